// SPDX-License-Identifier: GPL-3.0-or-later
// What the search may add to a model.
#pragma once

#include <vector>

#include "identification/likelihood/bayes_factor.h"
#include "identification/likelihood/moments.h"

namespace sinew::diagnosis {

/// A column of structure without a name, and its share of that structure's variance.
struct Kin {
  Eigen::Index column = 0;
  double share = 1.0;
};

/// One way a hypothesis enters a model: a shape, or two neighbouring ones for all between them.
struct Entry {
  int hypothesis = 0;
  std::vector<int> shapes;
  std::vector<Eigen::Index> columns;
  double log_prior = 0.0;  ///< its part of its hypothesis' log prior odds
  ConditionalMoments alone;
  /// The unnamed structure that its form is a part of: no cause has exactly the form that the
  /// library gives it. Empty: it is no part of any.
  std::vector<Kin> kin;
};

/// Every shape of every hypothesis, and every two neighbouring ones; of a hypothesis' prior each
/// has the same part. `banned`: hypotheses that have none.
std::vector<Entry> make_entries(const Hypotheses& all, const SmallErrors& errors,
                                const std::vector<bool>& banned);

}  // namespace sinew::diagnosis
