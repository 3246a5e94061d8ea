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

/// What is disturbed as far as the explanation of the whole logs shows it.
Disturbances seen_by(const Problem& problem, const Settings& settings, const Model& found,
                     const FitInTime& whole) {
  const Design design = evenly_banded(problem, settings);
  // What no known causes together explain is plainest; few of them may hide less of it.
  Disturbances seen = find_disturbances(FitInTime(design, saturated(problem, found)));
  return seen.in_training() ? seen : find_disturbances(whole);
}

bool same(const std::vector<SetAside>& one, const std::vector<SetAside>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const SetAside& a, const SetAside& b) { return (a == b).all(); });
}

/// Structure without a name is what a push looks like: where there is any beside it, the search
/// finds it again.
std::vector<SlotForm> named_forms(const Problem& problem, std::vector<SlotForm> forms) {
  std::erase_if(forms, [&](const SlotForm& form) {
    return form.candidate >= 0 &&
           problem.library[static_cast<std::size_t>(form.candidate)].kind != CandidateKind::named;
  });
  return forms;
}

DrivenSubject without(const DrivenSubject& subject, const Disturbances& seen) {
  DrivenSubject rest = subject;
  rest.leave_out(stretches_in_time(seen));
  return rest;
}

}  // namespace

std::optional<NamedCause> find_undisturbed(const Searches& searches, const Settings& settings,
                                           DrivenSubject& subject, Explanation& explanation) {
  if (explanation.selection.model.terms.empty()) return std::nullopt;
  const Problem& problem = subject.problem();
  const auto left_by = [&](const DrivenSubject& of, const Explanation& e) {
    return FitInTime(evenly_banded(problem, settings), with_everything(of, e));
  };
  const FitInTime whole = left_by(subject, explanation);
  Disturbances seen =
      seen_by(problem, settings, with_lines(subject, explanation.selection.model), whole);
  if (!seen.in_training()) return std::nullopt;
  DrivenSubject rest = subject;
  Explanation rough;
  std::vector<SetAside> without_these;  // the rough explanation is found
  const auto search_without = [&](const Disturbances& known) {
    rest = without(subject, known);
    rough = searches.rough(rest, named_forms(problem, explanation.forms));
    without_these = known.aside;
  };
  // With causes that a push has spoilt less it is plainer what is disturbed, in held-out logs too:
  // what is set aside of it at first may be its beginning alone.
  seen = settled(std::move(seen), [&](const Disturbances& known) {
    search_without(known);
    return find_disturbances(left_by(rest, rough));
  });
  if (!same(seen.aside, without_these)) search_without(seen);
  Explanation other = searches.full(rest, rough.forms);
  leave_over(left_by(rest, other), seen);
  std::optional<NamedCause> force =
      find_unlogged_force({whole, numbers_of(explanation)}, numbers_of(other), seen,
                          places_of(subject, seen), recording_names(problem), settings);
  if (!force) return std::nullopt;
  subject = std::move(rest);
  explanation = std::move(other);
  return force;
}

}  // namespace sinew::diagnosis
