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

/// The slots with names alone, where those explain as much as structure without a name but for what
/// their forms are off by; the search knows of nothing else then.
void prefer_names(FoundSlots& found);

/// Grows, then searches from the slots' rivals, among names alone and, where structure without a
/// name explains more than their forms may be off by, among all.
void search_slots(int most, const std::vector<bool>& banned, FoundSlots& found);

}  // namespace sinew::diagnosis
