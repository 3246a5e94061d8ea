// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/form_errors.h"

#include <cmath>

#include "identification/diagnosis/standard_errors.h"

namespace sinew::diagnosis {
namespace {

using Estimates = std::vector<ParameterEstimate>;

/// Either of two values is the right one.
void widen(double difference, ParameterEstimate& estimate) {
  estimate.standard_error = std::hypot(estimate.standard_error, difference / std::sqrt(2.0));
}

}  // namespace

std::vector<std::vector<ParameterEstimate>> told_estimates(const Design& design, const Model& model,
                                                           const NoiseView& noise) {
  std::vector<Estimates> all = estimates(design, model, noise, NoiseErrors::of_stretches_too);
  for (std::size_t t = 0; t < all.size(); ++t) {
    const Candidate& candidate = *model.terms[t].candidate;
    if (model.terms[t].baseline) continue;
    if (candidate.sized_twice && all[t].size() == 2) {
      const double difference = all[t][0].value - all[t][1].value;
      for (ParameterEstimate& size : all[t]) widen(difference, size);
    }
  }
  return all;
}

}  // namespace sinew::diagnosis
