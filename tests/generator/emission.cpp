// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted C: literals, scalar purity, warnings, names, manifest.
#include <catch2/catch.hpp>

#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "generator/assemble.h"
#include "generator/cost.h"
#include "generator/emit_c.h"
#include "generator/evaluate.h"
#include "generator/literal.h"
#include "generator/lower.h"
#include "generator/write.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/generator/every_operation.h"
#include "tests/reference/emitted_model.h"
#include "tests/skip.h"

using namespace sinew;
using reference::run_program;
namespace fs = std::filesystem;

namespace {

/// The index finger's functions and the one with every operation.
EmittedModel model_of(Scalar scalar) {
  std::vector<Function> functions =
      functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"), emitted_cost);
  functions.push_back(every_operation());
  return assemble({"sample", "A sample.", std::string(64, '0'), {}}, functions, {scalar});
}

std::vector<double> awkward_doubles() {
  std::vector<double> values{0.0,
                             1e22,
                             -1e22,
                             0.1,
                             1e-5,
                             100000.0,
                             123456789.0,
                             0x1p-1074,
                             -0x1p-1022,
                             0x1.fffffffffffffp-1023,
                             1.7976931348623157e308,
                             -1.0 / 3.0};
  std::mt19937_64 random(5);
  while (values.size() < 700) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

std::vector<double> awkward_floats() {
  std::vector<double> values{0.0,
                             static_cast<double>(1e22f),
                             -0.10000000149011612,
                             0x1p-149,
                             -0x1p-126,
                             0x1.fffffep127,
                             16777216.0};
  std::mt19937 random(6);
  while (values.size() < 700) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) values.push_back(static_cast<double>(value));
  }
  return values;
}

/// A function that returns `values`, as C that has been compiled, loaded and called.
std::vector<double> through_c(const std::vector<double>& values, Scalar scalar) {
  Graph graph;
  graph.name = "constants";
  graph.outputs = {{"r", static_cast<int>(values.size()), 1, "", "", {}, {}}};
  for (double value : values) graph.outputs[0].values.push_back(graph.constant(value));
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "literals",
                 emit_files({"literals", "Constants.", "0", {}, {graph}, {scalar}}));
  return reference::EmittedModel(place.path() / "literals").call("constants", {});
}

void check_literals() {
  for (double value : awkward_doubles()) {
    const std::string text = literal(value, {Scalar::binary64});
    double back = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), back);
    CAPTURE(text);
    CHECK((end.ptr == text.data() + text.size() && back == value));
  }
  const bool doubles = through_c(awkward_doubles(), Scalar::binary64) == awkward_doubles();
  const bool floats = through_c(awkward_floats(), Scalar::binary32) == awkward_floats();
  CHECK(doubles);
  CHECK(floats);
}

/// What a compiler says; empty where it has nothing to say.
std::string compiler_output(std::vector<std::string> command, const fs::path& folder,
                            const std::string& file) {
  command.insert(command.end(), {"-I", SINEW_SOURCE_DIR "/runtime", "-I", folder.string(), "-c",
                                 "-o", (folder / "object.o").string(), (folder / file).string()});
  std::string output;
  const int status = run_program(command, output);
  return status == 0 ? output : output + "\nexit status " + std::to_string(status);
}

bool installed(const std::string& program) {
  std::string output;
  try {
    return run_program({program, "--version"}, output) == 0;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Literals of floating-point type that are not float, and the word double.
std::vector<std::string> double_traces(const std::string& code) {
  static const std::regex comment(R"(/\*[\s\S]*?\*/)");
  static const std::regex trace(
      R"(\bdouble\b|\b[0-9]+\.[0-9]*(e[-+]?[0-9]+)?(?![0-9.ef])|\b[0-9]+e[-+]?[0-9]+(?![0-9f]))");
  const std::string bare = std::regex_replace(code, comment, "");
  std::vector<std::string> traces;
  for (std::sregex_iterator at(bare.begin(), bare.end(), trace), end; at != end; ++at)
    traces.push_back(at->str());
  return traces;
}

}  // namespace

TEST_CASE("literals read back to the same bits") {
  check_literals();
}

TEST_CASE("literals read back to the same bits where the comma separates decimals", "[slow]") {
  const reference::TemporaryFolder place;
  std::string output;
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) {
    if (installed("localedef"))
      run_program(
          {"localedef", "-i", "de_DE", "-f", "UTF-8", (place.path() / "de_DE.UTF-8").string()},
          output);
    ::setenv("LOCPATH", place.path().c_str(), 1);
  }
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) {
    test::skip("no German locale: none is installed and localedef cannot make one");
  } else {
    CHECK(std::localeconv()->decimal_point == std::string(","));
    const FileSet german = emit_files(model_of(Scalar::binary64));
    check_literals();
    std::setlocale(LC_ALL, "C");
    CHECK(german == emit_files(model_of(Scalar::binary64)));
  }
  std::setlocale(LC_ALL, "C");
  ::unsetenv("LOCPATH");
}

