// SPDX-License-Identifier: GPL-3.0-or-later
// The same bytes in every run, locale and folder; two_compilers does the same with two compilers.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew::reference;
namespace fs = std::filesystem;

namespace {

const std::string model_folder = SINEW_SOURCE_DIR "/models/index";

/// Names and contents of all files of a folder.
std::map<std::string, std::string> content_of(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory())
      content[entry.path().lexically_relative(folder).string()] = read_text(entry.path());
  return content;
}

/// A German locale: installed, or made in `folder`. What to put into the environment; empty where
/// it cannot be had.
std::vector<std::string> german_locale(const fs::path& folder) {
  std::string output;
  if (run_program({"locale", "-a"}, output) == 0 && output.find("de_DE.utf8") != std::string::npos)
    return {"LC_ALL=de_DE.UTF-8"};
  try {
    run_program({"localedef", "-i", "de_DE", "-f", "UTF-8", (folder / "de_DE.UTF-8").string()},
                output);
  } catch (const std::runtime_error&) {
    return {};
  }
  if (!fs::exists(folder / "de_DE.UTF-8" / "LC_NUMERIC")) return {};
  return {"LC_ALL=de_DE.UTF-8", "LOCPATH=" + folder.string()};
}

struct Run {
  std::map<std::string, std::string> files;
  std::string half;  ///< as the locale writes it
};

Run run(const std::string& program, const std::vector<std::string>& environment,
        const fs::path& working_folder, const std::string& out) {
  std::vector<std::string> command{"env", "-C", working_folder.string()};
  command.insert(command.end(), environment.begin(), environment.end());
  command.insert(command.end(), {program, model_folder, out});
  Run result;
  const int status = run_program(command, result.half);
  INFO(result.half);
  REQUIRE(status == 0);
  result.files = content_of(working_folder / out);
  return result;
}

std::size_t different(const std::vector<Run>& runs) {
  std::set<std::map<std::string, std::string>> contents;
  for (const Run& each : runs) contents.insert(each.files);
  return contents.size();
}

}  // namespace

TEST_CASE("30 generations in two locales and two folders give one output", "[slow]") {
  if (read_text("/proc/sys/kernel/randomize_va_space")[0] == '0')
    sinew::test::skip("this kernel does not randomise addresses");
  const TemporaryFolder here, there, locales;
  fs::create_directories(there.path() / "a folder" / "below");
  std::vector<std::vector<std::string>> environments{{"LC_ALL=C"}};
  const std::vector<std::string> german = german_locale(locales.path());
  if (german.empty())
    sinew::test::skip("no German locale: none is installed and localedef cannot make one");
  else
    environments.push_back(german);
  std::vector<Run> runs;
  for (int i = 0; i < 30; ++i) {
    const bool elsewhere = i / 2 % 2 == 1;
    runs.push_back(
        run(SINEW_EMIT_MODEL, environments[static_cast<std::size_t>(i) % environments.size()],
            elsewhere ? there.path() : here.path(), elsewhere ? "a folder/below/index" : "index"));
  }
  CHECK(different(runs) == 1);
  CHECK(runs[0].files.size() >= 5);
  CHECK(runs[0].half == "0.5\n");
  if (!german.empty()) CHECK(runs[1].half == "0,5\n");
}

TEST_CASE("planted: a random order of operands is seen") {
  const TemporaryFolder folder;
  std::vector<Run> runs;
  for (int i = 0; i < 3; ++i)
    runs.push_back(run(SINEW_EMIT_MODEL_RANDOM, {"LC_ALL=C"}, folder.path(), "index"));
  CHECK(different(runs) == 3);
}
