/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Hamatometacarpal joint: four-bar that carries the fifth finger
 *
 * Made by: sinew generate models/hmc
 * Model:   sha256 c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7
 * Do not edit: change the model and generate again.
 */
#include "hmc.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

SINEW_NOT_INLINE static double sinew_one_atan2(double y, double x)
{
    return sinew_atan2(y, x);
}

struct sinew_sines {
    double s[1], c[1];
};

SINEW_NOT_INLINE static struct sinew_sines sinew_one_sincos(double x)
{
    struct sinew_sines y;
    sinew_sincos(x, y.s, y.c);
    return y;
}

void hmc_four_bar(double theta2, double out[SINEW_AT_LEAST(4)])
{
    const struct sinew_sines sines1 = sinew_one_sincos(theta2);
    const double sin2 = sines1.s[0];
    const double cos2 = sines1.c[0];
    const double A = 1.2 - cos2;
    const double reach_squared = sinew_max(sin2 * sin2 + A * A, 1e-12);
    const double reach = sinew_sqrt(reach_squared);
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double slack = 0.6944444444444444 * (C + reach) * (C - reach);
    const double root = sinew_sqrt(sinew_max(-slack, 1e-12));
    const double side = 1.2 * root;
    const double limited = sinew_min(sinew_max(C, -reach), reach);
    const double t2 = 1.0 / reach_squared;
    const double cos4 = (sin2 * side - A * limited) * t2;
    const double along = 0.012 - 0.01 * cos2 + 0.011 * cos4;
    const double sin4 = (sin2 * limited + A * side) * t2;
    const double across = 0.01 * sin2 - 0.011 * sin4;
    const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
    const double t3 = 1.0 / length;
    const double cos3 = along * t3;
    const double sin3 = across * t3;
    const double t4 = 1.0 / root;
    out[0] = sinew_one_atan2(-sin3, cos3);
    out[1] = sinew_one_atan2(sin4, cos4);
    out[2] = -(0.8333333333333334 * (cos2 * sin4 - sin2 * cos4) * t4);
    out[3] = 0.9090909090909091 * (cos2 * sin3 + sin2 * cos3) * t4;
}

void hmc_locking(double theta2, double distance[SINEW_AT_LEAST(1)], int *status)
{
    const struct sinew_sines sines1 = sinew_one_sincos(theta2);
    const double sin2 = sines1.s[0];
    const double cos2 = sines1.c[0];
    const double A = 1.2 - cos2;
    const double reach = sinew_sqrt(sinew_max(sin2 * sin2 + A * A, 1e-12));
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double cos_34 = 0.9166666666666666 - 0.8333333333333334 * sinew_min(sinew_max(C, -reach),
        reach);
    const double slack = 0.6944444444444444 * (C + reach) * (C - reach);
    const double t2 = sinew_one_atan2(sinew_sqrt(sinew_max(-slack, 0.0)), sinew_max(cos_34,
        -cos_34));
    distance[0] = t2;
    *status = (int)sinew_choose(-(1e-12 + slack), 0.0, 1.0);
}

void hmc_coupler_pose(double theta2, double T[SINEW_AT_LEAST(16)])
{
    const struct sinew_sines sines1 = sinew_one_sincos(theta2);
    const double sin2 = sines1.s[0];
    const double cos2 = sines1.c[0];
    const double A = 1.2 - cos2;
    const double reach_squared = sinew_max(sin2 * sin2 + A * A, 1e-12);
    const double reach = sinew_sqrt(reach_squared);
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double slack = 0.6944444444444444 * (C + reach) * (C - reach);
    const double side = 1.2 * sinew_sqrt(sinew_max(-slack, 1e-12));
    const double limited = sinew_min(sinew_max(C, -reach), reach);
    const double t2 = 1.0 / reach_squared;
    const double t3 = 0.01 * cos2;
    const double along = 0.012 - t3 + 0.011 * ((sin2 * side - A * limited) * t2);
    const double t4 = 0.01 * sin2;
    const double across = t4 - 0.011 * ((sin2 * limited + A * side) * t2);
    const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
    const double t5 = 1.0 / length;
    const double cos3 = along * t5;
    const double sin3 = across * t5;
    T[0] = cos3;
    T[1] = sin3;
    T[2] = 0.0;
    T[3] = t3;
    T[4] = -sin3;
    T[5] = cos3;
    T[6] = 0.0;
    T[7] = t4;
    T[8] = 0.0;
    T[9] = 0.0;
    T[10] = 1.0;
    T[11] = 0.0;
    T[12] = 0.0;
    T[13] = 0.0;
    T[14] = 0.0;
    T[15] = 1.0;
}

void hmc_tendon_lengths(double theta2, double h[SINEW_AT_LEAST(2)])
{
    const double length = 0.007853981633974483 - 0.005 * theta2;
    h[0] = -length;
    h[1] = length;
}
