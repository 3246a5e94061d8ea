/* SPDX-License-Identifier: BSD-2-Clause
 *
 * sincos for the current precision, in one lane and, where the compiler has vectors, in two and four.
 */
#define SINEW_LANE_REAL SINEW_REAL
#define SINEW_LANE_BITS SINEW_BITS
#define SINEW_LANE_TO_BITS(x) SINEW_NAME(sinew_bits)(x)
#define SINEW_LANE_TO_REAL(x) SINEW_NAME(sinew_from_bits)(x)
#define SINEW_LANE_NAME(name) SINEW_NAME(name)
#include "sinew_kernel_sincos_lane.h"
#undef SINEW_LANE_REAL
#undef SINEW_LANE_BITS
#undef SINEW_LANE_TO_BITS
#undef SINEW_LANE_TO_REAL
#undef SINEW_LANE_NAME

/* Sine and cosine of one angle in radians. |x| <= 256 pi; beyond, and for NaN and infinity, some
 * finite values of at most 1.001. */
SINEW_INLINE void SINEW_NAME(sinew_sincos)(SINEW_REAL x, SINEW_REAL *s, SINEW_REAL *c) {
    SINEW_NAME(sinew_sincos_lane)(&x, s, c);
}
