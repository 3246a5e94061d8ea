// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/places.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace sinew {
namespace {

constexpr std::size_t most_angles = 3;
/// Fewer operations are not worth a call.
constexpr int fewest_operations = 12;

bool is_sine(const Node& node) {
  return node.op == Op::sine || node.op == Op::cosine;
}

/// The angles that each value depends on; nothing where they are more than a part may take.
using Angles = std::optional<std::set<Value>>;

Angles both(const Angles& a, const Angles& b) {
  if (!a || !b) return std::nullopt;
  std::set<Value> all = *a;
  all.insert(b->begin(), b->end());
  if (all.size() > most_angles) return std::nullopt;
  return all;
}

class AngleFinder {
 public:
  explicit AngleFinder(const Graph& graph) : graph_(graph) {
    for (Value v = 0; v < graph.size(); ++v) {
      const bool takes = is_sine(graph[v]) || graph[v].op == Op::input;
      bool below = is_sine(graph[v]);
      for (Value w : needs_of(graph, v)) {
        if (takes) angles_.insert(w);
        below = below || graph[v].op == Op::input || derived_[static_cast<std::size_t>(w)];
      }
      derived_.push_back(below);
    }
  }

  /// By number of operations. `first`: of those angles alone that no other angle is needed for.
  std::map<std::set<Value>, int> sets(bool first) const {
    std::vector<Angles> of;
    std::map<std::set<Value>, int> count;
    for (Value v = 0; v < graph_.size(); ++v) {
      const bool is_end = angles_.count(v) && !(first && derived_[static_cast<std::size_t>(v)]);
      Angles mine = std::set<Value>{};
      for (Value w : needs_of(graph_, v)) mine = both(mine, of[static_cast<std::size_t>(w)]);
      if (mine && arity(graph_[v].op) > 0) ++count[*mine];
      of.push_back(is_end ? Angles(std::set<Value>{v}) : mine);
    }
    return count;
  }

 private:
  const Graph& graph_;
  std::set<Value> angles_;
  std::vector<bool> derived_;  ///< needs a sine or a call
};

/// Finds the other function's input element for one of the base.
class InputImages {
 public:
  InputImages(const CallingFunction& base, const CallingFunction& other)
      : base_(base), other_(other), calls_(calls_by_port(base)), its_calls_(calls_by_port(other)) {}

  Value of(Value v, const std::vector<Value>& image) const {
    int element = base_.rest[v].index;
    const std::size_t port = base_.rest.port_of_input(element);
    for (std::size_t p = 0; p < port; ++p) element -= base_.rest.inputs[p].size();
    for (std::size_t p = 0; p < other_.rest.inputs.size(); ++p)
      if (is_same(port, p, image)) return element_of(p, element);
    return no_value;
  }

 private:
  bool is_same(std::size_t port, std::size_t p, const std::vector<Value>& image) const {
    const Port &mine = base_.rest.inputs[port], &its = other_.rest.inputs[p];
    const Call *call = calls_[port], *there = its_calls_[p];
    if (!call || !there) return !call && !there && same_argument(mine, its);
    if (!call->is_part || call->function != there->function || call->arguments != there->arguments)
      return false;
    for (std::size_t k = 0; k < mine.values.size(); ++k)
      if (image[static_cast<std::size_t>(mine.values[k])] != its.values[k]) return false;
    return true;
  }

  Value element_of(std::size_t p, int element) const {
    Node node;
    node.op = Op::input;
    node.index = element;
    for (std::size_t before = 0; before < p; ++before)
      node.index += other_.rest.inputs[before].size();
    return other_.rest.find(node);
  }

  const CallingFunction &base_, &other_;
  std::vector<const Call*> calls_, its_calls_;
};

}  // namespace

bool same_argument(const Port& a, const Port& b) {
  return a.name == b.name && a.size() == b.size() && a.by_value == b.by_value;
}

std::size_t own_ports(const CallingFunction& function) {
  std::size_t arrays = 0;
  for (const Call& call : function.calls) arrays += call.results.size();
  return function.rest.inputs.size() - arrays;
}

std::vector<const Call*> calls_by_port(const CallingFunction& function) {
  std::vector<const Call*> by_port(own_ports(function), nullptr);
  for (const Call& call : function.calls) by_port.insert(by_port.end(), call.results.size(), &call);
  return by_port;
}

std::vector<Value> needs_of(const Graph& graph, Value v) {
  const Node& node = graph[v];
  if (node.op == Op::input) return graph.inputs[graph.port_of_input(node.index)].values;
  std::vector<Value> needs;
  for (int i = 0; i < arity(node.op); ++i) needs.push_back(node.operand(i));
  return needs;
}

std::vector<std::vector<Value>> places_of(const CallingFunction& function) {
  const AngleFinder finder(function.rest);
  std::set<std::vector<Value>> places{{}};
  for (const bool first : {false, true})
    for (const auto& [angles, operations] : finder.sets(first))
      if (operations >= fewest_operations) places.insert({angles.begin(), angles.end()});
  return {places.begin(), places.end()};
}

std::vector<Value> images(const CallingFunction& base, const std::vector<Value>& at,
                          const CallingFunction& other, const std::vector<Value>& there) {
  const InputImages inputs(base, other);
  std::vector<Value> image(static_cast<std::size_t>(base.rest.size()), no_value);
  for (Value v = 0; v < base.rest.size(); ++v) {
    Value& mine = image[static_cast<std::size_t>(v)];
    if (const auto place = std::find(at.begin(), at.end(), v); place != at.end()) {
      mine = there[static_cast<std::size_t>(place - at.begin())];
      continue;
    }
    Node node = base.rest[v];
    if (node.op == Op::input) {
      mine = inputs.of(v, image);
      continue;
    }
    bool known = true;
    for (int i = 0; i < arity(node.op); ++i) {
      node.operand(i) = image[static_cast<std::size_t>(node.operand(i))];
      known = known && node.operand(i) != no_value;
    }
    if (known) mine = other.rest.find(node);
  }
  return image;
}

}  // namespace sinew
