// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/extend.h"

#include <algorithm>
#include <cmath>

#include "identification/adoption/adopted_fit.h"
#include "identification/adoption/physical_links.h"
#include "identification/diagnosis/form_errors.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/rigid_candidates.h"
#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/learnt_entry.h"
#include "symbolic/model/pseudo_inertia.h"

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
void fill(const CandidateOrigin& origin, bool revolute, const Eigen::VectorXd& searched,
          const std::vector<ParameterEstimate>& estimates, IdentifiedEffect& entry) {
  const Effect& effect = find_effect(entry.effect);
  for (std::size_t k = 0; k < effect.shapes.size(); ++k) {
    const ShapeParameter& shape = effect.shapes[k];
    IdentifiedValue value = value_of(estimates, shape.name);
    value.unit = unit_at(shape.unit, revolute);
    value.value = (origin.fixed.size() > 0 ? origin.fixed : searched)(static_cast<Eigen::Index>(k));
    entry.shape.push_back(std::move(value));
  }
  for (const EffectColumn& column : effect.columns) {
    IdentifiedValue value = value_of(estimates, column.name);
    value.unit = unit_at(column.unit, revolute);
    entry.coefficients.push_back(std::move(value));
  }
}

/// Entries that are no effect of the catalogue. False where the model has no place for it.
bool fill_special(const std::vector<ParameterEstimate>& estimates, IdentifiedEffect& entry) {
  if (entry.effect == "delay") {
    entry.coefficients = {value_of(estimates, "delay")};
    return true;
  }
  if (changes_mechanism(entry)) {
    for (const ParameterEstimate& e : estimates)
      entry.coefficients.push_back({e.name, e.value, e.standard_error, e.unit});
    return true;
  }
  if (entry.effect == "torque_constant" || entry.effect == "pulley_radius") {
    // The term says by how much the logged effort exceeds what the motion took.
    IdentifiedValue gain = value_of(estimates, "gain");
    gain.name = "gain_change";
    gain.value = 1.0 / (1.0 + gain.value) - 1.0;
    entry.coefficients = {gain};
    return true;
  }
  return false;
}

/// A link's mass told alone leaves the link its shape: the first moments go with it.
void keep_centre(const Mechanism& mechanism, IdentifiedEffect& entry) {
  if (entry.effect != "inertial_parameters" || entry.coefficients.size() != 1) return;
  const auto body = std::find_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                 [&](const Body& b) { return "link " + b.name == entry.place; });
  if (body == mechanism.bodies.end()) return;
  const IdentifiedValue mass = entry.coefficients.front();
  const char* axes[] = {"x", "y", "z"};
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double centre = body->centre_of_mass(k);
    entry.coefficients.push_back({std::string("first_moment_") + axes[k], mass.value * centre,
                                  mass.standard_error * std::abs(centre), "kg*m"});
  }
}

/// Goes with the payload's cause.
ExtensionTerm drawing_entry(const DrawingError& error, int cause) {
  ExtensionTerm term;
  term.cause = cause;
  term.entry.effect = "inertial_parameters";
  term.entry.place = error.link;
  for (const ParameterEstimate& e : error.estimates)
    term.entry.coefficients.push_back({e.name, e.value, e.standard_error, e.unit});
  return term;
}

/// An estimate may lie beyond its limit by what chance does.
void keep_within_limits(IdentifiedEffect& entry) {
  const std::optional<DeclaredEntry> declared = declared_entry(entry.effect);
  if (!declared) return;
  for (IdentifiedValue& value : entry.coefficients)
    for (const DeclaredValue& each : declared->coefficients)
      if (each.name == value.name)
        value.value = std::clamp(value.value, each.limits.low, each.limits.high);
}

bool in_catalogue(const std::string& id) {
  return std::any_of(effects().begin(), effects().end(),
                     [&](const Effect& effect) { return effect.id == id; });
}

/// What was learnt of how a joint's friction turns stays: these logs alone do not speak against it.
bool is_learnt(const DrivenSubject& subject, const ExtensionTerm& term) {
  const std::vector<IdentifiedEffect>& known = subject.identified().effects;
  return std::any_of(known.begin(), known.end(), [&](const IdentifiedEffect& e) {
    return e.effect == term.entry.effect && e.place == term.entry.place;
  });
}

/// The direction of friction where its law over the velocity is a bristle's.
void add_directions(const DrivenSubject& subject, const Selection& selection,
                    const std::vector<std::vector<ParameterEstimate>>& all,
                    std::vector<ExtensionTerm>& result) {
  for (std::size_t t = 0; t < selection.model.terms.size(); ++t) {
    const Term& term = selection.model.terms[t];
    if (!term.baseline) continue;
    const CandidateOrigin& origin = subject.baseline_origins()[static_cast<std::size_t>(
        term.candidate - subject.problem().baseline.data())];
    if (origin.effect == "soft_reversal" || origin.effect == "late_reversal") {
      ExtensionTerm soft;
      soft.entry.effect = origin.effect;
      soft.entry.place = subject.model().joints[origin.joint].name;
      fill(origin, subject.model().joints[origin.joint].revolute, term.nonlinear, all[t],
           soft.entry);
      if (!is_learnt(subject, soft)) result.push_back(std::move(soft));
    }
    if (origin.effect != "presliding") continue;
    ExtensionTerm direction;
    direction.entry.effect = "direction";
    direction.entry.place = subject.model().joints[origin.joint].name;
    direction.entry.shape = {value_of(all[t], "presliding_length")};
    direction.entry.shape.front().value = term.nonlinear(0);
    direction.entry.shape.front().unit = unit_at(find_effect("presliding").shapes.front().unit,
                                                 subject.model().joints[origin.joint].revolute);
    if (!is_learnt(subject, direction)) result.push_back(std::move(direction));
  }
}

