/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planted defect: state between calls. */
static double last;
void planted_global(const double *in, double *out);
void planted_global(const double *in, double *out) {
  out[0] = last;
  last = in[0];
}
