// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/confounding.h"

#include <tbb/parallel_for.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/diagnosis/lag.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kByChance = 8.0;         // deviance a wrong cause may be ahead of the right one
constexpr double kStays = 2.0;            // the same among two of a kind
constexpr double kPairedLimit = 1.6;      // standard errors of the paired block differences
constexpr double kClose = 0.12;           // share within which the paired differences are asked
constexpr double kPlainlyBehind = 100.0;  // deviance; with the same in every block it is no rival
constexpr double kInEveryBlock = 4.0;     // standard errors of the paired block differences
constexpr double kSameThing = 0.4;  // least correlation: below, a rival explains something else

/// Whitened columns of a group with the model's columns projected out.
MatrixXd apart(const Stack& stacked, const MatrixXd& inverse, const Weights& weights,
               const BandColumns& columns) {
  Index wide = 0;
  for (const MatrixXd& part : columns) wide = std::max(wide, part.cols());
  MatrixXd x = MatrixXd::Zero(stacked.y.size(), wide);
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (weights[s].size() > 0 && columns[s].cols() > 0)
      x.middleRows(stacked.first_row[s], weights[s].size()) = weights[s].asDiagonal() * columns[s];
  MatrixXd moment = MatrixXd::Zero(stacked.coefficients, wide);
  const auto rows = [&](std::size_t s) {
    return x.middleRows(stacked.first_row[s], stacked.a[s].rows());
  };
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (!stacked.at[s].empty())
      moment(stacked.at[s], Eigen::all) += stacked.a[s].transpose() * rows(s);
  const MatrixXd solution = inverse * moment;
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (!stacked.at[s].empty())
      x.middleRows(stacked.first_row[s], stacked.a[s].rows()) -=
          stacked.a[s] * solution(stacked.at[s], Eigen::all);
  return x;
}

}  // namespace

CanonicalCorrelation::CanonicalCorrelation(const Model& model, const Weights& weights)
    : weights_(weights),
      stacked_(stack(model, weights)),
      inverse_(scaled_pseudo_inverse(stacked_.gram())) {}

double CanonicalCorrelation::largest(const BandColumns& a, const BandColumns& b) const {
  const MatrixXd x = apart(stacked_, inverse_, weights_, a),
                 y = apart(stacked_, inverse_, weights_, b);
  if (x.cols() == 0 || y.cols() == 0) return 0.0;
  const MatrixXd cross = x.transpose() * y;
  const MatrixXd square = scaled_pseudo_inverse(x.transpose() * x, 1e-8) * cross *
                          scaled_pseudo_inverse(y.transpose() * y, 1e-8) * cross.transpose();
  return std::sqrt(std::clamp(square.eigenvalues().real().maxCoeff(), 0.0, 1.0));
}

