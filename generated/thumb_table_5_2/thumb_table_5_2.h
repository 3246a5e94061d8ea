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

/* SI units; matrices row-major. Results are finite for every finite input.
 * Numbers such as (5.2) are those of equations in the model's source. */

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
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out T           4x4 [m] maps coordinates of the frame to the base
 * 13 multiplications, 7 additions, 4 sincos. */
void thumb_table_5_2_forward_kinematics(const double q[SINEW_AT_LEAST(4)],
    double T[SINEW_AT_LEAST(16)]);

/* Geometric Jacobian of the frame tip: linear rows first, base frame.
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out J           6x4 [m | 1] velocity and angular velocity a joint rate
 * 25 multiplications, 16 additions, 4 sincos. */
void thumb_table_5_2_tip_jacobian(const double q[SINEW_AT_LEAST(4)], double J[SINEW_AT_LEAST(24)]);

/* Mass matrix M(q), symmetric. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out M           4x4 [kg m^2] mass matrix
 * 22 multiplications, 23 additions, 3 sincos. */
void thumb_table_5_2_mass_matrix(const double q[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)]);

/* Coriolis matrix C(q,qd) in Christoffel form: dM/dt - 2 C is skew-symmetric. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out C           4x4 [kg m^2/s] Coriolis matrix
 * 41 multiplications, 30 additions, 3 sincos. */
void thumb_table_5_2_coriolis_matrix(const double q[SINEW_AT_LEAST(4)],
    const double qd[SINEW_AT_LEAST(4)], double C[SINEW_AT_LEAST(16)]);

/* Joint torques that hold the mechanism still: g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out g             4 [N m] gravity torques
 * 3 multiplications, 4 additions, 3 sincos. */
void thumb_table_5_2_gravity(const double q[SINEW_AT_LEAST(4)], double g[SINEW_AT_LEAST(4)]);

/* Joint torques at zero acceleration: C(q,qd) qd + g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out h             4 [N m] bias torques
 * 42 multiplications, 29 additions, 3 sincos. */
void thumb_table_5_2_bias(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    double h[SINEW_AT_LEAST(4)]);

/* Mass matrix and bias at once, with what they share computed once. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out M           4x4 [kg m^2] mass matrix
 *   out h             4 [N m] bias torques
 * 53 multiplications, 48 additions, 3 sincos. */
void thumb_table_5_2_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(4)],
    const double qd[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)], double h[SINEW_AT_LEAST(4)]);

/* Joint accelerations M(q)^-1 (tau - C(q,qd) qd - g(q)). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   in  tau           4 [N m] joint torques; made for -1..1
 *   out qdd           4 [rad/s^2] joint accelerations
 * 70 multiplications, 62 additions, 3 divisions, 3 sincos. */
void thumb_table_5_2_forward_dynamics(const double q[SINEW_AT_LEAST(4)],
    const double qd[SINEW_AT_LEAST(4)], const double tau[SINEW_AT_LEAST(4)],
    double qdd[SINEW_AT_LEAST(4)]);

/* Joint torques for a motion: M(q) qdd + C(q,qd) qd + g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   in  qdd           4 [rad/s^2] joint accelerations; made for -100..100
 *   out tau           4 [N m] joint torques
 * 63 multiplications, 51 additions, 3 sincos. */
void thumb_table_5_2_inverse_dynamics(const double q[SINEW_AT_LEAST(4)],
    const double qd[SINEW_AT_LEAST(4)], const double qdd[SINEW_AT_LEAST(4)],
    double tau[SINEW_AT_LEAST(4)]);

/* Path lengths of the tendons. (5.5)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out h             8 [m] tendon path lengths
 * 24 multiplications, 30 additions, 4 square roots, 2 sincos. */
void thumb_table_5_2_tendon_lengths(const double q[SINEW_AT_LEAST(4)], double h[SINEW_AT_LEAST(8)]);

/* Coupling matrix P = dh/dq. (5.9)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out P           8x4 [m/rad] coupling matrix
 * 54 multiplications, 49 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_coupling_matrix(const double q[SINEW_AT_LEAST(4)],
    double P[SINEW_AT_LEAST(32)]);

/* Joint torques from tendon forces: tau = -P^T f. (5.8)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  f             8 [N] tendon forces, pulling; made for 0..100
 *   out tau           4 [N m] joint torques
 * 64 multiplications, 59 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_joint_torque(const double q[SINEW_AT_LEAST(4)],
    const double f[SINEW_AT_LEAST(8)], double tau[SINEW_AT_LEAST(4)]);

/* Joint stiffness with the motors held: sum f_i d2h_i/dq2 + P^T diag(kt) P. (5.12)
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   in  f             8 [N] tendon forces, pulling; made for 0..100
 *   in  kt            8 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K           4x4 [N m/rad] stiffness matrix, symmetric
 * 148 multiplications, 127 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_joint_stiffness(const double q[SINEW_AT_LEAST(4)],
    const double f[SINEW_AT_LEAST(8)], const double kt[SINEW_AT_LEAST(8)],
    double K[SINEW_AT_LEAST(16)]);

/* Second derivatives of the path lengths.
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out H          8x16 [m/rad^2] each row a symmetric matrix, row-major
 * 110 multiplications, 102 additions, 4 divisions, 4 square roots, 2 sincos. */
void thumb_table_5_2_tendon_hessian(const double q[SINEW_AT_LEAST(4)],
    double H[SINEW_AT_LEAST(128)]);

