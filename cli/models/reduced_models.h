// SPDX-License-Identifier: GPL-3.0-or-later
// What a model gains and loses by leaving something out.
#pragma once

#include <string>
#include <vector>

#include "symbolic/model/mechanism.h"

namespace sinew {

struct ReducedModel {
  std::string
      left_out;  ///< "gravity", "Coriolis and centrifugal torques", "change of the coupling"
  std::string function;  ///< that is reduced: inverse_dynamics, joint_torque
  int operations = 0, reduced_operations = 0;
  /// Of the joint where it is largest, in units of the whole torque's rms there.
  double rms_error = 0.0, largest_error = 0.0;
};

/// Errors over `states` random states, the same on every run: positions over their ranges, rates
/// and accelerations up to `share` of their largest, tendon forces up to the model's largest.
std::vector<ReducedModel> reduced_models(const Mechanism& mechanism, int states = 2000,
                                         double share = 0.25);

}  // namespace sinew
