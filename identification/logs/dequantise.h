// SPDX-License-Identifier: GPL-3.0-or-later
// What a coarse or a loose sensor hides of the motion, as far as the instants tell at which its
// reading changes.
#pragma once

#include <Eigen/Core>

#include "identification/logs/sensor_steps.h"

namespace sinew::diagnosis {

/// A smooth motion, nothing above `cutoff` [Hz], that a sensor with these steps reads so, as far as
/// there is one: it lies within half a step of every reading, as consistent reconstruction of a
/// quantised signal asks for. `step`: between samples, s.
Eigen::VectorXd consistent_motion(const Eigen::VectorXd& reading, const SensorSteps& steps,
                                  double step, double cutoff);

/// Which end of its play a sensor is at, -1..1: the direction of the reading's motion, and on its
/// way from one end to the other while the reading stands still (changes by no more than `quantum`
/// a sample; without steps: moves no faster than `still`).
Eigen::VectorXd side_of_play(const Eigen::VectorXd& reading, const Eigen::VectorXd& velocity,
                             double quantum, double still);

}  // namespace sinew::diagnosis
