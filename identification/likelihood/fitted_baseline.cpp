// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/fitted_baseline.h"

#include "identification/regression/baseline.h"
#include "identification/regression/noise_model.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

void append_nuisances(const Design& design, bool flexible, Model& model) {
  for (const Candidate& c : design.problem().library)
    if (c.nuisance && c.nonlinear.empty() && (c.kind == CandidateKind::flexible) == flexible)
      model.terms.push_back(make_term(design, c, {}, false));
}

}  // namespace

Model fitted_baseline(const Design& design) {
  Model model = baseline_model(design);
  append_nuisances(design, false, model);
  Weights weights = own_noise(design, model).weights;
  refine(design, weights, model);
  weights = own_noise(design, model).weights;
  settle_nuisances(design, weights, model);
  // Free curves follow friction whatever its own shape is, and would leave that to chance.
  append_nuisances(design, true, model);
  return model;
}

std::vector<BaselineShape> shapes_of(const Problem& problem, const Model& baseline) {
  std::vector<BaselineShape> shapes;
  for (const Term& term : baseline.terms) {
    const std::vector<Candidate>& list = term.baseline ? problem.baseline : problem.library;
    shapes.push_back(
        {!term.baseline, static_cast<std::size_t>(term.candidate - list.data()), term.nonlinear});
  }
  return shapes;
}

Model baseline_with(const Design& design, const std::vector<BaselineShape>& shapes) {
  const Problem& problem = design.problem();
  Model model;
  model.advance.assign(design.segments().size(), 0.0);
  for (std::size_t s = 0; s < design.segments().size(); ++s)
    model.target.push_back(design.target(static_cast<int>(s)));
  for (const BaselineShape& shape : shapes)
    model.terms.push_back(make_term(
        design,
        shape.of_library ? problem.library[shape.candidate] : problem.baseline[shape.candidate],
        shape.nonlinear, !shape.of_library));
  return model;
}

}  // namespace sinew::diagnosis
