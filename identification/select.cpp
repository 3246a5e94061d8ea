// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/select.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/parallel_for.h"
#include "identification/refine.h"

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t kShortlist = 6;

const Candidate& candidate_at(const Design& design, int index) {
  return design.problem().library[static_cast<std::size_t>(index)];
}

bool taken(const Design& design, const Model& model, int candidate) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const Term& term) {
    return !term.baseline && library_index(design, term) == candidate;
  });
}

double deviance(const Design& design, const Model& model, const Weights& weights) {
  return solve(stack(design, model, weights)).deviance;
}

/// A model with one more cause, or with one exchanged, fully fitted.
struct Trial {
  int candidate = 0;
  Model model;
  double score = 0.0;  ///< deviance plus the price of its causes: smaller is better
  bool allowed = false;
};

double price(const Design& design, const Selection& state, const Model& model) {
  double sum = 0.0;
  for (const Term& term : model.terms)
    if (!term.baseline) sum += state.freedom[static_cast<std::size_t>(library_index(design, term))];
  return sum * complexity_price(design);
}

Trial try_candidate(const Design& design, const Selection& state, const Model& base,
                    const Screened& screened) {
  Trial trial{screened.candidate, base, 0.0, false};
  append_term(design, state.weights, candidate_at(design, screened.candidate), screened.nonlinear,
              trial.model);
  refine(design, state.weights, RefineScope::last_term, trial.model);
  const LinearFit fit = solve(stack(design, trial.model, state.weights));
  trial.allowed = !violates_limits(design, trial.model, fit, trial.model.terms.size() - 1);
  trial.score = fit.deviance + price(design, state, trial.model);
  return trial;
}

/// The best few of a screening, worth a nonlinear fit.
std::vector<Screened> shortlist(const Design& design, const Selection& state, const Model& model,
                                const Screening& screening) {
  std::vector<Screened> list;
  for (const Screened& s : screening.candidates)
    if (s.gate == Gate::open && candidate_at(design, s.candidate).kind != CandidateKind::flexible &&
        !taken(design, model, s.candidate))
      list.push_back(s);
  const auto worth = [&](const Screened& s) {
    return s.statistic -
           complexity_price(design) * state.freedom[static_cast<std::size_t>(s.candidate)];
  };
  std::sort(list.begin(), list.end(),
            [&](const Screened& a, const Screened& b) { return worth(a) > worth(b); });
  if (list.size() > kShortlist) list.resize(kShortlist);
  return list;
}

/// Best allowed trial; refused ones are noted with their reason.
std::optional<Trial> best_trial(const Design& design, const Settings& settings, const Model& base,
                                const std::vector<Screened>& list, Selection& state) {
  std::vector<Trial> trials(list.size());
  parallel_for(static_cast<int>(list.size()), settings.threads, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    trials[k] = try_candidate(design, state, base, list[k]);
  });
  std::optional<Trial> best;
  for (Trial& trial : trials) {
    if (!trial.allowed)
      state.refused.push_back(
          {trial.candidate, candidate_at(design, trial.candidate).limit_meaning});
    else if (!best || trial.score < best->score)
      best = std::move(trial);
  }
  return best;
}

/// Exchanges accepted causes for better ones as long as that helps.
bool swap_causes(const Design& design, const Library& library, const Settings& settings,
                 Selection& state) {
  bool swapped = false;
  double present = deviance(design, state.model, state.weights) + price(design, state, state.model);
  for (std::size_t t = 0; t < state.model.terms.size(); ++t) {
    if (state.model.terms[t].baseline) continue;
    const int own = library_index(design, state.model.terms[t]);
    Model without = state.model;
    remove_term(design, t, without);
    const Screening screening =
        screen(design, library, without, state.weights, {}, settings.threads);
    std::vector<Screened> list = shortlist(design, state, without, screening);
    std::erase_if(list, [own](const Screened& s) { return s.candidate == own; });
    if (list.size() > 3) list.resize(3);
    const std::optional<Trial> best = best_trial(design, settings, without, list, state);
    if (!best || best->score > present - 4.0) continue;
    state.model = best->model;
    refine(design, state.weights, RefineScope::all_terms, state.model);
    present = deviance(design, state.model, state.weights) + price(design, state, state.model);
    swapped = true;
    t = static_cast<std::size_t>(-1);
    if (--state.swaps_left <= 0) return swapped;
  }
  return swapped;
}

Evidence judge(const Design& design, const Settings& settings, const Selection& state,
               std::size_t term) {
  Evidence evidence;
  Model without = state.model;
  remove_term(design, term, without);
  evidence.statistic =
      deviance(design, without, state.weights) - deviance(design, state.model, state.weights);
  evidence.freedom =
      state.freedom[static_cast<std::size_t>(library_index(design, state.model.terms[term]))];
  const BlockLosses before = cross_validate(design, without, state.weights, settings.blocks);
  const BlockLosses after = cross_validate(design, state.model, state.weights, settings.blocks);
  evidence.validated = before.whitened.sum() - after.whitened.sum();
  evidence.gain = block_bootstrap_gain(before.plain, after.plain, 0.95, settings.seed);
  return evidence;
}

