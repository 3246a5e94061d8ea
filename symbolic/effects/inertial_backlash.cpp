// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/piecewise.h"

namespace sinew {

Effect inertial_backlash() {
  Effect e("inertial_backlash", "backlash");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2);
  const GiNaC::symbol place("place"), rate("rate");
  // The load flies on at constant velocity while the motor crosses the play; impacts do not bounce.
  const GiNaC::ex faster = rate + s.acceleration * s.step / gap;
  const GiNaC::ex moved = clamped(place + faster * s.step, 0, 1);
  e.states = {{place, 1.0, moved}, {rate, 0.0, choose(-moved, 0, choose(moved - 1, 0, faster))}};
  const GiNaC::ex free = choose(-moved, 0, choose(moved - 1, 0, 1));
  e.column("inertia_behind_gap", "{effort}/{acceleration}", Sign::negative, free * s.acceleration);
  e.signature = "the drive is lighter for a short while whenever the effort on the load reverses";
  e.excitation = "accelerations of both signs";
  e.experiment = "small fast reversals about several positions";
  e.limit = "the drive would be heavier inside the gap";
  return e;
}

}  // namespace sinew
