// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/adopted_fit.h"

#include <catch2/catch.hpp>
#include <string>

#include "identification/regression/baseline.h"
#include "identification/regression/noise_model.h"
#include "identification/regression/refine.h"

using namespace sinew::diagnosis;

// Seen red with the candidates that a name stands for besides left out.
TEST_CASE("a candidate's cause is the one that it is told by, or that stands for it, too") {
  Verdict verdict;
  verdict.causes.resize(2);
  verdict.causes[0].candidate = 4;
  verdict.causes[1].candidate = 0;
  verdict.causes[1].also = {1};
  CHECK(cause_of(verdict, 0) == 1);
  CHECK(cause_of(verdict, 1) == 1);
  CHECK(cause_of(verdict, 4) == 0);
  CHECK(cause_of(verdict, 2) == -1);
}

namespace {

/// A sine of the position, as much as its coefficient says, none of which may be negative.
Candidate sine(const std::string& name, double times, bool nuisance) {
  Candidate c;
  c.name = name;
  c.nuisance = nuisance;
  c.linear.resize(1);
  c.linear.front().low = 0.0;
  c.columns = [times](const Recording& r, int, const Eigen::VectorXd&) -> Eigen::MatrixXd {
    return (times * r.q.col(0).array()).sin().matrix();
  };
  return c;
}

}  // namespace

// Seen red with what is fitted in any case refused as causes are: a finger's report told that noise
// of its motors' sensors cannot be adopted.
TEST_CASE("a cause beyond its limits is refused, and not what is fitted in any case") {
  constexpr Eigen::Index n = 8000;
  Recording log;
  log.step = 0.001;
  log.time = Eigen::VectorXd::LinSpaced(n, 0.0, log.step * static_cast<double>(n - 1));
  log.q = Eigen::VectorXd::LinSpaced(n, 0.0, 60.0);
  log.qd = log.qdd = Eigen::MatrixXd::Zero(n, 1);
  // Both are negative in the log.
  log.target = {Eigen::VectorXd(-log.q.col(0).array().sin() - (2.0 * log.q.col(0).array()).sin())};
  Problem problem;
  problem.training = {log};
  problem.library = {sine("noise", 1.0, true), sine("cause", 2.0, false)};
  const Design design(problem, {});
  Explanation explanation;
  Selection& fit = explanation.selection;
  fit.model = baseline_model(design);
  for (const Candidate& c : problem.library)
    fit.model.terms.push_back(make_term(design, c, {}, false));
  fit.noise = own_noise(design, fit.model);
  const AdoptedFit possible = possible_fit(design, explanation);
  REQUIRE(possible.refused.size() == 1);
  CHECK(possible.refused.front().starts_with("cause"));
  REQUIRE(possible.selection.model.terms.size() == 1);
  CHECK(possible.selection.model.terms.front().candidate->name == "noise");
}
