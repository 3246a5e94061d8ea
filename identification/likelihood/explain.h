// SPDX-License-Identifier: GPL-3.0-or-later
// From recordings and candidates to a verdict, by one likelihood and one search.
#pragma once

#include "identification/diagnosis/explanation.h"

namespace sinew::diagnosis {

/// Names what the baseline leaves over: the set of hypotheses with the largest posterior odds under
/// one likelihood of the whitened logs, small errors in everything included. What would settle its
/// sets is proposed afterwards (propose_experiments, diagnosis/separation.h). Deterministic for
/// given settings. Throws std::invalid_argument where no log is long enough. `beginning`: forms of
/// an explanation of nearly the same logs, which is quicker than from nothing.
Explanation explain(const Problem& problem, const Settings& settings,
                    const std::vector<SlotForm>& beginning = {});

/// Its selection, structure and forms alone, by a search that leaves rivals out: what nearly the
/// same logs leave over, in a small part of the time.
Explanation explain_roughly(const Problem& problem, const Settings& settings,
                            const std::vector<SlotForm>& beginning);

}  // namespace sinew::diagnosis
