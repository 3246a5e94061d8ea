// SPDX-License-Identifier: GPL-3.0-or-later
// move_signs: negations are carried to where a sum or a constant takes them in for nothing.
//
//   t = -a            t = a * b
//   u = t * b    ->   r = c - t
//   r = c + u
#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {
namespace {

/// |value| and whether it carries a minus.
struct Parted {
  Value value;
  bool negative;
};

Parted part(Graph& g, Value v) {
  if (g[v].op == Op::negate) return {g[v].a, true};
  if (g.is_constant(v) && g[v].constant < 0) return {g.constant(-g[v].constant), true};
  return {v, false};
}

Value negate_if(Graph& g, Value v, bool negative) {
  if (!negative) return v;
  if (g.is_constant(v)) return g.constant(-g[v].constant);
  if (g[v].op == Op::negate) return g[v].a;
  return g.make(Op::negate, v);
}

Value sum(Graph& g, Parted a, Parted b) {
  if (a.negative == b.negative) return negate_if(g, g.make(Op::add, a.value, b.value), a.negative);
  return a.negative ? g.make(Op::subtract, b.value, a.value)
                    : g.make(Op::subtract, a.value, b.value);
}

}  // namespace

Graph move_signs(const Graph& graph) {
  return rewrite(graph, [](Graph& g, const Node& n) {
    switch (n.op) {
      case Op::add:
        return sum(g, part(g, n.a), part(g, n.b));
      case Op::subtract: {
        Parted b = part(g, n.b);
        b.negative = !b.negative;
        return sum(g, part(g, n.a), b);
      }
      case Op::multiply:
      case Op::divide: {
        const Parted a = part(g, n.a), b = part(g, n.b);
        return negate_if(g, g.make(n.op, a.value, b.value), a.negative != b.negative);
      }
      case Op::power: {
        const Parted a = part(g, n.a);
        Node positive = n;
        positive.a = a.value;
        return negate_if(g, g.add(positive), a.negative && n.index % 2 == 1);
      }
      default:
        return g.add(n);
    }
  });
}

}  // namespace sinew
