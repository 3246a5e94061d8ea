// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/graph.h"

namespace sinew {

/// The graph with every long sum whose first two terms have one form begun at -0.0, so that its
/// first term can be a pass of a loop as the others are: -0.0 + x is x, bit for bit.
///
///   r = a*f[0] + b*f[1] + ...    ->    r = -0.0 + a*f[0] + b*f[1] + ...
Graph with_started_sums(const Graph& graph);

}  // namespace sinew
