// SPDX-License-Identifier: GPL-3.0-or-later
// Variable-stiffness lever: a sprung lever deflects the tendon between two pulleys (4.1).
//
// Planar. The tendon runs from the motor pulley (1) around the pulley on the lever (2) to the fixed
// pulley (3). The lever turns about a pivot; a linear spring connects a point of the lever with a
// fixed anchor. theta is the direction of the lever, from the pivot to its pulley.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "generator/function.h"

namespace sinew {

struct Pulley {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m
  double radius = 0.0;                               ///< m
  int sense = 1;  ///< +1: the tendon runs counter-clockwise around it on the way from 1 to 3
};

struct LeverParameters {
  Pulley motor, fixed;
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero();  ///< m
  double lever_length = 0.0;                        ///< m, pivot to the lever's pulley
  double pulley_radius = 0.0;                       ///< m, of the lever's pulley
  int pulley_sense = -1;
  double spring_arm = 0.0;    ///< m, pivot to the spring's point on the lever
  double spring_angle = 0.0;  ///< rad, of that point, from the lever
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  ///< m, the spring's fixed point
  double spring_stiffness = 0.0;                     ///< K [N/m]
  double free_angle = 0.0;                           ///< theta_0 [rad]: spring and tendon free
  double end_angle = 0.0;                            ///< rad, the end of the lever's travel
  double count_free = 0.0;        ///< of the lever's 12-bit sensor at the free angle
  double count_end = 4095.0;      ///< and at the end of travel
  int newton_iterations = 5;      ///< of the map from elongation to angle
  double singular_margin = 1e-6;  ///< rad; nearer to a dead centre counts as one
};

/// state(theta -> out 4): dL [m], elongation x = dL(theta_0) - dL [m], force -U'/dL' [N], stiffness
/// df/dx [N/m]. dL counts both free stretches and all three wraps, up to a constant.
Function lever_state(const LeverParameters& parameters);
/// slope(theta -> out 2): dL' [m/rad], U' [N m/rad]: force and length for the virtual work.
Function lever_slope(const LeverParameters& parameters);
/// angle(elongation, theta -> theta_lever 1, residual 1): the lever's angle [rad] at an elongation
/// [m] by a fixed number of Newton steps from `theta`; residual: the elongation's remaining error
/// [m]. Angles stay within the lever's travel.
Function lever_angle(const LeverParameters& parameters);
/// status(theta -> status 1): 0 fine; 1 outside the lever's travel, at a dead centre or where the
/// tendon's path does not exist.
Function lever_status(const LeverParameters& parameters);

/// All of the above.
std::vector<Function> lever_functions(const LeverParameters& parameters);

/// Lever angle [rad] at an elongation [m], followed from the free angle; for the end of travel.
/// Throws std::domain_error if the lever cannot be deflected as far.
double lever_angle_at(LeverParameters parameters, double elongation);

/// Polynomials of the sensor's count in Horner form, coefficients from the constant upwards, in the
/// normalised variable u = (counts - centre)/half_range.
struct LeverCalibration {
  double centre = 2048.0;        ///< counts
  double half_range = 2048.0;    ///< counts; counts outside centre ± half_range are limited
  std::vector<double> force;     ///< N
  std::vector<double> length;    ///< dL [m]
  double smallest_slope = 1e-6;  ///< m; |d(dL)/du| below this counts as a dead centre
};

/// calibrated_state(counts -> out 3): dL [m], force [N], stiffness [N/m]. The stiffness is
/// -f'/dL', so that it is the derivative of the force along the length whatever the coefficients.
Function lever_calibrated_state(const LeverCalibration& calibration);

}  // namespace sinew
