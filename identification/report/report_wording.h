// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences that the report and the terminal share. Plain text, UTF-8.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// Names of all members: "payload or torque gain". Members that differ by place alone:
/// "friction (tendon 1 or tendon 2)".
std::string title_of(const NamedCause& cause);

/// The place of all members where it is one and the same, otherwise empty.
std::string place_of(const NamedCause& cause);

/// The gain a cause is credited with: on held-out logs where there are any.
const Gain& gain_of(const Findings& findings, const NamedCause& cause);

/// Whether a log was held out.
bool has_held_out(const Findings& findings);

/// "held-out log", "held-out logs" or "left-out blocks": what gains are measured on.
std::string measured_on(const Findings& findings);

/// "cannot tell payload from torque gain: ..." with the experiment, empty for a single member.
std::string separation_of(const NamedCause& cause);

/// All faults of all logs.
std::vector<std::string> faults_of(const Findings& findings);

/// The headline, or a sentence that the verdict gives where there is none.
std::string headline_of(const Findings& findings);

/// One sentence about what the known causes leave over.
std::string leftover_of(const Verdict& verdict);

/// "position x direction" with a multiplication sign.
std::string shown_dependence(std::string on);

/// With a full stop at the end.
std::string sentence(std::string text);

/// "1 log", "3 logs".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace sinew::diagnosis
