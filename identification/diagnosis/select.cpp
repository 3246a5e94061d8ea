// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/select.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "identification/diagnosis/best_form.h"
#include "identification/diagnosis/collinearity.h"
#include "identification/diagnosis/standard_errors.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t kShortlist = 6;
constexpr double kWorthSwapping = 4.0;  // deviance; less is chance

/// The search's fixed surroundings.
struct Search {
  const Design& design;
  const Library& library;
  const Settings& settings;
  Selection& state;
};

void renew_noise(const Search& s) {
  s.state.noise = own_noise(s.design, s.state.model);
}

/// Candidates worth a fit: the best under the noise the whole library leaves over (which a
/// strong effect cannot hide in) and under the noise the model leaves over (which does not
/// mistake the next effect's trace for its own).
std::vector<Screened> promising(const Search& s, const NoiseView& saturated) {
  const Screening alone =
      screen(s.design, s.library, s.state.model, saturated.weights, saturated.surrogates);
  if (s.state.freedom.empty()) {
    for (const Screened& c : alone.candidates) s.state.freedom.push_back(c.freedom);
    s.state.first = alone;
  }
  std::vector<Screened> list =
      shortlist(s.design, s.state.freedom, s.state.model, alone, kShortlist);
  std::erase_if(list, [&](const Screened& c) {
    return alone.family.p_value(c.surprise) > 10.0 * s.settings.significance;
  });
  if (list.empty()) return list;
  const Screening own = screen(s.design, s.library, s.state.model, s.state.noise.weights, {});
  for (const Screened& c : shortlist(s.design, s.state.freedom, s.state.model, own, kShortlist - 2))
    if (std::none_of(list.begin(), list.end(),
                     [&](const Screened& l) { return l.candidate == c.candidate; }))
      list.push_back(c);
  return list;
}

void note_refusals(const std::vector<Trial>& trials, Selection& state) {
  for (const Trial& trial : trials)
    if (!trial.allowed) state.refused.push_back({trial.candidate, trial.refusal});
}

/// Position of the allowed trial with the smallest plain loss on left-out blocks, or -1.
int smallest_loss(const Search& s, const std::vector<Trial>& trials) {
  std::vector<double> losses(trials.size(), std::numeric_limits<double>::infinity());
  tbb::parallel_for(0, static_cast<int>(trials.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    if (!trials[k].allowed) return;
    const NoiseView own = own_noise(s.design, trials[k].model);
    losses[k] =
        cross_validate(s.design, trials[k].model, own.weights, s.settings.blocks).plain.sum();
  });
  const auto least = std::min_element(losses.begin(), losses.end());
  return least == losses.end() || std::isinf(*least) ? -1
                                                     : static_cast<int>(least - losses.begin());
}

/// The best trial under the noise that it leaves over itself. The present model's noise must not
/// decide: what a strong cause is to explain is still part of it.
int settle(const Search& s, std::vector<Trial>& trials, NoiseView& view) {
  int best = smallest_loss(s, trials);
  for (int round = 0; round < 3 && best >= 0; ++round) {
    view = own_noise(s.design, trials[static_cast<std::size_t>(best)].model);
    const int next = rank_trials(s.design, s.state.freedom, view.weights, trials);
    if (next == best) break;
    best = next;
  }
  return best;
}

/// Family-wise probability that a cause explains that much by chance, everything the trial leaves
/// over being noise.
double confirm(const Search& s, const Trial& trial, const Model& base, NoiseView& view) {
  draw_surrogates(s.design, s.settings, view);
  const Screening screening = screen(s.design, s.library, base, view.weights, view.surrogates);
  const Screened& own = screening.candidates[static_cast<std::size_t>(trial.candidate)];
  const double statistic = deviance(base, view.weights) - trial.deviance;
  return screening.family.p_value(own.null.surprise(statistic));
}

