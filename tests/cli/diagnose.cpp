// SPDX-License-Identifier: GPL-3.0-or-later
// sinew diagnose from the command line: a slide whose friction is stronger one way than the other.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/cli/slide_log.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

constexpr int kDiagnosedRows = 8000;

/// Every joint of the finger to and fro by its antagonists.
std::string finger_scenario(double phase) {
  std::string text = R"([scenario]
duration = { value = 6, unit = "s" }
output_rate = { value = 1000, unit = "Hz" }
[integrator]
relative_tolerance = { value = 1e-6, unit = "1" }
absolute_tolerance = { value = 1e-8, unit = "1" }
[drive]
mode = "servo"
gain = { value = 60, unit = "N*m" }
rate_gain = { value = 2, unit = "N*m*s/rad" }
compensation = true
pretension = { value = 15, unit = "N" }
[noise]
seed = { value = 1, unit = "1" }
q = { value = 1e-5, unit = "rad" }
force = { value = 0.1, unit = "N" }
tau = { value = 5e-3, unit = "N*m" }
)";
  const int signs[8][4] = {{1, 1, 0, 0}, {1, -1, 0, 0}, {-1, 1, 0, 0}, {-1, -1, 0, 0},
                           {0, 0, 1, 0}, {0, 0, -1, 0}, {0, 0, 1, -1}, {0, 0, -1, 1}};
  const double size[] = {0.15, 0.3, 0.3, 0.25}, rate[] = {0.7, 0.9, 0.6, 1.1};
  for (int tendon = 0; tendon < 8; ++tendon)
    for (int joint = 0; joint < 4; ++joint)
      if (signs[tendon][joint] != 0)
        text += fmt::format(
            "[[command]]\nchannel = \"theta_{}_ref\"\nshape = \"sine\"\n"
            "amplitude = {{ value = {}, unit = \"rad\" }}\n"
            "frequency = {{ value = {}, unit = \"Hz\" }}\n"
            "phase = {{ value = {}, unit = \"rad\" }}\n",
            tendon + 1, -1.2 * signs[tendon][joint] * size[joint], rate[joint], phase + joint);
  return text;
}

struct Bench : Workplace {
  explicit Bench(double difference) {
    reference::write_text(path("slide.urdf"), test::slide_urdf);
    REQUIRE(sinew({"import", "slide.urdf", "--out", "models/slide"}).status == 0);
    reference::write_text(path("train.csv"), test::slide_log(1, difference, kDiagnosedRows));
    reference::write_text(path("test.csv"), test::slide_log(2, difference, kDiagnosedRows));
  }
  Ended diagnose(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"diagnose",  "models/slide", "--log", "train.csv",
                                       "--holdout", "test.csv",     "--out", "found"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return sinew(arguments);
  }
};

}  // namespace

TEST_CASE("a cause is named, the model extended and its C generated with it") {
  const Bench bench(1.5);
  const Ended ended = bench.diagnose();
  INFO(ended.output);
  CHECK(ended.status == 1);
  CHECK(ended.says("viscous asymmetry"));
  CHECK(ended.says("report.html"));
  const auto findings = nlohmann::json::parse(bench.text("found/findings.json"));
  CHECK(findings.at("extension").at("adopted") == true);
  CHECK(bench.text("models/slide/identified.toml").find("viscous_asymmetry") != std::string::npos);

  CHECK(bench.sinew({"generate", "models/slide"}).status == 0);
  const std::string c = bench.text("generated/slide/slide.c");
  CHECK(c.find("void slide_effort(") != std::string::npos);
  CHECK(c.find("void slide_compensation(") != std::string::npos);

  // The extended model leaves nothing over.
  const Ended again = bench.diagnose();
  INFO(again.output);
  CHECK(again.status == 0);
}

TEST_CASE("where the model is right nothing is named and nothing changes") {
  const Bench bench(0.0);
  const Ended ended = bench.diagnose();
  INFO(ended.output);
  CHECK(ended.status == 0);
  CHECK(fs::exists(bench.path("found/report.html")));
  CHECK_FALSE(fs::exists(bench.path("models/slide/identified.toml")));
}

