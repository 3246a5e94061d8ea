/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Wrist: double inverted parallelogram with 38 tendons
 *
 * Made by: sinew generate models/wrist
 * Model:   sha256 5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_WRIST_H
#define SINEW_WRIST_H

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

/* Pose of the palm: maps {ABC} to the forearm frame. (6.8)
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out T           4x4 [1 and m] homogeneous transform
 * 48 multiplications, 24 additions, 2 divisions, 2 square roots, 2 sincos, 4 other functions. */
void wrist_pose(double q71, double q73, double T[SINEW_AT_LEAST(16)]);

/* The palm's points A, B, C in the forearm frame. (6.4), (6.5)
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out ABC         3x3 [m] rows A, B, C
 * 44 multiplications, 22 additions, 2 divisions, 2 square roots, 2 sincos, 4 other functions. */
void wrist_points(double q71, double q73, double ABC[SINEW_AT_LEAST(9)]);

/* Direction of the palm from the bar angles.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out angles        2 [rad] flexion, abduction
 * 35 multiplications, 19 additions, 2 divisions, 2 square roots, 2 sincos, 8 other functions. */
void wrist_palm_angles(double q71, double q73, double angles[SINEW_AT_LEAST(2)]);

/* Bar angles that point the palm in a given direction.
 *   in  flexion       1 [rad] of the palm, about -y; made for -0.5236..0.5236
 *   in  abduction      1 [rad] of the palm, towards y; made for -0.3491..0.3491
 *   out q             2 [rad] q71, q73
 *   out residual      1 [rad] between the wanted and the reached direction
 *   out status        1 [1] 0 fine, 1 not reached
 * 393 multiplications, 232 additions, 20 divisions, 18 square roots, 8 sincos, 53 other
 *     functions. */
void wrist_bar_angles(double flexion, double abduction, double q[SINEW_AT_LEAST(2)],
    double residual[SINEW_AT_LEAST(1)], int *status);
enum { WRIST_BAR_ANGLES_FINE = 0, WRIST_BAR_ANGLES_NOT_REACHED = 1 };

/* Distance to the singular poses.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out distance      2 [rad] to the flat pose, to the dead centre
 * 23 multiplications, 14 additions, 1 divisions, 2 square roots, 2 sincos, 7 other functions. */
void wrist_singularity(double q71, double q73, double distance[SINEW_AT_LEAST(2)]);

/* Whether the pose is regular.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out status        1 [1] 0 fine, 1 at or beyond a singular pose
 * 24 multiplications, 15 additions, 1 divisions, 1 square roots, 2 sincos, 3 other functions. */
void wrist_status(double q71, double q73, int *status);
enum { WRIST_STATUS_FINE = 0, WRIST_STATUS_SINGULAR = 1 };

/* Lengths of the tendons through the wrist. (6.9)
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out h            38 [m] tendon lengths
 * 195 multiplications, 238 additions, 2 divisions, 40 square roots, 2 sincos, 4 other functions. */
void wrist_tendon_lengths(double q71, double q73, double h[SINEW_AT_LEAST(38)]);

/* Derivatives of the lengths by q71 and q73.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out P          38x2 [m/rad] dh/dq
 * 619 multiplications, 570 additions, 42 divisions, 40 square roots, 2 sincos, 12 other
 *     functions. */
void wrist_tendon_jacobian(double q71, double q73, double P[SINEW_AT_LEAST(76)]);

/* Second derivatives of the lengths by q71 and q73.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out H          38x4 [m/rad^2] each row a symmetric 2x2 matrix
 * 1501 multiplications, 1389 additions, 42 divisions, 40 square roots, 2 sincos, 21 other
 *     functions. */
void wrist_tendon_hessian(double q71, double q73, double H[SINEW_AT_LEAST(152)]);

/* Total bending of each tendon in the wrist.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out angles       38 [rad] against the forearm's and the palm's x axis
 * 661 multiplications, 532 additions, 2 divisions, 78 square roots, 2 sincos, 80 other
 *     functions. */
void wrist_bending_angles(double q71, double q73, double angles[SINEW_AT_LEAST(38)]);

/* Motor angles that hold the fingers still while the wrist moves.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   out delta_theta     38 [rad] 0 in the reference pose
 * 233 multiplications, 276 additions, 2 divisions, 40 square roots, 2 sincos, 4 other functions. */
void wrist_feedforward(double q71, double q73, double delta_theta[SINEW_AT_LEAST(38)]);

/* Rates of the motor angles of wrist_feedforward.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   in  dq71          1 [rad/s] rate of q71; made for -3..3
 *   in  dq73          1 [rad/s] rate of q73; made for -3..3
 *   out delta_theta_rate     38 [rad/s] 
 * 469 multiplications, 463 additions, 42 divisions, 40 square roots, 2 sincos, 9 other
 *     functions. */
void wrist_feedforward_rate(double q71, double q73, double dq71, double dq73,
    double delta_theta_rate[SINEW_AT_LEAST(38)]);

/* Torques of the tendons on q71, q73.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   in  f            38 [N] tendon forces; made for 0..100
 *   out tau           2 [N m] -P^T f
 * 502 multiplications, 532 additions, 42 divisions, 40 square roots, 2 sincos, 12 other
 *     functions. */
void wrist_joint_torque(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    double tau[SINEW_AT_LEAST(2)]);

/* Stiffness of the wrist's bars, motors held.
 *   in  q71           1 [rad] turns the bar plane about y; made for 0.337..0.88
 *   in  q73           1 [rad] swings the bars within their plane; made for 0.725..1.269
 *   in  f            38 [N] tendon forces; made for 0..100
 *   in  k            38 [N/m] tendon stiffnesses; made for 1000..5e+04
 *   out K           2x2 [N m/rad] sum of f d2h/dq2, plus P^T diag(k) P; symmetric
 * 1353 multiplications, 1180 additions, 42 divisions, 40 square roots, 2 sincos, 21 other
 *     functions. */
void wrist_joint_stiffness(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    const double k[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(4)]);

#ifdef __cplusplus
}
#endif
#endif
