// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/trial.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>

#include "identification/regression/body_limits.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;

// Neighbouring rows say much the same; rows to this power is about the number of independent ones.
constexpr double kPriceExponent = 0.6;

const Candidate& candidate_at(const Design& design, int index) {
  return design.problem().library[static_cast<std::size_t>(index)];
}

/// Another form of a cause that the model has counts as well: one cause is named once.
bool taken(const Design& design, const Model& model, int candidate) {
  const Candidate& wanted = candidate_at(design, candidate);
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const Term& term) {
    return library_index(design, term) == candidate ||
           (!term.baseline && term.deviation < 0 && wanted.kind == CandidateKind::named &&
            term.candidate->name == wanted.name && term.candidate->place == wanted.place);
  });
}

Trial try_candidate(const Design& design, const Weights& weights, const Model& base,
                    const std::vector<bool>& violated_before, const Screened& screened) {
  const Candidate& candidate = candidate_at(design, screened.candidate);
  Trial trial;
  trial.candidate = screened.candidate;
  trial.model = base;
  append_term(design, weights, candidate, screened.nonlinear, trial.model);
  refine(design, weights, RefineScope::last_term, trial.model);
  const LinearFit fit = solve(stack(trial.model, weights));
  trial.allowed = !violates_limits(design, trial.model, fit, trial.model.terms.size() - 1);
  if (!trial.allowed) trial.refusal = candidate.limit_meaning;
  for (std::size_t t = 0; t < base.terms.size() && trial.allowed; ++t)
    if (!violated_before[t] && violates_limits(design, trial.model, fit, t)) {
      trial.allowed = false;
      trial.refusal = "it would make '" + base.terms[t].candidate->name + "' impossible";
    }
  return trial;
}

}  // namespace

NoiseView own_noise(const Design& design, const Model& model) {
  NoiseView view;
  view.noise = estimate_noise(design, model, {});
  view.weights = whitening(view.noise);
  return view;
}

NoiseView saturated_noise(const Design& design, const Library& library, const Model& model) {
  NoiseView view;
  view.noise = estimate_noise(design, model, library.representatives());
  view.weights = whitening(view.noise);
  return view;
}

void draw_surrogates(const Design& design, const Settings& settings, NoiseView& view) {
  view.surrogates = make_surrogates(design, view.noise, settings.surrogates, settings.seed);
}

double parameter_price(const Design& design) {
  double rows = 0.0;
  for (const Segment& s : design.segments())
    if (!s.holdout) rows += 2.0 * static_cast<double>(s.bins);
  return kPriceExponent * std::log(rows);
}

int library_index(const Design& design, const Term& term) {
  const std::vector<Candidate>& library = design.problem().library;
  if (term.deviation >= 0) return -1 - term.deviation;
  return term.baseline || library.empty() ? -1 : static_cast<int>(term.candidate - library.data());
}

double model_price(const Design& design, const std::vector<double>& freedom, const Model& model) {
  double sum = 0.0, unlikely = 0.0;
  for (const Term& term : model.terms)
    if (!term.baseline) {
      if (term.candidate->unlikely) unlikely += kUnlikely;
      sum += term.deviation >= 0 ? term.freedom
                                 : freedom[static_cast<std::size_t>(library_index(design, term))];
    }
  return sum * parameter_price(design) + unlikely;
}

bool is_beyond_limits(const Design& design, const Model& model, const LinearFit& fit,
                      std::size_t term) {
  const Term& t = model.terms[term];
  if (t.candidate->kind == CandidateKind::delay) {
    const NonlinearParameter& range = t.candidate->nonlinear.front();
    return t.nonlinear(0) <= range.low || t.nonlinear(0) >= range.high;
  }
  const auto layout = design.coefficients(*t.candidate);
  const Index first = first_columns(model)[term];
  for (std::size_t c = 0; c < layout.size(); ++c) {
    const LinearParameter& p = t.candidate->linear[static_cast<std::size_t>(layout[c].parameter)];
    const Index at = first + static_cast<Index>(c);
    // The slack forgives a wrong side by chance only.
    const double slack = 2.0 * std::sqrt(std::max(0.0, fit.covariance(at, at)));
    const double value = fit.coefficients(at);
    if (value < p.low - slack || value > p.high + slack) return true;
  }
  if (!t.candidate->possible) return false;
  const auto wide = static_cast<Index>(layout.size());
  return !t.candidate->possible(fit.coefficients.segment(first, wide), t.nonlinear);
}

bool violates_limits(const Design& design, const Model& model, const LinearFit& fit,
                     std::size_t term) {
  if (is_beyond_limits(design, model, fit, term)) return true;
  const std::optional<double>& within = model.terms[term].candidate->body_within;
  if (!within) return false;
  const auto n = static_cast<Index>(design.coefficients(*model.terms[term].candidate).size());
  const Index first = first_columns(model)[term];
  const Eigen::VectorXd errors =
      fit.covariance.diagonal().segment(first, n).cwiseMax(0.0).cwiseSqrt();
  return !is_body(fit.coefficients.segment(first, n), errors, *within);
}

double deviance(const Model& model, const Weights& weights) {
  return solve(stack(model, weights)).deviance;
}

std::vector<Screened> shortlist(const Design& design, const std::vector<double>& freedom,
                                const Model& model, const Screening& screening, std::size_t most) {
  std::vector<Screened> list;
  for (const Screened& s : screening.candidates)
    if (s.gate == Gate::open && candidate_at(design, s.candidate).kind != CandidateKind::flexible &&
        !taken(design, model, s.candidate))
      list.push_back(s);
  const double price = parameter_price(design);
  const auto worth = [&](const Screened& s) {
    return s.statistic - price * freedom[static_cast<std::size_t>(s.candidate)];
  };
  std::sort(list.begin(), list.end(),
            [&](const Screened& a, const Screened& b) { return worth(a) > worth(b); });
  if (list.size() > most) list.resize(most);
  return list;
}

std::vector<Trial> try_candidates(const Design& design, const Weights& weights, const Model& base,
                                  const std::vector<Screened>& list) {
  std::vector<bool> violated;
  const LinearFit fit = solve(stack(base, weights));
  for (std::size_t t = 0; t < base.terms.size(); ++t)
    violated.push_back(violates_limits(design, base, fit, t));
  std::vector<Trial> trials(list.size());
  tbb::parallel_for(0, static_cast<int>(list.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    trials[k] = try_candidate(design, weights, base, violated, list[k]);
  });
  return trials;
}

int rank_trials(const Design& design, const std::vector<double>& freedom, const Weights& weights,
                std::vector<Trial>& trials) {
  int best = -1;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!trials[i].allowed) continue;
    trials[i].deviance = deviance(trials[i].model, weights);
    trials[i].score = trials[i].deviance + model_price(design, freedom, trials[i].model);
    if (best < 0 || trials[i].score < trials[static_cast<std::size_t>(best)].score)
      best = static_cast<int>(i);
  }
  return best;
}

}  // namespace sinew::diagnosis
