/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Inverse trigonometric functions for the current precision.
 */

/* a b - c for c close to a b, without fused multiply-add: both factors are cut into halves whose
 * products are exact. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_product_error)(SINEW_REAL a, SINEW_REAL b, SINEW_REAL c) {
    const SINEW_REAL a1 =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(a) & SINEW_UPPER_HALF);
    const SINEW_REAL b1 =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(b) & SINEW_UPPER_HALF);
    const SINEW_REAL a2 = a - a1;
    const SINEW_REAL b2 = b - b1;
    return (((a1 * b1 - c) + a1 * b2) + a2 * b1) + a2 * b2;
}

/* Angle of the vector (x, y) in radians, -pi to pi. Infinities and NaN count as the largest number;
 * (0, 0) gives 0 or pi with the signs of y and x as usual. Meant for 2^-1022 <= max(|x|, |y|) <
 * 2^1023 (float: 2^-126, 2^127). */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_atan2)(SINEW_REAL y, SINEW_REAL x) {
    const SINEW_BITS y_bits = SINEW_NAME(sinew_bits)(y);
    const SINEW_BITS x_bits = SINEW_NAME(sinew_bits)(x);
    const SINEW_BITS height = SINEW_NAME(sinew_smaller_bits)(y_bits & ~(SINEW_BITS)SINEW_SIGN,
                                                             SINEW_LARGEST_RATIO_PART);
    const SINEW_BITS width = SINEW_NAME(sinew_smaller_bits)(x_bits & ~(SINEW_BITS)SINEW_SIGN,
                                                            SINEW_LARGEST_RATIO_PART);

    /* 0 <= n <= d and d in [1, 2). */
    const SINEW_BITS steep = SINEW_NAME(sinew_spread)(width - height);
    const SINEW_BITS exchange = (width ^ height) & steep;
    const SINEW_BITS larger = width ^ exchange;
    const SINEW_REAL scale = SINEW_NAME(sinew_from_bits)(
        (SINEW_BITS)(SINEW_EXPONENT - SINEW_SMALLEST_NORMAL) - (larger & SINEW_EXPONENT));
    const SINEW_REAL n = SINEW_NAME(sinew_from_bits)(height ^ exchange) * scale;
    const SINEW_REAL d = SINEW_NAME(sinew_from_bits)(
        SINEW_NAME(sinew_bits)(SINEW_NAME(sinew_from_bits)(larger) * scale) | SINEW_ONE_BITS);

    /* Above pi/8 turn back by pi/4: (n - d)/(n + d), with what the sum and the difference lose. */
    const SINEW_BITS middle = ~SINEW_NAME(sinew_spread)(
        SINEW_NAME(sinew_bits)(n - SINEW_TAN_PIO8 * d));
    const SINEW_REAL d_turned = SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(d) & middle);
    const SINEW_REAL n_turned = SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(n) & middle);
    const SINEW_REAL upper = n - d_turned;
    const SINEW_REAL lower = d + n_turned;
    const SINEW_REAL upper_rest = n - (upper + d_turned);
    const SINEW_REAL lower_rest = n_turned - (lower - d);

    const SINEW_REAL reciprocal = SINEW_LITERAL(1.0) / lower;
    const SINEW_REAL t = upper * reciprocal;
    const SINEW_REAL rest = (upper_rest - t * lower_rest) -
                            SINEW_NAME(sinew_product_error)(t, lower, upper);
    const SINEW_REAL z = t * t;
    const SINEW_REAL t_rest = rest * reciprocal;
    const SINEW_REAL small = (t * z) * SINEW_ATAN_POLYNOMIAL(z) + (t_rest - t_rest * z);

    /* The angle is m pi/4 +- atan(t), m counted in quadrants from the x axis. */
    const SINEW_BITS backward = SINEW_NAME(sinew_spread)(x_bits);
    const SINEW_BITS turned = (steep ^ backward) & SINEW_SIGN;
    const SINEW_REAL eighths =
        SINEW_NAME(sinew_from_bits)(SINEW_TWO_BITS & steep) +
        SINEW_NAME(sinew_from_bits)((SINEW_ONE_BITS & middle) ^ (SINEW_SIGN & steep));
    const SINEW_REAL m =
        SINEW_NAME(sinew_from_bits)(SINEW_FOUR_BITS & backward) +
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(eighths) ^ (SINEW_SIGN & backward));
    const SINEW_REAL base = m * SINEW_PIO4_1;
    const SINEW_REAL step = SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(t) ^ turned);
    const SINEW_REAL small_step =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(small) ^ turned);
    const SINEW_REAL sum = base + step;
    const SINEW_REAL lost = (base - sum) + step;
    const SINEW_REAL angle = sum + (lost + (m * SINEW_PIO4_2 + small_step));
    return SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(angle) ^ (y_bits & SINEW_SIGN));
}

