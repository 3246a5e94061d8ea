// SPDX-License-Identifier: GPL-3.0-or-later
// A verdict in words.
#pragma once

#include <string>

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// What to log to tell a set apart, where its motion is, and how sure that would be.
std::string experiment_text(const Separation& separation);

/// What training and held-out logs do not agree on; empty: nothing.
std::string disagreement_text(const Findings& findings);

/// One sentence that a person understands.
std::string headline(const Findings& findings);

/// What to do now.
std::string next_step(const Findings& findings);

/// Mathematics, signature and excitation of causes that act on the model as a whole (delay, torque
/// constant, the position sensor).
void describe_model_term(const std::string& effect, CauseTerm& term);

}  // namespace sinew::diagnosis
