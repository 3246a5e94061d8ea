// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration rig of a lever and its tendon as a subject of a diagnosis.
#pragma once

#include "identification/subjects/observed_rig.h"
#include "symbolic/extension/lever_observation.h"

namespace sinew::diagnosis {

/// Channels of a log: count, force and, where logged, elongation and bend (total bending angle
/// between lever and load cell). `with_elongation`: the logs have it.
ObservedRig lever_rig(const LeverRig& rig, const std::string& model, bool with_elongation);

}  // namespace sinew::diagnosis
