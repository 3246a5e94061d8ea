// SPDX-License-Identifier: GPL-3.0-or-later
// Plain statistics between two channels, and a drive's effort explained by its motion.
#pragma once

#include <Eigen/Core>

namespace sinew {

double rms(const Eigen::ArrayXd& x);
Eigen::ArrayXd centred(const Eigen::ArrayXd& x);
/// 0 where one of the two does not change.
double correlation(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b);
/// Of y over x, least squares with an offset.
double slope(const Eigen::ArrayXd& y, const Eigen::ArrayXd& x);
/// Mean over 2 m + 1 samples; the result is 2 m shorter.
Eigen::ArrayXd moving_mean(const Eigen::ArrayXd& x, long m);

/// Samples m over which a second difference of x (period dt, white noise given) stands clear of
/// its noise.
long smoothing(double noise, const Eigen::ArrayXd& x, double dt);

// Position, velocity, acceleration and effort behind the same smoothing, at spread-out points.
struct DriveMotion {
  Eigen::ArrayXd position, velocity, acceleration, effort;
};

struct EffortFit {
  double inertia = 0.0, inertia_error = 1.0e300;
  double friction = 0.0;        // mean effort in the direction of motion
  double friction_share = 0.0;  // correlation of effort with the direction of motion
  double explained = 0.0;       // R^2
};

/// effort = inertia * acceleration + viscous * velocity + friction by direction + offset + a linear
/// term in the position; where the joint turns also sine and cosine of it (gravity).
EffortFit fit_effort(const DriveMotion& motion, bool turns);

}  // namespace sinew
