/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Parameters of the kernels for double: types, layout of the bits, constants split into parts, and
 * polynomials as printed by coefficients/minimax.py. Included by sinew_math.h only; undone by
 * sinew_precision_end.h.
 */
#define SINEW_REAL double
#define SINEW_BITS uint64_t
#define SINEW_NAME(name) name
#define SINEW_LITERAL(value) value

#define SINEW_SIGN 0x8000000000000000U
#define SINEW_TOP_EXPONENT_BIT 0x4000000000000000U
#define SINEW_EXPONENT 0x7ff0000000000000U
#define SINEW_MANTISSA 0x000fffffffffffffU
#define SINEW_LARGEST 0x7fefffffffffffffU
#define SINEW_LARGEST_RATIO_PART 0x7fdfffffffffffffU
#define SINEW_ONE_BITS 0x3ff0000000000000U
#define SINEW_TWO_BITS 0x4000000000000000U
#define SINEW_FOUR_BITS 0x4010000000000000U
#define SINEW_SMALLEST_NORMAL 0x0010000000000000U
#define SINEW_SQRT_HALF_BITS 0x3fe6a09e667f3bcdU
#define SINEW_UPPER_HALF 0xfffffffff8000000U
#define SINEW_SIGN_SHIFT 63
#define SINEW_MANTISSA_WIDTH 52
#define SINEW_SQRT(x) __builtin_sqrt(x)

/* sincos: multiples k of pi/2 are kept as k 2^-8, so that |k| < 2^9 means |k 2^-8| < 2. The parts
 * of pi/2 have 44, 44 and 53 bits: k times the first two is exact. */
#define SINEW_TURN 0x1.45f306dc9c883p-9
#define SINEW_ROUND 0x1.8p44
#define SINEW_PIO2_1 0x1.921fb54442e00p+8
#define SINEW_PIO2_2 -0x1.cf72cece67600p-37
#define SINEW_PIO2_3 0x1.701b839a25205p-84

/* sincos_wide: the same with k 2^-19, |k| < 2^20, parts of 33, 33, 33, 33 and 53 bits. */
#define SINEW_WIDE_TURN 0x1.45f306dc9c883p-20
#define SINEW_WIDE_ROUND 0x1.8p33
#define SINEW_WIDE_PIO2_1 0x1.921fb544p+19
#define SINEW_WIDE_PIO2_2 0x1.0b4611a6p-15
#define SINEW_WIDE_PIO2_3 0x1.3198a2ep-50
#define SINEW_WIDE_PIO2_4 0x1.b839a252p-85
#define SINEW_WIDE_PIO2_5 0x1.27044533e63ap-123

/* sin r = r + r z (S1 + S2 z + ...), cos r = 1 - z/2 + z^2 (C1 + C2 z + ...), z = r^2 <= (pi/4)^2. */
#define SINEW_S1 -0x1.5555555555549p-3
#define SINEW_S2 0x1.111111110f87ep-7
#define SINEW_S3 -0x1.a01a019c0f026p-13
#define SINEW_S4 0x1.71de357421c57p-19
#define SINEW_S5 -0x1.ae5e62ddf7502p-26
#define SINEW_S6 0x1.5d91f139d2989p-33
#define SINEW_C1 0x1.555555555554cp-5
#define SINEW_C2 -0x1.6c16c16c1521fp-10
#define SINEW_C3 0x1.a01a019cbf61ep-16
#define SINEW_C4 -0x1.27e4f812b525bp-22
#define SINEW_C5 0x1.1ee9f15129f8cp-29
#define SINEW_C6 -0x1.8fb130035824bp-37
#define SINEW_SIN_POLYNOMIAL(z) \
    (SINEW_LANE_CONSTANT(S1) + \
     (z) * (SINEW_LANE_CONSTANT(S2) + \
     (z) * (SINEW_LANE_CONSTANT(S3) + \
     (z) * (SINEW_LANE_CONSTANT(S4) + \
     (z) * (SINEW_LANE_CONSTANT(S5) + \
     (z) * SINEW_LANE_CONSTANT(S6))))))
#define SINEW_COS_POLYNOMIAL(z) \
    (SINEW_LANE_CONSTANT(C1) + \
     (z) * (SINEW_LANE_CONSTANT(C2) + \
     (z) * (SINEW_LANE_CONSTANT(C3) + \
     (z) * (SINEW_LANE_CONSTANT(C4) + \
     (z) * (SINEW_LANE_CONSTANT(C5) + \
     (z) * SINEW_LANE_CONSTANT(C6))))))

