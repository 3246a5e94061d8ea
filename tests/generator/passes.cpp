// SPDX-License-Identifier: GPL-3.0-or-later
// After every pass: interpreter = exact = compiled C; and the check sees passes that are wrong.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "generator/assemble.h"
#include "generator/dump.h"
#include "generator/error_bound.h"
#include "generator/lower.h"
#include "generator/passes/passes.h"
#include "generator/rewrite.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/generator/every_operation.h"
#include "tests/generator/pass_check.h"
#include "tests/reference/random_mechanism.h"

using namespace sinew;

namespace {

std::string first_of(const std::vector<std::string>& findings) {
  return findings.empty() ? "" : findings.front();
}

std::vector<Graph> lowered(const std::vector<Function>& functions) {
  std::vector<Graph> graphs;
  for (const Function& function : functions) graphs.push_back(lower(function));
  return graphs;
}

std::vector<Graph> index_finger() {
  return lowered(functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"), emitted_cost));
}

std::vector<Graph> random_chain() {
  return lowered(functions_of(reference::random_mechanism(20, {.joints = 4, .tendons = 3})));
}

/// Largest error that 50-digit arithmetic explains, relative to the results' scale.
double exact_resolution(const Graph& graph, const States& states) {
  double error = 0.0, scale = 0.0;
  for (const auto& state : states) {
    for (double bound : error_bounds(graph, state, exact_rounding)) error = std::max(error, bound);
    for (double value : evaluate<double>(graph, state)) scale = std::max(scale, std::abs(value));
  }
  return scale > 0.0 ? error / scale : 0.0;
}

void check_values(const std::vector<Graph>& graphs, int count) {
  REQUIRE(!graphs.empty());
  for (const Graph& graph : graphs) {
    INFO(graph.name);
    const States states = states_of(graph, count, 1);
    CHECK(first_of(disagreements(stages_of(graph), states)) == "");
    CHECK(exact_resolution(graph, states) < 1e-45);
  }
}

/// Without the stages whose pass changed nothing: their C is the one before.
std::vector<Stage> distinct(const std::vector<Stage>& stages) {
  std::vector<Stage> kept;
  for (const Stage& stage : stages)
    if (kept.empty() || dump_text(kept.back().graph) != dump_text(stage.graph))
      kept.push_back(stage);
  return kept;
}

void check_bits(const std::vector<Graph>& graphs, int count) {
  for (Scalar scalar : {Scalar::binary64, Scalar::binary32})
    for (const Graph& graph : graphs)
      CHECK(first_of(bit_differences(distinct(stages_of(graph)), states_of(graph, count, 2),
                                     scalar)) == "");
}

/// Findings on the function of every operation where `wrong` runs instead of the whole pipeline.
std::vector<std::string> findings_of(const std::function<Graph(const Graph&)>& wrong) {
  const Graph graph = lower(every_operation());
  return disagreements(stages_of(graph, {{"wrong", wrong}}), states_of(graph, 5, 3));
}

/// A pass that puts `replacement(graph, node)` in a node's place unless that is no_value.
std::function<Graph(const Graph&)> planted(
    const std::function<Value(Graph&, const Node&)>& replacement) {
  return [replacement](const Graph& graph) {
    return rewrite(graph, [&](Graph& to, const Node& node) {
      const Value v = replacement(to, node);
      return v == no_value ? to.add(node) : v;
    });
  };
}

}  // namespace

TEST_CASE("the hand-made function has every operation") {
  const Graph graph = lower(every_operation());
  for (int op = 0; op <= static_cast<int>(Op::choose); ++op) {
    INFO(name_of(static_cast<Op>(op)));
    CHECK(std::any_of(graph.nodes().begin(), graph.nodes().end(),
                      [op](const Node& node) { return node.op == static_cast<Op>(op); }));
  }
}

TEST_CASE("values stay the same after every pass: every operation") {
  check_values({lower(every_operation())}, 20);
}

TEST_CASE("values stay the same after every pass: index finger") {
  check_values(index_finger(), 4);
}

TEST_CASE("values stay the same after every pass: random chain") {
  REQUIRE(random_chain().size() > 8);
  check_values(random_chain(), 3);
}

TEST_CASE("compiled C has the interpreter's bits after every pass: every operation") {
  check_bits({lower(every_operation())}, 1000);
}

TEST_CASE("compiled C has the interpreter's bits after every pass: index finger", "[slow]") {
  check_bits(index_finger(), 60);
}

TEST_CASE("compiled C has the interpreter's bits after every pass: random chain", "[slow]") {
  check_bits(random_chain(), 60);
}

TEST_CASE("planted: a pass that drops signs is found") {
  CHECK(!findings_of(planted([](Graph&, const Node& node) {
           return node.op == Op::negate ? node.a : no_value;
         })).empty());
}

TEST_CASE("planted: a pass that folds two times three to seven is found") {
  const auto wrong = planted([](Graph& to, const Node& node) {
    const bool known = node.op == Op::multiply && to.is_constant(node.a) && to.is_constant(node.b);
    return known ? to.constant(to[node.a].constant * to[node.b].constant + 1.0) : no_value;
  });
  Graph graph;
  graph.name = "product";
  graph.outputs = {{"r", 1, 1, "", "", {}, {}}};
  graph.outputs[0].values = {graph.make(Op::multiply, graph.constant(2.0), graph.constant(3.0))};
  CHECK(evaluate<double>(wrong(graph), {}) == std::vector<double>{7.0});
  CHECK(!disagreements(stages_of(graph, {{"fold_constants", wrong}}), {{}}).empty());
  CHECK(disagreements(stages_of(graph, {{"fold_constants", fold_constants}}), {{}}).empty());
}

TEST_CASE("planted: a pass that swaps the operands of differences is found") {
  CHECK(!findings_of(planted([](Graph& to, const Node& node) {
           return node.op == Op::subtract ? to.make(Op::subtract, node.b, node.a) : no_value;
         })).empty());
}

TEST_CASE("planted: a pass that swaps the cases of a choice is found") {
  CHECK(!findings_of(planted([](Graph& to, const Node& node) {
           return node.op == Op::choose ? to.make(Op::choose, node.a, node.c, node.b) : no_value;
         })).empty());
}

TEST_CASE("planted: constants that lose their last digit are found") {
  const auto shortened = planted([](Graph& to, const Node& node) {
    return node.op == Op::constant ? to.constant(node.constant * (1.0 + 0x1p-52)) : no_value;
  });
  CHECK(!findings_of(shortened).empty());
}

TEST_CASE("planted: C of another graph than the interpreter's is found, down to the last bit") {
  // Dividing and multiplying by the reciprocal differ by one rounding.
  const Graph graph = lower(every_operation());
  const std::vector<Stage> before{{"lower", graph}},
      after{{"lower", share_reciprocals(fold_constants(graph))}};
  const States states = states_of(graph, 200, 4);
  CHECK(bit_differences(before, before, states, Scalar::binary64).empty());
  CHECK(!bit_differences(before, after, states, Scalar::binary64).empty());
  CHECK(!bit_differences(before, after, states, Scalar::binary32).empty());
}
