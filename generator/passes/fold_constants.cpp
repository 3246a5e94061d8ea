// SPDX-License-Identifier: GPL-3.0-or-later
// fold_constants: what is known at generation time is computed there.
//
//   2 * 3 -> 6      x + 0 -> x      x * 1 -> x      x * 0 -> 0      0 / x -> 0      --x -> x
//
// Functions of constants use the runtime's own functions, so that folding never changes a bit.
#include <sinew_math.h>

#include <cmath>
#include <optional>

#include "generator/evaluate.h"
#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {
namespace {

std::optional<Value> identity(Graph& g, const Node& n) {
  switch (n.op) {
    case Op::add:
      if (g.is_constant(n.a, 0.0)) return n.b;
      if (g.is_constant(n.b, 0.0)) return n.a;
      break;
    case Op::subtract:
      if (g.is_constant(n.b, 0.0)) return n.a;
      if (g.is_constant(n.a, 0.0)) return g.make(Op::negate, n.b);
      if (n.a == n.b) return g.constant(0.0);
      break;
    case Op::multiply:
      if (g.is_constant(n.a, 0.0) || g.is_constant(n.b, 0.0)) return g.constant(0.0);
      if (g.is_constant(n.a, 1.0)) return n.b;
      if (g.is_constant(n.b, 1.0)) return n.a;
      if (g.is_constant(n.a, -1.0)) return g.make(Op::negate, n.b);
      if (g.is_constant(n.b, -1.0)) return g.make(Op::negate, n.a);
      break;
    case Op::divide:
      if (g.is_constant(n.a, 0.0)) return g.constant(0.0);
      if (g.is_constant(n.b, 1.0)) return n.a;
      break;
    case Op::negate:
      if (g[n.a].op == Op::negate) return g[n.a].a;
      break;
    default:
      break;
  }
  return std::nullopt;
}

bool all_constant(const Graph& g, const Node& n) {
  if (arity(n.op) == 0) return false;
  for (int i = 0; i < arity(n.op); ++i)
    if (!g.is_constant(n.operand(i))) return false;
  return true;
}

}  // namespace

Graph fold_constants(const Graph& graph) {
  return rewrite(graph, [](Graph& to, const Node& node) {
    if (all_constant(to, node)) {
      const auto value = [&](int i) { return to[node.operand(i)].constant; };
      const int n = arity(node.op);
      const double folded =
          apply<double>(node, value(0), n > 1 ? value(1) : 0.0, n > 2 ? value(2) : 0.0);
      if (std::isfinite(folded)) return to.constant(folded);
    }
    if (const std::optional<Value> v = identity(to, node)) return *v;
    return to.add(node);
  });
}

}  // namespace sinew
