// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/equations/named_values.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// Positions of all moving joints and their slopes by the coordinate that each follows.
struct NamedJoint {
  ex position, slope;
  std::size_t coordinate = 0;
};

class MechanismEquations {
 public:
  explicit MechanismEquations(const Mechanism& mechanism)
      : mechanism_(mechanism), coordinates_(mechanism), table_(mechanism) {
    for (const int index : coordinates_.joints()) {
      const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      const std::string below = subscript_of(joint.name);
      const char* unit = joint.type == JointType::revolute ? "rad" : "m";
      q_.push_back(table_.variable("q_" + below, "position of joint " + joint.name, unit));
      qd_.push_back(table_.variable("qd_" + below, "its rate", std::string(unit) + "/s"));
    }
    name_joints();
    values_ = named_values(mechanism, table_);
  }

  EquationPage page() {
    page_.title = fmt::format("Equations of {}", mechanism_.name);
    const std::vector<LinkPose> poses = kinematics();
    if (!is_massless(mechanism_)) {
      lagrangian_section(poses);
      mass_matrix_section(poses);
    }
    if (!mechanism_.tendons.empty()) tendon_sections(poses);
    name_definitions();
    page_.symbols = table_.entries();
    return std::move(page_);
  }

 private:
  std::size_t coordinate_called(const std::string& joint) const {
    for (std::size_t k = 0; k < q_.size(); ++k)
      if (mechanism_.joints[static_cast<std::size_t>(coordinates_.joints()[k])].name == joint)
        return k;
    return 0;
  }

  void name_joints() {
    for (const Joint& joint : mechanism_.joints) {
      if (joint.type == JointType::fixed) continue;
      joints_.push_back(named(joint));
    }
  }

  NamedJoint named(const Joint& joint) {
    const std::string below = subscript_of(joint.name);
    for (const JointCoupling& coupling : mechanism_.couplings) {
      if (coupling.dependent != joint.name) continue;
      const std::size_t k = coordinate_called(coupling.independent);
      const std::string path = "coupling." + joint.name;
      const ex ratio = table_.symbol(
          "rho_" + below, "ratio at which " + joint.name + " follows " + coupling.independent,
          coupling.ratio, "1", path + ".ratio");
      const ex offset =
          table_.symbol("delta_" + below,
                        "position of " + joint.name + " where " + coupling.independent + " is 0",
                        coupling.offset, "rad", path + ".offset");
      return {ratio * q_[k] + offset, ratio, k};
    }
    for (const FourBarCoupling& bars : mechanism_.four_bars) {
      if (bars.dependent != joint.name) continue;
      const std::size_t k = coordinate_called(bars.independent);
      const std::string function =
          "function of " + bars.independent + " by Freudenstein's equation";
      return {table_.variable("phi_" + below, function, "rad"),
              table_.variable("eta_" + below, "its derivative", "1"), k};
    }
    const std::size_t k = coordinate_called(joint.name);
    return {q_[k], 1, k};
  }

  /// Definitions made since the last call.
  std::vector<ReadableEquation> fresh() {
    std::vector<ReadableEquation> equations;
    for (; told_ < list_.items().size(); ++told_) {
      const Definition& each = list_.items()[told_];
      equations.push_back({each.symbol.get_name(), each.value});
    }
    return equations;
  }

  std::vector<LinkPose> kinematics() {
    std::vector<ex> positions;
    for (const NamedJoint& joint : joints_) positions.push_back(joint.position);
    std::vector<LinkPose> poses = link_poses(list_, mechanism_, values_, positions);
    page_.sections.push_back(
        {"Kinematics", "(5.2)",
         "From the base outwards: c and s are cosine and sine of each joint's position, R the "
         "rotation of each body's frame (rows x, y, z) and p its origin, both in the base frame. "
         "What is not listed is 0, 1 or equal to what precedes it.",
         fresh()});
    return poses;
  }

  std::vector<ex> rates(const std::vector<ex>& qd) const {
    std::vector<ex> all;
    for (const NamedJoint& joint : joints_) all.push_back(joint.slope * qd[joint.coordinate]);
    return all;
  }

  void lagrangian_section(const std::vector<LinkPose>& poses) {
    const std::vector<LinkVelocity> velocities =
        link_velocities(list_, mechanism_, values_, poses, rates({qd_.begin(), qd_.end()}));
    const ex L = lagrangian(list_, mechanism_, values_, poses, velocities);
    page_.sections.push_back(
        {"Lagrangian", "(5.3), (5.4)",
         "L = T - V. Angular velocity and velocity of each body's origin in its own axes, then the "
         "velocity u of its centre of mass and its share of L. The equations of motion are "
         "d/dt dL/d(qd) - dL/dq = tau.",
         fresh()});
    std::vector<ReadableEquation>& equations = page_.sections.back().equations;
    if (equations.back().left != "L") equations.push_back({"L", L});  // of a single body
  }

