/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model hand behind one calling convention.
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f
 * Do not edit: change the model and generate again.
 */
#include "hand_catalogue.h"

#include "hand.h"

static void call_fingertips(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_fingertips(x + 0, x + 19, y + 0, y + 80);
}
static const double fingertips_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double fingertips_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6, 0.35,
    1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double fingertips_q_wrist_low[] = {0.337, 0.725};
static const double fingertips_q_wrist_high[] = {0.88, 1.269};
static const sinew_argument fingertips_inputs[] = {
    {"q", "rad", 19, 1, fingertips_q_low, fingertips_q_high},
    {"q_wrist", "rad", 2, 1, fingertips_q_wrist_low, fingertips_q_wrist_high},
};
static const sinew_argument fingertips_outputs[] = {
    {"in_palm", "1 and m", 20, 4, 0, 0},
    {"in_forearm", "1 and m", 20, 4, 0, 0},
};

static void call_finger_gravity(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_finger_gravity(x + 0, x + 19, x + 21, y + 0);
}
static const double finger_gravity_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double finger_gravity_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6,
    0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double finger_gravity_q_wrist_low[] = {0.337, 0.725};
static const double finger_gravity_q_wrist_high[] = {0.88, 1.269};
static const double finger_gravity_gravity_low[] = {-9.81, -9.81, -9.81};
static const double finger_gravity_gravity_high[] = {9.81, 9.81, 9.81};
static const sinew_argument finger_gravity_inputs[] = {
    {"q", "rad", 19, 1, finger_gravity_q_low, finger_gravity_q_high},
    {"q_wrist", "rad", 2, 1, finger_gravity_q_wrist_low, finger_gravity_q_wrist_high},
    {"gravity", "m/s^2", 3, 1, finger_gravity_gravity_low, finger_gravity_gravity_high},
};
static const sinew_argument finger_gravity_outputs[] = {
    {"g", "m/s^2", 5, 3, 0, 0},
};

static void call_tendon_lengths(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_tendon_lengths(x + 0, x + 19, y + 0);
}
static const double tendon_lengths_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double tendon_lengths_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6,
    0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double tendon_lengths_q_wrist_low[] = {0.337, 0.725};
static const double tendon_lengths_q_wrist_high[] = {0.88, 1.269};
static const sinew_argument tendon_lengths_inputs[] = {
    {"q", "rad", 19, 1, tendon_lengths_q_low, tendon_lengths_q_high},
    {"q_wrist", "rad", 2, 1, tendon_lengths_q_wrist_low, tendon_lengths_q_wrist_high},
};
static const sinew_argument tendon_lengths_outputs[] = {
    {"h", "m", 38, 1, 0, 0},
};

static void call_coupling_matrix(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_coupling_matrix(x + 0, x + 19, y + 0);
}
static const double coupling_matrix_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double coupling_matrix_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6,
    0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double coupling_matrix_q_wrist_low[] = {0.337, 0.725};
static const double coupling_matrix_q_wrist_high[] = {0.88, 1.269};
static const sinew_argument coupling_matrix_inputs[] = {
    {"q", "rad", 19, 1, coupling_matrix_q_low, coupling_matrix_q_high},
    {"q_wrist", "rad", 2, 1, coupling_matrix_q_wrist_low, coupling_matrix_q_wrist_high},
};
static const sinew_argument coupling_matrix_outputs[] = {
    {"P", "m/rad", 38, 21, 0, 0},
};

static void call_joint_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_joint_torque(x + 0, x + 19, x + 21, y + 0);
}
static const double joint_torque_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double joint_torque_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6, 0.35,
    1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double joint_torque_q_wrist_low[] = {0.337, 0.725};
static const double joint_torque_q_wrist_high[] = {0.88, 1.269};
static const double joint_torque_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double joint_torque_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0};
static const sinew_argument joint_torque_inputs[] = {
    {"q", "rad", 19, 1, joint_torque_q_low, joint_torque_q_high},
    {"q_wrist", "rad", 2, 1, joint_torque_q_wrist_low, joint_torque_q_wrist_high},
    {"f", "N", 38, 1, joint_torque_f_low, joint_torque_f_high},
};
static const sinew_argument joint_torque_outputs[] = {
    {"tau", "N m", 21, 1, 0, 0},
};

static void call_joint_stiffness(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_joint_stiffness(x + 0, x + 19, x + 21, x + 59, y + 0);
}
static const double joint_stiffness_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double joint_stiffness_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6,
    0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double joint_stiffness_q_wrist_low[] = {0.337, 0.725};
