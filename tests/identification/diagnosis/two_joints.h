// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of two joints, for tests that make up what they take.
#pragma once

#include "identification/regression/candidate.h"

namespace sinew::test {

/// 30 s at 200 Hz; efforts, step and everything else are the test's own.
inline diagnosis::Recording two_joint_motion() {
  constexpr double step = 5e-3;
  constexpr Eigen::Index samples = 6000;
  diagnosis::Recording log;
  log.name = "arm";
  log.step = step;
  const Eigen::ArrayXd t =
      Eigen::ArrayXd::LinSpaced(samples, 0.0, step * static_cast<double>(samples - 1));
  log.time = t;
  log.q.resize(samples, 2);
  log.qd.resize(samples, 2);
  log.q.col(0) = 1.1 * (0.9 * t).sin() + 0.4 * (2.3 * t).sin();
  log.qd.col(0) = 0.99 * (0.9 * t).cos() + 0.92 * (2.3 * t).cos();
  log.q.col(1) = 0.8 * (1.3 * t + 1.0).sin() + 0.5 * (3.1 * t).sin();
  log.qd.col(1) = 1.04 * (1.3 * t + 1.0).cos() + 1.55 * (3.1 * t).cos();
  return log;
}

inline diagnosis::Settings below_20_hz() {
  diagnosis::Settings settings;
  settings.band_hz = 20.0;
  return settings;
}

}  // namespace sinew::test
