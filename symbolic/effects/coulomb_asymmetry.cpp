// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect coulomb_asymmetry() {
  Effect e("coulomb_asymmetry", "Coulomb friction asymmetry");
  const EffectSignals& s = effect_signals();
  e.column("difference", "{effort}", Sign::any, magnitude(s.direction));
  e.signature = "a notch at standstill beside an offset: the two directions have different levels";
  e.excitation = "slow motion both ways";
  e.experiment = "slow runs at constant speed both ways, with stops";
  e.compensable = true;
  return e;
}

}  // namespace sinew
