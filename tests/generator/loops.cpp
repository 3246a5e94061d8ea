// SPDX-License-Identifier: GPL-3.0-or-later
// What repeats is written as a loop: what is found, that its C has the interpreter's bits, and that
// an exchanged table entry is seen.
#include <catch2/catch.hpp>

#include <bit>
#include <regex>
#include <set>

#include "generator/emit_c.h"
#include "generator/evaluate.h"
#include "generator/loops/constant_stores.h"
#include "generator/loops/find_loops.h"
#include "generator/loops/runs.h"
#include "generator/loops/started_sums.h"
#include "generator/write.h"
#include "tests/generator/evaluate_plan.h"
#include "tests/generator/every_operation.h"
#include "tests/reference/emitted_model.h"

using namespace sinew;

namespace {

/// |p_i(q) + load_i|: lengths of strands to points that differ; and the moments of the loads.
/// Strand 4 has one term less, as one in the middle of a hand has.
Graph strands(int count, bool with_sums) {
  Graph graph;
  graph.name = "strands";
  graph.inputs = {{"q", 2, 1, "", "", std::vector<Range>(2, {-1.0, 1.0}), {}},
                  {"f",
                   count,
                   1,
                   "",
                   "",
                   std::vector<Range>(static_cast<std::size_t>(count), {-3.0, 3.0}),
                   {}}};
  const Value x = graph.make(Op::sine, graph.input(0)), y = graph.make(Op::cosine, graph.input(0));
  Value sum = no_value, sum_of_squares = no_value;
  std::vector<Value> lengths;
  for (int i = 0; i < count; ++i) {
    const Value scaled = i == 4 ? x : graph.make(Op::multiply, graph.constant(0.1 * (i + 1)), x);
    const Value a = graph.make(Op::add, y, scaled);
    const Value b = graph.make(Op::subtract, graph.constant(2.0 - 0.3 * i), graph.input(1));
    const Value length = graph.make(
        Op::square_root,
        graph.make(Op::add, graph.make(Op::multiply, a, a), graph.make(Op::multiply, b, b)));
    graph.set_label(length, "length_" + std::to_string(i));
    lengths.push_back(length);
    if (!with_sums) continue;
    const Value term = graph.make(Op::multiply, graph.input(2 + i), length);
    sum = i == 0 ? term : graph.make(Op::add, sum, term);
    const Value square = graph.make(Op::multiply, term, length);
    sum_of_squares = i == 0 ? square : graph.make(Op::subtract, sum_of_squares, square);
  }
  if (with_sums) {
    graph.outputs = {{"moment", 2, 1, "", "", {}, {sum, sum_of_squares}}};
  } else {
    graph.outputs = {{"lengths", count, 1, "", "", {}, lengths}};
  }
  return graph;
}

/// Newton's iteration for the square root: each step is computed from the one before.
Graph newton(int steps) {
  Graph graph;
  graph.name = "newton";
  graph.inputs = {{"a", 1, 1, "", "", {{1.0, 9.0}}, {}}};
  Value x = graph.make(Op::multiply, graph.constant(0.5), graph.input(0));
  for (int i = 0; i < steps; ++i) {
    const Value square = graph.make(Op::multiply, x, x);
    const Value gap = graph.make(Op::subtract, square, graph.input(0));
    const Value slope = graph.make(Op::multiply, graph.constant(4.0), square);  // squared
    const Value step = graph.make(Op::divide, gap, graph.make(Op::square_root, slope));
    x = graph.make(Op::subtract, x, step);
  }
  graph.outputs = {{"root", 1, 1, "", "", {}, {x}}};
  return graph;
}

/// Lengths in four layers, on either side of each; some of them in a product and a quotient, too.
Graph layers(int count) {
  Graph graph;
  graph.name = "layers";
  graph.inputs = {{"q", 2, 1, "", "", std::vector<Range>(2, {-1.0, 1.0}), {}}};
  const Value x = graph.make(Op::sine, graph.input(0)), y = graph.make(Op::cosine, graph.input(1));
  std::vector<Value> layer;
  for (const double height : {2.0, 3.0, 5.0, 7.0})
    layer.push_back(graph.make(Op::square_root, graph.make(Op::add, graph.constant(height), y)));
  std::vector<Value> lengths;
  for (int i = 0; i < count; ++i) {
    const Value aside = graph.make(Op::multiply, graph.constant(0.1 * (i + 1)), x);
    const Op op = i % 3 == 0 ? Op::subtract : Op::add;
    const Value place = graph.make(op, layer[static_cast<std::size_t>(i * 3 % 4)], aside);
    lengths.push_back(graph.make(Op::square_root, graph.make(Op::multiply, place, place)));
  }
  const Value pair = graph.make(Op::multiply, lengths[1], lengths[2]);
  const Value quotient = graph.make(Op::divide, lengths[5], lengths[3]);
  graph.outputs = {{"all", count, 1, "", "", {}, lengths},
                   {"few", 2, 1, "", "", {}, {pair, quotient}}};
  return graph;
}

std::vector<Graph> samples() {
  return {strands(12, false), strands(12, true), newton(9), layers(10)};
}

/// Loops wherever they make the C shorter.
constexpr LoopLimits generous{12, 2.0, 128};

int leaves_of(const Plan& plan, LoopLeaf::Kind kind) {
  int count = 0;
  for (const Loop& loop : plan.loops)
    for (const LoopLeaf& leaf : loop.leaves) count += leaf.kind == kind;
  return count;
}

template <class Real>
std::vector<std::uint64_t> bits_of(const std::vector<Real>& values) {
  std::vector<std::uint64_t> bits;
  for (Real value : values)
    bits.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(value)));
  return bits;
}

