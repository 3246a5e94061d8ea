// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/log_record.h"

namespace sinew::diagnosis {

LogRecord log_record(const Log& log, bool held_out) {
  LogRecord record{log.file, log.sha256, held_out, log.rows, 0.0, log.period, {}};
  record.seconds = log.period * static_cast<double>(log.sample_count());
  for (const DataFault& fault : log.faults) record.faults.push_back(message(fault));
  return record;
}

}  // namespace sinew::diagnosis
