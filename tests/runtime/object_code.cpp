// SPDX-License-Identifier: GPL-3.0-or-later
// What compilers make of the runtime: no conditional jump, no undefined symbol, vectorised loops,
// and the same bits from every compiler and option. Each check is also shown a defect that it must
// find.
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

namespace {

const std::string source_dir = SINEW_SOURCE_DIR "/tests/runtime/";
const std::string rules = " -std=c11 -ffp-contract=off -fno-math-errno -I " SINEW_SOURCE_DIR
                          "/runtime -I " SINEW_SOURCE_DIR "/tests/runtime ";

struct Result {
  std::string output;
  int status;
};

Result run(const std::string& command) {
  Result result{"", -1};
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> piece;
  while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), pipe))
    result.output.append(piece.data(), size);
  result.status = pclose(pipe);
  return result;
}

bool installed(const std::string& program) {
  return run("command -v " + program).status == 0;
}

// Whether it is installed; what a test does with it is skipped where it is not.
bool is_there(const std::string& compiler) {
  const bool there = installed(compiler);
  if (!there) sinew::test::skip(compiler + " is not installed");
  return there;
}

// One folder a process, gone at its end: CTest runs these tests side by side, and one's planted
// defect must not be what another looks at.
std::string scratch(const std::string& name) {
  static const sinew::reference::TemporaryFolder folder;
  return (folder.path() / name).string();
}

struct Target {
  std::string compiler;
  std::string options;
  std::string binutils;  // prefix of objdump and nm
};

std::vector<Target> targets() {
  const std::string thumb = " -mthumb -mfloat-abi=hard";
  const std::vector<Target> all = {
      {"gcc", "-march=x86-64-v3", ""},
      {"gcc", "", ""},
      {"clang", "-march=x86-64-v3", ""},
      {"arm-none-eabi-gcc", "-mcpu=cortex-a9 -mfpu=neon-vfpv3" + thumb, "arm-none-eabi-"},
      {"arm-none-eabi-gcc", "-mcpu=cortex-m7 -mfpu=fpv5-d16" + thumb, "arm-none-eabi-"},
      {"arm-none-eabi-gcc", "-mcpu=cortex-r5 -mfpu=vfpv3-d16" + thumb, "arm-none-eabi-"},
  };
  std::vector<Target> result;
  for (const Target& target : all)
    if (is_there(target.compiler)) result.push_back(target);
  return result;
}

// Lines of the disassembly that jump on a condition: x86 j.. but jmp, Arm b<condition>, cbz, tbb.
std::vector<std::string> conditional_jumps(const std::string& disassembly) {
  static const std::regex jump(
      "\\t(j(?!mp)[a-z]+|b(eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)(\\.[nw])?|cbn?z|tb[bh])"
      "\\s");
  std::vector<std::string> result;
  std::istringstream lines(disassembly);
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, jump)) result.push_back(line);
  return result;
}

struct Findings {
  std::size_t jumps;
  std::string undefined;
};

Findings examine(const Target& target, const std::string& options) {
  const std::string object = scratch("probe.o");
  const Result built = run(target.compiler + rules + target.options + " " + options +
                           " -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Werror -c " +
                           source_dir + "probe.c -o " + object);
  INFO(built.output);
  REQUIRE(built.status == 0);
  const Result code = run(target.binutils + "objdump -d --no-show-raw-insn " + object);
  REQUIRE(code.output.find("probe_sincos") != std::string::npos);
  return {conditional_jumps(code.output).size(), run(target.binutils + "nm -u " + object).output};
}

}  // namespace

TEST_CASE("no conditional jump and no undefined symbol, whatever the compiler and its options") {
  for (const Target& target : targets())
    for (const char* level : {"-O2", "-O3", "-Os"}) {
      INFO(target.compiler << " " << target.options << " " << level);
      const Findings found = examine(target, level);
      CHECK(found.jumps == 0);
      CHECK(found.undefined.empty());
    }
}

TEST_CASE("a jump or a call of the C library is found") {
  for (const Target& target : targets()) {
    INFO(target.compiler << " " << target.options);
    CHECK(examine(target, "-O2 -DPLANTED_CALL").undefined.find("sin") != std::string::npos);
    if (target.binutils.empty())  // Arm predicates a single store instead of jumping around it
      CHECK(examine(target, "-O2 -DPLANTED_BRANCH").jumps > 0);
  }
  CHECK(conditional_jumps("  10:\tbne.n\t8 <f+0x8>\n  12:\tcbz\tr0, 18\n  14:\tbic.w\tr1, r1, #1\n"
                          "  18:\tbl\t0 <g>\n  1c:\tbx\tlr\n")
            .size() == 2);
}

TEST_CASE("float functions hold no double operation") {
  if (!is_there("arm-none-eabi-gcc")) return;  // its mnemonics name the precision
  const Target target{"arm-none-eabi-gcc",
                      "-mcpu=cortex-m7 -mfpu=fpv5-d16 -mthumb -mfloat-abi=hard", "arm-none-eabi-"};
  examine(target, "-O2");
  std::istringstream lines(run("arm-none-eabi-objdump -d " + scratch("probe.o")).output);
  std::string function;
  int in_float = 0, in_double = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(">:") != std::string::npos) function = line.substr(line.find('<'));
    if (line.find(".f64") == std::string::npos) continue;
    ++(function.find("f>:") != std::string::npos ? in_float : in_double);
  }
  CHECK(in_float == 0);
  CHECK(in_double > 0);  // the same search does find them where they belong
}

TEST_CASE("gcc vectorises a loop over sincos without fast-math") {
  if (!is_there("gcc")) return;
  const std::string command = std::string("gcc") + rules +
                              "-O3 -march=x86-64-v3 -fopt-info-vec -c " + source_dir +
                              "batch_probe.c -o " + scratch("batch.o");
  const std::string sign = "loop vectorized using 32 byte vectors";
  CHECK(run(command).output.find(sign) != std::string::npos);
  CHECK(run(command + " -DPLANTED").output.find(sign) == std::string::npos);
}

TEST_CASE("every compiler and option gives the same bits; contraction does not") {
  const auto hash = [](const std::string& compiler, const std::string& options) {
    const std::string program = scratch("hash");
    const Result built =
        run(compiler + rules + options + " " + source_dir + "hash_program.c -o " + program);
    INFO(built.output);
    REQUIRE(built.status == 0);
    return run(program).status;
  };
  for (const std::string compiler : {"gcc", "clang"}) {
    if (!is_there(compiler)) continue;
    for (const char* options : {"-O0", "-O2", "-Os", "-O3 -march=x86-64-v3"}) {
      INFO(compiler << " " << options);
      CHECK(hash(compiler, options) == 0);
    }
    CHECK(hash(compiler, "-O3 -march=x86-64-v3 -ffp-contract=fast") != 0);
  }
}
