/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model hand over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_hand_BATCH_H
#define SINEW_hand_BATCH_H

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

void hand_fingertips_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, double *SINEW_RESTRICT in_palm,
    double *SINEW_RESTRICT in_forearm);
void hand_finger_gravity_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, const double *SINEW_RESTRICT gravity,
    double *SINEW_RESTRICT g);
void hand_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, double *SINEW_RESTRICT h);
void hand_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, double *SINEW_RESTRICT P);
void hand_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, const double *SINEW_RESTRICT f,
    double *SINEW_RESTRICT tau);
void hand_feedforward_batch(int count, const double *SINEW_RESTRICT q_wrist,
    double *SINEW_RESTRICT delta_theta);
void hand_feedforward_rate_batch(int count, const double *SINEW_RESTRICT q_wrist,
    const double *SINEW_RESTRICT qd_wrist, double *SINEW_RESTRICT delta_theta_rate);
void hand_wrist_passage_batch(int count, const double *SINEW_RESTRICT q_wrist,
    double *SINEW_RESTRICT h, double *SINEW_RESTRICT P);
void hand_wrist_stiffness_batch(int count, const double *SINEW_RESTRICT q_wrist,
    const double *SINEW_RESTRICT h, const double *SINEW_RESTRICT P, const double *SINEW_RESTRICT f,
    const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K_wrist);
void hand_whole_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT P, const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt,
    const double *SINEW_RESTRICT K_wrist, double *SINEW_RESTRICT K);
void hand_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd,
    const double *SINEW_RESTRICT g, double *SINEW_RESTRICT tau);

#ifdef __cplusplus
}
#endif
#endif
