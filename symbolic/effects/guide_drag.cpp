// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction of a sheath that presses on its tendon by itself: what the tendon loses does not
// depend on its force.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guide_drag() {
  Effect e("guide_drag", "guiding friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex elsewhere = e.shape("bending_elsewhere", "rad", Scale::none, 0.003, 30.0, 2);
  e.column("friction_force", "N/rad", Sign::positive, s.direction * (s.position + elsewhere));
  e.signature =
      "a force is lost against the tendon's motion, however hard it is pulled, more where it is "
      "bent";
  e.excitation = "reversals at several postures and forces";
  e.experiment = "slow motion back and forth at several postures, the antagonist's force varied";
  e.limit = "friction would drive the tendon";
  e.at_tendon = true;
  e.of_one_make = true;
  return e;
}

}  // namespace sinew
