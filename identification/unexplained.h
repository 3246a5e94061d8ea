// SPDX-License-Identifier: GPL-3.0-or-later
// "None of the known causes": structure that a flexible family explains and no named cause does.
#pragma once

#include <string>
#include <vector>

#include "identification/select.h"

namespace sinew {

/// Ranges the splines are spread over, for one axis.
struct FlexibleRanges {
  double low = 0.0, high = 1.0;  ///< of the position
  double speed = 1.0;            ///< largest |velocity|
  double load = 0.0;             ///< largest |load|; 0: no load channel
  double duration = 60.0;        ///< s
};

/// Cubic B-splines in position, position x direction, velocity, time, time x direction, load and
/// load x direction of one axis (column of the recording's matrices), acting on one channel.
std::vector<Candidate> flexible_families(const FlexibleRanges& ranges, int axis = 0,
                                         int channel = 0);

/// Cubic B-spline basis with `count` functions on [low, high]; constant continuation outside.
Eigen::MatrixXd spline_basis(const Eigen::VectorXd& x, double low, double high, int count);

}  // namespace sinew
