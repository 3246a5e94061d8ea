// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain_by_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/diagnosis/confidence.h"
#include "identification/diagnosis/form_errors.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/likelihood/decision_constants.h"
#include "identification/likelihood/fitted_baseline.h"
#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/slot_verdict.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

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
  cause.paired_z = cause.correlation = std::numeric_limits<double>::quiet_NaN();  // not asked for
  cause.weight = rival.probability;
  return cause;
}

/// The named members of a slot's credible set, what the model is extended by first. Structure
/// without a name of which a member's form is a part does not speak against it.
NamedCause name_slot(const FoundSlots& found, std::size_t slot) {
  NamedCause cause;
  cause.candidate = hypothesis_of(found, slot).candidate;
  if (!hypothesis_of(found, slot).named) return cause;
  double named = 0.0;
  const std::vector<Rival> set = found.search->credible(found.slots, slot);
  for (const Rival& rival : set) {
    const Hypothesis& h = found.all.list[static_cast<std::size_t>(rival.hypothesis)];
    if (!h.named) continue;
    if (cause.members.empty()) {
      cause.statistic = 2.0 * rival.log_odds;
      cause.p_family = std::min(1.0, std::exp(-rival.log_odds));
    }
    named += rival.probability;
    cause.members.push_back(ranked(found, rival, set.front().log_odds));
  }
  const auto adopted =
      std::find_if(cause.members.begin(), cause.members.end(),
                   [&](const RankedCause& m) { return m.candidate == cause.candidate; });
  if (adopted != cause.members.end()) std::rotate(cause.members.begin(), adopted, adopted + 1);
  cause.confidence = kHighestConfidence * std::min(1.0, named);
  return cause;
}

/// A model's terms with those of structure without a name taken out, and whose slot each is of.
Model named_model(const Design& design, const FoundSlots& found,
                  const std::vector<NamedCause>& of_slot) {
  Model model = found.model;
  const std::size_t first = model.terms.size() - of_slot.size();
  for (std::size_t i = of_slot.size(); i-- > 0;)
    if (of_slot[i].members.empty()) remove_term(design, first + i, model);
  return model;
}

/// What the slots without a name hold.
std::vector<Term> structure_of(const FoundSlots& found, const std::vector<NamedCause>& of_slot) {
  std::vector<Term> structure;
  const std::size_t first = found.model.terms.size() - of_slot.size();
  for (std::size_t i = 0; i < of_slot.size(); ++i)
    if (of_slot[i].members.empty() && !hypothesis_of(found, i).named)
      structure.push_back(found.model.terms[first + i]);
  return structure;
}

/// The baseline free and the causes of the library: what the motion's directions are read from.
Selection free_selection(const Design& design, const Model& baseline, const Model& adopted) {
  Selection s;
  s.model = baseline;
  s.model.advance = adopted.advance;
  for (std::size_t i = 0; i < s.model.target.size(); ++i)
    s.model.target[i] = design.target(static_cast<int>(i), s.model.advance[i]);
  for (const Term& term : adopted.terms)
    if (!term.baseline && !term.candidate->nuisance && term.deviation < 0)
      s.model.terms.push_back(term);
  s.noise = own_noise(design, s.model);
  s.evidence.resize(s.model.terms.size());
  return s;
}

Gain cross_validated_gain(const Design& design, const Settings& settings,
                          const Selection& selection, std::size_t term) {
  const Weights& weights = selection.noise.weights;
  const auto [with, without] = compared(design, selection.model, term, weights);
  const VectorXd channels = channels_of(design, selection.model.terms[term]);
  return block_bootstrap_gain(
      cross_validate(design, without, weights, settings.blocks).plain * channels,
      cross_validate(design, with, weights, settings.blocks).plain * channels, 0.95, settings.seed);
}

}  // namespace

