/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The complete hand: 19 finger coordinates, two wrist angles, 38 tendons
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_HAND_H
#define SINEW_HAND_H

/* SI units; matrices row-major. Results are finite for every finite input.
 * Numbers such as (5.2) are those of equations in the model's source. */

/* Coordinates:
 *   q[0] thumb.q10 (rad)
 *   q[1] thumb.q11 (rad)
 *   q[2] thumb.q12 (rad)
 *   q[3] thumb.q13 (rad)
 *   q[4] index.q20 (rad)
 *   q[5] index.q21 (rad)
 *   q[6] index.q22 (rad)
 *   q[7] index.q23 (rad)
 *   q[8] middle.q30 (rad)
 *   q[9] middle.q31 (rad)
 *   q[10] middle.q32 (rad)
 *   q[11] middle.q33 (rad)
 *   q[12] ring.q40 (rad)
 *   q[13] ring.q41 (rad)
 *   q[14] ring.q42 (rad)
 *   q[15] fifth.q50 (rad)
 *   q[16] fifth.q51 (rad)
 *   q[17] fifth.q52 (rad)
 *   q[18] hmc.theta2 (rad)
 *   q_wrist: q71, q73 (rad), the last two columns of every matrix
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

/* Poses of the fingertips, homogeneous, one below the other in the order of the fingers.
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   out in_palm    20x4 [1 and m] map the tips' frames to {ABC}
 *   out in_forearm   20x4 [1 and m] map the tips' frames to {0}
 * 357 multiplications, 246 additions, 4 divisions, 5 square roots, 23 sincos, 9 other functions. */
void hand_fingertips(const double q[SINEW_AT_LEAST(19)], const double q_wrist[SINEW_AT_LEAST(2)],
    double in_palm[SINEW_AT_LEAST(80)], double in_forearm[SINEW_AT_LEAST(80)]);

/* Gravity in the base frame of each finger.
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   in  gravity       3 [m/s^2] in the forearm frame {0}; made for -9.81..9.81
 *   out g           5x3 [m/s^2] one row a finger, in their order
 * 82 multiplications, 45 additions, 4 divisions, 5 square roots, 3 sincos, 9 other functions. */
void hand_finger_gravity(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], const double gravity[SINEW_AT_LEAST(3)],
    double g[SINEW_AT_LEAST(15)]);

/* Path lengths of all tendons, wrist and finger together. (5.1)
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   out h            38 [m] by wrist channel
 * 234 multiplications, 328 additions, 2 divisions, 44 square roots, 4 sincos, 4 other functions. */
void hand_tendon_lengths(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], double h[SINEW_AT_LEAST(38)]);

/* Coupling matrix P = dh/d(q, q_wrist) of the whole hand.
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   out P         38x21 [m/rad] rows by wrist channel; the last two columns are q71, q73
 * 673 multiplications, 619 additions, 46 divisions, 44 square roots, 4 sincos, 12 other
 *     functions. */
void hand_coupling_matrix(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], double P[SINEW_AT_LEAST(798)]);

/* Torques on all joints from the tendon forces: tau = -P^T f. (5.8)
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   in  f            38 [N] tendon forces, pulling; made for 0..100
 *   out tau          21 [N m] fingers, crank, q71, q73
 * 782 multiplications, 738 additions, 46 divisions, 44 square roots, 4 sincos, 12 other
 *     functions. */
void hand_joint_torque(const double q[SINEW_AT_LEAST(19)], const double q_wrist[SINEW_AT_LEAST(2)],
    const double f[SINEW_AT_LEAST(38)], double tau[SINEW_AT_LEAST(21)]);

/* Stiffness of all joints with the motors held; wrist and fingers are coupled. (5.12)
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   in  f            38 [N] tendon forces, pulling; made for 0..100
 *   in  kt           38 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K         21x21 [N m/rad] symmetric; fingers, crank, q71, q73
 * 1667 multiplications, 1470 additions, 84 divisions, 44 square roots, 4 sincos, 23 other
 *     functions. */
void hand_joint_stiffness(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], const double f[SINEW_AT_LEAST(38)],
    const double kt[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(441)]);

/* Motor angles that hold the fingers still while the wrist moves.
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   out delta_theta     38 [rad] 0 in the reference pose
 * 233 multiplications, 276 additions, 2 divisions, 40 square roots, 2 sincos, 4 other functions. */
