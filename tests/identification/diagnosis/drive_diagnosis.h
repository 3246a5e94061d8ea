// SPDX-License-Identifier: GPL-3.0-or-later
// The plain drive library against a simulated drive, and what to ask of the verdict.
#pragma once

#include <set>
#include <string>

#include "identification/likelihood/explain.h"
#include "tests/identification/diagnosis/synthetic_drive.h"

namespace sinew::test {

/// Diagnoses a simulated drive.
Explanation diagnose_drive(const SyntheticDrive& drive, unsigned seed);

/// True where a cause has a member of that name.
bool is_member(const NamedCause& cause, const std::string& name);
bool is_member(const Verdict& verdict, const std::string& name);

/// The best member of every named cause.
std::set<std::string> first_names(const Verdict& verdict);

}  // namespace sinew::test
