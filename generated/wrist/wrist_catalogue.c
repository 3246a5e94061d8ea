/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model wrist behind one calling convention.
 *
 * Made by: sinew generate models/wrist
 * Model:   sha256 5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011
 * Do not edit: change the model and generate again.
 */
#include "wrist_catalogue.h"

#include "wrist.h"

static void call_pose(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_pose(x[0], x[1], y + 0);
}
static const double pose_q71_low[] = {0.337};
static const double pose_q71_high[] = {0.88};
static const double pose_q73_low[] = {0.725};
static const double pose_q73_high[] = {1.269};
static const sinew_argument pose_inputs[] = {
    {"q71", "rad", 1, 1, pose_q71_low, pose_q71_high},
    {"q73", "rad", 1, 1, pose_q73_low, pose_q73_high},
};
static const sinew_argument pose_outputs[] = {
    {"T", "1 and m", 4, 4, 0, 0},
};

static void call_points(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_points(x[0], x[1], y + 0);
}
static const double points_q71_low[] = {0.337};
static const double points_q71_high[] = {0.88};
static const double points_q73_low[] = {0.725};
static const double points_q73_high[] = {1.269};
static const sinew_argument points_inputs[] = {
    {"q71", "rad", 1, 1, points_q71_low, points_q71_high},
    {"q73", "rad", 1, 1, points_q73_low, points_q73_high},
};
static const sinew_argument points_outputs[] = {
    {"ABC", "m", 3, 3, 0, 0},
};

static void call_palm_angles(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_palm_angles(x[0], x[1], y + 0);
}
static const double palm_angles_q71_low[] = {0.337};
static const double palm_angles_q71_high[] = {0.88};
static const double palm_angles_q73_low[] = {0.725};
static const double palm_angles_q73_high[] = {1.269};
static const sinew_argument palm_angles_inputs[] = {
    {"q71", "rad", 1, 1, palm_angles_q71_low, palm_angles_q71_high},
    {"q73", "rad", 1, 1, palm_angles_q73_low, palm_angles_q73_high},
};
static const sinew_argument palm_angles_outputs[] = {
    {"angles", "rad", 2, 1, 0, 0},
};

static void call_bar_angles(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    int status;
    wrist_bar_angles(x[0], x[1], y + 0, y + 2, &status);
    y[3] = (double)status;
}
static const double bar_angles_flexion_low[] = {-0.5235987755982988};
static const double bar_angles_flexion_high[] = {0.5235987755982988};
static const double bar_angles_abduction_low[] = {-0.3490658503988659};
static const double bar_angles_abduction_high[] = {0.3490658503988659};
static const sinew_argument bar_angles_inputs[] = {
    {"flexion", "rad", 1, 1, bar_angles_flexion_low, bar_angles_flexion_high},
    {"abduction", "rad", 1, 1, bar_angles_abduction_low, bar_angles_abduction_high},
};
static const sinew_argument bar_angles_outputs[] = {
    {"q", "rad", 2, 1, 0, 0},
    {"residual", "rad", 1, 1, 0, 0},
    {"status", "1", 1, 1, 0, 0},
};

static void call_singularity(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_singularity(x[0], x[1], y + 0);
}
static const double singularity_q71_low[] = {0.337};
static const double singularity_q71_high[] = {0.88};
static const double singularity_q73_low[] = {0.725};
static const double singularity_q73_high[] = {1.269};
static const sinew_argument singularity_inputs[] = {
    {"q71", "rad", 1, 1, singularity_q71_low, singularity_q71_high},
    {"q73", "rad", 1, 1, singularity_q73_low, singularity_q73_high},
};
static const sinew_argument singularity_outputs[] = {
    {"distance", "rad", 2, 1, 0, 0},
};

static void call_status(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    int status;
    wrist_status(x[0], x[1], &status);
    y[0] = (double)status;
}
static const double status_q71_low[] = {0.337};
static const double status_q71_high[] = {0.88};
static const double status_q73_low[] = {0.725};
static const double status_q73_high[] = {1.269};
static const sinew_argument status_inputs[] = {
    {"q71", "rad", 1, 1, status_q71_low, status_q71_high},
    {"q73", "rad", 1, 1, status_q73_low, status_q73_high},
};
static const sinew_argument status_outputs[] = {
    {"status", "1", 1, 1, 0, 0},
};

