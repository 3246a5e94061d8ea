// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generator/pass_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "generator/error_bound.h"
#include "generator/passes/chains.h"
#include "generator/write.h"
#include "tests/reference/emitted_model.h"

namespace sinew {
namespace {

std::vector<Exact> exact_results(const Graph& graph, const std::vector<double>& state) {
  return evaluate<Exact>(graph, {state.begin(), state.end()});
}

/// The largest number of constants in one sum or product.
int longest_chain_of_constants(const Graph& graph) {
  const std::vector<int> uses = use_counts(graph);
  int most = 0;
  for (Value v = 0; v < graph.size(); ++v) {
    int count = 0;
    if (is_sum(graph[v]))
      for (const Term& term : terms_of(graph, uses, v)) count += graph.is_constant(term.value);
    if (graph[v].op == Op::multiply)
      for (Value factor : factors_of(graph, uses, v)) count += graph.is_constant(factor);
    most = std::max(most, count);
  }
  return most;
}

/// What a pass may do to the constants of the graph it is given.
Rounding rounding_of(const std::string& pass, const Graph& before) {
  Rounding rounding;
  if (pass == "fold_constants") rounding.folded = double_rounding.function;
  if (pass == "distribute_constants" || pass == "reduce_strength") rounding.constant = 0x1p-53;
  if (pass == "combine_constants")
    rounding.constant = std::max(0, longest_chain_of_constants(before) - 1) * 0x1p-53;
  return rounding;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

template <class Real>
void compare(const std::vector<Real>& before, const std::vector<Real>& after,
             const std::vector<double>& limits, const std::string& what,
             std::vector<std::string>& found) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double off = static_cast<double>(Real(after[i] - before[i]));
    if (!(std::abs(off) <= limits[i]))
      found.push_back(fmt::format("{}: result {} is {:.3g} off its {:.3g}; {:.3g} is explained",
                                  what, i, off, static_cast<double>(before[i]), limits[i]));
  }
}

void compare_at(const std::vector<Stage>& stages, const std::vector<double>& state,
                std::vector<std::string>& found) {
  const Graph& first = stages.front().graph;
  const std::vector<Exact> exact_first = exact_results(first, state);
  const std::vector<double> double_first = evaluate<double>(first, state);
  const std::vector<double> double_bound = error_bounds(first, state, double_rounding);
  std::vector<Exact> exact_before = exact_first;
  std::vector<double> exact_bound = error_bounds(first, state, exact_rounding);
  std::vector<double> constants(exact_first.size(), 0.0), limit_to_first = exact_bound;
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const Graph &before = stages[k - 1].graph, &graph = stages[k].graph;
    const std::string what = fmt::format("{} after {}", graph.name, stages[k].pass);
    const std::vector<double> rounded =
        error_bounds(before, state, rounding_of(stages[k].pass, before));
    const std::vector<double> bound = error_bounds(graph, state, exact_rounding);
    const std::vector<Exact> exact = exact_results(graph, state);
    compare(exact_before, exact, sum(sum(exact_bound, bound), rounded), what + ", 50 digits",
            found);
    constants = sum(constants, rounded);
    limit_to_first = sum(sum(limit_to_first, bound), rounded);
    compare(exact_first, exact, limit_to_first, what + ", 50 digits, all passes", found);
    compare(double_first, evaluate<double>(graph, state),
            sum(sum(double_bound, error_bounds(graph, state, double_rounding)), constants),
            what + ", double", found);
    exact_before = exact;
    exact_bound = bound;
  }
}

template <class Real>
bool same_bits(Real a, Real b) {
  using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <class Real>
void compare_bits(const Stage& stage, const std::string& function,
                  const reference::EmittedModel& model, const States& states,
                  std::vector<std::string>& found) {
  for (const std::vector<double>& state : states) {
    const std::vector<Real> inputs(state.begin(), state.end());
    const std::vector<Real> expected = evaluate<Real>(stage.graph, inputs);
    const std::vector<double> compiled = model.call(function, state);
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (!same_bits(expected[i], static_cast<Real>(compiled[i])))
        found.push_back(fmt::format("{}: result {}: the interpreter says {}, the C {}", function, i,
                                    expected[i], compiled[i]));
  }
}

}  // namespace

std::vector<Stage> stages_of(const Graph& graph, const std::vector<Pass>& passes) {
  std::vector<Stage> stages{{"lower", graph}};
  for (const Pass& pass : passes) stages.push_back({pass.name, pass.run(stages.back().graph)});
  return stages;
}

std::vector<std::string> disagreements(const std::vector<Stage>& stages, const States& states) {
  std::vector<std::string> found;
  for (const std::vector<double>& state : states) compare_at(stages, state, found);
  return found;
}

std::vector<std::string> bit_differences(const std::vector<Stage>& interpreted,
                                         const std::vector<Stage>& compiled, const States& states,
                                         Scalar scalar) {
  EmittedModel model{"stages", "Graphs between passes.", std::string(64, '0'), {}, {}, {scalar}};
  for (std::size_t k = 0; k < compiled.size(); ++k) {
    model.functions.push_back(compiled[k].graph);
    model.functions.back().name =
        fmt::format("{}_{}_{}", compiled[k].graph.name, k, compiled[k].pass);
  }
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "stages", emit_files(model));
  const reference::EmittedModel loaded(
      place.path() / "stages", {"cc",
                                {"-std=c11", "-O1", "-ffp-contract=off", "-fno-math-errno", "-Wall",
                                 "-Werror", "-Wno-unused-variable"}});
  std::vector<std::string> found;
  for (std::size_t k = 0; k < compiled.size(); ++k) {
    const std::string& name = model.functions[k].name;
    scalar == Scalar::binary64 ? compare_bits<double>(interpreted[k], name, loaded, states, found)
                               : compare_bits<float>(interpreted[k], name, loaded, states, found);
  }
  return found;
}

std::vector<std::string> bit_differences(const std::vector<Stage>& stages, const States& states,
                                         Scalar scalar) {
  return bit_differences(stages, stages, states, scalar);
}

}  // namespace sinew
