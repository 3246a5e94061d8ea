// SPDX-License-Identifier: GPL-3.0-or-later
// The mass matrix: second derivatives of the kinetic energy in qd, from composites of all masses
// beyond each joint (columns are the wrench that a unit acceleration of one joint needs).
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/dynamics_plan.h"
#include "symbolic/dynamics/joint_tree.h"

namespace sinew {

/// M(q), n x n row-major and symmetric, kg m^2 (revolute), kg (prismatic), as definitions appended
/// to `list`.
std::vector<GiNaC::ex> mass_matrix(DefinitionList& list, const JointTree& tree,
                                   const DynamicsPlan& plan, const std::vector<GiNaC::ex>& q);

}  // namespace sinew