void hand_feedforward(const double q_wrist[SINEW_AT_LEAST(2)],
    double delta_theta[SINEW_AT_LEAST(38)]);

/* Rates of the motor angles of hand_feedforward.
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   in  qd_wrist      2 [rad/s] rates of the bar angles; made for -3..3
 *   out delta_theta_rate     38 [rad/s] 
 * 469 multiplications, 463 additions, 42 divisions, 40 square roots, 2 sincos, 9 other
 *     functions. */
void hand_feedforward_rate(const double q_wrist[SINEW_AT_LEAST(2)],
    const double qd_wrist[SINEW_AT_LEAST(2)], double delta_theta_rate[SINEW_AT_LEAST(38)]);

/* Lengths of all tendons through the wrist, and their derivatives by q71 and q73. (6.9)
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   out h            38 [m] without the fingers
 *   out P          38x2 [m/rad] 
 * 619 multiplications, 570 additions, 42 divisions, 40 square roots, 2 sincos, 12 other
 *     functions. */
void hand_wrist_passage(const double q_wrist[SINEW_AT_LEAST(2)], double h[SINEW_AT_LEAST(38)],
    double P[SINEW_AT_LEAST(76)]);

/* Stiffness of the wrist's bars: the last block of joint_stiffness.
 *   in  q_wrist       2 [rad] bar angles q71, q73; made for 0.337..0.88, 0.725..1.269
 *   in  h            38 [m] of wrist_passage; made for 0.02..0.1
 *   in  P          38x2 [m/rad] of wrist_passage; made for -0.02..0.02
 *   in  f            38 [N] tendon forces, pulling; made for 0..100
 *   in  kt           38 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K_wrist     2x2 [N m/rad] symmetric
 * 911 multiplications, 824 additions, 42 divisions, 2 square roots, 2 sincos, 21 other
 *     functions. */
void hand_wrist_stiffness(const double q_wrist[SINEW_AT_LEAST(2)],
    const double h[SINEW_AT_LEAST(38)], const double P[SINEW_AT_LEAST(76)],
    const double f[SINEW_AT_LEAST(38)], const double kt[SINEW_AT_LEAST(38)],
    double K_wrist[SINEW_AT_LEAST(4)]);

/* joint_stiffness where the wrist's own block is known. (5.12)
 *   in  q            19 [rad] coordinates of the fingers, crank angle; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  P          38x2 [m/rad] of wrist_passage; made for -0.02..0.02
 *   in  f            38 [N] tendon forces, pulling; made for 0..100
 *   in  kt           38 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   in  K_wrist     2x2 [N m/rad] of wrist_stiffness; made for -100..100
 *   out K         21x21 [N m/rad] symmetric; fingers, crank, q71, q73
 * 321 multiplications, 252 additions, 4 divisions, 4 square roots, 2 sincos. */
void hand_whole_stiffness(const double q[SINEW_AT_LEAST(19)], const double P[SINEW_AT_LEAST(76)],
    const double f[SINEW_AT_LEAST(38)], const double kt[SINEW_AT_LEAST(38)],
    const double K_wrist[SINEW_AT_LEAST(4)], double K[SINEW_AT_LEAST(441)]);

/* Joint torques that a motion of the fingers takes, each on a base at rest: M(q) qdd + C(q,qd) qd +
 *     g(q). (2.1)
 *   in  q            18 [rad] coordinates of the fingers; made for -0.6981..0.6981,
 *     -0.6981..0.6981, -0.2..1.6, -0.2..1.6, -0.35..0.35, -0.2..1.6, -0.2..1.6, -0.2..1.6, ...
 *   in  qd           18 [rad/s] their rates; made for -10..10
 *   in  qdd          18 [rad/s^2] accelerations; made for -100..100
 *   in  g           5x3 [m/s^2] gravity in the base frame of each finger, one row a finger; made
 *     for -9.81..9.81
 *   out tau          18 [N m] of the fingers, without a crank
 * 469 multiplications, 354 additions, 20 sincos. */
void hand_inverse_dynamics(const double q[SINEW_AT_LEAST(18)], const double qd[SINEW_AT_LEAST(18)],
    const double qdd[SINEW_AT_LEAST(18)], const double g[SINEW_AT_LEAST(15)],
    double tau[SINEW_AT_LEAST(18)]);

#ifdef __cplusplus
}
#endif
#endif
