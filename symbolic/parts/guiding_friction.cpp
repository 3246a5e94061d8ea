// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/guiding_friction.h"

#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;

const GiNaC::numeric most_bending(100);  // rad; far beyond any hand, and its exponential is finite

struct Guiding {
  explicit Guiding(const GuidingParameters& p)
      : tension(scalar_argument("tension", "N", p.tension, "tendon force")),
        bending(scalar_argument("bending", "rad", p.bending, "total bending angle")),
        velocity(
            scalar_argument("velocity", "m/s", p.velocity, "tendon velocity, towards the motor")) {
    if (!(p.C0 >= 0 && p.C1 >= 0 && p.friction_coefficient >= 0))
      throw std::invalid_argument("guiding friction must not drive the tendon");
    if (!(p.reversal_velocity > 0))
      throw std::invalid_argument("the reversal velocity of guiding friction must be above 0 m/s");
    angle = list.define("angle", clamped(bending.symbols[0], 0, most_bending));
    // Limited first: far away its square would overflow, and the ratio is ±1 long before.
    const GiNaC::numeric reversal = exact_number(p.reversal_velocity);
    const GiNaC::numeric far = 1000000000 * reversal;
    const ex v = list.define("limited_velocity", clamped(velocity.symbols[0], -far, far));
    direction = list.define("direction", v / GiNaC::sqrt(v * v + reversal * reversal));
  }

  ex pull() { return list.define("pull", maximum(tension.symbols[0], 0)); }

  Argument tension, bending, velocity;
  DefinitionList list;
  ex angle, direction;
};

}  // namespace

Function guiding_friction_force(const GuidingParameters& parameters) {
  const Guiding g(parameters);
  const ex share = 1 - GiNaC::exp(-exact_number(parameters.C1) * g.angle);
  return {"friction_force",
          "Friction of a bent tendon, fitted form; opposes the tendon's motion.",
          "(4.1)",
          {g.bending, g.velocity},
          g.list.items(),
          {{"force",
            1,
            1,
            {-exact_number(parameters.C0) * share * g.direction},
            "N",
            "on the tendon"}}};
}

Function capstan_friction_force(const GuidingParameters& parameters) {
  Guiding g(parameters);
  const ex pull = g.pull();
  const ex share = 1 - GiNaC::exp(-exact_number(parameters.friction_coefficient) * g.angle);
  return {
      "friction_force", "Friction of a bent tendon, in proportion to the pulling side's tension.",
      "(4.1)",          {g.tension, g.bending, g.velocity},
      g.list.items(),   {{"force", 1, 1, {-pull * share * g.direction}, "N", "on the tendon"}}};
}

Function capstan_transmitted_force(const GuidingParameters& parameters) {
  Guiding g(parameters);
  const ex pull = g.pull();
  const ex exponent = -exact_number(parameters.friction_coefficient) * g.angle * g.direction;
  return {"transmitted_force",
          "Tension at the finger when the motor's side is known.",
          "(4.1)",
          {g.tension, g.bending, g.velocity},
          g.list.items(),
          {{"force", 1, 1, {pull * GiNaC::exp(exponent)}, "N", "on the finger's side"}}};
}

}  // namespace sinew
