/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Hamatometacarpal joint: four-bar that carries the fifth finger
 *
 * Made by: sinew generate models/hmc
 * Model:   sha256 c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_HMC_H
#define SINEW_HMC_H

/* SI units; matrices row-major. Results are finite for every finite input. */

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

/* Coupler and rocker angle of the four-bar and their derivatives.
 *   in  theta2        1 [rad] crank angle; made for 1.047..2.094
 *   out out           4 [rad, rad, 1, 1] theta3, theta4, dtheta3/dtheta2, dtheta4/dtheta2
 * 28 multiplications, 13 additions, 3 divisions, 3 square roots, 1 sincos, 7 other functions. */
void hmc_four_bar(double theta2, double out[SINEW_AT_LEAST(4)]);

/* How far the four-bar is from locking.
 *   in  theta2        1 [rad] crank angle; made for 1.047..2.094
 *   out distance      1 [rad] angle between coupler and rocker, folded to 0..pi/2
 *   out status        1 [1] 0 fine, 1 at or beyond a locking pose
 * 6 multiplications, 7 additions, 2 square roots, 1 sincos, 7 other functions. */
void hmc_locking(double theta2, double distance[SINEW_AT_LEAST(1)], int *status);
enum { HMC_LOCKING_FINE = 0, HMC_LOCKING_LOCKED = 1 };

/* Pose of the coupler: maps its frame to the linkage's plane frame.
 *   in  theta2        1 [rad] crank angle; made for 1.047..2.094
 *   out T           4x4 [1 and m] homogeneous transform
 * 20 multiplications, 11 additions, 2 divisions, 3 square roots, 1 sincos, 5 other functions. */
void hmc_coupler_pose(double theta2, double T[SINEW_AT_LEAST(16)]);

/* Lengths of the two antagonistic tendons on the crank's pulley.
 *   in  theta2        1 [rad] crank angle; made for 1.047..2.094
 *   out h             2 [m] 0 at the reference crank angle
 * 1 multiplications, 1 additions. */
void hmc_tendon_lengths(double theta2, double h[SINEW_AT_LEAST(2)]);

#ifdef __cplusplus
}
#endif
#endif
