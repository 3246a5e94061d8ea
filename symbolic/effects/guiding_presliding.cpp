// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction that a log resolves: at a reversal the tendon creeps in its guide for a short
// way before it slips, and the friction builds up over that way (Dahl's law, as in presliding.cpp).
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect guiding_presliding() {
  Effect e = guiding_friction();
  e.id = "guiding_presliding";
  const EffectSignals& s = effect_signals();
  const GiNaC::ex length = e.shape("presliding_length", "m", Scale::none, 3e-6, 1e-3, 4);
  const GiNaC::symbol z("z");
  const GiNaC::ex travel = s.velocity * s.step / length;
  const GiNaC::ex left = GiNaC::exp(-magnitude(travel));
  const GiNaC::ex now = choose(travel, 1 - (1 - z) * left, (1 + z) * left - 1);
  e.states = {{z, 0.0, now}};
  for (EffectColumn& column : e.columns) column.term = column.term.subs(s.direction == now);
  e.signature =
      "a share of the tendon's force is lost, against its motion, and builds up over a short way "
      "behind every reversal";
  return e;
}

}  // namespace sinew
