// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect soft_reversal() {
  Effect e("soft_reversal", "softness of friction at reversals");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex speed = e.shape("turning_speed", "{velocity}", Scale::speed, 3e-4, 2e-2, 3);
  e.column("softness", "{effort}", Sign::positive,
           GiNaC::tanh(s.velocity / speed) - choose(s.velocity, 1, -1));
  e.signature = "friction that turns with the velocity and not with the way";
  e.excitation = "reversals";
  e.experiment = "very slow reversals";
  e.limit = "friction would be larger next to standstill";
  e.baseline_only = true;
  return e;
}

}  // namespace sinew
