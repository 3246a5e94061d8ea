// SPDX-License-Identifier: GPL-3.0-or-later
// Torque constants of joints whose efforts are logged as currents.
#pragma once

#include <vector>

#include "identification/regression/candidate.h"
#include "identification/subjects/effort_model.h"

namespace sinew::diagnosis {

/// What makes an effort of a joint's current [N·m/A, N/A].
struct FittedConstant {
  double value = 0.0;
  double standard_error = 0.0;
  bool assumed = false;  ///< the logs do not tell it: the geometric mean of those that they tell
};

/// The constants with which the currents are the model's effort beside an armature, viscous and
/// Coulomb friction and an offset of each joint's own. `logs`: the targets of the joints asked for
/// are currents. `joints`: those to be fitted. Empty where the logs tell none of them.
std::vector<FittedConstant> fit_torque_constants(const std::vector<Recording>& logs,
                                                 const EffortModel& model,
                                                 const std::vector<std::size_t>& joints);

}  // namespace sinew::diagnosis
