// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/piecewise.h"

namespace sinew {

Effect elastic_hysteresis() {
  Effect e("elastic_hysteresis", "hysteresis");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex length = e.shape("length", "{position}", Scale::reach, 1e-3, 0.3, 5);
  const GiNaC::symbol z("z");
  const GiNaC::ex travel = s.velocity * s.step / length;
  const GiNaC::ex left = GiNaC::exp(-magnitude(travel));
  const GiNaC::ex now = choose(travel, 1 - (1 - z) * left, (1 + z) * left - 1);
  e.states = {{z, 0.0, now}};
  e.column("half_width", "{effort}", Sign::positive, now * magnitude(s.load));
  e.signature = "a loop whose width grows with the load";
  e.excitation = "loading and unloading to several levels";
  e.experiment = "triangular loading to several levels";
  e.limit = "the loop would run the wrong way round";
  return e;
}

}  // namespace sinew
