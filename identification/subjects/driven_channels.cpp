// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/driven_channels.h"

#include <fmt/format.h>

#include <numeric>

#include "identification/logs/csv_rows.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/model/channel_name.h"

namespace sinew::diagnosis {
namespace {

bool has_channel(const std::string& file, const std::vector<std::string>& map,
                 const std::string& name) {
  return names_channel(CsvReader(file).dialect().header, map, name);
}

DriveLimits limits_of(const Joint& joint) {
  DriveLimits limits;
  limits.low = joint.low;
  limits.high = joint.high;
  limits.max_velocity = joint.max_velocity;
  return limits;
}

}  // namespace

DrivenChannels drive_log_channels(bool revolute, const DriveLimits& limits) {
  DrivenChannels channels;
  channels.specs = revolute ? rotary_drive_channels(limits) : linear_drive_channels(limits);
  channels.positions = {revolute ? "theta" : "x"};
  channels.efforts = {revolute ? "tau_m" : "f"};
  channels.load = "load";
  return channels;
}

DrivenChannels robot_log_channels(const Mechanism& mechanism, const std::string& file,
                                  const std::vector<std::string>& map) {
  const Coordinates coordinates(mechanism);
  const auto joint_at = [&](int index) -> const Joint& {
    return mechanism.joints[static_cast<std::size_t>(index)];
  };
  if (coordinates.count() == 1) {
    const Joint& joint = joint_at(coordinates.joints().front());
    // A joint called x or theta is no drive's position where its effort is a joint's.
    const auto names_joint = [&](const std::string& name) {
      return !name.empty() &&
             (has_channel(file, map, "q_" + name) || has_channel(file, map, "tau_" + name));
    };
    if (!names_joint(joint.name) && !names_joint(joint.source_name))
      return drive_log_channels(joint.type == JointType::revolute, limits_of(joint));
  }
  DrivenChannels channels;
  channels.specs = robot_channels(mechanism);
  for (const int index : coordinates.joints()) {
    channels.positions.push_back(position_channel(joint_at(index).name));
    channels.efforts.push_back("tau_" + joint_at(index).name);
  }
  return channels;
}

std::string joint_of_effort(const std::string& channel) {
  return channel.starts_with("tau_") ? channel.substr(4) : channel;
}

void set_torque_constants(const std::map<std::string, double>& constants,
                          DrivenChannels& channels) {
  for (ChannelSpec& spec : channels.specs) {
    if (spec.role != ChannelRole::effort) continue;
    for (const std::string& name : {spec.name, joint_of_effort(spec.name)})
      if (const auto found = constants.find(name); found != constants.end())
        spec.per_ampere = found->second;
    spec.keep_ampere = spec.per_ampere == 0.0;
  }
}

LoggedEfforts logged_efforts(const Mechanism& mechanism, const std::string& file,
                             const std::vector<std::string>& map) {
  const auto has = [&](const std::string& name) { return has_channel(file, map, name); };
  if (mechanism.tendons.empty() || !has("force_1")) return LoggedEfforts::at_joints;
  return has("theta_1") && has("tau_1") ? LoggedEfforts::tendon_forces_and_motors
                                        : LoggedEfforts::tendon_forces;
}

DrivenChannels tendon_log_channels(const Mechanism& mechanism, const std::vector<int>& numbers,
                                   bool motors) {
  DrivenChannels channels;
  channels.specs = finger_channels(mechanism, numbers, motors, true);
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints())
    channels.positions.push_back(
        position_channel(mechanism.joints[static_cast<std::size_t>(index)].name));
  for (const int i : numbers) {
    channels.forces.push_back(fmt::format("force_{}", i));
    if (!motors) continue;
    channels.positions.push_back(fmt::format("theta_{}", i));
    channels.efforts.push_back(fmt::format("tau_{}", i));
  }
  return channels;
}

std::vector<int> tendon_numbers(const Mechanism& mechanism) {
  std::vector<int> numbers(mechanism.tendons.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

}  // namespace sinew::diagnosis
