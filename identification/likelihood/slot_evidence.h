// SPDX-License-Identifier: GPL-3.0-or-later
// The search under every share of small errors, and how probable what it ends with is.
#pragma once

#include <vector>

#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

/// Searches the moments of `found` at every share of small errors, or from its forms at the share
/// they were found at and those beside it that are more probable, and keeps the most probable: its
/// search, slots, share and evidence. `most`: slots at most; `banned`: of every hypothesis, whether
/// it is left out.
void grow_slots(int most, const std::vector<bool>& banned, FoundSlots& found);

/// Then from the slots' rivals, and with names alone where they explain as much but for what their
/// forms are off by.
void search_slots(int most, const std::vector<bool>& banned, FoundSlots& found);

}  // namespace sinew::diagnosis
