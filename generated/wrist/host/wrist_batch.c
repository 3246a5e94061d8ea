/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model wrist over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/wrist
 * Model:   sha256 5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011
 * Do not edit: change the model and generate again.
 */
#include "wrist_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void wrist_pose_batch(int count, const double *SINEW_RESTRICT q71, const double *SINEW_RESTRICT q73,
    double *SINEW_RESTRICT T)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double M_e = 0.5 * (B_e + C_e);
        const double s_e = M_e - 0.036 * sin_q71;
        const double M_y = 0.5 * (B_y - C_y);
        const double s_y = 0.021 - M_y;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t1 = 1.0 / reach_squared;
        const double sin_A = (p_y * root - p_z * limited) * t1;
        const double x_plane_x = u_y * sin_A;
        const double cos_A = (p_y * limited + p_z * root) * t1;
        const double z_plane_x = u_y * cos_A;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double z_plane_y = u_e * cos_A;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        T[state] = cos_q71 * x_plane_x + sin_q71 * cos_A;
        T[1 * n + state] = cos_q71 * u_e;
        T[2 * n + state] = z_x;
        T[3 * n + state] = cos_q71 * M_e - 0.018 * z_x;
        T[4 * n + state] = -(u_e * sin_A);
        T[5 * n + state] = u_y;
        T[6 * n + state] = -z_plane_y;
        T[7 * n + state] = M_y + 0.018 * z_plane_y;
        T[8 * n + state] = -(cos_q71 * cos_A - sin_q71 * x_plane_x);
        T[9 * n + state] = sin_q71 * u_e;
        T[10 * n + state] = z_z;
        T[11 * n + state] = sin_q71 * M_e - 0.018 * z_z;
        T[12 * n + state] = 0.0;
        T[13 * n + state] = 0.0;
        T[14 * n + state] = 0.0;
        T[15 * n + state] = 1.0;
    }
}

void wrist_points_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT ABC)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double M_e = 0.5 * (B_e + C_e);
        const double s_e = M_e - 0.036 * sin_q71;
        const double M_y = 0.5 * (B_y - C_y);
        const double s_y = 0.021 - M_y;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t1 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t1;
        const double z_plane_x = u_y * cos_A;
        const double sin_A = (p_y * root - p_z * limited) * t1;
        ABC[state] = cos_q71 * M_e - 0.036 * (cos_q71 * z_plane_x - sin_q71 * sin_A);
        ABC[1 * n + state] = M_y + 0.036 * u_e * cos_A;
        ABC[2 * n + state] = sin_q71 * M_e - 0.036 * (cos_q71 * sin_A + sin_q71 * z_plane_x);
        ABC[3 * n + state] = cos_q71 * B_e;
        ABC[4 * n + state] = B_y;
        ABC[5 * n + state] = sin_q71 * B_e;
        ABC[6 * n + state] = cos_q71 * C_e;
        ABC[7 * n + state] = -C_y;
        ABC[8 * n + state] = sin_q71 * C_e;
    }
}

void wrist_palm_angles_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT angles)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double s_e = 0.5 * (B_e + C_e) - 0.036 * sin_q71;
        const double s_y = 0.5 * (C_y - B_y) + 0.021;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t1 = 1.0 / reach_squared;
        const double sin_A = (p_y * root - p_z * limited) * t1;
        const double x_plane_x = u_y * sin_A;
        const double cos_A = (p_y * limited + p_z * root) * t1;
        const double t2 = sinew_atan2(-(cos_q71 * cos_A - sin_q71 * x_plane_x), cos_q71 * x_plane_x
            + sin_q71 * cos_A);
        angles[state] = t2;
        angles[1 * n + state] = sinew_asin(sinew_min(sinew_max(-(u_e * sin_A), -1.0), 1.0));
    }
}

void wrist_bar_angles_batch(int count, const double *SINEW_RESTRICT flexion,
    const double *SINEW_RESTRICT abduction, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT residual, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double limited_flexion = sinew_min(sinew_max(flexion[state], -1.5), 1.5);
        const double t1 = 0.5 * limited_flexion;
        const double limited_abduction = sinew_min(sinew_max(abduction[state], -1.5), 1.5);
        double s2, c3;
        sinew_sincos(t1, &s2, &c3);
        double v_y, level;
        sinew_sincos(limited_abduction, &v_y, &level);
        double s4, c5;
        sinew_sincos(limited_flexion, &s4, &c5);
        const double q71_start = t1 + sinew_asin(0.584304725845076 * c3);
        double sin_q71, cos_q71;
        sinew_sincos(q71_start, &sin_q71, &cos_q71);
        const double v_x = level * c5;
        const double v_z = level * s4;
        const double v_e = v_x * cos_q71 + v_z * sin_q71;
        const double t6 = v_e * v_e;
        const double t7 = v_y * v_y;
        const double t8 = 1e-12 - t7;
        const double v_e_by_q71 = v_x * sin_q71 - v_z * cos_q71;
        const double t9 = 1.0 / sinew_sqrt(sinew_max(t7 + t6, 1e-12));
        const double v_length_by_q71 = v_e * v_e_by_q71 * sinew_choose(-(t8 - t6), 1.0, 0.0) * t9;
        const double cos_tilt = v_e * t9;
        const double cos_tilt_by_q71 = (v_e_by_q71 - cos_tilt * v_length_by_q71) * t9;
        const double t10 = 0.5 * cos_tilt;
        const double cos_half_tilt = sinew_sqrt(sinew_max(0.5 + t10, 1e-12));
        const double t11 = 1.0 / cos_half_tilt;
        const double cos_half_tilt_by_q71 = 0.25 * cos_tilt_by_q71 * sinew_choose(0.499999999999
            + t10, 1.0, 0.0) * t11;
        const double cos_sum_by_q71 = 0.5632638698251111 * cos_half_tilt_by_q71;
        const double cos_sum = 0.5632638698251111 * cos_half_tilt;
        const double sin_sum = sinew_sqrt(1.0 - cos_sum * cos_sum);
        const double sin_sum_by_q71 = cos_sum * cos_sum_by_q71 / sin_sum;
        const double sin_tilt = v_y * t9;
        const double sin_half_tilt = 0.5 * sin_tilt * t11;
        const double sin_tilt_by_q71 = sin_tilt * v_length_by_q71 * t9;
        const double t12 = 0.5 * (sin_tilt_by_q71 + (sin_half_tilt + sin_half_tilt)
            * cos_half_tilt_by_q71);
        const double sin_half_tilt_by_q71 = t12 * t11;
        const double t13 = cos_half_tilt * sin_sum_by_q71 + sin_half_tilt * cos_sum_by_q71 - cos_sum
            * sin_half_tilt_by_q71;
        const double sin_q73_by_q71 = t13 - sin_sum * cos_half_tilt_by_q71;
        const double t14 = 0.074565407529229 * cos_q71;
        const double u_x = cos_q71 * sin_tilt;
        const double u_z_by_q71 = u_x + sin_q71 * sin_tilt_by_q71;
        const double u_z = sin_q71 * sin_tilt;
        const double u_x_by_q71 = u_z - cos_q71 * sin_tilt_by_q71;
        const double t15 = 0.021 * u_x_by_q71 - 0.036 * (v_y * u_z_by_q71 - v_z * cos_tilt_by_q71)
            - t14 * sin_q73_by_q71;
        const double sin_q73 = cos_half_tilt * sin_sum - sin_half_tilt * cos_sum;
        const double t16 = 0.074565407529229 * sin_q71;
        const double t17 = t16 * sin_q73;
        const double t18 = t14 * sin_q73;
        const double gap_x = 0.021 * u_x + 0.036 * (v_y * u_z + v_z * cos_tilt) + t18;
        const double t19 = cos_half_tilt * cos_sum_by_q71 - sin_half_tilt * sin_sum_by_q71 + cos_sum
            * cos_half_tilt_by_q71;
        const double gap_y_by_q71 = 0.021 * cos_tilt_by_q71 - 0.036 * (v_x * u_z_by_q71 + v_z
            * u_x_by_q71) - 0.074565407529229 * (t19 - sin_sum * sin_half_tilt_by_q71);
        const double cos_q73 = cos_half_tilt * cos_sum + sin_half_tilt * sin_sum;
        const double gap_y = 0.021 + 0.021 * cos_tilt + 0.036 * (v_x * u_z - v_z * u_x)
            - 0.074565407529229 * cos_q73;
        const double t20 = 0.021 * u_z_by_q71 + 0.036 * (v_x * cos_tilt_by_q71 + v_y * u_x_by_q71)
            + t18;
        const double gap_z = 0.036 - 0.021 * u_z + 0.036 * (v_x * cos_tilt + v_y * u_x) - t17;
        const double mismatch_by_q71 = gap_x * (t15 + t17) + gap_y * gap_y_by_q71 + gap_z * (t20
            + t16 * sin_q73_by_q71);
        const double t21 = -mismatch_by_q71;
        const double safe_slope = sinew_choose(t21, sinew_max(t21, 1.8e-09), sinew_min(t21,
            -1.8e-09));
        const double mismatch = 0.001898 - 0.5 * (gap_x * gap_x + gap_y * gap_y + gap_z * gap_z);
        const double q71 = q71_start + sinew_min(sinew_max(mismatch / safe_slope, -0.2), 0.2);
        double sin_q71_2, cos_q71_2;
        sinew_sincos(q71, &sin_q71_2, &cos_q71_2);
        const double v_e_2 = v_x * cos_q71_2 + v_z * sin_q71_2;
        const double t22 = v_e_2 * v_e_2;
        const double t23 = 1.0 / sinew_sqrt(sinew_max(t7 + t22, 1e-12));
        const double cos_tilt_2 = v_e_2 * t23;
        const double sin_tilt_2 = v_y * t23;
        const double u_z_2 = sin_q71_2 * sin_tilt_2;
        const double u_x_2 = cos_q71_2 * sin_tilt_2;
        const double t24 = 0.5 * cos_tilt_2;
        const double cos_half_tilt_2 = sinew_sqrt(sinew_max(0.5 + t24, 1e-12));
        const double cos_sum_2 = 0.5632638698251111 * cos_half_tilt_2;
        const double sin_sum_2 = sinew_sqrt(1.0 - cos_sum_2 * cos_sum_2);
        const double t25 = 1.0 / cos_half_tilt_2;
        const double sin_half_tilt_2 = 0.5 * sin_tilt_2 * t25;
        const double sin_q73_2 = cos_half_tilt_2 * sin_sum_2 - sin_half_tilt_2 * cos_sum_2;
        const double t26 = 0.074565407529229 * cos_q71_2;
        const double t27 = t26 * sin_q73_2;
        const double gap_x_2 = 0.021 * u_x_2 + 0.036 * (v_y * u_z_2 + v_z * cos_tilt_2) + t27;
        const double cos_q73_2 = cos_half_tilt_2 * cos_sum_2 + sin_half_tilt_2 * sin_sum_2;
        const double gap_y_2 = 0.021 + 0.021 * cos_tilt_2 + 0.036 * (v_x * u_z_2 - v_z * u_x_2)
            - 0.074565407529229 * cos_q73_2;
        const double t28 = 0.074565407529229 * sin_q71_2;
        const double t29 = t28 * sin_q73_2;
        const double gap_z_2 = 0.036 - 0.021 * u_z_2 + 0.036 * (v_x * cos_tilt_2 + v_y * u_x_2)
            - t29;
        const double mismatch_2 = 0.001898 - 0.5 * (gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + gap_z_2
            * gap_z_2);
        const double v_e_2_by_q71 = v_x * sin_q71_2 - v_z * cos_q71_2;
        const double v_length_2_by_q71 = v_e_2 * v_e_2_by_q71 * sinew_choose(-(t8 - t22), 1.0, 0.0)
            * t23;
        const double sin_tilt_2_by_q71 = sin_tilt_2 * v_length_2_by_q71 * t23;
        const double u_x_2_by_q71 = u_z_2 - cos_q71_2 * sin_tilt_2_by_q71;
        const double u_z_2_by_q71 = u_x_2 + sin_q71_2 * sin_tilt_2_by_q71;
        const double cos_tilt_2_by_q71 = (v_e_2_by_q71 - cos_tilt_2 * v_length_2_by_q71) * t23;
        const double z_x_2_by_q71 = v_y * u_z_2_by_q71 - v_z * cos_tilt_2_by_q71;
        const double cos_half_tilt_2_by_q71 = 0.25 * cos_tilt_2_by_q71 * sinew_choose(0.499999999999
            + t24, 1.0, 0.0) * t25;
        const double cos_sum_2_by_q71 = 0.5632638698251111 * cos_half_tilt_2_by_q71;
        const double sin_sum_2_by_q71 = cos_sum_2 * cos_sum_2_by_q71 / sin_sum_2;
        const double t30 = sin_tilt_2_by_q71 + (sin_half_tilt_2 + sin_half_tilt_2)
            * cos_half_tilt_2_by_q71;
        const double sin_half_tilt_2_by_q71 = 0.5 * t30 * t25;
        const double t31 = cos_half_tilt_2 * sin_sum_2_by_q71 + sin_half_tilt_2 * cos_sum_2_by_q71
            - cos_sum_2 * sin_half_tilt_2_by_q71;
        const double sin_q73_2_by_q71 = t31 - sin_sum_2 * cos_half_tilt_2_by_q71;
        const double gap_x_2_by_q71 = 0.021 * u_x_2_by_q71 - 0.036 * z_x_2_by_q71 - t26
            * sin_q73_2_by_q71 + t29;
        const double t32 = 0.021 * cos_tilt_2_by_q71 - 0.036 * (v_x * u_z_2_by_q71 + v_z
            * u_x_2_by_q71);
        const double t33 = cos_half_tilt_2 * cos_sum_2_by_q71 - sin_half_tilt_2 * sin_sum_2_by_q71
            + cos_sum_2 * cos_half_tilt_2_by_q71;
        const double gap_y_2_by_q71 = t32 - 0.074565407529229 * (t33 - sin_sum_2
            * sin_half_tilt_2_by_q71);
        const double z_z_2_by_q71 = v_x * cos_tilt_2_by_q71 + v_y * u_x_2_by_q71;
        const double gap_z_2_by_q71 = 0.021 * u_z_2_by_q71 + 0.036 * z_z_2_by_q71 + t27 + t28
            * sin_q73_2_by_q71;
        const double mismatch_2_by_q71 = gap_x_2 * gap_x_2_by_q71 + gap_y_2 * gap_y_2_by_q71
            + gap_z_2 * gap_z_2_by_q71;
        const double t34 = -mismatch_2_by_q71;
        const double safe_slope_2 = sinew_choose(t34, sinew_max(t34, 1.8e-09), sinew_min(t34,
            -1.8e-09));
        const double q71_2 = q71 + sinew_min(sinew_max(mismatch_2 / safe_slope_2, -0.2), 0.2);
        double sin_q71_4, cos_q71_4;
        sinew_sincos(q71_2, &sin_q71_4, &cos_q71_4);
        const double v_e_4 = v_x * cos_q71_4 + v_z * sin_q71_4;
        const double t35 = v_e_4 * v_e_4;
        const double t36 = 1.0 / sinew_sqrt(sinew_max(t7 + t35, 1e-12));
        const double sin_tilt_4 = v_y * t36;
        const double u_x_4 = cos_q71_4 * sin_tilt_4;
        const double u_z_4 = sin_q71_4 * sin_tilt_4;
        const double cos_tilt_4 = v_e_4 * t36;
        const double t37 = 0.074565407529229 * cos_q71_4;
        const double t38 = 0.5 * cos_tilt_4;
        const double cos_half_tilt_4 = sinew_sqrt(sinew_max(0.5 + t38, 1e-12));
        const double cos_sum_4 = 0.5632638698251111 * cos_half_tilt_4;
        const double sin_sum_4 = sinew_sqrt(1.0 - cos_sum_4 * cos_sum_4);
        const double t39 = 1.0 / cos_half_tilt_4;
        const double sin_half_tilt_4 = 0.5 * sin_tilt_4 * t39;
        const double sin_q73_4 = cos_half_tilt_4 * sin_sum_4 - sin_half_tilt_4 * cos_sum_4;
        const double t40 = t37 * sin_q73_4;
        const double gap_x_4 = 0.021 * u_x_4 + 0.036 * (v_y * u_z_4 + v_z * cos_tilt_4) + t40;
        const double cos_q73_4 = cos_half_tilt_4 * cos_sum_4 + sin_half_tilt_4 * sin_sum_4;
        const double gap_y_4 = 0.021 + 0.021 * cos_tilt_4 + 0.036 * (v_x * u_z_4 - v_z * u_x_4)
            - 0.074565407529229 * cos_q73_4;
        const double t41 = 0.074565407529229 * sin_q71_4;
        const double t42 = t41 * sin_q73_4;
        const double gap_z_4 = 0.036 - 0.021 * u_z_4 + 0.036 * (v_x * cos_tilt_4 + v_y * u_x_4)
            - t42;
        const double mismatch_4 = 0.001898 - 0.5 * (gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4 + gap_z_4
            * gap_z_4);
        const double v_e_4_by_q71 = v_x * sin_q71_4 - v_z * cos_q71_4;
        const double v_length_4_by_q71 = v_e_4 * v_e_4_by_q71 * sinew_choose(-(t8 - t35), 1.0, 0.0)
            * t36;
        const double sin_tilt_4_by_q71 = sin_tilt_4 * v_length_4_by_q71 * t36;
        const double u_x_4_by_q71 = u_z_4 - cos_q71_4 * sin_tilt_4_by_q71;
        const double u_z_4_by_q71 = u_x_4 + sin_q71_4 * sin_tilt_4_by_q71;
        const double cos_tilt_4_by_q71 = (v_e_4_by_q71 - cos_tilt_4 * v_length_4_by_q71) * t36;
        const double z_x_4_by_q71 = v_y * u_z_4_by_q71 - v_z * cos_tilt_4_by_q71;
        const double cos_half_tilt_4_by_q71 = 0.25 * cos_tilt_4_by_q71 * sinew_choose(0.499999999999
            + t38, 1.0, 0.0) * t39;
        const double cos_sum_4_by_q71 = 0.5632638698251111 * cos_half_tilt_4_by_q71;
        const double sin_sum_4_by_q71 = cos_sum_4 * cos_sum_4_by_q71 / sin_sum_4;
        const double t43 = sin_tilt_4_by_q71 + (sin_half_tilt_4 + sin_half_tilt_4)
            * cos_half_tilt_4_by_q71;
        const double sin_half_tilt_4_by_q71 = 0.5 * t43 * t39;
        const double t44 = cos_half_tilt_4 * sin_sum_4_by_q71 + sin_half_tilt_4 * cos_sum_4_by_q71
            - cos_sum_4 * sin_half_tilt_4_by_q71;
        const double sin_q73_4_by_q71 = t44 - sin_sum_4 * cos_half_tilt_4_by_q71;
        const double gap_x_4_by_q71 = 0.021 * u_x_4_by_q71 - 0.036 * z_x_4_by_q71 - t37
            * sin_q73_4_by_q71 + t42;
        const double t45 = 0.021 * cos_tilt_4_by_q71 - 0.036 * (v_x * u_z_4_by_q71 + v_z
            * u_x_4_by_q71);
        const double t46 = cos_half_tilt_4 * cos_sum_4_by_q71 - sin_half_tilt_4 * sin_sum_4_by_q71
            + cos_sum_4 * cos_half_tilt_4_by_q71;
        const double gap_y_4_by_q71 = t45 - 0.074565407529229 * (t46 - sin_sum_4
            * sin_half_tilt_4_by_q71);
        const double z_z_4_by_q71 = v_x * cos_tilt_4_by_q71 + v_y * u_x_4_by_q71;
        const double gap_z_4_by_q71 = 0.021 * u_z_4_by_q71 + 0.036 * z_z_4_by_q71 + t40 + t41
            * sin_q73_4_by_q71;
        const double mismatch_4_by_q71 = gap_x_4 * gap_x_4_by_q71 + gap_y_4 * gap_y_4_by_q71
            + gap_z_4 * gap_z_4_by_q71;
        const double t47 = -mismatch_4_by_q71;
        const double safe_slope_4 = sinew_choose(t47, sinew_max(t47, 1.8e-09), sinew_min(t47,
            -1.8e-09));
        const double q71_4 = q71_2 + sinew_min(sinew_max(mismatch_4 / safe_slope_4, -0.2), 0.2);
        double sin_q71_6, cos_q71_6;
        sinew_sincos(q71_4, &sin_q71_6, &cos_q71_6);
        const double v_e_6 = v_x * cos_q71_6 + v_z * sin_q71_6;
        const double t48 = v_e_6 * v_e_6;
        const double t49 = 1.0 / sinew_sqrt(sinew_max(t7 + t48, 1e-12));
        const double sin_tilt_6 = v_y * t49;
        const double u_x_6 = cos_q71_6 * sin_tilt_6;
        const double u_z_6 = sin_q71_6 * sin_tilt_6;
        const double cos_tilt_6 = v_e_6 * t49;
        const double t50 = 0.074565407529229 * cos_q71_6;
        const double t51 = 0.5 * cos_tilt_6;
        const double cos_half_tilt_6 = sinew_sqrt(sinew_max(0.5 + t51, 1e-12));
        const double cos_sum_6 = 0.5632638698251111 * cos_half_tilt_6;
        const double sin_sum_6 = sinew_sqrt(1.0 - cos_sum_6 * cos_sum_6);
        const double t52 = 1.0 / cos_half_tilt_6;
        const double sin_half_tilt_6 = 0.5 * sin_tilt_6 * t52;
        const double sin_q73_6 = cos_half_tilt_6 * sin_sum_6 - sin_half_tilt_6 * cos_sum_6;
        const double t53 = t50 * sin_q73_6;
        const double gap_x_6 = 0.021 * u_x_6 + 0.036 * (v_y * u_z_6 + v_z * cos_tilt_6) + t53;
        const double cos_q73_6 = cos_half_tilt_6 * cos_sum_6 + sin_half_tilt_6 * sin_sum_6;
        const double gap_y_6 = 0.021 + 0.021 * cos_tilt_6 + 0.036 * (v_x * u_z_6 - v_z * u_x_6)
            - 0.074565407529229 * cos_q73_6;
        const double t54 = 0.074565407529229 * sin_q71_6;
        const double t55 = t54 * sin_q73_6;
        const double gap_z_6 = 0.036 - 0.021 * u_z_6 + 0.036 * (v_x * cos_tilt_6 + v_y * u_x_6)
            - t55;
        const double mismatch_6 = 0.001898 - 0.5 * (gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6 + gap_z_6
            * gap_z_6);
        const double v_e_6_by_q71 = v_x * sin_q71_6 - v_z * cos_q71_6;
        const double v_length_6_by_q71 = v_e_6 * v_e_6_by_q71 * sinew_choose(-(t8 - t48), 1.0, 0.0)
            * t49;
        const double sin_tilt_6_by_q71 = sin_tilt_6 * v_length_6_by_q71 * t49;
        const double u_x_6_by_q71 = u_z_6 - cos_q71_6 * sin_tilt_6_by_q71;
        const double u_z_6_by_q71 = u_x_6 + sin_q71_6 * sin_tilt_6_by_q71;
        const double cos_tilt_6_by_q71 = (v_e_6_by_q71 - cos_tilt_6 * v_length_6_by_q71) * t49;
        const double z_x_6_by_q71 = v_y * u_z_6_by_q71 - v_z * cos_tilt_6_by_q71;
        const double cos_half_tilt_6_by_q71 = 0.25 * cos_tilt_6_by_q71 * sinew_choose(0.499999999999
            + t51, 1.0, 0.0) * t52;
        const double cos_sum_6_by_q71 = 0.5632638698251111 * cos_half_tilt_6_by_q71;
        const double sin_sum_6_by_q71 = cos_sum_6 * cos_sum_6_by_q71 / sin_sum_6;
        const double t56 = sin_tilt_6_by_q71 + (sin_half_tilt_6 + sin_half_tilt_6)
            * cos_half_tilt_6_by_q71;
        const double sin_half_tilt_6_by_q71 = 0.5 * t56 * t52;
        const double t57 = cos_half_tilt_6 * sin_sum_6_by_q71 + sin_half_tilt_6 * cos_sum_6_by_q71
            - cos_sum_6 * sin_half_tilt_6_by_q71;
        const double sin_q73_6_by_q71 = t57 - sin_sum_6 * cos_half_tilt_6_by_q71;
        const double gap_x_6_by_q71 = 0.021 * u_x_6_by_q71 - 0.036 * z_x_6_by_q71 - t50
            * sin_q73_6_by_q71 + t55;
        const double t58 = 0.021 * cos_tilt_6_by_q71 - 0.036 * (v_x * u_z_6_by_q71 + v_z
            * u_x_6_by_q71);
        const double t59 = cos_half_tilt_6 * cos_sum_6_by_q71 - sin_half_tilt_6 * sin_sum_6_by_q71
            + cos_sum_6 * cos_half_tilt_6_by_q71;
        const double gap_y_6_by_q71 = t58 - 0.074565407529229 * (t59 - sin_sum_6
            * sin_half_tilt_6_by_q71);
        const double z_z_6_by_q71 = v_x * cos_tilt_6_by_q71 + v_y * u_x_6_by_q71;
        const double gap_z_6_by_q71 = 0.021 * u_z_6_by_q71 + 0.036 * z_z_6_by_q71 + t53 + t54
            * sin_q73_6_by_q71;
        const double mismatch_6_by_q71 = gap_x_6 * gap_x_6_by_q71 + gap_y_6 * gap_y_6_by_q71
            + gap_z_6 * gap_z_6_by_q71;
        const double t60 = -mismatch_6_by_q71;
        const double safe_slope_6 = sinew_choose(t60, sinew_max(t60, 1.8e-09), sinew_min(t60,
            -1.8e-09));
        const double q71_6 = q71_4 + sinew_min(sinew_max(mismatch_6 / safe_slope_6, -0.2), 0.2);
        double sin_q71_8, cos_q71_8;
        sinew_sincos(q71_6, &sin_q71_8, &cos_q71_8);
        const double v_e_8 = v_x * cos_q71_8 + v_z * sin_q71_8;
        const double v_length_8 = sinew_sqrt(sinew_max(t7 + v_e_8 * v_e_8, 1e-12));
        const double t61 = 1.0 / v_length_8;
        const double cos_half_tilt_8 = sinew_sqrt(sinew_max(0.5 + 0.5 * (v_e_8 * t61), 1e-12));
        const double cos_sum_8 = 0.5632638698251111 * cos_half_tilt_8;
        const double sin_sum_8 = sinew_sqrt(1.0 - cos_sum_8 * cos_sum_8);
        const double sin_half_tilt_8 = 0.5 * (v_y * t61) / cos_half_tilt_8;
        const double sin_q73_8 = cos_half_tilt_8 * sin_sum_8 - sin_half_tilt_8 * cos_sum_8;
        const double cos_q73_8 = cos_half_tilt_8 * cos_sum_8 + sin_half_tilt_8 * sin_sum_8;
        const double B_e = 0.074565407529229 * sin_q73_8;
        const double B_y = 0.074565407529229 * cos_q73_8;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_e = B_e * ratio;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double s_y = 0.5 * (C_y - B_y) + 0.021;
        const double u_y_10 = 23.80952380952381 * (B_y + C_y);
        const double s_e = 0.5 * (B_e + C_e) - 0.036 * sin_q71_8;
        const double p_y = u_e * s_y + u_y_10 * s_e;
        const double p_z = 0.036 * cos_q71_8;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y_10 * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t62 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t62;
        const double sin_A = (p_y * root - p_z * limited) * t62;
        const double x_plane_x = u_y_10 * sin_A;
        const double x_z = cos_q71_8 * cos_A - sin_q71_8 * x_plane_x;
        const double x_plane_y = u_e * sin_A;
        const double aside_x = v_y * x_z - v_z * x_plane_y;
        const double x_x = cos_q71_8 * x_plane_x + sin_q71_8 * cos_A;
        const double aside_y = v_x * x_z + v_z * x_x;
        const double aside_z = v_x * x_plane_y + v_y * x_x;
        const double error_sine = sinew_sqrt(aside_x * aside_x + aside_y * aside_y + aside_z
            * aside_z);
        const double residual_2 = sinew_atan2(error_sine, v_x * x_x - v_y * x_plane_y - v_z * x_z);
        const double t63 = flexion[state] - limited_flexion;
        const double t64 = abduction[state] - limited_abduction;
        const double t65 = sinew_choose(1e-06 - residual_2 - sinew_max(-t63, t63) - sinew_max(-t64,
            t64), sinew_choose(-(1e-06 - sin_q73_8), 0.0, 1.0), 1.0);
        q[state] = q71_6;
        q[1 * n + state] = sinew_atan2(sin_q73_8, cos_q73_8);
        residual[state] = residual_2;
        status[state] = (int)t65;
    }
}

