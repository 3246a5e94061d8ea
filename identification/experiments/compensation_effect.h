// SPDX-License-Identifier: GPL-3.0-or-later
// What a compensation does: the amplitude at the motor's rotation frequency before and after it
// (3.2, Fig. 3.6).
#pragma once

#include <string>
#include <vector>

#include "identification/experiments/bump_projection.h"
#include "identification/logs/log.h"

namespace sinew {

/// Amplitude of one channel at one turn of the motor, over one constant velocity.
struct MotorOrderAmplitude {
  std::string log;
  double speed = 0.0;  ///< rad/s, output shaft
  long periods = 0;    ///< whole turns of the motor
  Estimate amplitude;  ///< the channel's unit; standard error from the turns' scatter
};

/// One constant velocity of a later log against the same one of the first.
struct MotorOrderReduction {
  std::string log;
  double speed = 0.0;
  Estimate share_left;  ///< amplitude over that in the first log: 0 removed, 1 unchanged
};

struct MotorOrderEffect {
  std::vector<MotorOrderAmplitude> amplitudes;
  std::vector<MotorOrderReduction> reductions;  ///< speeds within 10 % that both logs have
};

/// `channel`: "omega" (also where it is not logged: theta's slope over 2 samples each way),
/// "tau_m", or any other the logs carry, such as the controller's torque before the feedforward.
/// Needs "theta" and "tau_m". Three turns of the motor at least; shorter velocities and logs
/// without the channel are left out.
MotorOrderEffect motor_order_effect(const std::vector<Log>& logs, double gear_ratio,
                                    const std::string& channel);

}  // namespace sinew
