// SPDX-License-Identifier: GPL-3.0-or-later
// A factor or a sign of one effort's or one force's column alone. A model lacks one thing or
// another; that everything it says of a channel is off by the same factor, and of no other channel,
// is the column's.
#pragma once

#include "identification/logs/data_faults.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Joints with an effort of their own: the measured effort is compared with the model's weight,
/// with its inertia and with what depends on the speed, each by a factor of its own. Where two of
/// them at least are told, and all that are told agree on a factor beyond any that a machine is off
/// by, it is a stop in `faults`. `recording`: a stretch of `log`.
void judge_effort_factors(const Log& log, const DrivenColumns& columns, const Recording& recording,
                          const EffortModel& model, FaultList& faults);

/// Joints on tendons: the forces' torques, each force with a factor of its own, are compared with
/// what the model asks for, beside what each joint may have of its own. `recording` has signals
/// "tension" (samples x tendons, N) and "moment_arm" (samples x tendons·joints, m). One force whose
/// factor is told and beyond any that a machine is off by, all others being right, is a stop.
void judge_force_factors(const Log& log, const DrivenColumns& columns, const Recording& recording,
                         const DrivenModel& model, const EffortModel& effort, FaultList& faults);

}  // namespace sinew::diagnosis
