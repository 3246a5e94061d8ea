// SPDX-License-Identifier: GPL-3.0-or-later
// schedule: the order of the emitted statements. All angles and their sincos come first, where a
// processor can overlap them; after that several depth-first orders are tried and the one that
// keeps the fewest values waiting beyond a register file is taken. Results with many terms that
// have factors in common are woven: all their sums grow term by term.
//
//   s = sin(a); t = s * b; u = sin(d); r = t + u   ->   s, u, t, r
#include <algorithm>

#include "generator/passes/passes.h"
#include "generator/passes/schedule_results.h"

namespace sinew {
namespace {

/// Floating-point registers of the machines the code is meant for, less a few for the operation
/// at hand. Only guides the choice: no order is wrong.
constexpr int registers = 14;

/// Which operand, and which result, is computed first.
struct Order {
  bool heavier_first;
  bool last_result_first;
  ResultOrder results;
};

class Scheduler {
 public:
  Scheduler(const Graph& graph, Order order)
      : from_(graph),
        order_(order),
        to_(graph.empty_like()),
        moved_(static_cast<std::size_t>(graph.size()), no_value),
        weight_(static_cast<std::size_t>(graph.size()), 1),
        after_sincos_(static_cast<std::size_t>(graph.size()), false) {
    measure();
  }

  Graph run() {
    hoist_sincos();
    for (Value v : result_order(from_, order_.results, order_.last_result_first)) place(v);
    for (Port& port : to_.outputs)
      for (Value& v : port.values) v = moved_[static_cast<std::size_t>(v)];
    return std::move(to_);
  }

 private:
  static bool is_sincos(const Node& n) { return n.op == Op::sine || n.op == Op::cosine; }

  void measure() {
    for (Value v = 0; v < from_.size(); ++v) {
      const Node& node = from_[v];
      int& weight = weight_[static_cast<std::size_t>(v)];
      for (int i = 0; i < arity(node.op); ++i) {
        const auto operand = static_cast<std::size_t>(node.operand(i));
        weight = std::min(weight + weight_[operand], 1 << 20);
        if (after_sincos_[operand] || is_sincos(from_[node.operand(i)]))
          after_sincos_[static_cast<std::size_t>(v)] = true;
      }
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

  void place(Value v) {
    if (moved_[static_cast<std::size_t>(v)] != no_value) return;
    const Node& node = from_[v];
    std::vector<Value> operands;
    for (int i = 0; i < arity(node.op); ++i) operands.push_back(node.operand(i));
    std::stable_sort(operands.begin(), operands.end(), [this](Value x, Value y) {
      const int wx = weight_[static_cast<std::size_t>(x)],
                wy = weight_[static_cast<std::size_t>(y)];
      return order_.heavier_first ? wx > wy : wx < wy;
    });
    for (Value operand : operands) place(operand);
    if (is_sincos(node))
      place_pair(node.a);
    else
      copy(v);
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
  Order order_;
  Graph to_;
  std::vector<Value> moved_;
  std::vector<int> weight_;
  std::vector<bool> after_sincos_;
};

/// Values waiting beyond the registers, summed over all statements. Inputs and constants are read
/// from memory where they are used and do not wait.
long waiting(const Graph& graph) {
  std::vector<Value> last_use(static_cast<std::size_t>(graph.size()), no_value);
  for (Value v = 0; v < graph.size(); ++v)
    for (int i = 0; i < arity(graph[v].op); ++i)
      last_use[static_cast<std::size_t>(graph[v].operand(i))] = v;
  std::vector<int> ends(static_cast<std::size_t>(graph.size()) + 1, 0);
  long total = 0;
  int alive = 0;
  for (Value v = 0; v < graph.size(); ++v) {
    alive -= ends[static_cast<std::size_t>(v)];
    const bool in_memory = graph[v].op == Op::input || graph.is_constant(v);
    if (!in_memory && last_use[static_cast<std::size_t>(v)] != no_value) {
      ++alive;
      ++ends[static_cast<std::size_t>(last_use[static_cast<std::size_t>(v)])];
    }
    total += std::max(0, alive - registers);
  }
  return total;
}

/// A form with its waiting values.
struct Candidate {
  Graph graph;
  long waiting = -1;
};

Candidate best_of(const Graph& graph, ResultOrder results) {
  Candidate best;
  for (bool heavier_first : {true, false})
    for (bool last_result_first : {false, true}) {
      Graph candidate = Scheduler(graph, {heavier_first, last_result_first, results}).run();
      const long now = waiting(candidate);
      if (best.waiting >= 0 && now >= best.waiting) continue;
      best = {std::move(candidate), now};
    }
  return best;
}

}  // namespace

Graph schedule(const Graph& graph) {
  Candidate simple = best_of(graph, ResultOrder::one_by_one);
  Candidate woven = best_of(graph, ResultOrder::beside_longest_sum);
  // Compilers do better with results in their own order, so only where it matters.
  return 4 * woven.waiting < 3 * simple.waiting ? std::move(woven.graph) : std::move(simple.graph);
}

}  // namespace sinew
