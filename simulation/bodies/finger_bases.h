// SPDX-License-Identifier: GPL-3.0-or-later
// How the bases of a hand's fingers move with the wrist and with the four-bar that carries one.
//
// Carriers c: the four-bar's crank theta2, where the hand has one, then q71, q73; their rates cd
// and accelerations cdd likewise. One row of a result a finger, in their order.
#pragma once

#include "symbolic/hand/hand.h"

namespace sinew {

/// base_pose(c -> T 4k x 4): homogeneous transforms of the k fingers' bases to the forearm frame
/// {0}, one below the other [m].
Function finger_base_pose(const Hand& hand);

/// base_twist(c, cd -> twist k x 6): velocity of each base's origin and angular velocity against
/// {0}, in the base frame [m/s, rad/s].
Function finger_base_twist(const Hand& hand);

/// base_motion(c, cd, cdd, gravity 3 -> motion k x 9): angular velocity, angular acceleration and
/// acceleration of the origin less gravity, in the base frame, as moving_base.h wants them [rad/s,
/// rad/s², m/s²]; `gravity` in {0} [m/s²].
Function finger_base_motion(const Hand& hand);

}  // namespace sinew
