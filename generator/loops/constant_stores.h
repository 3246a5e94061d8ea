// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/loops/plan.h"

namespace sinew {

/// Loops over rows of a result that have the same constants in the same columns, as a coupling
/// matrix has its zeros: each pass stores a row's. Elements that `plan` stores in loops already
/// stay there.
///
///   P[4] = 0.0; P[5] = 0.0; P[25] = 0.0; P[26] = 0.0; ...
///   -> for (int i = 0; i < 8; ++i) { P[4 + 21 * i] = 0.0; P[5 + 21 * i] = 0.0; }
std::vector<Loop> loops_of_constants(const Graph& graph, const Plan& plan);

}  // namespace sinew
