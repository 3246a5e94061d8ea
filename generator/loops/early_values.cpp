// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/early_values.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <limits>

namespace sinew {
namespace {

using Links = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Network = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, std::size_t,
                    boost::property<boost::vertex_color_t, boost::default_color_type,
                                    boost::property<boost::vertex_distance_t, long,
                                                    boost::property<boost::vertex_predecessor_t,
                                                                    Links::edge_descriptor>>>>,
    boost::property<
        boost::edge_capacity_t, long,
        boost::property<boost::edge_residual_capacity_t, long,
                        boost::property<boost::edge_reverse_t, Links::edge_descriptor>>>>;

constexpr long always = std::numeric_limits<int>::max();

/// A value that is early has all its operands early. One that has a late user has to wait.
class Cut {
 public:
  Cut(const Graph& graph, const std::vector<Loop>& loops, const std::vector<bool>& needed)
      : graph_(graph), needed_(needed), network_(2 * static_cast<std::size_t>(graph.size()) + 2) {
    mark_loops(loops);
    for (Value v = 0; v < graph.size(); ++v)
      if (is_operation(v)) add(v);
    for (Value v = 0; v < graph.size(); ++v)
      for (int i = 0; is_operation(v) && i < arity(graph[v].op); ++i)
        add_use(graph[v].operand(i), v);
  }

  std::vector<bool> early() {
    boost::boykov_kolmogorov_max_flow(network_, source(), sink());
    const auto colour = boost::get(boost::vertex_color, network_);
    std::vector<bool> early(static_cast<std::size_t>(graph_.size()), false);
    for (Value v = 0; v < graph_.size(); ++v)
      early[static_cast<std::size_t>(v)] =
          !is_operation(v) || boost::get(colour, at(v)) == boost::black_color;
    return early;
  }

 private:
  std::size_t at(Value v) const { return 2 * static_cast<std::size_t>(v); }
  /// Stands for "all users of v are early".
  std::size_t users_of(Value v) const { return at(v) + 1; }
  std::size_t source() const { return at(graph_.size()); }
  std::size_t sink() const { return at(graph_.size()) + 1; }
  bool is_operation(Value v) const {
    return arity(graph_[v].op) > 0 && needed_[static_cast<std::size_t>(v)];
  }

  void mark_loops(const std::vector<Loop>& loops) {
    read_.assign(static_cast<std::size_t>(graph_.size()), false);
    late_.assign(static_cast<std::size_t>(graph_.size()), false);
    for (const Loop& loop : loops) {
      for (const LoopLeaf& leaf : loop.leaves)
        for (Value v : leaf.reads()) read_[static_cast<std::size_t>(v)] = true;
      for (const LoopResult& result : loop.results) {
        if (result.is_carried()) read_[static_cast<std::size_t>(result.first)] = true;
        for (Value v : result.given()) late_[static_cast<std::size_t>(v)] = true;
      }
    }
    for (Value v = 0; v < graph_.size(); ++v)
      for (int i = 0; i < arity(graph_[v].op); ++i)
        if (late_[static_cast<std::size_t>(graph_[v].operand(i))])
          late_[static_cast<std::size_t>(v)] = true;
  }

  void add(Value v) {
    const bool is_late = late_[static_cast<std::size_t>(v)];
    if (is_late) return link(at(v), sink(), always);
    if (read_[static_cast<std::size_t>(v)]) link(source(), at(v), always);
    link(at(v), users_of(v), 1);
  }

  void add_use(Value operand, Value user) {
    if (!is_operation(operand) || late_[static_cast<std::size_t>(operand)]) return;
    link(users_of(operand), at(user), always);
    if (!late_[static_cast<std::size_t>(user)]) link(at(user), at(operand), always);
  }

  void link(std::size_t from, std::size_t to, long capacity) {
    const auto forth = boost::add_edge(from, to, network_).first;
    const auto back = boost::add_edge(to, from, network_).first;
    boost::put(boost::edge_capacity, network_, forth, capacity);
    boost::put(boost::edge_capacity, network_, back, 0);
    boost::put(boost::edge_reverse, network_, forth, back);
    boost::put(boost::edge_reverse, network_, back, forth);
  }

  const Graph& graph_;
  const std::vector<bool>& needed_;
  Network network_;
  std::vector<bool> read_;  ///< by loops
  std::vector<bool> late_;  ///< needs a loop's result
};

}  // namespace

std::vector<bool> early_values(const Graph& graph, const std::vector<Loop>& loops,
                               const std::vector<bool>& needed) {
  return Cut(graph, loops, needed).early();
}

}  // namespace sinew
