// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/graph.h"

namespace sinew {

/// A function as JavaScript, of the same graph and with the same operations as the C: an expression
/// "function (x) {...}" that takes all inputs one after the other in one array and gives all
/// results likewise. Sums, products, quotients and square roots are those of IEEE 754, as in C;
/// sines and the like are the browser's, so that results agree to rounding, not bit by bit. What it
/// calls stands in javascript_prelude(). ASCII; no text of the model gets in but numbers.
/// Throws std::invalid_argument for a graph with fused operations, which browsers do not have.
std::string emit_javascript(const Graph& graph);

/// Declarations of what emitted functions call, with the runtime's answers outside of a function's
/// domain (square root of a negative number: 0). To stand once before them.
std::string javascript_prelude();

}  // namespace sinew
