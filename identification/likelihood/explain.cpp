// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain.h"

#include "identification/diagnosis/explain_by_rules.h"
#include "identification/likelihood/explain_by_likelihood.h"

namespace sinew::diagnosis {

Explanation explain(const Problem& problem, const Settings& settings, const IsWanted& is_wanted,
                    const std::vector<SlotForm>& beginning) {
  if (!settings.by_likelihood) return explain_by_rules(problem, settings, is_wanted);
  Explanation explanation = explain_by_likelihood(problem, settings, beginning);
  if (is_wanted) is_wanted(explanation);
  return explanation;
}

}  // namespace sinew::diagnosis
