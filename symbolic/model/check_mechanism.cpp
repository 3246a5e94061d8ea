// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/check_mechanism.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <set>

#include "symbolic/files/identifier.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/model_name.h"
#include "symbolic/model/rotation.h"
#include "symbolic/parts/four_bar.h"

namespace sinew {
namespace {

constexpr double rounding = 1e-12;  // of an eigenvalue, relative to the largest

class Checker {
 public:
  Checker(const Mechanism& mechanism, Findings& findings)
      : mechanism_(mechanism), findings_(findings) {}

  void check() {
    if (const auto why = why_not_model_name(mechanism_.name))
      findings_.add(here(), fmt::format("the name of the mechanism {}", *why),
                    model_name_rule(mechanism_.name));
    if (!mechanism_.gravity.allFinite())
      findings_.add(here(), "gravity is not finite", "expected 3 finite numbers");
    if (mechanism_.bodies.size() != mechanism_.joints.size()) {
      findings_.add(here(), "the numbers of bodies and joints differ",
                    "expected one joint for each body");
      return;
    }
    if (const int moving = coordinate_count(mechanism_); moving > limits::moving_joints) {
      findings_.add(here(), fmt::format("the mechanism has {} coordinates", moving),
                    fmt::format("expected at most {}: fix joints, or divide the mechanism",
                                limits::moving_joints));
      return;
    }
    if (coordinate_count(mechanism_) == 0)
      findings_.add(here(), "the mechanism has no moving joint", "expected at least one");
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) check_body(i), check_joint(i);
    check_tendons();
    check_couplings();
    check_frames();
  }

 private:
  SourceLocation here() const { return {"mechanism '" + mechanism_.name + "'", 0, 0}; }

  void check_name(const std::string& kind, const std::string& name, const SourceLocation& where) {
    if (const auto why = why_not_identifier(name))
      findings_.add(where, fmt::format("the name of {} '{}' {}", kind, name, *why),
                    identifier_rule());
    if (!names_.insert(kind + " " + name).second)
      findings_.add(where, fmt::format("{} '{}' appears twice", kind, name),
                    "expected different names");
  }

  void check_body(std::size_t index) {
    const Body& body = mechanism_.bodies[index];
    check_name("body", body.name, body.where);
    if (!(body.mass >= 0.0) || !std::isfinite(body.mass))
      findings_.add(body.where, fmt::format("the mass of body '{}' is {}", body.name, body.mass),
                    "expected a mass that is not negative");
    if (!body.centre_of_mass.allFinite())
      findings_.add(body.where,
                    fmt::format("the centre of mass of body '{}' is not finite", body.name),
                    "expected 3 finite numbers");
    if (body.mass == 0.0 && !body.inertia.isZero(0.0))
      findings_.add(body.where, fmt::format("body '{}' has inertia but no mass", body.name),
                    "expected a mass");
    if (const auto wrong = wrong_inertia(body.inertia, InertiaCheck::as_given))
      findings_.add(body.where, fmt::format("body '{}': {}", body.name, *wrong),
                    "expected a symmetric inertia without negative principal moments");
  }

  void check_joint(std::size_t index) {
    const Joint& joint = mechanism_.joints[index];
    const auto wrong = [&](const std::string& what, const char* expected) {
      findings_.add(joint.where, fmt::format("joint '{}' {}", joint.name, what), expected);
    };
    check_name("joint", joint.name, joint.where);
    if (joint.parent < -1 || joint.parent >= static_cast<int>(index))
      wrong("does not come after its parent", "expected parents before children");
    if (!is_rotation(joint.origin.rotation) || !joint.origin.translation.allFinite())
      wrong("has an origin that is no rigid transform", "expected a rotation and finite numbers");
    if (joint.type == JointType::fixed) return;
    if (!(std::abs(joint.axis.norm() - 1.0) <= 1e-12))
      wrong("has an axis that is not a unit vector", "expected length 1");
    if (!(joint.low < joint.high) || !std::isfinite(joint.high - joint.low))
      wrong(fmt::format("has the range {} to {}", joint.low, joint.high), "expected low < high");
    if (joint.reference && !(*joint.reference >= joint.low && *joint.reference <= joint.high))
      wrong(fmt::format("has the reference {}", *joint.reference), "expected one within its range");
    if (!(joint.max_velocity > 0.0) || !(joint.max_acceleration > 0.0) || !(joint.damping >= 0.0))
      wrong("has a velocity or acceleration that is not positive, or a negative damping",
            "expected positive limits and damping >= 0");
    if (!(joint.friction >= 0.0) || !(joint.friction_speed >= 0.0) || !(joint.armature >= 0.0) ||
        !(joint.motor_turn >= 0.0))
      wrong("has a drive with a negative value",
            "expected friction, friction_speed, armature and motor_turn >= 0");
    if (joint.motor_poles < 0 || joint.motor_poles % 2 != 0 || joint.motor_slots < 0 ||
        joint.gear_teeth < 0)
      wrong("has a count of poles, slots or teeth that none has",
            "expected an even number of motor_poles; motor_slots and gear_teeth >= 0");
  }

