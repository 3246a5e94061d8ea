// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "symbolic/dynamics/joint_tree.h"

namespace sinew {

/// Moves every part of a link's mass distribution that its own joint cannot move to the parent
/// link, from the leaves to the base.
///
/// Mass on a revolute joint's axis does not notice the joint's angle: the link's J(z,z), J(z,1) and
/// m become zero and reappear, through the joint's origin, in the parent's J. Behind a prismatic
/// joint the whole rotational block J(xyz,xyz) moves. What is left over all links are the base
/// parameters: the fewest numbers that the motion depends on, but for joints whose parents turn
/// about one fixed axis only, where the rest drops out of the equations by itself.
void fold_base_parameters(JointTree& tree);

}  // namespace sinew
