// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "identification/findings.h"
#include "identification/log.h"

namespace sinew::diagnosis {

/// What a report says of a log that was read.
LogRecord log_record(const Log& log, bool held_out);

}  // namespace sinew::diagnosis
