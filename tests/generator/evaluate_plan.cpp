// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generator/evaluate_plan.h"

#include <cmath>

#include "generator/evaluate.h"

namespace sinew {
namespace {

class PlanRun {
 public:
  PlanRun(const Graph& graph, const Plan& plan, const std::vector<double>& inputs)
      : graph_(graph),
        plan_(plan),
        inputs_(inputs),
        values_(static_cast<std::size_t>(graph.size()), std::nan("")),
        given_(static_cast<std::size_t>(graph.size()), false) {
    for (const Port& port : graph.outputs)
      results_.emplace_back(static_cast<std::size_t>(port.size()), std::nan(""));
  }

  std::vector<double> run() {
    for (const Step& step : plan_.steps)
      if (step.loop >= 0)
        run_loop(plan_.loops[static_cast<std::size_t>(step.loop)]);
      else
        compute(step.value);
    std::vector<double> all;
    for (std::size_t p = 0; p < results_.size(); ++p)
      for (std::size_t i = 0; i < results_[p].size(); ++i)
        all.push_back(plan_.stored[p][i] ? results_[p][i] : at(graph_.outputs[p].values[i]));
    return all;
  }

 private:
  double& at(Value v) { return values_[static_cast<std::size_t>(v)]; }
  double operand(Value v) { return v == no_value ? 0.0 : at(v); }

  void compute(Value v) {
    if (given_[static_cast<std::size_t>(v)]) return;
    const Node& node = graph_[v];
    at(v) = node.op == Op::input
                ? inputs_[static_cast<std::size_t>(node.index)]
                : apply<double>(node, operand(node.a), operand(node.b), operand(node.c));
  }

  void give(Value v, double value) {
    at(v) = value;
    given_[static_cast<std::size_t>(v)] = true;
  }

  void run_loop(const Loop& loop) {
    std::vector<double> carried;
    for (const LoopResult& result : loop.results)
      carried.push_back(result.is_carried() ? at(result.first) : 0.0);
    for (std::size_t pass = 0; pass < static_cast<std::size_t>(loop.count); ++pass) {
      std::vector<double> leaves;
      for (const LoopLeaf& leaf : loop.leaves) leaves.push_back(leaf_in_pass(leaf, pass, carried));
      carried = evaluate(loop.body, leaves);
      for (std::size_t k = 0; k < loop.results.size(); ++k)
        if (const LoopResult& result = loop.results[k]; result.is_kept())
          give(result.kept[pass], carried[k]);
        else if (!result.is_carried())
          results_[static_cast<std::size_t>(result.port)]
                  [static_cast<std::size_t>(result.elements[pass])] = carried[k];
    }
    for (std::size_t k = 0; k < loop.results.size(); ++k) {
      if (!loop.results[k].is_carried()) continue;
      give(loop.results[k].last, carried[k]);
    }
  }

  double leaf_in_pass(const LoopLeaf& leaf, std::size_t pass, const std::vector<double>& carried) {
    switch (leaf.kind) {
      case LoopLeaf::Kind::shared:
        return at(leaf.value);
      case LoopLeaf::Kind::chosen:
        return at(leaf.choices[static_cast<std::size_t>(leaf.places[pass])]);
      case LoopLeaf::Kind::kept:
        return at(leaf.choices[pass]);
      case LoopLeaf::Kind::constant:
        return leaf.constants[pass];
      case LoopLeaf::Kind::input:
        return inputs_[static_cast<std::size_t>(leaf.inputs[pass])];
      case LoopLeaf::Kind::carried:
        return carried[static_cast<std::size_t>(leaf.result)];
    }
    return std::nan("");
  }

  const Graph& graph_;
  const Plan& plan_;
  const std::vector<double>& inputs_;
  std::vector<double> values_;
  std::vector<bool> given_;
  std::vector<std::vector<double>> results_;
};

}  // namespace

std::vector<double> evaluate_plan(const Graph& graph, const Plan& plan,
                                  const std::vector<double>& inputs) {
  return PlanRun(graph, plan, inputs).run();
}

}  // namespace sinew
