// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/bump_projection.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sinew {

Estimate estimate(double value, double standard_error, long freedom) {
  const double t = freedom < 1 ? std::numeric_limits<double>::infinity()
                               : boost::math::quantile(
                                     boost::math::students_t(static_cast<double>(freedom)), 0.975);
  return {value, standard_error, value - t * standard_error, value + t * standard_error};
}

BumpProjection::BumpProjection(long width, double period) : width_(width | 1) {
  if (width < 5 || !(period > 0.0))
    throw std::invalid_argument("a bump needs five samples and a positive period");
  // (1 - s^2)^4 on [-1, 1]: value and three derivatives vanish at the ends.
  const double scale = 2.0 / (static_cast<double>(width_ - 1) * period);
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(width_, -1.0, 1.0), r = 1.0 - s * s;
  weight_[0] = period * r.pow(4);
  weight_[1] = period * scale * 8.0 * s * r.cube();
  weight_[2] = period * scale * scale * (48.0 * s * s * r * r - 8.0 * r.cube());
  // The sums then obey the parts' rule exactly up to quadratic signals, as the integrals do.
  const Eigen::ArrayXd t = s / scale;
  weight_[1] *= weight_[0].sum() / (weight_[1] * t).sum();
  weight_[2] -= weight_[0] * (weight_[2].sum() / weight_[0].sum());
  weight_[2] *= weight_[0].sum() / (weight_[2] * t * t / 2.0).sum();
}

double BumpProjection::of(const Eigen::ArrayXd& signal, long first, int derivative) const {
  const auto part = signal.segment(first, width_);
  // Only the change matters to a derivative; a large constant would cost digits.
  const double level = derivative == 0 ? 0.0 : part(width_ / 2);
  return ((part - level) * weight_[derivative]).sum();
}

Eigen::VectorXd BumpProjection::all(const Eigen::ArrayXd& signal, int derivative) const {
  const long count = signal.size() < width_ ? 0 : (signal.size() - 1) / (width_ - 1);
  Eigen::VectorXd values(count);
  for (long k = 0; k < count; ++k) values(k) = of(signal, k * (width_ - 1), derivative);
  return values;
}

Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target) {
  Regression result;
  const auto n = columns.cols();
  result.values.setZero(n);
  result.standard_errors.setConstant(n, std::numeric_limits<double>::infinity());
  result.freedom = columns.rows() - n;
  if (result.freedom < 1) return result;
  Eigen::VectorXd scale = columns.colwise().norm();
  for (double& each : scale)
    if (each == 0.0) return result;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns * scale.cwiseInverse().asDiagonal());
  qr.setThreshold(1e-8);
  result.identifiable = qr.rank() == n;
  const Eigen::VectorXd scaled = qr.solve(target);
  result.values = scaled.cwiseQuotient(scale);
  const double squares = (columns * result.values - target).squaredNorm();
  result.residual = std::sqrt(squares / static_cast<double>(columns.rows()));
  if (!result.identifiable) return result;
  const Eigen::MatrixXd unit = columns * scale.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd covariance =
      (unit.transpose() * unit).ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const double variance = squares / static_cast<double>(result.freedom);
  result.covariance =
      variance * scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
  result.standard_errors = result.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  return result;
}

}  // namespace sinew
