// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/subjects/arm_logs.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "tests/reference/newton_euler.h"
#include "tests/reference/random_numbers.h"

namespace sinew::test {

using Eigen::Index;
using Eigen::MatrixXd;
using reference::RandomNumbers;

Mechanism arm_of_five() {
  static const Eigen::Vector3d axes[] = {{0, 0, 1}, {0, -1, 0}, {0, -1, 0}, {1, 0, 0}, {0, -1, 0}};
  static const double masses[] = {4.0, 2.5, 1.5, 0.3, 0.08};
  Mechanism arm;
  arm.name = "arm";
  for (int i = 0; i < kArmJoints; ++i) {
    Joint joint;
    joint.name = fmt::format("j{}", i + 1);
    joint.parent = i - 1;
    joint.axis = axes[i];
    if (i > 0) joint.origin.translation = Eigen::Vector3d(0.3, 0.0, i == 1 ? 0.2 : 0.0);
    Body body;
    body.name = fmt::format("l{}", i + 1);
    body.mass = masses[i];
    body.centre_of_mass = {0.12, 0.02, -0.01};
    body.inertia = Eigen::Vector3d(0.004, 0.012, 0.013).asDiagonal();
    body.inertia *= masses[i];
    arm.joints.push_back(joint);
    arm.bodies.push_back(body);
  }
  return arm;
}

Mechanism upper_and_lower_arm() {
  Mechanism arm;
  arm.name = "arm";
  for (int i = 0; i < 2; ++i) {
    Joint joint;
    joint.name = fmt::format("j{}", i + 1);
    joint.parent = i - 1;
    joint.axis = {0.0, 1.0, 0.0};
    joint.origin.translation = Eigen::Vector3d(0.0, 0.0, 0.35 * i);
    Body body;
    body.name = fmt::format("l{}", i + 1);
    body.mass = i == 0 ? 3.2 : 1.6;
    body.centre_of_mass = {0.0, 0.0, i == 0 ? 0.16 : 0.13};
    body.inertia = Eigen::Vector3d(0.01, 0.01, 0.001).asDiagonal();
    body.inertia *= body.mass;
    arm.joints.push_back(joint);
    arm.bodies.push_back(body);
  }
  return arm;
}

ArmLog draw_log(const Mechanism& arm, std::uint64_t seed, const ArmFriction& friction, double step,
                double seconds) {
  RandomNumbers random(seed);
  const auto samples = static_cast<Index>(seconds / step);
  const auto joints = static_cast<Index>(arm.joints.size());
  MatrixXd q = MatrixXd::Zero(samples, joints), qd = q, qdd = q, tau = q;
  for (Index j = 0; j < joints; ++j) {
    q.col(j).setConstant(random.uniform(-0.5, 0.5));
    for (int harmonic = 1; harmonic <= 5; ++harmonic) {
      const double w = 2.0 * std::numbers::pi * 0.1 * harmonic;
      const double size = random.uniform(0.25, 0.75) / harmonic;
      const double phase = random.uniform(0.0, 6.28);
      for (Index k = 0; k < samples; ++k) {
        const double angle = w * step * static_cast<double>(k) + phase;
        q(k, j) += size * std::sin(angle);
        qd(k, j) += size * w * std::cos(angle);
        qdd(k, j) -= size * w * w * std::sin(angle);
      }
    }
  }
  const reference::NewtonEuler<double> newton_euler(arm);
  for (Index k = 0; k < samples; ++k)
    tau.row(k) =
        newton_euler
            .inverse_dynamics(q.row(k).transpose(), qd.row(k).transpose(), qdd.row(k).transpose())
            .transpose();
  tau.array() += friction.coulomb * (qd.array() / 0.01).tanh() + friction.viscous * qd.array();
  for (std::size_t j = 0; j < friction.rotors.size(); ++j)
    tau.col(static_cast<Index>(j)) += friction.rotors[j] * qdd.col(static_cast<Index>(j));
  for (Index j = 0; j < joints; ++j) {
    const double noise = 0.01 * std::sqrt(tau.col(j).squaredNorm() / double(samples));
    for (Index k = 0; k < samples; ++k) {
      tau(k, j) += noise * random.uniform(-1.7, 1.7);
      q(k, j) += 1e-5 * random.uniform(-1.7, 1.7);
    }
  }
  return {q, tau, step};
}

std::string csv(const ArmLog& log) {
  std::string text = "time [s]";
  for (Index j = 0; j < log.q.cols(); ++j) text += fmt::format(",q_j{} [rad]", j + 1);
  for (Index j = 0; j < log.q.cols(); ++j) text += fmt::format(",tau_j{} [N*m]", j + 1);
  for (Index k = 0; k < log.q.rows(); ++k) {
    fmt::format_to(std::back_inserter(text), "\n{:.6f}", log.step * static_cast<double>(k));
    for (Index j = 0; j < log.q.cols(); ++j)
      fmt::format_to(std::back_inserter(text), ",{:.8f}", log.q(k, j));
    for (Index j = 0; j < log.q.cols(); ++j)
      fmt::format_to(std::back_inserter(text), ",{:.8g}", log.tau(k, j));
  }
  return text + "\n";
}

}  // namespace sinew::test
