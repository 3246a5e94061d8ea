// SPDX-License-Identifier: GPL-3.0-or-later
// At a tendon: position is its bending at the joints, velocity the rate of its length, load its
// force. Capstan friction T (1 - e^(-mu alpha)) is mu alpha T for the small mu alpha of a guide.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guiding_friction() {
  Effect e("guiding_friction", "guiding friction");
  const EffectSignals& s = effect_signals();
  e.column("share_when_straight", "1", Sign::positive, s.load * s.direction).most = 1.0;
  e.column("share_for_bending", "1/rad", Sign::positive, s.load * s.position * s.direction).most =
      1.0;
  e.signature = "a share of the tendon's force is lost, against its motion, more where it is bent";
  e.excitation = "reversals at several postures and forces";
  e.experiment = "slow motion back and forth at several postures, the antagonist's force varied";
  e.limit = "friction would drive the tendon";
  e.at_tendon = true;
  return e;
}

}  // namespace sinew
