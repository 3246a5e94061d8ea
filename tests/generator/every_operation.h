// SPDX-License-Identifier: GPL-3.0-or-later
// A function that needs every operation a graph can hold, and a graph's inputs as tests draw them.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/function.h"
#include "generator/graph.h"

namespace sinew {

/// `every_operation(a[4], b[2], r[20])`. The ranges keep away from poles and from the points where
/// a piecewise function has no derivative.
Function every_operation();

/// `count` states in the inputs' ranges; see reference::sample_box.
std::vector<std::vector<double>> states_of(const Graph& graph, int count, std::uint64_t seed);

}  // namespace sinew
