// SPDX-License-Identifier: GPL-3.0-or-later
// What a rig's sensors should read, and how every effect that may be missing changes that: one
// symbolic function with a deviation for each effect, from which the search's derivatives, the
// extended model and the report's equations all come.
#pragma once

#include <string>
#include <vector>

#include "generator/function.h"
#include "symbolic/extension/identified.h"

namespace sinew {

/// A value that is 0 (or, for a shape, arbitrary) where the model is right.
struct ObservationParameter {
  GiNaC::symbol symbol;
  std::string name, unit;
  double low = 0.0, high = 0.0;  ///< physical limits of the change; of a shape its search range
  double step = 0.0;             ///< of a numerical derivative; of a shape the starting points
};

/// With a symbol of that name.
ObservationParameter observation_parameter(const std::string& name, const std::string& unit,
                                           double low, double high, double step);

/// One effect at one place.
struct ObservationEffect {
  std::string id;           ///< as identified.toml has it
  std::string name, place;  ///< as a report says it
  std::vector<ObservationParameter> deviations, shapes;
  std::vector<int> outputs;  ///< of the observation that it acts on; empty: all
  std::string left{};        ///< left side of its equation
  GiNaC::ex term{};          ///< right side
  std::string signature{};   ///< what it leaves over
  std::string excitation{};  ///< what has to happen for it to be seen
  std::string experiment{};  ///< what isolates it
  std::string limit{};       ///< what a violated limit says

  /// Symbol of its first deviation, which most effects have alone.
  GiNaC::ex deviation() const { return deviations.front().symbol; }
};

/// `function` has one output number for each measured channel ("measured"), and "next" where it has
/// a state; its expressions contain the effects' symbols, which are not among its inputs.
struct Observation {
  std::string model;
  Function function;
  std::vector<ObservationEffect> effects;
};

/// The function with the arguments `deviation` (all effects', in their order) and `shape` added.
Function open_observation(const Observation& observation);

/// The function with the values of identified.toml in place; what is not there is 0. Throws
/// std::invalid_argument for an effect or place that the observation has not.
Function closed_observation(const Observation& observation, const Identified& identified);

/// The effect of that identifier and place, nullptr where there is none.
const ObservationEffect* find_effect(const Observation& observation, const std::string& id,
                                     const std::string& place);

}  // namespace sinew
