/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Friction of a guided tendon, capstan law
 *
 * Made by: sinew generate models/capstan
 * Model:   sha256 9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_CAPSTAN_H
#define SINEW_CAPSTAN_H

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

/* Friction of a bent tendon, in proportion to the pulling side's tension. (4.1)
 *   in  tension       1 [N] tendon force; made for 0..100
 *   in  bending       1 [rad] total bending angle; made for 0..6.3
 *   in  velocity      1 [m/s] tendon velocity, towards the motor; made for -0.1..0.1
 *   out force         1 [N] on the tendon
 * 4 multiplications, 2 additions, 1 divisions, 1 square roots, 6 other functions. */
void capstan_friction_force(double tension, double bending, double velocity,
    double force[SINEW_AT_LEAST(1)]);

/* Tension at the finger when the motor's side is known. (4.1)
 *   in  tension       1 [N] tendon force; made for 0..100
 *   in  bending       1 [rad] total bending angle; made for 0..6.3
 *   in  velocity      1 [m/s] tendon velocity, towards the motor; made for -0.1..0.1
 *   out force         1 [N] on the finger's side
 * 4 multiplications, 1 additions, 1 divisions, 1 square roots, 6 other functions. */
void capstan_transmitted_force(double tension, double bending, double velocity,
    double force[SINEW_AT_LEAST(1)]);

#ifdef __cplusplus
}
#endif
#endif
