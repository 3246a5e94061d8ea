/* SPDX-License-Identifier: BSD-2-Clause
 *
 * sincos over one lane type: a number, or a vector of numbers.
 *
 * With k the nearest integer to x 2/pi and r + tail = x - k pi/2, |r| <= pi/4, sin and cos of r are
 * polynomials in r^2, which then change places when k is odd and change signs by the two lowest
 * bits of k. Adding a large constant rounds to k and leaves k in the lowest bits of the sum.
 *
 * No input needs a comparison: x 2/pi 2^-8 and the remainder are below 2 whenever x is in range, so
 * the top bit of their exponents is clear; clearing it anyway makes everything else finite too.
 */

/* Sine and cosine of k pi/2 + r + tail, where the two lowest bits of quadrant are those of k. */
SINEW_INLINE void SINEW_LANE_NAME(sinew_sincos_rest)(
    SINEW_LANE_TABLE_PARAMETER const SINEW_LANE_REAL *remainder, const SINEW_LANE_REAL *rest,
    const SINEW_LANE_BITS *integer, SINEW_LANE_REAL *s, SINEW_LANE_REAL *c) {
    const SINEW_LANE_REAL r = *remainder;
    const SINEW_LANE_REAL tail = *rest;
    const SINEW_LANE_BITS quadrant = *integer;

    /* 1 - z/2 is rounded, but what it loses is known exactly; |tail| <= 2^-54 (float: 2^-25). */
    const SINEW_LANE_REAL z = r * r;
    const SINEW_LANE_REAL half_square = z * SINEW_LANE_CONSTANT(HALF);
    const SINEW_LANE_REAL most = SINEW_LANE_CONSTANT(ONE) - half_square;
    const SINEW_LANE_REAL lost = (SINEW_LANE_CONSTANT(ONE) - most) - half_square;
    const SINEW_LANE_REAL sine = r + ((r * z) * SINEW_SIN_POLYNOMIAL(z) + tail * most);
    const SINEW_LANE_REAL cosine = most + (lost + ((z * z) * SINEW_COS_POLYNOMIAL(z) - r * tail));

    /* Even k: (sine, cosine), odd k: (cosine, -sine); both negated when the second bit is set. */
    const SINEW_LANE_BITS even =
        (quadrant & SINEW_LANE_TO_BITS(SINEW_LANE_CONSTANT(LOWEST_BIT))) - 1U;
    const SINEW_LANE_BITS half_turn = (quadrant << (SINEW_SIGN_SHIFT - 1)) &
                                      SINEW_LANE_TO_BITS(SINEW_LANE_CONSTANT(SIGN_MASK));
    const SINEW_LANE_BITS turned_sine = SINEW_LANE_TO_BITS(sine) ^ (quadrant << SINEW_SIGN_SHIFT);
    const SINEW_LANE_BITS upright_cosine = SINEW_LANE_TO_BITS(cosine);
    const SINEW_LANE_BITS exchange = ((turned_sine ^ upright_cosine) & even) ^ half_turn;
    *s = SINEW_LANE_TO_REAL(upright_cosine ^ exchange);
    *c = SINEW_LANE_TO_REAL(turned_sine ^ exchange);
}

SINEW_INLINE void SINEW_LANE_NAME(sinew_sincos)(const SINEW_LANE_REAL *x, SINEW_LANE_REAL *s,
                                                SINEW_LANE_REAL *c) {
    SINEW_LANE_TABLE
    const SINEW_LANE_BITS bounded = SINEW_LANE_TO_BITS(SINEW_LANE_CONSTANT(BOUND));
    const SINEW_LANE_REAL turns =
        SINEW_LANE_TO_REAL(SINEW_LANE_TO_BITS(*x * SINEW_LANE_CONSTANT(TURN)) & bounded);
    const SINEW_LANE_REAL rounded = turns + SINEW_LANE_CONSTANT(ROUND);
    const SINEW_LANE_BITS quadrant = SINEW_LANE_TO_BITS(rounded);
    const SINEW_LANE_REAL k = rounded - SINEW_LANE_CONSTANT(ROUND);

    const SINEW_LANE_REAL remainder = *x - k * SINEW_LANE_CONSTANT(PIO2_1);
    const SINEW_LANE_REAL first = SINEW_LANE_TO_REAL(SINEW_LANE_TO_BITS(remainder) & bounded);
    const SINEW_LANE_REAL second = k * SINEW_LANE_CONSTANT(PIO2_2);
    const SINEW_LANE_REAL r = first - second;
    const SINEW_LANE_REAL tail = ((first - r) - second) - k * SINEW_LANE_CONSTANT(PIO2_3);
    SINEW_LANE_NAME(sinew_sincos_rest)(SINEW_LANE_TABLE_ARGUMENT &r, &tail, &quadrant, s, c);
}
