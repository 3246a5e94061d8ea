// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/motion_solver.h"

#include <algorithm>

namespace sinew {

// With g = gamma, positions q = r_q + g v, theta = r_theta + g w put in, the rates fulfil
//   (M + g D + g² K) v + g² R P^T k_t w = M r_v - g K r_q - g R P^T k_t r_theta, c w + g² R/B k_t P
//   v = s,   c = 1 - g by_speed - g² (by_angle - R²/B k_t), s = r_w + g by_angle r_theta - g R/B
//   k_t (R r_theta + P r_q).
void MotionSolver::prepare(double gamma) {
  gamma_ = gamma;
  n_ = static_cast<int>(jacobian.mass.rows());
  k_ = static_cast<int>(jacobian.by_angle.size());
  if (n_ > 0) A_ = jacobian.mass + gamma * jacobian.damping + gamma * gamma * jacobian.stiffness;
  if (k_ > 0) {
    find_links();
    eliminate_motors();
  }
  factorise();
}

void MotionSolver::find_links() {
  const MotionJacobian::Matrix& P = jacobian.coupling;  // constant where all pulleys are round
  if (P.size() == linked_.size() && std::equal(P.data(), P.data() + P.size(), linked_.data()) &&
      static_cast<int>(ends_.size()) == (n_ > 0 ? k_ : 0))
    return;
  linked_ = P;
  links_.clear();
  ends_.clear();
  for (int i = 0; i < k_ && n_ > 0; ++i) {
    const double* row = jacobian.coupling.data() + static_cast<std::ptrdiff_t>(i) * n_;
    for (int j = 0; j < n_; ++j)
      if (row[j] != 0.0) links_.push_back({j, row[j]});
    ends_.push_back(static_cast<int>(links_.size()));
  }
}

void MotionSolver::eliminate_motors() {
  const MotionJacobian& J = jacobian;
  const double g = gamma_, square = g * g, R = J.radius;
  own_.resize(k_);
  int at = 0;
  for (int i = 0; i < k_; ++i) {
    const double pull = R * J.per_torque * J.tendon(i);
    own_(i) = 1.0 / (1.0 - g * J.by_speed(i) - square * (J.by_angle(i) - R * pull));
    if (n_ == 0) continue;
    const double weight = square * square * R * J.tendon(i) * pull * own_(i);
    const int first = at;
    for (; at < ends_[static_cast<std::size_t>(i)]; ++at) {
      const Link& one = links_[static_cast<std::size_t>(at)];
      for (int other = first; other <= at; ++other) {
        const Link& two = links_[static_cast<std::size_t>(other)];
        A_(one.joint, two.joint) -= weight * one.arm * two.arm;  // the lower half alone is used
      }
    }
  }
}

void MotionSolver::factorise() {
  for (int j = 0; j < n_; ++j) {
    double* row = A_.data() + static_cast<std::ptrdiff_t>(j) * n_;
    for (int i = 0; i < j; ++i) {
      const double* above = A_.data() + static_cast<std::ptrdiff_t>(i) * n_;
      double sum = row[i];
      for (int m = 0; m < i; ++m) sum -= row[m] * above[m];
      row[i] = sum;  // L times D as yet
    }
    double pivot = row[j];
    for (int i = 0; i < j; ++i) {
      const double scaled = row[i] * A_(i, i);
      pivot -= scaled * row[i];
      row[i] = scaled;
    }
    row[j] = 1.0 / pivot;
  }
}

void MotionSolver::substitute(double* b) const {
  for (int j = 0; j < n_; ++j) {
    const double* row = A_.data() + static_cast<std::ptrdiff_t>(j) * n_;
    for (int i = 0; i < j; ++i) b[j] -= row[i] * b[i];
  }
  for (int j = 0; j < n_; ++j) b[j] *= A_(j, j);
  for (int j = n_; j-- > 0;) {
    const double* row = A_.data() + static_cast<std::ptrdiff_t>(j) * n_;
    for (int i = 0; i < j; ++i) b[i] -= row[i] * b[j];
  }
}

void MotionSolver::solve(const double* r, double* x) {
  const MotionJacobian& J = jacobian;
  const double g = gamma_, R = J.radius;
  const double *q = r, *theta = r + n_, *v = theta + k_, *w = v + n_;
  joint_.resize(n_);
  motor_.resize(k_);
  for (int j = 0; j < n_; ++j) {
    double sum = 0.0;
    const double* mass = J.mass.data() + static_cast<std::ptrdiff_t>(j) * n_;
    const double* stiffness = J.stiffness.data() + static_cast<std::ptrdiff_t>(j) * n_;
    for (int i = 0; i < n_; ++i) sum += mass[i] * v[i] - g * stiffness[i] * q[i];
    joint_(j) = sum;
  }
  std::size_t at = 0;
  const auto links_end = [&](int i) {
    return n_ > 0 ? static_cast<std::size_t>(ends_[static_cast<std::size_t>(i)]) : 0;
  };
  for (int i = 0; i < k_; ++i) {
    const std::size_t first = at;
    double change = R * theta[i];
    for (; at < links_end(i); ++at) change += links_[at].arm * q[links_[at].joint];
    motor_(i) = w[i] + g * (J.by_angle(i) * theta[i] - R * J.per_torque * J.tendon(i) * change);
    const double force = g * R * J.tendon(i) * (theta[i] + g * own_(i) * motor_(i));
    for (std::size_t k = first; k < at; ++k) joint_(links_[k].joint) -= links_[k].arm * force;
  }
  substitute(joint_.data());
  at = 0;
  for (int i = 0; i < k_; ++i) {
    double change = 0.0;
    for (; at < links_end(i); ++at) change += links_[at].arm * joint_(links_[at].joint);
    motor_(i) = own_(i) * (motor_(i) - g * g * R * J.per_torque * J.tendon(i) * change);
  }
  for (int j = 0; j < n_; ++j) x[j] = q[j] + g * joint_(j);
  for (int i = 0; i < k_; ++i) x[n_ + i] = theta[i] + g * motor_(i);
  std::copy(joint_.begin(), joint_.end(), x + n_ + k_);
  std::copy(motor_.begin(), motor_.end(), x + 2 * n_ + k_);
}

}  // namespace sinew
