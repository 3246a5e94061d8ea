// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect concave_friction() {
  Effect e("concave_friction", "friction concave in speed");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex bend = e.shape("bend", "{velocity}", Scale::speed, 0.03, 0.4);
  e.column("plateau", "{effort}", Sign::positive, GiNaC::atan(s.velocity / bend));
  e.signature = "friction over velocity bends towards a plateau";
  e.excitation = "the whole range of speeds";
  e.experiment = "constant speeds from slow to fast, both ways";
  e.limit = "friction would bend upwards";
  e.compensable = true;
  return e;
}

}  // namespace sinew
