// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/explain_by_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "identification/diagnosis/confidence.h"
#include "identification/diagnosis/deviation_terms.h"
#include "identification/diagnosis/explained_structure.h"
#include "identification/diagnosis/fewer_causes.h"
#include "identification/diagnosis/form_errors.h"
#include "identification/diagnosis/parameter_deviations.h"
#include "identification/diagnosis/standard_errors.h"
#include "identification/diagnosis/unexplained.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/regression/baseline.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The cause of a term. Where another one turns out to be better by more than chance, the model
/// takes that one instead: what is named is what the model is extended by.
NamedCause name_cause(const Design& design, const Library& library, const Settings& settings,
                      std::size_t term, Selection& selection) {
  const Evidence& evidence = selection.evidence[term];
  Rivals rivals = find_rivals(design, library, settings, selection, term);
  NamedCause cause;
  cause.members = rivals.members;
  if (cause.members.front().candidate != library_index(design, selection.model.terms[term]))
    selection.model = std::move(rivals.model);
  const Term& own = selection.model.terms[term];
  cause.candidate = library_index(design, own);
  cause.statistic = evidence.statistic;
  cause.p_family = evidence.p_family;
  cause.validated = evidence.validated;
  cause.cross_validated = evidence.gain;
  cause.confidence = rivals.margin;  // weighed once the left-over structure is known
  cause.held_out = cause.confirmed = gain_on_held_out(design, settings, selection, term);
  return cause;
}

std::string reason_of(const Screened& screened, const Candidate& candidate, double p) {
  switch (screened.gate) {
    case Gate::not_excited:
      return "not excited by these logs beside the model";
    case Gate::out_of_band:
      return "mostly above the frequencies looked at";
    case Gate::limit_violated:
      return candidate.limit_meaning.empty() ? "outside its physical limits"
                                             : candidate.limit_meaning;
    case Gate::open:
      break;
  }
  return p > 0.05 ? "nothing beyond noise beside the named causes"
                  : "too little beside the named causes to be told from noise";
}

void list_ruled_out(const Design& design, const Selection& selection, Verdict& verdict) {
  const std::vector<Candidate>& library = design.problem().library;
  for (const Screened& s : selection.last.candidates) {
    const Candidate& candidate = library[static_cast<std::size_t>(s.candidate)];
    if (candidate.kind == CandidateKind::flexible) continue;
    const bool named =
        std::any_of(verdict.causes.begin(), verdict.causes.end(), [&](const NamedCause& cause) {
          return std::any_of(cause.members.begin(), cause.members.end(),
                             [&](const RankedCause& m) { return m.candidate == s.candidate; });
        });
    if (named) continue;
    const double p = selection.last.family.p_value(s.surprise);
    RuledOut out{candidate.name, candidate.place, reason_of(s, candidate, p), s.statistic, p};
    for (const Refusal& refusal : selection.refused)
      if (refusal.candidate == s.candidate && !refusal.reason.empty()) out.reason = refusal.reason;
    verdict.ruled_out.push_back(std::move(out));
  }
}

/// Deviations whose change is not told from none by its standard error, all parameters free.
std::vector<int> uncertain_deviations(const Design& design, const Selection& state) {
  constexpr double kStandardErrors = 3.0;
  std::vector<int> list;
  const auto all = estimates(design, state.model, state.noise);
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (state.model.terms[t].deviation < 0) continue;
    const bool certain = std::any_of(all[t].begin(), all[t].end(), [](const ParameterEstimate& p) {
      return std::abs(p.value) >= kStandardErrors * p.standard_error;
    });
    if (!certain) list.push_back(state.model.terms[t].deviation);
  }
  return list;
}

/// The deviations the model's own values differ in. Those that are not certain, and those that
/// structure without a name takes over, are taken back.
DeviationSelection find_deviations(const Design& design, const Settings& settings,
                                   const Structure& structure, Explanation& result) {
  Unexplained& unexplained = result.verdict.unexplained;
  std::vector<int> taken_back;
  for (;;) {
    DeviationSelection deviations =
        select_deviations(design, settings, result.selection, taken_back);
    std::vector<int> now = uncertain_deviations(design, deviations.state);
    if (now.empty() && !unexplained.depends_on.empty()) {
      const ExplainedStructure names =
          explained_structure_of(design, settings, deviations.state, result.selection, structure);
      unexplained.named_share = names.named_share;
      unexplained.none_of_the_known = names.named_share < kNamesHold;
      now = names.displaced;
      for (const int deviation : now)
        unexplained.withdrawn.push_back(
            design.problem().deviations[static_cast<std::size_t>(deviation)].name);
    }
    if (now.empty()) return deviations;
    taken_back.insert(taken_back.end(), now.begin(), now.end());
  }
}