/// Takes out causes that the others have made superfluous or impossible.
void prune(const Design& design, const Settings& settings, Selection& state) {
  for (std::size_t t = 0; t < state.model.terms.size();) {
    if (state.model.terms[t].baseline) {
      ++t;
      continue;
    }
    const Evidence evidence = judge(design, settings, state, t);
    const LinearFit fit = solve(stack(design, state.model, state.weights));
    const bool impossible = violates_limits(design, state.model, fit, t);
    const bool superfluous = evidence.statistic < evidence.freedom * complexity_price(design) ||
                             evidence.validated <= 0.0 ||
                             evidence.gain.share < settings.least_share;
    if (!impossible && !superfluous) {
      ++t;
      continue;
    }
    const int index = library_index(design, state.model.terms[t]);
    state.refused.push_back({index, impossible
                                        ? candidate_at(design, index).limit_meaning
                                        : "no gain on left-out blocks beside the other causes"});
    remove_term(design, t, state.model);
    refine(design, state.weights, RefineScope::all_terms, state.model);
    t = 0;
  }
}

}  // namespace

double complexity_price(const Design& design) {
  double rows = 0.0;
  for (const Segment& s : design.segments())
    if (!s.holdout) rows += 2.0 * static_cast<double>(s.bins);
  return std::log(rows);
}

Model baseline_model(const Design& design) {
  Model model;
  model.advance.assign(design.segments().size(), 0.0);
  for (const Candidate& candidate : design.problem().baseline) {
    VectorXd start(static_cast<Index>(candidate.nonlinear.size()));
    const auto values = starting_values(candidate);
    if (start.size() > 0) start = values[values.size() / 2];
    model.terms.push_back(make_term(design, candidate, start, true));
  }
  return model;
}

int library_index(const Design& design, const Term& term) {
  const std::vector<Candidate>& library = design.problem().library;
  return term.baseline || library.empty() ? -1 : static_cast<int>(term.candidate - library.data());
}

bool violates_limits(const Design& design, const Model& model, const LinearFit& fit,
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
    const double slack = 2.0 * std::sqrt(std::max(0.0, fit.covariance(at, at)));
    const double value = fit.coefficients(at);
    // The estimate itself must be possible; the slack only forgives a wrong side by chance.
    if (value < p.low - slack || value > p.high + slack) return true;
  }
  return false;
}

void renew_noise(const Design& design, const Library& library, const Settings& settings,
                 Selection& state) {
  std::vector<const BandColumns*> saturating = library.representatives();
  state.noise = estimate_noise(design, state.model, saturating, settings.threads);
  state.weights = whitening(state.noise);
  state.surrogates =
      make_surrogates(design, state.noise, settings.surrogates, settings.seed, settings.threads);
}

Selection select_causes(const Design& design, const Library& library, const Settings& settings) {
  Selection state;
  state.model = baseline_model(design);
  renew_noise(design, library, settings, state);
  for (int step = 0; step < settings.most_causes; ++step) {
    state.last =
        screen(design, library, state.model, state.weights, state.surrogates, settings.threads);
    if (step == 0)
      for (const Screened& s : state.last.candidates) {
        state.freedom.push_back(s.freedom);
        state.first_surprise.push_back(s.surprise);
      }
    std::vector<Screened> list = shortlist(design, state, state.model, state.last);
    std::erase_if(list, [&](const Screened& s) {
      return state.last.family.p_value(s.surprise) > settings.significance;
    });
    const std::optional<Trial> best = best_trial(design, settings, state.model, list, state);
    if (!best) break;
    const std::size_t terms_before = state.model.terms.size();
    const Model before = state.model;
    state.model = best->model;
    refine(design, state.weights, RefineScope::all_terms, state.model);
    renew_noise(design, library, settings, state);
    state.swaps_left = 4;
    swap_causes(design, library, settings, state);
    prune(design, settings, state);
    if (state.model.terms.size() <= terms_before) {
      // Nothing was gained: what came in went out again, or pushed another out.
      if (state.model.terms.size() < terms_before) state.model = before;
      renew_noise(design, library, settings, state);
      break;
    }
  }
  state.last =
      screen(design, library, state.model, state.weights, state.surrogates, settings.threads);
  state.evidence.assign(state.model.terms.size(), {});
  for (std::size_t t = 0; t < state.model.terms.size(); ++t)
    if (!state.model.terms[t].baseline) state.evidence[t] = judge(design, settings, state, t);
  return state;
}

}  // namespace sinew
