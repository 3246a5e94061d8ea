// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/passes/schedule_results.h"

#include <algorithm>
#include <set>

namespace sinew {
namespace {

std::size_t position_of(Value v) {
  return static_cast<std::size_t>(v);
}

/// Sums, also with a sign or a constant factor.
bool is_part_of_sum(const Graph& graph, const Node& n) {
  return n.op == Op::add || n.op == Op::subtract || n.op == Op::negate ||
         (n.op == Op::multiply && (graph.is_constant(n.a) || graph.is_constant(n.b)));
}

/// How many steps of a sum in a row end in each value.
std::vector<int> sum_lengths(const Graph& graph) {
  std::vector<int> lengths(position_of(graph.size()), 0);
  for (Value v = 0; v < graph.size(); ++v) {
    if (!is_part_of_sum(graph, graph[v])) continue;
    for (int i = 0; i < arity(graph[v].op); ++i)
      lengths[position_of(v)] = std::max(lengths[position_of(v)], lengths[position_of(graph[v].operand(i))]);
    ++lengths[position_of(v)];
  }
  return lengths;
}

/// The partial sums of a result, the innermost first, itself last.
std::vector<Value> partial_sums(const Graph& graph, const std::vector<int>& lengths, Value v) {
  std::vector<Value> sums{v};
  while (lengths[position_of(v)] > 1) {
    const Node& node = graph[v];
    v = node.a;
    for (int i = 1; i < arity(node.op); ++i)
      if (lengths[position_of(node.operand(i))] > lengths[position_of(v)]) v = node.operand(i);
    sums.push_back(v);
  }
  std::reverse(sums.begin(), sums.end());
  return sums;
}

std::vector<std::vector<Value>> all_partial_sums(const Graph& graph, bool last_first) {
  const std::vector<int> lengths = sum_lengths(graph);
  std::vector<Value> results = graph.results();
  if (last_first) std::reverse(results.begin(), results.end());
  std::vector<std::vector<Value>> all;
  std::set<Value> seen;
  for (Value v : results)
    if (seen.insert(v).second) all.push_back(partial_sums(graph, lengths, v));
  return all;
}

/// For every value the last step of a sum with which the value, or anything it is computed from, is
/// shared; -1 where nothing is.
std::vector<int> shared_steps(const Graph& graph, const std::vector<Value>& sum) {
  const int never = static_cast<int>(sum.size());
  std::vector<int> needed(position_of(graph.size()), never);  // by which step for the first time
  for (std::size_t k = 0; k < sum.size(); ++k) needed[position_of(sum[k])] = static_cast<int>(k);
  for (Value v = graph.size() - 1; v >= 0; --v)
    for (int i = 0; i < arity(graph[v].op); ++i)
      needed[position_of(graph[v].operand(i))] = std::min(needed[position_of(graph[v].operand(i))], needed[position_of(v)]);
  std::vector<int> shared(position_of(graph.size()), -1);
  for (Value v = 0; v < graph.size(); ++v) {
    if (needed[position_of(v)] < never) shared[position_of(v)] = needed[position_of(v)];
    for (int i = 0; i < arity(graph[v].op); ++i)
      shared[position_of(v)] = std::max(shared[position_of(v)], shared[position_of(graph[v].operand(i))]);
  }
  return shared;
}

/// Along the longest sum: a partial sum of another result follows the first partial sum of the
/// longest one that has everything the two share.
std::vector<Value> beside_longest_sum(const Graph& graph,
                                      const std::vector<std::vector<Value>>& all) {
  const auto longest = std::max_element(
      all.begin(), all.end(), [](const auto& x, const auto& y) { return x.size() < y.size(); });
  if (longest == all.end()) return {};
  const std::vector<int> shared = shared_steps(graph, *longest);
  std::vector<Value> order;
  std::vector<std::size_t> next(all.size(), 0);
  for (int k = -1; k < static_cast<int>(longest->size()); ++k) {
    if (k >= 0) order.push_back((*longest)[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < all.size(); ++i)
      while (next[i] < all[i].size() && shared[position_of(all[i][next[i]])] <= k)
        order.push_back(all[i][next[i]++]);
  }
  return order;
}

}  // namespace

std::vector<Value> result_order(const Graph& graph, ResultOrder order, bool last_first) {
  const std::vector<std::vector<Value>> all = all_partial_sums(graph, last_first);
  if (order == ResultOrder::beside_longest_sum) return beside_longest_sum(graph, all);
  std::vector<Value> results;
  for (const std::vector<Value>& sums : all) results.push_back(sums.back());
  return results;
}

}  // namespace sinew
