// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/position_noise.h"

#include <algorithm>
#include <cmath>

#include "identification/filter.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A smoother needs ten samples of what it is to pass.
double at_most(double frequency, double step) {
  return std::min(frequency, 0.1 / step);
}

/// Mean square of the acceleration between the two smoothers, for white noise of the position that
/// has mean square 1 above both.
double noise_of_acceleration(double step) {
  const auto half = static_cast<Index>(std::ceil(0.3 / step));  // longer than either smoother
  const VectorXd pulse = VectorXd::Unit(2 * half + 1, half);
  const Motion fast = differentiate(pulse, step, motion_cutoff(step));
  const Motion slow = differentiate(pulse, step, smooth_cutoff(step));
  return (fast.qdd - slow.qdd).squaredNorm() / (pulse - fast.q).squaredNorm();
}

}  // namespace

double motion_cutoff(double step) {
  return at_most(60.0, step);  // above, an encoder's acceleration is its steps
}

double slow_cutoff(double step) {
  return at_most(35.0, step);
}

double smooth_cutoff(double step) {
  return at_most(18.0, step);
}

bool noise_of_position(const std::vector<const Recording*>& logs, Index joint) {
  double found = 0.0, expected = 0.0;
  for (const Recording* log : logs) {
    expected += noise_of_acceleration(log->step) *
                (log->signals.at("logged_q").col(joint) - log->q.col(joint)).squaredNorm();
    found += (log->qdd.col(joint) - log->signals.at("smooth_qdd").col(joint)).squaredNorm();
  }
  return expected > 0.0 && found < 4.0 * expected;
}

}  // namespace sinew::diagnosis
