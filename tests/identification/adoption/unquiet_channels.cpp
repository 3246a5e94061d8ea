// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/unquiet_channels.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace sinew::diagnosis;
using Eigen::VectorXd;

namespace {

/// An effort of rms 0.7 with white noise of rms 0.01, of which the model knows the smooth part.
struct Bench {
  Problem problem;
  std::vector<MeasuredChannel> measured;

  explicit Bench(const VectorXd& left_over) {
    const Eigen::Index n = left_over.size();
    std::mt19937_64 random(1);
    std::normal_distribution<double> white(0.0, 0.01);
    const VectorXd said = VectorXd::LinSpaced(n, 0.0, 60.0).array().sin();
    Recording log;
    log.step = 0.001;
    log.target = {said + left_over + VectorXd::NullaryExpr(n, [&] { return white(random); })};
    problem.training = {log};
    MeasuredChannel m;
    m.step = 0.001;
    m.measured = log.target.front();
    m.before = m.after = said;
    measured = {m};
  }
};

}  // namespace

TEST_CASE("contacts are no noise, however little they depend on the motion") {
  // Planted defect, seen to fail: kBursts 1e9 in unquiet_channels.cpp says nothing of them.
  VectorXd pulses = VectorXd::Zero(20000);
  for (Eigen::Index k = 900; k < 20000; k += 2113) pulses.segment(k, 60).setConstant(0.6);
  const Bench bench(pulses);
  const auto found = unquiet_channels(bench.problem, bench.measured);
  REQUIRE(found.size() == 1);
  CHECK(found.front().channel == 0);
  CHECK(found.front().times_noise > 5.0);
}

TEST_CASE("noise that is slow and large is noise") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> white(0.0, 0.01);
  VectorXd slow = VectorXd::Zero(20000);
  for (Eigen::Index k = 1; k < slow.size(); ++k) slow(k) = 0.98 * slow(k - 1) + white(random);
  const Bench bench(slow);
  CHECK(unquiet_channels(bench.problem, bench.measured).empty());
}
