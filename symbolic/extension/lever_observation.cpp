// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/lever_observation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/extension/late_sensor.h"
#include "symbolic/extension/lever_effects.h"
#include "symbolic/parts/lever_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

const numeric guide_turns_over(1, 20000);  // m of travel; and it stays as it is at rest

/// Dahl's law: the side, -1..1, that a loop is on after `travel`, from the side `before`. The way
/// from one side to the other has a length of its own, in the unit of `travel`; at rest it stays
/// where it is. Defines names that begin with `name`.
ex turned_side(DefinitionList& list, const std::string& name, const ex& before, const ex& travel,
               const ex& length) {
  const ex z = clamped(before, -1, 1);
  const ex way = list.define(name + "_way", travel / length);
  const ex left = list.define(name + "_left", GiNaC::exp(-magnitude(way)));
  return list.define(name + "_next", choose(way, 1 - (1 - z) * left, (1 + z) * left - 1));
}

/// Reading of the rig, line by line.
class Reading {
 public:
  Reading(const LeverRig& rig, LeverEffects& effects) : rig_(rig), e_(effects) {
    const double counts = rig.lever.count_end - rig.lever.count_free;
    if (!(std::abs(counts) > 0.0))
      throw std::invalid_argument("the lever's sensor needs different counts at both ends");
    const double low = std::min(rig.lever.count_free, rig.lever.count_end);
    count_ = scalar_argument("count", "1", {low, low + std::abs(counts)}, "of the lever's sensor");
    late_ = late_inputs("count", "1/s", std::abs(counts));
    rate_ = scalar_argument("count_rate", "1/s", {-std::abs(counts), std::abs(counts)},
                            "without the sensor's flicker: zero where it rests");
    bend_ = scalar_argument("bend", "rad", {0.0, 6.3},
                            "total bending angle between lever and load cell");
    step_ = scalar_argument("step", "s", {1e-4, 1e-2}, "to the next sample");
    state_ = array_argument("memory", 2, 1, "1", {-1.0, 1.0},
                            "of the hysteresis and of the guides, before this sample");
  }

  Function function() {
    write_angle();
    write_force();
    const ex guided = write_guides();
    const ex stretched = elongation_ +
                         (exact_number(rig_.compliance) + e_.series.deviation()) * force_ +
                         e_.slack.deviation();
    return {"observation",
            "What the calibration rig's load cell and gauge read at a count of the lever's sensor.",
            "4.1",
            {count_, rate_, late_.speed, late_.side, bend_, step_, state_},
            list_.items(),
            {{"measured", 2, 1, {guided, stretched}, "N, m", "force, elongation"},
             {"next", 2, 1, {next_, guided_}, "1", "states for the next sample"}}};
  }

 private:
  void write_angle() {
    const LeverParameters& p = rig_.lever;
    const numeric free = exact_number(p.free_angle), end = exact_number(p.end_angle);
    const numeric range = end - free,
                  counts = exact_number(rig_.lever.count_end) - exact_number(rig_.lever.count_free);
    per_count_ = range / counts / (1 + e_.scale.deviation());
    counted_ = list_.define(
        "counted", clamped(rate_.symbols[0], -1000000, 1000000) * clamped(step_.symbols[0], 0, 1));
    const ex true_count =
        list_.define("true_count", in_time(count_.symbols[0], late_, e_.low_pass, e_.play));
    const ex share = list_.define(
        "share", (true_count - e_.offset.deviation() - exact_number(rig_.lever.count_free)) /
                     counts / (1 + e_.scale.deviation()));
    const ex limited =
        list_.define("share_limited", clamped(share, numeric(-1, 10), numeric(11, 10)));
    theta_ = list_.define("theta", free + range * limited);
  }

  void write_force() {
    const LeverGeometry g = lever_geometry(list_, rig_.lever, theta_);
    elongation_ = list_.define("elongation", free_path_length(rig_.lever) - g.length);
    const ex pull = list_.define(
        "pull", -(1 + e_.spring.deviation()) *
                    (g.energy_slope + e_.preload.deviation() * g.preload_slope) / g.safe_slope);
    force_ = list_.define("force", maximum(pull, 0));
    travel_ = list_.define("travel", -g.slope * per_count_ * counted_);
    next_ = turned(0, travel_, e_.hysteresis.shapes.front().symbol, "loop");
  }

  ex turned(std::size_t state, const ex& travel, const ex& length, const std::string& name) {
    return turned_side(list_, name, state_.symbols[state], travel, length);
  }

  ex write_guides() {
    guided_ = turned(1, travel_, guide_turns_over, "guide");
    const ex bend = list_.define("bend_limited", clamped(bend_.symbols[0], 0, 100));
    const ex loop = list_.define("loop", force_ * (1 + e_.hysteresis.deviation() * next_));
    const ex exponent = clamped(e_.capstan.deviation() * bend * guided_, -10, 10);
    return list_.define("cell", loop * GiNaC::exp(exponent)) + e_.zero.deviation() +
           e_.fitted.deviation() * guided_ *
               (1 - GiNaC::exp(-e_.fitted.shapes.front().symbol * bend));
  }

  const LeverRig& rig_;
  LeverEffects& e_;
  DefinitionList list_;
  Argument count_, rate_, bend_, step_, state_;
  LateInputs late_;
  ex per_count_, theta_, elongation_, force_, counted_, travel_, next_, guided_;
};

}  // namespace

Observation lever_observation(const LeverRig& rig, const std::string& model) {
  LeverEffects effects(0.25 * std::abs(rig.lever.count_end - rig.lever.count_free));
  Function function = Reading(rig, effects).function();
  return {model, std::move(function), effects.all()};
}

}  // namespace sinew
