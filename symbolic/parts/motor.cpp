// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/motor.h"

#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/exact_number.h"

namespace sinew {
namespace {

using GiNaC::ex;

void check(bool fine, const char* message) {
  if (!fine) throw std::invalid_argument(message);
}

void check(const MotorParameters& p) {
  check(p.gear_ratio > 0 && p.rotor_inertia >= 0 && p.gearbox_inertia >= 0 &&
            p.rotor_inertia + p.gearbox_inertia > 0,
        "a motor needs a positive gear ratio and inertia");
  check(p.torque_constant > 0, "a motor needs a positive torque constant");
  check(p.gamma1 >= 0 && p.gamma2 >= 0 && p.gamma3 >= 0, "motor friction must not drive the motor");
  check(p.friction_compensation >= 0 && p.friction_compensation < 1,
        "friction compensation must be in [0, 1): more injects energy");
  check(p.ripple_compensation >= 0 && p.ripple_compensation < 1,
        "ripple compensation must be in [0, 1)");
}

/// The motor's terms as definitions; signs as in B θ'' = τ_m - friction - ripple - R f.
struct Motor {
  explicit Motor(const MotorParameters& parameters) : p(parameters) {
    check(p);
    theta = scalar_argument("theta", "rad", p.theta, "output angle");
    qd = scalar_argument("qd", "rad/s", p.velocity, "output velocity");
    tau_m = scalar_argument("tau_m", "N m", p.torque, "electromagnetic torque at the output");
    f = scalar_argument("f", "N", p.tendon_force, "tendon force");
  }

  ex friction() {
    const ex speed = qd.symbols[0];
    return list.define("friction",
                       exact_number(p.gamma2) * GiNaC::atan(exact_number(p.gamma1) * speed) +
                           exact_number(p.gamma3) * speed);
  }

  ex ripple() {
    const ex angle = theta.symbols[0];
    ex sum = 0;
    for (const Ripple& term : p.output_ripple) sum += wave(term, angle);
    for (const Ripple& term : p.input_ripple) sum += wave(term, angle / exact_number(p.gear_ratio));
    return list.define("ripple", sum);
  }

  ex inertia() const {
    const GiNaC::numeric ratio = exact_number(p.gear_ratio);
    return exact_number(p.rotor_inertia) / (ratio * ratio) + exact_number(p.gearbox_inertia);
  }

  ex acceleration() {
    const ex lost = friction();  // one after the other: an expression's order is the compiler's
    const ex periodic = ripple();
    const ex net =
        tau_m.symbols[0] - lost - periodic - exact_number(p.pulley_radius) * f.symbols[0];
    return list.define("acceleration", net / inertia());
  }

  ex wave(const Ripple& term, const ex& angle) {
    return exact_number(term.amplitude) *
           GiNaC::sin(exact_number(term.order) * angle + exact_number(term.phase));
  }

