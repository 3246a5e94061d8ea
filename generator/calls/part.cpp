// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/part.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace sinew {
namespace {

bool is_number(const PartDraft& draft, Value v) {
  return std::find(draft.at.begin(), draft.at.end(), v) != draft.at.end();
}

/// What the part's values need and do not compute: arguments of the base, numbers, constants.
std::vector<bool> leaves_of(const PartDraft& draft) {
  const Graph& graph = draft.base->rest;
  std::vector<bool> leaves(static_cast<std::size_t>(graph.size()), false);
  for (Value v = 0; v < graph.size(); ++v) {
    if (!draft.belongs[static_cast<std::size_t>(v)]) continue;
    for (Value need : needs_of(graph, v))
      if (!draft.belongs[static_cast<std::size_t>(need)])
        leaves[static_cast<std::size_t>(need)] = true;
  }
  return leaves;
}

/// The ports of the base that the values in `chosen` are elements of.
std::set<std::size_t> ports_of(const PartDraft& draft, const std::vector<bool>& chosen) {
  const Graph& graph = draft.base->rest;
  std::set<std::size_t> ports;
  for (Value v = 0; v < graph.size(); ++v)
    if (chosen[static_cast<std::size_t>(v)] && graph[v].op == Op::input && !is_number(draft, v))
      ports.insert(graph.port_of_input(graph[v].index));
  return ports;
}

int first_element(const Graph& graph, std::size_t port) {
  int first = 0;
  for (std::size_t p = 0; p < port; ++p) first += graph.inputs[p].size();
  return first;
}

class PartMaker {
 public:
  explicit PartMaker(const PartDraft& draft)
      : draft_(draft),
        base_(draft.base->rest),
        copy_(static_cast<std::size_t>(base_.size()), no_value) {}

  CallingFunction run() {
    made_.rest.name = draft_.name;
    for (std::size_t port : arrays_of_part(draft_)) add_port(port, {});
    add_numbers();
    const std::vector<const Call*> calls = calls_by_port(*draft_.base);
    for (std::size_t port : ports_of(draft_, draft_.belongs)) {
      made_.calls.push_back(*calls[port]);
      add_port(port, {});
    }
    copy_values();
    Port results{"part", static_cast<int>(draft_.results.size()), 1, "", "", {}, {}};
    for (Value v : draft_.results) results.values.push_back(copy(v));
    made_.rest.outputs = {results};
    return made_;
  }

 private:
  Value& copy(Value v) { return copy_[static_cast<std::size_t>(v)]; }

  void add_port(std::size_t port, const std::vector<Value>& values) {
    first_[port] = made_.rest.input_size();
    made_.rest.inputs.push_back(base_.inputs[port]);
    made_.rest.inputs.back().values = values;
  }

  void add_numbers() {
    const std::vector<Value> numbers = numbers_of(draft_);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      copy(numbers[k]) = made_.rest.input(made_.rest.input_size());
      Port number{draft_.names[k], 1, 1, "", "", {}, {}};
      number.by_value = true;
      made_.rest.inputs.push_back(number);
    }
  }

  void copy_values() {
    const std::vector<bool> leaves = leaves_of(draft_);
    for (Value v = 0; v < base_.size(); ++v) {
      const auto i = static_cast<std::size_t>(v);
      if ((!draft_.belongs[i] && !leaves[i]) || copy(v) != no_value) continue;
      Node node = base_[v];
      if (node.op == Op::input) {
        copy(v) = copied_input(node.index);
        continue;
      }
      for (int k = 0; k < arity(node.op); ++k) node.operand(k) = copy(node.operand(k));
      copy(v) = made_.rest.add(node);
      made_.rest.set_label(copy(v), base_.label(v));
    }
  }

  Value copied_input(int index) {
    const std::size_t port = base_.port_of_input(index);
    const int first = first_.at(port);
    Port& array = made_.rest.inputs[made_.rest.port_of_input(first)];
    if (array.values.empty())
      for (Value passed : base_.inputs[port].values) array.values.push_back(copy(passed));
    return made_.rest.input(first + index - first_element(base_, port));
  }

  const PartDraft& draft_;
  const Graph& base_;
  std::vector<Value> copy_;
  std::map<std::size_t, int> first_;  ///< input element, by port of the base
  CallingFunction made_;
};

