// SPDX-License-Identifier: GPL-3.0-or-later
// A wrist whose tendons are kept at their force while it moves: where their motors should stand
// (6.9), and what may change that.
#pragma once

#include "symbolic/extension/observation.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// observation(q71, q73 [rad], q71_speed, q73_speed [rad/s], q71_side, q73_side -> measured m):
/// motor angles [rad], 0 in the reference pose. A speed is the reading's smooth derivative, a side
/// the end of its play that the sensor is at (late_sensor.h). Effects: coupling left uncompensated,
/// zero offset, scale, low-pass and play of both angles, shift of the contact point on the pulleys
/// at both ends, and the radius of each motor's pulley.
Observation wrist_observation(const WristParameters& parameters, const std::string& model);

}  // namespace sinew
