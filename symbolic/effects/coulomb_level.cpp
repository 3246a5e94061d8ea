// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect coulomb_level() {
  Effect e("coulomb_level", "Coulomb friction level");
  const EffectSignals& s = effect_signals();
  e.column("level_change", "{effort}", Sign::any, s.direction);
  e.signature = "a step of the effort at every reversal";
  e.excitation = "reversals";
  e.experiment = "slow triangular motion";
  e.compensable = true;
  return e;
}

}  // namespace sinew
