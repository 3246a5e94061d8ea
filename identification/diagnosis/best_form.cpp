// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/best_form.h"

#include <algorithm>
#include <utility>

#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

/// The most promising starts of a form of term `t`, which stands last in each: fitting all of them
/// would take long where a form remembers.
std::vector<Model> begun_elsewhere(const Design& design, const Weights& weights, const Model& model,
                                   std::size_t t, const Candidate& form) {
  constexpr std::size_t kPromising = 4;
  std::vector<std::pair<double, Model>> trials;
  for (const VectorXd& start : starting_values(form)) {
    Model trial = model;
    trial.terms[t] = make_term(design, form, start, false);
    const auto at = trial.terms.begin() + static_cast<std::ptrdiff_t>(t);
    std::rotate(at, at + 1, trial.terms.end());
    const double now = deviance(trial, weights);
    trials.emplace_back(now, std::move(trial));
    std::stable_sort(trials.begin(), trials.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (trials.size() > kPromising) trials.pop_back();
  }
  std::vector<Model> models;
  for (auto& [deviance, trial] : trials) models.push_back(std::move(trial));
  return models;
}

}  // namespace

bool is_free(const NonlinearParameter& p) {
  return p.high > p.low;
}

bool has_free_shape(const Term& term) {
  if (term.nonlinear.size() == 0 || term.candidate->kind == CandidateKind::delay) return false;
  const auto& shapes = term.candidate->nonlinear;
  return std::any_of(shapes.begin(), shapes.end(), is_free);
}

Model best_form(const Design& design, const Weights& weights, const Model& model,
                const std::function<bool(const Term&)>& asked) {
  const std::vector<Candidate>& library = design.problem().library;
  Model best = model;
  double least = deviance(model, weights);
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Term& own = model.terms[t];
    if (own.baseline || own.deviation >= 0 || !has_free_shape(own) || !asked(own)) continue;
    for (const Candidate& form : library) {
      if (form.name != own.candidate->name || form.place != own.candidate->place) continue;
      for (Model& trial : begun_elsewhere(design, weights, model, t, form)) {
        refine(design, weights, RefineScope::last_term, trial);
        const LinearFit fit = solve(stack(trial, weights));
        if (violates_limits(design, trial, fit, trial.terms.size() - 1)) continue;
        const double now = deviance(trial, weights);
        if (now >= least) continue;
        least = now;
        std::rotate(trial.terms.begin() + static_cast<std::ptrdiff_t>(t), trial.terms.end() - 1,
                    trial.terms.end());
        best = std::move(trial);
      }
    }
  }
  return best;
}

}  // namespace sinew::diagnosis
