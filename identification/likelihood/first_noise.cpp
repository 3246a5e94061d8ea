// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/first_noise.h"

#include <utility>

#include "identification/likelihood/fitted_shapes.h"
#include "identification/likelihood/slot_evidence.h"

namespace sinew::diagnosis {
namespace {

/// Searches under one noise, then under that which is beside what was found: its shapes are fitted.
/// False: nothing was found under either.
bool try_noise(Whitening noise, const Searched& s, FoundSlots& found) {
  found.forms.clear();
  search_under(std::move(noise), s, found);
  const bool any = !found.slots.entries.empty();
  search_under(whitening_beside(s.design, found.model, s.floor), s, found);
  return any || !found.slots.entries.empty();
}

/// What the rest of the search begins with.
struct Beginning {
  std::vector<SlotForm> forms;
  Whitening whitening;
  double small_errors = 0.0, evidence = 0.0;
};

Beginning beginning_of(const FoundSlots& found) {
  return {found.forms, found.whitening, found.small_errors, found.evidence};
}

std::vector<SlotForm> forms_at(const Design& design, const FoundSlots& found,
                               const std::vector<SlotForm>& forms, int channel, bool there) {
  std::vector<SlotForm> some;
  for (const SlotForm& form : forms)
    if ((channel_of(design, found, form) == channel) == there) some.push_back(form);
  return some;
}

}  // namespace

void noise_beside(const std::vector<SlotForm>& forms, const Searched& s, FoundSlots& found) {
  found.whitening = whitening_beside(s.design, found.all.parts.base, s.floor);
  fit_forms(s.design, forms, found);
  found.whitening = whitening_beside(s.design, found.model, s.floor);
  make_moments(s.design, found);
  found.forms = forms;
}

namespace {

/// Where only one of two beginnings has found something in a channel, whether that is noise is
/// asked by itself: the better one with the other's answer there, where that is more probable.
void ask_by_channel(const Beginning& other, const Searched& s, FoundSlots& found, Beginning& best) {
  const int channels = s.design.problem().channels;
  for (int channel = 0; channels > 1 && channel < channels; ++channel) {
    const std::vector<SlotForm> own = forms_at(s.design, found, best.forms, channel, true),
                                others = forms_at(s.design, found, other.forms, channel, true);
    if (own.empty() == others.empty()) continue;
    std::vector<SlotForm> forms = forms_at(s.design, found, best.forms, channel, false);
    forms.insert(forms.end(), others.begin(), others.end());
    noise_beside(forms, s, found);
    grow_slots(s.allowed, found);
    fit_shapes(s.design, found);
    if (found.evidence > best.evidence) best = beginning_of(found);
  }
}

}  // namespace

void first_noise(const Searched& s, FoundSlots& found) {
  // Where nothing was found the noise is that beside the model alone by now.
  if (!try_noise(whitening_of(s.design, found.all, s.floor), s, found)) return;
  const Beginning beside_everything = beginning_of(found);
  found.forms.clear();
  search_under(whitening_beside(s.design, found.all.parts.base, s.floor), s, found);
  if (!found.slots.entries.empty())
    search_under(whitening_beside(s.design, found.model, s.floor), s, found);
  const Beginning beside_model = beginning_of(found);
  const bool everything = beside_model.evidence < beside_everything.evidence;
  Beginning best = everything ? beside_everything : beside_model;
  ask_by_channel(everything ? beside_model : beside_everything, s, found, best);
  found.whitening = std::move(best.whitening);
  found.forms = std::move(best.forms);
  found.small_errors = best.small_errors;
  make_moments(s.design, found);
}

}  // namespace sinew::diagnosis
