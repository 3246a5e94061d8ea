// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect offset() {
  Effect e("offset", "offset");
  const EffectSignals& s = effect_signals();
  e.column("offset", "{effort}", Sign::any, GiNaC::ex(1));
  (void)s;
  e.signature = "the same effort left over all the time";
  e.excitation = "any motion, both ways";
  e.experiment = "the same slow run both ways";
  return e;
}

}  // namespace sinew
