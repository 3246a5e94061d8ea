// SPDX-License-Identifier: GPL-3.0-or-later
// distribute_constants: a constant in front of a sum moves into the constants of its terms.
//
//   r = 3 * (2*a - 5*b + 1)    ->    r = 6*a - 15*b + 3        (one multiplication fewer)
//
// Only where every term brings a constant of its own and nothing of the sum is used elsewhere.
#include <optional>

#include "generator/passes/chains.h"
#include "generator/passes/passes.h"

namespace sinew {
namespace {

/// The constant factor of a term that is used only here.
std::optional<double> own_constant(const Graph& g, const std::vector<int>& uses, Value v) {
  if (g.is_constant(v)) return g[v].constant;
  const Node& n = g[v];
  if (n.op != Op::multiply || uses[static_cast<std::size_t>(v)] != 1) return std::nullopt;
  if (g.is_constant(n.a)) return g[n.a].constant;
  if (g.is_constant(n.b)) return g[n.b].constant;
  return std::nullopt;
}

/// The sum behind a constant factor, where it can take the constant in.
std::optional<Value> open_sum(const Graph& g, const std::vector<int>& uses, const Node& n) {
  if (n.op != Op::multiply || g.is_constant(n.a) == g.is_constant(n.b)) return std::nullopt;
  const Value sum = g.is_constant(n.a) ? n.b : n.a;
  if (!is_sum(g[sum]) || uses[static_cast<std::size_t>(sum)] != 1) return std::nullopt;
  for (const Term& term : terms_of(g, uses, sum))
    if (!own_constant(g, uses, term.value)) return std::nullopt;
  return sum;
}

}  // namespace

Graph distribute_constants(const Graph& graph) {
  const std::vector<int> uses = use_counts(graph);
  Graph to = graph.empty_like();
  std::vector<Value> moved;
  for (Value v = 0; v < graph.size(); ++v) {
    Node node = graph[v];
    const std::optional<Value> sum = open_sum(graph, uses, node);
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
    if (!sum) {
      moved.push_back(to.add(node));
    } else {
      const double factor = graph[graph.is_constant(graph[v].a) ? graph[v].a : graph[v].b].constant;
      std::vector<Term> terms;
      for (const Term& term : terms_of(graph, uses, *sum)) {
        const Value constant = to.constant(factor * *own_constant(graph, uses, term.value));
        const Node& product = graph[term.value];
        if (graph.is_constant(term.value)) {
          terms.push_back({constant, term.negative});
        } else {
          const Value rest = graph.is_constant(product.a) ? product.b : product.a;
          terms.push_back({to.make(Op::multiply, constant, moved[static_cast<std::size_t>(rest)]),
                           term.negative});
        }
      }
      moved.push_back(make_sum(to, terms));
    }
    if (!to.is_constant(moved.back()) && to[moved.back()].op != Op::input)
      to.set_label(moved.back(), graph.label(v));
  }
  for (Port& port : to.outputs)
    for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return remove_dead(to);
}

}  // namespace sinew
