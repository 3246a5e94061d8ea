// SPDX-License-Identifier: GPL-3.0-or-later
// A wrist that moves freely: its books close, and driven by the torques of a prescribed motion it
// moves as prescribed.
#include <catch2/catch.hpp>
#include <cmath>

#include "symbolic/hand/read_hand.h"
#include "tests/simulation/plant/hand_runs.h"

using namespace sinew_tests;
using Eigen::VectorXd;

namespace {

const std::string free_wrist = R"(
[integrator]
relative_tolerance = { value = 1e-9, unit = "1" }
absolute_tolerance = { value = 1e-11, unit = "1" }
[drive]
mode = "prescribed"
pretension = { value = 15, unit = "N" }
[initial]
"hmc.theta2" = { value = 90, unit = "deg" }
[wrist]
mode = "dynamic"
)";

constexpr double rate = 2000.0;  // Hz
constexpr int fingers = 19;

sinew::Signal swing(double amplitude, double frequency) {
  sinew::Wave wave;
  wave.shape = sinew::WaveShape::sine;
  wave.amplitude = amplitude;
  wave.frequency = frequency;
  sinew::Signal signal;
  signal.add(wave);
  return signal;
}

/// Torques on q71 and q73 that move the wrist as it moved in a run, one pair a row: what the motion
/// takes of bars, palm and fingers, less what tendons give.
std::vector<Eigen::Vector2d> torques(const sinew::Plant& prescribed, const sinew::Joints& joints,
                                     const Run& run) {
  std::vector<Eigen::Vector2d> all;
  const auto n = joints.size();
  sinew::Evaluation e;
  for (const std::vector<double>& row : run.rows) {
    VectorXd y(2 * (n - 2)), q(n), qd(n), qdd(n), pull(n), taken(n);
    y << Eigen::Map<const VectorXd>(row.data() + 1, n - 2),
        Eigen::Map<const VectorXd>(row.data() + n - 1, n - 2);
    prescribed.evaluate(row[0], y.data(), e, true);
    q << e.q, e.wrist.q[0], e.wrist.q[1];
    qd << e.qd, e.wrist.qd[0], e.wrist.qd[1];
    qdd << e.qdd, e.wrist.qdd[0], e.wrist.qdd[1];
    joints.torque(q.data(), {}, e.force().data(), pull.data());
    joints.inertial_forces(q.data(), qd.data(), qdd.data(), {}, taken.data());
    all.push_back((taken - pull + joints.damping.cwiseProduct(qd)).tail<2>());
  }
  CHECK(joints.tendons == 38);
  return all;
}

double largest_difference(const Run& a, const Run& b) {
  double largest = 0.0;
  REQUIRE(a.rows.size() == b.rows.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    for (std::size_t j = 1; j <= fingers; ++j)
      largest = std::max(largest, std::abs(a.rows[i][j] - b.rows[i][j]));
    for (const char* bar : {"q71", "q73"})
      largest = std::max(largest, std::abs(a.at(i, bar) - b.at(i, bar)));
  }
  return largest;
}

}  // namespace

TEST_CASE("a free wrist moves as prescribed under the torques of that motion", "[hand][slow]") {
  const HandRuns hand(scenario_text(0.1, rate, free_wrist));
  const sinew::Joints& joints = *hand.plant.parts().joints;

  sinew::Scenario scenario = hand.plant.scenario();
  scenario.commands = {{"flexion", swing(0.2, 2.0)}, {"abduction", swing(0.1, 3.0)}};
  sinew::PlantParts parts = hand.plant.parts();
  parts.joints = sinew::on_other_palm(joints, {});
  parts.wrist.emplace(sinew::read_hand(source + "/models/hand").hand.wrist, source + "/runtime");
  sinew::Plant prescribed(scenario, parts);
  const Run wanted = run(prescribed);

  const std::vector<Eigen::Vector2d> torque = torques(prescribed, joints, wanted);
  const sinew::WristMotion start = prescribed.parts().wrist->at(
      scenario.commands["flexion"].at(0.0), scenario.commands["abduction"].at(0.0));
  const auto drive = [&](bool with_torques) {
    return [&, with_torques](sinew::Scenario& own) {
      for (int i = 0; i < 2; ++i) {
        const std::string bar = i == 0 ? "q71" : "q73";
        sinew::SampledSignal samples;
        for (std::size_t k = 0; k < torque.size(); ++k) {
          samples.time.push_back(wanted.rows[k][0]);
          samples.value.push_back(torque[k](i));
        }
        if (with_torques) own.commands["tau_" + bar].add(samples);
        own.initial[bar] = start.q[i];
        own.initial["qd_" + bar] = start.qd[i];
      }
    };
  };
  const Run driven = hand.changed(drive(true)), left_alone = hand.changed(drive(false));
  CAPTURE(largest_difference(driven, wanted), largest_difference(left_alone, wanted));
  CHECK(largest_difference(driven, wanted) < 1e-5);
  CHECK(largest_difference(left_alone, wanted) > 1e-2);

  const sinew::Audit& audit = driven.result.audit;
  CAPTURE(audit.energy_residual, audit.largest_energy, audit.power_residual);
  CHECK(audit.power_residual < 1e-8);
  CHECK(audit.energy_residual < 1e-7 * audit.largest_energy);
  CHECK(audit.largest_friction_power <= 0.0);
  CHECK(audit.work[sinew::external_power] != 0.0);
}
