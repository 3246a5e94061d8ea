// SPDX-License-Identifier: GPL-3.0-or-later
// The search under every share of small errors, and how probable what it ends with is.
#pragma once

#include <optional>
#include <vector>

#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

/// What a search may take.
struct Allowed {
  int most = 0;                 ///< slots
  std::vector<bool> banned;     ///< of every hypothesis, whether it is left out
  std::optional<double> share;  ///< of small errors; empty: any
};

/// The least share of small errors that is tried, and the one in the middle. A search that ends
/// above the latter is done again: a measured drive ends poorly there, and a simulated one at
/// 0.0003 was told a second name when it was done again, too. No command calibrates it yet.
inline constexpr double kLeastShare = 1e-4, kMiddleShare = 1e-3;

/// Searches the moments of `found` at every share of small errors, or from its forms at the share
/// they were found at and those beside it that are more probable, and keeps the most probable: its
/// search, slots, share and evidence.
void grow_slots(const Allowed& allowed, FoundSlots& found);

/// Whether what one search has found is more probable than what another one has. Names may lack
/// against structure without a name what their forms are off by.
bool is_more_probable(const FoundSlots& one, const FoundSlots& other);

/// The slots with names alone, where those explain as much as structure without a name but for what
/// their forms are off by; the search knows of nothing else then.
void prefer_names(FoundSlots& found);

/// Grows, then searches from the slots' rivals, among names alone and, where structure without a
/// name explains more than their forms may be off by, among all.
void search_slots(const Allowed& allowed, FoundSlots& found);

}  // namespace sinew::diagnosis
