/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Friction of a guided tendon, fitted form
 *
 * Made by: sinew generate models/guiding
 * Model:   sha256 46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_GUIDING_H
#define SINEW_GUIDING_H

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

/* Friction of a bent tendon, fitted form; opposes the tendon's motion. (4.1)
 *   in  bending       1 [rad] total bending angle; made for 0..6.3
 *   in  velocity      1 [m/s] tendon velocity, towards the motor; made for -0.1..0.1
 *   out force         1 [N] on the tendon
 * 4 multiplications, 2 additions, 1 divisions, 1 square roots, 5 other functions. */
void guiding_friction_force(double bending, double velocity, double force[SINEW_AT_LEAST(1)]);

#ifdef __cplusplus
}
#endif
#endif
