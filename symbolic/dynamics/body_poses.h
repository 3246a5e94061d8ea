// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// body_poses(q -> T 3b x 4): poses of the b bodies' frames in the base frame, one below the other
/// in the mechanism's order, [R p] row by row [1 and m]. For drawing; not among the functions that
/// a mechanism offers, of which forward_kinematics gives the tip alone.
Function body_poses_function(const Mechanism& mechanism);

}  // namespace sinew
