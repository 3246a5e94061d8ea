// SPDX-License-Identifier: GPL-3.0-or-later
// A finger whose last joint follows the one before through a four-bar linkage, simulated.
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "tests/simulation/scenario_run.h"

using namespace sinew_tests;
namespace fs = std::filesystem;

namespace {

const std::string linkage = R"(
[[four_bar]]
dependent = "q23"
independent = "q22"
ground = { value = 10, unit = "mm", from = "assumed" }
crank = { value = 29.8, unit = "mm", from = "assumed" }
coupler = { value = 9.5, unit = "mm", from = "assumed" }
rocker = { value = 30.2, unit = "mm", from = "assumed" }
branch = "open"
follows = "coupler"
crank_angle = { value = 0.8, unit = "rad", from = "assumed" }
)";

/// The index finger with the linkage; `damped` as the model has it, or with every damping zero.
struct LinkedFinger {
  sinew::reference::TemporaryFolder folder;
  explicit LinkedFinger(bool damped) {
    for (const char* part : {"index", "motor", "tendon", "lever", "capstan", "guiding"})
      fs::copy(source + "/models/" + part, folder.path() / part, fs::copy_options::recursive);
    const fs::path file = folder.path() / "index" / "mechanism.toml";
    std::string text = sinew::reference::read_text(file);
    if (!damped)
      text = std::regex_replace(text, std::regex("(damping = \\{ value = )[-+0-9.e]+"), "$010");
    sinew::reference::write_text(file, text + linkage);
  }
  Run simulated(const std::string& scenario) const {
    const fs::path file = folder.path() / "scenario.toml";
    sinew::reference::write_text(file, scenario);
    sinew::Plant plant = sinew::build_plant(folder.path() / "index", file, source + "/runtime");
    return run(plant);
  }
};

const std::string free_motion = R"(
[drive]
mode = "prescribed"
pretension = { value = 20, unit = "N" }
[integrator]
method = "cvode_adams"
relative_tolerance = { value = 1e-12, unit = "1" }
absolute_tolerance = { value = 1e-14, unit = "1" }
[losses]
joint_damping = false
motor_friction = false
motor_ripple = false
[initial]
q21 = { value = 0.5, unit = "rad" }
q22 = { value = 0.3, unit = "rad" }
qd_q21 = { value = 10, unit = "rad/s" }
qd_q22 = { value = 10, unit = "rad/s" }
)";

}  // namespace

TEST_CASE("a finger with a four-bar keeps its energy", "[energy]") {
  const Run held = LinkedFinger(false).simulated(scenario_text(1, 200, free_motion));
  const sinew::Audit& audit = held.result.audit;
  double swing = 0.0;
  for (std::size_t i = 0; i < held.rows.size(); ++i)
    swing = std::max(swing, std::abs(held.at(i, "q22") - 0.3));
  CAPTURE(audit.energy_drift, audit.largest_energy, audit.power_residual, swing);
  CHECK(swing > 0.01);
  // Planted defect: with the last joint's angle 1 % off where the energy is taken the drift is a
  // hundred times this.
  CHECK(audit.energy_drift < 1e-9 * audit.largest_energy);
  CHECK(audit.power_residual < 1e-8);
}

TEST_CASE("damping of joints beside a four-bar is refused, not left out") {
  CHECK_THROWS_WITH(LinkedFinger(true).simulated(scenario_text(0.1, 200, free_motion)),
                    Catch::Contains("four-bar"));
}
