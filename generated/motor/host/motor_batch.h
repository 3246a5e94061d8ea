/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model motor over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/motor
 * Model:   sha256 2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_motor_BATCH_H
#define SINEW_motor_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

void motor_friction_torque_batch(int count, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT tau);
void motor_ripple_torque_batch(int count, const double *SINEW_RESTRICT theta,
    double *SINEW_RESTRICT tau);
void motor_acceleration_batch(int count, const double *SINEW_RESTRICT theta,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau_m,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT qdd);
void motor_compensation_torque_batch(int count, const double *SINEW_RESTRICT theta,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT tau, double *SINEW_RESTRICT margin);
void motor_power_balance_batch(int count, const double *SINEW_RESTRICT theta,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau_m,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT power);
void motor_torque_batch(int count, const double *SINEW_RESTRICT current,
    double *SINEW_RESTRICT tau_m);
void motor_current_batch(int count, const double *SINEW_RESTRICT tau_m,
    double *SINEW_RESTRICT current);

#ifdef __cplusplus
}
#endif
#endif
