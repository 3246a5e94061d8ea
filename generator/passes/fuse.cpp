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

std::size_t index_of(Value v) {
  return static_cast<std::size_t>(v);
}

/// Operations in a row that end in each value.
std::vector<int> depths(const Graph& graph) {
  std::vector<int> depth(index_of(graph.size()), 0);
  for (Value v = 0; v < graph.size(); ++v)
    for (int i = 0; i < arity(graph[v].op); ++i)
      depth[index_of(v)] = std::max(depth[index_of(v)], depth[index_of(graph[v].operand(i))] + 1);
  return depth;
}

/// The sums that each product goes into; empty where it is needed by itself as well.
std::vector<std::vector<Value>> sums_of_products(const Graph& graph) {
  std::vector<std::vector<Value>> sums(index_of(graph.size()));
  std::vector<bool> needed(index_of(graph.size()), false);
  for (Value v : graph.results()) needed[index_of(v)] = true;
  for (Value v = 0; v < graph.size(); ++v)
    for (int i = 0; i < arity(graph[v].op); ++i) {
      const Value operand = graph[v].operand(i);
      if (!is_sum(graph[v]) || graph[v].a == graph[v].b) needed[index_of(operand)] = true;
      if (graph[operand].op == Op::multiply) sums[index_of(operand)].push_back(v);
    }
  for (Value v = 0; v < graph.size(); ++v)
    if (needed[index_of(v)]) sums[index_of(v)].clear();
  return sums;
}

std::vector<bool> negated_values(const Graph& graph) {
  std::vector<bool> negated(index_of(graph.size()), false);
  for (const Node& node : graph.nodes())
    if (node.op == Op::negate) negated[index_of(node.a)] = true;
  return negated;
}

/// For every sum the product that goes into it, or no_value.
std::vector<Value> chosen_products(const Graph& graph) {
  const std::vector<bool> negated = negated_values(graph);
  const std::vector<std::vector<Value>> sums = sums_of_products(graph);
  const std::vector<int> depth = depths(graph);
  std::vector<Value> order(index_of(graph.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Value x, Value y) { return depth[index_of(x)] > depth[index_of(y)]; });
  std::vector<Value> chosen(index_of(graph.size()), no_value);
  for (Value product : order) {
    const std::vector<Value>& into = sums[index_of(product)];
    if (std::any_of(into.begin(), into.end(),
                    [&](Value v) { return chosen[index_of(v)] != no_value || negated[index_of(v)]; }))
      continue;
    for (Value v : into) chosen[index_of(v)] = product;
  }
  return chosen;
}

}  // namespace

Graph fuse(const Graph& graph) {
  const std::vector<Value> chosen = chosen_products(graph);
  const Graph fused = rewrite(graph, [&](Graph& to, const Node& node, Value v) {
    if (chosen[index_of(v)] == no_value) return to.add(node);
    const bool first = graph[v].a == chosen[index_of(v)];
    const Node product = to[first ? node.a : node.b];
    const Op op = node.op == Op::add ? Op::multiply_add
                  : first            ? Op::multiply_subtract
                                     : Op::subtract_product;
    return to.make(op, product.a, product.b, first ? node.b : node.a);
  });
  return remove_dead(fused);
}

}  // namespace sinew
