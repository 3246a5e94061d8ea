// SPDX-License-Identifier: GPL-3.0-or-later
// In which order the results of a function, and the partial sums that lead to them, are computed.
#pragma once

#include <vector>

#include "generator/graph.h"

namespace sinew {

enum class ResultOrder {
  one_by_one,          ///< each result in full before the next
  beside_longest_sum,  ///< along the longest sum; partial sums of others as soon as what they share
                       ///< with it is there: terms with common factors are used up together
};

/// Values of `graph` to compute one after the other, each with what it needs; all results are among
/// them. `last_first`: from the last result to the first.
std::vector<Value> result_order(const Graph& graph, ResultOrder order, bool last_first);

}  // namespace sinew
