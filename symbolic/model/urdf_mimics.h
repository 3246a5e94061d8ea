// SPDX-License-Identifier: GPL-3.0-or-later
// Joints of a URDF that follow others, and those that do not move at all, each in one step.
#pragma once

#include "symbolic/files/description_error.h"
#include "symbolic/model/urdf_outline.h"

namespace sinew {

/// Rewrites what the joints mimic: a chain of mimics (c follows b, which follows a) becomes one
/// step, and what follows a joint that stands still, or with multiplier 0, stands still itself
/// (`held`). Reports joints that mimic an unknown joint, themselves, or each other in a circle.
void resolve_mimics(UrdfOutline& outline, Findings& findings);

}  // namespace sinew
