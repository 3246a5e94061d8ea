// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/turning.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect load_friction() {
  Effect e("load_friction", "load-dependent friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex direction = turning_direction(e);
  e.column("share", "1", Sign::positive, direction * magnitude(s.load));
  e.signature = "the step at a reversal grows with the load";
  e.excitation = "reversals under different loads";
  e.experiment = "slow triangular motion under several loads";
  e.limit = "friction would fall with load";
  e.compensable = true;
  return e;
}

}  // namespace sinew
