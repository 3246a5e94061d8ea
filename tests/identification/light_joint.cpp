// SPDX-License-Identifier: GPL-3.0-or-later
// Joints of one arm: a light one beside a heavy one, and one delay of both.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/explain.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStep = 5e-3;
constexpr Index kSamples = 6000;
constexpr double kHeavy = 200.0, kLight = 1.0;  // N·m of both joints' weight per rad

double weight_of(int joint) {
  return joint == 0 ? kHeavy : kLight;
}

double angle(int joint, double t) {
  return joint == 0 ? 1.1 * std::sin(0.9 * t) + 0.4 * std::sin(2.3 * t)
                    : 0.8 * std::sin(1.3 * t + 1.0) + 0.5 * std::sin(3.1 * t);
}

/// What acts on one joint, or on both.
Candidate group(const std::string& name, std::vector<int> channels, ColumnFunction columns) {
  Candidate c;
  c.name = name;
  c.place = channels.size() == 1 ? "joint " + std::to_string(channels.front()) : "all joints";
  c.channels = std::move(channels);
  c.linear.push_back({"size", "", -1e9, 1e9, false, 0.0});
  c.columns = std::move(columns);
  return c;
}

MatrixXd velocity(const Recording& log, int channel, const VectorXd&) {
  return log.qd.col(channel);
}

MatrixXd tripled(const Recording& log, int channel, const VectorXd&) {
  return (3.0 * log.q.col(channel).array()).sin();
}

/// Two joints with their weight and damping. The noise is 1 % of each joint's own effort.
/// hidden: of the light joint's effort; delay: of both efforts, as late as a bus makes them.
Problem arm(double hidden, double delay, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  Recording log;
  log.name = "arm";
  log.step = kStep;
  log.time = ArrayXd::LinSpaced(kSamples, 0.0, kStep * static_cast<double>(kSamples - 1));
  log.q.resize(kSamples, 2);
  log.qd.resize(kSamples, 2);
  Problem problem;
  problem.channels = 2;
  for (int c = 0; c < 2; ++c) {
    VectorXd said(kSamples), measured(kSamples);
    for (Index k = 0; k < kSamples; ++k) {
      const double t = log.time(k);
      log.q(k, c) = angle(c, t);
      log.qd(k, c) = (angle(c, t + 1e-5) - angle(c, t - 1e-5)) / 2e-5;
      said(k) = weight_of(c) * angle(c, t);
      measured(k) = weight_of(c) * (angle(c, t + delay) + 0.01 * gauss(random));
      if (c == 1) measured(k) += hidden * std::sin(3.0 * log.q(k, c));
    }
    log.target.push_back(measured);
    log.known.push_back(said);
    problem.baseline.push_back(group("viscous level", {c}, velocity));
    problem.library.push_back(group("ripple", {c}, tripled));
    LevelCause level;
    level.name = "viscous level";
    level.place = "joint " + std::to_string(c);
    level.parameters.resize(1);
    level.parameters.front().name = "change";
    level.parameters.front().shares = {{c, 0, 1.0}};
    problem.levels.push_back(level);
  }
  LevelCause late;
  late.name = "delay";
  late.place = "all joints";
  late.parameters.resize(1);
  late.parameters.front().name = "delay";
  late.delayed = {0, 1};
  problem.levels.push_back(late);
  problem.training.push_back(std::move(log));
  return problem;
}

Settings quick() {
  Settings settings;
  settings.band_hz = 20.0;
  settings.surrogates = 100;
  return settings;
}

}  // namespace

TEST_CASE("a cause at a light joint is named beside a heavy one") {
  Problem problem = arm(0.01 * kLight, 0.0, 31);
  const Explanation e = explain(problem, quick());
  REQUIRE(e.verdict.causes.size() == 1);
  CHECK(e.verdict.causes[0].members[0].name == "ripple");
  CHECK(e.verdict.causes[0].members[0].place == "joint 1");
  // The share is that of its own joint.
  CHECK(e.verdict.causes[0].cross_validated.share > 0.3);
  // Planted: all errors in N·m together. The heavy joint's noise leaves the light one no share.
  problem.shared_noise = true;
  CHECK(explain(problem, quick()).verdict.causes.empty());
}

TEST_CASE("one delay of both joints is one cause, not a damping of each") {
  for (const double delay : {4e-3, -3e-3}) {
    Problem problem = arm(0.0, delay, 32);
    const Explanation e = explain(problem, quick());
    CAPTURE(delay);
    REQUIRE(e.verdict.causes.size() == 1);
    CHECK(e.verdict.causes[0].members[0].name == "delay");
    REQUIRE(e.verdict.causes[0].parameters.size() == 1);
    const ParameterEstimate& found = e.verdict.causes[0].parameters[0];
    CHECK(std::abs(found.value - delay) < 5.0 * found.standard_error);
    // Planted: without the delay among the levels.
    problem.levels.pop_back();
    CHECK(explain(problem, quick()).verdict.causes.size() == 2);
  }
}

TEST_CASE("an arm that hides nothing has no cause") {
  CHECK(explain(arm(0.0, 0.0, 33), quick()).verdict.causes.empty());
}
