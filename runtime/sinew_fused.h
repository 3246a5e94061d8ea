/* SPDX-License-Identifier: BSD-2-Clause
 *
 * a * b + c, rounded once, for C emitted with --fma: the processor's instruction and never a call.
 * SINEW_FUSED_DOUBLE and SINEW_FUSED_FLOAT say which precisions the target has the instruction for;
 * without it the function is not there. gcc and clang on x86-64 need -mfma or -march=x86-64-v3.
 */
#ifndef SINEW_FUSED_H
#define SINEW_FUSED_H

#include "sinew_math.h"

/* ACLE: bits 2 and 3 of __ARM_FP are single and double precision. */
#if defined(__ARM_FEATURE_FMA) && defined(__ARM_FP)
#define SINEW_ARM_FUSED __ARM_FP
#else
#define SINEW_ARM_FUSED 0
#endif

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__FP_FAST_FMA) || defined(__FMA__) || (SINEW_ARM_FUSED & 8)
#define SINEW_FUSED_DOUBLE
SINEW_INLINE double sinew_fma(double a, double b, double c) {
    return __builtin_fma(a, b, c);
}
#endif

#if defined(__FP_FAST_FMAF) || defined(__FMA__) || (SINEW_ARM_FUSED & 4)
#define SINEW_FUSED_FLOAT
SINEW_INLINE float sinew_fmaf(float a, float b, float c) {
    return __builtin_fmaf(a, b, c);
}
#endif

#ifdef __cplusplus
}
#endif
#endif
