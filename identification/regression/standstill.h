// SPDX-License-Identifier: GPL-3.0-or-later
// Standstill, for long or for a moment between two directions: friction is then whatever holds the
// joint, and a log cannot tell by which law.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// Stretches of a log [s] in which a joint does not move. It rests, with the way into and out of
/// it, where one of its velocities, differently smoothed and as long as `time`, is next to zero for
/// longer than any reversal takes. It reverses where the first of them changes sign: over the time
/// that its smoother, which passes what is below `cutoff` [Hz], spreads it. Reversals are left out,
/// and then the rests, where next to nothing would be left of the log. still: speed that is rest
/// even where the joint was never fast.
std::vector<Standstill> find_standstills(const Eigen::VectorXd& time,
                                         const std::vector<Eigen::VectorXd>& velocities,
                                         double cutoff, double still = 0.0);

/// Both together; the first ones alone, where next to nothing would be left of the log.
std::vector<Standstill> united(const std::vector<Standstill>& first,
                               const std::vector<Standstill>& second, const Eigen::VectorXd& time);

/// 1 in motion, 0 at standstill, with smooth flanks between, at the times [s].
Eigen::VectorXd motion_window(const std::vector<Standstill>& stretches,
                              const Eigen::VectorXd& time);

}  // namespace sinew::diagnosis