/// Rewrites one function.
class PartCaller {
 public:
  PartCaller(const CallingFunction& function, const PartDraft& draft,
             const std::vector<const PartInstance*>& instances)
      : function_(function),
        graph_(function.rest),
        state_(static_cast<std::size_t>(graph_.size()), State::waiting),
        copy_(static_cast<std::size_t>(graph_.size()), no_value) {
    for (const PartInstance* instance : instances) add(draft, *instance);
  }

  std::optional<CallingFunction> run() {
    for (Value v : graph_.results())
      if (!need(v)) return std::nullopt;
    lay_out();
    for (Value v = 0; v < graph_.size(); ++v)
      if (state_[static_cast<std::size_t>(v)] == State::done) place(v);
    made_.rest.outputs = graph_.outputs;
    for (Port& port : made_.rest.outputs)
      for (Value& v : port.values) v = copy(v);
    return made_;
  }

 private:
  enum class State { waiting, open, done };

  struct NewCall {
    std::vector<Value> passed;
    std::vector<std::string> arguments;
    bool used = false;
    int first = 0;  ///< input element
    std::size_t port = 0;
    std::string name = {};
    int results = 0;
  };
  struct PartElement {
    std::size_t call;
    int element;
  };

  Value& copy(Value v) { return copy_[static_cast<std::size_t>(v)]; }

  void add(const PartDraft& draft, const PartInstance& instance) {
    NewCall call;
    for (Value v : numbers_of(draft))
      call.passed.push_back(instance.image[static_cast<std::size_t>(v)]);
    for (std::size_t port : arrays_of_part(draft))
      call.arguments.push_back(draft.base->rest.inputs[port].name);
    call.name = draft.name;
    call.results = static_cast<int>(draft.results.size());
    for (std::size_t k = 0; k < draft.results.size(); ++k) {
      const Value v = instance.image[static_cast<std::size_t>(draft.results[k])];
      if (v != no_value) given_.try_emplace(v, PartElement{calls_.size(), static_cast<int>(k)});
    }
    calls_.push_back(std::move(call));
  }

  std::vector<Value> needs(Value v) const {
    const auto given = given_.find(v);
    return given == given_.end() ? needs_of(graph_, v) : calls_[given->second.call].passed;
  }

  /// Marks what is still computed; false where values need each other.
  bool need(Value v) {
    State& state = state_[static_cast<std::size_t>(v)];
    if (state == State::open) return false;
    if (state == State::done) return true;
    state = State::open;
    for (Value each : needs(v))
      if (!need(each)) return false;
    const auto given = given_.find(v);
    if (given != given_.end())
      calls_[given->second.call].used = true;
    else if (graph_[v].op == Op::input)
      ports_.insert(graph_.port_of_input(graph_[v].index));
    state = State::done;
    return true;
  }

  /// The arguments, the arrays of calls that are still needed, and those of the new ones.
  void lay_out() {
    made_.rest = graph_.empty_like();
    made_.rest.inputs.clear();
    for (std::size_t port = 0; port < own_ports(function_); ++port) add_port(port);
    std::size_t port = own_ports(function_);
    for (const Call& call : function_.calls) {
      bool used = false;
      for (std::size_t k = 0; k < call.results.size(); ++k) used = used || ports_.count(port + k);
      for (std::size_t k = 0; used && k < call.results.size(); ++k) add_port(port + k);
      if (used) made_.calls.push_back(call);
      port += call.results.size();
    }
    for (NewCall& call : calls_)
      if (call.used) add_call(call);
  }

  void add_port(std::size_t port) {
    first_[port] = made_.rest.input_size();
    made_.rest.inputs.push_back(graph_.inputs[port]);
    made_.rest.inputs.back().values.clear();
  }

  void add_call(NewCall& call) {
    Port array{free_name(call.name), call.results, 1, "", "", {}, {}};
    call.first = made_.rest.input_size();
    call.port = made_.rest.inputs.size();
    made_.rest.inputs.push_back(array);
    made_.calls.push_back({call.name, call.arguments, {array}, false, true});
  }

