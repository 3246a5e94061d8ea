// SPDX-License-Identifier: GPL-3.0-or-later
// Play and a spring in the gear of an arm's joint whose sensor sits on the motor: the links part
// from it under their own weight, and the joint before feels that. Newton-Euler numerics with
// motor and links apart, in closed loop.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/reference/newton_euler.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;
using diagnosis::Findings;
using diagnosis::NamedCause;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The arm in its vertical plane unless it weighs nothing; every motor has a gear's inertia.
Mechanism geared_arm(bool weighing) {
  Mechanism arm = test::upper_and_lower_arm();
  if (!weighing) arm.gravity.setZero();
  for (std::size_t i = 0; i < 2; ++i) {
    Joint& joint = arm.joints[i];
    joint.armature = i == 0 ? 0.12 : 0.05;
    joint.damping = i == 0 ? 0.5 : 0.2;
    joint.friction = i == 0 ? 0.8 : 0.35;
    joint.friction_speed = 0.02;
  }
  return arm;
}

/// What connects the second joint's motor with its links.
struct Gear {
  double gap = 0.0;        ///< rad
  double stiffness = 0.0;  ///< N m / rad
  double damping = 0.0;    ///< N m s / rad

  double torque(double twist, double rate) const {
    const double beyond = std::abs(twist) - 0.5 * gap;
    if (beyond <= 0.0) return 0.0;
    const double pushed = stiffness * beyond + damping * (twist > 0.0 ? rate : -rate);
    return std::copysign(gap > 0.0 ? std::max(0.0, pushed) : pushed, twist);
  }
};

/// A joint's reference: slow and faster sines, and its derivatives.
struct Sines {
  double middle = 0.0;
  double size[5] = {}, rate[5] = {}, phase[5] = {};

  Eigen::Vector3d at(double t) const {
    Eigen::Vector3d r(middle, 0.0, 0.0);
    for (int k = 0; k < 5; ++k) {
      const double x = rate[k] * t + phase[k];
      r += size[k] *
           Eigen::Vector3d(std::sin(x), rate[k] * std::cos(x), -rate[k] * rate[k] * std::sin(x));
    }
    return r;
  }
};

Sines draw_sines(double middle, reference::RandomNumbers& random) {
  Sines s;
  s.middle = middle;
  for (int k = 0; k < 5; ++k) {
    s.rate[k] = 2.0 * std::numbers::pi * 0.13 * (k + 1) * random.uniform(0.9, 1.1);
    s.size[k] = random.uniform(0.2, 0.5) / (k + 1);
    s.phase[k] = random.uniform(0.0, 6.28);
  }
  return s;
}

