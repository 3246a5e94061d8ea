/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: state between calls. */
static double last;
void planted_global(const double *in, double *out);
void planted_global(const double *in, double *out) {
  out[0] = last;
  last = in[0];
}
