// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/rigid_candidates.h"

#include <tbb/parallel_for.h>
#include <algorithm>

#include "generator/assemble.h"
#include "identification/subjects/expected_bodies.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/dynamics/runtime_parameters.h"
#include "symbolic/effects/model_effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double strongest_gravity = 10.0;  // m/s²
constexpr std::size_t most_payloads = 5;    // a hand's fingers
constexpr std::size_t most_links = 8;       // whose own masses are asked about
// Of a link's mass, what its drawing is off by. Of slide arms whose links were 2 to 6 % off the
// same was told at 0.1; at 0.4 links of twice their mass took the place of rotors.
constexpr double kOwnSpread = 0.2;
constexpr double lightest_link = 0.1;  // of its model's mass, where its shape is as drawn

LinearParameter parameter(const std::string& name, const std::string& unit, double low) {
  LinearParameter p;
  p.name = name;
  p.unit = unit;
  p.low = low;
  return p;
}

/// Named, limited and told apart as the effect says; the group's type is its owner's own.
template <class Group>
void describe(const std::string& effect, Group& group) {
  const ModelEffect& e = *find_model_effect(effect);
  group.effect = effect;
  group.name = e.name;
  group.experiment = e.experiment;
  group.limit = e.limit;
}

}  // namespace

RigidColumns::RigidColumns(const Mechanism& mechanism, const std::filesystem::path& runtime)
    : mechanism_(mechanism),
      bodies_(static_cast<Index>(mechanism.bodies.size())),
      coordinates_(coordinate_count(mechanism)) {
  const EmittedModel emitted = assemble(
      {mechanism.name, "Dynamics with open masses", "", {}},
      {base_parameters_function(mechanism), inverse_dynamics_function(mechanism, {}, true)}, {});
  compiled_ = std::make_shared<CompiledModel>(emitted, runtime);
  coordinates_ = compiled_->find("inverse_dynamics").output_size;
  const std::vector<MovingBody> moving = moving_bodies(mechanism);
  std::size_t payloads = 0;
  for (const MovingBody& m : moving)
    if (m.leaf && payloads++ < most_payloads) add_payload(mechanism, m.body);
  const bool arm = mechanism.tendons.empty() && coordinates_ > 1;
  if (arm && moving.size() <= most_links)
    for (const MovingBody& m : moving) add_inertial(mechanism, m.body, m.leaf);
  if (!arm && moving.size() <= most_links)
    for (const MovingBody& m : moving) add_density(mechanism, m.body, m.leaf);
  add_gravity(mechanism);
}

VectorXd RigidColumns::parameters(const VectorXd& mass, const MatrixXd& com,
                                  const MatrixXd& inertia, const Vector3d& gravity) const {
  const sinew_function& function = compiled_->find("base_parameters");
  VectorXd in(function.input_size), out(function.output_size);
  const MatrixXd com_rows = com.transpose(), inertia_rows = inertia.transpose();
  in << mass, Eigen::Map<const VectorXd>(com_rows.data(), com_rows.size()),
      Eigen::Map<const VectorXd>(inertia_rows.data(), inertia_rows.size()), gravity;
  function.call(in.data(), out.data());
  return out;
}

