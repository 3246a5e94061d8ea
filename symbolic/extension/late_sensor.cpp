// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/late_sensor.h"

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

using GiNaC::ex;

void describe_late_sensor(const LateSensor& sensor, ObservationEffect& low_pass,
                          ObservationEffect& play) {
  const GiNaC::symbol reading(sensor.reading), speed(sensor.reading + "_speed"),
      turned("play_direction");
  low_pass.deviations = {observation_parameter("lag", "s", 0.0, 0.1, 1e-5)};
  low_pass.limit = "the sensor would know the future";
  low_pass.experiment = "the same travel slow and fast";
  low_pass.signature = sensor.shows + ", in proportion to the speed";
  low_pass.excitation = "several speeds";
  low_pass.left = sensor.reading;
  low_pass.term = reading + low_pass.deviation() * speed;
  play.deviations = {
      observation_parameter("half_width", sensor.unit, 0.0, sensor.most, sensor.step)};
  play.limit = "the sensor would run ahead of the " + sensor.moved;
  play.experiment = "slow triangular motion, the reading against a gauge at the " + sensor.moved;
  play.signature = sensor.shows + " by the same " + (sensor.unit == "1" ? "counts" : "amount") +
                   ", the other way in each direction";
  play.excitation = "both directions, slowly";
  play.left = sensor.reading;
  play.term = reading + play.deviation() * turned;
}

LateInputs late_inputs(const std::string& reading, const std::string& unit, double fastest) {
  return {scalar_argument(reading + "_rate", unit, {-fastest, fastest},
                          "without the sensor's flicker: zero where it rests"),
          scalar_argument(reading + "_speed", unit, {-fastest, fastest},
                          "the reading's smooth derivative")};
}

ex turned_side(DefinitionList& list, const std::string& name, const ex& before, const ex& travel,
               const ex& length) {
  const ex z = clamped(before, -1, 1);
  const ex way = list.define(name + "_way", travel / length);
  const ex left = list.define(name + "_left", GiNaC::exp(-magnitude(way)));
  return list.define(name + "_next", choose(way, 1 - (1 - z) * left, (1 + z) * left - 1));
}

ex in_time(const ex& reading, const LateInputs& inputs, const ex& side,
           const ObservationEffect& low_pass, const ObservationEffect& play) {
  return reading + low_pass.deviation() * clamped(inputs.speed.symbols[0], -1000000, 1000000) +
         play.deviation() * side;
}

ex moved_since(const LateInputs& inputs, const Argument& step) {
  return clamped(inputs.rate.symbols[0], -1000000, 1000000) * clamped(step.symbols[0], 0, 1);
}

}  // namespace sinew
