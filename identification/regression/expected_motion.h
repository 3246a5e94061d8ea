// SPDX-License-Identifier: GPL-3.0-or-later
// Where a joint was, given what its sensor said: regressors made of a noisy reading are too large
// by its noise, and what is fitted with them is too small.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Share of the energy of a reading that is motion, at frequencies 0 ... half the sampling rate,
/// `bins` of them: 1 - noise / energy, the noise being white and as large as what is left from
/// `quiet_from` [Hz] on, where nothing moves. It never grows again once it has fallen below a half,
/// nor falls before, and takes 4 Hz to fall. 1 everywhere where the log is too short to tell.
Eigen::VectorXd share_of_motion(const Eigen::VectorXd& reading, double step, double quiet_from,
                                Eigen::Index bins);

/// The expected position of every axis given its readings (Wiener's filter, zero-phase; a
/// regression on it is calibrated). Both samples x axes; at the ends the reading is continued by
/// point reflection.
Eigen::MatrixXd expected_position(const Eigen::MatrixXd& reading, double step, double quiet_from);

}  // namespace sinew::diagnosis
