// SPDX-License-Identifier: GPL-3.0-or-later
// pair_sincos: one angle, one call. Angles that differ only in sign share their sine and cosine;
// emission then writes one sincos for both.
//
//   s = sin(a); c = cos(-a)    ->    s = sin(a); c = cos(a)
//   t = sin(b - a), u = cos(a - b)  ->  d = a - b; u = cos(d); t = -sin(d)
#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {

Graph pair_sincos(const Graph& graph) {
  return rewrite(graph, [](Graph& g, const Node& n) {
    if ((n.op != Op::sine && n.op != Op::cosine) || g[n.a].op != Op::negate) return g.add(n);
    const Value v = g.make(n.op, g[n.a].a);
    return n.op == Op::cosine ? v : g.make(Op::negate, v);
  });
}

}  // namespace sinew
