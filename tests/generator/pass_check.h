// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a pass keeps the meaning of a graph, and whether the C says what the graph says.
#pragma once

#include <string>
#include <vector>

#include "generator/passes/pipeline.h"
#include "generator/target.h"

namespace sinew {

using States = std::vector<std::vector<double>>;

/// A graph before any pass, or after one.
struct Stage {
  std::string pass;  ///< "lower" for the first
  Graph graph;
};

/// `graph` and what each pass makes of it in turn.
std::vector<Stage> stages_of(const Graph& graph, const std::vector<Pass>& passes = pipeline());

/// Compares every stage with the one before it in 50 digits, and with the first in 50 digits and in
/// double. One line for every result that is further off than the arithmetic explains:
///  - 50 digits: the error bound of 50-digit arithmetic, at most 1e-45 of the result's scale. A
///  pass
///    that computes with constants rounds them to double: fold_constants rounds once for each
///    operation folded, combine_constants perturbs each of the n constants of a sum or product by
///    at most (n - 1) 2^-53. That, carried to the results, is added for these two.
///  - double: the bounds of both graphs in double arithmetic.
std::vector<std::string> disagreements(const std::vector<Stage>& stages, const States& states);

/// Compiles every stage and compares the results with the interpreter's, bit by bit.
std::vector<std::string> bit_differences(const std::vector<Stage>& stages, const States& states,
                                         Scalar scalar);

/// The same where the C is made from other graphs than the interpreter runs.
std::vector<std::string> bit_differences(const std::vector<Stage>& interpreted,
                                         const std::vector<Stage>& compiled, const States& states,
                                         Scalar scalar);

}  // namespace sinew
