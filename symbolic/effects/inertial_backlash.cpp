// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/first_sample.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

/// Acceleration of the motor against what moves behind the gap, which flies on under what acts on
/// it until a side hits it, and is hit. `pull`: the same at rest, in the gap. To be added to the
/// shape parameters `e` has.
GiNaC::ex add_gap(const GiNaC::ex& gap, const GiNaC::ex& pull, Effect& e) {
  const EffectSignals& s = effect_signals();
  const GiNaC::ex restitution = e.shape("restitution", "1", Scale::none, 0.0, 0.9, 2);
  e.shapes.back().limits = {0.0, 1.0};
  const GiNaC::symbol place("place"), rate("rate");
  // In units of the gap: where the motor is between both sides of the load, and how fast. A log
  // begins with the load at the side to which it is pulled.
  const GiNaC::ex from = place + first_sample(e) * choose(pull, 1, 0);
  const GiNaC::ex faster = rate + (s.acceleration + pull) * s.step / gap;
  const GiNaC::ex moved = clamped(from + faster * s.step, 0, 1);
  const GiNaC::ex back = -restitution * faster;
  const GiNaC::ex next = choose(-moved, back, choose(moved - 1, back, faster));
  e.states.push_back({place, moved});
  e.states.push_back({rate, next});
  e.signature = "the drive is lighter for a short while whenever the effort on the load reverses";
  e.excitation = "accelerations of both signs";
  e.experiment = "small fast reversals about several positions";
  e.limit = "the drive would be heavier inside the gap";
  // In the gap what each has by itself, at a side the impact.
  return (next - rate) * gap / s.step;
}

void add_inertia_behind(const GiNaC::ex& apart, Effect& e) {
  e.column("inertia_behind_gap", "{effort}/{acceleration}", Sign::negative, apart);
}

}  // namespace

Effect inertial_backlash() {
  Effect e("inertial_backlash", "backlash");
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2, 48);
  add_inertia_behind(add_gap(gap, 0, e), e);
  return e;
}

Effect loaded_backlash() {
  Effect e("loaded_backlash", "backlash");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2, 10);
  // The reciprocal of the inertia behind the gap: where the load is hit depends sharply on both.
  const GiNaC::ex mobility =
      e.shape("mobility", "{acceleration}/{effort}", Scale::mobility, 1.1, 5.0, 8);
  add_inertia_behind(add_gap(gap, mobility * s.load, e), e);
  return e;
}

Effect link_backlash() {
  Effect e("link_backlash", "backlash");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex gap = e.shape("gap", "{position}", Scale::reach, 1e-4, 3e-2, 60);
  const GiNaC::ex apart = add_gap(gap, s.parting - s.acceleration, e);
  // 1 where all the links hang behind the gap and weigh what the model says.
  e.column("share_behind_gap", "1", Sign::negative, s.carried_inertia * apart).most = 1.5;
  e.links_react = true;
  return e;
}

}  // namespace sinew
