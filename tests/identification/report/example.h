// SPDX-License-Identifier: GPL-3.0-or-later
// Findings as a diagnosis may end with, made up: what reports are tested with.
#pragma once

#include "identification/report/findings.h"

namespace sinew::diagnosis::example {

/// A linear drive: four causes, one with a phase for each log, data faults, an adopted extension.
Findings rich_drive();

/// A robot's joint: payload or torque gain, which one joint alone cannot tell.
Findings inseparable_pair();

/// One cause with its term in the model, judged on a held-out log: what it gains is what all gain.
Findings lone_cause();

/// A joint held still, whose error is nothing to explain, and plots with axes of all kinds.
Findings awkward_numbers();

/// A cause without a name, an extension refused.
Findings none_of_the_known();

/// A model that is right.
Findings nothing_beyond_noise();

/// Many channels, three causes on several tendons, long names, 60 s at 3 kHz.
Findings large_finger();

/// Default-constructed but for its model: every list empty.
Findings empty();

/// What can go wrong in a field: markup, quotes, invalid UTF-8, NaN and infinity everywhere.
Findings hostile();

}  // namespace sinew::diagnosis::example
