// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/possible_terms.h"

#include <fmt/format.h>

#include <algorithm>

#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/learnt_mass_matrix.h"
#include "symbolic/files/description_error.h"

namespace sinew::diagnosis {
namespace {

LearntPlaces places_of(const DrivenSubject& subject) {
  if (!subject.rigid()) return learnt_places_of_motor();
  return learnt_places(subject.rigid()->mechanism(), subject.model().tendons.motor.has_value());
}

/// What follows the first ": ".
std::string behind_colon(const std::string& text) {
  return text.substr(text.find(": ") + 2);
}

/// The first mistake without its place and its key, "effect[0].coefficient[1]": the file is not
/// there yet.
std::string first_mistake(const DescriptionError& error) {
  std::string text = error.messages().front();
  if (text.find(": ") != std::string::npos) text = behind_colon(text);
  const std::size_t key = text.find(": ");
  const bool has_key = key != std::string::npos && text.find_first_of(" '") > key;
  return has_key ? behind_colon(text) : text;
}

std::string name_of(const ExtensionTerm& term) {
  for (const Effect& effect : effects())
    if (effect.id == term.entry.effect) return effect.name;
  const ModelEffect* of_model = find_model_effect(term.entry.effect);
  return of_model ? of_model->name : term.entry.effect;
}

}  // namespace

std::optional<std::string> why_impossible(const DrivenSubject& subject,
                                          const Identified& identified) {
  Identified effects_alone = identified;
  effects_alone.logs.clear();
  try {
    parse_identified(identified_text(effects_alone), "identified.toml", places_of(subject));
    if (!subject.rigid()) return why_not_definite(subject.model(), identified);
    const Mechanism learnt = with_identified(subject.rigid()->mechanism(),
                                             mechanism_changes(subject.identified(), identified));
    return why_not_definite(learnt, subject.model().tendons.motor, identified);
  } catch (const DescriptionError& error) {
    return first_mistake(error);
  }
}

std::optional<std::string> why_impossible(const Observation& observation,
                                          const Identified& identified) {
  try {
    parse_identified(identified_text(identified), "identified.toml", observation);
    return std::nullopt;
  } catch (const DescriptionError& error) {
    return first_mistake(error);
  }
}

PossibleTerms possible_terms(const DrivenSubject& subject, std::vector<ExtensionTerm> terms) {
  std::stable_partition(terms.begin(), terms.end(),
                        [](const ExtensionTerm& t) { return changes_mechanism(t.entry); });
  PossibleTerms result;
  for (ExtensionTerm& term : terms) {
    result.terms.push_back(std::move(term));
    const auto why = why_impossible(subject, extended(subject.identified(), result.terms));
    if (!why) continue;
    const ExtensionTerm& last = result.terms.back();
    result.refused.push_back(
        fmt::format("{} ({}) cannot be adopted: {}", name_of(last), last.entry.place, *why));
    result.terms.pop_back();
  }
  return result;
}

}  // namespace sinew::diagnosis
