// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace sinew {

/// The rational number that the shortest decimal text of `value` stands for: 0.042 gives 21/500,
/// not the nearest binary fraction, so that derived constants are exact until they are emitted.
/// Throws std::invalid_argument if `value` is not finite.
GiNaC::numeric exact_number(double value);

/// √square as a rational number, exact where it is one, else correct to 60 digits: a constant that
/// is rounded once, when it is emitted. Throws std::invalid_argument if `square` is negative.
GiNaC::numeric rational_root(const GiNaC::numeric& square);

/// A real constant expression, for instance cos(3/10), as a rational number correct to 60 digits.
/// Throws std::invalid_argument if it has no real value.
GiNaC::numeric rational_value(const GiNaC::ex& constant);

}  // namespace sinew
