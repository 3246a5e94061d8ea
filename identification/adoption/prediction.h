// SPDX-License-Identifier: GPL-3.0-or-later
// The motion that a model predicts from the measured efforts, through its emitted C: over short
// windows, and in open loop over a whole log.
#pragma once

#include <vector>

#include "identification/subjects/driven_subject.h"
#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// Squared error of the predicted position, mean over each stretch: stretches x joints [rad^2,
/// m^2]. A stretch where the prediction leaves all bounds is infinite.
using StretchErrors = Eigen::MatrixXd;

/// From the measured state at the beginning of each of `stretches` windows spread over the log, for
/// `seconds`, under the measured efforts.
StretchErrors window_errors(const EffortModel& model, const Recording& log, double seconds,
                            int stretches);

/// From the log's start to its end, in `stretches` parts.
StretchErrors open_loop_errors(const EffortModel& model, const Recording& log, int stretches);

/// Adds the domains "window" and "open loop" to the findings of all channels, over the held-out
/// logs or, where there are none, the training logs. Joints on tendons have neither: what moves
/// them is not an effort of theirs.
void add_predictions(const DrivenSubject& subject, const EffortModel& after,
                     std::vector<ChannelFinding>& channels);

}  // namespace sinew::diagnosis
