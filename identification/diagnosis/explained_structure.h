// SPDX-License-Identifier: GPL-3.0-or-later
// Changed deviations beside structure that has no name: which of them only stand in for it.
#pragma once

#include <vector>

#include "identification/diagnosis/unexplained.h"

namespace sinew::diagnosis {

struct ExplainedStructure {
  double named_share = 1.0;  ///< of all structure, what causes and deviations account for
  std::vector<int>
      displaced;  ///< deviations that unnamed structure takes over; empty where names hold
};

/// `adopted`: the state of select_deviations(). Losses are cross-validated, against the model with
/// every deviation at its nominal value and no cause.
ExplainedStructure explained_structure_of(const Design& design, const Settings& settings,
                                          const Selection& adopted, const Selection& selection,
                                          const Structure& structure);

}  // namespace sinew::diagnosis
