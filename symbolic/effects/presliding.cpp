// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect presliding() {
  Effect e("presliding", "presliding of friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex length = e.shape("presliding_length", "{position}", Scale::reach, 1e-8, 1e-2, 5);
  const GiNaC::symbol z("z");
  const GiNaC::ex travel = s.velocity * s.step / length;
  const GiNaC::ex left = GiNaC::exp(-magnitude(travel));
  // Exact over one sample at constant speed: z runs to the direction of motion over the length.
  const GiNaC::ex now = choose(travel, 1 - (1 - z) * left, (1 + z) * left - 1);
  e.states = {{z, 0.0, now}};
  e.column("level", "{effort}", Sign::positive, now);
  e.signature = "friction that builds up over a short way behind every reversal";
  e.excitation = "small motions with reversals";
  e.experiment = "very small slow triangles";
  e.limit = "friction would drive the motion";
  e.baseline_only = true;
  return e;
}

}  // namespace sinew
