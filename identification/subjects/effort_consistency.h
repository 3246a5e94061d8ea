// SPDX-License-Identifier: GPL-3.0-or-later
// Coupled coordinates: which column is which, in which unit and with which sign, told by the model.
// One joint's effort against its own motion tells nothing there: gravity and the other joints move
// it, and may brake it all the time.
#pragma once

#include "identification/logs/data_faults.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Looks for one exchange of two columns, one reversed sign or one wrong unit without which the
/// model's efforts do not fit the measured ones at all and with which they do. `recording`: a
/// stretch of `log` (q, qd, qdd of every coordinate, `target`: the measured efforts). Judged are
/// the coordinates with an effort of their own, the last ones; the fault goes to `faults` as a
/// stop. Does nothing for a single coordinate: judge_consistency() looks at that.
void judge_efforts(const Log& log, const DrivenColumns& columns, const Recording& recording,
                   const EffortModel& model, FaultList& faults);

}  // namespace sinew::diagnosis
