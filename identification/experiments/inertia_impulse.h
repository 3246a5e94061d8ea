// SPDX-License-Identifier: GPL-3.0-or-later
// Inertia from torque impulses, with friction accounted for and without: the difference is the bias
// of (3.6).
#pragma once

#include <string>
#include <vector>

#include "identification/experiments/bump_projection.h"
#include "identification/experiments/drive_stretch.h"

namespace sinew {

struct InertiaResult {
  bool identified = false;
  Estimate inertia;           ///< B at the output [kg·m²], with friction and ripple fitted along
  Estimate without_friction;  ///< tau_m = B theta'' alone over the impulses, (3.6)
  double bias = 0.0;          ///< of that, relative to `inertia`
  double residual = 0.0;      ///< N·m, rms, with friction
  double residual_without = 0.0;
  std::vector<std::string> missing;
};

/// tau_m - load = B theta'' + c1 atan(gamma1 w) + c2 w + ripple of order 1 at output and input,
/// projected on bumps of `width` seconds. gamma1 and the gear ratio are the model's.
InertiaResult identify_inertia(const std::vector<DriveStretch>& stretches,
                               const MotorParameters& model, double width = 0.03);

}  // namespace sinew
