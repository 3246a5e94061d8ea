// SPDX-License-Identifier: GPL-3.0-or-later
// What a study's trials came to, for the tables of docs/blind_trials.md (tests/blind/study).
#pragma once

#include <string>

#include "tests/blind/diagnosed_trial.h"

namespace sinew::blind {

/// One line of JSON (reference::record_line).
/// `played`: what was told once the motion asked for was played.
void record(const truth::TrialRequest& trial, const Outcome& outcome,
            const Outcome* played = nullptr);

}  // namespace sinew::blind
