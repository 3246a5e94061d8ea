// SPDX-License-Identifier: GPL-3.0-or-later
// How far tendons are bent in their guides, from the routing and the pose: what guiding friction
// (4.1) grows with.
#pragma once

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// bending_angles(q -> angles m) [rad]: over pulleys the joint's angle, whichever way it turns; at
/// both ends of a straight stretch how far it leans away from its direction at q = 0, seen from the
/// body that guides it. Bending outside the finger (wrist, fixed guides) adds to it. Throws
/// std::invalid_argument for a tendon over an unknown joint or body.
Function tendon_bending_angles(const Mechanism& mechanism);

}  // namespace sinew
