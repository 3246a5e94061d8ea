// SPDX-License-Identifier: GPL-3.0-or-later
// The noise that a search begins with.
#pragma once

#include <vector>

#include "identification/likelihood/shaped_search.h"

namespace sinew::diagnosis {

/// Beside a fit of everything too little is left of the noise where that takes all rows of a
/// frequency; beside the model alone all that is hidden counts as noise. The more probable one of
/// where the two lead, asked anew in every channel in which one of them has found nothing.
void first_noise(const Searched& s, FoundSlots& found);

/// The noise beside what another search has found.
void noise_beside(const std::vector<SlotForm>& forms, const Searched& s, FoundSlots& found);

}  // namespace sinew::diagnosis
