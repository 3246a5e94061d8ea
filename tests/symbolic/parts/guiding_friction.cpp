// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/guiding_friction.h"

#include <catch2/catch.hpp>

#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;

TEST_CASE("guiding friction follows the fitted law against the motion", "[guiding_friction]") {
  const Function force = guiding_friction_force(guiding_parameters());
  for (const double bending : {0.0, 0.5, 1.57, 3.0, 6.0}) {
    const double expected = 6.0 * (1 - std::exp(-0.35 * bending));
    CHECK(evaluate(force, {bending, 0.05})[0] == Approx(-expected).epsilon(1e-5));
    CHECK(evaluate(force, {bending, -0.05})[0] == Approx(expected).epsilon(1e-5));
    CHECK(evaluate(force, {bending, 0.0})[0] == 0.0);
    // Independent of speed beyond the reversal.
    CHECK(evaluate(force, {bending, 0.01})[0] ==
          Approx(evaluate(force, {bending, 0.1})[0]).epsilon(1e-4));
  }
  CHECK(evaluate(force, {-1.0, 0.05})[0] == 0.0);
  CHECK(all_finite(evaluate(force, {1e300, -1e300})));
}

TEST_CASE("capstan friction is what the tension loses", "[guiding_friction]") {
  const GuidingParameters p = guiding_parameters();
  const Function friction = capstan_friction_force(p), transmitted = capstan_transmitted_force(p);
  for (const double bending : {0.3, 1.5, 4.0}) {
    // The motor pulls: its side is the pulling side.
    const double finger = evaluate(transmitted, {50, bending, 0.05})[0];
    CHECK(finger == Approx(50 * std::exp(-0.1 * bending)).epsilon(1e-6));
    CHECK(50 + evaluate(friction, {50, bending, 0.05})[0] == Approx(finger).epsilon(1e-6));
    // The finger pulls: its side is the pulling side.
    const double pulled = evaluate(transmitted, {50, bending, -0.05})[0];
    CHECK(pulled == Approx(50 * std::exp(0.1 * bending)).epsilon(1e-6));
    CHECK(pulled - evaluate(friction, {pulled, bending, -0.05})[0] == Approx(50).epsilon(1e-6));
    // Turning back the motion turns back the loss.
    CHECK(evaluate(transmitted, {finger, bending, -0.05})[0] == Approx(50).epsilon(1e-12));
  }
  CHECK(evaluate(transmitted, {-5, 1, 0.05})[0] == 0.0);
  CHECK(all_finite(evaluate(transmitted, {100, 1e300, -1e300})));
}

TEST_CASE("fitted and capstan form agree where C0 is the tension and C1 is mu",
          "[guiding_friction]") {
  GuidingParameters p = guiding_parameters();
  p.C0 = 40;
  p.C1 = p.friction_coefficient;
  for (const double bending : {0.2, 2.0, 5.0})
    CHECK(evaluate(guiding_friction_force(p), {bending, 0.02})[0] ==
          Approx(evaluate(capstan_friction_force(p), {40, bending, 0.02})[0]).epsilon(1e-14));
}

TEST_CASE("friction takes power out whatever the motion", "[guiding_friction]") {
  const Function force = guiding_friction_force(guiding_parameters());
  for (double velocity = -2e-3; velocity <= 2e-3; velocity += 1e-4)
    CHECK(evaluate(force, {1.2, velocity})[0] * velocity <= 0);
  GuidingParameters p = guiding_parameters();
  p.C0 = -1;
  CHECK_THROWS_AS(guiding_friction_force(p), std::invalid_argument);
  p = guiding_parameters();
  p.reversal_velocity = 0;
  CHECK_THROWS_AS(capstan_friction_force(p), std::invalid_argument);
}