/// What is left without a name, and the values of the model that differ; causes that one alone may
/// replace are exchanged for it.
DeviationSelection find_values(const Design& design, const Library& library,
                               const Settings& settings, Explanation& result) {
  constexpr int most_exchanges = 2;
  Selection& selection = result.selection;
  for (int left = most_exchanges;; --left) {
    const Selection found = selection;
    const Structure structure = find_unexplained(design, library, settings, selection);
    result.verdict.unexplained = structure.said;
    if (!structure.said.withdrawn.empty()) selection.noise = own_noise(design, selection.model);
    if (design.problem().deviations.empty()) return {};
    DeviationSelection deviations = find_deviations(design, settings, structure, result);
    const auto fewer =
        left > 0 ? find_fewer_causes(design, library, settings, deviations.state) : std::nullopt;
    if (!fewer) return deviations;
    selection = replace_causes(design, library, settings, found, *fewer);
  }
}

/// The term of a candidate of the library, or of another form of the same name at the same place.
std::optional<std::size_t> term_of(const Design& design, int candidate, const Model& model) {
  const Candidate& named = design.problem().library[static_cast<std::size_t>(candidate)];
  std::optional<std::size_t> other;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Term& term = model.terms[t];
    if (term.baseline || term.deviation >= 0) continue;
    if (library_index(design, term) == candidate) return t;
    if (term.candidate->name == named.name && term.candidate->place == named.place) other = t;
  }
  return other;
}

/// The cause's term is that of another form of the same name.
void take_form(int candidate, NamedCause& cause) {
  for (RankedCause& member : cause.members)
    if (member.candidate == cause.candidate) member.candidate = candidate;
  cause.candidate = candidate;
}

/// Of a set the member that the model is extended by goes first: beside values that are free
/// another one may have been ahead.
void put_adopted_first(const Design& design, const Model& model, NamedCause& cause) {
  if (cause.candidate < 0 || term_of(design, cause.candidate, model)) return;
  const auto is_adopted = [&](const RankedCause& member) {
    return member.candidate >= 0 && term_of(design, member.candidate, model);
  };
  const auto adopted = std::find_if(cause.members.begin(), cause.members.end(), is_adopted);
  if (adopted == cause.members.end()) return;
  std::rotate(cause.members.begin(), adopted, adopted + 1);
  cause.candidate = cause.members.front().candidate;
}

/// Gains and forms of the causes as the model is extended by them: beside values that are free a
/// cause may have another form.
void follow_adopted(const Design& design, const Settings& settings, const Selection& state,
                    Explanation& result) {
  // Beside values of the model that are free, a cause gains no more than they leave to it: of logs
  // under one load friction by the load would gain nothing. Where it takes most of what the model
  // as adopted leaves over, in which they are not free, that is what it gains; and so it is where
  // it took the place of such values.
  constexpr double kMost = 0.5;
  const std::vector<int>& exchanged = result.selection.exchanged;
  for (NamedCause& cause : result.verdict.causes) {
    if (cause.candidate < 0) continue;
    put_adopted_first(design, state.model, cause);
    const std::optional<std::size_t> t = term_of(design, cause.candidate, state.model);
    if (!t) continue;
    const bool is_exchanged =
        std::find(exchanged.begin(), exchanged.end(), cause.candidate) != exchanged.end();
    const Gain adopted = gain_on_held_out(design, settings, state, *t);
    if (adopted.low > kMost || is_exchanged) cause.held_out = cause.confirmed = adopted;
    take_form(library_index(design, state.model.terms[*t]), cause);
  }
}

