// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/model_effects.h"

#include <algorithm>

namespace sinew {
namespace {

using GiNaC::symbol;

constexpr double longest_delay = 0.05;      // s
constexpr double strongest_gravity = 20.0;  // m/s^2 of change: upside down

const symbol& model() {
  static const symbol s("model");
  return s;
}

const symbol& model_rate() {
  static const symbol s("model_rate");
  return s;
}

const symbol& model_slope() {
  static const symbol s("model_slope");
  return s;
}

std::vector<ModelEffect> of_drives() {
  const symbol delay("delay"), gain("gain_change");
  return {
      {"delay",
       "delay",
       model() + delay * model_rate(),
       "effort left over in proportion to the model's rate of change",
       "fast changes of the effort",
       "steps of the command at several speeds, logged at the highest rate",
       "it would be longer than any bus or filter makes it",
       {{"delay", "s", {-longest_delay, longest_delay}}}},
      {"torque_constant",
       "torque constant",
       model() / (1 + gain),
       "effort left over in proportion to the whole effort",
       "a load that is known apart from the motion",
       "a known external load, for instance a weight held still",
       "no gain is that wrong: is the unit, is the sign right?",
       {{"gain_change", "1", {-0.6, 1.5}}}},
      {"pulley_radius",
       "pulley radius",
       model() / (1 + gain),
       "torque left over in proportion to the tendons' torque",
       "tendon forces that are known apart from the motion",
       "a known weight at the link, the joint held by its tendons alone",
       "the pulley would be less than half or more than twice as large",
       {{"gain_change", "1", {-0.5, 1.0}}}},
  };
}

/// Mass, first moments and moments of inertia about the link's origin. Those of a point may be left
/// away.
std::vector<ModelCoefficient> of_a_body(const ValueLimits& mass) {
  std::vector<ModelCoefficient> list{{"mass", "kg", mass}};
  for (const char* axis : {"x", "y", "z"})
    list.push_back({std::string("first_moment_") + axis, "kg*m", {}, false});
  for (const char* axes : {"xx", "yy", "zz", "xy", "xz", "yz"})
    list.push_back({std::string("moment_") + axes, "kg*m^2", {}, false});
  return list;
}

std::vector<ModelCoefficient> of_gravity() {
  std::vector<ModelCoefficient> list;
  for (const char* axis : {"x", "y", "z"})
    list.push_back({std::string("gravity_change_") + axis,
                    "m/s^2",
                    {-strongest_gravity, strongest_gravity},
                    false});
  return list;
}

std::vector<ModelEffect> of_links() {
  const symbol regressor("regressor_of_the_link"), change("change_of_its_inertial_parameters"),
      weight("model_for_each_axis_of_gravity"), gravity("gravity_change"),
      push("jacobian_of_the_point"), force("force");
  return {
      {"payload", "payload", model() + regressor * change,
       "effort left over with the link's weight and its acceleration",
       "motion of all joints that the link moves with",
       "the same slow motion with and without what may be attached",
       "no body near the robot has such a mass and such moments", of_a_body({0.0}),
       ModelPlace::link},
      {"inertial_parameters", "inertial parameters", model() + regressor * change,
       "effort left over with the link's weight and its acceleration",
       "motion of all joints that the link moves with",
       "motion of all joints that it moves with, slow and fast",
       "its mass would be negative, or the change more than the whole robot weighs", of_a_body({}),
       ModelPlace::link},
      {"unlogged_force",
       "unlogged force",
       model() - push * force,
       "much more left over now and then than at the same motion elsewhere",
       "",
       "the same motion again, nothing near the robot, or the force logged",
       "",
       {},
       ModelPlace::link},
      {"gravity", "gravity left out, or its direction", model() + weight * gravity,
       "effort left over with the posture, the same both ways", "several postures",
       "slow motion over the whole range", "gravity would be stronger than the earth's",
       of_gravity(), ModelPlace::base},
  };
}

std::vector<ModelEffect> of_position_sensors() {
  const symbol tau("time_constant"), scale("scale_error"), offset("zero_offset"), q("q"),
      play("half_play"), side("side"), share("share_of_steps"), steps("model_of_the_steps");
  return {
      {"sensor_low_pass", "low-pass of the position sensor", model() + tau * model_rate(),
       "effort left over in proportion to the model's rate of change", "fast motion",
       "fast sinusoids against a second sensor", "the sensor would run ahead of the motion"},
      {"sensor_scale", "scale of the position sensor", model() - scale * q * model_slope(),
       "inertia and damping off by one share, friction not", "large motion",
       "the travel between two stops, measured with a gauge", ""},
      {"sensor_offset",
       "zero offset of the position sensor",
       model() - offset * model_slope(),
       "as if gravity and the other links stood elsewhere",
       "gravity, or joints that move together",
       "the position held at a stop or a mark that is known",
       "",
       {{"zero_offset", "{position}", {-0.2, 0.2}}}},
      {"sensor_quantisation", "quantisation of the position sensor", model() + share * steps,
       "effort left over as rough as the position's steps make it", "motion that is smooth itself",
       "the same motion against a finer sensor",
       "the motion would be rougher than what is logged of it"},
      {"sensor_hysteresis", "hysteresis of the position sensor",
       model() + play * side * model_slope(), "a short pulse behind every reversal",
       "many reversals", "slow reversals against a second sensor",
       "the sensor would run ahead of the motion"},
  };
}

}  // namespace

const std::vector<ModelEffect>& model_effects() {
  static const std::vector<ModelEffect> list = [] {
    std::vector<ModelEffect> all = of_drives();
    for (const std::vector<ModelEffect>& more : {of_links(), of_position_sensors()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return list;
}

const ModelEffect* find_model_effect(const std::string& id) {
  const std::vector<ModelEffect>& list = model_effects();
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const ModelEffect& e) { return e.id == id; });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace sinew
