// SPDX-License-Identifier: GPL-3.0-or-later
// Which channels a log of driven joints has.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnose.h"
#include "symbolic/mechanism.h"

namespace sinew::diagnosis {

/// theta, tau_m, load or x, f, load.
DrivenChannels drive_log_channels(bool revolute, const DriveLimits& limits);

/// q_<joint>, tau_<joint> of every coordinate. A mechanism of one joint may also be logged as a
/// drive: it is where neither the file's header nor --map knows q_<joint>.
DrivenChannels robot_log_channels(const Mechanism& mechanism, const std::string& file,
                                  const std::vector<std::string>& map);

}  // namespace sinew::diagnosis
