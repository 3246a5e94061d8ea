// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/turning.h"

#include "symbolic/expressions/piecewise.h"

namespace sinew {

GiNaC::ex turning_direction(Effect& effect) {
  const GiNaC::ex direction = effect_signals().direction;
  const GiNaC::ex share = effect.shape("turning_share", "1", Scale::turning, 0.05, 1.0, 2);
  ShapeParameter& p = effect.shapes.back();
  p.limits = {0.0, 1.0, true};
  p.before = 1.0;
  // Near standstill steeper by 1/share, and 1 where the direction is. The maximum changes nothing
  // at a share that is looked for: out of the bare sum GiNaC takes a sign in one run and not in the
  // next, and the manual's equation was another one each time.
  const GiNaC::ex size = magnitude(direction);
  return direction / maximum(share + size - share * size, GiNaC::numeric(1, 1000000));
}

}  // namespace sinew
