// SPDX-License-Identifier: GPL-3.0-or-later
// The one zero-phase filter that target and regressors share, and the derivative smoother.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Symmetric windowed-sinc (Kaiser, 60 dB) low-pass followed by keeping every factor-th sample.
/// Flat to band_hz = 0.4 of the new rate, stopped from 0.6 on, so nothing folds into the band.
struct DecimatingFilter {
  double step = 0.0;            ///< s, of the input
  int factor = 1;               ///< output rate = 1 / (factor * step)
  double band_hz = 0.0;         ///< what is kept
  Eigen::Index half_width = 0;  ///< input samples on each side of the kernel's centre
  Eigen::VectorXd value, rate;  ///< kernels of the filtered signal and of its time derivative
};

/// Filter that keeps at least `band_hz` of a signal sampled at `step`.
DecimatingFilter design_decimating_filter(double step, double band_hz);

/// Number of outputs for an input of that many samples: only where the kernel fits, then cut to a
/// length without prime factors above 5 (fast to transform). 0 where the log is too short.
Eigen::Index filtered_length(const DecimatingFilter& filter, Eigen::Index samples);

/// Filters every column of x. Output k is centred on input sample half_width + k * factor, moved
/// by `advance` seconds (output = x at that later time, |advance| small against the kernel).
/// derivative = 1 gives the time derivative of the filtered signal.
Eigen::MatrixXd filter_decimate(const DecimatingFilter& filter, const Eigen::MatrixXd& x,
                                double advance = 0.0, int derivative = 0);

/// Input sample on which output k is centred.
Eigen::Index centre_sample(const DecimatingFilter& filter, Eigen::Index k);

/// Position, velocity and acceleration of a measured position, same length and rate.
struct Motion {
  Eigen::MatrixXd q, qd, qdd;
};

/// Zero-phase derivative smoother: position is convolved with a Blackman-windowed sinc that passes
/// everything below cutoff_hz and with that kernel's first and second derivative. At the ends
/// the position is continued by point reflection, as often as a short log takes. position: samples,
/// 2 at least, x axes. Throws std::invalid_argument.
Motion differentiate(const Eigen::MatrixXd& position, double step, double cutoff_hz);

}  // namespace sinew::diagnosis
