/* SPDX-License-Identifier: BSD-2-Clause */
/* A loop of fixed length over a constant table is allowed. */
void planted_loop(const double *x, double *y);

void planted_loop(const double *x, double *y)
{
    static const double table[7][2] = {{0.5, 1.0}, {0.25, 2.0}, {0.125, 4.0}, {3.0, 8.0},
        {0.3, 5.0}, {0.1, 6.0}, {0.7, 9.0}};
    double sum = 0.0;
    for (int i = 0; i < 7; ++i) {
        y[1 + i] = table[i][0] * x[0] - table[i][1];
        sum = sum + y[1 + i] * x[1];
    }
    y[0] = sum;
}
