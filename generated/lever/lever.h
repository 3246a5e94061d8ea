/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Variable-stiffness lever: force and stiffness of one tendon
 *
 * Made by: sinew generate models/lever
 * Model:   sha256 15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_LEVER_H
#define SINEW_LEVER_H

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

/* Tendon path and force of the variable-stiffness lever. 4.1
 *   in  theta         1 [rad] lever angle; made for 0.09548..0.8378
 *   out out           4 [m, m, N, N/m] dL, elongation, force, stiffness
 * 75 multiplications, 57 additions, 7 divisions, 3 square roots, 1 sincos, 16 other functions. */
void lever_state(double theta, double out[SINEW_AT_LEAST(4)]);

/* Derivatives of the tendon path and of the spring's energy by the lever angle. 4.1
 *   in  theta         1 [rad] lever angle; made for 0.09548..0.8378
 *   out out           2 [m/rad, N m/rad] dL', U'
 * 29 multiplications, 20 additions, 3 divisions, 3 square roots, 1 sincos, 4 other functions. */
void lever_slope(double theta, double out[SINEW_AT_LEAST(2)]);

/* Lever angle at an elongation of the tendon, by Newton's method. 4.1
 *   in  elongation      1 [m] tendon elongation; made for 0..0.01
 *   in  theta         1 [rad] where the search starts, e.g. the last angle; made for
 *     0.09548..0.8378
 *   out theta_lever      1 [rad] within the lever's travel
 *   out residual      1 [m] what is left of the elongation
 * 120 multiplications, 111 additions, 15 divisions, 12 square roots, 6 sincos, 65 other
 *     functions. */
void lever_angle(double elongation, double theta, double theta_lever[SINEW_AT_LEAST(1)],
    double residual[SINEW_AT_LEAST(1)]);

/* Whether the lever is within its travel and transmits force.
 *   in  theta         1 [rad] lever angle; made for 0.09548..0.8378
 *   out status        1 [1] 0 fine, 1 outside the travel or at a dead centre
 * 19 multiplications, 16 additions, 2 divisions, 2 square roots, 1 sincos, 12 other functions. */
void lever_status(double theta, int *status);
enum { LEVER_STATUS_FINE = 0, LEVER_STATUS_NOT_USABLE = 1 };

#ifdef __cplusplus
}
#endif
#endif
