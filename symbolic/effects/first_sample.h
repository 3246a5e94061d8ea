// SPDX-License-Identifier: GPL-3.0-or-later
// Where an effect's states begin, which are all zero before the first sample.
#pragma once

#include "symbolic/effects/effect.h"

namespace sinew {

/// 1 at a log's first sample, 0 at all others: by a state that `effect` is given.
GiNaC::ex first_sample(Effect& effect);

}  // namespace sinew
