// SPDX-License-Identifier: GPL-3.0-or-later
// A measured six-joint arm from its motors' currents, where its logs are present.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/skip.h"

namespace {

using namespace sinew;
using nlohmann::json;

const std::string data = SINEW_SOURCE_DIR "/../shared/data/ur10e/";

/// Published, N·m/A.
const std::map<std::string, double> constants{{"shoulder_pan_joint", 14.87},
                                              {"shoulder_lift_joint", 13.26},
                                              {"elbow_joint", 11.13},
                                              {"wrist_1_joint", 10.62},
                                              {"wrist_2_joint", 11.03},
                                              {"wrist_3_joint", 11.47}};

/// The first half of a log and its second.
std::pair<std::string, std::string> halves(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line + "\n");
  std::pair<std::string, std::string> parts{lines.front(), lines.front()};
  for (std::size_t k = 1; k < lines.size(); ++k)
    (2 * k < lines.size() ? parts.first : parts.second) += lines[k];
  return parts;
}

json diagnosed(const Workplace& here, const std::string& log, const std::string& holdout,
               const std::string& out) {
  std::vector<std::string> arguments{"diagnose", "arm",     "--log", log,
                                     "--holdout", holdout, "--out", out};
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

TEST_CASE("a measured arm tells its rotors and its friction from currents, and then its load",
          "[slow]") {
  if (!std::filesystem::exists(data + "harmonics_unloaded.csv"))
    return sinew::test::skip("../shared/data/ur10e is absent");
  const Workplace here;
  REQUIRE(here.sinew({"import", data + "ur10e.urdf", "--out", "arm"}).status == 0);
  const json bare = diagnosed(here, data + "harmonics_unloaded.csv",
                              data + "point_to_point_unloaded.csv", "bare");
  CHECK(bare["extension"]["adopted"] == true);
  for (const json& channel : bare["channels"]) {
    INFO(channel["name"]);
    CHECK(channel["relative_error_after"] < 0.14);
    CHECK(channel["relative_error_after"] < 0.5 * channel["relative_error_before"].get<double>());
  }
  // Published for this joint: 0.50 kg m^2.
  CHECK(told(bare, "inertia", "joint wrist_3_joint") == Approx(0.5).margin(0.06));
  for (const json& log : bare["logs"])
    for (const json& fault : log["faults"])
      CHECK(fault.get<std::string>().find("keeps one value") == std::string::npos);
}