TEST_CASE("a dry run leaves the model as it is") {
  const Bench bench(1.5);
  const Ended ended = bench.diagnose({"--dry-run"});
  CHECK(ended.status == 1);
  // Said once that the model held the terms.
  CHECK(ended.output.find("without --dry-run it takes the terms") != std::string::npos);
  CHECK_FALSE(fs::exists(bench.path("models/slide/identified.toml")));
  CHECK(fs::exists(bench.path("found/identified.toml")));
  CHECK(fs::exists(bench.path("found/generated/slide/slide.c")));
}

TEST_CASE("a load that only one log has counts as none in the other, which is said") {
  // Planted defect: no complete_loads(): the library reads a load that is not there, and crashes.
  const Workplace here;
  for (const char* file : {"train.csv", "test.csv"})
    fs::copy(std::string(SINEW_SOURCE_DIR "/examples/diagnosis/") + file, here.path(file));
  fs::copy(SINEW_SOURCE_DIR "/models/motor", here.path("models/drive"),
           fs::copy_options::recursive);
  std::istringstream lines(here.text("train.csv"));
  std::string loaded, line;
  std::getline(lines, line);
  loaded = line + ",load [N*m]\n";
  for (int row = 0; std::getline(lines, line); ++row)
    loaded += fmt::format("{},{}\n", line, row % 400 < 200 ? 0.01 : -0.01);
  reference::write_text(here.path("train.csv"), loaded);
  std::vector<std::string> arguments{"diagnose", "models/drive", "--log", "train.csv", "--holdout",
                                     "test.csv", "--out",        "found", "--quick"};
  for (const char* map :
       {"theta=Motor Position (rad)", "tau_m=Motor Torque (N·m)", "time=Time (s)"})
    arguments.insert(arguments.end(), {"--map", map});
  const Ended ended = here.sinew(arguments);
  INFO(ended.output);
  CHECK((ended.status == 0 || ended.status == 1));
  CHECK(here.text("found/findings.json").find("test.csv: has no column 'load'") !=
        std::string::npos);
}

TEST_CASE("a first look names what is large, says that it is one, and adopts nothing") {
  // Planted defect: no tell_first_look(): the model is extended.
  const Bench bench(1.5);
  const Ended ended = bench.diagnose({"--quick"});
  INFO(ended.output);
  CHECK(ended.status == 1);
  CHECK(ended.says("At a first look: "));
  CHECK(ended.says("viscous asymmetry"));
  CHECK(ended.says("a first look adopts nothing"));
  CHECK_FALSE(fs::exists(bench.path("models/slide/identified.toml")));
  CHECK_FALSE(fs::exists(bench.path("found/identified.toml")));
}

TEST_CASE("a payload on a finger is found in the forces of its tendons", "[slow][thorough]") {
  // The log comes from a copy whose distal link is heavier.
  const Workplace bench;
  for (const char* part : {"motor", "lever", "tendon", "guiding", "capstan"})
    fs::copy(fs::path(SINEW_SOURCE_DIR) / "models" / part, bench.path("models") / part,
             fs::copy_options::recursive);
  fs::copy(bench.path("models"), bench.path("measured"), fs::copy_options::recursive);
  bench.change("measured/index/mass_properties.csv", "distal,0.003", "distal,0.033");
  for (const auto& [name, phase] : {std::pair{"train", 0.3}, {"test", 1.9}}) {
    reference::write_text(bench.path(fmt::format("{}.toml", name)), finger_scenario(phase));
    const Ended run =
        bench.sinew({"simulate", "measured/index", "--scenario", fmt::format("{}.toml", name),
                     "--out", fmt::format("{}.csv", name)});
    INFO(run.output);
    REQUIRE(run.status == 0);
  }
  const Ended ended = bench.sinew({"diagnose", "models/index", "--log", "train.csv", "--holdout",
                                   "test.csv", "--out", "found"});
  INFO(ended.output);
  CHECK(ended.status == 1);
  CHECK(ended.says("payload (link distal)"));
  const auto findings = nlohmann::json::parse(bench.text("found/findings.json"));
  CHECK(findings.at("extension").at("adopted") == true);
  CHECK(bench.text("found/generated/index/index.c").find("void index_effort(") !=
        std::string::npos);
}

