// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/sensor_play.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>

#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"
#include "identification/regression/starting_values.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Half of what is left makes a name, after all parameters were fitted: a start of the search on
// its grid has to take less.
constexpr double kGoodPart = 0.2;

/// Left over per channel, all frequencies alike.
VectorXd left_over(const Design& design, const Model& model, const Weights& even) {
  const Stack rows = stack(model, even);
  const VectorXd residual = solve(rows).residual;
  VectorXd energy = VectorXd::Zero(design.problem().channels);
  for (std::size_t s = 0; s < design.segments().size(); ++s)
    energy(design.segments()[s].channel) +=
        residual.segment(rows.first_row[s], rows.first_row[s + 1] - rows.first_row[s])
            .squaredNorm();
  return energy;
}

/// The terms of a model of another design, at their nonlinear parameters.
Model same_terms(const Design& design, const Weights& even, const Model& found) {
  Model model = baseline_model(design);
  model.terms.clear();
  for (const Term& term : found.terms)
    if (term.candidate->kind != CandidateKind::delay)
      model.terms.push_back(make_term(design, *term.candidate, term.nonlinear, term.baseline));
  for (const Term& term : found.terms)
    if (term.candidate->kind == CandidateKind::delay)
      append_term(design, even, *term.candidate, term.nonlinear, model);
  return model;
}

}  // namespace

bool may_have_play(const Design& design, const Model& found, const std::vector<int>& plays) {
  if (plays.empty()) return false;
  const Weights even = even_weights(design);
  std::atomic<bool> any = false;
  for (const Model& base : {baseline_model(design), same_terms(design, even, found)}) {
    const VectorXd without = left_over(design, base, even);
    tbb::parallel_for(0, static_cast<int>(plays.size()), [&](int i) {
      const auto index = static_cast<std::size_t>(plays[static_cast<std::size_t>(i)]);
      const Candidate& play = design.problem().library[index];
      Model beside = base;
      beside.terms.emplace_back();
      for (const VectorXd& start : starting_values(play)) {
        if (any) return;
        beside.terms.back() = make_term(design, play, start, false);
        const VectorXd with = left_over(design, beside, even);
        if (((without - with).array() > kGoodPart * without.array()).any()) any = true;
      }
    });
    if (any) return true;
  }
  return false;
}

}  // namespace sinew::diagnosis
