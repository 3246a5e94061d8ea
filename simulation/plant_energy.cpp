// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and power of a plant, for the audit.
#include "simulation/plant.h"

namespace sinew {

Powers Plant::powers(const Evaluation& e) const {
  Powers power{};
  if (k_ > 0) {
    power_.resize(5 * k_);
    parts_.motor->powers(k_, e.theta.data(), e.omega.data(), e.torque.data(), forces_or_zero(e),
                         power_.data());
    power[motor_power] = power_.head(k_).sum();
    power[motor_friction_power] = power_.segment(k_, k_).sum();
    power[ripple_power] = power_.segment(2 * k_, k_).sum();
    power[load_power] = -e.load * e.omega.sum();
  }
  if (n_ > 0) {
    power[external_power] = e.external.dot(e.qd);
    if (scenario_.joint_damping)
      power[damping_power] = -parts_.joints->damping.dot(e.qd.cwiseProduct(e.qd));
    power[base_power] = parts_.joints->base_power(e.q.data(), e.qd.data(), e.wrist);
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
    M_.resize(n_, n_);
    bias_.resize(n_);
    parts_.joints->mass_and_bias(e.q.data(), e.qd.data(), e.wrist, M_.data(), bias_.data());
    now.value += 0.5 * e.qd.dot(M_ * e.qd) + parts_.joints->potential(e.q.data(), e.wrist);
    bias_ += M_ * e.qdd;
    add_rate(e.qd.cwiseProduct(bias_));
  }
  if (k_ > 0) {
    now.value += 0.5 * parts_.motor->inertia() * e.omega.squaredNorm();
    add_rate(parts_.motor->inertia() * e.omega.cwiseProduct(e.omega_rate));
  }
  if (!elastic_) return now;
  for (int i = 0; i < tendons_; ++i)
    now.value += parts_.tendon->energy(e.elongation(i), e.tendon, i);
  add_rate(e.force().cwiseProduct(parts_.motor->radius() * e.omega + e.h_rate));
  return now;
}

}  // namespace sinew