  bool moves(const std::string& name) const {
    for (const Joint& joint : mechanism_.joints)
      if (joint.name == name) return joint.type != JointType::fixed;
    return false;
  }

  bool is_body(const std::string& name) const {
    for (const Body& body : mechanism_.bodies)
      if (body.name == name) return true;
    return false;
  }

  void check_tendons() {
    for (const Tendon& tendon : mechanism_.tendons) {
      check_name("tendon", tendon.name, tendon.where);
      const auto wrong = [&](const std::string& what, const char* expected) {
        findings_.add(tendon.where, fmt::format("tendon '{}' {}", tendon.name, what), expected);
      };
      if (tendon.pulleys.empty() && tendon.straights.empty())
        wrong("has no pulley and no straight stretch", "expected at least one");
      for (const PulleyRouting& pulley : tendon.pulleys) {
        if (!moves(pulley.joint))
          wrong(fmt::format("runs over '{}'", pulley.joint), "expected a moving joint");
        if (pulley.radius == 0.0 || !std::isfinite(pulley.radius))
          wrong("has a pulley without radius", "expected a radius other than 0");
      }
      for (const StraightRouting& straight : tendon.straights)
        for (const std::string& body : {straight.from_body, straight.to_body})
          if (body != "base" && !is_body(body))
            wrong(fmt::format("runs to the unknown body '{}'", body), "expected 'base' or a body");
    }
  }

  void check_couplings() {
    std::set<std::string> dependent;
    for (const JointCoupling& coupling : mechanism_.couplings) dependent.insert(coupling.dependent);
    for (const FourBarCoupling& bars : mechanism_.four_bars) dependent.insert(bars.dependent);
    if (dependent.size() != mechanism_.couplings.size() + mechanism_.four_bars.size())
      findings_.add(here(), "a joint depends on two others", "expected one coupling for each");
    for (const JointCoupling& coupling : mechanism_.couplings)
      if (!moves(coupling.dependent) || !moves(coupling.independent) ||
          dependent.contains(coupling.independent) || coupling.ratio == 0.0 ||
          !std::isfinite(coupling.ratio) || !std::isfinite(coupling.offset))
        findings_.add(
            coupling.where,
            fmt::format("the coupling of '{}' to '{}' by {} is not possible", coupling.dependent,
                        coupling.independent, coupling.ratio),
            "expected two moving joints, the second independent, a ratio other than 0 and a finite "
            "offset");
    for (const FourBarCoupling& bars : mechanism_.four_bars) check_four_bar(bars, dependent);
  }

  const Joint* turning_joint(const std::string& name) const {
    for (const Joint& joint : mechanism_.joints)
      if (joint.name == name && joint.type == JointType::revolute) return &joint;
    return nullptr;
  }

  void check_four_bar(const FourBarCoupling& bars, const std::set<std::string>& dependent) {
    const Joint* crank = turning_joint(bars.independent);
    const auto wrong = [&](const std::string& what, const char* expected) {
      findings_.add(bars.where, fmt::format("the four-bar of '{}' {}", bars.dependent, what),
                    expected);
    };
    if (!crank || !turning_joint(bars.dependent) || dependent.contains(bars.independent))
      return wrong(fmt::format("cannot follow '{}'", bars.independent),
                   "expected two revolute joints, the second independent");
    FourBarParameters p;
    p.ground = bars.ground, p.crank = bars.crank, p.coupler = bars.coupler, p.rocker = bars.rocker;
    p.theta2 = {crank->low + bars.crank_angle, crank->high + bars.crank_angle};
    for (const double length : {p.ground, p.crank, p.coupler, p.rocker})
      if (!(length > 0.0) || !std::isfinite(length))
        return wrong("has a link without length", "expected lengths > 0");
    if (const auto hinges = wrong_hinges(bars)) wrong(*hinges, "expected hinges as the linkage's");
    if (const auto angle = unreachable_crank_angle(p))
      wrong(fmt::format("locks or does not close at {} = {:.6g} rad", bars.independent,
                        *angle - bars.crank_angle),
            "expected links that close over the whole range of the independent joint");
  }

  std::size_t index_of(const std::string& joint) const {
    std::size_t i = 0;
    while (mechanism_.joints[i].name != joint) ++i;
    return i;
  }

