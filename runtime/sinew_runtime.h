/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The whole runtime, to be copied as one folder and used with or without emitted C. C11, header
 * only: no heap, no global that is written, no loop without a bound, and no library but memcpy.
 *
 *   sinew_math.h        sin, cos, atan, asin, exp, log, ...: the same bits on every target
 *   sinew_polynomial.h  Horner's rule, slope, normalised argument
 *   sinew_solve.h       L D L^T of small symmetric matrices
 *   sinew_iterate.h     Newton's method with a fixed number of steps
 *   sinew_limits.h      limits that NaN does not pass
 *   sinew_channel.h     status, last good and safe value of a measured channel
 *   sinew_ring.h        records from a loop that must not wait to one that may
 *   sinew_checksum.h    CRC-32
 *
 * To be compiled with -std=c11 -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize and never
 * with -ffast-math (docs/firmware.md says why).
 */
#ifndef SINEW_RUNTIME_H
#define SINEW_RUNTIME_H

#include "sinew_channel.h"
#include "sinew_checksum.h"
#include "sinew_iterate.h"
#include "sinew_limits.h"
#include "sinew_math.h"
#include "sinew_polynomial.h"
#include "sinew_ring.h"
#include "sinew_solve.h"

#endif
