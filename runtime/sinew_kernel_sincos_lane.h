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
SINEW_INLINE void SINEW_LANE_NAME(sinew_sincos_lane)(const SINEW_LANE_REAL *x, SINEW_LANE_REAL *s,
                                                     SINEW_LANE_REAL *c) {
    const SINEW_BITS bounded = ~(SINEW_BITS)SINEW_TOP_EXPONENT_BIT;
    const SINEW_LANE_REAL turns =
        SINEW_LANE_TO_REAL(SINEW_LANE_TO_BITS(*x * SINEW_TURN) & bounded);
    const SINEW_LANE_REAL rounded = turns + SINEW_ROUND;
    const SINEW_LANE_BITS quadrant = SINEW_LANE_TO_BITS(rounded);
    const SINEW_LANE_REAL k = rounded - SINEW_ROUND;

    const SINEW_LANE_REAL first =
        SINEW_LANE_TO_REAL(SINEW_LANE_TO_BITS(*x - k * SINEW_PIO2_1) & bounded);
    const SINEW_LANE_REAL second = k * SINEW_PIO2_2;
    const SINEW_LANE_REAL r = first - second;
    const SINEW_LANE_REAL tail = ((first - r) - second) - k * SINEW_PIO2_3;

    /* sin(r + tail) = sin r + tail, cos(r + tail) = cos r - r tail: the tail is below 2^-54. */
    const SINEW_LANE_REAL z = r * r;
    const SINEW_LANE_REAL sine = r + ((r * z) * SINEW_SIN_POLYNOMIAL(z) + tail);
    const SINEW_LANE_REAL cosine =
        SINEW_LITERAL(1.0) + (z * (SINEW_LITERAL(-0.5) + z * SINEW_COS_POLYNOMIAL(z)) - r * tail);

    /* Even k: (sine, cosine), odd k: (cosine, -sine); both negated when the second bit is set. */
    const SINEW_LANE_BITS even = (quadrant & 1U) - 1U;
    const SINEW_LANE_BITS half_turn = (quadrant << (SINEW_SIGN_SHIFT - 1)) & SINEW_SIGN;
    const SINEW_LANE_BITS turned_sine = SINEW_LANE_TO_BITS(sine) ^ (quadrant << SINEW_SIGN_SHIFT);
    const SINEW_LANE_BITS upright_cosine = SINEW_LANE_TO_BITS(cosine);
    const SINEW_LANE_BITS exchange = ((turned_sine ^ upright_cosine) & even) ^ half_turn;
    *s = SINEW_LANE_TO_REAL(upright_cosine ^ exchange);
    *c = SINEW_LANE_TO_REAL(turned_sine ^ exchange);
}
