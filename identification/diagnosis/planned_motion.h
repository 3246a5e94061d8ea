// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that a drive could be asked for next, within what its logs have already shown it can do.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace sinew::diagnosis {

/// What the logs cover at one joint. rad or m; a load is an effort.
struct MotionRange {
  double low = 0.0, high = 1.0;
  double speed = 1.0;         ///< largest, without sign
  double acceleration = 1.0;  ///< the same
  double load = 0.0;          ///< largest known load, with its sign; 0: none is known
};

/// A reference to be played, and the known load that belongs to it.
struct PlannedMotion {
  std::string name;          ///< "constant speeds from slow to fast, both ways"
  double step = 0.0;         ///< s
  Eigen::MatrixXd position;  ///< samples x joints, rad or m
  Eigen::VectorXd load;      ///< empty: no load is known
};

/// Motions of one joint, the others resting in the middle of their ranges, and where there are
/// others one of all joints together. None is faster or wider than what the ranges say.
std::vector<PlannedMotion> planned_motions(const std::vector<MotionRange>& joints,
                                           std::size_t joint, double step);

}  // namespace sinew::diagnosis
