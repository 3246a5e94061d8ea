// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/explained_structure.h"

#include <algorithm>

#include "identification/diagnosis/deviation_terms.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

double own_loss(const Design& design, const Settings& settings, const Model& model) {
  const NoiseView noise = own_noise(design, model);
  return cross_validate(design, model, noise.weights, settings.blocks).plain.sum();
}

/// What a term is worth in a model, by the loss without it.
double worth(const Design& design, const Settings& settings, const Model& model, std::size_t term) {
  const NoiseView noise = own_noise(design, model);
  Model without = model;
  remove_term(design, term, without);
  return cross_validate(design, without, noise.weights, settings.blocks).plain.sum() -
         cross_validate(design, model, noise.weights, settings.blocks).plain.sum();
}

Model without_causes(const Design& design, Model model) {
  for (std::size_t t = model.terms.size(); t-- > 0;)
    if (!model.terms[t].baseline && !model.terms[t].candidate->nuisance)
      remove_term(design, t, model);
  return model;
}

}  // namespace

ExplainedStructure explained_structure_of(const Design& design, const Settings& settings,
                                          const Selection& adopted, const Selection& selection,
                                          const Structure& structure) {
  ExplainedStructure result;
  const DeviationTerms plain = take_apart(design, without_causes(design, selection.model));
  const double nothing = own_loss(design, settings, plain.base);
  const double named = own_loss(design, settings, adopted.model);
  const double all = named * structure.left;
  result.named_share =
      nothing > all ? std::clamp((nothing - named) / (nothing - all), 0.0, 1.0) : 0.0;
  if (result.named_share >= kNamesHold) return result;
  DeviationTerms wide = take_apart(design, structure.beside);
  Model beside = wide.base;
  std::vector<std::size_t> at;
  for (std::size_t t = 0; t < adopted.model.terms.size(); ++t) {
    const Term& term = adopted.model.terms[t];
    if (term.deviation < 0) continue;
    at.push_back(t);
    beside.terms.push_back(wide.deviations[static_cast<std::size_t>(term.deviation)]);
    beside.terms.back().freedom = term.freedom;
  }
  const std::size_t first = beside.terms.size() - at.size();
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double alone = worth(design, settings, adopted.model, at[i]);
    if (alone < named - all || worth(design, settings, beside, first + i) < kStandsAlone * alone)
      result.displaced.push_back(adopted.model.terms[at[i]].deviation);
  }
  return result;
}

}  // namespace sinew::diagnosis
