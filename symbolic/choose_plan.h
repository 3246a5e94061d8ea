// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "generator/function.h"
#include "symbolic/dynamics_plan.h"
#include "symbolic/mechanism.h"

namespace sinew {

/// What a function costs once it is optimised; smaller is better. Comes from the generator, so that
/// the derivation chooses by what is emitted and still knows nothing of C.
using CostOf = std::function<double(const Function&)>;

/// Tries the choices joint by joint, keeping what makes `derive`'s function cheaper, until nothing
/// does. Deterministic. Without a cost, or with more than `most_joints` joints, the default plan.
DynamicsPlan choose_plan(
    const Mechanism& mechanism,
    const std::function<Function(const JointTree&, const DynamicsPlan&)>& derive,
    const CostOf& cost, int most_joints = 12);

}  // namespace sinew
