// SPDX-License-Identifier: GPL-3.0-or-later
// How far an emitted function may be from the exact value of its own formula, by rounding alone.
#pragma once

#include <vector>

#include "generator/graph.h"

namespace sinew {

/// Results in double with a bound of each one's error, both in the result's unit.
struct BoundedResults {
  std::vector<double> values;
  std::vector<double> bounds;
};

/// Running error analysis of one evaluation: every operation adds half a unit in the last place
/// (the runtime's functions one, docs/trigonometry.md) to what its operands bring along. Terms of
/// second order are left out. Infinite where an argument may be at a pole or beyond a domain.
BoundedResults evaluate_with_bounds(const Graph& graph, const std::vector<double>& inputs);

/// Of a function over several states, relative to the largest entry of the result in each state.
struct RelativeErrors {
  double bound = 0.0;     ///< largest of the bounds
  double observed = 0.0;  ///< largest difference from an evaluation with 50 digits
};

/// Results that are all zero say nothing and are left out.
RelativeErrors relative_errors(const Graph& graph, const std::vector<std::vector<double>>& states);

}  // namespace sinew
