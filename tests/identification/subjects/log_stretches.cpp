// SPDX-License-Identifier: GPL-3.0-or-later
// A log with a hole in it: what grows with time grows on behind the hole.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;

constexpr double kMass = 8.0, kViscous = 30.0, kDrift = 0.03;  // kg, N·s/m, N/s

/// Fifteen seconds of motion, three minutes without a row, fifteen more; an offset that drifts.
std::string log_with_hole(std::uint64_t seed) {
  reference::RandomNumbers random(seed);
  std::string text = "time [s],q_x [m],tau_x [N]\n";
  const double step = 1e-3, slow = random.uniform(2.0, 3.0), fast = random.uniform(5.0, 7.0);
  double wander = 0.0;
  for (const double begin : {0.0, 195.0})
    for (int k = 0; k < 15000; ++k) {
      const double t = begin + step * k;
      const double x = 0.2 * std::sin(slow * t) + 0.05 * std::cos(fast * t);
      const double v = 0.2 * slow * std::cos(slow * t) - 0.05 * fast * std::sin(fast * t);
      const double a =
          -0.2 * slow * slow * std::sin(slow * t) - 0.05 * fast * fast * std::cos(fast * t);
      wander = 0.9 * wander + random.uniform(-0.2, 0.2);
      text += fmt::format("{:.3f},{:.9f},{:.6f}\n", t, x,
                          kMass * a + kViscous * v + kDrift * t + wander);
    }
  return text;
}

}  // namespace

TEST_CASE("what grows with time grows on behind a hole in the log") {
  // Planted defect: with each stretch's time from its own beginning (Recording::started) the drift
  // is told as "none of the known causes".
  const diagnosis::Findings found =
      test::diagnosed(test::slide(kMass, kViscous, 0.0), log_with_hole(1), log_with_hole(2));
  INFO(found.headline);
  REQUIRE(found.verdict.causes.size() == 1);
  const diagnosis::NamedCause& cause = found.verdict.causes.front();
  CHECK(cause.members.front().name == "drift of the offset");
  REQUIRE_FALSE(cause.parameters.empty());
  CHECK(cause.parameters.front().value == Approx(kDrift).epsilon(0.05));
  CHECK(found.extension.adopted);
}
