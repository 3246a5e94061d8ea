// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/explain.h"

#include <algorithm>

#include "identification/diagnosis/form_errors.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/likelihood/fitted_baseline.h"
#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/held_out_judge.h"
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

void tell_baseline(const Design& design, Explanation& result) {
  const Selection& found = result.selection;
  result.estimates = told_estimates(design, found.model, found.noise);
  for (std::size_t t = 0; t < found.model.terms.size(); ++t)
    if (found.model.terms[t].baseline)
      result.verdict.baseline.insert(result.verdict.baseline.end(), result.estimates[t].begin(),
                                     result.estimates[t].end());
}

/// A design and what was found in it.
struct SearchedDesign {
  SearchedDesign(const Problem& problem, const Settings& settings, Rivals rivals,
                 const std::vector<SlotForm>& beginning)
      : design(with_units(problem, settings)),
        baseline(fitted_baseline(design)),
        found(find_slots(design, settings, baseline, rivals, beginning)) {
    name();
  }

  /// Structure that is not told must not stand beside names, which would be told as what it leaves.
  void leave_out_refuted(const Settings& settings) {
    if (!HeldOutJudge(design, settings, *found).refutes_structure()) return;
    search_names_alone(design, settings, *found);
    name();
  }

  void name() {
    of_slot = name_slots(*found);
    adopted.model = named_model(design, *found, of_slot);
    settle_nuisances(design, own_noise(design, adopted.model).weights, adopted.model);
    adopted.noise = own_noise(design, adopted.model);
    adopted.made = found->all.parts.made;
  }

  static Design with_units(const Problem& problem, const Settings& settings) {
    Design design(problem, settings);
    design.set_units(left_over(design, baseline_model(design)));
    return design;
  }

  /// Selection, structure and forms, which hold what their terms point to.
  Explanation explanation() const {
    Explanation result;
    result.structure = structure_of(*found, of_slot);
    result.forms = found->forms;
    result.selection = adopted;
    if (design.problem().deviations.empty()) return result;
    result.selection = free_selection(design, baseline, adopted.model);
    result.adopted = adopted;
    return result;
  }

  Design design;
  Model baseline;
  std::unique_ptr<FoundSlots> found;
  std::vector<NamedCause> of_slot;
  Selection adopted;
};

}  // namespace

Explanation explain(const Problem& problem, const Settings& settings,
                    const std::vector<SlotForm>& beginning) {
  SearchedDesign s(problem, settings, Rivals::asked, beginning);
  s.leave_out_refuted(settings);
  Explanation result = s.explanation();
  Selection& adopted = problem.deviations.empty() ? result.selection : result.adopted;
  Verdict& verdict = result.verdict;
  const HeldOutJudge judge(s.design, settings, *s.found);
  verdict.causes = judge.causes(s.of_slot, adopted);
  tell_baseline(s.design, result);
  tell_unnamed(*s.found, verdict.unexplained);
  judge.confirm_structure(verdict.unexplained.depends_on);
  list_ruled_out(*s.found, verdict);
  tell_errors(s.design, settings, s.found->all.parts.base, adopted, verdict);
  return result;
}

Explanation explain_roughly(const Problem& problem, const Settings& settings,
                            const std::vector<SlotForm>& beginning) {
  return SearchedDesign(problem, settings, Rivals::left_out, beginning).explanation();
}

}  // namespace sinew::diagnosis
