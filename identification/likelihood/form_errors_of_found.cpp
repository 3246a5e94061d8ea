// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/form_errors_of_found.h"

#include <algorithm>
#include <utility>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What the terms of one form say of every segment, in the band; empty where none acts.
std::vector<VectorXd> said_by_laws(const Model& model, const VectorXd& coefficients,
                                   std::size_t first) {
  const std::vector<Index> column = first_columns(model);
  std::vector<VectorXd> sum(model.target.size());
  for (std::size_t t = first; t < model.terms.size(); ++t) {
    if (has_any_form(*model.terms[t].candidate, model.terms[t].deviation >= 0)) continue;
    for (std::size_t s = 0; s < sum.size(); ++s) {
      const Eigen::MatrixXd& columns = model.terms[t].columns[s];
      if (columns.cols() == 0) continue;
      const VectorXd own = columns * coefficients.segment(column[t], columns.cols());
      sum[s] = sum[s].size() == 0 ? own : VectorXd(sum[s] + own);
    }
  }
  return sum;
}

/// What is said that the free model cannot say, its coefficients fitted to it under the weights.
std::vector<VectorXd> beyond(Model free, std::vector<VectorXd> said, const Weights& weights) {
  for (std::size_t s = 0; s < said.size(); ++s)
    free.target[s] =
        said[s].size() == 0 ? VectorXd(VectorXd::Zero(free.target[s].size())) : said[s];
  const VectorXd taken = solve(stack(free, weights)).coefficients;
  const std::vector<Index> column = first_columns(free);
  for (std::size_t s = 0; s < said.size(); ++s)
    for (std::size_t t = 0; t < free.terms.size() && said[s].size() > 0; ++t) {
      const Eigen::MatrixXd& columns = free.terms[t].columns[s];
      if (columns.cols() > 0) said[s] -= columns * taken.segment(column[t], columns.cols());
    }
  return said;
}

/// What the form is off by, as the variance of every row.
VectorXd form_variance(const VectorXd& said) {
  constexpr Index least = 4;     // bins
  constexpr double width = 0.3;  // of the frequency
  const VectorXd energy = bin_energy(said);
  return per_row(0.5 * kFormError * kFormError *
                 smooth_ratio(energy, VectorXd::Ones(energy.size()), least, width));
}

}  // namespace

Whitening with_form_errors(const Whitening& noise, const Model& model, std::size_t first,
                           Model free) {
  Whitening all = noise;
  all.noise_share.resize(noise.training.size());
  const LinearFit fit = solve(stack(model, noise.training));
  const std::vector<VectorXd> said =
      beyond(std::move(free), said_by_laws(model, fit.coefficients, first), noise.training);
  for (Weights* weights : {&all.training, &all.held_out})
    for (std::size_t s = 0; s < weights->size(); ++s) {
      VectorXd& weight = (*weights)[s];
      if (weight.size() == 0 || said[s].size() == 0) continue;
      const VectorXd alone = weight;
      weight = (alone.array().square().inverse() + form_variance(said[s]).array()).rsqrt().matrix();
      all.noise_share[s] = weight.cwiseQuotient(alone);
    }
  return all;
}

}  // namespace sinew::diagnosis
