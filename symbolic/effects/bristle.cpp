// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/bristle.h"

#include "symbolic/expressions/piecewise.h"

namespace sinew {

GiNaC::ex add_bristle(const GiNaC::ex& length, Effect& effect) {
  const EffectSignals& s = effect_signals();
  const GiNaC::symbol z("z");
  const GiNaC::ex travel = s.velocity * s.step / length;
  const GiNaC::ex left = GiNaC::exp(-magnitude(travel));
  const GiNaC::ex now = choose(travel, 1 - (1 - z) * left, (1 + z) * left - 1);
  effect.states = {{z, now}};
  return now;
}

void creep_in_guide(Effect& effect) {
  const GiNaC::ex length = effect.shape("presliding_length", "m", Scale::none, 3e-6, 1e-3, 4);
  const GiNaC::ex now = add_bristle(length, effect);
  for (EffectColumn& column : effect.columns)
    column.term = column.term.subs(effect_signals().direction == now);
}

}  // namespace sinew
