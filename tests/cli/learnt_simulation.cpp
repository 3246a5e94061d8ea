// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnosis adopts acts in the simulation: on a held-out log its error falls from the
// number that the report gives before to the one that it gives after, channel by channel.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/lever_logs.h"
#include "tests/cli/wrist_logs.h"

using namespace sinew;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct Sine {
  std::string channel, unit;
  double amplitude, hertz, phase;
};

std::string text_of(const Sine& sine) {
  return fmt::format(
      "[[command]]\nchannel = \"{}\"\nshape = \"sine\"\n"
      "amplitude = {{ value = {}, unit = \"{}\" }}\nfrequency = {{ value = {}, unit = \"Hz\" }}\n"
      "phase = {{ value = {}, unit = \"rad\" }}\n",
      sine.channel, sine.amplitude, sine.unit, sine.hertz, sine.phase);
}

std::string times(double duration, double rate) {
  return fmt::format(
      "[scenario]\nduration = {{ value = {}, unit = \"s\" }}\n"
      "output_rate = {{ value = {}, unit = \"Hz\" }}\n",
      duration, rate);
}

/// models/<name> as it is drawn, measured/<name> as it is.
class Loop : public Workplace {
 public:
  explicit Loop(std::string name) : name_(std::move(name)) {}

  void copy_models() const {
    fs::remove_all(path("models"));
    fs::copy(SINEW_SOURCE_DIR "/models", path("models"), fs::copy_options::recursive);
  }
  /// Entries of measured/<name>/identified.toml.
  void hide(const std::string& entries) const {
    fs::copy(path("models"), path("measured"), fs::copy_options::recursive);
    reference::write_text(path("measured/" + name_ + "/identified.toml"), entries);
  }
  void log(const std::string& file, const std::string& scenario) const {
    reference::write_text(path(file + ".toml"), scenario);
    const Ended run = sinew(
        {"simulate", "measured/" + name_, "--scenario", file + ".toml", "--out", file + ".csv"});
    INFO(run.output);
    REQUIRE(run.status == 0);
  }
  /// Adopts, and gives the findings.
  json diagnosed() const {
    const Ended ended = sinew({"diagnose", "models/" + name_, "--log", "train.csv", "--holdout",
                               "test.csv", "--out", "found"});
    INFO(ended.output);
    REQUIRE(ended.status == 1);
    json findings = json::parse(text("found/findings.json"));
    REQUIRE(findings.at("extension").at("adopted") == true);
    return findings;
  }
  /// `sinew simulate --log test.csv`: the deviations of every channel.
  json replayed() const {
    const Ended ended =
        sinew({"simulate", "models/" + name_, "--log", "test.csv", "--out", "again.csv", "--json"});
    INFO(ended.output);
    REQUIRE(ended.status == 0);
    return json::parse(ended.output.substr(ended.output.find('{'))).at("deviations");
  }

 private:
  std::string name_;
};

const json* domain_of(const json& channel, const std::string& name) {
  for (const json& domain : channel.at("domains"))
    if (domain.at("domain") == name) return &domain;
  return nullptr;
}

/// The report's number of each channel and the simulation's, before and after: `key` of the
/// replay is `domain` of the report. Root mean square over all instants, nothing masked.
void compare(const json& findings, const json& before, const json& after, const std::string& domain,
             const std::string& key, double tolerance) {
  REQUIRE(before.size() == after.size());
  for (std::size_t c = 0; c < before.size(); ++c) {
    const json* said = domain_of(findings.at("channels").at(c), domain);
    INFO(domain << " of " << before[c].at("channel"));
    REQUIRE(said);
    const double was = before[c].at(key), is = after[c].at(key);
    INFO("report " << said->at("before") << " -> " << said->at("after") << ", simulation " << was
                   << " -> " << is);
    CHECK(was == Approx(said->at("before").get<double>()).epsilon(tolerance));
    CHECK(is == Approx(said->at("after").get<double>()).epsilon(tolerance));
  }
}

std::string entry(const std::string& effect, const std::string& place, const std::string& rest) {
  return fmt::format("[[effect]]\neffect = \"{}\"\nplace = \"{}\"\n{}", effect, place, rest);
}

std::string value_of(const std::string& kind, const std::string& name, double value,
                     const std::string& unit) {
  return fmt::format("[[effect.{}]]\nname = \"{}\"\nvalue = {}\nunit = \"{}\"\n", kind, name, value,
                     unit);
}

}  // namespace