TEST_CASE("a constant that the scalar type cannot hold is refused") {
  CHECK_THROWS_AS(literal(1e39, {Scalar::binary32}), std::range_error);
  CHECK_THROWS_AS(literal(HUGE_VAL, {Scalar::binary64}), std::range_error);
  CHECK(literal(1e39, {Scalar::binary64}) == "1e+39");
}

TEST_CASE("float code holds no double") {
  const FileSet files = emit_files(model_of(Scalar::binary32));
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", files);
  for (const char* file : {"sample.c", "sample.h"})
    CHECK(double_traces(files.at(file)) == std::vector<std::string>{});
  for (const char* compiler : {"gcc", "clang"}) {
    if (!installed(compiler)) {
      test::skip(std::string(compiler) + " is not installed");
      continue;
    }
    CHECK(compiler_output({compiler, "-std=c11", "-O1", "-Wdouble-promotion", "-Wfloat-conversion",
                           "-Wconversion", "-Werror"},
                          place.path() / "sample", "sample.c") == "");
  }
}

TEST_CASE("planted: a double in float code is found") {
  CHECK(double_traces("float a = 0.5f * b + 1e-06f - 2.0f; /* 0.5 double */").empty());
  CHECK(double_traces("const double a = 0.5f;").size() == 1);
  CHECK(double_traces("a = 0.5 * b;").size() == 1);
  CHECK(double_traces("a = 1e-06 * b + 12e+22;").size() == 2);
  CHECK(double_traces("a = 1.5e-06 * b;").size() == 1);
  const reference::TemporaryFolder place;
  reference::write_text(place.path() / "planted.c",
                        "void f(const float *a, float *b);\n"
                        "void f(const float *a, float *b) { b[0] = (float)(a[0] * 0.1); }\n");
  CHECK(compiler_output({"gcc", "-std=c11", "-Wdouble-promotion", "-Werror"}, place.path(),
                        "planted.c") != "");
}

TEST_CASE("headers and code compile without a warning as C11, headers as C++17", "[slow]") {
  for (Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
    const FileSet files = emit_files(model_of(scalar));
    const reference::TemporaryFolder place;
    const fs::path folder = place.path() / "sample";
    replace_folder(folder, files);
    for (const auto& [name, content] : files) {
      if (!name.ends_with(".h")) continue;
      const std::string twice =
          "#include \"" + name + "\"\n#include \"" + name + "\"\nint unused;\n";
      const std::string user = "use_" + fs::path(name).filename().string();
      reference::write_text(folder / (user + ".c"), twice);
      reference::write_text(folder / (user + ".cpp"), twice);
    }
    const std::vector<std::string> strict{"-O1",      "-Wall",        "-Wextra", "-Wpedantic",
                                          "-Wshadow", "-Wconversion", "-Werror"};
    for (const std::string compiler : {"gcc", "clang"}) {
      if (!installed(compiler)) {
        test::skip(compiler + " is not installed");
        continue;
      }
      for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (!name.ends_with(".c") && !name.ends_with(".cpp")) continue;
        std::vector<std::string> command{compiler,
                                         name.ends_with(".c") ? "-std=c11" : "-std=c++17"};
        command.insert(command.end(), strict.begin(), strict.end());
        // Clang says where it leaves a batch loop scalar: a fact about speed, not about the text.
        if (compiler == "clang") command.push_back("-Wno-error=pass-failed");
        INFO(compiler << " " << name);
        CHECK(compiler_output(command, folder, name) == "");
      }
    }
  }
}

