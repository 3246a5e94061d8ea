// SPDX-License-Identifier: GPL-3.0-or-later
// Derivative of the equations of motion, from the emitted stiffness and mass matrices: what makes a
// step of a stiff integrator cheap. Gradients of gravity, Coriolis terms and bending are left out;
// the integrators only need it near enough.
#include <Eigen/Cholesky>
#include <cmath>

#include "simulation/plant.h"

namespace sinew {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

void Plant::jacobian(double time, const double* y, MatrixXd& J) const {
  Evaluation& e = scratch_;
  evaluate(time, y, e, tendons_ > 0);
  const int half = n_ + k_;
  J.setZero(size(), size());
  J.topRightCorner(half, half).setIdentity();

  if (n_ > 0) {
    RowMajor M(n_, n_), K = RowMajor::Zero(n_, n_);
    VectorXd bias(n_);
    parts_.joints->mass_and_bias(e.q.data(), e.qd.data(), e.wrist, M.data(), bias.data());
    const Eigen::LDLT<MatrixXd> inverse{MatrixXd(M)};
    MatrixXd D = MatrixXd::Zero(n_, n_);
    if (scenario_.joint_damping) D = parts_.joints->damping.asDiagonal();
    if (tendons_ > 0) {
      parts_.joints->stiffness(e.q.data(), e.wrist, e.finger_force.data(), e.stiffness.data(),
                               K.data());
      if (parts_.guiding) D += e.P.transpose() * guiding_slope(e).asDiagonal() * e.P;
      if (k_ > 0)
        J.block(half, n_, n_, k_) = -inverse.solve(
            MatrixXd(e.P.transpose() * (parts_.motor->radius() * e.stiffness).asDiagonal()));
    }
    J.block(half, 0, n_, n_) = -inverse.solve(MatrixXd(K));
    J.block(half, half, n_, n_) = -inverse.solve(D);
  }
  for (int i = 0; i < k_; ++i) {
    const double force = tendons_ > 0 ? e.force(i) : 0.0;
    const auto change = [&](double angle, double speed) {
      const auto at = [&](double sign) {
        return parts_.motor->acceleration(e.theta(i) + sign * angle, e.omega(i) + sign * speed,
                                          e.torque(i) - e.load, force);
      };
      return (at(1.0) - at(-1.0)) / (2.0 * (angle + speed));
    };
    const double per_torque = 1.0 / parts_.motor->inertia();
    const double by_elongation =
        tendons_ > 0 ? -parts_.motor->radius() * per_torque * e.stiffness(i) : 0.0;
    const bool servo = scenario_.drive == DriveMode::servo;
    const int row = half + n_ + i;
    J(row, n_ + i) = change(1e-5, 0.0) - (servo ? scenario_.gain * per_torque : 0.0) +
                     (tendons_ > 0 ? by_elongation * parts_.motor->radius() : 0.0);
    J(row, row) = change(0.0, 1e-5) - (servo ? scenario_.rate_gain * per_torque : 0.0);
    if (tendons_ > 0) J.block(row, 0, 1, n_) = by_elongation * e.P.row(i);
  }
}

VectorXd Plant::guiding_slope(const Evaluation& e) const {
  VectorXd bending(tendons_), slope(tendons_);
  parts_.joints->bending(e.q.data(), e.wrist, bending.data());
  const double step = 0.01 * parts_.guiding->reversal_velocity();
  for (int i = 0; i < tendons_; ++i) {
    const double velocity = -(e.h_rate(i) - e.wrist_rate(i));
    const auto at = [&](double v) {
      return parts_.guiding->transmitted(e.force(i), bending(i) + scenario_.fixed_bending, v);
    };
    // The finger's tension grows with dh/dt, so this is a damping.
    slope(i) = (at(velocity - step) - at(velocity + step)) / (2.0 * step);
  }
  return slope;
}

}  // namespace sinew
