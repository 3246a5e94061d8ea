// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain_by_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/diagnosis/confidence.h"
#include "identification/diagnosis/standard_errors.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/found_slots.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

/// The model's own terms, how friction turns at a reversal among them, fitted to the logs.
Model fitted_baseline(const Design& design) {
  Model model = baseline_model(design);
  Weights weights = own_noise(design, model).weights;
  refine(design, weights, RefineScope::all_terms, model);
  weights = own_noise(design, model).weights;
  settle_nuisances(design, weights, model);
  return model;
}

const Hypothesis& hypothesis_of(const FoundSlots& found, std::size_t slot) {
  return found.all.list[static_cast<std::size_t>(
      found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot])].hypothesis)];
}

RankedCause ranked(const FoundSlots& found, const Rival& rival, double best) {
  const Hypothesis& h = found.all.list[static_cast<std::size_t>(rival.hypothesis)];
  RankedCause cause;
  cause.candidate = h.candidate;
  cause.name = h.source->name;
  cause.place = h.source->place;
  cause.behind = 2.0 * (best - rival.log_odds);
  cause.weight = rival.probability;
  return cause;
}

/// The smallest set that is credible, the slot's own hypothesis first.
NamedCause name_slot(const FoundSlots& found, std::size_t slot) {
  const std::vector<Rival> rivals = found.search->rivals(found.slots, slot);
  const Hypothesis& own = hypothesis_of(found, slot);
  NamedCause cause;
  cause.candidate = own.candidate;
  double sum = 0.0;
  for (const Rival& rival : rivals) {
    if (sum >= kCredible) break;
    sum += rival.probability;
    const Hypothesis& h = found.all.list[static_cast<std::size_t>(rival.hypothesis)];
    if (h.named) cause.members.push_back(ranked(found, rival, rivals.front().log_odds));
    if (h.candidate != own.candidate) continue;
    cause.statistic = 2.0 * rival.log_odds;
    cause.p_family = std::min(1.0, std::exp(-rival.log_odds));
  }
  if (cause.members.empty()) cause.members.push_back({own.candidate, own.source->name,
                                                      own.source->place});
  cause.confidence = kHighestConfidence * std::min(1.0, sum);
  return cause;
}

/// A model's terms with those of structure without a name taken out, and whose slot each is of.
Model named_model(const Design& design, const FoundSlots& found, std::vector<std::size_t>& slots) {
  Model model = found.model;
  const std::size_t first = model.terms.size() - found.slots.entries.size();
  for (std::size_t i = found.slots.entries.size(); i-- > 0;) {
    if (hypothesis_of(found, i).named)
      slots.insert(slots.begin(), i);
    else
      remove_term(design, first + i, model);
  }
  return model;
}

/// The baseline free and the causes of the library: what the motion's directions are read from.
Selection free_selection(const Design& design, const Model& baseline, const Model& adopted) {
  Selection s;
  s.model = baseline;
  s.model.advance = adopted.advance;
  for (std::size_t i = 0; i < s.model.target.size(); ++i)
    s.model.target[i] = design.target(static_cast<int>(i), s.model.advance[i]);
  for (const Term& term : adopted.terms)
    if (!term.baseline && term.deviation < 0) s.model.terms.push_back(term);
  s.noise = own_noise(design, s.model);
  s.evidence.resize(s.model.terms.size());
  return s;
}

Gain cross_validated_gain(const Design& design, const Settings& settings,
                          const Selection& selection, std::size_t term) {
  Model without = selection.model;
  remove_term(design, term, without);
  const VectorXd channels = channels_of(design, selection.model.terms[term]);
  const Weights& weights = selection.noise.weights;
  return block_bootstrap_gain(
      cross_validate(design, without, weights, settings.blocks).plain * channels,
      cross_validate(design, selection.model, weights, settings.blocks).plain * channels, 0.95,
      settings.seed);
}

void tell_unnamed(const FoundSlots& found, Unexplained& said) {
  double named = 0.0, all = 0.0;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    const Hypothesis& h = hypothesis_of(found, i);
    const std::vector<Rival> rivals = found.search->rivals(found.slots, i);
    const double odds = rivals.empty() ? 0.0 : std::max(0.0, rivals.front().log_odds);
    all += odds;
    if (h.named) {
      named += odds;
      continue;
    }
    said.none_of_the_known = true;
    said.depends_on.push_back({h.source->depends_on.empty() ? h.source->name : h.source->depends_on,
                               h.source->place, std::min(1.0, std::exp(-odds)), {}});
  }
  said.named_share = all > 0.0 ? named / all : 1.0;
}

void list_ruled_out(const FoundSlots& found, Verdict& verdict) {
  for (const Rival& rival : found.search->on_top(found.slots)) {
    const Hypothesis& h = found.all.list[static_cast<std::size_t>(rival.hypothesis)];
    const bool told =
        std::any_of(verdict.causes.begin(), verdict.causes.end(), [&](const NamedCause& c) {
          return std::any_of(c.members.begin(), c.members.end(),
                             [&](const RankedCause& m) { return m.candidate == h.candidate; });
        });
    if (told || !h.named) continue;
    verdict.ruled_out.push_back(
        {h.source->name, h.source->place,
         rival.log_odds > 0.0 ? "outside its physical limits"
                              : "nothing beyond noise beside the named causes",
         std::max(0.0, 2.0 * (rival.log_odds - h.log_prior)),
         std::min(1.0, std::exp(-rival.log_odds))});
  }
}

}  // namespace

Explanation explain_by_likelihood(const Problem& problem, const Settings& settings,
                                  const ExperimentPlanner& planner) {
  Design design(problem, settings);
  if (!problem.shared_noise) design.set_units(left_over(design, baseline_model(design)));
  const Model baseline = fitted_baseline(design);
  const auto found = find_slots(design, settings, baseline);
  Explanation result;
  Verdict& verdict = result.verdict;
  std::vector<std::size_t> slots;
  Selection adopted;
  adopted.model = named_model(design, *found, slots);
  adopted.noise = own_noise(design, adopted.model);
  adopted.evidence.resize(adopted.model.terms.size());
  adopted.made = found->all.parts.made;
  result.selection =
      problem.deviations.empty() ? adopted : free_selection(design, baseline, adopted.model);
  result.estimates = estimates(design, result.selection.model, result.selection.noise);
  for (std::size_t t = 0; t < result.selection.model.terms.size(); ++t)
    if (result.selection.model.terms[t].baseline)
      verdict.baseline.insert(verdict.baseline.end(), result.estimates[t].begin(),
                              result.estimates[t].end());
  const auto all = estimates(design, adopted.model, adopted.noise);
  const std::size_t first = adopted.model.terms.size() - slots.size();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    NamedCause cause = name_slot(*found, slots[i]);
    cause.parameters = all[first + i];
    cause.cross_validated = cross_validated_gain(design, settings, adopted, first + i);
    cause.held_out = gain_on_held_out(design, settings, adopted, first + i);
    cause.separation = separate(design, settings, result.selection, adopted, first + i,
                                cause.members, planner);
    verdict.causes.push_back(std::move(cause));
  }
  std::stable_sort(verdict.causes.begin(), verdict.causes.end(),
                   [](const NamedCause& a, const NamedCause& b) {
                     return a.cross_validated.share > b.cross_validated.share;
                   });
  tell_unnamed(*found, verdict.unexplained);
  list_ruled_out(*found, verdict);
  tell_errors(design, settings, found->all.parts.base, adopted, verdict);
  if (!problem.deviations.empty()) result.adopted = std::move(adopted);
  return result;
}

}  // namespace sinew::diagnosis
