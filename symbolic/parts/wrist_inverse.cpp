// SPDX-License-Identifier: GPL-3.0-or-later
// From palm angles back to bar angles.
//
// Given the palm's direction v, its BC axis is normal to v and lies in the bar plane, so q71 alone
// decides that axis, and by the crossed loop B, C and A. What is left is one equation,
// |A A0|² = a² + c², for q71. At zero abduction it is the crossed loop A0-A-M-M0 and has the closed
// solution the iteration starts from: q71 = φ/2 + asin(c/√(a²+c²) cos(φ/2)).
#include <algorithm>
#include <cmath>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/parts/wrist_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

const GiNaC::numeric largest_step(1, 5);  // rad; keeps the iteration far outside from jumping about
const GiNaC::numeric widest_angle(3, 2);  // rad; targets beyond are taken at nearly a right angle

/// The palm's direction and the angles it comes from, limited to the half space in front.
struct HandDirection {
  ex flexion, abduction;
  Vector3 v;
};

HandDirection direction(DefinitionList& list, const ex& flexion, const ex& abduction) {
  const ex limit = widest_angle;
  HandDirection d;
  d.flexion = list.define("limited_flexion", clamped(flexion, -limit, limit));
  d.abduction = list.define("limited_abduction", clamped(abduction, -limit, limit));
  const ex level = list.define("level", GiNaC::cos(d.abduction));
  d.v = define(list, "v",
               Vector3{level * GiNaC::cos(d.flexion), GiNaC::sin(d.abduction),
                       level * GiNaC::sin(d.flexion)});
  return d;
}

/// Bars that hold the palm's BC axis normal to v, with the bar plane at q71.
struct Bars {
  BarAngles angles;
  ex mismatch;  ///< (|A A0|² - a² - c²)/2 [m²]
};

Bars bars_at(DefinitionList& list, const WristLinks& links, const HandDirection& d, const ex& q71) {
  const auto& [a, b, c, r, r_squared, margin] = links;
  Bars bars;
  auto& q = bars.angles;
  q.cos_q71 = list.define("cos_q71", GiNaC::cos(q71));
  q.sin_q71 = list.define("sin_q71", GiNaC::sin(q71));
  // (C - B)/b = (sin χ, -cos χ) along e and y.
  const ex v_e = list.define("v_e", d.v[0] * q.cos_q71 + d.v[2] * q.sin_q71);
  const ex length =
      list.define("v_length", GiNaC::sqrt(maximum(v_e * v_e + d.v[1] * d.v[1], margin * margin)));
  const ex cos_x = list.define("cos_tilt", v_e / length);
  const ex sin_x = list.define("sin_tilt", d.v[1] / length);
  const ex cos_half =
      list.define("cos_half_tilt", GiNaC::sqrt(maximum((1 + cos_x) / 2, margin * margin)));
  const ex sin_half = list.define("sin_half_tilt", sin_x / (2 * cos_half));
  // Crossed loop: cos(q73 + χ/2) = (b/r) cos(χ/2).
  const ex cosine = list.define("cos_sum", (b / r) * cos_half);
  const ex sine = list.define("sin_sum", GiNaC::sqrt(1 - cosine * cosine));
  q.cos_q73 = list.define("cos_q73", cosine * cos_half + sine * sin_half);
  q.sin_q73 = list.define("sin_q73", sine * cos_half - cosine * sin_half);
  // A = M - c z with M = B + (b/2)(C - B)/b and z = v × y.
  const Vector3 u = define(list, "u", Vector3{sin_x * q.cos_q71, -cos_x, sin_x * q.sin_q71});
  const Vector3 B{r * q.sin_q73 * q.cos_q71, r * q.cos_q73, r * q.sin_q73 * q.sin_q71};
  const Vector3 z = define(list, "z", cross(u, d.v));
  const Vector3 gap = define(list, "gap", B + (b / 2) * u - c * z - Vector3{0, b / 2, c});
  bars.mismatch = list.define("mismatch", (dot(gap, gap) - a * a - c * c) / 2);
  return bars;
}

