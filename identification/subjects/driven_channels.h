// SPDX-License-Identifier: GPL-3.0-or-later
// Which channels a log of driven joints has.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "identification/logs/channel_map.h"
#include "identification/subjects/driven_subject.h"
#include "symbolic/model/mechanism.h"

namespace sinew::diagnosis {

/// The channels of one log file that belong to the joints of a driven model, in their order.
struct DrivenChannels {
  std::vector<ChannelSpec> specs;
  std::vector<std::string> positions, efforts;  ///< names among the specs
  std::vector<std::string> forces;              ///< of the tendons that drive the joints
  std::string load;                             ///< empty: none
};

/// theta, tau_m, load or x, f, load.
DrivenChannels drive_log_channels(bool revolute, const DriveLimits& limits = {});

/// Position (position_channel()) and tau_<joint> of every coordinate. A mechanism of one joint may
/// also be logged as a drive: it is where neither the file's header nor --map knows q_<joint> or
/// tau_<joint>.
DrivenChannels robot_log_channels(const Mechanism& mechanism, const std::string& file,
                                  const std::vector<std::string>& map);

/// The joint that an effort channel belongs to: "tau_elbow" is of "elbow".
std::string joint_of_effort(const std::string& channel);

/// Sets what 1 A makes of each effort, by joint or by channel; efforts without an entry are read in
/// A where the file has them as a current.
void set_torque_constants(const std::map<std::string, double>& constants, DrivenChannels& channels);

/// What a log of a mechanism has of its efforts.
enum class LoggedEfforts { at_joints, tendon_forces, tendon_forces_and_motors };

/// By the file's header and the texts of --map; at_joints where neither has force_1.
LoggedEfforts logged_efforts(const Mechanism& mechanism, const std::string& file,
                             const std::vector<std::string>& map);

/// Position of every coordinate; for the tendon of number i force_i, and with motors theta_i,
/// tau_i.
DrivenChannels tendon_log_channels(const Mechanism& mechanism, const std::vector<int>& numbers,
                                   bool motors);

/// 1, 2, ... for all tendons of the mechanism.
std::vector<int> tendon_numbers(const Mechanism& mechanism);

}  // namespace sinew::diagnosis
