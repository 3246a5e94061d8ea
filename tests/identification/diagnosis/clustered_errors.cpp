// SPDX-License-Identifier: GPL-3.0-or-later
// Standard errors of noise that comes with the motion, and of causes whose form is not sure.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "identification/diagnosis/form_errors.h"
#include "identification/diagnosis/standard_errors.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"
#include "tests/identification/diagnosis/two_joints.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;
using namespace sinew::diagnosis;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Problem moved(const ArrayXd& effort) {
  Problem problem;
  Recording log = test::two_joint_motion();
  log.q = MatrixXd(log.q.col(0));
  log.qd = MatrixXd(log.qd.col(0));
  log.target = {effort};
  problem.training = {std::move(log)};
  return problem;
}

ArrayXd speed() {
  return test::two_joint_motion().qd.col(0);
}

ArrayXd white(Index count, std::uint64_t seed) {
  reference::RandomNumbers random(seed);
  ArrayXd noise(count);
  for (double& value : noise) value = random.uniform(-1.7, 1.7);
  return noise;
}

Candidate of_speed(const std::function<double(double)>& law) {
  Candidate c;
  c.name = "friction";
  c.channels = {0};
  c.linear.resize(1);
  c.linear.front().name = "level";
  c.columns = [law](const Recording& log, int, const VectorXd&) -> MatrixXd {
    return log.qd.col(0).unaryExpr(law);
  };
  return c;
}

Model fitted(const Design& design, const Candidate& cause, const VectorXd& nonlinear) {
  Model model = baseline_model(design);
  model.terms.push_back(make_term(design, cause, nonlinear, false));
  return model;
}

ParameterEstimate estimate_of(const ArrayXd& effort, const Candidate& cause) {
  const Problem problem = moved(effort);
  const Settings settings = test::below_20_hz();
  const Design design(problem, settings);
  const Model model = fitted(design, cause, {});
  return told_estimates(design, model, own_noise(design, model)).front().front();
}

}  // namespace

TEST_CASE("noise that comes with the motion is in the standard error") {
  // Planted defect, seen to fail: the spectrum's covariance alone. It takes noise for as large at
  // rest as in the fast strokes that tell the coefficient: half of what the estimates scatter.
  const Candidate viscous = of_speed([](double v) { return v; });
  const ArrayXd v = speed();
  constexpr int kLogs = 40;
  double scatter = 0.0, told = 0.0;
  for (int k = 0; k < kLogs; ++k) {
    const ArrayXd noise = white(v.size(), 100 + static_cast<std::uint64_t>(k));
    const ParameterEstimate e = estimate_of(0.5 * v + 0.1 * v.abs().pow(3) * noise, viscous);
    scatter += std::pow(e.value - 0.5, 2);
    told += std::pow(e.standard_error, 2);
  }
  const double ratio = std::sqrt(told / scatter);
  CHECK(ratio > 0.85);
  CHECK(ratio < 1.5);
}

TEST_CASE("two numbers for one size are as far off as they are apart") {
  // Planted defect, seen to fail: the standard error of one of them, which was a sixteenth of the
  // error at a sealed drive with a play in its sensor.
  Candidate play = of_speed([](double v) { return v; });
  play.nonlinear = {{"play_of_motion", "rad", 0.1, 2.0, 4, true}};
  play.sized_twice = true;
  const Problem problem = moved(0.5 * speed() + 0.05 * white(speed().size(), 8));
  const Design design(problem, test::below_20_hz());
  const Model model = fitted(design, play, VectorXd::Constant(1, 0.8));
  const auto told = told_estimates(design, model, own_noise(design, model)).front();
  REQUIRE(told.size() == 2);
  CHECK(told[0].value == Approx(0.5).epsilon(0.01));
  CHECK(told[0].standard_error == Approx(0.3 / std::sqrt(2.0)).epsilon(0.02));
  // Planted defect, seen to fail: nothing beside the logs, which say nothing here; a drive's gap
  // was told as (0.0 ± 3.0)×10⁸ rad. Any value of its range is as likely.
  const double of_range = 0.8 * std::log(20.0) / std::sqrt(12.0);
  CHECK(told[1].standard_error == Approx(std::hypot(of_range, 0.3 / std::sqrt(2.0))).epsilon(0.02));
}
