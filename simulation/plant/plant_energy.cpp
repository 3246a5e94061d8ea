// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and power of a plant, for the audit.
#include "simulation/plant/plant.h"

namespace sinew {

Powers Plant::powers(const Evaluation& e) const {
  Powers power{};
  if (k_ > 0) {
    power[motor_power] = e.motor.power;  // with drives of their own: all that the torque does
    power[motor_friction_power] = e.motor.friction_power;
    power[ripple_power] = e.motor.ripple_power;
    power[load_power] = -e.load * e.omega.sum();
  }
  if (parts_.drives) power[effects_power] = e.effects_power;
  if (n_ > 0) {
    power[external_power] = e.external.dot(e.qd);
    power[damping_power] = -damping_.dot(e.qd.cwiseProduct(e.qd));
    power[base_power] = e.base_power;
  }
  if (tendons_ == 0) return power;
  power[guiding_power] = (e.force() - e.finger_force).dot(e.h_rate - e.wrist_rate);
  if (!elastic_) {
    power[prescribed_power] = -e.force().dot(e.h_rate - e.wrist_rate);
    return power;
  }
  power[wrist_power] = e.force().dot(e.wrist_rate);
  if (k_ == 0) power[prescribed_power] = parts_.motor->radius() * e.force().dot(e.omega);
  return power;
}

EnergyNow Plant::energy(const Evaluation& e) const {
  EnergyNow now;
  const auto add_rate = [&](const auto& parts) {
    now.rate += parts.sum();
    now.size += parts.cwiseAbs().sum();
  };
  if (n_ > 0) {
    inertial_.resize(n_);
    parts_.joints->inertial_forces(e.q.data(), e.qd.data(), e.qdd.data(), e.wrist,
                                   inertial_.data());
    now.value += parts_.joints->energy(e.q.data(), e.qd.data(), e.wrist);
    add_rate(e.qd.cwiseProduct(inertial_));
  }
  if (k_ > 0) {
    now.value += 0.5 * parts_.motor->inertia() * e.omega.squaredNorm();
    add_rate(parts_.motor->inertia() * e.omega.cwiseProduct(e.motor.acceleration));
  }
  if (!elastic_) return now;
  now.value += parts_.tendon->energy(e.elongation, e.tendon);
  add_rate(e.force().cwiseProduct(parts_.motor->radius() * e.omega + e.h_rate));
  return now;
}

}  // namespace sinew
