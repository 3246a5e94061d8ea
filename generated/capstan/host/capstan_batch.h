/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model capstan over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/capstan
 * Model:   sha256 9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_capstan_BATCH_H
#define SINEW_capstan_BATCH_H

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

void capstan_friction_force_batch(int count, const double *SINEW_RESTRICT tension,
    const double *SINEW_RESTRICT bending, const double *SINEW_RESTRICT velocity,
    double *SINEW_RESTRICT force);
void capstan_transmitted_force_batch(int count, const double *SINEW_RESTRICT tension,
    const double *SINEW_RESTRICT bending, const double *SINEW_RESTRICT velocity,
    double *SINEW_RESTRICT force);

#ifdef __cplusplus
}
#endif
#endif