  /// What keeps two joints from being pivots of the linkage: the rocker hinges on the crank's
  /// ground, the coupler on the crank, about the same direction, a link's length away.
  std::optional<std::string> wrong_hinges(const FourBarCoupling& bars) const {
    const std::size_t crank = index_of(bars.independent);
    const Joint &first = mechanism_.joints[crank],
                &second = mechanism_.joints[index_of(bars.dependent)];
    const bool rocker = bars.follows == FourBarCoupling::Follows::rocker;
    if (second.parent != (rocker ? first.parent : static_cast<int>(crank)))
      return fmt::format("hinges on another body than the {}", rocker ? "crank's ground" : "crank");
    const Eigen::Vector3d axis = rocker ? first.origin.rotation * first.axis : first.axis;
    if (!((second.origin.rotation * second.axis - axis).norm() < 1e-9))
      return "turns about another direction than the crank";
    Eigen::Vector3d apart = second.origin.translation;
    if (rocker) apart -= first.origin.translation;
    apart -= apart.dot(axis) * axis;
    const double length = rocker ? bars.ground : bars.crank;
    if (!(std::abs(apart.norm() - length) <= 1e-6 * length))
      return fmt::format("has its pivots {:.7g} m apart and a {} of {:.7g} m", apart.norm(),
                         rocker ? "ground" : "crank", length);
    return std::nullopt;
  }

  void check_frames() {
    for (const Frame& frame : mechanism_.frames) {
      check_name("frame", frame.name, frame.where);
      if (!is_body(frame.body))
        findings_.add(frame.where,
                      fmt::format("frame '{}' is on the unknown body '{}'", frame.name, frame.body),
                      "expected the name of a body");
      if (!is_rotation(frame.pose.rotation) || !frame.pose.translation.allFinite())
        findings_.add(frame.where,
                      fmt::format("frame '{}' has a pose that is no rigid transform", frame.name),
                      "expected a rotation and finite numbers");
    }
  }

  const Mechanism& mechanism_;
  Findings& findings_;
  std::set<std::string> names_;
};

}  // namespace

std::optional<std::string> wrong_inertia(const Eigen::Matrix3d& inertia, InertiaCheck check) {
  if (!inertia.allFinite()) return "the inertia is not finite";
  if (inertia != inertia.transpose()) return "the inertia is not symmetric";
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d moment = solver.eigenvalues();
  const double largest = moment.cwiseAbs().maxCoeff();
  const std::string moments = principal_moments_text(inertia);
  if (moment[0] < -rounding * largest)
    return fmt::format("the inertia is not positive definite: {}", moments);
  if (check == InertiaCheck::physical && moment[0] <= rounding * largest)
    return fmt::format("the inertia is not positive definite: {}", moments);
  if (check != InertiaCheck::as_given && moment[0] + moment[1] < moment[2] * (1.0 - inertia_margin))
    return fmt::format("the inertia violates the triangle inequality: {}", moments);
  return std::nullopt;
}

std::optional<InertiaCheck> strictest_check(const Eigen::Matrix3d& inertia) {
  for (const InertiaCheck check :
       {InertiaCheck::physical, InertiaCheck::idealised, InertiaCheck::as_given})
    if (!wrong_inertia(inertia, check)) return check;
  return std::nullopt;
}

std::string to_text(InertiaCheck check) {
  if (check == InertiaCheck::physical) return "physical";
  return check == InertiaCheck::idealised ? "idealised" : "as_given";
}

std::string principal_moments_text(const Eigen::Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d moment = solver.eigenvalues();
  return fmt::format("principal moments {:.4g}, {:.4g}, {:.4g} kg*m^2", moment[0], moment[1],
                     moment[2]);
}

std::optional<Eigen::Matrix3d> without_negative_rounding(const Eigen::Matrix3d& inertia,
                                                         double mass) {
  constexpr double smallest_radius = 1e-9;  // m, of gyration
  if (!inertia.allFinite() || inertia != inertia.transpose()) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  const Eigen::Vector3d moment = solver.eigenvalues();
  const double tiny =
      std::max(rounding * moment.cwiseAbs().maxCoeff(), mass * smallest_radius * smallest_radius);
  if (moment[0] >= 0.0 || moment[0] < -tiny) return std::nullopt;
  const Eigen::Matrix3d axes = solver.eigenvectors();
  const Eigen::Matrix3d cleaned = inertia.isDiagonal(0.0)
                                      ? Eigen::Matrix3d(inertia.cwiseMax(0.0))
                                      : axes * moment.cwiseMax(0.0).asDiagonal() * axes.transpose();
  return 0.5 * (cleaned + cleaned.transpose());
}

void check_mechanism(const Mechanism& mechanism, Findings& findings) {
  Checker(mechanism, findings).check();
}

void require_sound(const Mechanism& mechanism) {
  Findings findings;
  check_mechanism(mechanism, findings);
  findings.raise_if_any();
}

}  // namespace sinew
