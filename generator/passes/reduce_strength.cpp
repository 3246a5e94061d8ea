// SPDX-License-Identifier: GPL-3.0-or-later
// reduce_strength: an operation becomes a cheaper one with the same result.
//
//   r = x / 4      ->   r = x * 0.25        (division by a constant)
//   r = 2 * x      ->   r = x + x
//   r = a / (b/c)  ->   r = a * c / b       (one division for two)
#include <cmath>

#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {

Graph reduce_strength(const Graph& graph) {
  const std::vector<int> uses = use_counts(graph);
  return rewrite(graph, [&](Graph& g, const Node& n, Value v) {
    if (n.op == Op::divide && g.is_constant(n.b)) {
      const double reciprocal = 1.0 / g[n.b].constant;
      if (std::isfinite(reciprocal) && reciprocal != 0.0)
        return g.make(Op::multiply, n.a, g.constant(reciprocal));
    }
    const bool nested = n.op == Op::divide && g[n.b].op == Op::divide &&
                        uses[static_cast<std::size_t>(graph[v].b)] == 1;
    if (nested) return g.make(Op::divide, g.make(Op::multiply, n.a, g[n.b].b), g[n.b].a);
    if (n.op == Op::multiply && g.is_constant(n.a, 2.0)) return g.make(Op::add, n.b, n.b);
    if (n.op == Op::multiply && g.is_constant(n.b, 2.0)) return g.make(Op::add, n.a, n.a);
    return g.add(n);
  });
}

}  // namespace sinew
