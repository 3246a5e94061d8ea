// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect gear_elasticity() {
  Effect e("gear_elasticity", "gear elasticity");
  const EffectSignals& s = effect_signals();
  // With the sensor on the output; one on the motor sees the load swing (gear_resonance).
  e.column("compliance_term", "{effort}*s^2/{acceleration}", Sign::positive, s.jounce);
  e.signature = "effort left over in proportion to the second derivative of the acceleration";
  e.excitation = "fast changes of acceleration";
  e.experiment = "a sweep of frequencies with the output free";
  e.limit = "the output would run ahead of the motor";
  return e;
}

Effect gear_resonance() {
  Effect e("gear_resonance", "gear elasticity");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex w = e.shape("natural_frequency", "rad/s", Scale::none, 10.0, 400.0, 6);
  e.shapes.back().inside = true;
  const GiNaC::ex damping = e.shape("damping_ratio", "1", Scale::none, 0.01, 0.4, 1);
  e.shapes.back().inside = true;
  e.shapes.back().above = true;  // a line of the spectrum is a resonance without damping
  // Twist of the gear behind a sensor on the motor: twist'' = -qdd - 2 D w twist' - w^2 twist, by
  // the trapezoidal rule, which neither delays nor diverges.
  const GiNaC::symbol twist("twist"), rate("rate"), change("change");
  const GiNaC::ex half = s.step / 2;
  const GiNaC::ex drifted = rate + half * change;
  const GiNaC::ex carried = twist + half * (rate + drifted);
  const GiNaC::ex now = -(s.acceleration + 2 * damping * w * drifted + w * w * carried) /
                        (1 + 2 * damping * w * half + w * w * half * half);
  e.states = {{twist, 0.0, carried + half * half * now},
              {rate, 0.0, drifted + half * now},
              {change, 0.0, now}};
  e.column("inertia_behind_spring", "{effort}/{acceleration}", Sign::positive, now);
  e.signature = "the load swings behind the gear at a frequency of its own";
  e.excitation = "fast changes of acceleration";
  e.experiment = "a sweep of frequencies with the output free";
  e.limit = "the load would pull where it has to be pulled";
  return e;
}

}  // namespace sinew
