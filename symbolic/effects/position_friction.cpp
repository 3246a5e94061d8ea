// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/turning.h"

namespace sinew {

Effect position_friction() {
  Effect e("position_friction", "friction that varies with position");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex direction = turning_direction(e);
  e.column("slope", "{effort}/{position}", Sign::any, direction * s.position);
  e.signature = "the step at a reversal depends on where it happens";
  e.excitation = "reversals all over the range";
  e.experiment = "short slow triangles at several positions";
  e.compensable = true;
  return e;
}

}  // namespace sinew