void wrist_singularity_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT distance)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double s_e = 0.5 * (B_e + C_e) - 0.036 * sin_q71;
        const double s_y = 0.5 * (C_y - B_y) + 0.021;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double height = sinew_sqrt(sinew_max(reach * reach - projection * projection, 0.0));
        distance[state] = sinew_atan2(sinew_max(sin_q73, -sin_q73), sinew_max(cos_q73, -cos_q73));
        distance[1 * n + state] = sinew_atan2(height, sinew_max(-projection, projection));
    }
}

void wrist_status_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double s_e = 0.5 * (B_e + C_e) - 0.036 * sin_q71;
        const double s_y = 0.5 * (C_y - B_y) + 0.021;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double t1 = sinew_choose(0.999999999999 * reach * reach - projection * projection,
            0.0, 1.0);
        status[state] = (int)sinew_choose(-(1e-06 - sin_q73), t1, 1.0);
    }
}

void wrist_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double M_e = 0.5 * (B_e + C_e);
        const double s_e = M_e - 0.036 * sin_q71;
        const double M_y = 0.5 * (B_y - C_y);
        const double s_y = 0.021 - M_y;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t1 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t1;
        const double z_plane_x = u_y * cos_A;
        const double sin_A = (p_y * root - p_z * limited) * t1;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double x_plane_x = u_y * sin_A;
        const double t2 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * (cos_q71 * x_plane_x
            + sin_q71 * cos_A);
        const double t3 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double layer_0_x = t2 - t3 + 0.011 * y_x;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double t4 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double t5 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double layer_0_z = 0.008 - origin_z - t4 - t5 + 0.011 * y_z;
        const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
        const double twice_across = across + across;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t6 = 0.004 * (u_e * sin_A);
        const double t7 = 0.01 * z_plane_y;
        const double t8 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t6 + t7 + t8;
        const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
        const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
        const double twice_across_2 = across_by_y + across_by_y;
        const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
        const double twice_across_4 = across_by_y_squared + across_by_y_squared;
        const double across_2 = twice_across - 0.001 * (twice_across_2 - 0.001 * twice_across_4);
        const double strand_y_1 = 0.001 + layer_0_y - 0.001 * u_y;
        const double length_1 = sinew_sqrt(across_2 + strand_y_1 * strand_y_1);
        const double t9 = 0.003 * twice_across_4;
        const double across_4 = twice_across - 0.003 * (twice_across_2 - t9);
        const double t10 = 0.003 * u_y;
        const double strand_y_2 = 0.003 + layer_0_y - t10;
        const double length_2 = sinew_sqrt(across_4 + strand_y_2 * strand_y_2);
        const double t11 = 0.005 * twice_across_4;
        const double across_6 = twice_across - 0.005 * (twice_across_2 - t11);
        const double t12 = 0.005 * u_y;
        const double strand_y_3 = 0.004 + layer_0_y - t12;
        const double length_3 = sinew_sqrt(across_6 + strand_y_3 * strand_y_3);
        const double across_8 = twice_across - 0.006 * (twice_across_2 - 0.006 * twice_across_4);
        const double strand_y_4 = 0.006 + layer_0_y - 0.006 * u_y;
        const double length_4 = sinew_sqrt(across_8 + strand_y_4 * strand_y_4);
        const double t13 = 0.008 * twice_across_4;
        const double across_10 = twice_across - 0.008 * (twice_across_2 - t13);
        const double t14 = 0.008 * u_y;
        const double strand_y_5 = 0.008 + layer_0_y - t14;
        const double length_5 = sinew_sqrt(across_10 + strand_y_5 * strand_y_5);
        const double across_12 = twice_across - 0.009 * (twice_across_2 - 0.009 * twice_across_4);
        const double strand_y_6 = 0.009 + layer_0_y - 0.009 * u_y;
        const double length_6 = sinew_sqrt(across_12 + strand_y_6 * strand_y_6);
        const double t15 = 0.011 * twice_across_4;
        const double across_14 = twice_across - 0.011 * (twice_across_2 - t15);
        const double strand_y_7 = 0.011 + layer_0_y - t8;
        const double length_7 = sinew_sqrt(across_14 + strand_y_7 * strand_y_7);
        const double t16 = 0.013 * twice_across_4;
        const double across_16 = twice_across - 0.013 * (twice_across_2 - t16);
        const double t17 = 0.013 * u_y;
        const double strand_y_8 = 0.012 + layer_0_y - t17;
        const double length_8 = sinew_sqrt(across_16 + strand_y_8 * strand_y_8);
        const double across_18 = twice_across - 0.014 * (twice_across_2 - 0.014 * twice_across_4);
        const double strand_y_9 = 0.014 + layer_0_y - 0.014 * u_y;
        const double length_9 = sinew_sqrt(across_18 + strand_y_9 * strand_y_9);
        const double t18 = 0.016 * twice_across_4;
        const double across_20 = twice_across - 0.016 * (twice_across_2 - t18);
        const double t19 = 0.016 * u_y;
        const double strand_y_10 = 0.016 + layer_0_y - t19;
        const double length_10 = sinew_sqrt(across_20 + strand_y_10 * strand_y_10);
        const double across_22 = twice_across - 0.017 * (twice_across_2 - 0.017 * twice_across_4);
        const double strand_y_11 = 0.017 + layer_0_y - 0.017 * u_y;
        const double length_11 = sinew_sqrt(across_22 + strand_y_11 * strand_y_11);
        const double t20 = 0.019 * twice_across_4;
        const double across_24 = twice_across - 0.019 * (twice_across_2 - t20);
        const double t21 = 0.019 * u_y;
        const double strand_y_12 = 0.019 + layer_0_y - t21;
        const double length_12 = sinew_sqrt(across_24 + strand_y_12 * strand_y_12);
        const double t22 = 0.021 * twice_across_4;
        const double across_26 = twice_across - 0.021 * (twice_across_2 - t22);
        const double t23 = 0.021 * u_y;
        const double strand_y_13 = 0.02 + layer_0_y - t23;
        const double length_13 = sinew_sqrt(across_26 + strand_y_13 * strand_y_13);
        const double across_28 = twice_across - 0.022 * (twice_across_2 - 0.022 * twice_across_4);
        const double strand_y_14 = 0.022 + layer_0_y - 0.022 * u_y;
        const double length_14 = sinew_sqrt(across_28 + strand_y_14 * strand_y_14);
        const double t24 = 0.024 * twice_across_4;
        const double across_30 = twice_across - 0.024 * (twice_across_2 - t24);
        const double t25 = 0.024 * u_y;
        const double strand_y_15 = 0.024 + layer_0_y - t25;
        const double length_15 = sinew_sqrt(across_30 + strand_y_15 * strand_y_15);
        const double across_32 = twice_across - 0.025 * (twice_across_2 - 0.025 * twice_across_4);
        const double strand_y_16 = 0.025 + layer_0_y - 0.025 * u_y;
        const double length_16 = sinew_sqrt(across_32 + strand_y_16 * strand_y_16);
        const double t26 = 0.027 * twice_across_4;
        const double across_34 = twice_across - 0.027 * (twice_across_2 - t26);
        const double t27 = 0.027 * u_y;
        const double strand_y_17 = 0.027 + layer_0_y - t27;
        const double length_17 = sinew_sqrt(across_34 + strand_y_17 * strand_y_17);
        const double t28 = 0.029 * twice_across_4;
        const double across_36 = twice_across - 0.029 * (twice_across_2 - t28);
        const double t29 = 0.029 * u_y;
        const double strand_y_18 = 0.028 + layer_0_y - t29;
        const double length_18 = sinew_sqrt(across_36 + strand_y_18 * strand_y_18);
        const double layer_1_x = t2 + t3 + 0.013 * y_x;
        const double layer_1_z = 0.028 - origin_z - t4 + t5 + 0.013 * y_z;
        const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
        const double twice_across_6 = across_38 + across_38;
        const double layer_1_y = 0.006 - origin_y - t6 - t7 + t17;
        const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
        const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
        const double twice_across_8 = across_by_y_2 + across_by_y_2;
        const double across_40 = twice_across_6 - 0.002 * (twice_across_8 - 0.002 * twice_across_4);
        const double strand_y_20 = 0.001 + layer_1_y - 0.002 * u_y;
        const double length_20 = sinew_sqrt(across_40 + strand_y_20 * strand_y_20);
        const double across_42 = twice_across_6 - 0.003 * (twice_across_8 - t9);
        const double strand_y_21 = 0.003 + layer_1_y - t10;
        const double length_21 = sinew_sqrt(across_42 + strand_y_21 * strand_y_21);
        const double across_44 = twice_across_6 - 0.005 * (twice_across_8 - t11);
        const double strand_y_22 = 0.005 + layer_1_y - t12;
        const double length_22 = sinew_sqrt(across_44 + strand_y_22 * strand_y_22);
        const double across_46 = twice_across_6 - 0.007 * (twice_across_8 - 0.007 * twice_across_4);
        const double strand_y_23 = 0.006 + layer_1_y - 0.007 * u_y;
        const double length_23 = sinew_sqrt(across_46 + strand_y_23 * strand_y_23);
        const double across_48 = twice_across_6 - 0.008 * (twice_across_8 - t13);
        const double strand_y_24 = 0.008 + layer_1_y - t14;
        const double length_24 = sinew_sqrt(across_48 + strand_y_24 * strand_y_24);
        const double across_50 = twice_across_6 - 0.01 * (twice_across_8 - 0.01 * twice_across_4);
        const double strand_y_25 = 0.009 + layer_1_y - 0.01 * u_y;
        const double length_25 = sinew_sqrt(across_50 + strand_y_25 * strand_y_25);
        const double across_52 = twice_across_6 - 0.011 * (twice_across_8 - t15);
        const double strand_y_26 = 0.011 + layer_1_y - t8;
        const double length_26 = sinew_sqrt(across_52 + strand_y_26 * strand_y_26);
        const double across_54 = twice_across_6 - 0.013 * (twice_across_8 - t16);
        const double strand_y_27 = 0.013 + layer_1_y - t17;
        const double length_27 = sinew_sqrt(across_54 + strand_y_27 * strand_y_27);
        const double across_56 = twice_across_6 - 0.015 * (twice_across_8 - 0.015 * twice_across_4);
        const double strand_y_28 = 0.014 + layer_1_y - 0.015 * u_y;
        const double length_28 = sinew_sqrt(across_56 + strand_y_28 * strand_y_28);
        const double across_58 = twice_across_6 - 0.016 * (twice_across_8 - t18);
        const double strand_y_29 = 0.016 + layer_1_y - t19;
        const double length_29 = sinew_sqrt(across_58 + strand_y_29 * strand_y_29);
        const double across_60 = twice_across_6 - 0.018 * (twice_across_8 - 0.018 * twice_across_4);
        const double strand_y_30 = 0.017 + layer_1_y - 0.018 * u_y;
        const double length_30 = sinew_sqrt(across_60 + strand_y_30 * strand_y_30);
        const double across_62 = twice_across_6 - 0.019 * (twice_across_8 - t20);
        const double strand_y_31 = 0.019 + layer_1_y - t21;
        const double length_31 = sinew_sqrt(across_62 + strand_y_31 * strand_y_31);
        const double across_64 = twice_across_6 - 0.021 * (twice_across_8 - t22);
        const double strand_y_32 = 0.021 + layer_1_y - t23;
        const double length_32 = sinew_sqrt(across_64 + strand_y_32 * strand_y_32);
        const double across_66 = twice_across_6 - 0.023 * (twice_across_8 - 0.023 * twice_across_4);
        const double strand_y_33 = 0.022 + layer_1_y - 0.023 * u_y;
        const double length_33 = sinew_sqrt(across_66 + strand_y_33 * strand_y_33);
        const double across_68 = twice_across_6 - 0.024 * (twice_across_8 - t24);
        const double strand_y_34 = 0.024 + layer_1_y - t25;
        const double length_34 = sinew_sqrt(across_68 + strand_y_34 * strand_y_34);
        const double across_70 = twice_across_6 - 0.026 * (twice_across_8 - 0.026 * twice_across_4);
        const double strand_y_35 = 0.025 + layer_1_y - 0.026 * u_y;
        const double length_35 = sinew_sqrt(across_70 + strand_y_35 * strand_y_35);
        const double across_72 = twice_across_6 - 0.027 * (twice_across_8 - t26);
        const double strand_y_36 = 0.027 + layer_1_y - t27;
        const double length_36 = sinew_sqrt(across_72 + strand_y_36 * strand_y_36);
        const double across_74 = twice_across_6 - 0.029 * (twice_across_8 - t28);
        const double strand_y_37 = 0.029 + layer_1_y - t29;
        const double length_37 = sinew_sqrt(across_74 + strand_y_37 * strand_y_37);
        h[state] = length_0;
        h[1 * n + state] = length_1;
        h[2 * n + state] = length_2;
        h[3 * n + state] = length_3;
        h[4 * n + state] = length_4;
        h[5 * n + state] = length_5;
        h[6 * n + state] = length_6;
        h[7 * n + state] = length_7;
        h[8 * n + state] = length_8;
        h[9 * n + state] = length_9;
        h[10 * n + state] = length_10;
        h[11 * n + state] = length_11;
        h[12 * n + state] = length_12;
        h[13 * n + state] = length_13;
        h[14 * n + state] = length_14;
        h[15 * n + state] = length_15;
        h[16 * n + state] = length_16;
        h[17 * n + state] = length_17;
        h[18 * n + state] = length_18;
        h[19 * n + state] = length_19;
        h[20 * n + state] = length_20;
        h[21 * n + state] = length_21;
        h[22 * n + state] = length_22;
        h[23 * n + state] = length_23;
        h[24 * n + state] = length_24;
        h[25 * n + state] = length_25;
        h[26 * n + state] = length_26;
        h[27 * n + state] = length_27;
        h[28 * n + state] = length_28;
        h[29 * n + state] = length_29;
        h[30 * n + state] = length_30;
        h[31 * n + state] = length_31;
        h[32 * n + state] = length_32;
        h[33 * n + state] = length_33;
        h[34 * n + state] = length_34;
        h[35 * n + state] = length_35;
        h[36 * n + state] = length_36;
        h[37 * n + state] = length_37;
    }
}

