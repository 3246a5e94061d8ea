// SPDX-License-Identifier: GPL-3.0-or-later
// What is driven in a model's folder, as its logs show it.
#pragma once

#include <vector>

#include "cli/models/model_folder.h"
#include "identification/adoption/diagnose.h"
#include "symbolic/model/held_joints.h"

namespace sinew {

/// Sets kind, mechanism, driven model and channels of a request for its logs: of joints by their
/// own efforts or by the forces of their tendons, which is what the first log has, of all fingers
/// of a hand with the palm held, or of a motor. Joints of a mechanism that no log moves are held:
/// they are given back, and noted; entries that were learnt of them are left out. Throws
/// std::runtime_error for any other model.
std::vector<HeldJoint> set_driven_model(const ModelFolder& folder,
                                        diagnosis::DiagnoseRequest& request);

}  // namespace sinew
