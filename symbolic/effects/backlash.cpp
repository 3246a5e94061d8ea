// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/piecewise.h"

namespace sinew {

Effect backlash() {
  Effect e("backlash", "backlash");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2);
  const GiNaC::symbol place("place");
  const GiNaC::ex moved = clamped(place + s.velocity * s.step / gap, 0, 1);
  e.states = {{place, 0.5, moved}};
  // In contact at either end of the play nothing is different.
  const GiNaC::ex free = choose(-moved, 0, choose(moved - 1, 0, 1));
  e.column("inertia_behind_gap", "{effort}/{acceleration}", Sign::negative, free * s.acceleration);
  e.signature = "the drive is lighter for a short way behind every reversal";
  e.excitation = "reversals at high acceleration";
  e.experiment = "small fast reversals about several positions";
  e.limit = "the drive would be heavier inside the gap";
  return e;
}

}  // namespace sinew
