// SPDX-License-Identifier: GPL-3.0-or-later
// The two loops of the runner that are long: a convolution, and emitted C called row by row.

// y[k] = sum of w[i] x[k * every + i], for the `count` k at which the weights fit.
void convolved(const double* x, const double* w, long weights, long every, long count, double* y) {
  for (long k = 0; k < count; ++k) {
    double sum = 0.0;
    for (long i = 0; i < weights; ++i) sum += w[i] * x[k * every + i];
    y[k] = sum;
  }
}

// Calls f with every row of `given` and writes its results to `said`. What it keeps from one call
// to the next, `kept` numbers, it takes behind its first `memory` inputs and gives behind its first
// `next` results.
void played(void (*f)(const double*, double*), long rows, double* given, long inputs, double* said,
            long results, long memory, long next, long kept) {
  for (long k = 0; k < rows; ++k) {
    double* in = given + k * inputs;
    if (k > 0)
      for (long i = 0; i < kept; ++i) in[memory + i] = said[(k - 1) * results + next + i];
    f(in, said + k * results);
  }
}
