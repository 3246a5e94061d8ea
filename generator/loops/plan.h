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
    chosen,    ///< one of a few values for each pass
    kept,      ///< what another loop keeps, for each pass
    constant,  ///< a constant for each pass
    input,     ///< an input element of the function for each pass
    carried    ///< what the pass before gave
  };
  Kind kind = Kind::shared;
  Value value = no_value;              ///< shared
  std::vector<Value> choices = {};     ///< chosen; kept: by pass
  std::vector<int> places = {};        ///< chosen: by pass, in `choices`
  std::vector<double> constants = {};  ///< constant: by pass
  std::vector<int> inputs = {};        ///< input: by pass, all in one argument
  int result = 0;                      ///< carried: which of the loop's results

  /// The values of the graph that the leaf reads.
  std::vector<Value> reads() const {
    return kind == Kind::shared ? std::vector<Value>{value} : choices;
  }
};

/// A result of a loop's body: stored in each pass, carried to the next, or kept for what follows.
struct LoopResult {
  int port = 0;                    ///< stored: the output
  std::vector<int> elements = {};  ///< stored: by pass; empty elsewhere
  Value first = no_value;          ///< carried: the value before the first pass
  Value last = no_value;           ///< carried: the value that the last pass gives
  std::vector<Value> kept = {};    ///< kept: by pass; empty elsewhere
  bool is_carried() const { return last != no_value; }
  bool is_kept() const { return !kept.empty(); }

  /// The values of the graph that are there after the loop.
  std::vector<Value> given() const { return is_carried() ? std::vector<Value>{last} : kept; }
};

/// `count` passes of one body. The body's input element k is leaves[k]; the elements of its only
/// output are `results`.
struct Loop {
  int count = 0;
  Graph body;
  std::vector<LoopLeaf> leaves;
  std::vector<LoopResult> results;
};

/// A value to compute or, where `loop` is not -1, a loop to run or, where `call` is not -1, the
/// call that fills this input array.
struct Step {
  Value value = no_value;
  int loop = -1;
  int call = -1;
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

/// The same loops with the steps in the order in which the fewest values wait for the loops to end.
Plan with_fewest_waiting(const Graph& graph, const Plan& plan);

/// Operations of the graph, inputs and constants left out.
int operation_count(const Graph& graph);

/// Instructions of an operation: in the code, and executed where it calls a function.
struct Weight {
  int written = 1;
  int executed = 1;
};
Weight instructions_of(Op op);

/// An estimate of the instructions that a plan writes, constants included, and executes.
struct PlanSize {
  int written = 0;
  int executed = 0;
};
PlanSize size_of(const Loop& loop);
PlanSize size_of(const Graph& graph, const Plan& plan);

}  // namespace sinew
