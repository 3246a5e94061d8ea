// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/lever_effects.h"

#include "symbolic/extension/late_sensor.h"

namespace sinew {

using GiNaC::ex;

LeverEffects::LeverEffects(double counts) {
  describe_lever();
  describe_sensors(counts);
  describe_late_sensor({"count", "1", counts, 0.01, "force and elongation off together", "lever"},
                       low_pass, play);
  describe_guides();
  write_equations();
}

std::vector<ObservationEffect> LeverEffects::all() const {
  return {spring, preload,  hysteresis, series, slack,   scale,
          offset, low_pass, play,       zero,   capstan, fitted};
}

void LeverEffects::describe_lever() {
  spring.deviations = {observation_parameter("spring_change", "1", -0.9, 10.0, 1e-4)};
  spring.limit = "the spring would push";
  spring.experiment = "weights hung on the tendon, the lever's angle read";
  spring.signature = "force left over in proportion to the force";
  spring.excitation = "several forces";
  preload.deviations = {observation_parameter("preload", "m", 0.0, 0.05, 1e-6)};
  preload.limit = "the spring would be slack at rest";
  preload.experiment = "the force at which the lever leaves its stop";
  preload.signature = "a force that is there from the start of travel";
  preload.excitation = "the whole travel, from its start";
  hysteresis.deviations = {observation_parameter("width_share", "1", 0.0, 1.0, 1e-4)};
  hysteresis.shapes = {observation_parameter("length", "m", 5e-5, 3e-3, 5)};
  hysteresis.limit = "the loop would run the wrong way round";
  hysteresis.experiment = "triangular loading to several levels";
  hysteresis.signature = "a loop of the force whose width grows with the load";
  hysteresis.excitation = "loading and unloading to several levels";
  series.deviations = {observation_parameter("compliance", "m/N", 0.0, 1e-3, 1e-9)};
  series.limit = "the tendon would shorten under load";
  series.experiment = "the lever locked, the tendon drawn";
  series.signature = "elongation left over in proportion to the force";
  series.excitation = "several forces";
  slack.deviations = {observation_parameter("slack", "m", 0.0, 0.05, 1e-6)};
  slack.limit = "the tendon would be shorter than its path";
  slack.experiment = "the elongation at which the force begins";
  slack.signature = "the same elongation left over wherever there is a force";
  slack.excitation = "the start of travel";
}

void LeverEffects::describe_sensors(double counts) {
  scale.deviations = {observation_parameter("scale_error", "1", -0.5, 0.5, 1e-5)};
  scale.experiment = "the lever between its stops, measured with a gauge";
  scale.signature = "force and elongation off together, growing with travel";
  scale.excitation = "the whole travel";
  offset.deviations = {observation_parameter("count_offset", "1", -counts, counts, 0.01)};
  offset.experiment = "the count with the tendon free";
  offset.signature = "force and elongation off together from the start of travel";
  offset.excitation = "the whole travel";
  zero.deviations = {observation_parameter("force_offset", "N", -1000.0, 1000.0, 1e-3)};
  zero.experiment = "the tendon slack: what the load cell still shows";
  zero.signature = "the same force left over everywhere, with the tendon slack, too";
  zero.excitation = "the start of travel, where the lever is at its stop";
}

void LeverEffects::describe_guides() {
  for (ObservationEffect* e : {&capstan, &fitted}) {
    e->limit = "friction would drive the tendon";
    e->experiment = "slow triangular motion at several bending angles and forces";
    e->excitation = "both directions at several bending angles";
  }
  capstan.deviations = {observation_parameter("friction_coefficient", "1", 0.0, 1.0, 1e-5)};
  capstan.signature = "a loop whose width grows with the bending angle and with the force";
  fitted.deviations = {observation_parameter("C0", "N", 0.0, 200.0, 1e-3)};
  fitted.shapes = {observation_parameter("C1", "1/rad", 0.05, 3.0, 4)};
  fitted.signature = "a loop whose width grows with the bending angle at any force";
}

void LeverEffects::write_equations() {
  const GiNaC::symbol f("f"), K("K"), x("x"), z("z"), alpha("alpha"), direction("direction"),
      count("count"), leverage("leverage");
  const auto say = [](ObservationEffect& e, const char* left, const ex& term) {
    e.left = left;
    e.term = term;
  };
  say(spring, "force", f * (1 + spring.deviation()));
  say(preload, "force", f + K * preload.deviation() * leverage);
  say(hysteresis, "force", f * (1 + hysteresis.deviation() * z));
  say(series, "elongation", x + series.deviation() * f);
  say(slack, "elongation", x + slack.deviation());
  say(scale, "count", count / (1 + scale.deviation()));
  say(offset, "count", count - offset.deviation());
  say(zero, "force", f + zero.deviation());
  say(capstan, "force", f * GiNaC::exp(capstan.deviation() * alpha * direction));
  say(fitted, "force",
      f + fitted.deviation() * direction * (1 - GiNaC::exp(-fitted.shapes.front().symbol * alpha)));
}

}  // namespace sinew
