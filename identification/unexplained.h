// SPDX-License-Identifier: GPL-3.0-or-later
// "None of the known causes": structure that a flexible family explains and no named cause does.
#pragma once

#include <string>
#include <vector>

#include "identification/select.h"
#include "identification/verdict.h"

namespace sinew::diagnosis {

/// Ranges the splines are spread over, for one axis.
struct FlexibleRanges {
  double low = 0.0, high = 1.0;  ///< of the position
  double speed = 1.0;            ///< largest |velocity|
  double load = 0.0;             ///< largest |load|; 0: no load channel
  double duration = 60.0;        ///< s
};

/// Cubic B-splines in position, position x direction, velocity, time, time x direction, load and
/// load x direction, and a sine of any period in position, of one axis (column of the recording's
/// matrices), acting on one channel.
std::vector<Candidate> flexible_families(const FlexibleRanges& ranges, int axis = 0,
                                         int channel = 0);

/// Cubic B-spline basis with `count` functions on [low, high]; constant continuation outside.
Eigen::MatrixXd spline_basis(const Eigen::VectorXd& x, double low, double high, int count);

/// Looks for structure in what the selection leaves over, takes back names that only stood in for
/// it, and says what it depends on.
Unexplained find_unexplained(const Design& design, const Library& library, const Settings& settings,
                             Selection& selection);

/// A line in the residual's spectrum over time: frequency and family-wise probability.
struct SpectralLine {
  double frequency_hz = 0.0;
  double p_value = 1.0;
  double share = 0.0;  ///< of its segment's residual energy
};
SpectralLine strongest_line(const Design& design, const Model& model);

}  // namespace sinew::diagnosis
