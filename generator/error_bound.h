// SPDX-License-Identifier: GPL-3.0-or-later
// How far the results of a graph may be from the exact ones.
//
// A forward error analysis that runs along with a 50-digit evaluation: every node carries an
// absolute error, made of what its operation rounds and of what its operands' errors become. The
// limits of the tests' comparisons come from here, and what a model's report says; none is chosen
// by hand.
#pragma once

#include <vector>

#include "generator/evaluate.h"

namespace sinew {

/// Relative errors, each of the result it is named after.
struct Rounding {
  double operation = 0.0;  ///< + - * / sqrt
  double function = 0.0;   ///< sin, atan, exp, ...
  double constant = 0.0;   ///< a constant of the graph
  double folded = 0.0;     ///< an operation all of whose operands are known at generation time
};

/// IEEE double; the runtime's functions err by less than one unit in the last place, its tanh by
/// less than three (docs/trigonometry.md).
inline constexpr Rounding double_rounding{0x1p-53, 0x1p-52, 0.0, 0.0};
/// Exact has 168 bits; Boost's functions err by a few units in the last place.
inline constexpr Rounding exact_rounding{0x1p-167, 0x1p-163, 0.0, 0.0};

/// Absolute error of every result, to first order with a margin of 1e-6; infinite where an error
/// could turn a case distinction or reach a pole.
std::vector<double> error_bounds(const Graph& graph, const std::vector<double>& inputs,
                                 const Rounding& rounding);

/// Of a function's results, relative to the largest entry of each in each state, over all states.
/// Results that are all zero, or no larger than their own bound (a search's residual), say nothing
/// and are left out.
struct RelativeErrors {
  double bound = 0.0;     ///< largest of the bounds, in double
  double observed = 0.0;  ///< largest difference from an evaluation with 50 digits
};
RelativeErrors relative_errors(const Graph& graph, const std::vector<std::vector<double>>& states);

}  // namespace sinew