void wrist_tendon_jacobian_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT P)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double t1 = 1.0 / (0.007324 - 0.084 * B_y);
        const double ratio = 0.003796 * t1;
        const double t2 = 21.0 - 500.0 * B_y;
        const double C_y = 0.002 * ratio * t2;
        const double t3 = 23.80952380952381 * B_y;
        const double u_y = t3 + 23.80952380952381 * C_y;
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double t4 = 0.5 * B_e;
        const double M_e = t4 + 0.5 * C_e;
        const double p_z_by_q71 = 0.036 * sin_q71;
        const double s_e = M_e - p_z_by_q71;
        const double t5 = 0.5 * B_y;
        const double M_y = t5 - 0.5 * C_y;
        const double s_y = 0.021 - M_y;
        const double t6 = 23.80952380952381 * B_e;
        const double u_e = t6 - 23.80952380952381 * C_e;
        const double p_y = u_e * s_y + u_y * s_e;
        const double t7 = p_y + p_y;
        const double p_z = 0.036 * cos_q71;
        const double p_y_by_q71 = u_y * p_z;
        const double t8 = p_y * p_y;
        const double t9 = p_z * p_z;
        const double t10 = -(1.296e-15 - t8 - t9);
        const double reach_squared_by_q71 = sinew_choose(t10, -(t7 * p_y_by_q71 + (p_z + p_z)
            * p_z_by_q71), 0.0);
        const double reach_squared = sinew_max(t8 + t9, 1.296e-15);
        const double reach = sinew_sqrt(reach_squared);
        const double t11 = 1.0 / reach;
        const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t11;
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double t12 = reach - projection;
        const double t13 = sinew_choose(t12, 0.0, 1.0);
        const double t14 = sinew_choose(t12, 1.0, 0.0);
        const double t15 = 27.77777777777778 * p_x;
        const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t15 * u_e * p_z;
        const double t16 = sinew_max(-projection, -reach);
        const double t17 = reach - t16;
        const double limited_by_q71 = sinew_choose(t17, -(reach_by_q71 * t13 - projection_by_q71
            * t14), reach_by_q71);
        const double limited = sinew_min(t16, reach);
        const double t18 = limited + limited;
        const double t19 = reach + reach;
        const double t20 = (reach + limited) * (reach - limited);
        const double t21 = 1e-12 * reach_squared;
        const double t22 = -(t21 - t20);
        const double clearance_by_q71 = sinew_choose(t22, t19 * reach_by_q71 - t18 * limited_by_q71,
            1e-12 * reach_squared_by_q71);
        const double root = sinew_sqrt(sinew_max(t20, t21));
        const double t23 = 1.0 / root;
        const double root_by_q71 = 0.5 * clearance_by_q71 * t23;
        const double t24 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double t25 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t25;
        const double cos_A_by_q71 = (t24 - cos_A * reach_squared_by_q71) * t25;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double sin_A = (p_y * root - p_z * limited) * t25;
        const double t26 = cos_q71 * sin_A;
        const double z_plane_x = u_y * cos_A;
        const double t27 = sin_q71 * z_plane_x;
        const double t28 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t28 - sin_A * reach_squared_by_q71) * t25;
        const double z_x_by_q71 = t26 - cos_q71 * z_plane_x_by_q71 + t27 + sin_q71 * sin_A_by_q71;
        const double M_z = sin_q71 * M_e;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double t29 = cos_q71 * cos_A;
        const double x_plane_x = u_y * sin_A;
        const double t30 = sin_q71 * x_plane_x;
        const double x_x_by_q71 = t29 + cos_q71 * x_plane_x_by_q71 - t30 + sin_q71 * cos_A_by_q71;
        const double t31 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
        const double t32 = 0.01 * z_x_by_q71;
        const double y_z = sin_q71 * u_e;
        const double t33 = 0.011 * y_z;
        const double layer_0_x_by_q71 = t31 + t32 - t33;
        const double t34 = cos_q71 * z_plane_x;
        const double t35 = sin_q71 * sin_A;
        const double z_x = t34 - t35;
        const double M_x = cos_q71 * M_e;
        const double t36 = cos_q71 * x_plane_x;
        const double t37 = sin_q71 * cos_A;
        const double t38 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t36 + t37);
        const double t39 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double t40 = 0.011 * y_x;
        const double layer_0_x = t38 - t39 + t40;
        const double z_z_by_q71 = t34 + cos_q71 * sin_A_by_q71 - t35 + sin_q71 * z_plane_x_by_q71;
        const double x_z_by_q71 = t36 - cos_q71 * cos_A_by_q71 + t37 + sin_q71 * x_plane_x_by_q71;
        const double t41 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t42 = 0.01 * z_z_by_q71;
        const double layer_0_z_by_q71 = t41 + t42 - t40;
        const double z_z = t26 + t27;
        const double origin_z = M_z - 0.018 * z_z;
        const double t43 = 0.004 * (t29 - t30);
        const double t44 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t43 - t44 + t33;
        const double across_by_q71 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t45 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t46 = 0.01 * z_plane_y_by_q71;
        const double layer_0_y_by_q71 = t45 - t46;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t47 = 0.004 * (u_e * sin_A);
        const double t48 = 0.01 * z_plane_y;
        const double t49 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t47 + t48 + t49;
        const double half_square_by = across_by_q71 - layer_0_y * layer_0_y_by_q71;
        const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
        const double twice_across = across + across;
        const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
        const double t50 = 1.0 / length_0;
        const double ratio_by_q73 = ratio * (0.084 * B_e) * t1;
        const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t2;
        const double M_y_by_q73 = t4 + 0.5 * C_y_by_q73;
        const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
        const double M_e_by_q73 = t5 - 0.5 * C_e_by_q73;
        const double u_y_by_q73 = t6 - 23.80952380952381 * C_y_by_q73;
        const double u_e_by_q73 = t3 + 23.80952380952381 * C_e_by_q73;
        const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
            * u_e_by_q73;
        const double reach_squared_by_q73 = sinew_choose(t10, t7 * p_y_by_q73, 0.0);
        const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
            * u_y_by_q73;
        const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t15
            * p_x_by_q73;
        const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t11;
        const double limited_by_q73 = sinew_choose(t17, -(reach_by_q73 * t13 - projection_by_q73
            * t14), reach_by_q73);
        const double clearance_by_q73 = sinew_choose(t22, t19 * reach_by_q73 - t18 * limited_by_q73,
            1e-12 * reach_squared_by_q73);
        const double root_by_q73 = 0.5 * clearance_by_q73 * t23;
        const double t51 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t51 * t25;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double t52 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t52 * t25;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t53 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t54 = 0.01 * z_x_by_q73;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double layer_0_x_by_q73 = t53 + t54 - 0.011 * y_x_by_q73;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t55 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t56 = 0.01 * z_z_by_q73;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double layer_0_z_by_q73 = t55 + t56 - 0.011 * y_z_by_q73;
        const double across_by_q73 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t57 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t58 = 0.01 * z_plane_y_by_q73;
        const double t59 = 0.011 * u_y_by_q73;
        const double layer_0_y_by_q73 = t57 + t58 - t59;
        const double half_square_by_76 = across_by_q73 - layer_0_y * layer_0_y_by_q73;
        const double across_by_y_by_q71 = y_x * (layer_0_z + layer_0_x_by_q71) - y_z * (layer_0_x
            + layer_0_z_by_q71);
        const double across_76 = across_by_q71 - 0.001 * across_by_y_by_q71;
        const double strand_y_1 = 0.001 + layer_0_y - 0.001 * u_y;
        const double half_square_by_2 = across_76 - strand_y_1 * layer_0_y_by_q71;
        const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
        const double twice_across_2 = across_by_y + across_by_y;
        const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
        const double twice_across_4 = across_by_y_squared + across_by_y_squared;
        const double across_2 = twice_across - 0.001 * (twice_across_2 - 0.001 * twice_across_4);
        const double length_1 = sinew_sqrt(across_2 + strand_y_1 * strand_y_1);
        const double t60 = 1.0 / length_1;
        const double across_by_y_by_q73 = y_x * layer_0_x_by_q73 + y_z * layer_0_z_by_q73
            - layer_0_x * y_x_by_q73 - layer_0_z * y_z_by_q73;
        const double across_by_y_squared_by_q73 = y_x * y_x_by_q73 + y_z * y_z_by_q73;
        const double across_slope_144 = across_by_y_by_q73 + 0.001 * across_by_y_squared_by_q73;
        const double half_square_by_78 = across_by_q73 - 0.001 * across_slope_144 - strand_y_1
            * (layer_0_y_by_q73 + 0.001 * u_y_by_q73);
        const double across_78 = across_by_q71 - 0.003 * across_by_y_by_q71;
        const double t61 = 0.003 * u_y;
        const double strand_y_2 = 0.003 + layer_0_y - t61;
        const double half_square_by_4 = across_78 - strand_y_2 * layer_0_y_by_q71;
        const double t62 = 0.003 * twice_across_4;
        const double across_4 = twice_across - 0.003 * (twice_across_2 - t62);
        const double length_2 = sinew_sqrt(across_4 + strand_y_2 * strand_y_2);
        const double t63 = 1.0 / length_2;
        const double t64 = 0.003 * across_by_y_squared_by_q73;
        const double across_150 = across_by_q73 - 0.003 * (across_by_y_by_q73 + t64);
        const double t65 = 0.003 * u_y_by_q73;
        const double half_square_by_80 = across_150 - strand_y_2 * (layer_0_y_by_q73 + t65);
        const double across_80 = across_by_q71 - 0.005 * across_by_y_by_q71;
        const double t66 = 0.005 * u_y;
        const double strand_y_3 = 0.004 + layer_0_y - t66;
        const double half_square_by_6 = across_80 - strand_y_3 * layer_0_y_by_q71;
        const double t67 = 0.005 * twice_across_4;
        const double across_6 = twice_across - 0.005 * (twice_across_2 - t67);
        const double length_3 = sinew_sqrt(across_6 + strand_y_3 * strand_y_3);
        const double t68 = 1.0 / length_3;
        const double t69 = 0.005 * across_by_y_squared_by_q73;
        const double across_152 = across_by_q73 - 0.005 * (across_by_y_by_q73 + t69);
        const double t70 = 0.005 * u_y_by_q73;
        const double half_square_by_82 = across_152 - strand_y_3 * (layer_0_y_by_q73 + t70);
        const double across_82 = across_by_q71 - 0.006 * across_by_y_by_q71;
        const double strand_y_4 = 0.006 + layer_0_y - 0.006 * u_y;
        const double half_square_by_8 = across_82 - strand_y_4 * layer_0_y_by_q71;
        const double across_8 = twice_across - 0.006 * (twice_across_2 - 0.006 * twice_across_4);
        const double length_4 = sinew_sqrt(across_8 + strand_y_4 * strand_y_4);
        const double t71 = 1.0 / length_4;
        const double across_slope_150 = across_by_y_by_q73 + 0.006 * across_by_y_squared_by_q73;
        const double half_square_by_84 = across_by_q73 - 0.006 * across_slope_150 - strand_y_4
            * (layer_0_y_by_q73 + 0.006 * u_y_by_q73);
        const double across_84 = across_by_q71 - 0.008 * across_by_y_by_q71;
        const double t72 = 0.008 * u_y;
        const double strand_y_5 = 0.008 + layer_0_y - t72;
        const double half_square_by_10 = across_84 - strand_y_5 * layer_0_y_by_q71;
        const double t73 = 0.008 * twice_across_4;
        const double across_10 = twice_across - 0.008 * (twice_across_2 - t73);
        const double length_5 = sinew_sqrt(across_10 + strand_y_5 * strand_y_5);
        const double t74 = 1.0 / length_5;
        const double t75 = 0.008 * across_by_y_squared_by_q73;
        const double across_156 = across_by_q73 - 0.008 * (across_by_y_by_q73 + t75);
        const double t76 = 0.008 * u_y_by_q73;
        const double half_square_by_86 = across_156 - strand_y_5 * (layer_0_y_by_q73 + t76);
        const double across_86 = across_by_q71 - 0.009 * across_by_y_by_q71;
        const double strand_y_6 = 0.009 + layer_0_y - 0.009 * u_y;
        const double half_square_by_12 = across_86 - strand_y_6 * layer_0_y_by_q71;
        const double across_12 = twice_across - 0.009 * (twice_across_2 - 0.009 * twice_across_4);
        const double length_6 = sinew_sqrt(across_12 + strand_y_6 * strand_y_6);
        const double t77 = 1.0 / length_6;
        const double across_slope_154 = across_by_y_by_q73 + 0.009 * across_by_y_squared_by_q73;
        const double half_square_by_88 = across_by_q73 - 0.009 * across_slope_154 - strand_y_6
            * (layer_0_y_by_q73 + 0.009 * u_y_by_q73);
        const double across_88 = across_by_q71 - 0.011 * across_by_y_by_q71;
        const double strand_y_7 = 0.011 + layer_0_y - t49;
        const double half_square_by_14 = across_88 - strand_y_7 * layer_0_y_by_q71;
        const double t78 = 0.011 * twice_across_4;
        const double across_14 = twice_across - 0.011 * (twice_across_2 - t78);
        const double length_7 = sinew_sqrt(across_14 + strand_y_7 * strand_y_7);
        const double t79 = 1.0 / length_7;
        const double t80 = 0.011 * across_by_y_squared_by_q73;
        const double across_160 = across_by_q73 - 0.011 * (across_by_y_by_q73 + t80);
        const double half_square_by_90 = across_160 - strand_y_7 * (layer_0_y_by_q73 + t59);
        const double across_90 = across_by_q71 - 0.013 * across_by_y_by_q71;
        const double t81 = 0.013 * u_y;
        const double strand_y_8 = 0.012 + layer_0_y - t81;
        const double half_square_by_16 = across_90 - strand_y_8 * layer_0_y_by_q71;
        const double t82 = 0.013 * twice_across_4;
        const double across_16 = twice_across - 0.013 * (twice_across_2 - t82);
        const double length_8 = sinew_sqrt(across_16 + strand_y_8 * strand_y_8);
        const double t83 = 1.0 / length_8;
        const double t84 = 0.013 * across_by_y_squared_by_q73;
        const double across_162 = across_by_q73 - 0.013 * (across_by_y_by_q73 + t84);
        const double t85 = 0.013 * u_y_by_q73;
        const double half_square_by_92 = across_162 - strand_y_8 * (layer_0_y_by_q73 + t85);
        const double across_92 = across_by_q71 - 0.014 * across_by_y_by_q71;
        const double strand_y_9 = 0.014 + layer_0_y - 0.014 * u_y;
        const double half_square_by_18 = across_92 - strand_y_9 * layer_0_y_by_q71;
        const double across_18 = twice_across - 0.014 * (twice_across_2 - 0.014 * twice_across_4);
        const double length_9 = sinew_sqrt(across_18 + strand_y_9 * strand_y_9);
        const double t86 = 1.0 / length_9;
        const double across_slope_160 = across_by_y_by_q73 + 0.014 * across_by_y_squared_by_q73;
        const double half_square_by_94 = across_by_q73 - 0.014 * across_slope_160 - strand_y_9
            * (layer_0_y_by_q73 + 0.014 * u_y_by_q73);
        const double across_94 = across_by_q71 - 0.016 * across_by_y_by_q71;
        const double t87 = 0.016 * u_y;
        const double strand_y_10 = 0.016 + layer_0_y - t87;
        const double half_square_by_20 = across_94 - strand_y_10 * layer_0_y_by_q71;
        const double t88 = 0.016 * twice_across_4;
        const double across_20 = twice_across - 0.016 * (twice_across_2 - t88);
        const double length_10 = sinew_sqrt(across_20 + strand_y_10 * strand_y_10);
        const double t89 = 1.0 / length_10;
        const double t90 = 0.016 * across_by_y_squared_by_q73;
        const double across_166 = across_by_q73 - 0.016 * (across_by_y_by_q73 + t90);
        const double t91 = 0.016 * u_y_by_q73;
        const double half_square_by_96 = across_166 - strand_y_10 * (layer_0_y_by_q73 + t91);
        const double across_96 = across_by_q71 - 0.017 * across_by_y_by_q71;
        const double strand_y_11 = 0.017 + layer_0_y - 0.017 * u_y;
        const double half_square_by_22 = across_96 - strand_y_11 * layer_0_y_by_q71;
        const double across_22 = twice_across - 0.017 * (twice_across_2 - 0.017 * twice_across_4);
        const double length_11 = sinew_sqrt(across_22 + strand_y_11 * strand_y_11);
        const double t92 = 1.0 / length_11;
        const double across_slope_164 = across_by_y_by_q73 + 0.017 * across_by_y_squared_by_q73;
        const double half_square_by_98 = across_by_q73 - 0.017 * across_slope_164 - strand_y_11
            * (layer_0_y_by_q73 + 0.017 * u_y_by_q73);
        const double across_98 = across_by_q71 - 0.019 * across_by_y_by_q71;
        const double t93 = 0.019 * u_y;
        const double strand_y_12 = 0.019 + layer_0_y - t93;
        const double half_square_by_24 = across_98 - strand_y_12 * layer_0_y_by_q71;
        const double t94 = 0.019 * twice_across_4;
        const double across_24 = twice_across - 0.019 * (twice_across_2 - t94);
        const double length_12 = sinew_sqrt(across_24 + strand_y_12 * strand_y_12);
        const double t95 = 1.0 / length_12;
        const double t96 = 0.019 * across_by_y_squared_by_q73;
        const double across_170 = across_by_q73 - 0.019 * (across_by_y_by_q73 + t96);
        const double t97 = 0.019 * u_y_by_q73;
        const double half_square_by_100 = across_170 - strand_y_12 * (layer_0_y_by_q73 + t97);
        const double across_100 = across_by_q71 - 0.021 * across_by_y_by_q71;
        const double t98 = 0.021 * u_y;
        const double strand_y_13 = 0.02 + layer_0_y - t98;
        const double half_square_by_26 = across_100 - strand_y_13 * layer_0_y_by_q71;
        const double t99 = 0.021 * twice_across_4;
        const double across_26 = twice_across - 0.021 * (twice_across_2 - t99);
        const double length_13 = sinew_sqrt(across_26 + strand_y_13 * strand_y_13);
        const double t100 = 1.0 / length_13;
        const double t101 = 0.021 * across_by_y_squared_by_q73;
        const double across_172 = across_by_q73 - 0.021 * (across_by_y_by_q73 + t101);
        const double t102 = 0.021 * u_y_by_q73;
        const double half_square_by_102 = across_172 - strand_y_13 * (layer_0_y_by_q73 + t102);
        const double across_102 = across_by_q71 - 0.022 * across_by_y_by_q71;
        const double strand_y_14 = 0.022 + layer_0_y - 0.022 * u_y;
        const double half_square_by_28 = across_102 - strand_y_14 * layer_0_y_by_q71;
        const double across_28 = twice_across - 0.022 * (twice_across_2 - 0.022 * twice_across_4);
        const double length_14 = sinew_sqrt(across_28 + strand_y_14 * strand_y_14);
        const double t103 = 1.0 / length_14;
        const double across_slope_170 = across_by_y_by_q73 + 0.022 * across_by_y_squared_by_q73;
        const double half_square_by_104 = across_by_q73 - 0.022 * across_slope_170 - strand_y_14
            * (layer_0_y_by_q73 + 0.022 * u_y_by_q73);
        const double across_104 = across_by_q71 - 0.024 * across_by_y_by_q71;
        const double t104 = 0.024 * u_y;
        const double strand_y_15 = 0.024 + layer_0_y - t104;
        const double half_square_by_30 = across_104 - strand_y_15 * layer_0_y_by_q71;
        const double t105 = 0.024 * twice_across_4;
        const double across_30 = twice_across - 0.024 * (twice_across_2 - t105);
        const double length_15 = sinew_sqrt(across_30 + strand_y_15 * strand_y_15);
        const double t106 = 1.0 / length_15;
        const double t107 = 0.024 * across_by_y_squared_by_q73;
        const double across_176 = across_by_q73 - 0.024 * (across_by_y_by_q73 + t107);
        const double t108 = 0.024 * u_y_by_q73;
        const double half_square_by_106 = across_176 - strand_y_15 * (layer_0_y_by_q73 + t108);
        const double across_106 = across_by_q71 - 0.025 * across_by_y_by_q71;
        const double strand_y_16 = 0.025 + layer_0_y - 0.025 * u_y;
        const double half_square_by_32 = across_106 - strand_y_16 * layer_0_y_by_q71;
        const double across_32 = twice_across - 0.025 * (twice_across_2 - 0.025 * twice_across_4);
        const double length_16 = sinew_sqrt(across_32 + strand_y_16 * strand_y_16);
        const double t109 = 1.0 / length_16;
        const double across_slope_174 = across_by_y_by_q73 + 0.025 * across_by_y_squared_by_q73;
        const double half_square_by_108 = across_by_q73 - 0.025 * across_slope_174 - strand_y_16
            * (layer_0_y_by_q73 + 0.025 * u_y_by_q73);
        const double across_108 = across_by_q71 - 0.027 * across_by_y_by_q71;
        const double t110 = 0.027 * u_y;
        const double strand_y_17 = 0.027 + layer_0_y - t110;
        const double half_square_by_34 = across_108 - strand_y_17 * layer_0_y_by_q71;
        const double t111 = 0.027 * twice_across_4;
        const double across_34 = twice_across - 0.027 * (twice_across_2 - t111);
        const double length_17 = sinew_sqrt(across_34 + strand_y_17 * strand_y_17);
        const double t112 = 1.0 / length_17;
        const double t113 = 0.027 * across_by_y_squared_by_q73;
        const double across_180 = across_by_q73 - 0.027 * (across_by_y_by_q73 + t113);
        const double t114 = 0.027 * u_y_by_q73;
        const double half_square_by_110 = across_180 - strand_y_17 * (layer_0_y_by_q73 + t114);
        const double across_110 = across_by_q71 - 0.029 * across_by_y_by_q71;
        const double t115 = 0.029 * u_y;
        const double strand_y_18 = 0.028 + layer_0_y - t115;
        const double half_square_by_36 = across_110 - strand_y_18 * layer_0_y_by_q71;
        const double t116 = 0.029 * twice_across_4;
        const double across_36 = twice_across - 0.029 * (twice_across_2 - t116);
        const double length_18 = sinew_sqrt(across_36 + strand_y_18 * strand_y_18);
        const double t117 = 1.0 / length_18;
        const double t118 = 0.029 * across_by_y_squared_by_q73;
        const double across_182 = across_by_q73 - 0.029 * (across_by_y_by_q73 + t118);
        const double t119 = 0.029 * u_y_by_q73;
        const double half_square_by_112 = across_182 - strand_y_18 * (layer_0_y_by_q73 + t119);
        const double t120 = 0.013 * y_z;
        const double layer_1_x_by_q71 = t31 - t32 - t120;
        const double t121 = 0.013 * y_x;
        const double layer_1_x = t38 + t39 + t121;
        const double layer_1_z_by_q71 = t41 - t42 - t121;
        const double layer_1_z = 0.028 - origin_z - t43 + t44 + t120;
        const double across_38_by_q71 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71;
        const double layer_1_y_by_q71 = t45 + t46;
        const double layer_1_y = 0.006 - origin_y - t47 - t48 + t81;
        const double half_square_by_38 = across_38_by_q71 - layer_1_y * layer_1_y_by_q71;
        const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
        const double twice_across_6 = across_38 + across_38;
        const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
        const double t122 = 1.0 / length_19;
        const double layer_1_x_by_q73 = t53 - t54 - 0.013 * y_x_by_q73;
        const double layer_1_z_by_q73 = t55 - t56 - 0.013 * y_z_by_q73;
        const double across_38_by_q73 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73;
        const double layer_1_y_by_q73 = t57 - t58 - t85;
        const double half_square_by_114 = across_38_by_q73 - layer_1_y * layer_1_y_by_q73;
        const double across_by_y_2_by_q71 = y_x * (layer_1_z + layer_1_x_by_q71) - y_z * (layer_1_x
            + layer_1_z_by_q71);
        const double across_112 = across_38_by_q71 - 0.002 * across_by_y_2_by_q71;
        const double strand_y_20 = 0.001 + layer_1_y - 0.002 * u_y;
        const double half_square_by_40 = across_112 - strand_y_20 * layer_1_y_by_q71;
        const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
        const double twice_across_8 = across_by_y_2 + across_by_y_2;
        const double across_40 = twice_across_6 - 0.002 * (twice_across_8 - 0.002 * twice_across_4);
        const double length_20 = sinew_sqrt(across_40 + strand_y_20 * strand_y_20);
        const double t123 = 1.0 / length_20;
        const double across_by_y_2_by_q73 = y_x * layer_1_x_by_q73 + y_z * layer_1_z_by_q73
            - layer_1_x * y_x_by_q73 - layer_1_z * y_z_by_q73;
        const double across_slope_180 = across_by_y_2_by_q73 + 0.002 * across_by_y_squared_by_q73;
        const double across_184 = across_38_by_q73 - 0.002 * across_slope_180;
        const double half_square_by_116 = across_184 - strand_y_20 * (layer_1_y_by_q73 + 0.002
            * u_y_by_q73);
        const double across_114 = across_38_by_q71 - 0.003 * across_by_y_2_by_q71;
        const double strand_y_21 = 0.003 + layer_1_y - t61;
        const double half_square_by_42 = across_114 - strand_y_21 * layer_1_y_by_q71;
        const double across_42 = twice_across_6 - 0.003 * (twice_across_8 - t62);
        const double length_21 = sinew_sqrt(across_42 + strand_y_21 * strand_y_21);
        const double t124 = 1.0 / length_21;
        const double across_186 = across_38_by_q73 - 0.003 * (across_by_y_2_by_q73 + t64);
        const double half_square_by_118 = across_186 - strand_y_21 * (layer_1_y_by_q73 + t65);
        const double across_116 = across_38_by_q71 - 0.005 * across_by_y_2_by_q71;
        const double strand_y_22 = 0.005 + layer_1_y - t66;
        const double half_square_by_44 = across_116 - strand_y_22 * layer_1_y_by_q71;
        const double across_44 = twice_across_6 - 0.005 * (twice_across_8 - t67);
        const double length_22 = sinew_sqrt(across_44 + strand_y_22 * strand_y_22);
        const double t125 = 1.0 / length_22;
        const double across_188 = across_38_by_q73 - 0.005 * (across_by_y_2_by_q73 + t69);
        const double half_square_by_120 = across_188 - strand_y_22 * (layer_1_y_by_q73 + t70);
        const double across_118 = across_38_by_q71 - 0.007 * across_by_y_2_by_q71;
        const double strand_y_23 = 0.006 + layer_1_y - 0.007 * u_y;
        const double half_square_by_46 = across_118 - strand_y_23 * layer_1_y_by_q71;
        const double across_46 = twice_across_6 - 0.007 * (twice_across_8 - 0.007 * twice_across_4);
        const double length_23 = sinew_sqrt(across_46 + strand_y_23 * strand_y_23);
        const double t126 = 1.0 / length_23;
        const double across_slope_186 = across_by_y_2_by_q73 + 0.007 * across_by_y_squared_by_q73;
        const double across_190 = across_38_by_q73 - 0.007 * across_slope_186;
        const double half_square_by_122 = across_190 - strand_y_23 * (layer_1_y_by_q73 + 0.007
            * u_y_by_q73);
        const double across_120 = across_38_by_q71 - 0.008 * across_by_y_2_by_q71;
        const double strand_y_24 = 0.008 + layer_1_y - t72;
        const double half_square_by_48 = across_120 - strand_y_24 * layer_1_y_by_q71;
        const double across_48 = twice_across_6 - 0.008 * (twice_across_8 - t73);
        const double length_24 = sinew_sqrt(across_48 + strand_y_24 * strand_y_24);
        const double t127 = 1.0 / length_24;
        const double across_192 = across_38_by_q73 - 0.008 * (across_by_y_2_by_q73 + t75);
        const double half_square_by_124 = across_192 - strand_y_24 * (layer_1_y_by_q73 + t76);
        const double across_122 = across_38_by_q71 - 0.01 * across_by_y_2_by_q71;
        const double strand_y_25 = 0.009 + layer_1_y - 0.01 * u_y;
        const double half_square_by_50 = across_122 - strand_y_25 * layer_1_y_by_q71;
        const double across_50 = twice_across_6 - 0.01 * (twice_across_8 - 0.01 * twice_across_4);
        const double length_25 = sinew_sqrt(across_50 + strand_y_25 * strand_y_25);
        const double t128 = 1.0 / length_25;
        const double across_slope_190 = across_by_y_2_by_q73 + 0.01 * across_by_y_squared_by_q73;
        const double across_194 = across_38_by_q73 - 0.01 * across_slope_190;
        const double half_square_by_126 = across_194 - strand_y_25 * (layer_1_y_by_q73 + 0.01
            * u_y_by_q73);
        const double across_124 = across_38_by_q71 - 0.011 * across_by_y_2_by_q71;
        const double strand_y_26 = 0.011 + layer_1_y - t49;
        const double half_square_by_52 = across_124 - strand_y_26 * layer_1_y_by_q71;
        const double across_52 = twice_across_6 - 0.011 * (twice_across_8 - t78);
        const double length_26 = sinew_sqrt(across_52 + strand_y_26 * strand_y_26);
        const double t129 = 1.0 / length_26;
        const double across_196 = across_38_by_q73 - 0.011 * (across_by_y_2_by_q73 + t80);
        const double half_square_by_128 = across_196 - strand_y_26 * (layer_1_y_by_q73 + t59);
        const double across_126 = across_38_by_q71 - 0.013 * across_by_y_2_by_q71;
        const double strand_y_27 = 0.013 + layer_1_y - t81;
        const double half_square_by_54 = across_126 - strand_y_27 * layer_1_y_by_q71;
        const double across_54 = twice_across_6 - 0.013 * (twice_across_8 - t82);
        const double length_27 = sinew_sqrt(across_54 + strand_y_27 * strand_y_27);
        const double t130 = 1.0 / length_27;
        const double across_198 = across_38_by_q73 - 0.013 * (across_by_y_2_by_q73 + t84);
        const double half_square_by_130 = across_198 - strand_y_27 * (layer_1_y_by_q73 + t85);
        const double across_128 = across_38_by_q71 - 0.015 * across_by_y_2_by_q71;
        const double strand_y_28 = 0.014 + layer_1_y - 0.015 * u_y;
        const double half_square_by_56 = across_128 - strand_y_28 * layer_1_y_by_q71;
        const double across_56 = twice_across_6 - 0.015 * (twice_across_8 - 0.015 * twice_across_4);
        const double length_28 = sinew_sqrt(across_56 + strand_y_28 * strand_y_28);
        const double t131 = 1.0 / length_28;
        const double across_slope_196 = across_by_y_2_by_q73 + 0.015 * across_by_y_squared_by_q73;
        const double across_200 = across_38_by_q73 - 0.015 * across_slope_196;
        const double half_square_by_132 = across_200 - strand_y_28 * (layer_1_y_by_q73 + 0.015
            * u_y_by_q73);
        const double across_130 = across_38_by_q71 - 0.016 * across_by_y_2_by_q71;
        const double strand_y_29 = 0.016 + layer_1_y - t87;
        const double half_square_by_58 = across_130 - strand_y_29 * layer_1_y_by_q71;
        const double across_58 = twice_across_6 - 0.016 * (twice_across_8 - t88);
        const double length_29 = sinew_sqrt(across_58 + strand_y_29 * strand_y_29);
        const double t132 = 1.0 / length_29;
        const double across_202 = across_38_by_q73 - 0.016 * (across_by_y_2_by_q73 + t90);
        const double half_square_by_134 = across_202 - strand_y_29 * (layer_1_y_by_q73 + t91);
        const double across_132 = across_38_by_q71 - 0.018 * across_by_y_2_by_q71;
        const double strand_y_30 = 0.017 + layer_1_y - 0.018 * u_y;
        const double half_square_by_60 = across_132 - strand_y_30 * layer_1_y_by_q71;
        const double across_60 = twice_across_6 - 0.018 * (twice_across_8 - 0.018 * twice_across_4);
        const double length_30 = sinew_sqrt(across_60 + strand_y_30 * strand_y_30);
        const double t133 = 1.0 / length_30;
        const double across_slope_200 = across_by_y_2_by_q73 + 0.018 * across_by_y_squared_by_q73;
        const double across_204 = across_38_by_q73 - 0.018 * across_slope_200;
        const double half_square_by_136 = across_204 - strand_y_30 * (layer_1_y_by_q73 + 0.018
            * u_y_by_q73);
        const double across_134 = across_38_by_q71 - 0.019 * across_by_y_2_by_q71;
        const double strand_y_31 = 0.019 + layer_1_y - t93;
        const double half_square_by_62 = across_134 - strand_y_31 * layer_1_y_by_q71;
        const double across_62 = twice_across_6 - 0.019 * (twice_across_8 - t94);
        const double length_31 = sinew_sqrt(across_62 + strand_y_31 * strand_y_31);
        const double t134 = 1.0 / length_31;
        const double across_206 = across_38_by_q73 - 0.019 * (across_by_y_2_by_q73 + t96);
        const double half_square_by_138 = across_206 - strand_y_31 * (layer_1_y_by_q73 + t97);
        const double across_136 = across_38_by_q71 - 0.021 * across_by_y_2_by_q71;
        const double strand_y_32 = 0.021 + layer_1_y - t98;
        const double half_square_by_64 = across_136 - strand_y_32 * layer_1_y_by_q71;
        const double across_64 = twice_across_6 - 0.021 * (twice_across_8 - t99);
        const double length_32 = sinew_sqrt(across_64 + strand_y_32 * strand_y_32);
        const double t135 = 1.0 / length_32;
        const double across_208 = across_38_by_q73 - 0.021 * (across_by_y_2_by_q73 + t101);
        const double half_square_by_140 = across_208 - strand_y_32 * (layer_1_y_by_q73 + t102);
        const double across_138 = across_38_by_q71 - 0.023 * across_by_y_2_by_q71;
        const double strand_y_33 = 0.022 + layer_1_y - 0.023 * u_y;
        const double half_square_by_66 = across_138 - strand_y_33 * layer_1_y_by_q71;
        const double across_66 = twice_across_6 - 0.023 * (twice_across_8 - 0.023 * twice_across_4);
        const double length_33 = sinew_sqrt(across_66 + strand_y_33 * strand_y_33);
        const double t136 = 1.0 / length_33;
        const double across_slope_206 = across_by_y_2_by_q73 + 0.023 * across_by_y_squared_by_q73;
        const double across_210 = across_38_by_q73 - 0.023 * across_slope_206;
        const double half_square_by_142 = across_210 - strand_y_33 * (layer_1_y_by_q73 + 0.023
            * u_y_by_q73);
        const double across_140 = across_38_by_q71 - 0.024 * across_by_y_2_by_q71;
        const double strand_y_34 = 0.024 + layer_1_y - t104;
        const double half_square_by_68 = across_140 - strand_y_34 * layer_1_y_by_q71;
        const double across_68 = twice_across_6 - 0.024 * (twice_across_8 - t105);
        const double length_34 = sinew_sqrt(across_68 + strand_y_34 * strand_y_34);
        const double t137 = 1.0 / length_34;
        const double across_212 = across_38_by_q73 - 0.024 * (across_by_y_2_by_q73 + t107);
        const double half_square_by_144 = across_212 - strand_y_34 * (layer_1_y_by_q73 + t108);
        const double across_142 = across_38_by_q71 - 0.026 * across_by_y_2_by_q71;
        const double strand_y_35 = 0.025 + layer_1_y - 0.026 * u_y;
        const double half_square_by_70 = across_142 - strand_y_35 * layer_1_y_by_q71;
        const double across_70 = twice_across_6 - 0.026 * (twice_across_8 - 0.026 * twice_across_4);
        const double length_35 = sinew_sqrt(across_70 + strand_y_35 * strand_y_35);
        const double t138 = 1.0 / length_35;
        const double across_slope_210 = across_by_y_2_by_q73 + 0.026 * across_by_y_squared_by_q73;
        const double across_214 = across_38_by_q73 - 0.026 * across_slope_210;
        const double half_square_by_146 = across_214 - strand_y_35 * (layer_1_y_by_q73 + 0.026
            * u_y_by_q73);
        const double across_144 = across_38_by_q71 - 0.027 * across_by_y_2_by_q71;
        const double strand_y_36 = 0.027 + layer_1_y - t110;
        const double half_square_by_72 = across_144 - strand_y_36 * layer_1_y_by_q71;
        const double across_72 = twice_across_6 - 0.027 * (twice_across_8 - t111);
        const double length_36 = sinew_sqrt(across_72 + strand_y_36 * strand_y_36);
        const double t139 = 1.0 / length_36;
        const double across_216 = across_38_by_q73 - 0.027 * (across_by_y_2_by_q73 + t113);
        const double half_square_by_148 = across_216 - strand_y_36 * (layer_1_y_by_q73 + t114);
        const double across_146 = across_38_by_q71 - 0.029 * across_by_y_2_by_q71;
        const double strand_y_37 = 0.029 + layer_1_y - t115;
        const double half_square_by_74 = across_146 - strand_y_37 * layer_1_y_by_q71;
        const double across_74 = twice_across_6 - 0.029 * (twice_across_8 - t116);
        const double length_37 = sinew_sqrt(across_74 + strand_y_37 * strand_y_37);
        const double t140 = 1.0 / length_37;
        const double across_218 = across_38_by_q73 - 0.029 * (across_by_y_2_by_q73 + t118);
        const double half_square_by_150 = across_218 - strand_y_37 * (layer_1_y_by_q73 + t119);
        P[state] = half_square_by * t50;
        P[1 * n + state] = -(half_square_by_76 * t50);
        P[2 * n + state] = half_square_by_2 * t60;
        P[3 * n + state] = -(half_square_by_78 * t60);
        P[4 * n + state] = half_square_by_4 * t63;
        P[5 * n + state] = -(half_square_by_80 * t63);
        P[6 * n + state] = half_square_by_6 * t68;
        P[7 * n + state] = -(half_square_by_82 * t68);
        P[8 * n + state] = half_square_by_8 * t71;
        P[9 * n + state] = -(half_square_by_84 * t71);
        P[10 * n + state] = half_square_by_10 * t74;
        P[11 * n + state] = -(half_square_by_86 * t74);
        P[12 * n + state] = half_square_by_12 * t77;
        P[13 * n + state] = -(half_square_by_88 * t77);
        P[14 * n + state] = half_square_by_14 * t79;
        P[15 * n + state] = -(half_square_by_90 * t79);
        P[16 * n + state] = half_square_by_16 * t83;
        P[17 * n + state] = -(half_square_by_92 * t83);
        P[18 * n + state] = half_square_by_18 * t86;
        P[19 * n + state] = -(half_square_by_94 * t86);
        P[20 * n + state] = half_square_by_20 * t89;
        P[21 * n + state] = -(half_square_by_96 * t89);
        P[22 * n + state] = half_square_by_22 * t92;
        P[23 * n + state] = -(half_square_by_98 * t92);
        P[24 * n + state] = half_square_by_24 * t95;
        P[25 * n + state] = -(half_square_by_100 * t95);
        P[26 * n + state] = half_square_by_26 * t100;
        P[27 * n + state] = -(half_square_by_102 * t100);
        P[28 * n + state] = half_square_by_28 * t103;
        P[29 * n + state] = -(half_square_by_104 * t103);
        P[30 * n + state] = half_square_by_30 * t106;
        P[31 * n + state] = -(half_square_by_106 * t106);
        P[32 * n + state] = half_square_by_32 * t109;
        P[33 * n + state] = -(half_square_by_108 * t109);
        P[34 * n + state] = half_square_by_34 * t112;
        P[35 * n + state] = -(half_square_by_110 * t112);
        P[36 * n + state] = half_square_by_36 * t117;
        P[37 * n + state] = -(half_square_by_112 * t117);
        P[38 * n + state] = half_square_by_38 * t122;
        P[39 * n + state] = -(half_square_by_114 * t122);
        P[40 * n + state] = half_square_by_40 * t123;
        P[41 * n + state] = -(half_square_by_116 * t123);
        P[42 * n + state] = half_square_by_42 * t124;
        P[43 * n + state] = -(half_square_by_118 * t124);
        P[44 * n + state] = half_square_by_44 * t125;
        P[45 * n + state] = -(half_square_by_120 * t125);
        P[46 * n + state] = half_square_by_46 * t126;
        P[47 * n + state] = -(half_square_by_122 * t126);
        P[48 * n + state] = half_square_by_48 * t127;
        P[49 * n + state] = -(half_square_by_124 * t127);
        P[50 * n + state] = half_square_by_50 * t128;
        P[51 * n + state] = -(half_square_by_126 * t128);
        P[52 * n + state] = half_square_by_52 * t129;
        P[53 * n + state] = -(half_square_by_128 * t129);
        P[54 * n + state] = half_square_by_54 * t130;
        P[55 * n + state] = -(half_square_by_130 * t130);
        P[56 * n + state] = half_square_by_56 * t131;
        P[57 * n + state] = -(half_square_by_132 * t131);
        P[58 * n + state] = half_square_by_58 * t132;
        P[59 * n + state] = -(half_square_by_134 * t132);
        P[60 * n + state] = half_square_by_60 * t133;
        P[61 * n + state] = -(half_square_by_136 * t133);
        P[62 * n + state] = half_square_by_62 * t134;
        P[63 * n + state] = -(half_square_by_138 * t134);
        P[64 * n + state] = half_square_by_64 * t135;
        P[65 * n + state] = -(half_square_by_140 * t135);
        P[66 * n + state] = half_square_by_66 * t136;
        P[67 * n + state] = -(half_square_by_142 * t136);
        P[68 * n + state] = half_square_by_68 * t137;
        P[69 * n + state] = -(half_square_by_144 * t137);
        P[70 * n + state] = half_square_by_70 * t138;
        P[71 * n + state] = -(half_square_by_146 * t138);
        P[72 * n + state] = half_square_by_72 * t139;
        P[73 * n + state] = -(half_square_by_148 * t139);
        P[74 * n + state] = half_square_by_74 * t140;
        P[75 * n + state] = -(half_square_by_150 * t140);
    }
}

