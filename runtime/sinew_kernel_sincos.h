/* SPDX-License-Identifier: BSD-2-Clause
 *
 * sincos for the current precision, in one lane and, where the compiler has vectors, in two and four.
 */
#define SINEW_LANE_REAL SINEW_REAL
#define SINEW_LANE_BITS SINEW_BITS
#define SINEW_LANE_TO_BITS(x) SINEW_NAME(sinew_bits)(x)
#define SINEW_LANE_TO_REAL(x) SINEW_NAME(sinew_from_bits)(x)
#define SINEW_LANE_NAME(name) SINEW_NAME(name##_lane)
#define SINEW_LANE_TABLE
#define SINEW_LANE_TABLE_PARAMETER
#define SINEW_LANE_TABLE_ARGUMENT
#define SINEW_LANE_CONSTANT(name) SINEW_##name
#include "sinew_kernel_sincos_lane.h"

/* Sine and cosine of one angle in radians, |x| <= 800; beyond, and for NaN and infinity, some
 * finite values of at most 1.001. */
SINEW_INLINE void SINEW_NAME(sinew_sincos)(SINEW_REAL x, SINEW_REAL *s, SINEW_REAL *c) {
    SINEW_NAME(sinew_sincos_lane)(&x, s, c);
}

/* The same for |x| <= 2^20 (float: 2^12), at the price of nine more operations. */
SINEW_INLINE void SINEW_NAME(sinew_sincos_wide)(SINEW_REAL x, SINEW_REAL *s, SINEW_REAL *c) {
    const SINEW_BITS bounded = ~(SINEW_BITS)SINEW_TOP_EXPONENT_BIT;
    const SINEW_REAL turns =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(x * SINEW_WIDE_TURN) & bounded);
    const SINEW_REAL rounded = turns + SINEW_WIDE_ROUND;
    const SINEW_BITS quadrant = SINEW_NAME(sinew_bits)(rounded);
    const SINEW_REAL k = rounded - SINEW_WIDE_ROUND;

    /* Every product but the last is exact; each difference is kept with what it loses. */
    const SINEW_REAL first =
        SINEW_NAME(sinew_from_bits)(SINEW_NAME(sinew_bits)(x - k * SINEW_WIDE_PIO2_1) & bounded);
    const SINEW_REAL second = k * SINEW_WIDE_PIO2_2;
    const SINEW_REAL r2 = first - second;
    const SINEW_REAL lost2 = (first - r2) - second;
    const SINEW_REAL third = k * SINEW_WIDE_PIO2_3;
    const SINEW_REAL r3 = r2 - third;
    const SINEW_REAL lost3 = (r2 - r3) - third;
    const SINEW_REAL fourth = k * SINEW_WIDE_PIO2_4;
    const SINEW_REAL r4 = r3 - fourth;
    const SINEW_REAL lost4 = (r3 - r4) - fourth;
    const SINEW_REAL tail = ((lost2 + lost3) + lost4) - k * SINEW_WIDE_PIO2_5;
    SINEW_NAME(sinew_sincos_rest_lane)(&r4, &tail, &quadrant, s, c);
}

#ifdef SINEW_VECTORS

#undef SINEW_LANE_REAL
#undef SINEW_LANE_BITS
#undef SINEW_LANE_TO_BITS
#undef SINEW_LANE_TO_REAL
#undef SINEW_LANE_NAME
#undef SINEW_LANE_TABLE
#undef SINEW_LANE_TABLE_PARAMETER
#undef SINEW_LANE_TABLE_ARGUMENT
#undef SINEW_LANE_CONSTANT

/* Vectors of constants are read from a table whose address the compiler is not allowed to see
 * through: knowing the values, it would build each vector with an instruction of its own. */
#define SINEW_LANE_CONSTANT(name) (table->name)
#define SINEW_LANE_TABLE                                       \
    static const SINEW_LANE_CONSTANTS constants = {            \
        SINEW_SINCOS_CONSTANTS(SINEW_LANE_BROADCAST)};         \
    const SINEW_LANE_CONSTANTS *table = &constants;            \
    __asm__("" : "+r"(table));
#define SINEW_LANE_TABLE_PARAMETER const SINEW_LANE_CONSTANTS *table,
#define SINEW_LANE_TABLE_ARGUMENT table,
#define SINEW_LANE_MEMBER(name) SINEW_LANE_REAL name;

