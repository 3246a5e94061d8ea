// SPDX-License-Identifier: GPL-3.0-or-later
// remove_dead: values that no result needs are dropped.
//
//   t = a * b; u = a + b; r = u    ->    u = a + b; r = u
#include "generator/passes/passes.h"

namespace sinew {

Graph remove_dead(const Graph& graph) {
  std::vector<bool> alive(static_cast<std::size_t>(graph.size()), false);
  for (Value v : graph.results()) alive[static_cast<std::size_t>(v)] = true;
  for (Value v = graph.size() - 1; v >= 0; --v) {
    if (!alive[static_cast<std::size_t>(v)]) continue;
    for (int i = 0; i < arity(graph[v].op); ++i)
      alive[static_cast<std::size_t>(graph[v].operand(i))] = true;
  }
  Graph result = graph.empty_like();
  std::vector<Value> moved(static_cast<std::size_t>(graph.size()), no_value);
  for (Value v = 0; v < graph.size(); ++v) {
    if (!alive[static_cast<std::size_t>(v)]) continue;
    Node node = graph[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
    moved[static_cast<std::size_t>(v)] = result.add(node);
    result.set_label(moved[static_cast<std::size_t>(v)], graph.label(v));
  }
  for (Port& port : result.outputs)
    for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return result;
}

}  // namespace sinew