/// Adds the next cause; false where there is none.
bool add_cause(const Search& s) {
  NoiseView saturated = saturated_noise(s.design, s.library, s.state.model);
  draw_surrogates(s.design, s.settings, saturated);
  std::vector<Screened> list = promising(s, saturated);
  while (!list.empty()) {
    std::vector<Trial> trials =
        try_candidates(s.design, s.state.noise.weights, s.state.model, list);
    note_refusals(trials, s.state);
    NoiseView view;
    const int best = settle(s, trials, view);
    if (best < 0) return false;
    Trial& trial = trials[static_cast<std::size_t>(best)];
    const double p = confirm(s, trial, s.state.model, view);
    s.state.p_family[static_cast<std::size_t>(trial.candidate)] = p;
    if (p > s.settings.significance) return false;
    s.state.model = std::move(trial.model);
    s.state.noise = std::move(view);
    return true;
  }
  return false;
}

/// Exchanges accepted causes for better ones as long as that helps.
void swap_causes(const Search& s) {
  Selection& state = s.state;
  int left = 4;
  for (std::size_t t = 0; t < state.model.terms.size() && left > 0; ++t) {
    if (state.model.terms[t].baseline) continue;
    const int own = library_index(s.design, state.model.terms[t]);
    Model without = state.model;
    remove_term(s.design, t, without);
    const Screening screening = screen(s.design, s.library, without, state.noise.weights, {});
    std::vector<Screened> list =
        shortlist(s.design, state.freedom, without, screening, kShortlist - 2);
    std::erase_if(list, [own](const Screened& c) { return c.candidate == own; });
    std::vector<Trial> trials = try_candidates(s.design, state.noise.weights, without, list);
    Trial present;
    present.candidate = own;
    present.model = state.model;
    present.allowed = true;
    trials.push_back(std::move(present));
    NoiseView view;
    const int best = settle(s, trials, view);
    if (trials[static_cast<std::size_t>(best)].score > trials.back().score - kWorthSwapping)
      continue;
    state.p_family[static_cast<std::size_t>(trials[static_cast<std::size_t>(best)].candidate)] =
        state.p_family[static_cast<std::size_t>(own)];
    state.model = std::move(trials[static_cast<std::size_t>(best)].model);
    refine(s.design, state.noise.weights, RefineScope::all_terms, state.model);
    renew_noise(s);
    --left;
    t = static_cast<std::size_t>(-1);
  }
}

/// Two causes together can stand in for a third one that alone explains as much: tries every pair.
void merge_causes(const Search& s) {
  Selection& state = s.state;
  for (std::size_t a = 0; a < state.model.terms.size(); ++a)
    for (std::size_t b = a + 1; b < state.model.terms.size(); ++b) {
      if (state.model.terms[a].baseline || state.model.terms[b].baseline) continue;
      Model without = state.model;
      remove_term(s.design, b, without);
      remove_term(s.design, a, without);
      const Screening screening = screen(s.design, s.library, without, state.noise.weights, {});
      std::vector<Trial> trials =
          try_candidates(s.design, state.noise.weights, without,
                         shortlist(s.design, state.freedom, without, screening, kShortlist - 2));
      const int best = rank_trials(s.design, state.freedom, state.noise.weights, trials);
      if (best < 0) continue;
      const double present = deviance(state.model, state.noise.weights) +
                             model_price(s.design, state.freedom, state.model);
      Trial& trial = trials[static_cast<std::size_t>(best)];
      if (trial.score > present) continue;
      state.p_family[static_cast<std::size_t>(trial.candidate)] = std::min(
          state.p_family[static_cast<std::size_t>(library_index(s.design, state.model.terms[a]))],
          state.p_family[static_cast<std::size_t>(library_index(s.design, state.model.terms[b]))]);
      state.model = std::move(trial.model);
      refine(s.design, state.noise.weights, RefineScope::all_terms, state.model);
      renew_noise(s);
      return;
    }
}