  const MotorParameters& p;
  Argument theta, qd, tau_m, f;
  DefinitionList list;
};

}  // namespace

Function motor_friction_torque(const MotorParameters& parameters) {
  Motor motor(parameters);
  const ex tau = -motor.friction();
  return {"friction_torque",
          "Friction torque at a velocity; opposes motion.",
          "(3.8)",
          {motor.qd},
          motor.list.items(),
          {{"tau", 1, 1, {tau}, "N m", "acts on the output shaft"}}};
}

Function motor_ripple_torque(const MotorParameters& parameters) {
  Motor motor(parameters);
  const ex tau = -motor.ripple();
  return {"ripple_torque",
          "Periodic torque of output and input shaft at an angle.",
          "(3.5)",
          {motor.theta},
          motor.list.items(),
          {{"tau", 1, 1, {tau}, "N m", "acts on the output shaft"}}};
}

Function motor_acceleration(const MotorParameters& parameters) {
  Motor motor(parameters);
  const ex qdd = motor.acceleration();
  return {"acceleration",
          "Acceleration of the output shaft.",
          "(3.5)",
          {motor.theta, motor.qd, motor.tau_m, motor.f},
          motor.list.items(),
          {{"qdd", 1, 1, {qdd}, "rad/s^2", ""}}};
}

Function motor_compensation_torque(const MotorParameters& parameters) {
  Motor motor(parameters);
  const GiNaC::numeric share = exact_number(parameters.friction_compensation);
  const ex friction = motor.friction();
  const ex tau = share * friction + exact_number(parameters.ripple_compensation) * motor.ripple();
  const ex margin = (1 - share) * friction * motor.qd.symbols[0];
  return {"compensation_torque",
          "Feedforward against friction and ripple, and what friction still dissipates.",
          "(3.8)",
          {motor.theta, motor.qd},
          motor.list.items(),
          {{"tau", 1, 1, {tau}, "N m", "to be added to the commanded torque"},
           {"margin", 1, 1, {margin}, "W", "never negative: the compensated motor is passive"}}};
}

Function motor_power_balance(const MotorParameters& parameters) {
  Motor motor(parameters);
  const ex speed = motor.qd.symbols[0];
  const ex kinetic = motor.inertia() * motor.acceleration() * speed;
  const std::vector<ex> power{
      motor.tau_m.symbols[0] * speed, -motor.friction() * speed, -motor.ripple() * speed,
      -exact_number(parameters.pulley_radius) * motor.f.symbols[0] * speed, kinetic};
  return {"power_balance",
          "Where the motor's power goes; the last entry is the sum of the others.",
          "(3.5)",
          {motor.theta, motor.qd, motor.tau_m, motor.f},
          motor.list.items(),
          {{"power", 5, 1, power, "W", "motor, friction, ripple, tendon, into kinetic energy"}}};
}

Function motor_torque(const MotorParameters& parameters) {
  check(parameters);
  const GiNaC::numeric factor =
      exact_number(parameters.torque_constant) / exact_number(parameters.gear_ratio);
  const double per_ampere = factor.to_double();
  const Argument current = scalar_argument(
      "current", "A", {parameters.torque.low / per_ampere, parameters.torque.high / per_ampere},
      "motor current");
  return {"torque", "Torque at the output from the current.",
          "",       {current},
          {},       {{"tau_m", 1, 1, {factor * current.symbols[0]}, "N m", "at the output shaft"}}};
}

Function motor_current(const MotorParameters& parameters) {
  check(parameters);
  const Argument tau_m =
      scalar_argument("tau_m", "N m", parameters.torque, "torque at the output shaft");
  const ex current = tau_m.symbols[0] * exact_number(parameters.gear_ratio) /
                     exact_number(parameters.torque_constant);
  return {"current", "Current for a torque at the output.",  "", {tau_m},
          {},        {{"current", 1, 1, {current}, "A", ""}}};
}

Function motor_rigid_torque(const MotorParameters& parameters) {
  Motor motor(parameters);
  const Argument qdd = scalar_argument("qdd", "rad/s^2", {-100.0, 100.0}, "output acceleration");
  const ex tau = motor.inertia() * qdd.symbols[0] + motor.ripple();
  return {"rigid_torque",
          "Torque that inertia and ripple take, friction aside.",
          "(3.5)",
          {motor.theta, motor.qd, qdd},
          motor.list.items(),
          {{"tau", 1, 1, {tau}, "N m", "at the output shaft"}}};
}

std::vector<Function> motor_functions(const MotorParameters& p) {
  return {motor_friction_torque(p), motor_ripple_torque(p),
          motor_acceleration(p),    motor_compensation_torque(p),
          motor_power_balance(p),   motor_torque(p),
          motor_current(p)};
}

double motor_inertia(const MotorParameters& parameters) {
  return GiNaC::ex_to<GiNaC::numeric>(Motor(parameters).inertia()).to_double();
}

}  // namespace sinew
