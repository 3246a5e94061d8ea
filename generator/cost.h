// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/graph.h"

namespace sinew {

/// Operations executed by one call. A sincos pair counts once.
struct Cost {
  int multiply = 0;
  int add = 0;  ///< additions and subtractions
  int negate = 0;
  int divide = 0;
  int square_root = 0;
  int sincos = 0;
  int other = 0;  ///< atan, exp, min, ...
  int fused = 0;  ///< multiplications and additions above that are one instruction, in pairs

  /// Multiplications and additions: the figure that peers are compared by.
  int operations() const { return multiply + add; }
  /// One number for choosing between forms of one function, in multiplications.
  double weight() const {
    return multiply + add - fused + 0.5 * negate + 8.0 * divide + 8.0 * square_root +
           40.0 * sincos + 40.0 * other;
  }
};

Cost count_operations(const Graph& graph);

}  // namespace sinew
