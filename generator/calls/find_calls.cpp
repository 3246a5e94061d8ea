// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/find_calls.h"

#include <algorithm>
#include <map>
#include <optional>

#include "generator/calls/chain.h"
#include "generator/calls/value_keys.h"

namespace sinew {
namespace {

bool has_status(const Graph& graph) {
  return std::any_of(graph.outputs.begin(), graph.outputs.end(),
                     [](const Port& port) { return !port.states.empty(); });
}

/// Whether every input of `inner` is one of `outer`.
bool has_inputs_of(const Graph& outer, const Graph& inner) {
  return std::all_of(inner.inputs.begin(), inner.inputs.end(), [&](const Port& wanted) {
    return std::any_of(outer.inputs.begin(), outer.inputs.end(), [&](const Port& port) {
      return port.name == wanted.name && port.size() == wanted.size() &&
             port.by_value == wanted.by_value;
    });
  });
}

/// Where a value comes from that a call gives: which of the arrays, which element, and whether that
/// has the other sign.
struct Given {
  int array = 0;
  int element = 0;
  bool negative = false;
};

/// A function with some of its values given by calls.
class Caller {
 public:
  Caller(const Graph& graph, std::vector<int> keys) : graph_(&graph), keys_(std::move(keys)) {}

  /// This caller with one call more.
  Caller calling(const Graph& callee, const std::vector<int>& callee_keys) const {
    Caller more = *this;
    Call call{callee.name, {}, {}};
    for (const Port& port : callee.inputs) call.arguments.push_back(port.name);
    std::map<int, Given> found;
    const auto key = [&](Value v) { return callee_keys[static_cast<std::size_t>(v)]; };
    for (const Port& port : callee.outputs) {
      Port array{
          free_name(callee.name + "_" + port.name), port.rows, port.cols, port.unit, "", {}, {}};
      for (int i = 0; i < port.size(); ++i) {
        const Value result = port.values[static_cast<std::size_t>(i)];
        found.try_emplace(key(result), Given{more.arrays_, i, false});
        if (callee[result].op == Op::negate)
          found.try_emplace(key(callee[result].a), Given{more.arrays_, i, true});
      }
      call.results.push_back(std::move(array));
      ++more.arrays_;
    }
    for (Value v = 0; v < graph().size(); ++v)
      if (const auto place = found.find(keys_[static_cast<std::size_t>(v)]);
          place != found.end() && arity(graph()[v].op) > 0)
        more.given_.try_emplace(v, place->second);
    more.calls_.push_back(std::move(call));
    return more;
  }

  std::size_t elements() const { return array_elements(calls_); }

  CallingFunction made() const {
    CallingFunction function{calls_, graph().empty_like()};
    Graph& rest = function.rest;
    std::vector<int> first;  // input element of each array
    for (Call& call : function.calls)
      for (Port& array : call.results) {
        first.push_back(rest.input_size());
        rest.inputs.push_back(array);
      }
    std::vector<Value> copy(static_cast<std::size_t>(graph().size()), no_value);
    const std::vector<bool> needed = needed_values();
    for (Value v = 0; v < graph().size(); ++v) {
      if (!needed[static_cast<std::size_t>(v)]) continue;
      copy[static_cast<std::size_t>(v)] = copied(v, copy, first, rest);
    }
    for (std::size_t p = 0; p < rest.outputs.size(); ++p) {
      rest.outputs[p].values.clear();
      for (Value v : graph().outputs[p].values)
        rest.outputs[p].values.push_back(copy[static_cast<std::size_t>(v)]);
    }
    return function;
  }

 private:
  const Graph& graph() const { return *graph_; }

  /// That no argument of the caller has, and no array of its calls.
  std::string free_name(std::string name) const {
    const auto is_among = [&](const std::vector<Port>& ports) {
      return std::any_of(ports.begin(), ports.end(),
                         [&](const Port& port) { return port.name == name; });
    };
    const auto is_array = [&](const Call& call) { return is_among(call.results); };
    while (is_among(graph().inputs) || is_among(graph().outputs) ||
           std::any_of(calls_.begin(), calls_.end(), is_array))
      name += "_";
    return name;
  }

  std::vector<bool> needed_values() const {
    std::vector<bool> needed(static_cast<std::size_t>(graph().size()), false);
    for (Value v : graph().results()) needed[static_cast<std::size_t>(v)] = true;
    for (Value v = graph().size() - 1; v >= 0; --v)
      for (int i = 0;
           needed[static_cast<std::size_t>(v)] && !given_.count(v) && i < arity(graph()[v].op); ++i)
        needed[static_cast<std::size_t>(graph()[v].operand(i))] = true;
    return needed;
  }