/* Any x; infinities and NaN give +-pi/2 to within the rounding. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_atan)(SINEW_REAL x) {
    return SINEW_NAME(sinew_atan2)(x, SINEW_LITERAL(1.0));
}

/* What asin and acos share. With a = min(|x|, 1): asin a = w + rest where a <= 1/2, else
 * acos a = 2 (w + rest) with w = sqrt((1 - a)/2). Returns all ones in the second case. */
SINEW_INLINE SINEW_BITS SINEW_NAME(sinew_arc_sine)(SINEW_REAL x, SINEW_REAL *w, SINEW_REAL *rest) {
    const SINEW_REAL a = SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_smaller_bits)(
        SINEW_NAME(sinew_bits)(x) & ~(SINEW_BITS)SINEW_SIGN, SINEW_ONE_BITS));
    const SINEW_BITS outer =
        SINEW_NAME(sinew_spread)(SINEW_NAME(sinew_bits)(SINEW_LITERAL(0.5) - a));
    const SINEW_REAL z = SINEW_NAME(sinew_blend)(
        outer, SINEW_LITERAL(0.5) - SINEW_LITERAL(0.5) * a, a * a);
    const SINEW_REAL root = SINEW_SQRT(z);
    /* Where the root was rounded: sqrt(z) = root - (root^2 - z)/(2 root); the small constant keeps
     * 0/0 away at |x| = 1. */
    const SINEW_REAL lost = SINEW_NAME(sinew_product_error)(root, root, z) /
                            (root + root + SINEW_NAME(sinew_from_bits)(SINEW_SMALLEST_NORMAL));
    const SINEW_REAL correction =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(lost) & outer);
    *w = SINEW_NAME(sinew_blend)(outer, root, a);
    *rest = (*w * z) * SINEW_ASIN_POLYNOMIAL(z) - correction;
    return outer;
}

/* -pi/2 to pi/2; |x| > 1 and NaN count as +-1. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_asin)(SINEW_REAL x) {
    SINEW_REAL w;
    SINEW_REAL rest;
    const SINEW_BITS outer = SINEW_NAME(sinew_arc_sine)(x, &w, &rest);
    const SINEW_REAL m = SINEW_NAME(sinew_from_bits)(SINEW_TWO_BITS & outer);
    const SINEW_REAL factor =
        SINEW_NAME(sinew_blend)(outer, SINEW_LITERAL(-2.0), SINEW_LITERAL(1.0));
    const SINEW_REAL base = m * SINEW_PIO4_1;
    const SINEW_REAL sum = base + factor * w;
    const SINEW_REAL lost = (base - sum) + factor * w;
    const SINEW_REAL angle = sum + (lost + (m * SINEW_PIO4_2 + factor * rest));
    const SINEW_BITS sign = SINEW_NAME(sinew_bits)(x) & SINEW_SIGN;
    return SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(angle) ^ sign);
}

/* 0 to pi; |x| > 1 and NaN count as +-1. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_acos)(SINEW_REAL x) {
    SINEW_REAL w;
    SINEW_REAL rest;
    const SINEW_BITS outer = SINEW_NAME(sinew_arc_sine)(x, &w, &rest);
    const SINEW_BITS sign = SINEW_NAME(sinew_bits)(x) & SINEW_SIGN;
    /* Inner: pi/2 - asin x. Outer: 2 asin w, or pi minus it for negative x. */
    const SINEW_BITS eighths = (SINEW_TWO_BITS & ~outer) |
                               (SINEW_FOUR_BITS & outer & SINEW_NAME(sinew_spread)(sign));
    const SINEW_REAL m = SINEW_NAME(sinew_from_bits)(eighths);
    const SINEW_REAL factor =
        SINEW_NAME(sinew_blend)(outer, SINEW_LITERAL(2.0), SINEW_LITERAL(-1.0));
    const SINEW_REAL turned =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(factor) ^ sign);
    const SINEW_REAL base = m * SINEW_PIO4_1;
    const SINEW_REAL sum = base + turned * w;
    const SINEW_REAL lost = (base - sum) + turned * w;
    return sum + (lost + (m * SINEW_PIO4_2 + turned * rest));
}
