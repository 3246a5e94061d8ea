// SPDX-License-Identifier: GPL-3.0-or-later
// A whole log's effort against the emitted function called at one instant after the other.
#include <catch2/catch.hpp>
#include <random>

#include "identification/subjects/effort_model.h"
#include "simulation/emitted/driven_effort.h"
#include "tests/identification/subjects/finger_with_motors.h"

namespace {

using namespace sinew;
using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kSamples = 5000;  // more than a block of inputs

/// One of the finger's motors has friction that remembers.
Identified friction_with_memory(const DrivenModel& model) {
  Identified identified;
  identified.effects.push_back({"presliding",
                                model.joints.back().name,
                                {{"presliding_length", 1e-3, 0.0, "rad"}},
                                {{"level", 0.1, 0.0, "N m"}}});
  return identified;
}

Recording wandering(Index joints, Index tendons) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  const auto any = [&](Index columns) {
    MatrixXd x(kSamples, columns);
    for (double& value : x.reshaped()) value = draw(engine);
    return x;
  };
  Recording log;
  log.step = 1e-3;
  log.time = Eigen::VectorXd::LinSpaced(kSamples, 0.0, 5.0);
  log.q = any(joints);
  log.qd = any(joints);
  log.qdd = any(joints);
  log.load = any(joints);
  log.signals["tension"] = any(tendons);
  return log;
}

}  // namespace

TEST_CASE("a log's effort has the bits of one instant after the other, one joint's alone too") {
  // Planted defects: a state that begins anew with every block of inputs; the load of one block
  // for all; a motor's effort from the function of its neighbour.
  const DrivenModel driven = test::finger_with_motors();
  const Identified identified = friction_with_memory(driven);
  const EffortModel model(driven, identified, SINEW_SOURCE_DIR "/runtime");
  const Recording log = wandering(12, 8);
  const MatrixXd all = model(log);
  DrivenEffort instant(driven, identified, SINEW_SOURCE_DIR "/runtime");
  instant.set_step(log.step);
  for (Index k = 0; k < kSamples; ++k) {
    instant.set_time(log.time(k));
    instant.set_load(log.load.row(k).transpose());
    instant.set_tension(log.signals.at("tension").row(k).transpose());
    const Eigen::VectorXd now =
        instant(log.q.row(k).transpose(), log.qd.row(k).transpose(), log.qdd.row(k).transpose());
    instant.remember();
    REQUIRE(now == all.row(k).transpose());
  }
  for (int joint = 0; joint < 12; ++joint)
    CHECK(model.of_joint(joint, log, log.q, log.qd, log.qdd) == all.col(joint));
}
