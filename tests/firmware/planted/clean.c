/* SPDX-License-Identifier: BSD-2-Clause */
/* Keeps every rule. */
static double square(double x) { return x * x; }
void planted_clean(const double *in, double *out);
void planted_clean(const double *in, double *out) {
  out[0] = square(in[0]) + in[1];
  out[1] = in[0] * out[0];
}
