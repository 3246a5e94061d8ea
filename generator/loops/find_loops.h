// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "generator/loops/plan.h"
#include "generator/target.h"

namespace sinew {

struct LoopLimits {
  /// What a loop must save: operations written in it fewer than without.
  int saving = 24;
  /// What loops may cost: instructions executed over those without loops, as size_of estimates
  /// them. A pass reads from tables what straight code has in its instructions.
  double growth = 1.1;
  /// Elements that the arrays of a function's calls and loops may have together: they are on the
  /// stack.
  std::size_t arrays = 128;
};

/// Whether more is executed than the limits allow.
bool is_dear(const PlanSize& now, const PlanSize& before, const LoopLimits& limits);

/// The usual ones; where a target is short of room for code, loops may cost more.
/// docs/performance.md has the measurement.
LoopLimits loop_limits(const Target& target);

/// Finds what repeats in an optimised graph and plans loops for it: results, steps of long sums and
/// other values whose computations have the same form and differ in constants, signs and input
/// elements alone. Results have the bits of the graph evaluated value by value.
Plan plan_loops(const Graph& graph, const LoopLimits& limits);

/// A graph and the plan for it.
struct PlannedGraph {
  Graph graph;
  Plan plan;
};

/// The same of the graph or of that with its sums started, whichever leaves less to write.
PlannedGraph plan_graph(const Graph& graph, const LoopLimits& limits);

}  // namespace sinew
