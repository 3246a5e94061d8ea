// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drives/effort_history.h"

#include <catch2/catch.hpp>

using namespace sinew;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

EffortHistory::Efforts efforts(double joint, double motor) {
  return {Vector2d(joint, -joint), Vector2d(motor, -motor), VectorXd()};
}

}  // namespace

TEST_CASE("efforts of the past lie on straight lines between the entries") {
  // Planted defect: the entry before instead of the line: 1 in place of 1.5.
  EffortHistory history;
  history.add(0.0, efforts(1.0, 10.0), 1.0);
  history.add(0.1, efforts(2.0, 30.0), 1.0);
  const VectorXd now = Vector2d(7.0, 8.0);
  CHECK(history.at(PastEffort::joint_torque, 0.05, now).isApprox(Vector2d(1.5, -1.5)));
  CHECK(history.at(PastEffort::motor_torque, 0.075, now).isApprox(Vector2d(25.0, -25.0)));
}

TEST_CASE("before the first entry the first holds, after the last one what is now") {
  EffortHistory history;
  const VectorXd now = Vector2d(7.0, 8.0);
  CHECK(history.at(PastEffort::joint_torque, 0.0, now) == now);
  history.add(0.5, efforts(1.0, 10.0), 1.0);
  CHECK(history.at(PastEffort::joint_torque, 0.1, now).isApprox(Vector2d(1.0, -1.0)));
  CHECK(history.at(PastEffort::joint_torque, 0.6, now) == now);
}

TEST_CASE("what is older than the longest delay goes, and the line to it stays") {
  // Planted defect: entries dropped as soon as they are too old: the line that a delay just
  // within `longest` needs has lost its first end.
  EffortHistory history;
  for (int i = 0; i <= 100; ++i) history.add(0.01 * i, efforts(i, 0.0), 0.055);
  const VectorXd now = Vector2d::Zero();
  CHECK(history.at(PastEffort::joint_torque, 0.945, now)(0) == Approx(94.5));
  CHECK(history.at(PastEffort::joint_torque, 0.2, now)(0) >= 93.0);
}
