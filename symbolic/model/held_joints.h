// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that stand still in all that is looked at.
#pragma once

#include <string>
#include <vector>

#include "symbolic/model/mechanism.h"

namespace sinew {

struct HeldJoint {
  std::string name;
  double position = 0.0;  ///< rad or m
};

/// The joint fixed at a position [rad or m].
void fix_at(Joint& joint, double position);

/// The mechanism with these joints fixed where they are, and what follows them at a ratio. Throws
/// std::invalid_argument where a four-bar follows one of them, or where no joint is left to move.
Mechanism with_held(Mechanism mechanism, const std::vector<HeldJoint>& held);

}  // namespace sinew
