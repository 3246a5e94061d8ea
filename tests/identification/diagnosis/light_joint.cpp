// SPDX-License-Identifier: GPL-3.0-or-later
// Joints of one arm: a light one beside a heavy one, and one delay of both.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/likelihood/explain.h"
#include "tests/identification/diagnosis/two_joints.h"

namespace {

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kHeavy = 200.0, kLight = 1.0;  // N·m of both joints' weight per rad

double weight_of(int joint) {
  return joint == 0 ? kHeavy : kLight;
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
/// hidden: of the light joint's effort; delay: both efforts act that much later, to first order.
Problem arm(double hidden, double delay, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  Recording log = test::two_joint_motion();
  Problem problem;
  problem.channels = 2;
  for (int c = 0; c < 2; ++c) {
    const VectorXd said = weight_of(c) * log.q.col(c);
    VectorXd measured = said + weight_of(c) * delay * log.qd.col(c);
    for (double& effort : measured) effort += 0.01 * weight_of(c) * gauss(random);
    if (c == 1) measured.array() += hidden * (3.0 * log.q.col(c).array()).sin();
    log.target.push_back(measured);
    log.known.push_back(said);
    problem.baseline.push_back(group("viscous level", {c}, velocity));
    problem.library.push_back(group("ripple", {c}, tripled));
    ParameterDeviation deviation;
    deviation.name = "viscous level";
    deviation.place = "joint " + std::to_string(c);
    deviation.parameters.resize(1);
    deviation.parameters.front().name = "change";
    deviation.parameters.front().shares = {{c, 0, 1.0}};
    problem.deviations.push_back(deviation);
  }
  ParameterDeviation late;
  late.name = "delay";
  late.place = "all joints";
  late.parameters.resize(1);
  late.parameters.front().name = "delay";
  late.delayed = {0, 1};
  problem.deviations.push_back(late);
  problem.training.push_back(std::move(log));
  return problem;
}

}  // namespace

TEST_CASE("a cause at a light joint is named beside a heavy one") {
  const Explanation e = explain(arm(0.01 * kLight, 0.0, 31), test::below_20_hz());
  REQUIRE(e.verdict.causes.size() == 1);
  CHECK(e.verdict.causes[0].members[0].name == "ripple");
  CHECK(e.verdict.causes[0].members[0].place == "joint 1");
  // The share is that of its own joint.
  CHECK(e.verdict.causes[0].cross_validated.share > 0.3);
}

TEST_CASE("one delay of both joints is one cause, not a damping of each") {
  for (const double delay : {4e-3, -3e-3}) {
    Problem problem = arm(0.0, delay, 32);
    const Explanation e = explain(problem, test::below_20_hz());
    CAPTURE(delay);
    REQUIRE(e.verdict.causes.size() == 1);
    CHECK(e.verdict.causes[0].members[0].name == "delay");
    REQUIRE(e.verdict.causes[0].parameters.size() == 1);
    const ParameterEstimate& found = e.verdict.causes[0].parameters[0];
    CHECK(std::abs(found.value - delay) < 5.0 * found.standard_error);
    // Planted: without the delay among the deviations.
    problem.deviations.pop_back();
    CHECK(explain(problem, test::below_20_hz()).verdict.causes.size() == 2);
  }
}

TEST_CASE("an arm that hides nothing has no cause") {
  CHECK(explain(arm(0.0, 0.0, 33), test::below_20_hz()).verdict.causes.empty());
}
