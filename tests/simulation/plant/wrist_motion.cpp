// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist moves the fingers through their tendons; the emitted feedforward holds them still.
#include <catch2/catch.hpp>
#include <cmath>

#include "symbolic/hand/read_hand.h"
#include "tests/simulation/plant/hand_runs.h"

using namespace sinew_tests;

namespace {

const std::string moving_wrist = R"(
gravity = { value = [0, 0, 0], unit = "m/s^2" }
[integrator]
relative_tolerance = { value = 1e-6, unit = "1" }
absolute_tolerance = { value = 1e-8, unit = "1" }
[initial]
"hmc.theta2" = { value = 90, unit = "deg" }
[[command]]
channel = "flexion"
shape = "sine"
amplitude = { value = 30, unit = "deg" }
frequency = { value = 0.5, unit = "Hz" }
[[command]]
channel = "abduction"
shape = "sine"
amplitude = { value = 20, unit = "deg" }
frequency = { value = 0.5, unit = "Hz" }
[drive]
mode = "prescribed"
pretension = { value = 15, unit = "N" }
)";

/// Root of the mean square of all fingers' joint angles about their start [rad].
double motion(const Run& run) {
  double sum = 0.0;
  for (const std::vector<double>& row : run.rows)
    for (std::size_t j = 1; j <= 19; ++j)
      sum += (row[j] - run.rows[0][j]) * (row[j] - run.rows[0][j]);
  return std::sqrt(sum / static_cast<double>(19 * run.rows.size()));
}

}  // namespace

TEST_CASE(
    "the wrist feedforward takes 98 % of the fingers' motion away, with gravity when it "
    "carries their weight",
    "[hand][slow]") {
  const HandRuns hand(scenario_text(0.5, 50, moving_wrist));
  const Run without = hand.changed([](sinew::Scenario&) {});
  const Run with =
      hand.changed([](sinew::Scenario& scenario) { scenario.wrist_feedforward = true; });
  const double before = motion(without), after = motion(with);
  CAPTURE(before, after);
  CHECK(without.columns[1] == "thumb.q10 [rad]");
  CHECK(without.columns[19] == "hmc.theta2 [rad]");
  CHECK(before > 0.01);
  CHECK(after < 0.02 * before);
  CHECK(with.result.audit.power_residual < 1e-8);
  CHECK(with.result.audit.energy_residual < 1e-5 * with.result.audit.largest_energy);

  // With gravity elastic tendons give way to the fingers' weight, wrist or no wrist.
  sinew::PalmParameters palm;
  palm.gravity = sinew::read_hand(source + "/models/hand").hand.fingers.front().mechanism.gravity;
  const std::shared_ptr<const sinew::Joints> heavy =
      sinew::on_other_palm(*hand.plant.parts().joints, palm);
  const auto weighed = [&](bool moves, bool feedforward, bool carried) {
    sinew::Scenario scenario = hand.plant.scenario();
    if (!moves) scenario.commands.clear();
    scenario.wrist_feedforward = feedforward;
    scenario.weight_feedforward = carried;
    sinew::PlantParts parts = hand.plant.parts();
    parts.joints = heavy;
    sinew::Plant own(scenario, parts);
    return run(own);
  };
  const Run moved = weighed(true, false, false), held = weighed(true, true, false),
            at_rest = weighed(false, false, false), carried = weighed(true, true, true);
  const double unhelped = motion(moved), helped = motion(held), sag = motion(at_rest);
  double sum = 0.0;
  for (std::size_t i = 0; i < held.rows.size(); ++i)
    for (std::size_t j = 1; j <= 19; ++j) sum += std::pow(held.rows[i][j] - at_rest.rows[i][j], 2);
  const double by_wrist = std::sqrt(sum / static_cast<double>(19 * held.rows.size()));
  const double left = motion(carried);
  CAPTURE(unhelped, helped, sag, by_wrist, left, carried.result.audit.power_residual);
  CHECK(helped < 0.12 * unhelped);
  CHECK(sag > 0.09 * unhelped);  // with the wrist at rest they move as much
  CHECK(by_wrist < 0.04 * unhelped);
  CHECK(left < 0.02 * unhelped);
  CHECK(carried.result.audit.power_residual < 1e-8);
  // Planted defect: without the quadratures in CVODE's error test this is 4e-3, since fingers that
  // do not move allow long steps.
  CHECK(carried.result.audit.energy_residual < 1e-5 * carried.result.audit.largest_energy);
}
