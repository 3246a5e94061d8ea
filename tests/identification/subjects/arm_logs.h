// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of an arm of five joints from Newton-Euler numerics.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "symbolic/model/mechanism.h"

namespace sinew::test {

inline constexpr Eigen::Index kArmJoints = 5;

/// A shoulder that turns and pitches, an elbow, a wrist that rolls and pitches; no friction. The
/// hand has a fiftieth of the shoulder's mass.
Mechanism arm_of_five();

/// Two links in a vertical plane; no friction.
Mechanism upper_and_lower_arm();

/// Friction of every joint, [N·m] and [N·m·s/rad], and each one's rotor [kg·m²]; empty: none.
struct ArmFriction {
  double coulomb = 0.0, viscous = 0.0;
  std::vector<double> rotors = {};
};

/// samples x joints; rad, N·m.
struct ArmLog {
  Eigen::MatrixXd q, tau;
  double step = 0.0;  ///< s
};

/// A Fourier series of ten seconds for all joints, as excitation is planned, and what the arm asks
/// of its joints there, with a hundredth of noise.
ArmLog draw_log(const Mechanism& arm, std::uint64_t seed, const ArmFriction& friction,
                double step = 0.004, double seconds = 10.0);

/// time, q_j1 ..., tau_j1 ..., whatever the joints are called.
std::string csv(const ArmLog& log);

}  // namespace sinew::test
