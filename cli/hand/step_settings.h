// SPDX-License-Identifier: GPL-3.0-or-later
// real_time.toml beside a hand: what its real-time step needs that is no part of the model.
#pragma once

#include <filesystem>

namespace sinew {

/// A kind of sensor; times in s, values in the sensor's unit.
struct SensorSettings {
  double low = 0.0, high = 0.0;
  double largest_step = 0.0;  ///< a period
  double hold = 0.0, settle = 0.0, frozen = 0.0;
};

struct StepSettings {
  double period = 0.0;                             ///< s
  double pretension = 0.0;                         ///< N
  double servo_gain = 0.0, servo_rate_gain = 0.0;  ///< N·m/rad, N·m·s/rad
  double torque_limit = 0.0;                       ///< N·m
  double reference_rate = 0.0;                     ///< rad/s
  double rate_filter = 0.0;                        ///< Hz
  int turns = 1;
  double restart = 0.0;  ///< s
  SensorSettings motor, lever, wrist;
  double wrist_margin = 0.0;  ///< rad
};

/// Reads `folder`/real_time.toml. Throws DescriptionError with every mistake found.
StepSettings read_step_settings(const std::filesystem::path& folder);

}  // namespace sinew
