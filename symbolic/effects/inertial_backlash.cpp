// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/piecewise.h"

namespace sinew {
namespace {

/// What moves behind the gap flies on under what acts on it until a side hits it; `pulled`: its
/// acceleration against positive motion meanwhile. To be added to the shape parameters `e` has.
void add_gap(const GiNaC::ex& gap, const GiNaC::ex& pulled, Effect& e) {
  const EffectSignals& s = effect_signals();
  const GiNaC::ex restitution = e.shape("restitution", "1", Scale::none, 0.0, 0.9, 2);
  const GiNaC::symbol place("place"), rate("rate");
  // In units of the gap: where the motor is between both sides of the load, and how fast.
  const GiNaC::ex faster = rate + (s.acceleration + pulled) * s.step / gap;
  const GiNaC::ex moved = clamped(place + faster * s.step, 0, 1);
  const GiNaC::ex back = -restitution * faster;
  const GiNaC::ex next = choose(-moved, back, choose(moved - 1, back, faster));
  e.states = {{place, 1.0, moved}, {rate, 0.0, next}};
  // The motor's acceleration against the load's: in the gap what each has by itself, at a side the
  // impact.
  e.column("inertia_behind_gap", "{effort}/{acceleration}", Sign::negative,
           (next - rate) * gap / s.step);
  e.signature = "the drive is lighter for a short while whenever the effort on the load reverses";
  e.excitation = "accelerations of both signs";
  e.experiment = "small fast reversals about several positions";
  e.limit = "the drive would be heavier inside the gap";
}

}  // namespace

Effect inertial_backlash() {
  Effect e("inertial_backlash", "backlash");
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2, 9);
  add_gap(gap, 0, e);
  return e;
}

Effect loaded_backlash() {
  Effect e("loaded_backlash", "backlash");
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2, 10);
  // The reciprocal of the inertia behind the gap: where the load is hit depends sharply on both.
  const GiNaC::ex mobility =
      e.shape("mobility", "{acceleration}/{effort}", Scale::mobility, 1.1, 5.0, 8);
  add_gap(gap, mobility * effect_signals().load, e);
  return e;
}

}  // namespace sinew
