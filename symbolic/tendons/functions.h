// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/dynamics/choose_plan.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Every function that a mechanism offers, in the order in which it is emitted: kinematics,
/// dynamics, and, where there are tendons, coupling and stiffness. `cost` decides between forms
/// of equal meaning; without it the default forms are taken. With `runtime_parameters` masses and
/// gravity are arguments of the dynamics (runtime_parameters.h).
std::vector<Function> functions_of(const Mechanism& mechanism, const CostOf& cost = {},
                                   bool runtime_parameters = false);

/// Of these the kinematics alone: forward_kinematics and tip_jacobian.
std::vector<Function> kinematics_functions(const Mechanism& mechanism);

}  // namespace sinew
