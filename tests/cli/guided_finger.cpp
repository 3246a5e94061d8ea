// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulation hides in a finger's guides, and a push at its tip, a diagnosis finds.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

using namespace sinew;
using nlohmann::json;

namespace {

/// All joints to and fro by their antagonists, capstan friction in every guide.
std::string scenario(double seconds, double faster, const std::string& push) {
  std::string text = fmt::format(R"([scenario]
duration = {{ value = {}, unit = "s" }}
output_rate = {{ value = 1000, unit = "Hz" }}
[drive]
mode = "servo"
gain = {{ value = 60, unit = "N*m" }}
rate_gain = {{ value = 2, unit = "N*m*s/rad" }}
compensation = true
pretension = {{ value = 15, unit = "N" }}
[losses]
guiding = "capstan"
[noise]
q = {{ value = 2e-5, unit = "rad" }}
force = {{ value = 0.02, unit = "N" }}
[initial]
q21 = {{ value = 0.7, unit = "rad" }}
q22 = {{ value = 0.7, unit = "rad" }}
q23 = {{ value = 0.7, unit = "rad" }}
)",
                                 seconds);
  const double ways[8][4] = {{1.3, 1.3, 0, 0},   {1.3, -1.3, 0, 0}, {-1.3, 1.3, 0, 0},
                             {-1.3, -1.3, 0, 0}, {0, 0, 1.1, 0},    {0, 0, -1.1, 0},
                             {0, 0, 1.1, -0.9},  {0, 0, -1.1, 0.9}};
  const double size[4] = {0.2, 0.35, 0.35, 0.35}, hertz[4] = {0.71, 0.31, 0.43, 0.57};
  for (int tendon = 0; tendon < 8; ++tendon)
    for (int joint = 0; joint < 4; ++joint)
      for (int wave = 0; wave < 2; ++wave)
        if (ways[tendon][joint] != 0.0)
          text += fmt::format(
              "[[command]]\nchannel = \"theta_{}_ref\"\nshape = \"sine\"\n"
              "amplitude = {{ value = {}, unit = \"rad\" }}\n"
              "frequency = {{ value = {}, unit = \"Hz\" }}\n",
              tendon + 1, -ways[tendon][joint] * size[joint] * (wave == 0 ? 0.8 : 0.4),
              faster * hertz[joint] * (wave == 0 ? 1.0 : 2.3));
  return text + push;
}

constexpr const char* kPush = R"([[command]]
channel = "tip_force_z"
value = { value = 1, unit = "N" }
from = { value = 8, unit = "s" }
to = { value = 9, unit = "s" }
)";

/// The same log as of a finger whose motors nobody logs.
std::string without_motors(const std::string& text) {
  std::string kept;
  std::vector<bool> is_kept;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); kept += '\n') {
    std::istringstream cells(line);
    std::size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column) {
      if (kept.empty() || is_kept.size() <= column)
        is_kept.push_back(!cell.starts_with("theta_") && !cell.starts_with("tau_"));
      if (is_kept[column]) kept += (column == 0 ? "" : ",") + cell;
    }
  }
  return kept;
}

/// What is told of a finger with friction in its guides and a push at its tip.
struct Told {
  int causes = 0, pushes = 0;
  std::string pushed;          ///< where
  double of_all_guides = 0.0;  ///< friction coefficient
  bool none_of_the_known = false;
};

Told told_by(const json& verdict) {
  Told told;
  for (const json& cause : verdict.at("causes")) {
    const json& first = cause.at("members").at(0);
    const auto name = first.at("name").get<std::string>();
    const auto where = first.at("place").get<std::string>();
    ++told.causes;
    if (name == "guiding friction" && where == "all tendons")
      told.of_all_guides = cause.at("parameters").at(0).at("value").get<double>();
    if (name != "unlogged force") continue;
    ++told.pushes;
    told.pushed = where;
  }
  told.none_of_the_known = verdict.at("unexplained").at("none_of_the_known").get<bool>();
  return told;
}

/// Whether a friction of the guides' name is learnt at a tendon, with or without pre-sliding.
bool is_learnt_at(const std::string& learnt, int tendon) {
  for (const char* law : {"guiding_friction", "guiding_presliding"})
    if (learnt.find(fmt::format("effect = \"{}\"\nplace = \"tendon h{}\"", law, tendon)) !=
        std::string::npos)
      return true;
  return false;
}

/// Told of 16 s with the push, of which 10 s without are held out.
void check_told(bool motors) {
  const Workplace place;
  const auto log = [&](const std::string& file, const std::string& text) {
    reference::write_text(place.path(file + ".toml"), text);
    const Ended run = place.sinew({"simulate", SINEW_SOURCE_DIR "/models/index", "--scenario",
                                   file + ".toml", "--out", file + ".csv"});
    INFO(run.output);
    REQUIRE(run.status == 0);
    if (!motors)
      reference::write_text(place.path(file + ".csv"), without_motors(place.text(file + ".csv")));
  };
  log("train", scenario(16, 1.0, kPush));
  log("test", scenario(10, 1.13, ""));
  const Ended ended =
      place.sinew({"diagnose", SINEW_SOURCE_DIR "/models/index", "--log", "train.csv", "--holdout",
                   "test.csv", "--out", "found", "--dry-run"});
  INFO(ended.output);
  REQUIRE(ended.status == 1);
  const Told told = told_by(json::parse(place.text("found/findings.json")).at("verdict"));
  CHECK(told.causes == 2);
  CHECK(told.of_all_guides == Approx(0.1).margin(0.004));
  CHECK(told.pushes == 1);
  CHECK(told.pushed == "link distal");
  CHECK_FALSE(told.none_of_the_known);
  const std::string learnt = place.text("found/identified.toml");
  for (int tendon = 1; tendon <= 8; ++tendon) CHECK(is_learnt_at(learnt, tendon));
}

}  // namespace

// One of the next two was seen to fail with measured forces in the place of those that agree with
// the model (routing offsets of nearly a pulley's radius are told), and with the guides of each
// tendon by itself alone: six of them, up to 0.19 for their antagonists, too. With friction's
// direction worked out at a thinned rate a motor's friction turned with 0.5 N·m, and nothing was
// adopted. With one second look at what is disturbed, in blocks of 32 KiB (block_sizes.h), the push
// stayed set aside by its first half, and nothing of it was told. With a price of a number for
// every sample of the push it was not told without the motors: structure over the stroke was worth
// more.
TEST_CASE("friction in a finger's guides is told, and a push at its tip", "[slow][thorough]") {
  check_told(false);
}

TEST_CASE("friction in a finger's guides is told, and a push at its tip, by its motors, too",
          "[slow][thorough]") {
  check_told(true);
}
