// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/plan.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "generator/loops/early_values.h"

namespace sinew {
namespace {

bool is_operation(const Node& node) {
  return node.op != Op::input && node.op != Op::constant;
}

/// Orders the values that the results and the loops need; each loop after all that it reads.
class StepOrder {
 public:
  StepOrder(const Graph& graph, Plan& plan)
      : graph_(graph),
        plan_(plan),
        state_(static_cast<std::size_t>(graph.size()), State::waiting),
        loop_state_(plan.loops.size(), State::waiting),
        call_state_(graph.inputs.size(), State::waiting),
        given_by_(static_cast<std::size_t>(graph.size()), -1) {
    for (std::size_t k = 0; k < plan.loops.size(); ++k)
      for (const LoopResult& result : plan.loops[k].results)
        for (Value v : result.given()) given_by_[static_cast<std::size_t>(v)] = static_cast<int>(k);
  }

  /// In the graph's order.
  void run() {
    const std::vector<bool> needed = needed_values();
    place_all(needed);
    place_loops();
  }

  /// What is better computed before the loops first.
  void run_early_first() {
    const std::vector<bool> needed = needed_values();
    std::vector<bool> early = early_values(graph_, plan_.loops, needed);
    for (std::size_t v = 0; v < early.size(); ++v) early[v] = early[v] && needed[v];
    place_all(early);
    place_loops();
    place_all(needed);
  }

 private:
  enum class State { waiting, open, done };

  void place_all(const std::vector<bool>& chosen) {
    for (Value v = 0; v < graph_.size(); ++v)
      if (chosen[static_cast<std::size_t>(v)]) place(v);
  }

  void place_loops() {
    for (std::size_t k = 0; k < plan_.loops.size(); ++k) place_loop(static_cast<int>(k));
  }

  void use(Value v, int times, std::vector<bool>& needed) {
    plan_.uses[static_cast<std::size_t>(v)] += times;
    needed[static_cast<std::size_t>(v)] = true;
  }

  /// What is passed to the call that an input element is from; once.
  void use_call(int index, std::vector<bool>& needed) {
    const std::size_t port = graph_.port_of_input(index);
    if (!called_.insert(port).second) return;
    for (Value v : graph_.inputs[port].values) use(v, 1, needed);
  }

  void use_by_loop(const Loop& loop, std::vector<bool>& needed) {
    for (const LoopLeaf& leaf : loop.leaves) {
      for (Value v : leaf.reads()) use(v, 2, needed);
      if (!leaf.inputs.empty()) use_call(leaf.inputs[0], needed);
    }
    for (const LoopResult& result : loop.results)
      if (result.is_carried()) use(result.first, 1, needed);
  }

  std::vector<bool> needed_values() {
    std::vector<bool> needed(static_cast<std::size_t>(graph_.size()), false);
    for (std::size_t p = 0; p < graph_.outputs.size(); ++p)
      for (std::size_t i = 0; i < graph_.outputs[p].values.size(); ++i)
        if (!plan_.stored[p][i]) use(graph_.outputs[p].values[i], 1, needed);
    for (const Loop& loop : plan_.loops) use_by_loop(loop, needed);
    for (Value v = graph_.size() - 1; v >= 0; --v) {
      if (!needed[static_cast<std::size_t>(v)] || given_by_[static_cast<std::size_t>(v)] >= 0)
        continue;
      if (graph_[v].op == Op::input) use_call(graph_[v].index, needed);
      for (int i = 0; i < arity(graph_[v].op); ++i) use(graph_[v].operand(i), 1, needed);
    }
    return needed;
  }

  /// Whether this is the first visit; throws inside a visit.
  static bool enter(State& state) {
    if (state == State::open) throw std::logic_error("loops that need each other's results");
    if (state == State::done) return false;
    state = State::open;
    return true;
  }

  void place(Value v) {
    if (!enter(state_[static_cast<std::size_t>(v)])) return;
    const int loop = given_by_[static_cast<std::size_t>(v)];
    if (graph_[v].op == Op::input) place_call(graph_[v].index);
    if (loop >= 0)
      place_loop(loop);
    else
      for (int i = 0; i < arity(graph_[v].op); ++i) place(graph_[v].operand(i));
    plan_.steps.push_back({v, -1});
    state_[static_cast<std::size_t>(v)] = State::done;
  }

