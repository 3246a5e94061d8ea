// SPDX-License-Identifier: GPL-3.0-or-later
// At a tendon: position is its bending at the joints, velocity the rate of its length, load its
// force. Capstan friction T (1 - e^(-mu alpha)) is mu alpha T for the small mu alpha of a guide,
// alpha being what the joints bend it by and what its way to them does.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guiding_friction() {
  Effect e("guiding_friction", "guiding friction");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex elsewhere = e.shape("bending_elsewhere", "rad", Scale::none, 0.003, 30.0, 2);
  e.column("friction_coefficient", "1", Sign::positive,
           s.load * s.direction * (s.position + elsewhere))
      .most = 1.0;
  e.signature = "a share of the tendon's force is lost, against its motion, more where it is bent";
  e.excitation = "reversals at several postures and forces";
  e.experiment = "slow motion back and forth at several postures, the antagonist's force varied";
  e.limit = "friction would drive the tendon";
  e.at_tendon = true;
  // Tendons and guides of a hand are of the same materials.
  e.of_one_make = true;
  return e;
}

}  // namespace sinew
