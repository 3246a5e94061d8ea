/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The loops of the batch form, which gcc has to vectorise; with PLANTED one that it can not.
 */
#include "sinew_math.h"

#ifdef PLANTED
double opaque(double x);
#define ANGLE(x) opaque(x)
#else
#define ANGLE(x) (x)
#endif

void batch(int n, const double *restrict x, double *restrict s, double *restrict c);
void batch(int n, const double *restrict x, double *restrict s, double *restrict c) {
    for (int i = 0; i < n; i++) sinew_sincos(ANGLE(x[i]), &s[i], &c[i]);
}
