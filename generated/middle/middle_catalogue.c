/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model middle behind one calling convention.
 *
 * Made by: sinew generate models/middle
 * Model:   sha256 5178dcc126793c8544b85aef441fae055a412f16d86c338979b82e8fddc6e30d
 * Do not edit: change the model and generate again.
 */
#include "middle_catalogue.h"

#include "middle.h"

static void call_forward_kinematics(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_forward_kinematics(x + 0, y + 0);
}
static const double forward_kinematics_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double forward_kinematics_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument forward_kinematics_inputs[] = {
    {"q", "rad", 4, 1, forward_kinematics_q_low, forward_kinematics_q_high},
};
static const sinew_argument forward_kinematics_outputs[] = {
    {"T", "m", 4, 4, 0, 0},
};

static void call_tip_jacobian(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_tip_jacobian(x + 0, y + 0);
}
static const double tip_jacobian_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double tip_jacobian_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument tip_jacobian_inputs[] = {
    {"q", "rad", 4, 1, tip_jacobian_q_low, tip_jacobian_q_high},
};
static const sinew_argument tip_jacobian_outputs[] = {
    {"J", "m | 1", 6, 4, 0, 0},
};

static void call_mass_matrix(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_mass_matrix(x + 0, y + 0);
}
static const double mass_matrix_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double mass_matrix_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument mass_matrix_inputs[] = {
    {"q", "rad", 4, 1, mass_matrix_q_low, mass_matrix_q_high},
};
static const sinew_argument mass_matrix_outputs[] = {
    {"M", "kg m^2", 4, 4, 0, 0},
};

static void call_coriolis_matrix(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_coriolis_matrix(x + 0, x + 4, y + 0);
}
static const double coriolis_matrix_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double coriolis_matrix_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double coriolis_matrix_qd_low[] = {-10.0, -10.0, -10.0, -10.0};
static const double coriolis_matrix_qd_high[] = {10.0, 10.0, 10.0, 10.0};
static const sinew_argument coriolis_matrix_inputs[] = {
    {"q", "rad", 4, 1, coriolis_matrix_q_low, coriolis_matrix_q_high},
    {"qd", "rad/s", 4, 1, coriolis_matrix_qd_low, coriolis_matrix_qd_high},
};
static const sinew_argument coriolis_matrix_outputs[] = {
    {"C", "kg m^2/s", 4, 4, 0, 0},
};

static void call_gravity(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_gravity(x + 0, y + 0);
}
static const double gravity_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double gravity_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument gravity_inputs[] = {
    {"q", "rad", 4, 1, gravity_q_low, gravity_q_high},
};
static const sinew_argument gravity_outputs[] = {
    {"g", "N m", 4, 1, 0, 0},
};

static void call_bias(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_bias(x + 0, x + 4, y + 0);
}
static const double bias_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double bias_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double bias_qd_low[] = {-10.0, -10.0, -10.0, -10.0};
static const double bias_qd_high[] = {10.0, 10.0, 10.0, 10.0};
static const sinew_argument bias_inputs[] = {
    {"q", "rad", 4, 1, bias_q_low, bias_q_high},
    {"qd", "rad/s", 4, 1, bias_qd_low, bias_qd_high},
};
static const sinew_argument bias_outputs[] = {
    {"h", "N m", 4, 1, 0, 0},
};

static void call_mass_matrix_and_bias(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_mass_matrix_and_bias(x + 0, x + 4, y + 0, y + 16);
}
static const double mass_matrix_and_bias_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double mass_matrix_and_bias_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double mass_matrix_and_bias_qd_low[] = {-10.0, -10.0, -10.0, -10.0};
static const double mass_matrix_and_bias_qd_high[] = {10.0, 10.0, 10.0, 10.0};
static const sinew_argument mass_matrix_and_bias_inputs[] = {
    {"q", "rad", 4, 1, mass_matrix_and_bias_q_low, mass_matrix_and_bias_q_high},
    {"qd", "rad/s", 4, 1, mass_matrix_and_bias_qd_low, mass_matrix_and_bias_qd_high},
};
static const sinew_argument mass_matrix_and_bias_outputs[] = {
    {"M", "kg m^2", 4, 4, 0, 0},
    {"h", "N m", 4, 1, 0, 0},
};