  std::string free_name(const std::string& stem) const {
    const auto is_taken = [&](const std::string& name) {
      const auto has = [&](const Port& port) { return port.name == name; };
      return std::any_of(made_.rest.inputs.begin(), made_.rest.inputs.end(), has) ||
             std::any_of(graph_.outputs.begin(), graph_.outputs.end(), has);
    };
    std::string name = stem;
    for (int i = 2; is_taken(name); ++i) name = fmt::format("{}_{}", stem, i);
    return name;
  }

  /// In the graph's order but for what is passed to a call.
  void place(Value v) {
    if (copy(v) != no_value) return;
    for (Value each : needs(v)) place(each);
    if (const auto given = given_.find(v); given != given_.end()) {
      const NewCall& call = calls_[given->second.call];
      pass(made_.rest.inputs[call.port], call.passed);
      copy(v) = made_.rest.input(call.first + given->second.element);
      return;
    }
    Node node = graph_[v];
    if (node.op == Op::input) {
      const std::size_t port = graph_.port_of_input(node.index);
      node.index += first_.at(port) - first_element(graph_, port);
      pass(made_.rest.inputs[made_.rest.port_of_input(node.index)], graph_.inputs[port].values);
    }
    for (int i = 0; i < arity(node.op); ++i) node.operand(i) = copy(node.operand(i));
    copy(v) = made_.rest.add(node);
    made_.rest.set_label(copy(v), graph_.label(v));
  }

  void pass(Port& array, const std::vector<Value>& passed) {
    if (!array.values.empty()) return;
    for (Value v : passed) array.values.push_back(copy(v));
  }

  const CallingFunction& function_;
  const Graph& graph_;
  std::vector<State> state_;
  std::vector<Value> copy_;
  std::vector<NewCall> calls_;
  std::map<Value, PartElement> given_;
  std::set<std::size_t> ports_;       ///< that are still read
  std::map<std::size_t, int> first_;  ///< input element, by the old port
  CallingFunction made_;
};

}  // namespace

std::vector<bool> members_of(const Graph& graph, const std::vector<bool>& belongs,
                             const PartInstance& instance) {
  std::vector<bool> members(static_cast<std::size_t>(graph.size()), false);
  for (std::size_t v = 0; v < belongs.size(); ++v)
    if (belongs[v] && instance.image[v] != no_value)
      members[static_cast<std::size_t>(instance.image[v])] = true;
  return members;
}

std::vector<Value> numbers_of(const PartDraft& draft) {
  const Graph& graph = draft.base->rest;
  const std::vector<bool> leaves = leaves_of(draft);
  std::vector<Value> numbers;
  for (Value v : draft.at)
    if (leaves[static_cast<std::size_t>(v)]) numbers.push_back(v);
  const std::vector<const Call*> calls = calls_by_port(*draft.base);
  for (Value v = 0; v < graph.size(); ++v) {
    if (!leaves[static_cast<std::size_t>(v)] || is_number(draft, v)) continue;
    const std::size_t port =
        graph[v].op == Op::input ? graph.port_of_input(graph[v].index) : graph.inputs.size();
    if (arity(graph[v].op) > 0 ||
        (port < graph.inputs.size() && (calls[port] || graph.inputs[port].by_value)))
      numbers.push_back(v);
  }
  return numbers;
}

std::set<std::size_t> arrays_of_part(const PartDraft& draft) {
  const CallingFunction& base = *draft.base;
  std::set<std::size_t> arrays;
  for (std::size_t port : ports_of(draft, leaves_of(draft)))
    if (port < own_ports(base) && !base.rest.inputs[port].by_value) arrays.insert(port);
  const std::vector<const Call*> calls = calls_by_port(base);
  for (std::size_t port : ports_of(draft, draft.belongs))
    for (const std::string& name : calls[port]->arguments)
      for (std::size_t own = 0; own < own_ports(base); ++own)
        if (base.rest.inputs[own].name == name) arrays.insert(own);
  return arrays;
}

CallingFunction made_part(const PartDraft& draft) {
  return PartMaker(draft).run();
}

std::optional<CallingFunction> calling(const CallingFunction& function, const PartDraft& draft,
                                       const std::vector<const PartInstance*>& instances) {
  return PartCaller(function, draft, instances).run();
}

}  // namespace sinew
