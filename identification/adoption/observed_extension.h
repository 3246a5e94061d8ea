// SPDX-License-Identifier: GPL-3.0-or-later
// From a verdict on a rig's sensors to entries of identified.toml, and what they gain.
#pragma once

#include <vector>

#include "identification/diagnosis/explanation.h"
#include "identification/adoption/measure.h"
#include "identification/subjects/observed_subject.h"

namespace sinew::diagnosis {

/// What the observation has learnt with the verdict's causes: deviations and shapes fitted together
/// to the training logs, starting from the search's linear estimates.
Identified extended_observation(const ObservedSubject& subject, const Design& design,
                                const Explanation& explanation);

/// Every channel of every log through the C of what was known before and of `after`. free_zero: a
/// channel's mean error in a log counts as its zero.
std::vector<MeasuredChannel> measure_observation(const ObservedSubject& subject,
                                                 const Design& design, const Identified& after,
                                                 bool free_zero);

/// Operations of the emitted observation.
int observation_operations(const ObservedSubject& subject, const Identified& identified);

}  // namespace sinew::diagnosis
