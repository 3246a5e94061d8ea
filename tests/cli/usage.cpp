// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong usage and wrong input end with 2 and say where and what was expected.
#include <catch2/catch.hpp>

#include <regex>

#include "tests/cli/program.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

constexpr const char* model = "models/index";

std::vector<std::string> folders_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

}  // namespace

TEST_CASE("help is fine, and every command has one") {
  const Workplace here;
  CHECK(here.sinew({"--help"}).status == 0);
  for (const char* command : {"generate", "check", "cost", "dump", "import"}) {
    CHECK(here.sinew({"--help"}).says(command));
    CHECK(here.sinew({command, "--help"}).status == 0);
  }
}

TEST_CASE("wrong usage ends with 2 and says what is wrong") {
  const Workplace here;
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{}, "subcommand"},
      {{"produce"}, "no command is called 'produce'; expected one of generate, check, "},
      {{"generate"}, "model"},
      {{"generate", model, "--fast"}, "--fast"},
      {{"generate", model, "--scalar", "half"}, "expected double or float"},
      {{"generate", model, "--optimise", "beauty"}, "expected speed or size"},
      {{"check", model, "--optimise", "beauty"}, "expected speed or size"},
      {{"cost", model, "--optimise", "beauty"}, "expected speed or size"},
      {{"cost", model, "--scalar", "half"}, "expected double or float"},
      {{"dump", model, "--function", "bias", "--optimise", "beauty"}, "expected speed or size"},
      {{"generate", model, "--without", "nosuch"}, "expected one of share, fold_constants"},
      {{"generate", "models/none"}, "models/none"},
      {{"check", model, "--scalar", "half"}, "expected double or float"},
      {{"cost", "models/none"}, "models/none"},
      {{"dump", model}, "--function"},
      {{"diagnose", model, "--log", "a.csv", "--out", "o", "--band", "-5"},
       "expected a frequency above 0 Hz, got '-5'"},
      {{"dump", model, "--function", "nosuch"}, "expected one of forward_kinematics, "},
      {{"dump", model, "--function", "bias", "--after", "nosuch"},
       "expected one of lower, share, "}};
  for (const auto& [arguments, words] : table) {
    const Ended ended = here.sinew(arguments);
    INFO(words << "\n" << ended.output);
    CHECK(ended.status == 2);
    CHECK(ended.says(words));
  }
  CHECK(folders_in(here.path(".")) == std::vector<std::string>{"models"});
}

TEST_CASE("a mistake in a model is reported with file, line and column, and nothing is written") {
  const Workplace here;
  const auto mechanism = "models/index/mechanism.toml";
  const std::string original = here.text(mechanism);
  REQUIRE(here.sinew({"generate", model}).status == 0);
  const std::string before = here.text("generated/index/index.c");
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"name = \"medial\"", "name = \"med ial\""},
      {"axis = [0, 0, 1]", "axis = [0, 0, 0]"},
      {"parent = \"knuckle\"", "parent = \"wrist\""},
      {"type = \"revolute\"", "type = \"hinge\""},
      {"unit = \"m/s^2\"", "unit = \"furlong\""}};
  for (const auto& [good, bad] : mistakes) {
    here.change(mechanism, good, bad);
    for (const char* command : {"generate", "check", "cost"}) {
      const Ended ended = here.sinew({command, model});
      INFO(command << " with " << bad << "\n" << ended.output);
      CHECK(ended.status == 2);
      CHECK(std::regex_search(ended.output, std::regex(R"(mechanism\.toml:[0-9]+:[0-9]+: )")));
    }
    reference::write_text(here.path(mechanism), original);
  }
  here.change("models/index/mass_properties.csv", "distal,0.003", "distal,-0.003");
  const Ended negative = here.sinew({"generate", model});
  CHECK(negative.status == 2);
  CHECK(std::regex_search(negative.output, std::regex(R"(mass_properties\.csv:[0-9]+:[0-9]+: )")));
  CHECK(here.text("generated/index/index.c") == before);
}

TEST_CASE("an output that cannot be written is not passed over") {
  const Workplace here;
  CHECK(here.shell("sinew dump models/index --function bias > /dev/full").status == 2);
  CHECK(here.shell("sinew cost models/index --json > /dev/full").status == 2);
  const Ended ended = here.shell("trap '' XFSZ; ulimit -f 1; sinew generate models/index");
  CHECK(ended.status == 2);
  CHECK(!fs::exists(here.path("generated/index")));
  if (fs::exists(here.path("generated")))
    CHECK(folders_in(here.path("generated")) == std::vector<std::string>{});
}
