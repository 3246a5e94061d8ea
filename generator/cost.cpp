// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cost.h"

#include <set>

namespace sinew {

Cost count_operations(const Graph& graph) {
  Cost cost;
  std::set<Value> angles;
  for (const Node& node : graph.nodes()) {
    switch (node.op) {
      case Op::input:
      case Op::constant:
        break;
      case Op::add:
      case Op::subtract:
        ++cost.add;
        break;
      case Op::multiply:
        ++cost.multiply;
        break;
      case Op::divide:
        ++cost.divide;
        break;
      case Op::negate:
        ++cost.negate;
        break;
      case Op::power:
        cost.multiply += node.index - 1;
        break;
      case Op::square_root:
        ++cost.square_root;
        break;
      case Op::sine:
      case Op::cosine:
        angles.insert(node.a);
        break;
      case Op::multiply_add:
      case Op::multiply_subtract:
      case Op::subtract_product:
        ++cost.multiply;
        ++cost.add;
        ++cost.fused;
        break;
      default:
        ++cost.other;
        break;
    }
  }
  cost.sincos = static_cast<int>(angles.size());
  return cost;
}

}  // namespace sinew