ex newton_step(DefinitionList& list, const WristLinks& links, const HandDirection& d,
               const GiNaC::symbol& q71) {
  const Bars bars = bars_at(list, links, d, q71);
  ForwardDerivative by_q71(list, q71, "q71");
  const ex slope = list.define("slope", by_q71.of(bars.mismatch));
  const ex floor = links.margin * links.a * links.c;
  const ex safe =
      list.define("safe_slope", choose(slope, maximum(slope, floor), minimum(slope, -floor)));
  return clamped(-bars.mismatch / safe, -largest_step, largest_step);
}

/// Angle between the wanted direction and the x axis that the pose has at these bar angles.
ex direction_error(DefinitionList& list, const Vector3& wanted, const Vector3& reached) {
  const Vector3 aside = define(list, "aside", cross(wanted, reached));
  const ex sine = list.define("error_sine", GiNaC::sqrt(dot(aside, aside)));
  return GiNaC::atan2(sine, dot(wanted, reached));
}

Range rounded_outwards(double low, double high) {
  return {std::floor(low * 1000.0) / 1000.0, std::ceil(high * 1000.0) / 1000.0};
}

}  // namespace

Function wrist_bar_angles(const WristParameters& parameters) {
  const WristLinks links(parameters);
  const Argument flexion =
      scalar_argument("flexion", "rad", parameters.flexion, "of the palm, about -y");
  const Argument abduction =
      scalar_argument("abduction", "rad", parameters.abduction, "of the palm, towards y");
  DefinitionList list;
  const HandDirection d = direction(list, flexion.symbols[0], abduction.symbols[0]);
  const GiNaC::numeric ratio = links.c / rational_root(links.a * links.a + links.c * links.c);
  ex q71 = list.define("q71_start", d.flexion / 2 + GiNaC::asin(ratio * GiNaC::cos(d.flexion / 2)));
  for (int i = 0; i < parameters.newton_iterations; ++i)
    q71 = list.define("q71", q71 + newton_step(list, links, d, GiNaC::ex_to<GiNaC::symbol>(q71)));
  const Bars bars = bars_at(list, links, d, q71);
  const WristPose pose = wrist_pose(list, links.lengths(), bars.angles);
  const ex residual = list.define("residual", direction_error(list, d.v, pose.x));
  const ex outside =
      magnitude(d.flexion - flexion.symbols[0]) + magnitude(d.abduction - abduction.symbols[0]);
  const ex status = choose(links.margin - residual - outside,
                           choose(bars.angles.sin_q73 - links.margin, 0, 1), 1);
  return {"bar_angles",
          "Bar angles that point the palm in a given direction.",
          "",
          {flexion, abduction},
          list.items(),
          {{"q",
            2,
            1,
            {q71, GiNaC::atan2(bars.angles.sin_q73, bars.angles.cos_q73)},
            "rad",
            "q71, q73"},
           {"residual", 1, 1, {residual}, "rad", "between the wanted and the reached direction"},
           {"status", 1, 1, {status}, "1", "0 fine, 1 not reached", {"fine", "not_reached"}}}};
}

std::vector<Range> bar_ranges(const WristParameters& parameters) {
  const Function inverse = wrist_bar_angles(parameters);
  constexpr int steps = 8;  // the extremes lie on the border, near its corners
  Range q71{1e9, -1e9}, q73{1e9, -1e9};
  const auto include = [](Range& range, double value) {
    range = {std::min(range.low, value), std::max(range.high, value)};
  };
  const auto at = [](const Range& range, int i) {
    return range.low + (range.high - range.low) * i / steps;
  };
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const std::vector<double> q =
          evaluate(inverse, {at(parameters.flexion, i), at(parameters.abduction, j)});
      include(q71, q[0]);
      include(q73, q[1]);
    }
  return {rounded_outwards(q71.low, q71.high), rounded_outwards(q73.low, q73.high)};
}

}  // namespace sinew
