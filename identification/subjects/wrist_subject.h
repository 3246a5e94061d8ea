// SPDX-License-Identifier: GPL-3.0-or-later
// A wrist-coupling log as a subject of a diagnosis: the wrist moves, motors keep the tendons'
// force.
#pragma once

#include <vector>

#include "identification/subjects/observed_rig.h"
#include "symbolic/extension/wrist_observation.h"

namespace sinew::diagnosis {

/// `tendons`: those whose motors are logged, from 1; their angles have a zero of their own in every
/// log. Throws std::invalid_argument where there is none.
ObservedRig wrist_rig(const WristParameters& wrist, const std::string& model,
                      const std::vector<int>& tendons);

}  // namespace sinew::diagnosis
