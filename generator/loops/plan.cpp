// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/plan.h"

#include <stdexcept>

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
        given_by_(static_cast<std::size_t>(graph.size()), -1) {
    for (std::size_t k = 0; k < plan.loops.size(); ++k)
      for (const LoopResult& result : plan.loops[k].results)
        if (result.is_carried())
          given_by_[static_cast<std::size_t>(result.last)] = static_cast<int>(k);
  }

  void run() {
    const std::vector<bool> needed = needed_values();
    for (Value v = 0; v < graph_.size(); ++v)
      if (needed[static_cast<std::size_t>(v)]) place(v);
    for (std::size_t k = 0; k < plan_.loops.size(); ++k) place_loop(static_cast<int>(k));
  }

 private:
  enum class State { waiting, open, done };

  void use(Value v, int times, std::vector<bool>& needed) {
    plan_.uses[static_cast<std::size_t>(v)] += times;
    needed[static_cast<std::size_t>(v)] = true;
  }

  void use_by_loop(const Loop& loop, std::vector<bool>& needed) {
    for (const LoopLeaf& leaf : loop.leaves)
      if (leaf.kind == LoopLeaf::Kind::shared) use(leaf.value, 2, needed);
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
    for (const LoopLeaf& leaf : plan_.loops[static_cast<std::size_t>(k)].leaves)
      if (leaf.kind == LoopLeaf::Kind::shared) place(leaf.value);
    for (const LoopResult& result : plan_.loops[static_cast<std::size_t>(k)].results)
      if (result.is_carried()) place(result.first);
    plan_.steps.push_back({no_value, k});
    state = State::done;
  }

  const Graph& graph_;
  Plan& plan_;
  std::vector<State> state_, loop_state_;
  std::vector<int> given_by_;
};

}  // namespace

Plan straight_plan(const Graph& graph) {
  Plan plan;
  plan.uses = use_counts(graph);
  for (const Port& port : graph.outputs) plan.stored.emplace_back(port.values.size(), false);
  for (Value v = 0; v < graph.size(); ++v) plan.steps.push_back({v, -1});
  return plan;
}

Plan plan_with(const Graph& graph, std::vector<Loop> loops) {
  if (loops.empty()) return straight_plan(graph);
  Plan plan;
  plan.loops = std::move(loops);
  plan.uses.assign(static_cast<std::size_t>(graph.size()), 0);
  for (const Port& port : graph.outputs) plan.stored.emplace_back(port.values.size(), false);
  for (const Loop& loop : plan.loops)
    for (const LoopResult& result : loop.results)
      for (int element : result.elements)
        plan.stored[static_cast<std::size_t>(result.port)][static_cast<std::size_t>(element)] =
            true;
  StepOrder(graph, plan).run();
  return plan;
}

int operation_count(const Graph& graph) {
  int count = 0;
  for (const Node& node : graph.nodes()) count += is_operation(node);
  return count;
}

PlanSize size_of(const Graph& graph, const Plan& plan) {
  PlanSize size;
  std::vector<bool> given(static_cast<std::size_t>(graph.size()), false);
  for (const Loop& loop : plan.loops) {
    const int body = operation_count(loop.body);
    size.written += body;
    size.executed += body * loop.count;
    for (const LoopResult& result : loop.results)
      if (result.is_carried()) given[static_cast<std::size_t>(result.last)] = true;
  }
  for (const Step& step : plan.steps) {
    if (step.loop >= 0 || given[static_cast<std::size_t>(step.value)]) continue;
    size.written += is_operation(graph[step.value]);
    size.executed += is_operation(graph[step.value]);
  }
  return size;
}

}  // namespace sinew
