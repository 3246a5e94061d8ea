/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Bits, selection and the functions that need nothing else, for the current precision. Selections
 * are made with masks of bits: a compiler may turn a ?: on floating point into a jump, and does.
 */

SINEW_INLINE SINEW_BITS SINEW_NAME(sinew_bits)(SINEW_REAL x) {
    union {
        SINEW_REAL real;
        SINEW_BITS bits;
    } both;
    both.real = x;
    return both.bits;
}

SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_from_bits)(SINEW_BITS bits) {
    union {
        SINEW_REAL real;
        SINEW_BITS bits;
    } both;
    both.bits = bits;
    return both.real;
}

/* All ones where the top bit is set, else zero. */
SINEW_INLINE SINEW_BITS SINEW_NAME(sinew_spread)(SINEW_BITS bits) {
    SINEW_BITS mask = (SINEW_BITS)0 - (bits >> SINEW_SIGN_SHIFT);
#ifdef __clang__
    /* Without this clang recognises the selection behind the mask and makes it a jump. */
    __asm__("" : "+r"(mask));
#endif
    return mask;
}

/* The smaller of two integers that both have the top bit clear. */
SINEW_INLINE SINEW_BITS SINEW_NAME(sinew_smaller_bits)(SINEW_BITS a, SINEW_BITS b) {
    return a + ((b - a) & SINEW_NAME(sinew_spread)(b - a));
}

/* a where the mask is all ones, b where it is zero. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_blend)(SINEW_BITS mask, SINEW_REAL a, SINEW_REAL b) {
    const SINEW_BITS other = SINEW_NAME(sinew_bits)(b);
    return SINEW_NAME(sinew_from_bits)(other ^ ((SINEW_NAME(sinew_bits)(a) ^ other) & mask));
}

/* Zero where x >= 0 (so also for -0), all ones where x < 0 or NaN; x <= limit is asked for too, where
 * limit is the largest number allowed, as bits. */
SINEW_INLINE SINEW_BITS SINEW_NAME(sinew_outside)(SINEW_REAL x, SINEW_BITS limit) {
    const SINEW_BITS bits = SINEW_NAME(sinew_bits)(x + SINEW_LITERAL(0.0));
    return SINEW_NAME(sinew_spread)((limit - bits) | bits);
}

SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_abs)(SINEW_REAL x) {
    return SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(x) & ~(SINEW_BITS)SINEW_SIGN);
}

/* condition >= 0 ? a : b; b where the condition is NaN. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_choose)(SINEW_REAL condition, SINEW_REAL a, SINEW_REAL b) {
    return SINEW_NAME(sinew_blend)(SINEW_NAME(sinew_outside)(condition, SINEW_EXPONENT), b, a);
}

/* a where a < b, else b (so b where either is NaN), as one instruction of most processors does it. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_min)(SINEW_REAL a, SINEW_REAL b) {
    return SINEW_NAME(sinew_blend)((SINEW_BITS)0 - (SINEW_BITS)(a < b), a, b);
}

SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_max)(SINEW_REAL a, SINEW_REAL b) {
    return SINEW_NAME(sinew_blend)((SINEW_BITS)0 - (SINEW_BITS)(a > b), a, b);
}

/* x; zero where x is NaN or infinite. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_finite)(SINEW_REAL x) {
    const SINEW_BITS bits = SINEW_NAME(sinew_bits)(x);
    const SINEW_BITS size = bits & ~(SINEW_BITS)SINEW_SIGN;
    return SINEW_NAME(sinew_from_bits)(bits & ~SINEW_NAME(sinew_spread)(SINEW_LARGEST - size));
}

/* Square root, correctly rounded; zero where x is negative, NaN or infinite. */
SINEW_INLINE SINEW_REAL SINEW_NAME(sinew_sqrt)(SINEW_REAL x) {
    const SINEW_BITS keep = ~SINEW_NAME(sinew_outside)(x, SINEW_LARGEST);
    return SINEW_SQRT(SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(x) & keep));
}
