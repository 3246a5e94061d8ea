// SPDX-License-Identifier: GPL-3.0-or-later
// An external force or contact that no log has: whether there was one, where, and how large.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/contacts/force_fit.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// What explains the same logs otherwise, the disturbed stretches with them.
struct Alternative {
  const FitInTime& fit;
  double numbers = 0.0;  ///< of its causes
};

/// Where a force at one of the places, beside causes with so many `numbers`, explains the logs
/// better than the alternative does: the cause to be told, with a parameter for each disturbance's
/// peak. By the probability of what is left over, all that any channel may be off by included: the
/// force's course by evidence, other numbers by Bayes' information criterion.
/// `disturbances`: as those causes leave them over; `names`: of the recordings; `material_share`:
/// force_noise().
std::optional<NamedCause> find_unlogged_force(const Alternative& alternative, double numbers,
                                              const Disturbances& disturbances,
                                              const std::vector<ForcePlace>& places,
                                              const std::vector<std::string>& names,
                                              const Settings& settings);

/// Per recording the disturbed stretches of its time [s].
std::vector<std::vector<Standstill>> stretches_in_time(const Disturbances& disturbances);

}  // namespace sinew::diagnosis
