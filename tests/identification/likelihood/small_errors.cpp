// SPDX-License-Identifier: GPL-3.0-or-later
// What a law of one make is off by at each of its places, against rows with that noise.
#include "identification/likelihood/small_errors.h"

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <string>

#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/slot_model.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kGuides = 4, kColumns = kGuides + 2;

/// Friction in all guides, in each of them, and something else, one column each.
struct Guides {
  explicit Guides(Index rows) {
    std::srand(5);
    x = MatrixXd::Random(rows, kColumns);
    x.col(0) = x.middleCols(1, kGuides).rowwise().sum();
    for (Index c = 0; c < kColumns; ++c) {
      Candidate& source = sources.emplace_back();
      source.name = c <= kGuides ? "friction" : "offset";
      source.place = std::to_string(c);
      source.linear.resize(1);
    }
    for (Index c = 0; c < kColumns; ++c) {
      Hypothesis h;
      h.candidate = static_cast<int>(c);
      h.source = &sources[static_cast<std::size_t>(c)];
      h.shapes = {static_cast<int>(c)};
      h.log_prior = std::log(kPriorOdds);
      all.list.push_back(h);
      all.shapes.push_back({static_cast<int>(c), {}, {}, {}});
    }
  }

  Moments moments(const VectorXd& y) const {
    Moments m;
    m.gram = RegionProducts(MatrixXd(x.transpose() * x));
    for (Index c = 0; c < x.cols(); ++c) m.of_shape.push_back({c, 1});
    m.coefficient.assign(static_cast<std::size_t>(x.cols()), 0);
    m.scale = VectorXd::Constant(x.cols(), 2.0);
    m.target = x.transpose() * y;
    m.deviance = y.squaredNorm();
    return m;
  }

  MatrixXd x;
  std::vector<Candidate> sources;
  Hypotheses all;
};

std::vector<FoundLaw> in_all_guides(double coefficient) {
  return {{0, VectorXd::Constant(1, coefficient)}};
}

double odds_of_second(const Guides& guides, const VectorXd& y, const std::vector<FoundLaw>& laws) {
  const Moments m = guides.moments(y);
  const SmallErrors errors(m, guides.all, 0.0, laws);
  const SlotModel model(guides.all, errors, std::vector<bool>(kColumns, false));
  const SlotModel::Fit fit = model.fit({{0}, {100.0}, 0.0}, Regions::kEverywhere);
  return model.log_odds(fit, false)[1];
}

}  // namespace

// Seen red with relatives that are not freed of what the law says, and with the law's coefficient
// in the columns' scale taken for one in its own unit.
TEST_CASE("a law of one make is off at each of its places as noise in one coefficient") {
  const Guides guides(40);
  const VectorXd y = VectorXd::Random(40);
  const Moments m = guides.moments(y);
  const SmallErrors errors(m, guides.all, 0.0, in_all_guides(0.6));
  const VectorXd law = 0.3 * guides.x.col(0);
  MatrixXd covariance = MatrixXd::Identity(40, 40);
  for (Index c = 1; c <= kGuides; ++c) {
    const VectorXd own = guides.x.col(c);
    const VectorXd off = kFormError * std::abs(own.dot(law)) / own.squaredNorm() *
                         (own - law * (law.dot(own) / law.squaredNorm()));
    covariance += off * off.transpose();
  }
  const Eigen::LLT<MatrixXd> factor(covariance);
  std::vector<Index> columns(kColumns);
  std::iota(columns.begin(), columns.end(), Index{0});
  const MatrixXd exact = guides.x.transpose() * factor.solve(guides.x);
  CHECK((errors.gram(columns, columns) - exact).cwiseAbs().maxCoeff() < 1e-9 * exact.maxCoeff());
  const VectorXd target = guides.x.transpose() * factor.solve(y);
  CHECK((errors.target() - target).norm() < 1e-9 * target.norm());
  const double log_likelihood = -0.5 * y.dot(VectorXd(factor.solve(y))) -
                                MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  CHECK(errors.log_likelihood() == Approx(log_likelihood).epsilon(1e-9));
  // What all guides share is told as before.
  CHECK(errors.gram({0}, {0})(0, 0) == Approx(guides.x.col(0).squaredNorm()));
}

// Seen red without the law's errors: log odds of 1233 in the long log.
TEST_CASE("one guide a tenth off brings no second name, however long the log") {
  for (const Index rows : {400, 40000}) {
    CAPTURE(rows);
    const Guides guides(rows);
    const double noise = 0.2;
    const VectorXd y = (guides.x.col(0) + 0.1 * guides.x.col(1)) / noise;
    CHECK(odds_of_second(guides, y, in_all_guides(2.0 / noise)) < 0.0);
  }
}

// Seen red with errors of ten times the size.
TEST_CASE("one guide with five times the friction of the others has a name of its own") {
  const Guides guides(40000);
  const VectorXd y = guides.x.col(0) + 4.0 * guides.x.col(1);
  CHECK(odds_of_second(guides, y, in_all_guides(4.0)) > 0.0);
}
