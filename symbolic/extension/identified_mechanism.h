// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "symbolic/extension/identified.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// The mechanism with the payloads and the gravity that logs taught:
///   payload at "link <body>": mass [kg], first_moment_x.. [kg m] and moment_xx.. [kg m^2] about
///   the body frame's origin, added to the body; gravity at "base": gravity_change_x.. [m/s^2].
/// Throws std::invalid_argument for a body that is not there or whose mass would not be positive.
Mechanism with_identified(Mechanism mechanism, const Identified& identified);

/// Whether the entry is one of the two above.
bool changes_mechanism(const IdentifiedEffect& entry);

}  // namespace sinew
