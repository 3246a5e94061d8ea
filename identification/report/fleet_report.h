// SPDX-License-Identifier: GPL-3.0-or-later
// What the sums of many logs say, for people and for programs.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

struct FleetFindings {
  std::string model, model_hash, kind;
  std::vector<LogRecord> logs;  ///< period 0: sums do not keep it
  Verdict verdict;
  std::string headline;
  double whitened_error_left = 1.0;  ///< of the training logs, with all causes
  double seconds = 0.0;
};

/// A sentence, then one line each for the logs, the causes with their parameters, and what is left.
std::string fleet_text(const FleetFindings& findings);

/// docs/fleets.md says what every field means.
std::string fleet_json(const FleetFindings& findings);

}  // namespace sinew::diagnosis
