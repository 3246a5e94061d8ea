// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/signal_relations.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace sinew {

using Eigen::ArrayXd;

double rms(const ArrayXd& x) {
  return x.size() == 0 ? 0.0 : std::sqrt(x.square().mean());
}

ArrayXd centred(const ArrayXd& x) {
  return x - x.mean();
}

double correlation(const ArrayXd& a, const ArrayXd& b) {
  const ArrayXd ca = centred(a), cb = centred(b);
  const double scale = std::sqrt(ca.square().sum() * cb.square().sum());
  return scale > 0.0 ? (ca * cb).sum() / scale : 0.0;
}

double slope(const ArrayXd& y, const ArrayXd& x) {
  const ArrayXd cx = centred(x);
  const double power = cx.square().sum();
  return power > 0.0 ? (centred(y) * cx).sum() / power : 0.0;
}

ArrayXd moving_mean(const ArrayXd& x, long m) {
  const long n = x.size() - 2 * m;
  ArrayXd y(n);
  double sum = x.head(2 * m + 1).sum();
  const double scale = 1.0 / static_cast<double>(2 * m + 1);
  y(0) = sum * scale;
  for (long k = 1; k < n; ++k) {
    sum += x(k + 2 * m) - x(k - 1);
    y(k) = sum * scale;
  }
  return y;
}

long smoothing(double noise, const ArrayXd& x, double dt) {
  long m = 1;
  while (m < x.size() / 40) {
    const auto h = static_cast<double>(m) * dt;
    const long n = x.size() - 2 * m;
    const ArrayXd second = x.tail(n) - 2.0 * x.segment(m, n) + x.head(n);
    const double acceleration_noise = noise * std::sqrt(6.0) / (h * h);
    if (rms(second) / (h * h) > 8.0 * acceleration_noise && h > 2.0 * dt) break;
    m *= 2;
  }
  return m;
}

EffortFit fit_effort(const DriveMotion& m, bool turns) {
  const long n = m.effort.size();
  const double v_scale = std::max(0.1 * rms(m.velocity), 1.0e-300);
  Eigen::MatrixXd A(n, turns ? 7 : 5);
  A.col(0) = m.acceleration.matrix();
  A.col(1) = m.velocity.matrix();
  A.col(2) = (m.velocity / v_scale).tanh().matrix();
  A.col(3).setOnes();
  A.col(4) = m.position.matrix();
  if (turns) {
    A.col(5) = m.position.sin().matrix();
    A.col(6) = m.position.cos().matrix();
  }
  Eigen::VectorXd scale = A.colwise().norm();
  for (long j = 0; j < A.cols(); ++j) A.col(j) /= std::max(scale(j), 1.0e-300);
  const Eigen::MatrixXd normal =
      A.transpose() * A + 1.0e-10 * Eigen::MatrixXd::Identity(A.cols(), A.cols());
  const Eigen::MatrixXd inverse = normal.inverse();
  const Eigen::VectorXd x = inverse * (A.transpose() * m.effort.matrix());
  const ArrayXd left = m.effort - (A * x).array();
  const double total = centred(m.effort).square().sum();
  EffortFit result;
  result.explained = total > 0.0 ? 1.0 - left.square().sum() / total : 0.0;
  result.inertia = x(0) / scale(0);
  // Residuals are coloured: as if only every 20th point were new.
  const double variance = left.square().sum() / static_cast<double>(n) * 20.0;
  result.inertia_error = std::sqrt(variance * inverse(0, 0)) / scale(0);
  const ArrayXd direction = (m.velocity / v_scale).tanh();
  result.friction = slope(m.effort, direction);
  result.friction_share = correlation(m.effort, direction);
  return result;
}

}  // namespace sinew
