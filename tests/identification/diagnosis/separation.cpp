// SPDX-License-Identifier: GPL-3.0-or-later
// Payload or torque gain: one joint cannot tell, a second one can.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/diagnosis/separation.h"
#include "identification/likelihood/explain.h"
#include "tests/identification/diagnosis/two_joints.h"

namespace {

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Candidate group(const std::string& name, ColumnFunction columns) {
  Candidate c;
  c.name = name;
  c.place = "arm";
  c.linear.push_back({"size", "", -1e9, 1e9, false, {}});
  c.columns = std::move(columns);
  c.isolating_experiment = "hold " + name;
  return c;
}

/// Two joints, the second's own gravity torque not proportional to what a payload adds.
Problem arm(int channels, double payload, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  Recording log = test::two_joint_motion();
  log.command.resize(log.q.rows(), 2);
  log.command.col(0) = log.q.col(0).array().cos();
  log.command.col(1) = log.q.col(1).array().cos() + 0.8 * (log.q.col(1).array() * 3.0).sin();
  for (int c = 0; c < channels; ++c) {
    double state = 0.0;
    VectorXd y = payload * log.q.col(c).array().cos();
    for (double& value : y) {
      state = 0.97 * state + gauss(random);
      value += 0.02 * state;
    }
    log.target.push_back(y);
  }
  Problem problem;
  problem.channels = channels;
  problem.training.push_back(std::move(log));
  for (int c = 0; c < channels; ++c) {
    Candidate offset = group("offset", [](const Recording& r, int, const VectorXd&) -> MatrixXd {
      return VectorXd::Ones(r.q.rows());
    });
    offset.channels = {c};
    problem.baseline.push_back(std::move(offset));
  }
  problem.library = {group("payload",
                           [](const Recording& r, int c, const VectorXd&) -> MatrixXd {
                             return r.q.col(c).array().cos();
                           }),
                     group("torque gain",
                           [](const Recording& r, int c, const VectorXd&) -> MatrixXd {
                             return r.command.col(c);
                           }),
                     group("spring", [](const Recording& r, int c, const VectorXd&) -> MatrixXd {
                       return r.q.col(c);
                     })};
  return problem;
}

Explanation explained(const Problem& problem, const ExperimentPlanner& planner) {
  Explanation e = explain(problem, test::below_20_hz());
  propose_experiments(problem, test::below_20_hz(), planner, e);
  return e;
}

}  // namespace

TEST_CASE("one joint cannot tell a payload from a torque gain, and says so") {
  const Explanation e = explained(arm(1, 0.3, 4), {});
  REQUIRE(e.verdict.causes.size() == 1);
  CHECK(e.verdict.causes[0].members.size() == 2);
  CHECK(e.verdict.causes[0].separation.experiment == "hold payload");
  CHECK_FALSE(e.verdict.causes[0].separation.motion);
  for (const RankedCause& member : e.verdict.causes[0].members) CHECK(member.name != "spring");
}

TEST_CASE("a second joint separates them") {
  const Explanation e = explain(arm(2, 0.3, 4), test::below_20_hz());
  REQUIRE(e.verdict.causes.size() == 1);
  REQUIRE(e.verdict.causes[0].members.size() == 1);
  CHECK(e.verdict.causes[0].members[0].name == "payload");
  REQUIRE(e.verdict.causes[0].parameters.size() == 1);
  const ParameterEstimate& size = e.verdict.causes[0].parameters[0];
  CHECK(std::abs(size.value - 0.3) < 5.0 * size.standard_error);
  CHECK(size.standard_error < 0.1);
}

TEST_CASE("the planned motion that separates a set is the one proposed") {
  // Planted defect: with left_by() (separation.cpp) leaving the rival out, every motion seems to
  // separate them, and the first one is proposed.
  const Problem problem = arm(1, 0.3, 6);
  const auto planned = [&](const std::string& name, double bend) {
    Recording log = problem.training[0];
    log.target[0].setZero();
    log.command.col(0) = log.q.col(0).array().cos() + bend * (log.q.col(0).array() * 3.0).sin();
    return PlannedExperiment{{name, problem.training[0].step, {}, {}}, [log] { return log; }};
  };
  const std::vector<PlannedExperiment> all{planned("as it was", 0.0), planned("a little", 0.3),
                                           planned("much", 0.9), planned("some", 0.5)};
  const Explanation e = explained(problem, [&](int) { return all; });
  REQUIRE(e.verdict.causes.size() == 1);
  const Separation& separation = e.verdict.causes[0].separation;
  CHECK(separation.experiment == "much");
  CHECK(separation.expected > 5.0);
  REQUIRE(separation.motion);
  CHECK(separation.motion->name == "much");
}

TEST_CASE("where no planned motion would settle a set, what isolates a member is proposed") {
  const Problem problem = arm(1, 0.3, 6);
  Recording log = problem.training[0];
  log.target[0].setZero();
  const PlannedExperiment same{{"as it was", problem.training[0].step, {}, {}},
                               [log] { return log; }};
  const std::vector<PlannedExperiment> all{same};
  const Explanation e = explained(problem, [&](int) { return all; });
  REQUIRE(e.verdict.causes.size() == 1);
  CHECK(e.verdict.causes[0].separation.experiment == "hold payload");
  CHECK_FALSE(e.verdict.causes[0].separation.motion);
}