  void place_loop(int k) {
    State& state = loop_state_[static_cast<std::size_t>(k)];
    if (!enter(state)) return;
    for (const LoopLeaf& leaf : plan_.loops[static_cast<std::size_t>(k)].leaves) {
      for (Value v : leaf.reads()) place(v);
      if (!leaf.inputs.empty()) place_call(leaf.inputs[0]);
    }
    for (const LoopResult& result : plan_.loops[static_cast<std::size_t>(k)].results)
      if (result.is_carried()) place(result.first);
    plan_.steps.push_back({no_value, k});
    state = State::done;
  }

  /// The call that an input element is from, where it is passed numbers.
  void place_call(int index) {
    const std::size_t port = graph_.port_of_input(index);
    if (graph_.inputs[port].values.empty() || !enter(call_state_[port])) return;
    for (Value v : graph_.inputs[port].values) place(v);
    plan_.steps.push_back({no_value, -1, static_cast<int>(port)});
    call_state_[port] = State::done;
  }

  const Graph& graph_;
  Plan& plan_;
  std::vector<State> state_, loop_state_, call_state_;
  std::set<std::size_t> called_;  ///< input arrays whose calls are needed
  std::vector<int> given_by_;
};

}  // namespace

Plan straight_plan(const Graph& graph) {
  Plan plan;
  plan.uses = use_counts(graph);
  for (const Port& port : graph.outputs) plan.stored.emplace_back(port.values.size(), false);
  std::vector<bool> called(graph.inputs.size(), false);
  for (Value v = 0; v < graph.size(); ++v) {
    if (graph[v].op == Op::input) {
      const std::size_t port = graph.port_of_input(graph[v].index);
      if (!graph.inputs[port].values.empty() && !called[port])
        plan.steps.push_back({no_value, -1, static_cast<int>(port)});
      called[port] = true;
    }
    plan.steps.push_back({v, -1});
  }
  return plan;
}

namespace {

/// With everything but the steps and the uses, which the order of steps counts.
Plan plan_without_steps(const Graph& graph, std::vector<Loop> loops) {
  Plan plan;
  plan.loops = std::move(loops);
  plan.uses.assign(static_cast<std::size_t>(graph.size()), 0);
  for (const Port& port : graph.outputs) plan.stored.emplace_back(port.values.size(), false);
  for (const Loop& loop : plan.loops)
    for (const LoopResult& result : loop.results)
      for (int element : result.elements)
        plan.stored[static_cast<std::size_t>(result.port)][static_cast<std::size_t>(element)] =
            true;
  return plan;
}

}  // namespace

Plan plan_with(const Graph& graph, std::vector<Loop> loops) {
  if (loops.empty()) return straight_plan(graph);
  Plan plan = plan_without_steps(graph, std::move(loops));
  StepOrder(graph, plan).run();
  return plan;
}

Plan with_fewest_waiting(const Graph& graph, const Plan& planned) {
  if (planned.loops.empty()) return planned;
  Plan plan = plan_without_steps(graph, planned.loops);
  StepOrder(graph, plan).run_early_first();
  return plan;
}

int operation_count(const Graph& graph) {
  int count = 0;
  for (const Node& node : graph.nodes()) count += is_operation(node);
  return count;
}

/// Counted in the object code for the Cortex-A9; docs/performance.md has the comparison.
Weight instructions_of(Op op) {
  switch (op) {
    case Op::input:
    case Op::constant:
      return {0, 0};
    case Op::square_root:
      return {9, 9};
    case Op::minimum:
    case Op::maximum:
    case Op::choose:
    case Op::absolute:
      return {6, 6};
    case Op::sine:
    case Op::cosine:
      return {6, 60};
    case Op::arctangent:
    case Op::arctangent2:
    case Op::arccosine:
    case Op::arcsine:
    case Op::exponential:
    case Op::logarithm:
    case Op::hyperbolic_tangent:
      return {4, 150};
    default:
      return {1, 1};
  }
}

namespace {

/// Products that are used once, by a sum: one instruction computes both, with two roundings.
std::vector<bool> products_in_sums(const Graph& graph, const std::vector<int>& uses) {
  std::vector<bool> in_sum(static_cast<std::size_t>(graph.size()), false);
  for (Value v = 0; v < graph.size(); ++v) {
    if (graph[v].op != Op::add && graph[v].op != Op::subtract) continue;
    for (int i = 1; i >= 0; --i) {
      const auto operand = static_cast<std::size_t>(graph[v].operand(i));
      if (graph[graph[v].operand(i)].op != Op::multiply || uses[operand] != 1) continue;
      in_sum[operand] = true;
      break;
    }
  }
  return in_sum;
}

/// A constant is loaded where it is used; a loop keeps it in a register.
int constant_operands(const Graph& graph, const Node& node) {
  int count = 0;
  for (int i = 0; i < arity(node.op); ++i) count += graph.is_constant(node.operand(i));
  return count;
}

/// Loads and stores of values that registers have no room for: the more, the longer the code is.
int moved_in(int instructions) {
  constexpr int length = 12000;
  return instructions * instructions / length;
}

/// The same in a pass of a loop, which also holds what it reads in every pass.
int moved_in_pass(int operations) {
  constexpr int length = 300;
  return operations * operations / length;
}

bool is_even(const std::vector<int>& elements) {
  for (std::size_t i = 2; i < elements.size(); ++i)
    if (elements[i] - elements[i - 1] != elements[1] - elements[0]) return false;
  return true;
}

/// What a pass does beside the body's operations: its counter, and loads and stores of what it
/// reads and gives. Places that are not evenly spaced are read from a table, once for all that has
/// the same.
int beside_of_pass(const Loop& loop) {
  constexpr int counter = 5, lookup = 4;
  constexpr std::ptrdiff_t in_registers = 8;  // half of the fewest that the boards have
  const std::ptrdiff_t carried =
      std::count_if(loop.results.begin(), loop.results.end(),
                    [](const LoopResult& result) { return result.is_carried(); });
  std::size_t moved =
      loop.results.size() - static_cast<std::size_t>(std::min(carried, in_registers));
  std::set<std::vector<int>> tables;
  for (const LoopResult& result : loop.results)
    if (!is_even(result.elements)) tables.insert(result.elements);
  for (const LoopLeaf& leaf : loop.leaves) {
    moved += leaf.kind == LoopLeaf::Kind::shared || leaf.kind == LoopLeaf::Kind::carried ? 0 : 1;
    if (!is_even(leaf.inputs)) tables.insert(leaf.inputs);
    if (leaf.kind == LoopLeaf::Kind::chosen) {
      tables.insert(leaf.places);
      ++moved;  // the array's address
    }
  }
  return counter + static_cast<int>(moved + lookup * tables.size());
}

/// Stores of what passes choose from, and loads of what they kept.
int choices_of(const Loop& loop) {
  std::size_t stores = 0;
  for (const LoopResult& result : loop.results) stores += result.kept.size();
  for (const LoopLeaf& leaf : loop.leaves)
    if (leaf.kind == LoopLeaf::Kind::chosen) stores += leaf.choices.size();
  return static_cast<int>(stores);
}

PlanSize body_size(const Graph& body) {
  PlanSize size;
  const std::vector<bool> in_sum = products_in_sums(body, use_counts(body));
  for (Value v = 0; v < body.size(); ++v) {
    if (in_sum[static_cast<std::size_t>(v)]) continue;
    size.written += instructions_of(body[v].op).written;
    size.executed += instructions_of(body[v].op).executed;
  }
  return size;
}

}  // namespace

PlanSize size_of(const Loop& loop) {
  const PlanSize body = body_size(loop.body);
  const int beside = beside_of_pass(loop) + moved_in_pass(operation_count(loop.body));
  const int choices = choices_of(loop);
  return {body.written + beside + choices, loop.count * (body.executed + beside) + choices};
}

PlanSize size_of(const Graph& graph, const Plan& plan) {
  PlanSize size;
  std::vector<bool> given(static_cast<std::size_t>(graph.size()), false);
  for (const Loop& loop : plan.loops) {
    const PlanSize each = size_of(loop);
    size.written += each.written;
    size.executed += each.executed;
    for (const LoopResult& result : loop.results)
      for (Value v : result.given()) given[static_cast<std::size_t>(v)] = true;
  }
  PlanSize straight;
  const std::vector<bool> in_sum = products_in_sums(graph, plan.uses);
  for (const Step& step : plan.steps) {
    if (step.value == no_value || given[static_cast<std::size_t>(step.value)]) continue;
    const Node& node = graph[step.value];
    const int constants = constant_operands(graph, node);
    const Weight weight =
        in_sum[static_cast<std::size_t>(step.value)] ? Weight{0, 0} : instructions_of(node.op);
    straight.written += weight.written + 2 * constants;  // with the constant itself
    straight.executed += weight.executed + constants;
  }
  const int moved = moved_in(straight.written);
  size.written += straight.written + moved;
  size.executed += straight.executed + moved;
  for (const std::vector<bool>& port : plan.stored)
    for (bool stored : port) {
      size.written += stored ? 0 : 1;
      size.executed += stored ? 0 : 1;
    }
  return size;
}

}  // namespace sinew
