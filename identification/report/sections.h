// SPDX-License-Identifier: GPL-3.0-or-later
// The report's sections as HTML. Each is empty where there is nothing to say.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// What a person sees first: headline, error before and after, what to do, faults, verdict cards.
std::string first_screen(const Findings& findings);

/// Error before and after of every channel, and the plots.
std::string channel_section(const Findings& findings);

/// The terms that were found, with their parameters.
std::string term_section(const Findings& findings);

/// Why these causes and no others.
std::string ranking_section(const Findings& findings);

std::string unexplained_section(const Findings& findings);

/// What became of the model.
std::string extension_section(const Findings& findings);

std::string log_section(const Findings& findings);

/// How the numbers were made.
std::string method_section(const Findings& findings);

}  // namespace sinew::diagnosis
