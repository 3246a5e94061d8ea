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
  effect.states = {{z, 0.0, now}};
  return now;
}

}  // namespace sinew
