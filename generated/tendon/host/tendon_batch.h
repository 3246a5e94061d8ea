/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model tendon over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/tendon
 * Model:   sha256 9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_tendon_BATCH_H
#define SINEW_tendon_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

void tendon_series_stiffness_batch(int count, const double *SINEW_RESTRICT k_lever,
    double *SINEW_RESTRICT k);
void tendon_force_batch(int count, const double *SINEW_RESTRICT elongation,
    const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT out,
    double *SINEW_RESTRICT residual);

#ifdef __cplusplus
}
#endif
#endif