// Planted defect: identified.toml not read by the simulation (taken away before the log is played
// again). The motor's open loop stays at 19.8 rad where the report says 0.58.

TEST_CASE("a motor's friction that was learnt acts in its simulation", "[learnt]") {
  const Loop loop("motor");
  loop.copy_models();
  loop.hide(entry("coulomb_asymmetry", "motor", value_of("coefficient", "difference", 0.2, "N*m")));
  for (const auto& [name, phase] : {std::pair{"train", 0.2}, {"test", 1.7}}) {
    std::string scenario = times(12, 1000) +
                           "[drive]\nmode = \"servo\"\ngain = { value = 40, unit = \"N*m\" }\n"
                           "rate_gain = { value = 1, unit = \"N*m*s/rad\" }\n"
                           "[noise]\ntheta = { value = 1e-5, unit = \"rad\" }\ntau = { value = "
                           "5e-3, unit = \"N*m\" }\n";
    for (const auto& [size, rate] : {std::pair{1.0, 0.31}, {0.5, 0.83}, {0.2, 1.7}})
      scenario += text_of({"theta_ref", "rad", size, rate, phase * rate * 5});
    loop.log(name, scenario);
  }
  const json before = loop.replayed();
  const json findings = loop.diagnosed();
  const json after = loop.replayed();
  compare(findings, before, after, "open loop", "open_loop", 0.02);
  compare(findings, before, after, "window", "window", 0.02);
  CHECK(after[0].at("open_loop").get<double>() < 0.1 * before[0].at("open_loop").get<double>());
}

namespace {

/// Two links that hang down; `payload` [kg] at the end of the lower one.
std::string hanging_arm(const char* elbow) {
  return fmt::format(R"(<robot name="arm"><link name="base"/>
<link name="upper"><inertial><origin xyz="0 0 -0.15"/><mass value="1"/>
<inertia ixx="0.008" iyy="0.008" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="lower"><inertial><origin xyz="0 0 -0.12"/><mass value="0.6"/>
<inertia ixx="0.004" iyy="0.004" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="J1" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="20" velocity="10"/><dynamics damping="0.1" friction="0.2"/></joint>
{}<parent link="upper"/><child link="lower"/></joint></robot>)",
                     elbow);
}

constexpr const char* moving_elbow =
    R"(<joint name="J2" type="revolute"><origin xyz="0 0 -0.3"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="10" velocity="10"/><dynamics damping="0.05" friction="0.1"/>)";
constexpr const char* fixed_elbow =
    R"(<joint name="J2" type="fixed"><origin xyz="0 0 -0.3" rpy="0 0.3 0"/>)";

std::string arm_scenario(double phase, bool elbow) {
  std::string text =
      times(15, 500) +
      "[drive]\nmode = \"joint_torques\"\n"
      "[noise]\nq = { value = 1e-6, unit = \"rad\" }\ntau = { value = 5e-3, unit = \"N*m\" }\n";
  for (const auto& [size, rate] : {std::pair{1.6, 0.37}, {1.2, 0.9}, {0.8, 2.1}}) {
    text += text_of({"tau_J1", "N*m", size, rate, phase * rate * 4});
    if (elbow) text += text_of({"tau_J2", "N*m", 0.35 * size, 1.2 * rate, phase * rate * 7});
  }
  return text;
}

}  // namespace

TEST_CASE("an imported arm's payload and friction that were learnt act in its simulation",
          "[learnt][slow]") {
  // Its friction has no law over the velocity in the file: a bristle's state is learnt with it.
  const Loop loop("arm");
  fs::remove_all(loop.path("models"));
  reference::write_text(loop.path("arm.urdf"), hanging_arm(moving_elbow));
  REQUIRE(loop.sinew({"import", "arm.urdf", "--out", "models/arm"}).status == 0);
  loop.hide(entry("payload", "link lower",
                  value_of("coefficient", "mass", 0.2, "kg") +
                      value_of("coefficient", "first_moment_x", 0.0, "kg*m") +
                      value_of("coefficient", "first_moment_y", 0.0, "kg*m") +
                      value_of("coefficient", "first_moment_z", -0.05, "kg*m")) +
            entry("direction", "J1", value_of("shape", "presliding_length", 2e-3, "rad")) +
            entry("direction", "J2", value_of("shape", "presliding_length", 2e-3, "rad")));
  loop.log("train", arm_scenario(0.3, true));
  loop.log("test", arm_scenario(1.9, true));
  const json before = loop.replayed();
  const json findings = loop.diagnosed();
  CHECK(loop.text("models/arm/identified.toml").find("direction") != std::string::npos);
  const json after = loop.replayed();
  compare(findings, before, after, "open loop", "open_loop", 0.02);
  compare(findings, before, after, "window", "window", 0.02);
  for (std::size_t c = 0; c < after.size(); ++c)
    CHECK(after[c].at("open_loop").get<double>() < 0.3 * before[c].at("open_loop").get<double>());
}

