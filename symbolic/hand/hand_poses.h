// SPDX-License-Identifier: GPL-3.0-or-later
// Where the fingers are: from their bases through palm and wrist to the forearm.
#pragma once

#include "symbolic/hand/hand.h"

namespace sinew {

/// fingertips(q, q_wrist -> in_palm 4k x 4, in_forearm 4k x 4): homogeneous transforms of the k
/// fingers' tips, one below the other, to {ABC} and to {0} [m].
Function hand_fingertips(const Hand& hand);

/// finger_gravity(q, q_wrist, gravity 3 -> g k x 3): gravity in each finger's base frame from
/// gravity in the forearm frame {0} [m/s^2].
Function hand_finger_gravity(const Hand& hand);

}  // namespace sinew
