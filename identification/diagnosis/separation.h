// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment that would tell apart what the logs cannot.
#pragma once

#include <functional>
#include <vector>

#include "identification/diagnosis/explanation.h"
#include "identification/diagnosis/planned_motion.h"

namespace sinew::diagnosis {

/// A planned experiment: what is played, and what a log of it would hold, all targets zero. An
/// arm's is large, so that it is made when it is asked for.
struct PlannedExperiment {
  PlannedMotion motion;
  std::function<Recording()> recording;
};

/// Experiments that a channel's causes may be told apart by.
using ExperimentPlanner = std::function<std::vector<PlannedExperiment>(int channel)>;

/// Gives every set of an explanation the experiment by which its first member, as it is fitted,
/// and the others differ most: what is left of the first one's effort on the planned motion after
/// everything else that is free is fitted to it, against the noise of these logs. Where no planned
/// motion tells them apart, or there is no planner, the isolating experiment of the first member
/// that has any. For the explanation that stands: an arm's planned motions take as long as a
/// search.
void propose_experiments(const Problem& problem, const Settings& settings,
                         const ExperimentPlanner& planner, Explanation& explanation);

}  // namespace sinew::diagnosis
