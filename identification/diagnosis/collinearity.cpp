// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/collinearity.h"

#include <algorithm>
#include <functional>

#include "identification/regression/refine.h"

namespace sinew::diagnosis {

std::optional<std::size_t> find_collinear_term(const Design& design, const Settings& settings,
                                               const Weights& weights, const Model& model,
                                               CollinearAmong asked) {
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
  const auto is_cause = [&](std::size_t t) { return !terms[t].baseline && terms[t].deviation < 0; };
  const auto is_asked = [&](std::size_t t) {
    return asked == CollinearAmong::deviations ? terms[t].deviation >= 0 : is_cause(t);
  };
  const double all = loss_without({});
  std::vector<double> worth(terms.size(), 0.0);
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (is_cause(t) || is_asked(t)) worth[t] = loss_without({t}) - all;
  for (std::size_t t = 0; t < terms.size(); ++t)
    for (std::size_t u = 0; u < terms.size(); ++u) {
      if (t == u || !is_asked(t) || !is_cause(u) || worth[t] >= kSmall * worth[u]) continue;
      // When an impact comes is known to a sample: what is left of each is large.
      if (terms[u].candidate->broadband && worth[t] < kOfImpacts * worth[u]) return t;
      if (loss_without({t, u}) - loss_without({u}) > kInvited * worth[t]) return t;
    }
  return {};
}

}  // namespace sinew::diagnosis
