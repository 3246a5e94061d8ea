// SPDX-License-Identifier: GPL-3.0-or-later
// The motion that a model predicts from the measured efforts, as the simulation integrates its
// emitted C: over short windows, and in open loop over a whole log.
#pragma once

#include <vector>

#include "identification/report/findings.h"
#include "identification/subjects/driven_subject.h"
#include "simulation/plant/plant.h"

namespace sinew::diagnosis {

/// Squared error of the predicted position, mean over each stretch: stretches x joints [rad^2,
/// m^2]. A stretch where the prediction leaves all bounds is infinite.
using StretchErrors = Eigen::MatrixXd;

/// s: longer than a delay, shorter than a controller's way back.
inline constexpr double prediction_window = 0.05;
/// Windows of a log; of joints on tendons, whose steps take long.
inline constexpr int effort_windows = 120, tendon_windows = 40;

/// From the measured state at the beginning of each of `stretches` windows spread over the log, for
/// `seconds`, under the measured efforts.
StretchErrors window_errors(const EffortModel& model, const Recording& log, double seconds,
                            int stretches);

/// From the log's start to its end, in `stretches` parts.
StretchErrors open_loop_errors(const EffortModel& model, const Recording& log, int stretches);

/// The same of any plant with drives whose first coordinates are the recording's, and whose
/// commands are the log's efforts over the time since its start, in fixed steps of the log's.
StretchErrors window_errors(Plant& plant, const Recording& log, double seconds, int stretches);
StretchErrors open_loop_errors(Plant& plant, const Recording& log, int stretches);

/// Adds the domains "window" and "open loop" to the findings of all channels, over the held-out
/// logs or, where there are none, the training logs. Joints on tendons have no open loop: under
/// given forces a finger does not stay where it is.
void add_predictions(const DrivenSubject& subject, const EffortModel& after,
                     std::vector<ChannelFinding>& channels);

}  // namespace sinew::diagnosis
