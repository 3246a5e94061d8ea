// SPDX-License-Identifier: GPL-3.0-or-later
// The share of a grid's step that the logs leave to a fitted shape, against an integral.
#include "identification/likelihood/shape_share.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "identification/likelihood/fitted_baseline.h"
#include "identification/regression/refine.h"
#include "tests/identification/diagnosis/two_joints.h"

namespace {

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLag = 0.14, kLow = 0.025, kHigh = 0.4;
constexpr int kGrid = 5;

/// Any size of a cosine that lags, and one of a sine that says much of the same.
Problem problem_with_lag() {
  Problem problem;
  problem.channels = 1;
  const auto turned = [](const Recording& r, double lag) {
    return MatrixXd((r.q.col(0).array() + lag).cos().matrix());
  };
  Candidate lag;
  lag.name = "lag";
  lag.place = "arm";
  lag.linear.push_back({"size", "", -1e9, 1e9, false, {}});
  lag.nonlinear = {{"lag", "", kLow, kHigh, kGrid, true}};
  lag.columns = [turned](const Recording& r, int, const VectorXd& n) { return turned(r, n(0)); };
  Candidate sine = lag;
  sine.name = "sine";
  sine.nonlinear.clear();
  sine.columns = [](const Recording& r, int, const VectorXd&) {
    return MatrixXd((r.q.col(0).array().sin() + 0.2 * r.qd.col(0).array()).matrix());
  };
  problem.library = {lag, sine};
  std::srand(5);
  Recording log = test::two_joint_motion();
  log.target.push_back(turned(log, kLag) + 0.05 * VectorXd::Random(log.q.rows()));
  problem.training.push_back(std::move(log));
  return problem;
}

Model model_of(const Design& design) {
  Model model = fitted_baseline(design);
  const std::vector<Candidate>& library = design.problem().library;
  model.terms.push_back(make_term(design, library.back(), VectorXd(), false));
  model.terms.push_back(make_term(design, library.front(), VectorXd::Constant(1, kLag), false));
  return model;
}

/// log of the integral of the likelihood over the lag, in steps of the grid, its largest value 1.
double log_integral(const Design& design, const Weights& weights, Model model) {
  const double step = std::log(kHigh / kLow) / (kGrid - 1);
  constexpr int points = 400;
  constexpr double reach = 0.5;  // steps to both sides
  VectorXd left(points);
  for (int i = 0; i < points; ++i) {
    const double u = reach * (2.0 * i / (points - 1) - 1.0);
    model.terms.back() = make_term(design, *model.terms.back().candidate,
                                   VectorXd::Constant(1, kLag * std::exp(step * u)), false);
    left(i) = deviance(model, weights);
  }
  return std::log((-0.5 * (left.array() - left.minCoeff())).exp().sum() * 2.0 * reach /
                  (points - 1));
}

}  // namespace

// Seen red with the other coefficients held: the sine says much of what the lag's rate does.
TEST_CASE("a shape that fits in a part of a grid's step has that part of its prior") {
  const Problem problem = problem_with_lag();
  const Design design(problem, test::below_20_hz());
  Model model = model_of(design);
  for (const double size : {30.0, 100.0}) {
    CAPTURE(size);
    Weights weights = even_weights(design);
    for (VectorXd& weight : weights) weight *= size;
    refine(design, weights, model);
    const double share = log_share_of_step({design, weights, model}, model.terms.size() - 1);
    CHECK(share < -0.5);
    CHECK(share == Approx(log_integral(design, weights, model)).margin(0.1));
  }
}

TEST_CASE("a shape that the logs leave open has all of its prior") {
  const Problem problem = problem_with_lag();
  const Design design(problem, test::below_20_hz());
  Model model = model_of(design);
  Weights weights = even_weights(design);
  for (VectorXd& weight : weights) weight *= 1e-3;
  CHECK(log_share_of_step({design, weights, model}, model.terms.size() - 1) == 0.0);
}
