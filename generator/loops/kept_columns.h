// SPDX-License-Identifier: GPL-3.0-or-later
// What a loop has to keep for what follows it.
#pragma once

#include <vector>

#include "generator/loops/plan.h"
#include "generator/loops/unify.h"

namespace sinew {

/// The values of the graph that are there after these loops.
std::vector<bool> given_by(const Graph& graph, const std::vector<Loop>& loops);

/// Of a loop that is built and comes to those of `planned`: keeps the columns of its body that are
/// needed beside it and would take several operations to compute again, and no others.
void keep_needed(const Graph& graph, const Plan& planned, LoopBuilder& builder);

}  // namespace sinew
