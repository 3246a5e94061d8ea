// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the model's own values: the sparsest set of parameter deviations that explains how the
// fitted baseline differs from its nominal values.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/select.h"

namespace sinew::diagnosis {

/// The final model with every covered baseline coefficient at its nominal value, and what moves it.
struct DeviationSelection {
  Selection state;  ///< its model's last terms are the named deviations; evidence as in select.h
  std::vector<Refusal> refused;  ///< candidate: -1 - deviation
  std::vector<double> p_family;  ///< per deviation, on top of the named ones
  std::vector<double> statistic;
};

/// `selection` with its baseline held at the nominal values and deviations found by search:
/// minimises whitened deviance + price * effective parameters over sets of at most
/// Settings::most_deviations deviations (or three a channel, up to 24, or one) whose changes lie
/// within their limits. Each deviation must beat surrogates (Bonferroni over all deviations), gain
/// Settings::least_of_baseline of the nominal residual's energy on left-out blocks or plainly a
/// tenth of what all others leave over, gain on held-out logs (or be plain in the training logs:
/// verdict.h), and not be undone by others of its set. Throws std::invalid_argument where a share
/// points to no baseline coefficient or to one per log. Deviations in `withdrawn` are not taken.
DeviationSelection select_deviations(const Design& design, const Settings& settings,
                                     const Selection& selection,
                                     const std::vector<int>& withdrawn = {});

}  // namespace sinew::diagnosis
