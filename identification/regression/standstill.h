// SPDX-License-Identifier: GPL-3.0-or-later
// Standstill, for long or for a moment between two directions: friction is then whatever holds the
// joint, and a log cannot tell by which law.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

using Flags = Eigen::ArrayX<bool>;  ///< one of each sample

/// When a joint, or a tendon in its guide, does not move.
struct Stillness {
  Flags rests, reversals;
};

/// It rests, with the way into and out of it, where one of its velocities, differently smoothed and
/// `step` [s] apart, is next to zero for longer than any reversal takes. It reverses where the
/// first of them changes sign: over the time that its smoother, which passes what is below `cutoff`
/// [Hz], spreads it. still: speed that is rest even where it was never fast.
Stillness find_stillness(const std::vector<Eigen::VectorXd>& velocities, double step, double cutoff,
                         double still = 0.0);

/// Stretches of a log, with its times [s], in which one of the parts that act on a joint does not
/// move: the joint itself comes first. Reversals that would leave little of the log are not counted;
/// rests are, however much of it they are.
std::vector<Standstill> find_standstills(const std::vector<Stillness>& parts,
                                         const Eigen::VectorXd& time);

/// 1 in motion, 0 at standstill, with smooth flanks between, at the times [s].
Eigen::VectorXd motion_window(const std::vector<Standstill>& stretches,
                              const Eigen::VectorXd& time);

}  // namespace sinew::diagnosis
