// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/undisturbed.h"

#include <algorithm>

#include "identification/contacts/unlogged_force.h"
#include "identification/regression/starting_values.h"

namespace sinew::diagnosis {
namespace {

double numbers_of(const Explanation& explanation) {
  double sum = 0.0;
  for (const NamedCause& cause : explanation.verdict.causes)
    sum += static_cast<double>(cause.parameters.size());
  for (const Term& term : explanation.structure)
    sum += static_cast<double>(term.candidate->linear.size());
  return sum;
}

/// The model with every named cause of the library, each in two of its forms: what disturbances
/// leave over is seen before it is known which causes there are.
Model saturated(const Problem& problem, Model model) {
  for (const Candidate& candidate : problem.library) {
    if (candidate.kind != CandidateKind::named) continue;
    const std::vector<Eigen::VectorXd> starts = starting_values(candidate);
    for (const std::size_t i : {starts.size() / 3, 2 * starts.size() / 3}) {
      if (i > 0 && i == starts.size() / 3 && model.terms.back().candidate == &candidate) continue;
      model.terms.push_back({&candidate, false, starts[i], {}});
      if (starts.size() < 3) break;
    }
  }
  return model;
}

/// The model with the ripples that the spectra over the angle show: what the band holds of them
/// comes in bursts, where the shaft is slow.
Model with_lines(const DrivenSubject& subject, Model model) {
  for (const DrivenSubject::ShaftLine& line : subject.shaft_lines()) {
    const Candidate* ripple = &subject.problem().library[static_cast<std::size_t>(line.candidate)];
    const auto is_there = [&](const Term& term) { return term.candidate == ripple; };
    if (std::none_of(model.terms.begin(), model.terms.end(), is_there))
      model.terms.push_back({ripple, false, Eigen::VectorXd(), {}});
  }
  return model;
}

/// Everything that explains the logs: the model, lines over a shaft's angle, and structure that has
/// no name. None of it is a push.
Model with_everything(const DrivenSubject& subject, const Explanation& explanation) {
  Model model = with_lines(subject, explanation.selection.model);
  for (const Term& term : explanation.structure)
    model.terms.push_back({term.candidate, false, term.nonlinear, {}});
  return model;
}

std::vector<ForcePlace> places_of(const DrivenSubject& subject, const Disturbances& disturbances) {
  std::vector<std::string> names, units;
  for (int c = 0; c < subject.problem().channels; ++c) {
    const auto joint = static_cast<std::size_t>(c);
    names.push_back(subject.place(joint));
    units.push_back(subject.model().joints[joint].revolute ? "N*m" : "N");
  }
  std::vector<ForcePlace> places = channel_places(disturbances, names, units);
  if (!subject.rigid() || subject.problem().channels == 1) return places;
  for (ForcePlace& place : link_places(disturbances, *subject.rigid()))
    places.push_back(std::move(place));
  return places;
}

std::vector<std::string> recording_names(const Problem& problem) {
  std::vector<std::string> names;
  for (const auto* logs : {&problem.training, &problem.holdout})
    for (const Recording& log : *logs) names.push_back(log.name);
  return names;
}

constexpr int kMostSearches = 2;

}  // namespace

std::optional<NamedCause> find_undisturbed(const Search& search, const Settings& settings,
                                           DrivenSubject& subject, Explanation& explanation) {
  if (explanation.selection.model.terms.empty()) return std::nullopt;
  const Model found = with_lines(subject, explanation.selection.model);
  const Problem& problem = subject.problem();
  // A design holds thinned copies of the logs: none is kept while the search has its own.
  std::optional<Design> design(evenly_banded(problem, settings));
  const FitInTime whole(*design, with_everything(subject, explanation));
  // What no known causes together explain is plainest; few of them may hide less of it.
  Disturbances seen = find_disturbances(FitInTime(*design, saturated(problem, found)));
  design.reset();
  if (!seen.in_training()) seen = find_disturbances(whole);
  for (int left = kMostSearches; seen.in_training() && left > 0; --left) {
    DrivenSubject rest = subject;
    rest.leave_out(stretches_in_time(seen));
    std::optional<FitInTime> outside;
    std::optional<Disturbances> plainer;
    Explanation other = search(rest, [&](const Explanation& e) {
      outside.emplace(evenly_banded(problem, settings), with_everything(rest, e));
      if (left == 1) return true;
      // With causes that no push has spoilt it is plainer what is disturbed, in held-out logs too.
      Disturbances again = find_disturbances(*outside);
      if (again.in_training() && differ(again, seen)) plainer = std::move(again);
      return !plainer;
    });
    if (plainer) {
      seen = *std::move(plainer);
      continue;
    }
    leave_over(*outside, seen);
    std::optional<NamedCause> force =
        find_unlogged_force({whole, numbers_of(explanation)}, numbers_of(other), seen,
                            places_of(subject, seen), recording_names(problem), settings);
    if (!force) return std::nullopt;
    subject = std::move(rest);
    explanation = std::move(other);
    return force;
  }
  return std::nullopt;
}

}  // namespace sinew::diagnosis