static void call_tendon_lengths(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_tendon_lengths(x[0], x[1], y + 0);
}
static const double tendon_lengths_q71_low[] = {0.337};
static const double tendon_lengths_q71_high[] = {0.88};
static const double tendon_lengths_q73_low[] = {0.725};
static const double tendon_lengths_q73_high[] = {1.269};
static const sinew_argument tendon_lengths_inputs[] = {
    {"q71", "rad", 1, 1, tendon_lengths_q71_low, tendon_lengths_q71_high},
    {"q73", "rad", 1, 1, tendon_lengths_q73_low, tendon_lengths_q73_high},
};
static const sinew_argument tendon_lengths_outputs[] = {
    {"h", "m", 38, 1, 0, 0},
};

static void call_tendon_jacobian(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_tendon_jacobian(x[0], x[1], y + 0);
}
static const double tendon_jacobian_q71_low[] = {0.337};
static const double tendon_jacobian_q71_high[] = {0.88};
static const double tendon_jacobian_q73_low[] = {0.725};
static const double tendon_jacobian_q73_high[] = {1.269};
static const sinew_argument tendon_jacobian_inputs[] = {
    {"q71", "rad", 1, 1, tendon_jacobian_q71_low, tendon_jacobian_q71_high},
    {"q73", "rad", 1, 1, tendon_jacobian_q73_low, tendon_jacobian_q73_high},
};
static const sinew_argument tendon_jacobian_outputs[] = {
    {"P", "m/rad", 38, 2, 0, 0},
};

static void call_tendon_hessian(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_tendon_hessian(x[0], x[1], y + 0);
}
static const double tendon_hessian_q71_low[] = {0.337};
static const double tendon_hessian_q71_high[] = {0.88};
static const double tendon_hessian_q73_low[] = {0.725};
static const double tendon_hessian_q73_high[] = {1.269};
static const sinew_argument tendon_hessian_inputs[] = {
    {"q71", "rad", 1, 1, tendon_hessian_q71_low, tendon_hessian_q71_high},
    {"q73", "rad", 1, 1, tendon_hessian_q73_low, tendon_hessian_q73_high},
};
static const sinew_argument tendon_hessian_outputs[] = {
    {"H", "m/rad^2", 38, 4, 0, 0},
};

static void call_bending_angles(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_bending_angles(x[0], x[1], y + 0);
}
static const double bending_angles_q71_low[] = {0.337};
static const double bending_angles_q71_high[] = {0.88};
static const double bending_angles_q73_low[] = {0.725};
static const double bending_angles_q73_high[] = {1.269};
static const sinew_argument bending_angles_inputs[] = {
    {"q71", "rad", 1, 1, bending_angles_q71_low, bending_angles_q71_high},
    {"q73", "rad", 1, 1, bending_angles_q73_low, bending_angles_q73_high},
};
static const sinew_argument bending_angles_outputs[] = {
    {"angles", "rad", 38, 1, 0, 0},
};

static void call_feedforward(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_feedforward(x[0], x[1], y + 0);
}
static const double feedforward_q71_low[] = {0.337};
static const double feedforward_q71_high[] = {0.88};
static const double feedforward_q73_low[] = {0.725};
static const double feedforward_q73_high[] = {1.269};
static const sinew_argument feedforward_inputs[] = {
    {"q71", "rad", 1, 1, feedforward_q71_low, feedforward_q71_high},
    {"q73", "rad", 1, 1, feedforward_q73_low, feedforward_q73_high},
};
static const sinew_argument feedforward_outputs[] = {
    {"delta_theta", "rad", 38, 1, 0, 0},
};

static void call_feedforward_rate(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_feedforward_rate(x[0], x[1], x[2], x[3], y + 0);
}
static const double feedforward_rate_q71_low[] = {0.337};
static const double feedforward_rate_q71_high[] = {0.88};
static const double feedforward_rate_q73_low[] = {0.725};
static const double feedforward_rate_q73_high[] = {1.269};
static const double feedforward_rate_dq71_low[] = {-3.0};
static const double feedforward_rate_dq71_high[] = {3.0};
static const double feedforward_rate_dq73_low[] = {-3.0};
static const double feedforward_rate_dq73_high[] = {3.0};
static const sinew_argument feedforward_rate_inputs[] = {
    {"q71", "rad", 1, 1, feedforward_rate_q71_low, feedforward_rate_q71_high},
    {"q73", "rad", 1, 1, feedforward_rate_q73_low, feedforward_rate_q73_high},
    {"dq71", "rad/s", 1, 1, feedforward_rate_dq71_low, feedforward_rate_dq71_high},
    {"dq73", "rad/s", 1, 1, feedforward_rate_dq73_low, feedforward_rate_dq73_high},
};
static const sinew_argument feedforward_rate_outputs[] = {
    {"delta_theta_rate", "rad/s", 38, 1, 0, 0},
};

