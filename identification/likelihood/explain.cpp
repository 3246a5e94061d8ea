// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain.h"

#include <algorithm>

#include "identification/diagnosis/form_errors.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/likelihood/fitted_baseline.h"
#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/ruled_out.h"
#include "identification/likelihood/slot_verdict.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

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
Gain confirmed_gain(const Measured& m, const Model& whole, std::size_t term) {
  const auto [with, without] = compared(m.design, whole, term, m.found.whitening.training);
  const VectorXd channels = channels_of(m.design, whole.terms[term]);
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
    cause.confirmed = confirmed_gain(m, m.adopted.model, first + i);
  }
  std::stable_sort(list.begin(), list.end(), [](const NamedCause& a, const NamedCause& b) {
    return a.cross_validated.share > b.cross_validated.share;
  });
  return list;
}

bool is_of_one_log(const Candidate& c) {
  return c.of_its_time || std::any_of(c.linear.begin(), c.linear.end(),
                                      [](const LinearParameter& p) { return p.per_log; });
}

/// What the held-out logs say of structure without a name, in the order of its slots.
void confirm_structure(const Measured& m, std::vector<Dependence>& depends_on) {
  if (m.design.problem().holdout.empty()) return;
  const Model& model = m.found.model;
  const std::size_t first = model.terms.size() - m.found.slots.entries.size();
  auto said = depends_on.begin();
  for (std::size_t i = 0; i < m.found.slots.entries.size() && said != depends_on.end(); ++i) {
    const Hypothesis& h = hypothesis_of(m.found, i);
    if (h.named || !is_told(m.found, i)) continue;
    if (!is_of_one_log(*h.source)) said->confirmed = confirmed_gain(m, model, first + i);
    ++said;
  }
}

}  // namespace

Explanation explain(const Problem& problem, const Settings& settings, const IsWanted& is_wanted,
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
  adopted.made = found->all.parts.made;
  result.selection =
      problem.deviations.empty() ? adopted : free_selection(design, baseline, adopted.model);
  if (is_wanted && !is_wanted(result)) return result;
  tell_baseline(design, result);
  Verdict& verdict = result.verdict;
  verdict.causes = measured_causes({design, settings, *found, adopted}, of_slot);
  tell_unnamed(*found, verdict.unexplained);
  confirm_structure({design, settings, *found, adopted}, verdict.unexplained.depends_on);
  list_ruled_out(*found, verdict);
  tell_errors(design, settings, found->all.parts.base, adopted, verdict);
  if (!problem.deviations.empty()) result.adopted = std::move(adopted);
  return result;
}

}  // namespace sinew::diagnosis
