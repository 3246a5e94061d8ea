// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/sums.h"

#include <algorithm>

namespace sinew {
namespace {

class SumFinder {
 public:
  explicit SumFinder(const Graph& graph)
      : graph_(graph), length_(static_cast<std::size_t>(graph.size()), 0) {
    const std::vector<bool> live = live_values(graph);
    for (Value v = 0; v < graph.size(); ++v)
      if (is_sum_of_terms(v) && live[static_cast<std::size_t>(v)])
        length_of(v) = 1 + length_of(rest_of(graph[v]));
  }

  std::vector<Sum> run() {
    std::vector<bool> part(static_cast<std::size_t>(graph_.size()), false);
    std::vector<Sum> all;
    for (Value v = graph_.size() - 1; v >= 0; --v)
      if (!part[static_cast<std::size_t>(v)] && length_of(v) >= 3) all.push_back(sum_at(v, part));
    return all;
  }

 private:
  bool is_sum_of_terms(Value v) const {
    return graph_[v].op == Op::add || graph_[v].op == Op::subtract;
  }

  int& length_of(Value v) { return length_[static_cast<std::size_t>(v)]; }

  /// The operand that is the sum so far.
  Value rest_of(const Node& node) {
    const bool b = node.op == Op::add && length_of(node.b) > length_of(node.a);
    return b ? node.b : node.a;
  }

  Sum sum_at(Value v, std::vector<bool>& part) {
    Sum sum;
    for (; is_sum_of_terms(v); v = rest_of(graph_[v])) {
      part[static_cast<std::size_t>(v)] = true;
      const Node& node = graph_[v];
      sum.partial.push_back(v);
      sum.terms.push_back(rest_of(node) == node.a ? node.b : node.a);
    }
    sum.partial.push_back(v);
    sum.terms.push_back(v);
    std::reverse(sum.partial.begin(), sum.partial.end());
    std::reverse(sum.terms.begin(), sum.terms.end());
    return sum;
  }

  const Graph& graph_;
  std::vector<int> length_;
};

}  // namespace

std::vector<bool> live_values(const Graph& graph) {
  std::vector<bool> live(static_cast<std::size_t>(graph.size()), false);
  for (Value v : graph.results()) live[static_cast<std::size_t>(v)] = true;
  for (const Port& port : graph.inputs)
    for (Value v : port.values) live[static_cast<std::size_t>(v)] = true;
  for (Value v = graph.size() - 1; v >= 0; --v)
    for (int i = 0; live[static_cast<std::size_t>(v)] && i < arity(graph[v].op); ++i)
      live[static_cast<std::size_t>(graph[v].operand(i))] = true;
  return live;
}

std::vector<Sum> long_sums(const Graph& graph) {
  return SumFinder(graph).run();
}

}  // namespace sinew
