// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of what a search has found, fitted between the points of their grids.
#pragma once

#include <vector>

#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

/// The model with a term for every slot, its shapes fitted together. Delays come last: their column
/// is the rate of all else. The slots' forms are what the next search begins from.
void fit_shapes(const Design& design, FoundSlots& found);

/// The model with a term for every form of another search whose hypothesis is there, likewise.
void fit_forms(const Design& design, const std::vector<SlotForm>& forms, FoundSlots& found);

/// Fitted shapes that are no grid points become shapes of their hypotheses, and those that stand
/// for all places of one make are the laws of what was found.
void add_fitted_shapes(const Design& design, FoundSlots& found);

/// Hypotheses whose fitted terms lie beyond their limits are not taken again. False: there are
/// none.
bool ban_impossible(const Design& design, const FoundSlots& found, std::vector<bool>& banned);

}  // namespace sinew::diagnosis