static void call_forward_dynamics(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_forward_dynamics(x + 0, x + 4, x + 8, y + 0);
}
static const double forward_dynamics_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double forward_dynamics_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double forward_dynamics_qd_low[] = {-10.0, -10.0, -10.0, -10.0};
static const double forward_dynamics_qd_high[] = {10.0, 10.0, 10.0, 10.0};
static const double forward_dynamics_tau_low[] = {-1.0, -1.0, -1.0, -1.0};
static const double forward_dynamics_tau_high[] = {1.0, 1.0, 1.0, 1.0};
static const sinew_argument forward_dynamics_inputs[] = {
    {"q", "rad", 4, 1, forward_dynamics_q_low, forward_dynamics_q_high},
    {"qd", "rad/s", 4, 1, forward_dynamics_qd_low, forward_dynamics_qd_high},
    {"tau", "N m", 4, 1, forward_dynamics_tau_low, forward_dynamics_tau_high},
};
static const sinew_argument forward_dynamics_outputs[] = {
    {"qdd", "rad/s^2", 4, 1, 0, 0},
};

static void call_inverse_dynamics(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_inverse_dynamics(x + 0, x + 4, x + 8, y + 0);
}
static const double inverse_dynamics_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double inverse_dynamics_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double inverse_dynamics_qd_low[] = {-10.0, -10.0, -10.0, -10.0};
static const double inverse_dynamics_qd_high[] = {10.0, 10.0, 10.0, 10.0};
static const double inverse_dynamics_qdd_low[] = {-100.0, -100.0, -100.0, -100.0};
static const double inverse_dynamics_qdd_high[] = {100.0, 100.0, 100.0, 100.0};
static const sinew_argument inverse_dynamics_inputs[] = {
    {"q", "rad", 4, 1, inverse_dynamics_q_low, inverse_dynamics_q_high},
    {"qd", "rad/s", 4, 1, inverse_dynamics_qd_low, inverse_dynamics_qd_high},
    {"qdd", "rad/s^2", 4, 1, inverse_dynamics_qdd_low, inverse_dynamics_qdd_high},
};
static const sinew_argument inverse_dynamics_outputs[] = {
    {"tau", "N m", 4, 1, 0, 0},
};

static void call_tendon_lengths(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_tendon_lengths(x + 0, y + 0);
}
static const double tendon_lengths_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double tendon_lengths_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument tendon_lengths_inputs[] = {
    {"q", "rad", 4, 1, tendon_lengths_q_low, tendon_lengths_q_high},
};
static const sinew_argument tendon_lengths_outputs[] = {
    {"h", "m", 8, 1, 0, 0},
};

static void call_coupling_matrix(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_coupling_matrix(x + 0, y + 0);
}
static const double coupling_matrix_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double coupling_matrix_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument coupling_matrix_inputs[] = {
    {"q", "rad", 4, 1, coupling_matrix_q_low, coupling_matrix_q_high},
};
static const sinew_argument coupling_matrix_outputs[] = {
    {"P", "m/rad", 8, 4, 0, 0},
};

static void call_joint_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_joint_torque(x + 0, x + 4, y + 0);
}
static const double joint_torque_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double joint_torque_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double joint_torque_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double joint_torque_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0};
static const sinew_argument joint_torque_inputs[] = {
    {"q", "rad", 4, 1, joint_torque_q_low, joint_torque_q_high},
    {"f", "N", 8, 1, joint_torque_f_low, joint_torque_f_high},
};
static const sinew_argument joint_torque_outputs[] = {
    {"tau", "N m", 4, 1, 0, 0},
};

