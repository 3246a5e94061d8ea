// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be is refused where it is read, and no library speaks to a user.
#include <cln/exception.h>
#include <ginac/ginac.h>

#include <toml++/toml.h>
#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/clear_message.h"
#include "symbolic/files/description_error.h"
#include "tests/cli/program.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

/// Its last link is a rod along the last joint's axis.
constexpr const char* robot_with_a_rod = R"(<robot name="rod"><link name="base"/>
<link name="upper"><inertial><origin xyz="0.1 0 0"/><mass value="1"/>
<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="rod"><inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="0.1"/>
<inertia ixx="0.001" iyy="0.001" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="3"/></joint>
<joint name="spin" type="revolute"><parent link="upper"/><child link="rod"/>
<origin xyz="0.2 0 0" rpy="0.3 0.2 0.1"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="5" velocity="3"/></joint></robot>)";

/// What a user reads for an error.
template <class Act>
std::string told(Act act) {
  try {
    act();
  } catch (const std::exception& error) {
    return clear_message(error);
  }
  return "";
}

}  // namespace

TEST_CASE("a joint that moves no inertia is told, and all but the inverse is generated") {
  // Planted defect: forward_dynamics not left out (dynamics_functions.cpp): generate ends with
  // "power::eval(): division by zero".
  const Workplace here;
  reference::write_text(here.path("rod.urdf"), robot_with_a_rod);
  const Ended imported = here.sinew({"import", "rod.urdf", "--out", "models/rod"});
  INFO(imported.output);
  CHECK(imported.status == 0);
  CHECK(imported.says("joint 'spin' can move without moving any inertia"));
  CHECK(imported.says("inertia about its axis"));
  const Ended generated = here.sinew({"generate", "models/rod"});
  INFO(generated.output);
  REQUIRE(generated.status == 0);
  CHECK(generated.says("joint 'spin' can move without moving any inertia"));
  CHECK(generated.says("forward_dynamics"));
  const std::string header = here.text("generated/rod/rod.h");
  CHECK(header.find("rod_inverse_dynamics(") != std::string::npos);
  CHECK(header.find("rod_mass_matrix(") != std::string::npos);
  CHECK(header.find("rod_forward_dynamics(") == std::string::npos);
  CHECK(header.find("Note: the mass matrix is singular") != std::string::npos);
  CHECK(here.text("generated/rod/manifest.json").find("forward_dynamics\"") == std::string::npos);
  const Ended checked = here.sinew({"check", "models/rod"});
  INFO(checked.output);
  CHECK(checked.status == 0);
  const Ended json = here.sinew({"generate", "models/rod", "--json"});
  CHECK(nlohmann::json::parse(json.output).at("notes").size() == 1);
  // With some inertia about its axis all is there.
  here.change("models/rod/mass_properties.csv", "rod,0.1,0", "rod,0.1,0.01");
  const Ended whole = here.sinew({"generate", "models/rod"});
  INFO(whole.output);
  CHECK(whole.status == 0);
  CHECK(here.text("generated/rod/rod.h").find("rod_forward_dynamics(") != std::string::npos);
}

TEST_CASE("an identified.toml that makes a link impossible is refused with its place") {
  const Workplace here;
  const auto learnt = [&](const std::string& text) {
    reference::write_text(here.path("models/index/identified.toml"), text);
    return here.sinew({"generate", "models/index"});
  };
  const std::string payload =
      "[[effect]]\neffect = \"payload\"\nplace = \"link distal\"\n"
      "[[effect.coefficient]]\nname = \"mass\"\nvalue = 0.01\nunit = \"kg\"\n";
  const std::string moment =
      "[[effect.coefficient]]\nname = \"moment_xx\"\nvalue = -1\nunit = \"kg*m^2\"\n";
  // Defects to plant: without is_physical() status 0 and a mass matrix with M[0][0] < 0; a Stribeck
  // velocity that is not checked: "power::eval(): division by zero".
  const Ended impossible = learnt(payload + moment);
  INFO(impossible.output);
  CHECK(impossible.status == 2);
  CHECK(impossible.says("identified.toml:2:"));
  CHECK(impossible.says("link 'distal'"));
  const Ended stribeck = learnt(
      "[[effect]]\neffect = \"stribeck\"\nplace = \"q20\"\n"
      "[[effect.shape]]\nname = \"stribeck_velocity\"\nvalue = 0\nunit = \"rad/s\"\n"
      "[[effect.coefficient]]\nname = \"extra_at_rest\"\nvalue = 0.1\nunit = \"N*m\"\n");
  INFO(stribeck.output);
  CHECK(stribeck.status == 2);
  CHECK(stribeck.says("identified.toml:6:"));
  CHECK_FALSE(fs::exists(here.path("generated/index")));
  const Ended fine = learnt(payload);
  INFO(fine.output);
  CHECK(fine.status == 0);
}

TEST_CASE("the simulation refuses what was learnt and cannot be, as the generator does") {
  // Planted defect: the extension read without its model's places and without a look at the mass
  // matrix (checked_extension.cpp): both are simulated, the joint with less than no inertia too.
  const Workplace here;
  const auto inertia = [&](const char* place, const char* change) {
    reference::write_text(here.path("models/index/identified.toml"),
                          std::string("[[effect]]\neffect = \"inertia\"\nplace = \"") + place +
                              "\"\n[[effect.coefficient]]\nname = \"inertia_change\"\nvalue = " +
                              change + "\nunit = \"kg*m^2\"\n");
  };
  const auto refused = [&](const char* expected) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"generate", "models/index"},
          {"simulate", "models/index", "--scenario", "models/index/scenarios/energy.toml", "--out",
           "run.csv"}}) {
      const Ended ended = here.sinew(command);
      INFO(ended.output);
      CHECK(ended.status == 2);
      CHECK(ended.says("identified.toml"));
      CHECK(ended.says(expected));
    }
  };
  inertia("q99", "1e-6");
  refused("q99");
  inertia("q20", "-1");
  refused("would not be positive definite at ");
  CHECK_FALSE(fs::exists(here.path("run.csv")));
}

TEST_CASE("what a library throws is told in words of the program") {
  // Planted defect: clear_message() giving what() back: all but the last three are red.
  using Catch::Contains;
  CHECK_THAT(told([] { GiNaC::pow(GiNaC::ex(0), -1); }),
             Contains("divides by zero") && Contains("[power::eval(): division by zero]"));
  CHECK_THAT(told([] { throw std::runtime_error("numeric::inverse(): division by zero"); }),
             Contains("was not foreseen"));
  CHECK_THAT(told([] { (void)std::stod("a"); }), Contains("was not foreseen"));
  CHECK_THAT(told([] { (void)std::string("a").at(3); }), Contains("was not foreseen"));
  CHECK_THAT(told([] { (void)nlohmann::json::parse("{"); }), Contains("JSON"));
  CHECK_THAT(told([] { (void)toml::parse("a ="); }), Contains("was not foreseen"));
  CHECK_THAT(told([] { throw CLI::ConversionError("x"); }), Contains("--help"));
  CHECK_THAT(told([] { throw std::bad_alloc(); }), Contains("memory is not enough"));
  CHECK(told([] { (void)fs::file_size("/none"); }) == "/none: No such file or directory");
  // Its own stay as they are.
  CHECK(told([] { throw std::runtime_error("a.toml: there is no joint 'b'"); }) ==
        "a.toml: there is no joint 'b'");
  CHECK(told([] { throw DescriptionError({"a.toml:1:2: wrong; expected right"}); }) ==
        "a.toml:1:2: wrong; expected right");
}
