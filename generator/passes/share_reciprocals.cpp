// SPDX-License-Identifier: GPL-3.0-or-later
// share_reciprocals: where several values are divided by one, one division is left.
//
//   r = a / d; s = b / d    ->    t = 1 / d; r = a * t; s = b * t
#include <map>

#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {

Graph share_reciprocals(const Graph& graph) {
  std::map<Value, int> divisions;
  for (const Node& n : graph.nodes())
    if (n.op == Op::divide) ++divisions[n.b];
  return rewrite(graph, [&](Graph& to, const Node& n, Value v) {
    if (n.op != Op::divide || divisions[graph[v].b] < 2) return to.add(n);
    const Value reciprocal = to.make(Op::divide, to.constant(1.0), n.b);
    return to.is_constant(n.a, 1.0) ? reciprocal : to.make(Op::multiply, n.a, reciprocal);
  });
}

}  // namespace sinew
