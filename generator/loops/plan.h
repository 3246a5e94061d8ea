// SPDX-License-Identifier: GPL-3.0-or-later
// What of a graph is written as loops of fixed length. The graph itself stays as it is: evaluation,
// cost and every other user see the operations that are executed; only emission follows the plan.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// An input element of a loop's body.
struct LoopLeaf {
  enum class Kind {
    shared,    ///< the same value in all passes
    constant,  ///< a constant for each pass
    input,     ///< an input element of the function for each pass
    carried    ///< what the pass before gave
  };
  Kind kind = Kind::shared;
  Value value = no_value;              ///< shared
  std::vector<double> constants = {};  ///< constant: by pass
  std::vector<int> inputs = {};        ///< input: by pass, all in one argument
  int result = 0;                      ///< carried: which of the loop's results
};

/// A result of a loop's body: stored in each pass, or carried to the next.
struct LoopResult {
  int port = 0;               ///< stored: the output
  std::vector<int> elements;  ///< stored: by pass; empty where carried
  Value first = no_value;     ///< carried: the value before the first pass
  Value last = no_value;      ///< carried: the value that the last pass gives
  bool is_carried() const { return last != no_value; }
};

/// `count` passes of one body. The body's input element k is leaves[k]; the elements of its only
/// output are `results`.
struct Loop {
  int count = 0;
  Graph body;
  std::vector<LoopLeaf> leaves;
  std::vector<LoopResult> results;
};

/// A value to compute or, where `loop` is not -1, a loop to run.
struct Step {
  Value value = no_value;
  int loop = -1;
};

/// The statements of a function in order.
struct Plan {
  std::vector<Loop> loops;
  std::vector<Step> steps;
  std::vector<int> uses;                  ///< of each value outside of loops; a loop counts as two
  std::vector<std::vector<bool>> stored;  ///< by output and element: stored by a loop
};

/// Every value in the graph's order, no loop.
Plan straight_plan(const Graph& graph);

/// The steps for these loops. Throws std::logic_error where two need each other's results.
Plan plan_with(const Graph& graph, std::vector<Loop> loops);

/// Operations of the graph, inputs and constants left out.
int operation_count(const Graph& graph);

/// Operations that a plan writes, and that it executes.
struct PlanSize {
  int written = 0;
  int executed = 0;
};
PlanSize size_of(const Graph& graph, const Plan& plan);

}  // namespace sinew
