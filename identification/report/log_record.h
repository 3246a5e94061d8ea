// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "identification/logs/log.h"
#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// What a report says of a log that was read.
LogRecord log_record(const Log& log, bool held_out);

/// Throws std::invalid_argument where a held-out log is one of the others: what was learnt from a
/// log is no surprise to it.
void refuse_held_out_twins(const std::vector<LogRecord>& logs);

}  // namespace sinew::diagnosis
