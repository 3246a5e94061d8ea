// SPDX-License-Identifier: GPL-3.0-or-later
// What a function computes that another function of its model gives: emitted as a call of that one.
// The graphs themselves stay as they are, as with loops: only emission follows.
#pragma once

#include <string>
#include <vector>

#include "generator/graph.h"
#include "generator/loops/find_loops.h"

namespace sinew {

/// A call in a function's body.
struct Call {
  std::string function;                ///< without the model's prefix
  std::vector<std::string> arguments;  ///< inputs of the caller by name, in the callee's order
  std::vector<Port> results;           ///< local arrays, in the callee's order
  bool gives_results = false;          ///< they are the caller's own results
  bool is_part = false;                ///< of a part (find_parts.h), which gives one array
};

/// Elements of all arrays that the calls fill.
std::size_t array_elements(const std::vector<Call>& calls);

/// What the arrays of a function's calls leave to its loops.
LoopLimits limits_beside(const std::vector<Call>& calls, LoopLimits limits);

/// A function as it is emitted: calls, and then what is left to compute.
struct CallingFunction {
  std::vector<Call> calls;
  /// The same signature, and after its inputs the arrays of the calls, in their order. The values
  /// of such an array are the numbers that its call is passed after the arrays: it stands where
  /// they are known, or at the start of the body.
  Graph rest;
};

/// A chain calls its functions. Another function calls one with fewer operations where that leaves
/// clearly fewer operations to write and costs hardly more instructions, by size_of. Results have
/// the bits of the graphs.
std::vector<CallingFunction> find_calls(const std::vector<Graph>& functions,
                                        const LoopLimits& limits);

}  // namespace sinew
