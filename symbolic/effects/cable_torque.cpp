// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "symbolic/effects/effects.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

// By what a smooth curve's Chebyshev coefficients fall from degree to degree: those of a measured
// cable torque (joint 4 of a master arm, 0.077 N m at the first degree, 0.004 at the seventh) do.
constexpr double kDegreeToDegree = 0.6;

Effect cable_torque_of(const std::string& id, int highest) {
  Effect e(id, "position-dependent cable torque");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex middle = e.shape("middle", "{position}", Scale::reach, 0.0, 1.0);
  e.shapes.back().limits = {};  // a place, on either side of zero
  const GiNaC::ex half = e.shape("half_range", "{position}", Scale::reach, 0.0, 1.0);
  const GiNaC::ex x = clamped((s.position - middle) / half, -1, 1);
  // Chebyshev polynomials: columns that stay well conditioned.
  GiNaC::ex before = x, now = 1;
  for (int degree = 0; degree <= highest; ++degree) {
    e.column("degree_" + std::to_string(degree), "{effort}", Sign::any, now).share =
        std::pow(kDegreeToDegree, degree);
    const GiNaC::ex next = degree == 0 ? x : GiNaC::ex(2 * x * now - before);
    before = now;
    now = next;
  }
  e.signature = "a smooth curve over the position, the same both ways";
  e.excitation = "motion over the whole range";
  e.experiment = "slow motion over the whole range both ways";
  e.compensable = true;
  return e;
}

}  // namespace

Effect cable_torque() {
  return cable_torque_of("cable_torque", 7);
}

// What a short stretch of a cable does, told by fewer numbers from shorter logs.
Effect cable_torque_cubic() {
  return cable_torque_of("cable_torque_cubic", 3);
}

}  // namespace sinew
