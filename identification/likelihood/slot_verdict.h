// SPDX-License-Identifier: GPL-3.0-or-later
// What the slots that were found say, in the words of a verdict: nothing here asks the logs.
#pragma once

#include <vector>

#include "identification/diagnosis/verdict.h"
#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

/// What a slot holds.
const Hypothesis& hypothesis_of(const FoundSlots& found, std::size_t slot);

/// Of every slot the named members of its credible set, most probable first; without members where
/// no name is among them. Parameters and gains are left open.
std::vector<NamedCause> name_slots(const FoundSlots& found);

/// Whether nothing in a slot's place is ruled out.
bool is_told(const FoundSlots& found, std::size_t slot);

/// Slots that are sure and hold no name.
void tell_unnamed(const FoundSlots& found, Unexplained& said);

}  // namespace sinew::diagnosis
