// SPDX-License-Identifier: GPL-3.0-or-later
// The last net under all other checks of a log: a channel of which the model explains less than
// half, though hardly any of it is noise, is no log that "leaves nothing over".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "identification/adoption/measure.h"
#include "identification/logs/log.h"
#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// Where a channel of the problem stands in a log.
struct LoggedColumn {
  std::string name;
  int column = 0;  ///< from 1
};

/// Doubtful faults, one for each channel and file. `columns`: by file, one for each channel of the
/// problem. free_zero: of each log a channel's mean is nobody's, only its changes count.
std::vector<DataFault> discrepant_channels(
    const Problem& problem, const std::vector<MeasuredChannel>& measured,
    const std::map<std::string, std::vector<LoggedColumn>>& columns, bool free_zero);

/// Says so with the logs and in the headline; where nothing else was found it is the finding.
void report_discrepancies(const std::vector<DataFault>& faults, Findings& findings);

}  // namespace sinew::diagnosis
