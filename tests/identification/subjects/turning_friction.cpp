// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that turns over a short and a long way is no cause.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>

#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;

constexpr double kMass = 20.0, kViscous = 60.0, kCoulomb = 30.0;
constexpr double kShort = 1e-4, kLong = 8e-3;  // m: bristles

/// 20 s of a slide as its model has it, but that half of its friction turns over a long way.
std::string log_of(double phase, unsigned seed) {
  reference::RandomNumbers random(seed);
  std::string text = "time [s],q_x [m],tau_x [N]\n";
  double of_short = 0.0, of_long = 0.0, before = 0.3 * std::sin(phase);
  for (int k = 0; k < 10000; ++k) {
    const double t = 2e-3 * k, w1 = 2.1, w2 = 5.3;
    const double x = 0.3 * std::sin(w1 * t + phase) + 0.1 * std::sin(w2 * t);
    const double v = 0.3 * w1 * std::cos(w1 * t + phase) + 0.1 * w2 * std::cos(w2 * t);
    const double a = -0.3 * w1 * w1 * std::sin(w1 * t + phase) - 0.1 * w2 * w2 * std::sin(w2 * t);
    const double side = x < before ? -1.0 : 1.0, way = std::abs(x - before);
    before = x;
    of_short = side + (of_short - side) * std::exp(-way / kShort);
    of_long = side + (of_long - side) * std::exp(-way / kLong);
    fmt::format_to(std::back_inserter(text), "{:.3f},{:.9g},{:.9g}\n", t, x,
                   kMass * a + kViscous * v + kCoulomb * (0.5 * of_short + 0.5 * of_long) +
                       random.uniform(-1.0, 1.0));
  }
  return text;
}

}  // namespace

// Seen red with bristles of one length: a delay or torque constant and a low-pass were told.
TEST_CASE("friction that turns over several lengths is no cause", "[slow]") {
  const diagnosis::Findings found = test::diagnosis_of(test::slide(kMass, kViscous, kCoulomb),
                                                       {{"train.csv", log_of(0.4, 3), false},
                                                        {"holdout.csv", log_of(1.3, 4), true}})
                                        .findings;
  INFO(found.headline);
  CHECK(found.verdict.causes.empty());
  CHECK_FALSE(found.verdict.unexplained.none_of_the_known);
}
