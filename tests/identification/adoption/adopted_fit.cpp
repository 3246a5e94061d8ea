// SPDX-License-Identifier: GPL-3.0-or-later
// What the model is extended by holds what is told, and nothing that made up for it in the fit.
#include <catch2/catch.hpp>

#include "identification/adoption/adopted_fit.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"
#include "tests/identification/diagnosis/two_joints.h"

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Candidate term(const std::string& name, bool of_body, double harmonic) {
  Candidate c;
  c.name = name;
  c.place = "arm";
  c.of_body = of_body;
  c.linear.push_back({"size", "", -1e9, 1e9, false, {}});
  c.columns = [harmonic](const Recording& r, int, const VectorXd&) -> MatrixXd {
    return (harmonic * r.q.col(0).array()).cos();
  };
  return c;
}

/// One channel; of a payload, another link and a spring together.
Problem three_causes() {
  Problem problem;
  problem.channels = 1;
  problem.library = {term("payload", true, 1.0), term("link", true, 1.2), term("spring", false, 3)};
  Recording log = test::two_joint_motion();
  VectorXd y = VectorXd::Zero(log.q.rows());
  for (const Candidate& c : problem.library) y += c.columns(log, 0, VectorXd()).col(0);
  log.target.push_back(y);
  problem.training.push_back(std::move(log));
  return problem;
}

}  // namespace

TEST_CASE("a body that no cause tells is not left in the fit that is adopted") {
  // Two bodies share what their joints feel: the told one's mass would be what both have. Planted
  // defect: remove_untold_bodies() without effect (adopted_fit.cpp): three terms.
  const Problem problem = three_causes();
  const Settings settings = test::below_20_hz();
  const Design design(problem, settings);
  Explanation explanation;
  Model& model = explanation.selection.model;
  model = baseline_model(design);
  for (const Candidate& c : problem.library)
    model.terms.push_back(make_term(design, c, VectorXd(), false));
  explanation.selection.noise = own_noise(design, model);
  NamedCause payload;
  payload.candidate = 0;
  explanation.verdict.causes.push_back(payload);

  const AdoptedFit fit = possible_fit(design, explanation);
  CHECK(fit.refused == std::vector<std::string>{});
  REQUIRE(fit.selection.model.terms.size() == 2);
  CHECK(fit.selection.model.terms[0].candidate->name == "payload");
  CHECK(fit.selection.model.terms[1].candidate->name == "spring");

  // As one of several that the same name stands for it is told.
  explanation.verdict.causes.front().also = {1};
  CHECK(possible_fit(design, explanation).selection.model.terms.size() == 3);
  CHECK(cause_of(explanation.verdict, 1) == 0);
  CHECK(cause_of(explanation.verdict, 2) == -1);
}
