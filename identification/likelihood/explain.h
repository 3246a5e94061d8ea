// SPDX-License-Identifier: GPL-3.0-or-later
// From recordings and candidates to a verdict.
#pragma once

#include "identification/diagnosis/explanation.h"

namespace sinew::diagnosis {

/// Names what the baseline leaves over, by the rules (explain_by_rules.h) or, where the settings
/// ask for it, by one likelihood (explain_by_likelihood.h). What would settle its sets is proposed
/// afterwards (propose_experiments, diagnosis/separation.h). Deterministic for given settings.
/// Throws std::invalid_argument where no log is long enough. `is_wanted`: whether more than the
/// selection is (explanation.h); the likelihood has all of it at once.
/// `beginning`: forms of an explanation of nearly the same logs, which is quicker than from
/// nothing; the rules know of none.
Explanation explain(const Problem& problem, const Settings& settings,
                    const IsWanted& is_wanted = {}, const std::vector<SlotForm>& beginning = {});

}  // namespace sinew::diagnosis
