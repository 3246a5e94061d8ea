// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/adopted_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/diagnosis/standard_errors.h"
#include "identification/regression/held_bodies.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

std::string called(const Term& term) {
  return fmt::format("{} ({})", term.candidate->name, term.candidate->place);
}

bool all_finite(const std::vector<ParameterEstimate>& estimates) {
  for (const ParameterEstimate& e : estimates)
    if (!std::isfinite(e.value) || !std::isfinite(e.standard_error)) return false;
  return true;
}

/// Why the fit has an impossible cause in this term; empty: it has none.
std::string why_not(const Design& design, const Model& model, const LinearFit& fit,
                    std::size_t term, const std::vector<ParameterEstimate>& estimates) {
  if (!all_finite(estimates)) return "these logs leave its size open";
  // What is no body as it was fitted becomes the nearest one (physical_links.h).
  if (model.terms[term].candidate->body_within) return {};
  if (!violates_limits(design, model, fit, term)) return {};
  const std::string& limit = model.terms[term].candidate->limit_meaning;
  return limit.empty() ? "beside the other causes it is beyond its limits" : limit;
}

/// The model's own, and what is fitted in any case, are no causes.
bool is_cause(const Term& term) {
  return !term.baseline && !term.candidate->nuisance;
}

struct Impossible {
  std::size_t term = 0;
  std::string why;
};

std::optional<Impossible> first_impossible(const Design& design, const Selection& selection) {
  const Model& model = selection.model;
  if (model.terms.empty()) return std::nullopt;
  const auto all = estimates(design, model, selection.noise);
  const LinearFit fit = solve(stack(model, selection.noise.weights));
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    if (!is_cause(model.terms[t])) continue;
    const std::string why = why_not(design, model, fit, t, all[t]);
    if (!why.empty()) return Impossible{t, why};
  }
  return std::nullopt;
}

bool acts_on(const Design& design, const Term& term, int channel) {
  for (std::size_t s = 0; s < term.columns.size(); ++s)
    if (design.segments()[s].channel == channel && term.columns[s].cols() > 0) return true;
  return false;
}

double loss_at(const Design& design, const Settings& settings, const Model& model,
               const Weights& weights, int channel) {
  return held_out(design, model, solve(stack(model, weights)), settings.blocks)
      .plain.col(channel)
      .sum();
}

}  // namespace

int cause_of(const Verdict& verdict, int candidate) {
  for (std::size_t c = 0; c < verdict.causes.size(); ++c) {
    const NamedCause& cause = verdict.causes[c];
    if (cause.candidate == candidate ||
        std::find(cause.also.begin(), cause.also.end(), candidate) != cause.also.end())
      return static_cast<int>(c);
  }
  return -1;
}

AdoptedFit possible_fit(const Design& design, const Explanation& explanation) {
  AdoptedFit fit{design.problem().deviations.empty() ? explanation.selection : explanation.adopted,
                 {}};
  while (const auto first = first_impossible(design, fit.selection)) {
    Model& model = fit.selection.model;
    fit.refused.push_back(called(model.terms[first->term]) + " cannot be adopted: " + first->why);
    remove_term(design, first->term, model);
  }
  return fit;
}

bool leave_out_harmful(const Design& design, const Settings& settings, int channel,
                       const std::string& channel_name, AdoptedFit& fit) {
  Model& model = fit.selection.model;
  const Weights& weights = fit.selection.noise.weights;
  double least = loss_at(design, settings, model, weights, channel);
  std::optional<std::size_t> harmful;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    if (!is_cause(model.terms[t]) || !acts_on(design, model.terms[t], channel)) continue;
    Model without = model;
    remove_term(design, t, without);
    const double loss = loss_at(design, settings, without, weights, channel);
    if (loss >= least) continue;
    least = loss;
    harmful = t;
  }
  if (!harmful) return false;
  fit.refused.push_back(
      fmt::format("{} is not adopted: with it the held-out error of '{}' would grow",
                  called(model.terms[*harmful]), channel_name));
  remove_term(design, *harmful, model);
  return true;
}

}  // namespace sinew::diagnosis
