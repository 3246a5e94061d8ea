// SPDX-License-Identifier: GPL-3.0-or-later
// The hand's default numbers, for tests of single derivations.
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <vector>

#include "symbolic/parts/four_bar.h"
#include "symbolic/parts/guiding_friction.h"
#include "symbolic/parts/lever.h"
#include "symbolic/tendons/link_position.h"
#include "symbolic/parts/motor.h"
#include "symbolic/parts/tendon_force.h"
#include "symbolic/parts/wrist.h"

namespace sinew_tests {

constexpr double degree = std::numbers::pi / 180.0;

/// Tables 6.1 and 6.2.
inline sinew::WristParameters wrist_parameters() {
  sinew::WristParameters p;
  p.length = 0.050;
  p.width = 0.042;
  p.thickness = 0.036;
  // y of the forearm and of the palm points, in millimetres, for the two layers of 19 tendons.
  const int forearm[2][19] = {
      {7, 8, 10, 11, 13, 15, 16, 18, 19, 21, 23, 24, 26, 27, 29, 31, 32, 34, 35},
      {6, 7, 9, 11, 12, 14, 15, 17, 19, 20, 22, 23, 25, 27, 28, 30, 31, 33, 35}};
  const int palm[2][19] = {
      {-11, -10, -8, -6, -5, -3, -2, 0, 2, 3, 5, 6, 8, 10, 11, 13, 14, 16, 18},
      {-13, -11, -10, -8, -6, -5, -3, -2, 0, 2, 3, 5, 6, 8, 10, 11, 13, 14, 16}};
  for (int layer = 0; layer < 2; ++layer)
    for (int i = 0; i < 19; ++i) {
      p.forearm_points.emplace_back(0.004, forearm[layer][i] / 1000.0, layer == 0 ? 0.008 : 0.028);
      p.palm_points.emplace_back(-0.004, palm[layer][i] / 1000.0, layer == 0 ? 0.010 : -0.010);
    }
  p.motor_radius = 0.005;
  p.flexion = {-30 * degree, 30 * degree};
  p.abduction = {-20 * degree, 20 * degree};
  return p;
}

inline sinew::FourBarParameters four_bar_parameters() {
  sinew::FourBarParameters p;
  p.ground = 0.012;
  p.crank = 0.010;
  p.coupler = 0.012;
  p.rocker = 0.011;
  p.branch = -1;
  p.pulley_radius = 0.005;
  p.reference_theta2 = 90 * degree;
  p.theta2 = {60 * degree, 120 * degree};
  return p;
}

/// 0 to 99 N over 10 mm.
inline sinew::LeverParameters lever_parameters() {
  sinew::LeverParameters p;
  p.motor = {{0.0, 0.0}, 0.005, 1};
  p.fixed = {{0.034, 0.0}, 0.004, 1};
  p.pivot = {0.005, -0.005};
  p.lever_length = 0.014;
  p.pulley_radius = 0.004;
  p.pulley_sense = -1;
  p.spring_arm = 0.015;
  p.spring_angle = -130 * degree;
  p.anchor = {0.025, -0.017};
  p.spring_stiffness = 6400;
  p.free_angle = 48 * degree;
  p.end_angle = sinew::lever_angle_at(p, 0.010);
  return p;
}

inline sinew::MotorParameters motor_parameters() {
  sinew::MotorParameters p;
  p.gear_ratio = 0.01;
  p.rotor_inertia = 2.0e-7;
  p.gearbox_inertia = 5e-5;
  p.torque_constant = 0.0085;
  p.pulley_radius = 0.005;
  p.gamma1 = 10;
  p.gamma2 = 0.5586;
  p.gamma3 = 0.0356;
  p.output_ripple = {{1, 0.02, 0.3}};
  p.input_ripple = {{1, 0.04, 1.1}};
  return p;
}

inline sinew::GuidingParameters guiding_parameters() {
  sinew::GuidingParameters p;
  p.C0 = 6.0;
  p.C1 = 0.35;
  p.friction_coefficient = 0.10;
  return p;
}

inline sinew::TendonParameters tendon_parameters() {
  return {1.0e4, 0.5};
}

/// Table 5.2 for the palm's points; the distal ones are the default, not the table's.
inline sinew::ThumbBaseParameters thumb_base_parameters() {
  sinew::ThumbBaseParameters p;
  p.length = 0.045;
  for (const double y : {1.0, -1.0})
    for (const double z : {-1.0, 1.0}) {
      p.base_points.emplace_back(0.002, 0.030 * y, 0.025 * z);
      p.distal_points.emplace_back(0.002, 0.006 * y, 0.005 * z);
    }
  p.angle = {-40 * degree, 40 * degree};
  return p;
}

}  // namespace sinew_tests
