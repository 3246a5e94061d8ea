// SPDX-License-Identifier: GPL-3.0-or-later
// What a search has found, for another search to begin from.
#pragma once

#include <vector>

#include "identification/diagnosis/slot_form.h"
#include "identification/likelihood/slot_search.h"

namespace sinew::diagnosis {

/// The index of a form's hypothesis; -1: there is none.
int hypothesis_of(const Hypotheses& all, const SlotForm& form);

/// `terms`: the fitted term of every slot, in their order.
std::vector<SlotForm> slot_forms(const Hypotheses& all, const SlotSearch& search,
                                 const Slots& slots, const std::vector<Term>& terms);

/// Each form at the nearest shape that the search has of its hypothesis. A form whose hypothesis is
/// not there, or is not to be taken, is left out.
Slots slots_of_forms(const Hypotheses& all, const SlotSearch& search,
                     const std::vector<SlotForm>& forms);

}  // namespace sinew::diagnosis
