/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model lever over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/lever
 * Model:   sha256 15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_lever_BATCH_H
#define SINEW_lever_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#include "../lever.h" /* what the values of a status are called */

#ifdef __cplusplus
extern "C" {
#endif

void lever_state_batch(int count, const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT out);
void lever_slope_batch(int count, const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT out);
void lever_angle_batch(int count, const double *SINEW_RESTRICT elongation,
    const double *SINEW_RESTRICT theta, double *SINEW_RESTRICT theta_lever,
    double *SINEW_RESTRICT residual);
void lever_status_batch(int count, const double *SINEW_RESTRICT theta, int *SINEW_RESTRICT status);

#ifdef __cplusplus
}
#endif
#endif
