// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "identification/diagnosis/deviation_terms.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"
#include "identification/regression/starting_values.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSeparated = 3.0;  // standard errors: less is no proposal
constexpr double kPlenty = 10.0;    // with as much, the shorter motion is the better one
// Share of the first one's own part by which another may be behind and still be the right one: no
// model is perfect.
constexpr double kByImperfection = 0.04;

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

/// A planned recording in the logs' place.
struct PlannedLog {
  PlannedLog(const Problem& logged, const Settings& settings, Recording recording)
      : problem(planned_problem(logged, std::move(recording))), design(problem, settings) {}
  PlannedLog(const PlannedLog&) = delete;
  PlannedLog& operator=(const PlannedLog&) = delete;

  const Problem problem;
  const Design design;
};

/// A set with several members: the term of its first one in the model it was fitted in.
struct OpenSet {
  NamedCause* cause;
  const Selection* state;
  std::size_t term;
};

/// A planned recording as the fit sees it. `found`: the selection that the nonlinear parameters of
/// the baseline are taken from.
class PlannedFit {
 public:
  PlannedFit(const Design& design, const Selection& found, const OpenSet& set,
             const PlannedLog& planned)
      : problem_(planned.problem), design_(planned.design) {
    std::vector<NoiseModel> noise;
    for (const Segment& s : design_.segments())
      noise.push_back(expected_noise(design, set.state->noise.noise, s));
    weights_ = whitening(noise);
    set_base(design, found, *set.state, set.term);
    set_signal(design, *set.state, set.term);
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

  const Problem& problem_;
  const Design& design_;
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
/// `known`: what the first one explains of these logs, which count again beside the planned one.
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

/// A cause's term: of the library in the model whose values are free, as its set was made; of the
/// model's own values in the adopted one.
std::optional<OpenSet> open_set(const Design& design, const Explanation& explanation,
                                NamedCause& cause) {
  for (const Selection* state : {&explanation.selection, &explanation.adopted})
    for (std::size_t t = 0; t < state->model.terms.size(); ++t)
      if (!state->model.terms[t].baseline &&
          library_index(design, state->model.terms[t]) == cause.candidate)
        return OpenSet{&cause, state, t};
  return std::nullopt;
}

/// The sets that a motion may settle, by the channel that it is planned for.
std::map<int, std::vector<OpenSet>> open_sets(const Design& design, Explanation& explanation) {
  std::map<int, std::vector<OpenSet>> sets;
  for (NamedCause& cause : explanation.verdict.causes) {
    if (cause.members.size() < 2) continue;
    if (const auto set = open_set(design, explanation, cause))
      sets[first_channel(design, set->state->model.terms[set->term])].push_back(*set);
  }
  return sets;
}

void plan_motions(const Design& design, const Settings& settings, const ExperimentPlanner& planner,
                  Explanation& explanation) {
  for (const auto& [channel, sets] : open_sets(design, explanation))
    for (const PlannedExperiment& each : planner(channel)) {
      const PlannedLog planned(design.problem(), settings, each.recording());
      for (const OpenSet& set : sets) {
        const PlannedFit fit(design, explanation.selection, set, planned);
        NamedCause& cause = *set.cause;
        Separation now = judged(fit, each.motion, 2.0 * cause.log_odds, cause.members);
        if (is_better(now, cause.separation)) cause.separation = std::move(now);
      }
    }
}

}  // namespace

void propose_experiments(const Problem& problem, const Settings& settings,
                         const ExperimentPlanner& planner, Explanation& explanation) {
  std::vector<NamedCause>& causes = explanation.verdict.causes;
  const auto is_open = [](const NamedCause& cause) { return cause.members.size() > 1; };
  if (planner && std::any_of(causes.begin(), causes.end(), is_open))
    plan_motions(Design(problem, settings), settings, planner, explanation);
  for (NamedCause& cause : causes) {
    if (!is_open(cause)) continue;
    for (const RankedCause& member : cause.members)
      if (cause.separation.experiment.empty() && member.candidate != kNoTerm)
        cause.separation.experiment = isolating_experiment(problem, member.candidate);
  }
}

}  // namespace sinew::diagnosis
