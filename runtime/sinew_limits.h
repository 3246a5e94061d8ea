/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Limits that hold for every bit pattern, NaN and infinity included. No library call, no global.
 */
#ifndef SINEW_LIMITS_H
#define SINEW_LIMITS_H

#ifdef __cplusplus
extern "C" {
#endif

/* 1 for a finite number, 0 for NaN and the infinities. Needs IEEE arithmetic: no -ffast-math. */
static inline int sinew_is_finite(double x) {
    return x - x == 0.0;
}

/* x within low..high; `otherwise` where x is NaN. An infinity becomes the limit on its side.
 * low <= high, both and `otherwise` finite: then the result is finite. */
static inline double sinew_limited(double x, double low, double high, double otherwise) {
    if (!(x == x)) return otherwise;
    if (x < low) return low;
    return x > high ? high : x;
}

/* 1 where low <= x <= high; 0 elsewhere and for NaN. */
static inline int sinew_is_within(double x, double low, double high) {
    return x >= low && x <= high;
}

/* |x|, as one instruction where the compiler can be told so; may be -0 for -0. */
static inline double sinew_magnitude(double x) {
#ifdef __GNUC__
    return __builtin_fabs(x);
#else
    return x < 0.0 ? -x : x;
#endif
}

/* `last` moved towards `wanted` by no more than `step` >= 0. Where `wanted` is NaN: `last`. */
static inline double sinew_approached(double last, double wanted, double step) {
    return sinew_limited(wanted, last - step, last + step, last);
}

#ifdef __cplusplus
}
#endif
#endif
