// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {

Effect quadratic_friction() {
  Effect e("quadratic_friction", "friction quadratic in speed");
  const EffectSignals& s = effect_signals();
  e.column("coefficient", "{effort}/{velocity}^2", Sign::positive,
           s.velocity * magnitude(s.velocity));
  e.signature = "friction over velocity bends upwards";
  e.excitation = "high speeds";
  e.experiment = "constant speeds up to the highest";
  e.limit = "friction would bend downwards";
  e.compensable = true;
  return e;
}

}  // namespace sinew