TEST_CASE("derivations' names never meet C's words, the arguments or each other") {
  const std::vector<std::string> labels{
      "double",   "while",        "register",   "q",          "r",
      "restrict", "t1",           "s1",         "c1",         "inline",
      "auto",     "sinew_sincos", "sinew_sqrt", "sinew_atan", "same",
      "same",     "same_2",       "_Bool",      "typeof",     "goto",
      "count",    "state",        "i",          "angle1",     "sine2"};
  Graph graph;
  graph.name = "collisions";
  graph.inputs = {{"q", 2, 1, "", "", {{0.1, 1.0}, {0.1, 1.0}}, {}}};
  graph.outputs = {{"r", 1, 1, "", "", {}, {}}};
  Value sum = graph.input(0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Op op = i % 3 == 0 ? Op::square_root : i % 3 == 1 ? Op::sine : Op::arctangent;
    const Value square = graph.make(Op::multiply, sum, sum);  // used twice it keeps its name
    sum = graph.make(op, graph.make(Op::add, square, graph.input(1)));
    graph.set_label(sum, labels[i]);
  }
  graph.outputs[0].values = {graph.make(Op::multiply, sum, sum)};
  for (Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
    const reference::TemporaryFolder place;
    replace_folder(place.path() / "names",
                   emit_files({"names", "Names.", "0", {}, {graph}, {scalar}}));
    const double compiled =
        reference::EmittedModel(place.path() / "names").call("collisions", {0.3, 0.4})[0];
    CHECK(compiled == (scalar == Scalar::binary64
                           ? evaluate<double>(graph, {0.3, 0.4})[0]
                           : static_cast<double>(evaluate<float>(graph, {0.3f, 0.4f})[0])));
  }
}

// Planted: named steps kept whatever their length, and none of them, seen red here.
TEST_CASE("a short step that is used once is written in place, whatever the derivation calls it") {
  Graph graph;
  graph.name = "steps";
  graph.inputs = {{"elongation", 4, 1, "", "", std::vector<Range>(4, {0.1, 1.0}), {}}};
  Value products = graph.input(0);
  for (int i = 1; i < 4; ++i) products = graph.make(Op::multiply, products, graph.input(i));
  graph.set_label(products, "product_of_all");
  const Value gap = graph.make(Op::subtract, graph.input(0), graph.input(1));
  graph.set_label(gap, "gap");
  const Value slope = graph.make(Op::add, graph.input(2), graph.input(3));
  graph.set_label(slope, "slope");
  const Value ratio = graph.make(Op::divide, gap, slope);
  graph.outputs = {{"r",
                    3,
                    1,
                    "",
                    "",
                    {},
                    {graph.make(Op::sine, ratio), graph.make(Op::subtract, slope, products),
                     graph.make(Op::square_root, slope)}}};
  const std::string c = emit_files({"short", "Short.", "0", {}, {graph}, {}}).at("short.c");
  CHECK(c.find("double gap ") == std::string::npos);
  CHECK(c.find("double slope = elongation[2] + elongation[3];") != std::string::npos);
  CHECK(c.find("double product_of_all = ") != std::string::npos);
}

TEST_CASE("a description cannot leave its comment") {
  const Graph graph = lower(every_operation());
  const FileSet files = emit_files({"sample",
                                    "odd */ int planted; /* text /*/ \\\n#error second line */",
                                    "0",
                                    {},
                                    {graph},
                                    {Scalar::binary64}});
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", files);
  for (const char* file : {"sample.c", "sample_catalogue.c"})
    CHECK(compiler_output({"gcc", "-std=c11", "-Wall", "-Wextra", "-Werror"},
                          place.path() / "sample", file) == "");
  std::string symbols;
  compiler_output({"gcc", "-std=c11"}, place.path() / "sample", "sample.c");
  REQUIRE(run_program({"nm", (place.path() / "sample" / "object.o").string()}, symbols) == 0);
  CHECK(symbols.find("planted") == std::string::npos);
}

TEST_CASE("every emitted file opens with its licence and names no place or time") {
  for (const auto& [name, content] : emit_files(model_of(Scalar::binary64))) {
    INFO(name);
    if (name != "manifest.json" && name != "reference.csv")
      CHECK(content.rfind("/* SPDX-License-Identifier: BSD-2-Clause", 0) == 0);
    CHECK(content.find(SINEW_SOURCE_DIR) == std::string::npos);
    CHECK(!std::regex_search(content, std::regex(R"(\b20[0-9][0-9]-[01][0-9]-)")));
  }
}

