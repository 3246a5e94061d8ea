// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect gear_elasticity() {
  Effect e("gear_elasticity", "gear elasticity");
  const EffectSignals& s = effect_signals();
  // Negative with the sensor on the motor, positive with it on the output.
  e.column("compliance_term", "{effort}*s^2/{acceleration}", Sign::any, s.jounce);
  e.signature = "effort left over in proportion to the second derivative of the acceleration";
  e.excitation = "fast changes of acceleration";
  e.experiment = "a sweep of frequencies with the output free";
  return e;
}

}  // namespace sinew
