// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/lever.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/horner.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/parts/lever_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

Argument angle_argument(const LeverParameters& p, const std::string& doc) {
  return scalar_argument("theta", "rad",
                         {std::min(p.free_angle, p.end_angle), std::max(p.free_angle, p.end_angle)},
                         doc);
}

/// Elongation at the end of travel [m].
double travel(const LeverParameters& p) {
  return rounded_values(lever_state(p), {p.end_angle})[1];
}

}  // namespace

Function lever_state(const LeverParameters& parameters) {
  const Argument theta = angle_argument(parameters, "lever angle");
  DefinitionList list;
  const LeverGeometry g = lever_geometry(list, parameters, theta.symbols[0]);
  const ex force = lever_force(list, g);
  ForwardDerivative by_theta(list, theta.symbols[0], "theta");
  const ex stiffness = -by_theta.of(force) / g.safe_slope;
  return {"state",
          "Tendon path and force of the variable-stiffness lever.",
          "4.1",
          {theta},
          list.items(),
          {{"out",
            4,
            1,
            {g.length, free_path_length(parameters) - g.length, force, stiffness},
            "m, m, N, N/m",
            "dL, elongation, force, stiffness"}}};
}

Function lever_slope(const LeverParameters& parameters) {
  const Argument theta = angle_argument(parameters, "lever angle");
  DefinitionList list;
  const LeverGeometry g = lever_geometry(list, parameters, theta.symbols[0]);
  return {
      "slope",      "Derivatives of the tendon path and of the spring's energy by the lever angle.",
      "4.1",        {theta},
      list.items(), {{"out", 2, 1, {g.slope, g.energy_slope}, "m/rad, N m/rad", "dL', U'"}}};
}

Function lever_angle(const LeverParameters& parameters) {
  const Argument elongation =
      scalar_argument("elongation", "m", {0.0, travel(parameters)}, "tendon elongation");
  const Argument start = angle_argument(parameters, "where the search starts, e.g. the last angle");
  DefinitionList list;
  const ex limited = limited_elongation(list, elongation.symbols[0]);
  const ex target = list.define("dL_target", free_path_length(parameters) - limited);
  ex theta = list.define("theta_start", within_travel(parameters, start.symbols[0]));
  for (int i = 0; i < parameters.newton_iterations; ++i) {
    const LeverGeometry g = lever_geometry(list, parameters, theta);
    const ex next = list.define("theta_next", theta + (target - g.length) / g.safe_slope);
    theta = list.define("theta_limited", within_travel(parameters, next));
  }
  const ex residual = target - lever_geometry(list, parameters, theta).length;
  return {"angle",
          "Lever angle at an elongation of the tendon, by Newton's method.",
          "4.1",
          {elongation, start},
          list.items(),
          {{"theta_lever", 1, 1, {theta}, "rad", "within the lever's travel"},
           {"residual", 1, 1, {residual}, "m", "what is left of the elongation"}}};
}

Function lever_status(const LeverParameters& parameters) {
  const Argument theta = angle_argument(parameters, "lever angle");
  DefinitionList list;
  const LeverGeometry g = lever_geometry(list, parameters, theta.symbols[0]);
  const ex outside = magnitude(theta.symbols[0] - within_travel(parameters, theta.symbols[0]));
  const ex dead =
      magnitude(g.slope) - exact_number(parameters.singular_margin * parameters.lever_length);
  // Written so that a comparison that fails, whatever the reason, says 1.
  return {"status",
          "Whether the lever is within its travel and transmits force.",
          "",
          {theta},
          list.items(),
          {{"status",
            1,
            1,
            {choose(-outside, choose(dead, choose(g.path_margin, 0, 1), 1), 1)},
            "1",
            "0 fine, 1 outside the travel or at a dead centre",
            {"fine", "not_usable"}}}};
}

std::vector<Function> lever_functions(const LeverParameters& p) {
  return {lever_state(p), lever_slope(p), lever_angle(p), lever_status(p)};
}

double lever_angle_at(LeverParameters parameters, double elongation) {
  const Function state = lever_state(parameters), slope = lever_slope(parameters);
  double theta = parameters.free_angle;
  constexpr int steps = 64;  // small ones, so that Newton's method stays on the free angle's side
  for (int i = 1; i <= steps; ++i)
    for (int j = 0; j < 4; ++j) {
      const double error = evaluate(state, {theta})[1] - elongation * i / steps;
      theta += error / evaluate(slope, {theta})[0];
    }
  if (!(std::abs(evaluate(state, {theta})[1] - elongation) <= 1e-12))
    throw std::domain_error("the lever cannot take up this elongation");
  // The last digits of a double would depend on GiNaC's order of terms.
  GiNaC::numeric precise = binary_fraction(theta);
  for (int i = 0; i < 2; ++i) {
    const GiNaC::numeric error = evaluate_precisely(state, {precise})[1] - exact_number(elongation);
    precise += error / evaluate_precisely(slope, {precise})[0];
  }
  return precise.to_double();
}

Function lever_calibrated_state(const LeverCalibration& calibration) {
  const double low = calibration.centre - calibration.half_range,
               high = calibration.centre + calibration.half_range;
  const Argument counts = scalar_argument("counts", "1", {low, high}, "lever sensor");
  DefinitionList list;
  const ex limited =
      list.define("limited", clamped(counts.symbols[0], exact_number(low), exact_number(high)));
  const ex u = list.define(
      "u", (limited - exact_number(calibration.centre)) / exact_number(calibration.half_range));
  const ex force = horner(list, "force", calibration.force, u);
  const ex length = horner(list, "length", calibration.length, u);
  const ex force_slope = horner(list, "force_slope", derived_coefficients(calibration.force), u);
  const ex slope = horner(list, "length_slope", derived_coefficients(calibration.length), u);
  const ex floor = exact_number(calibration.smallest_slope);
  const ex safe =
      list.define("safe_slope", choose(slope, maximum(slope, floor), minimum(slope, -floor)));
  return {
      "calibrated_state",
      "Tendon length in the lever, force and stiffness from the sensor's count.",
      "4.1",
      {counts},
      list.items(),
      {{"out", 3, 1, {length, force, -force_slope / safe}, "m, N, N/m", "dL, force, stiffness"}}};
}

}  // namespace sinew
