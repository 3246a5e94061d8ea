// SPDX-License-Identifier: GPL-3.0-or-later
// The motion linearised at a state, from the emitted stiffness and mass matrices: what makes a step
// of a stiff integrator cheap. Gradients of gravity, Coriolis terms and bending are left out; the
// integrators only need it near enough.
#include "simulation/plant/plant.h"

namespace sinew {

void Plant::jacobian(double time, const double* y, MotionJacobian& J) const {
  const Evaluation& e = evaluated(time, y, tendons_ > 0);
  J.mass.resize(n_, n_);
  J.damping.setZero(n_, n_);
  if (n_ > 0) {
    parts_.joints->mass_matrix(e.q.data(), e.wrist, J.mass.data());
    J.damping.diagonal() = damping_;
    if (tendons_ > 0) {
      J.stiffness.resize(n_, n_);
      parts_.joints->stiffness(e.q.data(), e.wrist, e.finger_force.data(),
                               e.tendon.stiffness.data(), J.stiffness.data());
      if (parts_.guiding) add_guiding_slope(e, J.damping);
    } else {
      J.stiffness.setZero(n_, n_);
    }
  }
  motor_jacobian(e, J);
  if (parts_.drives) add_drive_slopes(time, e, J);
}

void Plant::motor_jacobian(const Evaluation& e, MotionJacobian& J) const {
  J.by_angle.resize(k_);
  J.by_speed.resize(k_);
  J.tendon.setZero(k_);
  if (k_ == 0) return;
  J.radius = parts_.motor->radius();
  J.per_torque = 1.0 / parts_.motor->inertia();
  J.by_angle = e.motor.by_angle;
  J.by_speed = e.motor.by_speed;
  if (scenario_.drive == DriveMode::servo) {
    J.by_angle.array() -= scenario_.gain * J.per_torque;
    J.by_speed.array() -= scenario_.rate_gain * J.per_torque;
  }
  if (tendons_ == 0) return;
  J.tendon = e.tendon.stiffness;
  J.coupling = e.P;
}

void Plant::add_guiding_slope(const Evaluation& e, MotionJacobian::Matrix& D) const {
  const double step = 0.01 * parts_.guiding->reversal_velocity();
  const auto at = [&](double change) {
    const Eigen::VectorXd velocity = e.inward.array() + change;
    Eigen::VectorXd tension(tendons_);
    parts_.guiding->transmitted(tendons_, e.force().data(), e.bending.data(), velocity.data(),
                                tension.data());
    return tension;
  };
  // The finger's tension grows with dh/dt, so this is a damping.
  const Eigen::VectorXd slope = (at(-step) - at(step)) / (2.0 * step);
  D += e.P.transpose() * slope.asDiagonal() * e.P;
}

}  // namespace sinew
