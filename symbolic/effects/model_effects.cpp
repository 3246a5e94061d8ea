// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/model_effects.h"

#include <algorithm>

namespace sinew {
namespace {

using GiNaC::symbol;

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
      {"delay", "delay", model() + delay * model_rate(),
       "effort left over in proportion to the model's rate of change", "fast changes of the effort",
       "steps of the command at several speeds, logged at the highest rate",
       "it would be longer than any bus or filter makes it"},
      {"torque_constant", "torque constant", model() / (1 + gain),
       "effort left over in proportion to the whole effort",
       "a load that is known apart from the motion",
       "a known external load, for instance a weight held still",
       "no gain is that wrong: is the unit, is the sign right?"},
      {"pulley_radius", "pulley radius", model() / (1 + gain),
       "torque left over in proportion to the tendons' torque",
       "tendon forces that are known apart from the motion",
       "a known weight at the link, the joint held by its tendons alone",
       "the pulley would be less than half or more than twice as large"},
  };
}

std::vector<ModelEffect> of_links() {
  const symbol regressor("regressor_of_the_link"), change("change_of_its_inertial_parameters"),
      weight("model_for_each_axis_of_gravity"), gravity("gravity_change");
  return {
      {"payload", "payload", model() + regressor * change,
       "effort left over with the link's weight and its acceleration",
       "motion of all joints that the link moves with",
       "the same slow motion with and without what may be attached",
       "no body near the robot has such a mass and such moments"},
      {"inertial_parameters", "inertial parameters", model() + regressor * change,
       "effort left over with the link's weight and its acceleration",
       "motion of all joints that the link moves with",
       "motion of all joints that it moves with, slow and fast", "its mass would be negative"},
      {"gravity", "gravity left out, or its direction", model() + weight * gravity,
       "effort left over with the posture, the same both ways", "several postures",
       "slow motion over the whole range", "gravity would be stronger than the earth's"},
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
      {"sensor_offset", "zero offset of the position sensor", model() - offset * model_slope(),
       "as if gravity and the other links stood elsewhere", "gravity, or joints that move together",
       "the position held at a stop or a mark that is known", ""},
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
