// SPDX-License-Identifier: GPL-3.0-or-later
// How the friction of an effect turns with the motion, where the model's own turns with the speed.
#pragma once

#include "symbolic/effects/effect.h"

namespace sinew {

/// The direction of friction of an effect, -1..1, with a shape parameter "turning_share": below
/// which share of the model's own turning speed it turns. At 1 it turns as the model's Coulomb
/// friction does, near 0 as soon as the motion does. What the model's law over the speed says of
/// its own friction it does not say of another one. Where friction turns on bristles, 1.
GiNaC::ex turning_direction(Effect& effect);

}  // namespace sinew
