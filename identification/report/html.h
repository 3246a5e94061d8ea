// SPDX-License-Identifier: GPL-3.0-or-later
// The report: one HTML file that needs nothing else.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// The whole page. No script, no font and no request of any kind: its own content security policy
/// forbids them. Pictures are drawn by gnuplot; where it is absent, their places say so. The same
/// findings give the same bytes.
std::string report_html(const Findings& findings);

}  // namespace sinew::diagnosis
