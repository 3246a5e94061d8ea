// SPDX-License-Identifier: GPL-3.0-or-later
// Targets with fused multiply-add, and targets short of room.
#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <regex>

#include "generator/assemble.h"
#include "generator/cost.h"
#include "generator/emit_c.h"
#include "generator/evaluate.h"
#include "generator/lower.h"
#include "generator/passes/passes.h"
#include "generator/write.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/generator/every_operation.h"
#include "tests/generator/pass_check.h"
#include "tests/reference/emitted_model.h"
#include "tests/skip.h"

using namespace sinew;
using reference::run_program;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> fused_flags{"-std=c11",           "-O2",   "-ffp-contract=off",
                                           "-fno-math-errno",    "-mfma", "-fno-tree-slp-vectorize",
                                           "-fno-tree-vectorize"};

EmittedModel model_for(const Target& target) {
  std::vector<Function> functions =
      functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"), emitted_cost);
  functions.push_back(every_operation());
  return assemble({"sample", "A sample.", std::string(64, '0'), {}}, functions, target);
}

bool machine_fuses() {
  std::ifstream in("/proc/cpuinfo");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return std::regex_search(text, std::regex(R"(\bfma\b)"));
}

/// Results of the C that are not the bits of the interpreter, over some states of each function.
template <class Real>
int differing_results(const EmittedModel& model, const reference::EmittedModel& compiled) {
  int found = 0;
  for (const Graph& graph : model.functions)
    for (const std::vector<double>& state : states_of(graph, 40, 7)) {
      const std::vector<Real> expected =
          evaluate<Real>(graph, std::vector<Real>(state.begin(), state.end()));
      const std::vector<double> given = compiled.call(graph.name, state);
      for (std::size_t i = 0; i < expected.size(); ++i)
        found += std::bit_cast<std::uint64_t>(static_cast<double>(expected[i])) !=
                 std::bit_cast<std::uint64_t>(given[i]);
    }
  return found;
}

/// What a compiler says about <folder>/sample.c, and its exit status; the object is left there.
int compile(const fs::path& folder, const std::vector<std::string>& options, std::string& output) {
  std::vector<std::string> command{"gcc"};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(),
                 {"-I", SINEW_SOURCE_DIR "/runtime", "-I", folder.string(), "-c", "-o",
                  (folder / "object.o").string(), (folder / "sample.c").string()});
  return run_program(command, output);
}

/// Bytes of machine code of the model.
int code_size(const Target& target, const std::string& level) {
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", emit_files(model_for(target)));
  std::string output;
  REQUIRE(compile(place.path() / "sample",
                  {"-std=c11", level, "-ffp-contract=off", "-fno-math-errno"}, output) == 0);
  REQUIRE(run_program({"size", "-A", (place.path() / "sample" / "object.o").string()}, output) ==
          0);
  std::smatch text;
  REQUIRE(std::regex_search(output, text, std::regex(R"(\.text\S*\s+(\d+))")));
  return std::stoi(text[1]);
}

}  // namespace

TEST_CASE("fused code has the interpreter's bits, in double and in float") {
  if (!machine_fuses()) return sinew::test::skip("this machine has no fused multiply-add");
  for (const Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
    const EmittedModel model = model_for({.scalar = scalar, .fused = true});
    const reference::TemporaryFolder place;
    replace_folder(place.path() / "sample", emit_files(model));
    const reference::EmittedModel compiled(place.path() / "sample", {"gcc", fused_flags});
    CHECK((scalar == Scalar::binary64 ? differing_results<double>(model, compiled)
                                      : differing_results<float>(model, compiled)) == 0);
    // Planted: the interpreter runs what was not fused.
    const EmittedModel other = model_for({.scalar = scalar});
    CHECK((scalar == Scalar::binary64 ? differing_results<double>(other, compiled)
                                      : differing_results<float>(other, compiled)) > 0);
  }
}

TEST_CASE("fused code calls no library and does not compile where the instruction is missing") {
  for (const Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
    const reference::TemporaryFolder place;
    const fs::path folder = place.path() / "sample";
    replace_folder(folder, emit_files(model_for({.scalar = scalar, .fused = true})));
    std::string output;
    REQUIRE(compile(folder, fused_flags, output) == 0);
    std::string undefined, code;
    REQUIRE(run_program({"nm", "-u", (folder / "object.o").string()}, undefined) == 0);
    CHECK(undefined == "");
    REQUIRE(run_program({"objdump", "-d", (folder / "object.o").string()}, code) == 0);
    CHECK(code.find(scalar == Scalar::binary64 ? "vfmadd" : "ss ") != std::string::npos);
    CHECK(compile(folder, {"-std=c11", "-O2"}, output) != 0);
    CHECK(output.find("fused multiply-add") != std::string::npos);
  }
}

TEST_CASE("a product that goes into sums only is fused with all of them") {
  Graph graph;
  graph.name = "sums";
  graph.inputs = {{"x", 4, 1, "", "", {}, {}}};
  graph.outputs = {{"r", 3, 1, "", "", {}, {}}};
  const Value a = graph.input(0), b = graph.input(1), c = graph.input(2), d = graph.input(3);
  const Value p = graph.make(Op::multiply, a, b), kept = graph.make(Op::multiply, c, d);
  graph.outputs[0].values = {graph.make(Op::add, p, c), graph.make(Op::subtract, d, p),
                             graph.make(Op::subtract, kept, kept)};
  const Graph fused = fuse(graph);
  const Cost cost = count_operations(fused);
  CHECK(cost.fused == 2);
  CHECK(cost.multiply == 3);  // two of them fused; `kept` stays
  const std::vector<double> r = evaluate<double>(fused, {3.0, 5.0, 7.0, 11.0});
  CHECK(r == std::vector<double>{22.0, -4.0, 0.0});
  // (1 + e)(1 - e) - 1 = -e^2 is lost where the product is rounded first.
  const double e = std::ldexp(1.0, -40);
  CHECK(evaluate<double>(fused, {1.0 + e, 1.0 - e, -1.0, 1.0})[0] == -e * e);
  CHECK(evaluate<double>(graph, {1.0 + e, 1.0 - e, -1.0, 1.0})[0] == 0.0);
}

TEST_CASE("fusing saves instructions and changes no other count") {
  for (const Function& function :
       functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"), emitted_cost)) {
    const Graph graph = lower(function);
    const Cost apart = count_operations(optimise(graph)),
               fused = count_operations(optimise(graph, {}, {.fused = true}));
    INFO(graph.name);
    CHECK(fused.weight() <= apart.weight());
    CHECK(fused.sincos == apart.sincos);
    CHECK(fused.divide == apart.divide);
  }
}

TEST_CASE("code made for size is smaller and has the same bits") {
  const Target small{.optimise = Optimise::size};
  const EmittedModel model = model_for(small);
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", emit_files(model));
  CHECK(differing_results<double>(model, reference::EmittedModel(place.path() / "sample")) == 0);
  for (const char* level : {"-O2", "-Os"}) {
    INFO(level);
    CHECK(code_size(small, level) < code_size({}, level));
  }
}
