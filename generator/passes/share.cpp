// SPDX-License-Identifier: GPL-3.0-or-later
// share: equal operations on equal operands are computed once.
//
//   t1 = a * b          t1 = a * b
//   t2 = b * a     ->   r  = t1 + t1
//   r  = t1 + t2
//
// A difference whose opposite is there becomes its negation, which `move_signs` then carries to
// where it costs nothing:  a - b, b - a  ->  d = a - b, -d.
#include <cstdint>
#include <unordered_map>

#include "generator/passes/passes.h"
#include "generator/rewrite.h"

namespace sinew {

Graph share(const Graph& graph) {
  std::unordered_map<std::uint64_t, Value> differences;
  return rewrite(graph, [&differences](Graph& to, const Node& node) {
    if (node.op != Op::subtract) return to.add(node);
    const auto pair = [](Value a, Value b) {
      return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    };
    const auto opposite = differences.find(pair(node.b, node.a));
    if (opposite != differences.end()) return to.make(Op::negate, opposite->second);
    const Value v = to.add(node);
    differences.emplace(pair(node.a, node.b), v);
    return v;
  });
}

}  // namespace sinew