/* Two masks and the lowest bit as numbers, and every constant of sincos, for tables of vectors. */
#define SINEW_HALF 0.5
#define SINEW_ONE 1.0
#define SINEW_BOUND -0x1.fffffffffffffp0
#define SINEW_SIGN_MASK -0.0
#define SINEW_LOWEST_BIT 0x1p-1074
#define SINEW_SINCOS_CONSTANTS(each) \
    each(TURN) each(ROUND) each(PIO2_1) each(PIO2_2) each(PIO2_3) each(HALF) each(ONE) \
    each(BOUND) each(SIGN_MASK) each(LOWEST_BIT) each(S1) each(S2) each(S3) each(S4) each(S5) \
    each(S6) each(C1) each(C2) each(C3) each(C4) each(C5) each(C6)


/* pi/4 in a part of 50 bits, of which 1 to 4 times is exact, and the rest. */
#define SINEW_PIO4_1 0x1.921fb54442d18p-1
#define SINEW_PIO4_2 0x1.1a62633145c07p-55
#define SINEW_TAN_PIO8 0x1.a827999fcef32p-2

#define SINEW_ATAN_POLYNOMIAL(z)                                                            \
    (-0x1.555555555553dp-2 +                                                                \
     (z) * (0x1.9999999995869p-3 +                                                          \
     (z) * (-0x1.24924922ad510p-3 +                                                         \
     (z) * (0x1.c71c70e60837bp-4 +                                                          \
     (z) * (-0x1.745cf8db96d2ap-4 +                                                         \
     (z) * (0x1.3b11190f38bb4p-4 +                                                          \
     (z) * (-0x1.10ebb7d3a66dep-4 +                                                         \
     (z) * (0x1.df0f46be086e4p-5 +                                                          \
     (z) * (-0x1.9cd2b06e926f0p-5 +                                                         \
     (z) * (0x1.37d58f60a6ae6p-5 + (z) * -0x1.256a290c9f4bfp-6))))))))))
#define SINEW_ASIN_POLYNOMIAL(z)                                                            \
    (0x1.5555555555577p-3 +                                                                 \
     (z) * (0x1.333333332e130p-4 +                                                          \
     (z) * (0x1.6db6db72127c5p-5 +                                                          \
     (z) * (0x1.f1c71a94e9400p-6 +                                                          \
     (z) * (0x1.6e8bdee179383p-6 +                                                          \
     (z) * (0x1.1c49f0438d770p-6 +                                                          \
     (z) * (0x1.ca1f905aa6320p-7 +                                                          \
     (z) * (0x1.7585698efc7fap-7 +                                                          \
     (z) * (0x1.613d904a35e9dp-7 +                                                          \
     (z) * (0x1.e5dea270bf37fp-9 +                                                          \
     (z) * (0x1.63a6d7552a92dp-6 +                                                          \
     (z) * (-0x1.5812fefaa3b9bp-6 + (z) * 0x1.0b5049be384cap-5))))))))))))

/* exp, log, tanh: ln 2 in a part of 42 bits and the rest. */
#define SINEW_LOG2E 0x1.71547652b82fep+0
#define SINEW_INTEGER_ROUND 0x1.8p52
#define SINEW_LN2_1 0x1.62e42fefa3800p-1
#define SINEW_LN2_2 0x1.ef35793c76730p-45
#define SINEW_EXP_LIMIT_BITS 0x4086200000000000U
#define SINEW_TANH_LIMIT_BITS 0x4034000000000000U
#define SINEW_INTEGER_BITS 0x4330000000000000U
#define SINEW_INTEGER_AND_BIAS 0x1.00000000003ffp52

#define SINEW_EXP_POLYNOMIAL(r)                                                             \
    (0x1.0000000000000p-1 +                                                                 \
     (r) * (0x1.5555555555557p-3 +                                                          \
     (r) * (0x1.5555555555558p-5 +                                                          \
     (r) * (0x1.11111111100dcp-7 +                                                          \
     (r) * (0x1.6c16c16c151dep-10 +                                                         \
     (r) * (0x1.a01a01abe7f0bp-13 +                                                         \
     (r) * (0x1.a01a01ad06ccep-16 +                                                         \
     (r) * (0x1.71de0231d3d9ap-19 +                                                         \
     (r) * (0x1.27e4ccae97b86p-22 +                                                         \
     (r) * (0x1.af4de8e41a069p-26 + (r) * 0x1.1f8b85492f787p-29))))))))))
#define SINEW_LOG_POLYNOMIAL(z)                                                             \
    (0x1.5555555555593p-1 +                                                                 \
     (z) * (0x1.999999997f9d7p-2 +                                                          \
     (z) * (0x1.249249422dacap-2 +                                                          \
     (z) * (0x1.c71c51d3b8ed1p-3 +                                                          \
     (z) * (0x1.74664adb40ee9p-3 +                                                          \
     (z) * (0x1.39a06d360da90p-3 + (z) * 0x1.2f138758bdf9cp-3))))))
