// SPDX-License-Identifier: GPL-3.0-or-later
// `sinew figures` from a user's side.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using sinew::reference::run_program;
using sinew::reference::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

const std::string source = SINEW_SOURCE_DIR;

int figures(const fs::path& out, const std::string& generated, std::string& output) {
  return run_program(
      {SINEW_PROGRAM, "figures", "--out", out.string(), "--models", source + "/models",
       "--generated", generated, "--runtime", source + "/runtime"},
      output);
}

std::string content(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("every figure is there as SVG and CSV, with the source's number in the index",
          "[figures][slow]") {
  if (std::string output; run_program({"gnuplot", "--version"}, output) != 0)
    return sinew::test::skip("gnuplot is not installed (gnuplot-nox)");
  const TemporaryFolder folder;
  std::string output;
  CAPTURE(output);
  REQUIRE(figures(folder.path(), source + "/generated", output) == 0);
  const std::string index = content(folder.path() / "index.html");
  for (const char* number : {"3.3", "4.10", "5.7", "5.16", "5.17a", "5.17i", "6.9", "6.10", "6.12"})
    CHECK(index.find("Fig. " + std::string(number)) != std::string::npos);
  int drawings = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() != ".svg") continue;
    ++drawings;
    CHECK(content(entry.path()).find("</svg>") != std::string::npos);
    fs::path table = entry.path();
    CHECK(content(table.replace_extension(".csv")).size() > 1000);
  }
  CHECK(drawings == 22);
}

TEST_CASE("figures without emitted C: a message and status 2", "[figures]") {
  const TemporaryFolder folder;
  std::string output;
  CHECK(figures(folder.path() / "out", (folder.path() / "none").string(), output) == 2);
  CHECK(output.find("not found; expected the emitted C of a model") != std::string::npos);
  CHECK(!fs::exists(folder.path() / "out"));
}