EmittedModel model_of(const std::vector<Graph>& graphs, Scalar scalar) {
  EmittedModel model{"sample", "A sample.", std::string(64, '0'),
                     {},       graphs,      {scalar, false, Optimise::size}};
  return model;
}

/// States at which the compiled C has not the interpreter's bits.
template <class Real>
int differing(const Graph& graph, const FileSet& files) {
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", files);
  const reference::EmittedModel compiled(place.path() / "sample");
  int count = 0;
  for (const std::vector<double>& state : states_of(graph, 100, 3)) {
    const std::vector<Real> inputs(state.begin(), state.end());
    count += bits_of(evaluate<Real>(graph, inputs)) != bits_of(compiled.call(graph.name, state));
  }
  return count;
}

/// States at which the plan has not the graph's bits.
int differing(const Graph& graph, const Plan& plan) {
  int count = 0;
  for (const std::vector<double>& state : states_of(graph, 20, 4))
    count += bits_of(evaluate(graph, state)) != bits_of(evaluate_plan(graph, plan, state));
  return count;
}

std::vector<int> passes_of(const Plan& plan) {
  std::vector<int> passes;
  for (const Loop& loop : plan.loops) passes.push_back(loop.count);
  return passes;
}

}  // namespace

TEST_CASE("runs are the longest repetitions from each place on") {
  const auto text = [](const std::vector<std::uint64_t>& keys) {
    std::string all;
    for (const Repetition& run : runs_of(keys))
      all += std::to_string(run.start) + "+" + std::to_string(run.count) + "x" +
             std::to_string(run.period) + " ";
    return all;
  };
  CHECK(text({}) == "");
  CHECK(text({7, 7}) == "");
  CHECK(text({7, 7, 7}) == "0+3x1 ");
  CHECK(text({1, 2, 1, 2, 1, 2, 1, 5}) == "0+3x2 ");
  CHECK(text({9, 1, 2, 2, 1, 2, 2, 1, 2, 2, 4, 3, 3, 3, 3}) == "1+3x3 11+4x1 ");
}

TEST_CASE("strands of one form are one loop, a factor 1 included") {
  const Plan plan = plan_loops(strands(12, false), generous);
  CHECK(passes_of(plan) == std::vector<int>{12});
  CHECK(plan.loops[0].body.label(plan.loops[0].body.outputs[0].values[0]) == "length");
  // Two tables of constants; y, x and q[1] are the same in all passes.
  CHECK(leaves_of(plan, LoopLeaf::Kind::constant) == 2);
  CHECK(leaves_of(plan, LoopLeaf::Kind::shared) == 3);
}

