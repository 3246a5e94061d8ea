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

struct sinew_sines2 {
    double s[2], c[2];
};

static struct sinew_sines2 sinew_one_sincos2(double x0, double x1)
{
    struct sinew_sines2 y;
    const double x[2] = {x0, x1};
    sinew_sincos2(x, y.s, y.c);
    return y;
}

void motor_friction_torque(double qd, double tau[SINEW_AT_LEAST(1)])
{
    const double friction = 0.0356 * qd + 0.5586 * sinew_one_atan(10.0 * qd);
    tau[0] = -friction;
}

void motor_ripple_torque(double theta, double tau[SINEW_AT_LEAST(1)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(0.3 + theta, 1.1 + 100.0 * theta);
    const double s2 = sines1.s[0];
    const double s4 = sines1.s[1];
    tau[0] = -(0.02 * s2 + 0.04 * s4);
}

void motor_acceleration(double theta, double qd, double tau_m, double f,
    double qdd[SINEW_AT_LEAST(1)])
{
    double ripple_torque_tau[1];
    motor_ripple_torque(theta, ripple_torque_tau);
    const double friction = 0.0356 * qd + 0.5586 * sinew_one_atan(10.0 * qd);
    const double acceleration = 487.8048780487805 * (friction - tau_m + -ripple_torque_tau[0])
        + 2.4390243902439024 * f;
    qdd[0] = -acceleration;
}

void motor_compensation_torque(double theta, double qd, double tau[SINEW_AT_LEAST(1)],
    double margin[SINEW_AT_LEAST(1)])
{
    double ripple_torque_tau[1];
    motor_ripple_torque(theta, ripple_torque_tau);
    const double friction = 0.0356 * qd + 0.5586 * sinew_one_atan(10.0 * qd);
    tau[0] = 0.9 * (friction + -ripple_torque_tau[0]);
    margin[0] = 0.1 * qd * friction;
}

void motor_power_balance(double theta, double qd, double tau_m, double f,
    double power[SINEW_AT_LEAST(5)])
{
    double ripple_torque_tau[1];
    motor_ripple_torque(theta, ripple_torque_tau);
    const double friction = 0.0356 * qd + 0.5586 * sinew_one_atan(10.0 * qd);
    const double t1 = -ripple_torque_tau[0];
    const double acceleration = 487.8048780487805 * (friction - tau_m + t1) + 2.4390243902439024
        * f;
    power[0] = qd * tau_m;
    power[1] = -(qd * friction);
    power[2] = -(qd * t1);
    power[3] = -(0.005 * qd * f);
    power[4] = -(0.00205 * qd * acceleration);
}

void motor_torque(double current, double tau_m[SINEW_AT_LEAST(1)])
{
    tau_m[0] = 0.85 * current;
}

void motor_current(double tau_m, double current[SINEW_AT_LEAST(1)])
{
    current[0] = 1.1764705882352942 * tau_m;
}
