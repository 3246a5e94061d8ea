// SPDX-License-Identifier: GPL-3.0-or-later
// Derivative of the equations of motion, from the emitted stiffness and mass matrices: what makes a
// step of a stiff integrator cheap. Gradients of gravity, Coriolis terms and bending are left out;
// the integrators only need it near enough.
#include <Eigen/Cholesky>
#include <cmath>

#include "simulation/plant.h"

namespace sinew {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void Plant::jacobian(double time, const double* y, MotionJacobian& J) const {
  const Evaluation& e = evaluated(time, y, tendons_ > 0);
  J.joint_by_motor.setZero(n_, k_);
  J.motor_by_joint.setZero(k_, n_);
  if (n_ > 0) {
    M_.resize(n_, n_);
    bias_.resize(n_);
    Matrix K = Matrix::Zero(n_, n_);
    parts_.joints->mass_and_bias(e.q.data(), e.qd.data(), e.wrist, M_.data(), bias_.data());
    const Eigen::LDLT<MatrixXd> inverse{MatrixXd(M_)};
    MatrixXd D = MatrixXd::Zero(n_, n_);
    if (scenario_.joint_damping) D = parts_.joints->damping.asDiagonal();
    if (tendons_ > 0) {
      parts_.joints->stiffness(e.q.data(), e.wrist, e.finger_force.data(),
                               e.tendon.stiffness.data(), K.data());
      if (parts_.guiding) D += e.P.transpose() * guiding_slope(e).asDiagonal() * e.P;
      if (k_ > 0)
        J.joint_by_motor = -inverse.solve(
            MatrixXd(e.P.transpose() * (parts_.motor->radius() * e.tendon.stiffness).asDiagonal()));
    }
    J.joint_by_joint = -inverse.solve(MatrixXd(K));
    J.joint_by_rate = -inverse.solve(D);
  }
  if (k_ > 0) motor_jacobian(e, J);
}

void Plant::motor_jacobian(const Evaluation& e, MotionJacobian& J) const {
  constexpr double step = 1e-5;  // rad and rad/s; friction and ripple are smooth on this scale
  const VectorXd torque = e.torque.array() - e.load;
  const auto slope = [&](double angle, double speed) {
    const auto at = [&](double sign) {
      const VectorXd theta = e.theta.array() + sign * angle, omega = e.omega.array() + sign * speed;
      VectorXd rate(k_);
      parts_.motor->accelerations(k_, theta.data(), omega.data(), torque.data(), forces_or_zero(e),
                                  rate.data());
      return rate;
    };
    return VectorXd((at(1.0) - at(-1.0)) / (2.0 * step));
  };
  const double per_torque = 1.0 / parts_.motor->inertia(), radius = parts_.motor->radius();
  J.motor_by_motor = slope(step, 0.0);
  J.motor_by_rate = slope(0.0, step);
  if (scenario_.drive == DriveMode::servo) {
    J.motor_by_motor.array() -= scenario_.gain * per_torque;
    J.motor_by_rate.array() -= scenario_.rate_gain * per_torque;
  }
  if (tendons_ == 0) return;
  const VectorXd by_elongation = -radius * per_torque * e.tendon.stiffness;
  J.motor_by_motor += radius * by_elongation;
  J.motor_by_joint = by_elongation.asDiagonal() * e.P;
}

VectorXd Plant::guiding_slope(const Evaluation& e) const {
  const double step = 0.01 * parts_.guiding->reversal_velocity();
  const auto at = [&](double change) {
    const VectorXd velocity = e.inward.array() + change;
    VectorXd tension(tendons_);
    parts_.guiding->transmitted(tendons_, e.force().data(), e.bending.data(), velocity.data(),
                                tension.data());
    return tension;
  };
  // The finger's tension grows with dh/dt, so this is a damping.
  return (at(-step) - at(step)) / (2.0 * step);
}

}  // namespace sinew
