// SPDX-License-Identifier: GPL-3.0-or-later
// A measured six-joint arm from its motors' currents, where its logs are present.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/skip.h"

namespace {

using namespace sinew;
using nlohmann::json;

const std::string data = SINEW_SOURCE_DIR "/../shared/data/ur10e/";

/// Published, N·m/A.
const std::map<std::string, double> constants{
    {"shoulder_pan_joint", 14.87}, {"shoulder_lift_joint", 13.26}, {"elbow_joint", 11.13},
    {"wrist_1_joint", 10.62},      {"wrist_2_joint", 11.03},       {"wrist_3_joint", 11.47}};

json diagnosed(const Workplace& here, const std::vector<std::string>& logs,
               const std::vector<std::string>& holdout, const std::string& out,
               const std::vector<std::string>& conditions = {}) {
  std::vector<std::string> arguments{"diagnose", "arm", "--out", out, "--log"};
  arguments.insert(arguments.end(), logs.begin(), logs.end());
  arguments.push_back("--holdout");
  arguments.insert(arguments.end(), holdout.begin(), holdout.end());
  for (const std::string& condition : conditions)
    arguments.insert(arguments.end(), {"--condition", condition});
  for (const auto& [joint, value] : constants) {
    arguments.push_back("--torque-constant");
    arguments.push_back(joint + "=" + std::to_string(value));
  }
  const Ended ended = here.sinew(arguments);
  INFO(ended.output);
  REQUIRE(ended.status == 1);
  return json::parse(here.text(out + "/findings.json"));
}

/// The parameter that a cause tells, NaN where it is not named.
double told(const json& findings, const std::string& cause, const std::string& place) {
  for (const json& c : findings["verdict"]["causes"])
    for (const json& m : c["members"])
      if (m["name"] == cause && m["place"] == place) return c["parameters"][0]["value"];
  return std::nan("");
}

}  // namespace

TEST_CASE("a measured arm tells its rotors and its friction from currents", "[slow]") {
  // Seen to fail before currents were read (no channel is there), with rests taken for stuck
  // readings, and with rotors hidden by the friction that was found: wrists 1 and 2 had none, and
  // the joints kept 4.8 to 12.8 % of their standard deviations. The first joint kept 10.4 % with
  // all names withdrawn at once that were not sure beside the others, 8.9 % with the rest's shapes
  // left.
  if (!std::filesystem::exists(data + "harmonics_unloaded.csv"))
    return sinew::test::skip("../shared/data/ur10e is absent");
  const Workplace here;
  REQUIRE(here.sinew({"import", data + "ur10e.urdf", "--out", "arm"}).status == 0);
  const json found = diagnosed(here, {data + "harmonics_unloaded.csv"},
                               {data + "point_to_point_unloaded.csv"}, "found");
  CHECK(found["extension"]["adopted"].get<bool>());
  for (const json& channel : found["channels"]) {
    INFO(channel["name"].get<std::string>());
    CHECK(channel["relative_error_after"].get<double>() < 0.085);
  }
  // Published for the last joint: 0.50 kg m^2.
  CHECK(told(found, "inertia", "joint wrist_3_joint") == Approx(0.5).margin(0.06));
  CHECK(told(found, "inertia", "joint wrist_1_joint") > 0.3);
  CHECK(told(found, "inertia", "joint wrist_2_joint") > 0.3);
  for (const json& log : found["logs"])
    for (const json& fault : log["faults"])
      CHECK(fault.get<std::string>().find("keeps one value") == std::string::npos);
}

TEST_CASE("logs with and without a load of known mass share one model", "[slow][thorough]") {
  // Seen to fail: with no limit to a link's mass the shoulder's rotor was 120 kg of upper arm,
  // which no body has, and its joint kept 104 % of its standard deviation; so it did where the
  // adopted fit took another form of the same friction, whose term was left out of the model
  // without a word. Without the condition no payload is told and the shoulder's rotor is 10.7 kg
  // m^2.
  if (!std::filesystem::exists(data + "harmonics_loaded.csv"))
    return sinew::test::skip("../shared/data/ur10e is absent");
  const Workplace here;
  REQUIRE(here.sinew({"import", data + "ur10e.urdf", "--out", "arm"}).status == 0);
  const json found = diagnosed(
      here, {data + "harmonics_unloaded.csv", data + "harmonics_loaded.csv"},
      {data + "point_to_point_unloaded.csv"}, "found", {"harmonics_loaded.csv:payload=2.805kg"});
  CHECK(found["extension"]["adopted"].get<bool>());
  for (const json& channel : found["channels"]) {
    INFO(channel["name"].get<std::string>());
    CHECK(channel["relative_error_after"].get<double>() < 0.12);
  }
  // By its own log alone the bare arm carries 0.75 kg at its last link, which is not in its
  // drawing.
  const Workplace alone;
  REQUIRE(alone.sinew({"import", data + "ur10e.urdf", "--out", "arm"}).status == 0);
  const json bare = diagnosed(alone, {data + "harmonics_unloaded.csv"},
                              {data + "point_to_point_unloaded.csv"}, "found");
  const double at_flange = told(bare, "payload", "link wrist_3_link");
  REQUIRE(at_flange == Approx(0.75).margin(0.1));
  CHECK(told(found, "payload", "link wrist_3_link") == Approx(at_flange).margin(0.2));
  // The rotor that the data's own page tells: 8 kg m^2.
  CHECK(told(found, "inertia", "joint shoulder_pan_joint") == Approx(8.0).margin(1.5));
}
