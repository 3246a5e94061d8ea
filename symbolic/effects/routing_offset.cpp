// SPDX-License-Identifier: GPL-3.0-or-later
// At a tendon: load is the force, position the joint's angle. A guide that sits off its
// place by (x, y) in the joint's plane turns with the joint, and the moment arm with it.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect routing_offset() {
  Effect e("routing_offset", "routing offset");
  const EffectSignals& s = effect_signals();
  e.column("offset_across", "m", Sign::any, s.load * GiNaC::sin(s.position)).most = 0.02;
  e.column("offset_along", "m", Sign::any, s.load * GiNaC::cos(s.position)).most = 0.02;
  e.signature =
      "torques off in proportion to one tendon's force and to another share of it at every "
      "posture";
  e.excitation = "varying force in one tendon at several postures";
  e.experiment = "the joint turned slowly over its range, the tendon's way measured";
  e.limit = "no guide of the drawing is that far off";
  e.at_tendon = true;
  e.scales_force = true;
  e.changes_arm = true;
  return e;
}

}  // namespace sinew