  /// Velocities for a rate of 1 of one coordinate alone.
  std::vector<LinkVelocity> column(const std::vector<LinkPose>& poses, std::size_t k) {
    std::vector<ex> unit(q_.size(), ex(0));
    unit[k] = 1;
    return link_velocities(list_, mechanism_, values_, poses, rates(unit),
                           "_by_" + subscript_of(joint_name(k)));
  }

  const std::string& joint_name(std::size_t k) const {
    return mechanism_.joints[static_cast<std::size_t>(coordinates_.joints()[k])].name;
  }

  void mass_matrix_section(const std::vector<LinkPose>& poses) {
    std::vector<std::vector<LinkVelocity>> columns;
    std::vector<std::vector<Vector3>> centres;
    for (std::size_t k = 0; k < q_.size(); ++k) {
      columns.push_back(column(poses, k));
      centres.emplace_back();
      for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b)
        centres.back().push_back(define(
            list_,
            fmt::format("{}_vc_by_{}", mechanism_.bodies[b].name, subscript_of(joint_name(k))),
            columns[k][b].velocity + cross(columns[k][b].spin, values_.bodies[b].centre)));
    }
    EquationSection section{
        "Mass matrix", "(2.1)",
        "M = sum over the bodies of m u_j.u_k + w_j.I w_k, with the velocities that a rate of 1 of "
        "one coordinate alone gives; M is symmetric.",
        fresh()};
    for (std::size_t j = 0; j < q_.size(); ++j)
      for (std::size_t k = j; k < q_.size(); ++k) {
        ex entry = 0;
        for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b)
          entry += values_.bodies[b].mass * dot(centres[j][b], centres[k][b]) +
                   dot(columns[j][b].spin, times(values_.bodies[b].inertia, columns[k][b].spin));
        section.equations.push_back(
            {fmt::format("M_{}{}{}", j + 1, q_.size() > 9 ? "_" : "", k + 1), entry});
      }
    page_.sections.push_back(std::move(section));
  }

  /// A point of a body in the base frame, as symbols.
  Vector3 point(const std::vector<LinkPose>& poses, const std::string& body,
                const Eigen::Vector3d& at, const std::string& name, const std::string& path) {
    Vector3 own;
    const char* axes[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k)
      own[k] = table_.symbol(name + "_" + axes[k],
                             fmt::format("point of {} on {}, along {}", name, body, axes[k]),
                             at[static_cast<Eigen::Index>(k)], "m", path);
    const int index = body_named(mechanism_, body);
    if (index < 0) return own;
    const LinkPose& pose = poses[static_cast<std::size_t>(index)];
    return pose.p + times(pose.R, own);
  }

  ex length_of(const Tendon& tendon, const std::vector<LinkPose>& poses) {
    const std::string path = "tendon." + tendon.name;
    ex h = table_.symbol("h0_" + tendon.name, "constant part of the length of " + tendon.name,
                         tendon.h0, "m", path + ".h0");
    const std::vector<int> moving = coordinate_of_joint(mechanism_);
    for (std::size_t i = 0; i < tendon.pulleys.size(); ++i) {
      const PulleyRouting& pulley = tendon.pulleys[i];
      for (std::size_t j = 0; j < mechanism_.joints.size(); ++j)
        if (mechanism_.joints[j].name == pulley.joint)
          h += radius(pulley, fmt::format("{}.pulleys[{}].radius", path, i)) *
               joints_[static_cast<std::size_t>(moving[j])].position;
    }
    for (std::size_t i = 0; i < tendon.straights.size(); ++i) {
      const StraightRouting& straight = tendon.straights[i];
      const std::string own = fmt::format("{}.straights[{}]", path, i);
      const std::string number = tendon.straights.size() == 1 ? "" : std::to_string(i + 1);
      const Vector3 d =
          define(list_, fmt::format("d{}_{}", number, tendon.name),
                 point(poses, straight.to_body, straight.to,
                       fmt::format("B{}_{}", number, tendon.name), own + ".to_point") -
                     point(poses, straight.from_body, straight.from,
                           fmt::format("A{}_{}", number, tendon.name), own + ".from_point"));
      h += list_.define(fmt::format("ell{}_{}", number, tendon.name), GiNaC::sqrt(dot(d, d)));
    }
    return h;
  }

  /// One symbol for each size of pulley at a joint; tendons on either side of it have either sign.
  ex radius(const PulleyRouting& pulley, const std::string& path) {
    const double size = std::abs(pulley.radius);
    for (const auto& [joint, known, symbol] : radii_)
      if (joint == pulley.joint && known == size) return pulley.radius < 0.0 ? -symbol : symbol;
    const auto at_joint = std::count_if(radii_.begin(), radii_.end(), [&](const auto& each) {
      return std::get<0>(each) == pulley.joint;
    });
    const ex symbol =
        table_.symbol(fmt::format("r_{}{}", subscript_of(pulley.joint),
                                  at_joint == 0 ? "" : "_" + std::to_string(at_joint + 1)),
                      "radius of a pulley at joint " + pulley.joint, size, "m", path);
    radii_.emplace_back(pulley.joint, size, symbol);
    return pulley.radius < 0.0 ? -symbol : symbol;
  }

  void tendon_sections(const std::vector<LinkPose>& poses) {
    std::vector<ex> lengths;
    for (const Tendon& tendon : mechanism_.tendons) lengths.push_back(length_of(tendon, poses));
    EquationSection section{"Tendon lengths", "(5.5), (5.20)",
                            "Pulleys add radius times angle, straight stretches the distance of "
                            "their ends.",
                            fresh()};
    for (std::size_t i = 0; i < lengths.size(); ++i)
      section.equations.push_back({"h_" + mechanism_.tendons[i].name, lengths[i]});
    page_.sections.push_back(std::move(section));
    const std::vector<ex> P = jacobian_of(lengths);
    EquationSection coupling{"Coupling matrix", "(5.9)",
                             "P = dh/dq, a row a tendon; tendons with forces f make the joint "
                             "torques -P^T f. Entries that are 0 are not listed.",
                             fresh()};
    for (std::size_t k = 0; k < P.size(); ++k)
      if (!P[k].is_zero())
        coupling.equations.push_back({fmt::format("P_{}_{}", mechanism_.tendons[k / q_.size()].name,
                                                  subscript_of(joint_name(k % q_.size()))),
                                      P[k]});
    page_.sections.push_back(std::move(coupling));
  }

  /// By the coordinates; what a four-bar makes of one is regarded by its slope.
  std::vector<ex> jacobian_of(const std::vector<ex>& lengths) {
    std::vector<ex> P;
    for (const ex& h : lengths)
      for (std::size_t k = 0; k < q_.size(); ++k) P.push_back(slope_of(h, k));
    return P;
  }

  /// d/dq_k through the definitions.
  ex slope_of(const ex& value, std::size_t k) {
    ex slope = value.diff(q_[k]);
    for (const NamedJoint& joint : joints_)
      if (GiNaC::is_a<GiNaC::symbol>(joint.position) && joint.coordinate == k &&
          !joint.position.is_equal(q_[k]))
        slope += value.diff(GiNaC::ex_to<GiNaC::symbol>(joint.position)) * joint.slope;
    for (const std::size_t at : list_.used_by(value)) {
      const GiNaC::symbol symbol = list_.items()[at].symbol;
      const ex inner = slope_of_definition(at, k);
      if (!inner.is_zero()) slope += value.diff(symbol) * inner;
    }
    return slope;
  }

  ex slope_of_definition(std::size_t at, std::size_t k) {
    const auto found = slopes_.find({at, k});
    if (found != slopes_.end()) return found->second;
    const ex value = list_.items()[at].value;
    const std::string name = list_.items()[at].symbol.get_name();
    const ex slope = list_.define(name + "_by_" + subscript_of(joint_name(k)), slope_of(value, k));
    slopes_[{at, k}] = slope;
    return slope;
  }

  /// q20_w_x is shown as omega_20 x, and so on.
  void name_definitions() {
    for (const EquationSection& section : page_.sections)
      for (const ReadableEquation& equation : section.equations) shown_name(equation.left);
  }

  void shown_name(const std::string& name) {
    constexpr std::pair<const char*, const char*> letters[] = {
        {"_cos", "c"}, {"_sin", "s"}, {"_R", "R"}, {"_p", "p"}, {"_w", "omega"}, {"_v", "v"}};
    constexpr std::pair<const char*, const char*> of_bodies[] = {{"_vc", "u"}, {"_L", "L"}};
    for (const Joint& joint : mechanism_.joints)
      for (const auto& [key, letter] : letters) show(name, joint.name, key, letter);
    for (const Body& body : mechanism_.bodies)
      for (const auto& [key, letter] : of_bodies) show(name, body.name, key, letter);
  }

  void show(const std::string& name, const std::string& owner, const std::string& key,
            const std::string& letter) {
    const std::string start = owner + key;
    if (!name.starts_with(start)) return;
    const std::string rest = name.substr(start.size());
    if (!rest.empty() && rest.front() != '_') return;
    page_.shown[name] = letter + "_" + subscript_of(owner) + rest;
  }

  const Mechanism& mechanism_;
  Coordinates coordinates_;
  SymbolTable table_;
  DefinitionList list_;
  std::size_t told_ = 0;
  std::vector<GiNaC::symbol> q_, qd_;
  std::vector<NamedJoint> joints_;
  MechanismValues values_;
  std::vector<std::tuple<std::string, double, ex>> radii_;
  std::map<std::pair<std::size_t, std::size_t>, ex> slopes_;
  EquationPage page_;
};

}  // namespace

EquationPage mechanism_equations(const Mechanism& mechanism) {
  return MechanismEquations(mechanism).page();
}

}  // namespace sinew
