// SPDX-License-Identifier: GPL-3.0-or-later
// What a rig's position sensor comes late by: with the motion (a filter), and by the way (play).
// Any rig's sensor may; its effects `sensor_low_pass` and `sensor_hysteresis` say so.
#pragma once

#include <string>

#include "generator/function.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/extension/observation.h"

namespace sinew {

/// A sensor as its effects are told.
struct LateSensor {
  std::string reading, unit;  ///< its channel, which the equations' symbols are called by, too
  double most = 0.0;          ///< half of its play at most, in that unit
  double step = 0.0;          ///< of the numerical derivative by that half
  std::string shows, moved;   ///< what is off with it ("... off together"), and what it sits on
};

/// Fills in all of both but identifier, name and place.
void describe_late_sensor(const LateSensor& sensor, ObservationEffect& low_pass,
                          ObservationEffect& play);

/// Inputs of a sensor whose reading comes late: `<reading>_rate`, of the reading without what it
/// flickers by, which turns the play's side and is zero at rest; `<reading>_speed`, the reading's
/// smooth derivative. Both in the reading's unit a second, +-`fastest`.
struct LateInputs {
  Argument rate, speed;
};
LateInputs late_inputs(const std::string& reading, const std::string& unit, double fastest);

/// Dahl's law: the side, -1..1, that a loop is on after `travel`, from the side `before`. The way
/// from one side to the other has a length of its own, in the unit of `travel`; at rest it stays
/// where it is. Defines names that begin with `name`.
GiNaC::ex turned_side(DefinitionList& list, const std::string& name, const GiNaC::ex& before,
                      const GiNaC::ex& travel, const GiNaC::ex& length);

/// What the reading would be of a fast and tight sensor. `side`: of its play, -1..1.
GiNaC::ex in_time(const GiNaC::ex& reading, const LateInputs& inputs, const GiNaC::ex& side,
                  const ObservationEffect& low_pass, const ObservationEffect& play);

/// What the sensor has moved since the sample before. `step`: the input, s.
GiNaC::ex moved_since(const LateInputs& inputs, const Argument& step);

}  // namespace sinew
