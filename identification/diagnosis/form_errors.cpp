// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/form_errors.h"

#include <cmath>

#include "identification/diagnosis/standard_errors.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Estimates = std::vector<ParameterEstimate>;

/// Either of two values is the right one.
void widen(double difference, ParameterEstimate& estimate) {
  estimate.standard_error = std::hypot(estimate.standard_error, difference / std::sqrt(2.0));
}

/// Coefficients of one term where it has the other form.
VectorXd with_other_form(const Design& design, const Model& model, const Weights& weights,
                         std::size_t term) {
  Candidate other = *model.terms[term].candidate;
  other.columns = other.other_form;
  Model changed = model;
  changed.terms[term].columns = design.columns(other, model.terms[term].nonlinear);
  const std::vector<Index> first = first_columns(changed);
  return solve(stack(changed, weights))
      .coefficients.segment(first[term], first[term + 1] - first[term]);
}

/// Those of shared coefficients come first, in their order.
void add_other_form(const Design& design, const Model& model, const Weights& weights,
                    std::size_t term, Estimates& estimates) {
  const VectorXd other = with_other_form(design, model, weights, term);
  const auto count = static_cast<Index>(model.terms[term].candidate->linear.size());
  if (other.size() != count || static_cast<Index>(estimates.size()) < count) return;
  for (Index c = 0; c < count; ++c) {
    ParameterEstimate& own = estimates[static_cast<std::size_t>(c)];
    widen(other(c) - own.value, own);
  }
}

}  // namespace

std::vector<std::vector<ParameterEstimate>> told_estimates(const Design& design, const Model& model,
                                                           const NoiseView& noise) {
  std::vector<Estimates> all = estimates(design, model, noise, NoiseErrors::of_stretches_too);
  for (std::size_t t = 0; t < all.size(); ++t) {
    const Candidate& candidate = *model.terms[t].candidate;
    if (model.terms[t].baseline) continue;
    if (candidate.other_form) add_other_form(design, model, noise.weights, t, all[t]);
    if (candidate.sized_twice && all[t].size() == 2) {
      const double difference = all[t][0].value - all[t][1].value;
      for (ParameterEstimate& size : all[t]) widen(difference, size);
    }
  }
  return all;
}

}  // namespace sinew::diagnosis
