// SPDX-License-Identifier: GPL-3.0-or-later
// Ripple in the position domain: which orders, how large, which phase (3.2, Fig. 3.5, 3.6).
#pragma once

#include <string>
#include <vector>

#include "identification/experiments/drive_regressors.h"

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
/// (its amplitude 5 standard errors or more). One factor on the model's friction is fitted along;
/// inertia, the friction's shape and the gear ratio are the model's: identify those first.
RippleResult identify_ripple(const std::vector<DriveStretch>& stretches,
                             const MotorParameters& model, int highest = 4);

}  // namespace sinew
