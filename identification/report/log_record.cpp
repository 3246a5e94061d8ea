// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/log_record.h"

#include <stdexcept>

namespace sinew::diagnosis {

LogRecord log_record(const Log& log, bool held_out) {
  LogRecord record{log.file, log.sha256, held_out, log.rows, 0.0, log.period, {}, {}};
  record.seconds = log.period * static_cast<double>(log.sample_count());
  for (const DataFault& fault : log.faults)
    (fault.severity == Severity::note ? record.notes : record.faults).push_back(message(fault));
  return record;
}

void refuse_held_out_twins(const std::vector<LogRecord>& logs) {
  for (const LogRecord& held : logs)
    for (const LogRecord& learnt : logs)
      if (held.held_out && !learnt.held_out && held.sha256 == learnt.sha256)
        throw std::invalid_argument(held.file + ": --holdout has the same content as --log " +
                                    learnt.file +
                                    "; hold out a log that is not learnt from, or leave it away");
}

}  // namespace sinew::diagnosis
