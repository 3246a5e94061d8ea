// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a search in which the shapes of what is found are fitted between the grid's points.
#pragma once

#include <vector>

#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/slot_evidence.h"

namespace sinew::diagnosis {

/// What a search is about, beside what it finds.
struct Searched {
  const Design& design;
  Eigen::VectorXd floor;  ///< per channel, the variance of a sample that is not material
  Allowed allowed;
  int bans = 0;
};

/// The channel that a form acts on; -1: several.
int channel_of(const Design& design, const FoundSlots& found, const SlotForm& form);

/// The products under the noise.
void make_moments(const Design& design, FoundSlots& found);

/// Grown under that noise from the forms so far.
void search_under(Whitening noise, const Searched& s, FoundSlots& found);

/// Grown from the forms so far under the present noise, names before structure.
void grow_with_shapes(const Searched& s, FoundSlots& found);

/// Searched from rivals, too. What cannot be by the fit of its shape is banned, and the search is
/// done again.
void search_with_shapes(Searched& s, FoundSlots& found);

}  // namespace sinew::diagnosis
