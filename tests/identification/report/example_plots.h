// SPDX-License-Identifier: GPL-3.0-or-later
// Made-up plots of a channel of a drive.
#pragma once

#include "identification/report/findings.h"

namespace sinew::diagnosis::example {

/// All six kinds; `samples` in time, different noise for different seeds. `after`: whether there is
/// a model after.
std::vector<Plot> drive_plots(const std::string& channel, const std::string& unit, int samples,
                              unsigned seed, bool after = true);

}  // namespace sinew::diagnosis::example
