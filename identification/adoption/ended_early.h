// SPDX-License-Identifier: GPL-3.0-or-later
// A log that was read is reported, whatever becomes of what is calculated from it.
#pragma once

#include <functional>
#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// Runs a step. Empty, or the message of the exception that ended it.
std::string why_ended(const std::function<void()>& step);

/// Says that the search for causes ended without a result: nothing is known of causes then, and
/// nothing is adopted.
void tell_ended_search(const std::string& why, Findings& findings);

}  // namespace sinew::diagnosis
