// SPDX-License-Identifier: GPL-3.0-or-later
// Energy is kept without losses, and the books close with them.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/simulation/scenario_run.h"

using namespace sinew_tests;

namespace {

const std::string no_losses = R"(
[losses]
joint_damping = false
motor_friction = false
motor_ripple = false
)";

const std::string moving_start = R"(
[initial]
q21 = { value = 0.5, unit = "rad" }
q22 = { value = 0.5, unit = "rad" }
qd_q20 = { value = 5, unit = "rad/s" }
qd_q21 = { value = 30, unit = "rad/s" }
)";

const std::string tight = R"(
[integrator]
method = "cvode_adams"
relative_tolerance = { value = 1e-12, unit = "1" }
absolute_tolerance = { value = 1e-14, unit = "1" }
)";

const std::string servo = R"(
[drive]
mode = "servo"
gain = { value = 60, unit = "N*m" }
rate_gain = { value = 2, unit = "N*m*s/rad" }
compensation = true
pretension = { value = 15, unit = "N" }
[[command]]
channel = "theta_5_ref"
shape = "sine"
amplitude = { value = 0.5, unit = "rad" }
frequency = { value = 2, unit = "Hz" }
[[command]]
channel = "theta_6_ref"
shape = "sine"
amplitude = { value = -0.5, unit = "rad" }
frequency = { value = 2, unit = "Hz" }
[[command]]
channel = "tip_force_z"
value = { value = 0.5, unit = "N" }
from = { value = 0.1, unit = "s" }
to = { value = 0.2, unit = "s" }
)";

}  // namespace

TEST_CASE("a finger on elastic tendons keeps its energy for 10 s", "[energy]") {
  const Run held = run("index", scenario_text(10, 200,
                                              "[drive]\nmode = \"prescribed\"\n"
                                              "pretension = { value = 20, unit = \"N\" }\n" +
                                                  tight + no_losses + moving_start));
  const sinew::Audit& audit = held.result.audit;
  double swing = 0.0;
  for (std::size_t i = 0; i < held.rows.size(); ++i)
    swing = std::max(swing, std::abs(held.at(i, "q21") - 0.5));
  CAPTURE(audit.energy_drift, audit.largest_energy, audit.power_residual);
  CHECK(held.rows.size() == 2001);
  CHECK(swing > 0.05);
  // Of the energy that moves to and fro, not of the pretension's.
  CHECK(audit.energy_drift < 1e-9 * 1e-3);
  CHECK(audit.power_residual < 1e-8);
}

TEST_CASE("coarse steps lose energy, and the audit says so", "[energy]") {
  const Run coarse = run("index", scenario_text(0.5, 200,
                                                "[drive]\nmode = \"prescribed\"\n"
                                                "pretension = { value = 20, unit = \"N\" }\n"
                                                "[integrator]\nmethod = \"fixed_step\"\n" +
                                                    no_losses + moving_start));
  CHECK(coarse.result.audit.energy_drift > 1e-5 * coarse.result.audit.largest_energy);
}

TEST_CASE("with every loss the books close and friction takes", "[energy]") {
  for (const char* guiding : {"fitted", "capstan"}) {
    const Run lossy =
        run("index", scenario_text(0.4, 1000,
                                   servo +
                                       "[integrator]\nrelative_tolerance = { value = 1e-10, unit = "
                                       "\"1\" }\nabsolute_tolerance = { value = 1e-12, unit = "
                                       "\"1\" }\n[losses]\nguiding = \"" +
                                       guiding + "\"\n"));
    const sinew::Audit& audit = lossy.result.audit;
    CAPTURE(guiding, audit.energy_residual, audit.largest_energy, audit.power_residual);
    CHECK(audit.energy_residual < 1e-8 * audit.largest_energy);
    CHECK(audit.power_residual < 1e-8);
    CHECK(audit.largest_friction_power <= 0.0);
    for (const int loss : {sinew::motor_friction_power, sinew::guiding_power, sinew::damping_power})
      CHECK(audit.work[static_cast<std::size_t>(loss)] < 0.0);
    CHECK(audit.work[sinew::external_power] != 0.0);
    CHECK(lossy.result.event_counts.count("tendon_sticks_5") == 1);
    CHECK(lossy.result.event_counts.count("motor_sticks_5") == 1);
  }
}

TEST_CASE("a wrong acceleration shows in the power balance", "[energy]") {
  const sinew::Plant plant = plant_of("index", scenario_text(1, 10, servo + moving_start));
  sinew::Evaluation e;
  const Eigen::VectorXd y = plant.initial_state();
  plant.evaluate(0.0, y.data(), e, true);
  const auto residual = [&] {
    const sinew::EnergyNow now = plant.energy(e);
    double sum = 0.0;
    for (const double power : plant.powers(e)) sum += power;
    return std::abs(now.rate - sum) / now.size;
  };
  CHECK(residual() < 1e-12);
  e.qdd *= 1.0 + 1e-5;
  CHECK(residual() > 1e-8);
}

TEST_CASE("a slack tendon neither pushes nor breaks the books", "[energy]") {
  const Run slack = run("index", scenario_text(0.3, 1000,
                                               "[drive]\nmode = \"prescribed\"\n"
                                               "pretension = { value = 0.2, unit = \"N\" }\n" +
                                                   tight + no_losses + moving_start));
  CHECK(slack.result.event_counts.size() > 1);
  double least = 1.0;
  for (std::size_t i = 0; i < slack.rows.size(); ++i)
    for (int k = 1; k <= 8; ++k) least = std::min(least, slack.at(i, "force_" + std::to_string(k)));
  CHECK(least == 0.0);
  CHECK(slack.result.audit.energy_residual < 1e-8 * slack.result.audit.largest_energy);
}

TEST_CASE("fixed steps come to where CVODE comes", "[energy][slow]") {
  const std::string what = servo + "[losses]\nguiding = \"capstan\"\n";
  const Run fine = run("index", scenario_text(0.3, 100, what));
  const Run fixed =
      run("index", scenario_text(0.3, 100,
                                 what + "[integrator]\nmethod = \"fixed_step\"\nstep = { value = "
                                        "20, unit = \"us\" }\n"));
  for (const char* joint : {"q20", "q21", "q22", "q23"})
    CHECK(fixed.at(30, joint) == Approx(fine.at(30, joint)).margin(2e-3));
  CHECK(std::abs(fine.at(12, "q22")) > 0.05);
}
