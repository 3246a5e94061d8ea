// SPDX-License-Identifier: GPL-3.0-or-later
// The linear equations of an implicit step, solved along their structure.
#pragma once

#include <vector>

#include "simulation/plant/plant.h"

namespace sinew {

/// (I - gamma d(dy/dt)/dy) x = r for y = [q, theta, qd, omega]. Positions follow from rates; each
/// motor then has one equation that couples it to the joints of its tendon alone and is eliminated:
/// what is left is symmetric, positive definite for all but long steps out of unstable positions,
/// and has the joints' size.
class MotionSolver {
 public:
  MotionJacobian jacobian;

  /// Factorises for a step; `jacobian` has been set.
  void prepare(double gamma);
  /// x and r have 2 (joints + motors) numbers and may be the same array.
  void solve(const double* r, double* x);

 private:
  /// One tendon's share of a joint.
  struct Link {
    int joint;
    double arm;  ///< dh/dq [m]
  };

  void find_links();
  void eliminate_motors();
  void factorise();
  void substitute(double* b) const;

  double gamma_ = 0.0;
  int n_ = 0, k_ = 0;
  MotionJacobian::Matrix linked_;  ///< coupling that the links are of
  std::vector<Link> links_;
  std::vector<int> ends_;     ///< of each tendon's links
  Eigen::VectorXd own_;       ///< 1 / each motor's own coefficient
  MotionJacobian::Matrix A_;  ///< L below the diagonal, D on it
  Eigen::VectorXd joint_, motor_, force_;
};

}  // namespace sinew
