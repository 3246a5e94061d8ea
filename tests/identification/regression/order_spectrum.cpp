// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/order_spectrum.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

/// To and fro at speeds that vary; lines of unit noise times `size` at the orders given.
ShaftLog turning(double travel, const std::vector<double>& orders, double size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  constexpr Index samples = 20000;
  ShaftLog log{VectorXd(samples), VectorXd(samples), VectorXd::Ones(samples)};
  for (Index i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    log.turns(i) = 0.5 * travel * (std::sin(13.0 * t) + 0.3 * std::sin(41.0 * t + seed));
    log.value(i) = gauss(random);
    for (const double order : orders)
      log.value(i) += size * std::sin(2.0 * std::numbers::pi * order * log.turns(i) + seed);
  }
  return log;
}

std::vector<int> orders(const std::vector<ShaftLog>& logs, int lowest, int highest) {
  std::vector<int> list;
  for (const OrderLine& line : order_lines(logs, lowest, highest)) list.push_back(line.order);
  return list;
}

}  // namespace

TEST_CASE("lines over the angle are found at whole orders, whatever the speed") {
  CHECK(orders({turning(12.0, {24.0}, 0.3, 1)}, 4, 60) == std::vector<int>{24});
  const auto two = orders({turning(12.0, {7.0, 31.0}, 0.3, 2)}, 4, 60);
  CHECK(std::set<int>(two.begin(), two.end()) == std::set<int>{7, 31});
  CHECK(orders({turning(12.0, {17.4}, 0.3, 3)}, 4, 60).empty());
  // A third of a line's width off. Planted defect, seen to fail: no look at where the top lies.
  CHECK(orders({turning(12.0, {17.03}, 0.5, 3)}, 4, 60).empty());
}

TEST_CASE("a line is found where the noise is low, and beside what turning back leaves over") {
  ShaftLog log = turning(12.0, {24.0}, 0.5, 6);
  std::mt19937_64 random(7);
  std::normal_distribution<double> gauss;
  double slow = 0.0;
  for (Index i = 1; i < log.turns.size(); ++i) {
    // Thirty times the line at low frequencies. Planted defect, seen to fail: every precision 1.
    slow += -0.001 * slow + 0.7 * gauss(random);
    log.value(i) += slow;
    if (std::abs(log.turns(i) - log.turns(i - 1)) > 3e-4) continue;
    // Planted defect, seen to fail: what does not count counts.
    log.counts(i) = 0.0;
    log.value(i) += 100.0 * gauss(random);
  }
  CHECK(orders({log}, 4, 60) == std::vector<int>{24});
}

TEST_CASE("logs add up, each with its own phase") {
  // Planted defect, seen to fail: the sum's chance that of one log (an order of noise is found).
  const double weak = 0.035;
  CHECK(orders({turning(6.0, {9.0}, weak, 4)}, 4, 60).empty());
  std::vector<ShaftLog> logs;
  for (unsigned seed = 4; seed < 12; ++seed) logs.push_back(turning(6.0, {9.0}, weak, seed));
  CHECK(orders(logs, 4, 60) == std::vector<int>{9});
}

TEST_CASE("noise has no order, and a few turns tell none") {
  int told = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
    told += orders({turning(8.0, {}, 0.0, seed)}, 4, 60).empty() ? 0 : 1;
  CHECK(told == 0);
  CHECK(orders({turning(2.0, {24.0}, 1.0, 1)}, 4, 60).empty());
}

TEST_CASE("a line's size is told, and what it gains on blocks that it was not fitted to") {
  const ShaftLog log = turning(12.0, {24.0}, 0.4, 1);
  const LineFit fit = fit_line(log, 24, 20);
  CHECK(fit.sine == Approx(0.4 * std::cos(1.0)).margin(0.03));
  CHECK(fit.cosine == Approx(0.4 * std::sin(1.0)).margin(0.03));
  // The line is a part of the spectrum that noise is taken to have, so that it gains a little less
  // than its share of the energy.
  const double share = 1.0 - fit.with.sum() / fit.without.sum();
  CHECK(share < 0.08 / 1.08);
  CHECK(share > 0.8 * 0.08 / 1.08);
  CHECK(fit.sine_error == Approx(0.01).epsilon(0.5));
  CHECK(fit.cosine_error == Approx(0.01).epsilon(0.5));
  // Of noise it gains nothing. Planted defect, seen to fail: fitted to the same blocks it does.
  const LineFit none = fit_line(turning(12.0, {}, 0.0, 1), 24, 20);
  CHECK(none.with.sum() > none.without.sum());
}

TEST_CASE(
    "where a ripple is faster than the samples its size is told by those that are slow enough") {
  // Seen to fail with all samples: of an effort that each sample averages the line came out at a
  // twentieth of its size.
  constexpr double kOrder = 24.0, kSize = 4.0;
  constexpr Index kEach = 25;  // samples that one is the mean of
  const ShaftLog log = turning(5.0, {}, 0.0, 1);
  const Index n = log.turns.size() / kEach;
  ShaftLog coarse{VectorXd(n), VectorXd(n), VectorXd::Ones(n), 0.1};
  for (Index i = 0; i < n; ++i) {
    coarse.turns(i) = log.turns(kEach * i + kEach / 2);
    coarse.value(i) = log.value(kEach * i) + kSize * (2.0 * std::numbers::pi * kOrder *
                                                      log.turns.segment(kEach * i, kEach).array())
                                                         .sin()
                                                         .mean();
  }
  const LineFit fit = fit_line(coarse, 24, 10);
  CHECK(fit.sine == Approx(kSize).epsilon(0.2));
}