TEST_CASE("sums over the same strands are one loop that carries both") {
  const Plan plan = plan_loops(strands(12, true), generous);
  // The first strand starts the sums.
  CHECK(passes_of(plan) == std::vector<int>{11});
  for (const Loop& loop : plan.loops) CHECK(loop.results.size() == 2);
}

TEST_CASE("steps of an iteration are one loop that carries the iterate") {
  const Plan plan = plan_loops(newton(9), generous);
  CHECK(passes_of(plan) == std::vector<int>{9});
  CHECK(operation_count(plan.loops[0].body) == 6);
  CHECK(plan.loops[0].results.size() == 1);
}

TEST_CASE(
    "a loop chooses between a few values, takes signs from its table and keeps what is needed") {
  const Plan plan = plan_loops(layers(10), generous);
  CHECK(passes_of(plan) == std::vector<int>{10});
  CHECK(leaves_of(plan, LoopLeaf::Kind::chosen) == 1);
  CHECK(leaves_of(plan, LoopLeaf::Kind::constant) == 1);
  CHECK(plan.loops[0].results.size() == 2);
  CHECK(plan.loops[0].results[1].is_kept());
}

TEST_CASE("a loop must save enough, and may not cost much") {
  const Graph graph = strands(12, false);
  CHECK(plan_loops(graph, {1000, 2.0, 128}).loops.empty());
  CHECK(plan_loops(graph, {12, 0.5, 128}).loops.empty());
  CHECK(plan_loops(layers(10), {12, 2.0, 3}).loops.empty());
  const PlanSize straight = size_of(graph, straight_plan(graph));
  const PlanSize planned = size_of(graph, plan_loops(graph, generous));
  CHECK(planned.written < straight.written / 2);
  CHECK(planned.executed <= generous.growth * straight.executed);
}

TEST_CASE("a plan has the graph's bits") {
  for (const Graph& graph : samples()) {
    const Plan plan = plan_loops(graph, generous);
    REQUIRE(!plan.loops.empty());
    CHECK(differing(graph, plan) == 0);
  }
}

namespace {

/// A matrix of 12 rows and 10 columns with the same zeros in the rows, but for one.
Graph mostly_zero() {
  Graph graph;
  graph.name = "mostly_zero";
  graph.inputs = {{"q", 12, 1, "", "", std::vector<Range>(12, {-1.0, 1.0}), {}}};
  std::vector<Value> values;
  for (int row = 0; row < 12; ++row)
    for (int col = 0; col < 10; ++col)
      values.push_back(col == 3 || (row == 5 && col == 7) ? graph.make(Op::sine, graph.input(row))
                                                          : graph.constant(col == 9 ? 2.0 : 0.0));
  graph.outputs = {{"M", 12, 10, "", "", {}, values}};
  return graph;
}

/// The sum of strands' moments on either side, so that a term's constant factor has either sign.
/// `height` makes what the strands have in common.
template <class Height>
Graph moments(int count, const Height& height) {
  Graph graph;
  graph.name = "moments";
  graph.inputs = {{"q", 2, 1, "", "", std::vector<Range>(2, {-1.0, 1.0}), {}},
                  {"f",
                   count,
                   1,
                   "",
                   "",
                   std::vector<Range>(static_cast<std::size_t>(count), {-3.0, 3.0}),
                   {}}};
  const Value x = graph.make(Op::sine, graph.input(0)), y = height(graph);
  Value sum = no_value;
  for (int i = 0; i < count; ++i) {
    const Value place =
        graph.make(Op::add, y, graph.make(Op::multiply, graph.constant(0.3 * (i + 1)), x));
    const Value share =
        graph.make(Op::divide, graph.input(2 + i),
                   graph.make(Op::square_root, graph.make(Op::multiply, place, place)));
    const Value weight = graph.make(Op::multiply, graph.constant(0.01 * (count - i)), share);
    const Value term = graph.make(Op::multiply, place, weight);
    sum = i == 0 ? term : graph.make(i < count / 2 ? Op::add : Op::subtract, sum, term);
  }
  graph.outputs = {{"moment", 1, 1, "", "", {}, {sum}}};
  return graph;
}

Value cosine_of_second(Graph& graph) {
  return graph.make(Op::cosine, graph.input(1));
}

/// Twelve intermediates; a loop needs the last of them, and what follows from all of them is needed
/// after it.
Graph much_beside_a_loop() {
  std::vector<Value> intermediates;
  Graph graph = moments(14, [&](Graph& made) {
    Value chain = made.input(0);
    for (int i = 0; i < 12; ++i) {
      chain = made.make(Op::multiply, made.make(Op::add, chain, made.input(1)), chain);
      intermediates.push_back(chain);
    }
    return chain;
  });
  graph.name = "much_beside_a_loop";
  Value all = intermediates.front();
  for (const Value each : intermediates) all = graph.make(Op::add, graph.make(Op::sine, all), each);
  Value& moment = graph.outputs[0].values[0];
  moment = graph.make(Op::multiply, moment, all);
  return graph;
}

/// The most values that wait while a loop runs.
int waiting(const Graph& graph, const Plan& plan) {
  std::set<Value> done;
  std::size_t last = 0;
  for (std::size_t i = 0; i < plan.steps.size(); ++i)
    if (plan.steps[i].loop >= 0) last = i;
  for (std::size_t i = 0; i < last; ++i)
    if (plan.steps[i].loop < 0) done.insert(plan.steps[i].value);
  std::set<Value> wait;
  for (std::size_t i = last; i < plan.steps.size(); ++i) {
    const Value v = plan.steps[i].value;
    for (int k = 0; v != no_value && k < arity(graph[v].op); ++k)
      if (done.count(graph[v].operand(k)) && arity(graph[graph[v].operand(k)].op) > 0)
        wait.insert(graph[v].operand(k));
  }
  return static_cast<int>(wait.size());
}

}  // namespace

