// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/collinearity.h"

#include <algorithm>
#include <functional>

#include "identification/regression/held_bodies.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {

namespace {

using Asked = std::function<bool(const Term&)>;

bool is_of_library(const Term& term) {
  return !term.baseline && term.deviation < 0;
}

/// Among the terms asked about.
std::optional<std::size_t> first_collinear(const Design& design, const Settings& settings,
                                           const Weights& weights, const Model& model,
                                           const Asked& is_asked) {
  constexpr double kSmall = 0.15;   // of the large one's worth
  constexpr double kInvited = 3.0;  // times its own worth, without the large one
  constexpr double kOfImpacts = 0.005;
  const auto loss_without = [&](std::vector<std::size_t> terms) {
    Model rest = model;
    std::sort(terms.begin(), terms.end(), std::greater<>());
    for (const std::size_t t : terms) remove_term(design, t, rest);
    return cross_validate(design, rest, weights, settings.blocks).plain.sum();
  };
  const std::vector<Term>& terms = model.terms;
  if (std::none_of(terms.begin(), terms.end(), is_asked)) return {};
  const double all = loss_without({});
  std::vector<double> worth(terms.size(), 0.0);
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (is_of_library(terms[t]) || is_asked(terms[t])) worth[t] = loss_without({t}) - all;
  for (std::size_t t = 0; t < terms.size(); ++t)
    for (std::size_t u = 0; u < terms.size(); ++u) {
      if (t == u || !is_asked(terms[t]) || !is_of_library(terms[u]) ||
          worth[t] >= kSmall * worth[u])
        continue;
      // When an impact comes is known to a sample: what is left of each is large.
      if (terms[u].candidate->broadband && worth[t] < kOfImpacts * worth[u]) return t;
      if (loss_without({t, u}) - loss_without({u}) > kInvited * worth[t]) return t;
    }
  return {};
}

/// Where a term of the held model stands in the whole one.
std::size_t place_in(const Model& whole, std::size_t of_held) {
  for (std::size_t t = 0; t < whole.terms.size(); ++t)
    if (!is_of_body(whole.terms[t]) && of_held-- == 0) return t;
  return whole.terms.size();
}

}  // namespace

std::optional<std::size_t> find_collinear_term(const Design& design, const Settings& settings,
                                               const Weights& weights, const Model& model,
                                               CollinearAmong asked) {
  if (asked == CollinearAmong::causes)
    return first_collinear(design, settings, weights, model, is_of_library);
  const auto is_deviation = [](const Term& term) { return term.deviation >= 0; };
  // What a body changes has its form exactly, and would take over what it is unlikely to do.
  if (const auto found = first_collinear(design, settings, weights,
                                         hold_bodies(design, model, weights), is_deviation))
    return place_in(model, *found);
  return first_collinear(design, settings, weights, model,
                         [&](const Term& term) { return is_deviation(term) && is_of_body(term); });
}

}  // namespace sinew::diagnosis
