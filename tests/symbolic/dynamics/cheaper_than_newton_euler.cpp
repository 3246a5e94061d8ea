// SPDX-License-Identifier: GPL-3.0-or-later
// Robots nobody tuned for: their emitted inverse dynamics is right, and takes fewer operations than
// a plain Newton-Euler recursion of the same robot, run with a number type that counts.
#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "generator/cost.h"
#include "generator/evaluate.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"
#include "symbolic/tendons/functions.h"
#include "tests/reference/newton_euler.h"
#include "tests/reference/random_mechanism.h"
#include "tests/reference/reference_model.h"

namespace sinew::reference {
namespace {

int operations = 0;

struct Counted {
  double value = 0.0;
};
Counted operator+(Counted a, Counted b) {
  ++operations;
  return {a.value + b.value};
}
Counted operator-(Counted a, Counted b) {
  ++operations;
  return {a.value - b.value};
}
Counted operator*(Counted a, Counted b) {
  ++operations;
  return {a.value * b.value};
}

using Three = std::array<Counted, 3>;
using Matrix = std::array<Three, 3>;

Three three(const Eigen::Vector3d& v) {
  return {{{v[0]}, {v[1]}, {v[2]}}};
}
Matrix matrix(const Eigen::Matrix3d& m) {
  return {three(m.row(0).transpose()), three(m.row(1).transpose()), three(m.row(2).transpose())};
}
Three operator+(const Three& a, const Three& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Three operator*(const Three& a, Counted s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
Counted dot(const Three& a, const Three& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Three operator*(const Matrix& m, const Three& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
Matrix transposed(const Matrix& m) {
  Matrix t;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) t[r][c] = m[c][r];
  return t;
}

/// The body's turn against its parent. Its entries are not counted, which favours the recursion.
Matrix turn(const Joint& joint, double q) {
  const double angle = joint.type == JointType::revolute ? q : 0.0;
  return matrix(joint.origin.rotation *
                Eigen::AngleAxisd(angle, joint.axis.normalized()).toRotationMatrix());
}

struct Link {
  Matrix turn;
  Three place, axis, spin, spin_rate, acceleration, force, moment;
};

/// The recursion outwards for one body; velocities and accelerations in the body's own axes.
void move(Link& own, const Link& parent, const Joint& joint, double rate, double rate_rate) {
  const Matrix back = transposed(own.turn);
  own.spin = back * parent.spin;
  own.spin_rate = back * parent.spin_rate;
  own.acceleration = back * (parent.acceleration + cross(parent.spin_rate, own.place) +
                             cross(parent.spin, cross(parent.spin, own.place)));
  if (joint.type == JointType::fixed) return;
  const Three speed = own.axis * Counted{rate}, gain = own.axis * Counted{rate_rate};
  if (joint.type == JointType::revolute) {
    own.spin_rate = own.spin_rate + cross(own.spin, speed) + gain;
    own.spin = own.spin + speed;
  } else {
    const Three turned = cross(own.spin, speed);
    own.acceleration = own.acceleration + turned + turned + gain;
  }
}

void load(Link& own, const Body& body) {
  const Three centre = three(body.centre_of_mass);
  const Matrix inertia = matrix(body.inertia);
  own.force =
      (own.acceleration + cross(own.spin_rate, centre) + cross(own.spin, cross(own.spin, centre))) *
      Counted{body.mass};
  own.moment =
      inertia * own.spin_rate + cross(own.spin, inertia * own.spin) + cross(centre, own.force);
}

/// Plain recursive Newton-Euler; its operations are counted in `operations`.
std::vector<double> plain(const Mechanism& mechanism, const State& state) {
  std::vector<Link> links(mechanism.joints.size());
  Link base{};
  base.acceleration = three(-mechanism.gravity);
  operations = 0;
  const std::vector<int> coordinate = coordinate_of_joint(mechanism);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const int k = coordinate[i];
    const double q = k < 0 ? 0.0 : state.q[k];
    const Eigen::Vector3d slide =
        joint.type == JointType::prismatic
            ? Eigen::Vector3d(joint.origin.rotation * joint.axis.normalized() * q)
            : Eigen::Vector3d::Zero();
    links[i].turn = turn(joint, q);
    links[i].place = three(joint.origin.translation + slide);
    links[i].axis = three(joint.axis.normalized());
    const Link& parent = joint.parent < 0 ? base : links[static_cast<std::size_t>(joint.parent)];
    move(links[i], parent, joint, k < 0 ? 0.0 : state.qd[k], k < 0 ? 0.0 : state.qdd[k]);
    load(links[i], mechanism.bodies[i]);
  }
  std::vector<double> torques(static_cast<std::size_t>(coordinate_count(mechanism)));
  for (std::size_t i = links.size(); i-- > 0;) {
    const Joint& joint = mechanism.joints[i];
    const Three& along = joint.type == JointType::revolute ? links[i].moment : links[i].force;
    if (coordinate[i] >= 0)
      torques[static_cast<std::size_t>(coordinate[i])] = dot(links[i].axis, along).value;
    if (joint.parent < 0) continue;
    Link& parent = links[static_cast<std::size_t>(joint.parent)];
    const Three passed = links[i].turn * links[i].force;
    parent.force = parent.force + passed;
    parent.moment = parent.moment + links[i].turn * links[i].moment + cross(links[i].place, passed);
  }
  return torques;
}

Graph emitted(const Mechanism& mechanism, const std::string& name) {
  for (const Function& function : functions_of(mechanism))
    if (function.name == name) return optimise(lower(function));
  throw std::runtime_error("no function " + name);
}

double difference(const std::vector<double>& values, const Eigen::VectorXd& exact) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < exact.size(); ++i)
    worst = std::max(worst, std::abs(values[static_cast<std::size_t>(i)] - exact[i]));
  return worst / exact.cwiseAbs().maxCoeff();
}

bool is_cheaper(const Graph& graph, const Mechanism& mechanism) {
  plain(mechanism, sample_states(mechanism, 1, 1).front());
  return count_operations(graph).operations() < operations;
}

void check(const Mechanism& mechanism) {
  const Graph graph = emitted(mechanism, "inverse_dynamics");
  const NewtonEuler<double> exact(mechanism);
  INFO(mechanism.name);
  for (const State& state : sample_states(mechanism, 5, 3)) {
    const Eigen::VectorXd expected = exact.inverse_dynamics(state.q, state.qd, state.qdd);
    CHECK(difference(plain(mechanism, state), expected) < 1e-12);
    CHECK(difference(evaluate<double>(graph, inputs_of("inverse_dynamics", state)), expected) <
          1e-12);
  }
  CHECK(is_cheaper(graph, mechanism));
}

Joint hinge(int parent, const Eigen::Vector3d& place, const Eigen::Vector3d& axis) {
  Joint joint;
  joint.parent = parent;
  joint.origin.translation = place;
  joint.axis = axis;
  return joint;
}

/// Three joints for the place, three with one common point for the direction. Bodies are those of a
/// random mechanism, so that nothing but the geometry is special.
Mechanism arm_with_spherical_wrist() {
  Mechanism arm = random_mechanism(
      11, {.joints = 6, .prismatic = 0.0, .fixed = 0.0, .branched = false, .arm = true});
  using V = Eigen::Vector3d;
  const std::array<V, 6> places{V(0, 0, 0.3),   V(0.1, 0, 0.2), V(0, 0, 0.4),
                                V(0.3, 0, 0.1), V::Zero(),      V::Zero()};
  const std::array<V, 6> axes{V::UnitZ(), V::UnitY(), V::UnitY(),
                              V::UnitX(), V::UnitY(), V::UnitX()};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string name = arm.joints[i].name;
    arm.joints[i] = hinge(static_cast<int>(i) - 1, places[i], axes[i]);
    arm.joints[i].name = name;
  }
  arm.name = "spherical_wrist";
  return arm;
}

TEST_CASE("an arm with a spherical wrist is cheaper than Newton-Euler") {
  check(arm_with_spherical_wrist());
}

TEST_CASE("random chains of 2 to 12 joints are cheaper than Newton-Euler") {
  for (int joints = 2; joints <= 12; ++joints)
    check(random_mechanism(100 + static_cast<std::uint64_t>(joints),
                           {.joints = joints, .arm = joints % 2 == 0}));
}

TEST_CASE("random trees are cheaper than Newton-Euler") {
  for (int joints = 3; joints <= 10; ++joints)
    check(random_mechanism(200 + static_cast<std::uint64_t>(joints),
                           {.joints = joints, .branched = true, .arm = joints % 2 == 1}));
}

TEST_CASE("chains of sliding joints are cheaper than Newton-Euler") {
  for (int joints = 3; joints <= 6; ++joints)
    check(random_mechanism(300 + static_cast<std::uint64_t>(joints),
                           {.joints = joints, .prismatic = 0.7, .fixed = 0.0}));
}

TEST_CASE("planted: a function that is not cheaper than Newton-Euler is found") {
  const Mechanism arm = random_mechanism(
      110, {.joints = 10, .prismatic = 0.0, .fixed = 0.0, .branched = false, .arm = true});
  CHECK_FALSE(is_cheaper(emitted(arm, "coriolis_matrix"), arm));
}

}  // namespace
}  // namespace sinew::reference
