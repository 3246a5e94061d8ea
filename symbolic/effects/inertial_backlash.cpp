// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/piecewise.h"

namespace sinew {

Effect inertial_backlash() {
  Effect e("inertial_backlash", "backlash");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2, 9);
  const GiNaC::ex restitution = e.shape("restitution", "1", Scale::none, 0.0, 0.9, 2);
  const GiNaC::symbol place("place"), rate("rate");
  // In units of the gap: where the motor is between both sides of the load, and how fast. The load
  // flies on at constant velocity until a side hits it.
  const GiNaC::ex faster = rate + s.acceleration * s.step / gap;
  const GiNaC::ex moved = clamped(place + faster * s.step, 0, 1);
  const GiNaC::ex back = -restitution * faster;
  const GiNaC::ex next = choose(-moved, back, choose(moved - 1, back, faster));
  e.states = {{place, 1.0, moved}, {rate, 0.0, next}};
  // The motor's acceleration against the load's: in the gap its own, at a side the impact.
  e.column("inertia_behind_gap", "{effort}/{acceleration}", Sign::negative,
           (next - rate) * gap / s.step);
  e.signature = "the drive is lighter for a short while whenever the effort on the load reverses";
  e.excitation = "accelerations of both signs";
  e.experiment = "small fast reversals about several positions";
  e.limit = "the drive would be heavier inside the gap";
  return e;
}

}  // namespace sinew
