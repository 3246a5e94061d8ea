// SPDX-License-Identifier: GPL-3.0-or-later
// The complete hand keeps its energy without losses, and its books close with them.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/simulation/plant/hand_runs.h"

using namespace sinew_tests;

namespace {

const std::string losing = R"(
[integrator]
relative_tolerance = { value = 1e-10, unit = "1" }
absolute_tolerance = { value = 1e-12, unit = "1" }
[drive]
mode = "servo"
gain = { value = 60, unit = "N*m" }
rate_gain = { value = 2, unit = "N*m*s/rad" }
compensation = true
pretension = { value = 15, unit = "N" }
[initial]
"hmc.theta2" = { value = 90, unit = "deg" }
"index.q21" = { value = 0.4, unit = "rad" }
"qd_thumb.q11" = { value = 2, unit = "rad/s" }
"qd_ring.q42" = { value = 5, unit = "rad/s" }
[[command]]
channel = "theta_13_ref"
shape = "sine"
amplitude = { value = 0.3, unit = "rad" }
frequency = { value = 5, unit = "Hz" }
)";

}  // namespace

TEST_CASE("the hand's books close with every loss, and without losses its energy stays",
          "[hand][slow]") {
  const HandRuns hand(scenario_text(0.05, 1000, losing));
  const Run lossy = hand.changed([](sinew::Scenario&) {});
  const sinew::Audit& with = lossy.result.audit;
  CAPTURE(with.energy_residual, with.largest_energy, with.power_residual);
  CHECK(with.power_residual < 1e-8);
  CHECK(with.energy_residual < 1e-8 * with.largest_energy);
  CHECK(with.largest_friction_power <= 0.0);
  CHECK(with.work[sinew::motor_friction_power] < 0.0);
  CHECK(with.work[sinew::damping_power] < 0.0);

  const Run held = hand.changed([](sinew::Scenario& scenario) {
    scenario.drive = sinew::DriveMode::prescribed;
    scenario.commands.clear();
    scenario.joint_damping = false;
    scenario.integrator = sinew::Integrator::cvode_adams;
    scenario.relative_tolerance = 1e-12;
    scenario.absolute_tolerance = 1e-14;
    scenario.initial["qd_hmc.theta2"] = 2.0;
  });
  const sinew::Audit& without = held.result.audit;
  CAPTURE(without.energy_drift, without.largest_energy, without.work[sinew::base_power]);
  // The crank moves and carries a finger: its energy is in the books, and nothing comes from
  // outside.
  CHECK(without.energy_drift < 1e-9 * without.largest_energy);
  CHECK(without.work[sinew::base_power] == 0.0);
  CHECK(std::abs(held.at(50, "hmc.theta2") - held.at(0, "hmc.theta2")) > 1e-3);
  CHECK(without.power_residual < 1e-8);
  CHECK(std::abs(held.at(50, "index.q21") - 0.4) > 1e-3);

  // A palm that shakes the fingers gives them energy: counted, the books close; left out, they do
  // not.
  const Run shaken = hand.changed([](sinew::Scenario& scenario) {
    sinew::Wave wave;
    wave.shape = sinew::WaveShape::sine;
    wave.amplitude = 0.3;
    wave.frequency = 5.0;
    scenario.commands["flexion"].add(wave);
    wave.frequency = 4.0;
    scenario.commands["abduction"].add(wave);
  });
  const sinew::Audit& palm = shaken.result.audit;
  CAPTURE(palm.energy_residual, palm.largest_energy, palm.work[sinew::base_power]);
  CHECK(palm.power_residual < 1e-8);
  CHECK(palm.energy_residual < 1e-8 * palm.largest_energy);
  CHECK(std::abs(palm.work[sinew::base_power]) > 1e-5 * palm.largest_energy);
}
