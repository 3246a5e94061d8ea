// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/still_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/logs/read_csv.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/model/channel_name.h"

namespace sinew::diagnosis {
namespace {

/// Positions alone, any of which may be missing or stand still.
std::vector<ChannelSpec> positions_of(const Mechanism& mechanism) {
  std::vector<ChannelSpec> specs;
  for (ChannelSpec spec : robot_channels(mechanism)) {
    if (spec.role != ChannelRole::position) continue;
    spec.required = false;
    specs.push_back(std::move(spec));
  }
  return specs;
}

struct Seen {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double steps = 0.0;
};

Seen seen_of(const std::string& channel, const std::vector<Log>& logs) {
  // Noise reaches five deviations in a long log, a sensor's last step flickers.
  constexpr double kNoise = 10.0, kSteps = 1.5;
  Seen seen;
  for (const Log& log : logs) {
    const int index = log.channel(channel);
    if (index < 0) return {};
    const Channel& c = log.channels[static_cast<std::size_t>(index)];
    seen.low = std::min(seen.low, c.low);
    seen.high = std::max(seen.high, c.high);
    seen.steps = std::max({seen.steps, kNoise * c.noise_floor, kSteps * c.quantum});
  }
  return seen;
}

}  // namespace

std::vector<HeldJoint> still_joints(const Mechanism& mechanism,
                                    const std::vector<std::string>& files,
                                    const std::vector<std::string>& map) {
  ReadOptions options;
  // A lone joint's log may be a drive's, whose channels are not these.
  const Coordinates coordinates(mechanism);
  if (coordinates.count() < 2) return {};
  const std::vector<ChannelSpec> specs = positions_of(mechanism);
  for (const std::string& text : map) {
    const std::string name = text.substr(0, text.find('='));
    if (std::any_of(specs.begin(), specs.end(), [&](const ChannelSpec& spec) {
          return spec.name == name ||
                 std::find(spec.also.begin(), spec.also.end(), name) != spec.also.end();
        }))
      options.map.push_back(text);
  }
  options.check_consistency = false;
  std::vector<LogFile> logs;
  for (const std::string& file : files) logs.push_back({file, specs});
  const std::vector<Log> read = read_csv(logs, options);
  std::vector<HeldJoint> held;
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    const Seen seen = seen_of(position_channel(joint.name), read);
    // A sensor that is as rough as a hundredth of the range may hide motion.
    const double most = std::min(seen.steps, 1e-2 * (joint.high - joint.low));
    if (std::isfinite(seen.low) && seen.high - seen.low <= most)
      held.push_back({joint.name, 0.5 * (seen.low + seen.high)});
  }
  return held;
}

std::string said_of(const HeldJoint& held, const Mechanism& mechanism) {
  bool slides = false;
  for (const Joint& joint : mechanism.joints)
    if (joint.name == held.name) slides = joint.type == JointType::prismatic;
  return fmt::format(
      "joint '{}' does not move in these logs: it is held at {:.6g} {}, and nothing is said of it",
      held.name, held.position, slides ? "m" : "rad");
}

}  // namespace sinew::diagnosis
