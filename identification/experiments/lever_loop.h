// SPDX-License-Identifier: GPL-3.0-or-later
// The hysteresis of a lever's calibration, taken apart from what the polynomials are fitted to
// (4.1).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sinew {

/// State of a loop in [-1, 1]: +1 after loading, -1 after unloading; after a reversal it turns over
/// `length` of travel (Dahl's law). `u`: travel; steps back and forth by less than `step` are the
/// sensor's and count as none. `starts`: first sample of each recording, where it is unknown, 0.
Eigen::ArrayXd loop_state(const Eigen::ArrayXd& u, const std::vector<Eigen::Index>& starts,
                          double step, double length);

/// The force without its loop: what follows the loop's state, as wide as a polynomial of the
/// travel, is fitted along and taken off. The length is the one that explains most. `highest`:
/// degree of the force beside it.
struct MiddleOfLoop {
  Eigen::ArrayXd force;
  double length = 0.0;  ///< travel
};
MiddleOfLoop middle_of_loop(const Eigen::ArrayXd& u, const Eigen::ArrayXd& force,
                            const std::vector<Eigen::Index>& starts, double step, int highest);

}  // namespace sinew
