// SPDX-License-Identifier: GPL-3.0-or-later
// Slips of units that all joints of a robot have in common: of every effort, and of the clock.
#pragma once

#include "identification/logs/data_faults.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// What the weights of the links ask for shows the unit of the efforts, what their inertia asks for
/// beside that the unit of time: the same factor at two joints or more, and nothing else, is a
/// slip, of this log or of the model. Rotors and friction are each joint's own and free.
void judge_common_factors(const Log& log, const DrivenColumns& columns, const Recording& recording,
                          const EffortModel& model, FaultList& faults);

}  // namespace sinew::diagnosis
