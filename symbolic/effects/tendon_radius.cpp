// SPDX-License-Identifier: GPL-3.0-or-later
// At a tendon: load is the force. The joints feel it with other moment arms than the
// model's; the motor at its other end does not.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect tendon_radius() {
  Effect e("tendon_radius", "radius of one tendon's pulley");
  const EffectSignals& s = effect_signals();
  e.column("radius_change", "1", Sign::any, s.load).most = 0.5;
  e.signature =
      "torques off in proportion to one tendon's force, at every joint that it passes "
      "and not at its motor";
  e.excitation = "varying force in one tendon";
  e.experiment = "the joint turned by a known angle, the tendon's way measured";
  e.limit = "no pulley of the drawing is that far off";
  e.at_tendon = true;
  e.scales_force = true;
  return e;
}

}  // namespace sinew