/// Ten parameters of a mass that moves with a body: mass, first moments, moments of inertia.
RigidColumns::Group RigidColumns::mass_of(const Body& carrier, Index b) const {
  Group group;
  group.place = "link " + carrier.name;
  const VectorXd no_mass = VectorXd::Zero(bodies_);
  const MatrixXd no_com = MatrixXd::Zero(bodies_, 3), no_inertia = MatrixXd::Zero(bodies_, 6);
  VectorXd unit = no_mass;
  unit(b) = 1.0;
  const Vector3d& gravity = mechanism_.gravity;
  group.parameters.push_back(parameter("mass", "kg", 0.0));
  group.columns.push_back({parameters(unit, no_com, no_inertia, gravity), {}, 1.0});
  const char* axes[] = {"x", "y", "z"};
  constexpr double arm = 0.125;
  for (Index k = 0; k < 3; ++k) {
    MatrixXd com = no_com;
    com(b, k) = arm;
    group.parameters.push_back(
        parameter(std::string("first_moment_") + axes[k], "kg*m", -infinity));
    group.columns.push_back({parameters(unit, com, no_inertia, gravity),
                             parameters(unit, -com, no_inertia, gravity), 0.5 / arm});
  }
  const char* moments[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  for (Index k = 0; k < 6; ++k) {
    MatrixXd inertia = no_inertia;
    inertia(b, k) = 1.0;
    group.parameters.push_back(parameter(std::string("moment_") + moments[k], "kg*m^2", -infinity));
    group.columns.push_back({parameters(no_mass, no_com, inertia, gravity), {}, 1.0});
  }
  return group;
}

void RigidColumns::add_payload(const Mechanism& mechanism, std::size_t body) {
  const Body& carrier = mechanism.bodies[body];
  Group group = mass_of(carrier, static_cast<Index>(body));
  group.signal = "payload of " + carrier.name;
  describe("payload", group);
  group.body_within = reach_of(mechanism);
  if (carrier.mass > 0.0) expect_about(radius_of(carrier), group.parameters);
  groups_.push_back(std::move(group));
}

/// A link that is not as its drawing says. What the last one carries more is a payload.
void RigidColumns::add_inertial(const Mechanism& mechanism, std::size_t body, bool leaf) {
  const Body& carrier = mechanism.bodies[body];
  Group group = mass_of(carrier, static_cast<Index>(body));
  group.signal = "inertial parameters of " + carrier.name;
  describe("inertial_parameters", group);
  // Where the motion does not tell a rotor's inertia from a link's mass a regression may take it
  // for more than the whole robot weighs: that is no link of it.
  group.parameters.front().low = -carrier.mass;
  group.parameters.front().high = moving_mass(mechanism);
  if (leaf) group.parameters.front().high = 0.0;
  if (leaf) group.limit = "it would carry something";
  const bool has_mass = carrier.mass > 0.0;
  if (has_mass) expect(kOwnSpread * carrier.mass, radius_of(carrier), group.parameters);
  group.as_drawn = has_mass ? moments_as_drawn(carrier) : MatrixXd::Zero(6, kMassAndFirstMoments);
  group.unlikely = true;
  groups_.push_back(std::move(group));
}

/// A link of another mass and the drawing's shape: of another material, or with parts that the
/// drawing left out all over it. All ten parameters go with the mass. What the last one has more is
/// a payload.
void RigidColumns::add_density(const Mechanism& mechanism, std::size_t body, bool leaf) {
  const Body& link = mechanism.bodies[body];
  if (!(link.mass > 0.0)) return;
  Group group;
  group.place = "link " + link.name;
  group.signal = "mass of " + link.name;
  describe("inertial_parameters", group);
  const auto b = static_cast<Index>(body);
  VectorXd mass = VectorXd::Zero(bodies_);
  MatrixXd com = MatrixXd::Zero(bodies_, 3), inertia = MatrixXd::Zero(bodies_, 6);
  const Eigen::Matrix3d I = link.inertia / link.mass;
  mass(b) = 1.0;
  com.row(b) = link.centre_of_mass.transpose();
  inertia.row(b) << I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2);
  group.columns.push_back({parameters(mass, com, inertia, mechanism.gravity), {}, 1.0});
  group.parameters.push_back(parameter("mass", "kg", (lightest_link - 1.0) * link.mass));
  group.parameters.back().high = leaf ? 0.0 : std::max(link.mass, moving_mass(mechanism));
  if (leaf) group.limit = "it would carry something";
  groups_.push_back(std::move(group));
}

/// The mechanism's own, under some gravity.
VectorXd RigidColumns::nominal(const Vector3d& gravity) const {
  VectorXd mass(bodies_);
  MatrixXd com(bodies_, 3), inertia(bodies_, 6);
  for (Index b = 0; b < bodies_; ++b) {
    const Body& body = mechanism_.bodies[static_cast<std::size_t>(b)];
    const Eigen::Matrix3d& I = body.inertia;
    mass(b) = body.mass;
    com.row(b) = body.centre_of_mass.transpose();
    inertia.row(b) << I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2);
  }
  return parameters(mass, com, inertia, gravity);
}

/// Gravity that the model lacks, or has in another direction.
void RigidColumns::add_gravity(const Mechanism& mechanism) {
  const bool absent = mechanism.gravity.isZero(0.0);
  Group group;
  group.signal = "gravity";
  describe("gravity", group);
  group.name = absent ? "gravity left out" : "direction of gravity";
  group.place = "base";
  const VectorXd none = nominal(Vector3d::Zero());
  const char* axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    const double now = mechanism.gravity(k);
    group.parameters.push_back(
        parameter(std::string("gravity_change_") + axes[k], "m/s^2", -strongest_gravity - now));
    group.parameters.back().high = strongest_gravity - now;
    group.columns.push_back({nominal(Vector3d::Unit(k)), none, 1.0});
  }
  groups_.push_back(std::move(group));
}

std::size_t RigidColumns::body_of(const std::string& link) const {
  for (const MovingBody& m : moving_bodies(mechanism_))
    if (mechanism_.bodies[m.body].name == link) return m.body;
  std::string links;
  for (const std::string& name : moving_links()) links += (links.empty() ? "" : ", ") + name;
  throw std::invalid_argument("there is no link '" + link + "' that moves; expected one of " +
                              links);
}

