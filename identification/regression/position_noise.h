// SPDX-License-Identifier: GPL-3.0-or-later
// How far up a logged position shows motion, and where its noise begins.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/logs/filter.h"
#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// Highest frequencies [Hz] of the motion, of its third and higher derivatives, and of what is
/// certainly motion and not the noise of a sensor, for logs with that step [s].
double motion_cutoff(double step);
double slow_cutoff(double step);
double smooth_cutoff(double step);

/// True where all that is left of a joint's acceleration above the smooth motion is what the
/// position's noise at still higher frequencies makes of itself there. The recordings need the
/// signals "logged_q", "read_q" and "read_qdd" (the same, differentiated up to the motion's cutoff)
/// and "smooth_qdd".
bool noise_of_position(const std::vector<const Recording*>& logs, Eigen::Index joint);

/// The motion as it was read (signals "read_q", "read_qd", "read_qdd"), where the recording has
/// that beside the expected one: what firmware and simulation will see of the next log.
Motion motion_as_read(const Recording& log);

/// Share of the fourth derivative of a joint's position (signal "jounce") that is the position's
/// noise: 1 where the motion itself has none. `quantum`: step of the sensor, rad or m; 0 where none
/// is seen; `noisy`: noise_of_position().
double noise_of_jounce(const std::vector<const Recording*>& logs, Eigen::Index joint,
                       double quantum, bool noisy);

}  // namespace sinew::diagnosis
