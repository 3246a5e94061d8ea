// SPDX-License-Identifier: GPL-3.0-or-later
// A function that computes what another one gives calls it.
#include <catch2/catch.hpp>

#include <bit>

#include "generator/calls/chain.h"
#include "generator/calls/find_calls.h"
#include "generator/emit_c.h"
#include "generator/evaluate.h"
#include "generator/write.h"
#include "tests/generator/every_operation.h"
#include "tests/reference/emitted_model.h"

using namespace sinew;

namespace {

constexpr int points = 20;
/// Sines that a function has beside what it calls: so many that a call is not dear.
constexpr int beside = 6;

constexpr LoopLimits generous{24, 2.0, 128};

Port argument(const std::string& name, int size) {
  return {name, size, 1, "", "", std::vector<Range>(static_cast<std::size_t>(size), {0.2, 1.0}),
          {}};
}

/// Distances of points from a place, one negative.
std::vector<Value> distances(Graph& graph) {
  const Value x = graph.make(Op::sine, graph.input(0)), y = graph.make(Op::cosine, graph.input(1));
  std::vector<Value> all;
  for (int i = 0; i < points; ++i) {
    const Value a = graph.make(Op::subtract, x, graph.constant(1.5 + i * i));
    const Value b = graph.make(Op::add, y, graph.make(Op::multiply, graph.constant(0.1 + i), x));
    all.push_back(graph.make(Op::square_root, graph.make(Op::add, graph.make(Op::multiply, a, a),
                                                         graph.make(Op::multiply, b, b))));
  }
  return all;
}

/// Of inputs from `first` on.
Value sum_of_sines(Graph& graph, int first) {
  Value sum = graph.make(Op::sine, graph.input(first));
  for (int i = 1; i < beside; ++i)
    sum = graph.make(Op::add, sum, graph.make(Op::sine, graph.input(first + i)));
  return sum;
}

Graph lengths() {
  Graph graph;
  graph.name = "lengths";
  graph.inputs = {argument("q", 2)};
  std::vector<Value> h = distances(graph);
  h.back() = graph.make(Op::negate, h.back());
  graph.outputs = {{"h", points, 1, "", "", {}, h}};
  return graph;
}

/// Their weighted sum, and something beside.
Graph weighted(const std::string& place) {
  Graph graph;
  graph.name = "weighted";
  graph.inputs = {argument(place, 2), argument("f", points)};
  const std::vector<Value> h = distances(graph);
  Value sum = sum_of_sines(graph, 2);
  for (int i = 0; i < points; ++i)
    sum = graph.make(Op::add, sum,
                     graph.make(Op::multiply, graph.input(2 + i), h[static_cast<std::size_t>(i)]));
  graph.outputs = {{"sum", 1, 1, "", "", {}, {sum}}};
  return graph;
}

EmittedModel model_of(const std::vector<Graph>& graphs) {
  return {"sample", "A sample.", std::string(64, '0'),
          {},       graphs,      {Scalar::binary64, false, Optimise::size}};
}

/// States at which the compiled C of a function has not the interpreter's bits.
int differing(const Graph& graph, const FileSet& files) {
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", files);
  const reference::EmittedModel compiled(place.path() / "sample");
  int count = 0;
  for (const std::vector<double>& state : states_of(graph, 100, 3)) {
    const double expected = evaluate(graph, state)[0], got = compiled.call(graph.name, state)[0];
    count += std::bit_cast<std::uint64_t>(expected) != std::bit_cast<std::uint64_t>(got);
  }
  return count;
}

}  // namespace

TEST_CASE("a function calls the one whose results it computes") {
  const std::vector<CallingFunction> found = find_calls({lengths(), weighted("q")}, generous);
  CHECK(found[0].calls.empty());
  REQUIRE(found[1].calls.size() == 1);
  const Call& call = found[1].calls[0];
  CHECK(call.function == "lengths");
  CHECK(call.arguments == std::vector<std::string>{"q"});
  REQUIRE(call.results.size() == 1);
  CHECK(call.results[0].size() == points);
  // The sines' sum, and a product and a sum each; the last length has the other sign there.
  CHECK(operation_count(found[1].rest) == 2 * beside - 1 + 2 * points + 1);
}

