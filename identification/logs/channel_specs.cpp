// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/channel_specs.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/model/channel_name.h"

namespace sinew {
namespace {

ChannelSpec spec(std::string name, std::string unit, ChannelRole role, int group, bool required) {
  ChannelSpec result;
  result.name = std::move(name);
  result.unit = std::move(unit);
  result.role = role;
  result.group = group;
  result.required = required;
  return result;
}

std::vector<ChannelSpec> drive_channels(const DriveLimits& limits, const std::string& position,
                                        const std::string& velocity, const std::string& effort,
                                        const std::string& length, const std::string& force) {
  ChannelSpec p = spec(position, length, ChannelRole::position, 0, true);
  p.low = limits.low;
  p.high = limits.high;
  p.max_rate = limits.max_velocity;
  ChannelSpec r = p;
  r.name = position + "_ref";
  r.role = ChannelRole::reference;
  r.required = false;
  ChannelSpec v = spec(velocity, length + "/s", ChannelRole::velocity, 0, false);
  v.low = -limits.max_velocity;
  v.high = limits.max_velocity;
  ChannelSpec e = spec(effort, force, ChannelRole::effort, 0, true);
  e.low = -limits.max_effort;
  e.high = limits.max_effort;
  e.also = {"i"};
  return {p,
          e,
          r,
          v,
          spec("load", force, ChannelRole::other, 0, false),
          spec("i", "A", ChannelRole::current, 0, false)};
}

/// Either way of calling it is understood, with "q_" and without, and so is the joint's name in the
/// file that the model was imported from.
ChannelSpec joint_position(const Joint& joint, int group) {
  const bool slides = joint.type == JointType::prismatic;
  ChannelSpec p =
      spec(position_channel(joint.name), slides ? "m" : "rad", ChannelRole::position, group, true);
  p.also = {p.name == joint.name ? "q_" + joint.name : joint.name};
  if (!joint.source_name.empty())
    p.also.insert(p.also.end(), {joint.source_name, "q_" + joint.source_name});
  p.low = joint.low;
  p.high = joint.high;
  p.max_rate = joint.max_velocity;
  return p;
}

}  // namespace

std::vector<ChannelSpec> rotary_drive_channels(const DriveLimits& limits) {
  return drive_channels(limits, "theta", "omega", "tau_m", "rad", "N*m");
}

std::vector<ChannelSpec> linear_drive_channels(const DriveLimits& limits) {
  return drive_channels(limits, "x", "v", "f", "m", "N");
}

std::vector<ChannelSpec> robot_channels(const Mechanism& mechanism) {
  std::vector<ChannelSpec> specs;
  int group = 0;
  const Coordinates coordinates(mechanism);
  const std::vector<int>& own = coordinates.joints();
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type == JointType::fixed) continue;
    const bool slides = joint.type == JointType::prismatic;
    // What follows another joint need not be logged.
    const bool needed = std::find(own.begin(), own.end(), static_cast<int>(i)) != own.end();
    ChannelSpec p = joint_position(joint, group);
    p.required = needed;
    specs.push_back(p);
    const auto also = [&](const char* prefix) {
      return joint.source_name.empty() ? std::vector<std::string>{}
                                       : std::vector{prefix + joint.source_name};
    };
    specs.push_back(
        spec("tau_" + joint.name, slides ? "N" : "N*m", ChannelRole::effort, group, needed));
    specs.back().also = {"i_" + joint.name, "current_" + joint.name};
    for (const char* prefix : {"tau_", "i_", "current_"})
      if (!joint.source_name.empty()) specs.back().also.push_back(prefix + joint.source_name);
    ChannelSpec v = spec("qd_" + joint.name, p.unit + "/s", ChannelRole::velocity, group, false);
    v.also = also("qd_");
    v.low = -joint.max_velocity;
    v.high = joint.max_velocity;
    specs.push_back(v);
    ChannelSpec r = p;
    r.name = p.name + "_ref";
    r.role = ChannelRole::reference;
    r.required = false;
    for (std::string& other : r.also) other += "_ref";
    specs.push_back(r);
    ++group;
  }
  ChannelSpec carried = spec("payload", "kg", ChannelRole::other, -1, false);
  carried.low = 0.0;
  carried.is_set = true;
  specs.push_back(carried);
  return specs;
}

std::vector<ChannelSpec> finger_channels(const Mechanism& mechanism) {
  std::vector<int> numbers(mechanism.tendons.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  return finger_channels(mechanism, numbers, true, false);
}

std::vector<ChannelSpec> finger_channels(const Mechanism& mechanism,
                                         const std::vector<int>& numbers, bool motors,
                                         bool forces) {
  std::vector<ChannelSpec> specs;
  int group = 0;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<size_t>(index)];
    specs.push_back(joint_position(joint, group++));
  }
  for (const int i : numbers)
    if (forces)
      specs.push_back(spec(fmt::format("force_{}", i), "N", ChannelRole::other, -1, true));
  for (const int i : numbers) {
    if (!motors) continue;
    specs.push_back(spec(fmt::format("theta_{}", i), "rad", ChannelRole::position, group, true));
    specs.push_back(spec(fmt::format("tau_{}", i), "N*m", ChannelRole::effort, group, true));
    ++group;
  }
  return specs;
}

std::vector<ChannelSpec> lever_channels(double low, double high) {
  std::vector<ChannelSpec> specs{spec("count", "1", ChannelRole::other, -1, true),
                                 spec("force", "N", ChannelRole::effort, -1, true),
                                 spec("elongation", "m", ChannelRole::other, -1, false),
                                 spec("lever", "rad", ChannelRole::other, -1, false),
                                 spec("bend", "rad", ChannelRole::other, -1, false)};
  specs.front().low = low;
  specs.front().high = high;
  specs[3].low = -2.0 * std::numbers::pi;
  specs[3].high = 2.0 * std::numbers::pi;
  specs.back().is_set = true;
  // No guide bends a tendon by more than a turn.
  specs.back().low = 0.0;
  specs.back().high = 2.0 * std::numbers::pi;
  return specs;
}

std::vector<ChannelSpec> wrist_channels(int tendons) {
  std::vector<ChannelSpec> specs = {spec("q71", "rad", ChannelRole::position, 0, true),
                                    spec("q73", "rad", ChannelRole::position, 1, true)};
  for (int i = 1; i <= tendons; ++i) {
    specs.push_back(spec(fmt::format("theta_{}", i), "rad", ChannelRole::position, i + 1, true));
    specs.push_back(spec(fmt::format("force_{}", i), "N", ChannelRole::other, i + 1, false));
  }
  return specs;
}

}  // namespace sinew
