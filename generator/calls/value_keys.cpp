// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/value_keys.h"

#include <bit>

namespace sinew {

std::vector<int> ValueKeys::of(const Graph& graph) {
  std::vector<int> keys;
  for (const Node& node : graph.nodes()) {
    if (node.op == Op::input) {
      keys.push_back(number_of_input(graph, node.index));
      continue;
    }
    std::array<int, 3> operands{-1, -1, -1};
    for (int i = 0; i < arity(node.op); ++i)
      operands[static_cast<std::size_t>(i)] = keys[static_cast<std::size_t>(node.operand(i))];
    keys.push_back(
        number_of({node.op, node.index, operands, std::bit_cast<std::uint64_t>(node.constant)}));
  }
  return keys;
}

int ValueKeys::number_of(const Operation& operation) {
  const auto [place, is_new] = operations_.try_emplace(operation, next_);
  next_ += is_new;
  return place->second;
}

int ValueKeys::number_of_input(const Graph& graph, int index) {
  int element = index;
  for (const Port& port : graph.inputs) {
    if (element < port.size()) {
      const auto [place, is_new] =
          inputs_.try_emplace({port.name, port.size(), port.by_value, element}, next_);
      next_ += is_new;
      return place->second;
    }
    element -= port.size();
  }
  return -1;
}

}  // namespace sinew
