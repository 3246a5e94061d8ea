// SPDX-License-Identifier: GPL-3.0-or-later
// Changed levels beside structure that has no name: which of them only stand in for it.
#pragma once

#include <vector>

#include "identification/diagnosis/unexplained.h"

namespace sinew::diagnosis {

struct NamesBeside {
  double named_share = 1.0;   ///< of all structure, what causes and levels account for
  std::vector<int> stand_in;  ///< levels that unnamed structure takes over; empty where names hold
};

/// `adopted`: the state of restrict_to_levels(). Losses are cross-validated, against the model with
/// every level at its nominal value and no cause.
NamesBeside names_beside(const Design& design, const Settings& settings, const Selection& adopted,
                         const Selection& selection, const Structure& structure);

}  // namespace sinew::diagnosis