static void call_joint_stiffness(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_joint_stiffness(x + 0, x + 4, x + 12, y + 0);
}
static const double joint_stiffness_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double joint_stiffness_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const double joint_stiffness_f_low[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double joint_stiffness_f_high[] = {100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    100.0};
static const double joint_stiffness_kt_low[] = {1000.0, 1000.0, 1000.0, 1000.0, 1000.0, 1000.0,
    1000.0, 1000.0};
static const double joint_stiffness_kt_high[] = {50000.0, 50000.0, 50000.0, 50000.0, 50000.0,
    50000.0, 50000.0, 50000.0};
static const sinew_argument joint_stiffness_inputs[] = {
    {"q", "rad", 4, 1, joint_stiffness_q_low, joint_stiffness_q_high},
    {"f", "N", 8, 1, joint_stiffness_f_low, joint_stiffness_f_high},
    {"kt", "N/m", 8, 1, joint_stiffness_kt_low, joint_stiffness_kt_high},
};
static const sinew_argument joint_stiffness_outputs[] = {
    {"K", "N m/rad", 4, 4, 0, 0},
};

static void call_tendon_hessian(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_tendon_hessian(x + 0, y + 0);
}
static const double tendon_hessian_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double tendon_hessian_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument tendon_hessian_inputs[] = {
    {"q", "rad", 4, 1, tendon_hessian_q_low, tendon_hessian_q_high},
};
static const sinew_argument tendon_hessian_outputs[] = {
    {"H", "m/rad^2", 8, 16, 0, 0},
};

static void call_link_position(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_link_position(x + 0, y + 0);
}
static const double link_position_h_low[] = {-0.012674999999999999, -0.012674999999999999,
    -0.012674999999999999, -0.012674999999999999, -0.0088, -0.0088, -0.016, -0.016};
static const double link_position_h_high[] = {0.012674999999999999, 0.012674999999999999,
    0.012674999999999999, 0.012674999999999999, 0.0088, 0.0088, 0.016, 0.016};
static const sinew_argument link_position_inputs[] = {
    {"h", "m", 8, 1, link_position_h_low, link_position_h_high},
};
static const sinew_argument link_position_outputs[] = {
    {"q", "rad", 4, 1, 0, 0},
};

static void call_link_position_covariance(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_link_position_covariance(x[0], y + 0);
}
static const double link_position_covariance_sigma_low[] = {0.0};
static const double link_position_covariance_sigma_high[] = {0.002};
static const sinew_argument link_position_covariance_inputs[] = {
    {"sigma", "m", 1, 1, link_position_covariance_sigma_low, link_position_covariance_sigma_high},
};
static const sinew_argument link_position_covariance_outputs[] = {
    {"covariance", "rad^2", 4, 4, 0, 0},
};

static void call_bending_angles(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    middle_bending_angles(x + 0, y + 0);
}
static const double bending_angles_q_low[] = {-0.35, -0.2, -0.2, -0.2};
static const double bending_angles_q_high[] = {0.35, 1.6, 1.6, 1.6};
static const sinew_argument bending_angles_inputs[] = {
    {"q", "rad", 4, 1, bending_angles_q_low, bending_angles_q_high},
};
static const sinew_argument bending_angles_outputs[] = {
    {"angles", "rad", 8, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"middle_forward_kinematics", 1, 1, 4, 16, forward_kinematics_inputs,
        forward_kinematics_outputs, call_forward_kinematics},
    {"middle_tip_jacobian", 1, 1, 4, 24, tip_jacobian_inputs, tip_jacobian_outputs,
        call_tip_jacobian},
    {"middle_mass_matrix", 1, 1, 4, 16, mass_matrix_inputs, mass_matrix_outputs, call_mass_matrix},
    {"middle_coriolis_matrix", 2, 1, 8, 16, coriolis_matrix_inputs, coriolis_matrix_outputs,
        call_coriolis_matrix},
    {"middle_gravity", 1, 1, 4, 4, gravity_inputs, gravity_outputs, call_gravity},
    {"middle_bias", 2, 1, 8, 4, bias_inputs, bias_outputs, call_bias},
    {"middle_mass_matrix_and_bias", 2, 2, 8, 20, mass_matrix_and_bias_inputs,
        mass_matrix_and_bias_outputs, call_mass_matrix_and_bias},
    {"middle_forward_dynamics", 3, 1, 12, 4, forward_dynamics_inputs, forward_dynamics_outputs,
        call_forward_dynamics},
    {"middle_inverse_dynamics", 3, 1, 12, 4, inverse_dynamics_inputs, inverse_dynamics_outputs,
        call_inverse_dynamics},
    {"middle_tendon_lengths", 1, 1, 4, 8, tendon_lengths_inputs, tendon_lengths_outputs,
        call_tendon_lengths},
    {"middle_coupling_matrix", 1, 1, 4, 32, coupling_matrix_inputs, coupling_matrix_outputs,
        call_coupling_matrix},
    {"middle_joint_torque", 2, 1, 12, 4, joint_torque_inputs, joint_torque_outputs,
        call_joint_torque},
    {"middle_joint_stiffness", 3, 1, 20, 16, joint_stiffness_inputs, joint_stiffness_outputs,
        call_joint_stiffness},
    {"middle_tendon_hessian", 1, 1, 4, 128, tendon_hessian_inputs, tendon_hessian_outputs,
        call_tendon_hessian},
    {"middle_link_position", 1, 1, 8, 4, link_position_inputs, link_position_outputs,
        call_link_position},
    {"middle_link_position_covariance", 1, 1, 1, 16, link_position_covariance_inputs,
        link_position_covariance_outputs, call_link_position_covariance},
    {"middle_bending_angles", 1, 1, 4, 8, bending_angles_inputs, bending_angles_outputs,
        call_bending_angles},
};

const sinew_catalogue middle_catalogue = {"middle",
    "5178dcc126793c8544b85aef441fae055a412f16d86c338979b82e8fddc6e30d", 8, 17, functions};
