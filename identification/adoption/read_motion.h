// SPDX-License-Identifier: GPL-3.0-or-later
// The logs of a diagnosis of driven joints, currents made efforts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "identification/adoption/diagnose.h"

namespace sinew::diagnosis {

/// Training logs first, each with the channels that were looked for in it.
struct LoggedMotion {
  std::vector<Log> logs;
  std::vector<DrivenChannels> channels;
  std::size_t training = 0;  ///< how many of them
};

/// `constants`: by joint or effort channel, N·m/A or N/A; other currents are read in A. Throws as
/// read_csv() does.
LoggedMotion read_logs(const DiagnoseRequest& request,
                       const std::map<std::string, double>& constants);

DrivenColumns columns_in(const Log& log, const DrivenChannels& channels);

/// Effort channels that some log has as a current, and of which no constant is known.
std::vector<std::string> open_currents(const LoggedMotion& logged);

/// Adds the constants of these channels, fitted to the training logs, and gives what is to be said
/// of them. Throws LogError where the logs tell none. Logs with a load of `payloads` are looked at
/// only where there are no others. `subject`: without logs.
std::vector<std::string> fit_constants(const LoggedMotion& logged,
                                       const std::vector<CarriedPayload>& payloads,
                                       const std::vector<std::string>& open,
                                       const DrivenSubject& subject,
                                       std::map<std::string, double>& constants);

/// By joint, the constants with which efforts that are logged as currents were read [N·m/A, N/A].
std::map<std::string, double> constants_used(const LoggedMotion& logged);

}  // namespace sinew::diagnosis
