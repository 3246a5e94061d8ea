// SPDX-License-Identifier: GPL-3.0-or-later
// What a rig's position sensor comes late by: with the motion (a filter), and by the way (play).
// Any rig's sensor may; its effects `sensor_low_pass` and `sensor_hysteresis` say so.
#pragma once

#include <string>

#include "generator/function.h"
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

/// Inputs of a sensor whose reading comes late: `<reading>_speed`, the reading's smooth derivative,
/// in its unit a second, +-`fastest`; `<reading>_side`, the end of its play that the sensor is at,
/// -1..1: the way that its reading went last. While the reading stands still the motion goes from
/// one end to the other, which only the next change of the reading tells: a recording has it, a
/// running system keeps the last side.
struct LateInputs {
  Argument speed, side;
};
LateInputs late_inputs(const std::string& reading, const std::string& unit, double fastest);

/// What the reading would be of a fast and tight sensor.
GiNaC::ex in_time(const GiNaC::ex& reading, const LateInputs& inputs,
                  const ObservationEffect& low_pass, const ObservationEffect& play);

}  // namespace sinew