static void call_joint_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_joint_torque(x[0], x[1], x + 2, y + 0);
}
static const double joint_torque_q71_low[] = {0.337};
static const double joint_torque_q71_high[] = {0.88};
static const double joint_torque_q73_low[] = {0.725};
static const double joint_torque_q73_high[] = {1.269};
static const double joint_torque_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double joint_torque_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0};
static const sinew_argument joint_torque_inputs[] = {
    {"q71", "rad", 1, 1, joint_torque_q71_low, joint_torque_q71_high},
    {"q73", "rad", 1, 1, joint_torque_q73_low, joint_torque_q73_high},
    {"f", "N", 38, 1, joint_torque_f_low, joint_torque_f_high},
};
static const sinew_argument joint_torque_outputs[] = {
    {"tau", "N m", 2, 1, 0, 0},
};

static void call_joint_stiffness(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    wrist_joint_stiffness(x[0], x[1], x + 2, x + 40, y + 0);
}
static const double joint_stiffness_q71_low[] = {0.337};
static const double joint_stiffness_q71_high[] = {0.88};
static const double joint_stiffness_q73_low[] = {0.725};
static const double joint_stiffness_q73_high[] = {1.269};
static const double joint_stiffness_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double joint_stiffness_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0, 100.0, 100.0, 100.0, 100.0};
static const double joint_stiffness_k_low[] = {1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0};
static const double joint_stiffness_k_high[] = {50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0};
static const sinew_argument joint_stiffness_inputs[] = {
    {"q71", "rad", 1, 1, joint_stiffness_q71_low, joint_stiffness_q71_high},
    {"q73", "rad", 1, 1, joint_stiffness_q73_low, joint_stiffness_q73_high},
    {"f", "N", 38, 1, joint_stiffness_f_low, joint_stiffness_f_high},
    {"k", "N/m", 38, 1, joint_stiffness_k_low, joint_stiffness_k_high},
};
static const sinew_argument joint_stiffness_outputs[] = {
    {"K", "N m/rad", 2, 2, 0, 0},
};

static const sinew_function functions[] = {
    {"wrist_pose", 2, 1, 2, 16, pose_inputs, pose_outputs, call_pose},
    {"wrist_points", 2, 1, 2, 9, points_inputs, points_outputs, call_points},
    {"wrist_palm_angles", 2, 1, 2, 2, palm_angles_inputs, palm_angles_outputs, call_palm_angles},
    {"wrist_bar_angles", 2, 3, 2, 4, bar_angles_inputs, bar_angles_outputs, call_bar_angles},
    {"wrist_singularity", 2, 1, 2, 2, singularity_inputs, singularity_outputs, call_singularity},
    {"wrist_status", 2, 1, 2, 1, status_inputs, status_outputs, call_status},
    {"wrist_tendon_lengths", 2, 1, 2, 38, tendon_lengths_inputs, tendon_lengths_outputs,
        call_tendon_lengths},
    {"wrist_tendon_jacobian", 2, 1, 2, 76, tendon_jacobian_inputs, tendon_jacobian_outputs,
        call_tendon_jacobian},
    {"wrist_tendon_hessian", 2, 1, 2, 152, tendon_hessian_inputs, tendon_hessian_outputs,
        call_tendon_hessian},
    {"wrist_bending_angles", 2, 1, 2, 38, bending_angles_inputs, bending_angles_outputs,
        call_bending_angles},
    {"wrist_feedforward", 2, 1, 2, 38, feedforward_inputs, feedforward_outputs, call_feedforward},
    {"wrist_feedforward_rate", 4, 1, 4, 38, feedforward_rate_inputs, feedforward_rate_outputs,
        call_feedforward_rate},
    {"wrist_joint_torque", 3, 1, 40, 2, joint_torque_inputs, joint_torque_outputs,
        call_joint_torque},
    {"wrist_joint_stiffness", 4, 1, 78, 4, joint_stiffness_inputs, joint_stiffness_outputs,
        call_joint_stiffness},
};

const sinew_catalogue wrist_catalogue = {"wrist",
    "5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011", 8, 14, functions};
