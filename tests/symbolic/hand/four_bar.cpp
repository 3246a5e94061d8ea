// SPDX-License-Identifier: GPL-3.0-or-later
// The hamatometacarpal joint's emitted C (5.5).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "generator/evaluate.h"
#include "generator/lower.h"
#include "hmc_catalogue.h"
#include "symbolic/parts/four_bar.h"
#include "tests/symbolic/hand/emitted_call.h"
#include "tests/symbolic/hand/model_values.h"

using namespace sinew;
using namespace sinew_tests;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Links {
  double g, a, b, c;
};

const Links& links() {
  static const FourBarParameters& p = four_bar_values();
  static const Links values{p.ground, p.crank, p.coupler, p.rocker};
  return values;
}

/// How far crank and coupler end from the rocker [m].
double gap(double theta2, const Values& out) {
  const auto& [g, a, b, c] = links();
  const double x = a * std::cos(theta2) + b * std::cos(out[0]) - g - c * std::cos(out[1]);
  const double y = a * std::sin(theta2) + b * std::sin(out[0]) - c * std::sin(out[1]);
  return std::hypot(x, y);
}

/// A rocking linkage: it locks where it is stretched.
FourBarParameters rocking() {
  FourBarParameters p;
  p.ground = 0.015;
  p.crank = 0.010;
  p.coupler = 0.008;
  p.rocker = 0.009;
  p.theta2 = {0.1, 3.0};
  p.pulley_radius = 0.005;
  return p;
}

Values on(const Function& function, double theta2) {
  return evaluate<double>(lower(function), {theta2});
}

}  // namespace

TEST_CASE("the four-bar closes to rounding and its derivatives are exact", "[hmc]") {
  double worst = 0, worst_rate = 0;
  const auto& [g, a, b, c] = links();
  (void)g;
  for (double theta2 = four_bar_values().theta2.low; theta2 <= four_bar_values().theta2.high;
       theta2 += 0.25 * degree) {
    const Values out = call(hmc_catalogue, "four_bar", {theta2});
    worst = std::max(worst, gap(theta2, out));
    // The loop's velocity: d(gap)/d(theta2) = 0 with the rates given.
    const double vx =
        -a * std::sin(theta2) - b * out[2] * std::sin(out[0]) + c * out[3] * std::sin(out[1]);
    const double vy =
        a * std::cos(theta2) + b * out[2] * std::cos(out[0]) - c * out[3] * std::cos(out[1]);
    worst_rate = std::max(worst_rate, std::hypot(vx, vy));
    Values wrong = out;
    wrong[1] += 1e-12;
    CHECK(gap(theta2, wrong) > 5e-15);
  }
  CAPTURE(worst, worst_rate);
  CHECK(worst <= 1e-17 * 3);
  CHECK(worst_rate <= 1e-16);
}

TEST_CASE("the four-bar's rates equal differences of its angles", "[hmc]") {
  const double step = 1e-4;
  for (const double theta2 : {1.1, 1.5, 2.0}) {
    const Values out = call(hmc_catalogue, "four_bar", {theta2});
    const auto slope = [&](std::size_t i) {
      const auto at = [&](double t) { return call(hmc_catalogue, "four_bar", {t})[i]; };
      return (8 * (at(theta2 + step) - at(theta2 - step)) - at(theta2 + 2 * step) +
              at(theta2 - 2 * step)) /
             (12 * step);
    };
    CHECK(out[2] == Approx(slope(0)).epsilon(1e-10));
    CHECK(out[3] == Approx(slope(1)).epsilon(1e-10));
  }
}

TEST_CASE("locking is reported, and the default linkage never locks", "[hmc]") {
  const Range range = four_bar_values().theta2;
  for (double theta2 = range.low; theta2 <= range.high; theta2 += degree) {
    const Values locking = call(hmc_catalogue, "locking", {theta2});
    CHECK(locking[0] > 0.1);
    CHECK(locking[1] == 0.0);
  }
  const FourBarParameters p = rocking();
  const std::vector<double> at = locking_angles(p);
  REQUIRE(!at.empty());
  const Function locking = four_bar_locking(p);
  CHECK(on(locking, at[0] - 0.2)[1] == 0.0);
  CHECK(on(locking, at[0] + 0.2)[1] == 1.0);
  for (const double value : on(four_bar(p), at[0] + 0.2)) CHECK(std::isfinite(value));
}

TEST_CASE("the crank's tendons are antagonists about the reference pose", "[hmc]") {
  const FourBarParameters& p = four_bar_values();
  const Values h = call(hmc_catalogue, "tendon_lengths", {p.reference_theta2 + 10 * degree});
  CHECK(h[0] == Approx(p.pulley_radius * 10 * degree).epsilon(1e-13));
  CHECK(h[1] == -h[0]);
}
