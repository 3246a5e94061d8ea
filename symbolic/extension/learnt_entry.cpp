// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/learnt_entry.h"

#include "symbolic/effects/effects.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/observation.h"

namespace sinew {
namespace {

std::vector<DeclaredValue> shapes_of(const Effect& effect, bool revolute) {
  std::vector<DeclaredValue> list;
  for (const ShapeParameter& shape : effect.shapes)
    list.push_back(
        {shape.name, unit_at(shape.unit, revolute), shape.limits, true, "", shape.before});
  return list;
}

DeclaredEntry entry_of_effect(const Effect& effect, bool revolute) {
  DeclaredEntry entry;
  entry.place = effect.at_tendon ? PlaceKind::tendon : PlaceKind::joint;
  entry.shapes = shapes_of(effect, revolute);
  for (const EffectColumn& column : effect.columns)
    entry.coefficients.push_back({column.name, unit_at(column.unit, revolute), limits_of(column)});
  entry.limit = effect.limit;
  return entry;
}

PlaceKind kind_of(ModelPlace place) {
  switch (place) {
    case ModelPlace::joint:
      return PlaceKind::joint;
    case ModelPlace::link:
      return PlaceKind::link;
    case ModelPlace::base:
      return PlaceKind::base;
  }
  return PlaceKind::joint;
}

DeclaredEntry entry_of_model_effect(const ModelEffect& effect, bool revolute) {
  DeclaredEntry entry;
  entry.place = kind_of(effect.place);
  for (const ModelCoefficient& c : effect.coefficients)
    entry.coefficients.push_back({c.name, unit_at(c.unit, revolute), c.limits, c.required});
  entry.limit = effect.limit;
  entry.single = true;
  return entry;
}

/// How the model's own friction turns: by the state of the effect "presliding".
constexpr const char* friction_direction = "direction";

}  // namespace

std::optional<DeclaredEntry> declared_entry(const std::string& effect, bool revolute) {
  if (effect == friction_direction) {
    DeclaredEntry entry;
    entry.shapes = shapes_of(find_effect("presliding"), revolute);
    entry.single = true;
    return entry;
  }
  for (const Effect& each : effects())
    if (each.id == effect) return entry_of_effect(each, revolute);
  const ModelEffect* of_model = find_model_effect(effect);
  if (!of_model || of_model->coefficients.empty()) return std::nullopt;
  return entry_of_model_effect(*of_model, revolute);
}

std::optional<DeclaredEntry> declared_entry(const std::string& effect) {
  std::optional<DeclaredEntry> entry = declared_entry(effect, true);
  if (!entry) return entry;
  const DeclaredEntry sliding = *declared_entry(effect, false);
  for (std::size_t k = 0; k < entry->shapes.size(); ++k)
    entry->shapes[k].or_unit = sliding.shapes[k].unit;
  for (std::size_t k = 0; k < entry->coefficients.size(); ++k)
    entry->coefficients[k].or_unit = sliding.coefficients[k].unit;
  return entry;
}

std::vector<std::string> declared_effects() {
  std::vector<std::string> names{friction_direction};
  for (const Effect& each : effects()) names.push_back(each.id);
  for (const ModelEffect& each : model_effects())
    if (!each.coefficients.empty()) names.push_back(each.id);
  return names;
}

std::optional<DeclaredEntry> declared_entry(const Observation& observation,
                                            const std::string& effect, const std::string& place) {
  const ObservationEffect* found = find_effect(observation, effect, place);
  if (!found) return std::nullopt;
  DeclaredEntry entry;
  // Of a shape `low` and `high` say where it is looked for.
  for (const ObservationParameter& p : found->shapes) {
    ValueLimits limits;
    if (p.low > 0.0) limits = {0.0, limits.high, true};
    entry.shapes.push_back({p.name, p.unit, limits});
  }
  for (const ObservationParameter& p : found->deviations)
    entry.coefficients.push_back({p.name, p.unit, {p.low, p.high}});
  entry.limit = found->limit;
  entry.single = true;
  return entry;
}

}  // namespace sinew
