// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/found_slots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "identification/diagnosis/materiality.h"
#include "identification/likelihood/decision_constants.h"
#include "identification/regression/refine.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Shares by which everything may be off. Four decades are all between a simulator and a rough
// model.
constexpr double kShares[] = {1e-4, 3.2e-4, 1e-3, 3.2e-3, 1e-2};

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

/// What two searches under different errors are compared by.
double evidence_of(const SmallErrors& errors, double share, const Slots& slots) {
  return errors.log_likelihood() + slots.log_posterior -
         kPriceOfDecade * std::log10(share / kShares[0]);
}

/// Slots with names alone, where they explain as much but for what their forms are off by; the
/// search knows of nothing else then.
Slots named_if_as_good(SlotSearch& search, Slots best) {
  search.set_names_alone(true);
  if (search.are_named(best)) return best;
  Slots named = search.from_rivals(search.find());
  if (named.log_posterior >= (1.0 - kFormError * kFormError) * best.log_posterior) return named;
  search.set_names_alone(false);
  return best;
}

}  // namespace

void search_slots(int most, const std::vector<bool>& banned, FoundSlots& found) {
  double best = -std::numeric_limits<double>::infinity();
  Slots slots;
  for (const double share : kShares) {
    auto errors = std::make_unique<SmallErrors>(found.moments, found.all, share);
    auto by = std::make_unique<SlotSearch>(found.all, *errors, most, banned);
    slots = share == kShares[0] ? by->find() : by->find(std::move(slots));
    const double evidence = evidence_of(*errors, share, slots);
    if (evidence <= best) continue;
    best = evidence;
    found.small_errors = share;
    found.search = std::move(by);
    found.errors = std::move(errors);
    found.slots = slots;
  }
  found.slots = found.search->from_rivals(found.slots);
  found.slots = named_if_as_good(*found.search, std::move(found.slots));
  found.slots = found.search->with_names(found.slots);
}

namespace {

double coordinate(const NonlinearParameter& range, double value) {
  return range.logarithmic ? std::log(value) : value;
}

/// Where a slot's shape is to be fitted from: its grid point, or between two by their coefficients.
VectorXd start_of(const FoundSlots& found, std::size_t slot) {
  const Entry& entry = found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot])];
  const auto shape = [&](std::size_t i) {
    return found.all.shapes[static_cast<std::size_t>(entry.shapes[i])].nonlinear;
  };
  if (entry.shapes.size() == 1) return shape(0);
  const VectorXd b = found.search->coefficients(found.slots, slot).cwiseAbs();
  const double part = b(1) / std::max(b.sum(), 1e-300);
  const auto& ranges = found.all.list[static_cast<std::size_t>(entry.hypothesis)].source->nonlinear;
  VectorXd start = shape(0);
  for (Index p = 0; p < start.size(); ++p) {
    const NonlinearParameter& range = ranges[static_cast<std::size_t>(p)];
    const double between =
        (1.0 - part) * coordinate(range, shape(0)(p)) + part * coordinate(range, shape(1)(p));
    start(p) = range.logarithmic ? std::exp(between) : between;
  }
  return start;
}

/// The model with a term for every slot, its shapes fitted together. Delays come last: their column
/// is the rate of all else.
void fit_shapes(const Design& design, FoundSlots& found) {
  found.model = found.all.parts.base;
  const std::size_t count = found.slots.entries.size();
  const std::size_t first = found.model.terms.size();
  std::vector<std::size_t> order;
  for (const bool delays : {false, true})
    for (std::size_t i = 0; i < count; ++i) {
      const Entry& e = found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])];
      const Hypothesis& h = found.all.list[static_cast<std::size_t>(e.hypothesis)];
      if ((h.source->kind == CandidateKind::delay) != delays) continue;
      order.push_back(i);
      if (delays)
        append_term(design, found.whitening.training, *h.source, VectorXd::Zero(1), found.model);
      else if (h.candidate < 0)
        found.model.terms.push_back(term_of(found.all, e.shapes.front()));
      else
        found.model.terms.push_back(make_term(design, *h.source, start_of(found, i), false));
    }
  if (count == 0) return;
  for (std::size_t t = first; t < found.model.terms.size(); ++t)
    found.model.terms[t].with_prior = true;
  refine(design, found.whitening.training, RefineScope::all_terms, found.model);
  std::vector<Term> sorted(count);
  for (std::size_t k = 0; k < count; ++k) sorted[order[k]] = found.model.terms[first + k];
  std::move(sorted.begin(), sorted.end(),
            found.model.terms.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Fitted shapes that are no grid points become shapes of their hypotheses. False: there are none.
bool add_fitted_shapes(const Design& design, FoundSlots& found) {
  bool added = false;
  const std::size_t first = found.model.terms.size() - found.slots.entries.size();
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    const Term& term = found.model.terms[first + i];
    const Entry& e = found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])];
    if (term.deviation >= 0 || term.candidate->kind == CandidateKind::delay ||
        term.nonlinear.size() == 0)
      continue;
    const VectorXd& known = found.all.shapes[static_cast<std::size_t>(e.shapes.front())].nonlinear;
    if (e.shapes.size() == 1 && known.size() == term.nonlinear.size() &&
        (known - term.nonlinear).norm() <= 1e-3 * term.nonlinear.norm())
      continue;
    add_shape(design, e.hypothesis, term.nonlinear, found.all);
    added = true;
  }
  return added;
}

/// Hypotheses whose fitted terms lie beyond their limits are not taken again. False: there are
/// none.
bool ban_impossible(const Design& design, const FoundSlots& found, std::vector<bool>& banned) {
  if (found.slots.entries.empty()) return false;
  const LinearFit fit = solve(stack(found.model, found.whitening.training));
  const std::size_t first = found.model.terms.size() - found.slots.entries.size();
  bool any = false;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    if (!violates_limits(design, found.model, fit, first + i)) continue;
    banned[static_cast<std::size_t>(
        found.search->entries()[static_cast<std::size_t>(found.slots.entries[i])].hypothesis)] =
        true;
    any = true;
  }
  return any;
}

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

}  // namespace

std::unique_ptr<FoundSlots> find_slots(const Design& design, const Settings& settings,
                                       const Model& baseline) {
  auto found = std::make_unique<FoundSlots>();
  found->all = make_hypotheses(design, baseline);
  found->whitening = whitening_of(design, found->all,
                                  immaterial_variance(design, settings, found->all.parts.base));
  // A machine whose drives are not in its model lacks four values a joint, and links' besides.
  constexpr int per_channel = 5;
  const int most = std::max(settings.most_causes, per_channel * design.problem().channels);
  const Whitening noise_alone = found->whitening;
  std::vector<bool> banned(found->all.list.size(), false);
  constexpr int most_bans = 6;
  found->moments = moments_of(design, found->all, found->whitening);
  for (int round = 0, bans = 0;;) {
    search_slots(most, banned, *found);
    fit_shapes(design, *found);
    if (bans < most_bans && ban_impossible(design, *found, banned)) {
      ++bans;
      continue;
    }
    if (++round == kRounds || found->slots.entries.empty()) return found;
    // The first round knows nothing of the errors of what it finds.
    if (!add_fitted_shapes(design, *found) && round > 1) return found;
    add_form_errors(noise_alone, *found);
    found->moments = moments_of(design, found->all, found->whitening);
  }
}

}  // namespace sinew::diagnosis
