/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model guiding over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/guiding
 * Model:   sha256 46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_guiding_BATCH_H
#define SINEW_guiding_BATCH_H

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

void guiding_friction_force_batch(int count, const double *SINEW_RESTRICT bending,
    const double *SINEW_RESTRICT velocity, double *SINEW_RESTRICT force);

#ifdef __cplusplus
}
#endif
#endif
