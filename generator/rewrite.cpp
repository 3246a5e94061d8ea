// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/rewrite.h"

namespace sinew {

Graph rewrite(const Graph& graph, const std::function<Value(Graph&, const Node&, Value)>& make) {
  Graph result = graph.empty_like();
  std::vector<Value> moved;
  for (Value v = 0; v < graph.size(); ++v) {
    Node node = graph[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
    const Value target = make(result, node, v);
    moved.push_back(target);
    if (!graph.label(v).empty() && result[target].op != Op::input && !result.is_constant(target))
      result.set_label(target, graph.label(v));
  }
  for (Port& port : result.outputs)
    for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return result;
}

Graph rewrite(const Graph& graph, const std::function<Value(Graph&, const Node&)>& make) {
  return rewrite(graph, [&make](Graph& to, const Node& node, Value) { return make(to, node); });
}

}  // namespace sinew
