// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/late_sensor.h"

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

using GiNaC::ex;

void describe_late_sensor(const LateSensor& sensor, ObservationEffect& low_pass,
                          ObservationEffect& play) {
  const GiNaC::symbol reading(sensor.reading), speed(sensor.reading + "_speed"),
      side(sensor.reading + "_side");
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
  play.term = reading + play.deviation() * side;
}

LateInputs late_inputs(const std::string& reading, const std::string& unit, double fastest) {
  return {scalar_argument(reading + "_speed", unit, {-fastest, fastest},
                          "the reading's smooth derivative"),
          scalar_argument(reading + "_side", "1", {-1.0, 1.0},
                          "end of its play that the sensor is at: the way the reading went last")};
}

ex in_time(const ex& reading, const LateInputs& inputs, const ObservationEffect& low_pass,
           const ObservationEffect& play) {
  return reading + low_pass.deviation() * clamped(inputs.speed.symbols[0], -1000000, 1000000) +
         play.deviation() * clamped(inputs.side.symbols[0], -1, 1);
}

}  // namespace sinew
