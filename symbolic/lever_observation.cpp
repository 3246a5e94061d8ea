// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/lever_observation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "symbolic/argument.h"
#include "symbolic/exact_number.h"
#include "symbolic/lever_geometry.h"
#include "symbolic/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

const numeric guide_turns_over(1, 20000);  // m of travel; and it stays as it is at rest

ObservationParameter deviation(const char* name, const char* unit, double low, double high,
                               double step) {
  return {GiNaC::symbol(name), name, unit, low, high, step};
}

/// The effects, each with its symbols; the terms follow where they act.
struct LeverEffects {
  ObservationEffect spring{"spring_constant", "spring constant", "lever", {}, {}, {0}};
  ObservationEffect preload{"preload_offset", "preload offset", "lever", {}, {}, {0}};
  ObservationEffect hysteresis{"lever_hysteresis", "lever hysteresis", "lever", {}, {}, {0}};
  ObservationEffect series{"series_tendon", "tendon in series", "tendon", {}, {}, {1}};
  ObservationEffect slack{"slack", "slack", "tendon", {}, {}, {1}};
  ObservationEffect scale{"sensor_scale", "scale of the lever sensor", "sensor", {}, {}, {}};
  ObservationEffect offset{"sensor_offset", "offset of the lever sensor", "sensor", {}, {}, {}};
  ObservationEffect zero{
      "force_sensor_offset", "offset of the force sensor", "sensor", {}, {}, {0}};
  ObservationEffect capstan{
      "guiding_capstan", "guiding friction (capstan law)", "tendon", {}, {}, {0}};
  ObservationEffect fitted{
      "guiding_fitted", "guiding friction (fitted law)", "tendon", {}, {}, {0}};

  explicit LeverEffects(double counts) {
    spring.deviations = {deviation("spring_change", "1", -0.9, 10.0, 1e-4)};
    spring.limit = "the spring would push";
    spring.experiment = "weights hung on the tendon, the lever's angle read";
    spring.signature = "force left over in proportion to the force";
    spring.excitation = "several forces";
    preload.deviations = {deviation("preload", "m", 0.0, 0.05, 1e-6)};
    preload.limit = "the spring would be slack at rest";
    preload.experiment = "the force at which the lever leaves its stop";
    preload.signature = "a force that is there from the start of travel";
    preload.excitation = "the whole travel, from its start";
    hysteresis.deviations = {deviation("width_share", "1", 0.0, 1.0, 1e-4)};
    hysteresis.shapes = {deviation("length", "m", 5e-5, 3e-3, 5)};
    hysteresis.limit = "the loop would run the wrong way round";
    hysteresis.experiment = "triangular loading to several levels";
    hysteresis.signature = "a loop of the force whose width grows with the load";
    hysteresis.excitation = "loading and unloading to several levels";
    series.deviations = {deviation("compliance", "m/N", 0.0, 1e-3, 1e-9)};
    series.limit = "the tendon would shorten under load";
    series.experiment = "the lever locked, the tendon drawn";
    series.signature = "elongation left over in proportion to the force";
    series.excitation = "several forces";
    slack.deviations = {deviation("slack", "m", 0.0, 0.05, 1e-6)};
    slack.limit = "the tendon would be shorter than its path";
    slack.experiment = "the elongation at which the force begins";
    slack.signature = "the same elongation left over wherever there is a force";
    slack.excitation = "the start of travel";
    scale.deviations = {deviation("scale_error", "1", -0.5, 0.5, 1e-5)};
    scale.experiment = "the lever between its stops, measured with a gauge";
    scale.signature = "force and elongation off together, growing with travel";
    scale.excitation = "the whole travel";
    offset.deviations = {deviation("count_offset", "1", -counts, counts, 0.01)};
    offset.experiment = "the count with the tendon free";
    offset.signature = "force and elongation off together from the start of travel";
    offset.excitation = "the whole travel";
    zero.deviations = {deviation("force_offset", "N", -1000.0, 1000.0, 1e-3)};
    zero.experiment = "the tendon slack: what the load cell still shows";
    zero.signature = "the same force left over everywhere, with the tendon slack, too";
    zero.excitation = "the start of travel, where the lever is at its stop";
    for (ObservationEffect* e : {&capstan, &fitted}) {
      e->limit = "friction would drive the tendon";
      e->experiment = "slow triangular motion at several bending angles and forces";
      e->excitation = "both directions at several bending angles";
    }
    capstan.deviations = {deviation("friction_coefficient", "1", 0.0, 1.0, 1e-5)};
    capstan.signature = "a loop whose width grows with the bending angle and with the force";
    fitted.deviations = {deviation("C0", "N", 0.0, 200.0, 1e-3)};
    fitted.shapes = {deviation("C1", "1/rad", 0.05, 3.0, 4)};
    fitted.signature = "a loop whose width grows with the bending angle at any force";
  }