TEST_CASE("no call where the place has another name, little is saved, or it is dear") {
  CHECK(find_calls({lengths(), weighted("p")}, generous)[1].calls.empty());
  LoopLimits limits = generous;
  limits.saving = 100000;
  CHECK(find_calls({lengths(), weighted("q")}, limits)[1].calls.empty());
  limits = generous;
  limits.arrays = points - 1;
  CHECK(find_calls({lengths(), weighted("q")}, limits)[1].calls.empty());
  limits = generous;
  limits.growth = 1.01;
  CHECK(find_calls({lengths(), weighted("q")}, limits)[1].calls.empty());
}

// Planted: the sign of the last length left out in find_calls.cpp, seen red here and above.
TEST_CASE("C with calls has the interpreter's bits") {
  const FileSet files = emit_files(model_of({lengths(), weighted("q")}));
  CHECK(files.at("sample.c").find("    sample_lengths(q, lengths_h);\n") != std::string::npos);
  CHECK(differing(weighted("q"), files) == 0);
}

namespace {

/// The weighted sum where the lengths are an argument.
Graph sum_of_lengths() {
  Graph graph;
  graph.name = "sum_of_lengths";
  graph.inputs = {argument("f", points), argument("h", points)};
  Value sum = sum_of_sines(graph, 0);
  for (int i = 0; i < points; ++i)
    sum =
        graph.make(Op::add, sum, graph.make(Op::multiply, graph.input(i), graph.input(points + i)));
  graph.outputs = {{"sum", 1, 1, "", "", {}, {sum}}};
  return graph;
}

/// `weighted` as a chain of those two.
std::vector<Graph> chained() {
  Graph chain = weighted("q");
  chain.chain = {"lengths", "sum_of_lengths"};
  return {lengths(), sum_of_lengths(), chain};
}

}  // namespace

// Planted: results of the first function taken in the wrong order in chain.cpp, seen red.
TEST_CASE("a chain is emitted as the calls of its functions, with their bits") {
  std::vector<Graph> graphs = chained();
  join_chains(graphs);
  const FileSet files = emit_files(model_of(graphs));
  const std::string& c = files.at("sample.c");
  CHECK(c.find("    double h[20];\n    sample_lengths(q, h);\n"
               "    sample_sum_of_lengths(f, h, sum);\n}") != std::string::npos);
  CHECK(differing(graphs[2], files) == 0);
  // The last length has the other sign: it is the chain's sum, and not that of the derivation.
  const std::vector<double> state = states_of(graphs[2], 1, 3)[0];
  const std::vector<double> h = evaluate(lengths(), std::vector<double>{state[0], state[1]});
  std::vector<double> arguments(state.begin() + 2, state.end());
  arguments.insert(arguments.end(), h.begin(), h.end());
  CHECK(evaluate(graphs[2], state)[0] == evaluate(sum_of_lengths(), arguments)[0]);
}

TEST_CASE("a chain that lacks an argument, or ends with other results, is refused") {
  std::vector<Graph> graphs = chained();
  graphs[2].chain = {"sum_of_lengths"};
  CHECK_THROWS_WITH(join_chains(graphs),
                    "weighted: as a chain of functions, it has no h of that size");
  graphs = chained();
  graphs[2].chain = {"lengths"};
  CHECK_THROWS_WITH(join_chains(graphs),
                    "weighted: as a chain of functions, it has no sum of that size");
  graphs = chained();
  graphs[2].chain = {"lengths", "sum_of_lengths", "lengths"};
  CHECK_THROWS_WITH(join_chains(graphs),
                    "weighted: as a chain of functions, it has two arrays named h");
  graphs = chained();
  Graph other = lengths();
  other.name = "other";
  other.outputs[0].name = "g";
  graphs.push_back(other);
  graphs[2].chain = {"lengths", "sum_of_lengths", "other"};
  CHECK_THROWS_WITH(join_chains(graphs),
                    "weighted: as a chain of functions, it does not end with its results");
  graphs = chained();
  graphs[2].chain = {"nothing"};
  CHECK_THROWS_WITH(join_chains(graphs), "there is no function nothing");
}