bool same_values(const std::vector<IdentifiedValue>& a, const std::vector<IdentifiedValue>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.value == y.value; });
}

/// A point learnt before has moments of inertia, which those of its change are added to.
void complete_moments(IdentifiedEffect& entry) {
  if (entry.effect != "payload") return;
  const Eigen::Matrix3d I = moments_of(pseudo_inertia_of(entry));
  const std::pair<const char*, double> all[] = {{"moment_xx", I(0, 0)}, {"moment_yy", I(1, 1)},
                                                {"moment_zz", I(2, 2)}, {"moment_xy", I(0, 1)},
                                                {"moment_xz", I(0, 2)}, {"moment_yz", I(1, 2)}};
  for (const auto& [name, value] : all) {
    const auto named = [&, name = name](const IdentifiedValue& v) { return v.name == name; };
    if (std::none_of(entry.coefficients.begin(), entry.coefficients.end(), named))
      entry.coefficients.push_back({name, value, 0.0, "kg*m^2"});
  }
}

/// Adds to the value of that name, or to the list.
void add_to(std::vector<IdentifiedValue>& values, const IdentifiedValue& more) {
  const auto same = std::find_if(values.begin(), values.end(),
                                 [&](const IdentifiedValue& v) { return v.name == more.name; });
  if (same == values.end()) {
    values.push_back(more);
    return;
  }
  same->value += more.value;
  same->standard_error = more.standard_error;
}

/// The model divides a joint's whole effort by what its torque constant or pulley changed; the fit
/// has that change of the model as it was, and what is added to it beside it. What changes bodies
/// acts on several joints and stays as it was fitted: off by the change at those joints.
void put_before_gains(std::vector<ExtensionTerm>& terms) {
  for (const ExtensionTerm& gain : terms) {
    if (gain.entry.effect != "torque_constant" && gain.entry.effect != "pulley_radius") continue;
    const double whole = 1.0 + gain.entry.coefficient("gain_change");
    for (ExtensionTerm& term : terms) {
      if (term.entry.place != gain.entry.place || !in_catalogue(term.entry.effect)) continue;
      for (IdentifiedValue& value : term.entry.coefficients) {
        value.value *= whole;
        value.standard_error *= whole;
      }
    }
  }
}

/// Of what is everywhere: each of the joints, or of the tendons.
std::vector<std::string> places_of(const DrivenSubject& subject, const CandidateOrigin& origin) {
  std::vector<std::string> places;
  if (origin.tendon.empty())
    for (const DrivenJoint& joint : subject.model().joints) places.push_back(joint.name);
  else
    for (const std::string& name : subject.model().tendons.names)
      places.push_back(tendon_place(name));
  return places;
}

}  // namespace

ExtensionTerms extension_terms(const DrivenSubject& subject, const Design& design,
                               const Explanation& explanation, const Selection& selection) {
  auto all = told_estimates(design, selection.model, selection.noise);
  ExtensionTerms extension;
  const PhysicalLinks physical = make_links_physical(subject, design, selection, all);
  extension.changed = physical.changed;
  std::vector<ExtensionTerm>& result = extension.terms;
  add_directions(subject, explanation.selection, explanation.estimates, result);
  for (std::size_t t = 0; t < selection.model.terms.size(); ++t) {
    const Term& term = selection.model.terms[t];
    if (term.baseline) continue;
    const int candidate = term.deviation >= 0
                              ? -1 - term.deviation
                              : static_cast<int>(term.candidate - subject.problem().library.data());
    const CandidateOrigin& origin = subject.origin_of(term);
    if (origin.effect.empty()) continue;
    ExtensionTerm entry;
    entry.cause = cause_of(explanation.verdict, candidate);
    if (entry.cause < 0) continue;
    entry.entry.effect = origin.effect;
    const ModelEffect* of_model = find_model_effect(origin.effect);
    entry.entry.place = of_model && of_model->place != ModelPlace::joint ? term.candidate->place
                        : origin.tendon.empty() ? subject.model().joints[origin.joint].name
                                                : origin.tendon;
    if (in_catalogue(origin.effect))
      fill(origin, origin.tendon.empty() && subject.model().joints[origin.joint].revolute,
           term.nonlinear, all[t], entry.entry);
    else if (!fill_special(all[t], entry.entry))
      continue;
    if (subject.rigid()) keep_centre(subject.rigid()->mechanism(), entry.entry);
    keep_within_limits(entry.entry);
    entry.per_log = term.deviation < 0 &&
                    std::any_of(term.candidate->linear.begin(), term.candidate->linear.end(),
                                [](const LinearParameter& p) { return p.per_log; });
    // The model has a delay at each joint; one of all joints is the same at each.
    if (origin.everywhere) {
      const std::vector<std::string> places = places_of(subject, origin);
      entry.entry.place = places.front();
      for (auto other = places.begin() + 1; other != places.end(); ++other) {
        result.push_back(entry);
        result.back().entry.place = *other;
      }
    }
    for (const DrawingError& error : physical.drawings)
      if (error.term == t) result.push_back(drawing_entry(error, entry.cause));
    result.push_back(std::move(entry));
  }
  put_before_gains(result);
  return extension;
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
    if (changes_link(term.entry)) complete_moments(*same);
    for (const IdentifiedValue& more : term.entry.coefficients) add_to(same->coefficients, more);
  }
  return result;
}

}  // namespace sinew::diagnosis
