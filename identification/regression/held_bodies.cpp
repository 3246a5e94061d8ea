// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/held_bodies.h"

#include <algorithm>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void add_part(const Design& design, const BandColumns& columns, const VectorXd& coefficients,
              std::vector<VectorXd>& sum) {
  if (sum.empty())
    for (const Segment& s : design.segments()) sum.push_back(VectorXd::Zero(2 * s.bins));
  for (std::size_t s = 0; s < columns.size(); ++s)
    if (columns[s].cols() > 0) sum[s] += columns[s] * coefficients;
}

SharedColumns term_rate(const Design& design, const Term& term) {
  return term.columns.rates([&] { return design.columns(*term.candidate, term.nonlinear, 1); });
}

}  // namespace

bool is_of_body(const Term& term) {
  return term.candidate->of_body;
}

Model hold_bodies(const Design& design, const Model& model, const Weights& weights) {
  if (std::none_of(model.terms.begin(), model.terms.end(), is_of_body)) return model;
  const VectorXd coefficients = solve(stack(model, weights)).coefficients;
  const std::vector<Index> first = first_columns(model);
  Model held = model;
  const bool delayed = std::any_of(model.terms.begin(), model.terms.end(), [](const Term& t) {
    return t.candidate->kind == CandidateKind::delay;
  });
  for (std::size_t t = model.terms.size(); t-- > 0;) {
    const Term& term = model.terms[t];
    if (!is_of_body(term)) continue;
    const VectorXd own = coefficients.segment(first[t], first[t + 1] - first[t]);
    add_part(design, term.columns, own, held.fixed.value);
    if (delayed)  // nothing else asks for rates
      add_part(design, term_rate(design, term), own, held.fixed.rate);
    for (std::size_t s = 0; s < term.columns.size(); ++s)
      if (term.columns[s].cols() > 0) held.target[s] -= term.columns[s] * own;
    held.terms.erase(held.terms.begin() + static_cast<std::ptrdiff_t>(t));
  }
  return held;
}

}  // namespace sinew::diagnosis
