// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction of a sheath that presses on its tendon by itself: what the tendon loses does not
// depend on its force.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guide_drag() {
  Effect e = guiding_friction();
  e.id = "guide_drag";
  const EffectSignals& s = effect_signals();
  const GiNaC::ex of_force = e.columns.front().term;
  // Most guides press on their tendons by the tendons' own force.
  e.unlikely = true;
  e.columns.clear();
  e.column("friction_force", "N/rad", Sign::positive, of_force.subs(s.load == 1));
  e.signature =
      "a force is lost against the tendon's motion, however hard it is pulled, more where it is "
      "bent";
  return e;
}

}  // namespace sinew
