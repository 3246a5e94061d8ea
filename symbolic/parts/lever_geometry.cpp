// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/lever_geometry.h"

#include <algorithm>
#include <array>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::numeric;
using PlanePoint = std::array<ex, 2>;

PlanePoint exact_point(const Eigen::Vector2d& p) {
  return {exact_number(p.x()), exact_number(p.y())};
}
PlanePoint plane_difference(const PlanePoint& a, const PlanePoint& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
ex plane_dot(const PlanePoint& a, const PlanePoint& b) {
  return a[0] * b[0] + a[1] * b[1];
}

/// Free stretch between two pulleys with signed radii s R.
struct Stretch {
  ex length;         ///< L
  ex angle;          ///< φ, travel direction
  PlanePoint along;  ///< unit vector of travel
  ex margin;         ///< |D|² - k²
};

Stretch stretch(DefinitionList& list, const std::string& name, const PlanePoint& from,
                const ex& from_radius, const PlanePoint& to, const ex& to_radius) {
  const PlanePoint gap = plane_difference(to, from);
  const PlanePoint D{list.define(name + "_x", gap[0]), list.define(name + "_y", gap[1])};
  const ex k = from_radius - to_radius;
  // A hundredth of a millimetre of tangent is the least where the pulleys would overlap.
  const numeric least(1, 10000000000);
  const ex distance_squared =
      list.define(name + "_distance_squared", maximum(plane_dot(D, D), least));
  Stretch s;
  s.margin = list.define(name + "_margin", distance_squared - k * k);
  s.length = list.define(name + "_length", GiNaC::sqrt(maximum(s.margin, least)));
  // atan2(D_y, D_x) + atan2(k, L) as the direction of one vector, of length |D|².
  const ex u = list.define(name + "_u", D[0] * s.length - D[1] * k);
  const ex v = list.define(name + "_v", D[1] * s.length + D[0] * k);
  s.angle = list.define(name + "_angle", GiNaC::atan2(v, u));
  s.along = {list.define(name + "_along_x", u / distance_squared),
             list.define(name + "_along_y", v / distance_squared)};
  return s;
}

}  // namespace

LeverGeometry lever_geometry(DefinitionList& list, const LeverParameters& p, const ex& theta) {
  const ex cosine = list.define("cos_theta", GiNaC::cos(theta));
  const ex sine = list.define("sin_theta", GiNaC::sin(theta));
  const ex l = exact_number(p.lever_length), arm = exact_number(p.spring_arm);
  const PlanePoint pivot = exact_point(p.pivot), anchor = exact_point(p.anchor);
  // Tendon: both stretches and the three wraps, whose lengths telescope to k φ per stretch.
  const ex signed_1 = p.motor.sense * exact_number(p.motor.radius);
  const ex signed_2 = p.pulley_sense * exact_number(p.pulley_radius);
  const ex signed_3 = p.fixed.sense * exact_number(p.fixed.radius);
  const PlanePoint C2{list.define("C2_x", pivot[0] + l * cosine),
                      list.define("C2_y", pivot[1] + l * sine)};
  const Stretch first = stretch(list, "s12", exact_point(p.motor.centre), signed_1, C2, signed_2);
  const Stretch second = stretch(list, "s23", C2, signed_2, exact_point(p.fixed.centre), signed_3);
  LeverGeometry g;
  g.length = list.define("dL", first.length + second.length + (signed_1 - signed_2) * first.angle +
                                   (signed_2 - signed_3) * second.angle);
  const PlanePoint turn = plane_difference(first.along, second.along);
  g.slope = list.define("dL_slope", l * (turn[1] * cosine - turn[0] * sine));
  const ex floor = exact_number(p.singular_margin) * l;
  g.safe_slope = list.define("dL_safe_slope",
                             choose(g.slope, maximum(g.slope, floor), minimum(g.slope, -floor)));
  g.path_margin = minimum(first.margin, second.margin);
  // Spring.
  const ex beta = exact_number(p.spring_angle);
  const ex cos_beta = rational_value(GiNaC::cos(beta)), sin_beta = rational_value(GiNaC::sin(beta));
  const PlanePoint tip{list.define("spring_x", arm * (cos_beta * cosine - sin_beta * sine)),
                       list.define("spring_y", arm * (sin_beta * cosine + cos_beta * sine))};
  const PlanePoint base = plane_difference(anchor, pivot);
  const ex constant = arm * arm + plane_dot(base, base);
  const auto spring_length = [&](const PlanePoint& at) {
    return GiNaC::sqrt(constant - 2 * plane_dot(base, at));
  };
  const ex free = exact_number(p.free_angle) + beta;
  const ex free_length = rational_value(spring_length(
      {arm * rational_value(GiNaC::cos(free)), arm * rational_value(GiNaC::sin(free))}));
  const ex length = list.define(
      "spring_length",
      GiNaC::sqrt(list.define("spring_length_squared", constant - 2 * plane_dot(base, tip))));
  const ex strain = list.define("spring_strain", 1 - free_length / length);
  // ℓ ℓ' = -base · d(tip)/dθ
  const ex lever_arm = list.define("spring_moment", base[0] * tip[1] - base[1] * tip[0]);
  g.energy_slope =
      list.define("energy_slope", exact_number(p.spring_stiffness) * strain * lever_arm);
  g.preload_slope = exact_number(p.spring_stiffness) * lever_arm / length;
  return g;
}

numeric free_path_length(const LeverParameters& parameters) {
  DefinitionList list;
  const GiNaC::symbol theta("theta");
  const LeverGeometry g = lever_geometry(list, parameters, theta);
  const Function length{"length",     "",
                        "",           {{"theta", 1, 1, {theta}, "", "", {}}},
                        list.items(), {{"dL", 1, 1, {g.length}, "", ""}}};
  return rational_value(evaluate_precisely(length, {exact_number(parameters.free_angle)}, 65)[0]);
}

ex lever_force(DefinitionList& list, const LeverGeometry& geometry) {
  return list.define("force", -geometry.energy_slope / geometry.safe_slope);
}

ex within_travel(const LeverParameters& p, const ex& theta) {
  return clamped(theta, exact_number(std::min(p.free_angle, p.end_angle)),
                 exact_number(std::max(p.free_angle, p.end_angle)));
}

ex limited_elongation(DefinitionList& list, const ex& elongation) {
  return list.define("limited_elongation", clamped(elongation, -1, 1));
}

}  // namespace sinew
