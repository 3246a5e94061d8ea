/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Parameters of the kernels for float, in the order of sinew_double.h. Included by sinew_math.h only;
 * undone by sinew_precision_end.h.
 */
#define SINEW_REAL float
#define SINEW_BITS uint32_t
#define SINEW_NAME(name) name##f
#define SINEW_LITERAL(value) value##F

#define SINEW_SIGN 0x80000000U
#define SINEW_TOP_EXPONENT_BIT 0x40000000U
#define SINEW_EXPONENT 0x7f800000U
#define SINEW_MANTISSA 0x007fffffU
#define SINEW_LARGEST 0x7f7fffffU
#define SINEW_LARGEST_RATIO_PART 0x7effffffU
#define SINEW_ONE_BITS 0x3f800000U
#define SINEW_TWO_BITS 0x40000000U
#define SINEW_FOUR_BITS 0x40800000U
#define SINEW_SMALLEST_NORMAL 0x00800000U
#define SINEW_SQRT_HALF_BITS 0x3f3504f3U
#define SINEW_UPPER_HALF 0xfffff000U
#define SINEW_SIGN_SHIFT 31
#define SINEW_MANTISSA_WIDTH 23
#define SINEW_SQRT(x) __builtin_sqrtf(x)

/* sincosf: |k| < 2^9 as for double, parts of 15, 15 and 24 bits. */
#define SINEW_TURN 0x1.45f306p-9F
#define SINEW_ROUND 0x1.8p15F
#define SINEW_PIO2_1 0x1.922p+8F
#define SINEW_PIO2_2 -0x1.2afp-10F
#define SINEW_PIO2_3 0x1.0b4612p-26F

/* sincosf_wide: |k| < 2^12, parts of 12, 12, 12, 12 and 24 bits. */
#define SINEW_WIDE_TURN 0x1.45f306p-12F
#define SINEW_WIDE_ROUND 0x1.8p12F
#define SINEW_WIDE_PIO2_1 0x1.922p+11F
#define SINEW_WIDE_PIO2_2 -0x1.2aep-7F
#define SINEW_WIDE_PIO2_3 -0x1.deap-20F
#define SINEW_WIDE_PIO2_4 0x1.184p-33F
#define SINEW_WIDE_PIO2_5 0x1.a62634p-47F

/* sin r = r + r z (S1 + S2 z + ...), cos r = 1 - z/2 + z^2 (C1 + C2 z + ...), z = r^2 <= (pi/4)^2. */
#define SINEW_S1 -0x1.555546p-3F
#define SINEW_S2 0x1.110778p-7F
#define SINEW_S3 -0x1.995406p-13F
#define SINEW_C1 0x1.55554ap-5F
#define SINEW_C2 -0x1.6c0c1ap-10F
#define SINEW_C3 0x1.99e0f0p-16F
#define SINEW_SIN_POLYNOMIAL(z) \
    (SINEW_LANE_CONSTANT(S1) + \
     (z) * (SINEW_LANE_CONSTANT(S2) + \
     (z) * SINEW_LANE_CONSTANT(S3)))
#define SINEW_COS_POLYNOMIAL(z) \
    (SINEW_LANE_CONSTANT(C1) + \
     (z) * (SINEW_LANE_CONSTANT(C2) + \
     (z) * SINEW_LANE_CONSTANT(C3)))

/* Two masks and the lowest bit as numbers, and every constant of sincos, for tables of vectors. */
#define SINEW_HALF 0.5F
#define SINEW_ONE 1.0F
#define SINEW_BOUND -0x1.fffffep0F
#define SINEW_SIGN_MASK -0.0F
#define SINEW_LOWEST_BIT 0x1p-149F
#define SINEW_SINCOS_CONSTANTS(each) \
    each(TURN) each(ROUND) each(PIO2_1) each(PIO2_2) each(PIO2_3) each(HALF) each(ONE) \
    each(BOUND) each(SIGN_MASK) each(LOWEST_BIT) each(S1) each(S2) each(S3) each(C1) each(C2) \
    each(C3)


#define SINEW_PIO4_1 0x1.921fbp-1F
#define SINEW_PIO4_2 0x1.5110b4p-23F
#define SINEW_TAN_PIO8 0x1.a8279ap-2F

#define SINEW_ATAN_POLYNOMIAL(z)  \
    (-0x1.55554ap-2F +            \
     (z) * (0x1.9991e2p-3F +      \
     (z) * (-0x1.23b9a2p-3F + (z) * (0x1.b22454p-4F + (z) * -0x1.f2e57ep-5F))))
#define SINEW_ASIN_POLYNOMIAL(z)  \
    (0x1.5555c8p-3F +             \
     (z) * (0x1.330204p-4F +      \
     (z) * (0x1.747bb4p-5F + (z) * (0x1.8c3e96p-6F + (z) * 0x1.595becp-5F))))

#define SINEW_LOG2E 0x1.715476p+0F
#define SINEW_INTEGER_ROUND 0x1.8p23F
#define SINEW_LN2_1 0x1.62e4p-1F
#define SINEW_LN2_2 0x1.7f7d1cp-20F
#define SINEW_EXP_LIMIT_BITS 0x42ae0000U
#define SINEW_TANH_LIMIT_BITS 0x41200000U
#define SINEW_INTEGER_BITS 0x4b000000U
#define SINEW_INTEGER_AND_BIAS 0x1.0000fep23F

#define SINEW_EXP_POLYNOMIAL(r)   \
    (0x1.0p-1F +                  \
     (r) * (0x1.5554dcp-3F +      \
     (r) * (0x1.5554b8p-5F + (r) * (0x1.120b6ep-7F + (r) * 0x1.6d7642p-10F))))
#define SINEW_LOG_POLYNOMIAL(z) \
    (0x1.55557ap-1F + (z) * (0x1.995ec6p-2F + (z) * 0x1.31e36cp-2F))
