/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Motor with harmonic drive, seen at its output
 *
 * Made by: sinew generate models/motor
 * Model:   sha256 2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736
 * Do not edit: change the model and generate again.
 */
#include "motor.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

SINEW_NOT_INLINE static double sinew_one_atan(double x)
{
    return sinew_atan(x);
}

SINEW_NOT_INLINE static void sinew_one_sincos2(const double x[2], double s[2], double c[2])
{
    sinew_sincos2(x, s, c);
}

void motor_friction_torque(const double qd[SINEW_AT_LEAST(1)], double tau[SINEW_AT_LEAST(1)])
{
    const double friction = 0.0356 * qd[0] + 0.5586 * sinew_one_atan(10.0 * qd[0]);
    tau[0] = -friction;
}

void motor_ripple_torque(const double theta[SINEW_AT_LEAST(1)], double tau[SINEW_AT_LEAST(1)])
{
    const double angle1[2] = {0.3 + theta[0], 1.1 + 100.0 * theta[0]};
    double sine2[2], cosine3[2];
    sinew_one_sincos2(angle1, sine2, cosine3);
    const double s4 = sine2[0];
    const double s6 = sine2[1];
    const double ripple = 0.02 * s4 + 0.04 * s6;
    tau[0] = -ripple;
}

void motor_acceleration(const double theta[SINEW_AT_LEAST(1)], const double qd[SINEW_AT_LEAST(1)], const double tau_m[SINEW_AT_LEAST(1)], const double f[SINEW_AT_LEAST(1)], double qdd[SINEW_AT_LEAST(1)])
{
    const double angle1[2] = {0.3 + theta[0], 1.1 + 100.0 * theta[0]};
    double sine2[2], cosine3[2];
    sinew_one_sincos2(angle1, sine2, cosine3);
    const double s4 = sine2[0];
    const double s6 = sine2[1];
    const double ripple = 0.02 * s4 + 0.04 * s6;
    const double friction = 0.0356 * qd[0] + 0.5586 * sinew_one_atan(10.0 * qd[0]);
    const double acceleration = 487.8048780487805 * (friction - tau_m[0] + ripple) + 2.4390243902439024 * f[0];
    qdd[0] = -acceleration;
}

void motor_compensation_torque(const double theta[SINEW_AT_LEAST(1)], const double qd[SINEW_AT_LEAST(1)], double tau[SINEW_AT_LEAST(1)], double margin[SINEW_AT_LEAST(1)])
{
    const double angle1[2] = {0.3 + theta[0], 1.1 + 100.0 * theta[0]};
    double sine2[2], cosine3[2];
    sinew_one_sincos2(angle1, sine2, cosine3);
    const double s4 = sine2[0];
    const double s6 = sine2[1];
    const double ripple = 0.02 * s4 + 0.04 * s6;
    const double friction = 0.0356 * qd[0] + 0.5586 * sinew_one_atan(10.0 * qd[0]);
    tau[0] = 0.9 * (friction + ripple);
    margin[0] = 0.1 * qd[0] * friction;
}

void motor_power_balance(const double theta[SINEW_AT_LEAST(1)], const double qd[SINEW_AT_LEAST(1)], const double tau_m[SINEW_AT_LEAST(1)], const double f[SINEW_AT_LEAST(1)], double power[SINEW_AT_LEAST(5)])
{
    const double angle1[2] = {0.3 + theta[0], 1.1 + 100.0 * theta[0]};
    double sine2[2], cosine3[2];
    sinew_one_sincos2(angle1, sine2, cosine3);
    const double s4 = sine2[0];
    const double s6 = sine2[1];
    const double friction = 0.0356 * qd[0] + 0.5586 * sinew_one_atan(10.0 * qd[0]);
    const double ripple = 0.02 * s4 + 0.04 * s6;
    const double acceleration = 487.8048780487805 * (friction - tau_m[0] + ripple) + 2.4390243902439024 * f[0];
    power[0] = qd[0] * tau_m[0];
    power[1] = -(qd[0] * friction);
    power[2] = -(qd[0] * ripple);
    power[3] = -(0.005 * qd[0] * f[0]);
    power[4] = -(0.00205 * qd[0] * acceleration);
}

void motor_torque(const double current[SINEW_AT_LEAST(1)], double tau_m[SINEW_AT_LEAST(1)])
{
    tau_m[0] = 0.85 * current[0];
}

void motor_current(const double tau_m[SINEW_AT_LEAST(1)], double current[SINEW_AT_LEAST(1)])
{
    current[0] = 1.1764705882352942 * tau_m[0];
}
