// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/turning.h"

namespace sinew {

Effect stribeck() {
  Effect e("stribeck", "Stribeck friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex speed = e.shape("stribeck_velocity", "{velocity}", Scale::speed, 0.01, 0.3);
  const GiNaC::ex direction = turning_direction(e);
  e.column("extra_at_rest", "{effort}", Sign::positive,
           direction * GiNaC::exp(-GiNaC::pow(s.velocity / speed, 2)));
  e.signature = "friction falls as motion begins";
  e.excitation = "very slow motion";
  e.experiment = "constant speeds, densely spaced near zero";
  e.limit = "friction rises, not falls, as the drive starts to move";
  return e;
}

}  // namespace sinew
