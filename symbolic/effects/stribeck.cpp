// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/turning.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect stribeck() {
  Effect e("stribeck", "Stribeck friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex speed = e.shape("stribeck_velocity", "{velocity}", Scale::speed, 0.01, 0.3);
  const GiNaC::ex factor = e.shape("shape_factor", "1", Scale::none, 1.0, 2.0, 2);
  e.shapes.back().before = 2.0;
  const GiNaC::ex ratio = maximum(magnitude(s.velocity) / speed, GiNaC::numeric(1, 1000000));
  const GiNaC::ex direction = turning_direction(e);
  e.column("extra_at_rest", "{effort}", Sign::positive,
           direction * GiNaC::exp(-GiNaC::exp(factor * GiNaC::log(ratio))));
  e.signature = "friction falls as motion begins";
  e.excitation = "very slow motion";
  e.experiment = "constant speeds, densely spaced near zero";
  e.limit = "friction rises, not falls, as the drive starts to move";
  return e;
}

}  // namespace sinew
