// SPDX-License-Identifier: GPL-3.0-or-later
// What a tendon's friction depends on, from the motion of the joints.
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// tendon_motion(q, qd -> P, rate, bending): coupling matrix P = dh/dq, tendons x coordinates
/// row-major (5.9); rate P qd [m/s] of the paths' lengths; bending [rad] of tendon_bending.h.
Function tendon_motion_function(const Mechanism& mechanism);

}  // namespace sinew
