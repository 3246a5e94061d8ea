// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/fewer_causes.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <functional>

#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

constexpr std::size_t kRefits = 5;
constexpr double kAnotherName = 4.0;  // deviance that one more name must be worth

bool is_cause(const Term& term) {
  return !term.baseline && (term.deviation >= 0 || term.candidate->kind == CandidateKind::named);
}

/// The search's fixed surroundings.
struct Reduction {
  const Design& design;
  const Library& library;
  const Settings& settings;
  const Selection& adopted;

  const Weights& weights() const { return adopted.noise.weights; }
  double price(const Term& term) const {
    const int index = library_index(design, term);
    const double freedom =
        term.deviation >= 0 ? term.freedom : adopted.freedom[static_cast<std::size_t>(index)];
    return freedom * parameter_price(design) +
           (term.candidate->unlikely && !term.candidate->of_body ? kUnlikely : kAnotherName);
  }
  double score(const Model& model) const {
    double sum = deviance(model, weights());
    for (const Term& term : model.terms)
      if (is_cause(term)) sum += price(term);
    return sum;
  }
};

/// A model with other causes, and its score.
struct Alternative {
  FewerCauses causes;
  Model model;
  double score = 0.0;
  bool allowed = false;  ///< keeps the new cause's limits
};

/// Causes that act on a channel, by their places in the model.
std::vector<std::size_t> causes_at(const Reduction& s, int channel) {
  std::vector<std::size_t> list;
  const std::vector<Term>& terms = s.adopted.model.terms;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!is_cause(terms[t])) continue;
    for (std::size_t k = 0; k < s.design.segments().size(); ++k)
      if (s.design.segments()[k].channel == channel && terms[t].columns[k].cols() > 0) {
        list.push_back(t);
        break;
      }
  }
  return list;
}

/// Those that go and are worth their price beside the new one come back.
void withdraw_group(const Reduction& s, const std::vector<std::size_t>& group, Alternative& trial) {
  std::vector<std::size_t> out = group;
  for (;;) {
    Model best;
    std::size_t taken = 0;
    double least = trial.score;
    for (std::size_t i = 0; i < out.size(); ++i) {
      Model more = trial.model;
      more.terms.push_back(s.adopted.model.terms[out[i]]);
      const double score = s.score(more);
      if (score >= least) continue;
      least = score;
      best = std::move(more);
      taken = i;
    }
    if (best.terms.empty()) break;
    trial.model = std::move(best);
    trial.score = least;
    out.erase(out.begin() + static_cast<std::ptrdiff_t>(taken));
  }
  for (const std::size_t t : out) {
    trial.causes.replaced.push_back(library_index(s.design, s.adopted.model.terms[t]));
    trial.causes.p_family = std::min(trial.causes.p_family, s.adopted.evidence[t].p_family);
  }
}

/// It is a value of the model as well, which says more: there all others are the model's own.
bool is_value(const Problem& problem, const Candidate& candidate) {
  return std::any_of(problem.deviations.begin(), problem.deviations.end(),
                     [&](const ParameterDeviation& deviation) {
                       return deviation.name == candidate.name &&
                              deviation.place == candidate.place &&
                              deviation.parameters.size() == candidate.linear.size();
                     });
}

/// Candidates and values of the model that explain most where the group is missing.
std::vector<Alternative> alternatives(const Reduction& s, const std::vector<std::size_t>& group) {
  Model without = s.adopted.model;
  for (std::size_t i = group.size(); i-- > 0;) remove_term(s.design, group[i], without);
  std::vector<Alternative> list;
  const auto is_in_group = [&](int index) {
    return std::any_of(group.begin(), group.end(), [&](std::size_t t) {
      return library_index(s.design, s.adopted.model.terms[t]) == index;
    });
  };
  const auto add = [&](int index, const std::function<void(Model&)>& append) {
    if (is_in_group(index)) return;
    Alternative trial{{index, {}, 1.0}, without, 0.0, false};
    append(trial.model);
    list.push_back(std::move(trial));
  };
  const Screening screening = screen(s.design, s.library, without, s.weights(), {});
  for (const Screened& c : shortlist(s.design, s.adopted.freedom, without, screening, kRefits)) {
    const Candidate& candidate = s.design.problem().library[static_cast<std::size_t>(c.candidate)];
    if (candidate.kind != CandidateKind::named || is_value(s.design.problem(), candidate)) continue;
    add(c.candidate,
        [&](Model& model) { append_term(s.design, s.weights(), candidate, c.nonlinear, model); });
  }
  for (const Term& deviation : s.adopted.deviations)
    add(-1 - deviation.deviation, [&](Model& model) { model.terms.push_back(deviation); });
  return list;
}

/// The best replacement of a group, if it is better than what there is.
std::optional<Alternative> best_instead(const Reduction& s, const std::vector<std::size_t>& group,
                                        double present) {
  std::vector<Alternative> trials = alternatives(s, group);
  tbb::parallel_for(0, static_cast<int>(trials.size()), [&](int i) {
    Alternative& trial = trials[static_cast<std::size_t>(i)];
    refine(s.design, s.weights(), RefineScope::last_term, trial.model);
    const LinearFit fit = solve(stack(trial.model, s.weights()));
    trial.allowed = !violates_limits(s.design, trial.model, fit, trial.model.terms.size() - 1);
    trial.score = s.score(trial.model);
    if (trial.allowed) withdraw_group(s, group, trial);
  });
  std::optional<Alternative> best;
  for (Alternative& trial : trials) {
    if (!trial.allowed) continue;
    if (trial.causes.replaced.size() < 2 || trial.score >= present) continue;
    if (!best || trial.score < best->score) best = std::move(trial);
  }
  return best;
}

}  // namespace

std::optional<FewerCauses> find_fewer_causes(const Design& design, const Library& library,
                                             const Settings& settings, const Selection& adopted) {
  const Reduction s{design, library, settings, adopted};
  const double present = s.score(adopted.model);
  std::optional<Alternative> best;
  std::vector<std::vector<std::size_t>> seen;
  for (int c = 0; c < design.problem().channels; ++c) {
    const std::vector<std::size_t> group = causes_at(s, c);
    if (group.size() < 2 || std::count(seen.begin(), seen.end(), group) > 0) continue;
    seen.push_back(group);
    std::optional<Alternative> found = best_instead(s, group, present);
    if (found && (!best || found->score < best->score)) best = std::move(found);
  }
  if (!best) return {};
  return best->causes;
}

Selection replace_causes(const Design& design, const Library& library, const Settings& settings,
                         const Selection& found, const FewerCauses& fewer) {
  Selection state = found;
  for (const int index : fewer.replaced) {
    if (index < 0) continue;
    for (std::size_t t = state.model.terms.size(); t-- > 0;)
      if (!state.model.terms[t].baseline && library_index(design, state.model.terms[t]) == index)
        remove_term(design, t, state.model);
  }
  if (fewer.candidate >= 0) {
    const auto index = static_cast<std::size_t>(fewer.candidate);
    const Candidate& candidate = design.problem().library[index];
    const Screening screening = screen(design, library, state.model, state.noise.weights, {});
    append_term(design, state.noise.weights, candidate, screening.candidates[index].nonlinear,
                state.model);
    refine(design, state.noise.weights, RefineScope::last_term, state.model);
    state.p_family[index] = fewer.p_family;
    state.exchanged.push_back(fewer.candidate);
  }
  refine(design, state.noise.weights, RefineScope::all_terms, state.model);
  state.noise = own_noise(design, state.model);
  conclude(design, library, settings, state);
  return state;
}

}  // namespace sinew::diagnosis
