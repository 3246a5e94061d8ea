// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/effects/first_sample.h"

namespace sinew {
namespace {

constexpr const char* kSweep = "a sweep of frequencies with the output free";

void describe_elasticity(Effect& e) {
  e.signature = "effort left over in proportion to the second derivative of the acceleration";
  e.excitation = "fast changes of acceleration";
  e.experiment = kSweep;
  e.limit = "the output would run ahead of the motor";
}

/// Second derivative of a gear's twist behind a sensor on the motor. `pull`: the motor's
/// acceleration at rest against the load's, were that let go.
GiNaC::ex twisting(const GiNaC::ex& pull, Effect& e) {
  const EffectSignals& s = effect_signals();
  const GiNaC::ex w = e.shape("natural_frequency", "rad/s", Scale::none, 10.0, 400.0, 40);
  e.shapes.back().inside = true;
  const GiNaC::ex damping = e.shape("damping_ratio", "1", Scale::none, 0.01, 0.4, 1);
  e.shapes.back().inside = true;
  e.shapes.back().above = true;  // a line of the spectrum is a resonance without damping
  // twist'' = -acceleration - pull - 2 D w twist' - w^2 twist, by the trapezoidal rule, which
  // neither delays nor diverges.
  const GiNaC::symbol twist("twist"), rate("rate"), change("change");
  const GiNaC::ex half = s.step / 2;
  const GiNaC::ex drifted = rate + half * change;
  // A log begins with the load carried: let go, its weight would swing for seconds.
  const GiNaC::ex before = pull.is_zero() ? pull : -first_sample(e) * pull / (w * w);
  const GiNaC::ex carried = twist + before + half * (rate + drifted);
  const GiNaC::ex now = -(s.acceleration + pull + 2 * damping * w * drifted + w * w * carried) /
                        (1 + 2 * damping * w * half + w * w * half * half);
  e.states.push_back({twist, carried + half * half * now});
  e.states.push_back({rate, drifted + half * now});
  e.states.push_back({change, now});
  e.signature = "the load swings behind the gear at a frequency of its own";
  e.excitation = "fast changes of acceleration";
  e.experiment = kSweep;
  e.limit = "the load would pull where it has to be pulled";
  return now;
}

}  // namespace

Effect gear_elasticity() {
  Effect e("gear_elasticity", "gear elasticity");
  // With the sensor on the output; one on the motor sees the load swing (gear_resonance).
  e.column("compliance_term", "{effort}*s^2/{acceleration}", Sign::positive,
           effect_signals().jounce);
  describe_elasticity(e);
  return e;
}

Effect gear_resonance() {
  Effect e("gear_resonance", "gear elasticity");
  const GiNaC::ex now = twisting(0, e);
  e.column("inertia_behind_spring", "{effort}/{acceleration}", Sign::positive, now);
  return e;
}

Effect link_elasticity() {
  Effect e("link_elasticity", "gear elasticity");
  const EffectSignals& s = effect_signals();
  // The motor's inertia by the gear's stiffness.
  e.column("compliance_term", "s^2", Sign::positive, s.carried_inertia * s.carried_jounce);
  describe_elasticity(e);
  return e;
}

Effect link_resonance() {
  Effect e("link_resonance", "gear elasticity");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex now = twisting(s.parting - s.acceleration, e);
  // 1 where all the links hang behind the spring and weigh what the model says.
  e.column("share_behind_spring", "1", Sign::positive, s.carried_inertia * now).most = 1.5;
  e.links_react = true;
  return e;
}

}  // namespace sinew
