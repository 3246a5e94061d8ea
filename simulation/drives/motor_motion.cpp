// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drives/motor_motion.h"

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/inline_function.h"

namespace sinew {

using GiNaC::ex;

Function motor_motion(const MotorParameters& parameters, bool compensated) {
  const Function acceleration = motor_acceleration(parameters);
  const Argument load = scalar_argument("load", "N m", {-1.0, 1.0}, "against the motor");
  std::vector<Argument> inputs = acceleration.inputs;
  inputs.push_back(load);
  const ex theta = inputs[0].symbols[0], qd = inputs[1].symbols[0], force = inputs[3].symbols[0];
  DefinitionList list;
  ex torque = inputs[2].symbols[0];
  if (compensated)
    torque = list.define(
        "torque", torque + inlined(list, motor_compensation_torque(parameters), {theta, qd})[0][0]);
  const ex net = list.define("net", torque - load.symbols[0]);
  const ex qdd = list.define("whole", inlined(list, acceleration, {theta, qd, net, force})[0][0]);
  const std::vector<ex> power =
      inlined(list, motor_power_balance(parameters), {theta, qd, torque, force})[0];
  ForwardDerivative by_theta(list, inputs[0].symbols[0], "theta");
  ForwardDerivative by_qd(list, inputs[1].symbols[0], "qd");
  const ex per_angle = by_theta.of(qdd), per_speed = by_qd.of(qdd);
  return {"motion",
          "A motor's acceleration with what an implicit step and an audit need.",
          "(3.5)",
          inputs,
          list.items(),
          {{"tau", 1, 1, {torque}, "N m", "applied"},
           {"qdd", 1, 1, {qdd}, "rad/s^2", ""},
           {"slope", 2, 1, {per_angle, per_speed}, "1/s^2, 1/s", "dqdd/dtheta, dqdd/dqd"},
           {"power", 3, 1, {power[0], power[1], power[2]}, "W", "motor, friction, ripple"}}};
}

}  // namespace sinew
