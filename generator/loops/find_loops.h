// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/loops/plan.h"

namespace sinew {

/// What a loop must save: operations written in it fewer than without. docs/performance.md has the
/// measurement.
inline constexpr int smallest_saving = 24;

/// What loops may cost: operations executed over those of the graph. A value that two passes share
/// is computed in both.
inline constexpr double largest_growth = 1.11;

/// Finds what repeats in an optimised graph and plans loops for it: results in a row, and steps of
/// long sums, whose computations have the same form and differ in constants and input elements
/// alone. Results have the bits of the graph evaluated value by value.
Plan plan_loops(const Graph& graph, int saving = smallest_saving);

}  // namespace sinew
