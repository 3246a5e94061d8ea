// SPDX-License-Identifier: GPL-3.0-or-later
// Commands from tables and from shapes are the same; forces at the tip act as the torques of their
// virtual work; a robot from elsewhere simulates.
#include <catch2/catch.hpp>
#include <cmath>

#include "symbolic/model/read_mechanism.h"
#include "tests/simulation/scenario_run.h"

using namespace sinew_tests;
using sinew::reference::read_text;
using sinew::reference::run_program;
using sinew::reference::TemporaryFolder;
using sinew::reference::write_text;

namespace {

/// Runs a model under a scenario that may name commands.csv.
Run with_table(const std::string& model, const std::string& scenario, const std::string& table) {
  const TemporaryFolder folder;
  write_text(folder.path() / "scenario.toml", scenario);
  write_text(folder.path() / "commands.csv", table);
  sinew::Plant plant = sinew::build_plant(source + "/models/" + model,
                                          folder.path() / "scenario.toml", source + "/runtime");
  return run(plant);
}

const std::string from_table = "[commands]\nfile = \"commands.csv\"\n";

/// Two links: one turns, one slides along it.
const std::string urdf = R"(<robot name="crane">
  <link name="base"/>
  <link name="arm"><inertial><origin xyz="0.2 0 0"/><mass value="1"/>
    <inertia ixx="0.001" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="trolley"><inertial><origin xyz="0 0 0"/><mass value="0.5"/>
    <inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="swing" type="revolute"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="10" velocity="10"/></joint>
  <joint name="reach" type="prismatic"><parent link="arm"/><child link="trolley"/>
    <origin xyz="0.1 0 0"/><axis xyz="1 0 0"/>
    <limit lower="-1" upper="1" effort="10" velocity="10"/></joint>
</robot>
)";

}  // namespace

TEST_CASE("a torque from a table moves a motor as the same ramp does", "[commands]") {
  const Run ramp = run("motor", scenario_text(0.1, 100, R"(
[drive]
mode = "torque"
[[command]]
channel = "tau_m"
shape = "ramp"
rise = { value = 2, unit = "N*m" }
to = { value = 0.2, unit = "s" }
)"));
  const Run table =
      with_table("motor", scenario_text(0.1, 100, "[drive]\nmode = \"torque\"\n" + from_table),
                 "time [ms],tau_m [mN*m]\n0,0\n100,1000\n200,2000\n");
  REQUIRE(table.rows.size() == ramp.rows.size());
  CHECK(std::abs(ramp.at(10, "theta")) > 1e-4);
  for (std::size_t i = 0; i < ramp.rows.size(); ++i)
    CHECK(table.at(i, "theta") == Approx(ramp.at(i, "theta")).margin(1e-7));
}

TEST_CASE("palm angles are read from a table", "[commands]") {
  const TemporaryFolder folder;
  write_text(folder.path() / "scenario.toml", scenario_text(1, 10, from_table));
  write_text(folder.path() / "commands.csv",
             "time [s],flexion [deg],abduction [rad]\n0,0,0.1\n1,90,0.1\n");
  const sinew::Scenario scenario = sinew::read_scenario(
      folder.path() / "scenario.toml", sinew::channels_of(sinew::DriveMode::torque, {{"q", false}},
                                                          1, sinew::TopOfModel::commanded_wrist));
  CHECK(scenario.commands.at("flexion").at(0.5).value == Approx(0.785398163));
  CHECK(scenario.commands.at("flexion").at(0.5).rate == Approx(1.570796327));
  CHECK(scenario.commands.at("abduction").at(0.5).value == Approx(0.1));
}

TEST_CASE("a force at the tip moves a finger as the torques of its virtual work", "[commands]") {
  const std::string start =
      "gravity = { value = [0, 0, 0], unit = \"m/s^2\" }\n"
      "[drive]\nmode = \"joint_torques\"\n[[command]]\n";
  const Run pushed = run("index", scenario_text(0.004, 1000, start + R"(
channel = "tip_force_y"
value = { value = 0.01, unit = "N" }
)"));
  // Straight and along x, the tip is 0.006 + 0.04038 + 0.0298 + 0.0201 m from the base's axis,
  // about z there.
  const Run turned = run("index", scenario_text(0.004, 1000, start + R"(
channel = "tau_q20"
value = { value = 0.0009628, unit = "N*m" }
)"));
  CHECK(pushed.at(4, "q20") > 1e-4);
  CHECK(pushed.at(4, "q20") == Approx(turned.at(4, "q20")).epsilon(1e-3));
  CHECK(pushed.at(4, "q21") == Approx(turned.at(4, "q21")).margin(1e-3 * pushed.at(4, "q20")));
}

TEST_CASE("an imported robot simulates, and is not asked for what it lacks", "[commands]") {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  write_text(folder.path() / "crane.urdf", urdf);
  std::string output;
  REQUIRE(run_program({SINEW_PROGRAM, "import", path("crane.urdf"), "--out", path("crane")},
                      output) == 0);
  const auto simulate = [&](const std::string& text) {
    write_text(folder.path() / "scenario.toml", scenario_text(0.5, 100, text));
    return run_program(
        {SINEW_PROGRAM, "simulate", path("crane"), "--scenario", path("scenario.toml"), "--out",
         path("out.csv"), "--runtime", source + "/runtime"},
        output);
  };
  REQUIRE(simulate("[drive]\nmode = \"joint_torques\"\n[[command]]\nchannel = \"tau_reach\"\n"
                   "value = { value = 0.5, unit = \"N\" }\n") == 0);
  const std::string log = read_text(folder.path() / "out.csv");
  CHECK(log.substr(0, log.find('\n')) ==
        "time [s],q_swing [rad],q_reach [m],qd_swing [rad/s],qd_reach [m/s],tau_swing [N·m],"
        "tau_reach [N]");
  // 0.5 N on 0.5 kg for 0.5 s.
  std::string last = log.substr(log.rfind('\n', log.size() - 2) + 1);
  last = last.substr(last.find(',', last.find(',') + 1) + 1);
  CHECK(std::stod(last) == Approx(0.125).epsilon(1e-5));

  const auto refused = [&](const std::string& text, const std::string& message) {
    CHECK(simulate(text) == 2);
    CAPTURE(output);
    CHECK(output.find(message) != std::string::npos);
  };
  refused("[drive]\nmode = \"torque\"\n",
          "crane has no tendons; expected the drive mode joint_torques");
  refused(
      "[drive]\nmode = \"joint_torques\"\n[[command]]\nchannel = \"tau_reach\"\n"
      "value = { value = 0.5, unit = \"N*m\" }\n",
      "has the unit 'N*m' of torque");
  refused(
      "[drive]\nmode = \"joint_torques\"\n[[command]]\nchannel = \"theta_1_ref\"\n"
      "value = { value = 0.5, unit = \"rad\" }\n",
      "the model has no command 'theta_1_ref'");
}
