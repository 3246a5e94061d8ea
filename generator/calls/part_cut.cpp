// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/part_cut.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "generator/calls/places.h"

namespace sinew {
namespace {

using Arcs = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using FlowNetwork = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, std::size_t,
                    boost::property<boost::vertex_color_t, boost::default_color_type,
                                    boost::property<boost::vertex_distance_t, long,
                                                    boost::property<boost::vertex_predecessor_t,
                                                                    Arcs::edge_descriptor>>>>,
    boost::property<
        boost::edge_capacity_t, long,
        boost::property<boost::edge_residual_capacity_t, long,
                        boost::property<boost::edge_reverse_t, Arcs::edge_descriptor>>>>;

constexpr long whole_part = std::numeric_limits<int>::max();

/// The source's side of the least cut belongs to the part.
class PartCut {
 public:
  PartCut(const Graph& graph, const PartValues& values)
      : graph_(graph), values_(values), network_(2 * static_cast<std::size_t>(graph.size()) + 2) {
    for (Value v = 0; v < graph.size(); ++v)
      if (may(v)) add(v);
  }

  std::vector<bool> run() {
    boost::boykov_kolmogorov_max_flow(network_, source(), sink());
    const auto colour = boost::get(boost::vertex_color, network_);
    std::vector<bool> belongs(static_cast<std::size_t>(graph_.size()), false);
    for (Value v = 0; v < graph_.size(); ++v)
      belongs[static_cast<std::size_t>(v)] =
          may(v) && boost::get(colour, at(v)) == boost::black_color;
    return belongs;
  }

 private:
  std::size_t at(Value v) const { return 2 * static_cast<std::size_t>(v); }
  /// Stands for "all that need v belong to the part".
  std::size_t users_of(Value v) const { return at(v) + 1; }
  std::size_t source() const { return at(graph_.size()); }
  std::size_t sink() const { return source() + 1; }
  bool may(Value v) const { return values_.may[static_cast<std::size_t>(v)]; }

  void add(Value v) {
    const auto i = static_cast<std::size_t>(v);
    connect(source(), at(v), scaled(values_.gain[i]));
    connect(at(v), users_of(v), scaled(values_.cost[i]));
    if (values_.beside[i]) connect(users_of(v), sink(), whole_part);
    for (Value need : needs_of(graph_, v)) {
      if (!may(need)) continue;
      connect(at(v), at(need), whole_part);
      connect(users_of(need), at(v), whole_part);
    }
    if (graph_[v].op != Op::input) return;
    const auto [first, is_new] = first_.try_emplace(graph_.port_of_input(graph_[v].index), v);
    if (is_new) return;
    connect(at(v), at(first->second), whole_part);
    connect(at(first->second), at(v), whole_part);
  }

  static long scaled(double instructions) { return std::lround(100.0 * instructions); }

  void connect(std::size_t from, std::size_t to, long capacity) {
    const auto forth = boost::add_edge(from, to, network_).first;
    const auto back = boost::add_edge(to, from, network_).first;
    boost::put(boost::edge_capacity, network_, forth, capacity);
    boost::put(boost::edge_capacity, network_, back, 0);
    boost::put(boost::edge_reverse, network_, forth, back);
    boost::put(boost::edge_reverse, network_, back, forth);
  }

  const Graph& graph_;
  const PartValues& values_;
  FlowNetwork network_;
  std::map<std::size_t, Value> first_;  ///< element of each call's array
};

}  // namespace

std::vector<bool> cut_part(const Graph& graph, const PartValues& values) {
  return PartCut(graph, values).run();
}

}  // namespace sinew
