// SPDX-License-Identifier: GPL-3.0-or-later
// The Bayes factor of an entry against integrals done by brute force.
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "identification/likelihood/bayes_factor.h"
#include "identification/likelihood/decision_constants.h"

namespace {

using namespace sinew::diagnosis;

constexpr double infinite = std::numeric_limits<double>::infinity();

ConditionalMoments one_column(double gram, double target, double low, double high) {
  ConditionalMoments m;
  m.gram = Eigen::MatrixXd::Constant(1, 1, gram);
  m.target = Eigen::VectorXd::Constant(1, target);
  m.low = Eigen::VectorXd::Constant(1, low);
  m.high = Eigen::VectorXd::Constant(1, high);
  return m;
}

/// Log of the likelihood ratio's mean over a normal prior cut off at the limits.
double integrated(double gram, double target, double low, double high, double deviation) {
  double sum = 0.0, prior = 0.0;
  constexpr int steps = 200000;
  const double reach = 10.0 * deviation;
  for (int i = 0; i < steps; ++i) {
    const double b = -reach + 2.0 * reach * (i + 0.5) / steps;
    if (b < low || b > high) continue;
    const double density = std::exp(-0.5 * b * b / (deviation * deviation));
    prior += density;
    sum += density * std::exp(b * target - 0.5 * b * b * gram);
  }
  return std::log(sum / prior);
}

/// Over the sizes that a cause may have.
double averaged(double gram, double target, double low, double high) {
  constexpr int sizes = 8;
  double mean = 0.0;
  for (int i = 0; i < sizes; ++i)
    mean += std::exp(integrated(
                gram, target, low, high,
                kSmallestSize * std::pow(kLargestSize / kSmallestSize, i / (sizes - 1.0)))) /
            sizes;
  return std::log(mean);
}

}  // namespace

// Seen red with the determinant left out, and with a mean of 0 where limits are looked at.
TEST_CASE("a Bayes factor is the mean likelihood over the prior") {
  for (const double target : {0.0, 15.0, -40.0}) {
    CHECK(bayes_factor_of(one_column(400.0, target, -infinite, infinite)).logarithm ==
          Approx(averaged(400.0, target, -infinite, infinite)).margin(2e-3));
    CHECK(bayes_factor_of(one_column(400.0, target, 0.0, infinite)).logarithm ==
          Approx(averaged(400.0, target, 0.0, infinite)).margin(2e-3));
  }
}

TEST_CASE("two columns that do not touch each other are worth the sum of both") {
  ConditionalMoments both;
  both.gram = Eigen::Vector2d(400.0, 400.0).asDiagonal();
  both.target = Eigen::Vector2d(40.0, 40.0);
  both.low = Eigen::Vector2d::Constant(-infinite);
  both.high = Eigen::Vector2d::Constant(infinite);
  const BayesFactor pair = bayes_factor_of(both);
  const BayesFactor single = bayes_factor_of(one_column(400.0, 40.0, -infinite, infinite));
  // The size is common to both, so that the sizes' mean is taken once.
  CHECK(pair.logarithm < 2.0 * single.logarithm + std::log(8.0));
  CHECK(pair.logarithm > 2.0 * single.logarithm);
}

TEST_CASE("a normal's probability is exact far into its tails") {
  CHECK(log_probability_between(-1.0, 1.0, 0.0, 1.0) == Approx(std::log(0.682689492137)));
  CHECK(log_probability_between(0.0, infinite, -30.0, 1.0) ==
        Approx(-0.5 * 900.0 - std::log(30.0 * std::sqrt(2.0 * 3.14159265358979))).epsilon(1e-3));
  CHECK(log_probability_between(-infinite, infinite, 5.0, 1.0) == Approx(0.0).margin(1e-12));
}

// Seen red with a half of it.
TEST_CASE("a Bayes factor is no more than the best fit's, whatever the limits") {
  for (const double target : {0.0, 3.0, 15.0, -40.0, 4000.0})
    for (const auto& [low, high] :
         {std::pair{-infinite, infinite}, {0.0, infinite}, {-0.02, 0.3}, {0.01, 0.05}}) {
      const ConditionalMoments m = one_column(10000.0, target, low, high);
      CHECK(bayes_factor_of(m).logarithm <= most_by_fit(m) + 1e-9);
    }
  ConditionalMoments two;
  two.gram = (Eigen::Matrix2d() << 400.0, 390.0, 390.0, 500.0).finished();
  two.target = Eigen::Vector2d(150.0, -200.0);
  two.low = Eigen::Vector2d(0.0, -infinite);
  two.high = Eigen::Vector2d(infinite, infinite);
  CHECK(bayes_factor_of(two).logarithm <= most_by_fit(two));
  CHECK(most_by_fit(two) == Approx(0.5 * two.target.dot(two.gram.inverse() * two.target)));
}
