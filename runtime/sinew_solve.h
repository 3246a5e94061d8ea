/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Small symmetric systems A x = b by A = L D L^T, without square roots and without pivoting: for
 * positive definite A, such as mass matrices and P^T P. Row-major, in place, no heap. The loops
 * depend on n alone.
 */
#ifndef SINEW_SOLVE_H
#define SINEW_SOLVE_H

#ifdef __cplusplus
extern "C" {
#endif

/* Factorises the n x n matrix A; only its lower triangle is read. Afterwards the diagonal holds
 * 1/D and what is below it L. A pivot that is not above `least` (NaN included) is taken as 1, so
 * that everything stays finite, and counted. Returns the number of such pivots: 0 where A is
 * positive definite. least > 0, in A's unit. */
static inline int sinew_factorise(double *A, int n, double least) {
    int singular = 0;
    for (int j = 0; j < n; ++j) {
        double pivot = A[j * n + j];
        for (int k = 0; k < j; ++k) {
            /* rows before hold L times D in their upper triangle, see below */
            pivot -= A[j * n + k] * A[k * n + j];
        }
        if (!(pivot > least)) {
            pivot = 1.0;
            ++singular;
        }
        A[j * n + j] = 1.0 / pivot;
        for (int i = j + 1; i < n; ++i) {
            double scaled = A[i * n + j];
            for (int k = 0; k < j; ++k) scaled -= A[i * n + k] * A[k * n + j];
            A[j * n + i] = scaled; /* L D, for the columns to come */
            A[i * n + j] = scaled * A[j * n + j];
        }
    }
    return singular;
}

/* x = A^-1 b from what sinew_factorise left; b and x may be the same array. */
static inline void sinew_substitute(const double *A, int n, const double *b, double *x) {
    for (int i = 0; i < n; ++i) {
        double value = b[i];
        for (int k = 0; k < i; ++k) value -= A[i * n + k] * x[k];
        x[i] = value;
    }
    for (int i = n - 1; i >= 0; --i) {
        double value = x[i] * A[i * n + i];
        for (int k = i + 1; k < n; ++k) value -= A[k * n + i] * x[k];
        x[i] = value;
    }
}

/* Both. Returns the number of pivots that were not above `least`; x is meaningful where it is 0,
 * and finite where A and b are and no overflow occurs. A is overwritten. */
static inline int sinew_solve(double *A, int n, double least, const double *b, double *x) {
    const int singular = sinew_factorise(A, n, least);
    sinew_substitute(A, n, b, x);
    return singular;
}

#ifdef __cplusplus
}
#endif
#endif
