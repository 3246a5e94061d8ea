// SPDX-License-Identifier: GPL-3.0-or-later
// What the terminal shows of a diagnosis.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// At most 25 lines of at most 100 characters (UTF-8), a line feed at the end of each. What does
/// not fit is in the report, which the text says.
std::string report_text(const Findings& findings);

}  // namespace sinew::diagnosis
