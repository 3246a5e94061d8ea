// SPDX-License-Identifier: GPL-3.0-or-later
// The motion predicted from measured efforts, against a drive whose motion is known in closed form.
#include "identification/adoption/prediction.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

using namespace sinew;
using namespace sinew::diagnosis;
using Eigen::Index;

constexpr double step = 1e-3, inertia = 0.02, viscous = 0.05;

EffortModel drive(double own_inertia) {
  MotorParameters motor;
  motor.gear_ratio = 1.0;
  motor.gearbox_inertia = own_inertia;
  motor.torque_constant = 1.0;
  motor.gamma1 = 50.0;
  motor.gamma2 = 0.1;
  motor.gamma3 = viscous;
  return {driven_model(motor, "drive"), {}, SINEW_SOURCE_DIR "/runtime"};
}

/// A log of the drive under the law that its model has, q = 0.3 sin(4 t) - 0.5 t^2.
Recording swinging(Index samples) {
  Recording log;
  log.step = step;
  log.time = Eigen::VectorXd::LinSpaced(samples, 0.0, step * static_cast<double>(samples - 1));
  const Eigen::ArrayXd t = log.time.array();
  log.q = (0.3 * (4.0 * t).sin() - 0.5 * t.square()).matrix();
  log.qd = (1.2 * (4.0 * t).cos() - t).matrix();
  log.qdd = (-4.8 * (4.0 * t).sin() - 1.0).matrix();
  log.target = {drive(inertia)(log).col(0)};
  return log;
}

double rms(const StretchErrors& errors) {
  return std::sqrt(errors.mean());
}

}  // namespace

TEST_CASE("the true model predicts the motion, a wrong inertia drifts as the square of the time") {
  const Recording log = swinging(3000);
  const double window = 0.05;
  const StretchErrors right = window_errors(drive(inertia), log, window, 40);
  REQUIRE(right.rows() == 40);
  // What is left is the integration's: half a step's acceleration.
  CHECK(rms(right) < 0.7 * 5.8 * step * window);
  // Planted defect: a model with 1.3 times the inertia. Its acceleration is wrong by 0.3 / 1.3 of
  // the true one; over a window the error's mean square is a quarter of that, by t^4 / 5.
  const double wrong = rms(window_errors(drive(1.3 * inertia), log, window, 40));
  const double off = 0.3 / 1.3 * std::sqrt(log.qdd.array().square().mean());
  CHECK(wrong == Approx(0.5 * off * window * window / std::sqrt(5.0)).epsilon(0.15));
  CHECK(wrong > 5.0 * rms(right));
}

TEST_CASE("an open loop drifts further than a window, and away where the model would") {
  const Recording log = swinging(3000);
  const StretchErrors loop = open_loop_errors(drive(1.3 * inertia), log, 6);
  REQUIRE(loop.rows() == 6);
  CHECK(rms(loop) > 10.0 * rms(window_errors(drive(1.3 * inertia), log, 0.05, 40)));
  CHECK(rms(open_loop_errors(drive(inertia), log, 6)) < 0.1 * rms(loop));
  // A sign turned round: nothing that could be called a number.
  Recording away = log;
  away.target.front() *= 1e300;
  CHECK_FALSE(open_loop_errors(drive(inertia), away, 6).allFinite());
}

TEST_CASE("a log shorter than a window has no prediction") {
  CHECK(window_errors(drive(inertia), swinging(30), 0.05, 40).rows() == 0);
}
