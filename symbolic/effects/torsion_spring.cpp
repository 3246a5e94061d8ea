// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect torsion_spring() {
  Effect e("torsion_spring", "spring towards a position");
  const EffectSignals& s = effect_signals();
  e.column("stiffness", "{effort}/{position}", Sign::positive, s.position);
  e.signature = "effort left over in proportion to the position";
  e.excitation = "motion over the range";
  e.experiment = "slow motion over the whole range both ways";
  e.limit = "it would push away from the position";
  e.compensable = true;
  return e;
}

}  // namespace sinew
