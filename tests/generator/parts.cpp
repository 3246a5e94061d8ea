// SPDX-License-Identifier: GPL-3.0-or-later
// What functions compute alike at several places is one part that they call.
#include <catch2/catch.hpp>

#include <bit>

#include "generator/calls/find_parts.h"
#include "generator/calls/part.h"
#include "generator/calls/part_cut.h"
#include "generator/calls/places.h"
#include "generator/emit_c.h"
#include "generator/evaluate.h"
#include "generator/write.h"
#include "tests/generator/every_operation.h"
#include "tests/reference/emitted_model.h"

using namespace sinew;

namespace {

/// Terms of a sum that no loop takes in: each has another form than the one before.
constexpr int terms = 14;

Port numbers(const std::string& name, int size) {
  return {name, size, 1, "", "", std::vector<Range>(static_cast<std::size_t>(size), {0.2, 1.0}),
          {}};
}

/// Two results of an angle and of q[1]: a long sum, and the sine.
std::pair<Value, Value> long_sum(Graph& graph, Value angle) {
  const Value s = graph.make(Op::sine, angle), c = graph.make(Op::cosine, angle);
  Value sum = graph.make(Op::multiply, s, graph.input(1));
  for (int i = 0; i < terms; ++i) {
    const Value factor = graph.make(Op::add, i % 2 ? s : c, graph.constant(1.25 + i));
    sum = graph.make(Op::subtract, graph.make(Op::multiply, sum, factor), i % 3 ? c : s);
  }
  return {graph.make(Op::square_root, graph.make(Op::multiply, sum, sum)), s};
}

Graph named(const std::string& name) {
  Graph graph;
  graph.name = name;
  graph.inputs = {numbers("q", 2)};
  return graph;
}

/// Goes from q[0] to another angle, as a search does, and again; the last with a factor.
Graph search(int steps) {
  Graph graph = named("search");
  Value angle = graph.input(0), sine = no_value;
  for (int step = 0; step < steps; ++step) {
    const auto [sum, s] = long_sum(graph, angle);
    angle = graph.make(Op::divide, sum, graph.make(Op::add, graph.constant(3.0), sum));
    sine = s;
  }
  const Value scaled = graph.make(Op::multiply, graph.constant(0.5), sine);
  graph.outputs = {{"found", 2, 1, "", "", {}, {angle, scaled}}};
  return graph;
}

/// The sum at q[0] alone, with the other sign.
Graph once() {
  Graph graph = named("once");
  graph.outputs = {
      {"sum", 1, 1, "", "", {}, {graph.make(Op::negate, long_sum(graph, graph.input(0)).first)}}};
  return graph;
}

struct Found {
  std::vector<CallingFunction> functions, parts;
};

Found parts_of(const std::vector<Graph>& graphs, const LoopLimits& limits = {24, 1.3, 128}) {
  Found found;
  for (const Graph& graph : graphs) found.functions.push_back({{}, graph});
  found.parts = find_parts(found.functions, limits);
  return found;
}

EmittedModel model_of_parts(const std::vector<Graph>& graphs) {
  return {"sample", "A sample.", std::string(64, '0'),
          {},       graphs,      {Scalar::binary64, false, Optimise::size}};
}

int states_apart(const Graph& graph, const FileSet& files) {
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", files);
  const reference::EmittedModel compiled(place.path() / "sample");
  int count = 0;
  for (const std::vector<double>& state : states_of(graph, 100, 3)) {
    const std::vector<double> expected = evaluate(graph, state),
                              got = compiled.call(graph.name, state);
    for (std::size_t i = 0; i < expected.size(); ++i)
      count += std::bit_cast<std::uint64_t>(expected[i]) != std::bit_cast<std::uint64_t>(got[i]);
  }
  return count;
}

}  // namespace

TEST_CASE("what a search computes at several places is one part, and another function calls it") {
  const Found found = parts_of({once(), search(3)});
  REQUIRE(found.parts.size() == 1);
  const Graph& part = found.parts[0].rest;
  REQUIRE(part.inputs.size() == 2);
  CHECK(part.inputs[0].name == "q");
  CHECK(part.inputs[1].by_value);
  REQUIRE(found.functions[1].calls.size() == 3);
  CHECK(found.functions[0].calls.size() == 1);
  CHECK(found.functions[1].calls[0].arguments == std::vector<std::string>{"q"});
  // A quotient and a sum for each step, and the factor of the sine.
  CHECK(operation_count(found.functions[1].rest) == 3 * 2 + 1);
  CHECK(operation_count(found.functions[0].rest) == 1);
}

