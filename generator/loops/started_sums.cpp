// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/started_sums.h"

#include <map>

#include "generator/loops/sums.h"
#include "generator/loops/unify.h"
#include "generator/passes/chains.h"

namespace sinew {
namespace {

/// By the second partial sum: the first term.
std::map<Value, Value> first_terms(const Graph& graph) {
  const Forms forms = forms_of(graph, {});
  std::map<Value, Value> first;
  for (const Sum& sum : long_sums(graph)) {
    const Value a = sum.terms[0], b = sum.terms[1];
    if (sum.terms.size() >= terms_of_a_long_sum && arity(graph[a].op) > 0 &&
        forms[static_cast<std::size_t>(a)] == forms[static_cast<std::size_t>(b)])
      first[sum.partial[1]] = a;
  }
  return first;
}

}  // namespace

Graph with_started_sums(const Graph& graph) {
  const std::map<Value, Value> first = first_terms(graph);
  if (first.empty()) return graph;
  Graph started = graph.empty_like();
  std::vector<Value> moved;
  for (Value v = 0; v < graph.size(); ++v) {
    Node node = graph[v];
    const auto start = first.find(v);
    for (int i = 0; i < arity(node.op); ++i) {
      const bool is_first = start != first.end() && node.operand(i) == start->second;
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
      if (!is_first) continue;
      Node zero;
      zero.constant = -0.0;
      node.operand(i) = started.make(Op::add, started.add(zero), node.operand(i));
    }
    moved.push_back(started.add(node));
    started.set_label(moved.back(), graph.label(v));
  }
  for (std::vector<Port>* ports : {&started.inputs, &started.outputs})
    for (Port& port : *ports)
      for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return started;
}

}  // namespace sinew
