// SPDX-License-Identifier: GPL-3.0-or-later
// Two joints whose torques are made of the same noisy force.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/likelihood/column_sums.h"
#include "identification/likelihood/fitted_baseline.h"
#include "identification/regression/spectrum.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double alike = 0.9;  // correlation of the two joints' noise

Candidate sine(const std::string& name, double hz, int channel) {
  Candidate c;
  c.name = name;
  c.place = channel == 0 ? "first joint" : "second joint";
  c.linear.resize(1);
  c.channels = {channel};
  c.columns = [hz](const Recording& log, int, const VectorXd&) -> MatrixXd {
    return (2.0 * 3.14159265358979 * hz * log.time.array()).sin().matrix();
  };
  return c;
}

/// 40 s of noise alone.
Problem two_joints(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  constexpr Eigen::Index rows = 10000;
  Recording log;
  log.step = 0.004;
  log.time = VectorXd::LinSpaced(rows, 0.0, log.step * (rows - 1));
  log.q = log.qd = log.qdd = MatrixXd::Zero(rows, 2);
  VectorXd first(rows), second(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double own = normal(random);
    first(i) = own;
    second(i) = 3.0 * (alike * own + std::sqrt(1.0 - alike * alike) * normal(random));
  }
  log.target = {first, second};
  Problem problem;
  problem.channels = 2;
  problem.training = {log};
  problem.noise_groups = {0, 0};
  for (const int channel : {0, 1}) {
    problem.baseline.push_back(sine("level", 0.7, channel));
    problem.library.push_back(sine("ripple", 3.1, channel));
  }
  return problem;
}

struct TwoJoints {
  template <class Weighted>
  ColumnSums sums(const Weighted& weights) const {
    return column_sums(design, all, weights);
  }

  Problem problem = two_joints(3);
  Settings settings = [] {
    Settings s;
    s.edge_s = 0.2;
    return s;
  }();
  Design design{problem, settings};
  Hypotheses all = make_hypotheses(design, fitted_baseline(design));
  Whitening whitening = whitening_of(design, all, VectorXd::Zero(2));
};

}  // namespace

// Seen red with channels that are whitened each by itself.
TEST_CASE("what channels share of their noise counts once") {
  const TwoJoints joints;
  const Whitening& whitening = joints.whitening;
  REQUIRE(whitening.shared.size() == 1);
  CHECK(whitening.shared.front().correlation(0, 1) == Approx(alike).margin(0.03));

  const ColumnSums together = joints.sums(whitening);
  const ColumnSums apart = joints.sums(whitening.training);
  CHECK(together.rows == apart.rows);
  // Rows at the ends of a log count for less.
  const double counted = end_taper(joints.design.segments().front().samples).cwiseAbs2().mean();
  CHECK(together.deviance == Approx(counted * together.rows).epsilon(0.05));
  // A cause at one joint: the other one's noise is known there, and so less is left of its own.
  const Eigen::Index ripple = together.free;
  const double known = 1.0 - alike * alike;
  CHECK(together.gram(ripple + 1, ripple + 1) ==
        Approx(apart.gram(ripple + 1, ripple + 1) / known).epsilon(0.15));
  CHECK(together.gram(ripple, ripple) == Approx(apart.gram(ripple, ripple) / known).epsilon(0.15));
}

// Seen red with a share that nobody reads.
TEST_CASE("of rows with other noise besides, only what is shared goes together") {
  const TwoJoints joints;
  Whitening whitening = joints.whitening;
  // All of a row's variance is its own: channels as if each by itself.
  for (const VectorXd& weight : whitening.training)
    whitening.noise_share.push_back(VectorXd::Constant(weight.size(), 1e-6));
  const ColumnSums none = joints.sums(whitening);
  const ColumnSums apart = joints.sums(whitening.training);
  const MatrixXd as_apart = apart.gram.dense();
  CHECK((none.gram.dense() - as_apart).cwiseAbs().maxCoeff() <
        1e-6 * as_apart.cwiseAbs().maxCoeff());
}
