/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model fifth over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/fifth
 * Model:   sha256 ae27d826145740fcb6e3f8c3b6f00dad5a582dbf0da2c06f617ce673f467b351
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_fifth_BATCH_H
#define SINEW_fifth_BATCH_H

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

void fifth_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T);
void fifth_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J);
void fifth_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M);
void fifth_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C);
void fifth_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g);
void fifth_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h);
void fifth_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h);
void fifth_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd);
void fifth_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau);
void fifth_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT h);
void fifth_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P);
void fifth_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau);
void fifth_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K);
void fifth_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT H);
void fifth_link_position_batch(int count, const double *SINEW_RESTRICT h, double *SINEW_RESTRICT q);
void fifth_link_position_covariance_batch(int count, const double *SINEW_RESTRICT sigma,
    double *SINEW_RESTRICT covariance);
void fifth_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles);

#ifdef __cplusplus
}
#endif
#endif
