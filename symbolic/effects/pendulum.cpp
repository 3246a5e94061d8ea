// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect pendulum() {
  Effect e("pendulum", "gravity left out");
  const EffectSignals& s = effect_signals();
  e.column("sine", "{effort}", Sign::any, GiNaC::sin(s.position));
  e.column("cosine", "{effort}", Sign::any, GiNaC::cos(s.position));
  e.signature = "one period over a full turn of the joint";
  e.excitation = "motion over a good part of a turn";
  e.experiment = "slow motion over the whole range both ways";
  e.compensable = true;
  return e;
}

}  // namespace sinew
