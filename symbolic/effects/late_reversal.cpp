// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/bristle.h"
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect late_reversal() {
  Effect e("late_reversal", "bristles of friction at reversals");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex length = e.shape("bristle_length", "{position}", Scale::reach, 1e-7, 3e-3, 3);
  const GiNaC::ex now = add_bristle(length, e);
  // Friction of a known law over the velocity turns only after the bristles have.
  e.column("level", "{effort}", Sign::positive,
           magnitude(s.direction) * (now - choose(s.velocity, 1, -1)));
  e.signature = "friction that turns a short way behind every reversal";
  e.excitation = "reversals";
  e.experiment = "very small slow triangles";
  e.limit = "friction would turn before the motion";
  e.baseline_only = true;
  return e;
}

}  // namespace sinew