void wrist_bending_angles_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT angles)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double M_e = 0.5 * (B_e + C_e);
        const double s_e = M_e - 0.036 * sin_q71;
        const double M_y = 0.5 * (B_y - C_y);
        const double s_y = 0.021 - M_y;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t1 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t1;
        const double z_plane_x = u_y * cos_A;
        const double sin_A = (p_y * root - p_z * limited) * t1;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double x_plane_x = u_y * sin_A;
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double t2 = 0.004 * x_z;
        const double t3 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double t4 = 0.011 * y_z;
        const double layer_0_z = 0.008 - origin_z - t2 - t3 + t4;
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double t5 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * x_x;
        const double t6 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double t7 = 0.011 * y_x;
        const double layer_0_x = t5 - t6 + t7;
        const double aside_y = x_x * layer_0_z + x_z * layer_0_x;
        const double x_plane_y = u_e * sin_A;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t8 = 0.004 * x_plane_y;
        const double t9 = 0.01 * z_plane_y;
        const double t10 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t8 + t9 + t10;
        const double aside_x = x_plane_y * layer_0_z - x_z * layer_0_y;
        const double aside_z_2 = x_plane_y * layer_0_x + x_x * layer_0_y;
        const double t11 = sinew_sqrt(aside_x * aside_x + aside_y * aside_y + aside_z_2
            * aside_z_2);
        const double t12 = sinew_atan2(t11, x_plane_y * layer_0_y - x_x * layer_0_x + x_z
            * layer_0_z);
        const double t13 = sinew_atan2(sinew_sqrt(layer_0_y * layer_0_y + layer_0_z * layer_0_z),
            -layer_0_x);
        const double strand_1_z = layer_0_z - 0.001 * y_z;
        const double strand_1_x = layer_0_x - 0.001 * y_x;
        const double aside_y_2 = x_x * strand_1_z + x_z * strand_1_x;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double aside_x_2 = x_plane_y * strand_1_z - x_z * strand_1_y;
        const double aside_z_6 = x_plane_y * strand_1_x + x_x * strand_1_y;
        const double t14 = sinew_sqrt(aside_x_2 * aside_x_2 + aside_y_2 * aside_y_2 + aside_z_6
            * aside_z_6);
        const double t15 = sinew_atan2(t14, x_plane_y * strand_1_y - x_x * strand_1_x + x_z
            * strand_1_z);
        const double t16 = sinew_atan2(sinew_sqrt(strand_1_y * strand_1_y + strand_1_z
            * strand_1_z), -strand_1_x);
        const double t17 = 0.003 * y_z;
        const double strand_2_z = layer_0_z - t17;
        const double t18 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t18;
        const double aside_y_4 = x_x * strand_2_z + x_z * strand_2_x;
        const double t19 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t19;
        const double aside_x_4 = x_plane_y * strand_2_z - x_z * strand_2_y;
        const double aside_z_10 = x_plane_y * strand_2_x + x_x * strand_2_y;
        const double t20 = sinew_sqrt(aside_x_4 * aside_x_4 + aside_y_4 * aside_y_4 + aside_z_10
            * aside_z_10);
        const double t21 = sinew_atan2(t20, x_plane_y * strand_2_y - x_x * strand_2_x + x_z
            * strand_2_z);
        const double t22 = sinew_atan2(sinew_sqrt(strand_2_y * strand_2_y + strand_2_z
            * strand_2_z), -strand_2_x);
        const double t23 = 0.005 * y_z;
        const double strand_3_z = layer_0_z - t23;
        const double t24 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t24;
        const double aside_y_6 = x_x * strand_3_z + x_z * strand_3_x;
        const double t25 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t25;
        const double aside_x_6 = x_plane_y * strand_3_z - x_z * strand_3_y;
        const double aside_z_14 = x_plane_y * strand_3_x + x_x * strand_3_y;
        const double t26 = sinew_sqrt(aside_x_6 * aside_x_6 + aside_y_6 * aside_y_6 + aside_z_14
            * aside_z_14);
        const double t27 = sinew_atan2(t26, x_plane_y * strand_3_y - x_x * strand_3_x + x_z
            * strand_3_z);
        const double t28 = sinew_atan2(sinew_sqrt(strand_3_y * strand_3_y + strand_3_z
            * strand_3_z), -strand_3_x);
        const double strand_4_z = layer_0_z - 0.006 * y_z;
        const double strand_4_x = layer_0_x - 0.006 * y_x;
        const double aside_y_8 = x_x * strand_4_z + x_z * strand_4_x;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double aside_x_8 = x_plane_y * strand_4_z - x_z * strand_4_y;
        const double aside_z_18 = x_plane_y * strand_4_x + x_x * strand_4_y;
        const double t29 = sinew_sqrt(aside_x_8 * aside_x_8 + aside_y_8 * aside_y_8 + aside_z_18
            * aside_z_18);
        const double t30 = sinew_atan2(t29, x_plane_y * strand_4_y - x_x * strand_4_x + x_z
            * strand_4_z);
        const double t31 = sinew_atan2(sinew_sqrt(strand_4_y * strand_4_y + strand_4_z
            * strand_4_z), -strand_4_x);
        const double t32 = 0.008 * y_z;
        const double strand_5_z = layer_0_z - t32;
        const double t33 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t33;
        const double aside_y_10 = x_x * strand_5_z + x_z * strand_5_x;
        const double t34 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t34;
        const double aside_x_10 = x_plane_y * strand_5_z - x_z * strand_5_y;
        const double aside_z_22 = x_plane_y * strand_5_x + x_x * strand_5_y;
        const double t35 = aside_x_10 * aside_x_10 + aside_y_10 * aside_y_10 + aside_z_22
            * aside_z_22;
        const double t36 = sinew_atan2(sinew_sqrt(t35), x_plane_y * strand_5_y - x_x * strand_5_x
            + x_z * strand_5_z);
        const double t37 = sinew_atan2(sinew_sqrt(strand_5_y * strand_5_y + strand_5_z
            * strand_5_z), -strand_5_x);
        const double strand_6_z = layer_0_z - 0.009 * y_z;
        const double strand_6_x = layer_0_x - 0.009 * y_x;
        const double aside_y_12 = x_x * strand_6_z + x_z * strand_6_x;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double aside_x_12 = x_plane_y * strand_6_z - x_z * strand_6_y;
        const double aside_z_26 = x_plane_y * strand_6_x + x_x * strand_6_y;
        const double t38 = aside_x_12 * aside_x_12 + aside_y_12 * aside_y_12 + aside_z_26
            * aside_z_26;
        const double t39 = sinew_atan2(sinew_sqrt(t38), x_plane_y * strand_6_y - x_x * strand_6_x
            + x_z * strand_6_z);
        const double t40 = sinew_atan2(sinew_sqrt(strand_6_y * strand_6_y + strand_6_z
            * strand_6_z), -strand_6_x);
        const double strand_7_z = layer_0_z - t4;
        const double strand_7_x = layer_0_x - t7;
        const double aside_y_14 = x_x * strand_7_z + x_z * strand_7_x;
        const double strand_7_y = 0.011 + layer_0_y - t10;
        const double aside_x_14 = x_plane_y * strand_7_z - x_z * strand_7_y;
        const double aside_z_30 = x_plane_y * strand_7_x + x_x * strand_7_y;
        const double t41 = aside_x_14 * aside_x_14 + aside_y_14 * aside_y_14 + aside_z_30
            * aside_z_30;
        const double t42 = sinew_atan2(sinew_sqrt(t41), x_plane_y * strand_7_y - x_x * strand_7_x
            + x_z * strand_7_z);
        const double t43 = sinew_atan2(sinew_sqrt(strand_7_y * strand_7_y + strand_7_z
            * strand_7_z), -strand_7_x);
        const double t44 = 0.013 * y_z;
        const double strand_8_z = layer_0_z - t44;
        const double t45 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t45;
        const double aside_y_16 = x_x * strand_8_z + x_z * strand_8_x;
        const double t46 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t46;
        const double aside_x_16 = x_plane_y * strand_8_z - x_z * strand_8_y;
        const double aside_z_34 = x_plane_y * strand_8_x + x_x * strand_8_y;
        const double t47 = aside_x_16 * aside_x_16 + aside_y_16 * aside_y_16 + aside_z_34
            * aside_z_34;
        const double t48 = sinew_atan2(sinew_sqrt(t47), x_plane_y * strand_8_y - x_x * strand_8_x
            + x_z * strand_8_z);
        const double t49 = sinew_atan2(sinew_sqrt(strand_8_y * strand_8_y + strand_8_z
            * strand_8_z), -strand_8_x);
        const double strand_9_z = layer_0_z - 0.014 * y_z;
        const double strand_9_x = layer_0_x - 0.014 * y_x;
        const double aside_y_18 = x_x * strand_9_z + x_z * strand_9_x;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double aside_x_18 = x_plane_y * strand_9_z - x_z * strand_9_y;
        const double aside_z_38 = x_plane_y * strand_9_x + x_x * strand_9_y;
        const double t50 = aside_x_18 * aside_x_18 + aside_y_18 * aside_y_18 + aside_z_38
            * aside_z_38;
        const double t51 = sinew_atan2(sinew_sqrt(t50), x_plane_y * strand_9_y - x_x * strand_9_x
            + x_z * strand_9_z);
        const double t52 = sinew_atan2(sinew_sqrt(strand_9_y * strand_9_y + strand_9_z
            * strand_9_z), -strand_9_x);
        const double t53 = 0.016 * y_z;
        const double strand_10_z = layer_0_z - t53;
        const double t54 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t54;
        const double aside_y_20 = x_x * strand_10_z + x_z * strand_10_x;
        const double t55 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t55;
        const double aside_x_20 = x_plane_y * strand_10_z - x_z * strand_10_y;
        const double aside_z_42 = x_plane_y * strand_10_x + x_x * strand_10_y;
        const double t56 = aside_x_20 * aside_x_20 + aside_y_20 * aside_y_20 + aside_z_42
            * aside_z_42;
        const double t57 = sinew_atan2(sinew_sqrt(t56), x_plane_y * strand_10_y - x_x * strand_10_x
            + x_z * strand_10_z);
        const double t58 = sinew_atan2(sinew_sqrt(strand_10_y * strand_10_y + strand_10_z
            * strand_10_z), -strand_10_x);
        const double strand_11_z = layer_0_z - 0.017 * y_z;
        const double strand_11_x = layer_0_x - 0.017 * y_x;
        const double aside_y_22 = x_x * strand_11_z + x_z * strand_11_x;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double aside_x_22 = x_plane_y * strand_11_z - x_z * strand_11_y;
        const double aside_z_46 = x_plane_y * strand_11_x + x_x * strand_11_y;
        const double t59 = aside_x_22 * aside_x_22 + aside_y_22 * aside_y_22 + aside_z_46
            * aside_z_46;
        const double t60 = sinew_atan2(sinew_sqrt(t59), x_plane_y * strand_11_y - x_x * strand_11_x
            + x_z * strand_11_z);
        const double t61 = sinew_atan2(sinew_sqrt(strand_11_y * strand_11_y + strand_11_z
            * strand_11_z), -strand_11_x);
        const double t62 = 0.019 * y_z;
        const double strand_12_z = layer_0_z - t62;
        const double t63 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t63;
        const double aside_y_24 = x_x * strand_12_z + x_z * strand_12_x;
        const double t64 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t64;
        const double aside_x_24 = x_plane_y * strand_12_z - x_z * strand_12_y;
        const double aside_z_50 = x_plane_y * strand_12_x + x_x * strand_12_y;
        const double t65 = aside_x_24 * aside_x_24 + aside_y_24 * aside_y_24 + aside_z_50
            * aside_z_50;
        const double t66 = sinew_atan2(sinew_sqrt(t65), x_plane_y * strand_12_y - x_x * strand_12_x
            + x_z * strand_12_z);
        const double t67 = sinew_atan2(sinew_sqrt(strand_12_y * strand_12_y + strand_12_z
            * strand_12_z), -strand_12_x);
        const double t68 = 0.021 * y_z;
        const double strand_13_z = layer_0_z - t68;
        const double t69 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t69;
        const double aside_y_26 = x_x * strand_13_z + x_z * strand_13_x;
        const double t70 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t70;
        const double aside_x_26 = x_plane_y * strand_13_z - x_z * strand_13_y;
        const double aside_z_54 = x_plane_y * strand_13_x + x_x * strand_13_y;
        const double t71 = aside_x_26 * aside_x_26 + aside_y_26 * aside_y_26 + aside_z_54
            * aside_z_54;
        const double t72 = sinew_atan2(sinew_sqrt(t71), x_plane_y * strand_13_y - x_x * strand_13_x
            + x_z * strand_13_z);
        const double t73 = sinew_atan2(sinew_sqrt(strand_13_y * strand_13_y + strand_13_z
            * strand_13_z), -strand_13_x);
        const double strand_14_z = layer_0_z - 0.022 * y_z;
        const double strand_14_x = layer_0_x - 0.022 * y_x;
        const double aside_y_28 = x_x * strand_14_z + x_z * strand_14_x;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double aside_x_28 = x_plane_y * strand_14_z - x_z * strand_14_y;
        const double aside_z_58 = x_plane_y * strand_14_x + x_x * strand_14_y;
        const double t74 = aside_x_28 * aside_x_28 + aside_y_28 * aside_y_28 + aside_z_58
            * aside_z_58;
        const double t75 = sinew_atan2(sinew_sqrt(t74), x_plane_y * strand_14_y - x_x * strand_14_x
            + x_z * strand_14_z);
        const double t76 = sinew_atan2(sinew_sqrt(strand_14_y * strand_14_y + strand_14_z
            * strand_14_z), -strand_14_x);
        const double t77 = 0.024 * y_z;
        const double strand_15_z = layer_0_z - t77;
        const double t78 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t78;
        const double aside_y_30 = x_x * strand_15_z + x_z * strand_15_x;
        const double t79 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t79;
        const double aside_x_30 = x_plane_y * strand_15_z - x_z * strand_15_y;
        const double aside_z_62 = x_plane_y * strand_15_x + x_x * strand_15_y;
        const double t80 = aside_x_30 * aside_x_30 + aside_y_30 * aside_y_30 + aside_z_62
            * aside_z_62;
        const double t81 = sinew_atan2(sinew_sqrt(t80), x_plane_y * strand_15_y - x_x * strand_15_x
            + x_z * strand_15_z);
        const double t82 = sinew_atan2(sinew_sqrt(strand_15_y * strand_15_y + strand_15_z
            * strand_15_z), -strand_15_x);
        const double strand_16_z = layer_0_z - 0.025 * y_z;
        const double strand_16_x = layer_0_x - 0.025 * y_x;
        const double aside_y_32 = x_x * strand_16_z + x_z * strand_16_x;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double aside_x_32 = x_plane_y * strand_16_z - x_z * strand_16_y;
        const double aside_z_66 = x_plane_y * strand_16_x + x_x * strand_16_y;
        const double t83 = aside_x_32 * aside_x_32 + aside_y_32 * aside_y_32 + aside_z_66
            * aside_z_66;
        const double t84 = sinew_atan2(sinew_sqrt(t83), x_plane_y * strand_16_y - x_x * strand_16_x
            + x_z * strand_16_z);
        const double t85 = sinew_atan2(sinew_sqrt(strand_16_y * strand_16_y + strand_16_z
            * strand_16_z), -strand_16_x);
        const double t86 = 0.027 * y_z;
        const double strand_17_z = layer_0_z - t86;
        const double t87 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t87;
        const double aside_y_34 = x_x * strand_17_z + x_z * strand_17_x;
        const double t88 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t88;
        const double aside_x_34 = x_plane_y * strand_17_z - x_z * strand_17_y;
        const double aside_z_70 = x_plane_y * strand_17_x + x_x * strand_17_y;
        const double t89 = aside_x_34 * aside_x_34 + aside_y_34 * aside_y_34 + aside_z_70
            * aside_z_70;
        const double t90 = sinew_atan2(sinew_sqrt(t89), x_plane_y * strand_17_y - x_x * strand_17_x
            + x_z * strand_17_z);
        const double t91 = sinew_atan2(sinew_sqrt(strand_17_y * strand_17_y + strand_17_z
            * strand_17_z), -strand_17_x);
        const double t92 = 0.029 * y_z;
        const double strand_18_z = layer_0_z - t92;
        const double t93 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t93;
        const double aside_y_36 = x_x * strand_18_z + x_z * strand_18_x;
        const double t94 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t94;
        const double aside_x_36 = x_plane_y * strand_18_z - x_z * strand_18_y;
        const double aside_z_74 = x_plane_y * strand_18_x + x_x * strand_18_y;
        const double t95 = aside_x_36 * aside_x_36 + aside_y_36 * aside_y_36 + aside_z_74
            * aside_z_74;
        const double t96 = sinew_atan2(sinew_sqrt(t95), x_plane_y * strand_18_y - x_x * strand_18_x
            + x_z * strand_18_z);
        const double t97 = sinew_atan2(sinew_sqrt(strand_18_y * strand_18_y + strand_18_z
            * strand_18_z), -strand_18_x);
        const double layer_1_z = 0.028 - origin_z - t2 + t3 + t44;
        const double layer_1_x = t5 + t6 + t45;
        const double aside_y_38 = x_x * layer_1_z + x_z * layer_1_x;
        const double layer_1_y = 0.006 - origin_y - t8 - t9 + t46;
        const double aside_x_38 = x_plane_y * layer_1_z - x_z * layer_1_y;
        const double aside_z_78 = x_plane_y * layer_1_x + x_x * layer_1_y;
        const double t98 = aside_x_38 * aside_x_38 + aside_y_38 * aside_y_38 + aside_z_78
            * aside_z_78;
        const double t99 = sinew_atan2(sinew_sqrt(t98), x_plane_y * layer_1_y - x_x * layer_1_x
            + x_z * layer_1_z);
        const double t100 = sinew_atan2(sinew_sqrt(layer_1_y * layer_1_y + layer_1_z * layer_1_z),
            -layer_1_x);
        const double strand_20_z = layer_1_z - 0.002 * y_z;
        const double strand_20_x = layer_1_x - 0.002 * y_x;
        const double aside_y_40 = x_x * strand_20_z + x_z * strand_20_x;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double aside_x_40 = x_plane_y * strand_20_z - x_z * strand_20_y;
        const double aside_z_82 = x_plane_y * strand_20_x + x_x * strand_20_y;
        const double t101 = aside_x_40 * aside_x_40 + aside_y_40 * aside_y_40 + aside_z_82
            * aside_z_82;
        const double t102 = sinew_atan2(sinew_sqrt(t101), x_plane_y * strand_20_y - x_x
            * strand_20_x + x_z * strand_20_z);
        const double t103 = sinew_atan2(sinew_sqrt(strand_20_y * strand_20_y + strand_20_z
            * strand_20_z), -strand_20_x);
        const double strand_21_z = layer_1_z - t17;
        const double strand_21_x = layer_1_x - t18;
        const double aside_y_42 = x_x * strand_21_z + x_z * strand_21_x;
        const double strand_21_y = 0.003 + layer_1_y - t19;
        const double aside_x_42 = x_plane_y * strand_21_z - x_z * strand_21_y;
        const double aside_z_86 = x_plane_y * strand_21_x + x_x * strand_21_y;
        const double t104 = aside_x_42 * aside_x_42 + aside_y_42 * aside_y_42 + aside_z_86
            * aside_z_86;
        const double t105 = sinew_atan2(sinew_sqrt(t104), x_plane_y * strand_21_y - x_x
            * strand_21_x + x_z * strand_21_z);
        const double t106 = sinew_atan2(sinew_sqrt(strand_21_y * strand_21_y + strand_21_z
            * strand_21_z), -strand_21_x);
        const double strand_22_z = layer_1_z - t23;
        const double strand_22_x = layer_1_x - t24;
        const double aside_y_44 = x_x * strand_22_z + x_z * strand_22_x;
        const double strand_22_y = 0.005 + layer_1_y - t25;
        const double aside_x_44 = x_plane_y * strand_22_z - x_z * strand_22_y;
        const double aside_z_90 = x_plane_y * strand_22_x + x_x * strand_22_y;
        const double t107 = aside_x_44 * aside_x_44 + aside_y_44 * aside_y_44 + aside_z_90
            * aside_z_90;
        const double t108 = sinew_atan2(sinew_sqrt(t107), x_plane_y * strand_22_y - x_x
            * strand_22_x + x_z * strand_22_z);
        const double t109 = sinew_atan2(sinew_sqrt(strand_22_y * strand_22_y + strand_22_z
            * strand_22_z), -strand_22_x);
        const double strand_23_z = layer_1_z - 0.007 * y_z;
        const double strand_23_x = layer_1_x - 0.007 * y_x;
        const double aside_y_46 = x_x * strand_23_z + x_z * strand_23_x;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double aside_x_46 = x_plane_y * strand_23_z - x_z * strand_23_y;
        const double aside_z_94 = x_plane_y * strand_23_x + x_x * strand_23_y;
        const double t110 = aside_x_46 * aside_x_46 + aside_y_46 * aside_y_46 + aside_z_94
            * aside_z_94;
        const double t111 = sinew_atan2(sinew_sqrt(t110), x_plane_y * strand_23_y - x_x
            * strand_23_x + x_z * strand_23_z);
        const double t112 = sinew_atan2(sinew_sqrt(strand_23_y * strand_23_y + strand_23_z
            * strand_23_z), -strand_23_x);
        const double strand_24_z = layer_1_z - t32;
        const double strand_24_x = layer_1_x - t33;
        const double aside_y_48 = x_x * strand_24_z + x_z * strand_24_x;
        const double strand_24_y = 0.008 + layer_1_y - t34;
        const double aside_x_48 = x_plane_y * strand_24_z - x_z * strand_24_y;
        const double aside_z_98 = x_plane_y * strand_24_x + x_x * strand_24_y;
        const double t113 = aside_x_48 * aside_x_48 + aside_y_48 * aside_y_48 + aside_z_98
            * aside_z_98;
        const double t114 = sinew_atan2(sinew_sqrt(t113), x_plane_y * strand_24_y - x_x
            * strand_24_x + x_z * strand_24_z);
        const double t115 = sinew_atan2(sinew_sqrt(strand_24_y * strand_24_y + strand_24_z
            * strand_24_z), -strand_24_x);
        const double strand_25_z = layer_1_z - 0.01 * y_z;
        const double strand_25_x = layer_1_x - 0.01 * y_x;
        const double aside_y_50 = x_x * strand_25_z + x_z * strand_25_x;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double aside_x_50 = x_plane_y * strand_25_z - x_z * strand_25_y;
        const double aside_z_102 = x_plane_y * strand_25_x + x_x * strand_25_y;
        const double t116 = aside_x_50 * aside_x_50 + aside_y_50 * aside_y_50 + aside_z_102
            * aside_z_102;
        const double t117 = sinew_atan2(sinew_sqrt(t116), x_plane_y * strand_25_y - x_x
            * strand_25_x + x_z * strand_25_z);
        const double t118 = sinew_atan2(sinew_sqrt(strand_25_y * strand_25_y + strand_25_z
            * strand_25_z), -strand_25_x);
        const double strand_26_z = layer_1_z - t4;
        const double strand_26_x = layer_1_x - t7;
        const double aside_y_52 = x_x * strand_26_z + x_z * strand_26_x;
        const double strand_26_y = 0.011 + layer_1_y - t10;
        const double aside_x_52 = x_plane_y * strand_26_z - x_z * strand_26_y;
        const double aside_z_106 = x_plane_y * strand_26_x + x_x * strand_26_y;
        const double t119 = aside_x_52 * aside_x_52 + aside_y_52 * aside_y_52 + aside_z_106
            * aside_z_106;
        const double t120 = sinew_atan2(sinew_sqrt(t119), x_plane_y * strand_26_y - x_x
            * strand_26_x + x_z * strand_26_z);
        const double t121 = sinew_atan2(sinew_sqrt(strand_26_y * strand_26_y + strand_26_z
            * strand_26_z), -strand_26_x);
        const double strand_27_z = layer_1_z - t44;
        const double strand_27_x = layer_1_x - t45;
        const double aside_y_54 = x_x * strand_27_z + x_z * strand_27_x;
        const double strand_27_y = 0.013 + layer_1_y - t46;
        const double aside_x_54 = x_plane_y * strand_27_z - x_z * strand_27_y;
        const double aside_z_110 = x_plane_y * strand_27_x + x_x * strand_27_y;
        const double t122 = aside_x_54 * aside_x_54 + aside_y_54 * aside_y_54 + aside_z_110
            * aside_z_110;
        const double t123 = sinew_atan2(sinew_sqrt(t122), x_plane_y * strand_27_y - x_x
            * strand_27_x + x_z * strand_27_z);
        const double t124 = sinew_atan2(sinew_sqrt(strand_27_y * strand_27_y + strand_27_z
            * strand_27_z), -strand_27_x);
        const double strand_28_z = layer_1_z - 0.015 * y_z;
        const double strand_28_x = layer_1_x - 0.015 * y_x;
        const double aside_y_56 = x_x * strand_28_z + x_z * strand_28_x;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double aside_x_56 = x_plane_y * strand_28_z - x_z * strand_28_y;
        const double aside_z_114 = x_plane_y * strand_28_x + x_x * strand_28_y;
        const double t125 = aside_x_56 * aside_x_56 + aside_y_56 * aside_y_56 + aside_z_114
            * aside_z_114;
        const double t126 = sinew_atan2(sinew_sqrt(t125), x_plane_y * strand_28_y - x_x
            * strand_28_x + x_z * strand_28_z);
        const double t127 = sinew_atan2(sinew_sqrt(strand_28_y * strand_28_y + strand_28_z
            * strand_28_z), -strand_28_x);
        const double strand_29_z = layer_1_z - t53;
        const double strand_29_x = layer_1_x - t54;
        const double aside_y_58 = x_x * strand_29_z + x_z * strand_29_x;
        const double strand_29_y = 0.016 + layer_1_y - t55;
        const double aside_x_58 = x_plane_y * strand_29_z - x_z * strand_29_y;
        const double aside_z_118 = x_plane_y * strand_29_x + x_x * strand_29_y;
        const double t128 = aside_x_58 * aside_x_58 + aside_y_58 * aside_y_58 + aside_z_118
            * aside_z_118;
        const double t129 = sinew_atan2(sinew_sqrt(t128), x_plane_y * strand_29_y - x_x
            * strand_29_x + x_z * strand_29_z);
        const double t130 = sinew_atan2(sinew_sqrt(strand_29_y * strand_29_y + strand_29_z
            * strand_29_z), -strand_29_x);
        const double strand_30_z = layer_1_z - 0.018 * y_z;
        const double strand_30_x = layer_1_x - 0.018 * y_x;
        const double aside_y_60 = x_x * strand_30_z + x_z * strand_30_x;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double aside_x_60 = x_plane_y * strand_30_z - x_z * strand_30_y;
        const double aside_z_122 = x_plane_y * strand_30_x + x_x * strand_30_y;
        const double t131 = aside_x_60 * aside_x_60 + aside_y_60 * aside_y_60 + aside_z_122
            * aside_z_122;
        const double t132 = sinew_atan2(sinew_sqrt(t131), x_plane_y * strand_30_y - x_x
            * strand_30_x + x_z * strand_30_z);
        const double t133 = sinew_atan2(sinew_sqrt(strand_30_y * strand_30_y + strand_30_z
            * strand_30_z), -strand_30_x);
        const double strand_31_z = layer_1_z - t62;
        const double strand_31_x = layer_1_x - t63;
        const double aside_y_62 = x_x * strand_31_z + x_z * strand_31_x;
        const double strand_31_y = 0.019 + layer_1_y - t64;
        const double aside_x_62 = x_plane_y * strand_31_z - x_z * strand_31_y;
        const double aside_z_126 = x_plane_y * strand_31_x + x_x * strand_31_y;
        const double t134 = aside_x_62 * aside_x_62 + aside_y_62 * aside_y_62 + aside_z_126
            * aside_z_126;
        const double t135 = sinew_atan2(sinew_sqrt(t134), x_plane_y * strand_31_y - x_x
            * strand_31_x + x_z * strand_31_z);
        const double t136 = sinew_atan2(sinew_sqrt(strand_31_y * strand_31_y + strand_31_z
            * strand_31_z), -strand_31_x);
        const double strand_32_z = layer_1_z - t68;
        const double strand_32_x = layer_1_x - t69;
        const double aside_y_64 = x_x * strand_32_z + x_z * strand_32_x;
        const double strand_32_y = 0.021 + layer_1_y - t70;
        const double aside_x_64 = x_plane_y * strand_32_z - x_z * strand_32_y;
        const double aside_z_130 = x_plane_y * strand_32_x + x_x * strand_32_y;
        const double t137 = aside_x_64 * aside_x_64 + aside_y_64 * aside_y_64 + aside_z_130
            * aside_z_130;
        const double t138 = sinew_atan2(sinew_sqrt(t137), x_plane_y * strand_32_y - x_x
            * strand_32_x + x_z * strand_32_z);
        const double t139 = sinew_atan2(sinew_sqrt(strand_32_y * strand_32_y + strand_32_z
            * strand_32_z), -strand_32_x);
        const double strand_33_z = layer_1_z - 0.023 * y_z;
        const double strand_33_x = layer_1_x - 0.023 * y_x;
        const double aside_y_66 = x_x * strand_33_z + x_z * strand_33_x;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double aside_x_66 = x_plane_y * strand_33_z - x_z * strand_33_y;
        const double aside_z_134 = x_plane_y * strand_33_x + x_x * strand_33_y;
        const double t140 = aside_x_66 * aside_x_66 + aside_y_66 * aside_y_66 + aside_z_134
            * aside_z_134;
        const double t141 = sinew_atan2(sinew_sqrt(t140), x_plane_y * strand_33_y - x_x
            * strand_33_x + x_z * strand_33_z);
        const double t142 = sinew_atan2(sinew_sqrt(strand_33_y * strand_33_y + strand_33_z
            * strand_33_z), -strand_33_x);
        const double strand_34_z = layer_1_z - t77;
        const double strand_34_x = layer_1_x - t78;
        const double aside_y_68 = x_x * strand_34_z + x_z * strand_34_x;
        const double strand_34_y = 0.024 + layer_1_y - t79;
        const double aside_x_68 = x_plane_y * strand_34_z - x_z * strand_34_y;
        const double aside_z_138 = x_plane_y * strand_34_x + x_x * strand_34_y;
        const double t143 = aside_x_68 * aside_x_68 + aside_y_68 * aside_y_68 + aside_z_138
            * aside_z_138;
        const double t144 = sinew_atan2(sinew_sqrt(t143), x_plane_y * strand_34_y - x_x
            * strand_34_x + x_z * strand_34_z);
        const double t145 = sinew_atan2(sinew_sqrt(strand_34_y * strand_34_y + strand_34_z
            * strand_34_z), -strand_34_x);
        const double strand_35_z = layer_1_z - 0.026 * y_z;
        const double strand_35_x = layer_1_x - 0.026 * y_x;
        const double aside_y_70 = x_x * strand_35_z + x_z * strand_35_x;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double aside_x_70 = x_plane_y * strand_35_z - x_z * strand_35_y;
        const double aside_z_142 = x_plane_y * strand_35_x + x_x * strand_35_y;
        const double t146 = aside_x_70 * aside_x_70 + aside_y_70 * aside_y_70 + aside_z_142
            * aside_z_142;
        const double t147 = sinew_atan2(sinew_sqrt(t146), x_plane_y * strand_35_y - x_x
            * strand_35_x + x_z * strand_35_z);
        const double t148 = sinew_atan2(sinew_sqrt(strand_35_y * strand_35_y + strand_35_z
            * strand_35_z), -strand_35_x);
        const double strand_36_z = layer_1_z - t86;
        const double strand_36_x = layer_1_x - t87;
        const double aside_y_72 = x_x * strand_36_z + x_z * strand_36_x;
        const double strand_36_y = 0.027 + layer_1_y - t88;
        const double aside_x_72 = x_plane_y * strand_36_z - x_z * strand_36_y;
        const double aside_z_146 = x_plane_y * strand_36_x + x_x * strand_36_y;
        const double t149 = aside_x_72 * aside_x_72 + aside_y_72 * aside_y_72 + aside_z_146
            * aside_z_146;
        const double t150 = sinew_atan2(sinew_sqrt(t149), x_plane_y * strand_36_y - x_x
            * strand_36_x + x_z * strand_36_z);
        const double t151 = sinew_atan2(sinew_sqrt(strand_36_y * strand_36_y + strand_36_z
            * strand_36_z), -strand_36_x);
        const double strand_37_z = layer_1_z - t92;
        const double strand_37_x = layer_1_x - t93;
        const double aside_y_74 = x_x * strand_37_z + x_z * strand_37_x;
        const double strand_37_y = 0.029 + layer_1_y - t94;
        const double aside_x_74 = x_plane_y * strand_37_z - x_z * strand_37_y;
        const double aside_z_150 = x_plane_y * strand_37_x + x_x * strand_37_y;
        const double t152 = aside_x_74 * aside_x_74 + aside_y_74 * aside_y_74 + aside_z_150
            * aside_z_150;
        const double t153 = sinew_atan2(sinew_sqrt(t152), x_plane_y * strand_37_y - x_x
            * strand_37_x + x_z * strand_37_z);
        const double t154 = sinew_atan2(sinew_sqrt(strand_37_y * strand_37_y + strand_37_z
            * strand_37_z), -strand_37_x);
        angles[state] = t12 + t13;
        angles[1 * n + state] = t15 + t16;
        angles[2 * n + state] = t21 + t22;
        angles[3 * n + state] = t27 + t28;
        angles[4 * n + state] = t30 + t31;
        angles[5 * n + state] = t36 + t37;
        angles[6 * n + state] = t39 + t40;
        angles[7 * n + state] = t42 + t43;
        angles[8 * n + state] = t48 + t49;
        angles[9 * n + state] = t51 + t52;
        angles[10 * n + state] = t57 + t58;
        angles[11 * n + state] = t60 + t61;
        angles[12 * n + state] = t66 + t67;
        angles[13 * n + state] = t72 + t73;
        angles[14 * n + state] = t75 + t76;
        angles[15 * n + state] = t81 + t82;
        angles[16 * n + state] = t84 + t85;
        angles[17 * n + state] = t90 + t91;
        angles[18 * n + state] = t96 + t97;
        angles[19 * n + state] = t99 + t100;
        angles[20 * n + state] = t102 + t103;
        angles[21 * n + state] = t105 + t106;
        angles[22 * n + state] = t108 + t109;
        angles[23 * n + state] = t111 + t112;
        angles[24 * n + state] = t114 + t115;
        angles[25 * n + state] = t117 + t118;
        angles[26 * n + state] = t120 + t121;
        angles[27 * n + state] = t123 + t124;
        angles[28 * n + state] = t126 + t127;
        angles[29 * n + state] = t129 + t130;
        angles[30 * n + state] = t132 + t133;
        angles[31 * n + state] = t135 + t136;
        angles[32 * n + state] = t138 + t139;
        angles[33 * n + state] = t141 + t142;
        angles[34 * n + state] = t144 + t145;
        angles[35 * n + state] = t147 + t148;
        angles[36 * n + state] = t150 + t151;
        angles[37 * n + state] = t153 + t154;
    }
}

