// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/function.h"
#include "symbolic/parts/motor.h"

namespace sinew {

/// motion(theta, qd, tau_m, f, load -> tau, qdd, slope 2, power 3): one function of everything that
/// a simulation asks of a motor, so that its sines are taken once. The emitted equations are put
/// together, none is written here. `tau` is the torque applied: `tau_m`, and where `compensated`
/// the feedforward against friction and ripple; `load` acts against it [N·m]. `qdd` [rad/s²] and
/// its derivatives by theta and qd with the feedforward's own; powers of motor, friction and ripple
/// [W].
Function motor_motion(const MotorParameters& parameters, bool compensated);

}  // namespace sinew
