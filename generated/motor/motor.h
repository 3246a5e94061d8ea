/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Motor with harmonic drive, seen at its output
 *
 * Made by: sinew generate models/motor
 * Model:   sha256 2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_MOTOR_H
#define SINEW_MOTOR_H

/* SI units; matrices row-major. Results are finite for every finite input.
 * Numbers such as (5.2) are those of equations in the model's source. */

#ifndef SINEW_AT_LEAST
#ifdef __cplusplus
#define SINEW_AT_LEAST(n) n
#else
#define SINEW_AT_LEAST(n) static n
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Friction torque at a velocity; opposes motion. (3.8)
 *   in  qd            1 [rad/s] output velocity; made for -10..10
 *   out tau           1 [N m] acts on the output shaft
 * 3 multiplications, 1 additions, 1 other functions. */
void motor_friction_torque(double qd, double tau[SINEW_AT_LEAST(1)]);

/* Periodic torque of output and input shaft at an angle. (3.5)
 *   in  theta         1 [rad] output angle; made for -6.283..6.283
 *   out tau           1 [N m] acts on the output shaft
 * 3 multiplications, 3 additions, 2 sincos. */
void motor_ripple_torque(double theta, double tau[SINEW_AT_LEAST(1)]);

/* Acceleration of the output shaft. (3.5)
 *   in  theta         1 [rad] output angle; made for -6.283..6.283
 *   in  qd            1 [rad/s] output velocity; made for -10..10
 *   in  tau_m         1 [N m] electromagnetic torque at the output; made for -2..2
 *   in  f             1 [N] tendon force; made for 0..100
 *   out qdd           1 [rad/s^2] 
 * 8 multiplications, 7 additions, 2 sincos, 1 other functions. */
void motor_acceleration(double theta, double qd, double tau_m, double f,
    double qdd[SINEW_AT_LEAST(1)]);

/* Feedforward against friction and ripple, and what friction still dissipates. (3.8)
 *   in  theta         1 [rad] output angle; made for -6.283..6.283
 *   in  qd            1 [rad/s] output velocity; made for -10..10
 *   out tau           1 [N m] to be added to the commanded torque
 *   out margin        1 [W] never negative: the compensated motor is passive
 * 9 multiplications, 5 additions, 2 sincos, 1 other functions. */
void motor_compensation_torque(double theta, double qd, double tau[SINEW_AT_LEAST(1)],
    double margin[SINEW_AT_LEAST(1)]);

/* Where the motor's power goes; the last entry is the sum of the others. (3.5)
 *   in  theta         1 [rad] output angle; made for -6.283..6.283
 *   in  qd            1 [rad/s] output velocity; made for -10..10
 *   in  tau_m         1 [N m] electromagnetic torque at the output; made for -2..2
 *   in  f             1 [N] tendon force; made for 0..100
 *   out power         5 [W] motor, friction, ripple, tendon, into kinetic energy
 * 15 multiplications, 7 additions, 2 sincos, 1 other functions. */
void motor_power_balance(double theta, double qd, double tau_m, double f,
    double power[SINEW_AT_LEAST(5)]);

/* Torque at the output from the current.
 *   in  current       1 [A] motor current; made for -2.353..2.353
 *   out tau_m         1 [N m] at the output shaft
 * 1 multiplications, 0 additions. */
void motor_torque(double current, double tau_m[SINEW_AT_LEAST(1)]);

/* Current for a torque at the output.
 *   in  tau_m         1 [N m] torque at the output shaft; made for -2..2
 *   out current       1 [A] 
 * 1 multiplications, 0 additions. */
void motor_current(double tau_m, double current[SINEW_AT_LEAST(1)]);

#ifdef __cplusplus
}
#endif
#endif
