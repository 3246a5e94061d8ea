// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/runs.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// Cosine and sine by which each link is turned against its reference: its parent, or the run's
/// frame {P} for links in a common frame (sum of the angles up to the link). Quarter turns of the
/// joints' zeros swap sine and cosine and cost nothing. Prismatic joints get (1, 0).
std::vector<CosSin> joint_angles(DefinitionList& list, const JointTree& tree, const Runs& runs,
                                 const std::vector<GiNaC::ex>& q);

}  // namespace sinew
