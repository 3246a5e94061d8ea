// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dump.h"

#include <fmt/format.h>

#include "generator/literal.h"

namespace sinew {
namespace {

std::string payload(const Graph& graph, const Node& node) {
  switch (node.op) {
    case Op::input:
      return graph.input_name(node.index);
    case Op::constant:
      return literal(node.constant, Target{});
    case Op::power:
      return std::to_string(node.index);
    default:
      return "";
  }
}

}  // namespace

std::string dump_text(const Graph& graph) {
  std::string text = fmt::format("function {}\n", graph.name);
  for (Value v = 0; v < graph.size(); ++v) {
    const Node& node = graph[v];
    std::string line = fmt::format("%{} = {}", v, name_of(node.op));
    for (int i = 0; i < arity(node.op); ++i) line += fmt::format(" %{}", node.operand(i));
    const std::string extra = payload(graph, node);
    if (!extra.empty()) line += " " + extra;
    if (!graph.label(v).empty()) line += fmt::format("   # {}", graph.label(v));
    text += line + "\n";
  }
  for (const Port& port : graph.outputs)
    for (int i = 0; i < port.size(); ++i)
      text += fmt::format("{}[{}] = %{}\n", port.name, i, port.values[static_cast<std::size_t>(i)]);
  return text;
}

std::string dump_dot(const Graph& graph) {
  std::string text =
      fmt::format("digraph {} {{\n  node [shape=box, fontname=\"monospace\"];\n", graph.name);
  for (Value v = 0; v < graph.size(); ++v) {
    const Node& node = graph[v];
    const std::string extra = payload(graph, node);
    text += fmt::format("  v{} [label=\"{}{}{}\"];\n", v, name_of(node.op),
                        extra.empty() ? "" : " " + extra,
                        graph.label(v).empty() ? "" : "\\n" + graph.label(v));
    for (int i = 0; i < arity(node.op); ++i)
      text += fmt::format("  v{} -> v{};\n", node.operand(i), v);
  }
  for (const Port& port : graph.outputs)
    for (int i = 0; i < port.size(); ++i)
      text += fmt::format("  \"{0}[{1}]\" [shape=ellipse];\n  v{2} -> \"{0}[{1}]\";\n", port.name,
                          i, port.values[static_cast<std::size_t>(i)]);
  return text + "}\n";
}

}  // namespace sinew
