// SPDX-License-Identifier: GPL-3.0-or-later
// A planned motion as a file that a controller can play.
#pragma once

#include <string>

#include "identification/adoption/diagnose.h"

namespace sinew::diagnosis {

/// CSV: time [s], <position>_ref of every joint, and the load where one belongs to it. Cells as
/// those of logs (docs/logs.md).
std::string motion_text(const PlannedMotion& motion, const DrivenChannels& channels);

}  // namespace sinew::diagnosis
