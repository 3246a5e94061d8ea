// SPDX-License-Identifier: GPL-3.0-or-later
// reduce_strength: an operation becomes a cheaper one with the same result.
//
//   r = x / 4      ->   r = x * 0.25        (division by a constant)
//   r = 2 * x      ->   r = x + x
//   r = a / (b/c)  ->   r = a * c / b       (one division for two)
//   r = exp(-max(x, -x))  ->  r = exp(-abs(x))
//
// max(x, -x) is -0 where x is +0, and abs(x) is +0: an exponential does not show which, other
// results might. Where x is NaN the exponential is that of the farthest x. Analysers of intervals
// see that abs(x) is not negative, so that the exponential is at most one.
#include <cmath>

#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {
namespace {

/// x of max(x, -x), in either order; no_value of anything else.
Value in_magnitude(const Graph& g, Value v) {
  if (g[v].op != Op::maximum) return no_value;
  const auto is_negation = [&g](Value x, Value y) { return g[x].op == Op::negate && g[x].a == y; };
  if (is_negation(g[v].b, g[v].a)) return g[v].a;
  return is_negation(g[v].a, g[v].b) ? g[v].b : no_value;
}

/// The exponential of -|x|, from that of -max(x, -x); no_value where `n` is anything else.
Value decay(Graph& g, const Node& n) {
  if (n.op != Op::exponential || g[n.a].op != Op::negate) return no_value;
  const Value x = in_magnitude(g, g[n.a].a);
  if (x == no_value) return no_value;
  return g.make(Op::exponential, g.make(Op::negate, g.make(Op::absolute, x)));
}

}  // namespace

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
    if (const Value decaying = decay(g, n); decaying != no_value) return decaying;
    if (n.op == Op::multiply && g.is_constant(n.a, 2.0)) return g.make(Op::add, n.b, n.b);
    if (n.op == Op::multiply && g.is_constant(n.b, 2.0)) return g.make(Op::add, n.a, n.a);
    return g.add(n);
  });
}

}  // namespace sinew
