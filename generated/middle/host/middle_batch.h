/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model middle over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/middle
 * Model:   sha256 5178dcc126793c8544b85aef441fae055a412f16d86c338979b82e8fddc6e30d
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_middle_BATCH_H
#define SINEW_middle_BATCH_H

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

void middle_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T);
void middle_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J);
void middle_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M);
void middle_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C);
void middle_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g);
void middle_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h);
void middle_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h);
void middle_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd);
void middle_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau);
void middle_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT h);
void middle_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P);
void middle_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau);
void middle_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K);
void middle_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT H);
void middle_link_position_batch(int count, const double *SINEW_RESTRICT h,
    double *SINEW_RESTRICT q);
void middle_link_position_covariance_batch(int count, const double *SINEW_RESTRICT sigma,
    double *SINEW_RESTRICT covariance);
void middle_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles);

#ifdef __cplusplus
}
#endif
#endif
