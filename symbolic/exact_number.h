// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace sinew {

/// The rational number that the shortest decimal text of `value` stands for: 0.042 gives 21/500,
/// not the nearest binary fraction, so that derived constants are exact until they are emitted.
/// Throws std::invalid_argument if `value` is not finite.
GiNaC::numeric exact_number(double value);

}  // namespace sinew
