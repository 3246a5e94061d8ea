// SPDX-License-Identifier: GPL-3.0-or-later
// From recordings and candidates to a verdict, by one likelihood and one search.
#pragma once

#include "identification/diagnosis/explanation.h"

namespace sinew::diagnosis {

/// As explain() (explain.h): the set of hypotheses with the largest posterior odds under one
/// likelihood of the whitened logs, small errors in everything included.
Explanation explain_by_likelihood(const Problem& problem, const Settings& settings,
                                  const std::vector<SlotForm>& beginning = {});

}  // namespace sinew::diagnosis
