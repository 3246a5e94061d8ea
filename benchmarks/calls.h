/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The one calling convention of everything that is timed: q, qd, u (accelerations, or torques for
 * forward dynamics) of n numbers each; out: row-major results.
 */
#ifndef SINEW_BENCHMARKS_CALLS_H
#define SINEW_BENCHMARKS_CALLS_H

typedef void dynamics_call(const double* q, const double* qd, const double* u, double* out);

/* Over `count` states; element k of state i is at [k * count + i]. */
typedef void batch_call(int count, const double* q, const double* qd, const double* u, double* out);

#endif
