/* SPDX-License-Identifier: BSD-2-Clause
 *
 * exp, log and tanh for the current precision.
 */

/* exp(x) = 2^k (1 + p) for |x| up to the limit; returns 2^k. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_exp_parts)(SINEW_REAL x, SINEW_REAL *p) {
    const SINEW_REAL rounded = x * SINEW_LOG2E + SINEW_INTEGER_ROUND;
    const SINEW_REAL k = rounded - SINEW_INTEGER_ROUND;
    const SINEW_REAL first = x - k * SINEW_LN2_1;
    const SINEW_REAL second = k * SINEW_LN2_2;
    const SINEW_REAL r = first - second;
    const SINEW_REAL tail = (first - r) - second;
    *p = r + ((r * r) * SINEW_EXP_POLYNOMIAL(r) + tail);
    return SINEW_NAME(sinew_from_bits)(
        (SINEW_NAME(sinew_bits)(rounded) << SINEW_MANTISSA_WIDTH) + SINEW_ONE_BITS);
}

/* exp(x), |x| <= 708 (float: 87); beyond, and for NaN, the value at the nearer end. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_exp)(SINEW_REAL x) {
    const SINEW_BITS bits = SINEW_NAME(sinew_bits)(x);
    const SINEW_BITS size = SINEW_NAME(sinew_smaller_bits)(bits & ~(SINEW_BITS)SINEW_SIGN,
                                                           SINEW_EXP_LIMIT_BITS);
    SINEW_REAL p;
    const SINEW_REAL power = SINEW_NAME(sinew_exp_parts)(
        SINEW_NAME(sinew_from_bits)(size | (bits & SINEW_SIGN)), &p);
    return (SINEW_LITERAL(1.0) + p) * power;
}

/* tanh(x); +-1 to within the rounding beyond |x| = 20 (float: 10), and for NaN. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_tanh)(SINEW_REAL x) {
    const SINEW_BITS bits = SINEW_NAME(sinew_bits)(x);
    const SINEW_REAL size = SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_smaller_bits)(
        bits & ~(SINEW_BITS)SINEW_SIGN, SINEW_TANH_LIMIT_BITS));
    SINEW_REAL p;
    const SINEW_REAL power = SINEW_NAME(sinew_exp_parts)(size + size, &p);
    const SINEW_REAL excess = power * p + (power - SINEW_LITERAL(1.0)); /* exp(2 |x|) - 1 */
    const SINEW_REAL value = excess / (excess + SINEW_LITERAL(2.0));
    return SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(value) | (bits & SINEW_SIGN));
}

/* Natural logarithm of a positive normal number. Zero, negative and subnormal numbers count as the
 * smallest normal one, infinity and positive NaN as the largest. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_log)(SINEW_REAL x) {
    const SINEW_BITS bits = SINEW_NAME(sinew_bits)(x);
    const SINEW_BITS positive = SINEW_NAME(sinew_smaller_bits)(
        bits & ~SINEW_NAME(sinew_spread)(bits), SINEW_LARGEST);
    const SINEW_BITS normal = (SINEW_BITS)(SINEW_LARGEST -
        SINEW_NAME(sinew_smaller_bits)(SINEW_LARGEST - positive,
                                       SINEW_LARGEST - SINEW_SMALLEST_NORMAL));

    /* x = 2^k (1 + f) with sqrt(1/2) <= 1 + f < sqrt(2); k becomes a number without a conversion. */
    const SINEW_BITS shifted = normal + (SINEW_BITS)(SINEW_ONE_BITS - SINEW_SQRT_HALF_BITS);
    const SINEW_REAL k = SINEW_NAME(sinew_from_bits)((shifted >> SINEW_MANTISSA_WIDTH) |
                                                     SINEW_INTEGER_BITS) - SINEW_INTEGER_AND_BIAS;
    const SINEW_REAL f = SINEW_NAME(sinew_from_bits)((shifted & SINEW_MANTISSA) +
                                                     SINEW_SQRT_HALF_BITS) - SINEW_LITERAL(1.0);

    /* With s = f/(2 + f): log(1 + f) = 2 s + s R = f - (f^2/2 - s (f^2/2 + R)). */
    const SINEW_REAL s = f / (SINEW_LITERAL(2.0) + f);
    const SINEW_REAL z = s * s;
    const SINEW_REAL half_square = SINEW_LITERAL(0.5) * f * f;
    const SINEW_REAL rest = s * (half_square + z * SINEW_LOG_POLYNOMIAL(z)) + k * SINEW_LN2_2;
    return k * SINEW_LN2_1 - ((half_square - rest) - f);
}
