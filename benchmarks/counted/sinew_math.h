/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Stands in for the runtime where operations are counted: trigonometry counts as one call.
 */
#ifndef SINEW_COUNTED_MATH_H
#define SINEW_COUNTED_MATH_H

static inline void sinew_sincos(double x, double *s, double *c) { counted_sincos(x, s, c); }

static inline void sinew_sincos2(const double *x, double *s, double *c) {
    for (int i = 0; i < 2; ++i) counted_sincos(x[i], s + i, c + i);
}

static inline void sinew_sincos4(const double *x, double *s, double *c) {
    for (int i = 0; i < 4; ++i) counted_sincos(x[i], s + i, c + i);
}

#endif
