// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"
#include "symbolic/piecewise.h"

namespace sinew {

Effect cable_torque() {
  Effect e("cable_torque", "position-dependent cable torque");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex middle = e.shape("middle", "{position}", Scale::reach, 0.0, 1.0);
  const GiNaC::ex half = e.shape("half_range", "{position}", Scale::reach, 0.0, 1.0);
  const GiNaC::ex x = clamped((s.position - middle) / half, -1, 1);
  // Chebyshev polynomials: columns that stay well conditioned.
  e.column("degree_0", "{effort}", Sign::any, GiNaC::ex(1));
  GiNaC::ex before = 1, now = x;
  for (int degree = 1; degree <= 7; ++degree) {
    e.column("degree_" + std::to_string(degree), "{effort}", Sign::any, now);
    const GiNaC::ex next = 2 * x * now - before;
    before = now;
    now = next;
  }
  e.signature = "a smooth curve over the position, the same both ways";
  e.excitation = "motion over the whole range";
  e.experiment = "slow motion over the whole range both ways";
  e.compensable = true;
  return e;
}

}  // namespace sinew
