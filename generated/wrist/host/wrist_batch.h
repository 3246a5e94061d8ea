/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model wrist over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/wrist
 * Model:   sha256 5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_wrist_BATCH_H
#define SINEW_wrist_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#include "../wrist.h" /* what the values of a status are called */

#ifdef __cplusplus
extern "C" {
#endif

void wrist_pose_batch(int count, const double *SINEW_RESTRICT q71, const double *SINEW_RESTRICT q73,
    double *SINEW_RESTRICT T);
void wrist_points_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT ABC);
void wrist_palm_angles_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT angles);
void wrist_bar_angles_batch(int count, const double *SINEW_RESTRICT flexion,
    const double *SINEW_RESTRICT abduction, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT residual, int *SINEW_RESTRICT status);
void wrist_singularity_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT distance);
void wrist_status_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, int *SINEW_RESTRICT status);
void wrist_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT h);
void wrist_tendon_jacobian_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT P);
void wrist_bending_angles_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT angles);
void wrist_feedforward_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT delta_theta);
void wrist_feedforward_rate_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, const double *SINEW_RESTRICT dq71,
    const double *SINEW_RESTRICT dq73, double *SINEW_RESTRICT delta_theta_rate);
void wrist_joint_torque_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau);

#ifdef __cplusplus
}
#endif
#endif