static const double joint_stiffness_q_wrist_high[] = {0.88, 1.269};
static const double joint_stiffness_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double joint_stiffness_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0};
static const double joint_stiffness_kt_low[] = {1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0};
static const double joint_stiffness_kt_high[] = {50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0};
static const sinew_argument joint_stiffness_inputs[] = {
    {"q", "rad", 19, 1, joint_stiffness_q_low, joint_stiffness_q_high},
    {"q_wrist", "rad", 2, 1, joint_stiffness_q_wrist_low, joint_stiffness_q_wrist_high},
    {"f", "N", 38, 1, joint_stiffness_f_low, joint_stiffness_f_high},
    {"kt", "N/m", 38, 1, joint_stiffness_kt_low, joint_stiffness_kt_high},
};
static const sinew_argument joint_stiffness_outputs[] = {
    {"K", "N m/rad", 21, 21, 0, 0},
};

static void call_feedforward(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_feedforward(x + 0, y + 0);
}
static const double feedforward_q_wrist_low[] = {0.337, 0.725};
static const double feedforward_q_wrist_high[] = {0.88, 1.269};
static const sinew_argument feedforward_inputs[] = {
    {"q_wrist", "rad", 2, 1, feedforward_q_wrist_low, feedforward_q_wrist_high},
};
static const sinew_argument feedforward_outputs[] = {
    {"delta_theta", "rad", 38, 1, 0, 0},
};

static void call_feedforward_rate(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_feedforward_rate(x + 0, x + 2, y + 0);
}
static const double feedforward_rate_q_wrist_low[] = {0.337, 0.725};
static const double feedforward_rate_q_wrist_high[] = {0.88, 1.269};
static const double feedforward_rate_qd_wrist_low[] = {-3.0, -3.0};
static const double feedforward_rate_qd_wrist_high[] = {3.0, 3.0};
static const sinew_argument feedforward_rate_inputs[] = {
    {"q_wrist", "rad", 2, 1, feedforward_rate_q_wrist_low, feedforward_rate_q_wrist_high},
    {"qd_wrist", "rad/s", 2, 1, feedforward_rate_qd_wrist_low, feedforward_rate_qd_wrist_high},
};
static const sinew_argument feedforward_rate_outputs[] = {
    {"delta_theta_rate", "rad/s", 38, 1, 0, 0},
};

static void call_wrist_passage(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_wrist_passage(x + 0, y + 0, y + 38);
}
static const double wrist_passage_q_wrist_low[] = {0.337, 0.725};
static const double wrist_passage_q_wrist_high[] = {0.88, 1.269};
static const sinew_argument wrist_passage_inputs[] = {
    {"q_wrist", "rad", 2, 1, wrist_passage_q_wrist_low, wrist_passage_q_wrist_high},
};
static const sinew_argument wrist_passage_outputs[] = {
    {"h", "m", 38, 1, 0, 0},
    {"P", "m/rad", 38, 2, 0, 0},
};

static void call_wrist_stiffness(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_wrist_stiffness(x + 0, x + 2, x + 40, x + 116, x + 154, y + 0);
}
static const double wrist_stiffness_q_wrist_low[] = {0.337, 0.725};
static const double wrist_stiffness_q_wrist_high[] = {0.88, 1.269};
static const double wrist_stiffness_h_low[] = {0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02};
static const double wrist_stiffness_h_high[] = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1,
    0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1,
    0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
static const double wrist_stiffness_P_low[] = {-0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02};
static const double wrist_stiffness_P_high[] = {0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02};
static const double wrist_stiffness_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double wrist_stiffness_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0};
static const double wrist_stiffness_kt_low[] = {1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0};
static const double wrist_stiffness_kt_high[] = {50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0};
static const sinew_argument wrist_stiffness_inputs[] = {
    {"q_wrist", "rad", 2, 1, wrist_stiffness_q_wrist_low, wrist_stiffness_q_wrist_high},
    {"h", "m", 38, 1, wrist_stiffness_h_low, wrist_stiffness_h_high},
    {"P", "m/rad", 38, 2, wrist_stiffness_P_low, wrist_stiffness_P_high},
    {"f", "N", 38, 1, wrist_stiffness_f_low, wrist_stiffness_f_high},
    {"kt", "N/m", 38, 1, wrist_stiffness_kt_low, wrist_stiffness_kt_high},
};
static const sinew_argument wrist_stiffness_outputs[] = {
    {"K_wrist", "N m/rad", 2, 2, 0, 0},
};

static void call_whole_stiffness(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_whole_stiffness(x + 0, x + 19, x + 95, x + 133, x + 171, y + 0);
}
static const double whole_stiffness_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2, -0.2,
    -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2,
    1.0471975511965976};
static const double whole_stiffness_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6,
    0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6, 2.0943951023931953};
static const double whole_stiffness_P_low[] = {-0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02, -0.02,
    -0.02, -0.02, -0.02, -0.02};
static const double whole_stiffness_P_high[] = {0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02,
    0.02, 0.02, 0.02, 0.02};
