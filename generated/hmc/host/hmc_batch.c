/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model hmc over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/hmc
 * Model:   sha256 c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7
 * Do not edit: change the model and generate again.
 */
#include "hmc_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void hmc_four_bar_batch(int count, const double *SINEW_RESTRICT theta2, double *SINEW_RESTRICT out)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin2, cos2;
        sinew_sincos(theta2[state], &sin2, &cos2);
        const double A = 1.2 - cos2;
        const double reach_squared = sinew_max(sin2 * sin2 + A * A, 1e-12);
        const double reach = sinew_sqrt(reach_squared);
        const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
        const double slack = 0.6944444444444444 * (C + reach) * (C - reach);
        const double root = sinew_sqrt(sinew_max(-slack, 1e-12));
        const double side = 1.2 * root;
        const double limited = sinew_min(sinew_max(C, -reach), reach);
        const double t1 = 1.0 / reach_squared;
        const double cos4 = (sin2 * side - A * limited) * t1;
        const double along = 0.012 - 0.01 * cos2 + 0.011 * cos4;
        const double sin4 = (sin2 * limited + A * side) * t1;
        const double across = 0.01 * sin2 - 0.011 * sin4;
        const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
        const double t2 = 1.0 / length;
        const double cos3 = along * t2;
        const double sin3 = across * t2;
        const double t3 = 1.0 / root;
        out[state] = sinew_atan2(-sin3, cos3);
        out[1 * n + state] = sinew_atan2(sin4, cos4);
        out[2 * n + state] = -(0.8333333333333334 * (cos2 * sin4 - sin2 * cos4) * t3);
        out[3 * n + state] = 0.9090909090909091 * (cos2 * sin3 + sin2 * cos3) * t3;
    }
}

void hmc_locking_batch(int count, const double *SINEW_RESTRICT theta2,
    double *SINEW_RESTRICT distance, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin2, cos2;
        sinew_sincos(theta2[state], &sin2, &cos2);
        const double A = 1.2 - cos2;
        const double reach = sinew_sqrt(sinew_max(sin2 * sin2 + A * A, 1e-12));
        const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
        const double cos_34 = 0.9166666666666666 - 0.8333333333333334 * sinew_min(sinew_max(C,
            -reach), reach);
        const double slack = 0.6944444444444444 * (C + reach) * (C - reach);
        const double t1 = sinew_atan2(sinew_sqrt(sinew_max(-slack, 0.0)), sinew_max(cos_34,
            -cos_34));
        distance[state] = t1;
        status[state] = (int)sinew_choose(-(1e-12 + slack), 0.0, 1.0);
    }
}

void hmc_coupler_pose_batch(int count, const double *SINEW_RESTRICT theta2,
    double *SINEW_RESTRICT T)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin2, cos2;
        sinew_sincos(theta2[state], &sin2, &cos2);
        const double A = 1.2 - cos2;
        const double reach_squared = sinew_max(sin2 * sin2 + A * A, 1e-12);
        const double reach = sinew_sqrt(reach_squared);
        const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
        const double slack = 0.6944444444444444 * (C + reach) * (C - reach);
        const double side = 1.2 * sinew_sqrt(sinew_max(-slack, 1e-12));
        const double limited = sinew_min(sinew_max(C, -reach), reach);
        const double t1 = 1.0 / reach_squared;
        const double t2 = 0.01 * cos2;
        const double along = 0.012 - t2 + 0.011 * ((sin2 * side - A * limited) * t1);
        const double t3 = 0.01 * sin2;
        const double across = t3 - 0.011 * ((sin2 * limited + A * side) * t1);
        const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
        const double t4 = 1.0 / length;
        const double cos3 = along * t4;
        const double sin3 = across * t4;
        T[state] = cos3;
        T[1 * n + state] = sin3;
        T[2 * n + state] = 0.0;
        T[3 * n + state] = t2;
        T[4 * n + state] = -sin3;
        T[5 * n + state] = cos3;
        T[6 * n + state] = 0.0;
        T[7 * n + state] = t3;
        T[8 * n + state] = 0.0;
        T[9 * n + state] = 0.0;
        T[10 * n + state] = 1.0;
        T[11 * n + state] = 0.0;
        T[12 * n + state] = 0.0;
        T[13 * n + state] = 0.0;
        T[14 * n + state] = 0.0;
        T[15 * n + state] = 1.0;
    }
}

void hmc_tendon_lengths_batch(int count, const double *SINEW_RESTRICT theta2,
    double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double length = 0.007853981633974483 - 0.005 * theta2[state];
        h[state] = -length;
        h[1 * n + state] = length;
    }
}
