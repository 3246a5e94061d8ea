// SPDX-License-Identifier: GPL-3.0-or-later
// The bristle that friction hangs on before it slips (Dahl): shared by effects with pre-sliding.
#pragma once

#include "symbolic/effects/effect.h"

namespace sinew {

/// Adds the bristle's state, -1..1, to the effect and gives its value at the end of a sample: exact
/// at constant speed, it runs to the direction of motion over `length` [as the place's position].
GiNaC::ex add_bristle(const GiNaC::ex& length, Effect& effect);

/// A tendon creeps in its guide for a short way behind a reversal before it slips: the effect's
/// columns follow the bristle in the place of the direction of motion. Its length becomes a shape.
void creep_in_guide(Effect& effect);

}  // namespace sinew
