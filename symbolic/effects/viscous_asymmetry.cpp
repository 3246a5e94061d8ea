// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect viscous_asymmetry() {
  Effect e("viscous_asymmetry", "viscous asymmetry");
  const EffectSignals& s = effect_signals();
  e.column("difference", "{effort}/{velocity}", Sign::any, magnitude(s.velocity));
  e.signature = "a V over the velocity: the two directions have different slopes";
  e.excitation = "several speeds both ways";
  e.experiment = "the same constant speeds both ways";
  e.compensable = true;
  return e;
}

}  // namespace sinew