TEST_CASE("logs that cannot be used end with 2, say where, and nothing is written") {
  const Bench bench(0.0);
  bench.change("train.csv", "time [s],x [m],f [N]", "time [s],x [m],force");
  const Ended ended = bench.diagnose();
  CHECK(ended.status == 2);
  CHECK(ended.says("train.csv:1"));
  CHECK_FALSE(fs::exists(bench.path("found")));
  CHECK(bench.sinew({"diagnose", "models/slide", "--log", "none.csv", "--out", "found"}).status ==
        2);
  CHECK(bench.sinew({"diagnose", "models/none", "--log", "test.csv", "--out", "found"}).status ==
        2);
}

TEST_CASE("a model's folder says what a recorder calls its channels") {
  // Planted defect: without mapped_channels() in cli/diagnose.cpp the log has no effort.
  const Bench bench(1.5);
  for (const char* log : {"train.csv", "test.csv"}) {
    std::string text = bench.text(log);
    text.replace(0, text.find('\n'), "time [s],carriage [m],drive force");
    reference::write_text(bench.path(log), text);
  }
  CHECK(bench.diagnose().status == 2);
  const std::string channels = "[channels]\nq_x = \"carriage [m]\"\n";
  reference::write_text(bench.path("models/slide/channels.toml"),
                        channels + "tau_x = \"drive force [N]\"\n");
  const Ended named = bench.diagnose({"--dry-run"});
  INFO(named.output);
  CHECK(named.status == 1);
  CHECK(named.says("viscous asymmetry"));
  // --map goes before it.
  reference::write_text(bench.path("models/slide/channels.toml"),
                        channels + "tau_x = \"none [N]\"\n");
  CHECK(bench.diagnose({"--dry-run"}).status == 2);
  CHECK(bench.diagnose({"--dry-run", "--map", "tau_x=drive force [N]"}).status == 1);
  reference::write_text(bench.path("models/slide/channels.toml"), channels + "tau_x = 3\n");
  const Ended wrong = bench.diagnose();
  CHECK(wrong.status == 2);
  CHECK(wrong.says("channels.toml:3"));
  CHECK(wrong.says("column name [unit]"));
}

TEST_CASE("currents are read with the constant that what was learnt holds with") {
  // Planted defect, seen to fail: without torque_constants in identified.toml a measured arm's
  // second log, with a load, was read with constants that were fitted to it: no payload, and a
  // wrist with six times its motion's standard deviation left over.
  const Bench bench(1.5);
  for (const char* log : {"train.csv", "test.csv"}) {
    std::string text = bench.text(log);
    text.replace(text.find("f [N]"), 5, "i_x [A]");
    reference::write_text(bench.path(log), text);
  }
  const auto diagnose = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"diagnose",  "models/slide", "--log", "train.csv",
                                       "--holdout", "test.csv",     "--out", "found",
                                       "--map",     "q_x=x [m]"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bench.sinew(arguments);
  };
  const Ended first = diagnose({"--torque-constant", "x=1"});
  INFO(first.output);
  REQUIRE(first.status == 1);
  const std::string learnt = bench.text("models/slide/identified.toml");
  CHECK(learnt.find("[[torque_constant]]\njoint = \"x\"") != std::string::npos);
  const Ended again = diagnose({"--dry-run"});
  INFO(again.output);
  CHECK(again.status == 0);
  const Ended other = diagnose({"--torque-constant", "x=2"});
  CHECK(other.status == 2);
  CHECK(other.says("identified.toml was learnt from currents with 1"));
  CHECK(bench.text("models/slide/identified.toml") == learnt);
}

TEST_CASE("the manual's page of effects is what the program says") {
  const Workplace here;
  const Ended page = here.sinew({"effects"});
  CHECK(page.status == 0);
  CHECK(page.output == reference::read_text(SINEW_SOURCE_DIR "/docs/effects.md"));
}
