// SPDX-License-Identifier: GPL-3.0-or-later
// The linear equations of an implicit step, solved along their structure.
#pragma once

#include <Eigen/LU>

#include "simulation/plant.h"

namespace sinew {

/// (I - gamma d(dy/dt)/dy) x = r for y = [q, theta, qd, omega]. Positions follow from rates; each
/// motor then has one equation that couples it to the joints alone and is eliminated: what is left
/// has the joints' size.
class MotionSolver {
 public:
  MotionJacobian jacobian;

  /// Factorises for a step; `jacobian` has been set.
  void prepare(double gamma);
  /// x and r have 2 (joints + motors) numbers and may be the same array.
  void solve(const double* r, double* x) const;

 private:
  double gamma_ = 0.0;
  Eigen::VectorXd motor_;      ///< 1 / each motor's own coefficient
  MotionJacobian::Matrix up_;  ///< joints by motors, over the motors' coefficients
  Eigen::PartialPivLU<Eigen::MatrixXd> joints_;
  mutable Eigen::VectorXd joint_rate_, motor_rate_;
};

}  // namespace sinew
