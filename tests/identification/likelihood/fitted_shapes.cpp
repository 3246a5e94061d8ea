// SPDX-License-Identifier: GPL-3.0-or-later
// A shape that is fitted without its limits stays within them.
#include "identification/likelihood/fitted_shapes.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "identification/likelihood/explain.h"
#include "tests/identification/diagnosis/two_joints.h"

namespace {

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTurnOfOne = 0.05;

MatrixXd turned(const Recording& r, double lag) {
  return (r.q.col(0).array() + kTurnOfOne * lag).cos().matrix();
}

Candidate named(const std::string& name) {
  Candidate c;
  c.name = name;
  c.place = "arm";
  c.linear.push_back({"size", "", -1e9, 1e9, false, {}});
  return c;
}

/// A lag of 2.8 is hidden, of a size of 1.
Problem problem_with_lag() {
  Problem problem;
  problem.channels = 1;
  // A lag may be 2.2 times its size at most.
  Candidate lag = named("lag");
  lag.nonlinear = {{"lag", "", 0.5, 4.0, 4, true}};
  lag.columns = [](const Recording& r, int, const VectorXd& n) { return turned(r, n(0)); };
  lag.possible = [](const VectorXd& size, const VectorXd& n) { return n(0) < 2.2 * size(0); };
  Candidate other = named("turned by more");
  other.columns = [](const Recording& r, int, const VectorXd&) { return turned(r, 8.0); };
  problem.library = {lag, other};
  std::srand(5);
  Recording log = test::two_joint_motion();
  log.target.push_back(turned(log, 2.8) + 0.2 * VectorXd::Random(log.q.rows()));
  problem.training.push_back(std::move(log));
  return problem;
}

}  // namespace

// Seen red without keep_best(): the free fit has 2.8, the lag was banned for it, and the other name
// told.
TEST_CASE("a cause whose free fit leaves its limits is told within them") {
  const Problem problem = problem_with_lag();
  const Explanation found = explain(problem, test::below_20_hz(), {});
  REQUIRE(found.verdict.causes.size() == 1);
  const NamedCause& cause = found.verdict.causes.front();
  CHECK(cause.members.front().name == "lag");
  const Term& term = found.selection.model.terms.back();
  REQUIRE(term.candidate->name == "lag");
  CHECK(term.nonlinear(0) < 2.2);
}
