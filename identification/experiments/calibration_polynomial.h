// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial through calibration data whose degree its validation error chooses.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sinew {

struct CalibrationPolynomial {
  std::vector<double> coefficients;    ///< of the normalised variable, from the constant upwards
  std::vector<double> validation_rms;  ///< of each degree tried, from 1 upwards
  double largest_error = 0.0;          ///< over the data
  double rms = 0.0;

  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  double at(double u) const;
  double slope(double u) const;
};

/// Least squares on u in [-1, 1] of degree 1..`highest`: the lowest degree whose error on blocks
/// left out is within 5 % of the smallest. Throws std::invalid_argument with fewer than
/// 3 (highest + 1) points.
CalibrationPolynomial fit_polynomial(const Eigen::ArrayXd& u, const Eigen::ArrayXd& value,
                                     int highest);

}  // namespace sinew
