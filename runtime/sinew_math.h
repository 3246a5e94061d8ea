/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Elementary functions of the emitted C: no library, no branch, no global, no undefined symbol, and a
 * defined, finite result for every input, NaN and infinity included. The same bits on every target
 * when compiled as ISO C with -ffp-contract=off -fno-math-errno.
 *
 * Every function exists for double (sinew_sincos) and for float (sinew_sincosf); the float ones hold
 * no double operation. Ranges, errors and how they are measured: docs/trigonometry.md.
 */
#ifndef SINEW_MATH_H
#define SINEW_MATH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Inlining is what makes these cheap; where size is asked for, the compiler decides. */
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define SINEW_INLINE static inline __attribute__((always_inline))
#elif defined(__GNUC__)
#define SINEW_INLINE static inline __attribute__((unused))
#else
#define SINEW_INLINE static inline
#endif

/* Where the processor has vectors with full IEEE arithmetic and the compiler can name them. */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#define SINEW_VECTORS
#endif

/* Each kernel is written once and included once for each precision. */
#include "sinew_double.h"
#include "sinew_kernel_select.h"
#include "sinew_kernel_sincos.h"
#include "sinew_kernel_arc.h"
#include "sinew_kernel_exponential.h"
#include "sinew_precision_end.h"

#include "sinew_float.h"
#include "sinew_kernel_select.h"
#include "sinew_kernel_sincos.h"
#include "sinew_kernel_arc.h"
#include "sinew_kernel_exponential.h"
#include "sinew_precision_end.h"

#ifdef __cplusplus
}
#endif
#endif
