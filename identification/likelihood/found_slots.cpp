// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/found_slots.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "identification/diagnosis/materiality.h"
#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/first_noise.h"
#include "identification/likelihood/fitted_shapes.h"
#include "identification/likelihood/form_errors_of_found.h"
#include "identification/likelihood/shaped_search.h"

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

Searched search_of(const Design& design, const Settings& settings, const FoundSlots& found,
                   std::optional<double> share = {}) {
  // A machine whose drives are not in its model lacks four values a joint, and links' besides.
  constexpr int per_channel = 5;
  return {design,
          immaterial_variance(design, settings, found.all.parts.base),
          {std::max(settings.most_causes, per_channel * design.problem().channels),
           std::vector<bool>(found.all.list.size(), false), share}};
}

/// The model with all of its own values free.
Model with_free_values(const Hypotheses& all) {
  Model model = all.parts.base;
  for (const Hypothesis& h : all.list)
    if (h.candidate < 0 && !h.shapes.empty()) model.terms.push_back(term_of(all, h.shapes.front()));
  return model;
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

/// What a search begins with.
struct Known {
  const Model& baseline;
  const std::vector<SlotForm>& forms;
  std::optional<double> share;  ///< of small errors; empty: any
};

std::unique_ptr<FoundSlots> found_from(const Design& design, const Settings& settings,
                                       const Known& known, Rivals rivals) {
  auto found = std::make_unique<FoundSlots>();
  found->all = make_hypotheses(design, known.baseline);
  Searched s = search_of(design, settings, *found, known.share);
  if (known.forms.empty())
    first_noise(s, *found);
  else
    noise_beside(known.forms, s, *found);
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

}  // namespace

std::unique_ptr<FoundSlots> find_slots(const Design& design, const Settings& settings,
                                       const Model& baseline, Rivals rivals,
                                       const std::vector<SlotForm>& beginning) {
  auto found = found_from(design, settings, {baseline, beginning, {}}, rivals);
  if (!beginning.empty() || found->slots.entries.empty() || found->small_errors <= kMiddleShare)
    return found;
  // Large errors in everything and the noise beside a poor explanation keep each other up: where
  // the search has come to the former, it is done again with smaller ones held.
  for (const double share : {kMiddleShare, kLeastShare}) {
    auto other = found_from(design, settings, {baseline, beginning, share}, rivals);
    if (!other->slots.entries.empty() && is_more_probable(*other, *found)) found = std::move(other);
  }
  return found;
}

void search_names_alone(const Design& design, const Settings& settings, FoundSlots& found) {
  Searched s = search_of(design, settings, found);
  for (std::size_t h = 0; h < s.allowed.banned.size(); ++h)
    s.allowed.banned[h] = !found.all.list[h].named;
  std::erase_if(found.forms, [&](const SlotForm& form) {
    return s.allowed.banned[static_cast<std::size_t>(hypothesis_of(found.all, form))];
  });
  search_with_shapes(s, found);
}

}  // namespace sinew::diagnosis
