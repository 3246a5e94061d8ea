// SPDX-License-Identifier: GPL-3.0-or-later
// The channels that a model knows, and what is plausible for each.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "identification/logs/log.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// A channel that a model knows, and what is plausible for it (SI units).
struct ChannelSpec {
  std::string name;
  std::string unit;  ///< SI
  ChannelRole role = ChannelRole::other;
  bool required = false;
  int group = -1;  ///< channels of one coordinate (position, velocity, effort, ...) share it
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double max_rate = std::numeric_limits<double>::infinity();  ///< per second
  std::vector<std::string> also{};                            ///< other names that are understood
  /// Effort channels: the torque constant, N·m/A or N/A at the joint, with which a column in A is
  /// read; 0: not known, such a column is refused.
  double per_ampere = 0.0;
  bool is_set = false;       ///< not measured: one value in every row is no fault
  bool keep_ampere = false;  ///< a column in A without a known constant is read as it is, in A
};

/// Limits of a single drive, for the plausibility of its channels. Infinite or 0 where unknown.
struct DriveLimits {
  double low = -std::numeric_limits<double>::infinity();  ///< position, rad or m
  double high = std::numeric_limits<double>::infinity();
  double max_velocity = std::numeric_limits<double>::infinity();  ///< rad/s or m/s
  double max_effort = std::numeric_limits<double>::infinity();    ///< N·m or N
};

/// theta, tau_m and optional theta_ref, omega, load, i.
std::vector<ChannelSpec> rotary_drive_channels(const DriveLimits& limits = {});
/// x, f and optional x_ref, v, load, i.
std::vector<ChannelSpec> linear_drive_channels(const DriveLimits& limits = {});
/// The position (position_channel()), tau_<joint> and optional qd_<joint>, <position>_ref for every
/// moving joint, those that follow another one optional altogether; optional payload, the mass of
/// what the last link is known to carry.
std::vector<ChannelSpec> robot_channels(const Mechanism& mechanism);
/// Position of every coordinate (position_channel()), theta_1..m, tau_1..m of the m tendons'
/// motors.
std::vector<ChannelSpec> finger_channels(const Mechanism& mechanism);
/// The same for tendons of these numbers, of each what is asked for: theta_i and tau_i of its
/// motor, force_i.
std::vector<ChannelSpec> finger_channels(const Mechanism& mechanism,
                                         const std::vector<int>& numbers, bool motors, bool forces);
/// count and force, optional elongation, lever, bend (of the tendon between lever and load cell).
/// The count's sensor goes from `low` to `high` where that is known.
std::vector<ChannelSpec> lever_channels(double low = -std::numeric_limits<double>::infinity(),
                                        double high = std::numeric_limits<double>::infinity());
/// q71, q73, theta_1..m and optional force_1..m.
std::vector<ChannelSpec> wrist_channels(int tendons);

}  // namespace sinew
