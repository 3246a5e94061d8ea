// SPDX-License-Identifier: GPL-3.0-or-later
// The play of a position sensor shows at its own joint where its reading stands still, and there
// alone.
#pragma once

#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Whether one of the candidates `plays` (indices of the library) takes away a good part of what
/// is left at one of its channels, rests and reversals counted in (`design`), beside the baseline
/// or beside all that was found without them (`found`, of another design of the same logs). Where
/// none does, a search with rests and reversals would find no play either.
bool may_have_play(const Design& design, const Model& found, const std::vector<int>& plays);

}  // namespace sinew::diagnosis
