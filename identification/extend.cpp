// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/extend.h"

#include <algorithm>

#include "identification/effect_candidate.h"
#include "identification/standard_errors.h"
#include "symbolic/effects/effects.h"

namespace sinew::diagnosis {
namespace {

/// The estimate called `name`; of a nuisance the first log's.
const ParameterEstimate* find(const std::vector<ParameterEstimate>& estimates,
                              const std::string& name) {
  for (const ParameterEstimate& e : estimates)
    if (e.name == name) return &e;
  return nullptr;
}

IdentifiedValue value_of(const std::vector<ParameterEstimate>& estimates, const std::string& name) {
  const ParameterEstimate* e = find(estimates, name);
  return e ? IdentifiedValue{name, e->value, e->standard_error, e->unit}
           : IdentifiedValue{name, 0.0, 0.0, "1"};
}

/// An effect of the catalogue.
void fill(const CandidateOrigin& origin, bool revolute,
          const std::vector<ParameterEstimate>& estimates, IdentifiedEffect& entry) {
  const Effect& effect = find_effect(entry.effect);
  for (std::size_t k = 0; k < effect.shapes.size(); ++k) {
    const ShapeParameter& shape = effect.shapes[k];
    if (origin.fixed.size() > 0)
      entry.shape.push_back({shape.name, origin.fixed(static_cast<Eigen::Index>(k)), 0.0,
                             unit_at(shape.unit, revolute)});
    else
      entry.shape.push_back(value_of(estimates, shape.name));
  }
  for (const EffectColumn& column : effect.columns)
    entry.coefficients.push_back(value_of(estimates, column.name));
}

/// Entries that are no effect of the catalogue. False where the model has no place for it.
bool fill_special(const std::vector<ParameterEstimate>& estimates, IdentifiedEffect& entry) {
  if (entry.effect == "delay") {
    entry.coefficients = {value_of(estimates, "delay")};
    return true;
  }
  if (entry.effect == "torque_constant") {
    // The term says by how much the logged effort exceeds what the motion took.
    IdentifiedValue gain = value_of(estimates, "gain");
    gain.name = "gain_change";
    gain.value = 1.0 / (1.0 + gain.value) - 1.0;
    entry.coefficients = {gain};
    return true;
  }
  return false;
}

bool in_catalogue(const std::string& id) {
  return std::any_of(effects().begin(), effects().end(),
                     [&](const Effect& effect) { return effect.id == id; });
}

/// Friction of the baseline whose law is a bristle's: its direction, and the change of its level.
void add_friction(const DrivenSubject& subject, std::size_t joint,
                  const std::vector<ParameterEstimate>& estimates, const ExtensionTerm& base,
                  std::vector<ExtensionTerm>& result) {
  ExtensionTerm direction = base, level = base;
  direction.entry.effect = "direction";
  direction.entry.shape = {value_of(estimates, "presliding_length")};
  level.entry.effect = "coulomb_level";
  level.entry.coefficients = {value_of(estimates, "level")};
  level.entry.coefficients.front().name = "level_change";
  level.entry.coefficients.front().value -= subject.model().joints[joint].friction;
  result.push_back(std::move(direction));
  result.push_back(std::move(level));
}

/// Of the causes, the one whose first member is this candidate.
int cause_of(const Verdict& verdict, int candidate) {
  for (std::size_t c = 0; c < verdict.causes.size(); ++c)
    if (verdict.causes[c].members.front().candidate == candidate) return static_cast<int>(c);
  return -1;
}

bool same_values(const std::vector<IdentifiedValue>& a, const std::vector<IdentifiedValue>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.value == y.value; });
}

}  // namespace

std::vector<ExtensionTerm> extension_terms(const DrivenSubject& subject,
                                           const Explanation& explanation) {
  const Problem& problem = subject.problem();
  const Selection& selection = explanation.selection;
  const Settings settings;
  std::vector<ExtensionTerm> result;
  for (std::size_t t = 0; t < selection.model.terms.size(); ++t) {
    const Term& term = selection.model.terms[t];
    const auto index = static_cast<std::size_t>(
        term.candidate - (term.baseline ? problem.baseline.data() : problem.library.data()));
    const CandidateOrigin& origin =
        term.baseline ? subject.baseline_origins()[index] : subject.library_origins()[index];
    if (origin.effect.empty()) continue;
    ExtensionTerm entry;
    entry.term = t;
    entry.baseline = term.baseline;
    entry.cause = term.baseline ? -1 : cause_of(explanation.verdict, static_cast<int>(index));
    entry.entry.effect = origin.effect;
    entry.entry.place = subject.model().joints[origin.joint].name;
    const auto& estimates = explanation.estimates[t];
    if (term.baseline && origin.effect == "presliding") {
      add_friction(subject, origin.joint, estimates, entry, result);
      continue;
    }
    if (in_catalogue(origin.effect))
      fill(origin, subject.model().joints[origin.joint].revolute, estimates, entry.entry);
    else if (!fill_special(estimates, entry.entry))
      continue;
    entry.per_log = std::any_of(term.candidate->linear.begin(), term.candidate->linear.end(),
                                [](const LinearParameter& p) { return p.per_log; });
    result.push_back(std::move(entry));
  }
  return result;
}

Identified extended(const Identified& before, const std::vector<ExtensionTerm>& terms) {
  Identified result = before;
  for (const ExtensionTerm& term : terms) {
    if (term.entry.effect == "direction")
      std::erase_if(result.effects, [&](const IdentifiedEffect& e) {
        return e.effect == "direction" && e.place == term.entry.place;
      });
    const auto same =
        std::find_if(result.effects.begin(), result.effects.end(), [&](const IdentifiedEffect& e) {
          return e.effect == term.entry.effect && e.place == term.entry.place &&
                 same_values(e.shape, term.entry.shape);
        });
    if (same == result.effects.end()) {
      result.effects.push_back(term.entry);
      continue;
    }
    for (std::size_t k = 0; k < same->coefficients.size(); ++k) {
      same->coefficients[k].value += term.entry.coefficients[k].value;
      same->coefficients[k].standard_error = term.entry.coefficients[k].standard_error;
    }
  }
  return result;
}

}  // namespace sinew::diagnosis
