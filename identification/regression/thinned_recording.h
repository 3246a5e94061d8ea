// SPDX-License-Identifier: GPL-3.0-or-later
// A recording at the rate that its comparison needs.
#pragma once

#include "identification/logs/filter.h"
#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// Highest frequency [Hz] that is told from any channel of the recording.
double highest_compared(const Recording& log, const Settings& settings);

/// Keeps every n-th sample of a recording with that step [s] of which all below `band_hz` is
/// compared; factor 1 where it is not sampled fast enough to be worth it. Six samples a period are
/// kept of the highest frequency compared and of the fastest motion (motion_cutoff()), so that of
/// what products of the motion and turns of friction have above the new rate little folds back.
DecimatingFilter thinning_filter(double step, double band_hz);

/// Every signal, target and known part behind the same zero-phase filter, samples at its instants.
/// Without the signal "effort_of_logged_motion", which filtered would be no effort of its motion.
Recording thinned(const Recording& log, const DecimatingFilter& filter);

}  // namespace sinew::diagnosis
