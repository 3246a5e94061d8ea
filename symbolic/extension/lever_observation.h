// SPDX-License-Identifier: GPL-3.0-or-later
// A lever on its calibration rig: what the load cell and the gauge should read at a sensor count
// (4.1), and what may change that.
#pragma once

#include "symbolic/extension/observation.h"
#include "symbolic/parts/lever.h"

namespace sinew {

struct LeverRig {
  LeverParameters lever;
  double compliance = 0.0;  ///< m/N, of the tendon in series: l0/(E S)
};

/// observation(count, count_rate [1/s], count_speed [1/s], count_side, bend [rad], step [s], memory
/// 2 -> measured 2, next 2): force [N] and elongation of lever and tendon [m]; count_rate is
/// without the sensor's flicker and turns the states, count_speed is the smooth derivative,
/// count_side the end of its play that the sensor is at (late_sensor.h); bend is the total bending
/// angle between lever and load cell; memory holds the sides of hysteresis and guides (-1..1).
/// Counts may lie up to a tenth of the travel outside it. Throws std::invalid_argument where both
/// counts are the same.
Observation lever_observation(const LeverRig& rig, const std::string& model);

}  // namespace sinew
