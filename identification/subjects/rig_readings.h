// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a rig's columns are what their names say: each way in which one may have been logged
// otherwise is a hypothesis, and competes with what the rig itself may have wrong.
#pragma once

#include "identification/logs/data_faults.h"
#include "identification/subjects/observed_rig.h"

namespace sinew::diagnosis {

/// Finds a sign, a unit or a factor of one column, or two columns that are exchanged, with which
/// the model says what the sensors read, and not as the log is. Severity::stop; nothing where the
/// log is likelier as it is.
void judge_rig_columns(const Log& log, const ObservedRig& rig, const ObservedSubject& subject,
                       FaultList& faults);

}  // namespace sinew::diagnosis