typedef SINEW_REAL SINEW_NAME(sinew_real2_) __attribute__((vector_size(2 * sizeof(SINEW_REAL))));
typedef SINEW_BITS SINEW_NAME(sinew_bits2_) __attribute__((vector_size(2 * sizeof(SINEW_REAL))));
#define SINEW_LANE_REAL SINEW_NAME(sinew_real2_)
#define SINEW_LANE_BITS SINEW_NAME(sinew_bits2_)
#define SINEW_LANE_TO_BITS(x) ((SINEW_LANE_BITS)(x))
#define SINEW_LANE_TO_REAL(x) ((SINEW_LANE_REAL)(x))
#define SINEW_LANE_NAME(name) SINEW_NAME(name##_two_lanes)
#define SINEW_LANE_CONSTANTS SINEW_NAME(sinew_sincos_constants2_)
#define SINEW_LANE_BROADCAST(name) {SINEW_##name, SINEW_##name},
typedef struct {
    SINEW_SINCOS_CONSTANTS(SINEW_LANE_MEMBER)
} SINEW_LANE_CONSTANTS;
#include "sinew_kernel_sincos_lane.h"

#undef SINEW_LANE_REAL
#undef SINEW_LANE_BITS
#undef SINEW_LANE_NAME
#undef SINEW_LANE_CONSTANTS
#undef SINEW_LANE_BROADCAST
typedef SINEW_REAL SINEW_NAME(sinew_real4_) __attribute__((vector_size(4 * sizeof(SINEW_REAL))));
typedef SINEW_BITS SINEW_NAME(sinew_bits4_) __attribute__((vector_size(4 * sizeof(SINEW_REAL))));
#define SINEW_LANE_REAL SINEW_NAME(sinew_real4_)
#define SINEW_LANE_BITS SINEW_NAME(sinew_bits4_)
#define SINEW_LANE_NAME(name) SINEW_NAME(name##_four_lanes)
#define SINEW_LANE_CONSTANTS SINEW_NAME(sinew_sincos_constants4_)
#define SINEW_LANE_BROADCAST(name) {SINEW_##name, SINEW_##name, SINEW_##name, SINEW_##name},
typedef struct {
    SINEW_SINCOS_CONSTANTS(SINEW_LANE_MEMBER)
} SINEW_LANE_CONSTANTS;
#include "sinew_kernel_sincos_lane.h"

/* Two and four angles at once, bit for bit what as many calls of sincos give. */
SINEW_INLINE void SINEW_NAME(sinew_sincos2)(const SINEW_REAL *x, SINEW_REAL *s, SINEW_REAL *c) {
    const SINEW_NAME(sinew_real2_) angles = {x[0], x[1]};
    SINEW_NAME(sinew_real2_) sines;
    SINEW_NAME(sinew_real2_) cosines;
    SINEW_NAME(sinew_sincos_two_lanes)(&angles, &sines, &cosines);
    s[0] = sines[0];
    s[1] = sines[1];
    c[0] = cosines[0];
    c[1] = cosines[1];
}

SINEW_INLINE void SINEW_NAME(sinew_sincos4)(const SINEW_REAL *x, SINEW_REAL *s, SINEW_REAL *c) {
    const SINEW_NAME(sinew_real4_) angles = {x[0], x[1], x[2], x[3]};
    SINEW_NAME(sinew_real4_) sines;
    SINEW_NAME(sinew_real4_) cosines;
    SINEW_NAME(sinew_sincos_four_lanes)(&angles, &sines, &cosines);
    s[0] = sines[0];
    s[1] = sines[1];
    s[2] = sines[2];
    s[3] = sines[3];
    c[0] = cosines[0];
    c[1] = cosines[1];
    c[2] = cosines[2];
    c[3] = cosines[3];
}

#else

SINEW_INLINE void SINEW_NAME(sinew_sincos2)(const SINEW_REAL *x, SINEW_REAL *s, SINEW_REAL *c) {
    SINEW_NAME(sinew_sincos)(x[0], &s[0], &c[0]);
    SINEW_NAME(sinew_sincos)(x[1], &s[1], &c[1]);
}

SINEW_INLINE void SINEW_NAME(sinew_sincos4)(const SINEW_REAL *x, SINEW_REAL *s, SINEW_REAL *c) {
    SINEW_NAME(sinew_sincos2)(x, s, c);
    SINEW_NAME(sinew_sincos2)(x + 2, s + 2, c + 2);
}

#endif
#undef SINEW_LANE_REAL
#undef SINEW_LANE_BITS
#undef SINEW_LANE_TO_BITS
#undef SINEW_LANE_TO_REAL
#undef SINEW_LANE_NAME
#undef SINEW_LANE_TABLE
#undef SINEW_LANE_TABLE_PARAMETER
#undef SINEW_LANE_TABLE_ARGUMENT
#undef SINEW_LANE_CONSTANT
#ifdef SINEW_VECTORS
#undef SINEW_LANE_MEMBER
#undef SINEW_LANE_CONSTANTS
#undef SINEW_LANE_BROADCAST
#endif
