// SPDX-License-Identifier: GPL-3.0-or-later
// True values of elementary functions to 60 digits, by MPFR, and errors of doubles against them.
#pragma once

#include <mpfr.h>

namespace sinew {

using ExactFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using ExactFunctionOfTwo = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

// |computed - function(x)| in ulp of a double at the true value; infinite where computed is not
// finite.
double ulp_error(double computed, ExactFunction function, double x);
double ulp_error(double computed, ExactFunctionOfTwo function, double y, double x);

}  // namespace sinew