TEST_CASE("a joint that does not move stops nothing: it is held, and said", "[learnt]") {
  // Planted defects: without hold_still_joints() (cli/logs/driven_request.cpp) the log is refused
  // for its constant channel; without Scenario::held the replay drops the lower link.
  const Loop loop("arm");
  fs::remove_all(loop.path("models"));
  reference::write_text(loop.path("arm.urdf"), hanging_arm(fixed_elbow));
  REQUIRE(loop.sinew({"import", "arm.urdf", "--out", "models/arm"}).status == 0);
  loop.hide(
      entry("viscous_asymmetry", "J1", value_of("coefficient", "difference", 0.15, "N*m*s/rad")));
  loop.log("train", arm_scenario(0.3, false));
  loop.log("test", arm_scenario(1.9, false));
  // As the recorder of a robot with a brake on its elbow writes it.
  for (const char* log : {"train.csv", "test.csv"}) {
    std::string text = loop.text(log), wider;
    for (std::size_t from = 0, row = 0; from < text.size(); ++row) {
      const std::size_t end = text.find('\n', from);
      wider +=
          text.substr(from, end - from) + (row == 0 ? ",q_J2 [rad],tau_J2 [N*m]" : ",0.3,0") + "\n";
      from = end + 1;
    }
    reference::write_text(loop.path(log), wider);
  }
  fs::remove_all(loop.path("models/arm"));
  reference::write_text(loop.path("arm.urdf"), hanging_arm(moving_elbow));
  REQUIRE(loop.sinew({"import", "arm.urdf", "--out", "models/arm"}).status == 0);
  const json before = loop.replayed();
  const json findings = loop.diagnosed();
  CHECK(findings.dump().find("joint 'J2' does not move in these logs: it is held at 0.3 rad") !=
        std::string::npos);
  REQUIRE(findings.at("channels").size() == 1);
  const json after = loop.replayed();
  REQUIRE(after.size() == 1);
  compare(findings, before, after, "open loop", "open_loop", 0.02);
}

namespace {

/// Every joint of the finger to and fro by its antagonists.
std::string finger_scenario(double phase) {
  std::string text = times(6, 600) + R"([drive]
mode = "servo"
gain = { value = 60, unit = "N*m" }
rate_gain = { value = 2, unit = "N*m*s/rad" }
compensation = true
pretension = { value = 15, unit = "N" }
[noise]
q = { value = 1e-5, unit = "rad" }
force = { value = 0.1, unit = "N" }
)";
  const int signs[8][4] = {{1, 1, 0, 0}, {1, -1, 0, 0}, {-1, 1, 0, 0}, {-1, -1, 0, 0},
                           {0, 0, 1, 0}, {0, 0, -1, 0}, {0, 0, 1, -1}, {0, 0, -1, 1}};
  const double size[] = {0.15, 0.3, 0.3, 0.25}, rate[] = {0.7, 0.9, 0.6, 1.1};
  for (int tendon = 0; tendon < 8; ++tendon)
    for (int joint = 0; joint < 4; ++joint)
      if (signs[tendon][joint] != 0)
        text += text_of({fmt::format("theta_{}_ref", tendon + 1), "rad",
                         -1.2 * signs[tendon][joint] * size[joint], rate[joint], phase + joint});
  return text;
}

}  // namespace

