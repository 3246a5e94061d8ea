// SPDX-License-Identifier: GPL-3.0-or-later
// The index finger with a motor at each of its tendons.
#pragma once

#include "symbolic/extension/driven_model.h"
#include "symbolic/model/read_mechanism.h"

namespace sinew::test {

inline DrivenModel finger_with_motors() {
  MotorParameters motor;
  motor.gear_ratio = 0.01;
  motor.torque_constant = 1.0;
  motor.gearbox_inertia = 2e-3;
  motor.pulley_radius = 0.005;
  motor.gamma1 = 50.0;
  motor.gamma2 = 0.1;
  return tendon_driven_model(read_mechanism(SINEW_SOURCE_DIR "/models/index"), motor);
}

}  // namespace sinew::test