double least_share(const Search& s, std::size_t term) {
  return std::max(s.settings.least_share, s.state.model.terms[term].candidate->least_share);
}

/// Counted over all channels of a noise group a cause of a few is a small share, which chance in
/// the others blurs.
bool is_unsure(const Design& design, const Gain& gain) {
  return !design.problem().noise_groups.empty() && gain.low <= 0.0;
}

/// Takes out causes that the others have made superfluous or impossible.
void prune(const Search& s) {
  Selection& state = s.state;
  for (std::size_t t = 0; t < state.model.terms.size(); ++t) {
    if (state.model.terms[t].baseline) continue;
    const Evidence evidence = judge(s.design, s.settings, state, t);
    const LinearFit fit = solve(stack(state.model, state.noise.weights));
    const bool impossible = violates_limits(s.design, state.model, fit, t);
    const bool superfluous = evidence.statistic < evidence.freedom * parameter_price(s.design) ||
                             evidence.validated <= 0.0 || evidence.gain.share < least_share(s, t) ||
                             evidence.of_baseline < s.settings.least_of_baseline ||
                             is_unsure(s.design, evidence.gain);
    if (!impossible && !superfluous) continue;
    const Term& term = state.model.terms[t];
    state.refused.push_back(
        {library_index(s.design, term),
         impossible ? term.candidate->limit_meaning : "no gain worth naming on left-out blocks"});
    remove_term(s.design, t, state.model);
    refine(s.design, state.noise.weights, RefineScope::all_terms, state.model);
    t = static_cast<std::size_t>(-1);
  }
  while (const std::optional<std::size_t> collinear = find_collinear_term(
             s.design, s.settings, state.noise.weights, state.model, CollinearAmong::causes)) {
    const std::size_t t = *collinear;
    state.refused.push_back({library_index(s.design, state.model.terms[t]),
                             "no more than what the form of a named cause leaves over"});
    remove_term(s.design, t, state.model);
    refine(s.design, state.noise.weights, RefineScope::all_terms, state.model);
  }
}

/// Its size is not told from none beside the other causes; nor, where it has a form, where in its
/// range some parameter of that lies: it explains by what the form happens to do in these logs.
bool is_undetermined(const Candidate& candidate, const std::vector<ParameterEstimate>& all) {
  constexpr double kStandardErrors = 2.0;
  const auto is = [](const auto& parameter) {
    return [&](const ParameterEstimate& e) { return e.name == parameter.name; };
  };
  bool sized = false, formless = false;
  for (const LinearParameter& p : candidate.linear)
    for (const ParameterEstimate& e : all)
      sized = sized || (is(p)(e) && std::abs(e.value) >= kStandardErrors * e.standard_error);
  for (const NonlinearParameter& p : candidate.nonlinear) {
    const auto found = std::find_if(all.begin(), all.end(), is(p));
    formless = formless || (found != all.end() && found->standard_error > p.high - p.low);
  }
  return (formless || candidate.nonlinear.empty()) && !sized;
}

void drop_undetermined(const Search& s) {
  Selection& state = s.state;
  const auto& terms = state.model.terms;
  const auto is_named = [](const Term& t) {
    return !t.baseline && t.candidate->kind == CandidateKind::named;
  };
  while (std::any_of(terms.begin(), terms.end(), is_named)) {
    const auto all = estimates(s.design, state.model, state.noise);
    std::size_t t = 0;
    while (t < terms.size() &&
           !(is_named(terms[t]) && is_undetermined(*terms[t].candidate, all[t])))
      ++t;
    if (t == terms.size()) return;
    state.refused.push_back({library_index(s.design, terms[t]),
                             "its size is not told from none beside the named causes"});
    remove_term(s.design, t, state.model);
    refine(s.design, state.noise.weights, RefineScope::all_terms, state.model);
    renew_noise(s);
  }
}

