// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/tendon_force.h"

#include <algorithm>
#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/parts/lever_geometry.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;

const GiNaC::numeric stiffest = GiNaC::numeric(10).power(12);  // N/m; as good as rigid

/// l0/(E S) [m/N].
GiNaC::numeric compliance(const TendonParameters& p) {
  if (!(p.axial_stiffness > 0 && p.free_length > 0))
    throw std::invalid_argument("a tendon needs a positive stiffness E S and length");
  return exact_number(p.free_length) / exact_number(p.axial_stiffness);
}

/// Lever and tendon at a lever angle: elongation of both, force, and their derivatives by the
/// angle.
struct ElasticPair {
  ElasticPair(DefinitionList& list, const LeverParameters& lever, const GiNaC::numeric& softness,
              const ex& theta, const GiNaC::symbol& angle)
      : geometry(lever_geometry(list, lever, theta)), force(lever_force(list, geometry)) {
    ForwardDerivative by_theta(list, angle, "theta");
    force_slope = list.define("force_slope", by_theta.of(force));
    elongation = list.define("elongation_here",
                             free_path_length(lever) - geometry.length + softness * force);
    slope = list.define("elongation_slope", softness * force_slope - geometry.safe_slope);
  }
  LeverGeometry geometry;
  ex force, force_slope, elongation, slope;
};

}  // namespace

Function tendon_series_stiffness(const TendonParameters& parameters) {
  const Argument k = scalar_argument("k_lever", "N/m", {0.0, 5.0e4}, "stiffness of the lever");
  const ex stiffness = clamped(k.symbols[0], 0, stiffest);
  return {"series_stiffness",
          "Stiffness of lever and tendon in series.",
          "4.1",
          {k},
          {},
          {{"k", 1, 1, {stiffness / (1 + compliance(parameters) * stiffness)}, "N/m", ""}}};
}

Function tendon_force(const TendonParameters& parameters, const LeverParameters& lever) {
  const GiNaC::numeric softness = compliance(parameters);
  const auto end = evaluate_precisely(lever_state(lever), {exact_number(lever.end_angle)});
  const Range travel{-0.001, (end[1] + softness * end[2]).to_double()};
  const Argument elongation =
      scalar_argument("elongation", "m", travel, "of lever and tendon together");
  const Argument start = scalar_argument(
      "theta", "rad",
      {std::min(lever.free_angle, lever.end_angle), std::max(lever.free_angle, lever.end_angle)},
      "where the search starts, e.g. the last angle");
  DefinitionList list;
  const ex x = limited_elongation(list, elongation.symbols[0]);
  ex theta = list.define("theta_start", within_travel(lever, start.symbols[0]));
  for (int i = 0; i < lever.newton_iterations; ++i) {
    const ElasticPair here(list, lever, softness, theta, GiNaC::ex_to<GiNaC::symbol>(theta));
    const ex next = list.define("theta_next", theta - (here.elongation - x) / here.slope);
    theta = list.define("theta_limited", within_travel(lever, next));
  }
  const ElasticPair found(list, lever, softness, theta, GiNaC::ex_to<GiNaC::symbol>(theta));
  // df/dx over both: the force's slope against that of the whole elongation.
  const std::vector<ex> out{choose(-x, 0, found.force),
                            choose(-x, 0, found.force_slope / found.slope), theta};
  return {"force",
          "Tendon force and stiffness from the elongation, 0 when slack.",
          "5.1",
          {elongation, start},
          list.items(),
          {{"out", 3, 1, out, "N, N/m, rad", "force, stiffness, lever angle"},
           {"residual",
            1,
            1,
            {choose(-x, 0, x - found.elongation)},
            "m",
            "what is left of the elongation"}}};
}

std::vector<Function> tendon_force_functions(const TendonParameters& parameters,
                                             const LeverParameters& lever) {
  return {tendon_series_stiffness(parameters), tendon_force(parameters, lever)};
}

}  // namespace sinew