void tell_unnamed(const FoundSlots& found, Unexplained& said) {
  double named = 0.0, all = 0.0;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    const std::vector<Rival> set = found.search->credible(found.slots, i);
    if (set.empty()) continue;
    const Hypothesis& h = hypothesis_of(found, i);
    all += set.front().log_odds;
    if (h.named) {
      named += set.front().log_odds;
      continue;
    }
    said.none_of_the_known = true;
    said.depends_on.push_back({h.source->depends_on.empty() ? h.source->name : h.source->depends_on,
                               h.source->place,
                               std::min(1.0, std::exp(-set.front().log_odds)),
                               {}});
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
    verdict.ruled_out.push_back({h.source->name, h.source->place,
                                 rival.log_odds > 0.0
                                     ? "outside its physical limits"
                                     : "nothing beyond noise beside the named causes",
                                 std::max(0.0, 2.0 * (rival.log_odds - h.log_prior)),
                                 std::min(1.0, std::exp(-rival.log_odds))});
  }
}

std::vector<NamedCause> name_slots(const FoundSlots& found) {
  std::vector<NamedCause> list;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) list.push_back(name_slot(found, i));
  return list;
}

namespace {

void tell_baseline(const Design& design, Explanation& result) {
  const Selection& found = result.selection;
  result.estimates = told_estimates(design, found.model, found.noise);
  for (std::size_t t = 0; t < found.model.terms.size(); ++t)
    if (found.model.terms[t].baseline)
      result.verdict.baseline.insert(result.verdict.baseline.end(), result.estimates[t].begin(),
                                     result.estimates[t].end());
}

/// What was found, as it is adopted and beside values of the model that are free.
struct Measured {
  const Design& design;
  const Settings& settings;
  const FoundSlots& found;
  const Selection& adopted;
};

/// The whitened error on the held-out logs with a term and without it.
Gain confirmed_gain(const Measured& m, std::size_t term) {
  const auto [with, without] =
      compared(m.design, m.adopted.model, term, m.found.whitening.training);
  const VectorXd channels = channels_of(m.design, m.adopted.model.terms[term]);
  const auto losses = [&](const Model& model) {
    const LinearFit fit = solve(stack(model, m.found.whitening.training));
    return VectorXd(
        held_out(m.design, model, fit, m.settings.blocks, &m.found.whitening.held_out).plain *
        channels);
  };
  return block_bootstrap_gain(losses(without), losses(with), 0.95, m.settings.seed);
}

/// Names with what they gain, largest gain first.
std::vector<NamedCause> measured_causes(const Measured& m, const std::vector<NamedCause>& of_slot) {
  std::vector<NamedCause> list;
  for (const NamedCause& cause : of_slot)
    if (!cause.members.empty()) list.push_back(cause);
  const auto all = told_estimates(m.design, m.adopted.model, m.adopted.noise);
  const std::size_t first = m.adopted.model.terms.size() - list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    NamedCause& cause = list[i];
    cause.parameters = all[first + i];
    cause.cross_validated = cross_validated_gain(m.design, m.settings, m.adopted, first + i);
    cause.held_out = gain_on_held_out(m.design, m.settings, m.adopted, first + i);
    cause.confirmed = confirmed_gain(m, first + i);
  }
  std::stable_sort(list.begin(), list.end(), [](const NamedCause& a, const NamedCause& b) {
    return a.cross_validated.share > b.cross_validated.share;
  });
  return list;
}

}  // namespace

Explanation explain_by_likelihood(const Problem& problem, const Settings& settings,
                                  const std::vector<SlotForm>& beginning) {
  Design design(problem, settings);
  design.set_units(left_over(design, baseline_model(design)));
  const Model baseline = fitted_baseline(design);
  const auto found = find_slots(design, settings, baseline, beginning);
  const std::vector<NamedCause> of_slot = name_slots(*found);
  Explanation result;
  result.structure = structure_of(*found, of_slot);
  result.forms = found->forms;
  Selection adopted;
  adopted.model = named_model(design, *found, of_slot);
  adopted.noise = own_noise(design, adopted.model);
  adopted.evidence.resize(adopted.model.terms.size());
  adopted.made = found->all.parts.made;
  result.selection =
      problem.deviations.empty() ? adopted : free_selection(design, baseline, adopted.model);
  tell_baseline(design, result);
  Verdict& verdict = result.verdict;
  verdict.causes = measured_causes({design, settings, *found, adopted}, of_slot);
  tell_unnamed(*found, verdict.unexplained);
  list_ruled_out(*found, verdict);
  tell_errors(design, settings, found->all.parts.base, adopted, verdict);
  if (!problem.deviations.empty()) result.adopted = std::move(adopted);
  return result;
}

}  // namespace sinew::diagnosis
