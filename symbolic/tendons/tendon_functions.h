// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// tendon_lengths, coupling_matrix, joint_torque, joint_stiffness, tendon_hessian and, where the
/// coupling is constant, link_position and link_position_covariance; for a base held by straight
/// tendons those of straight_base.h. Empty for a mechanism without tendons.
std::vector<Function> tendon_functions(const Mechanism& mechanism);

}  // namespace sinew
