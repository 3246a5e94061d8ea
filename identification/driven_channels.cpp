// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/driven_channels.h"

#include <fstream>

#include "symbolic/coordinates.h"

namespace sinew::diagnosis {
namespace {

/// The header: the first line that is no comment.
std::string header_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  while (std::getline(in, line))
    if (!line.empty() && line.front() != '#') return line;
  return {};
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
    std::string known = header_of(file);
    for (const std::string& text : map) known += " " + text;
    if (known.find("q_" + joint.name) == std::string::npos)
      return drive_log_channels(joint.type == JointType::revolute, {});
  }
  DrivenChannels channels;
  channels.specs = robot_channels(mechanism);
  for (const int index : coordinates.joints()) {
    channels.positions.push_back("q_" + joint_at(index).name);
    channels.efforts.push_back("tau_" + joint_at(index).name);
  }
  return channels;
}

}  // namespace sinew::diagnosis
