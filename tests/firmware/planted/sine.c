/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planted defect: the C library's sine. */
#include <math.h>
void planted_sine(const double *in, double *out);
void planted_sine(const double *in, double *out) { out[0] = sin(in[0]); }
