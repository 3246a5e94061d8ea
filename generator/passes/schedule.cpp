// SPDX-License-Identifier: GPL-3.0-or-later
// schedule: the order of the emitted statements. All angles and their sincos come first, where a
// processor can overlap them; after that every result is computed depth first, the operand that
// needs more operations before the other, so that few values are alive at a time.
//
//   s = sin(a); t = s * b; u = sin(d); r = t + u   ->   s, u, t, r
#include <algorithm>
#include <functional>

#include "generator/passes/passes.h"

namespace sinew {
namespace {

class Scheduler {
 public:
  explicit Scheduler(const Graph& graph)
      : from_(graph),
        to_(graph.empty_like()),
        moved_(static_cast<std::size_t>(graph.size()), no_value),
        weight_(static_cast<std::size_t>(graph.size()), 1),
        after_sincos_(static_cast<std::size_t>(graph.size()), false) {
    measure();
  }

  Graph run() {
    hoist_sincos();
    for (Port& port : to_.outputs)
      for (Value& v : port.values) v = place(v);
    return std::move(to_);
  }

 private:
  static bool is_sincos(const Node& n) { return n.op == Op::sine || n.op == Op::cosine; }

  void measure() {
    for (Value v = 0; v < from_.size(); ++v) {
      const Node& node = from_[v];
      for (int i = 0; i < arity(node.op); ++i) {
        const auto operand = static_cast<std::size_t>(node.operand(i));
        weight_[static_cast<std::size_t>(v)] += weight_[operand];
        if (after_sincos_[operand] || is_sincos(from_[node.operand(i)]))
          after_sincos_[static_cast<std::size_t>(v)] = true;
      }
      weight_[static_cast<std::size_t>(v)] =
          std::min(weight_[static_cast<std::size_t>(v)], 1 << 20);
    }
  }

  void hoist_sincos() {
    for (Value v = 0; v < from_.size(); ++v)
      if (is_sincos(from_[v]) && !after_sincos_[static_cast<std::size_t>(v)]) place(from_[v].a);
    for (Value v = 0; v < from_.size(); ++v)
      if (is_sincos(from_[v]) && !after_sincos_[static_cast<std::size_t>(v)])
        place_pair(from_[v].a);
  }

  /// Sine and cosine of one angle stand side by side, so that one call gives both.
  void place_pair(Value angle) {
    for (Value v = angle + 1; v < from_.size(); ++v)
      if (is_sincos(from_[v]) && from_[v].a == angle) copy(v);
  }

  Value place(Value v) {
    if (moved_[static_cast<std::size_t>(v)] != no_value) return moved_[static_cast<std::size_t>(v)];
    const Node& node = from_[v];
    std::vector<Value> operands;
    for (int i = 0; i < arity(node.op); ++i) operands.push_back(node.operand(i));
    std::stable_sort(operands.begin(), operands.end(), [this](Value x, Value y) {
      return weight_[static_cast<std::size_t>(x)] > weight_[static_cast<std::size_t>(y)];
    });
    for (Value operand : operands) place(operand);
    if (is_sincos(node))
      place_pair(node.a);
    else
      copy(v);
    return moved_[static_cast<std::size_t>(v)];
  }

  void copy(Value v) {
    if (moved_[static_cast<std::size_t>(v)] != no_value) return;
    Node node = from_[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved_[static_cast<std::size_t>(node.operand(i))];
    moved_[static_cast<std::size_t>(v)] = to_.add(node);
    to_.set_label(moved_[static_cast<std::size_t>(v)], from_.label(v));
  }

  const Graph& from_;
  Graph to_;
  std::vector<Value> moved_;
  std::vector<int> weight_;
  std::vector<bool> after_sincos_;
};

}  // namespace

Graph schedule(const Graph& graph) {
  return Scheduler(graph).run();
}

}  // namespace sinew
