// SPDX-License-Identifier: GPL-3.0-or-later
// A diagnosis of many logs by their sums: each log is summed by itself, anywhere, and the sums are
// added up.
#pragma once

#include <string>
#include <vector>

#include "identification/adoption/diagnose.h"
#include "identification/likelihood/sums_file.h"
#include "identification/report/fleet_report.h"

namespace sinew::diagnosis {

/// Reads, checks and sums the one log in `request.holdout`; `request.logs` are the reference logs
/// that decide the columns (the log itself may be one). `program`: its version. Throws as
/// diagnose() does, std::invalid_argument where the model's channels share their noise.
SumsFile summarise(const DiagnoseRequest& request, const std::string& program);

/// Files of sums.
struct SumsOfLogs {
  std::vector<std::string> training, held_out;
};

/// Adds the sums up, one file in memory at a time, and searches them. `request.logs`: the reference
/// logs. Throws std::runtime_error and std::invalid_argument that name a file which cannot be read,
/// is of another model, other reference logs or settings, or of a log that another file has.
FleetFindings diagnose_sums(const DiagnoseRequest& request, const std::string& program,
                            const SumsOfLogs& files);

}  // namespace sinew::diagnosis
