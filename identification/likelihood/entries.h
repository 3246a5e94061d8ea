// SPDX-License-Identifier: GPL-3.0-or-later
// What the search may add to a model.
#pragma once

#include <vector>

#include "identification/likelihood/bayes_factor.h"
#include "identification/likelihood/small_errors.h"

namespace sinew::diagnosis {

/// One way a hypothesis enters a model: a shape, or two neighbouring ones for all between them.
struct Entry {
  int hypothesis = 0;
  std::vector<int> shapes;
  std::vector<Eigen::Index> columns;
  double log_prior = 0.0;  ///< its part of its hypothesis' log prior odds
  ConditionalMoments alone;
};

/// Every shape of every hypothesis, and every two neighbouring ones; of a hypothesis' prior each
/// has the same part. `banned`: hypotheses that have none.
std::vector<Entry> make_entries(const Hypotheses& all, const SmallErrors& errors,
                                const std::vector<bool>& banned);

}  // namespace sinew::diagnosis
