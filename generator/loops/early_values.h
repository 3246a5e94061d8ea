// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/graph.h"
#include "generator/loops/plan.h"

namespace sinew {

/// Which values to compute before the last loop. What the loops need is, and what needs a loop's
/// result is not. Of the others so many are that the fewest values have to wait, on the stack,
/// until the loops are done: often few results of many intermediates that nothing else needs. It is
/// the minimum cut between what is computed before and after.
std::vector<bool> early_values(const Graph& graph, const std::vector<Loop>& loops,
                               const std::vector<bool>& needed);

}  // namespace sinew
