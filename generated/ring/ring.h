/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Ring finger: coupled PIP and DIP, three coordinates, six tendons
 *
 * Made by: sinew generate models/ring
 * Model:   sha256 a8bc321adefac22c0d65aa59ce2185ee47e4dfbbfa393b8abd0790fd9d4a1b7f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_RING_H
#define SINEW_RING_H

/* SI units; matrices row-major. Results are finite for every finite input.
 * Numbers such as (5.2) are those of equations in the model's source. */

/* Joint order (depth first from the base):
 *   q[0] q40 (revolute, rad)
 *   q[1] q41 (revolute, rad)
 *   q[2] q42 (revolute, rad)
 *   q43 = 1.2222222222222223 q42 follows
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
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out T           4x4 [m] maps coordinates of the frame to the base
 * 16 multiplications, 10 additions, 4 sincos. */
void ring_forward_kinematics(const double q[SINEW_AT_LEAST(3)], double T[SINEW_AT_LEAST(16)]);

/* Geometric Jacobian of the frame tip: linear rows first, base frame.
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out J           6x3 [m | 1] velocity and angular velocity a joint rate
 * 34 multiplications, 27 additions, 4 sincos. */
void ring_tip_jacobian(const double q[SINEW_AT_LEAST(3)], double J[SINEW_AT_LEAST(18)]);

/* Mass matrix M(q), symmetric. (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out M           3x3 [kg m^2] mass matrix
 * 31 multiplications, 31 additions, 3 sincos. */
void ring_mass_matrix(const double q[SINEW_AT_LEAST(3)], double M[SINEW_AT_LEAST(9)]);

/* Coriolis matrix C(q,qd) in Christoffel form: dM/dt - 2 C is skew-symmetric. (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  qd            3 [rad/s] joint velocities; made for -10..10
 *   out C           3x3 [kg m^2/s] Coriolis matrix
 * 63 multiplications, 50 additions, 3 sincos. */
void ring_coriolis_matrix(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    double C[SINEW_AT_LEAST(9)]);

/* Joint torques that hold the mechanism still: g(q). (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out g             3 [N m] gravity torques
 * 5 multiplications, 5 additions, 3 sincos. */
void ring_gravity(const double q[SINEW_AT_LEAST(3)], double g[SINEW_AT_LEAST(3)]);

/* Joint torques at zero acceleration: C(q,qd) qd + g(q). (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  qd            3 [rad/s] joint velocities; made for -10..10
 *   out h             3 [N m] bias torques
 * 52 multiplications, 35 additions, 3 sincos. */
void ring_bias(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    double h[SINEW_AT_LEAST(3)]);

/* Mass matrix and bias at once, with what they share computed once. (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  qd            3 [rad/s] joint velocities; made for -10..10
 *   out M           3x3 [kg m^2] mass matrix
 *   out h             3 [N m] bias torques
 * 72 multiplications, 63 additions, 3 sincos. */
void ring_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(3)],
    const double qd[SINEW_AT_LEAST(3)], double M[SINEW_AT_LEAST(9)], double h[SINEW_AT_LEAST(3)]);

/* Joint accelerations M(q)^-1 (tau - C(q,qd) qd - g(q)). (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  qd            3 [rad/s] joint velocities; made for -10..10
 *   in  tau           3 [N m] joint torques; made for -1..1
 *   out qdd           3 [rad/s^2] joint accelerations
 * 93 multiplications, 76 additions, 3 divisions, 3 sincos. */
void ring_forward_dynamics(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    const double tau[SINEW_AT_LEAST(3)], double qdd[SINEW_AT_LEAST(3)]);

/* Joint torques for a motion: M(q) qdd + C(q,qd) qd + g(q). (2.1)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  qd            3 [rad/s] joint velocities; made for -10..10
 *   in  qdd           3 [rad/s^2] joint accelerations; made for -100..100
 *   out tau           3 [N m] joint torques
 * 85 multiplications, 64 additions, 3 sincos. */
void ring_inverse_dynamics(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    const double qdd[SINEW_AT_LEAST(3)], double tau[SINEW_AT_LEAST(3)]);

/* Path lengths of the tendons. (5.5)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out h             6 [m] tendon path lengths
 * 3 multiplications, 2 additions. */
void ring_tendon_lengths(const double q[SINEW_AT_LEAST(3)], double h[SINEW_AT_LEAST(6)]);

/* Coupling matrix P = dh/dq. (5.9)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out P           6x3 [m/rad] coupling matrix
 * 0 multiplications, 0 additions. */
void ring_coupling_matrix(const double q[SINEW_AT_LEAST(3)], double P[SINEW_AT_LEAST(18)]);

/* Joint torques from tendon forces: tau = -P^T f. (5.8)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  f             6 [N] tendon forces, pulling; made for 0..100
 *   out tau           3 [N m] joint torques
 * 5 multiplications, 7 additions. */
void ring_joint_torque(const double q[SINEW_AT_LEAST(3)], const double f[SINEW_AT_LEAST(6)],
    double tau[SINEW_AT_LEAST(3)]);

/* Joint stiffness with the motors held: sum f_i d2h_i/dq2 + P^T diag(kt) P. (5.12)
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   in  f             6 [N] tendon forces, pulling; made for 0..100
 *   in  kt            6 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K           3x3 [N m/rad] stiffness matrix, symmetric
 * 5 multiplications, 7 additions. */
void ring_joint_stiffness(const double q[SINEW_AT_LEAST(3)], const double f[SINEW_AT_LEAST(6)],
    const double kt[SINEW_AT_LEAST(6)], double K[SINEW_AT_LEAST(9)]);

/* Second derivatives of the path lengths.
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out H           6x9 [m/rad^2] each row a symmetric matrix, row-major
 * 0 multiplications, 0 additions. */
void ring_tendon_hessian(const double q[SINEW_AT_LEAST(3)], double H[SINEW_AT_LEAST(54)]);

/* Joint positions from tendon lengths by least squares: P^+ (h - h(0)). (5.13)
 *   in  h             6 [m] tendon path lengths; made for -0.01267..0.01267, -0.01267..0.01267,
 *     -0.01267..0.01267, -0.01267..0.01267, -0.016..0.016, -0.016..0.016
 *   out q             3 [rad] joint positions
 * 5 multiplications, 7 additions. */
void ring_link_position(const double h[SINEW_AT_LEAST(6)], double q[SINEW_AT_LEAST(3)]);

/* Covariance of link_position for independent errors of the lengths: sigma^2 (P^T P)^-1.
 *   in  sigma         1 [m] standard deviation of a length; made for 0..0.002
 *   out covariance    3x3 [rad^2] symmetric
 * 3 multiplications, 0 additions. */
void ring_link_position_covariance(double sigma, double covariance[SINEW_AT_LEAST(9)]);

/* Total bending of each tendon in the finger: what guiding friction grows with. 4.2
 *   in  q             3 [rad] joint positions; made for -0.35..0.35, -0.2..1.6, -0.2..1.6
 *   out angles        6 [rad] over its pulleys, and where its straight stretches lean away from q =
 *     0
 * 1 multiplications, 2 additions, 4 other functions. */
void ring_bending_angles(const double q[SINEW_AT_LEAST(3)], double angles[SINEW_AT_LEAST(6)]);

#ifdef __cplusplus
}
#endif
#endif
