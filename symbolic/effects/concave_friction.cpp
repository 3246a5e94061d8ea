// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect concave_friction() {
  Effect e("concave_friction", "friction concave in speed");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex bend = e.shape("bend", "{velocity}", Scale::speed, 0.03, 1.0, 6);
  const GiNaC::ex sharpness = e.shape("sharpness", "1", Scale::none, 1.0, 4.0, 3);
  // Straight below the bend and level above it, the sharper the more suddenly: 1 is
  // v / (|v| + bend), 2 nearly an arctangent, 2.5 a hyperbolic tangent.
  const GiNaC::ex ratio = maximum(magnitude(s.velocity) / bend, GiNaC::numeric(1, 1000000));
  e.column("plateau", "{effort}", Sign::positive,
           s.velocity / bend *
               GiNaC::exp(-GiNaC::log(1 + GiNaC::exp(sharpness * GiNaC::log(ratio))) / sharpness));
  e.signature = "friction over velocity bends towards a plateau";
  e.excitation = "the whole range of speeds";
  e.experiment = "constant speeds from slow to fast, both ways";
  e.limit = "friction would bend upwards";
  e.compensable = true;
  return e;
}

}  // namespace sinew
