// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/found_slots.h"

#include <algorithm>
#include <utility>

#include "identification/diagnosis/materiality.h"
#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/fitted_shapes.h"
#include "identification/likelihood/slot_evidence.h"
#include "identification/regression/refine.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A shape is fitted where the grid's point was found; the search with it, and with the errors of
// what was found, may find another one.
constexpr int kRounds = 3;

}  // namespace

VectorXd immaterial_variance(const Design& design, const Settings& settings, const Model& model) {
  const ChannelSquares sums = channel_squares(design, model, even_weights(design));
  return settings.material_share * settings.material_share *
         sums.measured.cwiseQuotient(sums.samples.cwiseMax(1.0));
}

namespace {

/// What the found slots say of a segment, in the band; empty where none acts.
VectorXd found_part(const FoundSlots& found, const LinearFit& fit, std::size_t segment) {
  const std::vector<Index> first = first_columns(found.model);
  VectorXd sum;
  for (std::size_t t = found.model.terms.size() - found.slots.entries.size();
       t < found.model.terms.size(); ++t) {
    const Eigen::MatrixXd& columns = found.model.terms[t].columns[segment];
    // A value of the model's own changes the size of what the model says, not its form.
    if (columns.cols() == 0 || found.model.terms[t].deviation >= 0) continue;
    const VectorXd own = columns * fit.coefficients.segment(first[t], columns.cols());
    sum = sum.size() == 0 ? own : VectorXd(sum + own);
  }
  return sum;
}

/// What the form of the found part is off by, as the variance of every row: near the frequencies
/// where it is large.
VectorXd form_error_variance(const VectorXd& found_part) {
  constexpr Index least = 4;     // bins
  constexpr double width = 0.3;  // of the frequency
  const VectorXd energy = bin_energy(found_part);
  return per_row(0.5 * kFormError * kFormError *
                 smooth_ratio(energy, VectorXd::Ones(energy.size()), least, width));
}

/// Rows count for less where what was found is large.
void add_form_errors(const Whitening& noise_alone, FoundSlots& found) {
  found.whitening = noise_alone;
  found.whitening.noise_share.resize(noise_alone.training.size());
  if (found.slots.entries.empty()) return;
  const LinearFit fit = solve(stack(found.model, noise_alone.training));
  for (Weights* weights : {&found.whitening.training, &found.whitening.held_out})
    for (std::size_t s = 0; s < weights->size(); ++s) {
      VectorXd& weight = (*weights)[s];
      const VectorXd part = weight.size() == 0 ? VectorXd() : found_part(found, fit, s);
      if (part.size() == 0) continue;
      const VectorXd alone = weight;
      weight =
          (alone.array().square().inverse() + form_error_variance(part).array()).rsqrt().matrix();
      found.whitening.noise_share[s] = weight.cwiseQuotient(alone);
    }
}

/// What a search is about, beside what it finds.
struct Searched {
  const Design& design;
  VectorXd floor;  ///< per channel, the variance of a sample that is not material
  int most;        ///< slots
  std::vector<bool> banned;
};

/// Searches under one noise, then under that which is beside what was found: its shapes are fitted.
void try_noise(Whitening noise, const Searched& s, FoundSlots& found) {
  found.whitening = std::move(noise);
  found.moments = moments_of(s.design, found.all, found.whitening);
  found.forms.clear();
  grow_slots(s.most, s.banned, found);
  fit_shapes(s.design, found);
  found.whitening = whitening_beside(s.design, found.model, s.floor);
  found.moments = moments_of(s.design, found.all, found.whitening);
  grow_slots(s.most, s.banned, found);
  fit_shapes(s.design, found);
}

/// The noise to begin with. Beside a fit of everything too little is left of it where that takes
/// all rows of a frequency; beside the model alone all that is hidden counts as noise. The more
/// probable one of where the two lead.
void first_noise(const Searched& s, FoundSlots& found) {
  try_noise(whitening_of(s.design, found.all, s.floor), s, found);
  Whitening beside_everything = std::move(found.whitening);
  std::vector<SlotForm> forms = std::move(found.forms);
  const double evidence = found.evidence, share = found.small_errors;
  try_noise(whitening_beside(s.design, found.all.parts.base, s.floor), s, found);
  if (found.evidence >= evidence) return;
  found.whitening = std::move(beside_everything);
  found.forms = std::move(forms);
  found.small_errors = share;
}

/// The noise beside what another search has found.
void noise_beside(const std::vector<SlotForm>& forms, const Searched& s, FoundSlots& found) {
  found.whitening = whitening_beside(s.design, found.all.parts.base, s.floor);
  fit_forms(s.design, forms, found);
  found.whitening = whitening_beside(s.design, found.model, s.floor);
  found.forms = forms;
}

}  // namespace

std::unique_ptr<FoundSlots> find_slots(const Design& design, const Settings& settings,
                                       const Model& baseline,
                                       const std::vector<SlotForm>& beginning) {
  auto found = std::make_unique<FoundSlots>();
  found->all = make_hypotheses(design, baseline);
  // A machine whose drives are not in its model lacks four values a joint, and links' besides.
  constexpr int per_channel = 5;
  Searched s{design, immaterial_variance(design, settings, found->all.parts.base),
             std::max(settings.most_causes, per_channel * design.problem().channels),
             std::vector<bool>(found->all.list.size(), false)};
  constexpr int most_bans = 6;
  if (beginning.empty())
    first_noise(s, *found);
  else
    noise_beside(beginning, s, *found);
  found->moments = moments_of(design, found->all, found->whitening);
  for (int round = 0, bans = 0;;) {
    // What a slot's rivals are is asked once the errors of what was found are known.
    if (round == 0 && !found->forms.empty())
      grow_slots(s.most, s.banned, *found);
    else
      search_slots(s.most, s.banned, *found);
    fit_shapes(design, *found);
    if (bans < most_bans && ban_impossible(design, *found, s.banned)) {
      ++bans;
      continue;
    }
    if (++round == kRounds || found->slots.entries.empty()) return found;
    // The first round knows nothing of the errors of what it finds.
    if (!add_fitted_shapes(design, *found) && round > 1) return found;
    add_form_errors(whitening_beside(design, found->model, s.floor), *found);
    found->moments = moments_of(design, found->all, found->whitening);
  }
}

}  // namespace sinew::diagnosis
