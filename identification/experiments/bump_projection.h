// SPDX-License-Identifier: GPL-3.0-or-later
// Equations of motion without differentiating a noisy signal: both sides are multiplied by smooth
// bumps that vanish at their ends, and derivatives go over to the bump by parts.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace sinew {

/// An estimate with the limits of its 95 % confidence interval.
struct Estimate {
  double value = 0.0;
  double standard_error = 0.0;
  double low = 0.0;
  double high = 0.0;
  bool covers(double truth) const { return low <= truth && truth <= high; }
};

/// Interval of an estimate with `freedom` degrees of freedom (Student).
Estimate estimate(double value, double standard_error, long freedom);

/// Projections on bumps of `width` samples side by side without overlap, so that white noise on a
/// signal gives independent errors.
class BumpProjection {
 public:
  /// An even width becomes the next odd one. Throws std::invalid_argument unless width >= 5 and
  /// period > 0.
  BumpProjection(long width, double period);

  long width() const { return width_; }
  /// Rms of a projection of unit white noise over the projection of a constant 1.
  double noise_gain() const { return weight_[0].matrix().norm() / weight_[0].sum(); }
  /// Projection of the signal, or of its first or second derivative, from sample `first` on.
  double of(const Eigen::ArrayXd& signal, long first, int derivative = 0) const;
  /// The same for every bump that fits.
  Eigen::VectorXd all(const Eigen::ArrayXd& signal, int derivative = 0) const;

 private:
  long width_;
  Eigen::ArrayXd weight_[3];
};

/// Least squares with standard errors from the residuals. Columns that others explain are seen by
/// their estimates' size; `identifiable` is false where the columns are dependent to 1e-8.
struct Regression {
  Eigen::VectorXd values, standard_errors;
  Eigen::MatrixXd covariance;  ///< empty where not identifiable
  double residual = 0.0;       ///< rms
  long freedom = 0;
  bool identifiable = false;
  Estimate estimate_of(Eigen::Index k) const {
    return estimate(values(k), standard_errors(k), freedom);
  }
};
Regression regress(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target);

}  // namespace sinew
