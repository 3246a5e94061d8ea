// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/found_slots.h"

#include <algorithm>
#include <utility>

#include "identification/diagnosis/materiality.h"
#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/fitted_shapes.h"
#include "identification/likelihood/form_errors_of_found.h"
#include "identification/likelihood/slot_evidence.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

// Rounds in which the noise and the errors of form are those beside what was found: one that knows
// them for the first time, one that asks for rivals under them, and one more where a rival has won.
constexpr int kRounds = 3;

}  // namespace

VectorXd immaterial_variance(const Design& design, const Settings& settings, const Model& model) {
  const ChannelSquares sums = channel_squares(design, model, even_weights(design));
  return settings.material_share * settings.material_share *
         sums.measured.cwiseQuotient(sums.samples.cwiseMax(1.0));
}

namespace {

/// What a search is about, beside what it finds.
struct Searched {
  const Design& design;
  VectorXd floor;  ///< per channel, the variance of a sample that is not material
  int most;        ///< slots
  std::vector<bool> banned;
  int bans = 0;
};

/// The products under the noise. Those before go first: of an arm of seven joints they take a
/// quarter of a gigabyte.
void make_moments(const Design& design, FoundSlots& found) {
  found.moments = {};
  found.moments = moments_of(design, found.all, found.whitening);
}

void search_under(Whitening noise, const Searched& s, FoundSlots& found) {
  found.whitening = std::move(noise);
  make_moments(s.design, found);
  grow_slots(s.most, s.banned, found);
  fit_shapes(s.design, found);
}

/// Searches under one noise, then under that which is beside what was found: its shapes are fitted.
/// False: nothing was found under either.
bool try_noise(Whitening noise, const Searched& s, FoundSlots& found) {
  found.forms.clear();
  search_under(std::move(noise), s, found);
  const bool any = !found.slots.entries.empty();
  search_under(whitening_beside(s.design, found.model, s.floor), s, found);
  return any || !found.slots.entries.empty();
}

/// The noise to begin with. Beside a fit of everything too little is left of it where that takes
/// all rows of a frequency; beside the model alone all that is hidden counts as noise. The more
/// probable one of where the two lead.
void first_noise(const Searched& s, FoundSlots& found) {
  // Where nothing was found the noise is that beside the model alone by now.
  if (!try_noise(whitening_of(s.design, found.all, s.floor), s, found)) return;
  Whitening beside_everything = std::move(found.whitening);
  std::vector<SlotForm> forms = std::move(found.forms);
  const double evidence = found.evidence, share = found.small_errors;
  found.forms.clear();
  search_under(whitening_beside(s.design, found.all.parts.base, s.floor), s, found);
  if (!found.slots.entries.empty())
    search_under(whitening_beside(s.design, found.model, s.floor), s, found);
  if (found.evidence >= evidence) return;
  found.whitening = std::move(beside_everything);
  make_moments(s.design, found);
  found.forms = std::move(forms);
  found.small_errors = share;
}

/// The noise beside what another search has found.
void noise_beside(const std::vector<SlotForm>& forms, const Searched& s, FoundSlots& found) {
  found.whitening = whitening_beside(s.design, found.all.parts.base, s.floor);
  fit_forms(s.design, forms, found);
  found.whitening = whitening_beside(s.design, found.model, s.floor);
  make_moments(s.design, found);
  found.forms = forms;
}

/// The model with all of its own values free.
Model with_free_values(const Hypotheses& all) {
  Model model = all.parts.base;
  for (const Hypothesis& h : all.list)
    if (h.candidate < 0 && !h.shapes.empty()) model.terms.push_back(term_of(all, h.shapes.front()));
  return model;
}

/// Grown from the forms so far, with shapes that are fitted.
void grow_with_shapes(const Searched& s, FoundSlots& found) {
  grow_slots(s.most, s.banned, found);
  prefer_names(found);
  fit_shapes(s.design, found);
}

/// Searched from rivals, too. What cannot be by the fit of its shape is banned, and the search is
/// done again.
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

std::vector<int> hypotheses_of(const FoundSlots& found) {
  std::vector<int> all;
  for (const int e : found.slots.entries)
    all.push_back(found.search->entries()[static_cast<std::size_t>(e)].hypothesis);
  std::sort(all.begin(), all.end());
  return all;
}

/// The noise and what forms are off by, beside what was found, whose shapes join the others.
void take_errors(const Searched& s, FoundSlots& found) {
  found.whitening =
      with_form_errors(whitening_beside(s.design, found.model, s.floor), found.model,
                       found.all.parts.base.terms.size(), with_free_values(found.all));
  add_fitted_shapes(s.design, found);
  make_moments(s.design, found);
}

}  // namespace

std::unique_ptr<FoundSlots> find_slots(const Design& design, const Settings& settings,
                                       const Model& baseline, Rivals rivals,
                                       const std::vector<SlotForm>& beginning) {
  auto found = std::make_unique<FoundSlots>();
  found->all = make_hypotheses(design, baseline);
  // A machine whose drives are not in its model lacks four values a joint, and links' besides.
  constexpr int per_channel = 5;
  Searched s{design, immaterial_variance(design, settings, found->all.parts.base),
             std::max(settings.most_causes, per_channel * design.problem().channels),
             std::vector<bool>(found->all.list.size(), false)};
  if (beginning.empty())
    first_noise(s, *found);
  else
    noise_beside(beginning, s, *found);
  const bool asked = rivals == Rivals::asked;
  if (asked && found->forms.empty())
    search_with_shapes(s, *found);
  else
    grow_with_shapes(s, *found);
  for (int round = 1; round <= (asked ? kRounds : 1) && !found->slots.entries.empty(); ++round) {
    take_errors(s, *found);
    if (round == 1) {
      grow_with_shapes(s, *found);
      continue;
    }
    // What a slot's rivals are is asked once the errors of what was found are known.
    const std::vector<int> before = hypotheses_of(*found);
    search_with_shapes(s, *found);
    if (hypotheses_of(*found) == before) break;
  }
  return found;
}

}  // namespace sinew::diagnosis
