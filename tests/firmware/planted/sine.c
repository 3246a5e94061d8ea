/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: the C library's sine. */
#include <math.h>
void planted_sine(const double *in, double *out);
void planted_sine(const double *in, double *out) { out[0] = sin(in[0]); }
