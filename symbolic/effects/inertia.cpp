// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect inertia() {
  Effect e("inertia", "inertia");
  const EffectSignals& s = effect_signals();
  e.column("inertia_change", "{effort}/{acceleration}", Sign::any, s.acceleration);
  e.signature = "effort left over in proportion to the acceleration";
  e.excitation = "changing speed";
  e.experiment = "sinusoids of several frequencies at one amplitude of speed";
  return e;
}

}  // namespace sinew
