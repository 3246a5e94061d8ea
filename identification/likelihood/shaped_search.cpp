// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/shaped_search.h"

#include <utility>

#include "identification/likelihood/fitted_shapes.h"
#include "identification/likelihood/slot_evidence.h"

namespace sinew::diagnosis {

int channel_of(const Design& design, const FoundSlots& found, const SlotForm& form) {
  const Hypothesis& h = found.all.list[static_cast<std::size_t>(hypothesis_of(found.all, form))];
  const auto& columns = found.all.shapes[static_cast<std::size_t>(h.shapes.front())].columns;
  int channel = -1;
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    if (columns[i].cols() == 0 || columns[i].isZero(0.0)) continue;
    const int other = design.segments()[i].channel;
    if (channel >= 0 && other != channel) return -1;
    channel = other;
  }
  return channel;
}

void make_moments(const Design& design, FoundSlots& found) {
  // Those before go first: of an arm of seven joints they take a quarter of a gigabyte.
  found.moments = {};
  found.moments = moments_of(design, found.all, found.whitening);
}

void search_under(Whitening noise, const Searched& s, FoundSlots& found) {
  found.whitening = std::move(noise);
  make_moments(s.design, found);
  grow_slots(s.allowed, found);
  fit_shapes(s.design, found);
}

void grow_with_shapes(const Searched& s, FoundSlots& found) {
  grow_slots(s.allowed, found);
  prefer_names(found);
  fit_shapes(s.design, found);
}

void search_with_shapes(Searched& s, FoundSlots& found) {
  constexpr int most_bans = 6;
  for (;;) {
    search_slots(s.allowed, found);
    fit_shapes(s.design, found);
    bool again = false;
    while (s.bans < most_bans && ban_impossible(s.design, found, s.allowed.banned)) {
      ++s.bans;
      again = true;
      grow_with_shapes(s, found);
    }
    if (!again) return;
  }
}

}  // namespace sinew::diagnosis