/// Names the deviations the model's own values differ in, and lists the others as ruled out.
void name_deviations(const Design& design, const Library& library, const Settings& settings,
                     DeviationSelection deviations, Explanation& result) {
  Selection& state = deviations.state;
  follow_adopted(design, settings, state, result);
  std::vector<std::size_t> named;
  for (std::size_t t = 0; t < state.model.terms.size(); ++t)
    if (state.model.terms[t].deviation >= 0) named.push_back(t);
  const std::size_t first = result.verdict.causes.size();
  for (const std::size_t t : named) {
    NamedCause cause = name_cause(design, library, settings, t, state);
    cause.confidence =
        confidence_of({cause.confidence, cause.p_family, cause.cross_validated.share, 0.0});
    result.verdict.causes.push_back(std::move(cause));
  }
  const auto all = told_estimates(design, state.model, state.noise);
  for (std::size_t i = 0; i < named.size(); ++i)
    result.verdict.causes[first + i].parameters = all[named[i]];
  // Told as the model is extended by them: beside values that are free a cause that does much the
  // same as they do has hardly a size.
  for (std::size_t i = 0; i < first; ++i) {
    NamedCause& cause = result.verdict.causes[i];
    if (cause.candidate < 0) continue;
    if (const auto t = term_of(design, cause.candidate, state.model)) cause.parameters = all[*t];
  }
  const std::vector<ParameterDeviation>& causes = design.problem().deviations;
  for (std::size_t l = 0; l < causes.size(); ++l) {
    const int index = -1 - static_cast<int>(l);
    const bool is_named = std::any_of(
        result.verdict.causes.begin(), result.verdict.causes.end(), [&](const NamedCause& c) {
          return std::any_of(c.members.begin(), c.members.end(),
                             [&](const RankedCause& m) { return m.candidate == index; });
        });
    if (is_named) continue;
    RuledOut out{causes[l].name, causes[l].place, "nothing beyond noise beside the named causes",
                 deviations.statistic[l], deviations.p_family[l]};
    for (const Refusal& refusal : deviations.refused)
      if (refusal.candidate == index) out.reason = refusal.reason;
    result.verdict.ruled_out.push_back(std::move(out));
  }
  result.adopted = std::move(deviations.state);
}

/// The model before any cause: its free coefficients are fitted, its values are its own. `parts`:
/// the model found, which owns what the result points to.
Model model_before(const Design& design, const Model& found, const DeviationTerms& parts) {
  Model model = design.problem().deviations.empty() ? found : parts.base;
  for (std::size_t t = model.terms.size(); t-- > 0;)
    if (!model.terms[t].baseline) remove_term(design, t, model);
  return model;
}

}  // namespace

Explanation explain_by_rules(const Problem& problem, const Settings& settings,
                             const IsWanted& is_wanted) {
  Design design(problem, settings);
  design.set_units(left_over(design, baseline_model(design)));
  const Library library(design);
  Explanation result;
  result.selection = select_causes(design, library, settings);
  DeviationSelection deviations = find_values(design, library, settings, result);
  Selection& selection = result.selection;
  Verdict& verdict = result.verdict;

  std::vector<std::size_t> named;
  for (std::size_t t = 0; t < selection.model.terms.size(); ++t) {
    const Term& term = selection.model.terms[t];
    if (!term.baseline && (term.candidate->kind == CandidateKind::named ||
                           term.candidate->kind == CandidateKind::delay))
      named.push_back(t);
  }
  for (const std::size_t t : named) {
    NamedCause cause = name_cause(design, library, settings, t, selection);
    cause.confidence = confidence_of({cause.confidence, cause.p_family, cause.cross_validated.share,
                                      1.0 - verdict.unexplained.named_share});
    verdict.causes.push_back(std::move(cause));
  }
  result.estimates = told_estimates(design, selection.model, selection.noise);
  for (std::size_t i = 0; i < named.size(); ++i)
    verdict.causes[i].parameters = result.estimates[named[i]];
  for (std::size_t t = 0; t < selection.model.terms.size(); ++t)
    if (selection.model.terms[t].baseline)
      for (const ParameterEstimate& estimate : result.estimates[t])
        verdict.baseline.push_back(estimate);
  if (is_wanted && !is_wanted(result)) return result;
  list_ruled_out(design, selection, verdict);
  if (!problem.deviations.empty())
    name_deviations(design, library, settings, std::move(deviations), result);
  std::stable_sort(verdict.causes.begin(), verdict.causes.end(),
                   [](const NamedCause& a, const NamedCause& b) {
                     return a.cross_validated.share > b.cross_validated.share;
                   });
  const DeviationTerms parts = take_apart(design, selection.model);
  tell_errors(design, settings, model_before(design, selection.model, parts),
              problem.deviations.empty() ? selection : result.adopted, verdict);
  return result;
}

}  // namespace sinew::diagnosis
