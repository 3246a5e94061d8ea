// SPDX-License-Identifier: GPL-3.0-or-later
// Motor with harmonic drive, seen at the output shaft (chapter 3).
//
//   B θ'' = τ_m - τ_v(θ') - τ_r(θ) - τ_r,in(θ/α)/α - R f,   B = B_rotor/α² + B_gearbox
//
// θ is the output angle; friction and ripple act against τ_m. Torques are at the output shaft.
#pragma once

#include <vector>

#include "generator/function.h"

namespace sinew {

/// One periodic term amplitude * sin(order * angle + phase).
struct Ripple {
  double order = 1.0;      ///< periods per turn of its own shaft
  double amplitude = 0.0;  ///< N·m as seen at the output shaft (for the input side: already over α)
  double phase = 0.0;      ///< rad
};

struct MotorParameters {
  double gear_ratio = 0.0;       ///< α: output turns per input turn
  double rotor_inertia = 0.0;    ///< kg·m², at the input
  double gearbox_inertia = 0.0;  ///< kg·m², at the output
  double torque_constant = 0.0;  ///< N·m/A, at the rotor
  double pulley_radius = 0.0;    ///< R_motor [m]
  double gamma1 = 0.0;           ///< s/rad, (3.8)
  double gamma2 = 0.0;           ///< N·m; the plateau is γ2 π/2
  double gamma3 = 0.0;           ///< N·m·s/rad
  std::vector<Ripple> output_ripple;
  std::vector<Ripple> input_ripple;
  double friction_compensation = 0.9;  ///< share of the friction fed forward, in [0, 1)
  double ripple_compensation = 0.9;    ///< share of the ripple fed forward, in [0, 1)
  Range theta{-6.283, 6.283};          ///< rad, output
  Range velocity{-10.0, 10.0};         ///< rad/s, output
  Range torque{-2.0, 2.0};             ///< N·m, output
  Range tendon_force{0.0, 100.0};      ///< N
};

// All throw std::invalid_argument for parameters that make no sense: a gear ratio, inertia or
// torque constant that is not positive, negative friction, a compensation outside [0, 1).

/// friction_torque(qd -> tau): -(γ2 atan(γ1 q') + γ3 q') [N·m] (3.8); opposes motion.
Function motor_friction_torque(const MotorParameters& parameters);
/// ripple_torque(theta -> tau): -(τ_r + τ_r,in/α) [N·m]; what acts on the shaft.
Function motor_ripple_torque(const MotorParameters& parameters);
/// acceleration(theta, qd, tau_m, f -> qdd) [rad/s²] (3.5).
Function motor_acceleration(const MotorParameters& parameters);
/// compensation_torque(theta, qd -> tau 1, margin 1): feedforward [N·m] against friction and
/// ripple, and the power [W] that friction still takes away: never negative, so the motor stays
/// passive. The ripple depends on position alone and does no work over a turn.
Function motor_compensation_torque(const MotorParameters& parameters);
/// power_balance(theta, qd, tau_m, f -> power 5): by the motor, friction (<= 0), ripple, the
/// tendon, and into kinetic energy [W]; the last is the sum of the others.
Function motor_power_balance(const MotorParameters& parameters);
/// torque(current -> tau_m) [A -> N·m at the output].
Function motor_torque(const MotorParameters& parameters);
/// current(tau_m -> current) [N·m at the output -> A].
Function motor_current(const MotorParameters& parameters);

/// rigid_torque(theta, qd, qdd -> tau): inertia and ripple [N·m], friction aside (3.5).
Function motor_rigid_torque(const MotorParameters& parameters);

/// All of the above but rigid_torque, which effort (driven_model.h) is made of.
std::vector<Function> motor_functions(const MotorParameters& parameters);

/// B = B_rotor/α² + B_gearbox [kg·m²].
double motor_inertia(const MotorParameters& parameters);

}  // namespace sinew
