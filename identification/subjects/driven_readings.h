// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a driven mechanism's columns are what their names say: drives, joints, arms, and what
// tendons drive.
#pragma once

#include <filesystem>

#include "identification/logs/data_faults.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Finds a sign, a unit or a factor of one column or of all of a quantity, two columns that are
/// exchanged, or a clock, with which the efforts are what the model says, and not as the log is.
/// `recording`: a stretch of the log, as DrivenSubject reads it; `rigid`: null where the links are
/// not known one by one. Severity::stop; nothing where the log is likelier as it is. Throws
/// std::runtime_error where emitted C does not compile.
void judge_driven_columns(const Log& log, const DrivenColumns& columns, const Recording& recording,
                          const DrivenModel& model, const EffortModel& effort,
                          const RigidColumns* rigid, const std::filesystem::path& runtime,
                          FaultList& faults);

}  // namespace sinew::diagnosis
