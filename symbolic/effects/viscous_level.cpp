// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect viscous_level() {
  Effect e("viscous_level", "viscous friction level");
  const EffectSignals& s = effect_signals();
  e.column("viscous_change", "{effort}/{velocity}", Sign::any, s.velocity);
  e.signature = "effort left over in proportion to the velocity";
  e.excitation = "several speeds";
  e.experiment = "slow runs at constant speeds, both ways";
  e.compensable = true;
  return e;
}

}  // namespace sinew
