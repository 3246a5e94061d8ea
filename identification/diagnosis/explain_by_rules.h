// SPDX-License-Identifier: GPL-3.0-or-later
// From recordings and candidates to a verdict, by screening, selection and the rules that grew
// around them.
#pragma once

#include "identification/diagnosis/explanation.h"

namespace sinew::diagnosis {

/// As explain() in likelihood/explain.h.
Explanation explain_by_rules(const Problem& problem, const Settings& settings,
                             const IsWanted& is_wanted = {});

}  // namespace sinew::diagnosis
