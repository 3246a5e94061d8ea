// SPDX-License-Identifier: GPL-3.0-or-later
// From recordings and candidates to a verdict.
#pragma once

#include "identification/diagnosis/select.h"
#include "identification/diagnosis/separation.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// The verdict and the fitted model it stands for.
struct Explanation {
  Verdict verdict;
  Selection selection;
  /// Parameters of every term of the selection's model.
  std::vector<std::vector<ParameterEstimate>> estimates;
  /// Where the problem has deviations: the model the verdict's errors and gains stand for, with the
  /// baseline at its nominal values but for the named deviations, whose terms come last.
  Selection adopted;
};

/// Names what the baseline leaves over. `planner` (may be empty): what the separating experiment is
/// chosen from; without it a candidate's isolating experiment is proposed.
/// Deterministic for given settings. Throws std::invalid_argument where no log is long enough.
Explanation explain(const Problem& problem, const Settings& settings,
                    const ExperimentPlanner& planner = {});

}  // namespace sinew::diagnosis