TEST_CASE("what is for a host lies in a folder of its own, and its first line says so") {
  // Planted defect: the batch files beside the others, where a board's build takes all C.
  int found = 0;
  for (const auto& [name, content] : emit_files(model_of(Scalar::binary64))) {
    INFO(name);
    const bool has_loops = content.find("_batch(int count") != std::string::npos;
    CHECK(name.starts_with("host/") == has_loops);
    const std::string first =
        "/* SPDX-License-Identifier: BSD-2-Clause\n *\n * For a host with vector";
    CHECK(content.starts_with(first) == has_loops);
    found += has_loops;
  }
  CHECK(found == 2);
}

TEST_CASE("the manifest lists files, arguments and the operations that are counted") {
  const EmittedModel model = model_of(Scalar::binary64);
  const FileSet files = emit_files(model);
  const nlohmann::json manifest = nlohmann::json::parse(files.at("manifest.json"));
  CHECK(manifest["model"] == "sample");
  CHECK(manifest["sha256"] == std::string(64, '0'));
  CHECK(manifest["scalar"] == "double");
  std::vector<std::string> names;
  for (const auto& [name, content] : files) names.push_back(name);
  CHECK(manifest["files"] == names);
  REQUIRE(manifest["functions"].size() == model.functions.size());
  for (std::size_t i = 0; i < model.functions.size(); ++i) {
    const Graph& graph = model.functions[i];
    const nlohmann::json& function = manifest["functions"][i];
    const nlohmann::json& operations = function["operations"];
    const Cost cost = count_operations(graph);
    INFO(graph.name);
    CHECK(function["name"] == "sample_" + graph.name);
    CHECK(operations["multiply"] == cost.multiply);
    CHECK(operations["add"] == cost.add);
    CHECK(operations["negate"] == cost.negate);
    CHECK(operations["divide"] == cost.divide);
    CHECK(operations["sqrt"] == cost.square_root);
    CHECK(operations["sincos"] == cost.sincos);
    CHECK(operations["other"] == cost.other);
    CHECK(function["inputs"].size() == graph.inputs.size());
    CHECK(function["outputs"][0]["rows"] == graph.outputs[0].rows);
  }
}

TEST_CASE("a number is passed by its value, a status is an int whose values have names") {
  const GiNaC::symbol x("x"), y("y");
  Argument number{"x", 1, 1, {x}, "m", "a number", {{-1.0, 1.0}}};
  number.by_value = true;
  const Argument array{"y", 1, 1, {y}, "m", "an array of one", {{-1.0, 1.0}}};
  const Function function{
      "take",
      "Takes both.",
      "",
      {number, array},
      {},
      {{"sum", 1, 1, {x + y}, "m", ""},
       {"status", 1, 1, {choose(x - y, 0, 1)}, "1", "", {"fine", "too_small"}}}};
  for (const Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
    const EmittedModel model =
        assemble({"sample", "A sample.", std::string(64, '0'), {}}, {function}, {scalar});
    const FileSet files = emit_files(model);
    const std::string type = model.target.type();
    const std::string& header = files.at("sample.h");
    CHECK(header.find("sample_take(" + type + " x, const " + type + " y[SINEW_AT_LEAST(1)],") !=
          std::string::npos);
    CHECK(header.find("int *status);\nenum { SAMPLE_TAKE_FINE = 0, SAMPLE_TAKE_TOO_SMALL = 1 };") !=
          std::string::npos);
    const auto manifest = nlohmann::json::parse(files.at("manifest.json"))["functions"][0];
    CHECK(manifest["inputs"][0]["by_value"] == true);
    CHECK_FALSE(manifest["inputs"][1].contains("by_value"));
    CHECK(manifest["outputs"][1]["states"] == nlohmann::json{"fine", "too_small"});
    const reference::TemporaryFolder place;
    replace_folder(place.path() / "sample", files);
    const reference::EmittedModel compiled(place.path() / "sample");
    // Planted: a catalogue that does not give the status back: NaN is in its place.
    CHECK(compiled.call("take", {0.5, 0.25}) == std::vector<double>{0.75, 0.0});
    CHECK(compiled.call("take", {0.25, 0.5}) == std::vector<double>{0.75, 1.0});
  }
  Function wrong = function;
  wrong.inputs[0].rows = 2;
  wrong.inputs[0].symbols.emplace_back("x2");
  CHECK_THROWS_AS(lower(wrong), std::invalid_argument);
}
