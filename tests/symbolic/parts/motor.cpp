// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/motor.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;

namespace {

double viscous(double speed) {
  return 0.5586 * std::atan(10 * speed) + 0.0356 * speed;
}
double ripple(double theta) {
  return 0.02 * std::sin(theta + 0.3) + 0.04 * std::sin(100 * theta + 1.1);
}

/// Speed after `seconds` from 1 rad/s without command or load, by small explicit steps.
double speed_after(const Function& acceleration, double seconds) {
  double theta = 0, speed = 1;
  const double step = 1e-4;
  for (double t = 0; t < seconds; t += step) {
    speed += step * evaluate(acceleration, {theta, speed, 0, 0})[0];
    theta += step * speed;
  }
  return speed;
}

}  // namespace

TEST_CASE("motor friction opposes motion and has its plateau", "[motor]") {
  const Function friction = motor_friction_torque(motor_parameters());
  for (const double speed : {-3.0, -0.2, 0.0, 1e-3, 5.0}) {
    const double tau = evaluate(friction, {speed})[0];
    CHECK(tau == Approx(-viscous(speed)).epsilon(1e-15));
    CHECK(tau * speed <= 0);
  }
  const double plateau = evaluate(friction, {1e6})[0] + 0.0356 * 1e6;
  CHECK(-plateau == Approx(0.5586 * std::numbers::pi / 2).epsilon(1e-4));
  CHECK(-plateau == Approx(0.877).margin(0.001));
  CHECK(-plateau / 0.005 == Approx(175).margin(1));  // as tendon force
}

TEST_CASE("motor inertia goes through the gear", "[motor]") {
  const MotorParameters p = motor_parameters();
  CHECK(motor_inertia(p) == Approx(2.0e-7 * 1e4 + 5e-5).epsilon(1e-15));
  const auto qdd = evaluate(motor_acceleration(p), {0.4, 0.7, 0.9, 30});
  const double net = 0.9 - viscous(0.7) - ripple(0.4) - 0.005 * 30;
  CHECK(qdd[0] == Approx(net / motor_inertia(p)).epsilon(1e-12));
  CHECK(evaluate(motor_torque(p), {1.0})[0] == Approx(0.85).epsilon(1e-15));
  CHECK(evaluate(motor_current(p), {0.85})[0] == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("a free motor comes to rest; with friction's sign turned it runs away", "[motor]") {
  MotorParameters p = motor_parameters();
  p.output_ripple.clear();
  p.input_ripple.clear();
  const Function acceleration = motor_acceleration(p);
  CHECK(std::abs(speed_after(acceleration, 0.05)) < 0.05);
  Function turned = acceleration;  // the sign that the equation is often printed with
  turned.outputs[0].values[0] *= -1;
  CHECK(speed_after(turned, 0.05) > 5);
}

TEST_CASE("compensation stays passive", "[motor]") {
  const MotorParameters p = motor_parameters();
  const Function compensation = motor_compensation_torque(p);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-5, 5);
  for (int i = 0; i < 100; ++i) {
    const double theta = anywhere(random), speed = anywhere(random);
    const auto out = evaluate(compensation, {theta, speed});
    CHECK(out[0] == Approx(0.9 * (viscous(speed) + ripple(theta))).margin(1e-14));
    CHECK(out[1] >= 0);
    CHECK(out[1] == Approx(0.1 * viscous(speed) * speed).epsilon(1e-13));
  }
  MotorParameters eager = p;
  eager.friction_compensation = 1.05;
  CHECK_THROWS_AS(motor_compensation_torque(eager), std::invalid_argument);
}

TEST_CASE("motor power balance closes and friction never feeds", "[motor]") {
  const Function balance = motor_power_balance(motor_parameters());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-4, 4);
  for (int i = 0; i < 100; ++i) {
    const auto power =
        evaluate(balance, {anywhere(random), anywhere(random), anywhere(random), 50});
    CHECK(power[0] + power[1] + power[2] + power[3] == Approx(power[4]).margin(1e-13));
    CHECK(power[1] <= 0);
  }
}

TEST_CASE("motor parameters are checked", "[motor]") {
  for (double MotorParameters::*value :
       {&MotorParameters::gear_ratio, &MotorParameters::torque_constant,
        &MotorParameters::gamma2}) {
    MotorParameters p = motor_parameters();
    p.*value = -1;
    CHECK_THROWS_AS(motor_acceleration(p), std::invalid_argument);
  }
}
