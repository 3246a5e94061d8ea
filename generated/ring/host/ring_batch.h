/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model ring over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/ring
 * Model:   sha256 a8bc321adefac22c0d65aa59ce2185ee47e4dfbbfa393b8abd0790fd9d4a1b7f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_ring_BATCH_H
#define SINEW_ring_BATCH_H

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

void ring_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T);
void ring_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J);
void ring_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M);
void ring_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C);
void ring_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g);
void ring_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h);
void ring_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h);
void ring_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd);
void ring_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau);
void ring_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT h);
void ring_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P);
void ring_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau);
void ring_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K);
void ring_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT H);
void ring_link_position_batch(int count, const double *SINEW_RESTRICT h, double *SINEW_RESTRICT q);
void ring_link_position_covariance_batch(int count, const double *SINEW_RESTRICT sigma,
    double *SINEW_RESTRICT covariance);
void ring_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles);

#ifdef __cplusplus
}
#endif
#endif
