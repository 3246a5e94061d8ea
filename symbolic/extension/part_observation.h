// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "symbolic/extension/observation.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// What a calibration or coupling log of the part should read; nothing for parts without one.
std::optional<Observation> observation_of(const Part& part);

}  // namespace sinew