namespace {

/// Paired block differences of two models: sum over standard error.
double paired_z(const VectorXd& better, const VectorXd& worse) {
  const VectorXd difference = worse - better;
  const double n = static_cast<double>(difference.size());
  const double mean = difference.mean();
  const double variance = (difference.array() - mean).square().sum() / std::max(1.0, n - 1.0);
  return mean / std::sqrt(std::max(variance / n, 1e-300));
}

RankedCause describe(const Design& design, int candidate) {
  RankedCause cause;
  cause.candidate = candidate;
  const auto tell = [&cause](const auto& c) {
    cause.name = c.name;
    cause.place = c.place;
  };
  if (candidate < 0)
    tell(design.problem().deviations[static_cast<std::size_t>(-1 - candidate)]);
  else
    tell(design.problem().library[static_cast<std::size_t>(candidate)]);
  return cause;
}

/// The other causes were fitted beside the present one: whoever comes near it is compared only
/// after all parameters were fitted beside it, too.
void refit_close_ones(const Design& design, const Selection& state, double without,
                      std::vector<Trial>& trials) {
  double best = trials.front().score;
  for (const Trial& trial : trials) best = std::min(best, trial.score);
  tbb::parallel_for(0, static_cast<int>(trials.size()), [&](int i) {
    Trial& trial = trials[static_cast<std::size_t>(i)];
    const double close = std::max(3.0 * kByChance, 2.0 * kClose * (without - trial.deviance));
    if (trial.score - best <= close)
      refine(design, state.noise.weights, RefineScope::around_last, trial.model);
  });
  rank_trials(design, state.freedom, state.noise.weights, trials);
}

/// Deviations that are not in the model may take the place of a cause, too.
void add_deviations(const Design& design, const Selection& state, const Model& without,
                    std::vector<Trial>& trials) {
  for (const Term& deviation : state.deviations) {
    if (std::any_of(state.model.terms.begin(), state.model.terms.end(),
                    [&](const Term& t) { return t.deviation == deviation.deviation; }))
      continue;
    Trial trial;
    trial.candidate = -1 - deviation.deviation;
    trial.model = without;
    trial.model.terms.push_back(deviation);
    const LinearFit fit = solve(stack(trial.model, state.noise.weights));
    trial.allowed = !violates_limits(design, trial.model, fit, trial.model.terms.size() - 1);
    trials.push_back(std::move(trial));
  }
}

bool is_unlikely(const Design& design, const Trial& trial) {
  const Problem& problem = design.problem();
  return trial.candidate < 0
             ? problem.deviations[static_cast<std::size_t>(-1 - trial.candidate)].unlikely
             : problem.library[static_cast<std::size_t>(trial.candidate)].unlikely;
}

bool is_told_only(const Design& design, const Trial& trial) {
  return trial.candidate >= 0 &&
         design.problem().library[static_cast<std::size_t>(trial.candidate)].told_only;
}

/// Terms of the present model, the replaced one aside, that are within their limits.
std::vector<bool> within_limits(const Design& design, const Selection& state, std::size_t term) {
  const LinearFit fit = solve(stack(state.model, state.noise.weights));
  std::vector<bool> within;
  for (std::size_t t = 0; t < state.model.terms.size(); ++t)
    if (t != term) within.push_back(!violates_limits(design, state.model, fit, t));
  return within;
}

/// Beside a rival every other term has to stay possible, its own as well.
bool is_possible(const Design& design, const Weights& weights, const std::vector<bool>& within,
                 const Model& model) {
  const LinearFit fit = solve(stack(model, weights));
  for (std::size_t t = 0; t < model.terms.size(); ++t)
    if ((t >= within.size() || within[t]) && violates_limits(design, model, fit, t)) return false;
  return true;
}

/// Fitted models with the term replaced by whatever comes near it.
std::vector<Trial> contenders(const Design& design, const Library& library, const Selection& state,
                              std::size_t term) {
  const int own = library_index(design, state.model.terms[term]);
  Model without = state.model;
  remove_term(design, term, without);
  const Screening screening = screen(design, library, without, state.noise.weights, {});
  std::vector<Screened> list = shortlist(design, state.freedom, without, screening, 6);
  std::erase_if(list, [&](const Screened& c) { return c.candidate == own; });
  std::vector<Trial> trials = try_candidates(design, state.noise.weights, without, list);
  add_deviations(design, state, without, trials);
  const std::vector<Candidate>& library_of = design.problem().library;
  std::erase_if(trials, [&](const Trial& t) {
    const bool decoy = t.candidate >= 0 && library_of[static_cast<std::size_t>(t.candidate)].kind ==
                                               CandidateKind::decoy;
    // A decoy is no name, and lost against this one.
    return !t.allowed || decoy || is_unlikely(design, t);
  });
  Trial present;
  present.candidate = own;
  present.model = state.model;
  // Every contender's own term comes last.
  std::rotate(present.model.terms.begin() + static_cast<std::ptrdiff_t>(term),
              present.model.terms.begin() + static_cast<std::ptrdiff_t>(term) + 1,
              present.model.terms.end());
  present.allowed = true;
  // What explains something else is no rival, however much that is.
  const CanonicalCorrelation beside(without, state.noise.weights);
  tbb::parallel_for(std::size_t{0}, trials.size(), [&](std::size_t i) {
    trials[i].allowed = beside.largest(present.model.terms.back().columns,
                                       trials[i].model.terms.back().columns) >= kSameThing;
  });
  std::erase_if(trials, [](const Trial& t) { return !t.allowed; });
  trials.push_back(std::move(present));
  rank_trials(design, state.freedom, state.noise.weights, trials);
  refit_close_ones(design, state, deviance(without, state.noise.weights), trials);
  const std::vector<bool> within = within_limits(design, state, term);
  std::erase_if(trials, [&](const Trial& t) {
    return t.candidate != own && !is_possible(design, state.noise.weights, within, t.model);
  });
  std::sort(trials.begin(), trials.end(),
            [](const Trial& a, const Trial& b) { return a.score < b.score; });
  // The search's own choice stays first unless another one is better by more than chance.
  const auto chosen = std::find_if(trials.begin(), trials.end(),
                                   [own](const Trial& t) { return t.candidate == own; });
  const int ahead = trials.front().candidate;
  const bool value_against_form =
      own < 0 && ahead >= 0 && !library_of[static_cast<std::size_t>(ahead)].value;
  if (chosen->score <= trials.front().score + (value_against_form ? kByChance : kStays))
    std::rotate(trials.begin(), chosen, chosen + 1);
  // What cannot be adopted would leave the model without what the other one explains.
  const auto likely = std::find_if(trials.begin(), trials.end(), [&](const Trial& t) {
    return !is_unlikely(design, t) && !is_told_only(design, t);
  });
  if (likely != trials.end() && likely->score <= trials.front().score + kByChance)
    std::rotate(trials.begin(), likely, likely + 1);
  return trials;
}

/// A form stretched to its limit degenerates another one there: friction that warms up within
/// moments is friction, friction that hardly bends is straight. The other one says it with less.
bool degenerates(const Term& term) {
  constexpr double kEdge = 0.02;  // of the range
  if (term.deviation >= 0) return false;
  const auto& shapes = term.candidate->nonlinear;
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    const NonlinearParameter& shape = shapes[p];
    if (!(shape.high > shape.low)) continue;
    const auto at = [&](double x) { return shape.logarithmic ? std::log(x) : x; };
    const double low = at(shape.low), high = at(shape.high);
    const double place = (at(term.nonlinear(static_cast<Index>(p))) - low) / (high - low);
    if (place < kEdge || place > 1.0 - kEdge) return true;
  }
  return false;
}

