// SPDX-License-Identifier: GPL-3.0-or-later
// One diagnosis of driven joints, from log files to findings.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "identification/logs/carried_payload.h"
#include "identification/logs/channel_map.h"
#include "identification/report/findings.h"
#include "identification/subjects/driven_channels.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

struct DiagnoseRequest {
  DrivenModel model;
  Identified identified;               ///< what the model has learnt before
  std::optional<Mechanism> mechanism;  ///< behind the model, where there is one
  std::string name, description, hash, kind;
  std::filesystem::path runtime;           ///< folder of the runtime's headers
  std::vector<std::string> logs, holdout;  ///< files
  std::vector<std::string> map;            ///< texts of --map
  /// The channels to look for in a file, by what its header holds.
  std::function<DrivenChannels(const std::string& file)> channels;
  std::vector<std::string> notes;  ///< said beside what is found about the first log
  /// By joint or effort channel: the effort of 1 A [N·m/A, N/A], where efforts are logged as
  /// currents. Those that are not here are fitted.
  std::map<std::string, double> torque_constants;
  std::vector<CarriedPayload> payloads;  ///< loads of known mass that logs were recorded with
  Settings settings;
  /// Told what is going on, 0..1; may be empty.
  std::function<void(const std::string& step, double share)> progress;
};

struct Diagnosis {
  Findings findings;
  Identified extended;  ///< what the model has learnt with this, where it is adopted
  /// Motions that would settle what cannot be told apart, as CSV text, by file name.
  std::map<std::string, std::string> experiments;
};

/// Reads the logs, explains what the model leaves over, extends the model and measures the gain on
/// the held-out logs through the regenerated C. Throws LogError for logs that cannot be used,
/// std::invalid_argument where they are too short.
Diagnosis diagnose(const DiagnoseRequest& request);

}  // namespace sinew::diagnosis
