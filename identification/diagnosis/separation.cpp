// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/diagnosis/confounding.h"
#include "identification/diagnosis/deviation_terms.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSeparated = 3.0;  // standard errors: less is no proposal
constexpr double kPlenty = 10.0;    // with as much, the shorter motion is the better one

/// The problem with the planned recording in the logs' place.
Problem planned_problem(const Problem& problem, Recording recording) {
  Problem planned;
  planned.training.push_back(std::move(recording));
  planned.baseline = problem.baseline;
  planned.library = problem.library;
  planned.deviations = problem.deviations;
  planned.channels = problem.channels;
  planned.noise_groups = problem.noise_groups;
  planned.unlike_channels = problem.unlike_channels;
  return planned;
}

/// The noise of a channel of the logs, at the frequencies of a planned segment.
NoiseModel expected_noise(const Design& design, const std::vector<NoiseModel>& noise,
                          const Segment& planned) {
  NoiseModel model;
  model.variance = VectorXd::Ones(planned.bins);
  for (std::size_t s = 0; s < design.segments().size(); ++s) {
    const Segment& logged = design.segments()[s];
    if (logged.holdout || logged.channel != planned.channel || noise[s].variance.size() == 0)
      continue;
    const double ratio = planned.rate_hz / static_cast<double>(planned.samples) *
                         static_cast<double>(logged.samples) / logged.rate_hz;
    for (Index b = 0; b < planned.bins; ++b)
      model.variance(b) = noise[s].variance(
          std::min(noise[s].variance.size() - 1,
                   static_cast<Index>(std::lround(static_cast<double>(b) * ratio))));
    break;
  }
  return model;
}

bool is_restricted(const Selection& state) {
  return std::any_of(state.model.terms.begin(), state.model.terms.end(),
                     [](const Term& t) { return t.deviation >= 0; });
}

/// A planned recording as the fit sees it.
class PlannedFit {
 public:
  PlannedFit(const Design& design, const Settings& settings, const Selection& found,
             const Selection& state, std::size_t term, Recording recording)
      : problem_(planned_problem(design.problem(), std::move(recording))),
        design_(problem_, settings) {
    std::vector<NoiseModel> noise;
    for (const Segment& s : design_.segments())
      noise.push_back(expected_noise(design, state.noise.noise, s));
    weights_ = whitening(noise);
    set_base(design, found, state, term);
    set_signal(design, state, term);
  }

  /// Deviance that the first cause would make.
  double made() const { return solve(stack(base_, weights_)).deviance; }

  /// Deviance that is left of the first cause when the candidate stands in for it.
  double left_by(int candidate) const {
    double least = std::numeric_limits<double>::infinity();
    std::vector<VectorXd> starts{VectorXd()};
    if (candidate >= 0) starts = starting_values(in_library(candidate));
    for (const VectorXd& start : starts) {
      Model model = base_;
      model.terms.push_back(term_of(candidate, start));
      least = std::min(least, solve(stack(model, weights_)).deviance);
    }
    return least;
  }

 private:
  const Candidate& in_library(int candidate) const {
    return problem_.library[static_cast<std::size_t>(candidate)];
  }

  /// A term that the planned model has no prediction for yet: a delay takes the rate of what the
  /// nominal model says.
  Term term_of(int candidate, const VectorXd& nonlinear) const {
    if (candidate < 0) return deviations_.deviations[static_cast<std::size_t>(-1 - candidate)];
    const Candidate& named = in_library(candidate);
    if (named.kind != CandidateKind::delay) return make_term(design_, named, nonlinear, false);
    Term delay;
    delay.candidate = &named;
    delay.nonlinear = nonlinear;
    delay.columns = delay_columns(design_, named.channels, deviations_.base.fixed);
    return delay;
  }

  /// What stays free beside the cause in question: the other causes and the baseline, of which only
  /// what no deviation covers and the deviations named where the model is held at its own values.
  void set_base(const Design& design, const Selection& found, const Selection& state,
                std::size_t term) {
    Model whole = baseline_model(design_);
    whole.terms.clear();
    for (const Term& t : found.model.terms)
      if (t.baseline) {
        const auto index = t.candidate - design.problem().baseline.data();
        whole.terms.push_back(make_term(design_, problem_.baseline[static_cast<std::size_t>(index)],
                                        t.nonlinear, true));
      }
    deviations_ = take_apart(design_, whole);
    base_ = is_restricted(state) ? deviations_.base : whole;
    for (std::size_t t = 0; t < state.model.terms.size(); ++t) {
      const Term& other = state.model.terms[t];
      if (!other.baseline && t != term)
        base_.terms.push_back(term_of(library_index(design, other), other.nonlinear));
    }
  }