/// The lag in the delay's place, its term last, where that says nearly as much: its own fit differs
/// by the noise that a derivative of the position brings along.
std::optional<Model> with_lag(const Design& design, const Weights& weights, const Model& without,
                              const LagBehind& lag, double of_delay) {
  constexpr double kNearly = 0.8;
  const Candidate& candidate = design.problem().library[static_cast<std::size_t>(lag.candidate)];
  std::vector<Screened> list;
  for (const VectorXd& start : starting_values(candidate)) {
    list.emplace_back();
    list.back().candidate = lag.candidate;
    list.back().nonlinear = start;
  }
  std::vector<Trial> trials = try_candidates(design, weights, without, list);
  const double before = deviance(without, weights);
  std::optional<Model> best;
  double most = kNearly * of_delay;
  for (Trial& trial : trials) {
    const double drop = before - deviance(trial.model, weights);
    if (!trial.allowed || drop < most) continue;
    most = drop;
    best = std::move(trial.model);
  }
  return best;
}

/// A lag that these logs cannot tell from the delay: first where they are bent as by a lag and the
/// model can take it; else the model takes the delay for both.
void add_lag(RankedCause lag, std::optional<Model> model, Rivals& rivals, double& sum) {
  if (std::any_of(rivals.members.begin(), rivals.members.end(),
                  [&](const RankedCause& c) { return c.candidate == lag.candidate; }))
    return;
  lag.weight = std::exp(-0.5 * lag.behind);
  sum += lag.weight;
  rivals.members.insert(model ? rivals.members.begin() : rivals.members.end(), std::move(lag));
  if (model) rivals.model = *std::move(model);
}

/// Every trial beside the first one: how far behind, in how many blocks, and how alike.
std::vector<RankedCause> compared_with_first(const Design& design, const Settings& settings,
                                             const Weights& weights, const Model& without,
                                             const std::vector<Trial>& trials) {
  const CanonicalCorrelation beside(without, weights);
  std::vector<VectorXd> losses(trials.size());
  std::vector<RankedCause> list(trials.size());
  tbb::parallel_for(std::size_t{0}, trials.size(), [&](std::size_t i) {
    list[i] = describe(design, trials[i].candidate);
    list[i].behind = std::max(0.0, trials[i].score - trials.front().score);
    list[i].weight = std::exp(-0.5 * list[i].behind);
    losses[i] = cross_validate(design, trials[i].model, weights, settings.blocks).whitened;
    if (i > 0)
      list[i].correlation = beside.largest(trials.front().model.terms.back().columns,
                                           trials[i].model.terms.back().columns);
  });
  for (std::size_t i = 1; i < trials.size(); ++i)
    list[i].paired_z = paired_z(losses.front(), losses[i]);
  return list;
}

}  // namespace

Rivals find_rivals(const Design& design, const Library& library, const Settings& settings,
                   const Selection& state, std::size_t term) {
  const std::vector<Trial> trials = contenders(design, library, state, term);
  Model without = state.model;
  remove_term(design, term, without);
  const double own = deviance(without, state.noise.weights) - trials.front().deviance;
  const std::vector<RankedCause> described =
      compared_with_first(design, settings, state.noise.weights, without, trials);
  Rivals rivals;
  rivals.margin = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const RankedCause& cause = described[i];
    if (i > 0 && (cause.correlation < kSameThing || degenerates(trials[i].model.terms.back())))
      continue;
    if (cause.behind > kPlainlyBehind && cause.paired_z > kInEveryBlock) {
      rivals.margin = std::min(rivals.margin, cause.behind);
      continue;
    }
    sum += cause.weight;
    const bool near = cause.behind <= std::max(kByChance, kByImperfection * own) ||
                      (cause.behind <= kClose * own && cause.paired_z < kPairedLimit);
    if (near)
      rivals.members.push_back(cause);
    else
      rivals.margin = std::min(rivals.margin, cause.behind);
  }
  rivals.model = trials.front().model;
  if (const auto lag = lag_behind_delay(design, state, term);
      lag && lag->deviance <= std::max(kByChance, kByImperfection * own)) {
    RankedCause cause = describe(design, lag->candidate);
    cause.behind = std::max(0.0, lag->deviance);
    cause.correlation = CanonicalCorrelation(without, state.noise.weights)
                            .largest(trials.front().model.terms.back().columns, lag->columns);
    std::optional<Model> in_its_place;
    if (lag->deviance < 0.0)
      in_its_place = with_lag(design, state.noise.weights, without, *lag, own);
    add_lag(std::move(cause), std::move(in_its_place), rivals, sum);
  }
  for (RankedCause& cause : rivals.members) cause.weight /= sum;
  std::rotate(rivals.model.terms.begin() + static_cast<std::ptrdiff_t>(term),
              rivals.model.terms.end() - 1, rivals.model.terms.end());
  return rivals;
}

}  // namespace sinew::diagnosis
