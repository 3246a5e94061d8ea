/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model motor over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/motor
 * Model:   sha256 2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736
 * Do not edit: change the model and generate again.
 */
#include "motor_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void motor_friction_torque_batch(int count, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double friction = 0.0356 * qd[state] + 0.5586 * sinew_atan(10.0 * qd[state]);
        tau[state] = -friction;
    }
}

void motor_ripple_torque_batch(int count, const double *SINEW_RESTRICT theta,
    double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c2;
        sinew_sincos(0.3 + theta[state], &s1, &c2);
        double s3, c4;
        sinew_sincos(1.1 + 100.0 * theta[state], &s3, &c4);
        tau[state] = -(0.02 * s1 + 0.04 * s3);
    }
}

void motor_acceleration_batch(int count, const double *SINEW_RESTRICT theta,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau_m,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT qdd)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c2;
        sinew_sincos(0.3 + theta[state], &s1, &c2);
        double s3, c4;
        sinew_sincos(1.1 + 100.0 * theta[state], &s3, &c4);
        const double friction = 0.0356 * qd[state] + 0.5586 * sinew_atan(10.0 * qd[state]);
        const double acceleration = 487.8048780487805 * (friction - tau_m[state] + (0.02 * s1 + 0.04
            * s3)) + 2.4390243902439024 * f[state];
        qdd[state] = -acceleration;
    }
}

void motor_compensation_torque_batch(int count, const double *SINEW_RESTRICT theta,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT tau, double *SINEW_RESTRICT margin)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c2;
        sinew_sincos(0.3 + theta[state], &s1, &c2);
        double s3, c4;
        sinew_sincos(1.1 + 100.0 * theta[state], &s3, &c4);
        const double friction = 0.0356 * qd[state] + 0.5586 * sinew_atan(10.0 * qd[state]);
        tau[state] = 0.9 * (friction + (0.02 * s1 + 0.04 * s3));
        margin[state] = 0.1 * qd[state] * friction;
    }
}

void motor_power_balance_batch(int count, const double *SINEW_RESTRICT theta,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau_m,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT power)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c2;
        sinew_sincos(0.3 + theta[state], &s1, &c2);
        double s3, c4;
        sinew_sincos(1.1 + 100.0 * theta[state], &s3, &c4);
        const double friction = 0.0356 * qd[state] + 0.5586 * sinew_atan(10.0 * qd[state]);
        const double ripple = 0.02 * s1 + 0.04 * s3;
        const double acceleration = 487.8048780487805 * (friction - tau_m[state] + ripple)
            + 2.4390243902439024 * f[state];
        power[state] = qd[state] * tau_m[state];
        power[1 * n + state] = -(qd[state] * friction);
        power[2 * n + state] = -(qd[state] * ripple);
        power[3 * n + state] = -(0.005 * qd[state] * f[state]);
        power[4 * n + state] = -(0.00205 * qd[state] * acceleration);
    }
}

void motor_torque_batch(int count, const double *SINEW_RESTRICT current,
    double *SINEW_RESTRICT tau_m)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        tau_m[state] = 0.85 * current[state];
    }
}

void motor_current_batch(int count, const double *SINEW_RESTRICT tau_m,
    double *SINEW_RESTRICT current)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        current[state] = 1.1764705882352942 * tau_m[state];
    }
}
