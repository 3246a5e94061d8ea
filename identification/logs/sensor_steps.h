// SPDX-License-Identifier: GPL-3.0-or-later
// The lattice on which the readings of a sensor with steps lie, behind noise or few digits.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Values offset + n * step, in the reading's unit.
struct SensorSteps {
  double step = 0.0;     ///< 0: there is none
  double offset = 0.0;   ///< one of its values
  double scatter = 0.0;  ///< rms distance of the readings from it
};

/// Whether or not the readings were rounded again to a finer grid or have noise of up to a fifth of
/// a step.
SensorSteps sensor_steps(const Eigen::VectorXd& reading);

}  // namespace sinew::diagnosis
