// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "identification/experiments/bump_projection.h"
#include "identification/experiments/drive_stretch.h"

namespace sinew {

/// A sine and a cosine at an order of the output or the input shaft.
struct RippleOrder {
  bool input = false;
  double order = 1.0;  ///< periods per turn of its own shaft
  double per_output_radian(double gear_ratio) const { return input ? order / gear_ratio : order; }
};

/// tau = B theta'' + c1 atan(gamma1 w) + c2 w + ripples, projected: columns theta'', atan, w, then
/// sine and cosine of each order. Stretches one below the other.
struct DriveRegression {
  Eigen::MatrixXd columns;
  Eigen::VectorXd torque;
  std::vector<Eigen::Index> rows;      ///< of each stretch
  double noise = 0.0;                  ///< N·m, rms that the torque's white noise alone leaves
  double torque_per_projection = 1.0;  ///< a constant torque of 1 N·m gives this
};
DriveRegression project_drive(const std::vector<DriveStretch>& stretches, double gamma1,
                              double gear_ratio, const std::vector<RippleOrder>& ripples,
                              double width);

}  // namespace sinew
