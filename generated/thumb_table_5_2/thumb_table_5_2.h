/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Thumb with the distal insertions of Table 5.2 verbatim
 *
 * Made by: sinew generate models/thumb_table_5_2
 * Model:   sha256 bbe6ad946c25f79dfb874427de1b09ec5897fef90ad1f6d32550868697528da8
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_THUMB_TABLE_5_2_H
#define SINEW_THUMB_TABLE_5_2_H

/* SI units; matrices row-major. Results are finite for every finite input. */

/* Joint order (depth first from the base):
 *   q[0] q10 (revolute, rad)
 *   q[1] q11 (revolute, rad)
 *   q[2] q12 (revolute, rad)
 *   q[3] q13 (revolute, rad)
 * Gravity in the base frame: 0, 0, -9.81 m/s^2.
 */

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

/* Pose of the frame tip in the base frame, homogeneous. (5.2)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   out T           4x4 [m] maps coordinates of the frame to the base
 * 13 multiplications, 7 additions, 4 sincos. */
void thumb_table_5_2_forward_kinematics(const double q[SINEW_AT_LEAST(4)], double T[SINEW_AT_LEAST(16)]);

/* Geometric Jacobian of the frame tip: linear rows first, base frame.
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   out J           6x4 [m | 1] velocity and angular velocity a joint rate
 * 25 multiplications, 16 additions, 4 sincos. */
void thumb_table_5_2_tip_jacobian(const double q[SINEW_AT_LEAST(4)], double J[SINEW_AT_LEAST(24)]);

/* Mass matrix M(q), symmetric. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   out M           4x4 [kg m^2] mass matrix
 * 22 multiplications, 23 additions, 3 sincos. */
void thumb_table_5_2_mass_matrix(const double q[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)]);

/* Coriolis matrix C(q,qd) in Christoffel form: dM/dt - 2 C is skew-symmetric. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out C           4x4 [kg m^2/s] Coriolis matrix
 * 50 multiplications, 47 additions, 3 sincos. */
void thumb_table_5_2_coriolis_matrix(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)], double C[SINEW_AT_LEAST(16)]);

/* Joint torques that hold the mechanism still: g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   out g             4 [N m] gravity torques
 * 3 multiplications, 4 additions, 3 sincos. */
void thumb_table_5_2_gravity(const double q[SINEW_AT_LEAST(4)], double g[SINEW_AT_LEAST(4)]);

/* Joint torques at zero acceleration: C(q,qd) qd + g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out h             4 [N m] bias torques
 * 42 multiplications, 29 additions, 3 sincos. */
void thumb_table_5_2_bias(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)], double h[SINEW_AT_LEAST(4)]);

/* Mass matrix and bias at once, with what they share computed once. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out M           4x4 [kg m^2] mass matrix
 *   out h             4 [N m] bias torques
 * 53 multiplications, 48 additions, 3 sincos. */
void thumb_table_5_2_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)], double h[SINEW_AT_LEAST(4)]);

/* Joint accelerations M(q)^-1 (tau - C(q,qd) qd - g(q)). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   in  tau           4 [N m] joint torques; made for -1..1
 *   out qdd           4 [rad/s^2] joint accelerations
 * 70 multiplications, 62 additions, 3 divisions, 3 sincos. */
void thumb_table_5_2_forward_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)], const double tau[SINEW_AT_LEAST(4)], double qdd[SINEW_AT_LEAST(4)]);

/* Joint torques for a motion: M(q) qdd + C(q,qd) qd + g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   in  qdd           4 [rad/s^2] joint accelerations; made for -100..100
 *   out tau           4 [N m] joint torques
 * 63 multiplications, 51 additions, 3 sincos. */
void thumb_table_5_2_inverse_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)], const double qdd[SINEW_AT_LEAST(4)], double tau[SINEW_AT_LEAST(4)]);

/* Path lengths of the tendons. (5.5)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   out h             8 [m] tendon path lengths
 * 24 multiplications, 30 additions, 4 square roots, 2 sincos. */
void thumb_table_5_2_tendon_lengths(const double q[SINEW_AT_LEAST(4)], double h[SINEW_AT_LEAST(8)]);

/* Coupling matrix P = dh/dq. (5.9)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   out P           8x4 [m/rad] coupling matrix
 * 54 multiplications, 49 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_coupling_matrix(const double q[SINEW_AT_LEAST(4)], double P[SINEW_AT_LEAST(32)]);

/* Joint torques from tendon forces: tau = -P^T f. (5.8)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  f             8 [N] tendon forces, pulling; made for 0..100
 *   out tau           4 [N m] joint torques
 * 64 multiplications, 59 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_joint_torque(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)], double tau[SINEW_AT_LEAST(4)]);

/* Joint stiffness with the motors held: sum f_i d2h_i/dq2 + P^T diag(kt) P. (5.12)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981, -0.2..1.6, -0.2..1.6
 *   in  f             8 [N] tendon forces, pulling; made for 0..100
 *   in  kt            8 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K           4x4 [N m/rad] stiffness matrix, symmetric
 * 148 multiplications, 127 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_joint_stiffness(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)], const double kt[SINEW_AT_LEAST(8)], double K[SINEW_AT_LEAST(16)]);

#ifdef __cplusplus
}
#endif
#endif
