// SPDX-License-Identifier: GPL-3.0-or-later
// fuse: products that go into sums only become part of them, rounded once. Only for targets with
// fused multiply-add.
//
//   p = a * b; r = p + c; s = d - p    ->    r = fma(a, b, c); s = fma(-a, b, d)
//
// Of two products in one sum the one that is known last goes into it: the other need not wait. A
// sum whose negative is needed stays as it is: compilers make one instruction of -fma(a, b, c),
// which gives zero the other sign.
#include <algorithm>
#include <numeric>

#include "generator/passes/chains.h"
#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {
namespace {

std::size_t at(Value v) {
  return static_cast<std::size_t>(v);
}

/// Operations in a row that end in each value.
std::vector<int> depths(const Graph& graph) {
  std::vector<int> depth(at(graph.size()), 0);
  for (Value v = 0; v < graph.size(); ++v)
    for (int i = 0; i < arity(graph[v].op); ++i)
      depth[at(v)] = std::max(depth[at(v)], depth[at(graph[v].operand(i))] + 1);
  return depth;
}

/// The sums that each product goes into; empty where it is needed by itself as well.
std::vector<std::vector<Value>> sums_of_products(const Graph& graph) {
  std::vector<std::vector<Value>> sums(at(graph.size()));
  std::vector<bool> needed(at(graph.size()), false);
  for (Value v : graph.results()) needed[at(v)] = true;
  for (Value v = 0; v < graph.size(); ++v)
    for (int i = 0; i < arity(graph[v].op); ++i) {
      const Value operand = graph[v].operand(i);
      if (!is_sum(graph[v]) || graph[v].a == graph[v].b) needed[at(operand)] = true;
      if (graph[operand].op == Op::multiply) sums[at(operand)].push_back(v);
    }
  for (Value v = 0; v < graph.size(); ++v)
    if (needed[at(v)]) sums[at(v)].clear();
  return sums;
}

std::vector<bool> negated_values(const Graph& graph) {
  std::vector<bool> negated(at(graph.size()), false);
  for (const Node& node : graph.nodes())
    if (node.op == Op::negate) negated[at(node.a)] = true;
  return negated;
}

/// For every sum the product that goes into it, or no_value.
std::vector<Value> chosen_products(const Graph& graph) {
  const std::vector<bool> negated = negated_values(graph);
  const std::vector<std::vector<Value>> sums = sums_of_products(graph);
  const std::vector<int> depth = depths(graph);
  std::vector<Value> order(at(graph.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Value x, Value y) { return depth[at(x)] > depth[at(y)]; });
  std::vector<Value> chosen(at(graph.size()), no_value);
  for (Value product : order) {
    const std::vector<Value>& into = sums[at(product)];
    if (std::any_of(into.begin(), into.end(),
                    [&](Value v) { return chosen[at(v)] != no_value || negated[at(v)]; }))
      continue;
    for (Value v : into) chosen[at(v)] = product;
  }
  return chosen;
}

}  // namespace

Graph fuse(const Graph& graph) {
  const std::vector<Value> chosen = chosen_products(graph);
  const Graph fused = rewrite(graph, [&](Graph& to, const Node& node, Value v) {
    if (chosen[at(v)] == no_value) return to.add(node);
    const bool first = graph[v].a == chosen[at(v)];
    const Node product = to[first ? node.a : node.b];
    const Op op = node.op == Op::add ? Op::multiply_add
                  : first            ? Op::multiply_subtract
                                     : Op::subtract_product;
    return to.make(op, product.a, product.b, first ? node.b : node.a);
  });
  return remove_dead(fused);
}

}  // namespace sinew
