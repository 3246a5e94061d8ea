// SPDX-License-Identifier: GPL-3.0-or-later
// contract_trigonometry: sums of products of sines and cosines that are one function or a number.
//
//   s = sin(a)*sin(a) + cos(a)*cos(a)     ->   1
//   c = cos(a)*cos(a) - ... + sin(a)*sin(a)  (anywhere in a longer sum)  ->  1 - ...
#include <algorithm>
#include <optional>

#include "generator/passes/chains.h"
#include "generator/passes/passes.h"

namespace sinew {
namespace {

/// The angle where `v` is the square of its sine (or cosine).
std::optional<Value> squared_angle(const Graph& g, Value v, Op op) {
  const Node& n = g[v];
  const bool square = (n.op == Op::multiply && n.a == n.b) || (n.op == Op::power && n.index == 2);
  if (!square || g[n.a].op != op) return std::nullopt;
  return g[n.a].a;
}

/// Replaces one sin^2 + cos^2 of equal sign by the constant; true where one was found.
bool contract_once(Graph& g, std::vector<Term>& terms) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto angle = squared_angle(g, terms[i].value, Op::sine);
    if (!angle) continue;
    for (std::size_t j = 0; j < terms.size(); ++j) {
      if (terms[j].negative != terms[i].negative) continue;
      if (squared_angle(g, terms[j].value, Op::cosine) != angle) continue;
      terms[i].value = g.constant(1.0);
      terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
  }
  return false;
}

}  // namespace

Graph contract_trigonometry(const Graph& graph) {
  const std::vector<int> uses = use_counts(graph);
  const std::vector<bool> inner = inner_links(graph, uses);
  Graph to = graph.empty_like();
  std::vector<Value> moved(static_cast<std::size_t>(graph.size()), no_value);
  for (Value v = 0; v < graph.size(); ++v) {
    Node node = graph[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
    Value& target = moved[static_cast<std::size_t>(v)];
    if (is_sum(node) && !inner[static_cast<std::size_t>(v)]) {
      std::vector<Term> terms = terms_of(graph, uses, v);
      for (Term& t : terms) t.value = moved[static_cast<std::size_t>(t.value)];
      bool found = false;
      while (contract_once(to, terms)) found = true;
      if (found) target = make_sum(to, terms);
    }
    if (target == no_value) target = to.add(node);
    if (!to.is_constant(target) && to[target].op != Op::input) to.set_label(target, graph.label(v));
  }
  for (Port& port : to.outputs)
    for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return remove_dead(to);
}

}  // namespace sinew
