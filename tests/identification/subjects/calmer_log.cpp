// SPDX-License-Identifier: GPL-3.0-or-later
// A held-out log that moves less than the training logs: what the position's noise hides is the
// sensor's property, and no log's.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;

constexpr double kMass = 8.0, kBehind = 3.0, kViscous = 30.0;  // kg, kg, N·s/m
constexpr double kNatural = 2.0 * std::numbers::pi * 24.0, kDamping = 0.05;

/// Slow strokes and a trembling about the natural frequency of a load behind a spring, by a motor
/// whose position is read with 15 um of noise.
std::string trembling_log(double trembling, std::uint64_t seed) {
  reference::RandomNumbers random(seed);
  std::string text = "time [s],q_x [m],tau_x [N]\n";
  constexpr int kInner = 10;
  const double step = 1e-3, inner = step / kInner;
  const double slow = random.uniform(2.0, 3.0), turned = random.uniform(0.0, 3.0);
  double twist = 0.0, rate = 0.0;
  for (int k = 0; k < 20000; ++k) {
    double x = 0.0, v = 0.0, a = 0.0, swing = 0.0;
    for (int i = 0; i < kInner; ++i) {
      const double t = step * k + inner * i;
      const auto stroke = [&](double acceleration, double w) {
        const double size = acceleration / (w * w), phase = w * t + turned;
        x += size * std::sin(phase);
        v += size * w * std::cos(phase);
        a -= size * w * w * std::sin(phase);
      };
      x = v = a = 0.0;
      stroke(1.0, slow);
      for (const double hz : {21.3, 24.1, 26.7, 31.9})
        stroke(trembling, 2.0 * std::numbers::pi * hz);
      swing = -a - 2.0 * kDamping * kNatural * rate - kNatural * kNatural * twist;
      rate += inner * swing;
      twist += inner * rate;
    }
    text +=
        fmt::format("{:.3f},{:.9f},{:.6f}\n", step * k, x + 1.5e-5 * random.uniform(-1.7, 1.7),
                    kMass * a + kBehind * swing + kViscous * v + 0.3 * random.uniform(-1.7, 1.7));
  }
  return text;
}

}  // namespace

TEST_CASE("a calmer held-out log does not refute what the training logs tell") {
  // Seen red where each log by itself said whether the position's noise hides its acceleration: the
  // held-out log's ended at 18 Hz, 5.8 times as much was left over there, and the logs "disagree".
  const diagnosis::Findings found = test::diagnosed(test::slide(kMass, kViscous, 0.0),
                                                    trembling_log(1.0, 1), trembling_log(0.25, 2));
  INFO(found.headline);
  REQUIRE(found.verdict.causes.size() == 1);
  CHECK(found.verdict.causes.front().members.front().name == "gear elasticity");
  CHECK(found.verdict.disagreements.empty());
}