TEST_CASE("a long sum's first term is a pass of its loop, too") {
  const Graph graph = moments(14, cosine_of_second);
  const PlannedGraph planned = plan_graph(graph, generous);
  CHECK(passes_of(planned.plan) == std::vector<int>{14});
  for (const std::vector<double>& state : states_of(graph, 20, 4))
    CHECK(bits_of(evaluate(graph, state)) ==
          bits_of(evaluate_plan(planned.graph, planned.plan, state)));
}

// Begun at 0.0 instead, -0.0 became 0.0: planted, seen red.
TEST_CASE("a sum that is begun keeps the sign of a zero") {
  Graph graph;
  graph.name = "zeros";
  graph.inputs = {{"q", 12, 1, "", "", std::vector<Range>(12, {-1.0, 1.0}), {}}};
  Value sum = no_value;
  for (int i = 0; i < 12; ++i) {
    const Value term = graph.make(Op::multiply, graph.constant(1.0 + i), graph.input(i));
    sum = i == 0 ? term : graph.make(Op::add, sum, term);
  }
  graph.outputs = {{"sum", 1, 1, "", "", {}, {sum}}};
  const Graph started = with_started_sums(graph);
  REQUIRE(started.size() > graph.size());
  const std::vector<double> zeros(12, -0.0);
  CHECK(bits_of(evaluate(started, zeros)) == bits_of(evaluate(graph, zeros)));
}

TEST_CASE("rows with the same constants are stored by a loop, the row that differs beside it") {
  const Graph graph = mostly_zero();
  const Plan plan = plan_loops(graph, generous);
  REQUIRE(plan.loops.size() == 1);
  CHECK(plan.loops[0].count == 12);
  CHECK(plan.loops[0].results.size() == 8);
  CHECK(differing(graph, plan) == 0);
  CHECK(differing<double>(graph, emit_files(model_of({graph}, Scalar::binary64))) == 0);
}

/// Blocks on the diagonal, as the fingers of a hand have: 4 of 3 rows and 2 columns.
Graph blocks() {
  Graph graph;
  graph.name = "blocks";
  graph.inputs = {{"q", 12, 1, "", "", std::vector<Range>(12, {-1.0, 1.0}), {}}};
  std::vector<Value> values;
  for (int row = 0; row < 12; ++row)
    for (int col = 0; col < 8; ++col)
      values.push_back(col / 2 == row / 3 ? graph.make(Op::sine, graph.input(row))
                                          : graph.constant(0.0));
  graph.outputs = {{"M", 12, 8, "", "", {}, values}};
  return graph;
}

