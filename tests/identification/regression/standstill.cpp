// SPDX-License-Identifier: GPL-3.0-or-later
// Standstill is found where a joint rests, and nowhere else.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "identification/regression/standstill.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStep = 0.002, kCutoff = 60.0;

/// Strokes of one second with rests of `rest` seconds between, fifth-order in time.
VectorXd strokes(double rest, int count) {
  const auto still = static_cast<Index>(rest / kStep), moving = static_cast<Index>(1.0 / kStep);
  VectorXd v = VectorXd::Zero(count * (still + moving));
  for (int i = 0; i < count; ++i)
    for (Index k = 0; k < moving; ++k) {
      const double s = static_cast<double>(k) / static_cast<double>(moving), r = 1.0 - s;
      v(i * (still + moving) + k) = (i % 2 == 0 ? 30.0 : -30.0) * s * s * r * r;
    }
  return v;
}

VectorXd times(const VectorXd& like) {
  return VectorXd::LinSpaced(like.size(), 0.0, kStep * static_cast<double>(like.size() - 1));
}

std::vector<Standstill> found_in(const std::vector<VectorXd>& velocities) {
  return find_standstills({find_stillness(velocities, kStep, kCutoff)}, times(velocities.front()));
}

double length(const std::vector<Standstill>& found) {
  double sum = 0.0;
  for (const Standstill& each : found) sum += each.to - each.from;
  return sum;
}

}  // namespace

TEST_CASE("standstill is the rest between strokes with the ways into and out of it") {
  const VectorXd v = strokes(0.3, 6);
  const auto found = found_in({v});
  REQUIRE(found.size() == 7);  // the first sample, at rest as well, counts as a reversal
  for (std::size_t i = 1; i + 1 < found.size(); ++i) {
    const double begin = 1.3 * static_cast<double>(i - 1) + 1.0;
    CHECK(found[i].from < begin);
    CHECK(found[i].from > begin - 0.15);
    CHECK(found[i].to > begin + 0.3);
    CHECK(found[i].to < begin + 0.45);
  }
  const VectorXd window = motion_window(found, times(v));
  for (Index k = 0; k < v.size(); ++k) {
    if (v(k) == 0.0 && k > 0) CHECK(window(k) == 0.0);
    if (std::abs(v(k)) > 0.5) CHECK(window(k) == 1.0);
  }
}

TEST_CASE("a reversal is standstill until the joint is under way, slow motion is none") {
  VectorXd v(8000);
  const auto swing = [&](double hertz) {
    for (Index k = 0; k < v.size(); ++k)
      v(k) = std::cos(2.0 * std::numbers::pi * hertz * kStep * static_cast<double>(k));
    return found_in({v});
  };
  const auto found = swing(0.5);
  REQUIRE(found.size() == 16);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double turn = static_cast<double>(i) + 0.5;
    CHECK(found[i].from < turn);
    CHECK(found[i].to > turn);
    // 6 ms to each side for the smoother, and 3.2 ms below a hundredth of the speed.
    CHECK(found[i].to - found[i].from == Approx(0.0184).margin(2.5 * kStep));
  }
  // Nothing would be left between the reversals of a vibration.
  CHECK(swing(50.0).empty());
  // A friction curve's slow strokes: a hundredth of the fastest.
  for (Index k = 0; k < v.size(); ++k)
    v(k) = (k / 500 % 2 == 0 ? 1.0 : -1.0) * (k < 4000 ? 0.01 : 1.0);
  CHECK(found_in({v}).size() == 15);
  CHECK(motion_window({}, times(v)).isOnes(0.0));
}

TEST_CASE("where a joint lingers behind its reversals it is not under way") {
  const auto linger = [](double speed) {
    VectorXd v(4000);
    for (Index k = 0; k < v.size(); ++k) {
      const double side = k / 1000 % 2 == 0 ? 1.0 : -1.0;
      v(k) = side * (k % 1000 < 30 ? speed : 1.0);
    }
    return found_in({v});
  };
  const auto found = linger(0.005);
  REQUIRE(found.size() == 3);
  for (const Standstill& each : found) CHECK(each.to - each.from > 0.06);
  // Planted: as fast as a slow stroke. Then a reversal is over as soon as the smoother says.
  for (const Standstill& each : linger(0.02)) CHECK(each.to - each.from < 0.015);
}

TEST_CASE("rest is left out, however much of the log it is") {
  // Seen to fail with a rest left out unless it is 70 % of the log: of the first, nothing was.
  const VectorXd v = strokes(6.0, 4);
  CHECK(length(found_in({v})) > 24.0);
  CHECK(length(found_in({v})) < 25.0);
  CHECK(motion_window(found_in({VectorXd::Zero(v.size())}), times(v)).isZero(0.0));
}

TEST_CASE("of what acts on a joint all rests are left out, and reversals that leave enough") {
  // A joint under way, a tendon that rests in its guide for most of the log, one that vibrates, and
  // one that turns now and then.
  const VectorXd rests = strokes(2.0, 4), time = times(rests);
  const auto moving = [&](auto&& velocity) {
    return find_stillness({time.unaryExpr(velocity).eval()}, kStep, kCutoff);
  };
  const Stillness along = moving([](double) { return 1.0; });
  const Stillness vibrates = moving([](double t) { return std::sin(300.0 * t); });
  const Stillness turns = moving([](double t) { return std::cos(std::numbers::pi * t); });
  const Stillness guided = find_stillness({rests}, kStep, kCutoff);
  const double of_guide = length(find_standstills({along, guided}, time));
  CHECK(of_guide > 8.0);
  CHECK(length(find_standstills({along, vibrates, guided}, time)) == of_guide);
  // Seen to fail with all reversals together: one vibration kept those of the others, too.
  CHECK(length(find_standstills({along, vibrates, turns}, time)) ==
        length(find_standstills({along, turns}, time)));
  CHECK(length(find_standstills({along, turns}, time)) > 0.1);
}

TEST_CASE("the rougher of two velocities does not hide a rest, nor the smoother one") {
  const VectorXd v = strokes(0.3, 6);
  VectorXd rough = v;
  for (Index k = 0; k < rough.size(); ++k) rough(k) += 0.05 * (k % 2 == 0 ? 1.0 : -1.0);
  CHECK(found_in({rough, v}).size() == 7);
  CHECK(found_in({v, rough}).size() == 7);
}
