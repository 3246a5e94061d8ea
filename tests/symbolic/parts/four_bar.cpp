// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/four_bar.h"

#include <catch2/catch.hpp>
#include <complex>

#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;

namespace {

/// What is missing to close the loop a e^iθ2 + b e^iθ3 = g + c e^iθ4 [m].
double gap(const FourBarParameters& p, double theta2, double theta3, double theta4) {
  return std::abs(std::polar(p.crank, theta2) + std::polar(p.coupler, theta3) - p.ground -
                  std::polar(p.rocker, theta4));
}

/// A linkage whose crank cannot turn all the way round.
FourBarParameters rocking_parameters() {
  FourBarParameters p = four_bar_parameters();
  p.ground = 0.020;
  p.crank = 0.015;
  p.coupler = 0.012;
  p.rocker = 0.010;
  return p;
}

}  // namespace

TEST_CASE("four-bar loop closes to rounding on both branches", "[four_bar]") {
  FourBarParameters p = four_bar_parameters();
  for (const int branch : {-1, 1}) {
    p.branch = branch;
    const Function function = four_bar(p);
    for (double theta2 = -180; theta2 <= 180; theta2 += 3) {
      const auto out = evaluate(function, {theta2 * degree});
      CHECK(gap(p, theta2 * degree, out[0], out[1]) < 2e-17);
      // The form with inverse trigonometry, up to whole turns.
      const double A = std::cos(theta2 * degree) - p.ground / p.crank,
                   B = std::sin(theta2 * degree);
      const double K3 =
          (p.crank * p.crank - p.coupler * p.coupler + p.rocker * p.rocker + p.ground * p.ground) /
          (2 * p.crank * p.rocker);
      const double C = K3 - p.ground / p.rocker * std::cos(theta2 * degree);
      const double theta4 = std::atan2(B, A) + branch * std::acos(C / std::hypot(A, B));
      CHECK(std::abs(std::polar(1.0, out[1]) - std::polar(1.0, theta4)) < 1e-13);
    }
  }
  const auto out = evaluate(four_bar(four_bar_parameters()), {1.2});
  CHECK(gap(p, 1.2, out[0], out[1] + 1e-12) > 2e-17);
}

TEST_CASE("four-bar derivatives equal differences", "[four_bar]") {
  const Function function = four_bar(four_bar_parameters());
  for (const double theta2 : {-2.5, -0.3, 0.01, 0.8, 1.6, 2.9}) {
    const auto out = evaluate(function, {theta2}), slope = difference(function, {theta2}, 0);
    CHECK(out[2] == Approx(slope[0]).epsilon(1e-12));
    CHECK(out[3] == Approx(slope[1]).epsilon(1e-12));
  }
}

TEST_CASE("coupler pose carries the crank's end and the rocker's", "[four_bar]") {
  const FourBarParameters p = four_bar_parameters();
  const auto T = evaluate(four_bar_coupler_pose(p), {1.9}), out = evaluate(four_bar(p), {1.9});
  const std::complex<double> rocker_end(T[3] + p.coupler * T[0], T[7] + p.coupler * T[4]);
  CHECK(std::abs(rocker_end - p.ground - std::polar(p.rocker, out[1])) < 2e-17);
  CHECK(T[0] == Approx(std::cos(out[0])));
  CHECK(T[1] == -T[4]);
  CHECK(T[10] == 1.0);
}

TEST_CASE("the default linkage never locks, a rocking one does where predicted", "[four_bar]") {
  const FourBarParameters crank = four_bar_parameters(), rocking = rocking_parameters();
  CHECK(locking_angles(crank).empty());
  const Function never = four_bar_locking(crank);
  double nearest = 10;
  for (double theta2 = -180; theta2 <= 180; theta2 += 1) {
    const auto lock = evaluate(never, {theta2 * degree});
    CHECK(lock[1] == 0.0);
    nearest = std::min(nearest, lock[0]);
  }
  CHECK(nearest / degree == Approx(8.646).margin(0.001));
  const auto angles = locking_angles(rocking);
  REQUIRE(angles.size() == 1);
  const Function locking = four_bar_locking(rocking), function = four_bar(rocking);
  CHECK(evaluate(locking, {angles[0]})[0] < 1e-7);
  CHECK(evaluate(locking, {angles[0] - 1e-3})[1] == 0.0);
  CHECK(evaluate(locking, {angles[0] + 1e-3})[1] == 1.0);
  CHECK(evaluate(locking, {-angles[0] - 1e-3})[1] == 1.0);
  for (int ulps = -1000; ulps <= 1000; ulps += 25) {
    const double theta2 = angles[0] + ulps * 2.2e-16;
    CHECK(all_finite(evaluate(function, {theta2})));
    const double status = evaluate(locking, {theta2})[1];
    CHECK((status == 0.0 || status == 1.0));
  }
  for (double theta2 = -7; theta2 < 7; theta2 += 0.1) {
    CHECK(all_finite(evaluate(function, {theta2})));
    CHECK(all_finite(evaluate(four_bar_coupler_pose(rocking), {theta2})));
  }
}

TEST_CASE("crank meeting the rocker's pivot stays finite", "[four_bar]") {
  FourBarParameters p = four_bar_parameters();
  p.crank = p.ground;  // at theta2 = 0 the diagonal vanishes
  for (const double theta2 : {0.0, 1e-300, 1e-16, 1e-9})
    CHECK(all_finite(evaluate(four_bar(p), {theta2})));
}

TEST_CASE("crank tendons are antagonists", "[four_bar]") {
  const FourBarParameters p = four_bar_parameters();
  const auto h = evaluate(four_bar_tendon_lengths(p), {p.reference_theta2 + 0.2});
  CHECK(h[0] == Approx(0.001).epsilon(1e-12));
  CHECK(h[1] == -h[0]);
}

TEST_CASE("four-bar refuses links that are none", "[four_bar]") {
  FourBarParameters p = four_bar_parameters();
  p.branch = 0;
  CHECK_THROWS_AS(four_bar(p), std::invalid_argument);
  p.branch = 1;
  p.rocker = 0.0;
  CHECK_THROWS_AS(four_bar(p), std::invalid_argument);
}
