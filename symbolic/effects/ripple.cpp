// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect ripple() {
  Effect e("ripple", "ripple");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex order = e.shape("wavenumber", "rad/{position}", Scale::none, 1.0, 1000.0);
  e.column("sine", "{effort}", Sign::any, GiNaC::sin(order * s.position), true);
  e.column("cosine", "{effort}", Sign::any, GiNaC::cos(order * s.position), true);
  e.signature = "a periodic effort over the position";
  e.excitation = "motion over several periods, slow enough to resolve them";
  e.experiment = "slow constant speed over several turns both ways";
  e.compensable = true;
  return e;
}

}  // namespace sinew
