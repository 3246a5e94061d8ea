/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: a conditional branch. */
void planted_branch(const double *in, double *out);
void planted_branch(const double *in, double *out) {
  if (in[0] > in[1]) {
    out[0] = in[0] * in[1];
    out[1] = in[0] / in[1];
  }
}
