// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/observation.h"

#include <algorithm>
#include <stdexcept>

#include "symbolic/expressions/exact_number.h"

namespace sinew {
namespace {

/// `low` and `high` of a shape are where it is looked for; of a deviation, a tenth of a step either
/// way would do, but a sampled check wants to see it act.
Argument argument_of(const std::string& name, const std::vector<ObservationParameter>& parameters,
                     bool shape) {
  Argument argument;
  argument.name = name;
  argument.rows = static_cast<int>(parameters.size());
  argument.unit = "SI";
  for (const ObservationParameter& p : parameters) {
    argument.symbols.push_back(p.symbol);
    argument.ranges.push_back(shape ? Range{p.low, p.high} : Range{-p.step, p.step});
    argument.doc += (argument.doc.empty() ? "" : ", ") + p.name;
  }
  return argument;
}

void put_values(const std::vector<ObservationParameter>& parameters,
                const std::vector<IdentifiedValue>& values, GiNaC::exmap& map) {
  for (const ObservationParameter& p : parameters)
    for (const IdentifiedValue& value : values)
      if (value.name == p.name) map[p.symbol] = exact_number(value.value);
}

}  // namespace

const ObservationEffect* find_effect(const Observation& observation, const std::string& id,
                                     const std::string& place) {
  for (const ObservationEffect& effect : observation.effects)
    if (effect.id == id && effect.place == place) return &effect;
  return nullptr;
}

ObservationParameter observation_parameter(const std::string& name, const std::string& unit,
                                           double low, double high, double step) {
  return {GiNaC::symbol(name), name, unit, low, high, step};
}

Function open_observation(const Observation& observation) {
  std::vector<ObservationParameter> deviations, shapes;
  for (const ObservationEffect& effect : observation.effects) {
    deviations.insert(deviations.end(), effect.deviations.begin(), effect.deviations.end());
    shapes.insert(shapes.end(), effect.shapes.begin(), effect.shapes.end());
  }
  Function open = observation.function;
  open.inputs.push_back(argument_of("deviation", deviations, false));
  if (!shapes.empty()) open.inputs.push_back(argument_of("shape", shapes, true));
  return open;
}

Function closed_observation(const Observation& observation, const Identified& identified) {
  GiNaC::exmap map;
  for (const ObservationEffect& effect : observation.effects) {
    for (const ObservationParameter& p : effect.deviations) map[p.symbol] = 0;
    for (const ObservationParameter& p : effect.shapes) map[p.symbol] = exact_number(p.high);
  }
  for (const IdentifiedEffect& entry : identified.effects) {
    const ObservationEffect* effect = find_effect(observation, entry.effect, entry.place);
    if (!effect)
      throw std::invalid_argument("identified.toml: " + observation.model + " has no effect '" +
                                  entry.effect + "' at '" + entry.place + "'");
    put_values(effect->deviations, entry.coefficients, map);
    put_values(effect->shapes, entry.shape, map);
  }
  Function closed = observation.function;
  for (Definition& definition : closed.definitions) definition.value = definition.value.subs(map);
  for (Output& output : closed.outputs)
    for (GiNaC::ex& value : output.values) value = value.subs(map);
  return closed;
}

}  // namespace sinew