TEST_CASE("a finger's payload and guiding friction that were learnt act in its simulation",
          "[learnt][slow][thorough]") {
  // The forces are given, as they were measured, and joints compared over short windows: under
  // given forces a finger does not stay where it is.
  const Loop loop("index");
  loop.copy_models();
  loop.hide(entry("payload", "link distal",
                  value_of("coefficient", "mass", 0.03, "kg") +
                      value_of("coefficient", "first_moment_x", 3e-4, "kg*m")));
  for (const auto& [name, phase] : {std::pair{"train", 0.3}, {"test", 1.9}})
    loop.log(name, finger_scenario(phase));
  const json before = loop.replayed();
  const json findings = loop.diagnosed();
  const json after = loop.replayed();
  compare(findings, before, after, "window", "window", 0.05);
}

namespace {

/// Every motor of the hand to and fro, each at its own frequency.
std::string hand_scenario(double phase) {
  std::string text = times(4, 400) + R"([integrator]
relative_tolerance = { value = 1e-6, unit = "1" }
absolute_tolerance = { value = 1e-8, unit = "1" }
[drive]
mode = "servo"
gain = { value = 60, unit = "N*m" }
rate_gain = { value = 2, unit = "N*m*s/rad" }
compensation = true
pretension = { value = 15, unit = "N" }
[initial]
"hmc.theta2" = { value = 90, unit = "deg" }
[noise]
q = { value = 1e-5, unit = "rad" }
force = { value = 0.1, unit = "N" }
)";
  for (int i = 1; i <= 38; ++i)
    text += text_of({fmt::format("theta_{}_ref", i), "rad", 0.25 + 0.01 * (i % 5),
                     0.5 + std::fmod(0.037 * i, 0.8), phase + i});
  return text;
}

/// Without the thumb: its four straight tendons have no fixed moment arms, and under given forces
/// its base falls away from where it was within a window (docs/simulation.md).
json without_thumb(const json& channels, const char* name) {
  json rest = json::array();
  for (const json& channel : channels)
    if (channel.at(name).get<std::string>().find("thumb") == std::string::npos)
      rest.push_back(channel);
  return rest;
}

}  // namespace

TEST_CASE("a payload that was learnt at a hand's finger acts in the hand's simulation",
          "[learnt][slow][thorough]") {
  // Planted defect: hold_palm() left out (build_plant.cpp): the crank falls, and the fifth finger's
  // window is 0.093 rad where the report says 0.0088.
  const Loop loop("hand");
  loop.copy_models();
  loop.hide(entry("payload", "link index_distal",
                  value_of("coefficient", "mass", 0.03, "kg") +
                      value_of("coefficient", "first_moment_x", 3e-4, "kg*m")));
  for (const auto& [name, phase] : {std::pair{"train", 0.3}, {"test", 1.9}})
    loop.log(name, hand_scenario(phase));
  const json before = without_thumb(loop.replayed(), "channel");
  json findings = loop.diagnosed();
  findings.at("channels") = without_thumb(findings.at("channels"), "name");
  const json after = without_thumb(loop.replayed(), "channel");
  REQUIRE(before.size() == 14);
  CHECK(after[0].at("window").get<double>() < 0.1 * before[0].at("window").get<double>());
  compare(findings, before, after, "window", "window", 0.05);
}

TEST_CASE("what a lever's and a wrist's calibration taught acts in what their models say",
          "[learnt][slow][thorough]") {
  // Planted defect: replayed_rig() without the folder's identified.toml: the same before and after.
  const auto learns = [](const char* model, const auto& log) {
    INFO(model);
    const Loop loop(model);
    loop.copy_models();
    std::ofstream(loop.path("train.csv")) << log(1);
    std::ofstream(loop.path("test.csv")) << log(2);
    const json before = loop.replayed();
    const json findings = loop.diagnosed();
    const json after = loop.replayed();
    compare(findings, before, after, "sensor", "sensor", 0.02);
  };
  const Calibration lever({"spring_constant", "lever", {}, {{"spring_change", 0.1, 0.0, "1"}}});
  learns("lever", [&](unsigned seed) { return lever.log(seed, true); });
  const WristLog wrist({{"pulley_radius", "motor 3", {}, {{"change", 0.05, 0.0, "1"}}}});
  learns("wrist", [&](unsigned seed) { return wrist.log(seed); });
  const WristLog slow({{"sensor_low_pass", "q71", {}, {{"lag", 0.01, 0.0, "s"}}}});
  learns("wrist", [&](unsigned seed) { return slow.log(seed); });
  const WristLog loose({{"sensor_hysteresis", "q73", {}, {{"half_width", 0.003, 0.0, "rad"}}}});
  learns("wrist", [&](unsigned seed) { return loose.log(seed); });
}
