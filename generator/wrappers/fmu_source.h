// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sinew {

/// The C of a co-simulation unit, the same for every model; what differs is in fmu_model.h.
extern const char* const fmu_source;

}  // namespace sinew
