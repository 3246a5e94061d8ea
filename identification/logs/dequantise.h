// SPDX-License-Identifier: GPL-3.0-or-later
// What a coarse or a loose sensor hides of the motion, as far as the instants tell at which its
// reading changes.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Step of a signal that is held between changes, but for a little noise: the median change. 0
/// where it is not held.
double held_step(const Eigen::VectorXd& signal);

/// The lattice on which nearly all readings of a sensor lie, whether or not they were rounded again
/// to a finer grid.
struct SensorSteps {
  double step = 0.0;     ///< 0: there is none
  double scatter = 0.0;  ///< rms distance of the readings from it
};
SensorSteps sensor_steps(const Eigen::VectorXd& reading);

/// Straight lines between the middles of the changes; the signal itself before the first, after the
/// last, and where it is held so long that the motion rests, which may be anywhere within the step.
Eigen::VectorXd dequantised(const Eigen::VectorXd& signal);

/// Which end of its play a sensor is at, -1..1: the direction of the reading's motion, and on its
/// way from one end to the other while the reading stands still (changes by no more than `quantum`
/// a sample; without steps: moves no faster than `still`).
Eigen::VectorXd side_of_play(const Eigen::VectorXd& reading, const Eigen::VectorXd& velocity,
                             double quantum, double still);

}  // namespace sinew::diagnosis
