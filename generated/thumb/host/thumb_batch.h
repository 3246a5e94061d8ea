/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model thumb over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/thumb
 * Model:   sha256 a1887dfbbeca57cfa47ae5f680c6749b28b13c33cd3d097b0d35ffdcc7f65850
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_thumb_BATCH_H
#define SINEW_thumb_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#include "../thumb.h" /* what the values of a status are called */

#ifdef __cplusplus
extern "C" {
#endif

void thumb_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T);
void thumb_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J);
void thumb_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M);
void thumb_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C);
void thumb_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g);
void thumb_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h);
void thumb_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h);
void thumb_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd);
void thumb_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau);
void thumb_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT h);
void thumb_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P);
void thumb_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau);
void thumb_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K);
void thumb_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT H);
void thumb_link_position_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q_start, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status);
void thumb_link_position_warm_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q_start, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status);
void thumb_link_position_gradient_step_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT search, double *SINEW_RESTRICT next);
void thumb_link_position_status_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q, double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status);
void thumb_link_position_covariance_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT sigma, double *SINEW_RESTRICT covariance,
    int *SINEW_RESTRICT status);
void thumb_hinge_position_batch(int count, const double *SINEW_RESTRICT h,
    double *SINEW_RESTRICT q);
void thumb_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles);

#ifdef __cplusplus
}
#endif
#endif
