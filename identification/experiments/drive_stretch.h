// SPDX-License-Identifier: GPL-3.0-or-later
// What the experiments of chapter 3 take from a drive's log.
#pragma once

#include <string>
#include <vector>

#include "identification/logs/log.h"
#include "symbolic/parts/motor.h"

namespace sinew {

/// One gapless stretch of a drive's log, SI units.
struct DriveStretch {
  double period = 0.0;    ///< s
  Eigen::ArrayXd theta;   ///< rad, output shaft
  Eigen::ArrayXd omega;   ///< rad/s, as logged, else from theta
  Eigen::ArrayXd torque;  ///< N·m, motor less load
};

/// Theta, omega (where it is not logged theta's slope, over as little time as its noise allows and
/// `smoothing` seconds at most), tau_m - load.
std::vector<DriveStretch> drive_stretches(const Log& log, double smoothing = 0.01);

/// Samples [first, last) that move at one velocity.
struct Plateau {
  std::size_t stretch = 0;
  long first = 0, last = 0;
  double velocity = 0.0;  ///< rad/s
};

/// Stretches of constant velocity, without the transients at their beginnings, at least `least`
/// seconds long. Standstill is none.
std::vector<Plateau> plateaus(const std::vector<DriveStretch>& stretches, double least = 0.1);

}  // namespace sinew
