// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/model.h"

namespace sinew {

/// Text of <model>.h: documented prototypes with sizes, units, ranges and operation counts.
std::string emit_header(const EmittedModel& model);

}  // namespace sinew
