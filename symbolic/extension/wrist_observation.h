// SPDX-License-Identifier: GPL-3.0-or-later
// A wrist whose tendons are kept at their force while it moves: where their motors should stand
// (6.9), and what may change that.
#pragma once

#include "symbolic/extension/observation.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// observation(q71, q73 -> measured m): motor angles [rad], 0 in the reference pose. Effects:
/// coupling left uncompensated, zero offset and scale of both angles, shift of the contact point on
/// the pulleys at both ends, and the radius of each motor's pulley.
Observation wrist_observation(const WristParameters& parameters, const std::string& model);

}  // namespace sinew