  Value copied(Value v, const std::vector<Value>& copy, const std::vector<int>& first,
               Graph& rest) const {
    if (const auto place = given_.find(v); place != given_.end()) {
      const Given& given = place->second;
      const Value element =
          rest.input(first[static_cast<std::size_t>(given.array)] + given.element);
      return given.negative ? rest.make(Op::negate, element) : element;
    }
    Node node = graph()[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = copy[static_cast<std::size_t>(node.operand(i))];
    const Value made = rest.add(node);
    rest.set_label(made, graph().label(v));
    return made;
  }

  const Graph* graph_;
  std::vector<int> keys_;
  std::map<Value, Given> given_;
  std::vector<Call> calls_;
  int arrays_ = 0;
};

CallingFunction of_chain(const std::vector<Graph>& functions, const Graph& chain) {
  CallingFunction function{{}, chain.empty_like()};
  function.rest.outputs.clear();  // the calls give them
  for (const std::string& name : chain.chain) {
    const Graph& callee = functions[place_of_function(functions, name)];
    Call call{name, {}, callee.outputs, name == chain.chain.back()};
    for (const Port& port : callee.inputs) call.arguments.push_back(port.name);
    function.calls.push_back(std::move(call));
  }
  return function;
}

PlanSize straight_size(const Graph& graph) {
  return size_of(graph, straight_plan(graph));
}

class CallFinder {
 public:
  CallFinder(const std::vector<Graph>& functions, const LoopLimits& limits)
      : functions_(functions), limits_(limits) {
    ValueKeys keys;
    for (const Graph& graph : functions) {
      keys_.push_back(keys.of(graph));
      sizes_.push_back(straight_size(graph));
    }
  }

  /// The call that leaves least first, until none saves enough.
  CallingFunction run(std::size_t caller) const {
    if (!functions_[caller].chain.empty()) return of_chain(functions_, functions_[caller]);
    Caller best(functions_[caller], keys_[caller]);
    Sizes size{sizes_[caller].written, 0};
    while (const std::optional<Choice> next = best_call(caller, best, size)) {
      best = next->caller;
      size = next->size;
    }
    return best.made();
  }

 private:
  struct Sizes {
    int written = 0;   ///< of the function without what it calls
    int in_calls = 0;  ///< executed in what it calls
  };
  struct Choice {
    Caller caller;
    Sizes size;
  };

  std::optional<Choice> best_call(std::size_t caller, const Caller& now, const Sizes& size) const {
    std::optional<Choice> best;
    for (std::size_t callee = 0; callee < functions_.size(); ++callee) {
      if (!may_call(caller, callee)) continue;
      std::optional<Choice> choice = with_call(caller, callee, now, size);
      if (choice && (!best || choice->size.written < best->size.written)) best = std::move(choice);
    }
    return best;
  }

  bool may_call(std::size_t caller, std::size_t callee) const {
    return sizes_[callee].written < sizes_[caller].written && !has_status(functions_[callee]) &&
           has_inputs_of(functions_[caller], functions_[callee]);
  }

  /// Nothing where the call saves too little or costs too much.
  std::optional<Choice> with_call(std::size_t caller, std::size_t callee, const Caller& now,
                                  const Sizes& size) const {
    const Caller more = now.calling(functions_[callee], keys_[callee]);
    if (more.elements() > limits_.arrays) return std::nullopt;
    const PlanSize rest = straight_size(more.made().rest);
    constexpr int entry = 16;  // a call, what it saves on the stack, its return: Cortex-A9
    const int passed = static_cast<int>(functions_[callee].results().size());  // read again
    const Sizes after{rest.written, size.in_calls + sizes_[callee].executed + passed + entry};
    const bool saves = size.written - after.written >= limits_.saving;
    const PlanSize whole{after.written, rest.executed + after.in_calls};
    if (!saves || is_dear(whole, sizes_[caller], limits_)) return std::nullopt;
    return Choice{more, after};
  }

  const std::vector<Graph>& functions_;
  LoopLimits limits_;
  std::vector<std::vector<int>> keys_;
  std::vector<PlanSize> sizes_;
};

}  // namespace

std::size_t array_elements(const std::vector<Call>& calls) {
  std::size_t count = 0;
  for (const Call& call : calls)
    for (const Port& array : call.results)
      if (!call.gives_results) count += static_cast<std::size_t>(array.size());
  return count;
}

LoopLimits limits_beside(const std::vector<Call>& calls, LoopLimits limits) {
  limits.arrays -= std::min(limits.arrays, array_elements(calls));
  return limits;
}

std::vector<CallingFunction> find_calls(const std::vector<Graph>& functions,
                                        const LoopLimits& limits) {
  const CallFinder finder(functions, limits);
  std::vector<CallingFunction> all;
  for (std::size_t i = 0; i < functions.size(); ++i) all.push_back(finder.run(i));
  return all;
}

}  // namespace sinew
