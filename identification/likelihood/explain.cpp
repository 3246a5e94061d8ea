// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain.h"

#include "identification/diagnosis/explain_by_rules.h"
#include "identification/likelihood/explain_by_likelihood.h"

namespace sinew::diagnosis {

bool is_explained_by_likelihood(const Problem& problem, const Settings& settings) {
  return settings.by_likelihood && problem.noise_groups.empty();
}

Explanation explain(const Problem& problem, const Settings& settings) {
  return (is_explained_by_likelihood(problem, settings) ? explain_by_likelihood : explain_by_rules)(
      problem, settings);
}

}  // namespace sinew::diagnosis