void wrist_feedforward_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT delta_theta)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double M_e = 0.5 * (B_e + C_e);
        const double s_e = M_e - 0.036 * sin_q71;
        const double M_y = 0.5 * (B_y - C_y);
        const double s_y = 0.021 - M_y;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double p_y = u_e * s_y + u_y * s_e;
        const double p_z = 0.036 * cos_q71;
        const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double t1 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t1;
        const double z_plane_x = u_y * cos_A;
        const double sin_A = (p_y * root - p_z * limited) * t1;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double x_plane_x = u_y * sin_A;
        const double t2 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * (cos_q71 * x_plane_x
            + sin_q71 * cos_A);
        const double t3 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double layer_0_x = t2 - t3 + 0.011 * y_x;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double t4 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double t5 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double layer_0_z = 0.008 - origin_z - t4 - t5 + 0.011 * y_z;
        const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
        const double twice_across = across + across;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t6 = 0.004 * (u_e * sin_A);
        const double t7 = 0.01 * z_plane_y;
        const double t8 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t6 + t7 + t8;
        const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
        const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
        const double twice_across_2 = across_by_y + across_by_y;
        const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
        const double twice_across_4 = across_by_y_squared + across_by_y_squared;
        const double across_2 = twice_across - 0.001 * (twice_across_2 - 0.001 * twice_across_4);
        const double strand_y_1 = 0.001 + layer_0_y - 0.001 * u_y;
        const double length_1 = sinew_sqrt(across_2 + strand_y_1 * strand_y_1);
        const double t9 = 0.003 * twice_across_4;
        const double across_4 = twice_across - 0.003 * (twice_across_2 - t9);
        const double t10 = 0.003 * u_y;
        const double strand_y_2 = 0.003 + layer_0_y - t10;
        const double length_2 = sinew_sqrt(across_4 + strand_y_2 * strand_y_2);
        const double t11 = 0.005 * twice_across_4;
        const double across_6 = twice_across - 0.005 * (twice_across_2 - t11);
        const double t12 = 0.005 * u_y;
        const double strand_y_3 = 0.004 + layer_0_y - t12;
        const double length_3 = sinew_sqrt(across_6 + strand_y_3 * strand_y_3);
        const double across_8 = twice_across - 0.006 * (twice_across_2 - 0.006 * twice_across_4);
        const double strand_y_4 = 0.006 + layer_0_y - 0.006 * u_y;
        const double length_4 = sinew_sqrt(across_8 + strand_y_4 * strand_y_4);
        const double t13 = 0.008 * twice_across_4;
        const double across_10 = twice_across - 0.008 * (twice_across_2 - t13);
        const double t14 = 0.008 * u_y;
        const double strand_y_5 = 0.008 + layer_0_y - t14;
        const double length_5 = sinew_sqrt(across_10 + strand_y_5 * strand_y_5);
        const double across_12 = twice_across - 0.009 * (twice_across_2 - 0.009 * twice_across_4);
        const double strand_y_6 = 0.009 + layer_0_y - 0.009 * u_y;
        const double length_6 = sinew_sqrt(across_12 + strand_y_6 * strand_y_6);
        const double t15 = 0.011 * twice_across_4;
        const double across_14 = twice_across - 0.011 * (twice_across_2 - t15);
        const double strand_y_7 = 0.011 + layer_0_y - t8;
        const double length_7 = sinew_sqrt(across_14 + strand_y_7 * strand_y_7);
        const double t16 = 0.013 * twice_across_4;
        const double across_16 = twice_across - 0.013 * (twice_across_2 - t16);
        const double t17 = 0.013 * u_y;
        const double strand_y_8 = 0.012 + layer_0_y - t17;
        const double length_8 = sinew_sqrt(across_16 + strand_y_8 * strand_y_8);
        const double across_18 = twice_across - 0.014 * (twice_across_2 - 0.014 * twice_across_4);
        const double strand_y_9 = 0.014 + layer_0_y - 0.014 * u_y;
        const double length_9 = sinew_sqrt(across_18 + strand_y_9 * strand_y_9);
        const double t18 = 0.016 * twice_across_4;
        const double across_20 = twice_across - 0.016 * (twice_across_2 - t18);
        const double t19 = 0.016 * u_y;
        const double strand_y_10 = 0.016 + layer_0_y - t19;
        const double length_10 = sinew_sqrt(across_20 + strand_y_10 * strand_y_10);
        const double across_22 = twice_across - 0.017 * (twice_across_2 - 0.017 * twice_across_4);
        const double strand_y_11 = 0.017 + layer_0_y - 0.017 * u_y;
        const double length_11 = sinew_sqrt(across_22 + strand_y_11 * strand_y_11);
        const double t20 = 0.019 * twice_across_4;
        const double across_24 = twice_across - 0.019 * (twice_across_2 - t20);
        const double t21 = 0.019 * u_y;
        const double strand_y_12 = 0.019 + layer_0_y - t21;
        const double length_12 = sinew_sqrt(across_24 + strand_y_12 * strand_y_12);
        const double t22 = 0.021 * twice_across_4;
        const double across_26 = twice_across - 0.021 * (twice_across_2 - t22);
        const double t23 = 0.021 * u_y;
        const double strand_y_13 = 0.02 + layer_0_y - t23;
        const double length_13 = sinew_sqrt(across_26 + strand_y_13 * strand_y_13);
        const double across_28 = twice_across - 0.022 * (twice_across_2 - 0.022 * twice_across_4);
        const double strand_y_14 = 0.022 + layer_0_y - 0.022 * u_y;
        const double length_14 = sinew_sqrt(across_28 + strand_y_14 * strand_y_14);
        const double t24 = 0.024 * twice_across_4;
        const double across_30 = twice_across - 0.024 * (twice_across_2 - t24);
        const double t25 = 0.024 * u_y;
        const double strand_y_15 = 0.024 + layer_0_y - t25;
        const double length_15 = sinew_sqrt(across_30 + strand_y_15 * strand_y_15);
        const double across_32 = twice_across - 0.025 * (twice_across_2 - 0.025 * twice_across_4);
        const double strand_y_16 = 0.025 + layer_0_y - 0.025 * u_y;
        const double length_16 = sinew_sqrt(across_32 + strand_y_16 * strand_y_16);
        const double t26 = 0.027 * twice_across_4;
        const double across_34 = twice_across - 0.027 * (twice_across_2 - t26);
        const double t27 = 0.027 * u_y;
        const double strand_y_17 = 0.027 + layer_0_y - t27;
        const double length_17 = sinew_sqrt(across_34 + strand_y_17 * strand_y_17);
        const double t28 = 0.029 * twice_across_4;
        const double across_36 = twice_across - 0.029 * (twice_across_2 - t28);
        const double t29 = 0.029 * u_y;
        const double strand_y_18 = 0.028 + layer_0_y - t29;
        const double length_18 = sinew_sqrt(across_36 + strand_y_18 * strand_y_18);
        const double layer_1_x = t2 + t3 + 0.013 * y_x;
        const double layer_1_z = 0.028 - origin_z - t4 + t5 + 0.013 * y_z;
        const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
        const double twice_across_6 = across_38 + across_38;
        const double layer_1_y = 0.006 - origin_y - t6 - t7 + t17;
        const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
        const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
        const double twice_across_8 = across_by_y_2 + across_by_y_2;
        const double across_40 = twice_across_6 - 0.002 * (twice_across_8 - 0.002 * twice_across_4);
        const double strand_y_20 = 0.001 + layer_1_y - 0.002 * u_y;
        const double length_20 = sinew_sqrt(across_40 + strand_y_20 * strand_y_20);
        const double across_42 = twice_across_6 - 0.003 * (twice_across_8 - t9);
        const double strand_y_21 = 0.003 + layer_1_y - t10;
        const double length_21 = sinew_sqrt(across_42 + strand_y_21 * strand_y_21);
        const double across_44 = twice_across_6 - 0.005 * (twice_across_8 - t11);
        const double strand_y_22 = 0.005 + layer_1_y - t12;
        const double length_22 = sinew_sqrt(across_44 + strand_y_22 * strand_y_22);
        const double across_46 = twice_across_6 - 0.007 * (twice_across_8 - 0.007 * twice_across_4);
        const double strand_y_23 = 0.006 + layer_1_y - 0.007 * u_y;
        const double length_23 = sinew_sqrt(across_46 + strand_y_23 * strand_y_23);
        const double across_48 = twice_across_6 - 0.008 * (twice_across_8 - t13);
        const double strand_y_24 = 0.008 + layer_1_y - t14;
        const double length_24 = sinew_sqrt(across_48 + strand_y_24 * strand_y_24);
        const double across_50 = twice_across_6 - 0.01 * (twice_across_8 - 0.01 * twice_across_4);
        const double strand_y_25 = 0.009 + layer_1_y - 0.01 * u_y;
        const double length_25 = sinew_sqrt(across_50 + strand_y_25 * strand_y_25);
        const double across_52 = twice_across_6 - 0.011 * (twice_across_8 - t15);
        const double strand_y_26 = 0.011 + layer_1_y - t8;
        const double length_26 = sinew_sqrt(across_52 + strand_y_26 * strand_y_26);
        const double across_54 = twice_across_6 - 0.013 * (twice_across_8 - t16);
        const double strand_y_27 = 0.013 + layer_1_y - t17;
        const double length_27 = sinew_sqrt(across_54 + strand_y_27 * strand_y_27);
        const double across_56 = twice_across_6 - 0.015 * (twice_across_8 - 0.015 * twice_across_4);
        const double strand_y_28 = 0.014 + layer_1_y - 0.015 * u_y;
        const double length_28 = sinew_sqrt(across_56 + strand_y_28 * strand_y_28);
        const double across_58 = twice_across_6 - 0.016 * (twice_across_8 - t18);
        const double strand_y_29 = 0.016 + layer_1_y - t19;
        const double length_29 = sinew_sqrt(across_58 + strand_y_29 * strand_y_29);
        const double across_60 = twice_across_6 - 0.018 * (twice_across_8 - 0.018 * twice_across_4);
        const double strand_y_30 = 0.017 + layer_1_y - 0.018 * u_y;
        const double length_30 = sinew_sqrt(across_60 + strand_y_30 * strand_y_30);
        const double across_62 = twice_across_6 - 0.019 * (twice_across_8 - t20);
        const double strand_y_31 = 0.019 + layer_1_y - t21;
        const double length_31 = sinew_sqrt(across_62 + strand_y_31 * strand_y_31);
        const double across_64 = twice_across_6 - 0.021 * (twice_across_8 - t22);
        const double strand_y_32 = 0.021 + layer_1_y - t23;
        const double length_32 = sinew_sqrt(across_64 + strand_y_32 * strand_y_32);
        const double across_66 = twice_across_6 - 0.023 * (twice_across_8 - 0.023 * twice_across_4);
        const double strand_y_33 = 0.022 + layer_1_y - 0.023 * u_y;
        const double length_33 = sinew_sqrt(across_66 + strand_y_33 * strand_y_33);
        const double across_68 = twice_across_6 - 0.024 * (twice_across_8 - t24);
        const double strand_y_34 = 0.024 + layer_1_y - t25;
        const double length_34 = sinew_sqrt(across_68 + strand_y_34 * strand_y_34);
        const double across_70 = twice_across_6 - 0.026 * (twice_across_8 - 0.026 * twice_across_4);
        const double strand_y_35 = 0.025 + layer_1_y - 0.026 * u_y;
        const double length_35 = sinew_sqrt(across_70 + strand_y_35 * strand_y_35);
        const double across_72 = twice_across_6 - 0.027 * (twice_across_8 - t26);
        const double strand_y_36 = 0.027 + layer_1_y - t27;
        const double length_36 = sinew_sqrt(across_72 + strand_y_36 * strand_y_36);
        const double across_74 = twice_across_6 - 0.029 * (twice_across_8 - t28);
        const double strand_y_37 = 0.029 + layer_1_y - t29;
        const double length_37 = sinew_sqrt(across_74 + strand_y_37 * strand_y_37);
        delta_theta[state] = 200.0 * (0.04661544808322666 - length_0);
        delta_theta[1 * n + state] = 200.0 * (0.04661544808322666 - length_1);
        delta_theta[2 * n + state] = 200.0 * (0.04661544808322666 - length_2);
        delta_theta[3 * n + state] = 200.0 * (0.04669047011971501 - length_3);
        delta_theta[4 * n + state] = 200.0 * (0.04661544808322666 - length_4);
        delta_theta[5 * n + state] = 200.0 * (0.04661544808322666 - length_5);
        delta_theta[6 * n + state] = 200.0 * (0.04661544808322666 - length_6);
        delta_theta[7 * n + state] = 200.0 * (0.04661544808322666 - length_7);
        delta_theta[8 * n + state] = 200.0 * (0.04669047011971501 - length_8);
        delta_theta[9 * n + state] = 200.0 * (0.04661544808322666 - length_9);
        delta_theta[10 * n + state] = 200.0 * (0.04661544808322666 - length_10);
        delta_theta[11 * n + state] = 200.0 * (0.04661544808322666 - length_11);
        delta_theta[12 * n + state] = 200.0 * (0.04661544808322666 - length_12);
        delta_theta[13 * n + state] = 200.0 * (0.04669047011971501 - length_13);
        delta_theta[14 * n + state] = 200.0 * (0.04661544808322666 - length_14);
        delta_theta[15 * n + state] = 200.0 * (0.04661544808322666 - length_15);
        delta_theta[16 * n + state] = 200.0 * (0.04661544808322666 - length_16);
        delta_theta[17 * n + state] = 200.0 * (0.04661544808322666 - length_17);
        delta_theta[18 * n + state] = 200.0 * (0.04669047011971501 - length_18);
        delta_theta[19 * n + state] = 200.0 * (0.046561786907291264 - length_19);
        delta_theta[20 * n + state] = 200.0 * (0.04661544808322666 - length_20);
        delta_theta[21 * n + state] = 200.0 * (0.046561786907291264 - length_21);
        delta_theta[22 * n + state] = 200.0 * (0.046561786907291264 - length_22);
        delta_theta[23 * n + state] = 200.0 * (0.04661544808322666 - length_23);
        delta_theta[24 * n + state] = 200.0 * (0.046561786907291264 - length_24);
        delta_theta[25 * n + state] = 200.0 * (0.04661544808322666 - length_25);
        delta_theta[26 * n + state] = 200.0 * (0.046561786907291264 - length_26);
        delta_theta[27 * n + state] = 200.0 * (0.046561786907291264 - length_27);
        delta_theta[28 * n + state] = 200.0 * (0.04661544808322666 - length_28);
        delta_theta[29 * n + state] = 200.0 * (0.046561786907291264 - length_29);
        delta_theta[30 * n + state] = 200.0 * (0.04661544808322666 - length_30);
        delta_theta[31 * n + state] = 200.0 * (0.046561786907291264 - length_31);
        delta_theta[32 * n + state] = 200.0 * (0.046561786907291264 - length_32);
        delta_theta[33 * n + state] = 200.0 * (0.04661544808322666 - length_33);
        delta_theta[34 * n + state] = 200.0 * (0.046561786907291264 - length_34);
        delta_theta[35 * n + state] = 200.0 * (0.04661544808322666 - length_35);
        delta_theta[36 * n + state] = 200.0 * (0.046561786907291264 - length_36);
        delta_theta[37 * n + state] = 200.0 * (0.046561786907291264 - length_37);
    }
}

