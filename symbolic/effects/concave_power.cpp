// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/turning.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect concave_power() {
  Effect e("concave_power", "friction concave in speed");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex top = e.shape("top_speed", "{velocity}", Scale::speed, 1.0, 1.0, 1);
  const GiNaC::ex power = e.shape("power", "1", Scale::none, 0.2, 0.8, 3);
  e.shapes.back().limits = {0.0, 1.0, true};
  // Below a millionth of the highest speed there is no motion to speak of.
  const GiNaC::ex speed = maximum(magnitude(s.velocity) / top, GiNaC::numeric(1, 1000000));
  const GiNaC::ex direction = turning_direction(e);
  e.column("at_top_speed", "{effort}", Sign::positive,
           direction * GiNaC::exp(power * GiNaC::log(speed)));
  e.signature = "friction over velocity bends like a root";
  e.excitation = "the whole range of speeds";
  e.experiment = "constant speeds from slow to fast, both ways";
  e.limit = "friction would bend upwards";
  e.compensable = true;
  return e;
}

}  // namespace sinew
