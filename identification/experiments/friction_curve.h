// SPDX-License-Identifier: GPL-3.0-or-later
// Friction from constant velocities: mean torques over whole motor periods, then gamma1..3 (3.8).
#pragma once

#include <string>
#include <vector>

#include "identification/experiments/bump_projection.h"
#include "identification/experiments/drive_stretch.h"

namespace sinew {

/// Mean torque at one velocity.
struct FrictionPoint {
  double velocity = 0.0;  ///< rad/s
  double torque = 0.0;    ///< N·m, mean over the travel of whole motor periods
  double low = 0.0;       ///< smallest and largest torque of the stretch (Fig. 3.3)
  double high = 0.0;
  long periods = 0;        ///< turns of the motor
  double noise = 0.0;      ///< N·m, white, of one sample
  double deviation = 0.0;  ///< N·m, of the mean
  /// Velocities of short blocks and their share of the travel: ripple makes them differ, and
  /// friction is not linear.
  std::vector<double> velocities, shares;
  double sine = 0.0;    ///< means of sin and cos of the output angle: the output-side ripple,
  double cosine = 0.0;  ///< which motor periods do not average out, is fitted along
};

struct FrictionCurve {
  std::vector<FrictionPoint> points;
  bool identified = false;
  Estimate gamma1, gamma2, gamma3;  ///< s/rad, N·m, N·m·s/rad
  Estimate plateau;                 ///< gamma2 pi/2 [N·m]
  double residual = 0.0;            ///< N·m, rms over the points
  /// Largest share of the fitted friction that may be fed forward: at every velocity measured, and
  /// at standstill, the true friction is larger with 97.5 % confidence, so that the motor stays
  /// passive. Below 1 by the fit's uncertainty; 0 where that is as large as the friction.
  double passive_share = 0.0;
  std::vector<std::string> missing;  ///< what the log cannot say, and the experiment that would
};

/// `gear_ratio`: output turns per motor turn.
FrictionCurve identify_friction(const std::vector<DriveStretch>& stretches, double gear_ratio);

/// gamma2 atan(gamma1 w) + gamma3 w [N·m].
double friction_torque(double gamma1, double gamma2, double gamma3, double velocity);

}  // namespace sinew
