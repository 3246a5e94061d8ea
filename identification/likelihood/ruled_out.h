// SPDX-License-Identifier: GPL-3.0-or-later
// Why names were not taken.
#pragma once

#include "identification/diagnosis/verdict.h"
#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

/// Names and decoys that no cause of the verdict has as a member, whatever their forms, and why:
/// most probable ones first, those last that the logs say nothing of.
void list_ruled_out(const FoundSlots& found, Verdict& verdict);

}  // namespace sinew::diagnosis