static const double whole_stiffness_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double whole_stiffness_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0};
static const double whole_stiffness_kt_low[] = {1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0};
static const double whole_stiffness_kt_high[] = {50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0};
static const double whole_stiffness_K_wrist_low[] = {-100.0, -100.0, -100.0, -100.0};
static const double whole_stiffness_K_wrist_high[] = {100.0, 100.0, 100.0, 100.0};
static const sinew_argument whole_stiffness_inputs[] = {
    {"q", "rad", 19, 1, whole_stiffness_q_low, whole_stiffness_q_high},
    {"P", "m/rad", 38, 2, whole_stiffness_P_low, whole_stiffness_P_high},
    {"f", "N", 38, 1, whole_stiffness_f_low, whole_stiffness_f_high},
    {"kt", "N/m", 38, 1, whole_stiffness_kt_low, whole_stiffness_kt_high},
    {"K_wrist", "N m/rad", 2, 2, whole_stiffness_K_wrist_low, whole_stiffness_K_wrist_high},
};
static const sinew_argument whole_stiffness_outputs[] = {
    {"K", "N m/rad", 21, 21, 0, 0},
};

static void call_inverse_dynamics(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hand_inverse_dynamics(x + 0, x + 18, x + 36, x + 54, y + 0);
}
static const double inverse_dynamics_q_low[] = {-0.6981317007977318, -0.6981317007977318, -0.2,
    -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.2, -0.35, -0.2, -0.2, -0.35, -0.2, -0.2};
static const double inverse_dynamics_q_high[] = {0.6981317007977318, 0.6981317007977318, 1.6, 1.6,
    0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 1.6, 0.35, 1.6, 1.6, 0.35, 1.6, 1.6};
static const double inverse_dynamics_qd_low[] = {-10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0,
    -10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0};
static const double inverse_dynamics_qd_high[] = {10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0,
    10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0};
static const double inverse_dynamics_qdd_low[] = {-100.0, -100.0, -100.0, -100.0, -100.0, -100.0,
    -100.0, -100.0, -100.0, -100.0, -100.0, -100.0, -100.0, -100.0, -100.0, -100.0, -100.0, -100.0};
static const double inverse_dynamics_qdd_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0};
static const double inverse_dynamics_g_low[] = {-9.81, -9.81, -9.81, -9.81, -9.81, -9.81, -9.81,
    -9.81, -9.81, -9.81, -9.81, -9.81, -9.81, -9.81, -9.81};
static const double inverse_dynamics_g_high[] = {9.81, 9.81, 9.81, 9.81, 9.81, 9.81, 9.81, 9.81,
    9.81, 9.81, 9.81, 9.81, 9.81, 9.81, 9.81};
static const sinew_argument inverse_dynamics_inputs[] = {
    {"q", "rad", 18, 1, inverse_dynamics_q_low, inverse_dynamics_q_high},
    {"qd", "rad/s", 18, 1, inverse_dynamics_qd_low, inverse_dynamics_qd_high},
    {"qdd", "rad/s^2", 18, 1, inverse_dynamics_qdd_low, inverse_dynamics_qdd_high},
    {"g", "m/s^2", 5, 3, inverse_dynamics_g_low, inverse_dynamics_g_high},
};
static const sinew_argument inverse_dynamics_outputs[] = {
    {"tau", "N m", 18, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"hand_fingertips", 2, 2, 21, 160, fingertips_inputs, fingertips_outputs, call_fingertips},
    {"hand_finger_gravity", 3, 1, 24, 15, finger_gravity_inputs, finger_gravity_outputs,
        call_finger_gravity},
    {"hand_tendon_lengths", 2, 1, 21, 38, tendon_lengths_inputs, tendon_lengths_outputs,
        call_tendon_lengths},
    {"hand_coupling_matrix", 2, 1, 21, 798, coupling_matrix_inputs, coupling_matrix_outputs,
        call_coupling_matrix},
    {"hand_joint_torque", 3, 1, 59, 21, joint_torque_inputs, joint_torque_outputs,
        call_joint_torque},
    {"hand_joint_stiffness", 4, 1, 97, 441, joint_stiffness_inputs, joint_stiffness_outputs,
        call_joint_stiffness},
    {"hand_feedforward", 1, 1, 2, 38, feedforward_inputs, feedforward_outputs, call_feedforward},
    {"hand_feedforward_rate", 2, 1, 4, 38, feedforward_rate_inputs, feedforward_rate_outputs,
        call_feedforward_rate},
    {"hand_wrist_passage", 1, 2, 2, 114, wrist_passage_inputs, wrist_passage_outputs,
        call_wrist_passage},
    {"hand_wrist_stiffness", 5, 1, 192, 4, wrist_stiffness_inputs, wrist_stiffness_outputs,
        call_wrist_stiffness},
    {"hand_whole_stiffness", 5, 1, 175, 441, whole_stiffness_inputs, whole_stiffness_outputs,
        call_whole_stiffness},
    {"hand_inverse_dynamics", 4, 1, 69, 18, inverse_dynamics_inputs, inverse_dynamics_outputs,
        call_inverse_dynamics},
};

const sinew_catalogue hand_catalogue = {"hand",
    "149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f", 8, 12, functions};
