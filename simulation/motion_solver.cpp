// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motion_solver.h"

namespace sinew {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// With the positions put in, the rates v of joints (q) and motors (m) fulfil
//   (I - g B_q - g² A_q) v_q - g² A_qm v_m = b_q,   (1 - g B_m - g² A_m) v_m - g² A_mq v_q = b_m.
void MotionSolver::prepare(double gamma) {
  gamma_ = gamma;
  const MotionJacobian& J = jacobian;
  const double square = gamma * gamma;
  const auto n = J.joint_by_motor.rows(), k = J.joint_by_motor.cols();
  if (k > 0)
    motor_ = (1.0 - gamma * J.motor_by_rate.array() - square * J.motor_by_motor.array()).inverse();
  if (n == 0) return;
  MatrixXd own = MatrixXd::Identity(n, n);
  own.noalias() -= gamma * J.joint_by_rate + square * J.joint_by_joint;
  if (k > 0) {
    up_ = square * J.joint_by_motor * motor_.asDiagonal();
    own.noalias() -= square * (up_ * J.motor_by_joint);
  }
  joints_.compute(own);
}

void MotionSolver::solve(const double* r, double* x) const {
  const MotionJacobian& J = jacobian;
  const auto n = J.joint_by_motor.rows(), k = J.joint_by_motor.cols();
  const Eigen::Map<const VectorXd> q(r, n), theta(r + n, k), qd(r + n + k, n),
      omega(r + 2 * n + k, k);
  motor_rate_ = omega;
  if (k > 0) motor_rate_ += gamma_ * J.motor_by_motor.cwiseProduct(theta);
  if (n > 0) {
    joint_rate_ = qd;
    joint_rate_.noalias() += gamma_ * (J.joint_by_joint * q);
    if (k > 0) {
      joint_rate_.noalias() += gamma_ * (J.joint_by_motor * theta);
      motor_rate_.noalias() += gamma_ * (J.motor_by_joint * q);
      joint_rate_.noalias() += up_ * motor_rate_;
    }
    joint_rate_ = joints_.solve(joint_rate_).eval();
    if (k > 0) motor_rate_.noalias() += gamma_ * gamma_ * (J.motor_by_joint * joint_rate_);
  }
  if (k > 0) motor_rate_ = motor_rate_.cwiseProduct(motor_).eval();
  Eigen::Map<VectorXd> out(x, 2 * (n + k));
  out.head(n) = q + gamma_ * joint_rate_.head(n);
  out.segment(n, k) = theta + gamma_ * motor_rate_.head(k);
  out.segment(n + k, n) = joint_rate_.head(n);
  out.tail(k) = motor_rate_.head(k);
}

}  // namespace sinew
