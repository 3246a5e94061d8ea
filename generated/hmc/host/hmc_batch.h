/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model hmc over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/hmc
 * Model:   sha256 c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_hmc_BATCH_H
#define SINEW_hmc_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#include "../hmc.h" /* what the values of a status are called */

#ifdef __cplusplus
extern "C" {
#endif

void hmc_four_bar_batch(int count, const double *SINEW_RESTRICT theta2, double *SINEW_RESTRICT out);
void hmc_locking_batch(int count, const double *SINEW_RESTRICT theta2,
    double *SINEW_RESTRICT distance, int *SINEW_RESTRICT status);
void hmc_coupler_pose_batch(int count, const double *SINEW_RESTRICT theta2,
    double *SINEW_RESTRICT T);
void hmc_tendon_lengths_batch(int count, const double *SINEW_RESTRICT theta2,
    double *SINEW_RESTRICT h);

#ifdef __cplusplus
}
#endif
#endif
