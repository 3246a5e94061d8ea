// SPDX-License-Identifier: GPL-3.0-or-later
// What compilers make of a whole float model: no operation on doubles and no conversion to them.
#include <catch2/catch.hpp>

#include <regex>
#include <sstream>

#include "generator/assemble.h"
#include "generator/write.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/tendons/functions.h"
#include "tests/reference/emitted_model.h"
#include "tests/skip.h"

using namespace sinew;
using reference::run_program;
namespace fs = std::filesystem;

namespace {

struct Compiler {
  std::string program;
  std::vector<std::string> options;
  std::string objdump;
};

std::vector<Compiler> compilers() {
  const std::vector<Compiler> all{
      {"gcc", {"-O1", "-march=x86-64-v3"}, "objdump"},
      {"clang", {"-O1"}, "objdump"},
      {"arm-none-eabi-gcc",
       {"-O1", "-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-mthumb", "-mfloat-abi=hard"},
       "arm-none-eabi-objdump"},
      {"arm-none-eabi-gcc",
       {"-O1", "-mcpu=cortex-m7", "-mfpu=fpv5-sp-d16", "-mthumb", "-mfloat-abi=hard"},
       "arm-none-eabi-objdump"}};
  std::vector<Compiler> here;
  std::string output;
  for (const Compiler& compiler : all) try {
      if (run_program({compiler.program, "--version"}, output) == 0) here.push_back(compiler);
    } catch (const std::runtime_error&) {
      test::skip(compiler.program + " is not installed");
    }
  return here;
}

/// Emitted C of all of the index finger's functions.
FileSet files_of(const Target& target) {
  static const std::vector<Function> functions =
      functions_of(read_mechanism(SINEW_SOURCE_DIR "/models/index"));
  return emit_files(assemble({"sample", "A sample.", std::string(64, '0'), {}}, functions, target));
}

/// Instructions that compute with doubles or convert to or from them, and, for processors without
/// them, calls of the routines that do. Two floats may be moved as one double: that is none.
std::vector<std::string> double_instructions(const std::string& disassembly) {
  static const std::regex x86(
      R"(\tv?(cvt\w*(sd|pd)\w*|(add|sub|mul|div|sqrt|min|max|round|u?comi|cmp\w*|fn?m\w+)[sp]d)\s)");
  static const std::regex x87(R"(\tf(ld|st|i?ld|i?st|add|sub|mul|div)\w*\s)");
  static const std::regex arm(R"(\t\w+\.f64|\.f64\.|<__aeabi_(d|f2d|[iu]l?2d)\w*>)");
  std::vector<std::string> found;
  std::istringstream lines(disassembly);
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, x86) || std::regex_search(line, x87) ||
        std::regex_search(line, arm))
      found.push_back(line);
  return found;
}

/// Of the C files named, without their ending.
std::vector<std::string> double_instructions(const Compiler& compiler, const FileSet& files,
                                             const std::vector<std::string>& names) {
  const reference::TemporaryFolder place;
  replace_folder(place.path() / "sample", files);
  std::vector<std::string> found;
  for (const std::string& file : names) {
    const fs::path object = place.path() / "object.o";
    std::vector<std::string> command{compiler.program, "-std=c11", "-ffp-contract=off",
                                     "-fno-math-errno"};
    command.insert(command.end(), compiler.options.begin(), compiler.options.end());
    command.insert(command.end(), {"-I", SINEW_SOURCE_DIR "/runtime", "-I",
                                   (place.path() / "sample").string(), "-c", "-o", object.string(),
                                   (place.path() / "sample" / (file + ".c")).string()});
    std::string output, code;
    const int status = run_program(command, output);
    INFO(output);
    REQUIRE(status == 0);
    REQUIRE(run_program({compiler.objdump, "-d", "-r", "--no-show-raw-insn", object.string()},
                        code) == 0);
    REQUIRE(code.find("sample_inverse_dynamics") != std::string::npos);
    for (std::string& line : double_instructions(code)) found.push_back(std::move(line));
  }
  return found;
}

/// The same files with one float constant written as a double.
FileSet with_double_constant(FileSet files) {
  std::string& code = files.at("sample.c");
  const std::size_t start = code.find("sample_inverse_dynamics(");
  static const std::regex constant(R"(([0-9]\.[0-9]+)f \*)");
  code = code.substr(0, start) + std::regex_replace(code.substr(start), constant, "$1 *",
                                                    std::regex_constants::format_first_only);
  return files;
}

}  // namespace

TEST_CASE("compiled float models hold no operation on doubles", "[slow]") {
  const FileSet fast = files_of({.scalar = Scalar::binary32});
  const FileSet small = files_of({.scalar = Scalar::binary32, .optimise = Optimise::size});
  for (const Compiler& compiler : compilers()) {
    INFO(compiler.program);
    CHECK(double_instructions(compiler, fast, {"sample", "host/sample_batch"}).empty());
    CHECK(double_instructions(compiler, small, {"sample"}).empty());
  }
}

TEST_CASE("planted: one double constant in a float model is found in the object code") {
  const FileSet files = files_of({.scalar = Scalar::binary32});
  const FileSet planted = with_double_constant(files);
  REQUIRE(planted.at("sample.c") != files.at("sample.c"));
  const FileSet doubles = files_of({.scalar = Scalar::binary64});
  for (const Compiler& compiler : compilers()) {
    INFO(compiler.program);
    CHECK(double_instructions(compiler, planted, {"sample"}).size() >= 2);
    CHECK(double_instructions(compiler, doubles, {"sample"}).size() > 900);
  }
}
