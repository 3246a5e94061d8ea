// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/turning.h"

namespace sinew {

Effect friction_drift() {
  Effect e("friction_drift", "slow drift of friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex duration = e.shape("time_constant", "s", Scale::duration, 0.05, 2.0, 3);
  const GiNaC::ex direction = turning_direction(e);
  e.column("change", "{effort}", Sign::any, direction * (1 - GiNaC::exp(-s.time / duration)));
  e.signature = "the step at reversals changes in the course of the log";
  e.excitation = "a log longer than warming up takes";
  e.experiment = "the same motion repeated from cold until nothing changes";
  return e;
}

}  // namespace sinew