/// Impacts come sooner or later by whether others came: a fit of what makes them ends where it
/// began, and other causes would make up for it.
void begin_impacts_elsewhere(const Search& s) {
  const auto makes_impacts = [](const Term& term) { return term.candidate->broadband; };
  const auto& terms = s.state.model.terms;
  if (std::none_of(terms.begin(), terms.end(), makes_impacts)) return;
  s.state.model = best_form(s.design, s.state.noise.weights, s.state.model, makes_impacts);
  refine(s.design, s.state.noise.weights, RefineScope::all_terms, s.state.model);
  renew_noise(s);
}

std::vector<int> causes_of(const Design& design, const Model& model) {
  std::vector<int> list;
  for (const Term& term : model.terms)
    if (!term.baseline) list.push_back(library_index(design, term));
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

Evidence judge(const Design& design, const Settings& settings, const Selection& state,
               std::size_t term) {
  Evidence evidence;
  const int index = library_index(design, state.model.terms[term]);
  const Weights& weights = state.noise.weights;
  Model without = state.model;
  remove_term(design, term, without);
  evidence.statistic = deviance(without, weights) - deviance(state.model, weights);
  evidence.freedom = state.freedom[static_cast<std::size_t>(index)];
  evidence.p_family = state.p_family[static_cast<std::size_t>(index)];
  const BlockLosses before = cross_validate(design, without, weights, settings.blocks);
  const BlockLosses after = cross_validate(design, state.model, weights, settings.blocks);
  evidence.validated = before.whitened.sum() - after.whitened.sum();
  const VectorXd channels = channels_of(design, state.model.terms[term]);
  const VectorXd losses_before = before.plain * channels, losses_after = after.plain * channels;
  evidence.gain = block_bootstrap_gain(losses_before, losses_after, 0.95, settings.seed);
  evidence.of_baseline = (losses_before - losses_after).sum() / state.baseline_loss.dot(channels);
  return evidence;
}

Selection select_causes(const Design& design, const Library& library, const Settings& settings) {
  Selection state;
  const Search search{design, library, settings, state};
  state.p_family.assign(design.problem().library.size(), 1.0);
  state.model = baseline_model(design);
  renew_noise(search);
  refine(design, state.noise.weights, RefineScope::all_terms, state.model);
  renew_noise(search);
  settle_nuisances(design, state.noise.weights, state.model);
  state.baseline_loss = cross_validate(design, state.model, state.noise.weights, settings.blocks)
                            .plain.colwise()
                            .sum()
                            .transpose();
  std::vector<std::vector<int>> visited{{}};
  const int most = std::max(settings.most_causes, design.problem().channels);
  while (static_cast<int>(causes_of(design, state.model).size()) < most) {
    const Model before = state.model;
    const NoiseView noise_before = state.noise;
    if (!add_cause(search)) break;
    refine(design, state.noise.weights, RefineScope::all_terms, state.model);
    renew_noise(search);
    begin_impacts_elsewhere(search);
    swap_causes(search);
    merge_causes(search);
    prune(search);
    const std::vector<int> now = causes_of(design, state.model);
    const bool seen = std::find(visited.begin(), visited.end(), now) != visited.end();
    if (seen) {
      // The new cause did not survive beside the others: the search has come to its end.
      state.model = before;
      state.noise = noise_before;
      break;
    }
    visited.push_back(now);
    renew_noise(search);
  }
  drop_undetermined(search);
  conclude(design, library, settings, state);
  return state;
}

void conclude(const Design& design, const Library& library, const Settings& settings,
              Selection& state) {
  draw_surrogates(design, settings, state.noise);
  state.last = screen(design, library, state.model, state.noise.weights, state.noise.surrogates);
  state.evidence.assign(state.model.terms.size(), {});
  for (std::size_t t = 0; t < state.model.terms.size(); ++t)
    if (!state.model.terms[t].baseline) state.evidence[t] = judge(design, settings, state, t);
}

}  // namespace sinew::diagnosis
