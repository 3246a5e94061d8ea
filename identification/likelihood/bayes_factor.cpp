// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/bayes_factor.h"

#include <Eigen/Cholesky>
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
double limits_factor(double low, double high, double mean, double spread, double prior) {
  if (!is_limited(low, high)) return 0.0;
  return log_probability_between(low, high, mean, spread) -
         log_probability_between(low, high, 0.0, prior);
}

/// Everything on the axes of the Gram matrix. `Size`: number of columns where it is known
/// beforehand: most entries have one or two, and small matrices of fixed size need no heap.
template <int Size>
BayesFactor average_over_sizes(const ConditionalMoments& m) {
  using Vector = Eigen::Matrix<double, Size, 1>;
  using Matrix = Eigen::Matrix<double, Size, Size>;
  static const std::vector<double> sizes = variances();
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(Matrix(m.gram));
  const Vector d = eigen.eigenvalues().cwiseMax(0.0);
  const Matrix axes = eigen.eigenvectors();
  const Vector u = axes.transpose() * Vector(m.target);
  BayesFactor best{-kInfinity, 0.0};
  Eigen::Matrix<double, kSizes, 1> all;
  for (int k = 0; k < kSizes; ++k) {
    const double v = sizes[static_cast<std::size_t>(k)];
    const Vector shrunk = (v / (1.0 + v * d.array())).matrix();
    all(k) = 0.5 * u.cwiseAbs2().dot(shrunk) - 0.5 * (1.0 + v * d.array()).log().sum();
    for (Index i = 0; i < m.low.size(); ++i)
      all(k) += limits_factor(m.low(i), m.high(i), axes.row(i) * shrunk.cwiseProduct(u),
                              std::sqrt(axes.row(i).cwiseAbs2() * shrunk), std::sqrt(v));
    if (all(k) > best.logarithm) best = {all(k), v};
  }
  best.logarithm += std::log((all.array() - best.logarithm).exp().mean());
  return best;
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

double most_by_fit(const ConditionalMoments& m) {
  bool limited = false;
  for (Index i = 0; i < m.low.size(); ++i) limited = limited || is_limited(m.low(i), m.high(i));
  // Between limits a prior may be as narrow as they are.
  const double least = limited ? 0.0 : 1.0 / (kLargestSize * kLargestSize);
  if (m.target.size() == 1) return 0.5 * m.target(0) * m.target(0) / (m.gram(0, 0) + least);
  if (m.target.size() > 2) {
    if (limited) return kInfinity;
    const MatrixXd gram = m.gram + least * MatrixXd::Identity(m.gram.rows(), m.gram.cols());
    return 0.5 * Eigen::LLT<MatrixXd>(gram).matrixL().solve(m.target).squaredNorm();
  }
  const double a = m.gram(0, 0) + least, b = m.gram(0, 1), c = m.gram(1, 1) + least;
  const double x = m.target(0), y = m.target(1), determinant = a * c - b * b;
  constexpr double regular = 1e-9;
  return determinant > regular * a * c
             ? 0.5 * (c * x * x - 2.0 * b * x * y + a * y * y) / determinant
             : kInfinity;
}

BayesFactor bayes_factor_of(const ConditionalMoments& m) {
  switch (m.target.size()) {
    case 1:
      return average_over_sizes<1>(m);
    case 2:
      return average_over_sizes<2>(m);
    default:
      return average_over_sizes<Eigen::Dynamic>(m);
  }
}

}  // namespace sinew::diagnosis
