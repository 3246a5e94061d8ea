// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction that a log resolves: at a reversal the tendon creeps in its guide for a short
// way before it slips, and the friction builds up over that way (bristle.h).
#include "symbolic/effects/bristle.h"
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guiding_presliding() {
  Effect e = guiding_friction();
  e.id = "guiding_presliding";
  const EffectSignals& s = effect_signals();
  const GiNaC::ex length = e.shape("presliding_length", "m", Scale::none, 3e-6, 1e-3, 4);
  const GiNaC::ex now = add_bristle(length, e);
  for (EffectColumn& column : e.columns) column.term = column.term.subs(s.direction == now);
  e.signature =
      "a share of the tendon's force is lost, against its motion, and builds up over a short way "
      "behind every reversal";
  return e;
}

}  // namespace sinew
