// SPDX-License-Identifier: GPL-3.0-or-later
// What may be wrong with a wrist whose tendons are kept at their force, each with its symbols,
// limits and equation (6.9). Where they act: wrist_observation.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "symbolic/extension/observation.h"

namespace sinew {

struct WristEffects {
  explicit WristEffects(std::size_t tendons);
  std::vector<ObservationEffect> all() const;

  ObservationEffect coupling{"wrist_coupling", "coupling left uncompensated", "wrist", {}, {}, {}};
  ObservationEffect zero71{"wrist_zero", "zero offset", "q71", {}, {}, {}};
  ObservationEffect zero73{"wrist_zero", "zero offset", "q73", {}, {}, {}};
  ObservationEffect contact{"contact_shift", "contact-point shift", "wrist", {}, {}, {}};
  ObservationEffect scale71{"sensor_scale", "scale of the angle sensor", "q71", {}, {}, {}};
  ObservationEffect scale73{"sensor_scale", "scale of the angle sensor", "q73", {}, {}, {}};
  ObservationEffect low_pass71{
      "sensor_low_pass", "low-pass of the angle sensor", "q71", {}, {}, {}};
  ObservationEffect low_pass73{
      "sensor_low_pass", "low-pass of the angle sensor", "q73", {}, {}, {}};
  ObservationEffect play71{
      "sensor_hysteresis", "hysteresis of the angle sensor", "q71", {}, {}, {}};
  ObservationEffect play73{
      "sensor_hysteresis", "hysteresis of the angle sensor", "q73", {}, {}, {}};
  std::vector<ObservationEffect> radii;

 private:
  void describe_wrist();
  void describe_angles();
  void add_radius(std::size_t tendon);
  void write_equations();
};

}  // namespace sinew