  /// What the first cause would add to the planned efforts. Of nuisances, which differ from log to
  /// log, the first log's values.
  void set_signal(const Design& design, const Selection& state, std::size_t term) {
    const Term& own = state.model.terms[term];
    const Term planned = term_of(library_index(design, own), own.nonlinear);
    const VectorXd fitted = solve(stack(state.model, state.noise.weights)).coefficients;
    const Index first = first_columns(state.model)[term];
    VectorXd values;
    if (own.candidate->kind == CandidateKind::delay) {
      values = own.nonlinear;
    } else {
      const auto layout = design.coefficients(*own.candidate);
      values = VectorXd::Zero(static_cast<Index>(own.candidate->linear.size()));
      for (std::size_t i = layout.size(); i-- > 0;)
        values(layout[i].parameter) = fitted(first + static_cast<Index>(i));
    }
    for (std::size_t s = 0; s < base_.target.size(); ++s) {
      base_.target[s].setZero();
      if (planned.columns[s].cols() > 0) base_.target[s] = planned.columns[s] * values;
    }
  }

  Problem problem_;
  Design design_;
  Weights weights_;
  Model base_;
  DeviationTerms deviations_;
};

const std::string& isolating_experiment(const Problem& problem, int candidate) {
  return candidate < 0
             ? problem.deviations[static_cast<std::size_t>(-1 - candidate)].isolating_experiment
             : problem.library[static_cast<std::size_t>(candidate)].isolating_experiment;
}

int first_channel(const Design& design, const Term& term) {
  for (std::size_t s = 0; s < term.columns.size(); ++s)
    if (term.columns[s].cols() > 0) return design.segments()[s].channel;
  return 0;
}

/// Another form of a member before it: a set tells each name once.
bool is_named_alike(const std::vector<RankedCause>& members, std::size_t m) {
  return std::any_of(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(m),
                     [&](const RankedCause& other) {
                       return other.name == members[m].name && other.place == members[m].place;
                     });
}

/// Names of the members that are told from the first one, and by how much at least.
/// `known`: the first one's statistic in these logs, which count again beside the planned one.
Separation judged(const PlannedFit& fit, const PlannedMotion& motion, double known,
                  const std::vector<RankedCause>& members) {
  const double enough = std::max(kSeparated * kSeparated, kByImperfection * (known + fit.made()));
  Separation result{motion.name, std::numeric_limits<double>::infinity(), {}, motion, {}};
  for (std::size_t m = 1; m < members.size(); ++m) {
    const double left = fit.left_by(members[m].candidate);
    if (left < enough || is_named_alike(members, m)) continue;
    result.rules_out.push_back(members[m].name);
    result.expected = std::min(result.expected, std::sqrt(left));
  }
  return result;
}

/// Rules out more; or as many, sure enough and in less time, or else surer.
bool is_better(const Separation& one, const Separation& other) {
  if (one.rules_out.size() != other.rules_out.size())
    return one.rules_out.size() > other.rules_out.size();
  if (one.rules_out.empty()) return false;
  if (one.expected >= kPlenty && other.expected >= kPlenty)
    return one.motion->position.rows() < other.motion->position.rows();
  return one.expected > other.expected;
}

}  // namespace

Separation separate(const Design& design, const Settings& settings, const Selection& found,
                    const Selection& state, std::size_t term,
                    const std::vector<RankedCause>& members, const ExperimentPlanner& planner) {
  Separation best;
  if (members.size() < 2) return best;
  if (planner)
    for (const PlannedExperiment& each : planner(first_channel(design, state.model.terms[term]))) {
      const PlannedFit fit(design, settings, found, state, term, each.recording());
      Separation now = judged(fit, each.motion, state.evidence[term].statistic, members);
      if (is_better(now, best)) best = std::move(now);
    }
  for (const RankedCause& member : members)
    if (best.experiment.empty())
      best.experiment = isolating_experiment(design.problem(), member.candidate);
  return best;
}

}  // namespace sinew::diagnosis