/// 24 s at 500 Hz; the logged position of the second joint is its motor's.
std::string geared_log(const Mechanism& arm, const Gear& gear, std::uint64_t seed) {
  constexpr double step = 2e-4, seconds = 24.0, bandwidth = 25.0;
  constexpr int every = 10;
  reference::RandomNumbers random(seed);
  const reference::NewtonEuler<double> links(arm);
  const Sines wanted[] = {draw_sines(0.6, random), draw_sines(-0.5, random)};
  Vector2d q(wanted[0].at(0)(0), wanted[1].at(0)(0)), qd(wanted[0].at(0)(1), wanted[1].at(0)(1));
  double motor = q(1), speed = qd(1);
  test::ArmLog log;
  log.step = every * step;
  log.q.resize(static_cast<Index>(seconds / log.step), 2);
  log.tau = log.q;
  for (Index k = 0; k < log.q.rows() * every; ++k) {
    const Vector2d seen(q(0), motor), seen_rate(qd(0), speed);
    Vector2d reference, rate, acceleration, tau;
    for (Index i = 0; i < 2; ++i) {
      const Eigen::Vector3d r = wanted[i].at(step * static_cast<double>(k));
      reference(i) = r(0), rate(i) = r(1), acceleration(i) = r(2);
    }
    tau = VectorXd(links.inverse_dynamics(reference, rate, acceleration));
    Vector2d friction;
    for (Index i = 0; i < 2; ++i) {
      const Joint& joint = arm.joints[static_cast<std::size_t>(i)];
      const double inertia = joint.armature + (i == 0 ? 0.4 : 0.05);
      tau(i) += joint.armature * acceleration(i) +
                inertia * (bandwidth * bandwidth * (reference(i) - seen(i)) +
                           1.4 * bandwidth * (rate(i) - seen_rate(i)));
      friction(i) =
          joint.damping * seen_rate(i) +
          joint.friction * 2.0 / std::numbers::pi * std::atan(seen_rate(i) / joint.friction_speed);
    }
    if (k % every == 0) {
      log.q.row(k / every) = seen.transpose();
      log.tau.row(k / every) = tau.transpose();
      for (Index i = 0; i < 2; ++i) log.tau(k / every, i) += 0.03 * random.uniform(-1.7, 1.7);
    }
    const double passed = gear.torque(motor - q(1), speed - qd(1));
    MatrixXd inertia = links.mass_matrix(q);
    inertia(0, 0) += arm.joints[0].armature;
    const VectorXd bias = links.bias(q, qd);
    const Vector2d drive(tau(0) - friction(0) - bias(0), passed - bias(1));
    qd += step * Vector2d(inertia.ldlt().solve(VectorXd(drive)));
    q += step * qd;
    speed += step * (tau(1) - friction(1) - passed) / arm.joints[1].armature;
    motor += step * speed;
  }
  return test::csv(log);
}

Findings diagnosed(const Gear& gear, bool weighing) {
  const Mechanism arm = geared_arm(weighing);
  return test::diagnosed(arm, geared_log(arm, gear, 3), geared_log(arm, gear, 8));
}

/// The emitted extended model says it at both joints.
void check_emitted(const Findings& f) {
  CHECK(f.extension.adopted);
  REQUIRE(f.channels.size() == 2);
  for (const diagnosis::ChannelFinding& channel : f.channels) {
    INFO(channel.name << ": " << channel.unexplained_before << " -> " << channel.unexplained_after);
    CHECK(channel.unexplained_after < 0.7 * channel.unexplained_before);
  }
}

}  // namespace

// Planted defects, each seen to fail: the links part as a bare inertia does (without their weight);
// the first joint does not feel it; the search begins at the fitted gap alone; what
// impacts leave over is told; the emitted term acts at its own joint alone.
TEST_CASE("a gap behind a motor's sensor is found with the links' own motion in it",
          "[slow][thorough]") {
  const double gap = 3e-3;
  const Findings f = diagnosed({gap, 9000.0, 10.0}, true);
  INFO(f.headline);
  REQUIRE(f.verdict.causes.size() == 1);
  const NamedCause& cause = f.verdict.causes.front();
  CHECK(cause.members.front().name == "backlash");
  CHECK(cause.members.front().place == "joint j2");
  REQUIRE(cause.parameters.size() >= 2);
  CHECK(std::abs(cause.parameters[0].value + 1.0) < 0.15);
  CHECK(std::abs(cause.parameters[1].value - gap) < 0.15 * gap);
  CHECK(f.verdict.relative_error_after < 0.5 * f.verdict.relative_error_before);
  CHECK(f.verdict.held_out.low > 0.6);
  check_emitted(f);
}

TEST_CASE("a spring behind a motor's sensor is told at its joint and at no other", "[slow]") {
  const double frequency = 2.0 * std::numbers::pi * 12.0, inertia = 0.043;
  const Findings f =
      diagnosed({0.0, inertia * frequency * frequency, 0.1 * inertia * frequency}, false);
  INFO(f.headline);
  REQUIRE(f.verdict.causes.size() == 1);
  CHECK(f.verdict.causes.front().members.front().name == "gear elasticity");
  CHECK(f.verdict.causes.front().members.front().place == "joint j2");
  CHECK(f.verdict.held_out.low > 0.2);
  check_emitted(f);
}
