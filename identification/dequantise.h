// SPDX-License-Identifier: GPL-3.0-or-later
// What a coarse sensor saw, as far as the instants tell at which its reading changes.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Step of a signal that is held between changes, but for a little noise: the median change. 0
/// where it is not held.
double held_step(const Eigen::VectorXd& signal);

/// Straight lines between the middles of the changes; the signal itself before the first and after
/// the last.
Eigen::VectorXd dequantised(const Eigen::VectorXd& signal);

}  // namespace sinew::diagnosis
