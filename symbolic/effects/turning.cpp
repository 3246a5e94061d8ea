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
  // Near standstill steeper by 1/share, and 1 where the direction is. Below the maximum's second
  // value it never is; without one GiNaC takes a sign out of the sum, now one and now the other.
  const GiNaC::ex size = magnitude(direction);
  return direction / maximum(share + size - share * size, GiNaC::numeric(1, 1000000));
}

}  // namespace sinew
