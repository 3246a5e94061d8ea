// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/mechanism.h"

namespace sinew {

/// tendon_lengths, coupling_matrix, joint_torque, joint_stiffness and, where the coupling is
/// constant, link_position. Empty for a mechanism without tendons.
std::vector<Function> tendon_functions(const Mechanism& mechanism);

}  // namespace sinew
