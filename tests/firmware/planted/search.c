/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted: a loop whose number of passes depends on the input. */
void planted_search(const double *x, double *y);

void planted_search(const double *x, double *y)
{
    double value = x[0];
    for (int i = 0; value > 1.0; ++i) value = 0.5 * value - (double)i;
    y[0] = value;
}
