// SPDX-License-Identifier: GPL-3.0-or-later
// What held-out logs say of a name, by the likelihood of their whitened errors.
#include <catch2/catch.hpp>
#include <random>

#include "identification/regression/baseline.h"
#include "identification/regression/cross_validation.h"
#include "tests/identification/diagnosis/two_joints.h"

using namespace sinew::diagnosis;
namespace test = sinew::test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr Index kRows = 1200;

/// Share of draws that call the second of two models sure. Each says its part of an effect of so
/// many times the noise in a twentieth of the rows; `noise`: of which whitening knows 1.
double share_of_sure(double first, double second, double noise) {
  constexpr int draws = 2000;
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, noise);
  int sure = 0;
  for (int i = 0; i < draws; ++i) {
    VectorXd e(kRows);
    for (double& value : e) value = normal(random);
    VectorXd before = e, after = e;
    before.segment(200, kRows / 20).array() += first;
    after.segment(200, kRows / 20).array() += second;
    sure += is_sure(likelihood_gain({before}, {after})) ? 1 : 0;
  }
  return static_cast<double>(sure) / draws;
}

}  // namespace

// Seen red with half the standard error, and with the noise taken for 1 whatever it is.
TEST_CASE("of two models as far from the truth one is called sure by chance alone") {
  const double noise = GENERATE(1.0, 3.0);
  CHECK(share_of_sure(0.6, -0.6, noise) == Approx(0.055).margin(0.015));
}

TEST_CASE("an effect in a short part of the held-out log is sure") {
  CHECK(share_of_sure(0.6, 0.0, 1.0) > 0.6);
  CHECK(share_of_sure(1.0, 0.0, 1.0) > 0.97);
  CHECK(share_of_sure(0.0, 1.0, 1.0) < 0.001);
}

// Seen red with errors of the nuisances left in.
TEST_CASE("held-out errors, row by row, are those whose squares are counted by block") {
  Problem problem;
  problem.channels = 1;
  Recording log = test::two_joint_motion();
  std::srand(5);
  log.target.push_back(VectorXd(2.0 * log.qd.col(0) + 0.1 * VectorXd::Random(log.q.rows())));
  Recording later = log;
  later.target.front().array() += 0.7;
  problem.training.push_back(std::move(log));
  problem.holdout.push_back(std::move(later));
  Candidate damping;
  damping.name = "damping";
  damping.linear = {{"viscous", "", -1e9, 1e9, false, {}}, {"offset", "", -1e9, 1e9, true, {}}};
  damping.columns = [](const Recording& r, int, const VectorXd&) {
    Eigen::MatrixXd x(r.q.rows(), 2);
    x << r.qd.col(0), VectorXd::Ones(r.q.rows());
    return x;
  };
  problem.baseline = {damping};
  const Design design(problem, test::below_20_hz());
  const Model model = baseline_model(design);
  const LinearFit fit = solve(stack(model, even_weights(design)));
  Weights whitening;
  for (const Segment& s : design.segments())
    whitening.push_back(s.holdout ? VectorXd(VectorXd::Ones(2 * s.bins)) : VectorXd());
  constexpr int blocks = 6;
  double squares = 0.0;
  for (const VectorXd& e : held_out_errors(design, model, fit, blocks, whitening))
    squares += e.squaredNorm();
  const double counted = held_out(design, model, fit, blocks).plain.sum();
  CHECK(squares == Approx(counted).epsilon(1e-6));
}
