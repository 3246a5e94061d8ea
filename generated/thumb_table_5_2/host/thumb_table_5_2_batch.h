/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model thumb_table_5_2 over many states;
 *     element k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/thumb_table_5_2
 * Model:   sha256 bbe6ad946c25f79dfb874427de1b09ec5897fef90ad1f6d32550868697528da8
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_thumb_table_5_2_BATCH_H
#define SINEW_thumb_table_5_2_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#include "../thumb_table_5_2.h" /* what the values of a status are called */

#ifdef __cplusplus
extern "C" {
#endif

void thumb_table_5_2_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T);
void thumb_table_5_2_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT J);
void thumb_table_5_2_mass_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT M);
void thumb_table_5_2_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C);
void thumb_table_5_2_gravity_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT g);
void thumb_table_5_2_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT h);
void thumb_table_5_2_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h);
void thumb_table_5_2_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd);
void thumb_table_5_2_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau);
void thumb_table_5_2_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT h);
void thumb_table_5_2_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P);
void thumb_table_5_2_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau);
void thumb_table_5_2_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K);
void thumb_table_5_2_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT H);
void thumb_table_5_2_link_position_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q_start, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status);
void thumb_table_5_2_link_position_warm_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q_start, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status);
void thumb_table_5_2_link_position_gradient_step_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT search, double *SINEW_RESTRICT next);
void thumb_table_5_2_link_position_status_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q, double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status);
void thumb_table_5_2_link_position_covariance_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT sigma, double *SINEW_RESTRICT covariance,
    int *SINEW_RESTRICT status);
void thumb_table_5_2_hinge_position_batch(int count, const double *SINEW_RESTRICT h,
    double *SINEW_RESTRICT q);
void thumb_table_5_2_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles);

#ifdef __cplusplus
}
#endif
#endif
