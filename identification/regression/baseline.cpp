// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/baseline.h"

#include <algorithm>
#include <cmath>

#include "identification/regression/refine.h"
#include "identification/regression/starting_values.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

/// Best starting value of every nonlinear baseline parameter, term by term, unweighted.
void choose_starts(const Design& design, Model& model) {
  const Weights even = even_weights(design);
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    if (model.terms[t].nonlinear.size() == 0) continue;
    Term best = model.terms[t];
    double least = deviance(model, even);
    for (const VectorXd& value : starting_values(*best.candidate)) {
      model.terms[t] = make_term(design, *best.candidate, value, true);
      const double loss = deviance(model, even);
      if (loss >= least) continue;
      least = loss;
      best = model.terms[t];
    }
    model.terms[t] = best;
  }
}

/// A nuisance with a physical limit and a shape of its own, as how friction turns at a reversal.
bool is_limited_nuisance(const Term& term) {
  const auto limited = [](const LinearParameter& p) {
    return std::isfinite(p.low) || std::isfinite(p.high);
  };
  const auto& linear = term.candidate->linear;
  return term.baseline && term.nonlinear.size() > 0 &&
         std::any_of(linear.begin(), linear.end(), limited);
}

/// Such a nuisance that stands on the wrong side of its limits is where another nonlinear term of
/// its place has left it no room: from every start of its own, and with the others of the place at
/// their first. Without it where that does not help.
void bring_within_limits(const Design& design, const Weights& weights, std::size_t term,
                         Model& model) {
  const Term own = model.terms[term];
  Model best = model;
  remove_term(design, term, best);
  refine(design, weights, best);
  double least = deviance(best, weights);
  for (const VectorXd& start : starting_values(*own.candidate)) {
    Model trial = model;
    for (Term& t : trial.terms)
      if (t.baseline && t.nonlinear.size() > 0 && t.candidate->place == own.candidate->place)
        t = make_term(design, *t.candidate, starting_values(*t.candidate).front(), true);
    trial.terms[term] = make_term(design, *own.candidate, start, true);
    refine(design, weights, trial);
    const LinearFit fit = solve(stack(trial, weights));
    if (violates_limits(design, trial, fit, term) || fit.deviance >= least) continue;
    least = fit.deviance;
    best = std::move(trial);
  }
  model = std::move(best);
}

/// What is fitted to next to nothing in the training logs may be anything in a held-out log.
bool is_seen(const Design& design, const Weights& weights, std::size_t term, const Model& model) {
  constexpr double kSeen = 12.0;  // drop of the whitened deviance, two parameters
  Model without = model;
  remove_term(design, term, without);
  return deviance(without, weights) - deviance(model, weights) >= kSeen;
}

}  // namespace

Model baseline_model(const Design& design) {
  Model model;
  model.advance.assign(design.segments().size(), 0.0);
  for (std::size_t s = 0; s < design.segments().size(); ++s)
    model.target.push_back(design.target(static_cast<int>(s)));
  for (const Candidate& candidate : design.problem().baseline) {
    const std::vector<VectorXd> values = starting_values(candidate);
    model.terms.push_back(make_term(design, candidate, values[values.size() / 2], true));
  }
  choose_starts(design, model);
  return model;
}

void settle_nuisances(const Design& design, const Weights& weights, Model& model) {
  for (std::size_t t = model.terms.size(); t-- > 0;)
    if (is_limited_nuisance(model.terms[t]) &&
        violates_limits(design, model, solve(stack(model, weights)), t))
      bring_within_limits(design, weights, t, model);
  for (std::size_t t = model.terms.size(); t-- > 0;)
    if (is_limited_nuisance(model.terms[t]) && !is_seen(design, weights, t, model))
      remove_term(design, t, model);
}

}  // namespace sinew::diagnosis
