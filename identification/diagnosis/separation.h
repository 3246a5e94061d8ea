// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment that would tell apart what the logs cannot.
#pragma once

#include <functional>
#include <vector>

#include "identification/diagnosis/planned_motion.h"
#include "identification/diagnosis/select.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// A planned experiment: what is played, and what a log of it would hold, all targets zero. An
/// arm's is large, so that it is made when it is asked for.
struct PlannedExperiment {
  PlannedMotion motion;
  std::function<Recording()> recording;
};

/// Experiments that a channel's causes may be told apart by.
using ExperimentPlanner = std::function<const std::vector<PlannedExperiment>&(int channel)>;

/// The experiment by which the first of `members`, as it is fitted in term `term` of `state`, and
/// the others differ most: what is left of the first one's effort on the planned motion after
/// everything else that is free is fitted to it, against the noise of these logs. `found`: the
/// selection that the nonlinear parameters of the baseline are taken from. Where no planned motion
/// tells them apart, the isolating experiment of the first one that has any.
Separation separate(const Design& design, const Settings& settings, const Selection& found,
                    const Selection& state, std::size_t term,
                    const std::vector<RankedCause>& members, const ExperimentPlanner& planner);

}  // namespace sinew::diagnosis
