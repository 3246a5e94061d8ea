// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/bayes_factor.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// More change nothing: from one size to the next a factor of two.
constexpr int kSizes = 8;

std::vector<double> variances() {
  std::vector<double> list;
  for (int i = 0; i < kSizes; ++i)
    list.push_back(
        std::pow(kSmallestSize * std::pow(kLargestSize / kSmallestSize, i / (kSizes - 1.0)), 2.0));
  return list;
}

/// log P(x > a) of a standard normal x.
double log_upper_tail(double a) {
  if (a < 25.0) return std::log(std::max(0.5 * std::erfc(a / std::sqrt(2.0)), 1e-300));
  return -0.5 * a * a - std::log(a * std::sqrt(2.0 * 3.14159265358979323846));
}

bool is_limited(double low, double high) {
  return low > -kInfinity || high < kInfinity;
}

/// What the limits change: probability between them after the data over that before.
double limits_factor(const ConditionalMoments& m, const MatrixXd& axes, const VectorXd& shrunk,
                     const VectorXd& rotated, double variance) {
  double sum = 0.0;
  for (Index i = 0; i < m.low.size(); ++i) {
    if (!is_limited(m.low(i), m.high(i))) continue;
    const double mean = axes.row(i).dot(shrunk.cwiseProduct(rotated));
    const double spread = std::sqrt(axes.row(i).cwiseAbs2().dot(shrunk));
    sum += log_probability_between(m.low(i), m.high(i), mean, spread) -
           log_probability_between(m.low(i), m.high(i), 0.0, std::sqrt(variance));
  }
  return sum;
}

}  // namespace

double log_probability_between(double low, double high, double mean, double deviation) {
  double a = (low - mean) / deviation, b = (high - mean) / deviation;
  if (a < 0.0 && b <= 0.0) {
    std::swap(a, b);
    a = -a;
    b = -b;
  }
  if (a < 0.0)  // the mean lies between them
    return std::log1p(-std::min(
        1.0 - 1e-16, 0.5 * std::erfc(-a / std::sqrt(2.0)) + 0.5 * std::erfc(b / std::sqrt(2.0))));
  const double near = log_upper_tail(a);
  if (b == kInfinity) return near;
  const double ratio = std::exp(log_upper_tail(b) - near);
  return near + std::log(std::max(1.0 - ratio, 1e-300));
}

BayesFactor bayes_factor_of(const ConditionalMoments& m) {
  static const std::vector<double> sizes = variances();
  VectorXd d;
  MatrixXd axes;
  if (m.target.size() == 1) {
    d = m.gram.diagonal();
    axes = MatrixXd::Ones(1, 1);
  } else {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(m.gram);
    d = eigen.eigenvalues();
    axes = eigen.eigenvectors();
  }
  d = d.cwiseMax(0.0);
  const VectorXd u = axes.transpose() * m.target;
  BayesFactor best{-kInfinity, 0.0};
  VectorXd all(kSizes);
  for (int i = 0; i < kSizes; ++i) {
    const double v = sizes[static_cast<std::size_t>(i)];
    const VectorXd shrunk = (v / (1.0 + v * d.array())).matrix();
    const double gained = 0.5 * u.cwiseAbs2().dot(shrunk) -
                          0.5 * (1.0 + v * d.array()).log().sum() +
                          limits_factor(m, axes, shrunk, u, v);
    all(i) = gained;
    if (gained > best.logarithm) best = {gained, v};
  }
  best.logarithm += std::log((all.array() - best.logarithm).exp().mean());
  return best;
}

}  // namespace sinew::diagnosis