void wrist_feedforward_rate_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, const double *SINEW_RESTRICT dq71,
    const double *SINEW_RESTRICT dq73, double *SINEW_RESTRICT delta_theta_rate)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double t1 = 1.0 / (0.007324 - 0.084 * B_y);
        const double ratio = 0.003796 * t1;
        const double B_y_by_t = 0.074565407529229 * (dq73[state] * sin_q73);
        const double ratio_by_t = ratio * (0.084 * B_y_by_t) * t1;
        const double B_e = 0.074565407529229 * sin_q73;
        const double B_e_by_t = 0.074565407529229 * (dq73[state] * cos_q73);
        const double C_e_by_t = B_e * ratio_by_t - ratio * B_e_by_t;
        const double M_e_by_t = 0.5 * (B_e_by_t - C_e_by_t);
        const double sin_q71_by_t = dq71[state] * cos_q71;
        const double s_e_by_t = M_e_by_t - 0.036 * sin_q71_by_t;
        const double t2 = 21.0 - 500.0 * B_y;
        const double C_y = 0.002 * ratio * t2;
        const double u_y = 23.80952380952381 * (B_y + C_y);
        const double C_y_by_t = ratio * B_y_by_t - 0.002 * ratio_by_t * t2;
        const double M_y_by_t = 0.5 * (B_y_by_t + C_y_by_t);
        const double C_e = B_e * ratio;
        const double u_e = 23.80952380952381 * (B_e - C_e);
        const double u_y_by_t = 23.80952380952381 * (B_y_by_t - C_y_by_t);
        const double M_e = 0.5 * (B_e + C_e);
        const double s_e = M_e - 0.036 * sin_q71;
        const double u_e_by_t = 23.80952380952381 * (B_e_by_t + C_e_by_t);
        const double M_y = 0.5 * (B_y - C_y);
        const double s_y = 0.021 - M_y;
        const double p_y_by_t = u_e * M_y_by_t + u_y * s_e_by_t - s_e * u_y_by_t + s_y * u_e_by_t;
        const double p_y = u_e * s_y + u_y * s_e;
        const double cos_q71_by_t = dq71[state] * sin_q71;
        const double p_z_by_t = 0.036 * cos_q71_by_t;
        const double p_z = 0.036 * cos_q71;
        const double t3 = p_y * p_y_by_t - p_z * p_z_by_t;
        const double t4 = p_y * p_y;
        const double t5 = p_z * p_z;
        const double reach_squared_by_t = sinew_choose(-(1.296e-15 - t4 - t5), t3 + t3, 0.0);
        const double p_x_by_t = u_e * s_e_by_t - u_y * M_y_by_t + s_e * u_e_by_t + s_y * u_y_by_t;
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection_by_t = 13.88888888888889 * reach_squared_by_t + 27.77777777777778
            * p_x * p_x_by_t;
        const double reach_squared = sinew_max(t4 + t5, 1.296e-15);
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double t6 = reach - projection;
        const double reach_by_t = 0.5 * reach_squared_by_t / reach;
        const double t7 = reach_by_t * sinew_choose(t6, 0.0, 1.0) - projection_by_t
            * sinew_choose(t6, 1.0, 0.0);
        const double t8 = sinew_max(-projection, -reach);
        const double limited_by_t = sinew_choose(reach - t8, -t7, reach_by_t);
        const double limited = sinew_min(t8, reach);
        const double t9 = reach * reach_by_t - limited * limited_by_t;
        const double t10 = (reach + limited) * (reach - limited);
        const double t11 = 1e-12 * reach_squared;
        const double clearance_by_t = sinew_choose(-(t11 - t10), t9 + t9, 1e-12
            * reach_squared_by_t);
        const double root = sinew_sqrt(sinew_max(t10, t11));
        const double root_by_t = 0.5 * clearance_by_t / root;
        const double t12 = p_y * limited_by_t + p_z * root_by_t + limited * p_y_by_t - root
            * p_z_by_t;
        const double t13 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t13;
        const double cos_A_by_t = (t12 - cos_A * reach_squared_by_t) * t13;
        const double z_plane_x_by_t = u_y * cos_A_by_t - cos_A * u_y_by_t;
        const double t14 = p_y * root_by_t - p_z * limited_by_t + limited * p_z_by_t + root
            * p_y_by_t;
        const double sin_A = (p_y * root - p_z * limited) * t13;
        const double sin_A_by_t = (t14 - sin_A * reach_squared_by_t) * t13;
        const double z_plane_x = u_y * cos_A;
        const double z_x_by_t = cos_q71 * z_plane_x_by_t - sin_q71 * sin_A_by_t - sin_A
            * sin_q71_by_t - z_plane_x * cos_q71_by_t;
        const double origin_x_by_t = cos_q71 * M_e_by_t - M_e * cos_q71_by_t - 0.018 * z_x_by_t;
        const double x_plane_x_by_t = u_y * sin_A_by_t - sin_A * u_y_by_t;
        const double x_plane_x = u_y * sin_A;
        const double x_x_by_t = cos_q71 * x_plane_x_by_t + sin_q71 * cos_A_by_t + cos_A
            * sin_q71_by_t - x_plane_x * cos_q71_by_t;
        const double t15 = origin_x_by_t - 0.004 * x_x_by_t;
        const double t16 = 0.01 * z_x_by_t;
        const double y_x_by_t = cos_q71 * u_e_by_t - u_e * cos_q71_by_t;
        const double layer_0_x_by_t = t15 + t16 - 0.011 * y_x_by_t;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double t17 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * (cos_q71 * x_plane_x
            + sin_q71 * cos_A);
        const double t18 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double layer_0_x = t17 - t18 + 0.011 * y_x;
        const double z_z_by_t = cos_q71 * sin_A_by_t + sin_q71 * z_plane_x_by_t - sin_A
            * cos_q71_by_t + z_plane_x * sin_q71_by_t;
        const double origin_z_by_t = sin_q71 * M_e_by_t + M_e * sin_q71_by_t - 0.018 * z_z_by_t;
        const double x_z_by_t = cos_q71 * cos_A_by_t - sin_q71 * x_plane_x_by_t - cos_A
            * cos_q71_by_t - x_plane_x * sin_q71_by_t;
        const double t19 = origin_z_by_t + 0.004 * x_z_by_t;
        const double t20 = 0.01 * z_z_by_t;
        const double y_z_by_t = sin_q71 * u_e_by_t + u_e * sin_q71_by_t;
        const double layer_0_z_by_t = t19 + t20 - 0.011 * y_z_by_t;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double t21 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double t22 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double layer_0_z = 0.008 - origin_z - t21 - t22 + 0.011 * y_z;
        const double across_by_t = layer_0_x * layer_0_x_by_t + layer_0_z * layer_0_z_by_t;
        const double z_plane_y_by_t = u_e * cos_A_by_t + cos_A * u_e_by_t;
        const double t23 = M_y_by_t - 0.018 * z_plane_y_by_t - 0.004 * (u_e * sin_A_by_t + sin_A
            * u_e_by_t);
        const double t24 = 0.01 * z_plane_y_by_t;
        const double t25 = 0.011 * u_y_by_t;
        const double layer_0_y_by_t = t23 + t24 - t25;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t26 = 0.004 * (u_e * sin_A);
        const double t27 = 0.01 * z_plane_y;
        const double t28 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t26 + t27 + t28;
        const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
        const double twice_across = across + across;
        const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
        const double length_0_by_t = (across_by_t - layer_0_y * layer_0_y_by_t) / length_0;
        const double across_by_y_by_t = y_x * layer_0_x_by_t + y_z * layer_0_z_by_t - layer_0_x
            * y_x_by_t - layer_0_z * y_z_by_t;
        const double across_by_y_squared_by_t = y_x * y_x_by_t + y_z * y_z_by_t;
        const double across_slope_72 = across_by_y_by_t + 0.001 * across_by_y_squared_by_t;
        const double strand_y_1 = 0.001 + layer_0_y - 0.001 * u_y;
        const double half_square_by_2 = across_by_t - 0.001 * across_slope_72 - strand_y_1
            * (layer_0_y_by_t + 0.001 * u_y_by_t);
        const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
        const double twice_across_2 = across_by_y + across_by_y;
        const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
        const double twice_across_4 = across_by_y_squared + across_by_y_squared;
        const double across_2 = twice_across - 0.001 * (twice_across_2 - 0.001 * twice_across_4);
        const double length_1 = sinew_sqrt(across_2 + strand_y_1 * strand_y_1);
        const double t29 = 0.003 * across_by_y_squared_by_t;
        const double across_78 = across_by_t - 0.003 * (across_by_y_by_t + t29);
        const double t30 = 0.003 * u_y_by_t;
        const double t31 = 0.003 * u_y;
        const double strand_y_2 = 0.003 + layer_0_y - t31;
        const double half_square_by_4 = across_78 - strand_y_2 * (layer_0_y_by_t + t30);
        const double t32 = 0.003 * twice_across_4;
        const double across_4 = twice_across - 0.003 * (twice_across_2 - t32);
        const double length_2 = sinew_sqrt(across_4 + strand_y_2 * strand_y_2);
        const double t33 = 0.005 * across_by_y_squared_by_t;
        const double across_80 = across_by_t - 0.005 * (across_by_y_by_t + t33);
        const double t34 = 0.005 * u_y_by_t;
        const double t35 = 0.005 * u_y;
        const double strand_y_3 = 0.004 + layer_0_y - t35;
        const double half_square_by_6 = across_80 - strand_y_3 * (layer_0_y_by_t + t34);
        const double t36 = 0.005 * twice_across_4;
        const double across_6 = twice_across - 0.005 * (twice_across_2 - t36);
        const double length_3 = sinew_sqrt(across_6 + strand_y_3 * strand_y_3);
        const double across_slope_78 = across_by_y_by_t + 0.006 * across_by_y_squared_by_t;
        const double strand_y_4 = 0.006 + layer_0_y - 0.006 * u_y;
        const double half_square_by_8 = across_by_t - 0.006 * across_slope_78 - strand_y_4
            * (layer_0_y_by_t + 0.006 * u_y_by_t);
        const double across_8 = twice_across - 0.006 * (twice_across_2 - 0.006 * twice_across_4);
        const double length_4 = sinew_sqrt(across_8 + strand_y_4 * strand_y_4);
        const double t37 = 0.008 * across_by_y_squared_by_t;
        const double across_84 = across_by_t - 0.008 * (across_by_y_by_t + t37);
        const double t38 = 0.008 * u_y_by_t;
        const double t39 = 0.008 * u_y;
        const double strand_y_5 = 0.008 + layer_0_y - t39;
        const double half_square_by_10 = across_84 - strand_y_5 * (layer_0_y_by_t + t38);
        const double t40 = 0.008 * twice_across_4;
        const double across_10 = twice_across - 0.008 * (twice_across_2 - t40);
        const double length_5 = sinew_sqrt(across_10 + strand_y_5 * strand_y_5);
        const double across_slope_82 = across_by_y_by_t + 0.009 * across_by_y_squared_by_t;
        const double strand_y_6 = 0.009 + layer_0_y - 0.009 * u_y;
        const double half_square_by_12 = across_by_t - 0.009 * across_slope_82 - strand_y_6
            * (layer_0_y_by_t + 0.009 * u_y_by_t);
        const double across_12 = twice_across - 0.009 * (twice_across_2 - 0.009 * twice_across_4);
        const double length_6 = sinew_sqrt(across_12 + strand_y_6 * strand_y_6);
        const double t41 = 0.011 * across_by_y_squared_by_t;
        const double across_88 = across_by_t - 0.011 * (across_by_y_by_t + t41);
        const double strand_y_7 = 0.011 + layer_0_y - t28;
        const double half_square_by_14 = across_88 - strand_y_7 * (layer_0_y_by_t + t25);
        const double t42 = 0.011 * twice_across_4;
        const double across_14 = twice_across - 0.011 * (twice_across_2 - t42);
        const double length_7 = sinew_sqrt(across_14 + strand_y_7 * strand_y_7);
        const double t43 = 0.013 * across_by_y_squared_by_t;
        const double across_90 = across_by_t - 0.013 * (across_by_y_by_t + t43);
        const double t44 = 0.013 * u_y_by_t;
        const double t45 = 0.013 * u_y;
        const double strand_y_8 = 0.012 + layer_0_y - t45;
        const double half_square_by_16 = across_90 - strand_y_8 * (layer_0_y_by_t + t44);
        const double t46 = 0.013 * twice_across_4;
        const double across_16 = twice_across - 0.013 * (twice_across_2 - t46);
        const double length_8 = sinew_sqrt(across_16 + strand_y_8 * strand_y_8);
        const double across_slope_88 = across_by_y_by_t + 0.014 * across_by_y_squared_by_t;
        const double strand_y_9 = 0.014 + layer_0_y - 0.014 * u_y;
        const double half_square_by_18 = across_by_t - 0.014 * across_slope_88 - strand_y_9
            * (layer_0_y_by_t + 0.014 * u_y_by_t);
        const double across_18 = twice_across - 0.014 * (twice_across_2 - 0.014 * twice_across_4);
        const double length_9 = sinew_sqrt(across_18 + strand_y_9 * strand_y_9);
        const double t47 = 0.016 * across_by_y_squared_by_t;
        const double across_94 = across_by_t - 0.016 * (across_by_y_by_t + t47);
        const double t48 = 0.016 * u_y_by_t;
        const double t49 = 0.016 * u_y;
        const double strand_y_10 = 0.016 + layer_0_y - t49;
        const double half_square_by_20 = across_94 - strand_y_10 * (layer_0_y_by_t + t48);
        const double t50 = 0.016 * twice_across_4;
        const double across_20 = twice_across - 0.016 * (twice_across_2 - t50);
        const double length_10 = sinew_sqrt(across_20 + strand_y_10 * strand_y_10);
        const double across_slope_92 = across_by_y_by_t + 0.017 * across_by_y_squared_by_t;
        const double strand_y_11 = 0.017 + layer_0_y - 0.017 * u_y;
        const double half_square_by_22 = across_by_t - 0.017 * across_slope_92 - strand_y_11
            * (layer_0_y_by_t + 0.017 * u_y_by_t);
        const double across_22 = twice_across - 0.017 * (twice_across_2 - 0.017 * twice_across_4);
        const double length_11 = sinew_sqrt(across_22 + strand_y_11 * strand_y_11);
        const double t51 = 0.019 * across_by_y_squared_by_t;
        const double across_98 = across_by_t - 0.019 * (across_by_y_by_t + t51);
        const double t52 = 0.019 * u_y_by_t;
        const double t53 = 0.019 * u_y;
        const double strand_y_12 = 0.019 + layer_0_y - t53;
        const double half_square_by_24 = across_98 - strand_y_12 * (layer_0_y_by_t + t52);
        const double t54 = 0.019 * twice_across_4;
        const double across_24 = twice_across - 0.019 * (twice_across_2 - t54);
        const double length_12 = sinew_sqrt(across_24 + strand_y_12 * strand_y_12);
        const double t55 = 0.021 * across_by_y_squared_by_t;
        const double across_100 = across_by_t - 0.021 * (across_by_y_by_t + t55);
        const double t56 = 0.021 * u_y_by_t;
        const double t57 = 0.021 * u_y;
        const double strand_y_13 = 0.02 + layer_0_y - t57;
        const double half_square_by_26 = across_100 - strand_y_13 * (layer_0_y_by_t + t56);
        const double t58 = 0.021 * twice_across_4;
        const double across_26 = twice_across - 0.021 * (twice_across_2 - t58);
        const double length_13 = sinew_sqrt(across_26 + strand_y_13 * strand_y_13);
        const double across_slope_98 = across_by_y_by_t + 0.022 * across_by_y_squared_by_t;
        const double strand_y_14 = 0.022 + layer_0_y - 0.022 * u_y;
        const double half_square_by_28 = across_by_t - 0.022 * across_slope_98 - strand_y_14
            * (layer_0_y_by_t + 0.022 * u_y_by_t);
        const double across_28 = twice_across - 0.022 * (twice_across_2 - 0.022 * twice_across_4);
        const double length_14 = sinew_sqrt(across_28 + strand_y_14 * strand_y_14);
        const double t59 = 0.024 * across_by_y_squared_by_t;
        const double across_104 = across_by_t - 0.024 * (across_by_y_by_t + t59);
        const double t60 = 0.024 * u_y_by_t;
        const double t61 = 0.024 * u_y;
        const double strand_y_15 = 0.024 + layer_0_y - t61;
        const double half_square_by_30 = across_104 - strand_y_15 * (layer_0_y_by_t + t60);
        const double t62 = 0.024 * twice_across_4;
        const double across_30 = twice_across - 0.024 * (twice_across_2 - t62);
        const double length_15 = sinew_sqrt(across_30 + strand_y_15 * strand_y_15);
        const double across_slope_102 = across_by_y_by_t + 0.025 * across_by_y_squared_by_t;
        const double strand_y_16 = 0.025 + layer_0_y - 0.025 * u_y;
        const double half_square_by_32 = across_by_t - 0.025 * across_slope_102 - strand_y_16
            * (layer_0_y_by_t + 0.025 * u_y_by_t);
        const double across_32 = twice_across - 0.025 * (twice_across_2 - 0.025 * twice_across_4);
        const double length_16 = sinew_sqrt(across_32 + strand_y_16 * strand_y_16);
        const double t63 = 0.027 * across_by_y_squared_by_t;
        const double across_108 = across_by_t - 0.027 * (across_by_y_by_t + t63);
        const double t64 = 0.027 * u_y_by_t;
        const double t65 = 0.027 * u_y;
        const double strand_y_17 = 0.027 + layer_0_y - t65;
        const double half_square_by_34 = across_108 - strand_y_17 * (layer_0_y_by_t + t64);
        const double t66 = 0.027 * twice_across_4;
        const double across_34 = twice_across - 0.027 * (twice_across_2 - t66);
        const double length_17 = sinew_sqrt(across_34 + strand_y_17 * strand_y_17);
        const double t67 = 0.029 * across_by_y_squared_by_t;
        const double across_110 = across_by_t - 0.029 * (across_by_y_by_t + t67);
        const double t68 = 0.029 * u_y_by_t;
        const double t69 = 0.029 * u_y;
        const double strand_y_18 = 0.028 + layer_0_y - t69;
        const double half_square_by_36 = across_110 - strand_y_18 * (layer_0_y_by_t + t68);
        const double t70 = 0.029 * twice_across_4;
        const double across_36 = twice_across - 0.029 * (twice_across_2 - t70);
        const double length_18 = sinew_sqrt(across_36 + strand_y_18 * strand_y_18);
        const double layer_1_x_by_t = t15 - t16 - 0.013 * y_x_by_t;
        const double layer_1_x = t17 + t18 + 0.013 * y_x;
        const double layer_1_z_by_t = t19 - t20 - 0.013 * y_z_by_t;
        const double layer_1_z = 0.028 - origin_z - t21 + t22 + 0.013 * y_z;
        const double across_38_by_t = layer_1_x * layer_1_x_by_t + layer_1_z * layer_1_z_by_t;
        const double layer_1_y_by_t = t23 - t24 - t44;
        const double layer_1_y = 0.006 - origin_y - t26 - t27 + t45;
        const double half_square_by_38 = across_38_by_t - layer_1_y * layer_1_y_by_t;
        const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
        const double twice_across_6 = across_38 + across_38;
        const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
        const double across_by_y_2_by_t = y_x * layer_1_x_by_t + y_z * layer_1_z_by_t - layer_1_x
            * y_x_by_t - layer_1_z * y_z_by_t;
        const double across_slope_108 = across_by_y_2_by_t + 0.002 * across_by_y_squared_by_t;
        const double across_112 = across_38_by_t - 0.002 * across_slope_108;
        const double strand_y_20 = 0.001 + layer_1_y - 0.002 * u_y;
        const double half_square_by_40 = across_112 - strand_y_20 * (layer_1_y_by_t + 0.002
            * u_y_by_t);
        const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
        const double twice_across_8 = across_by_y_2 + across_by_y_2;
        const double across_40 = twice_across_6 - 0.002 * (twice_across_8 - 0.002 * twice_across_4);
        const double length_20 = sinew_sqrt(across_40 + strand_y_20 * strand_y_20);
        const double across_114 = across_38_by_t - 0.003 * (across_by_y_2_by_t + t29);
        const double strand_y_21 = 0.003 + layer_1_y - t31;
        const double half_square_by_42 = across_114 - strand_y_21 * (layer_1_y_by_t + t30);
        const double across_42 = twice_across_6 - 0.003 * (twice_across_8 - t32);
        const double length_21 = sinew_sqrt(across_42 + strand_y_21 * strand_y_21);
        const double across_116 = across_38_by_t - 0.005 * (across_by_y_2_by_t + t33);
        const double strand_y_22 = 0.005 + layer_1_y - t35;
        const double half_square_by_44 = across_116 - strand_y_22 * (layer_1_y_by_t + t34);
        const double across_44 = twice_across_6 - 0.005 * (twice_across_8 - t36);
        const double length_22 = sinew_sqrt(across_44 + strand_y_22 * strand_y_22);
        const double across_slope_114 = across_by_y_2_by_t + 0.007 * across_by_y_squared_by_t;
        const double across_118 = across_38_by_t - 0.007 * across_slope_114;
        const double strand_y_23 = 0.006 + layer_1_y - 0.007 * u_y;
        const double half_square_by_46 = across_118 - strand_y_23 * (layer_1_y_by_t + 0.007
            * u_y_by_t);
        const double across_46 = twice_across_6 - 0.007 * (twice_across_8 - 0.007 * twice_across_4);
        const double length_23 = sinew_sqrt(across_46 + strand_y_23 * strand_y_23);
        const double across_120 = across_38_by_t - 0.008 * (across_by_y_2_by_t + t37);
        const double strand_y_24 = 0.008 + layer_1_y - t39;
        const double half_square_by_48 = across_120 - strand_y_24 * (layer_1_y_by_t + t38);
        const double across_48 = twice_across_6 - 0.008 * (twice_across_8 - t40);
        const double length_24 = sinew_sqrt(across_48 + strand_y_24 * strand_y_24);
        const double across_slope_118 = across_by_y_2_by_t + 0.01 * across_by_y_squared_by_t;
        const double strand_y_25 = 0.009 + layer_1_y - 0.01 * u_y;
        const double half_square_by_50 = across_38_by_t - 0.01 * across_slope_118 - strand_y_25
            * (layer_1_y_by_t + 0.01 * u_y_by_t);
        const double across_50 = twice_across_6 - 0.01 * (twice_across_8 - 0.01 * twice_across_4);
        const double length_25 = sinew_sqrt(across_50 + strand_y_25 * strand_y_25);
        const double across_124 = across_38_by_t - 0.011 * (across_by_y_2_by_t + t41);
        const double strand_y_26 = 0.011 + layer_1_y - t28;
        const double half_square_by_52 = across_124 - strand_y_26 * (layer_1_y_by_t + t25);
        const double across_52 = twice_across_6 - 0.011 * (twice_across_8 - t42);
        const double length_26 = sinew_sqrt(across_52 + strand_y_26 * strand_y_26);
        const double across_126 = across_38_by_t - 0.013 * (across_by_y_2_by_t + t43);
        const double strand_y_27 = 0.013 + layer_1_y - t45;
        const double half_square_by_54 = across_126 - strand_y_27 * (layer_1_y_by_t + t44);
        const double across_54 = twice_across_6 - 0.013 * (twice_across_8 - t46);
        const double length_27 = sinew_sqrt(across_54 + strand_y_27 * strand_y_27);
        const double across_slope_124 = across_by_y_2_by_t + 0.015 * across_by_y_squared_by_t;
        const double across_128 = across_38_by_t - 0.015 * across_slope_124;
        const double strand_y_28 = 0.014 + layer_1_y - 0.015 * u_y;
        const double half_square_by_56 = across_128 - strand_y_28 * (layer_1_y_by_t + 0.015
            * u_y_by_t);
        const double across_56 = twice_across_6 - 0.015 * (twice_across_8 - 0.015 * twice_across_4);
        const double length_28 = sinew_sqrt(across_56 + strand_y_28 * strand_y_28);
        const double across_130 = across_38_by_t - 0.016 * (across_by_y_2_by_t + t47);
        const double strand_y_29 = 0.016 + layer_1_y - t49;
        const double half_square_by_58 = across_130 - strand_y_29 * (layer_1_y_by_t + t48);
        const double across_58 = twice_across_6 - 0.016 * (twice_across_8 - t50);
        const double length_29 = sinew_sqrt(across_58 + strand_y_29 * strand_y_29);
        const double across_slope_128 = across_by_y_2_by_t + 0.018 * across_by_y_squared_by_t;
        const double across_132 = across_38_by_t - 0.018 * across_slope_128;
        const double strand_y_30 = 0.017 + layer_1_y - 0.018 * u_y;
        const double half_square_by_60 = across_132 - strand_y_30 * (layer_1_y_by_t + 0.018
            * u_y_by_t);
        const double across_60 = twice_across_6 - 0.018 * (twice_across_8 - 0.018 * twice_across_4);
        const double length_30 = sinew_sqrt(across_60 + strand_y_30 * strand_y_30);
        const double across_134 = across_38_by_t - 0.019 * (across_by_y_2_by_t + t51);
        const double strand_y_31 = 0.019 + layer_1_y - t53;
        const double half_square_by_62 = across_134 - strand_y_31 * (layer_1_y_by_t + t52);
        const double across_62 = twice_across_6 - 0.019 * (twice_across_8 - t54);
        const double length_31 = sinew_sqrt(across_62 + strand_y_31 * strand_y_31);
        const double across_136 = across_38_by_t - 0.021 * (across_by_y_2_by_t + t55);
        const double strand_y_32 = 0.021 + layer_1_y - t57;
        const double half_square_by_64 = across_136 - strand_y_32 * (layer_1_y_by_t + t56);
        const double across_64 = twice_across_6 - 0.021 * (twice_across_8 - t58);
        const double length_32 = sinew_sqrt(across_64 + strand_y_32 * strand_y_32);
        const double across_slope_134 = across_by_y_2_by_t + 0.023 * across_by_y_squared_by_t;
        const double across_138 = across_38_by_t - 0.023 * across_slope_134;
        const double strand_y_33 = 0.022 + layer_1_y - 0.023 * u_y;
        const double half_square_by_66 = across_138 - strand_y_33 * (layer_1_y_by_t + 0.023
            * u_y_by_t);
        const double across_66 = twice_across_6 - 0.023 * (twice_across_8 - 0.023 * twice_across_4);
        const double length_33 = sinew_sqrt(across_66 + strand_y_33 * strand_y_33);
        const double across_140 = across_38_by_t - 0.024 * (across_by_y_2_by_t + t59);
        const double strand_y_34 = 0.024 + layer_1_y - t61;
        const double half_square_by_68 = across_140 - strand_y_34 * (layer_1_y_by_t + t60);
        const double across_68 = twice_across_6 - 0.024 * (twice_across_8 - t62);
        const double length_34 = sinew_sqrt(across_68 + strand_y_34 * strand_y_34);
        const double across_slope_138 = across_by_y_2_by_t + 0.026 * across_by_y_squared_by_t;
        const double across_142 = across_38_by_t - 0.026 * across_slope_138;
        const double strand_y_35 = 0.025 + layer_1_y - 0.026 * u_y;
        const double half_square_by_70 = across_142 - strand_y_35 * (layer_1_y_by_t + 0.026
            * u_y_by_t);
        const double across_70 = twice_across_6 - 0.026 * (twice_across_8 - 0.026 * twice_across_4);
        const double length_35 = sinew_sqrt(across_70 + strand_y_35 * strand_y_35);
        const double across_144 = across_38_by_t - 0.027 * (across_by_y_2_by_t + t63);
        const double strand_y_36 = 0.027 + layer_1_y - t65;
        const double half_square_by_72 = across_144 - strand_y_36 * (layer_1_y_by_t + t64);
        const double across_72 = twice_across_6 - 0.027 * (twice_across_8 - t66);
        const double length_36 = sinew_sqrt(across_72 + strand_y_36 * strand_y_36);
        const double across_146 = across_38_by_t - 0.029 * (across_by_y_2_by_t + t67);
        const double strand_y_37 = 0.029 + layer_1_y - t69;
        const double half_square_by_74 = across_146 - strand_y_37 * (layer_1_y_by_t + t68);
        const double across_74 = twice_across_6 - 0.029 * (twice_across_8 - t70);
        const double length_37 = sinew_sqrt(across_74 + strand_y_37 * strand_y_37);
        delta_theta_rate[state] = 200.0 * length_0_by_t;
        delta_theta_rate[1 * n + state] = 200.0 * (half_square_by_2 / length_1);
        delta_theta_rate[2 * n + state] = 200.0 * (half_square_by_4 / length_2);
        delta_theta_rate[3 * n + state] = 200.0 * (half_square_by_6 / length_3);
        delta_theta_rate[4 * n + state] = 200.0 * (half_square_by_8 / length_4);
        delta_theta_rate[5 * n + state] = 200.0 * (half_square_by_10 / length_5);
        delta_theta_rate[6 * n + state] = 200.0 * (half_square_by_12 / length_6);
        delta_theta_rate[7 * n + state] = 200.0 * (half_square_by_14 / length_7);
        delta_theta_rate[8 * n + state] = 200.0 * (half_square_by_16 / length_8);
        delta_theta_rate[9 * n + state] = 200.0 * (half_square_by_18 / length_9);
        delta_theta_rate[10 * n + state] = 200.0 * (half_square_by_20 / length_10);
        delta_theta_rate[11 * n + state] = 200.0 * (half_square_by_22 / length_11);
        delta_theta_rate[12 * n + state] = 200.0 * (half_square_by_24 / length_12);
        delta_theta_rate[13 * n + state] = 200.0 * (half_square_by_26 / length_13);
        delta_theta_rate[14 * n + state] = 200.0 * (half_square_by_28 / length_14);
        delta_theta_rate[15 * n + state] = 200.0 * (half_square_by_30 / length_15);
        delta_theta_rate[16 * n + state] = 200.0 * (half_square_by_32 / length_16);
        delta_theta_rate[17 * n + state] = 200.0 * (half_square_by_34 / length_17);
        delta_theta_rate[18 * n + state] = 200.0 * (half_square_by_36 / length_18);
        delta_theta_rate[19 * n + state] = 200.0 * (half_square_by_38 / length_19);
        delta_theta_rate[20 * n + state] = 200.0 * (half_square_by_40 / length_20);
        delta_theta_rate[21 * n + state] = 200.0 * (half_square_by_42 / length_21);
        delta_theta_rate[22 * n + state] = 200.0 * (half_square_by_44 / length_22);
        delta_theta_rate[23 * n + state] = 200.0 * (half_square_by_46 / length_23);
        delta_theta_rate[24 * n + state] = 200.0 * (half_square_by_48 / length_24);
        delta_theta_rate[25 * n + state] = 200.0 * (half_square_by_50 / length_25);
        delta_theta_rate[26 * n + state] = 200.0 * (half_square_by_52 / length_26);
        delta_theta_rate[27 * n + state] = 200.0 * (half_square_by_54 / length_27);
        delta_theta_rate[28 * n + state] = 200.0 * (half_square_by_56 / length_28);
        delta_theta_rate[29 * n + state] = 200.0 * (half_square_by_58 / length_29);
        delta_theta_rate[30 * n + state] = 200.0 * (half_square_by_60 / length_30);
        delta_theta_rate[31 * n + state] = 200.0 * (half_square_by_62 / length_31);
        delta_theta_rate[32 * n + state] = 200.0 * (half_square_by_64 / length_32);
        delta_theta_rate[33 * n + state] = 200.0 * (half_square_by_66 / length_33);
        delta_theta_rate[34 * n + state] = 200.0 * (half_square_by_68 / length_34);
        delta_theta_rate[35 * n + state] = 200.0 * (half_square_by_70 / length_35);
        delta_theta_rate[36 * n + state] = 200.0 * (half_square_by_72 / length_36);
        delta_theta_rate[37 * n + state] = 200.0 * (half_square_by_74 / length_37);
    }
}

