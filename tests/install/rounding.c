/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a compiler may round differently unless told otherwise: a product and a sum at once, the same
 * side by side, and a square root that is a call for the sake of errno. */
#include <math.h>
#include <sinew_math.h>

double product_and_sum(double a, double b, double c) { return a * b + c; }

void side_by_side(const double *a, const double *b, const double *c, double *restrict y)
{
    y[0] = a[0] * b[0] - c[0];
    y[1] = a[1] * b[1] + c[1];
}

double root(double a) { return sqrt(a); }