  std::vector<ObservationEffect> all() const {
    return {spring, preload, hysteresis, series, slack, scale, offset, zero, capstan, fitted};
  }
};

ex first(const ObservationEffect& e) {
  return e.deviations.front().symbol;
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
    rate_ = scalar_argument("count_rate", "1/s", {-std::abs(counts), std::abs(counts)}, "");
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
    const ex stretched =
        elongation_ + (exact_number(rig_.compliance) + first(e_.series)) * force_ + first(e_.slack);
    describe();
    return {"observation",
            "What the calibration rig's load cell and gauge read at a count of the lever's sensor.",
            "4.1",
            {count_, rate_, bend_, step_, state_},
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
    per_count_ = range / counts / (1 + first(e_.scale));
    const ex share = list_.define(
        "share", (count_.symbols[0] - first(e_.offset) - exact_number(rig_.lever.count_free)) /
                     counts / (1 + first(e_.scale)));
    const ex limited =
        list_.define("share_limited", clamped(share, numeric(-1, 10), numeric(11, 10)));
    theta_ = list_.define("theta", free + range * limited);
  }

  void write_force() {
    const LeverGeometry g = lever_geometry(list_, rig_.lever, theta_);
    elongation_ = list_.define("elongation", free_path_length(rig_.lever) - g.length);
    const ex pull = list_.define(
        "pull", -(1 + first(e_.spring)) * (g.energy_slope + first(e_.preload) * g.preload_slope) /
                    g.safe_slope);
    force_ = list_.define("force", maximum(pull, 0));
    const ex rate = clamped(rate_.symbols[0], -1000000, 1000000);
    travel_ =
        list_.define("travel", -g.slope * per_count_ * rate * clamped(step_.symbols[0], 0, 1));
    next_ = turned(0, e_.hysteresis.shapes.front().symbol, "loop");
  }

  /// Dahl's law: the way from one side of a loop to the other has a length of its own, at rest it
  /// stays where it is.
  ex turned(int state, const ex& length, const std::string& name) {
    const ex z = clamped(state_.symbols[static_cast<std::size_t>(state)], -1, 1);
    const ex way = list_.define(name + "_way", travel_ / length);
    const ex left = list_.define(name + "_left", GiNaC::exp(-magnitude(way)));
    return list_.define(name + "_next", choose(way, 1 - (1 - z) * left, (1 + z) * left - 1));
  }

  ex write_guides() {
    guided_ = turned(1, guide_turns_over, "guide");
    const ex bend = list_.define("bend_limited", clamped(bend_.symbols[0], 0, 100));
    const ex loop = list_.define("loop", force_ * (1 + first(e_.hysteresis) * next_));
    const ex exponent = clamped(first(e_.capstan) * bend * guided_, -10, 10);
    return list_.define("cell", loop * GiNaC::exp(exponent)) + first(e_.zero) +
           first(e_.fitted) * guided_ * (1 - GiNaC::exp(-e_.fitted.shapes.front().symbol * bend));
  }

  /// The equations as a report shows them.
  void describe() {
    const GiNaC::symbol f("f"), K("K"), x("x"), z("z"), alpha("alpha"), direction("direction"),
        count("count"), leverage("leverage");
    const auto say = [](ObservationEffect& e, const char* left, const ex& term) {
      e.left = left;
      e.term = term;
    };
    say(e_.spring, "force", f * (1 + first(e_.spring)));
    say(e_.preload, "force", f + K * first(e_.preload) * leverage);
    say(e_.hysteresis, "force", f * (1 + first(e_.hysteresis) * z));
    say(e_.series, "elongation", x + first(e_.series) * f);
    say(e_.slack, "elongation", x + first(e_.slack));
    say(e_.scale, "count", count / (1 + first(e_.scale)));
    say(e_.offset, "count", count - first(e_.offset));
    say(e_.zero, "force", f + first(e_.zero));
    say(e_.capstan, "force", f * GiNaC::exp(first(e_.capstan) * alpha * direction));
    say(e_.fitted, "force",
        f + first(e_.fitted) * direction *
                (1 - GiNaC::exp(-e_.fitted.shapes.front().symbol * alpha)));
  }

  const LeverRig& rig_;
  LeverEffects& e_;
  DefinitionList list_;
  Argument count_, rate_, bend_, step_, state_;
  ex per_count_, theta_, elongation_, force_, travel_, next_, guided_;
};

}  // namespace

Observation lever_observation(const LeverRig& rig, const std::string& model) {
  LeverEffects effects(0.25 * std::abs(rig.lever.count_end - rig.lever.count_free));
  Function function = Reading(rig, effects).function();
  return {model, std::move(function), effects.all()};
}

}  // namespace sinew
