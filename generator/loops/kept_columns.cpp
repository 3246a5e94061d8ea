// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/kept_columns.h"

#include <map>
#include <set>

namespace sinew {
namespace {

/// Values that statements beside the loop use, and other loops.
std::vector<bool> used_beside(const Graph& graph, const Plan& planned, const Loop& loop) {
  std::vector<bool> used(static_cast<std::size_t>(graph.size()), false);
  std::vector<std::vector<bool>> stored = planned.stored;
  const auto use = [&](const Loop& each) {
    for (const LoopLeaf& leaf : each.leaves)
      for (Value v : leaf.reads()) used[static_cast<std::size_t>(v)] = true;
    for (const LoopResult& result : each.results) {
      if (result.is_carried()) used[static_cast<std::size_t>(result.first)] = true;
      for (int element : result.elements)
        stored[static_cast<std::size_t>(result.port)][static_cast<std::size_t>(element)] = true;
    }
  };
  for (const Loop& each : planned.loops) use(each);
  for (const Port& port : graph.inputs)
    for (Value v : port.values) used[static_cast<std::size_t>(v)] = true;
  use(loop);
  for (std::size_t p = 0; p < graph.outputs.size(); ++p)
    for (std::size_t i = 0; i < stored[p].size(); ++i)
      if (!stored[p][i]) used[static_cast<std::size_t>(graph.outputs[p].values[i])] = true;
  return used;
}

int operations_below(const Graph& body, Value top) {
  std::vector<bool> below(static_cast<std::size_t>(top) + 1, false);
  below.back() = true;
  int count = 0;
  for (Value v = top; v >= 0; --v) {
    if (!below[static_cast<std::size_t>(v)]) continue;
    count += arity(body[v].op) > 0;
    for (int i = 0; i < arity(body[v].op); ++i)
      below[static_cast<std::size_t>(body[v].operand(i))] = true;
  }
  return count;
}

/// By value: the column of the body that has it, where that is worth keeping.
std::map<Value, Column> columns_by_value(const LoopBuilder& builder) {
  constexpr int cheap = 3;
  std::map<Value, Column> columns;
  for (const auto& [made, column] : builder.columns())
    if (operations_below(builder.loop.body, made) > cheap)
      for (Value v : column) columns[v] = column;
  return columns;
}

}  // namespace

std::vector<bool> given_by(const Graph& graph, const std::vector<Loop>& loops) {
  std::vector<bool> given(static_cast<std::size_t>(graph.size()), false);
  for (const Loop& loop : loops)
    for (const LoopResult& result : loop.results)
      for (Value v : result.given()) given[static_cast<std::size_t>(v)] = true;
  return given;
}

void keep_needed(const Graph& graph, const Plan& planned, LoopBuilder& builder) {
  std::vector<bool> used = used_beside(graph, planned, builder.loop);
  std::vector<bool> given = given_by(graph, planned.loops);
  for (const LoopResult& result : builder.loop.results)
    if (result.is_carried()) given[static_cast<std::size_t>(result.last)] = true;
  const std::map<Value, Column> columns = columns_by_value(builder);
  std::set<Column> needed;
  for (Value v = graph.size() - 1; v >= 0; --v) {
    if (!used[static_cast<std::size_t>(v)] || given[static_cast<std::size_t>(v)]) continue;
    if (const auto found = columns.find(v); found != columns.end())
      needed.insert(found->second);
    else
      for (int i = 0; i < arity(graph[v].op); ++i)
        used[static_cast<std::size_t>(graph[v].operand(i))] = true;
  }
  builder.keep_only(needed);
}

}  // namespace sinew
