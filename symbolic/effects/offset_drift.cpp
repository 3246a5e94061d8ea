// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect offset_drift() {
  Effect e("offset_drift", "drift of the offset");
  const EffectSignals& s = effect_signals();
  e.column("rate", "{effort}/s", Sign::any, s.time);
  e.signature = "effort left over that grows with time whatever the motion";
  e.excitation = "a long log";
  e.experiment = "standstill under power for a long time";
  return e;
}

}  // namespace sinew
