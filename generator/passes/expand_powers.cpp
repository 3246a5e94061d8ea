// SPDX-License-Identifier: GPL-3.0-or-later
// expand_powers: integer powers by repeated squaring, sharing every square.
//
//   r = x^6    ->    t = x * x;  u = t * t;  r = u * t
#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {

Graph expand_powers(const Graph& graph) {
  return rewrite(graph, [](Graph& g, const Node& n) {
    if (n.op != Op::power) return g.add(n);
    Value square = n.a, result = no_value;
    for (int left = n.index; left > 0; left /= 2) {
      if (left % 2 == 1)
        result = result == no_value ? square : g.make(Op::multiply, square, result);
      if (left > 1) square = g.make(Op::multiply, square, square);
    }
    return result == no_value ? g.constant(1.0) : result;
  });
}

}  // namespace sinew
