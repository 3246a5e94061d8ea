/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: a function that calls itself. */
double planted_recursion(const double *in, int n);
double planted_recursion(const double *in, int n) {
  return n == 0 ? 0.0 : 1.0 / (in[n] + planted_recursion(in, n - 1));
}