// Planted: results given with their factors, seen red here.
TEST_CASE("a factor of what a part gives stays with the caller") {
  Graph step = search(1);
  step.name = "step";
  const Found found = parts_of({step, search(3)});
  REQUIRE(!found.parts.empty());
  const Graph& part = found.parts[0].rest;
  for (Value v : part.results()) CHECK(part[v].op != Op::multiply);
}

TEST_CASE("no part where little is saved, it is dear, or its results have no room") {
  CHECK(parts_of({once(), search(1)}, {1000, 1.3, 128}).parts.empty());
  CHECK(parts_of({once(), search(3)}, {24, 1.01, 128}).parts.empty());
  CHECK(parts_of({once(), search(3)}, {24, 1.3, 0}).parts.empty());
  CHECK(parts_of({search(1)}).parts.empty());
}

// Planted: one angle passed at all places, seen red here and above.
TEST_CASE("C with parts has the interpreter's bits") {
  const FileSet files = emit_files(model_of_parts({once(), search(3)}));
  const std::string& c = files.at("sample.c");
  CHECK(c.find("SINEW_NOT_INLINE static void sample_part_1(const double q[SINEW_AT_LEAST(2)],") !=
        std::string::npos);
  CHECK(c.find("    sample_part_1(q, ") != std::string::npos);
  CHECK(states_apart(once(), files) == 0);
  CHECK(states_apart(search(3), files) == 0);
}

// Planted: constants taken for equal whatever their value, seen red here.
TEST_CASE("an image is the same operation on the same operands, or there is none") {
  Graph graph = named("one");
  const Value sine = graph.make(Op::sine, graph.input(0));
  const Value product = graph.make(Op::multiply, sine, graph.constant(2.0));
  const Value sum = graph.make(Op::add, product, graph.input(1));
  graph.outputs = {{"sum", 1, 1, "", "", {}, {sum}}};
  Graph other = named("other");
  const Value there = other.make(Op::sine, other.input(1));
  const Value twice = other.make(Op::multiply, other.constant(2.0), there);
  const Value thrice = other.make(Op::multiply, other.constant(3.0), there);
  other.outputs = {{"both", 2, 1, "", "", {}, {twice, thrice}}};
  const std::vector<Value> image =
      images({{}, graph}, {graph.input(0)}, {{}, other}, {other.input(1)});
  CHECK(image[static_cast<std::size_t>(sine)] == there);
  CHECK(image[static_cast<std::size_t>(product)] == twice);
  CHECK(image[static_cast<std::size_t>(sum)] == no_value);
}

// Planted: the cost of passing left out, seen red here.
TEST_CASE("a part ends where passing its results costs less than it saves") {
  Graph graph = named("chain");
  const Value a = graph.make(Op::sine, graph.input(0));
  const Value b = graph.make(Op::multiply, a, a);
  const Value c = graph.make(Op::add, b, graph.constant(1.0));
  graph.outputs = {{"c", 1, 1, "", "", {}, {c, b}}};
  const auto values = [&](double last) {
    PartValues part;
    for (Value v = 0; v < graph.size(); ++v) {
      part.may.push_back(arity(graph[v].op) > 0);
      part.beside.push_back(v == b || v == c);
      part.gain.push_back(v == c ? last : 10.0);
      part.cost.push_back(3.0);
    }
    return part;
  };
  const std::vector<bool> whole = cut_part(graph, values(4.0));
  CHECK(whole[static_cast<std::size_t>(c)]);
  const std::vector<bool> shorter = cut_part(graph, values(2.0));
  CHECK(shorter[static_cast<std::size_t>(b)]);
  CHECK_FALSE(shorter[static_cast<std::size_t>(c)]);
}

// With the check left out of PartCaller::need() this was seen not to end.
TEST_CASE("nothing is passed that needs what the call gives") {
  const Graph graph = search(2);
  const CallingFunction function{{}, graph};
  PartDraft draft{"part_1", &function, {}, {"angle"}, {}, {}};
  // Both steps as one part at the second angle: the first step's sum leads to it.
  PartInstance everywhere{{0, {}}, {}};
  Value second = no_value;
  for (Value v = 0; v < graph.size(); ++v) {
    everywhere.image.push_back(v);
    if (graph[v].op == Op::sine) second = graph[v].a;
  }
  draft.at = {second};
  for (Value v = 0; v < graph.size(); ++v) {
    draft.belongs.push_back(arity(graph[v].op) > 0 && v != second);
    if (graph[v].op == Op::square_root) draft.results.push_back(v);
  }
  CHECK_FALSE(calling(function, draft, {&everywhere}).has_value());
}
