// SPDX-License-Identifier: GPL-3.0-or-later
// Branch-free case distinctions as GiNaC functions, with numeric evaluation and derivatives.
//
// The real-time code may not branch, and GiNaC has no real-valued min and max. Where the two sides
// meet, the derivative is that of the first argument (minimum, maximum) or of `a` (choose).
#pragma once

#include <ginac/ginac.h>

namespace sinew {

/// a <= b ? a : b
DECLARE_FUNCTION_2P(minimum)

/// a >= b ? a : b
DECLARE_FUNCTION_2P(maximum)

/// condition >= 0 ? a : b
DECLARE_FUNCTION_3P(choose)

/// `value` limited to [low, high].
GiNaC::ex clamped(const GiNaC::ex& value, const GiNaC::ex& low, const GiNaC::ex& high);

/// |value|, differentiable by GiNaC as a real function (GiNaC's own abs differentiates as a complex
/// one).
GiNaC::ex magnitude(const GiNaC::ex& value);

}  // namespace sinew
