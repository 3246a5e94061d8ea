// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/position_noise.h"

#include <algorithm>
#include <cmath>

#include "identification/logs/filter.h"
#include "identification/logs/log.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A smoother needs ten samples of what it is to pass.
double at_most(double frequency, double step) {
  return std::min(frequency, 0.1 / step);
}

/// A sample of 1 among zeros that reach further than two smoothers one behind the other, which are
/// a good quarter of a second to each side, and 40 samples where samples are sparse.
VectorXd pulse_for(double step) {
  const auto half = std::max<Index>(250, static_cast<Index>(std::ceil(0.6 / step)));
  return VectorXd::Unit(2 * half + 1, half);
}

/// Mean square of the acceleration between the two smoothers, for white noise of the position that
/// has mean square 1 above both.
double noise_of_acceleration(double step) {
  const VectorXd pulse = pulse_for(step);
  const Motion fast = differentiate(pulse, step, motion_cutoff(step));
  const Motion slow = differentiate(pulse, step, smooth_cutoff(step));
  return (fast.qdd - slow.qdd).squaredNorm() / (pulse - fast.q).squaredNorm();
}

/// Mean square of the fourth derivative for white noise of the position with mean square 1.
double jounce_of_noise(double step, double cutoff) {
  const VectorXd pulse = pulse_for(step);
  const Motion smooth = differentiate(pulse, step, motion_cutoff(step));
  const Motion slow = differentiate(smooth.q, step, cutoff);
  return differentiate(slow.qdd, step, cutoff).qdd.squaredNorm();
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
                (log->signals.at("logged_q").col(joint) - log->signals.at("read_q").col(joint))
                    .squaredNorm();
    found += (log->signals.at("read_qdd").col(joint) - log->signals.at("smooth_qdd").col(joint))
                 .squaredNorm();
  }
  return expected > 0.0 && found < 4.0 * expected;
}

Motion motion_as_read(const Recording& log) {
  const Eigen::MatrixXd* read = log.signals.find("read_q");
  if (!read || read->rows() != log.q.rows()) return {log.q, log.qd, log.qdd};
  return {*read, log.signals.at("read_qd"), log.signals.at("read_qdd")};
}

double noise_of_jounce(const std::vector<const Recording*>& logs, Index joint, double quantum,
                       bool noisy) {
  double found = 0.0, expected = 0.0;
  for (const Recording* log : logs) {
    const VectorXd reading = log->signals.at("logged_q").col(joint);
    const double noise = std::max(white_noise_rms(reading.array()), quantum / std::sqrt(12.0));
    const double cutoff = noisy ? smooth_cutoff(log->step) : slow_cutoff(log->step);
    const auto samples = static_cast<double>(reading.size());
    expected += noise * noise * jounce_of_noise(log->step, cutoff) * samples;
    found += log->signals.at("jounce").col(joint).squaredNorm();
  }
  return found > 0.0 ? std::min(1.0, expected / found) : 1.0;
}

}  // namespace sinew::diagnosis
