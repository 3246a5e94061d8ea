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
  grow_slots(s.most, s.banned, found);
  fit_shapes(s.design, found);
}

void grow_with_shapes(const Searched& s, FoundSlots& found) {
  grow_slots(s.most, s.banned, found);
  prefer_names(found);
  fit_shapes(s.design, found);
}

void search_with_shapes(Searched& s, FoundSlots& found) {
  constexpr int most_bans = 6;
  for (;;) {
    search_slots(s.most, s.banned, found);
    fit_shapes(s.design, found);
    bool again = false;
    while (s.bans < most_bans && ban_impossible(s.design, found, s.banned)) {
      ++s.bans;
      again = true;
      grow_with_shapes(s, found);
    }
    if (!again) return;
  }
}

namespace {

/// Whether a slot's shape can be fitted: it may stand for another one, too, in another shape.
bool has_shapes(const FoundSlots& found, const SlotForm& form) {
  const auto& all = found.all.list;
  return form.candidate >= 0 &&
         all[static_cast<std::size_t>(hypothesis_of(found.all, form))].shapes.size() > 1;
}

/// The forms without one, their shapes fitted again and added to those of their hypotheses.
std::vector<SlotForm> refitted_without(std::size_t left_out, const Searched& s, FoundSlots& found) {
  std::vector<SlotForm> fewer = found.forms;
  fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
  fit_forms(s.design, fewer, found);
  const std::size_t first = found.model.terms.size() - fewer.size();
  for (std::size_t k = 0; k < fewer.size(); ++k) {
    if (!has_shapes(found, fewer[k])) continue;
    fewer[k].nonlinear = found.model.terms[first + k].nonlinear;
    add_shape(s.design, hypothesis_of(found.all, fewer[k]), fewer[k].nonlinear, found.all);
  }
  return fewer;
}

/// Whether another slot, where that one acts, can take another shape.
bool others_can_follow(std::size_t slot, const Searched& s, const FoundSlots& found) {
  const int channel = channel_of(s.design, found, found.forms[slot]);
  for (std::size_t k = 0; k < found.forms.size(); ++k) {
    if (k == slot || !has_shapes(found, found.forms[k])) continue;
    const int other = channel_of(s.design, found, found.forms[k]);
    if (channel < 0 || other < 0 || other == channel) return true;
  }
  return false;
}

}  // namespace

bool fewer_with_shapes(const Searched& s, FoundSlots& found) {
  std::vector<std::vector<SlotForm>> starts;
  for (std::size_t i = 0; i < found.forms.size(); ++i)
    if (others_can_follow(i, s, found)) starts.push_back(refitted_without(i, s, found));
  if (starts.empty()) return false;
  make_moments(s.design, found);
  grow_slots(s.most, s.banned, found);
  prefer_names(found);
  Slots best = found.slots;
  for (const std::vector<SlotForm>& start : starts) {
    const Slots end = found.search->find(slots_of_forms(found.all, *found.search, start));
    if (end.log_posterior > best.log_posterior + 1e-6) best = end;
  }
  const bool better = best.log_posterior > found.slots.log_posterior;
  found.slots = best;
  fit_shapes(s.design, found);
  return better;
}

}  // namespace sinew::diagnosis
