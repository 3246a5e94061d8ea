// SPDX-License-Identifier: GPL-3.0-or-later
// findings.json: the same facts as the report, for programs. docs/findings.md says what every field
// means, docs/findings.schema.json is its JSON schema.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// Raised whenever a field is renamed, removed or changes its meaning; added fields do not raise
/// it.
inline constexpr int kFindingsSchemaVersion = 3;

/// What the verdict comes down to: "causes named", "cannot tell" (at least one set of several),
/// "none of the known causes" or "nothing beyond noise".
std::string outcome(const Verdict& verdict);

/// Keys in a fixed order, two blanks of indentation, a line feed at the end. Numbers that are not
/// finite are null. Bytes that are no UTF-8 are replaced. Curves are thinned as in the report.
std::string findings_json(const Findings& findings);

}  // namespace sinew::diagnosis
