/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model motor behind one calling convention.
 *
 * Made by: sinew generate models/motor
 * Model:   sha256 2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736
 * Do not edit: change the model and generate again.
 */
#include "motor_catalogue.h"

#include "motor.h"

static void call_friction_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_friction_torque(x[0], y + 0);
}
static const double friction_torque_qd_low[] = {-10.0};
static const double friction_torque_qd_high[] = {10.0};
static const sinew_argument friction_torque_inputs[] = {
    {"qd", "rad/s", 1, 1, friction_torque_qd_low, friction_torque_qd_high},
};
static const sinew_argument friction_torque_outputs[] = {
    {"tau", "N m", 1, 1, 0, 0},
};

static void call_ripple_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_ripple_torque(x[0], y + 0);
}
static const double ripple_torque_theta_low[] = {-6.283};
static const double ripple_torque_theta_high[] = {6.283};
static const sinew_argument ripple_torque_inputs[] = {
    {"theta", "rad", 1, 1, ripple_torque_theta_low, ripple_torque_theta_high},
};
static const sinew_argument ripple_torque_outputs[] = {
    {"tau", "N m", 1, 1, 0, 0},
};

static void call_acceleration(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_acceleration(x[0], x[1], x[2], x[3], y + 0);
}
static const double acceleration_theta_low[] = {-6.283};
static const double acceleration_theta_high[] = {6.283};
static const double acceleration_qd_low[] = {-10.0};
static const double acceleration_qd_high[] = {10.0};
static const double acceleration_tau_m_low[] = {-2.0};
static const double acceleration_tau_m_high[] = {2.0};
static const double acceleration_f_low[] = {0.0};
static const double acceleration_f_high[] = {100.0};
static const sinew_argument acceleration_inputs[] = {
    {"theta", "rad", 1, 1, acceleration_theta_low, acceleration_theta_high},
    {"qd", "rad/s", 1, 1, acceleration_qd_low, acceleration_qd_high},
    {"tau_m", "N m", 1, 1, acceleration_tau_m_low, acceleration_tau_m_high},
    {"f", "N", 1, 1, acceleration_f_low, acceleration_f_high},
};
static const sinew_argument acceleration_outputs[] = {
    {"qdd", "rad/s^2", 1, 1, 0, 0},
};

static void call_compensation_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_compensation_torque(x[0], x[1], y + 0, y + 1);
}
static const double compensation_torque_theta_low[] = {-6.283};
static const double compensation_torque_theta_high[] = {6.283};
static const double compensation_torque_qd_low[] = {-10.0};
static const double compensation_torque_qd_high[] = {10.0};
static const sinew_argument compensation_torque_inputs[] = {
    {"theta", "rad", 1, 1, compensation_torque_theta_low, compensation_torque_theta_high},
    {"qd", "rad/s", 1, 1, compensation_torque_qd_low, compensation_torque_qd_high},
};
static const sinew_argument compensation_torque_outputs[] = {
    {"tau", "N m", 1, 1, 0, 0},
    {"margin", "W", 1, 1, 0, 0},
};

static void call_power_balance(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_power_balance(x[0], x[1], x[2], x[3], y + 0);
}
static const double power_balance_theta_low[] = {-6.283};
static const double power_balance_theta_high[] = {6.283};
static const double power_balance_qd_low[] = {-10.0};
static const double power_balance_qd_high[] = {10.0};
static const double power_balance_tau_m_low[] = {-2.0};
static const double power_balance_tau_m_high[] = {2.0};
static const double power_balance_f_low[] = {0.0};
static const double power_balance_f_high[] = {100.0};
static const sinew_argument power_balance_inputs[] = {
    {"theta", "rad", 1, 1, power_balance_theta_low, power_balance_theta_high},
    {"qd", "rad/s", 1, 1, power_balance_qd_low, power_balance_qd_high},
    {"tau_m", "N m", 1, 1, power_balance_tau_m_low, power_balance_tau_m_high},
    {"f", "N", 1, 1, power_balance_f_low, power_balance_f_high},
};
static const sinew_argument power_balance_outputs[] = {
    {"power", "W", 5, 1, 0, 0},
};

static void call_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_torque(x[0], y + 0);
}
static const double torque_current_low[] = {-2.3529411764705883};
static const double torque_current_high[] = {2.3529411764705883};
static const sinew_argument torque_inputs[] = {
    {"current", "A", 1, 1, torque_current_low, torque_current_high},
};
static const sinew_argument torque_outputs[] = {
    {"tau_m", "N m", 1, 1, 0, 0},
};

static void call_current(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    motor_current(x[0], y + 0);
}
static const double current_tau_m_low[] = {-2.0};
static const double current_tau_m_high[] = {2.0};
static const sinew_argument current_inputs[] = {
    {"tau_m", "N m", 1, 1, current_tau_m_low, current_tau_m_high},
};
static const sinew_argument current_outputs[] = {
    {"current", "A", 1, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"motor_friction_torque", 1, 1, 1, 1, friction_torque_inputs, friction_torque_outputs,
        call_friction_torque},
    {"motor_ripple_torque", 1, 1, 1, 1, ripple_torque_inputs, ripple_torque_outputs,
        call_ripple_torque},
    {"motor_acceleration", 4, 1, 4, 1, acceleration_inputs, acceleration_outputs,
        call_acceleration},
    {"motor_compensation_torque", 2, 2, 2, 2, compensation_torque_inputs,
        compensation_torque_outputs, call_compensation_torque},
    {"motor_power_balance", 4, 1, 4, 5, power_balance_inputs, power_balance_outputs,
        call_power_balance},
    {"motor_torque", 1, 1, 1, 1, torque_inputs, torque_outputs, call_torque},
    {"motor_current", 1, 1, 1, 1, current_inputs, current_outputs, call_current},
};

const sinew_catalogue motor_catalogue = {"motor",
    "2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736", 8, 7, functions};
