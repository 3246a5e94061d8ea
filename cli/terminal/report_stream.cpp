// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal/report_stream.h"

#include <stdexcept>

#include "generator/outputs/output_place.h"

namespace sinew {

std::FILE* stream_of_report(const std::string& out) {
  return is_standard_output(out) ? stderr : stdout;
}

void refuse_two_reports(const std::string& out, bool json) {
  if (json && is_standard_output(out))
    throw std::runtime_error("--out " + out +
                             ": is standard output, which --json writes to as well; expected a "
                             "file, or no --json");
}

}  // namespace sinew