// Planted: a loop's constants stored beside it, too, and one loop alone for all rows, seen red
// here.
TEST_CASE("blocks of zeros are loops, those that save most") {
  const Graph graph = blocks();
  const std::vector<Loop> loops = loops_of_constants(graph, straight_plan(graph));
  // Columns 4 to 7 of the upper half and 0 to 3 of the lower; two by three are not worth a loop.
  REQUIRE(loops.size() == 2);
  for (const Loop& loop : loops) {
    CHECK(loop.count == 6);
    CHECK(loop.results.size() == 4);
  }
  const Plan plan = plan_with(graph, loops);
  CHECK(differing(graph, plan) == 0);
}

TEST_CASE("a sign that changes within a sum goes into a table, not into an operation") {
  const Graph graph = moments(14, cosine_of_second);
  const Plan plan = plan_loops(graph, generous);
  REQUIRE(passes_of(plan) == std::vector<int>{13});
  CHECK(operation_count(plan.loops[0].body) == 8);
  CHECK(differing(graph, plan) == 0);
}

TEST_CASE("what waits for a loop to end is as little as possible") {
  const Graph graph = much_beside_a_loop();
  const Plan plan = plan_loops(graph, generous);
  REQUIRE(plan.loops.size() == 1);
  // Their result, and not they themselves.
  CHECK(waiting(graph, plan) == 1);
  CHECK(differing(graph, plan) == 0);
}

// Planted: entries 0 and 1 of one table of constants, places or elements exchanged. All 20 states
// differ.
TEST_CASE("planted: exchanged entries of a loop's table are found") {
  for (const Graph& graph : samples()) {
    Plan plan = plan_loops(graph, generous);
    for (LoopLeaf& leaf : plan.loops[0].leaves) {
      if (leaf.kind != LoopLeaf::Kind::constant) continue;
      std::swap(leaf.constants[0], leaf.constants[1]);
      CHECK(differing(graph, plan) > 0);
      std::swap(leaf.constants[0], leaf.constants[1]);
    }
    for (LoopLeaf& leaf : plan.loops[0].leaves) {
      if (leaf.kind != LoopLeaf::Kind::chosen) continue;
      std::swap(leaf.places[0], leaf.places[1]);
      CHECK(differing(graph, plan) > 0);
      std::swap(leaf.places[0], leaf.places[1]);
    }
    for (LoopResult& result : plan.loops[0].results) {
      if (result.elements.empty()) continue;
      std::swap(result.elements[0], result.elements[1]);
      CHECK(differing(graph, plan) > 0);
      std::swap(result.elements[0], result.elements[1]);
    }
    CHECK(differing(graph, plan) == 0);
  }
}

TEST_CASE("C with loops has the interpreter's bits") {
  for (const Graph& graph : samples()) {
    INFO(graph.outputs[0].name);
    const FileSet files = emit_files(model_of({graph}, Scalar::binary64));
    CHECK(files.at("sample.c").find("for (int ") != std::string::npos);
    CHECK(differing<double>(graph, files) == 0);
    CHECK(differing<float>(graph, emit_files(model_of({graph}, Scalar::binary32))) == 0);
  }
}

// Planted: the first two rows of a table exchanged in the C. All 100 states differ.
TEST_CASE("planted: exchanged rows of a table in the C are found") {
  for (const Graph& graph : {strands(12, false), strands(12, true)}) {
    FileSet files = emit_files(model_of({graph}, Scalar::binary64));
    std::string& text = files.at("sample.c");
    const std::string exchanged = std::regex_replace(
        text, std::regex(R"((table\d+\[\d+\]\[\d+\] = \{)(\{[^}]*\}),\s+(\{[^}]*\}))"), "$1$3, $2");
    REQUIRE(exchanged != text);
    text = exchanged;
    CHECK(differing<double>(graph, files) > 0);
  }
}