std::vector<std::string> RigidColumns::moving_links() const {
  std::vector<std::string> names;
  for (const MovingBody& m : moving_bodies(mechanism_))
    names.push_back(mechanism_.bodies[m.body].name);
  return names;
}

std::vector<std::string> RigidColumns::last_links() const {
  std::vector<std::string> names;
  for (const MovingBody& m : moving_bodies(mechanism_))
    if (m.leaf) names.push_back(mechanism_.bodies[m.body].name);
  return names;
}

MatrixXd RigidColumns::mass_columns(const std::string& link, const Recording& log) const {
  const std::size_t body = body_of(link);
  return columns_of(mass_of(mechanism_.bodies[body], static_cast<Index>(body)), log);
}

MatrixXd RigidColumns::point_mass(const std::string& link, const Vector3d& centre,
                                  const Recording& log) const {
  const auto b = static_cast<Index>(body_of(link));
  VectorXd mass = VectorXd::Zero(bodies_);
  MatrixXd com = MatrixXd::Zero(bodies_, 3);
  mass(b) = 1.0;
  com.row(b) = centre.transpose();
  Group group;
  group.columns.push_back(
      {parameters(mass, com, MatrixXd::Zero(bodies_, 6), mechanism_.gravity), {}, 1.0});
  return columns_of(group, log);
}

MatrixXd RigidColumns::body_columns(const std::string& link, const Recording& log) const {
  const auto b = static_cast<Index>(body_of(link));
  const Body& body = mechanism_.bodies[static_cast<std::size_t>(b)];
  VectorXd mass = VectorXd::Zero(bodies_);
  MatrixXd com = MatrixXd::Zero(bodies_, 3), inertia = MatrixXd::Zero(bodies_, 6);
  mass(b) = body.mass;
  com.row(b) = body.centre_of_mass.transpose();
  const MatrixXd none = inertia;
  const Eigen::Matrix3d& i = body.inertia;
  inertia.row(b) << i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2);
  Group group;
  group.columns.push_back({parameters(mass, com, inertia, mechanism_.gravity), {}, 1.0});
  const double reach = extent_of(link).second;
  mass(b) = moving_mass_and_reach().first / static_cast<double>(moving_links().size());
  for (Index k = 0; k < 3; ++k)
    for (const double way : {reach, -reach}) {
      MatrixXd beside = com;
      beside(b, k) += way;
      group.columns.push_back({parameters(mass, beside, none, mechanism_.gravity), {}, 1.0});
    }
  return columns_of(group, log);
}

MatrixXd RigidColumns::force_columns(const std::string& link, const Vector3d& point,
                                     const Recording& log) const {
  const sinew_function& function = compiled_->find("inverse_dynamics");
  const Index n = coordinates_;
  const auto b = static_cast<Index>(body_of(link));
  VectorXd mass = VectorXd::Zero(bodies_);
  MatrixXd com = MatrixXd::Zero(bodies_, 3);
  mass(b) = 1.0;
  com.row(b) = point.transpose();
  VectorXd in = VectorXd::Zero(function.input_size), out(n);
  MatrixXd x(log.q.rows(), 3 * n);
  // The weight of 1 kg under a gravity of 1 m/s^2 along an axis is that force.
  for (Index axis = 0; axis < 3; ++axis) {
    in.tail(in.size() - 3 * n) =
        parameters(mass, com, MatrixXd::Zero(bodies_, 6), Vector3d::Unit(axis));
    for (Index k = 0; k < x.rows(); ++k) {
      in.head(n) = log.q.row(k).head(n).transpose();
      function.call(in.data(), out.data());
      x.row(k).segment(axis * n, n) = out.transpose();
    }
  }
  return x;
}

std::pair<Vector3d, double> RigidColumns::extent_of(const std::string& link) const {
  const std::size_t body = body_of(link);
  const Vector3d centre = mechanism_.bodies[body].centre_of_mass;
  double farthest = centre.norm();  // its own joint
  for (const Joint& joint : mechanism_.joints)
    if (joint.parent == static_cast<int>(body))
      farthest = std::max(farthest, (joint.origin.translation - centre).norm());
  for (const Frame& frame : mechanism_.frames)
    if (frame.body == link) farthest = std::max(farthest, (frame.pose.translation - centre).norm());
  return {centre, farthest};
}

std::pair<double, double> RigidColumns::moving_mass_and_reach() const {
  double mass = 0.0, reach = 0.0;
  for (const std::string& link : moving_links()) {
    mass += mechanism_.bodies[body_of(link)].mass;
    reach += extent_of(link).second;
  }
  return {mass, reach};
}

