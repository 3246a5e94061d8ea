// SPDX-License-Identifier: GPL-3.0-or-later
// At a tendon: load is the force.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect force_sensor_scale() {
  Effect e("force_sensor_scale", "scale of the force sensor");
  const EffectSignals& s = effect_signals();
  e.column("force_excess", "1", Sign::any, s.load).most = 0.3;
  e.signature =
      "torques off in proportion to one tendon's force, at every joint that it passes "
      "and at its motor";
  e.excitation = "varying force in one tendon";
  e.experiment = "the tendon pulled against a known weight";
  e.limit = "a sensor that works is not that far off";
  e.at_tendon = true;
  e.scales_force = true;
  e.felt_by_motor = true;
  return e;
}

}  // namespace sinew
