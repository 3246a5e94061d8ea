// SPDX-License-Identifier: GPL-3.0-or-later
// What the real-time step asks of the whole hand at once (section 8 of the equations).
#pragma once

#include "symbolic/hand/hand.h"

namespace sinew {

/// inverse_dynamics(q, qd, qdd, g -> tau): joint torques [N m] that a motion of the fingers takes,
/// M q̈ + C q̇ + g, each finger on a base at rest with its own gravity. q, qd, qdd: coordinates of
/// the fingers alone, without the four-bar's crank [rad, rad/s, rad/s^2]; g: gravity in the base
/// frame of each finger, one row a finger [m/s^2], as finger_gravity gives it.
Function hand_inverse_dynamics(const Hand& hand);

/// wrist_passage(q_wrist -> h, P): lengths [m] of all tendons through the wrist and their
/// derivatives by q71 and q73 [m/rad], with what they share computed once.
Function hand_wrist_passage(const Hand& hand);

}  // namespace sinew
