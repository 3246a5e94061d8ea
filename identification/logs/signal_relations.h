// SPDX-License-Identifier: GPL-3.0-or-later
// Plain statistics between two channels.
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

}  // namespace sinew
