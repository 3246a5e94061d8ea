// SPDX-License-Identifier: GPL-3.0-or-later
// A single joint or drive: the unit of its position, effort, load and time, told by the model.
#pragma once

#include "identification/logs/data_faults.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Looks for one wrong unit (degrees, turns, thousandths, the motor's side of the gear) with which
/// the model explains nearly all of the measured effort, where it explains little of it as it
/// stands. `recording`: a stretch of `log`; `joint`: the only one of the model. The fault goes to
/// `faults`: a stop where no joint lacks as much, doubtful where one may. Where it is none of
/// those: for another factor of the logged load than 1, and for a clock with which the model
/// explains nearly all and which no single value of the model stands for; both stop. Does nothing
/// for several coordinates: judge_efforts() looks at those.
void judge_lone_effort(const Log& log, const DrivenColumns& columns, const Recording& recording,
                       const EffortModel& model, const DrivenJoint& joint, FaultList& faults);

}  // namespace sinew::diagnosis
