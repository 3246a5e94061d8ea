// SPDX-License-Identifier: GPL-3.0-or-later
// The logs of a diagnosis of driven joints, read, checked, and in the subject that they are of.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "identification/adoption/diagnose.h"
#include "identification/adoption/discrepancy.h"

namespace sinew::diagnosis {

/// The model under diagnosis, without a log.
DrivenSubject empty_subject(const DiagnoseRequest& request);

struct SubjectOfLogs {
  DrivenSubject subject;  ///< with all logs, not prepared yet
  /// By file: what each channel of the problem is measured by.
  std::map<std::string, std::vector<LoggedColumn>> columns;
  std::vector<LogRecord> logs;  ///< training logs first
  /// By joint, with which efforts that are logged as currents were read [N·m/A, N/A].
  std::map<std::string, double> torque_constants = {};
};

/// Throws LogError where going on with a log is not safe, std::invalid_argument for a load that the
/// model has no place for.
SubjectOfLogs read_subject(const DiagnoseRequest& request);

}  // namespace sinew::diagnosis
