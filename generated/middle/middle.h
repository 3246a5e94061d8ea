/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Middle finger: abduction, three flexion joints, eight tendons
 *
 * Made by: sinew generate models/middle
 * Model:   sha256 5178dcc126793c8544b85aef441fae055a412f16d86c338979b82e8fddc6e30d
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_MIDDLE_H
#define SINEW_MIDDLE_H

/* SI units; matrices row-major. Results are finite for every finite input.
 * Numbers such as (5.2) are those of equations in the model's source. */

/* Joint order (depth first from the base):
 *   q[0] q30 (revolute, rad)
 *   q[1] q31 (revolute, rad)
 *   q[2] q32 (revolute, rad)
 *   q[3] q33 (revolute, rad)
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
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out T           4x4 [m] maps coordinates of the frame to the base
 * 15 multiplications, 10 additions, 4 sincos. */
void middle_forward_kinematics(const double q[SINEW_AT_LEAST(4)], double T[SINEW_AT_LEAST(16)]);

/* Geometric Jacobian of the frame tip: linear rows first, base frame.
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out J           6x4 [m | 1] velocity and angular velocity a joint rate
 * 29 multiplications, 24 additions, 4 sincos. */
void middle_tip_jacobian(const double q[SINEW_AT_LEAST(4)], double J[SINEW_AT_LEAST(24)]);

/* Mass matrix M(q), symmetric. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out M           4x4 [kg m^2] mass matrix
 * 27 multiplications, 27 additions, 3 sincos. */
void middle_mass_matrix(const double q[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)]);

/* Coriolis matrix C(q,qd) in Christoffel form: dM/dt - 2 C is skew-symmetric. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out C           4x4 [kg m^2/s] Coriolis matrix
 * 56 multiplications, 45 additions, 3 sincos. */
void middle_coriolis_matrix(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    double C[SINEW_AT_LEAST(16)]);

/* Joint torques that hold the mechanism still: g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out g             4 [N m] gravity torques
 * 3 multiplications, 4 additions, 3 sincos. */
void middle_gravity(const double q[SINEW_AT_LEAST(4)], double g[SINEW_AT_LEAST(4)]);

/* Joint torques at zero acceleration: C(q,qd) qd + g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out h             4 [N m] bias torques
 * 49 multiplications, 34 additions, 3 sincos. */
void middle_bias(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    double h[SINEW_AT_LEAST(4)]);

/* Mass matrix and bias at once, with what they share computed once. (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   out M           4x4 [kg m^2] mass matrix
 *   out h             4 [N m] bias torques
 * 66 multiplications, 58 additions, 3 sincos. */
void middle_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(4)],
    const double qd[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)], double h[SINEW_AT_LEAST(4)]);

/* Joint accelerations M(q)^-1 (tau - C(q,qd) qd - g(q)). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   in  tau           4 [N m] joint torques; made for -1..1
 *   out qdd           4 [rad/s^2] joint accelerations
 * 98 multiplications, 84 additions, 3 divisions, 3 sincos. */
void middle_forward_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    const double tau[SINEW_AT_LEAST(4)], double qdd[SINEW_AT_LEAST(4)]);

/* Joint torques for a motion: M(q) qdd + C(q,qd) qd + g(q). (2.1)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  qd            4 [rad/s] joint velocities; made for -10..10
 *   in  qdd           4 [rad/s^2] joint accelerations; made for -100..100
 *   out tau           4 [N m] joint torques
 * 81 multiplications, 63 additions, 3 sincos. */
void middle_inverse_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    const double qdd[SINEW_AT_LEAST(4)], double tau[SINEW_AT_LEAST(4)]);

/* Path lengths of the tendons. (5.5)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out h             8 [m] tendon path lengths
 * 4 multiplications, 3 additions. */
void middle_tendon_lengths(const double q[SINEW_AT_LEAST(4)], double h[SINEW_AT_LEAST(8)]);

/* Coupling matrix P = dh/dq. (5.9)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out P           8x4 [m/rad] coupling matrix
 * 0 multiplications, 0 additions. */
void middle_coupling_matrix(const double q[SINEW_AT_LEAST(4)], double P[SINEW_AT_LEAST(32)]);

/* Joint torques from tendon forces: tau = -P^T f. (5.8)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  f             8 [N] tendon forces, pulling; made for 0..100
 *   out tau           4 [N m] joint torques
 * 6 multiplications, 10 additions. */
void middle_joint_torque(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)],
    double tau[SINEW_AT_LEAST(4)]);

/* Joint stiffness with the motors held: sum f_i d2h_i/dq2 + P^T diag(kt) P. (5.12)
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   in  f             8 [N] tendon forces, pulling; made for 0..100
 *   in  kt            8 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K           4x4 [N m/rad] stiffness matrix, symmetric
 * 10 multiplications, 10 additions. */
void middle_joint_stiffness(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)],
    const double kt[SINEW_AT_LEAST(8)], double K[SINEW_AT_LEAST(16)]);

/* Second derivatives of the path lengths.
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out H          8x16 [m/rad^2] each row a symmetric matrix, row-major
 * 0 multiplications, 0 additions. */
void middle_tendon_hessian(const double q[SINEW_AT_LEAST(4)], double H[SINEW_AT_LEAST(128)]);

/* Joint positions from tendon lengths by least squares: P^+ (h - h(0)). (5.13)
 *   in  h             8 [m] tendon path lengths; made for -0.01267..0.01267, -0.01267..0.01267,
 *     -0.01267..0.01267, -0.01267..0.01267, -0.0088..0.0088, -0.0088..0.0088, -0.016..0.016,
 *     -0.016..0.016
 *   out q             4 [rad] joint positions
 * 6 multiplications, 9 additions. */
void middle_link_position(const double h[SINEW_AT_LEAST(8)], double q[SINEW_AT_LEAST(4)]);

/* Covariance of link_position for independent errors of the lengths: sigma^2 (P^T P)^-1.
 *   in  sigma         1 [m] standard deviation of a length; made for 0..0.002
 *   out covariance    4x4 [rad^2] symmetric
 * 5 multiplications, 0 additions. */
void middle_link_position_covariance(double sigma, double covariance[SINEW_AT_LEAST(16)]);

/* Total bending of each tendon in the finger: what guiding friction grows with. 4.2
 *   in  q             4 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6,
 *     -0.2..1.6
 *   out angles        8 [rad] over its pulleys, and where its straight stretches lean away from q =
 *     0
 * 0 multiplications, 2 additions, 4 other functions. */
void middle_bending_angles(const double q[SINEW_AT_LEAST(4)], double angles[SINEW_AT_LEAST(8)]);

#ifdef __cplusplus
}
#endif
#endif
