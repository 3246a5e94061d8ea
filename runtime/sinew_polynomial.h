/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Polynomials by Horner's rule, coefficients from the constant upwards. The number of operations
 * depends on the degree alone.
 */
#ifndef SINEW_POLYNOMIAL_H
#define SINEW_POLYNOMIAL_H

#include "sinew_limits.h"

#ifdef __cplusplus
extern "C" {
#endif

/* c[0] + c[1] x + ... + c[degree] x^degree; degree >= 0. */
static inline double sinew_polynomial(const double *c, int degree, double x) {
    double value = c[degree];
    for (int i = degree - 1; i >= 0; --i) value = value * x + c[i];
    return value;
}

/* Its derivative by x; 0 for degree 0. */
static inline double sinew_polynomial_slope(const double *c, int degree, double x) {
    double value = 0.0;
    for (int i = degree; i >= 1; --i) value = value * x + (double)i * c[i];
    return value;
}

/* (x - centre) / half_range, held at -1 and 1 outside; 0 for NaN. `inverse` is 1 / half_range.
 * What a polynomial that was fitted over a range is evaluated at. */
static inline double sinew_normalised(double x, double centre, double inverse) {
    const double u = (x - centre) * inverse;
    return sinew_magnitude(u) <= 1.0 ? u : sinew_limited(u, -1.0, 1.0, 0.0);
}

#ifdef __cplusplus
}
#endif
#endif
