// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that tendons drive: which force, motor angle and motor torque is which, in which unit and
// with which sign, told by the model.
#pragma once

#include <filesystem>

#include "identification/logs/data_faults.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Looks for one exchange of two columns, one reversed sign or one wrong unit with which the forces
/// give the joints the torques of the model, or a motor the effort of the model, and without which
/// they do not. `recording`: a stretch of `log` as DrivenSubject::add_log() makes it, with signals
/// "tension" and "moment_arm"; `model` has tendons; `runtime`: folder of the runtime's headers. The
/// fault goes to `faults` as a stop.
void judge_tendons(const Log& log, const DrivenColumns& columns, const Recording& recording,
                   const DrivenModel& model, const EffortModel& effort,
                   const std::filesystem::path& runtime, FaultList& faults);

}  // namespace sinew::diagnosis
