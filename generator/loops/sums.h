// SPDX-License-Identifier: GPL-3.0-or-later
// Long sums of a graph, term by term.
#pragma once

#include <vector>

#include "generator/graph.h"

namespace sinew {

/// A long sum: value 0 is its first term, value i the sum up to term i.
struct Sum {
  std::vector<Value> partial;
  std::vector<Value> terms;  ///< term i leads from value i - 1 to i; the first is not used
};

/// Values that a result needs.
std::vector<bool> live_values(const Graph& graph);

/// Sums of three or more terms of which no other is a part, with all their terms in the order of
/// addition.
std::vector<Sum> long_sums(const Graph& graph);

}  // namespace sinew
