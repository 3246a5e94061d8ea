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
        const double t4 = 0.011 * y_x;
        const double layer_0_x = t2 - t3 + t4;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t5 = 0.004 * (u_e * sin_A);
        const double t6 = 0.01 * z_plane_y;
        const double t7 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t5 + t6 + t7;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double t8 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double t9 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double t10 = 0.011 * y_z;
        const double layer_0_z = 0.008 - origin_z - t8 - t9 + t10;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double strand_1_x = layer_0_x - 0.001 * y_x;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double strand_1_z = layer_0_z - 0.001 * y_z;
        const double t11 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double t12 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t12;
        const double t13 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t13;
        const double t14 = 0.003 * y_z;
        const double strand_2_z = layer_0_z - t14;
        const double t15 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double t16 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t16;
        const double t17 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t17;
        const double t18 = 0.005 * y_z;
        const double strand_3_z = layer_0_z - t18;
        const double t19 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double strand_4_x = layer_0_x - 0.006 * y_x;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double strand_4_z = layer_0_z - 0.006 * y_z;
        const double t20 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double t21 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t21;
        const double t22 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t22;
        const double t23 = 0.008 * y_z;
        const double strand_5_z = layer_0_z - t23;
        const double t24 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double strand_6_x = layer_0_x - 0.009 * y_x;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double strand_6_z = layer_0_z - 0.009 * y_z;
        const double t25 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double strand_7_x = layer_0_x - t4;
        const double strand_7_y = 0.011 + layer_0_y - t7;
        const double strand_7_z = layer_0_z - t10;
        const double t26 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double t27 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t27;
        const double t28 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t28;
        const double t29 = 0.013 * y_z;
        const double strand_8_z = layer_0_z - t29;
        const double t30 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double strand_9_x = layer_0_x - 0.014 * y_x;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double strand_9_z = layer_0_z - 0.014 * y_z;
        const double t31 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double t32 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t32;
        const double t33 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t33;
        const double t34 = 0.016 * y_z;
        const double strand_10_z = layer_0_z - t34;
        const double t35 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double strand_11_x = layer_0_x - 0.017 * y_x;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double strand_11_z = layer_0_z - 0.017 * y_z;
        const double t36 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double t37 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t37;
        const double t38 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t38;
        const double t39 = 0.019 * y_z;
        const double strand_12_z = layer_0_z - t39;
        const double t40 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double t41 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t41;
        const double t42 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t42;
        const double t43 = 0.021 * y_z;
        const double strand_13_z = layer_0_z - t43;
        const double t44 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double strand_14_x = layer_0_x - 0.022 * y_x;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double strand_14_z = layer_0_z - 0.022 * y_z;
        const double t45 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double t46 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t46;
        const double t47 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t47;
        const double t48 = 0.024 * y_z;
        const double strand_15_z = layer_0_z - t48;
        const double t49 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double strand_16_x = layer_0_x - 0.025 * y_x;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double strand_16_z = layer_0_z - 0.025 * y_z;
        const double t50 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double t51 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t51;
        const double t52 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t52;
        const double t53 = 0.027 * y_z;
        const double strand_17_z = layer_0_z - t53;
        const double t54 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double t55 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t55;
        const double t56 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t56;
        const double t57 = 0.029 * y_z;
        const double strand_18_z = layer_0_z - t57;
        const double t58 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double layer_1_x = t2 + t3 + t27;
        const double layer_1_y = 0.006 - origin_y - t5 - t6 + t28;
        const double layer_1_z = 0.028 - origin_z - t8 + t9 + t29;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double strand_20_x = layer_1_x - 0.002 * y_x;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double strand_20_z = layer_1_z - 0.002 * y_z;
        const double t59 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double strand_21_x = layer_1_x - t12;
        const double strand_21_y = 0.003 + layer_1_y - t13;
        const double strand_21_z = layer_1_z - t14;
        const double t60 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double strand_22_x = layer_1_x - t16;
        const double strand_22_y = 0.005 + layer_1_y - t17;
        const double strand_22_z = layer_1_z - t18;
        const double t61 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double strand_23_x = layer_1_x - 0.007 * y_x;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double strand_23_z = layer_1_z - 0.007 * y_z;
        const double t62 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double strand_24_x = layer_1_x - t21;
        const double strand_24_y = 0.008 + layer_1_y - t22;
        const double strand_24_z = layer_1_z - t23;
        const double t63 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double strand_25_x = layer_1_x - 0.01 * y_x;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double strand_25_z = layer_1_z - 0.01 * y_z;
        const double t64 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double strand_26_x = layer_1_x - t4;
        const double strand_26_y = 0.011 + layer_1_y - t7;
        const double strand_26_z = layer_1_z - t10;
        const double t65 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double strand_27_x = layer_1_x - t27;
        const double strand_27_y = 0.013 + layer_1_y - t28;
        const double strand_27_z = layer_1_z - t29;
        const double t66 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double strand_28_x = layer_1_x - 0.015 * y_x;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double strand_28_z = layer_1_z - 0.015 * y_z;
        const double t67 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double strand_29_x = layer_1_x - t32;
        const double strand_29_y = 0.016 + layer_1_y - t33;
        const double strand_29_z = layer_1_z - t34;
        const double t68 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double strand_30_x = layer_1_x - 0.018 * y_x;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double strand_30_z = layer_1_z - 0.018 * y_z;
        const double t69 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double strand_31_x = layer_1_x - t37;
        const double strand_31_y = 0.019 + layer_1_y - t38;
        const double strand_31_z = layer_1_z - t39;
        const double t70 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double strand_32_x = layer_1_x - t41;
        const double strand_32_y = 0.021 + layer_1_y - t42;
        const double strand_32_z = layer_1_z - t43;
        const double t71 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double strand_33_x = layer_1_x - 0.023 * y_x;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double strand_33_z = layer_1_z - 0.023 * y_z;
        const double t72 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double strand_34_x = layer_1_x - t46;
        const double strand_34_y = 0.024 + layer_1_y - t47;
        const double strand_34_z = layer_1_z - t48;
        const double t73 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double strand_35_x = layer_1_x - 0.026 * y_x;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double strand_35_z = layer_1_z - 0.026 * y_z;
        const double t74 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double strand_36_x = layer_1_x - t51;
        const double strand_36_y = 0.027 + layer_1_y - t52;
        const double strand_36_z = layer_1_z - t53;
        const double t75 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double strand_37_x = layer_1_x - t55;
        const double strand_37_y = 0.029 + layer_1_y - t56;
        const double strand_37_z = layer_1_z - t57;
        const double t76 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        h[state] = length_0;
        h[1 * n + state] = sinew_sqrt(t11);
        h[2 * n + state] = sinew_sqrt(t15);
        h[3 * n + state] = sinew_sqrt(t19);
        h[4 * n + state] = sinew_sqrt(t20);
        h[5 * n + state] = sinew_sqrt(t24);
        h[6 * n + state] = sinew_sqrt(t25);
        h[7 * n + state] = sinew_sqrt(t26);
        h[8 * n + state] = sinew_sqrt(t30);
        h[9 * n + state] = sinew_sqrt(t31);
        h[10 * n + state] = sinew_sqrt(t35);
        h[11 * n + state] = sinew_sqrt(t36);
        h[12 * n + state] = sinew_sqrt(t40);
        h[13 * n + state] = sinew_sqrt(t44);
        h[14 * n + state] = sinew_sqrt(t45);
        h[15 * n + state] = sinew_sqrt(t49);
        h[16 * n + state] = sinew_sqrt(t50);
        h[17 * n + state] = sinew_sqrt(t54);
        h[18 * n + state] = sinew_sqrt(t58);
        h[19 * n + state] = length_19;
        h[20 * n + state] = sinew_sqrt(t59);
        h[21 * n + state] = sinew_sqrt(t60);
        h[22 * n + state] = sinew_sqrt(t61);
        h[23 * n + state] = sinew_sqrt(t62);
        h[24 * n + state] = sinew_sqrt(t63);
        h[25 * n + state] = sinew_sqrt(t64);
        h[26 * n + state] = sinew_sqrt(t65);
        h[27 * n + state] = sinew_sqrt(t66);
        h[28 * n + state] = sinew_sqrt(t67);
        h[29 * n + state] = sinew_sqrt(t68);
        h[30 * n + state] = sinew_sqrt(t69);
        h[31 * n + state] = sinew_sqrt(t70);
        h[32 * n + state] = sinew_sqrt(t71);
        h[33 * n + state] = sinew_sqrt(t72);
        h[34 * n + state] = sinew_sqrt(t73);
        h[35 * n + state] = sinew_sqrt(t74);
        h[36 * n + state] = sinew_sqrt(t75);
        h[37 * n + state] = sinew_sqrt(t76);
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
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t41 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t42 = 0.01 * z_plane_y_by_q71;
        const double layer_0_y_by_q71 = t41 - t42;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t43 = 0.004 * (u_e * sin_A);
        const double t44 = 0.01 * z_plane_y;
        const double t45 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t43 + t44 + t45;
        const double z_z_by_q71 = t34 + cos_q71 * sin_A_by_q71 - t35 + sin_q71 * z_plane_x_by_q71;
        const double x_z_by_q71 = t36 - cos_q71 * cos_A_by_q71 + t37 + sin_q71 * x_plane_x_by_q71;
        const double t46 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t47 = 0.01 * z_z_by_q71;
        const double layer_0_z_by_q71 = t46 + t47 - t40;
        const double z_z = t26 + t27;
        const double origin_z = M_z - 0.018 * z_z;
        const double t48 = 0.004 * (t29 - t30);
        const double t49 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t48 - t49 + t33;
        const double t50 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
            * layer_0_z_by_q71;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double t51 = 1.0 / length_0;
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
        const double t52 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t52 * t25;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double t53 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t53 * t25;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t54 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t55 = 0.01 * z_x_by_q73;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t56 = 0.011 * y_x_by_q73;
        const double layer_0_x_by_q73 = t54 + t55 - t56;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t57 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t58 = 0.01 * z_plane_y_by_q73;
        const double t59 = 0.011 * u_y_by_q73;
        const double layer_0_y_by_q73 = t57 + t58 - t59;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t60 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t61 = 0.01 * z_z_by_q73;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t62 = 0.011 * y_z_by_q73;
        const double layer_0_z_by_q73 = t60 + t61 - t62;
        const double t63 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
            * layer_0_z_by_q73;
        const double t64 = 0.001 * y_z;
        const double t65 = 0.001 * y_x;
        const double strand_1_x = layer_0_x - t65;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double strand_1_z = layer_0_z - t64;
        const double t66 = strand_1_x * (layer_0_x_by_q71 + t64) - strand_1_y * layer_0_y_by_q71
            - strand_1_z * (layer_0_z_by_q71 + t65);
        const double t67 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double t68 = 1.0 / sinew_sqrt(t67);
        const double t69 = strand_1_x * (layer_0_x_by_q73 + 0.001 * y_x_by_q73) - strand_1_y
            * (layer_0_y_by_q73 + 0.001 * u_y_by_q73);
        const double length_1_by_q73 = (t69 + strand_1_z * (layer_0_z_by_q73 + 0.001 * y_z_by_q73))
            * t68;
        const double t70 = 0.003 * y_z;
        const double t71 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t71;
        const double t72 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t72;
        const double strand_2_z = layer_0_z - t70;
        const double t73 = strand_2_x * (layer_0_x_by_q71 + t70) - strand_2_y * layer_0_y_by_q71
            - strand_2_z * (layer_0_z_by_q71 + t71);
        const double t74 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double t75 = 1.0 / sinew_sqrt(t74);
        const double t76 = 0.003 * y_x_by_q73;
        const double t77 = 0.003 * u_y_by_q73;
        const double t78 = strand_2_x * (layer_0_x_by_q73 + t76) - strand_2_y * (layer_0_y_by_q73
            + t77);
        const double t79 = 0.003 * y_z_by_q73;
        const double length_2_by_q73 = (t78 + strand_2_z * (layer_0_z_by_q73 + t79)) * t75;
        const double t80 = 0.005 * y_z;
        const double t81 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t81;
        const double t82 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t82;
        const double strand_3_z = layer_0_z - t80;
        const double t83 = strand_3_x * (layer_0_x_by_q71 + t80) - strand_3_y * layer_0_y_by_q71
            - strand_3_z * (layer_0_z_by_q71 + t81);
        const double t84 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double t85 = 1.0 / sinew_sqrt(t84);
        const double t86 = 0.005 * y_x_by_q73;
        const double t87 = 0.005 * u_y_by_q73;
        const double t88 = strand_3_x * (layer_0_x_by_q73 + t86) - strand_3_y * (layer_0_y_by_q73
            + t87);
        const double t89 = 0.005 * y_z_by_q73;
        const double length_3_by_q73 = (t88 + strand_3_z * (layer_0_z_by_q73 + t89)) * t85;
        const double t90 = 0.006 * y_z;
        const double t91 = 0.006 * y_x;
        const double strand_4_x = layer_0_x - t91;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double strand_4_z = layer_0_z - t90;
        const double t92 = strand_4_x * (layer_0_x_by_q71 + t90) - strand_4_y * layer_0_y_by_q71
            - strand_4_z * (layer_0_z_by_q71 + t91);
        const double t93 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double t94 = 1.0 / sinew_sqrt(t93);
        const double t95 = strand_4_x * (layer_0_x_by_q73 + 0.006 * y_x_by_q73) - strand_4_y
            * (layer_0_y_by_q73 + 0.006 * u_y_by_q73);
        const double length_4_by_q73 = (t95 + strand_4_z * (layer_0_z_by_q73 + 0.006 * y_z_by_q73))
            * t94;
        const double t96 = 0.008 * y_z;
        const double t97 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t97;
        const double t98 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t98;
        const double strand_5_z = layer_0_z - t96;
        const double t99 = strand_5_x * (layer_0_x_by_q71 + t96) - strand_5_y * layer_0_y_by_q71
            - strand_5_z * (layer_0_z_by_q71 + t97);
        const double t100 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double t101 = 1.0 / sinew_sqrt(t100);
        const double t102 = 0.008 * y_x_by_q73;
        const double t103 = 0.008 * u_y_by_q73;
        const double t104 = strand_5_x * (layer_0_x_by_q73 + t102) - strand_5_y * (layer_0_y_by_q73
            + t103);
        const double t105 = 0.008 * y_z_by_q73;
        const double length_5_by_q73 = (t104 + strand_5_z * (layer_0_z_by_q73 + t105)) * t101;
        const double t106 = 0.009 * y_z;
        const double t107 = 0.009 * y_x;
        const double strand_6_x = layer_0_x - t107;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double strand_6_z = layer_0_z - t106;
        const double t108 = strand_6_x * (layer_0_x_by_q71 + t106) - strand_6_y * layer_0_y_by_q71
            - strand_6_z * (layer_0_z_by_q71 + t107);
        const double t109 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double t110 = 1.0 / sinew_sqrt(t109);
        const double t111 = strand_6_x * (layer_0_x_by_q73 + 0.009 * y_x_by_q73) - strand_6_y
            * (layer_0_y_by_q73 + 0.009 * u_y_by_q73);
        const double length_6_by_q73 = (t111 + strand_6_z * (layer_0_z_by_q73 + 0.009 * y_z_by_q73))
            * t110;
        const double strand_7_x = layer_0_x - t40;
        const double strand_7_y = 0.011 + layer_0_y - t45;
        const double strand_7_z = layer_0_z - t33;
        const double t112 = strand_7_x * (layer_0_x_by_q71 + t33) - strand_7_y * layer_0_y_by_q71
            - strand_7_z * (layer_0_z_by_q71 + t40);
        const double t113 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double t114 = 1.0 / sinew_sqrt(t113);
        const double t115 = strand_7_x * (layer_0_x_by_q73 + t56) - strand_7_y * (layer_0_y_by_q73
            + t59);
        const double length_7_by_q73 = (t115 + strand_7_z * (layer_0_z_by_q73 + t62)) * t114;
        const double t116 = 0.013 * y_z;
        const double t117 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t117;
        const double t118 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t118;
        const double strand_8_z = layer_0_z - t116;
        const double t119 = strand_8_x * (layer_0_x_by_q71 + t116) - strand_8_y * layer_0_y_by_q71
            - strand_8_z * (layer_0_z_by_q71 + t117);
        const double t120 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double t121 = 1.0 / sinew_sqrt(t120);
        const double t122 = 0.013 * y_x_by_q73;
        const double t123 = 0.013 * u_y_by_q73;
        const double t124 = strand_8_x * (layer_0_x_by_q73 + t122) - strand_8_y * (layer_0_y_by_q73
            + t123);
        const double t125 = 0.013 * y_z_by_q73;
        const double length_8_by_q73 = (t124 + strand_8_z * (layer_0_z_by_q73 + t125)) * t121;
        const double t126 = 0.014 * y_z;
        const double t127 = 0.014 * y_x;
        const double strand_9_x = layer_0_x - t127;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double strand_9_z = layer_0_z - t126;
        const double t128 = strand_9_x * (layer_0_x_by_q71 + t126) - strand_9_y * layer_0_y_by_q71
            - strand_9_z * (layer_0_z_by_q71 + t127);
        const double t129 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double t130 = 1.0 / sinew_sqrt(t129);
        const double t131 = strand_9_x * (layer_0_x_by_q73 + 0.014 * y_x_by_q73) - strand_9_y
            * (layer_0_y_by_q73 + 0.014 * u_y_by_q73);
        const double length_9_by_q73 = (t131 + strand_9_z * (layer_0_z_by_q73 + 0.014 * y_z_by_q73))
            * t130;
        const double t132 = 0.016 * y_z;
        const double t133 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t133;
        const double t134 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t134;
        const double strand_10_z = layer_0_z - t132;
        const double t135 = strand_10_x * (layer_0_x_by_q71 + t132) - strand_10_y * layer_0_y_by_q71
            - strand_10_z * (layer_0_z_by_q71 + t133);
        const double t136 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double t137 = 1.0 / sinew_sqrt(t136);
        const double t138 = 0.016 * y_x_by_q73;
        const double t139 = 0.016 * u_y_by_q73;
        const double t140 = strand_10_x * (layer_0_x_by_q73 + t138) - strand_10_y
            * (layer_0_y_by_q73 + t139);
        const double t141 = 0.016 * y_z_by_q73;
        const double length_10_by_q73 = (t140 + strand_10_z * (layer_0_z_by_q73 + t141)) * t137;
        const double t142 = 0.017 * y_z;
        const double t143 = 0.017 * y_x;
        const double strand_11_x = layer_0_x - t143;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double strand_11_z = layer_0_z - t142;
        const double t144 = strand_11_x * (layer_0_x_by_q71 + t142) - strand_11_y * layer_0_y_by_q71
            - strand_11_z * (layer_0_z_by_q71 + t143);
        const double t145 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double t146 = 1.0 / sinew_sqrt(t145);
        const double t147 = strand_11_x * (layer_0_x_by_q73 + 0.017 * y_x_by_q73) - strand_11_y
            * (layer_0_y_by_q73 + 0.017 * u_y_by_q73);
        const double length_11_by_q73 = (t147 + strand_11_z * (layer_0_z_by_q73 + 0.017
            * y_z_by_q73)) * t146;
        const double t148 = 0.019 * y_z;
        const double t149 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t149;
        const double t150 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t150;
        const double strand_12_z = layer_0_z - t148;
        const double t151 = strand_12_x * (layer_0_x_by_q71 + t148) - strand_12_y * layer_0_y_by_q71
            - strand_12_z * (layer_0_z_by_q71 + t149);
        const double t152 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double t153 = 1.0 / sinew_sqrt(t152);
        const double t154 = 0.019 * y_x_by_q73;
        const double t155 = 0.019 * u_y_by_q73;
        const double t156 = strand_12_x * (layer_0_x_by_q73 + t154) - strand_12_y
            * (layer_0_y_by_q73 + t155);
        const double t157 = 0.019 * y_z_by_q73;
        const double length_12_by_q73 = (t156 + strand_12_z * (layer_0_z_by_q73 + t157)) * t153;
        const double t158 = 0.021 * y_z;
        const double t159 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t159;
        const double t160 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t160;
        const double strand_13_z = layer_0_z - t158;
        const double t161 = strand_13_x * (layer_0_x_by_q71 + t158) - strand_13_y * layer_0_y_by_q71
            - strand_13_z * (layer_0_z_by_q71 + t159);
        const double t162 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double t163 = 1.0 / sinew_sqrt(t162);
        const double t164 = 0.021 * y_x_by_q73;
        const double t165 = 0.021 * u_y_by_q73;
        const double t166 = strand_13_x * (layer_0_x_by_q73 + t164) - strand_13_y
            * (layer_0_y_by_q73 + t165);
        const double t167 = 0.021 * y_z_by_q73;
        const double length_13_by_q73 = (t166 + strand_13_z * (layer_0_z_by_q73 + t167)) * t163;
        const double t168 = 0.022 * y_z;
        const double t169 = 0.022 * y_x;
        const double strand_14_x = layer_0_x - t169;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double strand_14_z = layer_0_z - t168;
        const double t170 = strand_14_x * (layer_0_x_by_q71 + t168) - strand_14_y * layer_0_y_by_q71
            - strand_14_z * (layer_0_z_by_q71 + t169);
        const double t171 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double t172 = 1.0 / sinew_sqrt(t171);
        const double t173 = strand_14_x * (layer_0_x_by_q73 + 0.022 * y_x_by_q73) - strand_14_y
            * (layer_0_y_by_q73 + 0.022 * u_y_by_q73);
        const double length_14_by_q73 = (t173 + strand_14_z * (layer_0_z_by_q73 + 0.022
            * y_z_by_q73)) * t172;
        const double t174 = 0.024 * y_z;
        const double t175 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t175;
        const double t176 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t176;
        const double strand_15_z = layer_0_z - t174;
        const double t177 = strand_15_x * (layer_0_x_by_q71 + t174) - strand_15_y * layer_0_y_by_q71
            - strand_15_z * (layer_0_z_by_q71 + t175);
        const double t178 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double t179 = 1.0 / sinew_sqrt(t178);
        const double t180 = 0.024 * y_x_by_q73;
        const double t181 = 0.024 * u_y_by_q73;
        const double t182 = strand_15_x * (layer_0_x_by_q73 + t180) - strand_15_y
            * (layer_0_y_by_q73 + t181);
        const double t183 = 0.024 * y_z_by_q73;
        const double length_15_by_q73 = (t182 + strand_15_z * (layer_0_z_by_q73 + t183)) * t179;
        const double t184 = 0.025 * y_z;
        const double t185 = 0.025 * y_x;
        const double strand_16_x = layer_0_x - t185;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double strand_16_z = layer_0_z - t184;
        const double t186 = strand_16_x * (layer_0_x_by_q71 + t184) - strand_16_y * layer_0_y_by_q71
            - strand_16_z * (layer_0_z_by_q71 + t185);
        const double t187 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double t188 = 1.0 / sinew_sqrt(t187);
        const double t189 = strand_16_x * (layer_0_x_by_q73 + 0.025 * y_x_by_q73) - strand_16_y
            * (layer_0_y_by_q73 + 0.025 * u_y_by_q73);
        const double length_16_by_q73 = (t189 + strand_16_z * (layer_0_z_by_q73 + 0.025
            * y_z_by_q73)) * t188;
        const double t190 = 0.027 * y_z;
        const double t191 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t191;
        const double t192 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t192;
        const double strand_17_z = layer_0_z - t190;
        const double t193 = strand_17_x * (layer_0_x_by_q71 + t190) - strand_17_y * layer_0_y_by_q71
            - strand_17_z * (layer_0_z_by_q71 + t191);
        const double t194 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double t195 = 1.0 / sinew_sqrt(t194);
        const double t196 = 0.027 * y_x_by_q73;
        const double t197 = 0.027 * u_y_by_q73;
        const double t198 = strand_17_x * (layer_0_x_by_q73 + t196) - strand_17_y
            * (layer_0_y_by_q73 + t197);
        const double t199 = 0.027 * y_z_by_q73;
        const double length_17_by_q73 = (t198 + strand_17_z * (layer_0_z_by_q73 + t199)) * t195;
        const double t200 = 0.029 * y_z;
        const double t201 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t201;
        const double t202 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t202;
        const double strand_18_z = layer_0_z - t200;
        const double t203 = strand_18_x * (layer_0_x_by_q71 + t200) - strand_18_y * layer_0_y_by_q71
            - strand_18_z * (layer_0_z_by_q71 + t201);
        const double t204 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double t205 = 1.0 / sinew_sqrt(t204);
        const double t206 = 0.029 * y_x_by_q73;
        const double t207 = 0.029 * u_y_by_q73;
        const double t208 = strand_18_x * (layer_0_x_by_q73 + t206) - strand_18_y
            * (layer_0_y_by_q73 + t207);
        const double t209 = 0.029 * y_z_by_q73;
        const double length_18_by_q73 = (t208 + strand_18_z * (layer_0_z_by_q73 + t209)) * t205;
        const double layer_1_x_by_q71 = t31 - t32 - t116;
        const double layer_1_x = t38 + t39 + t117;
        const double layer_1_y_by_q71 = t41 + t42;
        const double layer_1_y = 0.006 - origin_y - t43 - t44 + t118;
        const double layer_1_z_by_q71 = t46 - t47 - t117;
        const double layer_1_z = 0.028 - origin_z - t48 + t49 + t116;
        const double t210 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
            * layer_1_z_by_q71;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double t211 = 1.0 / length_19;
        const double layer_1_x_by_q73 = t54 - t55 - t122;
        const double layer_1_y_by_q73 = t57 - t58 - t123;
        const double layer_1_z_by_q73 = t60 - t61 - t125;
        const double t212 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
            * layer_1_z_by_q73;
        const double t213 = 0.002 * y_z;
        const double t214 = 0.002 * y_x;
        const double strand_20_x = layer_1_x - t214;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double strand_20_z = layer_1_z - t213;
        const double t215 = strand_20_x * (layer_1_x_by_q71 + t213) - strand_20_y * layer_1_y_by_q71
            - strand_20_z * (layer_1_z_by_q71 + t214);
        const double t216 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double t217 = 1.0 / sinew_sqrt(t216);
        const double t218 = strand_20_x * (layer_1_x_by_q73 + 0.002 * y_x_by_q73) - strand_20_y
            * (layer_1_y_by_q73 + 0.002 * u_y_by_q73);
        const double length_20_by_q73 = (t218 + strand_20_z * (layer_1_z_by_q73 + 0.002
            * y_z_by_q73)) * t217;
        const double strand_21_x = layer_1_x - t71;
        const double strand_21_y = 0.003 + layer_1_y - t72;
        const double strand_21_z = layer_1_z - t70;
        const double t219 = strand_21_x * (layer_1_x_by_q71 + t70) - strand_21_y * layer_1_y_by_q71
            - strand_21_z * (layer_1_z_by_q71 + t71);
        const double t220 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double t221 = 1.0 / sinew_sqrt(t220);
        const double t222 = strand_21_x * (layer_1_x_by_q73 + t76) - strand_21_y * (layer_1_y_by_q73
            + t77);
        const double length_21_by_q73 = (t222 + strand_21_z * (layer_1_z_by_q73 + t79)) * t221;
        const double strand_22_x = layer_1_x - t81;
        const double strand_22_y = 0.005 + layer_1_y - t82;
        const double strand_22_z = layer_1_z - t80;
        const double t223 = strand_22_x * (layer_1_x_by_q71 + t80) - strand_22_y * layer_1_y_by_q71
            - strand_22_z * (layer_1_z_by_q71 + t81);
        const double t224 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double t225 = 1.0 / sinew_sqrt(t224);
        const double t226 = strand_22_x * (layer_1_x_by_q73 + t86) - strand_22_y * (layer_1_y_by_q73
            + t87);
        const double length_22_by_q73 = (t226 + strand_22_z * (layer_1_z_by_q73 + t89)) * t225;
        const double t227 = 0.007 * y_z;
        const double t228 = 0.007 * y_x;
        const double strand_23_x = layer_1_x - t228;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double strand_23_z = layer_1_z - t227;
        const double t229 = strand_23_x * (layer_1_x_by_q71 + t227) - strand_23_y * layer_1_y_by_q71
            - strand_23_z * (layer_1_z_by_q71 + t228);
        const double t230 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double t231 = 1.0 / sinew_sqrt(t230);
        const double t232 = strand_23_x * (layer_1_x_by_q73 + 0.007 * y_x_by_q73) - strand_23_y
            * (layer_1_y_by_q73 + 0.007 * u_y_by_q73);
        const double length_23_by_q73 = (t232 + strand_23_z * (layer_1_z_by_q73 + 0.007
            * y_z_by_q73)) * t231;
        const double strand_24_x = layer_1_x - t97;
        const double strand_24_y = 0.008 + layer_1_y - t98;
        const double strand_24_z = layer_1_z - t96;
        const double t233 = strand_24_x * (layer_1_x_by_q71 + t96) - strand_24_y * layer_1_y_by_q71
            - strand_24_z * (layer_1_z_by_q71 + t97);
        const double t234 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double t235 = 1.0 / sinew_sqrt(t234);
        const double t236 = strand_24_x * (layer_1_x_by_q73 + t102) - strand_24_y
            * (layer_1_y_by_q73 + t103);
        const double length_24_by_q73 = (t236 + strand_24_z * (layer_1_z_by_q73 + t105)) * t235;
        const double t237 = 0.01 * y_z;
        const double t238 = 0.01 * y_x;
        const double strand_25_x = layer_1_x - t238;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double strand_25_z = layer_1_z - t237;
        const double t239 = strand_25_x * (layer_1_x_by_q71 + t237) - strand_25_y * layer_1_y_by_q71
            - strand_25_z * (layer_1_z_by_q71 + t238);
        const double t240 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double t241 = 1.0 / sinew_sqrt(t240);
        const double t242 = strand_25_x * (layer_1_x_by_q73 + 0.01 * y_x_by_q73) - strand_25_y
            * (layer_1_y_by_q73 + 0.01 * u_y_by_q73);
        const double length_25_by_q73 = (t242 + strand_25_z * (layer_1_z_by_q73 + 0.01
            * y_z_by_q73)) * t241;
        const double strand_26_x = layer_1_x - t40;
        const double strand_26_y = 0.011 + layer_1_y - t45;
        const double strand_26_z = layer_1_z - t33;
        const double t243 = strand_26_x * (layer_1_x_by_q71 + t33) - strand_26_y * layer_1_y_by_q71
            - strand_26_z * (layer_1_z_by_q71 + t40);
        const double t244 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double t245 = 1.0 / sinew_sqrt(t244);
        const double t246 = strand_26_x * (layer_1_x_by_q73 + t56) - strand_26_y * (layer_1_y_by_q73
            + t59);
        const double length_26_by_q73 = (t246 + strand_26_z * (layer_1_z_by_q73 + t62)) * t245;
        const double strand_27_x = layer_1_x - t117;
        const double strand_27_y = 0.013 + layer_1_y - t118;
        const double strand_27_z = layer_1_z - t116;
        const double t247 = strand_27_x * (layer_1_x_by_q71 + t116) - strand_27_y * layer_1_y_by_q71
            - strand_27_z * (layer_1_z_by_q71 + t117);
        const double t248 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double t249 = 1.0 / sinew_sqrt(t248);
        const double t250 = strand_27_x * (layer_1_x_by_q73 + t122) - strand_27_y
            * (layer_1_y_by_q73 + t123);
        const double length_27_by_q73 = (t250 + strand_27_z * (layer_1_z_by_q73 + t125)) * t249;
        const double t251 = 0.015 * y_z;
        const double t252 = 0.015 * y_x;
        const double strand_28_x = layer_1_x - t252;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double strand_28_z = layer_1_z - t251;
        const double t253 = strand_28_x * (layer_1_x_by_q71 + t251) - strand_28_y * layer_1_y_by_q71
            - strand_28_z * (layer_1_z_by_q71 + t252);
        const double t254 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double t255 = 1.0 / sinew_sqrt(t254);
        const double t256 = strand_28_x * (layer_1_x_by_q73 + 0.015 * y_x_by_q73) - strand_28_y
            * (layer_1_y_by_q73 + 0.015 * u_y_by_q73);
        const double length_28_by_q73 = (t256 + strand_28_z * (layer_1_z_by_q73 + 0.015
            * y_z_by_q73)) * t255;
        const double strand_29_x = layer_1_x - t133;
        const double strand_29_y = 0.016 + layer_1_y - t134;
        const double strand_29_z = layer_1_z - t132;
        const double t257 = strand_29_x * (layer_1_x_by_q71 + t132) - strand_29_y * layer_1_y_by_q71
            - strand_29_z * (layer_1_z_by_q71 + t133);
        const double t258 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double t259 = 1.0 / sinew_sqrt(t258);
        const double t260 = strand_29_x * (layer_1_x_by_q73 + t138) - strand_29_y
            * (layer_1_y_by_q73 + t139);
        const double length_29_by_q73 = (t260 + strand_29_z * (layer_1_z_by_q73 + t141)) * t259;
        const double t261 = 0.018 * y_z;
        const double t262 = 0.018 * y_x;
        const double strand_30_x = layer_1_x - t262;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double strand_30_z = layer_1_z - t261;
        const double t263 = strand_30_x * (layer_1_x_by_q71 + t261) - strand_30_y * layer_1_y_by_q71
            - strand_30_z * (layer_1_z_by_q71 + t262);
        const double t264 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double t265 = 1.0 / sinew_sqrt(t264);
        const double t266 = strand_30_x * (layer_1_x_by_q73 + 0.018 * y_x_by_q73) - strand_30_y
            * (layer_1_y_by_q73 + 0.018 * u_y_by_q73);
        const double length_30_by_q73 = (t266 + strand_30_z * (layer_1_z_by_q73 + 0.018
            * y_z_by_q73)) * t265;
        const double strand_31_x = layer_1_x - t149;
        const double strand_31_y = 0.019 + layer_1_y - t150;
        const double strand_31_z = layer_1_z - t148;
        const double t267 = strand_31_x * (layer_1_x_by_q71 + t148) - strand_31_y * layer_1_y_by_q71
            - strand_31_z * (layer_1_z_by_q71 + t149);
        const double t268 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double t269 = 1.0 / sinew_sqrt(t268);
        const double t270 = strand_31_x * (layer_1_x_by_q73 + t154) - strand_31_y
            * (layer_1_y_by_q73 + t155);
        const double length_31_by_q73 = (t270 + strand_31_z * (layer_1_z_by_q73 + t157)) * t269;
        const double strand_32_x = layer_1_x - t159;
        const double strand_32_y = 0.021 + layer_1_y - t160;
        const double strand_32_z = layer_1_z - t158;
        const double t271 = strand_32_x * (layer_1_x_by_q71 + t158) - strand_32_y * layer_1_y_by_q71
            - strand_32_z * (layer_1_z_by_q71 + t159);
        const double t272 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double t273 = 1.0 / sinew_sqrt(t272);
        const double t274 = strand_32_x * (layer_1_x_by_q73 + t164) - strand_32_y
            * (layer_1_y_by_q73 + t165);
        const double length_32_by_q73 = (t274 + strand_32_z * (layer_1_z_by_q73 + t167)) * t273;
        const double t275 = 0.023 * y_z;
        const double t276 = 0.023 * y_x;
        const double strand_33_x = layer_1_x - t276;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double strand_33_z = layer_1_z - t275;
        const double t277 = strand_33_x * (layer_1_x_by_q71 + t275) - strand_33_y * layer_1_y_by_q71
            - strand_33_z * (layer_1_z_by_q71 + t276);
        const double t278 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double t279 = 1.0 / sinew_sqrt(t278);
        const double t280 = strand_33_x * (layer_1_x_by_q73 + 0.023 * y_x_by_q73) - strand_33_y
            * (layer_1_y_by_q73 + 0.023 * u_y_by_q73);
        const double length_33_by_q73 = (t280 + strand_33_z * (layer_1_z_by_q73 + 0.023
            * y_z_by_q73)) * t279;
        const double strand_34_x = layer_1_x - t175;
        const double strand_34_y = 0.024 + layer_1_y - t176;
        const double strand_34_z = layer_1_z - t174;
        const double t281 = strand_34_x * (layer_1_x_by_q71 + t174) - strand_34_y * layer_1_y_by_q71
            - strand_34_z * (layer_1_z_by_q71 + t175);
        const double t282 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double t283 = 1.0 / sinew_sqrt(t282);
        const double t284 = strand_34_x * (layer_1_x_by_q73 + t180) - strand_34_y
            * (layer_1_y_by_q73 + t181);
        const double length_34_by_q73 = (t284 + strand_34_z * (layer_1_z_by_q73 + t183)) * t283;
        const double t285 = 0.026 * y_z;
        const double t286 = 0.026 * y_x;
        const double strand_35_x = layer_1_x - t286;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double strand_35_z = layer_1_z - t285;
        const double t287 = strand_35_x * (layer_1_x_by_q71 + t285) - strand_35_y * layer_1_y_by_q71
            - strand_35_z * (layer_1_z_by_q71 + t286);
        const double t288 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double t289 = 1.0 / sinew_sqrt(t288);
        const double t290 = strand_35_x * (layer_1_x_by_q73 + 0.026 * y_x_by_q73) - strand_35_y
            * (layer_1_y_by_q73 + 0.026 * u_y_by_q73);
        const double length_35_by_q73 = (t290 + strand_35_z * (layer_1_z_by_q73 + 0.026
            * y_z_by_q73)) * t289;
        const double strand_36_x = layer_1_x - t191;
        const double strand_36_y = 0.027 + layer_1_y - t192;
        const double strand_36_z = layer_1_z - t190;
        const double t291 = strand_36_x * (layer_1_x_by_q71 + t190) - strand_36_y * layer_1_y_by_q71
            - strand_36_z * (layer_1_z_by_q71 + t191);
        const double t292 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double t293 = 1.0 / sinew_sqrt(t292);
        const double t294 = strand_36_x * (layer_1_x_by_q73 + t196) - strand_36_y
            * (layer_1_y_by_q73 + t197);
        const double length_36_by_q73 = (t294 + strand_36_z * (layer_1_z_by_q73 + t199)) * t293;
        const double strand_37_x = layer_1_x - t201;
        const double strand_37_y = 0.029 + layer_1_y - t202;
        const double strand_37_z = layer_1_z - t200;
        const double t295 = strand_37_x * (layer_1_x_by_q71 + t200) - strand_37_y * layer_1_y_by_q71
            - strand_37_z * (layer_1_z_by_q71 + t201);
        const double t296 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double t297 = 1.0 / sinew_sqrt(t296);
        const double t298 = strand_37_x * (layer_1_x_by_q73 + t206) - strand_37_y
            * (layer_1_y_by_q73 + t207);
        const double length_37_by_q73 = (t298 + strand_37_z * (layer_1_z_by_q73 + t209)) * t297;
        P[state] = t50 * t51;
        P[1 * n + state] = -(t63 * t51);
        P[2 * n + state] = t66 * t68;
        P[3 * n + state] = -length_1_by_q73;
        P[4 * n + state] = t73 * t75;
        P[5 * n + state] = -length_2_by_q73;
        P[6 * n + state] = t83 * t85;
        P[7 * n + state] = -length_3_by_q73;
        P[8 * n + state] = t92 * t94;
        P[9 * n + state] = -length_4_by_q73;
        P[10 * n + state] = t99 * t101;
        P[11 * n + state] = -length_5_by_q73;
        P[12 * n + state] = t108 * t110;
        P[13 * n + state] = -length_6_by_q73;
        P[14 * n + state] = t112 * t114;
        P[15 * n + state] = -length_7_by_q73;
        P[16 * n + state] = t119 * t121;
        P[17 * n + state] = -length_8_by_q73;
        P[18 * n + state] = t128 * t130;
        P[19 * n + state] = -length_9_by_q73;
        P[20 * n + state] = t135 * t137;
        P[21 * n + state] = -length_10_by_q73;
        P[22 * n + state] = t144 * t146;
        P[23 * n + state] = -length_11_by_q73;
        P[24 * n + state] = t151 * t153;
        P[25 * n + state] = -length_12_by_q73;
        P[26 * n + state] = t161 * t163;
        P[27 * n + state] = -length_13_by_q73;
        P[28 * n + state] = t170 * t172;
        P[29 * n + state] = -length_14_by_q73;
        P[30 * n + state] = t177 * t179;
        P[31 * n + state] = -length_15_by_q73;
        P[32 * n + state] = t186 * t188;
        P[33 * n + state] = -length_16_by_q73;
        P[34 * n + state] = t193 * t195;
        P[35 * n + state] = -length_17_by_q73;
        P[36 * n + state] = t203 * t205;
        P[37 * n + state] = -length_18_by_q73;
        P[38 * n + state] = t210 * t211;
        P[39 * n + state] = -(t212 * t211);
        P[40 * n + state] = t215 * t217;
        P[41 * n + state] = -length_20_by_q73;
        P[42 * n + state] = t219 * t221;
        P[43 * n + state] = -length_21_by_q73;
        P[44 * n + state] = t223 * t225;
        P[45 * n + state] = -length_22_by_q73;
        P[46 * n + state] = t229 * t231;
        P[47 * n + state] = -length_23_by_q73;
        P[48 * n + state] = t233 * t235;
        P[49 * n + state] = -length_24_by_q73;
        P[50 * n + state] = t239 * t241;
        P[51 * n + state] = -length_25_by_q73;
        P[52 * n + state] = t243 * t245;
        P[53 * n + state] = -length_26_by_q73;
        P[54 * n + state] = t247 * t249;
        P[55 * n + state] = -length_27_by_q73;
        P[56 * n + state] = t253 * t255;
        P[57 * n + state] = -length_28_by_q73;
        P[58 * n + state] = t257 * t259;
        P[59 * n + state] = -length_29_by_q73;
        P[60 * n + state] = t263 * t265;
        P[61 * n + state] = -length_30_by_q73;
        P[62 * n + state] = t267 * t269;
        P[63 * n + state] = -length_31_by_q73;
        P[64 * n + state] = t271 * t273;
        P[65 * n + state] = -length_32_by_q73;
        P[66 * n + state] = t277 * t279;
        P[67 * n + state] = -length_33_by_q73;
        P[68 * n + state] = t281 * t283;
        P[69 * n + state] = -length_34_by_q73;
        P[70 * n + state] = t287 * t289;
        P[71 * n + state] = -length_35_by_q73;
        P[72 * n + state] = t291 * t293;
        P[73 * n + state] = -length_36_by_q73;
        P[74 * n + state] = t295 * t297;
        P[75 * n + state] = -length_37_by_q73;
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
        const double t4 = 0.011 * y_x;
        const double layer_0_x = t2 - t3 + t4;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t5 = 0.004 * (u_e * sin_A);
        const double t6 = 0.01 * z_plane_y;
        const double t7 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t5 + t6 + t7;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double t8 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double t9 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double t10 = 0.011 * y_z;
        const double layer_0_z = 0.008 - origin_z - t8 - t9 + t10;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double strand_1_x = layer_0_x - 0.001 * y_x;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double strand_1_z = layer_0_z - 0.001 * y_z;
        const double t11 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double t12 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t12;
        const double t13 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t13;
        const double t14 = 0.003 * y_z;
        const double strand_2_z = layer_0_z - t14;
        const double t15 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double t16 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t16;
        const double t17 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t17;
        const double t18 = 0.005 * y_z;
        const double strand_3_z = layer_0_z - t18;
        const double t19 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double strand_4_x = layer_0_x - 0.006 * y_x;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double strand_4_z = layer_0_z - 0.006 * y_z;
        const double t20 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double t21 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t21;
        const double t22 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t22;
        const double t23 = 0.008 * y_z;
        const double strand_5_z = layer_0_z - t23;
        const double t24 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double strand_6_x = layer_0_x - 0.009 * y_x;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double strand_6_z = layer_0_z - 0.009 * y_z;
        const double t25 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double strand_7_x = layer_0_x - t4;
        const double strand_7_y = 0.011 + layer_0_y - t7;
        const double strand_7_z = layer_0_z - t10;
        const double t26 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double t27 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t27;
        const double t28 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t28;
        const double t29 = 0.013 * y_z;
        const double strand_8_z = layer_0_z - t29;
        const double t30 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double strand_9_x = layer_0_x - 0.014 * y_x;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double strand_9_z = layer_0_z - 0.014 * y_z;
        const double t31 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double t32 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t32;
        const double t33 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t33;
        const double t34 = 0.016 * y_z;
        const double strand_10_z = layer_0_z - t34;
        const double t35 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double strand_11_x = layer_0_x - 0.017 * y_x;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double strand_11_z = layer_0_z - 0.017 * y_z;
        const double t36 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double t37 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t37;
        const double t38 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t38;
        const double t39 = 0.019 * y_z;
        const double strand_12_z = layer_0_z - t39;
        const double t40 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double t41 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t41;
        const double t42 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t42;
        const double t43 = 0.021 * y_z;
        const double strand_13_z = layer_0_z - t43;
        const double t44 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double strand_14_x = layer_0_x - 0.022 * y_x;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double strand_14_z = layer_0_z - 0.022 * y_z;
        const double t45 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double t46 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t46;
        const double t47 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t47;
        const double t48 = 0.024 * y_z;
        const double strand_15_z = layer_0_z - t48;
        const double t49 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double strand_16_x = layer_0_x - 0.025 * y_x;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double strand_16_z = layer_0_z - 0.025 * y_z;
        const double t50 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double t51 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t51;
        const double t52 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t52;
        const double t53 = 0.027 * y_z;
        const double strand_17_z = layer_0_z - t53;
        const double t54 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double t55 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t55;
        const double t56 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t56;
        const double t57 = 0.029 * y_z;
        const double strand_18_z = layer_0_z - t57;
        const double t58 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double layer_1_x = t2 + t3 + t27;
        const double layer_1_y = 0.006 - origin_y - t5 - t6 + t28;
        const double layer_1_z = 0.028 - origin_z - t8 + t9 + t29;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double strand_20_x = layer_1_x - 0.002 * y_x;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double strand_20_z = layer_1_z - 0.002 * y_z;
        const double t59 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double strand_21_x = layer_1_x - t12;
        const double strand_21_y = 0.003 + layer_1_y - t13;
        const double strand_21_z = layer_1_z - t14;
        const double t60 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double strand_22_x = layer_1_x - t16;
        const double strand_22_y = 0.005 + layer_1_y - t17;
        const double strand_22_z = layer_1_z - t18;
        const double t61 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double strand_23_x = layer_1_x - 0.007 * y_x;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double strand_23_z = layer_1_z - 0.007 * y_z;
        const double t62 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double strand_24_x = layer_1_x - t21;
        const double strand_24_y = 0.008 + layer_1_y - t22;
        const double strand_24_z = layer_1_z - t23;
        const double t63 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double strand_25_x = layer_1_x - 0.01 * y_x;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double strand_25_z = layer_1_z - 0.01 * y_z;
        const double t64 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double strand_26_x = layer_1_x - t4;
        const double strand_26_y = 0.011 + layer_1_y - t7;
        const double strand_26_z = layer_1_z - t10;
        const double t65 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double strand_27_x = layer_1_x - t27;
        const double strand_27_y = 0.013 + layer_1_y - t28;
        const double strand_27_z = layer_1_z - t29;
        const double t66 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double strand_28_x = layer_1_x - 0.015 * y_x;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double strand_28_z = layer_1_z - 0.015 * y_z;
        const double t67 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double strand_29_x = layer_1_x - t32;
        const double strand_29_y = 0.016 + layer_1_y - t33;
        const double strand_29_z = layer_1_z - t34;
        const double t68 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double strand_30_x = layer_1_x - 0.018 * y_x;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double strand_30_z = layer_1_z - 0.018 * y_z;
        const double t69 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double strand_31_x = layer_1_x - t37;
        const double strand_31_y = 0.019 + layer_1_y - t38;
        const double strand_31_z = layer_1_z - t39;
        const double t70 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double strand_32_x = layer_1_x - t41;
        const double strand_32_y = 0.021 + layer_1_y - t42;
        const double strand_32_z = layer_1_z - t43;
        const double t71 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double strand_33_x = layer_1_x - 0.023 * y_x;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double strand_33_z = layer_1_z - 0.023 * y_z;
        const double t72 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double strand_34_x = layer_1_x - t46;
        const double strand_34_y = 0.024 + layer_1_y - t47;
        const double strand_34_z = layer_1_z - t48;
        const double t73 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double strand_35_x = layer_1_x - 0.026 * y_x;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double strand_35_z = layer_1_z - 0.026 * y_z;
        const double t74 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double strand_36_x = layer_1_x - t51;
        const double strand_36_y = 0.027 + layer_1_y - t52;
        const double strand_36_z = layer_1_z - t53;
        const double t75 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double strand_37_x = layer_1_x - t55;
        const double strand_37_y = 0.029 + layer_1_y - t56;
        const double strand_37_z = layer_1_z - t57;
        const double t76 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        delta_theta[state] = 200.0 * (0.04661544808322666 - length_0);
        delta_theta[1 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t11));
        delta_theta[2 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t15));
        delta_theta[3 * n + state] = 200.0 * (0.04669047011971501 - sinew_sqrt(t19));
        delta_theta[4 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t20));
        delta_theta[5 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t24));
        delta_theta[6 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t25));
        delta_theta[7 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t26));
        delta_theta[8 * n + state] = 200.0 * (0.04669047011971501 - sinew_sqrt(t30));
        delta_theta[9 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t31));
        delta_theta[10 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t35));
        delta_theta[11 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t36));
        delta_theta[12 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t40));
        delta_theta[13 * n + state] = 200.0 * (0.04669047011971501 - sinew_sqrt(t44));
        delta_theta[14 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t45));
        delta_theta[15 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t49));
        delta_theta[16 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t50));
        delta_theta[17 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t54));
        delta_theta[18 * n + state] = 200.0 * (0.04669047011971501 - sinew_sqrt(t58));
        delta_theta[19 * n + state] = 200.0 * (0.046561786907291264 - length_19);
        delta_theta[20 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t59));
        delta_theta[21 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t60));
        delta_theta[22 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t61));
        delta_theta[23 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t62));
        delta_theta[24 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t63));
        delta_theta[25 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t64));
        delta_theta[26 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t65));
        delta_theta[27 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t66));
        delta_theta[28 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t67));
        delta_theta[29 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t68));
        delta_theta[30 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t69));
        delta_theta[31 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t70));
        delta_theta[32 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t71));
        delta_theta[33 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t72));
        delta_theta[34 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t73));
        delta_theta[35 * n + state] = 200.0 * (0.04661544808322666 - sinew_sqrt(t74));
        delta_theta[36 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t75));
        delta_theta[37 * n + state] = 200.0 * (0.046561786907291264 - sinew_sqrt(t76));
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
        const double t17 = 0.011 * y_x_by_t;
        const double layer_0_x_by_t = t15 + t16 - t17;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double t18 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * (cos_q71 * x_plane_x
            + sin_q71 * cos_A);
        const double t19 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double t20 = 0.011 * y_x;
        const double layer_0_x = t18 - t19 + t20;
        const double z_plane_y_by_t = u_e * cos_A_by_t + cos_A * u_e_by_t;
        const double t21 = M_y_by_t - 0.018 * z_plane_y_by_t - 0.004 * (u_e * sin_A_by_t + sin_A
            * u_e_by_t);
        const double t22 = 0.01 * z_plane_y_by_t;
        const double t23 = 0.011 * u_y_by_t;
        const double layer_0_y_by_t = t21 + t22 - t23;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t24 = 0.004 * (u_e * sin_A);
        const double t25 = 0.01 * z_plane_y;
        const double t26 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t24 + t25 + t26;
        const double z_z_by_t = cos_q71 * sin_A_by_t + sin_q71 * z_plane_x_by_t - sin_A
            * cos_q71_by_t + z_plane_x * sin_q71_by_t;
        const double origin_z_by_t = sin_q71 * M_e_by_t + M_e * sin_q71_by_t - 0.018 * z_z_by_t;
        const double x_z_by_t = cos_q71 * cos_A_by_t - sin_q71 * x_plane_x_by_t - cos_A
            * cos_q71_by_t - x_plane_x * sin_q71_by_t;
        const double t27 = origin_z_by_t + 0.004 * x_z_by_t;
        const double t28 = 0.01 * z_z_by_t;
        const double y_z_by_t = sin_q71 * u_e_by_t + u_e * sin_q71_by_t;
        const double t29 = 0.011 * y_z_by_t;
        const double layer_0_z_by_t = t27 + t28 - t29;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double t30 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double t31 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double t32 = 0.011 * y_z;
        const double layer_0_z = 0.008 - origin_z - t30 - t31 + t32;
        const double t33 = layer_0_x * layer_0_x_by_t - layer_0_y * layer_0_y_by_t + layer_0_z
            * layer_0_z_by_t;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double strand_1_x = layer_0_x - 0.001 * y_x;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double t34 = strand_1_x * (layer_0_x_by_t + 0.001 * y_x_by_t) - strand_1_y
            * (layer_0_y_by_t + 0.001 * u_y_by_t);
        const double strand_1_z = layer_0_z - 0.001 * y_z;
        const double t35 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1_by_t = (t34 + strand_1_z * (layer_0_z_by_t + 0.001 * y_z_by_t))
            / sinew_sqrt(t35);
        const double t36 = 0.003 * y_x_by_t;
        const double t37 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t37;
        const double t38 = 0.003 * u_y_by_t;
        const double t39 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t39;
        const double t40 = strand_2_x * (layer_0_x_by_t + t36) - strand_2_y * (layer_0_y_by_t
            + t38);
        const double t41 = 0.003 * y_z_by_t;
        const double t42 = 0.003 * y_z;
        const double strand_2_z = layer_0_z - t42;
        const double t43 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2_by_t = (t40 + strand_2_z * (layer_0_z_by_t + t41)) / sinew_sqrt(t43);
        const double t44 = 0.005 * y_x_by_t;
        const double t45 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t45;
        const double t46 = 0.005 * u_y_by_t;
        const double t47 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t47;
        const double t48 = strand_3_x * (layer_0_x_by_t + t44) - strand_3_y * (layer_0_y_by_t
            + t46);
        const double t49 = 0.005 * y_z_by_t;
        const double t50 = 0.005 * y_z;
        const double strand_3_z = layer_0_z - t50;
        const double t51 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3_by_t = (t48 + strand_3_z * (layer_0_z_by_t + t49)) / sinew_sqrt(t51);
        const double strand_4_x = layer_0_x - 0.006 * y_x;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double t52 = strand_4_x * (layer_0_x_by_t + 0.006 * y_x_by_t) - strand_4_y
            * (layer_0_y_by_t + 0.006 * u_y_by_t);
        const double strand_4_z = layer_0_z - 0.006 * y_z;
        const double t53 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4_by_t = (t52 + strand_4_z * (layer_0_z_by_t + 0.006 * y_z_by_t))
            / sinew_sqrt(t53);
        const double t54 = 0.008 * y_x_by_t;
        const double t55 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t55;
        const double t56 = 0.008 * u_y_by_t;
        const double t57 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t57;
        const double t58 = strand_5_x * (layer_0_x_by_t + t54) - strand_5_y * (layer_0_y_by_t
            + t56);
        const double t59 = 0.008 * y_z_by_t;
        const double t60 = 0.008 * y_z;
        const double strand_5_z = layer_0_z - t60;
        const double t61 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5_by_t = (t58 + strand_5_z * (layer_0_z_by_t + t59)) / sinew_sqrt(t61);
        const double strand_6_x = layer_0_x - 0.009 * y_x;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double t62 = strand_6_x * (layer_0_x_by_t + 0.009 * y_x_by_t) - strand_6_y
            * (layer_0_y_by_t + 0.009 * u_y_by_t);
        const double strand_6_z = layer_0_z - 0.009 * y_z;
        const double t63 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6_by_t = (t62 + strand_6_z * (layer_0_z_by_t + 0.009 * y_z_by_t))
            / sinew_sqrt(t63);
        const double strand_7_x = layer_0_x - t20;
        const double strand_7_y = 0.011 + layer_0_y - t26;
        const double t64 = strand_7_x * (layer_0_x_by_t + t17) - strand_7_y * (layer_0_y_by_t
            + t23);
        const double strand_7_z = layer_0_z - t32;
        const double t65 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double length_7_by_t = (t64 + strand_7_z * (layer_0_z_by_t + t29)) / sinew_sqrt(t65);
        const double t66 = 0.013 * y_x_by_t;
        const double t67 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t67;
        const double t68 = 0.013 * u_y_by_t;
        const double t69 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t69;
        const double t70 = strand_8_x * (layer_0_x_by_t + t66) - strand_8_y * (layer_0_y_by_t
            + t68);
        const double t71 = 0.013 * y_z_by_t;
        const double t72 = 0.013 * y_z;
        const double strand_8_z = layer_0_z - t72;
        const double t73 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8_by_t = (t70 + strand_8_z * (layer_0_z_by_t + t71)) / sinew_sqrt(t73);
        const double strand_9_x = layer_0_x - 0.014 * y_x;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double t74 = strand_9_x * (layer_0_x_by_t + 0.014 * y_x_by_t) - strand_9_y
            * (layer_0_y_by_t + 0.014 * u_y_by_t);
        const double strand_9_z = layer_0_z - 0.014 * y_z;
        const double t75 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9_by_t = (t74 + strand_9_z * (layer_0_z_by_t + 0.014 * y_z_by_t))
            / sinew_sqrt(t75);
        const double t76 = 0.016 * y_x_by_t;
        const double t77 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t77;
        const double t78 = 0.016 * u_y_by_t;
        const double t79 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t79;
        const double t80 = strand_10_x * (layer_0_x_by_t + t76) - strand_10_y * (layer_0_y_by_t
            + t78);
        const double t81 = 0.016 * y_z_by_t;
        const double t82 = 0.016 * y_z;
        const double strand_10_z = layer_0_z - t82;
        const double t83 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10_by_t = (t80 + strand_10_z * (layer_0_z_by_t + t81))
            / sinew_sqrt(t83);
        const double strand_11_x = layer_0_x - 0.017 * y_x;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double t84 = strand_11_x * (layer_0_x_by_t + 0.017 * y_x_by_t) - strand_11_y
            * (layer_0_y_by_t + 0.017 * u_y_by_t);
        const double strand_11_z = layer_0_z - 0.017 * y_z;
        const double t85 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11_by_t = (t84 + strand_11_z * (layer_0_z_by_t + 0.017 * y_z_by_t))
            / sinew_sqrt(t85);
        const double t86 = 0.019 * y_x_by_t;
        const double t87 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t87;
        const double t88 = 0.019 * u_y_by_t;
        const double t89 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t89;
        const double t90 = strand_12_x * (layer_0_x_by_t + t86) - strand_12_y * (layer_0_y_by_t
            + t88);
        const double t91 = 0.019 * y_z_by_t;
        const double t92 = 0.019 * y_z;
        const double strand_12_z = layer_0_z - t92;
        const double t93 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12_by_t = (t90 + strand_12_z * (layer_0_z_by_t + t91))
            / sinew_sqrt(t93);
        const double t94 = 0.021 * y_x_by_t;
        const double t95 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t95;
        const double t96 = 0.021 * u_y_by_t;
        const double t97 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t97;
        const double t98 = strand_13_x * (layer_0_x_by_t + t94) - strand_13_y * (layer_0_y_by_t
            + t96);
        const double t99 = 0.021 * y_z_by_t;
        const double t100 = 0.021 * y_z;
        const double strand_13_z = layer_0_z - t100;
        const double t101 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13_by_t = (t98 + strand_13_z * (layer_0_z_by_t + t99))
            / sinew_sqrt(t101);
        const double strand_14_x = layer_0_x - 0.022 * y_x;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double t102 = strand_14_x * (layer_0_x_by_t + 0.022 * y_x_by_t) - strand_14_y
            * (layer_0_y_by_t + 0.022 * u_y_by_t);
        const double strand_14_z = layer_0_z - 0.022 * y_z;
        const double t103 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14_by_t = (t102 + strand_14_z * (layer_0_z_by_t + 0.022 * y_z_by_t))
            / sinew_sqrt(t103);
        const double t104 = 0.024 * y_x_by_t;
        const double t105 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t105;
        const double t106 = 0.024 * u_y_by_t;
        const double t107 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t107;
        const double t108 = strand_15_x * (layer_0_x_by_t + t104) - strand_15_y * (layer_0_y_by_t
            + t106);
        const double t109 = 0.024 * y_z_by_t;
        const double t110 = 0.024 * y_z;
        const double strand_15_z = layer_0_z - t110;
        const double t111 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15_by_t = (t108 + strand_15_z * (layer_0_z_by_t + t109))
            / sinew_sqrt(t111);
        const double strand_16_x = layer_0_x - 0.025 * y_x;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double t112 = strand_16_x * (layer_0_x_by_t + 0.025 * y_x_by_t) - strand_16_y
            * (layer_0_y_by_t + 0.025 * u_y_by_t);
        const double strand_16_z = layer_0_z - 0.025 * y_z;
        const double t113 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16_by_t = (t112 + strand_16_z * (layer_0_z_by_t + 0.025 * y_z_by_t))
            / sinew_sqrt(t113);
        const double t114 = 0.027 * y_x_by_t;
        const double t115 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t115;
        const double t116 = 0.027 * u_y_by_t;
        const double t117 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t117;
        const double t118 = strand_17_x * (layer_0_x_by_t + t114) - strand_17_y * (layer_0_y_by_t
            + t116);
        const double t119 = 0.027 * y_z_by_t;
        const double t120 = 0.027 * y_z;
        const double strand_17_z = layer_0_z - t120;
        const double t121 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17_by_t = (t118 + strand_17_z * (layer_0_z_by_t + t119))
            / sinew_sqrt(t121);
        const double t122 = 0.029 * y_x_by_t;
        const double t123 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t123;
        const double t124 = 0.029 * u_y_by_t;
        const double t125 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t125;
        const double t126 = strand_18_x * (layer_0_x_by_t + t122) - strand_18_y * (layer_0_y_by_t
            + t124);
        const double t127 = 0.029 * y_z_by_t;
        const double t128 = 0.029 * y_z;
        const double strand_18_z = layer_0_z - t128;
        const double t129 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18_by_t = (t126 + strand_18_z * (layer_0_z_by_t + t127))
            / sinew_sqrt(t129);
        const double layer_1_x_by_t = t15 - t16 - t66;
        const double layer_1_x = t18 + t19 + t67;
        const double layer_1_y_by_t = t21 - t22 - t68;
        const double layer_1_y = 0.006 - origin_y - t24 - t25 + t69;
        const double layer_1_z_by_t = t27 - t28 - t71;
        const double layer_1_z = 0.028 - origin_z - t30 + t31 + t72;
        const double t130 = layer_1_x * layer_1_x_by_t - layer_1_y * layer_1_y_by_t + layer_1_z
            * layer_1_z_by_t;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double strand_20_x = layer_1_x - 0.002 * y_x;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double t131 = strand_20_x * (layer_1_x_by_t + 0.002 * y_x_by_t) - strand_20_y
            * (layer_1_y_by_t + 0.002 * u_y_by_t);
        const double strand_20_z = layer_1_z - 0.002 * y_z;
        const double t132 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20_by_t = (t131 + strand_20_z * (layer_1_z_by_t + 0.002 * y_z_by_t))
            / sinew_sqrt(t132);
        const double strand_21_x = layer_1_x - t37;
        const double strand_21_y = 0.003 + layer_1_y - t39;
        const double t133 = strand_21_x * (layer_1_x_by_t + t36) - strand_21_y * (layer_1_y_by_t
            + t38);
        const double strand_21_z = layer_1_z - t42;
        const double t134 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21_by_t = (t133 + strand_21_z * (layer_1_z_by_t + t41))
            / sinew_sqrt(t134);
        const double strand_22_x = layer_1_x - t45;
        const double strand_22_y = 0.005 + layer_1_y - t47;
        const double t135 = strand_22_x * (layer_1_x_by_t + t44) - strand_22_y * (layer_1_y_by_t
            + t46);
        const double strand_22_z = layer_1_z - t50;
        const double t136 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22_by_t = (t135 + strand_22_z * (layer_1_z_by_t + t49))
            / sinew_sqrt(t136);
        const double strand_23_x = layer_1_x - 0.007 * y_x;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double t137 = strand_23_x * (layer_1_x_by_t + 0.007 * y_x_by_t) - strand_23_y
            * (layer_1_y_by_t + 0.007 * u_y_by_t);
        const double strand_23_z = layer_1_z - 0.007 * y_z;
        const double t138 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23_by_t = (t137 + strand_23_z * (layer_1_z_by_t + 0.007 * y_z_by_t))
            / sinew_sqrt(t138);
        const double strand_24_x = layer_1_x - t55;
        const double strand_24_y = 0.008 + layer_1_y - t57;
        const double t139 = strand_24_x * (layer_1_x_by_t + t54) - strand_24_y * (layer_1_y_by_t
            + t56);
        const double strand_24_z = layer_1_z - t60;
        const double t140 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24_by_t = (t139 + strand_24_z * (layer_1_z_by_t + t59))
            / sinew_sqrt(t140);
        const double strand_25_x = layer_1_x - 0.01 * y_x;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double t141 = strand_25_x * (layer_1_x_by_t + 0.01 * y_x_by_t) - strand_25_y
            * (layer_1_y_by_t + 0.01 * u_y_by_t);
        const double strand_25_z = layer_1_z - 0.01 * y_z;
        const double t142 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25_by_t = (t141 + strand_25_z * (layer_1_z_by_t + 0.01 * y_z_by_t))
            / sinew_sqrt(t142);
        const double strand_26_x = layer_1_x - t20;
        const double strand_26_y = 0.011 + layer_1_y - t26;
        const double t143 = strand_26_x * (layer_1_x_by_t + t17) - strand_26_y * (layer_1_y_by_t
            + t23);
        const double strand_26_z = layer_1_z - t32;
        const double t144 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26_by_t = (t143 + strand_26_z * (layer_1_z_by_t + t29))
            / sinew_sqrt(t144);
        const double strand_27_x = layer_1_x - t67;
        const double strand_27_y = 0.013 + layer_1_y - t69;
        const double t145 = strand_27_x * (layer_1_x_by_t + t66) - strand_27_y * (layer_1_y_by_t
            + t68);
        const double strand_27_z = layer_1_z - t72;
        const double t146 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double length_27_by_t = (t145 + strand_27_z * (layer_1_z_by_t + t71))
            / sinew_sqrt(t146);
        const double strand_28_x = layer_1_x - 0.015 * y_x;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double t147 = strand_28_x * (layer_1_x_by_t + 0.015 * y_x_by_t) - strand_28_y
            * (layer_1_y_by_t + 0.015 * u_y_by_t);
        const double strand_28_z = layer_1_z - 0.015 * y_z;
        const double t148 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28_by_t = (t147 + strand_28_z * (layer_1_z_by_t + 0.015 * y_z_by_t))
            / sinew_sqrt(t148);
        const double strand_29_x = layer_1_x - t77;
        const double strand_29_y = 0.016 + layer_1_y - t79;
        const double t149 = strand_29_x * (layer_1_x_by_t + t76) - strand_29_y * (layer_1_y_by_t
            + t78);
        const double strand_29_z = layer_1_z - t82;
        const double t150 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29_by_t = (t149 + strand_29_z * (layer_1_z_by_t + t81))
            / sinew_sqrt(t150);
        const double strand_30_x = layer_1_x - 0.018 * y_x;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double t151 = strand_30_x * (layer_1_x_by_t + 0.018 * y_x_by_t) - strand_30_y
            * (layer_1_y_by_t + 0.018 * u_y_by_t);
        const double strand_30_z = layer_1_z - 0.018 * y_z;
        const double t152 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30_by_t = (t151 + strand_30_z * (layer_1_z_by_t + 0.018 * y_z_by_t))
            / sinew_sqrt(t152);
        const double strand_31_x = layer_1_x - t87;
        const double strand_31_y = 0.019 + layer_1_y - t89;
        const double t153 = strand_31_x * (layer_1_x_by_t + t86) - strand_31_y * (layer_1_y_by_t
            + t88);
        const double strand_31_z = layer_1_z - t92;
        const double t154 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31_by_t = (t153 + strand_31_z * (layer_1_z_by_t + t91))
            / sinew_sqrt(t154);
        const double strand_32_x = layer_1_x - t95;
        const double strand_32_y = 0.021 + layer_1_y - t97;
        const double t155 = strand_32_x * (layer_1_x_by_t + t94) - strand_32_y * (layer_1_y_by_t
            + t96);
        const double strand_32_z = layer_1_z - t100;
        const double t156 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32_by_t = (t155 + strand_32_z * (layer_1_z_by_t + t99))
            / sinew_sqrt(t156);
        const double strand_33_x = layer_1_x - 0.023 * y_x;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double t157 = strand_33_x * (layer_1_x_by_t + 0.023 * y_x_by_t) - strand_33_y
            * (layer_1_y_by_t + 0.023 * u_y_by_t);
        const double strand_33_z = layer_1_z - 0.023 * y_z;
        const double t158 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33_by_t = (t157 + strand_33_z * (layer_1_z_by_t + 0.023 * y_z_by_t))
            / sinew_sqrt(t158);
        const double strand_34_x = layer_1_x - t105;
        const double strand_34_y = 0.024 + layer_1_y - t107;
        const double t159 = strand_34_x * (layer_1_x_by_t + t104) - strand_34_y * (layer_1_y_by_t
            + t106);
        const double strand_34_z = layer_1_z - t110;
        const double t160 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34_by_t = (t159 + strand_34_z * (layer_1_z_by_t + t109))
            / sinew_sqrt(t160);
        const double strand_35_x = layer_1_x - 0.026 * y_x;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double t161 = strand_35_x * (layer_1_x_by_t + 0.026 * y_x_by_t) - strand_35_y
            * (layer_1_y_by_t + 0.026 * u_y_by_t);
        const double strand_35_z = layer_1_z - 0.026 * y_z;
        const double t162 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35_by_t = (t161 + strand_35_z * (layer_1_z_by_t + 0.026 * y_z_by_t))
            / sinew_sqrt(t162);
        const double strand_36_x = layer_1_x - t115;
        const double strand_36_y = 0.027 + layer_1_y - t117;
        const double t163 = strand_36_x * (layer_1_x_by_t + t114) - strand_36_y * (layer_1_y_by_t
            + t116);
        const double strand_36_z = layer_1_z - t120;
        const double t164 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36_by_t = (t163 + strand_36_z * (layer_1_z_by_t + t119))
            / sinew_sqrt(t164);
        const double strand_37_x = layer_1_x - t123;
        const double strand_37_y = 0.029 + layer_1_y - t125;
        const double t165 = strand_37_x * (layer_1_x_by_t + t122) - strand_37_y * (layer_1_y_by_t
            + t124);
        const double strand_37_z = layer_1_z - t128;
        const double t166 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37_by_t = (t165 + strand_37_z * (layer_1_z_by_t + t127))
            / sinew_sqrt(t166);
        delta_theta_rate[state] = 200.0 * (t33 / length_0);
        delta_theta_rate[1 * n + state] = 200.0 * length_1_by_t;
        delta_theta_rate[2 * n + state] = 200.0 * length_2_by_t;
        delta_theta_rate[3 * n + state] = 200.0 * length_3_by_t;
        delta_theta_rate[4 * n + state] = 200.0 * length_4_by_t;
        delta_theta_rate[5 * n + state] = 200.0 * length_5_by_t;
        delta_theta_rate[6 * n + state] = 200.0 * length_6_by_t;
        delta_theta_rate[7 * n + state] = 200.0 * length_7_by_t;
        delta_theta_rate[8 * n + state] = 200.0 * length_8_by_t;
        delta_theta_rate[9 * n + state] = 200.0 * length_9_by_t;
        delta_theta_rate[10 * n + state] = 200.0 * length_10_by_t;
        delta_theta_rate[11 * n + state] = 200.0 * length_11_by_t;
        delta_theta_rate[12 * n + state] = 200.0 * length_12_by_t;
        delta_theta_rate[13 * n + state] = 200.0 * length_13_by_t;
        delta_theta_rate[14 * n + state] = 200.0 * length_14_by_t;
        delta_theta_rate[15 * n + state] = 200.0 * length_15_by_t;
        delta_theta_rate[16 * n + state] = 200.0 * length_16_by_t;
        delta_theta_rate[17 * n + state] = 200.0 * length_17_by_t;
        delta_theta_rate[18 * n + state] = 200.0 * length_18_by_t;
        delta_theta_rate[19 * n + state] = 200.0 * (t130 / length_19);
        delta_theta_rate[20 * n + state] = 200.0 * length_20_by_t;
        delta_theta_rate[21 * n + state] = 200.0 * length_21_by_t;
        delta_theta_rate[22 * n + state] = 200.0 * length_22_by_t;
        delta_theta_rate[23 * n + state] = 200.0 * length_23_by_t;
        delta_theta_rate[24 * n + state] = 200.0 * length_24_by_t;
        delta_theta_rate[25 * n + state] = 200.0 * length_25_by_t;
        delta_theta_rate[26 * n + state] = 200.0 * length_26_by_t;
        delta_theta_rate[27 * n + state] = 200.0 * length_27_by_t;
        delta_theta_rate[28 * n + state] = 200.0 * length_28_by_t;
        delta_theta_rate[29 * n + state] = 200.0 * length_29_by_t;
        delta_theta_rate[30 * n + state] = 200.0 * length_30_by_t;
        delta_theta_rate[31 * n + state] = 200.0 * length_31_by_t;
        delta_theta_rate[32 * n + state] = 200.0 * length_32_by_t;
        delta_theta_rate[33 * n + state] = 200.0 * length_33_by_t;
        delta_theta_rate[34 * n + state] = 200.0 * length_34_by_t;
        delta_theta_rate[35 * n + state] = 200.0 * length_35_by_t;
        delta_theta_rate[36 * n + state] = 200.0 * length_36_by_t;
        delta_theta_rate[37 * n + state] = 200.0 * length_37_by_t;
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
        const double t29 = 0.029 * y_x;
        const double t30 = 0.011 * y_x;
        const double t31 = sin_q71 * sin_A;
        const double z_plane_x = u_y * cos_A;
        const double t32 = cos_q71 * z_plane_x;
        const double z_x = t32 - t31;
        const double t33 = 0.01 * z_x;
        const double t34 = sin_q71 * cos_A;
        const double x_plane_x = u_y * sin_A;
        const double t35 = cos_q71 * x_plane_x;
        const double M_x = cos_q71 * M_e;
        const double t36 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t35 + t34);
        const double layer_0_x = t36 - t33 + t30;
        const double strand_18_x = layer_0_x - t29;
        const double y_z = sin_q71 * u_e;
        const double t37 = 0.029 * y_z;
        const double t38 = 0.011 * y_z;
        const double t39 = cos_q71 * sin_A;
        const double t40 = sin_q71 * z_plane_x;
        const double z_z = t39 + t40;
        const double t41 = 0.01 * z_z;
        const double t42 = cos_q71 * cos_A;
        const double t43 = sin_q71 * x_plane_x;
        const double t44 = 0.004 * (t42 - t43);
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double layer_0_z = 0.008 - origin_z - t44 - t41 + t38;
        const double strand_18_z = layer_0_z - t37;
        const double t45 = 0.029 * u_y;
        const double t46 = 0.011 * u_y;
        const double z_plane_y = u_e * cos_A;
        const double t47 = 0.01 * z_plane_y;
        const double t48 = 0.004 * (u_e * sin_A);
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double layer_0_y = 0.007 - origin_y - t48 + t47 + t46;
        const double strand_18_y = 0.028 + layer_0_y - t45;
        const double t49 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double per_length_18 = f[18 * n + state] / sinew_sqrt(t49);
        const double t50 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t50;
        const double t51 = 0.027 * y_z;
        const double strand_17_z = layer_0_z - t51;
        const double t52 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t52;
        const double t53 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double per_length_17 = f[17 * n + state] / sinew_sqrt(t53);
        const double strand_16_x = layer_0_x - 0.025 * y_x;
        const double strand_16_z = layer_0_z - 0.025 * y_z;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double t54 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double per_length_16 = f[16 * n + state] / sinew_sqrt(t54);
        const double t55 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t55;
        const double t56 = 0.024 * y_z;
        const double strand_15_z = layer_0_z - t56;
        const double t57 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t57;
        const double t58 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double per_length_15 = f[15 * n + state] / sinew_sqrt(t58);
        const double strand_14_x = layer_0_x - 0.022 * y_x;
        const double strand_14_z = layer_0_z - 0.022 * y_z;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double t59 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double per_length_14 = f[14 * n + state] / sinew_sqrt(t59);
        const double t60 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t60;
        const double t61 = 0.021 * y_z;
        const double strand_13_z = layer_0_z - t61;
        const double t62 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t62;
        const double t63 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double per_length_13 = f[13 * n + state] / sinew_sqrt(t63);
        const double t64 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t64;
        const double t65 = 0.019 * y_z;
        const double strand_12_z = layer_0_z - t65;
        const double t66 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t66;
        const double t67 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double per_length_12 = f[12 * n + state] / sinew_sqrt(t67);
        const double strand_11_x = layer_0_x - 0.017 * y_x;
        const double strand_11_z = layer_0_z - 0.017 * y_z;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double t68 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double per_length_11 = f[11 * n + state] / sinew_sqrt(t68);
        const double t69 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t69;
        const double t70 = 0.016 * y_z;
        const double strand_10_z = layer_0_z - t70;
        const double t71 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t71;
        const double t72 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double per_length_10 = f[10 * n + state] / sinew_sqrt(t72);
        const double strand_9_x = layer_0_x - 0.014 * y_x;
        const double strand_9_z = layer_0_z - 0.014 * y_z;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double t73 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double per_length_9 = f[9 * n + state] / sinew_sqrt(t73);
        const double t74 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t74;
        const double t75 = 0.013 * y_z;
        const double strand_8_z = layer_0_z - t75;
        const double t76 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t76;
        const double t77 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double per_length_8 = f[8 * n + state] / sinew_sqrt(t77);
        const double strand_7_x = layer_0_x - t30;
        const double strand_7_z = layer_0_z - t38;
        const double strand_7_y = 0.011 + layer_0_y - t46;
        const double t78 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double per_length_7 = f[7 * n + state] / sinew_sqrt(t78);
        const double strand_6_x = layer_0_x - 0.009 * y_x;
        const double strand_6_z = layer_0_z - 0.009 * y_z;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double t79 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double per_length_6 = f[6 * n + state] / sinew_sqrt(t79);
        const double t80 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t80;
        const double t81 = 0.008 * y_z;
        const double strand_5_z = layer_0_z - t81;
        const double t82 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t82;
        const double t83 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double per_length_5 = f[5 * n + state] / sinew_sqrt(t83);
        const double strand_4_x = layer_0_x - 0.006 * y_x;
        const double strand_4_z = layer_0_z - 0.006 * y_z;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double t84 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double per_length_4 = f[4 * n + state] / sinew_sqrt(t84);
        const double t85 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t85;
        const double t86 = 0.005 * y_z;
        const double strand_3_z = layer_0_z - t86;
        const double t87 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t87;
        const double t88 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double per_length_3 = f[3 * n + state] / sinew_sqrt(t88);
        const double t89 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t89;
        const double t90 = 0.003 * y_z;
        const double strand_2_z = layer_0_z - t90;
        const double t91 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t91;
        const double t92 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double per_length_2 = f[2 * n + state] / sinew_sqrt(t92);
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double per_length_0 = f[state] / length_0;
        const double strand_1_x = layer_0_x - 0.001 * y_x;
        const double strand_1_z = layer_0_z - 0.001 * y_z;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double t93 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double per_length_1 = f[1 * n + state] / sinew_sqrt(t93);
        const double t94 = layer_0_x * per_length_0 + strand_1_x * per_length_1 + strand_2_x
            * per_length_2;
        const double t95 = t94 + strand_3_x * per_length_3 + strand_4_x * per_length_4 + strand_5_x
            * per_length_5;
        const double t96 = t95 + strand_6_x * per_length_6 + strand_7_x * per_length_7 + strand_8_x
            * per_length_8;
        const double t97 = t96 + strand_9_x * per_length_9 + strand_10_x * per_length_10
            + strand_11_x * per_length_11;
        const double t98 = t97 + strand_12_x * per_length_12 + strand_13_x * per_length_13
            + strand_14_x * per_length_14;
        const double t99 = t98 + strand_15_x * per_length_15 + strand_16_x * per_length_16
            + strand_17_x * per_length_17;
        const double pull_x = t99 + strand_18_x * per_length_18;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t100 = 0.01 * z_plane_y_by_q73;
        const double t101 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t102 = layer_0_y * per_length_0 + strand_1_y * per_length_1 + strand_2_y
            * per_length_2;
        const double t103 = t102 + strand_3_y * per_length_3 + strand_4_y * per_length_4
            + strand_5_y * per_length_5;
        const double t104 = t103 + strand_6_y * per_length_6 + strand_7_y * per_length_7
            + strand_8_y * per_length_8;
        const double t105 = t104 + strand_9_y * per_length_9 + strand_10_y * per_length_10
            + strand_11_y * per_length_11;
        const double t106 = t105 + strand_12_y * per_length_12 + strand_13_y * per_length_13
            + strand_14_y * per_length_14;
        const double t107 = t106 + strand_15_y * per_length_15 + strand_16_y * per_length_16
            + strand_17_y * per_length_17;
        const double pull_y = t107 + strand_18_y * per_length_18;
        const double t108 = pull_x * (t28 + t27 - 0.011 * y_x_by_q73) - pull_y * (t101 + t100
            - 0.011 * u_y_by_q73);
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double t109 = 0.01 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double t110 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t111 = layer_0_z * per_length_0 + strand_1_z * per_length_1 + strand_2_z
            * per_length_2;
        const double t112 = t111 + strand_3_z * per_length_3 + strand_4_z * per_length_4
            + strand_5_z * per_length_5;
        const double t113 = t112 + strand_6_z * per_length_6 + strand_7_z * per_length_7
            + strand_8_z * per_length_8;
        const double t114 = t113 + strand_9_z * per_length_9 + strand_10_z * per_length_10
            + strand_11_z * per_length_11;
        const double t115 = t114 + strand_12_z * per_length_12 + strand_13_z * per_length_13
            + strand_14_z * per_length_14;
        const double t116 = t115 + strand_15_z * per_length_15 + strand_16_z * per_length_16
            + strand_17_z * per_length_17;
        const double pull_z = t116 + strand_18_z * per_length_18;
        const double layer_1_x = t36 + t33 + t74;
        const double strand_37_x = layer_1_x - t29;
        const double layer_1_z = 0.028 - origin_z - t44 + t41 + t75;
        const double strand_37_z = layer_1_z - t37;
        const double layer_1_y = 0.006 - origin_y - t48 - t47 + t76;
        const double strand_37_y = 0.029 + layer_1_y - t45;
        const double t117 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double per_length_37 = f[37 * n + state] / sinew_sqrt(t117);
        const double strand_36_x = layer_1_x - t50;
        const double strand_36_z = layer_1_z - t51;
        const double strand_36_y = 0.027 + layer_1_y - t52;
        const double t118 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double per_length_36 = f[36 * n + state] / sinew_sqrt(t118);
        const double strand_35_x = layer_1_x - 0.026 * y_x;
        const double strand_35_z = layer_1_z - 0.026 * y_z;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double t119 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double per_length_35 = f[35 * n + state] / sinew_sqrt(t119);
        const double strand_34_x = layer_1_x - t55;
        const double strand_34_z = layer_1_z - t56;
        const double strand_34_y = 0.024 + layer_1_y - t57;
        const double t120 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double per_length_34 = f[34 * n + state] / sinew_sqrt(t120);
        const double strand_33_x = layer_1_x - 0.023 * y_x;
        const double strand_33_z = layer_1_z - 0.023 * y_z;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double t121 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double per_length_33 = f[33 * n + state] / sinew_sqrt(t121);
        const double strand_32_x = layer_1_x - t60;
        const double strand_32_z = layer_1_z - t61;
        const double strand_32_y = 0.021 + layer_1_y - t62;
        const double t122 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double per_length_32 = f[32 * n + state] / sinew_sqrt(t122);
        const double strand_31_x = layer_1_x - t64;
        const double strand_31_z = layer_1_z - t65;
        const double strand_31_y = 0.019 + layer_1_y - t66;
        const double t123 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double per_length_31 = f[31 * n + state] / sinew_sqrt(t123);
        const double strand_30_x = layer_1_x - 0.018 * y_x;
        const double strand_30_z = layer_1_z - 0.018 * y_z;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double t124 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double per_length_30 = f[30 * n + state] / sinew_sqrt(t124);
        const double strand_29_x = layer_1_x - t69;
        const double strand_29_z = layer_1_z - t70;
        const double strand_29_y = 0.016 + layer_1_y - t71;
        const double t125 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double per_length_29 = f[29 * n + state] / sinew_sqrt(t125);
        const double strand_28_x = layer_1_x - 0.015 * y_x;
        const double strand_28_z = layer_1_z - 0.015 * y_z;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double t126 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double per_length_28 = f[28 * n + state] / sinew_sqrt(t126);
        const double strand_27_x = layer_1_x - t74;
        const double strand_27_z = layer_1_z - t75;
        const double strand_27_y = 0.013 + layer_1_y - t76;
        const double t127 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double per_length_27 = f[27 * n + state] / sinew_sqrt(t127);
        const double strand_26_x = layer_1_x - t30;
        const double strand_26_z = layer_1_z - t38;
        const double strand_26_y = 0.011 + layer_1_y - t46;
        const double t128 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double per_length_26 = f[26 * n + state] / sinew_sqrt(t128);
        const double strand_25_x = layer_1_x - 0.01 * y_x;
        const double strand_25_z = layer_1_z - 0.01 * y_z;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double t129 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double per_length_25 = f[25 * n + state] / sinew_sqrt(t129);
        const double strand_24_x = layer_1_x - t80;
        const double strand_24_z = layer_1_z - t81;
        const double strand_24_y = 0.008 + layer_1_y - t82;
        const double t130 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double per_length_24 = f[24 * n + state] / sinew_sqrt(t130);
        const double strand_23_x = layer_1_x - 0.007 * y_x;
        const double strand_23_z = layer_1_z - 0.007 * y_z;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double t131 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double per_length_23 = f[23 * n + state] / sinew_sqrt(t131);
        const double strand_22_x = layer_1_x - t85;
        const double strand_22_z = layer_1_z - t86;
        const double strand_22_y = 0.005 + layer_1_y - t87;
        const double t132 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double per_length_22 = f[22 * n + state] / sinew_sqrt(t132);
        const double strand_21_x = layer_1_x - t89;
        const double strand_21_z = layer_1_z - t90;
        const double strand_21_y = 0.003 + layer_1_y - t91;
        const double t133 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double per_length_21 = f[21 * n + state] / sinew_sqrt(t133);
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double per_length_19 = f[19 * n + state] / length_19;
        const double strand_20_x = layer_1_x - 0.002 * y_x;
        const double strand_20_z = layer_1_z - 0.002 * y_z;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double t134 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double per_length_20 = f[20 * n + state] / sinew_sqrt(t134);
        const double t135 = layer_1_x * per_length_19 + strand_20_x * per_length_20 + strand_21_x
            * per_length_21;
        const double t136 = t135 + strand_22_x * per_length_22 + strand_23_x * per_length_23
            + strand_24_x * per_length_24;
        const double t137 = t136 + strand_25_x * per_length_25 + strand_26_x * per_length_26
            + strand_27_x * per_length_27;
        const double t138 = t137 + strand_28_x * per_length_28 + strand_29_x * per_length_29
            + strand_30_x * per_length_30;
        const double t139 = t138 + strand_31_x * per_length_31 + strand_32_x * per_length_32
            + strand_33_x * per_length_33;
        const double t140 = t139 + strand_34_x * per_length_34 + strand_35_x * per_length_35
            + strand_36_x * per_length_36;
        const double pull_x_2 = t140 + strand_37_x * per_length_37;
        const double t141 = t108 + pull_z * (t110 + t109 - 0.011 * y_z_by_q73) + pull_x_2 * (t28
            - t27 - 0.013 * y_x_by_q73);
        const double t142 = layer_1_y * per_length_19 + strand_20_y * per_length_20 + strand_21_y
            * per_length_21;
        const double t143 = t142 + strand_22_y * per_length_22 + strand_23_y * per_length_23
            + strand_24_y * per_length_24;
        const double t144 = t143 + strand_25_y * per_length_25 + strand_26_y * per_length_26
            + strand_27_y * per_length_27;
        const double t145 = t144 + strand_28_y * per_length_28 + strand_29_y * per_length_29
            + strand_30_y * per_length_30;
        const double t146 = t145 + strand_31_y * per_length_31 + strand_32_y * per_length_32
            + strand_33_y * per_length_33;
        const double t147 = t146 + strand_34_y * per_length_34 + strand_35_y * per_length_35
            + strand_36_y * per_length_36;
        const double pull_y_2 = t147 + strand_37_y * per_length_37;
        const double t148 = layer_1_z * per_length_19 + strand_20_z * per_length_20 + strand_21_z
            * per_length_21;
        const double t149 = t148 + strand_22_z * per_length_22 + strand_23_z * per_length_23
            + strand_24_z * per_length_24;
        const double t150 = t149 + strand_25_z * per_length_25 + strand_26_z * per_length_26
            + strand_27_z * per_length_27;
        const double t151 = t150 + strand_28_z * per_length_28 + strand_29_z * per_length_29
            + strand_30_z * per_length_30;
        const double t152 = t151 + strand_31_z * per_length_31 + strand_32_z * per_length_32
            + strand_33_z * per_length_33;
        const double t153 = t152 + strand_34_z * per_length_34 + strand_35_z * per_length_35
            + strand_36_z * per_length_36;
        const double pull_z_2 = t153 + strand_37_z * per_length_37;
        const double t154 = t141 - pull_y_2 * (t101 - t100 - 0.013 * u_y_by_q73) + pull_z_2 * (t110
            - t109 - 0.013 * y_z_by_q73);
        const double by_y_per_length_18 = 0.029 * per_length_18;
        const double by_y_per_length_17 = 0.027 * per_length_17;
        const double by_y_per_length_16 = 0.025 * per_length_16;
        const double by_y_per_length_15 = 0.024 * per_length_15;
        const double by_y_per_length_14 = 0.022 * per_length_14;
        const double by_y_per_length_13 = 0.021 * per_length_13;
        const double by_y_per_length_12 = 0.019 * per_length_12;
        const double by_y_per_length_11 = 0.017 * per_length_11;
        const double by_y_per_length_10 = 0.016 * per_length_10;
        const double by_y_per_length_9 = 0.014 * per_length_9;
        const double by_y_per_length_8 = 0.013 * per_length_8;
        const double by_y_per_length_7 = 0.011 * per_length_7;
        const double by_y_per_length_6 = 0.009 * per_length_6;
        const double by_y_per_length_5 = 0.008 * per_length_5;
        const double by_y_per_length_4 = 0.006 * per_length_4;
        const double by_y_per_length_3 = 0.005 * per_length_3;
        const double by_y_per_length_1 = 0.001 * per_length_1;
        const double by_y_per_length_2 = 0.003 * per_length_2;
        const double t155 = strand_1_x * by_y_per_length_1 + strand_2_x * by_y_per_length_2
            + strand_3_x * by_y_per_length_3;
        const double t156 = t155 + strand_4_x * by_y_per_length_4 + strand_5_x * by_y_per_length_5
            + strand_6_x * by_y_per_length_6;
        const double t157 = t156 + strand_7_x * by_y_per_length_7 + strand_8_x * by_y_per_length_8
            + strand_9_x * by_y_per_length_9;
        const double t158 = t157 + strand_10_x * by_y_per_length_10 + strand_11_x
            * by_y_per_length_11;
        const double t159 = t158 + strand_12_x * by_y_per_length_12 + strand_13_x
            * by_y_per_length_13;
        const double t160 = t159 + strand_14_x * by_y_per_length_14 + strand_15_x
            * by_y_per_length_15;
        const double t161 = t160 + strand_16_x * by_y_per_length_16 + strand_17_x
            * by_y_per_length_17;
        const double by_y_per_length_37 = 0.029 * per_length_37;
        const double by_y_per_length_36 = 0.027 * per_length_36;
        const double by_y_per_length_35 = 0.026 * per_length_35;
        const double by_y_per_length_34 = 0.024 * per_length_34;
        const double by_y_per_length_33 = 0.023 * per_length_33;
        const double by_y_per_length_32 = 0.021 * per_length_32;
        const double by_y_per_length_31 = 0.019 * per_length_31;
        const double by_y_per_length_30 = 0.018 * per_length_30;
        const double by_y_per_length_29 = 0.016 * per_length_29;
        const double by_y_per_length_28 = 0.015 * per_length_28;
        const double by_y_per_length_27 = 0.013 * per_length_27;
        const double by_y_per_length_26 = 0.011 * per_length_26;
        const double by_y_per_length_25 = 0.01 * per_length_25;
        const double by_y_per_length_24 = 0.008 * per_length_24;
        const double by_y_per_length_23 = 0.007 * per_length_23;
        const double by_y_per_length_22 = 0.005 * per_length_22;
        const double by_y_per_length_20 = 0.002 * per_length_20;
        const double by_y_per_length_21 = 0.003 * per_length_21;
        const double t162 = strand_20_x * by_y_per_length_20 + strand_21_x * by_y_per_length_21
            + strand_22_x * by_y_per_length_22;
        const double t163 = t162 + strand_23_x * by_y_per_length_23 + strand_24_x
            * by_y_per_length_24;
        const double t164 = t163 + strand_25_x * by_y_per_length_25 + strand_26_x
            * by_y_per_length_26;
        const double t165 = t164 + strand_27_x * by_y_per_length_27 + strand_28_x
            * by_y_per_length_28;
        const double t166 = t165 + strand_29_x * by_y_per_length_29 + strand_30_x
            * by_y_per_length_30;
        const double t167 = t166 + strand_31_x * by_y_per_length_31 + strand_32_x
            * by_y_per_length_32;
        const double t168 = t167 + strand_33_x * by_y_per_length_33 + strand_34_x
            * by_y_per_length_34;
        const double t169 = t168 + strand_35_x * by_y_per_length_35 + strand_36_x
            * by_y_per_length_36;
        const double pull_by_y = t161 + strand_18_x * by_y_per_length_18 + (t169 + strand_37_x
            * by_y_per_length_37);
        const double t170 = strand_1_y * by_y_per_length_1 + strand_2_y * by_y_per_length_2
            + strand_3_y * by_y_per_length_3;
        const double t171 = t170 + strand_4_y * by_y_per_length_4 + strand_5_y * by_y_per_length_5
            + strand_6_y * by_y_per_length_6;
        const double t172 = t171 + strand_7_y * by_y_per_length_7 + strand_8_y * by_y_per_length_8
            + strand_9_y * by_y_per_length_9;
        const double t173 = t172 + strand_10_y * by_y_per_length_10 + strand_11_y
            * by_y_per_length_11;
        const double t174 = t173 + strand_12_y * by_y_per_length_12 + strand_13_y
            * by_y_per_length_13;
        const double t175 = t174 + strand_14_y * by_y_per_length_14 + strand_15_y
            * by_y_per_length_15;
        const double t176 = t175 + strand_16_y * by_y_per_length_16 + strand_17_y
            * by_y_per_length_17;
        const double t177 = strand_20_y * by_y_per_length_20 + strand_21_y * by_y_per_length_21
            + strand_22_y * by_y_per_length_22;
        const double t178 = t177 + strand_23_y * by_y_per_length_23 + strand_24_y
            * by_y_per_length_24;
        const double t179 = t178 + strand_25_y * by_y_per_length_25 + strand_26_y
            * by_y_per_length_26;
        const double t180 = t179 + strand_27_y * by_y_per_length_27 + strand_28_y
            * by_y_per_length_28;
        const double t181 = t180 + strand_29_y * by_y_per_length_29 + strand_30_y
            * by_y_per_length_30;
        const double t182 = t181 + strand_31_y * by_y_per_length_31 + strand_32_y
            * by_y_per_length_32;
        const double t183 = t182 + strand_33_y * by_y_per_length_33 + strand_34_y
            * by_y_per_length_34;
        const double t184 = t183 + strand_35_y * by_y_per_length_35 + strand_36_y
            * by_y_per_length_36;
        const double pull_by_y_2 = t176 + strand_18_y * by_y_per_length_18 + (t184 + strand_37_y
            * by_y_per_length_37);
        const double t185 = strand_1_z * by_y_per_length_1 + strand_2_z * by_y_per_length_2
            + strand_3_z * by_y_per_length_3;
        const double t186 = t185 + strand_4_z * by_y_per_length_4 + strand_5_z * by_y_per_length_5
            + strand_6_z * by_y_per_length_6;
        const double t187 = t186 + strand_7_z * by_y_per_length_7 + strand_8_z * by_y_per_length_8
            + strand_9_z * by_y_per_length_9;
        const double t188 = t187 + strand_10_z * by_y_per_length_10 + strand_11_z
            * by_y_per_length_11;
        const double t189 = t188 + strand_12_z * by_y_per_length_12 + strand_13_z
            * by_y_per_length_13;
        const double t190 = t189 + strand_14_z * by_y_per_length_14 + strand_15_z
            * by_y_per_length_15;
        const double t191 = t190 + strand_16_z * by_y_per_length_16 + strand_17_z
            * by_y_per_length_17;
        const double t192 = strand_20_z * by_y_per_length_20 + strand_21_z * by_y_per_length_21
            + strand_22_z * by_y_per_length_22;
        const double t193 = t192 + strand_23_z * by_y_per_length_23 + strand_24_z
            * by_y_per_length_24;
        const double t194 = t193 + strand_25_z * by_y_per_length_25 + strand_26_z
            * by_y_per_length_26;
        const double t195 = t194 + strand_27_z * by_y_per_length_27 + strand_28_z
            * by_y_per_length_28;
        const double t196 = t195 + strand_29_z * by_y_per_length_29 + strand_30_z
            * by_y_per_length_30;
        const double t197 = t196 + strand_31_z * by_y_per_length_31 + strand_32_z
            * by_y_per_length_32;
        const double t198 = t197 + strand_33_z * by_y_per_length_33 + strand_34_z
            * by_y_per_length_34;
        const double t199 = t198 + strand_35_z * by_y_per_length_35 + strand_36_z
            * by_y_per_length_36;
        const double pull_by_y_4 = t191 + strand_18_z * by_y_per_length_18 + (t199 + strand_37_z
            * by_y_per_length_37);
        const double t200 = t154 + pull_by_y * y_x_by_q73 - pull_by_y_2 * u_y_by_q73 + pull_by_y_4
            * y_z_by_q73;
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
        const double t201 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t201 - sin_A * reach_squared_by_q71) * t9;
        const double t202 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double cos_A_by_q71 = (t202 - cos_A * reach_squared_by_q71) * t9;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double z_x_by_q71 = t39 - cos_q71 * z_plane_x_by_q71 + t40 + sin_q71 * sin_A_by_q71;
        const double t203 = 0.01 * z_x_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double x_x_by_q71 = t42 + cos_q71 * x_plane_x_by_q71 - t43 + sin_q71 * cos_A_by_q71;
        const double t204 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t205 = 0.01 * z_plane_y_by_q71;
        const double t206 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t207 = y_x * pull_by_y_4 - y_z * pull_by_y - pull_x * (t204 + t203 - t38)
            + pull_y * (t206 - t205);
        const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t31 + sin_q71 * z_plane_x_by_q71;
        const double t208 = 0.01 * z_z_by_q71;
        const double x_z_by_q71 = t35 - cos_q71 * cos_A_by_q71 + t34 + sin_q71 * x_plane_x_by_q71;
        const double t209 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t210 = t207 + pull_z * (t209 + t208 - t30) - pull_x_2 * (t204 - t203 - t75)
            + pull_y_2 * (t206 + t205);
        tau[state] = t210 + pull_z_2 * (t209 - t208 - t74);
        tau[1 * n + state] = t200;
    }
}
