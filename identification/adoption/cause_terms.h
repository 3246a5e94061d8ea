// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic terms that a verdict's causes stand for, as the report shows them.
#pragma once

#include <string>

#include "identification/report/findings.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// Identifier of what a cause's candidate stands for, as identified.toml and findings have it.
std::string effect_of(const DrivenSubject& subject, const NamedCause& cause);

/// Adds the term of every cause of the verdict, and takes its parameters to those of the equation.
void describe_terms(const DrivenSubject& subject, Findings& findings);

}  // namespace sinew::diagnosis
