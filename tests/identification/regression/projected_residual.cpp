// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/projected_residual.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "identification/regression/refine.h"

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Candidate term(std::vector<int> channels, bool shaped, ColumnFunction columns) {
  Candidate c;
  c.channels = std::move(channels);
  c.linear.resize(1);
  if (shaped) c.nonlinear = {{"speed", "rad/s", 0.01, 10.0, 5, true}};
  c.columns = std::move(columns);
  return c;
}

/// Friction that sets in within a speed.
ColumnFunction friction(int axis) {
  return [axis](const Recording& log, int, const VectorXd& p) {
    return MatrixXd((log.qd.col(axis).array() / p(0)).tanh().matrix());
  };
}

/// Two joints, 8 s each: both feel an inertia that they share and an offset.
Problem two_joints() {
  Problem problem;
  problem.channels = 2;
  Recording log;
  log.step = 0.002;
  const Index n = 4000;
  log.time = VectorXd::LinSpaced(n, 0.0, log.step * static_cast<double>(n - 1));
  log.q = log.qd = log.qdd = MatrixXd(n, 2);
  for (Index k = 0; k < n; ++k)
    for (Index c = 0; c < 2; ++c) {
      const double w = 3.0 + 2.0 * static_cast<double>(c), t = log.time(k);
      log.q(k, c) = std::sin(w * t) + 0.1 * std::sin(7.3 * w * t);
      log.qd(k, c) = w * std::cos(w * t) + 0.73 * w * std::cos(7.3 * w * t);
      log.qdd(k, c) = -w * w * std::sin(w * t) - 5.329 * w * w * std::sin(7.3 * w * t);
    }
  for (Index c = 0; c < 2; ++c)
    log.target.push_back((log.qd.col(c).array() / 0.7).tanh().matrix() + 0.02 * log.qdd.col(c) +
                         0.3 * log.q.col(c).array().cube().matrix());
  problem.training = {log};
  problem.library = {
      term({0}, true, friction(0)), term({1}, true, friction(1)),
      term({}, false,
           [](const Recording& r, int channel, const VectorXd&) {
             return MatrixXd(r.qdd.col(channel));
           }),
      term({0}, false,
           [](const Recording& r, int, const VectorXd&) {
             return MatrixXd(MatrixXd::Ones(r.q.rows(), 1));
           }),
      // Says what another term says: no basis may depend on its columns being independent.
      term({0}, false, [](const Recording& r, int, const VectorXd&) {
        return MatrixXd(2.0 * MatrixXd::Ones(r.q.rows(), 1));
      })};
  return problem;
}

}  // namespace

TEST_CASE("condensed rows leave over what all rows do") {
  // Planted defects, each seen to fail: moving columns not taken apart along the basis (norms), the
  // target left whole across it (norms), the columns of another point remembered (products), what
  // the columns that stay say of those that move not taken off these (all of them).
  const Problem problem = two_joints();
  const Design design(problem, Settings());
  Model model;
  model.advance.assign(design.segments().size(), 0.0);
  for (std::size_t s = 0; s < design.segments().size(); ++s)
    model.target.push_back(design.target(static_cast<int>(s)));
  for (const Candidate& c : problem.library)
    model.terms.push_back(make_term(
        design, c, c.nonlinear.empty() ? VectorXd() : VectorXd(VectorXd::Constant(1, 0.5)), false));
  Weights weights = even_weights(design);
  for (VectorXd& w : weights) w = VectorXd::LinSpaced(w.size(), 2.0, 0.5);
  const std::vector<std::vector<bool>> moving{{true, false, false, false, false},
                                              {true, true, false, false, false}};
  for (const std::vector<bool>& terms : moving) {
    ProjectedResidual condensed(design, weights, model, terms);
    CHECK(condensed.rows() < stack(model, weights).y.size() + 20);
    std::vector<VectorXd> few, all;
    // Back and forth, farther than what is remembered.
    for (const double p : {0.5, 0.6, 0.4, 0.5, 0.9, 1.5, 3.0, 0.5, 0.6}) {
      Model moved = model;
      std::vector<VectorXd> nonlinear;
      for (std::size_t t = 0; t < terms.size(); ++t) {
        Term& own = moved.terms[t];
        if (terms[t]) own = make_term(design, *own.candidate, VectorXd::Constant(1, p), false);
        nonlinear.push_back(own.nonlinear);
      }
      few.push_back(condensed(nonlinear));
      all.push_back(solve(stack(moved, weights)).residual);
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < all.size(); ++k)
        CHECK(few[i].dot(few[k]) == Approx(all[i].dot(all[k])).epsilon(1e-9));
  }
}