void wrist_joint_torque_batch(int count, const double *SINEW_RESTRICT q71,
    const double *SINEW_RESTRICT q73, const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double t1 = 23.80952380952381 * B_y;
        const double t2 = 1.0 / (0.007324 - 0.084 * B_y);
        const double ratio = 0.003796 * t2;
        const double B_e = 0.074565407529229 * sin_q73;
        const double ratio_by_q73 = ratio * (0.084 * B_e) * t2;
        const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
        const double u_e_by_q73 = t1 + 23.80952380952381 * C_e_by_q73;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double p_z = 0.036 * cos_q71;
        const double t3 = p_z * p_z;
        const double t4 = 23.80952380952381 * B_e;
        const double C_e = B_e * ratio;
        const double u_e = t4 - 23.80952380952381 * C_e;
        const double t5 = 0.5 * B_y;
        const double t6 = 21.0 - 500.0 * B_y;
        const double C_y = 0.002 * ratio * t6;
        const double M_y = t5 - 0.5 * C_y;
        const double s_y = 0.021 - M_y;
        const double p_z_by_q71 = 0.036 * sin_q71;
        const double t7 = 0.5 * B_e;
        const double M_e = t7 + 0.5 * C_e;
        const double s_e = M_e - p_z_by_q71;
        const double u_y = t1 + 23.80952380952381 * C_y;
        const double p_y = u_e * s_y + u_y * s_e;
        const double t8 = p_y * p_y;
        const double reach_squared = sinew_max(t8 + t3, 1.296e-15);
        const double t9 = 1.0 / reach_squared;
        const double t10 = -(1.296e-15 - t8 - t3);
        const double t11 = p_y + p_y;
        const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t6;
        const double u_y_by_q73 = t4 - 23.80952380952381 * C_y_by_q73;
        const double M_y_by_q73 = t7 + 0.5 * C_y_by_q73;
        const double M_e_by_q73 = t5 - 0.5 * C_e_by_q73;
        const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
            * u_e_by_q73;
        const double reach_squared_by_q73 = sinew_choose(t10, t11 * p_y_by_q73, 0.0);
        const double reach = sinew_sqrt(reach_squared);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double t12 = sinew_max(-projection, -reach);
        const double limited = sinew_min(t12, reach);
        const double t13 = 1e-12 * reach_squared;
        const double t14 = (reach + limited) * (reach - limited);
        const double root = sinew_sqrt(sinew_max(t14, t13));
        const double sin_A = (p_y * root - p_z * limited) * t9;
        const double t15 = reach - t12;
        const double t16 = 1.0 / reach;
        const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t16;
        const double t17 = reach - projection;
        const double t18 = sinew_choose(t17, 0.0, 1.0);
        const double t19 = sinew_choose(t17, 1.0, 0.0);
        const double t20 = 27.77777777777778 * p_x;
        const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
            * u_y_by_q73;
        const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t20
            * p_x_by_q73;
        const double limited_by_q73 = sinew_choose(t15, -(reach_by_q73 * t18 - projection_by_q73
            * t19), reach_by_q73);
        const double t21 = 1.0 / root;
        const double t22 = -(t13 - t14);
        const double t23 = reach + reach;
        const double t24 = limited + limited;
        const double clearance_by_q73 = sinew_choose(t22, t23 * reach_by_q73 - t24 * limited_by_q73,
            1e-12 * reach_squared_by_q73);
        const double root_by_q73 = 0.5 * clearance_by_q73 * t21;
        const double t25 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t25 * t9;
        const double cos_A = (p_y * limited + p_z * root) * t9;
        const double t26 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t26 * t9;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double t27 = 0.01 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
        const double t28 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double y_x = cos_q71 * u_e;
        const double t29 = 0.029 * u_y;
        const double t30 = 0.011 * u_y;
        const double z_plane_y = u_e * cos_A;
        const double t31 = 0.01 * z_plane_y;
        const double t32 = 0.004 * (u_e * sin_A);
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double layer_0_y = 0.007 - origin_y - t32 + t31 + t30;
        const double strand_y_18 = 0.028 + layer_0_y - t29;
        const double y_z = sin_q71 * u_e;
        const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
        const double twice_across_4 = across_by_y_squared + across_by_y_squared;
        const double t33 = 0.029 * twice_across_4;
        const double t34 = 0.011 * y_x;
        const double t35 = sin_q71 * sin_A;
        const double z_plane_x = u_y * cos_A;
        const double t36 = cos_q71 * z_plane_x;
        const double z_x = t36 - t35;
        const double t37 = 0.01 * z_x;
        const double t38 = sin_q71 * cos_A;
        const double x_plane_x = u_y * sin_A;
        const double t39 = cos_q71 * x_plane_x;
        const double M_x = cos_q71 * M_e;
        const double t40 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t39 + t38);
        const double layer_0_x = t40 - t37 + t34;
        const double t41 = 0.011 * y_z;
        const double t42 = cos_q71 * sin_A;
        const double t43 = sin_q71 * z_plane_x;
        const double z_z = t42 + t43;
        const double t44 = 0.01 * z_z;
        const double t45 = cos_q71 * cos_A;
        const double t46 = sin_q71 * x_plane_x;
        const double t47 = 0.004 * (t45 - t46);
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double layer_0_z = 0.008 - origin_z - t47 - t44 + t41;
        const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
        const double twice_across_2 = across_by_y + across_by_y;
        const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
        const double twice_across = across + across;
        const double across_36 = twice_across - 0.029 * (twice_across_2 - t33);
        const double length_18 = sinew_sqrt(across_36 + strand_y_18 * strand_y_18);
        const double per_length_18 = f[18 * n + state] / length_18;
        const double pull_by_y_18 = 0.029 * per_length_18;
        const double t48 = 0.027 * u_y;
        const double strand_y_17 = 0.027 + layer_0_y - t48;
        const double t49 = 0.027 * twice_across_4;
        const double across_34 = twice_across - 0.027 * (twice_across_2 - t49);
        const double length_17 = sinew_sqrt(across_34 + strand_y_17 * strand_y_17);
        const double per_length_17 = f[17 * n + state] / length_17;
        const double pull_by_y_17 = 0.027 * per_length_17;
        const double strand_y_16 = 0.025 + layer_0_y - 0.025 * u_y;
        const double across_32 = twice_across - 0.025 * (twice_across_2 - 0.025 * twice_across_4);
        const double length_16 = sinew_sqrt(across_32 + strand_y_16 * strand_y_16);
        const double per_length_16 = f[16 * n + state] / length_16;
        const double pull_by_y_16 = 0.025 * per_length_16;
        const double t50 = 0.024 * u_y;
        const double strand_y_15 = 0.024 + layer_0_y - t50;
        const double t51 = 0.024 * twice_across_4;
        const double across_30 = twice_across - 0.024 * (twice_across_2 - t51);
        const double length_15 = sinew_sqrt(across_30 + strand_y_15 * strand_y_15);
        const double per_length_15 = f[15 * n + state] / length_15;
        const double pull_by_y_15 = 0.024 * per_length_15;
        const double strand_y_14 = 0.022 + layer_0_y - 0.022 * u_y;
        const double across_28 = twice_across - 0.022 * (twice_across_2 - 0.022 * twice_across_4);
        const double length_14 = sinew_sqrt(across_28 + strand_y_14 * strand_y_14);
        const double per_length_14 = f[14 * n + state] / length_14;
        const double pull_by_y_14 = 0.022 * per_length_14;
        const double t52 = 0.021 * u_y;
        const double strand_y_13 = 0.02 + layer_0_y - t52;
        const double t53 = 0.021 * twice_across_4;
        const double across_26 = twice_across - 0.021 * (twice_across_2 - t53);
        const double length_13 = sinew_sqrt(across_26 + strand_y_13 * strand_y_13);
        const double per_length_13 = f[13 * n + state] / length_13;
        const double pull_by_y_13 = 0.021 * per_length_13;
        const double t54 = 0.019 * u_y;
        const double strand_y_12 = 0.019 + layer_0_y - t54;
        const double t55 = 0.019 * twice_across_4;
        const double across_24 = twice_across - 0.019 * (twice_across_2 - t55);
        const double length_12 = sinew_sqrt(across_24 + strand_y_12 * strand_y_12);
        const double per_length_12 = f[12 * n + state] / length_12;
        const double pull_by_y_12 = 0.019 * per_length_12;
        const double strand_y_11 = 0.017 + layer_0_y - 0.017 * u_y;
        const double across_22 = twice_across - 0.017 * (twice_across_2 - 0.017 * twice_across_4);
        const double length_11 = sinew_sqrt(across_22 + strand_y_11 * strand_y_11);
        const double per_length_11 = f[11 * n + state] / length_11;
        const double pull_by_y_11 = 0.017 * per_length_11;
        const double t56 = 0.016 * u_y;
        const double strand_y_10 = 0.016 + layer_0_y - t56;
        const double t57 = 0.016 * twice_across_4;
        const double across_20 = twice_across - 0.016 * (twice_across_2 - t57);
        const double length_10 = sinew_sqrt(across_20 + strand_y_10 * strand_y_10);
        const double per_length_10 = f[10 * n + state] / length_10;
        const double pull_by_y_10 = 0.016 * per_length_10;
        const double strand_y_9 = 0.014 + layer_0_y - 0.014 * u_y;
        const double across_18 = twice_across - 0.014 * (twice_across_2 - 0.014 * twice_across_4);
        const double length_9 = sinew_sqrt(across_18 + strand_y_9 * strand_y_9);
        const double per_length_9 = f[9 * n + state] / length_9;
        const double pull_by_y_9 = 0.014 * per_length_9;
        const double t58 = 0.013 * u_y;
        const double strand_y_8 = 0.012 + layer_0_y - t58;
        const double t59 = 0.013 * twice_across_4;
        const double across_16 = twice_across - 0.013 * (twice_across_2 - t59);
        const double length_8 = sinew_sqrt(across_16 + strand_y_8 * strand_y_8);
        const double per_length_8 = f[8 * n + state] / length_8;
        const double pull_by_y_8 = 0.013 * per_length_8;
        const double strand_y_7 = 0.011 + layer_0_y - t30;
        const double t60 = 0.011 * twice_across_4;
        const double across_14 = twice_across - 0.011 * (twice_across_2 - t60);
        const double length_7 = sinew_sqrt(across_14 + strand_y_7 * strand_y_7);
        const double per_length_7 = f[7 * n + state] / length_7;
        const double pull_by_y_7 = 0.011 * per_length_7;
        const double strand_y_6 = 0.009 + layer_0_y - 0.009 * u_y;
        const double across_12 = twice_across - 0.009 * (twice_across_2 - 0.009 * twice_across_4);
        const double length_6 = sinew_sqrt(across_12 + strand_y_6 * strand_y_6);
        const double per_length_6 = f[6 * n + state] / length_6;
        const double pull_by_y_6 = 0.009 * per_length_6;
        const double t61 = 0.008 * u_y;
        const double strand_y_5 = 0.008 + layer_0_y - t61;
        const double t62 = 0.008 * twice_across_4;
        const double across_10 = twice_across - 0.008 * (twice_across_2 - t62);
        const double length_5 = sinew_sqrt(across_10 + strand_y_5 * strand_y_5);
        const double per_length_5 = f[5 * n + state] / length_5;
        const double pull_by_y_5 = 0.008 * per_length_5;
        const double strand_y_4 = 0.006 + layer_0_y - 0.006 * u_y;
        const double across_8 = twice_across - 0.006 * (twice_across_2 - 0.006 * twice_across_4);
        const double length_4 = sinew_sqrt(across_8 + strand_y_4 * strand_y_4);
        const double per_length_4 = f[4 * n + state] / length_4;
        const double pull_by_y_4 = 0.006 * per_length_4;
        const double t63 = 0.005 * u_y;
        const double strand_y_3 = 0.004 + layer_0_y - t63;
        const double t64 = 0.005 * twice_across_4;
        const double across_6 = twice_across - 0.005 * (twice_across_2 - t64);
        const double length_3 = sinew_sqrt(across_6 + strand_y_3 * strand_y_3);
        const double per_length_3 = f[3 * n + state] / length_3;
        const double pull_by_y_3 = 0.005 * per_length_3;
        const double strand_y_1 = 0.001 + layer_0_y - 0.001 * u_y;
        const double across_2 = twice_across - 0.001 * (twice_across_2 - 0.001 * twice_across_4);
        const double length_1 = sinew_sqrt(across_2 + strand_y_1 * strand_y_1);
        const double per_length_1 = f[1 * n + state] / length_1;
        const double pull_by_y_1 = 0.001 * per_length_1;
        const double t65 = 0.003 * u_y;
        const double strand_y_2 = 0.003 + layer_0_y - t65;
        const double t66 = 0.003 * twice_across_4;
        const double across_4 = twice_across - 0.003 * (twice_across_2 - t66);
        const double length_2 = sinew_sqrt(across_4 + strand_y_2 * strand_y_2);
        const double per_length_2 = f[2 * n + state] / length_2;
        const double pull_by_y_2 = 0.003 * per_length_2;
        const double t67 = pull_by_y_1 + pull_by_y_2 + pull_by_y_3 + pull_by_y_4 + pull_by_y_5
            + pull_by_y_6;
        const double t68 = t67 + pull_by_y_7 + pull_by_y_8 + pull_by_y_9 + pull_by_y_10
            + pull_by_y_11;
        const double t69 = t68 + pull_by_y_12 + pull_by_y_13 + pull_by_y_14 + pull_by_y_15
            + pull_by_y_16;
        const double pull_19 = t69 + pull_by_y_17 + pull_by_y_18;
        const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
        const double per_length_0 = f[state] / length_0;
        const double t70 = per_length_0 + per_length_1 + per_length_2 + per_length_3 + per_length_4
            + per_length_5;
        const double t71 = t70 + per_length_6 + per_length_7 + per_length_8 + per_length_9
            + per_length_10;
        const double t72 = t71 + per_length_11 + per_length_12 + per_length_13 + per_length_14
            + per_length_15;
        const double pull = t72 + per_length_16 + per_length_17 + per_length_18;
        const double pull_x = y_x * pull_19 - layer_0_x * pull;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t73 = 0.01 * z_plane_y_by_q73;
        const double t74 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t75 = layer_0_y * per_length_0 + strand_y_1 * per_length_1 + strand_y_2
            * per_length_2;
        const double t76 = t75 + strand_y_3 * per_length_3 + strand_y_4 * per_length_4 + strand_y_5
            * per_length_5;
        const double t77 = t76 + strand_y_6 * per_length_6 + strand_y_7 * per_length_7 + strand_y_8
            * per_length_8;
        const double t78 = t77 + strand_y_9 * per_length_9 + strand_y_10 * per_length_10
            + strand_y_11 * per_length_11;
        const double t79 = t78 + strand_y_12 * per_length_12 + strand_y_13 * per_length_13
            + strand_y_14 * per_length_14;
        const double t80 = t79 + strand_y_15 * per_length_15 + strand_y_16 * per_length_16
            + strand_y_17 * per_length_17;
        const double pull_y = t80 + strand_y_18 * per_length_18;
        const double t81 = pull_x * (t28 + t27 - 0.011 * y_x_by_q73) + pull_y * (t74 + t73 - 0.011
            * u_y_by_q73);
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double t82 = 0.01 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double t83 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double pull_z = y_z * pull_19 - layer_0_z * pull;
        const double layer_1_y = 0.006 - origin_y - t32 - t31 + t58;
        const double strand_y_37 = 0.029 + layer_1_y - t29;
        const double t84 = 0.013 * y_x;
        const double layer_1_x = t40 + t37 + t84;
        const double t85 = 0.013 * y_z;
        const double layer_1_z = 0.028 - origin_z - t47 + t44 + t85;
        const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
        const double twice_across_8 = across_by_y_2 + across_by_y_2;
        const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
        const double twice_across_6 = across_38 + across_38;
        const double across_74 = twice_across_6 - 0.029 * (twice_across_8 - t33);
        const double length_37 = sinew_sqrt(across_74 + strand_y_37 * strand_y_37);
        const double per_length_37 = f[37 * n + state] / length_37;
        const double pull_by_y_37 = 0.029 * per_length_37;
        const double strand_y_36 = 0.027 + layer_1_y - t48;
        const double across_72 = twice_across_6 - 0.027 * (twice_across_8 - t49);
        const double length_36 = sinew_sqrt(across_72 + strand_y_36 * strand_y_36);
        const double per_length_36 = f[36 * n + state] / length_36;
        const double pull_by_y_36 = 0.027 * per_length_36;
        const double strand_y_35 = 0.025 + layer_1_y - 0.026 * u_y;
        const double across_70 = twice_across_6 - 0.026 * (twice_across_8 - 0.026 * twice_across_4);
        const double length_35 = sinew_sqrt(across_70 + strand_y_35 * strand_y_35);
        const double per_length_35 = f[35 * n + state] / length_35;
        const double pull_by_y_35 = 0.026 * per_length_35;
        const double strand_y_34 = 0.024 + layer_1_y - t50;
        const double across_68 = twice_across_6 - 0.024 * (twice_across_8 - t51);
        const double length_34 = sinew_sqrt(across_68 + strand_y_34 * strand_y_34);
        const double per_length_34 = f[34 * n + state] / length_34;
        const double pull_by_y_34 = 0.024 * per_length_34;
        const double strand_y_33 = 0.022 + layer_1_y - 0.023 * u_y;
        const double across_66 = twice_across_6 - 0.023 * (twice_across_8 - 0.023 * twice_across_4);
        const double length_33 = sinew_sqrt(across_66 + strand_y_33 * strand_y_33);
        const double per_length_33 = f[33 * n + state] / length_33;
        const double pull_by_y_33 = 0.023 * per_length_33;
        const double strand_y_32 = 0.021 + layer_1_y - t52;
        const double across_64 = twice_across_6 - 0.021 * (twice_across_8 - t53);
        const double length_32 = sinew_sqrt(across_64 + strand_y_32 * strand_y_32);
        const double per_length_32 = f[32 * n + state] / length_32;
        const double pull_by_y_32 = 0.021 * per_length_32;
        const double strand_y_31 = 0.019 + layer_1_y - t54;
        const double across_62 = twice_across_6 - 0.019 * (twice_across_8 - t55);
        const double length_31 = sinew_sqrt(across_62 + strand_y_31 * strand_y_31);
        const double per_length_31 = f[31 * n + state] / length_31;
        const double pull_by_y_31 = 0.019 * per_length_31;
        const double strand_y_30 = 0.017 + layer_1_y - 0.018 * u_y;
        const double across_60 = twice_across_6 - 0.018 * (twice_across_8 - 0.018 * twice_across_4);
        const double length_30 = sinew_sqrt(across_60 + strand_y_30 * strand_y_30);
        const double per_length_30 = f[30 * n + state] / length_30;
        const double pull_by_y_30 = 0.018 * per_length_30;
        const double strand_y_29 = 0.016 + layer_1_y - t56;
        const double across_58 = twice_across_6 - 0.016 * (twice_across_8 - t57);
        const double length_29 = sinew_sqrt(across_58 + strand_y_29 * strand_y_29);
        const double per_length_29 = f[29 * n + state] / length_29;
        const double pull_by_y_29 = 0.016 * per_length_29;
        const double strand_y_28 = 0.014 + layer_1_y - 0.015 * u_y;
        const double across_56 = twice_across_6 - 0.015 * (twice_across_8 - 0.015 * twice_across_4);
        const double length_28 = sinew_sqrt(across_56 + strand_y_28 * strand_y_28);
        const double per_length_28 = f[28 * n + state] / length_28;
        const double pull_by_y_28 = 0.015 * per_length_28;
        const double strand_y_27 = 0.013 + layer_1_y - t58;
        const double across_54 = twice_across_6 - 0.013 * (twice_across_8 - t59);
        const double length_27 = sinew_sqrt(across_54 + strand_y_27 * strand_y_27);
        const double per_length_27 = f[27 * n + state] / length_27;
        const double pull_by_y_27 = 0.013 * per_length_27;
        const double strand_y_26 = 0.011 + layer_1_y - t30;
        const double across_52 = twice_across_6 - 0.011 * (twice_across_8 - t60);
        const double length_26 = sinew_sqrt(across_52 + strand_y_26 * strand_y_26);
        const double per_length_26 = f[26 * n + state] / length_26;
        const double pull_by_y_26 = 0.011 * per_length_26;
        const double strand_y_25 = 0.009 + layer_1_y - 0.01 * u_y;
        const double across_50 = twice_across_6 - 0.01 * (twice_across_8 - 0.01 * twice_across_4);
        const double length_25 = sinew_sqrt(across_50 + strand_y_25 * strand_y_25);
        const double per_length_25 = f[25 * n + state] / length_25;
        const double pull_by_y_25 = 0.01 * per_length_25;
        const double strand_y_24 = 0.008 + layer_1_y - t61;
        const double across_48 = twice_across_6 - 0.008 * (twice_across_8 - t62);
        const double length_24 = sinew_sqrt(across_48 + strand_y_24 * strand_y_24);
        const double per_length_24 = f[24 * n + state] / length_24;
        const double pull_by_y_24 = 0.008 * per_length_24;
        const double strand_y_23 = 0.006 + layer_1_y - 0.007 * u_y;
        const double across_46 = twice_across_6 - 0.007 * (twice_across_8 - 0.007 * twice_across_4);
        const double length_23 = sinew_sqrt(across_46 + strand_y_23 * strand_y_23);
        const double per_length_23 = f[23 * n + state] / length_23;
        const double pull_by_y_23 = 0.007 * per_length_23;
        const double strand_y_22 = 0.005 + layer_1_y - t63;
        const double across_44 = twice_across_6 - 0.005 * (twice_across_8 - t64);
        const double length_22 = sinew_sqrt(across_44 + strand_y_22 * strand_y_22);
        const double per_length_22 = f[22 * n + state] / length_22;
        const double pull_by_y_22 = 0.005 * per_length_22;
        const double strand_y_20 = 0.001 + layer_1_y - 0.002 * u_y;
        const double across_40 = twice_across_6 - 0.002 * (twice_across_8 - 0.002 * twice_across_4);
        const double length_20 = sinew_sqrt(across_40 + strand_y_20 * strand_y_20);
        const double per_length_20 = f[20 * n + state] / length_20;
        const double pull_by_y_20 = 0.002 * per_length_20;
        const double strand_y_21 = 0.003 + layer_1_y - t65;
        const double across_42 = twice_across_6 - 0.003 * (twice_across_8 - t66);
        const double length_21 = sinew_sqrt(across_42 + strand_y_21 * strand_y_21);
        const double per_length_21 = f[21 * n + state] / length_21;
        const double pull_by_y_21 = 0.003 * per_length_21;
        const double t86 = pull_by_y_20 + pull_by_y_21 + pull_by_y_22 + pull_by_y_23 + pull_by_y_24
            + pull_by_y_25;
        const double t87 = t86 + pull_by_y_26 + pull_by_y_27 + pull_by_y_28 + pull_by_y_29
            + pull_by_y_30;
        const double t88 = t87 + pull_by_y_31 + pull_by_y_32 + pull_by_y_33 + pull_by_y_34
            + pull_by_y_35;
        const double pull_40 = t88 + pull_by_y_36 + pull_by_y_37;
        const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
        const double per_length_19 = f[19 * n + state] / length_19;
        const double t89 = per_length_19 + per_length_20 + per_length_21 + per_length_22
            + per_length_23;
        const double t90 = t89 + per_length_24 + per_length_25 + per_length_26 + per_length_27
            + per_length_28;
        const double t91 = t90 + per_length_29 + per_length_30 + per_length_31 + per_length_32
            + per_length_33;
        const double pull_38 = t91 + per_length_34 + per_length_35 + per_length_36 + per_length_37;
        const double pull_x_2 = y_x * pull_40 - layer_1_x * pull_38;
        const double t92 = t81 + pull_z * (t83 + t82 - 0.011 * y_z_by_q73) + pull_x_2 * (t28 - t27
            - 0.013 * y_x_by_q73);
        const double t93 = layer_1_y * per_length_19 + strand_y_20 * per_length_20 + strand_y_21
            * per_length_21;
        const double t94 = t93 + strand_y_22 * per_length_22 + strand_y_23 * per_length_23
            + strand_y_24 * per_length_24;
        const double t95 = t94 + strand_y_25 * per_length_25 + strand_y_26 * per_length_26
            + strand_y_27 * per_length_27;
        const double t96 = t95 + strand_y_28 * per_length_28 + strand_y_29 * per_length_29
            + strand_y_30 * per_length_30;
        const double t97 = t96 + strand_y_31 * per_length_31 + strand_y_32 * per_length_32
            + strand_y_33 * per_length_33;
        const double t98 = t97 + strand_y_34 * per_length_34 + strand_y_35 * per_length_35
            + strand_y_36 * per_length_36;
        const double pull_y_2 = t98 + strand_y_37 * per_length_37;
        const double pull_z_2 = y_z * pull_40 - layer_1_z * pull_38;
        const double t99 = t92 + pull_y_2 * (t74 - t73 - 0.013 * u_y_by_q73) + pull_z_2 * (t83 - t82
            - 0.013 * y_z_by_q73);
        const double t100 = 0.001 * pull_by_y_1 + 0.003 * pull_by_y_2 + 0.005 * pull_by_y_3 + 0.006
            * pull_by_y_4;
        const double t101 = t100 + 0.008 * pull_by_y_5 + 0.009 * pull_by_y_6 + 0.011 * pull_by_y_7
            + 0.013 * pull_by_y_8;
        const double t102 = t101 + 0.014 * pull_by_y_9 + 0.016 * pull_by_y_10 + 0.017 * pull_by_y_11
            + 0.019 * pull_by_y_12;
        const double t103 = t102 + 0.021 * pull_by_y_13 + 0.022 * pull_by_y_14 + 0.024
            * pull_by_y_15;
        const double pull_21 = t103 + 0.025 * pull_by_y_16 + 0.027 * pull_by_y_17 + 0.029
            * pull_by_y_18;
        const double t104 = 0.002 * pull_by_y_20 + 0.003 * pull_by_y_21 + 0.005 * pull_by_y_22
            + 0.007 * pull_by_y_23;
        const double t105 = t104 + 0.008 * pull_by_y_24 + 0.01 * pull_by_y_25 + 0.011 * pull_by_y_26
            + 0.013 * pull_by_y_27;
        const double t106 = t105 + 0.015 * pull_by_y_28 + 0.016 * pull_by_y_29 + 0.018
            * pull_by_y_30;
        const double t107 = t106 + 0.019 * pull_by_y_31 + 0.021 * pull_by_y_32 + 0.023
            * pull_by_y_33;
        const double t108 = t107 + 0.024 * pull_by_y_34 + 0.026 * pull_by_y_35 + 0.027
            * pull_by_y_36;
        const double t109 = pull_21 + (t108 + 0.029 * pull_by_y_37);
        const double pull_axis_x_4 = y_x * t109 - layer_0_x * pull_19 - layer_1_x * pull_40;
        const double t110 = strand_y_1 * pull_by_y_1 + strand_y_2 * pull_by_y_2 + strand_y_3
            * pull_by_y_3;
        const double t111 = t110 + strand_y_4 * pull_by_y_4 + strand_y_5 * pull_by_y_5 + strand_y_6
            * pull_by_y_6;
        const double t112 = t111 + strand_y_7 * pull_by_y_7 + strand_y_8 * pull_by_y_8 + strand_y_9
            * pull_by_y_9;
        const double t113 = t112 + strand_y_10 * pull_by_y_10 + strand_y_11 * pull_by_y_11
            + strand_y_12 * pull_by_y_12;
        const double t114 = t113 + strand_y_13 * pull_by_y_13 + strand_y_14 * pull_by_y_14
            + strand_y_15 * pull_by_y_15;
        const double pull_axis_y = t114 + strand_y_16 * pull_by_y_16 + strand_y_17 * pull_by_y_17
            + strand_y_18 * pull_by_y_18;
        const double t115 = strand_y_20 * pull_by_y_20 + strand_y_21 * pull_by_y_21 + strand_y_22
            * pull_by_y_22;
        const double t116 = t115 + strand_y_23 * pull_by_y_23 + strand_y_24 * pull_by_y_24
            + strand_y_25 * pull_by_y_25;
        const double t117 = t116 + strand_y_26 * pull_by_y_26 + strand_y_27 * pull_by_y_27
            + strand_y_28 * pull_by_y_28;
        const double t118 = t117 + strand_y_29 * pull_by_y_29 + strand_y_30 * pull_by_y_30
            + strand_y_31 * pull_by_y_31;
        const double t119 = t118 + strand_y_32 * pull_by_y_32 + strand_y_33 * pull_by_y_33
            + strand_y_34 * pull_by_y_34;
        const double pull_axis_y_2 = t119 + strand_y_35 * pull_by_y_35 + strand_y_36 * pull_by_y_36
            + strand_y_37 * pull_by_y_37;
        const double t120 = t99 + pull_axis_x_4 * y_x_by_q73 + (pull_axis_y + pull_axis_y_2)
            * u_y_by_q73;
        const double pull_axis_z_4 = y_z * t109 - layer_0_z * pull_19 - layer_1_z * pull_40;
        const double p_y_by_q71 = u_y * p_z;
        const double reach_squared_by_q71 = sinew_choose(t10, -(t11 * p_y_by_q71 + (p_z + p_z)
            * p_z_by_q71), 0.0);
        const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t16;
        const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t20 * u_e * p_z;
        const double limited_by_q71 = sinew_choose(t15, -(reach_by_q71 * t18 - projection_by_q71
            * t19), reach_by_q71);
        const double clearance_by_q71 = sinew_choose(t22, t23 * reach_by_q71 - t24 * limited_by_q71,
            1e-12 * reach_squared_by_q71);
        const double root_by_q71 = 0.5 * clearance_by_q71 * t21;
        const double t121 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t121 - sin_A * reach_squared_by_q71) * t9;
        const double t122 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double cos_A_by_q71 = (t122 - cos_A * reach_squared_by_q71) * t9;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double z_x_by_q71 = t42 - cos_q71 * z_plane_x_by_q71 + t43 + sin_q71 * sin_A_by_q71;
        const double t123 = 0.01 * z_x_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double x_x_by_q71 = t45 + cos_q71 * x_plane_x_by_q71 - t46 + sin_q71 * cos_A_by_q71;
        const double t124 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t125 = 0.01 * z_plane_y_by_q71;
        const double t126 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t127 = y_x * pull_axis_z_4 - y_z * pull_axis_x_4 - pull_x * (t124 + t123 - t41)
            - pull_y * (t126 - t125);
        const double z_z_by_q71 = t36 + cos_q71 * sin_A_by_q71 - t35 + sin_q71 * z_plane_x_by_q71;
        const double t128 = 0.01 * z_z_by_q71;
        const double x_z_by_q71 = t39 - cos_q71 * cos_A_by_q71 + t38 + sin_q71 * x_plane_x_by_q71;
        const double t129 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t130 = t127 + pull_z * (t129 + t128 - t34) - pull_x_2 * (t124 - t123 - t85)
            - pull_y_2 * (t126 + t125);
        tau[state] = -(t130 + pull_z_2 * (t129 - t128 - t84));
        tau[1 * n + state] = -(t120 + pull_axis_z_4 * y_z_by_q73);
    }
}
