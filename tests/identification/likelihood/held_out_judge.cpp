// SPDX-License-Identifier: GPL-3.0-or-later
// What the model is extended by holds what held-out logs confirm, and nothing that made up for it
// in the fit.
#include "identification/likelihood/held_out_judge.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "identification/likelihood/explain.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"
#include "tests/identification/diagnosis/two_joints.h"

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Candidate term(const std::string& name, double harmonic) {
  Candidate c;
  c.name = name;
  c.place = "arm";
  c.linear.push_back({"size", "", -1e9, 1e9, false, {}});
  c.columns = [harmonic](const Recording& r, int, const VectorXd&) -> MatrixXd {
    return (harmonic * r.q.col(0).array()).cos();
  };
  return c;
}

/// One channel of two logs; what a cause adds to the first and to the held-out one.
struct Hidden {
  std::string name;
  double harmonic, training, held_out;
};

Problem problem_of(const std::vector<Hidden>& hidden) {
  Problem problem;
  problem.channels = 1;
  Recording log = test::two_joint_motion();
  Recording later = log;
  std::srand(5);
  VectorXd y = 1e-3 * VectorXd::Random(log.q.rows()), z = 1e-3 * VectorXd::Random(log.q.rows());
  for (const Hidden& h : hidden) {
    problem.library.push_back(term(h.name, h.harmonic));
    const VectorXd column = problem.library.back().columns(log, 0, VectorXd()).col(0);
    y += h.training * column;
    z += h.held_out * column;
  }
  log.target.push_back(y);
  later.target.push_back(z);
  problem.training.push_back(std::move(log));
  problem.holdout.push_back(std::move(later));
  return problem;
}

/// Names that are told, since held-out logs confirm them or cannot tell, and those of the terms
/// that are left in the fit; how many times as much is left over without the names that are not
/// told.
struct Judged {
  std::vector<std::string> sure, stand, fitted;
  double left_without = 1.0;
};

Judged judged(const Problem& problem) {
  const Settings settings = test::below_20_hz();
  const Design design(problem, settings);
  Selection adopted;
  adopted.model = baseline_model(design);
  std::vector<NamedCause> causes;
  for (const Candidate& c : problem.library) {
    adopted.model.terms.push_back(make_term(design, c, VectorXd(), false));
    causes.emplace_back();
    causes.back().members.emplace_back();
    causes.back().members.front().name = c.name;
    causes.back().log_odds = 100.0;
  }
  adopted.noise = own_noise(design, adopted.model);
  FoundSlots found;
  found.whitening = whitening_beside(design, adopted.model, VectorXd::Constant(1, 1e-9));
  Judged result;
  for (const NamedCause& cause : HeldOutJudge(design, settings, found).causes(causes, adopted)) {
    if (is_sure(cause.confirmed)) result.sure.push_back(cause.members.front().name);
    if (cause.stands) result.stand.push_back(cause.members.front().name);
    result.left_without = std::max(result.left_without, cause.left_without);
  }
  for (const Term& t : adopted.model.terms) result.fitted.push_back(t.candidate->name);
  return result;
}

using Names = std::vector<std::string>;

}  // namespace

// Seen red with its term left in the fit.
TEST_CASE("a name that held-out logs do not confirm is not left in the fit") {
  const Judged j = judged(problem_of({{"link", 1.2, 0.3, 0.0}, {"payload", 1.0, 1.0, 1.0}}));
  CHECK(j.sure == Names{"payload"});
  CHECK(j.fitted == Names{"payload"});
  // 0.3 beside a noise of 6e-4, less where both say the same. Seen red where it is not measured: 1.
  CHECK(j.left_without > 20.0);
}

// Seen red with no name standing: the logs disagreed. A slow held-out log tells a delay hardly.
TEST_CASE("a plain name stands beside held-out logs that cannot tell, not against them") {
  for (const double held_out : {0.03, -0.03}) {
    Problem problem = problem_of({{"delay", 1.0, 0.03, held_out}});
    problem.holdout.front().target.front() +=
        1.5 * VectorXd::Random(problem.holdout.front().q.rows());
    const Judged j = judged(problem);
    INFO(held_out);
    CHECK(j.sure.empty());
    CHECK(j.stand == (held_out > 0.0 ? Names{"delay"} : Names{}));
    CHECK(j.fitted == j.stand);
  }
}

// Seen red with all that are not sure withdrawn at once: the spring alone was left.
TEST_CASE("of two names that say the same, neither sure beside the other, one is told") {
  const Judged j = judged(
      problem_of({{"link", 1.0, 0.5, 0.5}, {"payload", 1.0, 0.5, 0.5}, {"spring", 3.0, 1.0, 1.0}}));
  REQUIRE(j.sure.size() == 2);
  CHECK(j.fitted.size() == 2);
}

// Seen red with nobody giving way: the logs disagreed.
TEST_CASE("a member of a set that held-out logs refute gives way to one that they confirm") {
  Problem problem = problem_of({{"gravity", 1.0, 1.0, -1.0}});
  // The same in the training log; an encoder that counts from where it was switched on.
  Candidate ripple = term("ripple", 1.0);
  ripple.columns = [](const Recording& r, int, const VectorXd&) -> MatrixXd {
    return (r.name == "later" ? -1.0 : 1.0) * r.q.col(0).array().cos();
  };
  problem.library.push_back(ripple);
  problem.holdout.front().name = "later";
  const Explanation found = explain(problem, test::below_20_hz(), {});
  REQUIRE(found.verdict.causes.size() == 2);
  CHECK_FALSE(is_sure(found.verdict.causes.back().confirmed));
  const NamedCause& cause = found.verdict.causes.front();
  CHECK(is_sure(cause.confirmed));
  REQUIRE(cause.members.size() == 1);
  CHECK(cause.members.front().name == "ripple");
  CHECK(found.selection.model.terms.back().candidate->name == "ripple");
}

// Seen red without settle_nuisances() of what was found: the softness is negative in the model that
// held-out logs judge, and a delay was refuted for it.
TEST_CASE("how friction turns keeps to its limits beside what was found") {
  Problem problem = problem_of({{"payload", 1.0, 1.0, 1.0}});
  Candidate softness = term("softness", 1.3);
  softness.linear.front().low = 0.0;
  softness.nonlinear = {{"width", "", 0.9, 1.1, 3, true}};
  softness.columns = [](const Recording& r, int, const VectorXd& width) -> MatrixXd {
    return (1.3 * width(0) * r.q.col(0).array()).cos();
  };
  for (auto* logs : {&problem.training, &problem.holdout})
    logs->front().target.front() -=
        0.2 * softness.columns(logs->front(), 0, VectorXd::Ones(1)).col(0);
  problem.baseline = {softness};
  const Explanation found = explain(problem, test::below_20_hz(), {});
  REQUIRE_FALSE(found.verdict.causes.empty());
  CHECK(found.verdict.causes.front().members.front().name == "payload");
  for (const Term& t : found.selection.model.terms) CHECK(t.candidate->name != "softness");
}

// Seen red without leave_out_refuted() (explain.cpp): names were told as what the structure leaves.
TEST_CASE("structure that held-out logs do not confirm is left out of what is found") {
  const auto structure_found = [](double held_out) {
    Problem problem = problem_of({{"payload", 1.0, 1.0, 1.0}, {"bumps", 3.0, 0.5, held_out}});
    problem.library.back().kind = CandidateKind::flexible;
    return explain(problem, test::below_20_hz(), {}).structure.size();
  };
  CHECK(structure_found(0.5) == 1);
  CHECK(structure_found(0.0) == 0);
}
