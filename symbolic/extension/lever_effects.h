// SPDX-License-Identifier: GPL-3.0-or-later
// What may be wrong with a lever and its tendon on a calibration rig, each with its symbols, limits
// and equation (4.1). Where they act: lever_observation.cpp.
#pragma once

#include <vector>

#include "symbolic/extension/observation.h"

namespace sinew {

struct LeverEffects {
  /// `counts`: how far the lever's sensor may be off.
  explicit LeverEffects(double counts);
  std::vector<ObservationEffect> all() const;

  ObservationEffect spring{"spring_constant", "spring constant", "lever", {}, {}, {0}};
  ObservationEffect preload{"preload_offset", "preload offset", "lever", {}, {}, {0}};
  ObservationEffect hysteresis{"lever_hysteresis", "lever hysteresis", "lever", {}, {}, {0}};
  ObservationEffect series{"series_tendon", "tendon in series", "tendon", {}, {}, {1}};
  ObservationEffect slack{"slack", "slack", "tendon", {}, {}, {1}};
  ObservationEffect scale{"sensor_scale", "scale of the lever sensor", "sensor", {}, {}, {}};
  ObservationEffect offset{"sensor_offset", "offset of the lever sensor", "sensor", {}, {}, {}};
  ObservationEffect low_pass{
      "sensor_low_pass", "low-pass of the lever sensor", "sensor", {}, {}, {}};
  ObservationEffect play{
      "sensor_hysteresis", "hysteresis of the lever sensor", "sensor", {}, {}, {}};
  ObservationEffect zero{
      "force_sensor_offset", "offset of the force sensor", "sensor", {}, {}, {0}};
  ObservationEffect capstan{
      "guiding_capstan", "guiding friction (capstan law)", "tendon", {}, {}, {0}};
  ObservationEffect fitted{
      "guiding_fitted", "guiding friction (fitted law)", "tendon", {}, {}, {0}};

 private:
  void describe_lever();
  void describe_sensors(double counts);
  void describe_guides();
  void write_equations();
};

}  // namespace sinew
