// SPDX-License-Identifier: GPL-3.0-or-later
// Errors in units of the last place of the true result.
#pragma once

#include <algorithm>
#include <cmath>

namespace sinew {

// |computed - exact| in ulp of a float at `exact`; infinite where computed is not finite. Results
// in the subnormal range are measured in its fixed unit.
inline double ulp_error(float computed, double exact) {
  if (!std::isfinite(computed)) return HUGE_VAL;
  const int exponent = exact == 0 ? -126 : std::max(std::ilogb(exact), -126);
  return std::ldexp(std::fabs(static_cast<double>(computed) - exact), 23 - exponent);
}

}  // namespace sinew