/* Angles of the thumb's base by Levenberg-Marquardt. (5.24)
 *   in  h             4 [m] base tendon lengths; made for 0..0.1
 *   in  q_start       2 [rad] where the search starts, e.g. the last result; made for
 *     -0.6981..0.6981
 *   out q             2 [rad] q10, q11
 *   out correction      1 [rad] next Gauss-Newton step
 *   out status        1 [1] 0 converged, 1 not
 * 439 multiplications, 372 additions, 25 divisions, 21 square roots, 10 sincos, 64 other
 *     functions. */
void thumb_table_5_2_link_position(const double h[SINEW_AT_LEAST(4)],
    const double q_start[SINEW_AT_LEAST(2)], double q[SINEW_AT_LEAST(2)],
    double correction[SINEW_AT_LEAST(1)], int *status);
enum { THUMB_TABLE_5_2_LINK_POSITION_CONVERGED = 0, THUMB_TABLE_5_2_LINK_POSITION_NOT_CONVERGED
    = 1 };

/* Angles of the base by one Levenberg-Marquardt iteration, from a start a tick away. (5.24)
 *   in  h             4 [m] base tendon lengths; made for 0..0.1
 *   in  q_start       2 [rad] where the search starts, e.g. the last result; made for
 *     -0.6981..0.6981
 *   out q             2 [rad] q10, q11
 *   out correction      1 [rad] next Gauss-Newton step
 *   out status        1 [1] 0 converged, 1 not
 * 173 multiplications, 147 additions, 10 divisions, 9 square roots, 4 sincos, 22 other
 *     functions. */
void thumb_table_5_2_link_position_warm(const double h[SINEW_AT_LEAST(4)],
    const double q_start[SINEW_AT_LEAST(2)], double q[SINEW_AT_LEAST(2)],
    double correction[SINEW_AT_LEAST(1)], int *status);
enum { THUMB_TABLE_5_2_LINK_POSITION_WARM_CONVERGED = 0,
    THUMB_TABLE_5_2_LINK_POSITION_WARM_NOT_CONVERGED = 1 };

/* One iteration of the corrected gradient search. (5.24)
 *   in  h             4 [m] base tendon lengths; made for 0..0.1
 *   in  search        6 [rad, m^2/rad, rad/m^2, m^2] q10, q11, gradient (2), step, smallest cost;
 *     made for -0.6981..0.6981, -0.6981..0.6981, -0.001..0.001, -0.001..0.001, 0..300, 0..0.001
 *   out next          6 [rad, m^2/rad, rad/m^2, m^2] the state after it
 * 66 multiplications, 61 additions, 4 divisions, 4 square roots, 2 sincos, 14 other functions. */
void thumb_table_5_2_link_position_gradient_step(const double h[SINEW_AT_LEAST(4)],
    const double search[SINEW_AT_LEAST(6)], double next[SINEW_AT_LEAST(6)]);

/* Whether a search has arrived, whichever it was: the Gauss-Newton step left at its result. (5.24)
 *   in  h             4 [m] base tendon lengths; made for 0..0.1
 *   in  q             2 [rad] q10, q11, an estimate; made for -0.6981..0.6981
 *   out correction      1 [rad] next Gauss-Newton step
 *   out status        1 [1] 0 converged, 1 not
 * 82 multiplications, 70 additions, 5 divisions, 5 square roots, 2 sincos, 10 other functions. */
void thumb_table_5_2_link_position_status(const double h[SINEW_AT_LEAST(4)],
    const double q[SINEW_AT_LEAST(2)], double correction[SINEW_AT_LEAST(1)], int *status);
enum { THUMB_TABLE_5_2_LINK_POSITION_STATUS_CONVERGED = 0,
    THUMB_TABLE_5_2_LINK_POSITION_STATUS_NOT_CONVERGED = 1 };

/* Covariance of the thumb's base angles for noise on the lengths. (5.24)
 *   in  q             2 [rad] q10, q11; made for -0.6981..0.6981
 *   in  sigma         1 [m] standard deviation of a length; made for 0..0.002
 *   out covariance    2x2 [rad^2] sigma^2 (P^T P)^-1
 *   out status        1 [1] 0 fine, 1 where the lengths do not determine the angles
 * 70 multiplications, 57 additions, 5 divisions, 4 square roots, 2 sincos, 4 other functions. */
void thumb_table_5_2_link_position_covariance(const double q[SINEW_AT_LEAST(2)], double sigma,
    double covariance[SINEW_AT_LEAST(4)], int *status);
enum { THUMB_TABLE_5_2_LINK_POSITION_COVARIANCE_FINE = 0,
    THUMB_TABLE_5_2_LINK_POSITION_COVARIANCE_NOT_DETERMINED = 1 };

/* Positions of the joints behind the base from their tendons' lengths. (5.22)
 *   in  h             4 [m] lengths of the tendons behind the base; made for -0.03..0.03
 *   out q             2 [rad] joint positions from the third on
 * 2 multiplications, 3 additions. */
void thumb_table_5_2_hinge_position(const double h[SINEW_AT_LEAST(4)], double q[SINEW_AT_LEAST(2)]);

/* Total bending of each tendon in the finger: what guiding friction grows with. 4.2
 *   in  q             4 [rad] joint positions; made for -0.6981..0.6981, -0.6981..0.6981,
 *     -0.2..1.6, -0.2..1.6
 *   out angles        8 [rad] over its pulleys, and where its straight stretches lean away from q =
 *     0
 * 76 multiplications, 54 additions, 8 square roots, 2 sincos, 10 other functions. */
void thumb_table_5_2_bending_angles(const double q[SINEW_AT_LEAST(4)],
    double angles[SINEW_AT_LEAST(8)]);

#ifdef __cplusplus
}
#endif
#endif
