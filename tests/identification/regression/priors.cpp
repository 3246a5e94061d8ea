// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a coefficient before the logs.
#include <catch2/catch.hpp>

#include "identification/regression/linear_fit.h"

using namespace sinew::diagnosis;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Candidate with_spread(double spread) {
  Candidate c;
  c.linear.resize(1);
  c.linear.front().spread = spread;
  return c;
}

}  // namespace

TEST_CASE("of terms that no log tells apart each takes its share by what was known of it") {
  // Planted defects, each seen to fail: prior_precision() all 0 (both take half), the priors' part
  // left out of the deviance.
  const Candidate narrow = with_spread(0.1), wide = with_spread(0.3), free = with_spread(0.0);
  const MatrixXd x = MatrixXd::Constant(1000, 1, 10.0);
  Model model;
  model.target = {VectorXd::Constant(1000, 4.0)};
  const auto add = [&](const Candidate& c) {
    model.terms.emplace_back();
    model.terms.back().candidate = &c;
    model.terms.back().columns = {x};
    model.terms.back().with_prior = true;
  };
  add(narrow);
  add(wide);
  const Weights even{VectorXd::Ones(1000)};
  const LinearFit fit = solve(stack(model, even));
  CHECK(fit.coefficients.sum() == Approx(0.4).epsilon(1e-4));
  CHECK(fit.coefficients(1) == Approx(9.0 * fit.coefficients(0)).epsilon(1e-6));
  const double unlikely = 0.04 * 0.04 / 0.01 + 0.36 * 0.36 / 0.09;
  CHECK(fit.deviance == Approx(unlikely).epsilon(1e-3));
  // Beside what nothing is known of, what is known stays what it was.
  add(free);
  const LinearFit beside = solve(stack(model, even));
  CHECK(beside.coefficients(0) == Approx(0.0).margin(1e-6));
  CHECK(beside.coefficients(2) == Approx(0.4).epsilon(1e-6));
}
