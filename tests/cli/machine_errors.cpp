// SPDX-License-Identifier: GPL-3.0-or-later
// What helps where something is misspelt, and errors for machines.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

using namespace sinew;

TEST_CASE("a mistyped command or option says what may have been meant", "[usage]") {
  const Workplace here;
  CHECK(here.sinew({"genrate"}).says("(did you mean 'generate'?)"));
  CHECK(here.sinew({"simulat"}).says("(did you mean 'simulate'?)"));
  CHECK(here.sinew({"generate", "models/index", "--sclar", "float"})
            .says("(did you mean '--scalar'?)"));
  // Planted: what is near nothing suggests nothing, and a known option is not suggested for itself.
  CHECK_FALSE(here.sinew({"zzz"}).says("did you mean"));
  CHECK_FALSE(here.sinew({"dump", "models/index"}).says("did you mean"));
}

TEST_CASE("with --json errors are JSON on standard output, with their places", "[usage]") {
  const Workplace here;
  here.change("models/index/mechanism.toml", "axis = [0, 0, 1]", "axis = [0, 0, 0]");
  const Ended ended = here.shell("sinew generate models/index --json 2>errors");
  CHECK(ended.status == 2);
  CHECK(here.text("errors") == "");
  const auto report = nlohmann::json::parse(ended.output);
  CHECK(report.at("exit_status") == 2);
  const auto& error = report.at("errors").at(0);
  CHECK(error.at("file") == "models/index/mechanism.toml");
  CHECK(error.at("line").get<int>() > 1);
  CHECK(error.at("column").get<int>() >= 1);
  CHECK(error.at("message").get<std::string>().find("axis is zero") != std::string::npos);
  for (const char* wrong : {"sinew produce --json", "sinew generate --json",
                            "sinew generate models/none --json", "sinew import x.urdf --json"}) {
    const Ended each = here.shell(std::string(wrong) + " 2>errors");
    INFO(wrong << "\n" << each.output);
    CHECK(each.status == 2);
    CHECK(here.text("errors") == "");
    const auto errors = nlohmann::json::parse(each.output).at("errors");
    CHECK_FALSE(errors.empty());
  }
  // Planted: without --json people read it where errors belong.
  const Ended plain = here.shell("sinew generate models/index 2>errors");
  CHECK(plain.output == "");
  CHECK(here.text("errors").find("axis is zero") != std::string::npos);
}

TEST_CASE("what is not plausible is a warning, and a mistake with --strict", "[plausible]") {
  const Workplace here;
  here.change("models/index/mechanism.toml", "r22 = { value = 0.0055", "r22 = { value = 5.5");
  const Ended warned = here.sinew({"generate", "models/index"});
  CHECK(warned.status == 0);
  CHECK(warned.says("warning: models/index/mechanism.toml:"));
  CHECK(warned.says("a radius of 5.5 m"));
  const auto report = nlohmann::json::parse(here.shell("sinew check models/index --json").output);
  CHECK(report.at("warnings").size() == 1);
  const std::string before = here.text("generated/index/index.c");
  here.change("models/index/mechanism.toml", "r22 = { value = 5.5", "r22 = { value = 6.5");
  const Ended strict = here.sinew({"generate", "models/index", "--strict"});
  CHECK(strict.status == 2);
  CHECK(strict.says("a radius of 6.5 m"));
  CHECK(here.text("generated/index/index.c") == before);
}

TEST_CASE("the manual knows every command, and a shell completes them", "[usage]") {
  const Workplace here;
  const Ended page = here.sinew({"manual"});
  const Ended bash = here.sinew({"manual", "--bash"}), zsh = here.sinew({"manual", "--zsh"});
  REQUIRE(page.status == 0);
  for (const char* command :
       {"generate", "check", "cost", "dump", "import", "parameters", "simulate", "identify",
        "diagnose", "effects", "figures", "report", "manual"}) {
    CHECK(page.says(std::string("\n.SS ") + command + "\n"));
    CHECK(bash.says(std::string("    ") + command + ") words="));
    CHECK(zsh.says(std::string("'") + command + ":"));
  }
  CHECK(page.says("\\fB\\-\\-equations\\fR"));
  // Options of a group as well.
  CHECK(bash.says("--scenario"));
  CHECK(here.sinew({"manual", "--bash", "--zsh"}).status == 2);
}
