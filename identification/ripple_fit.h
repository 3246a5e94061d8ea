// SPDX-License-Identifier: GPL-3.0-or-later
// Ripple in the position domain: which orders, how large, which phase (3.2, Fig. 3.5, 3.6).
#pragma once

#include <string>
#include <vector>

#include "identification/drive_regressors.h"

namespace sinew {

/// amplitude * sin(order * angle + phase), angle of the shaft named.
struct FittedRipple {
  RippleOrder order;
  Estimate amplitude;     ///< N·m at the output
  Estimate phase;         ///< rad
  Estimate sine, cosine;  ///< N·m: amplitude cos(phase), amplitude sin(phase)
};

struct RippleResult {
  std::vector<FittedRipple> ripples;  ///< significant ones
  double residual = 0.0;              ///< N·m, rms
  double width = 0.0;                 ///< s, of the bumps
  std::vector<std::string> missing;
};

/// Orders 1..`highest` of output and input shaft, one after the other as long as one is significant
/// (its amplitude 5 standard errors or more). Friction is fitted along; inertia, gamma1 and
/// the gear ratio are the model's: identify the inertia first.
RippleResult identify_ripple(const std::vector<DriveStretch>& stretches,
                             const MotorParameters& model, int highest = 4);

/// Amplitude [rad/s] of the velocity at the motor's rotation frequency over the log's constant
/// velocities: the figure of merit of a compensation (Fig. 3.6). 0 where there is none.
double velocity_ripple_at_motor_order(const std::vector<DriveStretch>& stretches,
                                      double gear_ratio);

}  // namespace sinew
