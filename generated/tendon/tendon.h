/* SPDX-License-Identifier: BSD-2-Clause
 *
 * One tendon in series with its lever
 *
 * Made by: sinew generate models/tendon
 * Model:   sha256 9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_TENDON_H
#define SINEW_TENDON_H

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

/* Stiffness of lever and tendon in series. 4.1
 *   in  k_lever       1 [N/m] stiffness of the lever; made for 0..5e+04
 *   out k             1 [N/m] 
 * 1 multiplications, 1 additions, 1 divisions, 2 other functions. */
void tendon_series_stiffness(double k_lever, double k[SINEW_AT_LEAST(1)]);

/* Tendon force and stiffness from the elongation, 0 when slack. 5.1
 *   in  elongation      1 [m] of lever and tendon together; made for -0.001..0.01495
 *   in  theta         1 [rad] where the search starts, e.g. the last angle; made for
 *     0.09548..0.8378
 *   out out           3 [N, N/m, rad] force, stiffness, lever angle
 *   out residual      1 [m] what is left of the elongation
 * 456 multiplications, 360 additions, 48 divisions, 18 square roots, 6 sincos, 113 other
 *     functions. */
void tendon_force(double elongation, double theta, double out[SINEW_AT_LEAST(3)],
    double residual[SINEW_AT_LEAST(1)]);

#ifdef __cplusplus
}
#endif
#endif