MatrixXd RigidColumns::effort(const Recording& log) const {
  const sinew_function& function = compiled_->find("inverse_dynamics");
  const Index n = coordinates_;
  VectorXd in(function.input_size), out(n);
  const MatrixXd& qdd = log.acceleration();
  in.tail(in.size() - 3 * n) = nominal(mechanism_.gravity);
  MatrixXd effort(log.q.rows(), n);
  for (Index k = 0; k < effort.rows(); ++k) {
    in.head(3 * n) << log.q.row(k).head(n).transpose(), log.qd.row(k).head(n).transpose(),
        qdd.row(k).head(n).transpose();
    function.call(in.data(), out.data());
    effort.row(k) = out.transpose();
  }
  return effort;
}

MatrixXd RigidColumns::mass_matrix(const Recording& log) const {
  const sinew_function& function = compiled_->find("inverse_dynamics");
  const Index n = coordinates_;
  VectorXd in = VectorXd::Zero(function.input_size);
  in.tail(in.size() - 3 * n) = nominal(Vector3d::Zero());
  MatrixXd columns(log.q.rows(), n * n);
  VectorXd out(n);
  for (Index k = 0; k < columns.rows(); ++k) {
    in.head(n) = log.q.row(k).head(n).transpose();
    for (Index j = 0; j < n; ++j) {
      in.segment(2 * n, n) = VectorXd::Unit(n, j);
      function.call(in.data(), out.data());
      columns.row(k).segment(j * n, n) = out.transpose();
    }
  }
  return columns;
}

MatrixXd RigidColumns::columns_of(const Group& group, const Recording& log) const {
  const sinew_function& function = compiled_->find("inverse_dynamics");
  const Index n = coordinates_;
  const MatrixXd& qdd = log.acceleration();
  VectorXd in(function.input_size), plus(n), minus = VectorXd::Zero(n);
  const auto wide = static_cast<Index>(group.columns.size());
  MatrixXd x(log.q.rows(), n * wide);
  for (Index c = 0; c < wide; ++c) {
    const Column& column = group.columns[static_cast<std::size_t>(c)];
    const bool both = column.minus.size() > 0;
    minus.setZero();
    for (Index k = 0; k < x.rows(); ++k) {
      in.head(3 * n) << log.q.row(k).head(n).transpose(), log.qd.row(k).head(n).transpose(),
          qdd.row(k).head(n).transpose();
      in.tail(in.size() - 3 * n) = column.plus;
      function.call(in.data(), plus.data());
      if (both) {
        in.tail(in.size() - 3 * n) = column.minus;
        function.call(in.data(), minus.data());
      }
      for (Index i = 0; i < n; ++i) x(k, i * wide + c) = column.scale * (plus(i) - minus(i));
    }
  }
  return x;
}

void RigidColumns::add_signals(Recording& log) const {
  std::vector<MatrixXd> all(groups_.size());
  tbb::parallel_for(0, static_cast<int>(all.size()), [&](int i) {
    const auto g = static_cast<std::size_t>(i);
    all[g] = columns_of(groups_[g], log);
  });
  for (std::size_t g = 0; g < all.size(); ++g)
    log.wide_signals[groups_[g].signal] = std::make_shared<const MatrixXd>(std::move(all[g]));
}

std::vector<RigidColumns::OfMechanism> RigidColumns::candidates() const {
  std::vector<OfMechanism> list;
  for (const Group& group : groups_) {
    Candidate c;
    c.name = group.name;
    c.place = group.place;
    c.linear = group.parameters;
    c.limit_meaning = group.limit;
    c.isolating_experiment = group.experiment;
    c.unlikely = group.unlikely;
    c.body_within = group.body_within;
    c.of_body = group.effect != "gravity";
    c.has_model_form = true;
    const auto wide = static_cast<Index>(group.columns.size());
    c.columns = [signal = group.signal, wide, n = coordinates_](const Recording& log, int channel,
                                                                const VectorXd&) -> MatrixXd {
      if (channel >= n) return MatrixXd(log.q.rows(), 0);  // a motor
      return log.wide_signals.at(signal)->middleCols(channel * wide, wide);
    };
    list.push_back({c, group.effect});
    if (!group.as_drawn) continue;
    // The same cause with the drawing's shape: of moments of its own rotors take the place.
    c.linear.resize(kMassAndFirstMoments);
    c.columns = [all = c.columns, moments = *group.as_drawn](const Recording& log, int channel,
                                                             const VectorXd& shape) {
      MatrixXd x = all(log, channel, shape);
      if (x.cols() == 0) return x;
      return MatrixXd(x.leftCols(kMassAndFirstMoments) + x.rightCols(moments.rows()) * moments);
    };
    list.push_back({std::move(c), group.effect});
  }
  return list;
}

}  // namespace sinew::diagnosis
