// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and power of a plant, for the audit.
#include "simulation/plant.h"

namespace sinew {
namespace {

using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

Powers Plant::powers(const Evaluation& e) const {
  Powers power{};
  for (int i = 0; i < k_; ++i) {
    double own[5];
    parts_.motor->powers(e.theta(i), e.omega(i), e.torque(i), tendons_ > 0 ? e.force(i) : 0.0, own);
    power[motor_power] += own[0];
    power[motor_friction_power] += own[1];
    power[ripple_power] += own[2];
    power[load_power] -= e.load * e.omega(i);
  }
  if (n_ > 0) {
    power[external_power] = e.external.dot(e.qd);
    if (scenario_.joint_damping)
      power[damping_power] = -parts_.joints->damping.dot(e.qd.cwiseProduct(e.qd));
    power[base_power] = parts_.joints->base_power(e.q.data(), e.qd.data(), e.wrist);
  }
  if (tendons_ == 0) return power;
  const VectorXd finger_rate = e.h_rate - e.wrist_rate;
  power[guiding_power] = (e.force - e.finger_force).dot(finger_rate);
  if (!elastic_) {
    power[prescribed_power] = -e.force.dot(finger_rate);
    return power;
  }
  power[wrist_power] = e.force.dot(e.wrist_rate);
  if (k_ == 0) power[prescribed_power] = parts_.motor->radius() * e.force.dot(e.omega);
  return power;
}

double Plant::energy(const Evaluation& e) const {
  double sum = 0.0;
  if (n_ > 0) {
    RowMajor M(n_, n_);
    VectorXd bias(n_);
    parts_.joints->mass_and_bias(e.q.data(), e.qd.data(), e.wrist, M.data(), bias.data());
    sum += 0.5 * e.qd.dot(M * e.qd) + parts_.joints->potential(e.q.data(), e.wrist);
  }
  if (k_ > 0) sum += 0.5 * parts_.motor->inertia() * e.omega.squaredNorm();
  if (elastic_)
    for (int i = 0; i < tendons_; ++i)
      sum += parts_.tendon->energy(e.elongation(i),
                                   {e.force(i), e.stiffness(i), e.lever_angle(i), 0.0});
  return sum;
}

EnergyRate Plant::energy_rate(const Evaluation& e) const {
  EnergyRate rate;
  const auto add = [&](const VectorXd& parts) {
    rate.total += parts.sum();
    rate.size += parts.cwiseAbs().sum();
  };
  if (n_ > 0) {
    RowMajor M(n_, n_);
    VectorXd bias(n_);
    parts_.joints->mass_and_bias(e.q.data(), e.qd.data(), e.wrist, M.data(), bias.data());
    add(e.qd.cwiseProduct(M * e.qdd + bias));
  }
  if (k_ > 0) add(parts_.motor->inertia() * e.omega.cwiseProduct(e.omega_rate));
  if (elastic_) add(e.force.cwiseProduct(parts_.motor->radius() * e.omega + e.h_rate));
  return rate;
}

}  // namespace sinew
