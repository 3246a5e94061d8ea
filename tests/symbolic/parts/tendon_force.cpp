// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/tendon_force.h"

#include <catch2/catch.hpp>

#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;

TEST_CASE("lever and tendon in series", "[tendon_force]") {
  const Function series = tendon_series_stiffness(tendon_parameters());
  CHECK(evaluate(series, {5600})[0] == Approx(1 / (1 / 5600.0 + 0.5 / 1e4)).epsilon(1e-15));
  CHECK(evaluate(series, {0})[0] == 0.0);
  CHECK_THROWS_AS(tendon_series_stiffness({0.0, 0.5}), std::invalid_argument);
}

TEST_CASE("tendon force solves for lever and tendon together", "[tendon_force]") {
  const LeverParameters lever = lever_parameters();
  const Function force = tendon_force(tendon_parameters(), lever), state = lever_state(lever),
                 series = tendon_series_stiffness(tendon_parameters());
  for (int i = 1; i <= 20; ++i) {
    const double theta = lever.free_angle + (lever.end_angle - lever.free_angle) * i / 20;
    const auto expected = evaluate(state, {theta});
    const double elongation = expected[1] + expected[2] * 0.5 / 1e4;
    for (const double start : {lever.free_angle, theta + 0.005}) {
      const auto out = evaluate(force, {elongation, start});
      CHECK(std::abs(out[3]) < 1e-15);
      CHECK(out[0] == Approx(expected[2]).epsilon(1e-11));
      CHECK(out[1] == Approx(evaluate(series, {expected[3]})[0]).epsilon(1e-10));
      CHECK(out[2] == Approx(theta).epsilon(1e-11));
    }
  }
}

TEST_CASE("a slack tendon has no force", "[tendon_force]") {
  const Function force = tendon_force(tendon_parameters(), lever_parameters());
  for (const double elongation : {0.0, -1e-9, -0.004}) {
    const auto out = evaluate(force, {elongation, 0.8});
    CHECK(out[0] == 0.0);
    CHECK(out[1] == 0.0);
    CHECK(out[3] == 0.0);
  }
  const auto just_taut = evaluate(force, {1e-6, 0.8});
  CHECK(just_taut[0] == Approx(1e-6 * just_taut[1]).epsilon(1e-3));
  CHECK(all_finite(evaluate(force, {1e6, 1e6})));
  CHECK(all_finite(evaluate(force, {-1e6, -1e6})));
}
