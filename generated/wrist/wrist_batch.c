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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double y_x = cos_q71 * u_e;
        const double z_plane_x = u_y * cos_A;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double M_x = cos_q71 * M_e;
        const double origin_x = M_x - 0.018 * z_x;
        const double x_plane_y = u_e * sin_A;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double y_z = sin_q71 * u_e;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        T[state] = x_x;
        T[1 * n + state] = y_x;
        T[2 * n + state] = z_x;
        T[3 * n + state] = origin_x;
        T[4 * n + state] = -x_plane_y;
        T[5 * n + state] = u_y;
        T[6 * n + state] = -z_plane_y;
        T[7 * n + state] = origin_y;
        T[8 * n + state] = -x_z;
        T[9 * n + state] = y_z;
        T[10 * n + state] = z_z;
        T[11 * n + state] = origin_z;
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
        const double B_e = 0.074565407529229 * sin_q73;
        const double C_e = B_e * ratio;
        const double C_z = sin_q71 * C_e;
        const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
        const double C_x = cos_q71 * C_e;
        const double B_z = sin_q71 * B_e;
        const double B_x = cos_q71 * B_e;
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
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double M_z = sin_q71 * M_e;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double M_x = cos_q71 * M_e;
        ABC[state] = M_x - 0.036 * z_x;
        ABC[1 * n + state] = M_y + 0.036 * u_e * cos_A;
        ABC[2 * n + state] = M_z - 0.036 * z_z;
        ABC[3 * n + state] = B_x;
        ABC[4 * n + state] = B_y;
        ABC[5 * n + state] = B_z;
        ABC[6 * n + state] = C_x;
        ABC[7 * n + state] = -C_y;
        ABC[8 * n + state] = C_z;
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double x_plane_y = u_e * sin_A;
        angles[state] = sinew_atan2(-x_z, x_x);
        angles[1 * n + state] = sinew_asin(sinew_min(sinew_max(-x_plane_y, -1.0), 1.0));
    }
}

void wrist_bar_angles_batch(int count, const double *SINEW_RESTRICT flexion,
    const double *SINEW_RESTRICT abduction, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT residual, double *SINEW_RESTRICT status)
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
        const double v_length = sinew_sqrt(sinew_max(t7 + t6, 1e-12));
        const double t9 = 1.0 / v_length;
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
        const double z_x_by_q71 = v_y * u_z_by_q71 - v_z * cos_tilt_by_q71;
        const double u_z = sin_q71 * sin_tilt;
        const double u_x_by_q71 = u_z - cos_q71 * sin_tilt_by_q71;
        const double sin_q73 = cos_half_tilt * sin_sum - sin_half_tilt * cos_sum;
        const double t15 = 0.074565407529229 * sin_q71;
        const double t16 = t15 * sin_q73;
        const double gap_x_by_q71 = 0.021 * u_x_by_q71 - 0.036 * z_x_by_q71 - t14 * sin_q73_by_q71
            + t16;
        const double t17 = t14 * sin_q73;
        const double z_x = v_y * u_z + v_z * cos_tilt;
        const double gap_x = 0.021 * u_x + 0.036 * z_x + t17;
        const double t18 = cos_half_tilt * cos_sum_by_q71 - sin_half_tilt * sin_sum_by_q71 + cos_sum
            * cos_half_tilt_by_q71;
        const double cos_q73_by_q71 = t18 - sin_sum * sin_half_tilt_by_q71;
        const double z_y_by_q71 = v_x * u_z_by_q71 + v_z * u_x_by_q71;
        const double gap_y_by_q71 = 0.021 * cos_tilt_by_q71 - 0.036 * z_y_by_q71 - 0.074565407529229
            * cos_q73_by_q71;
        const double cos_q73 = cos_half_tilt * cos_sum + sin_half_tilt * sin_sum;
        const double z_y = v_x * u_z - v_z * u_x;
        const double gap_y = 0.021 * (1.0 + cos_tilt) + 0.036 * z_y - 0.074565407529229 * cos_q73;
        const double z_z_by_q71 = v_x * cos_tilt_by_q71 + v_y * u_x_by_q71;
        const double gap_z_by_q71 = 0.021 * u_z_by_q71 + 0.036 * z_z_by_q71 + t17 + t15
            * sin_q73_by_q71;
        const double z_z = v_x * cos_tilt + v_y * u_x;
        const double gap_z = 0.036 * (1.0 + z_z) - 0.021 * u_z - t16;
        const double mismatch_by_q71 = gap_x * gap_x_by_q71 + gap_y * gap_y_by_q71 + gap_z
            * gap_z_by_q71;
        const double t19 = -mismatch_by_q71;
        const double safe_slope = sinew_choose(t19, sinew_max(t19, 1.8e-09), sinew_min(t19,
            -1.8e-09));
        const double mismatch = 0.001898 - 0.5 * (gap_x * gap_x + gap_y * gap_y + gap_z * gap_z);
        const double q71 = q71_start + sinew_min(sinew_max(mismatch / safe_slope, -0.2), 0.2);
        double sin_q71_2, cos_q71_2;
        sinew_sincos(q71, &sin_q71_2, &cos_q71_2);
        const double v_e_2 = v_x * cos_q71_2 + v_z * sin_q71_2;
        const double t20 = v_e_2 * v_e_2;
        const double v_length_2 = sinew_sqrt(sinew_max(t7 + t20, 1e-12));
        const double t21 = 1.0 / v_length_2;
        const double cos_tilt_2 = v_e_2 * t21;
        const double sin_tilt_2 = v_y * t21;
        const double u_z_2 = sin_q71_2 * sin_tilt_2;
        const double z_x_2 = v_y * u_z_2 + v_z * cos_tilt_2;
        const double u_x_2 = cos_q71_2 * sin_tilt_2;
        const double t22 = 0.5 * cos_tilt_2;
        const double cos_half_tilt_2 = sinew_sqrt(sinew_max(0.5 + t22, 1e-12));
        const double cos_sum_2 = 0.5632638698251111 * cos_half_tilt_2;
        const double sin_sum_2 = sinew_sqrt(1.0 - cos_sum_2 * cos_sum_2);
        const double t23 = 1.0 / cos_half_tilt_2;
        const double sin_half_tilt_2 = 0.5 * sin_tilt_2 * t23;
        const double sin_q73_2 = cos_half_tilt_2 * sin_sum_2 - sin_half_tilt_2 * cos_sum_2;
        const double t24 = 0.074565407529229 * cos_q71_2;
        const double t25 = t24 * sin_q73_2;
        const double gap_x_2 = 0.021 * u_x_2 + 0.036 * z_x_2 + t25;
        const double z_y_2 = v_x * u_z_2 - v_z * u_x_2;
        const double cos_q73_2 = cos_half_tilt_2 * cos_sum_2 + sin_half_tilt_2 * sin_sum_2;
        const double gap_y_2 = 0.021 * (1.0 + cos_tilt_2) + 0.036 * z_y_2 - 0.074565407529229
            * cos_q73_2;
        const double z_z_2 = v_x * cos_tilt_2 + v_y * u_x_2;
        const double t26 = 0.074565407529229 * sin_q71_2;
        const double t27 = t26 * sin_q73_2;
        const double gap_z_2 = 0.036 * (1.0 + z_z_2) - 0.021 * u_z_2 - t27;
        const double mismatch_2 = 0.001898 - 0.5 * (gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + gap_z_2
            * gap_z_2);
        const double v_e_2_by_q71 = v_x * sin_q71_2 - v_z * cos_q71_2;
        const double v_length_2_by_q71 = v_e_2 * v_e_2_by_q71 * sinew_choose(-(t8 - t20), 1.0, 0.0)
            * t21;
        const double sin_tilt_2_by_q71 = sin_tilt_2 * v_length_2_by_q71 * t21;
        const double u_x_2_by_q71 = u_z_2 - cos_q71_2 * sin_tilt_2_by_q71;
        const double u_z_2_by_q71 = u_x_2 + sin_q71_2 * sin_tilt_2_by_q71;
        const double cos_tilt_2_by_q71 = (v_e_2_by_q71 - cos_tilt_2 * v_length_2_by_q71) * t21;
        const double z_x_2_by_q71 = v_y * u_z_2_by_q71 - v_z * cos_tilt_2_by_q71;
        const double cos_half_tilt_2_by_q71 = 0.25 * cos_tilt_2_by_q71 * sinew_choose(0.499999999999
            + t22, 1.0, 0.0) * t23;
        const double cos_sum_2_by_q71 = 0.5632638698251111 * cos_half_tilt_2_by_q71;
        const double sin_sum_2_by_q71 = cos_sum_2 * cos_sum_2_by_q71 / sin_sum_2;
        const double t28 = sin_tilt_2_by_q71 + (sin_half_tilt_2 + sin_half_tilt_2)
            * cos_half_tilt_2_by_q71;
        const double sin_half_tilt_2_by_q71 = 0.5 * t28 * t23;
        const double t29 = cos_half_tilt_2 * sin_sum_2_by_q71 + sin_half_tilt_2 * cos_sum_2_by_q71
            - cos_sum_2 * sin_half_tilt_2_by_q71;
        const double sin_q73_2_by_q71 = t29 - sin_sum_2 * cos_half_tilt_2_by_q71;
        const double gap_x_2_by_q71 = 0.021 * u_x_2_by_q71 - 0.036 * z_x_2_by_q71 - t24
            * sin_q73_2_by_q71 + t27;
        const double z_y_2_by_q71 = v_x * u_z_2_by_q71 + v_z * u_x_2_by_q71;
        const double t30 = cos_half_tilt_2 * cos_sum_2_by_q71 - sin_half_tilt_2 * sin_sum_2_by_q71
            + cos_sum_2 * cos_half_tilt_2_by_q71;
        const double cos_q73_2_by_q71 = t30 - sin_sum_2 * sin_half_tilt_2_by_q71;
        const double gap_y_2_by_q71 = 0.021 * cos_tilt_2_by_q71 - 0.036 * z_y_2_by_q71
            - 0.074565407529229 * cos_q73_2_by_q71;
        const double z_z_2_by_q71 = v_x * cos_tilt_2_by_q71 + v_y * u_x_2_by_q71;
        const double gap_z_2_by_q71 = 0.021 * u_z_2_by_q71 + 0.036 * z_z_2_by_q71 + t25 + t26
            * sin_q73_2_by_q71;
        const double mismatch_2_by_q71 = gap_x_2 * gap_x_2_by_q71 + gap_y_2 * gap_y_2_by_q71
            + gap_z_2 * gap_z_2_by_q71;
        const double t31 = -mismatch_2_by_q71;
        const double safe_slope_2 = sinew_choose(t31, sinew_max(t31, 1.8e-09), sinew_min(t31,
            -1.8e-09));
        const double q71_2 = q71 + sinew_min(sinew_max(mismatch_2 / safe_slope_2, -0.2), 0.2);
        double sin_q71_4, cos_q71_4;
        sinew_sincos(q71_2, &sin_q71_4, &cos_q71_4);
        const double v_e_4 = v_x * cos_q71_4 + v_z * sin_q71_4;
        const double t32 = v_e_4 * v_e_4;
        const double v_length_4 = sinew_sqrt(sinew_max(t7 + t32, 1e-12));
        const double t33 = 1.0 / v_length_4;
        const double sin_tilt_4 = v_y * t33;
        const double u_x_4 = cos_q71_4 * sin_tilt_4;
        const double u_z_4 = sin_q71_4 * sin_tilt_4;
        const double cos_tilt_4 = v_e_4 * t33;
        const double z_x_4 = v_y * u_z_4 + v_z * cos_tilt_4;
        const double t34 = 0.074565407529229 * cos_q71_4;
        const double t35 = 0.5 * cos_tilt_4;
        const double cos_half_tilt_4 = sinew_sqrt(sinew_max(0.5 + t35, 1e-12));
        const double cos_sum_4 = 0.5632638698251111 * cos_half_tilt_4;
        const double sin_sum_4 = sinew_sqrt(1.0 - cos_sum_4 * cos_sum_4);
        const double t36 = 1.0 / cos_half_tilt_4;
        const double sin_half_tilt_4 = 0.5 * sin_tilt_4 * t36;
        const double sin_q73_4 = cos_half_tilt_4 * sin_sum_4 - sin_half_tilt_4 * cos_sum_4;
        const double t37 = t34 * sin_q73_4;
        const double gap_x_4 = 0.021 * u_x_4 + 0.036 * z_x_4 + t37;
        const double z_y_4 = v_x * u_z_4 - v_z * u_x_4;
        const double cos_q73_4 = cos_half_tilt_4 * cos_sum_4 + sin_half_tilt_4 * sin_sum_4;
        const double gap_y_4 = 0.021 * (1.0 + cos_tilt_4) + 0.036 * z_y_4 - 0.074565407529229
            * cos_q73_4;
        const double z_z_4 = v_x * cos_tilt_4 + v_y * u_x_4;
        const double t38 = 0.074565407529229 * sin_q71_4;
        const double t39 = t38 * sin_q73_4;
        const double gap_z_4 = 0.036 * (1.0 + z_z_4) - 0.021 * u_z_4 - t39;
        const double mismatch_4 = 0.001898 - 0.5 * (gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4 + gap_z_4
            * gap_z_4);
        const double v_e_4_by_q71 = v_x * sin_q71_4 - v_z * cos_q71_4;
        const double v_length_4_by_q71 = v_e_4 * v_e_4_by_q71 * sinew_choose(-(t8 - t32), 1.0, 0.0)
            * t33;
        const double sin_tilt_4_by_q71 = sin_tilt_4 * v_length_4_by_q71 * t33;
        const double u_x_4_by_q71 = u_z_4 - cos_q71_4 * sin_tilt_4_by_q71;
        const double u_z_4_by_q71 = u_x_4 + sin_q71_4 * sin_tilt_4_by_q71;
        const double cos_tilt_4_by_q71 = (v_e_4_by_q71 - cos_tilt_4 * v_length_4_by_q71) * t33;
        const double z_x_4_by_q71 = v_y * u_z_4_by_q71 - v_z * cos_tilt_4_by_q71;
        const double cos_half_tilt_4_by_q71 = 0.25 * cos_tilt_4_by_q71 * sinew_choose(0.499999999999
            + t35, 1.0, 0.0) * t36;
        const double cos_sum_4_by_q71 = 0.5632638698251111 * cos_half_tilt_4_by_q71;
        const double sin_sum_4_by_q71 = cos_sum_4 * cos_sum_4_by_q71 / sin_sum_4;
        const double t40 = sin_tilt_4_by_q71 + (sin_half_tilt_4 + sin_half_tilt_4)
            * cos_half_tilt_4_by_q71;
        const double sin_half_tilt_4_by_q71 = 0.5 * t40 * t36;
        const double t41 = cos_half_tilt_4 * sin_sum_4_by_q71 + sin_half_tilt_4 * cos_sum_4_by_q71
            - cos_sum_4 * sin_half_tilt_4_by_q71;
        const double sin_q73_4_by_q71 = t41 - sin_sum_4 * cos_half_tilt_4_by_q71;
        const double gap_x_4_by_q71 = 0.021 * u_x_4_by_q71 - 0.036 * z_x_4_by_q71 - t34
            * sin_q73_4_by_q71 + t39;
        const double z_y_4_by_q71 = v_x * u_z_4_by_q71 + v_z * u_x_4_by_q71;
        const double t42 = cos_half_tilt_4 * cos_sum_4_by_q71 - sin_half_tilt_4 * sin_sum_4_by_q71
            + cos_sum_4 * cos_half_tilt_4_by_q71;
        const double cos_q73_4_by_q71 = t42 - sin_sum_4 * sin_half_tilt_4_by_q71;
        const double gap_y_4_by_q71 = 0.021 * cos_tilt_4_by_q71 - 0.036 * z_y_4_by_q71
            - 0.074565407529229 * cos_q73_4_by_q71;
        const double z_z_4_by_q71 = v_x * cos_tilt_4_by_q71 + v_y * u_x_4_by_q71;
        const double gap_z_4_by_q71 = 0.021 * u_z_4_by_q71 + 0.036 * z_z_4_by_q71 + t37 + t38
            * sin_q73_4_by_q71;
        const double mismatch_4_by_q71 = gap_x_4 * gap_x_4_by_q71 + gap_y_4 * gap_y_4_by_q71
            + gap_z_4 * gap_z_4_by_q71;
        const double t43 = -mismatch_4_by_q71;
        const double safe_slope_4 = sinew_choose(t43, sinew_max(t43, 1.8e-09), sinew_min(t43,
            -1.8e-09));
        const double q71_4 = q71_2 + sinew_min(sinew_max(mismatch_4 / safe_slope_4, -0.2), 0.2);
        double sin_q71_6, cos_q71_6;
        sinew_sincos(q71_4, &sin_q71_6, &cos_q71_6);
        const double v_e_6 = v_x * cos_q71_6 + v_z * sin_q71_6;
        const double t44 = v_e_6 * v_e_6;
        const double v_length_6 = sinew_sqrt(sinew_max(t7 + t44, 1e-12));
        const double t45 = 1.0 / v_length_6;
        const double sin_tilt_6 = v_y * t45;
        const double u_x_6 = cos_q71_6 * sin_tilt_6;
        const double u_z_6 = sin_q71_6 * sin_tilt_6;
        const double cos_tilt_6 = v_e_6 * t45;
        const double z_x_6 = v_y * u_z_6 + v_z * cos_tilt_6;
        const double t46 = 0.074565407529229 * cos_q71_6;
        const double t47 = 0.5 * cos_tilt_6;
        const double cos_half_tilt_6 = sinew_sqrt(sinew_max(0.5 + t47, 1e-12));
        const double cos_sum_6 = 0.5632638698251111 * cos_half_tilt_6;
        const double sin_sum_6 = sinew_sqrt(1.0 - cos_sum_6 * cos_sum_6);
        const double t48 = 1.0 / cos_half_tilt_6;
        const double sin_half_tilt_6 = 0.5 * sin_tilt_6 * t48;
        const double sin_q73_6 = cos_half_tilt_6 * sin_sum_6 - sin_half_tilt_6 * cos_sum_6;
        const double t49 = t46 * sin_q73_6;
        const double gap_x_6 = 0.021 * u_x_6 + 0.036 * z_x_6 + t49;
        const double z_y_6 = v_x * u_z_6 - v_z * u_x_6;
        const double cos_q73_6 = cos_half_tilt_6 * cos_sum_6 + sin_half_tilt_6 * sin_sum_6;
        const double gap_y_6 = 0.021 * (1.0 + cos_tilt_6) + 0.036 * z_y_6 - 0.074565407529229
            * cos_q73_6;
        const double z_z_6 = v_x * cos_tilt_6 + v_y * u_x_6;
        const double t50 = 0.074565407529229 * sin_q71_6;
        const double t51 = t50 * sin_q73_6;
        const double gap_z_6 = 0.036 * (1.0 + z_z_6) - 0.021 * u_z_6 - t51;
        const double mismatch_6 = 0.001898 - 0.5 * (gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6 + gap_z_6
            * gap_z_6);
        const double v_e_6_by_q71 = v_x * sin_q71_6 - v_z * cos_q71_6;
        const double v_length_6_by_q71 = v_e_6 * v_e_6_by_q71 * sinew_choose(-(t8 - t44), 1.0, 0.0)
            * t45;
        const double sin_tilt_6_by_q71 = sin_tilt_6 * v_length_6_by_q71 * t45;
        const double u_x_6_by_q71 = u_z_6 - cos_q71_6 * sin_tilt_6_by_q71;
        const double u_z_6_by_q71 = u_x_6 + sin_q71_6 * sin_tilt_6_by_q71;
        const double cos_tilt_6_by_q71 = (v_e_6_by_q71 - cos_tilt_6 * v_length_6_by_q71) * t45;
        const double z_x_6_by_q71 = v_y * u_z_6_by_q71 - v_z * cos_tilt_6_by_q71;
        const double cos_half_tilt_6_by_q71 = 0.25 * cos_tilt_6_by_q71 * sinew_choose(0.499999999999
            + t47, 1.0, 0.0) * t48;
        const double cos_sum_6_by_q71 = 0.5632638698251111 * cos_half_tilt_6_by_q71;
        const double sin_sum_6_by_q71 = cos_sum_6 * cos_sum_6_by_q71 / sin_sum_6;
        const double t52 = sin_tilt_6_by_q71 + (sin_half_tilt_6 + sin_half_tilt_6)
            * cos_half_tilt_6_by_q71;
        const double sin_half_tilt_6_by_q71 = 0.5 * t52 * t48;
        const double t53 = cos_half_tilt_6 * sin_sum_6_by_q71 + sin_half_tilt_6 * cos_sum_6_by_q71
            - cos_sum_6 * sin_half_tilt_6_by_q71;
        const double sin_q73_6_by_q71 = t53 - sin_sum_6 * cos_half_tilt_6_by_q71;
        const double gap_x_6_by_q71 = 0.021 * u_x_6_by_q71 - 0.036 * z_x_6_by_q71 - t46
            * sin_q73_6_by_q71 + t51;
        const double z_y_6_by_q71 = v_x * u_z_6_by_q71 + v_z * u_x_6_by_q71;
        const double t54 = cos_half_tilt_6 * cos_sum_6_by_q71 - sin_half_tilt_6 * sin_sum_6_by_q71
            + cos_sum_6 * cos_half_tilt_6_by_q71;
        const double cos_q73_6_by_q71 = t54 - sin_sum_6 * sin_half_tilt_6_by_q71;
        const double gap_y_6_by_q71 = 0.021 * cos_tilt_6_by_q71 - 0.036 * z_y_6_by_q71
            - 0.074565407529229 * cos_q73_6_by_q71;
        const double z_z_6_by_q71 = v_x * cos_tilt_6_by_q71 + v_y * u_x_6_by_q71;
        const double gap_z_6_by_q71 = 0.021 * u_z_6_by_q71 + 0.036 * z_z_6_by_q71 + t49 + t50
            * sin_q73_6_by_q71;
        const double mismatch_6_by_q71 = gap_x_6 * gap_x_6_by_q71 + gap_y_6 * gap_y_6_by_q71
            + gap_z_6 * gap_z_6_by_q71;
        const double t55 = -mismatch_6_by_q71;
        const double safe_slope_6 = sinew_choose(t55, sinew_max(t55, 1.8e-09), sinew_min(t55,
            -1.8e-09));
        const double q71_6 = q71_4 + sinew_min(sinew_max(mismatch_6 / safe_slope_6, -0.2), 0.2);
        double sin_q71_8, cos_q71_8;
        sinew_sincos(q71_6, &sin_q71_8, &cos_q71_8);
        const double v_e_8 = v_x * cos_q71_8 + v_z * sin_q71_8;
        const double v_length_8 = sinew_sqrt(sinew_max(t7 + v_e_8 * v_e_8, 1e-12));
        const double t56 = 1.0 / v_length_8;
        const double cos_tilt_8 = v_e_8 * t56;
        const double cos_half_tilt_8 = sinew_sqrt(sinew_max(0.5 * (1.0 + cos_tilt_8), 1e-12));
        const double cos_sum_8 = 0.5632638698251111 * cos_half_tilt_8;
        const double sin_sum_8 = sinew_sqrt(1.0 - cos_sum_8 * cos_sum_8);
        const double sin_tilt_8 = v_y * t56;
        const double sin_half_tilt_8 = 0.5 * sin_tilt_8 / cos_half_tilt_8;
        const double sin_q73_8 = cos_half_tilt_8 * sin_sum_8 - sin_half_tilt_8 * cos_sum_8;
        const double cos_q73_8 = cos_half_tilt_8 * cos_sum_8 + sin_half_tilt_8 * sin_sum_8;
        const double B_e = 0.074565407529229 * sin_q73_8;
        const double B_y = 0.074565407529229 * cos_q73_8;
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        const double t57 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t57;
        const double sin_A = (p_y * root - p_z * limited) * t57;
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
        const double t58 = flexion[state] - limited_flexion;
        const double t59 = abduction[state] - limited_abduction;
        const double t60 = sinew_choose(1e-06 - residual_2 - sinew_max(-t58, t58) - sinew_max(-t59,
            t59), sinew_choose(-(1e-06 - sin_q73_8), 0.0, 1.0), 1.0);
        q[state] = q71_6;
        q[1 * n + state] = sinew_atan2(sin_q73_8, cos_q73_8);
        residual[state] = residual_2;
        status[state] = t60;
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
    const double *SINEW_RESTRICT q73, double *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q73, cos_q73;
        sinew_sincos(q73[state], &sin_q73, &cos_q73);
        double sin_q71, cos_q71;
        sinew_sincos(q71[state], &sin_q71, &cos_q71);
        const double B_y = 0.074565407529229 * cos_q73;
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        status[state] = sinew_choose(-(1e-06 - sin_q73), t1, 1.0);
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double M_x = cos_q71 * M_e;
        const double z_plane_x = u_y * cos_A;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double t2 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
        const double t3 = 0.01 * z_x;
        const double layer_0_x = t2 - t3;
        const double y_x = cos_q71 * u_e;
        const double t4 = 0.011 * y_x;
        const double strand_0_x = layer_0_x + t4;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t5 = origin_y + 0.004 * u_e * sin_A;
        const double t6 = 0.01 * z_plane_y;
        const double layer_0_y = t5 - t6;
        const double t7 = 0.011 * u_y;
        const double strand_0_y = 0.007 - layer_0_y + t7;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double t8 = 0.004 * x_z;
        const double t9 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t8 - t9;
        const double y_z = sin_q71 * u_e;
        const double t10 = 0.011 * y_z;
        const double strand_0_z = layer_0_z + t10;
        const double t11 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z
            * strand_0_z;
        const double length_0 = sinew_sqrt(t11);
        const double t12 = 0.01 * y_x;
        const double strand_1_x = layer_0_x + t12;
        const double t13 = 0.01 * u_y;
        const double strand_1_y = 0.008 - layer_0_y + t13;
        const double t14 = 0.01 * y_z;
        const double strand_1_z = layer_0_z + t14;
        const double t15 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1 = sinew_sqrt(t15);
        const double t16 = 0.008 * y_x;
        const double strand_2_x = layer_0_x + t16;
        const double t17 = 0.008 * u_y;
        const double strand_2_y = 0.01 - layer_0_y + t17;
        const double t18 = 0.008 * y_z;
        const double strand_2_z = layer_0_z + t18;
        const double t19 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2 = sinew_sqrt(t19);
        const double t20 = 0.006 * y_x;
        const double strand_3_x = layer_0_x + t20;
        const double t21 = 0.006 * u_y;
        const double strand_3_y = 0.011 - layer_0_y + t21;
        const double t22 = 0.006 * y_z;
        const double strand_3_z = layer_0_z + t22;
        const double t23 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3 = sinew_sqrt(t23);
        const double t24 = 0.005 * y_x;
        const double strand_4_x = layer_0_x + t24;
        const double t25 = 0.005 * u_y;
        const double strand_4_y = 0.013 - layer_0_y + t25;
        const double t26 = 0.005 * y_z;
        const double strand_4_z = layer_0_z + t26;
        const double t27 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4 = sinew_sqrt(t27);
        const double t28 = 0.003 * y_x;
        const double strand_5_x = layer_0_x + t28;
        const double t29 = 0.003 * u_y;
        const double strand_5_y = 0.015 - layer_0_y + t29;
        const double t30 = 0.003 * y_z;
        const double strand_5_z = layer_0_z + t30;
        const double t31 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5 = sinew_sqrt(t31);
        const double t32 = 0.002 * y_x;
        const double strand_6_x = layer_0_x + t32;
        const double t33 = 0.002 * u_y;
        const double strand_6_y = 0.016 - layer_0_y + t33;
        const double t34 = 0.002 * y_z;
        const double strand_6_z = layer_0_z + t34;
        const double t35 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6 = sinew_sqrt(t35);
        const double strand_7_y = 0.018 - layer_0_y;
        const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z
            + strand_7_y * strand_7_y);
        const double strand_8_x = layer_0_x - t32;
        const double strand_8_y = 0.019 - layer_0_y - t33;
        const double strand_8_z = layer_0_z - t34;
        const double t36 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8 = sinew_sqrt(t36);
        const double strand_9_x = layer_0_x - t28;
        const double strand_9_y = 0.021 - layer_0_y - t29;
        const double strand_9_z = layer_0_z - t30;
        const double t37 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9 = sinew_sqrt(t37);
        const double strand_10_x = layer_0_x - t24;
        const double strand_10_y = 0.023 - layer_0_y - t25;
        const double strand_10_z = layer_0_z - t26;
        const double t38 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10 = sinew_sqrt(t38);
        const double strand_11_x = layer_0_x - t20;
        const double strand_11_y = 0.024 - layer_0_y - t21;
        const double strand_11_z = layer_0_z - t22;
        const double t39 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11 = sinew_sqrt(t39);
        const double strand_12_x = layer_0_x - t16;
        const double strand_12_y = 0.026 - layer_0_y - t17;
        const double strand_12_z = layer_0_z - t18;
        const double t40 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12 = sinew_sqrt(t40);
        const double strand_13_x = layer_0_x - t12;
        const double strand_13_y = 0.027 - layer_0_y - t13;
        const double strand_13_z = layer_0_z - t14;
        const double t41 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13 = sinew_sqrt(t41);
        const double strand_14_x = layer_0_x - t4;
        const double strand_14_y = 0.029 - layer_0_y - t7;
        const double strand_14_z = layer_0_z - t10;
        const double t42 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14 = sinew_sqrt(t42);
        const double t43 = 0.013 * y_x;
        const double strand_15_x = layer_0_x - t43;
        const double t44 = 0.013 * u_y;
        const double strand_15_y = 0.031 - layer_0_y - t44;
        const double t45 = 0.013 * y_z;
        const double strand_15_z = layer_0_z - t45;
        const double t46 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15 = sinew_sqrt(t46);
        const double t47 = 0.014 * y_x;
        const double strand_16_x = layer_0_x - t47;
        const double t48 = 0.014 * u_y;
        const double strand_16_y = 0.032 - layer_0_y - t48;
        const double t49 = 0.014 * y_z;
        const double strand_16_z = layer_0_z - t49;
        const double t50 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16 = sinew_sqrt(t50);
        const double t51 = 0.016 * y_x;
        const double strand_17_x = layer_0_x - t51;
        const double t52 = 0.016 * u_y;
        const double strand_17_y = 0.034 - layer_0_y - t52;
        const double t53 = 0.016 * y_z;
        const double strand_17_z = layer_0_z - t53;
        const double t54 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17 = sinew_sqrt(t54);
        const double strand_18_x = layer_0_x - 0.018 * y_x;
        const double strand_18_y = 0.035 - layer_0_y - 0.018 * u_y;
        const double strand_18_z = layer_0_z - 0.018 * y_z;
        const double t55 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18 = sinew_sqrt(t55);
        const double layer_1_x = t2 + t3;
        const double strand_19_x = layer_1_x + t43;
        const double layer_1_y = t5 + t6;
        const double strand_19_y = 0.006 - layer_1_y + t44;
        const double layer_1_z = 0.028 - origin_z - t8 + t9;
        const double strand_19_z = layer_1_z + t45;
        const double t56 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
            * strand_19_z;
        const double length_19 = sinew_sqrt(t56);
        const double strand_20_x = layer_1_x + t4;
        const double strand_20_y = 0.007 - layer_1_y + t7;
        const double strand_20_z = layer_1_z + t10;
        const double t57 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20 = sinew_sqrt(t57);
        const double strand_21_x = layer_1_x + t12;
        const double strand_21_y = 0.009 - layer_1_y + t13;
        const double strand_21_z = layer_1_z + t14;
        const double t58 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21 = sinew_sqrt(t58);
        const double strand_22_x = layer_1_x + t16;
        const double strand_22_y = 0.011 - layer_1_y + t17;
        const double strand_22_z = layer_1_z + t18;
        const double t59 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22 = sinew_sqrt(t59);
        const double strand_23_x = layer_1_x + t20;
        const double strand_23_y = 0.012 - layer_1_y + t21;
        const double strand_23_z = layer_1_z + t22;
        const double t60 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23 = sinew_sqrt(t60);
        const double strand_24_x = layer_1_x + t24;
        const double strand_24_y = 0.014 - layer_1_y + t25;
        const double strand_24_z = layer_1_z + t26;
        const double t61 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24 = sinew_sqrt(t61);
        const double strand_25_x = layer_1_x + t28;
        const double strand_25_y = 0.015 - layer_1_y + t29;
        const double strand_25_z = layer_1_z + t30;
        const double t62 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25 = sinew_sqrt(t62);
        const double strand_26_x = layer_1_x + t32;
        const double strand_26_y = 0.017 - layer_1_y + t33;
        const double strand_26_z = layer_1_z + t34;
        const double t63 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26 = sinew_sqrt(t63);
        const double strand_27_y = 0.019 - layer_1_y;
        const double t64 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y
            * strand_27_y;
        const double length_27 = sinew_sqrt(t64);
        const double strand_28_x = layer_1_x - t32;
        const double strand_28_y = 0.02 - layer_1_y - t33;
        const double strand_28_z = layer_1_z - t34;
        const double t65 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28 = sinew_sqrt(t65);
        const double strand_29_x = layer_1_x - t28;
        const double strand_29_y = 0.022 - layer_1_y - t29;
        const double strand_29_z = layer_1_z - t30;
        const double t66 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29 = sinew_sqrt(t66);
        const double strand_30_x = layer_1_x - t24;
        const double strand_30_y = 0.023 - layer_1_y - t25;
        const double strand_30_z = layer_1_z - t26;
        const double t67 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30 = sinew_sqrt(t67);
        const double strand_31_x = layer_1_x - t20;
        const double strand_31_y = 0.025 - layer_1_y - t21;
        const double strand_31_z = layer_1_z - t22;
        const double t68 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31 = sinew_sqrt(t68);
        const double strand_32_x = layer_1_x - t16;
        const double strand_32_y = 0.027 - layer_1_y - t17;
        const double strand_32_z = layer_1_z - t18;
        const double t69 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32 = sinew_sqrt(t69);
        const double strand_33_x = layer_1_x - t12;
        const double strand_33_y = 0.028 - layer_1_y - t13;
        const double strand_33_z = layer_1_z - t14;
        const double t70 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33 = sinew_sqrt(t70);
        const double strand_34_x = layer_1_x - t4;
        const double strand_34_y = 0.03 - layer_1_y - t7;
        const double strand_34_z = layer_1_z - t10;
        const double t71 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34 = sinew_sqrt(t71);
        const double strand_35_x = layer_1_x - t43;
        const double strand_35_y = 0.031 - layer_1_y - t44;
        const double strand_35_z = layer_1_z - t45;
        const double t72 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35 = sinew_sqrt(t72);
        const double strand_36_x = layer_1_x - t47;
        const double strand_36_y = 0.033 - layer_1_y - t48;
        const double strand_36_z = layer_1_z - t49;
        const double t73 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36 = sinew_sqrt(t73);
        const double strand_37_x = layer_1_x - t51;
        const double strand_37_y = 0.035 - layer_1_y - t52;
        const double strand_37_z = layer_1_z - t53;
        const double t74 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37 = sinew_sqrt(t74);
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double t1 = 1.0 / B_to_C0_squared;
        const double ratio = 0.003796 * t1;
        const double B_e = 0.074565407529229 * sin_q73;
        const double B_to_C0_squared_by_q73 = 0.084 * B_e;
        const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t1;
        const double t2 = 21.0 - 500.0 * B_y;
        const double C_e = B_e * ratio;
        const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t2;
        const double t3 = 0.5 * B_e;
        const double M_y_by_q73 = t3 + 0.5 * C_y_by_q73;
        const double t4 = 23.80952380952381 * B_e;
        const double u_e = t4 - 23.80952380952381 * C_e;
        const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
        const double t5 = 0.5 * B_y;
        const double M_e_by_q73 = t5 - 0.5 * C_e_by_q73;
        const double C_y = 0.002 * ratio * t2;
        const double t6 = 23.80952380952381 * B_y;
        const double u_y = t6 + 23.80952380952381 * C_y;
        const double u_y_by_q73 = t4 - 23.80952380952381 * C_y_by_q73;
        const double M_e = t3 + 0.5 * C_e;
        const double p_z_by_q71 = 0.036 * sin_q71;
        const double s_e = M_e - p_z_by_q71;
        const double u_e_by_q73 = t6 + 23.80952380952381 * C_e_by_q73;
        const double M_y = t5 - 0.5 * C_y;
        const double s_y = 0.021 - M_y;
        const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
            * u_e_by_q73;
        const double p_y = u_e * s_y + u_y * s_e;
        const double t7 = p_y + p_y;
        const double t8 = p_y * p_y;
        const double p_z = 0.036 * cos_q71;
        const double t9 = p_z * p_z;
        const double t10 = -(1.296e-15 - t8 - t9);
        const double reach_squared_by_q73 = sinew_choose(t10, t7 * p_y_by_q73, 0.0);
        const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
            * u_y_by_q73;
        const double p_x = u_e * s_e - u_y * s_y;
        const double t11 = 27.77777777777778 * p_x;
        const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t11
            * p_x_by_q73;
        const double reach_squared = sinew_max(t8 + t9, 1.296e-15);
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double t12 = reach - projection;
        const double t13 = sinew_choose(t12, 1.0, 0.0);
        const double t14 = 1.0 / reach;
        const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t14;
        const double t15 = sinew_choose(t12, 0.0, 1.0);
        const double t16 = sinew_max(-projection, -reach);
        const double t17 = reach - t16;
        const double limited_by_q73 = sinew_choose(t17, -(reach_by_q73 * t15 - projection_by_q73
            * t13), reach_by_q73);
        const double limited = sinew_min(t16, reach);
        const double t18 = limited + limited;
        const double t19 = reach + reach;
        const double t20 = (reach + limited) * (reach - limited);
        const double t21 = 1e-12 * reach_squared;
        const double t22 = -(t21 - t20);
        const double clearance_by_q73 = sinew_choose(t22, t19 * reach_by_q73 - t18 * limited_by_q73,
            1e-12 * reach_squared_by_q73);
        const double clearance = sinew_max(t20, t21);
        const double root = sinew_sqrt(clearance);
        const double t23 = 1.0 / root;
        const double root_by_q73 = 0.5 * clearance_by_q73 * t23;
        const double t24 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t24;
        const double t25 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t25 * t24;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double sin_A = (p_y * root - p_z * limited) * t24;
        const double t26 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t26 * t24;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double M_x_by_q73 = cos_q71 * M_e_by_q73;
        const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t27 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t28 = 0.01 * z_x_by_q73;
        const double layer_1_x_by_q73 = t27 - t28;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t29 = 0.016 * y_x_by_q73;
        const double strand_37_x_by_q73 = layer_1_x_by_q73 + t29;
        const double x_plane_x = u_y * sin_A;
        const double t30 = cos_q71 * x_plane_x;
        const double t31 = sin_q71 * cos_A;
        const double x_x = t30 + t31;
        const double M_x = cos_q71 * M_e;
        const double z_plane_x = u_y * cos_A;
        const double t32 = cos_q71 * z_plane_x;
        const double t33 = sin_q71 * sin_A;
        const double z_x = t32 - t33;
        const double t34 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
        const double t35 = 0.01 * z_x;
        const double layer_1_x = t34 + t35;
        const double y_x = cos_q71 * u_e;
        const double t36 = 0.016 * y_x;
        const double strand_37_x = layer_1_x - t36;
        const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
        const double t37 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
        const double t38 = 0.01 * z_plane_y_by_q73;
        const double layer_1_y_by_q73 = t37 - t38;
        const double t39 = 0.016 * u_y_by_q73;
        const double strand_37_y_by_q73 = layer_1_y_by_q73 + t39;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t40 = 0.004 * u_e;
        const double t41 = origin_y + t40 * sin_A;
        const double t42 = 0.01 * z_plane_y;
        const double layer_1_y = t41 + t42;
        const double t43 = 0.016 * u_y;
        const double strand_37_y = 0.035 - layer_1_y - t43;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double M_z_by_q73 = sin_q71 * M_e_by_q73;
        const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t44 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t45 = 0.01 * z_z_by_q73;
        const double layer_1_z_by_q73 = t44 - t45;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t46 = 0.016 * y_z_by_q73;
        const double strand_37_z_by_q73 = layer_1_z_by_q73 + t46;
        const double t47 = sin_q71 * z_plane_x;
        const double t48 = cos_q71 * sin_A;
        const double z_z = t48 + t47;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double t49 = sin_q71 * x_plane_x;
        const double t50 = cos_q71 * cos_A;
        const double x_z = t50 - t49;
        const double t51 = 0.004 * x_z;
        const double t52 = 0.01 * z_z;
        const double layer_1_z = 0.028 - origin_z - t51 + t52;
        const double y_z = sin_q71 * u_e;
        const double t53 = 0.016 * y_z;
        const double strand_37_z = layer_1_z - t53;
        const double t54 = strand_37_x * strand_37_x_by_q73 - strand_37_y * strand_37_y_by_q73
            + strand_37_z * strand_37_z_by_q73;
        const double t55 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37 = sinew_sqrt(t55);
        const double t56 = 1.0 / length_37;
        const double length_37_by_q73 = t54 * t56;
        const double p_y_by_q71 = u_y * p_z;
        const double reach_squared_by_q71 = sinew_choose(t10, -(t7 * p_y_by_q71 + (p_z + p_z)
            * p_z_by_q71), 0.0);
        const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t14;
        const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t11 * u_e * p_z;
        const double limited_by_q71 = sinew_choose(t17, -(reach_by_q71 * t15 - projection_by_q71
            * t13), reach_by_q71);
        const double clearance_by_q71 = sinew_choose(t22, t19 * reach_by_q71 - t18 * limited_by_q71,
            1e-12 * reach_squared_by_q71);
        const double root_by_q71 = 0.5 * clearance_by_q71 * t23;
        const double t57 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double cos_A_by_q71 = (t57 - cos_A * reach_squared_by_q71) * t24;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double t58 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t58 - sin_A * reach_squared_by_q71) * t24;
        const double z_x_by_q71 = t48 - cos_q71 * z_plane_x_by_q71 + t47 + sin_q71 * sin_A_by_q71;
        const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double x_x_by_q71 = t50 + cos_q71 * x_plane_x_by_q71 - t49 + sin_q71 * cos_A_by_q71;
        const double t59 = origin_x_by_q71 + 0.004 * x_x_by_q71;
        const double t60 = 0.01 * z_x_by_q71;
        const double layer_1_x_by_q71 = t59 - t60;
        const double strand_37_x_by_q71 = layer_1_x_by_q71 + t53;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
        const double t61 = origin_y_by_q71 + t40 * sin_A_by_q71;
        const double t62 = 0.01 * z_plane_y_by_q71;
        const double layer_1_y_by_q71 = t61 + t62;
        const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t33 + sin_q71 * z_plane_x_by_q71;
        const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
        const double x_z_by_q71 = t30 - cos_q71 * cos_A_by_q71 + t31 + sin_q71 * x_plane_x_by_q71;
        const double t63 = origin_z_by_q71 - 0.004 * x_z_by_q71;
        const double t64 = 0.01 * z_z_by_q71;
        const double layer_1_z_by_q71 = t63 - t64;
        const double strand_37_z_by_q71 = layer_1_z_by_q71 + t36;
        const double t65 = strand_37_x * strand_37_x_by_q71 - strand_37_y * layer_1_y_by_q71
            - strand_37_z * strand_37_z_by_q71;
        const double length_37_by_q71 = t65 * t56;
        const double t66 = 0.014 * y_x_by_q73;
        const double strand_36_x_by_q73 = layer_1_x_by_q73 + t66;
        const double t67 = 0.014 * y_x;
        const double strand_36_x = layer_1_x - t67;
        const double t68 = 0.014 * u_y_by_q73;
        const double strand_36_y_by_q73 = layer_1_y_by_q73 + t68;
        const double t69 = 0.014 * u_y;
        const double strand_36_y = 0.033 - layer_1_y - t69;
        const double t70 = 0.014 * y_z_by_q73;
        const double strand_36_z_by_q73 = layer_1_z_by_q73 + t70;
        const double t71 = 0.014 * y_z;
        const double strand_36_z = layer_1_z - t71;
        const double t72 = strand_36_x * strand_36_x_by_q73 - strand_36_y * strand_36_y_by_q73
            + strand_36_z * strand_36_z_by_q73;
        const double t73 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36 = sinew_sqrt(t73);
        const double t74 = 1.0 / length_36;
        const double length_36_by_q73 = t72 * t74;
        const double strand_36_x_by_q71 = layer_1_x_by_q71 + t71;
        const double strand_36_z_by_q71 = layer_1_z_by_q71 + t67;
        const double t75 = strand_36_x * strand_36_x_by_q71 - strand_36_y * layer_1_y_by_q71
            - strand_36_z * strand_36_z_by_q71;
        const double length_36_by_q71 = t75 * t74;
        const double t76 = 0.013 * y_x_by_q73;
        const double strand_35_x_by_q73 = layer_1_x_by_q73 + t76;
        const double t77 = 0.013 * y_x;
        const double strand_35_x = layer_1_x - t77;
        const double t78 = 0.013 * u_y_by_q73;
        const double strand_35_y_by_q73 = layer_1_y_by_q73 + t78;
        const double t79 = 0.013 * u_y;
        const double strand_35_y = 0.031 - layer_1_y - t79;
        const double t80 = 0.013 * y_z_by_q73;
        const double strand_35_z_by_q73 = layer_1_z_by_q73 + t80;
        const double t81 = 0.013 * y_z;
        const double strand_35_z = layer_1_z - t81;
        const double t82 = strand_35_x * strand_35_x_by_q73 - strand_35_y * strand_35_y_by_q73
            + strand_35_z * strand_35_z_by_q73;
        const double t83 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35 = sinew_sqrt(t83);
        const double t84 = 1.0 / length_35;
        const double length_35_by_q73 = t82 * t84;
        const double strand_35_x_by_q71 = layer_1_x_by_q71 + t81;
        const double strand_35_z_by_q71 = layer_1_z_by_q71 + t77;
        const double t85 = strand_35_x * strand_35_x_by_q71 - strand_35_y * layer_1_y_by_q71
            - strand_35_z * strand_35_z_by_q71;
        const double length_35_by_q71 = t85 * t84;
        const double t86 = 0.011 * y_x_by_q73;
        const double strand_34_x_by_q73 = layer_1_x_by_q73 + t86;
        const double t87 = 0.011 * y_x;
        const double strand_34_x = layer_1_x - t87;
        const double t88 = 0.011 * u_y_by_q73;
        const double strand_34_y_by_q73 = layer_1_y_by_q73 + t88;
        const double t89 = 0.011 * u_y;
        const double strand_34_y = 0.03 - layer_1_y - t89;
        const double t90 = 0.011 * y_z_by_q73;
        const double strand_34_z_by_q73 = layer_1_z_by_q73 + t90;
        const double t91 = 0.011 * y_z;
        const double strand_34_z = layer_1_z - t91;
        const double t92 = strand_34_x * strand_34_x_by_q73 - strand_34_y * strand_34_y_by_q73
            + strand_34_z * strand_34_z_by_q73;
        const double t93 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34 = sinew_sqrt(t93);
        const double t94 = 1.0 / length_34;
        const double length_34_by_q73 = t92 * t94;
        const double strand_34_x_by_q71 = layer_1_x_by_q71 + t91;
        const double strand_34_z_by_q71 = layer_1_z_by_q71 + t87;
        const double t95 = strand_34_x * strand_34_x_by_q71 - strand_34_y * layer_1_y_by_q71
            - strand_34_z * strand_34_z_by_q71;
        const double length_34_by_q71 = t95 * t94;
        const double t96 = 0.01 * y_x_by_q73;
        const double strand_33_x_by_q73 = layer_1_x_by_q73 + t96;
        const double t97 = 0.01 * y_x;
        const double strand_33_x = layer_1_x - t97;
        const double t98 = 0.01 * u_y_by_q73;
        const double strand_33_y_by_q73 = layer_1_y_by_q73 + t98;
        const double t99 = 0.01 * u_y;
        const double strand_33_y = 0.028 - layer_1_y - t99;
        const double t100 = 0.01 * y_z_by_q73;
        const double strand_33_z_by_q73 = layer_1_z_by_q73 + t100;
        const double t101 = 0.01 * y_z;
        const double strand_33_z = layer_1_z - t101;
        const double t102 = strand_33_x * strand_33_x_by_q73 - strand_33_y * strand_33_y_by_q73
            + strand_33_z * strand_33_z_by_q73;
        const double t103 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33 = sinew_sqrt(t103);
        const double t104 = 1.0 / length_33;
        const double length_33_by_q73 = t102 * t104;
        const double strand_33_x_by_q71 = layer_1_x_by_q71 + t101;
        const double strand_33_z_by_q71 = layer_1_z_by_q71 + t97;
        const double t105 = strand_33_x * strand_33_x_by_q71 - strand_33_y * layer_1_y_by_q71
            - strand_33_z * strand_33_z_by_q71;
        const double length_33_by_q71 = t105 * t104;
        const double t106 = 0.008 * y_x_by_q73;
        const double strand_32_x_by_q73 = layer_1_x_by_q73 + t106;
        const double t107 = 0.008 * y_x;
        const double strand_32_x = layer_1_x - t107;
        const double t108 = 0.008 * u_y_by_q73;
        const double strand_32_y_by_q73 = layer_1_y_by_q73 + t108;
        const double t109 = 0.008 * u_y;
        const double strand_32_y = 0.027 - layer_1_y - t109;
        const double t110 = 0.008 * y_z_by_q73;
        const double strand_32_z_by_q73 = layer_1_z_by_q73 + t110;
        const double t111 = 0.008 * y_z;
        const double strand_32_z = layer_1_z - t111;
        const double t112 = strand_32_x * strand_32_x_by_q73 - strand_32_y * strand_32_y_by_q73
            + strand_32_z * strand_32_z_by_q73;
        const double t113 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32 = sinew_sqrt(t113);
        const double t114 = 1.0 / length_32;
        const double length_32_by_q73 = t112 * t114;
        const double strand_32_x_by_q71 = layer_1_x_by_q71 + t111;
        const double strand_32_z_by_q71 = layer_1_z_by_q71 + t107;
        const double t115 = strand_32_x * strand_32_x_by_q71 - strand_32_y * layer_1_y_by_q71
            - strand_32_z * strand_32_z_by_q71;
        const double length_32_by_q71 = t115 * t114;
        const double t116 = 0.006 * y_x_by_q73;
        const double strand_31_x_by_q73 = layer_1_x_by_q73 + t116;
        const double t117 = 0.006 * y_x;
        const double strand_31_x = layer_1_x - t117;
        const double t118 = 0.006 * u_y_by_q73;
        const double strand_31_y_by_q73 = layer_1_y_by_q73 + t118;
        const double t119 = 0.006 * u_y;
        const double strand_31_y = 0.025 - layer_1_y - t119;
        const double t120 = 0.006 * y_z_by_q73;
        const double strand_31_z_by_q73 = layer_1_z_by_q73 + t120;
        const double t121 = 0.006 * y_z;
        const double strand_31_z = layer_1_z - t121;
        const double t122 = strand_31_x * strand_31_x_by_q73 - strand_31_y * strand_31_y_by_q73
            + strand_31_z * strand_31_z_by_q73;
        const double t123 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31 = sinew_sqrt(t123);
        const double t124 = 1.0 / length_31;
        const double length_31_by_q73 = t122 * t124;
        const double strand_31_x_by_q71 = layer_1_x_by_q71 + t121;
        const double strand_31_z_by_q71 = layer_1_z_by_q71 + t117;
        const double t125 = strand_31_x * strand_31_x_by_q71 - strand_31_y * layer_1_y_by_q71
            - strand_31_z * strand_31_z_by_q71;
        const double length_31_by_q71 = t125 * t124;
        const double t126 = 0.005 * y_x_by_q73;
        const double strand_30_x_by_q73 = layer_1_x_by_q73 + t126;
        const double t127 = 0.005 * y_x;
        const double strand_30_x = layer_1_x - t127;
        const double t128 = 0.005 * u_y_by_q73;
        const double strand_30_y_by_q73 = layer_1_y_by_q73 + t128;
        const double t129 = 0.005 * u_y;
        const double strand_30_y = 0.023 - layer_1_y - t129;
        const double t130 = 0.005 * y_z_by_q73;
        const double strand_30_z_by_q73 = layer_1_z_by_q73 + t130;
        const double t131 = 0.005 * y_z;
        const double strand_30_z = layer_1_z - t131;
        const double t132 = strand_30_x * strand_30_x_by_q73 - strand_30_y * strand_30_y_by_q73
            + strand_30_z * strand_30_z_by_q73;
        const double t133 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30 = sinew_sqrt(t133);
        const double t134 = 1.0 / length_30;
        const double length_30_by_q73 = t132 * t134;
        const double strand_30_x_by_q71 = layer_1_x_by_q71 + t131;
        const double strand_30_z_by_q71 = layer_1_z_by_q71 + t127;
        const double t135 = strand_30_x * strand_30_x_by_q71 - strand_30_y * layer_1_y_by_q71
            - strand_30_z * strand_30_z_by_q71;
        const double length_30_by_q71 = t135 * t134;
        const double t136 = 0.003 * y_x_by_q73;
        const double strand_29_x_by_q73 = layer_1_x_by_q73 + t136;
        const double t137 = 0.003 * y_x;
        const double strand_29_x = layer_1_x - t137;
        const double t138 = 0.003 * u_y_by_q73;
        const double strand_29_y_by_q73 = layer_1_y_by_q73 + t138;
        const double t139 = 0.003 * u_y;
        const double strand_29_y = 0.022 - layer_1_y - t139;
        const double t140 = 0.003 * y_z_by_q73;
        const double strand_29_z_by_q73 = layer_1_z_by_q73 + t140;
        const double t141 = 0.003 * y_z;
        const double strand_29_z = layer_1_z - t141;
        const double t142 = strand_29_x * strand_29_x_by_q73 - strand_29_y * strand_29_y_by_q73
            + strand_29_z * strand_29_z_by_q73;
        const double t143 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29 = sinew_sqrt(t143);
        const double t144 = 1.0 / length_29;
        const double length_29_by_q73 = t142 * t144;
        const double strand_29_x_by_q71 = layer_1_x_by_q71 + t141;
        const double strand_29_z_by_q71 = layer_1_z_by_q71 + t137;
        const double t145 = strand_29_x * strand_29_x_by_q71 - strand_29_y * layer_1_y_by_q71
            - strand_29_z * strand_29_z_by_q71;
        const double length_29_by_q71 = t145 * t144;
        const double t146 = 0.002 * y_x_by_q73;
        const double strand_28_x_by_q73 = layer_1_x_by_q73 + t146;
        const double t147 = 0.002 * y_x;
        const double strand_28_x = layer_1_x - t147;
        const double t148 = 0.002 * u_y_by_q73;
        const double strand_28_y_by_q73 = layer_1_y_by_q73 + t148;
        const double t149 = 0.002 * u_y;
        const double strand_28_y = 0.02 - layer_1_y - t149;
        const double t150 = 0.002 * y_z_by_q73;
        const double strand_28_z_by_q73 = layer_1_z_by_q73 + t150;
        const double t151 = 0.002 * y_z;
        const double strand_28_z = layer_1_z - t151;
        const double t152 = strand_28_x * strand_28_x_by_q73 - strand_28_y * strand_28_y_by_q73
            + strand_28_z * strand_28_z_by_q73;
        const double t153 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28 = sinew_sqrt(t153);
        const double t154 = 1.0 / length_28;
        const double length_28_by_q73 = t152 * t154;
        const double strand_28_x_by_q71 = layer_1_x_by_q71 + t151;
        const double strand_28_z_by_q71 = layer_1_z_by_q71 + t147;
        const double t155 = strand_28_x * strand_28_x_by_q71 - strand_28_y * layer_1_y_by_q71
            - strand_28_z * strand_28_z_by_q71;
        const double length_28_by_q71 = t155 * t154;
        const double strand_27_y = 0.019 - layer_1_y;
        const double t156 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73
            - strand_27_y * layer_1_y_by_q73;
        const double t157 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y
            * strand_27_y;
        const double length_27 = sinew_sqrt(t157);
        const double t158 = 1.0 / length_27;
        const double length_27_by_q73 = t156 * t158;
        const double t159 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71
            - strand_27_y * layer_1_y_by_q71;
        const double length_27_by_q71 = t159 * t158;
        const double strand_26_x_by_q73 = layer_1_x_by_q73 - t146;
        const double strand_26_x = layer_1_x + t147;
        const double strand_26_y_by_q73 = layer_1_y_by_q73 - t148;
        const double strand_26_y = 0.017 - layer_1_y + t149;
        const double strand_26_z_by_q73 = layer_1_z_by_q73 - t150;
        const double strand_26_z = layer_1_z + t151;
        const double t160 = strand_26_x * strand_26_x_by_q73 - strand_26_y * strand_26_y_by_q73
            + strand_26_z * strand_26_z_by_q73;
        const double t161 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26 = sinew_sqrt(t161);
        const double t162 = 1.0 / length_26;
        const double length_26_by_q73 = t160 * t162;
        const double strand_26_x_by_q71 = layer_1_x_by_q71 - t151;
        const double strand_26_z_by_q71 = layer_1_z_by_q71 - t147;
        const double t163 = strand_26_x * strand_26_x_by_q71 - strand_26_y * layer_1_y_by_q71
            - strand_26_z * strand_26_z_by_q71;
        const double length_26_by_q71 = t163 * t162;
        const double strand_25_x_by_q73 = layer_1_x_by_q73 - t136;
        const double strand_25_x = layer_1_x + t137;
        const double strand_25_y_by_q73 = layer_1_y_by_q73 - t138;
        const double strand_25_y = 0.015 - layer_1_y + t139;
        const double strand_25_z_by_q73 = layer_1_z_by_q73 - t140;
        const double strand_25_z = layer_1_z + t141;
        const double t164 = strand_25_x * strand_25_x_by_q73 - strand_25_y * strand_25_y_by_q73
            + strand_25_z * strand_25_z_by_q73;
        const double t165 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25 = sinew_sqrt(t165);
        const double t166 = 1.0 / length_25;
        const double length_25_by_q73 = t164 * t166;
        const double strand_25_x_by_q71 = layer_1_x_by_q71 - t141;
        const double strand_25_z_by_q71 = layer_1_z_by_q71 - t137;
        const double t167 = strand_25_x * strand_25_x_by_q71 - strand_25_y * layer_1_y_by_q71
            - strand_25_z * strand_25_z_by_q71;
        const double length_25_by_q71 = t167 * t166;
        const double strand_24_x_by_q73 = layer_1_x_by_q73 - t126;
        const double strand_24_x = layer_1_x + t127;
        const double strand_24_y_by_q73 = layer_1_y_by_q73 - t128;
        const double strand_24_y = 0.014 - layer_1_y + t129;
        const double strand_24_z_by_q73 = layer_1_z_by_q73 - t130;
        const double strand_24_z = layer_1_z + t131;
        const double t168 = strand_24_x * strand_24_x_by_q73 - strand_24_y * strand_24_y_by_q73
            + strand_24_z * strand_24_z_by_q73;
        const double t169 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24 = sinew_sqrt(t169);
        const double t170 = 1.0 / length_24;
        const double length_24_by_q73 = t168 * t170;
        const double strand_24_x_by_q71 = layer_1_x_by_q71 - t131;
        const double strand_24_z_by_q71 = layer_1_z_by_q71 - t127;
        const double t171 = strand_24_x * strand_24_x_by_q71 - strand_24_y * layer_1_y_by_q71
            - strand_24_z * strand_24_z_by_q71;
        const double length_24_by_q71 = t171 * t170;
        const double strand_23_x_by_q73 = layer_1_x_by_q73 - t116;
        const double strand_23_x = layer_1_x + t117;
        const double strand_23_y_by_q73 = layer_1_y_by_q73 - t118;
        const double strand_23_y = 0.012 - layer_1_y + t119;
        const double strand_23_z_by_q73 = layer_1_z_by_q73 - t120;
        const double strand_23_z = layer_1_z + t121;
        const double t172 = strand_23_x * strand_23_x_by_q73 - strand_23_y * strand_23_y_by_q73
            + strand_23_z * strand_23_z_by_q73;
        const double t173 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23 = sinew_sqrt(t173);
        const double t174 = 1.0 / length_23;
        const double length_23_by_q73 = t172 * t174;
        const double strand_23_x_by_q71 = layer_1_x_by_q71 - t121;
        const double strand_23_z_by_q71 = layer_1_z_by_q71 - t117;
        const double t175 = strand_23_x * strand_23_x_by_q71 - strand_23_y * layer_1_y_by_q71
            - strand_23_z * strand_23_z_by_q71;
        const double length_23_by_q71 = t175 * t174;
        const double strand_22_x_by_q73 = layer_1_x_by_q73 - t106;
        const double strand_22_x = layer_1_x + t107;
        const double strand_22_y_by_q73 = layer_1_y_by_q73 - t108;
        const double strand_22_y = 0.011 - layer_1_y + t109;
        const double strand_22_z_by_q73 = layer_1_z_by_q73 - t110;
        const double strand_22_z = layer_1_z + t111;
        const double t176 = strand_22_x * strand_22_x_by_q73 - strand_22_y * strand_22_y_by_q73
            + strand_22_z * strand_22_z_by_q73;
        const double t177 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22 = sinew_sqrt(t177);
        const double t178 = 1.0 / length_22;
        const double length_22_by_q73 = t176 * t178;
        const double strand_22_x_by_q71 = layer_1_x_by_q71 - t111;
        const double strand_22_z_by_q71 = layer_1_z_by_q71 - t107;
        const double t179 = strand_22_x * strand_22_x_by_q71 - strand_22_y * layer_1_y_by_q71
            - strand_22_z * strand_22_z_by_q71;
        const double length_22_by_q71 = t179 * t178;
        const double strand_21_x_by_q73 = layer_1_x_by_q73 - t96;
        const double strand_21_x = layer_1_x + t97;
        const double strand_21_y_by_q73 = layer_1_y_by_q73 - t98;
        const double strand_21_y = 0.009 - layer_1_y + t99;
        const double strand_21_z_by_q73 = layer_1_z_by_q73 - t100;
        const double strand_21_z = layer_1_z + t101;
        const double t180 = strand_21_x * strand_21_x_by_q73 - strand_21_y * strand_21_y_by_q73
            + strand_21_z * strand_21_z_by_q73;
        const double t181 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21 = sinew_sqrt(t181);
        const double t182 = 1.0 / length_21;
        const double length_21_by_q73 = t180 * t182;
        const double strand_21_x_by_q71 = layer_1_x_by_q71 - t101;
        const double strand_21_z_by_q71 = layer_1_z_by_q71 - t97;
        const double t183 = strand_21_x * strand_21_x_by_q71 - strand_21_y * layer_1_y_by_q71
            - strand_21_z * strand_21_z_by_q71;
        const double length_21_by_q71 = t183 * t182;
        const double strand_20_x_by_q73 = layer_1_x_by_q73 - t86;
        const double strand_20_x = layer_1_x + t87;
        const double strand_20_y_by_q73 = layer_1_y_by_q73 - t88;
        const double strand_20_y = 0.007 - layer_1_y + t89;
        const double strand_20_z_by_q73 = layer_1_z_by_q73 - t90;
        const double strand_20_z = layer_1_z + t91;
        const double t184 = strand_20_x * strand_20_x_by_q73 - strand_20_y * strand_20_y_by_q73
            + strand_20_z * strand_20_z_by_q73;
        const double t185 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20 = sinew_sqrt(t185);
        const double t186 = 1.0 / length_20;
        const double length_20_by_q73 = t184 * t186;
        const double strand_20_x_by_q71 = layer_1_x_by_q71 - t91;
        const double strand_20_z_by_q71 = layer_1_z_by_q71 - t87;
        const double t187 = strand_20_x * strand_20_x_by_q71 - strand_20_y * layer_1_y_by_q71
            - strand_20_z * strand_20_z_by_q71;
        const double length_20_by_q71 = t187 * t186;
        const double strand_19_x_by_q73 = layer_1_x_by_q73 - t76;
        const double strand_19_x = layer_1_x + t77;
        const double strand_19_y_by_q73 = layer_1_y_by_q73 - t78;
        const double strand_19_y = 0.006 - layer_1_y + t79;
        const double strand_19_z_by_q73 = layer_1_z_by_q73 - t80;
        const double strand_19_z = layer_1_z + t81;
        const double t188 = strand_19_x * strand_19_x_by_q73 - strand_19_y * strand_19_y_by_q73
            + strand_19_z * strand_19_z_by_q73;
        const double t189 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
            * strand_19_z;
        const double length_19 = sinew_sqrt(t189);
        const double t190 = 1.0 / length_19;
        const double length_19_by_q73 = t188 * t190;
        const double strand_19_x_by_q71 = layer_1_x_by_q71 - t81;
        const double strand_19_z_by_q71 = layer_1_z_by_q71 - t77;
        const double t191 = strand_19_x * strand_19_x_by_q71 - strand_19_y * layer_1_y_by_q71
            - strand_19_z * strand_19_z_by_q71;
        const double length_19_by_q71 = t191 * t190;
        const double layer_0_x_by_q73 = t27 + t28;
        const double strand_18_x_by_q73 = layer_0_x_by_q73 + 0.018 * y_x_by_q73;
        const double layer_0_x = t34 - t35;
        const double t192 = 0.018 * y_x;
        const double strand_18_x = layer_0_x - t192;
        const double layer_0_y_by_q73 = t37 + t38;
        const double strand_18_y_by_q73 = layer_0_y_by_q73 + 0.018 * u_y_by_q73;
        const double layer_0_y = t41 - t42;
        const double strand_18_y = 0.035 - layer_0_y - 0.018 * u_y;
        const double layer_0_z_by_q73 = t44 + t45;
        const double strand_18_z_by_q73 = layer_0_z_by_q73 + 0.018 * y_z_by_q73;
        const double layer_0_z = 0.008 - origin_z - t51 - t52;
        const double t193 = 0.018 * y_z;
        const double strand_18_z = layer_0_z - t193;
        const double t194 = strand_18_x * strand_18_x_by_q73 - strand_18_y * strand_18_y_by_q73
            + strand_18_z * strand_18_z_by_q73;
        const double t195 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18 = sinew_sqrt(t195);
        const double t196 = 1.0 / length_18;
        const double length_18_by_q73 = t194 * t196;
        const double layer_0_x_by_q71 = t59 + t60;
        const double strand_18_x_by_q71 = layer_0_x_by_q71 + t193;
        const double layer_0_y_by_q71 = t61 - t62;
        const double layer_0_z_by_q71 = t63 + t64;
        const double strand_18_z_by_q71 = layer_0_z_by_q71 + t192;
        const double t197 = strand_18_x * strand_18_x_by_q71 - strand_18_y * layer_0_y_by_q71
            - strand_18_z * strand_18_z_by_q71;
        const double length_18_by_q71 = t197 * t196;
        const double strand_17_x_by_q73 = layer_0_x_by_q73 + t29;
        const double strand_17_x = layer_0_x - t36;
        const double strand_17_y_by_q73 = layer_0_y_by_q73 + t39;
        const double strand_17_y = 0.034 - layer_0_y - t43;
        const double strand_17_z_by_q73 = layer_0_z_by_q73 + t46;
        const double strand_17_z = layer_0_z - t53;
        const double t198 = strand_17_x * strand_17_x_by_q73 - strand_17_y * strand_17_y_by_q73
            + strand_17_z * strand_17_z_by_q73;
        const double t199 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17 = sinew_sqrt(t199);
        const double t200 = 1.0 / length_17;
        const double length_17_by_q73 = t198 * t200;
        const double strand_17_x_by_q71 = layer_0_x_by_q71 + t53;
        const double strand_17_z_by_q71 = layer_0_z_by_q71 + t36;
        const double t201 = strand_17_x * strand_17_x_by_q71 - strand_17_y * layer_0_y_by_q71
            - strand_17_z * strand_17_z_by_q71;
        const double length_17_by_q71 = t201 * t200;
        const double strand_16_x_by_q73 = layer_0_x_by_q73 + t66;
        const double strand_16_x = layer_0_x - t67;
        const double strand_16_y_by_q73 = layer_0_y_by_q73 + t68;
        const double strand_16_y = 0.032 - layer_0_y - t69;
        const double strand_16_z_by_q73 = layer_0_z_by_q73 + t70;
        const double strand_16_z = layer_0_z - t71;
        const double t202 = strand_16_x * strand_16_x_by_q73 - strand_16_y * strand_16_y_by_q73
            + strand_16_z * strand_16_z_by_q73;
        const double t203 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16 = sinew_sqrt(t203);
        const double t204 = 1.0 / length_16;
        const double length_16_by_q73 = t202 * t204;
        const double strand_16_x_by_q71 = layer_0_x_by_q71 + t71;
        const double strand_16_z_by_q71 = layer_0_z_by_q71 + t67;
        const double t205 = strand_16_x * strand_16_x_by_q71 - strand_16_y * layer_0_y_by_q71
            - strand_16_z * strand_16_z_by_q71;
        const double length_16_by_q71 = t205 * t204;
        const double strand_15_x_by_q73 = layer_0_x_by_q73 + t76;
        const double strand_15_x = layer_0_x - t77;
        const double strand_15_y_by_q73 = layer_0_y_by_q73 + t78;
        const double strand_15_y = 0.031 - layer_0_y - t79;
        const double strand_15_z_by_q73 = layer_0_z_by_q73 + t80;
        const double strand_15_z = layer_0_z - t81;
        const double t206 = strand_15_x * strand_15_x_by_q73 - strand_15_y * strand_15_y_by_q73
            + strand_15_z * strand_15_z_by_q73;
        const double t207 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15 = sinew_sqrt(t207);
        const double t208 = 1.0 / length_15;
        const double length_15_by_q73 = t206 * t208;
        const double strand_15_x_by_q71 = layer_0_x_by_q71 + t81;
        const double strand_15_z_by_q71 = layer_0_z_by_q71 + t77;
        const double t209 = strand_15_x * strand_15_x_by_q71 - strand_15_y * layer_0_y_by_q71
            - strand_15_z * strand_15_z_by_q71;
        const double length_15_by_q71 = t209 * t208;
        const double strand_14_x_by_q73 = layer_0_x_by_q73 + t86;
        const double strand_14_x = layer_0_x - t87;
        const double strand_14_y_by_q73 = layer_0_y_by_q73 + t88;
        const double strand_14_y = 0.029 - layer_0_y - t89;
        const double strand_14_z_by_q73 = layer_0_z_by_q73 + t90;
        const double strand_14_z = layer_0_z - t91;
        const double t210 = strand_14_x * strand_14_x_by_q73 - strand_14_y * strand_14_y_by_q73
            + strand_14_z * strand_14_z_by_q73;
        const double t211 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14 = sinew_sqrt(t211);
        const double t212 = 1.0 / length_14;
        const double length_14_by_q73 = t210 * t212;
        const double strand_14_x_by_q71 = layer_0_x_by_q71 + t91;
        const double strand_14_z_by_q71 = layer_0_z_by_q71 + t87;
        const double t213 = strand_14_x * strand_14_x_by_q71 - strand_14_y * layer_0_y_by_q71
            - strand_14_z * strand_14_z_by_q71;
        const double length_14_by_q71 = t213 * t212;
        const double strand_13_x_by_q73 = layer_0_x_by_q73 + t96;
        const double strand_13_x = layer_0_x - t97;
        const double strand_13_y_by_q73 = layer_0_y_by_q73 + t98;
        const double strand_13_y = 0.027 - layer_0_y - t99;
        const double strand_13_z_by_q73 = layer_0_z_by_q73 + t100;
        const double strand_13_z = layer_0_z - t101;
        const double t214 = strand_13_x * strand_13_x_by_q73 - strand_13_y * strand_13_y_by_q73
            + strand_13_z * strand_13_z_by_q73;
        const double t215 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13 = sinew_sqrt(t215);
        const double t216 = 1.0 / length_13;
        const double length_13_by_q73 = t214 * t216;
        const double strand_13_x_by_q71 = layer_0_x_by_q71 + t101;
        const double strand_13_z_by_q71 = layer_0_z_by_q71 + t97;
        const double t217 = strand_13_x * strand_13_x_by_q71 - strand_13_y * layer_0_y_by_q71
            - strand_13_z * strand_13_z_by_q71;
        const double length_13_by_q71 = t217 * t216;
        const double strand_12_x_by_q73 = layer_0_x_by_q73 + t106;
        const double strand_12_x = layer_0_x - t107;
        const double strand_12_y_by_q73 = layer_0_y_by_q73 + t108;
        const double strand_12_y = 0.026 - layer_0_y - t109;
        const double strand_12_z_by_q73 = layer_0_z_by_q73 + t110;
        const double strand_12_z = layer_0_z - t111;
        const double t218 = strand_12_x * strand_12_x_by_q73 - strand_12_y * strand_12_y_by_q73
            + strand_12_z * strand_12_z_by_q73;
        const double t219 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12 = sinew_sqrt(t219);
        const double t220 = 1.0 / length_12;
        const double length_12_by_q73 = t218 * t220;
        const double strand_12_x_by_q71 = layer_0_x_by_q71 + t111;
        const double strand_12_z_by_q71 = layer_0_z_by_q71 + t107;
        const double t221 = strand_12_x * strand_12_x_by_q71 - strand_12_y * layer_0_y_by_q71
            - strand_12_z * strand_12_z_by_q71;
        const double length_12_by_q71 = t221 * t220;
        const double strand_11_x_by_q73 = layer_0_x_by_q73 + t116;
        const double strand_11_x = layer_0_x - t117;
        const double strand_11_y_by_q73 = layer_0_y_by_q73 + t118;
        const double strand_11_y = 0.024 - layer_0_y - t119;
        const double strand_11_z_by_q73 = layer_0_z_by_q73 + t120;
        const double strand_11_z = layer_0_z - t121;
        const double t222 = strand_11_x * strand_11_x_by_q73 - strand_11_y * strand_11_y_by_q73
            + strand_11_z * strand_11_z_by_q73;
        const double t223 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11 = sinew_sqrt(t223);
        const double t224 = 1.0 / length_11;
        const double length_11_by_q73 = t222 * t224;
        const double strand_11_x_by_q71 = layer_0_x_by_q71 + t121;
        const double strand_11_z_by_q71 = layer_0_z_by_q71 + t117;
        const double t225 = strand_11_x * strand_11_x_by_q71 - strand_11_y * layer_0_y_by_q71
            - strand_11_z * strand_11_z_by_q71;
        const double length_11_by_q71 = t225 * t224;
        const double strand_10_x_by_q73 = layer_0_x_by_q73 + t126;
        const double strand_10_x = layer_0_x - t127;
        const double strand_10_y_by_q73 = layer_0_y_by_q73 + t128;
        const double strand_10_y = 0.023 - layer_0_y - t129;
        const double strand_10_z_by_q73 = layer_0_z_by_q73 + t130;
        const double strand_10_z = layer_0_z - t131;
        const double t226 = strand_10_x * strand_10_x_by_q73 - strand_10_y * strand_10_y_by_q73
            + strand_10_z * strand_10_z_by_q73;
        const double t227 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10 = sinew_sqrt(t227);
        const double t228 = 1.0 / length_10;
        const double length_10_by_q73 = t226 * t228;
        const double strand_10_x_by_q71 = layer_0_x_by_q71 + t131;
        const double strand_10_z_by_q71 = layer_0_z_by_q71 + t127;
        const double t229 = strand_10_x * strand_10_x_by_q71 - strand_10_y * layer_0_y_by_q71
            - strand_10_z * strand_10_z_by_q71;
        const double length_10_by_q71 = t229 * t228;
        const double strand_9_x_by_q73 = layer_0_x_by_q73 + t136;
        const double strand_9_x = layer_0_x - t137;
        const double strand_9_y_by_q73 = layer_0_y_by_q73 + t138;
        const double strand_9_y = 0.021 - layer_0_y - t139;
        const double strand_9_z_by_q73 = layer_0_z_by_q73 + t140;
        const double strand_9_z = layer_0_z - t141;
        const double t230 = strand_9_x * strand_9_x_by_q73 - strand_9_y * strand_9_y_by_q73
            + strand_9_z * strand_9_z_by_q73;
        const double t231 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9 = sinew_sqrt(t231);
        const double t232 = 1.0 / length_9;
        const double length_9_by_q73 = t230 * t232;
        const double strand_9_x_by_q71 = layer_0_x_by_q71 + t141;
        const double strand_9_z_by_q71 = layer_0_z_by_q71 + t137;
        const double t233 = strand_9_x * strand_9_x_by_q71 - strand_9_y * layer_0_y_by_q71
            - strand_9_z * strand_9_z_by_q71;
        const double length_9_by_q71 = t233 * t232;
        const double strand_8_x_by_q73 = layer_0_x_by_q73 + t146;
        const double strand_8_x = layer_0_x - t147;
        const double strand_8_y_by_q73 = layer_0_y_by_q73 + t148;
        const double strand_8_y = 0.019 - layer_0_y - t149;
        const double strand_8_z_by_q73 = layer_0_z_by_q73 + t150;
        const double strand_8_z = layer_0_z - t151;
        const double t234 = strand_8_x * strand_8_x_by_q73 - strand_8_y * strand_8_y_by_q73
            + strand_8_z * strand_8_z_by_q73;
        const double t235 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8 = sinew_sqrt(t235);
        const double t236 = 1.0 / length_8;
        const double length_8_by_q73 = t234 * t236;
        const double strand_8_x_by_q71 = layer_0_x_by_q71 + t151;
        const double strand_8_z_by_q71 = layer_0_z_by_q71 + t147;
        const double t237 = strand_8_x * strand_8_x_by_q71 - strand_8_y * layer_0_y_by_q71
            - strand_8_z * strand_8_z_by_q71;
        const double length_8_by_q71 = t237 * t236;
        const double strand_7_y = 0.018 - layer_0_y;
        const double t238 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
            * layer_0_y_by_q73;
        const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z
            + strand_7_y * strand_7_y);
        const double t239 = 1.0 / length_7;
        const double length_7_by_q73 = t238 * t239;
        const double t240 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
            * layer_0_y_by_q71;
        const double length_7_by_q71 = t240 * t239;
        const double strand_6_x_by_q73 = layer_0_x_by_q73 - t146;
        const double strand_6_x = layer_0_x + t147;
        const double strand_6_y_by_q73 = layer_0_y_by_q73 - t148;
        const double strand_6_y = 0.016 - layer_0_y + t149;
        const double strand_6_z_by_q73 = layer_0_z_by_q73 - t150;
        const double strand_6_z = layer_0_z + t151;
        const double t241 = strand_6_x * strand_6_x_by_q73 - strand_6_y * strand_6_y_by_q73
            + strand_6_z * strand_6_z_by_q73;
        const double t242 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6 = sinew_sqrt(t242);
        const double t243 = 1.0 / length_6;
        const double length_6_by_q73 = t241 * t243;
        const double strand_6_x_by_q71 = layer_0_x_by_q71 - t151;
        const double strand_6_z_by_q71 = layer_0_z_by_q71 - t147;
        const double t244 = strand_6_x * strand_6_x_by_q71 - strand_6_y * layer_0_y_by_q71
            - strand_6_z * strand_6_z_by_q71;
        const double length_6_by_q71 = t244 * t243;
        const double strand_5_x_by_q73 = layer_0_x_by_q73 - t136;
        const double strand_5_x = layer_0_x + t137;
        const double strand_5_y_by_q73 = layer_0_y_by_q73 - t138;
        const double strand_5_y = 0.015 - layer_0_y + t139;
        const double strand_5_z_by_q73 = layer_0_z_by_q73 - t140;
        const double strand_5_z = layer_0_z + t141;
        const double t245 = strand_5_x * strand_5_x_by_q73 - strand_5_y * strand_5_y_by_q73
            + strand_5_z * strand_5_z_by_q73;
        const double t246 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5 = sinew_sqrt(t246);
        const double t247 = 1.0 / length_5;
        const double length_5_by_q73 = t245 * t247;
        const double strand_5_x_by_q71 = layer_0_x_by_q71 - t141;
        const double strand_5_z_by_q71 = layer_0_z_by_q71 - t137;
        const double t248 = strand_5_x * strand_5_x_by_q71 - strand_5_y * layer_0_y_by_q71
            - strand_5_z * strand_5_z_by_q71;
        const double length_5_by_q71 = t248 * t247;
        const double strand_4_x_by_q73 = layer_0_x_by_q73 - t126;
        const double strand_4_x = layer_0_x + t127;
        const double strand_4_y_by_q73 = layer_0_y_by_q73 - t128;
        const double strand_4_y = 0.013 - layer_0_y + t129;
        const double strand_4_z_by_q73 = layer_0_z_by_q73 - t130;
        const double strand_4_z = layer_0_z + t131;
        const double t249 = strand_4_x * strand_4_x_by_q73 - strand_4_y * strand_4_y_by_q73
            + strand_4_z * strand_4_z_by_q73;
        const double t250 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4 = sinew_sqrt(t250);
        const double t251 = 1.0 / length_4;
        const double length_4_by_q73 = t249 * t251;
        const double strand_4_x_by_q71 = layer_0_x_by_q71 - t131;
        const double strand_4_z_by_q71 = layer_0_z_by_q71 - t127;
        const double t252 = strand_4_x * strand_4_x_by_q71 - strand_4_y * layer_0_y_by_q71
            - strand_4_z * strand_4_z_by_q71;
        const double length_4_by_q71 = t252 * t251;
        const double strand_3_x_by_q73 = layer_0_x_by_q73 - t116;
        const double strand_3_x = layer_0_x + t117;
        const double strand_3_y_by_q73 = layer_0_y_by_q73 - t118;
        const double strand_3_y = 0.011 - layer_0_y + t119;
        const double strand_3_z_by_q73 = layer_0_z_by_q73 - t120;
        const double strand_3_z = layer_0_z + t121;
        const double t253 = strand_3_x * strand_3_x_by_q73 - strand_3_y * strand_3_y_by_q73
            + strand_3_z * strand_3_z_by_q73;
        const double t254 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3 = sinew_sqrt(t254);
        const double t255 = 1.0 / length_3;
        const double length_3_by_q73 = t253 * t255;
        const double strand_3_x_by_q71 = layer_0_x_by_q71 - t121;
        const double strand_3_z_by_q71 = layer_0_z_by_q71 - t117;
        const double t256 = strand_3_x * strand_3_x_by_q71 - strand_3_y * layer_0_y_by_q71
            - strand_3_z * strand_3_z_by_q71;
        const double length_3_by_q71 = t256 * t255;
        const double strand_2_x_by_q73 = layer_0_x_by_q73 - t106;
        const double strand_2_x = layer_0_x + t107;
        const double strand_2_y_by_q73 = layer_0_y_by_q73 - t108;
        const double strand_2_y = 0.01 - layer_0_y + t109;
        const double strand_2_z_by_q73 = layer_0_z_by_q73 - t110;
        const double strand_2_z = layer_0_z + t111;
        const double t257 = strand_2_x * strand_2_x_by_q73 - strand_2_y * strand_2_y_by_q73
            + strand_2_z * strand_2_z_by_q73;
        const double t258 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2 = sinew_sqrt(t258);
        const double t259 = 1.0 / length_2;
        const double length_2_by_q73 = t257 * t259;
        const double strand_2_x_by_q71 = layer_0_x_by_q71 - t111;
        const double strand_2_z_by_q71 = layer_0_z_by_q71 - t107;
        const double t260 = strand_2_x * strand_2_x_by_q71 - strand_2_y * layer_0_y_by_q71
            - strand_2_z * strand_2_z_by_q71;
        const double length_2_by_q71 = t260 * t259;
        const double strand_1_x_by_q73 = layer_0_x_by_q73 - t96;
        const double strand_1_x = layer_0_x + t97;
        const double strand_1_y_by_q73 = layer_0_y_by_q73 - t98;
        const double strand_1_y = 0.008 - layer_0_y + t99;
        const double strand_1_z_by_q73 = layer_0_z_by_q73 - t100;
        const double strand_1_z = layer_0_z + t101;
        const double t261 = strand_1_x * strand_1_x_by_q73 - strand_1_y * strand_1_y_by_q73
            + strand_1_z * strand_1_z_by_q73;
        const double t262 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1 = sinew_sqrt(t262);
        const double t263 = 1.0 / length_1;
        const double length_1_by_q73 = t261 * t263;
        const double strand_1_x_by_q71 = layer_0_x_by_q71 - t101;
        const double strand_1_z_by_q71 = layer_0_z_by_q71 - t97;
        const double t264 = strand_1_x * strand_1_x_by_q71 - strand_1_y * layer_0_y_by_q71
            - strand_1_z * strand_1_z_by_q71;
        const double length_1_by_q71 = t264 * t263;
        const double strand_0_x_by_q73 = layer_0_x_by_q73 - t86;
        const double strand_0_x = layer_0_x + t87;
        const double strand_0_y_by_q73 = layer_0_y_by_q73 - t88;
        const double strand_0_y = 0.007 - layer_0_y + t89;
        const double strand_0_z_by_q73 = layer_0_z_by_q73 - t90;
        const double strand_0_z = layer_0_z + t91;
        const double t265 = strand_0_x * strand_0_x_by_q73 - strand_0_y * strand_0_y_by_q73
            + strand_0_z * strand_0_z_by_q73;
        const double t266 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z
            * strand_0_z;
        const double length_0 = sinew_sqrt(t266);
        const double t267 = 1.0 / length_0;
        const double length_0_by_q73 = t265 * t267;
        const double strand_0_x_by_q71 = layer_0_x_by_q71 - t91;
        const double strand_0_z_by_q71 = layer_0_z_by_q71 - t87;
        const double t268 = strand_0_x * strand_0_x_by_q71 - strand_0_y * layer_0_y_by_q71
            - strand_0_z * strand_0_z_by_q71;
        const double length_0_by_q71 = t268 * t267;
        P[state] = length_0_by_q71;
        P[1 * n + state] = -length_0_by_q73;
        P[2 * n + state] = length_1_by_q71;
        P[3 * n + state] = -length_1_by_q73;
        P[4 * n + state] = length_2_by_q71;
        P[5 * n + state] = -length_2_by_q73;
        P[6 * n + state] = length_3_by_q71;
        P[7 * n + state] = -length_3_by_q73;
        P[8 * n + state] = length_4_by_q71;
        P[9 * n + state] = -length_4_by_q73;
        P[10 * n + state] = length_5_by_q71;
        P[11 * n + state] = -length_5_by_q73;
        P[12 * n + state] = length_6_by_q71;
        P[13 * n + state] = -length_6_by_q73;
        P[14 * n + state] = length_7_by_q71;
        P[15 * n + state] = -length_7_by_q73;
        P[16 * n + state] = length_8_by_q71;
        P[17 * n + state] = -length_8_by_q73;
        P[18 * n + state] = length_9_by_q71;
        P[19 * n + state] = -length_9_by_q73;
        P[20 * n + state] = length_10_by_q71;
        P[21 * n + state] = -length_10_by_q73;
        P[22 * n + state] = length_11_by_q71;
        P[23 * n + state] = -length_11_by_q73;
        P[24 * n + state] = length_12_by_q71;
        P[25 * n + state] = -length_12_by_q73;
        P[26 * n + state] = length_13_by_q71;
        P[27 * n + state] = -length_13_by_q73;
        P[28 * n + state] = length_14_by_q71;
        P[29 * n + state] = -length_14_by_q73;
        P[30 * n + state] = length_15_by_q71;
        P[31 * n + state] = -length_15_by_q73;
        P[32 * n + state] = length_16_by_q71;
        P[33 * n + state] = -length_16_by_q73;
        P[34 * n + state] = length_17_by_q71;
        P[35 * n + state] = -length_17_by_q73;
        P[36 * n + state] = length_18_by_q71;
        P[37 * n + state] = -length_18_by_q73;
        P[38 * n + state] = length_19_by_q71;
        P[39 * n + state] = -length_19_by_q73;
        P[40 * n + state] = length_20_by_q71;
        P[41 * n + state] = -length_20_by_q73;
        P[42 * n + state] = length_21_by_q71;
        P[43 * n + state] = -length_21_by_q73;
        P[44 * n + state] = length_22_by_q71;
        P[45 * n + state] = -length_22_by_q73;
        P[46 * n + state] = length_23_by_q71;
        P[47 * n + state] = -length_23_by_q73;
        P[48 * n + state] = length_24_by_q71;
        P[49 * n + state] = -length_24_by_q73;
        P[50 * n + state] = length_25_by_q71;
        P[51 * n + state] = -length_25_by_q73;
        P[52 * n + state] = length_26_by_q71;
        P[53 * n + state] = -length_26_by_q73;
        P[54 * n + state] = length_27_by_q71;
        P[55 * n + state] = -length_27_by_q73;
        P[56 * n + state] = length_28_by_q71;
        P[57 * n + state] = -length_28_by_q73;
        P[58 * n + state] = length_29_by_q71;
        P[59 * n + state] = -length_29_by_q73;
        P[60 * n + state] = length_30_by_q71;
        P[61 * n + state] = -length_30_by_q73;
        P[62 * n + state] = length_31_by_q71;
        P[63 * n + state] = -length_31_by_q73;
        P[64 * n + state] = length_32_by_q71;
        P[65 * n + state] = -length_32_by_q73;
        P[66 * n + state] = length_33_by_q71;
        P[67 * n + state] = -length_33_by_q73;
        P[68 * n + state] = length_34_by_q71;
        P[69 * n + state] = -length_34_by_q73;
        P[70 * n + state] = length_35_by_q71;
        P[71 * n + state] = -length_35_by_q73;
        P[72 * n + state] = length_36_by_q71;
        P[73 * n + state] = -length_36_by_q73;
        P[74 * n + state] = length_37_by_q71;
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double x_plane_x = u_y * sin_A;
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double t2 = 0.004 * x_z;
        const double t3 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t2 - t3;
        const double y_z = sin_q71 * u_e;
        const double t4 = 0.011 * y_z;
        const double strand_0_z = layer_0_z + t4;
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double M_x = cos_q71 * M_e;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double t5 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
        const double t6 = 0.01 * z_x;
        const double layer_0_x = t5 - t6;
        const double y_x = cos_q71 * u_e;
        const double t7 = 0.011 * y_x;
        const double strand_0_x = layer_0_x + t7;
        const double aside_y = x_x * strand_0_z + x_z * strand_0_x;
        const double x_plane_y = u_e * sin_A;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t8 = origin_y + 0.004 * x_plane_y;
        const double t9 = 0.01 * z_plane_y;
        const double layer_0_y = t8 - t9;
        const double t10 = 0.011 * u_y;
        const double strand_0_y = 0.007 - layer_0_y + t10;
        const double aside_x = x_plane_y * strand_0_z - x_z * strand_0_y;
        const double aside_z_2 = x_plane_y * strand_0_x + x_x * strand_0_y;
        const double t11 = sinew_sqrt(aside_x * aside_x + aside_y * aside_y + aside_z_2
            * aside_z_2);
        const double t12 = sinew_atan2(t11, x_plane_y * strand_0_y - x_x * strand_0_x + x_z
            * strand_0_z);
        const double t13 = sinew_atan2(sinew_sqrt(strand_0_y * strand_0_y + strand_0_z
            * strand_0_z), -strand_0_x);
        const double t14 = 0.01 * y_z;
        const double strand_1_z = layer_0_z + t14;
        const double t15 = 0.01 * y_x;
        const double strand_1_x = layer_0_x + t15;
        const double aside_y_2 = x_x * strand_1_z + x_z * strand_1_x;
        const double t16 = 0.01 * u_y;
        const double strand_1_y = 0.008 - layer_0_y + t16;
        const double aside_x_2 = x_plane_y * strand_1_z - x_z * strand_1_y;
        const double aside_z_6 = x_plane_y * strand_1_x + x_x * strand_1_y;
        const double t17 = sinew_sqrt(aside_x_2 * aside_x_2 + aside_y_2 * aside_y_2 + aside_z_6
            * aside_z_6);
        const double t18 = sinew_atan2(t17, x_plane_y * strand_1_y - x_x * strand_1_x + x_z
            * strand_1_z);
        const double t19 = sinew_atan2(sinew_sqrt(strand_1_y * strand_1_y + strand_1_z
            * strand_1_z), -strand_1_x);
        const double t20 = 0.008 * y_z;
        const double strand_2_z = layer_0_z + t20;
        const double t21 = 0.008 * y_x;
        const double strand_2_x = layer_0_x + t21;
        const double aside_y_4 = x_x * strand_2_z + x_z * strand_2_x;
        const double t22 = 0.008 * u_y;
        const double strand_2_y = 0.01 - layer_0_y + t22;
        const double aside_x_4 = x_plane_y * strand_2_z - x_z * strand_2_y;
        const double aside_z_10 = x_plane_y * strand_2_x + x_x * strand_2_y;
        const double t23 = sinew_sqrt(aside_x_4 * aside_x_4 + aside_y_4 * aside_y_4 + aside_z_10
            * aside_z_10);
        const double t24 = sinew_atan2(t23, x_plane_y * strand_2_y - x_x * strand_2_x + x_z
            * strand_2_z);
        const double t25 = sinew_atan2(sinew_sqrt(strand_2_y * strand_2_y + strand_2_z
            * strand_2_z), -strand_2_x);
        const double t26 = 0.006 * y_z;
        const double strand_3_z = layer_0_z + t26;
        const double t27 = 0.006 * y_x;
        const double strand_3_x = layer_0_x + t27;
        const double aside_y_6 = x_x * strand_3_z + x_z * strand_3_x;
        const double t28 = 0.006 * u_y;
        const double strand_3_y = 0.011 - layer_0_y + t28;
        const double aside_x_6 = x_plane_y * strand_3_z - x_z * strand_3_y;
        const double aside_z_14 = x_plane_y * strand_3_x + x_x * strand_3_y;
        const double t29 = sinew_sqrt(aside_x_6 * aside_x_6 + aside_y_6 * aside_y_6 + aside_z_14
            * aside_z_14);
        const double t30 = sinew_atan2(t29, x_plane_y * strand_3_y - x_x * strand_3_x + x_z
            * strand_3_z);
        const double t31 = sinew_atan2(sinew_sqrt(strand_3_y * strand_3_y + strand_3_z
            * strand_3_z), -strand_3_x);
        const double t32 = 0.005 * y_z;
        const double strand_4_z = layer_0_z + t32;
        const double t33 = 0.005 * y_x;
        const double strand_4_x = layer_0_x + t33;
        const double aside_y_8 = x_x * strand_4_z + x_z * strand_4_x;
        const double t34 = 0.005 * u_y;
        const double strand_4_y = 0.013 - layer_0_y + t34;
        const double aside_x_8 = x_plane_y * strand_4_z - x_z * strand_4_y;
        const double aside_z_18 = x_plane_y * strand_4_x + x_x * strand_4_y;
        const double t35 = sinew_sqrt(aside_x_8 * aside_x_8 + aside_y_8 * aside_y_8 + aside_z_18
            * aside_z_18);
        const double t36 = sinew_atan2(t35, x_plane_y * strand_4_y - x_x * strand_4_x + x_z
            * strand_4_z);
        const double t37 = sinew_atan2(sinew_sqrt(strand_4_y * strand_4_y + strand_4_z
            * strand_4_z), -strand_4_x);
        const double t38 = 0.003 * y_z;
        const double strand_5_z = layer_0_z + t38;
        const double t39 = 0.003 * y_x;
        const double strand_5_x = layer_0_x + t39;
        const double aside_y_10 = x_x * strand_5_z + x_z * strand_5_x;
        const double t40 = 0.003 * u_y;
        const double strand_5_y = 0.015 - layer_0_y + t40;
        const double aside_x_10 = x_plane_y * strand_5_z - x_z * strand_5_y;
        const double aside_z_22 = x_plane_y * strand_5_x + x_x * strand_5_y;
        const double t41 = aside_x_10 * aside_x_10 + aside_y_10 * aside_y_10 + aside_z_22
            * aside_z_22;
        const double t42 = sinew_atan2(sinew_sqrt(t41), x_plane_y * strand_5_y - x_x * strand_5_x
            + x_z * strand_5_z);
        const double t43 = sinew_atan2(sinew_sqrt(strand_5_y * strand_5_y + strand_5_z
            * strand_5_z), -strand_5_x);
        const double t44 = 0.002 * y_z;
        const double strand_6_z = layer_0_z + t44;
        const double t45 = 0.002 * y_x;
        const double strand_6_x = layer_0_x + t45;
        const double aside_y_12 = x_x * strand_6_z + x_z * strand_6_x;
        const double t46 = 0.002 * u_y;
        const double strand_6_y = 0.016 - layer_0_y + t46;
        const double aside_x_12 = x_plane_y * strand_6_z - x_z * strand_6_y;
        const double aside_z_26 = x_plane_y * strand_6_x + x_x * strand_6_y;
        const double t47 = aside_x_12 * aside_x_12 + aside_y_12 * aside_y_12 + aside_z_26
            * aside_z_26;
        const double t48 = sinew_atan2(sinew_sqrt(t47), x_plane_y * strand_6_y - x_x * strand_6_x
            + x_z * strand_6_z);
        const double t49 = sinew_atan2(sinew_sqrt(strand_6_y * strand_6_y + strand_6_z
            * strand_6_z), -strand_6_x);
        const double aside_y_14 = x_x * layer_0_z + x_z * layer_0_x;
        const double strand_7_y = 0.018 - layer_0_y;
        const double aside_x_14 = x_plane_y * layer_0_z - x_z * strand_7_y;
        const double aside_z_30 = x_plane_y * layer_0_x + x_x * strand_7_y;
        const double t50 = aside_x_14 * aside_x_14 + aside_y_14 * aside_y_14 + aside_z_30
            * aside_z_30;
        const double t51 = sinew_atan2(sinew_sqrt(t50), x_plane_y * strand_7_y - x_x * layer_0_x
            + x_z * layer_0_z);
        const double t52 = sinew_atan2(sinew_sqrt(layer_0_z * layer_0_z + strand_7_y * strand_7_y),
            -layer_0_x);
        const double strand_8_z = layer_0_z - t44;
        const double strand_8_x = layer_0_x - t45;
        const double aside_y_16 = x_x * strand_8_z + x_z * strand_8_x;
        const double strand_8_y = 0.019 - layer_0_y - t46;
        const double aside_x_16 = x_plane_y * strand_8_z - x_z * strand_8_y;
        const double aside_z_34 = x_plane_y * strand_8_x + x_x * strand_8_y;
        const double t53 = aside_x_16 * aside_x_16 + aside_y_16 * aside_y_16 + aside_z_34
            * aside_z_34;
        const double t54 = sinew_atan2(sinew_sqrt(t53), x_plane_y * strand_8_y - x_x * strand_8_x
            + x_z * strand_8_z);
        const double t55 = sinew_atan2(sinew_sqrt(strand_8_y * strand_8_y + strand_8_z
            * strand_8_z), -strand_8_x);
        const double strand_9_z = layer_0_z - t38;
        const double strand_9_x = layer_0_x - t39;
        const double aside_y_18 = x_x * strand_9_z + x_z * strand_9_x;
        const double strand_9_y = 0.021 - layer_0_y - t40;
        const double aside_x_18 = x_plane_y * strand_9_z - x_z * strand_9_y;
        const double aside_z_38 = x_plane_y * strand_9_x + x_x * strand_9_y;
        const double t56 = aside_x_18 * aside_x_18 + aside_y_18 * aside_y_18 + aside_z_38
            * aside_z_38;
        const double t57 = sinew_atan2(sinew_sqrt(t56), x_plane_y * strand_9_y - x_x * strand_9_x
            + x_z * strand_9_z);
        const double t58 = sinew_atan2(sinew_sqrt(strand_9_y * strand_9_y + strand_9_z
            * strand_9_z), -strand_9_x);
        const double strand_10_z = layer_0_z - t32;
        const double strand_10_x = layer_0_x - t33;
        const double aside_y_20 = x_x * strand_10_z + x_z * strand_10_x;
        const double strand_10_y = 0.023 - layer_0_y - t34;
        const double aside_x_20 = x_plane_y * strand_10_z - x_z * strand_10_y;
        const double aside_z_42 = x_plane_y * strand_10_x + x_x * strand_10_y;
        const double t59 = aside_x_20 * aside_x_20 + aside_y_20 * aside_y_20 + aside_z_42
            * aside_z_42;
        const double t60 = sinew_atan2(sinew_sqrt(t59), x_plane_y * strand_10_y - x_x * strand_10_x
            + x_z * strand_10_z);
        const double t61 = sinew_atan2(sinew_sqrt(strand_10_y * strand_10_y + strand_10_z
            * strand_10_z), -strand_10_x);
        const double strand_11_z = layer_0_z - t26;
        const double strand_11_x = layer_0_x - t27;
        const double aside_y_22 = x_x * strand_11_z + x_z * strand_11_x;
        const double strand_11_y = 0.024 - layer_0_y - t28;
        const double aside_x_22 = x_plane_y * strand_11_z - x_z * strand_11_y;
        const double aside_z_46 = x_plane_y * strand_11_x + x_x * strand_11_y;
        const double t62 = aside_x_22 * aside_x_22 + aside_y_22 * aside_y_22 + aside_z_46
            * aside_z_46;
        const double t63 = sinew_atan2(sinew_sqrt(t62), x_plane_y * strand_11_y - x_x * strand_11_x
            + x_z * strand_11_z);
        const double t64 = sinew_atan2(sinew_sqrt(strand_11_y * strand_11_y + strand_11_z
            * strand_11_z), -strand_11_x);
        const double strand_12_z = layer_0_z - t20;
        const double strand_12_x = layer_0_x - t21;
        const double aside_y_24 = x_x * strand_12_z + x_z * strand_12_x;
        const double strand_12_y = 0.026 - layer_0_y - t22;
        const double aside_x_24 = x_plane_y * strand_12_z - x_z * strand_12_y;
        const double aside_z_50 = x_plane_y * strand_12_x + x_x * strand_12_y;
        const double t65 = aside_x_24 * aside_x_24 + aside_y_24 * aside_y_24 + aside_z_50
            * aside_z_50;
        const double t66 = sinew_atan2(sinew_sqrt(t65), x_plane_y * strand_12_y - x_x * strand_12_x
            + x_z * strand_12_z);
        const double t67 = sinew_atan2(sinew_sqrt(strand_12_y * strand_12_y + strand_12_z
            * strand_12_z), -strand_12_x);
        const double strand_13_z = layer_0_z - t14;
        const double strand_13_x = layer_0_x - t15;
        const double aside_y_26 = x_x * strand_13_z + x_z * strand_13_x;
        const double strand_13_y = 0.027 - layer_0_y - t16;
        const double aside_x_26 = x_plane_y * strand_13_z - x_z * strand_13_y;
        const double aside_z_54 = x_plane_y * strand_13_x + x_x * strand_13_y;
        const double t68 = aside_x_26 * aside_x_26 + aside_y_26 * aside_y_26 + aside_z_54
            * aside_z_54;
        const double t69 = sinew_atan2(sinew_sqrt(t68), x_plane_y * strand_13_y - x_x * strand_13_x
            + x_z * strand_13_z);
        const double t70 = sinew_atan2(sinew_sqrt(strand_13_y * strand_13_y + strand_13_z
            * strand_13_z), -strand_13_x);
        const double strand_14_z = layer_0_z - t4;
        const double strand_14_x = layer_0_x - t7;
        const double aside_y_28 = x_x * strand_14_z + x_z * strand_14_x;
        const double strand_14_y = 0.029 - layer_0_y - t10;
        const double aside_x_28 = x_plane_y * strand_14_z - x_z * strand_14_y;
        const double aside_z_58 = x_plane_y * strand_14_x + x_x * strand_14_y;
        const double t71 = aside_x_28 * aside_x_28 + aside_y_28 * aside_y_28 + aside_z_58
            * aside_z_58;
        const double t72 = sinew_atan2(sinew_sqrt(t71), x_plane_y * strand_14_y - x_x * strand_14_x
            + x_z * strand_14_z);
        const double t73 = sinew_atan2(sinew_sqrt(strand_14_y * strand_14_y + strand_14_z
            * strand_14_z), -strand_14_x);
        const double t74 = 0.013 * y_z;
        const double strand_15_z = layer_0_z - t74;
        const double t75 = 0.013 * y_x;
        const double strand_15_x = layer_0_x - t75;
        const double aside_y_30 = x_x * strand_15_z + x_z * strand_15_x;
        const double t76 = 0.013 * u_y;
        const double strand_15_y = 0.031 - layer_0_y - t76;
        const double aside_x_30 = x_plane_y * strand_15_z - x_z * strand_15_y;
        const double aside_z_62 = x_plane_y * strand_15_x + x_x * strand_15_y;
        const double t77 = aside_x_30 * aside_x_30 + aside_y_30 * aside_y_30 + aside_z_62
            * aside_z_62;
        const double t78 = sinew_atan2(sinew_sqrt(t77), x_plane_y * strand_15_y - x_x * strand_15_x
            + x_z * strand_15_z);
        const double t79 = sinew_atan2(sinew_sqrt(strand_15_y * strand_15_y + strand_15_z
            * strand_15_z), -strand_15_x);
        const double t80 = 0.014 * y_z;
        const double strand_16_z = layer_0_z - t80;
        const double t81 = 0.014 * y_x;
        const double strand_16_x = layer_0_x - t81;
        const double aside_y_32 = x_x * strand_16_z + x_z * strand_16_x;
        const double t82 = 0.014 * u_y;
        const double strand_16_y = 0.032 - layer_0_y - t82;
        const double aside_x_32 = x_plane_y * strand_16_z - x_z * strand_16_y;
        const double aside_z_66 = x_plane_y * strand_16_x + x_x * strand_16_y;
        const double t83 = aside_x_32 * aside_x_32 + aside_y_32 * aside_y_32 + aside_z_66
            * aside_z_66;
        const double t84 = sinew_atan2(sinew_sqrt(t83), x_plane_y * strand_16_y - x_x * strand_16_x
            + x_z * strand_16_z);
        const double t85 = sinew_atan2(sinew_sqrt(strand_16_y * strand_16_y + strand_16_z
            * strand_16_z), -strand_16_x);
        const double t86 = 0.016 * y_z;
        const double strand_17_z = layer_0_z - t86;
        const double t87 = 0.016 * y_x;
        const double strand_17_x = layer_0_x - t87;
        const double aside_y_34 = x_x * strand_17_z + x_z * strand_17_x;
        const double t88 = 0.016 * u_y;
        const double strand_17_y = 0.034 - layer_0_y - t88;
        const double aside_x_34 = x_plane_y * strand_17_z - x_z * strand_17_y;
        const double aside_z_70 = x_plane_y * strand_17_x + x_x * strand_17_y;
        const double t89 = aside_x_34 * aside_x_34 + aside_y_34 * aside_y_34 + aside_z_70
            * aside_z_70;
        const double t90 = sinew_atan2(sinew_sqrt(t89), x_plane_y * strand_17_y - x_x * strand_17_x
            + x_z * strand_17_z);
        const double t91 = sinew_atan2(sinew_sqrt(strand_17_y * strand_17_y + strand_17_z
            * strand_17_z), -strand_17_x);
        const double strand_18_z = layer_0_z - 0.018 * y_z;
        const double strand_18_x = layer_0_x - 0.018 * y_x;
        const double aside_y_36 = x_x * strand_18_z + x_z * strand_18_x;
        const double strand_18_y = 0.035 - layer_0_y - 0.018 * u_y;
        const double aside_x_36 = x_plane_y * strand_18_z - x_z * strand_18_y;
        const double aside_z_74 = x_plane_y * strand_18_x + x_x * strand_18_y;
        const double t92 = aside_x_36 * aside_x_36 + aside_y_36 * aside_y_36 + aside_z_74
            * aside_z_74;
        const double t93 = sinew_atan2(sinew_sqrt(t92), x_plane_y * strand_18_y - x_x * strand_18_x
            + x_z * strand_18_z);
        const double t94 = sinew_atan2(sinew_sqrt(strand_18_y * strand_18_y + strand_18_z
            * strand_18_z), -strand_18_x);
        const double layer_1_z = 0.028 - origin_z - t2 + t3;
        const double strand_19_z = layer_1_z + t74;
        const double layer_1_x = t5 + t6;
        const double strand_19_x = layer_1_x + t75;
        const double aside_y_38 = x_x * strand_19_z + x_z * strand_19_x;
        const double layer_1_y = t8 + t9;
        const double strand_19_y = 0.006 - layer_1_y + t76;
        const double aside_x_38 = x_plane_y * strand_19_z - x_z * strand_19_y;
        const double aside_z_78 = x_plane_y * strand_19_x + x_x * strand_19_y;
        const double t95 = aside_x_38 * aside_x_38 + aside_y_38 * aside_y_38 + aside_z_78
            * aside_z_78;
        const double t96 = sinew_atan2(sinew_sqrt(t95), x_plane_y * strand_19_y - x_x * strand_19_x
            + x_z * strand_19_z);
        const double t97 = sinew_atan2(sinew_sqrt(strand_19_y * strand_19_y + strand_19_z
            * strand_19_z), -strand_19_x);
        const double strand_20_z = layer_1_z + t4;
        const double strand_20_x = layer_1_x + t7;
        const double aside_y_40 = x_x * strand_20_z + x_z * strand_20_x;
        const double strand_20_y = 0.007 - layer_1_y + t10;
        const double aside_x_40 = x_plane_y * strand_20_z - x_z * strand_20_y;
        const double aside_z_82 = x_plane_y * strand_20_x + x_x * strand_20_y;
        const double t98 = aside_x_40 * aside_x_40 + aside_y_40 * aside_y_40 + aside_z_82
            * aside_z_82;
        const double t99 = sinew_atan2(sinew_sqrt(t98), x_plane_y * strand_20_y - x_x * strand_20_x
            + x_z * strand_20_z);
        const double t100 = sinew_atan2(sinew_sqrt(strand_20_y * strand_20_y + strand_20_z
            * strand_20_z), -strand_20_x);
        const double strand_21_z = layer_1_z + t14;
        const double strand_21_x = layer_1_x + t15;
        const double aside_y_42 = x_x * strand_21_z + x_z * strand_21_x;
        const double strand_21_y = 0.009 - layer_1_y + t16;
        const double aside_x_42 = x_plane_y * strand_21_z - x_z * strand_21_y;
        const double aside_z_86 = x_plane_y * strand_21_x + x_x * strand_21_y;
        const double t101 = aside_x_42 * aside_x_42 + aside_y_42 * aside_y_42 + aside_z_86
            * aside_z_86;
        const double t102 = sinew_atan2(sinew_sqrt(t101), x_plane_y * strand_21_y - x_x
            * strand_21_x + x_z * strand_21_z);
        const double t103 = sinew_atan2(sinew_sqrt(strand_21_y * strand_21_y + strand_21_z
            * strand_21_z), -strand_21_x);
        const double strand_22_z = layer_1_z + t20;
        const double strand_22_x = layer_1_x + t21;
        const double aside_y_44 = x_x * strand_22_z + x_z * strand_22_x;
        const double strand_22_y = 0.011 - layer_1_y + t22;
        const double aside_x_44 = x_plane_y * strand_22_z - x_z * strand_22_y;
        const double aside_z_90 = x_plane_y * strand_22_x + x_x * strand_22_y;
        const double t104 = aside_x_44 * aside_x_44 + aside_y_44 * aside_y_44 + aside_z_90
            * aside_z_90;
        const double t105 = sinew_atan2(sinew_sqrt(t104), x_plane_y * strand_22_y - x_x
            * strand_22_x + x_z * strand_22_z);
        const double t106 = sinew_atan2(sinew_sqrt(strand_22_y * strand_22_y + strand_22_z
            * strand_22_z), -strand_22_x);
        const double strand_23_z = layer_1_z + t26;
        const double strand_23_x = layer_1_x + t27;
        const double aside_y_46 = x_x * strand_23_z + x_z * strand_23_x;
        const double strand_23_y = 0.012 - layer_1_y + t28;
        const double aside_x_46 = x_plane_y * strand_23_z - x_z * strand_23_y;
        const double aside_z_94 = x_plane_y * strand_23_x + x_x * strand_23_y;
        const double t107 = aside_x_46 * aside_x_46 + aside_y_46 * aside_y_46 + aside_z_94
            * aside_z_94;
        const double t108 = sinew_atan2(sinew_sqrt(t107), x_plane_y * strand_23_y - x_x
            * strand_23_x + x_z * strand_23_z);
        const double t109 = sinew_atan2(sinew_sqrt(strand_23_y * strand_23_y + strand_23_z
            * strand_23_z), -strand_23_x);
        const double strand_24_z = layer_1_z + t32;
        const double strand_24_x = layer_1_x + t33;
        const double aside_y_48 = x_x * strand_24_z + x_z * strand_24_x;
        const double strand_24_y = 0.014 - layer_1_y + t34;
        const double aside_x_48 = x_plane_y * strand_24_z - x_z * strand_24_y;
        const double aside_z_98 = x_plane_y * strand_24_x + x_x * strand_24_y;
        const double t110 = aside_x_48 * aside_x_48 + aside_y_48 * aside_y_48 + aside_z_98
            * aside_z_98;
        const double t111 = sinew_atan2(sinew_sqrt(t110), x_plane_y * strand_24_y - x_x
            * strand_24_x + x_z * strand_24_z);
        const double t112 = sinew_atan2(sinew_sqrt(strand_24_y * strand_24_y + strand_24_z
            * strand_24_z), -strand_24_x);
        const double strand_25_z = layer_1_z + t38;
        const double strand_25_x = layer_1_x + t39;
        const double aside_y_50 = x_x * strand_25_z + x_z * strand_25_x;
        const double strand_25_y = 0.015 - layer_1_y + t40;
        const double aside_x_50 = x_plane_y * strand_25_z - x_z * strand_25_y;
        const double aside_z_102 = x_plane_y * strand_25_x + x_x * strand_25_y;
        const double t113 = aside_x_50 * aside_x_50 + aside_y_50 * aside_y_50 + aside_z_102
            * aside_z_102;
        const double t114 = sinew_atan2(sinew_sqrt(t113), x_plane_y * strand_25_y - x_x
            * strand_25_x + x_z * strand_25_z);
        const double t115 = sinew_atan2(sinew_sqrt(strand_25_y * strand_25_y + strand_25_z
            * strand_25_z), -strand_25_x);
        const double strand_26_z = layer_1_z + t44;
        const double strand_26_x = layer_1_x + t45;
        const double aside_y_52 = x_x * strand_26_z + x_z * strand_26_x;
        const double strand_26_y = 0.017 - layer_1_y + t46;
        const double aside_x_52 = x_plane_y * strand_26_z - x_z * strand_26_y;
        const double aside_z_106 = x_plane_y * strand_26_x + x_x * strand_26_y;
        const double t116 = aside_x_52 * aside_x_52 + aside_y_52 * aside_y_52 + aside_z_106
            * aside_z_106;
        const double t117 = sinew_atan2(sinew_sqrt(t116), x_plane_y * strand_26_y - x_x
            * strand_26_x + x_z * strand_26_z);
        const double t118 = sinew_atan2(sinew_sqrt(strand_26_y * strand_26_y + strand_26_z
            * strand_26_z), -strand_26_x);
        const double aside_y_54 = x_x * layer_1_z + x_z * layer_1_x;
        const double strand_27_y = 0.019 - layer_1_y;
        const double aside_x_54 = x_plane_y * layer_1_z - x_z * strand_27_y;
        const double aside_z_110 = x_plane_y * layer_1_x + x_x * strand_27_y;
        const double t119 = aside_x_54 * aside_x_54 + aside_y_54 * aside_y_54 + aside_z_110
            * aside_z_110;
        const double t120 = sinew_atan2(sinew_sqrt(t119), x_plane_y * strand_27_y - x_x * layer_1_x
            + x_z * layer_1_z);
        const double t121 = sinew_atan2(sinew_sqrt(layer_1_z * layer_1_z + strand_27_y
            * strand_27_y), -layer_1_x);
        const double strand_28_z = layer_1_z - t44;
        const double strand_28_x = layer_1_x - t45;
        const double aside_y_56 = x_x * strand_28_z + x_z * strand_28_x;
        const double strand_28_y = 0.02 - layer_1_y - t46;
        const double aside_x_56 = x_plane_y * strand_28_z - x_z * strand_28_y;
        const double aside_z_114 = x_plane_y * strand_28_x + x_x * strand_28_y;
        const double t122 = aside_x_56 * aside_x_56 + aside_y_56 * aside_y_56 + aside_z_114
            * aside_z_114;
        const double t123 = sinew_atan2(sinew_sqrt(t122), x_plane_y * strand_28_y - x_x
            * strand_28_x + x_z * strand_28_z);
        const double t124 = sinew_atan2(sinew_sqrt(strand_28_y * strand_28_y + strand_28_z
            * strand_28_z), -strand_28_x);
        const double strand_29_z = layer_1_z - t38;
        const double strand_29_x = layer_1_x - t39;
        const double aside_y_58 = x_x * strand_29_z + x_z * strand_29_x;
        const double strand_29_y = 0.022 - layer_1_y - t40;
        const double aside_x_58 = x_plane_y * strand_29_z - x_z * strand_29_y;
        const double aside_z_118 = x_plane_y * strand_29_x + x_x * strand_29_y;
        const double t125 = aside_x_58 * aside_x_58 + aside_y_58 * aside_y_58 + aside_z_118
            * aside_z_118;
        const double t126 = sinew_atan2(sinew_sqrt(t125), x_plane_y * strand_29_y - x_x
            * strand_29_x + x_z * strand_29_z);
        const double t127 = sinew_atan2(sinew_sqrt(strand_29_y * strand_29_y + strand_29_z
            * strand_29_z), -strand_29_x);
        const double strand_30_z = layer_1_z - t32;
        const double strand_30_x = layer_1_x - t33;
        const double aside_y_60 = x_x * strand_30_z + x_z * strand_30_x;
        const double strand_30_y = 0.023 - layer_1_y - t34;
        const double aside_x_60 = x_plane_y * strand_30_z - x_z * strand_30_y;
        const double aside_z_122 = x_plane_y * strand_30_x + x_x * strand_30_y;
        const double t128 = aside_x_60 * aside_x_60 + aside_y_60 * aside_y_60 + aside_z_122
            * aside_z_122;
        const double t129 = sinew_atan2(sinew_sqrt(t128), x_plane_y * strand_30_y - x_x
            * strand_30_x + x_z * strand_30_z);
        const double t130 = sinew_atan2(sinew_sqrt(strand_30_y * strand_30_y + strand_30_z
            * strand_30_z), -strand_30_x);
        const double strand_31_z = layer_1_z - t26;
        const double strand_31_x = layer_1_x - t27;
        const double aside_y_62 = x_x * strand_31_z + x_z * strand_31_x;
        const double strand_31_y = 0.025 - layer_1_y - t28;
        const double aside_x_62 = x_plane_y * strand_31_z - x_z * strand_31_y;
        const double aside_z_126 = x_plane_y * strand_31_x + x_x * strand_31_y;
        const double t131 = aside_x_62 * aside_x_62 + aside_y_62 * aside_y_62 + aside_z_126
            * aside_z_126;
        const double t132 = sinew_atan2(sinew_sqrt(t131), x_plane_y * strand_31_y - x_x
            * strand_31_x + x_z * strand_31_z);
        const double t133 = sinew_atan2(sinew_sqrt(strand_31_y * strand_31_y + strand_31_z
            * strand_31_z), -strand_31_x);
        const double strand_32_z = layer_1_z - t20;
        const double strand_32_x = layer_1_x - t21;
        const double aside_y_64 = x_x * strand_32_z + x_z * strand_32_x;
        const double strand_32_y = 0.027 - layer_1_y - t22;
        const double aside_x_64 = x_plane_y * strand_32_z - x_z * strand_32_y;
        const double aside_z_130 = x_plane_y * strand_32_x + x_x * strand_32_y;
        const double t134 = aside_x_64 * aside_x_64 + aside_y_64 * aside_y_64 + aside_z_130
            * aside_z_130;
        const double t135 = sinew_atan2(sinew_sqrt(t134), x_plane_y * strand_32_y - x_x
            * strand_32_x + x_z * strand_32_z);
        const double t136 = sinew_atan2(sinew_sqrt(strand_32_y * strand_32_y + strand_32_z
            * strand_32_z), -strand_32_x);
        const double strand_33_z = layer_1_z - t14;
        const double strand_33_x = layer_1_x - t15;
        const double aside_y_66 = x_x * strand_33_z + x_z * strand_33_x;
        const double strand_33_y = 0.028 - layer_1_y - t16;
        const double aside_x_66 = x_plane_y * strand_33_z - x_z * strand_33_y;
        const double aside_z_134 = x_plane_y * strand_33_x + x_x * strand_33_y;
        const double t137 = aside_x_66 * aside_x_66 + aside_y_66 * aside_y_66 + aside_z_134
            * aside_z_134;
        const double t138 = sinew_atan2(sinew_sqrt(t137), x_plane_y * strand_33_y - x_x
            * strand_33_x + x_z * strand_33_z);
        const double t139 = sinew_atan2(sinew_sqrt(strand_33_y * strand_33_y + strand_33_z
            * strand_33_z), -strand_33_x);
        const double strand_34_z = layer_1_z - t4;
        const double strand_34_x = layer_1_x - t7;
        const double aside_y_68 = x_x * strand_34_z + x_z * strand_34_x;
        const double strand_34_y = 0.03 - layer_1_y - t10;
        const double aside_x_68 = x_plane_y * strand_34_z - x_z * strand_34_y;
        const double aside_z_138 = x_plane_y * strand_34_x + x_x * strand_34_y;
        const double t140 = aside_x_68 * aside_x_68 + aside_y_68 * aside_y_68 + aside_z_138
            * aside_z_138;
        const double t141 = sinew_atan2(sinew_sqrt(t140), x_plane_y * strand_34_y - x_x
            * strand_34_x + x_z * strand_34_z);
        const double t142 = sinew_atan2(sinew_sqrt(strand_34_y * strand_34_y + strand_34_z
            * strand_34_z), -strand_34_x);
        const double strand_35_z = layer_1_z - t74;
        const double strand_35_x = layer_1_x - t75;
        const double aside_y_70 = x_x * strand_35_z + x_z * strand_35_x;
        const double strand_35_y = 0.031 - layer_1_y - t76;
        const double aside_x_70 = x_plane_y * strand_35_z - x_z * strand_35_y;
        const double aside_z_142 = x_plane_y * strand_35_x + x_x * strand_35_y;
        const double t143 = aside_x_70 * aside_x_70 + aside_y_70 * aside_y_70 + aside_z_142
            * aside_z_142;
        const double t144 = sinew_atan2(sinew_sqrt(t143), x_plane_y * strand_35_y - x_x
            * strand_35_x + x_z * strand_35_z);
        const double t145 = sinew_atan2(sinew_sqrt(strand_35_y * strand_35_y + strand_35_z
            * strand_35_z), -strand_35_x);
        const double strand_36_z = layer_1_z - t80;
        const double strand_36_x = layer_1_x - t81;
        const double aside_y_72 = x_x * strand_36_z + x_z * strand_36_x;
        const double strand_36_y = 0.033 - layer_1_y - t82;
        const double aside_x_72 = x_plane_y * strand_36_z - x_z * strand_36_y;
        const double aside_z_146 = x_plane_y * strand_36_x + x_x * strand_36_y;
        const double t146 = aside_x_72 * aside_x_72 + aside_y_72 * aside_y_72 + aside_z_146
            * aside_z_146;
        const double t147 = sinew_atan2(sinew_sqrt(t146), x_plane_y * strand_36_y - x_x
            * strand_36_x + x_z * strand_36_z);
        const double t148 = sinew_atan2(sinew_sqrt(strand_36_y * strand_36_y + strand_36_z
            * strand_36_z), -strand_36_x);
        const double strand_37_z = layer_1_z - t86;
        const double strand_37_x = layer_1_x - t87;
        const double aside_y_74 = x_x * strand_37_z + x_z * strand_37_x;
        const double strand_37_y = 0.035 - layer_1_y - t88;
        const double aside_x_74 = x_plane_y * strand_37_z - x_z * strand_37_y;
        const double aside_z_150 = x_plane_y * strand_37_x + x_x * strand_37_y;
        const double t149 = aside_x_74 * aside_x_74 + aside_y_74 * aside_y_74 + aside_z_150
            * aside_z_150;
        const double t150 = sinew_atan2(sinew_sqrt(t149), x_plane_y * strand_37_y - x_x
            * strand_37_x + x_z * strand_37_z);
        const double t151 = sinew_atan2(sinew_sqrt(strand_37_y * strand_37_y + strand_37_z
            * strand_37_z), -strand_37_x);
        angles[state] = t12 + t13;
        angles[1 * n + state] = t18 + t19;
        angles[2 * n + state] = t24 + t25;
        angles[3 * n + state] = t30 + t31;
        angles[4 * n + state] = t36 + t37;
        angles[5 * n + state] = t42 + t43;
        angles[6 * n + state] = t48 + t49;
        angles[7 * n + state] = t51 + t52;
        angles[8 * n + state] = t54 + t55;
        angles[9 * n + state] = t57 + t58;
        angles[10 * n + state] = t60 + t61;
        angles[11 * n + state] = t63 + t64;
        angles[12 * n + state] = t66 + t67;
        angles[13 * n + state] = t69 + t70;
        angles[14 * n + state] = t72 + t73;
        angles[15 * n + state] = t78 + t79;
        angles[16 * n + state] = t84 + t85;
        angles[17 * n + state] = t90 + t91;
        angles[18 * n + state] = t93 + t94;
        angles[19 * n + state] = t96 + t97;
        angles[20 * n + state] = t99 + t100;
        angles[21 * n + state] = t102 + t103;
        angles[22 * n + state] = t105 + t106;
        angles[23 * n + state] = t108 + t109;
        angles[24 * n + state] = t111 + t112;
        angles[25 * n + state] = t114 + t115;
        angles[26 * n + state] = t117 + t118;
        angles[27 * n + state] = t120 + t121;
        angles[28 * n + state] = t123 + t124;
        angles[29 * n + state] = t126 + t127;
        angles[30 * n + state] = t129 + t130;
        angles[31 * n + state] = t132 + t133;
        angles[32 * n + state] = t135 + t136;
        angles[33 * n + state] = t138 + t139;
        angles[34 * n + state] = t141 + t142;
        angles[35 * n + state] = t144 + t145;
        angles[36 * n + state] = t147 + t148;
        angles[37 * n + state] = t150 + t151;
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double ratio = 0.003796 / B_to_C0_squared;
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
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double M_x = cos_q71 * M_e;
        const double z_plane_x = u_y * cos_A;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double t2 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
        const double t3 = 0.01 * z_x;
        const double layer_0_x = t2 - t3;
        const double y_x = cos_q71 * u_e;
        const double t4 = 0.011 * y_x;
        const double strand_0_x = layer_0_x + t4;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t5 = origin_y + 0.004 * u_e * sin_A;
        const double t6 = 0.01 * z_plane_y;
        const double layer_0_y = t5 - t6;
        const double t7 = 0.011 * u_y;
        const double strand_0_y = 0.007 - layer_0_y + t7;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double t8 = 0.004 * x_z;
        const double t9 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t8 - t9;
        const double y_z = sin_q71 * u_e;
        const double t10 = 0.011 * y_z;
        const double strand_0_z = layer_0_z + t10;
        const double t11 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z
            * strand_0_z;
        const double length_0 = sinew_sqrt(t11);
        const double change_0 = 0.04661544808322666 - length_0;
        const double t12 = 0.01 * y_x;
        const double strand_1_x = layer_0_x + t12;
        const double t13 = 0.01 * u_y;
        const double strand_1_y = 0.008 - layer_0_y + t13;
        const double t14 = 0.01 * y_z;
        const double strand_1_z = layer_0_z + t14;
        const double t15 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1 = sinew_sqrt(t15);
        const double change_1 = 0.04661544808322666 - length_1;
        const double t16 = 0.008 * y_x;
        const double strand_2_x = layer_0_x + t16;
        const double t17 = 0.008 * u_y;
        const double strand_2_y = 0.01 - layer_0_y + t17;
        const double t18 = 0.008 * y_z;
        const double strand_2_z = layer_0_z + t18;
        const double t19 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2 = sinew_sqrt(t19);
        const double change_2 = 0.04661544808322666 - length_2;
        const double t20 = 0.006 * y_x;
        const double strand_3_x = layer_0_x + t20;
        const double t21 = 0.006 * u_y;
        const double strand_3_y = 0.011 - layer_0_y + t21;
        const double t22 = 0.006 * y_z;
        const double strand_3_z = layer_0_z + t22;
        const double t23 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3 = sinew_sqrt(t23);
        const double change_3 = 0.04669047011971501 - length_3;
        const double t24 = 0.005 * y_x;
        const double strand_4_x = layer_0_x + t24;
        const double t25 = 0.005 * u_y;
        const double strand_4_y = 0.013 - layer_0_y + t25;
        const double t26 = 0.005 * y_z;
        const double strand_4_z = layer_0_z + t26;
        const double t27 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4 = sinew_sqrt(t27);
        const double change_4 = 0.04661544808322666 - length_4;
        const double t28 = 0.003 * y_x;
        const double strand_5_x = layer_0_x + t28;
        const double t29 = 0.003 * u_y;
        const double strand_5_y = 0.015 - layer_0_y + t29;
        const double t30 = 0.003 * y_z;
        const double strand_5_z = layer_0_z + t30;
        const double t31 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5 = sinew_sqrt(t31);
        const double change_5 = 0.04661544808322666 - length_5;
        const double t32 = 0.002 * y_x;
        const double strand_6_x = layer_0_x + t32;
        const double t33 = 0.002 * u_y;
        const double strand_6_y = 0.016 - layer_0_y + t33;
        const double t34 = 0.002 * y_z;
        const double strand_6_z = layer_0_z + t34;
        const double t35 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6 = sinew_sqrt(t35);
        const double change_6 = 0.04661544808322666 - length_6;
        const double strand_7_y = 0.018 - layer_0_y;
        const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z
            + strand_7_y * strand_7_y);
        const double change_7 = 0.04661544808322666 - length_7;
        const double strand_8_x = layer_0_x - t32;
        const double strand_8_y = 0.019 - layer_0_y - t33;
        const double strand_8_z = layer_0_z - t34;
        const double t36 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8 = sinew_sqrt(t36);
        const double change_8 = 0.04669047011971501 - length_8;
        const double strand_9_x = layer_0_x - t28;
        const double strand_9_y = 0.021 - layer_0_y - t29;
        const double strand_9_z = layer_0_z - t30;
        const double t37 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9 = sinew_sqrt(t37);
        const double change_9 = 0.04661544808322666 - length_9;
        const double strand_10_x = layer_0_x - t24;
        const double strand_10_y = 0.023 - layer_0_y - t25;
        const double strand_10_z = layer_0_z - t26;
        const double t38 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10 = sinew_sqrt(t38);
        const double change_10 = 0.04661544808322666 - length_10;
        const double strand_11_x = layer_0_x - t20;
        const double strand_11_y = 0.024 - layer_0_y - t21;
        const double strand_11_z = layer_0_z - t22;
        const double t39 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11 = sinew_sqrt(t39);
        const double change_11 = 0.04661544808322666 - length_11;
        const double strand_12_x = layer_0_x - t16;
        const double strand_12_y = 0.026 - layer_0_y - t17;
        const double strand_12_z = layer_0_z - t18;
        const double t40 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12 = sinew_sqrt(t40);
        const double change_12 = 0.04661544808322666 - length_12;
        const double strand_13_x = layer_0_x - t12;
        const double strand_13_y = 0.027 - layer_0_y - t13;
        const double strand_13_z = layer_0_z - t14;
        const double t41 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13 = sinew_sqrt(t41);
        const double change_13 = 0.04669047011971501 - length_13;
        const double strand_14_x = layer_0_x - t4;
        const double strand_14_y = 0.029 - layer_0_y - t7;
        const double strand_14_z = layer_0_z - t10;
        const double t42 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14 = sinew_sqrt(t42);
        const double change_14 = 0.04661544808322666 - length_14;
        const double t43 = 0.013 * y_x;
        const double strand_15_x = layer_0_x - t43;
        const double t44 = 0.013 * u_y;
        const double strand_15_y = 0.031 - layer_0_y - t44;
        const double t45 = 0.013 * y_z;
        const double strand_15_z = layer_0_z - t45;
        const double t46 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15 = sinew_sqrt(t46);
        const double change_15 = 0.04661544808322666 - length_15;
        const double t47 = 0.014 * y_x;
        const double strand_16_x = layer_0_x - t47;
        const double t48 = 0.014 * u_y;
        const double strand_16_y = 0.032 - layer_0_y - t48;
        const double t49 = 0.014 * y_z;
        const double strand_16_z = layer_0_z - t49;
        const double t50 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16 = sinew_sqrt(t50);
        const double change_16 = 0.04661544808322666 - length_16;
        const double t51 = 0.016 * y_x;
        const double strand_17_x = layer_0_x - t51;
        const double t52 = 0.016 * u_y;
        const double strand_17_y = 0.034 - layer_0_y - t52;
        const double t53 = 0.016 * y_z;
        const double strand_17_z = layer_0_z - t53;
        const double t54 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17 = sinew_sqrt(t54);
        const double change_17 = 0.04661544808322666 - length_17;
        const double strand_18_x = layer_0_x - 0.018 * y_x;
        const double strand_18_y = 0.035 - layer_0_y - 0.018 * u_y;
        const double strand_18_z = layer_0_z - 0.018 * y_z;
        const double t55 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18 = sinew_sqrt(t55);
        const double change_18 = 0.04669047011971501 - length_18;
        const double layer_1_x = t2 + t3;
        const double strand_19_x = layer_1_x + t43;
        const double layer_1_y = t5 + t6;
        const double strand_19_y = 0.006 - layer_1_y + t44;
        const double layer_1_z = 0.028 - origin_z - t8 + t9;
        const double strand_19_z = layer_1_z + t45;
        const double t56 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
            * strand_19_z;
        const double length_19 = sinew_sqrt(t56);
        const double change_19 = 0.046561786907291264 - length_19;
        const double strand_20_x = layer_1_x + t4;
        const double strand_20_y = 0.007 - layer_1_y + t7;
        const double strand_20_z = layer_1_z + t10;
        const double t57 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20 = sinew_sqrt(t57);
        const double change_20 = 0.04661544808322666 - length_20;
        const double strand_21_x = layer_1_x + t12;
        const double strand_21_y = 0.009 - layer_1_y + t13;
        const double strand_21_z = layer_1_z + t14;
        const double t58 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21 = sinew_sqrt(t58);
        const double change_21 = 0.046561786907291264 - length_21;
        const double strand_22_x = layer_1_x + t16;
        const double strand_22_y = 0.011 - layer_1_y + t17;
        const double strand_22_z = layer_1_z + t18;
        const double t59 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22 = sinew_sqrt(t59);
        const double change_22 = 0.046561786907291264 - length_22;
        const double strand_23_x = layer_1_x + t20;
        const double strand_23_y = 0.012 - layer_1_y + t21;
        const double strand_23_z = layer_1_z + t22;
        const double t60 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23 = sinew_sqrt(t60);
        const double change_23 = 0.04661544808322666 - length_23;
        const double strand_24_x = layer_1_x + t24;
        const double strand_24_y = 0.014 - layer_1_y + t25;
        const double strand_24_z = layer_1_z + t26;
        const double t61 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24 = sinew_sqrt(t61);
        const double change_24 = 0.046561786907291264 - length_24;
        const double strand_25_x = layer_1_x + t28;
        const double strand_25_y = 0.015 - layer_1_y + t29;
        const double strand_25_z = layer_1_z + t30;
        const double t62 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25 = sinew_sqrt(t62);
        const double change_25 = 0.04661544808322666 - length_25;
        const double strand_26_x = layer_1_x + t32;
        const double strand_26_y = 0.017 - layer_1_y + t33;
        const double strand_26_z = layer_1_z + t34;
        const double t63 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26 = sinew_sqrt(t63);
        const double change_26 = 0.046561786907291264 - length_26;
        const double strand_27_y = 0.019 - layer_1_y;
        const double t64 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y
            * strand_27_y;
        const double length_27 = sinew_sqrt(t64);
        const double change_27 = 0.046561786907291264 - length_27;
        const double strand_28_x = layer_1_x - t32;
        const double strand_28_y = 0.02 - layer_1_y - t33;
        const double strand_28_z = layer_1_z - t34;
        const double t65 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28 = sinew_sqrt(t65);
        const double change_28 = 0.04661544808322666 - length_28;
        const double strand_29_x = layer_1_x - t28;
        const double strand_29_y = 0.022 - layer_1_y - t29;
        const double strand_29_z = layer_1_z - t30;
        const double t66 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29 = sinew_sqrt(t66);
        const double change_29 = 0.046561786907291264 - length_29;
        const double strand_30_x = layer_1_x - t24;
        const double strand_30_y = 0.023 - layer_1_y - t25;
        const double strand_30_z = layer_1_z - t26;
        const double t67 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30 = sinew_sqrt(t67);
        const double change_30 = 0.04661544808322666 - length_30;
        const double strand_31_x = layer_1_x - t20;
        const double strand_31_y = 0.025 - layer_1_y - t21;
        const double strand_31_z = layer_1_z - t22;
        const double t68 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31 = sinew_sqrt(t68);
        const double change_31 = 0.046561786907291264 - length_31;
        const double strand_32_x = layer_1_x - t16;
        const double strand_32_y = 0.027 - layer_1_y - t17;
        const double strand_32_z = layer_1_z - t18;
        const double t69 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32 = sinew_sqrt(t69);
        const double change_32 = 0.046561786907291264 - length_32;
        const double strand_33_x = layer_1_x - t12;
        const double strand_33_y = 0.028 - layer_1_y - t13;
        const double strand_33_z = layer_1_z - t14;
        const double t70 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33 = sinew_sqrt(t70);
        const double change_33 = 0.04661544808322666 - length_33;
        const double strand_34_x = layer_1_x - t4;
        const double strand_34_y = 0.03 - layer_1_y - t7;
        const double strand_34_z = layer_1_z - t10;
        const double t71 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34 = sinew_sqrt(t71);
        const double change_34 = 0.046561786907291264 - length_34;
        const double strand_35_x = layer_1_x - t43;
        const double strand_35_y = 0.031 - layer_1_y - t44;
        const double strand_35_z = layer_1_z - t45;
        const double t72 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35 = sinew_sqrt(t72);
        const double change_35 = 0.04661544808322666 - length_35;
        const double strand_36_x = layer_1_x - t47;
        const double strand_36_y = 0.033 - layer_1_y - t48;
        const double strand_36_z = layer_1_z - t49;
        const double t73 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36 = sinew_sqrt(t73);
        const double change_36 = 0.046561786907291264 - length_36;
        const double strand_37_x = layer_1_x - t51;
        const double strand_37_y = 0.035 - layer_1_y - t52;
        const double strand_37_z = layer_1_z - t53;
        const double t74 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37 = sinew_sqrt(t74);
        const double change_37 = 0.046561786907291264 - length_37;
        delta_theta[state] = 200.0 * change_0;
        delta_theta[1 * n + state] = 200.0 * change_1;
        delta_theta[2 * n + state] = 200.0 * change_2;
        delta_theta[3 * n + state] = 200.0 * change_3;
        delta_theta[4 * n + state] = 200.0 * change_4;
        delta_theta[5 * n + state] = 200.0 * change_5;
        delta_theta[6 * n + state] = 200.0 * change_6;
        delta_theta[7 * n + state] = 200.0 * change_7;
        delta_theta[8 * n + state] = 200.0 * change_8;
        delta_theta[9 * n + state] = 200.0 * change_9;
        delta_theta[10 * n + state] = 200.0 * change_10;
        delta_theta[11 * n + state] = 200.0 * change_11;
        delta_theta[12 * n + state] = 200.0 * change_12;
        delta_theta[13 * n + state] = 200.0 * change_13;
        delta_theta[14 * n + state] = 200.0 * change_14;
        delta_theta[15 * n + state] = 200.0 * change_15;
        delta_theta[16 * n + state] = 200.0 * change_16;
        delta_theta[17 * n + state] = 200.0 * change_17;
        delta_theta[18 * n + state] = 200.0 * change_18;
        delta_theta[19 * n + state] = 200.0 * change_19;
        delta_theta[20 * n + state] = 200.0 * change_20;
        delta_theta[21 * n + state] = 200.0 * change_21;
        delta_theta[22 * n + state] = 200.0 * change_22;
        delta_theta[23 * n + state] = 200.0 * change_23;
        delta_theta[24 * n + state] = 200.0 * change_24;
        delta_theta[25 * n + state] = 200.0 * change_25;
        delta_theta[26 * n + state] = 200.0 * change_26;
        delta_theta[27 * n + state] = 200.0 * change_27;
        delta_theta[28 * n + state] = 200.0 * change_28;
        delta_theta[29 * n + state] = 200.0 * change_29;
        delta_theta[30 * n + state] = 200.0 * change_30;
        delta_theta[31 * n + state] = 200.0 * change_31;
        delta_theta[32 * n + state] = 200.0 * change_32;
        delta_theta[33 * n + state] = 200.0 * change_33;
        delta_theta[34 * n + state] = 200.0 * change_34;
        delta_theta[35 * n + state] = 200.0 * change_35;
        delta_theta[36 * n + state] = 200.0 * change_36;
        delta_theta[37 * n + state] = 200.0 * change_37;
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double t1 = 1.0 / B_to_C0_squared;
        const double ratio = 0.003796 * t1;
        const double B_e = 0.074565407529229 * sin_q73;
        const double B_to_C0_squared_by_q73 = 0.084 * B_e;
        const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t1;
        const double t2 = 21.0 - 500.0 * B_y;
        const double C_e = B_e * ratio;
        const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t2;
        const double t3 = 0.5 * B_e;
        const double M_y_by_q73 = t3 + 0.5 * C_y_by_q73;
        const double t4 = 23.80952380952381 * B_e;
        const double u_e = t4 - 23.80952380952381 * C_e;
        const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
        const double t5 = 0.5 * B_y;
        const double M_e_by_q73 = t5 - 0.5 * C_e_by_q73;
        const double C_y = 0.002 * ratio * t2;
        const double t6 = 23.80952380952381 * B_y;
        const double u_y = t6 + 23.80952380952381 * C_y;
        const double u_y_by_q73 = t4 - 23.80952380952381 * C_y_by_q73;
        const double M_e = t3 + 0.5 * C_e;
        const double p_z_by_q71 = 0.036 * sin_q71;
        const double s_e = M_e - p_z_by_q71;
        const double u_e_by_q73 = t6 + 23.80952380952381 * C_e_by_q73;
        const double M_y = t5 - 0.5 * C_y;
        const double s_y = 0.021 - M_y;
        const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
            * u_e_by_q73;
        const double p_y = u_e * s_y + u_y * s_e;
        const double t7 = p_y + p_y;
        const double t8 = p_y * p_y;
        const double p_z = 0.036 * cos_q71;
        const double t9 = p_z * p_z;
        const double t10 = -(1.296e-15 - t8 - t9);
        const double reach_squared_by_q73 = sinew_choose(t10, t7 * p_y_by_q73, 0.0);
        const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
            * u_y_by_q73;
        const double p_x = u_e * s_e - u_y * s_y;
        const double t11 = 27.77777777777778 * p_x;
        const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t11
            * p_x_by_q73;
        const double reach_squared = sinew_max(t8 + t9, 1.296e-15);
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double reach = sinew_sqrt(reach_squared);
        const double t12 = reach - projection;
        const double t13 = sinew_choose(t12, 1.0, 0.0);
        const double t14 = 1.0 / reach;
        const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t14;
        const double t15 = sinew_choose(t12, 0.0, 1.0);
        const double t16 = sinew_max(-projection, -reach);
        const double t17 = reach - t16;
        const double limited_by_q73 = sinew_choose(t17, -(reach_by_q73 * t15 - projection_by_q73
            * t13), reach_by_q73);
        const double limited = sinew_min(t16, reach);
        const double t18 = limited + limited;
        const double t19 = reach + reach;
        const double t20 = (reach + limited) * (reach - limited);
        const double t21 = 1e-12 * reach_squared;
        const double t22 = -(t21 - t20);
        const double clearance_by_q73 = sinew_choose(t22, t19 * reach_by_q73 - t18 * limited_by_q73,
            1e-12 * reach_squared_by_q73);
        const double clearance = sinew_max(t20, t21);
        const double root = sinew_sqrt(clearance);
        const double t23 = 1.0 / root;
        const double root_by_q73 = 0.5 * clearance_by_q73 * t23;
        const double t24 = 1.0 / reach_squared;
        const double cos_A = (p_y * limited + p_z * root) * t24;
        const double t25 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t25 * t24;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double sin_A = (p_y * root - p_z * limited) * t24;
        const double t26 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t26 * t24;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double M_x_by_q73 = cos_q71 * M_e_by_q73;
        const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t27 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t28 = 0.01 * z_x_by_q73;
        const double layer_0_x_by_q73 = t27 + t28;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t29 = 0.011 * y_x_by_q73;
        const double strand_0_x_by_q73 = layer_0_x_by_q73 - t29;
        const double x_plane_x = u_y * sin_A;
        const double t30 = cos_q71 * x_plane_x;
        const double t31 = sin_q71 * cos_A;
        const double x_x = t30 + t31;
        const double M_x = cos_q71 * M_e;
        const double z_plane_x = u_y * cos_A;
        const double t32 = cos_q71 * z_plane_x;
        const double t33 = sin_q71 * sin_A;
        const double z_x = t32 - t33;
        const double t34 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
        const double t35 = 0.01 * z_x;
        const double layer_0_x = t34 - t35;
        const double y_x = cos_q71 * u_e;
        const double t36 = 0.011 * y_x;
        const double strand_0_x = layer_0_x + t36;
        const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
        const double t37 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
        const double t38 = 0.01 * z_plane_y_by_q73;
        const double layer_0_y_by_q73 = t37 + t38;
        const double t39 = 0.011 * u_y_by_q73;
        const double strand_0_y_by_q73 = layer_0_y_by_q73 - t39;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t40 = 0.004 * u_e;
        const double t41 = origin_y + t40 * sin_A;
        const double t42 = 0.01 * z_plane_y;
        const double layer_0_y = t41 - t42;
        const double t43 = 0.011 * u_y;
        const double strand_0_y = 0.007 - layer_0_y + t43;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double M_z_by_q73 = sin_q71 * M_e_by_q73;
        const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t44 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t45 = 0.01 * z_z_by_q73;
        const double layer_0_z_by_q73 = t44 + t45;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t46 = 0.011 * y_z_by_q73;
        const double strand_0_z_by_q73 = layer_0_z_by_q73 - t46;
        const double t47 = sin_q71 * z_plane_x;
        const double t48 = cos_q71 * sin_A;
        const double z_z = t48 + t47;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double t49 = sin_q71 * x_plane_x;
        const double t50 = cos_q71 * cos_A;
        const double x_z = t50 - t49;
        const double t51 = 0.004 * x_z;
        const double t52 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t51 - t52;
        const double y_z = sin_q71 * u_e;
        const double t53 = 0.011 * y_z;
        const double strand_0_z = layer_0_z + t53;
        const double t54 = strand_0_x * strand_0_x_by_q73 - strand_0_y * strand_0_y_by_q73
            + strand_0_z * strand_0_z_by_q73;
        const double t55 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z
            * strand_0_z;
        const double length_0 = sinew_sqrt(t55);
        const double t56 = 1.0 / length_0;
        const double length_0_by_q73 = t54 * t56;
        const double t57 = 200.0 * dq73[state];
        const double p_y_by_q71 = u_y * p_z;
        const double reach_squared_by_q71 = sinew_choose(t10, -(t7 * p_y_by_q71 + (p_z + p_z)
            * p_z_by_q71), 0.0);
        const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t14;
        const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t11 * u_e * p_z;
        const double limited_by_q71 = sinew_choose(t17, -(reach_by_q71 * t15 - projection_by_q71
            * t13), reach_by_q71);
        const double clearance_by_q71 = sinew_choose(t22, t19 * reach_by_q71 - t18 * limited_by_q71,
            1e-12 * reach_squared_by_q71);
        const double root_by_q71 = 0.5 * clearance_by_q71 * t23;
        const double t58 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double cos_A_by_q71 = (t58 - cos_A * reach_squared_by_q71) * t24;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double t59 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t59 - sin_A * reach_squared_by_q71) * t24;
        const double z_x_by_q71 = t48 - cos_q71 * z_plane_x_by_q71 + t47 + sin_q71 * sin_A_by_q71;
        const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double x_x_by_q71 = t50 + cos_q71 * x_plane_x_by_q71 - t49 + sin_q71 * cos_A_by_q71;
        const double t60 = origin_x_by_q71 + 0.004 * x_x_by_q71;
        const double t61 = 0.01 * z_x_by_q71;
        const double layer_0_x_by_q71 = t60 + t61;
        const double strand_0_x_by_q71 = layer_0_x_by_q71 - t53;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
        const double t62 = origin_y_by_q71 + t40 * sin_A_by_q71;
        const double t63 = 0.01 * z_plane_y_by_q71;
        const double layer_0_y_by_q71 = t62 - t63;
        const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t33 + sin_q71 * z_plane_x_by_q71;
        const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
        const double x_z_by_q71 = t30 - cos_q71 * cos_A_by_q71 + t31 + sin_q71 * x_plane_x_by_q71;
        const double t64 = origin_z_by_q71 - 0.004 * x_z_by_q71;
        const double t65 = 0.01 * z_z_by_q71;
        const double layer_0_z_by_q71 = t64 + t65;
        const double strand_0_z_by_q71 = layer_0_z_by_q71 - t36;
        const double t66 = strand_0_x * strand_0_x_by_q71 - strand_0_y * layer_0_y_by_q71
            - strand_0_z * strand_0_z_by_q71;
        const double length_0_by_q71 = t66 * t56;
        const double t67 = 200.0 * dq71[state];
        const double t68 = 0.01 * y_x_by_q73;
        const double strand_1_x_by_q73 = layer_0_x_by_q73 - t68;
        const double t69 = 0.01 * y_x;
        const double strand_1_x = layer_0_x + t69;
        const double t70 = 0.01 * u_y_by_q73;
        const double strand_1_y_by_q73 = layer_0_y_by_q73 - t70;
        const double t71 = 0.01 * u_y;
        const double strand_1_y = 0.008 - layer_0_y + t71;
        const double t72 = 0.01 * y_z_by_q73;
        const double strand_1_z_by_q73 = layer_0_z_by_q73 - t72;
        const double t73 = 0.01 * y_z;
        const double strand_1_z = layer_0_z + t73;
        const double t74 = strand_1_x * strand_1_x_by_q73 - strand_1_y * strand_1_y_by_q73
            + strand_1_z * strand_1_z_by_q73;
        const double t75 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1 = sinew_sqrt(t75);
        const double t76 = 1.0 / length_1;
        const double length_1_by_q73 = t74 * t76;
        const double strand_1_x_by_q71 = layer_0_x_by_q71 - t73;
        const double strand_1_z_by_q71 = layer_0_z_by_q71 - t69;
        const double t77 = strand_1_x * strand_1_x_by_q71 - strand_1_y * layer_0_y_by_q71
            - strand_1_z * strand_1_z_by_q71;
        const double length_1_by_q71 = t77 * t76;
        const double t78 = 0.008 * y_x_by_q73;
        const double strand_2_x_by_q73 = layer_0_x_by_q73 - t78;
        const double t79 = 0.008 * y_x;
        const double strand_2_x = layer_0_x + t79;
        const double t80 = 0.008 * u_y_by_q73;
        const double strand_2_y_by_q73 = layer_0_y_by_q73 - t80;
        const double t81 = 0.008 * u_y;
        const double strand_2_y = 0.01 - layer_0_y + t81;
        const double t82 = 0.008 * y_z_by_q73;
        const double strand_2_z_by_q73 = layer_0_z_by_q73 - t82;
        const double t83 = 0.008 * y_z;
        const double strand_2_z = layer_0_z + t83;
        const double t84 = strand_2_x * strand_2_x_by_q73 - strand_2_y * strand_2_y_by_q73
            + strand_2_z * strand_2_z_by_q73;
        const double t85 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2 = sinew_sqrt(t85);
        const double t86 = 1.0 / length_2;
        const double length_2_by_q73 = t84 * t86;
        const double strand_2_x_by_q71 = layer_0_x_by_q71 - t83;
        const double strand_2_z_by_q71 = layer_0_z_by_q71 - t79;
        const double t87 = strand_2_x * strand_2_x_by_q71 - strand_2_y * layer_0_y_by_q71
            - strand_2_z * strand_2_z_by_q71;
        const double length_2_by_q71 = t87 * t86;
        const double t88 = 0.006 * y_x_by_q73;
        const double strand_3_x_by_q73 = layer_0_x_by_q73 - t88;
        const double t89 = 0.006 * y_x;
        const double strand_3_x = layer_0_x + t89;
        const double t90 = 0.006 * u_y_by_q73;
        const double strand_3_y_by_q73 = layer_0_y_by_q73 - t90;
        const double t91 = 0.006 * u_y;
        const double strand_3_y = 0.011 - layer_0_y + t91;
        const double t92 = 0.006 * y_z_by_q73;
        const double strand_3_z_by_q73 = layer_0_z_by_q73 - t92;
        const double t93 = 0.006 * y_z;
        const double strand_3_z = layer_0_z + t93;
        const double t94 = strand_3_x * strand_3_x_by_q73 - strand_3_y * strand_3_y_by_q73
            + strand_3_z * strand_3_z_by_q73;
        const double t95 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3 = sinew_sqrt(t95);
        const double t96 = 1.0 / length_3;
        const double length_3_by_q73 = t94 * t96;
        const double strand_3_x_by_q71 = layer_0_x_by_q71 - t93;
        const double strand_3_z_by_q71 = layer_0_z_by_q71 - t89;
        const double t97 = strand_3_x * strand_3_x_by_q71 - strand_3_y * layer_0_y_by_q71
            - strand_3_z * strand_3_z_by_q71;
        const double length_3_by_q71 = t97 * t96;
        const double t98 = 0.005 * y_x_by_q73;
        const double strand_4_x_by_q73 = layer_0_x_by_q73 - t98;
        const double t99 = 0.005 * y_x;
        const double strand_4_x = layer_0_x + t99;
        const double t100 = 0.005 * u_y_by_q73;
        const double strand_4_y_by_q73 = layer_0_y_by_q73 - t100;
        const double t101 = 0.005 * u_y;
        const double strand_4_y = 0.013 - layer_0_y + t101;
        const double t102 = 0.005 * y_z_by_q73;
        const double strand_4_z_by_q73 = layer_0_z_by_q73 - t102;
        const double t103 = 0.005 * y_z;
        const double strand_4_z = layer_0_z + t103;
        const double t104 = strand_4_x * strand_4_x_by_q73 - strand_4_y * strand_4_y_by_q73
            + strand_4_z * strand_4_z_by_q73;
        const double t105 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4 = sinew_sqrt(t105);
        const double t106 = 1.0 / length_4;
        const double length_4_by_q73 = t104 * t106;
        const double strand_4_x_by_q71 = layer_0_x_by_q71 - t103;
        const double strand_4_z_by_q71 = layer_0_z_by_q71 - t99;
        const double t107 = strand_4_x * strand_4_x_by_q71 - strand_4_y * layer_0_y_by_q71
            - strand_4_z * strand_4_z_by_q71;
        const double length_4_by_q71 = t107 * t106;
        const double t108 = 0.003 * y_x_by_q73;
        const double strand_5_x_by_q73 = layer_0_x_by_q73 - t108;
        const double t109 = 0.003 * y_x;
        const double strand_5_x = layer_0_x + t109;
        const double t110 = 0.003 * u_y_by_q73;
        const double strand_5_y_by_q73 = layer_0_y_by_q73 - t110;
        const double t111 = 0.003 * u_y;
        const double strand_5_y = 0.015 - layer_0_y + t111;
        const double t112 = 0.003 * y_z_by_q73;
        const double strand_5_z_by_q73 = layer_0_z_by_q73 - t112;
        const double t113 = 0.003 * y_z;
        const double strand_5_z = layer_0_z + t113;
        const double t114 = strand_5_x * strand_5_x_by_q73 - strand_5_y * strand_5_y_by_q73
            + strand_5_z * strand_5_z_by_q73;
        const double t115 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5 = sinew_sqrt(t115);
        const double t116 = 1.0 / length_5;
        const double length_5_by_q73 = t114 * t116;
        const double strand_5_x_by_q71 = layer_0_x_by_q71 - t113;
        const double strand_5_z_by_q71 = layer_0_z_by_q71 - t109;
        const double t117 = strand_5_x * strand_5_x_by_q71 - strand_5_y * layer_0_y_by_q71
            - strand_5_z * strand_5_z_by_q71;
        const double length_5_by_q71 = t117 * t116;
        const double t118 = 0.002 * y_x_by_q73;
        const double strand_6_x_by_q73 = layer_0_x_by_q73 - t118;
        const double t119 = 0.002 * y_x;
        const double strand_6_x = layer_0_x + t119;
        const double t120 = 0.002 * u_y_by_q73;
        const double strand_6_y_by_q73 = layer_0_y_by_q73 - t120;
        const double t121 = 0.002 * u_y;
        const double strand_6_y = 0.016 - layer_0_y + t121;
        const double t122 = 0.002 * y_z_by_q73;
        const double strand_6_z_by_q73 = layer_0_z_by_q73 - t122;
        const double t123 = 0.002 * y_z;
        const double strand_6_z = layer_0_z + t123;
        const double t124 = strand_6_x * strand_6_x_by_q73 - strand_6_y * strand_6_y_by_q73
            + strand_6_z * strand_6_z_by_q73;
        const double t125 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6 = sinew_sqrt(t125);
        const double t126 = 1.0 / length_6;
        const double length_6_by_q73 = t124 * t126;
        const double strand_6_x_by_q71 = layer_0_x_by_q71 - t123;
        const double strand_6_z_by_q71 = layer_0_z_by_q71 - t119;
        const double t127 = strand_6_x * strand_6_x_by_q71 - strand_6_y * layer_0_y_by_q71
            - strand_6_z * strand_6_z_by_q71;
        const double length_6_by_q71 = t127 * t126;
        const double strand_7_y = 0.018 - layer_0_y;
        const double t128 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
            * layer_0_y_by_q73;
        const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z
            + strand_7_y * strand_7_y);
        const double t129 = 1.0 / length_7;
        const double length_7_by_q73 = t128 * t129;
        const double t130 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
            * layer_0_y_by_q71;
        const double length_7_by_q71 = t130 * t129;
        const double strand_8_x_by_q73 = layer_0_x_by_q73 + t118;
        const double strand_8_x = layer_0_x - t119;
        const double strand_8_y_by_q73 = layer_0_y_by_q73 + t120;
        const double strand_8_y = 0.019 - layer_0_y - t121;
        const double strand_8_z_by_q73 = layer_0_z_by_q73 + t122;
        const double strand_8_z = layer_0_z - t123;
        const double t131 = strand_8_x * strand_8_x_by_q73 - strand_8_y * strand_8_y_by_q73
            + strand_8_z * strand_8_z_by_q73;
        const double t132 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8 = sinew_sqrt(t132);
        const double t133 = 1.0 / length_8;
        const double length_8_by_q73 = t131 * t133;
        const double strand_8_x_by_q71 = layer_0_x_by_q71 + t123;
        const double strand_8_z_by_q71 = layer_0_z_by_q71 + t119;
        const double t134 = strand_8_x * strand_8_x_by_q71 - strand_8_y * layer_0_y_by_q71
            - strand_8_z * strand_8_z_by_q71;
        const double length_8_by_q71 = t134 * t133;
        const double strand_9_x_by_q73 = layer_0_x_by_q73 + t108;
        const double strand_9_x = layer_0_x - t109;
        const double strand_9_y_by_q73 = layer_0_y_by_q73 + t110;
        const double strand_9_y = 0.021 - layer_0_y - t111;
        const double strand_9_z_by_q73 = layer_0_z_by_q73 + t112;
        const double strand_9_z = layer_0_z - t113;
        const double t135 = strand_9_x * strand_9_x_by_q73 - strand_9_y * strand_9_y_by_q73
            + strand_9_z * strand_9_z_by_q73;
        const double t136 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9 = sinew_sqrt(t136);
        const double t137 = 1.0 / length_9;
        const double length_9_by_q73 = t135 * t137;
        const double strand_9_x_by_q71 = layer_0_x_by_q71 + t113;
        const double strand_9_z_by_q71 = layer_0_z_by_q71 + t109;
        const double t138 = strand_9_x * strand_9_x_by_q71 - strand_9_y * layer_0_y_by_q71
            - strand_9_z * strand_9_z_by_q71;
        const double length_9_by_q71 = t138 * t137;
        const double strand_10_x_by_q73 = layer_0_x_by_q73 + t98;
        const double strand_10_x = layer_0_x - t99;
        const double strand_10_y_by_q73 = layer_0_y_by_q73 + t100;
        const double strand_10_y = 0.023 - layer_0_y - t101;
        const double strand_10_z_by_q73 = layer_0_z_by_q73 + t102;
        const double strand_10_z = layer_0_z - t103;
        const double t139 = strand_10_x * strand_10_x_by_q73 - strand_10_y * strand_10_y_by_q73
            + strand_10_z * strand_10_z_by_q73;
        const double t140 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10 = sinew_sqrt(t140);
        const double t141 = 1.0 / length_10;
        const double length_10_by_q73 = t139 * t141;
        const double strand_10_x_by_q71 = layer_0_x_by_q71 + t103;
        const double strand_10_z_by_q71 = layer_0_z_by_q71 + t99;
        const double t142 = strand_10_x * strand_10_x_by_q71 - strand_10_y * layer_0_y_by_q71
            - strand_10_z * strand_10_z_by_q71;
        const double length_10_by_q71 = t142 * t141;
        const double strand_11_x_by_q73 = layer_0_x_by_q73 + t88;
        const double strand_11_x = layer_0_x - t89;
        const double strand_11_y_by_q73 = layer_0_y_by_q73 + t90;
        const double strand_11_y = 0.024 - layer_0_y - t91;
        const double strand_11_z_by_q73 = layer_0_z_by_q73 + t92;
        const double strand_11_z = layer_0_z - t93;
        const double t143 = strand_11_x * strand_11_x_by_q73 - strand_11_y * strand_11_y_by_q73
            + strand_11_z * strand_11_z_by_q73;
        const double t144 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11 = sinew_sqrt(t144);
        const double t145 = 1.0 / length_11;
        const double length_11_by_q73 = t143 * t145;
        const double strand_11_x_by_q71 = layer_0_x_by_q71 + t93;
        const double strand_11_z_by_q71 = layer_0_z_by_q71 + t89;
        const double t146 = strand_11_x * strand_11_x_by_q71 - strand_11_y * layer_0_y_by_q71
            - strand_11_z * strand_11_z_by_q71;
        const double length_11_by_q71 = t146 * t145;
        const double strand_12_x_by_q73 = layer_0_x_by_q73 + t78;
        const double strand_12_x = layer_0_x - t79;
        const double strand_12_y_by_q73 = layer_0_y_by_q73 + t80;
        const double strand_12_y = 0.026 - layer_0_y - t81;
        const double strand_12_z_by_q73 = layer_0_z_by_q73 + t82;
        const double strand_12_z = layer_0_z - t83;
        const double t147 = strand_12_x * strand_12_x_by_q73 - strand_12_y * strand_12_y_by_q73
            + strand_12_z * strand_12_z_by_q73;
        const double t148 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12 = sinew_sqrt(t148);
        const double t149 = 1.0 / length_12;
        const double length_12_by_q73 = t147 * t149;
        const double strand_12_x_by_q71 = layer_0_x_by_q71 + t83;
        const double strand_12_z_by_q71 = layer_0_z_by_q71 + t79;
        const double t150 = strand_12_x * strand_12_x_by_q71 - strand_12_y * layer_0_y_by_q71
            - strand_12_z * strand_12_z_by_q71;
        const double length_12_by_q71 = t150 * t149;
        const double strand_13_x_by_q73 = layer_0_x_by_q73 + t68;
        const double strand_13_x = layer_0_x - t69;
        const double strand_13_y_by_q73 = layer_0_y_by_q73 + t70;
        const double strand_13_y = 0.027 - layer_0_y - t71;
        const double strand_13_z_by_q73 = layer_0_z_by_q73 + t72;
        const double strand_13_z = layer_0_z - t73;
        const double t151 = strand_13_x * strand_13_x_by_q73 - strand_13_y * strand_13_y_by_q73
            + strand_13_z * strand_13_z_by_q73;
        const double t152 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13 = sinew_sqrt(t152);
        const double t153 = 1.0 / length_13;
        const double length_13_by_q73 = t151 * t153;
        const double strand_13_x_by_q71 = layer_0_x_by_q71 + t73;
        const double strand_13_z_by_q71 = layer_0_z_by_q71 + t69;
        const double t154 = strand_13_x * strand_13_x_by_q71 - strand_13_y * layer_0_y_by_q71
            - strand_13_z * strand_13_z_by_q71;
        const double length_13_by_q71 = t154 * t153;
        const double strand_14_x_by_q73 = layer_0_x_by_q73 + t29;
        const double strand_14_x = layer_0_x - t36;
        const double strand_14_y_by_q73 = layer_0_y_by_q73 + t39;
        const double strand_14_y = 0.029 - layer_0_y - t43;
        const double strand_14_z_by_q73 = layer_0_z_by_q73 + t46;
        const double strand_14_z = layer_0_z - t53;
        const double t155 = strand_14_x * strand_14_x_by_q73 - strand_14_y * strand_14_y_by_q73
            + strand_14_z * strand_14_z_by_q73;
        const double t156 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14 = sinew_sqrt(t156);
        const double t157 = 1.0 / length_14;
        const double length_14_by_q73 = t155 * t157;
        const double strand_14_x_by_q71 = layer_0_x_by_q71 + t53;
        const double strand_14_z_by_q71 = layer_0_z_by_q71 + t36;
        const double t158 = strand_14_x * strand_14_x_by_q71 - strand_14_y * layer_0_y_by_q71
            - strand_14_z * strand_14_z_by_q71;
        const double length_14_by_q71 = t158 * t157;
        const double t159 = 0.013 * y_x_by_q73;
        const double strand_15_x_by_q73 = layer_0_x_by_q73 + t159;
        const double t160 = 0.013 * y_x;
        const double strand_15_x = layer_0_x - t160;
        const double t161 = 0.013 * u_y_by_q73;
        const double strand_15_y_by_q73 = layer_0_y_by_q73 + t161;
        const double t162 = 0.013 * u_y;
        const double strand_15_y = 0.031 - layer_0_y - t162;
        const double t163 = 0.013 * y_z_by_q73;
        const double strand_15_z_by_q73 = layer_0_z_by_q73 + t163;
        const double t164 = 0.013 * y_z;
        const double strand_15_z = layer_0_z - t164;
        const double t165 = strand_15_x * strand_15_x_by_q73 - strand_15_y * strand_15_y_by_q73
            + strand_15_z * strand_15_z_by_q73;
        const double t166 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15 = sinew_sqrt(t166);
        const double t167 = 1.0 / length_15;
        const double length_15_by_q73 = t165 * t167;
        const double strand_15_x_by_q71 = layer_0_x_by_q71 + t164;
        const double strand_15_z_by_q71 = layer_0_z_by_q71 + t160;
        const double t168 = strand_15_x * strand_15_x_by_q71 - strand_15_y * layer_0_y_by_q71
            - strand_15_z * strand_15_z_by_q71;
        const double length_15_by_q71 = t168 * t167;
        const double t169 = 0.014 * y_x_by_q73;
        const double strand_16_x_by_q73 = layer_0_x_by_q73 + t169;
        const double t170 = 0.014 * y_x;
        const double strand_16_x = layer_0_x - t170;
        const double t171 = 0.014 * u_y_by_q73;
        const double strand_16_y_by_q73 = layer_0_y_by_q73 + t171;
        const double t172 = 0.014 * u_y;
        const double strand_16_y = 0.032 - layer_0_y - t172;
        const double t173 = 0.014 * y_z_by_q73;
        const double strand_16_z_by_q73 = layer_0_z_by_q73 + t173;
        const double t174 = 0.014 * y_z;
        const double strand_16_z = layer_0_z - t174;
        const double t175 = strand_16_x * strand_16_x_by_q73 - strand_16_y * strand_16_y_by_q73
            + strand_16_z * strand_16_z_by_q73;
        const double t176 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16 = sinew_sqrt(t176);
        const double t177 = 1.0 / length_16;
        const double length_16_by_q73 = t175 * t177;
        const double strand_16_x_by_q71 = layer_0_x_by_q71 + t174;
        const double strand_16_z_by_q71 = layer_0_z_by_q71 + t170;
        const double t178 = strand_16_x * strand_16_x_by_q71 - strand_16_y * layer_0_y_by_q71
            - strand_16_z * strand_16_z_by_q71;
        const double length_16_by_q71 = t178 * t177;
        const double t179 = 0.016 * y_x_by_q73;
        const double strand_17_x_by_q73 = layer_0_x_by_q73 + t179;
        const double t180 = 0.016 * y_x;
        const double strand_17_x = layer_0_x - t180;
        const double t181 = 0.016 * u_y_by_q73;
        const double strand_17_y_by_q73 = layer_0_y_by_q73 + t181;
        const double t182 = 0.016 * u_y;
        const double strand_17_y = 0.034 - layer_0_y - t182;
        const double t183 = 0.016 * y_z_by_q73;
        const double strand_17_z_by_q73 = layer_0_z_by_q73 + t183;
        const double t184 = 0.016 * y_z;
        const double strand_17_z = layer_0_z - t184;
        const double t185 = strand_17_x * strand_17_x_by_q73 - strand_17_y * strand_17_y_by_q73
            + strand_17_z * strand_17_z_by_q73;
        const double t186 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17 = sinew_sqrt(t186);
        const double t187 = 1.0 / length_17;
        const double length_17_by_q73 = t185 * t187;
        const double strand_17_x_by_q71 = layer_0_x_by_q71 + t184;
        const double strand_17_z_by_q71 = layer_0_z_by_q71 + t180;
        const double t188 = strand_17_x * strand_17_x_by_q71 - strand_17_y * layer_0_y_by_q71
            - strand_17_z * strand_17_z_by_q71;
        const double length_17_by_q71 = t188 * t187;
        const double strand_18_x_by_q73 = layer_0_x_by_q73 + 0.018 * y_x_by_q73;
        const double t189 = 0.018 * y_x;
        const double strand_18_x = layer_0_x - t189;
        const double strand_18_y_by_q73 = layer_0_y_by_q73 + 0.018 * u_y_by_q73;
        const double strand_18_y = 0.035 - layer_0_y - 0.018 * u_y;
        const double strand_18_z_by_q73 = layer_0_z_by_q73 + 0.018 * y_z_by_q73;
        const double t190 = 0.018 * y_z;
        const double strand_18_z = layer_0_z - t190;
        const double t191 = strand_18_x * strand_18_x_by_q73 - strand_18_y * strand_18_y_by_q73
            + strand_18_z * strand_18_z_by_q73;
        const double t192 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18 = sinew_sqrt(t192);
        const double t193 = 1.0 / length_18;
        const double length_18_by_q73 = t191 * t193;
        const double strand_18_x_by_q71 = layer_0_x_by_q71 + t190;
        const double strand_18_z_by_q71 = layer_0_z_by_q71 + t189;
        const double t194 = strand_18_x * strand_18_x_by_q71 - strand_18_y * layer_0_y_by_q71
            - strand_18_z * strand_18_z_by_q71;
        const double length_18_by_q71 = t194 * t193;
        const double layer_1_x_by_q73 = t27 - t28;
        const double strand_19_x_by_q73 = layer_1_x_by_q73 - t159;
        const double layer_1_x = t34 + t35;
        const double strand_19_x = layer_1_x + t160;
        const double layer_1_y_by_q73 = t37 - t38;
        const double strand_19_y_by_q73 = layer_1_y_by_q73 - t161;
        const double layer_1_y = t41 + t42;
        const double strand_19_y = 0.006 - layer_1_y + t162;
        const double layer_1_z_by_q73 = t44 - t45;
        const double strand_19_z_by_q73 = layer_1_z_by_q73 - t163;
        const double layer_1_z = 0.028 - origin_z - t51 + t52;
        const double strand_19_z = layer_1_z + t164;
        const double t195 = strand_19_x * strand_19_x_by_q73 - strand_19_y * strand_19_y_by_q73
            + strand_19_z * strand_19_z_by_q73;
        const double t196 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
            * strand_19_z;
        const double length_19 = sinew_sqrt(t196);
        const double t197 = 1.0 / length_19;
        const double length_19_by_q73 = t195 * t197;
        const double layer_1_x_by_q71 = t60 - t61;
        const double strand_19_x_by_q71 = layer_1_x_by_q71 - t164;
        const double layer_1_y_by_q71 = t62 + t63;
        const double layer_1_z_by_q71 = t64 - t65;
        const double strand_19_z_by_q71 = layer_1_z_by_q71 - t160;
        const double t198 = strand_19_x * strand_19_x_by_q71 - strand_19_y * layer_1_y_by_q71
            - strand_19_z * strand_19_z_by_q71;
        const double length_19_by_q71 = t198 * t197;
        const double strand_20_x_by_q73 = layer_1_x_by_q73 - t29;
        const double strand_20_x = layer_1_x + t36;
        const double strand_20_y_by_q73 = layer_1_y_by_q73 - t39;
        const double strand_20_y = 0.007 - layer_1_y + t43;
        const double strand_20_z_by_q73 = layer_1_z_by_q73 - t46;
        const double strand_20_z = layer_1_z + t53;
        const double t199 = strand_20_x * strand_20_x_by_q73 - strand_20_y * strand_20_y_by_q73
            + strand_20_z * strand_20_z_by_q73;
        const double t200 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20 = sinew_sqrt(t200);
        const double t201 = 1.0 / length_20;
        const double length_20_by_q73 = t199 * t201;
        const double strand_20_x_by_q71 = layer_1_x_by_q71 - t53;
        const double strand_20_z_by_q71 = layer_1_z_by_q71 - t36;
        const double t202 = strand_20_x * strand_20_x_by_q71 - strand_20_y * layer_1_y_by_q71
            - strand_20_z * strand_20_z_by_q71;
        const double length_20_by_q71 = t202 * t201;
        const double strand_21_x_by_q73 = layer_1_x_by_q73 - t68;
        const double strand_21_x = layer_1_x + t69;
        const double strand_21_y_by_q73 = layer_1_y_by_q73 - t70;
        const double strand_21_y = 0.009 - layer_1_y + t71;
        const double strand_21_z_by_q73 = layer_1_z_by_q73 - t72;
        const double strand_21_z = layer_1_z + t73;
        const double t203 = strand_21_x * strand_21_x_by_q73 - strand_21_y * strand_21_y_by_q73
            + strand_21_z * strand_21_z_by_q73;
        const double t204 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21 = sinew_sqrt(t204);
        const double t205 = 1.0 / length_21;
        const double length_21_by_q73 = t203 * t205;
        const double strand_21_x_by_q71 = layer_1_x_by_q71 - t73;
        const double strand_21_z_by_q71 = layer_1_z_by_q71 - t69;
        const double t206 = strand_21_x * strand_21_x_by_q71 - strand_21_y * layer_1_y_by_q71
            - strand_21_z * strand_21_z_by_q71;
        const double length_21_by_q71 = t206 * t205;
        const double strand_22_x_by_q73 = layer_1_x_by_q73 - t78;
        const double strand_22_x = layer_1_x + t79;
        const double strand_22_y_by_q73 = layer_1_y_by_q73 - t80;
        const double strand_22_y = 0.011 - layer_1_y + t81;
        const double strand_22_z_by_q73 = layer_1_z_by_q73 - t82;
        const double strand_22_z = layer_1_z + t83;
        const double t207 = strand_22_x * strand_22_x_by_q73 - strand_22_y * strand_22_y_by_q73
            + strand_22_z * strand_22_z_by_q73;
        const double t208 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22 = sinew_sqrt(t208);
        const double t209 = 1.0 / length_22;
        const double length_22_by_q73 = t207 * t209;
        const double strand_22_x_by_q71 = layer_1_x_by_q71 - t83;
        const double strand_22_z_by_q71 = layer_1_z_by_q71 - t79;
        const double t210 = strand_22_x * strand_22_x_by_q71 - strand_22_y * layer_1_y_by_q71
            - strand_22_z * strand_22_z_by_q71;
        const double length_22_by_q71 = t210 * t209;
        const double strand_23_x_by_q73 = layer_1_x_by_q73 - t88;
        const double strand_23_x = layer_1_x + t89;
        const double strand_23_y_by_q73 = layer_1_y_by_q73 - t90;
        const double strand_23_y = 0.012 - layer_1_y + t91;
        const double strand_23_z_by_q73 = layer_1_z_by_q73 - t92;
        const double strand_23_z = layer_1_z + t93;
        const double t211 = strand_23_x * strand_23_x_by_q73 - strand_23_y * strand_23_y_by_q73
            + strand_23_z * strand_23_z_by_q73;
        const double t212 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23 = sinew_sqrt(t212);
        const double t213 = 1.0 / length_23;
        const double length_23_by_q73 = t211 * t213;
        const double strand_23_x_by_q71 = layer_1_x_by_q71 - t93;
        const double strand_23_z_by_q71 = layer_1_z_by_q71 - t89;
        const double t214 = strand_23_x * strand_23_x_by_q71 - strand_23_y * layer_1_y_by_q71
            - strand_23_z * strand_23_z_by_q71;
        const double length_23_by_q71 = t214 * t213;
        const double strand_24_x_by_q73 = layer_1_x_by_q73 - t98;
        const double strand_24_x = layer_1_x + t99;
        const double strand_24_y_by_q73 = layer_1_y_by_q73 - t100;
        const double strand_24_y = 0.014 - layer_1_y + t101;
        const double strand_24_z_by_q73 = layer_1_z_by_q73 - t102;
        const double strand_24_z = layer_1_z + t103;
        const double t215 = strand_24_x * strand_24_x_by_q73 - strand_24_y * strand_24_y_by_q73
            + strand_24_z * strand_24_z_by_q73;
        const double t216 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24 = sinew_sqrt(t216);
        const double t217 = 1.0 / length_24;
        const double length_24_by_q73 = t215 * t217;
        const double strand_24_x_by_q71 = layer_1_x_by_q71 - t103;
        const double strand_24_z_by_q71 = layer_1_z_by_q71 - t99;
        const double t218 = strand_24_x * strand_24_x_by_q71 - strand_24_y * layer_1_y_by_q71
            - strand_24_z * strand_24_z_by_q71;
        const double length_24_by_q71 = t218 * t217;
        const double strand_25_x_by_q73 = layer_1_x_by_q73 - t108;
        const double strand_25_x = layer_1_x + t109;
        const double strand_25_y_by_q73 = layer_1_y_by_q73 - t110;
        const double strand_25_y = 0.015 - layer_1_y + t111;
        const double strand_25_z_by_q73 = layer_1_z_by_q73 - t112;
        const double strand_25_z = layer_1_z + t113;
        const double t219 = strand_25_x * strand_25_x_by_q73 - strand_25_y * strand_25_y_by_q73
            + strand_25_z * strand_25_z_by_q73;
        const double t220 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25 = sinew_sqrt(t220);
        const double t221 = 1.0 / length_25;
        const double length_25_by_q73 = t219 * t221;
        const double strand_25_x_by_q71 = layer_1_x_by_q71 - t113;
        const double strand_25_z_by_q71 = layer_1_z_by_q71 - t109;
        const double t222 = strand_25_x * strand_25_x_by_q71 - strand_25_y * layer_1_y_by_q71
            - strand_25_z * strand_25_z_by_q71;
        const double length_25_by_q71 = t222 * t221;
        const double strand_26_x_by_q73 = layer_1_x_by_q73 - t118;
        const double strand_26_x = layer_1_x + t119;
        const double strand_26_y_by_q73 = layer_1_y_by_q73 - t120;
        const double strand_26_y = 0.017 - layer_1_y + t121;
        const double strand_26_z_by_q73 = layer_1_z_by_q73 - t122;
        const double strand_26_z = layer_1_z + t123;
        const double t223 = strand_26_x * strand_26_x_by_q73 - strand_26_y * strand_26_y_by_q73
            + strand_26_z * strand_26_z_by_q73;
        const double t224 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26 = sinew_sqrt(t224);
        const double t225 = 1.0 / length_26;
        const double length_26_by_q73 = t223 * t225;
        const double strand_26_x_by_q71 = layer_1_x_by_q71 - t123;
        const double strand_26_z_by_q71 = layer_1_z_by_q71 - t119;
        const double t226 = strand_26_x * strand_26_x_by_q71 - strand_26_y * layer_1_y_by_q71
            - strand_26_z * strand_26_z_by_q71;
        const double length_26_by_q71 = t226 * t225;
        const double strand_27_y = 0.019 - layer_1_y;
        const double t227 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73
            - strand_27_y * layer_1_y_by_q73;
        const double t228 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y
            * strand_27_y;
        const double length_27 = sinew_sqrt(t228);
        const double t229 = 1.0 / length_27;
        const double length_27_by_q73 = t227 * t229;
        const double t230 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71
            - strand_27_y * layer_1_y_by_q71;
        const double length_27_by_q71 = t230 * t229;
        const double strand_28_x_by_q73 = layer_1_x_by_q73 + t118;
        const double strand_28_x = layer_1_x - t119;
        const double strand_28_y_by_q73 = layer_1_y_by_q73 + t120;
        const double strand_28_y = 0.02 - layer_1_y - t121;
        const double strand_28_z_by_q73 = layer_1_z_by_q73 + t122;
        const double strand_28_z = layer_1_z - t123;
        const double t231 = strand_28_x * strand_28_x_by_q73 - strand_28_y * strand_28_y_by_q73
            + strand_28_z * strand_28_z_by_q73;
        const double t232 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28 = sinew_sqrt(t232);
        const double t233 = 1.0 / length_28;
        const double length_28_by_q73 = t231 * t233;
        const double strand_28_x_by_q71 = layer_1_x_by_q71 + t123;
        const double strand_28_z_by_q71 = layer_1_z_by_q71 + t119;
        const double t234 = strand_28_x * strand_28_x_by_q71 - strand_28_y * layer_1_y_by_q71
            - strand_28_z * strand_28_z_by_q71;
        const double length_28_by_q71 = t234 * t233;
        const double strand_29_x_by_q73 = layer_1_x_by_q73 + t108;
        const double strand_29_x = layer_1_x - t109;
        const double strand_29_y_by_q73 = layer_1_y_by_q73 + t110;
        const double strand_29_y = 0.022 - layer_1_y - t111;
        const double strand_29_z_by_q73 = layer_1_z_by_q73 + t112;
        const double strand_29_z = layer_1_z - t113;
        const double t235 = strand_29_x * strand_29_x_by_q73 - strand_29_y * strand_29_y_by_q73
            + strand_29_z * strand_29_z_by_q73;
        const double t236 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29 = sinew_sqrt(t236);
        const double t237 = 1.0 / length_29;
        const double length_29_by_q73 = t235 * t237;
        const double strand_29_x_by_q71 = layer_1_x_by_q71 + t113;
        const double strand_29_z_by_q71 = layer_1_z_by_q71 + t109;
        const double t238 = strand_29_x * strand_29_x_by_q71 - strand_29_y * layer_1_y_by_q71
            - strand_29_z * strand_29_z_by_q71;
        const double length_29_by_q71 = t238 * t237;
        const double strand_30_x_by_q73 = layer_1_x_by_q73 + t98;
        const double strand_30_x = layer_1_x - t99;
        const double strand_30_y_by_q73 = layer_1_y_by_q73 + t100;
        const double strand_30_y = 0.023 - layer_1_y - t101;
        const double strand_30_z_by_q73 = layer_1_z_by_q73 + t102;
        const double strand_30_z = layer_1_z - t103;
        const double t239 = strand_30_x * strand_30_x_by_q73 - strand_30_y * strand_30_y_by_q73
            + strand_30_z * strand_30_z_by_q73;
        const double t240 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30 = sinew_sqrt(t240);
        const double t241 = 1.0 / length_30;
        const double length_30_by_q73 = t239 * t241;
        const double strand_30_x_by_q71 = layer_1_x_by_q71 + t103;
        const double strand_30_z_by_q71 = layer_1_z_by_q71 + t99;
        const double t242 = strand_30_x * strand_30_x_by_q71 - strand_30_y * layer_1_y_by_q71
            - strand_30_z * strand_30_z_by_q71;
        const double length_30_by_q71 = t242 * t241;
        const double strand_31_x_by_q73 = layer_1_x_by_q73 + t88;
        const double strand_31_x = layer_1_x - t89;
        const double strand_31_y_by_q73 = layer_1_y_by_q73 + t90;
        const double strand_31_y = 0.025 - layer_1_y - t91;
        const double strand_31_z_by_q73 = layer_1_z_by_q73 + t92;
        const double strand_31_z = layer_1_z - t93;
        const double t243 = strand_31_x * strand_31_x_by_q73 - strand_31_y * strand_31_y_by_q73
            + strand_31_z * strand_31_z_by_q73;
        const double t244 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31 = sinew_sqrt(t244);
        const double t245 = 1.0 / length_31;
        const double length_31_by_q73 = t243 * t245;
        const double strand_31_x_by_q71 = layer_1_x_by_q71 + t93;
        const double strand_31_z_by_q71 = layer_1_z_by_q71 + t89;
        const double t246 = strand_31_x * strand_31_x_by_q71 - strand_31_y * layer_1_y_by_q71
            - strand_31_z * strand_31_z_by_q71;
        const double length_31_by_q71 = t246 * t245;
        const double strand_32_x_by_q73 = layer_1_x_by_q73 + t78;
        const double strand_32_x = layer_1_x - t79;
        const double strand_32_y_by_q73 = layer_1_y_by_q73 + t80;
        const double strand_32_y = 0.027 - layer_1_y - t81;
        const double strand_32_z_by_q73 = layer_1_z_by_q73 + t82;
        const double strand_32_z = layer_1_z - t83;
        const double t247 = strand_32_x * strand_32_x_by_q73 - strand_32_y * strand_32_y_by_q73
            + strand_32_z * strand_32_z_by_q73;
        const double t248 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32 = sinew_sqrt(t248);
        const double t249 = 1.0 / length_32;
        const double length_32_by_q73 = t247 * t249;
        const double strand_32_x_by_q71 = layer_1_x_by_q71 + t83;
        const double strand_32_z_by_q71 = layer_1_z_by_q71 + t79;
        const double t250 = strand_32_x * strand_32_x_by_q71 - strand_32_y * layer_1_y_by_q71
            - strand_32_z * strand_32_z_by_q71;
        const double length_32_by_q71 = t250 * t249;
        const double strand_33_x_by_q73 = layer_1_x_by_q73 + t68;
        const double strand_33_x = layer_1_x - t69;
        const double strand_33_y_by_q73 = layer_1_y_by_q73 + t70;
        const double strand_33_y = 0.028 - layer_1_y - t71;
        const double strand_33_z_by_q73 = layer_1_z_by_q73 + t72;
        const double strand_33_z = layer_1_z - t73;
        const double t251 = strand_33_x * strand_33_x_by_q73 - strand_33_y * strand_33_y_by_q73
            + strand_33_z * strand_33_z_by_q73;
        const double t252 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33 = sinew_sqrt(t252);
        const double t253 = 1.0 / length_33;
        const double length_33_by_q73 = t251 * t253;
        const double strand_33_x_by_q71 = layer_1_x_by_q71 + t73;
        const double strand_33_z_by_q71 = layer_1_z_by_q71 + t69;
        const double t254 = strand_33_x * strand_33_x_by_q71 - strand_33_y * layer_1_y_by_q71
            - strand_33_z * strand_33_z_by_q71;
        const double length_33_by_q71 = t254 * t253;
        const double strand_34_x_by_q73 = layer_1_x_by_q73 + t29;
        const double strand_34_x = layer_1_x - t36;
        const double strand_34_y_by_q73 = layer_1_y_by_q73 + t39;
        const double strand_34_y = 0.03 - layer_1_y - t43;
        const double strand_34_z_by_q73 = layer_1_z_by_q73 + t46;
        const double strand_34_z = layer_1_z - t53;
        const double t255 = strand_34_x * strand_34_x_by_q73 - strand_34_y * strand_34_y_by_q73
            + strand_34_z * strand_34_z_by_q73;
        const double t256 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34 = sinew_sqrt(t256);
        const double t257 = 1.0 / length_34;
        const double length_34_by_q73 = t255 * t257;
        const double strand_34_x_by_q71 = layer_1_x_by_q71 + t53;
        const double strand_34_z_by_q71 = layer_1_z_by_q71 + t36;
        const double t258 = strand_34_x * strand_34_x_by_q71 - strand_34_y * layer_1_y_by_q71
            - strand_34_z * strand_34_z_by_q71;
        const double length_34_by_q71 = t258 * t257;
        const double strand_35_x_by_q73 = layer_1_x_by_q73 + t159;
        const double strand_35_x = layer_1_x - t160;
        const double strand_35_y_by_q73 = layer_1_y_by_q73 + t161;
        const double strand_35_y = 0.031 - layer_1_y - t162;
        const double strand_35_z_by_q73 = layer_1_z_by_q73 + t163;
        const double strand_35_z = layer_1_z - t164;
        const double t259 = strand_35_x * strand_35_x_by_q73 - strand_35_y * strand_35_y_by_q73
            + strand_35_z * strand_35_z_by_q73;
        const double t260 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35 = sinew_sqrt(t260);
        const double t261 = 1.0 / length_35;
        const double length_35_by_q73 = t259 * t261;
        const double strand_35_x_by_q71 = layer_1_x_by_q71 + t164;
        const double strand_35_z_by_q71 = layer_1_z_by_q71 + t160;
        const double t262 = strand_35_x * strand_35_x_by_q71 - strand_35_y * layer_1_y_by_q71
            - strand_35_z * strand_35_z_by_q71;
        const double length_35_by_q71 = t262 * t261;
        const double strand_36_x_by_q73 = layer_1_x_by_q73 + t169;
        const double strand_36_x = layer_1_x - t170;
        const double strand_36_y_by_q73 = layer_1_y_by_q73 + t171;
        const double strand_36_y = 0.033 - layer_1_y - t172;
        const double strand_36_z_by_q73 = layer_1_z_by_q73 + t173;
        const double strand_36_z = layer_1_z - t174;
        const double t263 = strand_36_x * strand_36_x_by_q73 - strand_36_y * strand_36_y_by_q73
            + strand_36_z * strand_36_z_by_q73;
        const double t264 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36 = sinew_sqrt(t264);
        const double t265 = 1.0 / length_36;
        const double length_36_by_q73 = t263 * t265;
        const double strand_36_x_by_q71 = layer_1_x_by_q71 + t174;
        const double strand_36_z_by_q71 = layer_1_z_by_q71 + t170;
        const double t266 = strand_36_x * strand_36_x_by_q71 - strand_36_y * layer_1_y_by_q71
            - strand_36_z * strand_36_z_by_q71;
        const double length_36_by_q71 = t266 * t265;
        const double strand_37_x_by_q73 = layer_1_x_by_q73 + t179;
        const double strand_37_x = layer_1_x - t180;
        const double strand_37_y_by_q73 = layer_1_y_by_q73 + t181;
        const double strand_37_y = 0.035 - layer_1_y - t182;
        const double strand_37_z_by_q73 = layer_1_z_by_q73 + t183;
        const double strand_37_z = layer_1_z - t184;
        const double t267 = strand_37_x * strand_37_x_by_q73 - strand_37_y * strand_37_y_by_q73
            + strand_37_z * strand_37_z_by_q73;
        const double t268 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37 = sinew_sqrt(t268);
        const double t269 = 1.0 / length_37;
        const double length_37_by_q73 = t267 * t269;
        const double strand_37_x_by_q71 = layer_1_x_by_q71 + t184;
        const double strand_37_z_by_q71 = layer_1_z_by_q71 + t180;
        const double t270 = strand_37_x * strand_37_x_by_q71 - strand_37_y * layer_1_y_by_q71
            - strand_37_z * strand_37_z_by_q71;
        const double length_37_by_q71 = t270 * t269;
        delta_theta_rate[state] = -(t67 * length_0_by_q71 - t57 * length_0_by_q73);
        delta_theta_rate[1 * n + state] = -(t67 * length_1_by_q71 - t57 * length_1_by_q73);
        delta_theta_rate[2 * n + state] = -(t67 * length_2_by_q71 - t57 * length_2_by_q73);
        delta_theta_rate[3 * n + state] = -(t67 * length_3_by_q71 - t57 * length_3_by_q73);
        delta_theta_rate[4 * n + state] = -(t67 * length_4_by_q71 - t57 * length_4_by_q73);
        delta_theta_rate[5 * n + state] = -(t67 * length_5_by_q71 - t57 * length_5_by_q73);
        delta_theta_rate[6 * n + state] = -(t67 * length_6_by_q71 - t57 * length_6_by_q73);
        delta_theta_rate[7 * n + state] = -(t67 * length_7_by_q71 - t57 * length_7_by_q73);
        delta_theta_rate[8 * n + state] = -(t67 * length_8_by_q71 - t57 * length_8_by_q73);
        delta_theta_rate[9 * n + state] = -(t67 * length_9_by_q71 - t57 * length_9_by_q73);
        delta_theta_rate[10 * n + state] = -(t67 * length_10_by_q71 - t57 * length_10_by_q73);
        delta_theta_rate[11 * n + state] = -(t67 * length_11_by_q71 - t57 * length_11_by_q73);
        delta_theta_rate[12 * n + state] = -(t67 * length_12_by_q71 - t57 * length_12_by_q73);
        delta_theta_rate[13 * n + state] = -(t67 * length_13_by_q71 - t57 * length_13_by_q73);
        delta_theta_rate[14 * n + state] = -(t67 * length_14_by_q71 - t57 * length_14_by_q73);
        delta_theta_rate[15 * n + state] = -(t67 * length_15_by_q71 - t57 * length_15_by_q73);
        delta_theta_rate[16 * n + state] = -(t67 * length_16_by_q71 - t57 * length_16_by_q73);
        delta_theta_rate[17 * n + state] = -(t67 * length_17_by_q71 - t57 * length_17_by_q73);
        delta_theta_rate[18 * n + state] = -(t67 * length_18_by_q71 - t57 * length_18_by_q73);
        delta_theta_rate[19 * n + state] = -(t67 * length_19_by_q71 - t57 * length_19_by_q73);
        delta_theta_rate[20 * n + state] = -(t67 * length_20_by_q71 - t57 * length_20_by_q73);
        delta_theta_rate[21 * n + state] = -(t67 * length_21_by_q71 - t57 * length_21_by_q73);
        delta_theta_rate[22 * n + state] = -(t67 * length_22_by_q71 - t57 * length_22_by_q73);
        delta_theta_rate[23 * n + state] = -(t67 * length_23_by_q71 - t57 * length_23_by_q73);
        delta_theta_rate[24 * n + state] = -(t67 * length_24_by_q71 - t57 * length_24_by_q73);
        delta_theta_rate[25 * n + state] = -(t67 * length_25_by_q71 - t57 * length_25_by_q73);
        delta_theta_rate[26 * n + state] = -(t67 * length_26_by_q71 - t57 * length_26_by_q73);
        delta_theta_rate[27 * n + state] = -(t67 * length_27_by_q71 - t57 * length_27_by_q73);
        delta_theta_rate[28 * n + state] = -(t67 * length_28_by_q71 - t57 * length_28_by_q73);
        delta_theta_rate[29 * n + state] = -(t67 * length_29_by_q71 - t57 * length_29_by_q73);
        delta_theta_rate[30 * n + state] = -(t67 * length_30_by_q71 - t57 * length_30_by_q73);
        delta_theta_rate[31 * n + state] = -(t67 * length_31_by_q71 - t57 * length_31_by_q73);
        delta_theta_rate[32 * n + state] = -(t67 * length_32_by_q71 - t57 * length_32_by_q73);
        delta_theta_rate[33 * n + state] = -(t67 * length_33_by_q71 - t57 * length_33_by_q73);
        delta_theta_rate[34 * n + state] = -(t67 * length_34_by_q71 - t57 * length_34_by_q73);
        delta_theta_rate[35 * n + state] = -(t67 * length_35_by_q71 - t57 * length_35_by_q73);
        delta_theta_rate[36 * n + state] = -(t67 * length_36_by_q71 - t57 * length_36_by_q73);
        delta_theta_rate[37 * n + state] = -(t67 * length_37_by_q71 - t57 * length_37_by_q73);
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
        const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
        const double t1 = 1.0 / B_to_C0_squared;
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
        const double clearance = sinew_max(t20, t21);
        const double root = sinew_sqrt(clearance);
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
        const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double t29 = cos_q71 * cos_A;
        const double x_plane_x = u_y * sin_A;
        const double t30 = sin_q71 * x_plane_x;
        const double x_x_by_q71 = t29 + cos_q71 * x_plane_x_by_q71 - t30 + sin_q71 * cos_A_by_q71;
        const double t31 = origin_x_by_q71 + 0.004 * x_x_by_q71;
        const double t32 = 0.01 * z_x_by_q71;
        const double layer_0_x_by_q71 = t31 + t32;
        const double y_z = sin_q71 * u_e;
        const double t33 = 0.011 * y_z;
        const double strand_0_x_by_q71 = layer_0_x_by_q71 - t33;
        const double t34 = cos_q71 * x_plane_x;
        const double t35 = sin_q71 * cos_A;
        const double x_x = t34 + t35;
        const double M_x = cos_q71 * M_e;
        const double t36 = cos_q71 * z_plane_x;
        const double t37 = sin_q71 * sin_A;
        const double z_x = t36 - t37;
        const double t38 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
        const double t39 = 0.01 * z_x;
        const double layer_0_x = t38 - t39;
        const double y_x = cos_q71 * u_e;
        const double t40 = 0.011 * y_x;
        const double strand_0_x = layer_0_x + t40;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
        const double t41 = 0.004 * u_e;
        const double t42 = origin_y_by_q71 + t41 * sin_A_by_q71;
        const double t43 = 0.01 * z_plane_y_by_q71;
        const double layer_0_y_by_q71 = t42 - t43;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t44 = origin_y + t41 * sin_A;
        const double t45 = 0.01 * z_plane_y;
        const double layer_0_y = t44 - t45;
        const double t46 = 0.011 * u_y;
        const double strand_0_y = 0.007 - layer_0_y + t46;
        const double z_z_by_q71 = t36 + cos_q71 * sin_A_by_q71 - t37 + sin_q71 * z_plane_x_by_q71;
        const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
        const double x_z_by_q71 = t34 - cos_q71 * cos_A_by_q71 + t35 + sin_q71 * x_plane_x_by_q71;
        const double t47 = origin_z_by_q71 - 0.004 * x_z_by_q71;
        const double t48 = 0.01 * z_z_by_q71;
        const double layer_0_z_by_q71 = t47 + t48;
        const double strand_0_z_by_q71 = layer_0_z_by_q71 - t40;
        const double z_z = t26 + t27;
        const double origin_z = M_z - 0.018 * z_z;
        const double x_z = t29 - t30;
        const double t49 = 0.004 * x_z;
        const double t50 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t49 - t50;
        const double strand_0_z = layer_0_z + t33;
        const double t51 = strand_0_x * strand_0_x_by_q71 - strand_0_y * layer_0_y_by_q71
            - strand_0_z * strand_0_z_by_q71;
        const double t52 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z
            * strand_0_z;
        const double length_0 = sinew_sqrt(t52);
        const double t53 = 1.0 / length_0;
        const double length_0_by_q71 = t51 * t53;
        const double t54 = 0.01 * y_z;
        const double strand_1_x_by_q71 = layer_0_x_by_q71 - t54;
        const double t55 = 0.01 * y_x;
        const double strand_1_x = layer_0_x + t55;
        const double t56 = 0.01 * u_y;
        const double strand_1_y = 0.008 - layer_0_y + t56;
        const double strand_1_z_by_q71 = layer_0_z_by_q71 - t55;
        const double strand_1_z = layer_0_z + t54;
        const double t57 = strand_1_x * strand_1_x_by_q71 - strand_1_y * layer_0_y_by_q71
            - strand_1_z * strand_1_z_by_q71;
        const double t58 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1 = sinew_sqrt(t58);
        const double t59 = 1.0 / length_1;
        const double length_1_by_q71 = t57 * t59;
        const double B_to_C0_squared_by_q73 = 0.084 * B_e;
        const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t1;
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
        const double t60 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t60 * t25;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double t61 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t61 * t25;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double M_x_by_q73 = cos_q71 * M_e_by_q73;
        const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t62 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t63 = 0.01 * z_x_by_q73;
        const double layer_0_x_by_q73 = t62 + t63;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t64 = 0.011 * y_x_by_q73;
        const double strand_0_x_by_q73 = layer_0_x_by_q73 - t64;
        const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
        const double t65 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
        const double t66 = 0.01 * z_plane_y_by_q73;
        const double layer_0_y_by_q73 = t65 + t66;
        const double t67 = 0.011 * u_y_by_q73;
        const double strand_0_y_by_q73 = layer_0_y_by_q73 - t67;
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double M_z_by_q73 = sin_q71 * M_e_by_q73;
        const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t68 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t69 = 0.01 * z_z_by_q73;
        const double layer_0_z_by_q73 = t68 + t69;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t70 = 0.011 * y_z_by_q73;
        const double strand_0_z_by_q73 = layer_0_z_by_q73 - t70;
        const double t71 = strand_0_x * strand_0_x_by_q73 - strand_0_y * strand_0_y_by_q73
            + strand_0_z * strand_0_z_by_q73;
        const double length_0_by_q73 = t71 * t53;
        const double t72 = 0.01 * y_x_by_q73;
        const double strand_1_x_by_q73 = layer_0_x_by_q73 - t72;
        const double t73 = 0.01 * u_y_by_q73;
        const double strand_1_y_by_q73 = layer_0_y_by_q73 - t73;
        const double t74 = 0.01 * y_z_by_q73;
        const double strand_1_z_by_q73 = layer_0_z_by_q73 - t74;
        const double t75 = strand_1_x * strand_1_x_by_q73 - strand_1_y * strand_1_y_by_q73
            + strand_1_z * strand_1_z_by_q73;
        const double length_1_by_q73 = t75 * t59;
        const double t76 = 0.008 * y_z;
        const double strand_2_x_by_q71 = layer_0_x_by_q71 - t76;
        const double t77 = 0.008 * y_x;
        const double strand_2_x = layer_0_x + t77;
        const double t78 = 0.008 * u_y;
        const double strand_2_y = 0.01 - layer_0_y + t78;
        const double strand_2_z_by_q71 = layer_0_z_by_q71 - t77;
        const double strand_2_z = layer_0_z + t76;
        const double t79 = strand_2_x * strand_2_x_by_q71 - strand_2_y * layer_0_y_by_q71
            - strand_2_z * strand_2_z_by_q71;
        const double t80 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2 = sinew_sqrt(t80);
        const double t81 = 1.0 / length_2;
        const double length_2_by_q71 = t79 * t81;
        const double t82 = f[state] * length_0_by_q71 + f[1 * n + state] * length_1_by_q71 + f[2 * n
            + state] * length_2_by_q71;
        const double t83 = 0.008 * y_x_by_q73;
        const double strand_2_x_by_q73 = layer_0_x_by_q73 - t83;
        const double t84 = 0.008 * u_y_by_q73;
        const double strand_2_y_by_q73 = layer_0_y_by_q73 - t84;
        const double t85 = 0.008 * y_z_by_q73;
        const double strand_2_z_by_q73 = layer_0_z_by_q73 - t85;
        const double t86 = strand_2_x * strand_2_x_by_q73 - strand_2_y * strand_2_y_by_q73
            + strand_2_z * strand_2_z_by_q73;
        const double length_2_by_q73 = t86 * t81;
        const double t87 = f[state] * length_0_by_q73 + f[1 * n + state] * length_1_by_q73 + f[2 * n
            + state] * length_2_by_q73;
        const double t88 = 0.006 * y_z;
        const double strand_3_x_by_q71 = layer_0_x_by_q71 - t88;
        const double t89 = 0.006 * y_x;
        const double strand_3_x = layer_0_x + t89;
        const double t90 = 0.006 * u_y;
        const double strand_3_y = 0.011 - layer_0_y + t90;
        const double strand_3_z_by_q71 = layer_0_z_by_q71 - t89;
        const double strand_3_z = layer_0_z + t88;
        const double t91 = strand_3_x * strand_3_x_by_q71 - strand_3_y * layer_0_y_by_q71
            - strand_3_z * strand_3_z_by_q71;
        const double t92 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3 = sinew_sqrt(t92);
        const double t93 = 1.0 / length_3;
        const double length_3_by_q71 = t91 * t93;
        const double t94 = 0.006 * y_x_by_q73;
        const double strand_3_x_by_q73 = layer_0_x_by_q73 - t94;
        const double t95 = 0.006 * u_y_by_q73;
        const double strand_3_y_by_q73 = layer_0_y_by_q73 - t95;
        const double t96 = 0.006 * y_z_by_q73;
        const double strand_3_z_by_q73 = layer_0_z_by_q73 - t96;
        const double t97 = strand_3_x * strand_3_x_by_q73 - strand_3_y * strand_3_y_by_q73
            + strand_3_z * strand_3_z_by_q73;
        const double length_3_by_q73 = t97 * t93;
        const double t98 = 0.005 * y_z;
        const double strand_4_x_by_q71 = layer_0_x_by_q71 - t98;
        const double t99 = 0.005 * y_x;
        const double strand_4_x = layer_0_x + t99;
        const double t100 = 0.005 * u_y;
        const double strand_4_y = 0.013 - layer_0_y + t100;
        const double strand_4_z_by_q71 = layer_0_z_by_q71 - t99;
        const double strand_4_z = layer_0_z + t98;
        const double t101 = strand_4_x * strand_4_x_by_q71 - strand_4_y * layer_0_y_by_q71
            - strand_4_z * strand_4_z_by_q71;
        const double t102 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4 = sinew_sqrt(t102);
        const double t103 = 1.0 / length_4;
        const double length_4_by_q71 = t101 * t103;
        const double t104 = t82 + f[3 * n + state] * length_3_by_q71 + f[4 * n + state]
            * length_4_by_q71;
        const double t105 = 0.005 * y_x_by_q73;
        const double strand_4_x_by_q73 = layer_0_x_by_q73 - t105;
        const double t106 = 0.005 * u_y_by_q73;
        const double strand_4_y_by_q73 = layer_0_y_by_q73 - t106;
        const double t107 = 0.005 * y_z_by_q73;
        const double strand_4_z_by_q73 = layer_0_z_by_q73 - t107;
        const double t108 = strand_4_x * strand_4_x_by_q73 - strand_4_y * strand_4_y_by_q73
            + strand_4_z * strand_4_z_by_q73;
        const double length_4_by_q73 = t108 * t103;
        const double t109 = t87 + f[3 * n + state] * length_3_by_q73 + f[4 * n + state]
            * length_4_by_q73;
        const double t110 = 0.003 * y_z;
        const double strand_5_x_by_q71 = layer_0_x_by_q71 - t110;
        const double t111 = 0.003 * y_x;
        const double strand_5_x = layer_0_x + t111;
        const double t112 = 0.003 * u_y;
        const double strand_5_y = 0.015 - layer_0_y + t112;
        const double strand_5_z_by_q71 = layer_0_z_by_q71 - t111;
        const double strand_5_z = layer_0_z + t110;
        const double t113 = strand_5_x * strand_5_x_by_q71 - strand_5_y * layer_0_y_by_q71
            - strand_5_z * strand_5_z_by_q71;
        const double t114 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5 = sinew_sqrt(t114);
        const double t115 = 1.0 / length_5;
        const double length_5_by_q71 = t113 * t115;
        const double t116 = 0.003 * y_x_by_q73;
        const double strand_5_x_by_q73 = layer_0_x_by_q73 - t116;
        const double t117 = 0.003 * u_y_by_q73;
        const double strand_5_y_by_q73 = layer_0_y_by_q73 - t117;
        const double t118 = 0.003 * y_z_by_q73;
        const double strand_5_z_by_q73 = layer_0_z_by_q73 - t118;
        const double t119 = strand_5_x * strand_5_x_by_q73 - strand_5_y * strand_5_y_by_q73
            + strand_5_z * strand_5_z_by_q73;
        const double length_5_by_q73 = t119 * t115;
        const double t120 = 0.002 * y_z;
        const double strand_6_x_by_q71 = layer_0_x_by_q71 - t120;
        const double t121 = 0.002 * y_x;
        const double strand_6_x = layer_0_x + t121;
        const double t122 = 0.002 * u_y;
        const double strand_6_y = 0.016 - layer_0_y + t122;
        const double strand_6_z_by_q71 = layer_0_z_by_q71 - t121;
        const double strand_6_z = layer_0_z + t120;
        const double t123 = strand_6_x * strand_6_x_by_q71 - strand_6_y * layer_0_y_by_q71
            - strand_6_z * strand_6_z_by_q71;
        const double t124 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6 = sinew_sqrt(t124);
        const double t125 = 1.0 / length_6;
        const double length_6_by_q71 = t123 * t125;
        const double t126 = t104 + f[5 * n + state] * length_5_by_q71 + f[6 * n + state]
            * length_6_by_q71;
        const double t127 = 0.002 * y_x_by_q73;
        const double strand_6_x_by_q73 = layer_0_x_by_q73 - t127;
        const double t128 = 0.002 * u_y_by_q73;
        const double strand_6_y_by_q73 = layer_0_y_by_q73 - t128;
        const double t129 = 0.002 * y_z_by_q73;
        const double strand_6_z_by_q73 = layer_0_z_by_q73 - t129;
        const double t130 = strand_6_x * strand_6_x_by_q73 - strand_6_y * strand_6_y_by_q73
            + strand_6_z * strand_6_z_by_q73;
        const double length_6_by_q73 = t130 * t125;
        const double t131 = t109 + f[5 * n + state] * length_5_by_q73 + f[6 * n + state]
            * length_6_by_q73;
        const double strand_7_y = 0.018 - layer_0_y;
        const double t132 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
            * layer_0_y_by_q71;
        const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z
            + strand_7_y * strand_7_y);
        const double t133 = 1.0 / length_7;
        const double length_7_by_q71 = t132 * t133;
        const double t134 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
            * layer_0_y_by_q73;
        const double length_7_by_q73 = t134 * t133;
        const double strand_8_x_by_q71 = layer_0_x_by_q71 + t120;
        const double strand_8_x = layer_0_x - t121;
        const double strand_8_y = 0.019 - layer_0_y - t122;
        const double strand_8_z_by_q71 = layer_0_z_by_q71 + t121;
        const double strand_8_z = layer_0_z - t120;
        const double t135 = strand_8_x * strand_8_x_by_q71 - strand_8_y * layer_0_y_by_q71
            - strand_8_z * strand_8_z_by_q71;
        const double t136 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8 = sinew_sqrt(t136);
        const double t137 = 1.0 / length_8;
        const double length_8_by_q71 = t135 * t137;
        const double t138 = t126 + f[7 * n + state] * length_7_by_q71 + f[8 * n + state]
            * length_8_by_q71;
        const double strand_8_x_by_q73 = layer_0_x_by_q73 + t127;
        const double strand_8_y_by_q73 = layer_0_y_by_q73 + t128;
        const double strand_8_z_by_q73 = layer_0_z_by_q73 + t129;
        const double t139 = strand_8_x * strand_8_x_by_q73 - strand_8_y * strand_8_y_by_q73
            + strand_8_z * strand_8_z_by_q73;
        const double length_8_by_q73 = t139 * t137;
        const double t140 = t131 + f[7 * n + state] * length_7_by_q73 + f[8 * n + state]
            * length_8_by_q73;
        const double strand_9_x_by_q71 = layer_0_x_by_q71 + t110;
        const double strand_9_x = layer_0_x - t111;
        const double strand_9_y = 0.021 - layer_0_y - t112;
        const double strand_9_z_by_q71 = layer_0_z_by_q71 + t111;
        const double strand_9_z = layer_0_z - t110;
        const double t141 = strand_9_x * strand_9_x_by_q71 - strand_9_y * layer_0_y_by_q71
            - strand_9_z * strand_9_z_by_q71;
        const double t142 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9 = sinew_sqrt(t142);
        const double t143 = 1.0 / length_9;
        const double length_9_by_q71 = t141 * t143;
        const double strand_9_x_by_q73 = layer_0_x_by_q73 + t116;
        const double strand_9_y_by_q73 = layer_0_y_by_q73 + t117;
        const double strand_9_z_by_q73 = layer_0_z_by_q73 + t118;
        const double t144 = strand_9_x * strand_9_x_by_q73 - strand_9_y * strand_9_y_by_q73
            + strand_9_z * strand_9_z_by_q73;
        const double length_9_by_q73 = t144 * t143;
        const double strand_10_x_by_q71 = layer_0_x_by_q71 + t98;
        const double strand_10_x = layer_0_x - t99;
        const double strand_10_y = 0.023 - layer_0_y - t100;
        const double strand_10_z_by_q71 = layer_0_z_by_q71 + t99;
        const double strand_10_z = layer_0_z - t98;
        const double t145 = strand_10_x * strand_10_x_by_q71 - strand_10_y * layer_0_y_by_q71
            - strand_10_z * strand_10_z_by_q71;
        const double t146 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10 = sinew_sqrt(t146);
        const double t147 = 1.0 / length_10;
        const double length_10_by_q71 = t145 * t147;
        const double t148 = t138 + f[9 * n + state] * length_9_by_q71 + f[10 * n + state]
            * length_10_by_q71;
        const double strand_10_x_by_q73 = layer_0_x_by_q73 + t105;
        const double strand_10_y_by_q73 = layer_0_y_by_q73 + t106;
        const double strand_10_z_by_q73 = layer_0_z_by_q73 + t107;
        const double t149 = strand_10_x * strand_10_x_by_q73 - strand_10_y * strand_10_y_by_q73
            + strand_10_z * strand_10_z_by_q73;
        const double length_10_by_q73 = t149 * t147;
        const double t150 = t140 + f[9 * n + state] * length_9_by_q73 + f[10 * n + state]
            * length_10_by_q73;
        const double strand_11_x_by_q71 = layer_0_x_by_q71 + t88;
        const double strand_11_x = layer_0_x - t89;
        const double strand_11_y = 0.024 - layer_0_y - t90;
        const double strand_11_z_by_q71 = layer_0_z_by_q71 + t89;
        const double strand_11_z = layer_0_z - t88;
        const double t151 = strand_11_x * strand_11_x_by_q71 - strand_11_y * layer_0_y_by_q71
            - strand_11_z * strand_11_z_by_q71;
        const double t152 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11 = sinew_sqrt(t152);
        const double t153 = 1.0 / length_11;
        const double length_11_by_q71 = t151 * t153;
        const double strand_11_x_by_q73 = layer_0_x_by_q73 + t94;
        const double strand_11_y_by_q73 = layer_0_y_by_q73 + t95;
        const double strand_11_z_by_q73 = layer_0_z_by_q73 + t96;
        const double t154 = strand_11_x * strand_11_x_by_q73 - strand_11_y * strand_11_y_by_q73
            + strand_11_z * strand_11_z_by_q73;
        const double length_11_by_q73 = t154 * t153;
        const double strand_12_x_by_q71 = layer_0_x_by_q71 + t76;
        const double strand_12_x = layer_0_x - t77;
        const double strand_12_y = 0.026 - layer_0_y - t78;
        const double strand_12_z_by_q71 = layer_0_z_by_q71 + t77;
        const double strand_12_z = layer_0_z - t76;
        const double t155 = strand_12_x * strand_12_x_by_q71 - strand_12_y * layer_0_y_by_q71
            - strand_12_z * strand_12_z_by_q71;
        const double t156 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12 = sinew_sqrt(t156);
        const double t157 = 1.0 / length_12;
        const double length_12_by_q71 = t155 * t157;
        const double t158 = t148 + f[11 * n + state] * length_11_by_q71 + f[12 * n + state]
            * length_12_by_q71;
        const double strand_12_x_by_q73 = layer_0_x_by_q73 + t83;
        const double strand_12_y_by_q73 = layer_0_y_by_q73 + t84;
        const double strand_12_z_by_q73 = layer_0_z_by_q73 + t85;
        const double t159 = strand_12_x * strand_12_x_by_q73 - strand_12_y * strand_12_y_by_q73
            + strand_12_z * strand_12_z_by_q73;
        const double length_12_by_q73 = t159 * t157;
        const double t160 = t150 + f[11 * n + state] * length_11_by_q73 + f[12 * n + state]
            * length_12_by_q73;
        const double strand_13_x_by_q71 = layer_0_x_by_q71 + t54;
        const double strand_13_x = layer_0_x - t55;
        const double strand_13_y = 0.027 - layer_0_y - t56;
        const double strand_13_z_by_q71 = layer_0_z_by_q71 + t55;
        const double strand_13_z = layer_0_z - t54;
        const double t161 = strand_13_x * strand_13_x_by_q71 - strand_13_y * layer_0_y_by_q71
            - strand_13_z * strand_13_z_by_q71;
        const double t162 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13 = sinew_sqrt(t162);
        const double t163 = 1.0 / length_13;
        const double length_13_by_q71 = t161 * t163;
        const double strand_13_x_by_q73 = layer_0_x_by_q73 + t72;
        const double strand_13_y_by_q73 = layer_0_y_by_q73 + t73;
        const double strand_13_z_by_q73 = layer_0_z_by_q73 + t74;
        const double t164 = strand_13_x * strand_13_x_by_q73 - strand_13_y * strand_13_y_by_q73
            + strand_13_z * strand_13_z_by_q73;
        const double length_13_by_q73 = t164 * t163;
        const double strand_14_x_by_q71 = layer_0_x_by_q71 + t33;
        const double strand_14_x = layer_0_x - t40;
        const double strand_14_y = 0.029 - layer_0_y - t46;
        const double strand_14_z_by_q71 = layer_0_z_by_q71 + t40;
        const double strand_14_z = layer_0_z - t33;
        const double t165 = strand_14_x * strand_14_x_by_q71 - strand_14_y * layer_0_y_by_q71
            - strand_14_z * strand_14_z_by_q71;
        const double t166 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14 = sinew_sqrt(t166);
        const double t167 = 1.0 / length_14;
        const double length_14_by_q71 = t165 * t167;
        const double t168 = t158 + f[13 * n + state] * length_13_by_q71 + f[14 * n + state]
            * length_14_by_q71;
        const double strand_14_x_by_q73 = layer_0_x_by_q73 + t64;
        const double strand_14_y_by_q73 = layer_0_y_by_q73 + t67;
        const double strand_14_z_by_q73 = layer_0_z_by_q73 + t70;
        const double t169 = strand_14_x * strand_14_x_by_q73 - strand_14_y * strand_14_y_by_q73
            + strand_14_z * strand_14_z_by_q73;
        const double length_14_by_q73 = t169 * t167;
        const double t170 = t160 + f[13 * n + state] * length_13_by_q73 + f[14 * n + state]
            * length_14_by_q73;
        const double t171 = 0.013 * y_z;
        const double strand_15_x_by_q71 = layer_0_x_by_q71 + t171;
        const double t172 = 0.013 * y_x;
        const double strand_15_x = layer_0_x - t172;
        const double t173 = 0.013 * u_y;
        const double strand_15_y = 0.031 - layer_0_y - t173;
        const double strand_15_z_by_q71 = layer_0_z_by_q71 + t172;
        const double strand_15_z = layer_0_z - t171;
        const double t174 = strand_15_x * strand_15_x_by_q71 - strand_15_y * layer_0_y_by_q71
            - strand_15_z * strand_15_z_by_q71;
        const double t175 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15 = sinew_sqrt(t175);
        const double t176 = 1.0 / length_15;
        const double length_15_by_q71 = t174 * t176;
        const double t177 = 0.013 * y_x_by_q73;
        const double strand_15_x_by_q73 = layer_0_x_by_q73 + t177;
        const double t178 = 0.013 * u_y_by_q73;
        const double strand_15_y_by_q73 = layer_0_y_by_q73 + t178;
        const double t179 = 0.013 * y_z_by_q73;
        const double strand_15_z_by_q73 = layer_0_z_by_q73 + t179;
        const double t180 = strand_15_x * strand_15_x_by_q73 - strand_15_y * strand_15_y_by_q73
            + strand_15_z * strand_15_z_by_q73;
        const double length_15_by_q73 = t180 * t176;
        const double t181 = 0.014 * y_z;
        const double strand_16_x_by_q71 = layer_0_x_by_q71 + t181;
        const double t182 = 0.014 * y_x;
        const double strand_16_x = layer_0_x - t182;
        const double t183 = 0.014 * u_y;
        const double strand_16_y = 0.032 - layer_0_y - t183;
        const double strand_16_z_by_q71 = layer_0_z_by_q71 + t182;
        const double strand_16_z = layer_0_z - t181;
        const double t184 = strand_16_x * strand_16_x_by_q71 - strand_16_y * layer_0_y_by_q71
            - strand_16_z * strand_16_z_by_q71;
        const double t185 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16 = sinew_sqrt(t185);
        const double t186 = 1.0 / length_16;
        const double length_16_by_q71 = t184 * t186;
        const double t187 = t168 + f[15 * n + state] * length_15_by_q71 + f[16 * n + state]
            * length_16_by_q71;
        const double t188 = 0.014 * y_x_by_q73;
        const double strand_16_x_by_q73 = layer_0_x_by_q73 + t188;
        const double t189 = 0.014 * u_y_by_q73;
        const double strand_16_y_by_q73 = layer_0_y_by_q73 + t189;
        const double t190 = 0.014 * y_z_by_q73;
        const double strand_16_z_by_q73 = layer_0_z_by_q73 + t190;
        const double t191 = strand_16_x * strand_16_x_by_q73 - strand_16_y * strand_16_y_by_q73
            + strand_16_z * strand_16_z_by_q73;
        const double length_16_by_q73 = t191 * t186;
        const double t192 = t170 + f[15 * n + state] * length_15_by_q73 + f[16 * n + state]
            * length_16_by_q73;
        const double t193 = 0.016 * y_z;
        const double strand_17_x_by_q71 = layer_0_x_by_q71 + t193;
        const double t194 = 0.016 * y_x;
        const double strand_17_x = layer_0_x - t194;
        const double t195 = 0.016 * u_y;
        const double strand_17_y = 0.034 - layer_0_y - t195;
        const double strand_17_z_by_q71 = layer_0_z_by_q71 + t194;
        const double strand_17_z = layer_0_z - t193;
        const double t196 = strand_17_x * strand_17_x_by_q71 - strand_17_y * layer_0_y_by_q71
            - strand_17_z * strand_17_z_by_q71;
        const double t197 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17 = sinew_sqrt(t197);
        const double t198 = 1.0 / length_17;
        const double length_17_by_q71 = t196 * t198;
        const double t199 = 0.016 * y_x_by_q73;
        const double strand_17_x_by_q73 = layer_0_x_by_q73 + t199;
        const double t200 = 0.016 * u_y_by_q73;
        const double strand_17_y_by_q73 = layer_0_y_by_q73 + t200;
        const double t201 = 0.016 * y_z_by_q73;
        const double strand_17_z_by_q73 = layer_0_z_by_q73 + t201;
        const double t202 = strand_17_x * strand_17_x_by_q73 - strand_17_y * strand_17_y_by_q73
            + strand_17_z * strand_17_z_by_q73;
        const double length_17_by_q73 = t202 * t198;
        const double t203 = 0.018 * y_z;
        const double strand_18_x_by_q71 = layer_0_x_by_q71 + t203;
        const double t204 = 0.018 * y_x;
        const double strand_18_x = layer_0_x - t204;
        const double strand_18_y = 0.035 - layer_0_y - 0.018 * u_y;
        const double strand_18_z_by_q71 = layer_0_z_by_q71 + t204;
        const double strand_18_z = layer_0_z - t203;
        const double t205 = strand_18_x * strand_18_x_by_q71 - strand_18_y * layer_0_y_by_q71
            - strand_18_z * strand_18_z_by_q71;
        const double t206 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18 = sinew_sqrt(t206);
        const double t207 = 1.0 / length_18;
        const double length_18_by_q71 = t205 * t207;
        const double t208 = t187 + f[17 * n + state] * length_17_by_q71 + f[18 * n + state]
            * length_18_by_q71;
        const double strand_18_x_by_q73 = layer_0_x_by_q73 + 0.018 * y_x_by_q73;
        const double strand_18_y_by_q73 = layer_0_y_by_q73 + 0.018 * u_y_by_q73;
        const double strand_18_z_by_q73 = layer_0_z_by_q73 + 0.018 * y_z_by_q73;
        const double t209 = strand_18_x * strand_18_x_by_q73 - strand_18_y * strand_18_y_by_q73
            + strand_18_z * strand_18_z_by_q73;
        const double length_18_by_q73 = t209 * t207;
        const double t210 = t192 + f[17 * n + state] * length_17_by_q73 + f[18 * n + state]
            * length_18_by_q73;
        const double layer_1_x_by_q71 = t31 - t32;
        const double strand_19_x_by_q71 = layer_1_x_by_q71 - t171;
        const double layer_1_x = t38 + t39;
        const double strand_19_x = layer_1_x + t172;
        const double layer_1_y_by_q71 = t42 + t43;
        const double layer_1_y = t44 + t45;
        const double strand_19_y = 0.006 - layer_1_y + t173;
        const double layer_1_z_by_q71 = t47 - t48;
        const double strand_19_z_by_q71 = layer_1_z_by_q71 - t172;
        const double layer_1_z = 0.028 - origin_z - t49 + t50;
        const double strand_19_z = layer_1_z + t171;
        const double t211 = strand_19_x * strand_19_x_by_q71 - strand_19_y * layer_1_y_by_q71
            - strand_19_z * strand_19_z_by_q71;
        const double t212 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
            * strand_19_z;
        const double length_19 = sinew_sqrt(t212);
        const double t213 = 1.0 / length_19;
        const double length_19_by_q71 = t211 * t213;
        const double layer_1_x_by_q73 = t62 - t63;
        const double strand_19_x_by_q73 = layer_1_x_by_q73 - t177;
        const double layer_1_y_by_q73 = t65 - t66;
        const double strand_19_y_by_q73 = layer_1_y_by_q73 - t178;
        const double layer_1_z_by_q73 = t68 - t69;
        const double strand_19_z_by_q73 = layer_1_z_by_q73 - t179;
        const double t214 = strand_19_x * strand_19_x_by_q73 - strand_19_y * strand_19_y_by_q73
            + strand_19_z * strand_19_z_by_q73;
        const double length_19_by_q73 = t214 * t213;
        const double strand_20_x_by_q71 = layer_1_x_by_q71 - t33;
        const double strand_20_x = layer_1_x + t40;
        const double strand_20_y = 0.007 - layer_1_y + t46;
        const double strand_20_z_by_q71 = layer_1_z_by_q71 - t40;
        const double strand_20_z = layer_1_z + t33;
        const double t215 = strand_20_x * strand_20_x_by_q71 - strand_20_y * layer_1_y_by_q71
            - strand_20_z * strand_20_z_by_q71;
        const double t216 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20 = sinew_sqrt(t216);
        const double t217 = 1.0 / length_20;
        const double length_20_by_q71 = t215 * t217;
        const double t218 = t208 + f[19 * n + state] * length_19_by_q71 + f[20 * n + state]
            * length_20_by_q71;
        const double strand_20_x_by_q73 = layer_1_x_by_q73 - t64;
        const double strand_20_y_by_q73 = layer_1_y_by_q73 - t67;
        const double strand_20_z_by_q73 = layer_1_z_by_q73 - t70;
        const double t219 = strand_20_x * strand_20_x_by_q73 - strand_20_y * strand_20_y_by_q73
            + strand_20_z * strand_20_z_by_q73;
        const double length_20_by_q73 = t219 * t217;
        const double t220 = t210 + f[19 * n + state] * length_19_by_q73 + f[20 * n + state]
            * length_20_by_q73;
        const double strand_21_x_by_q71 = layer_1_x_by_q71 - t54;
        const double strand_21_x = layer_1_x + t55;
        const double strand_21_y = 0.009 - layer_1_y + t56;
        const double strand_21_z_by_q71 = layer_1_z_by_q71 - t55;
        const double strand_21_z = layer_1_z + t54;
        const double t221 = strand_21_x * strand_21_x_by_q71 - strand_21_y * layer_1_y_by_q71
            - strand_21_z * strand_21_z_by_q71;
        const double t222 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21 = sinew_sqrt(t222);
        const double t223 = 1.0 / length_21;
        const double length_21_by_q71 = t221 * t223;
        const double strand_21_x_by_q73 = layer_1_x_by_q73 - t72;
        const double strand_21_y_by_q73 = layer_1_y_by_q73 - t73;
        const double strand_21_z_by_q73 = layer_1_z_by_q73 - t74;
        const double t224 = strand_21_x * strand_21_x_by_q73 - strand_21_y * strand_21_y_by_q73
            + strand_21_z * strand_21_z_by_q73;
        const double length_21_by_q73 = t224 * t223;
        const double strand_22_x_by_q71 = layer_1_x_by_q71 - t76;
        const double strand_22_x = layer_1_x + t77;
        const double strand_22_y = 0.011 - layer_1_y + t78;
        const double strand_22_z_by_q71 = layer_1_z_by_q71 - t77;
        const double strand_22_z = layer_1_z + t76;
        const double t225 = strand_22_x * strand_22_x_by_q71 - strand_22_y * layer_1_y_by_q71
            - strand_22_z * strand_22_z_by_q71;
        const double t226 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22 = sinew_sqrt(t226);
        const double t227 = 1.0 / length_22;
        const double length_22_by_q71 = t225 * t227;
        const double t228 = t218 + f[21 * n + state] * length_21_by_q71 + f[22 * n + state]
            * length_22_by_q71;
        const double strand_22_x_by_q73 = layer_1_x_by_q73 - t83;
        const double strand_22_y_by_q73 = layer_1_y_by_q73 - t84;
        const double strand_22_z_by_q73 = layer_1_z_by_q73 - t85;
        const double t229 = strand_22_x * strand_22_x_by_q73 - strand_22_y * strand_22_y_by_q73
            + strand_22_z * strand_22_z_by_q73;
        const double length_22_by_q73 = t229 * t227;
        const double t230 = t220 + f[21 * n + state] * length_21_by_q73 + f[22 * n + state]
            * length_22_by_q73;
        const double strand_23_x_by_q71 = layer_1_x_by_q71 - t88;
        const double strand_23_x = layer_1_x + t89;
        const double strand_23_y = 0.012 - layer_1_y + t90;
        const double strand_23_z_by_q71 = layer_1_z_by_q71 - t89;
        const double strand_23_z = layer_1_z + t88;
        const double t231 = strand_23_x * strand_23_x_by_q71 - strand_23_y * layer_1_y_by_q71
            - strand_23_z * strand_23_z_by_q71;
        const double t232 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23 = sinew_sqrt(t232);
        const double t233 = 1.0 / length_23;
        const double length_23_by_q71 = t231 * t233;
        const double strand_23_x_by_q73 = layer_1_x_by_q73 - t94;
        const double strand_23_y_by_q73 = layer_1_y_by_q73 - t95;
        const double strand_23_z_by_q73 = layer_1_z_by_q73 - t96;
        const double t234 = strand_23_x * strand_23_x_by_q73 - strand_23_y * strand_23_y_by_q73
            + strand_23_z * strand_23_z_by_q73;
        const double length_23_by_q73 = t234 * t233;
        const double strand_24_x_by_q71 = layer_1_x_by_q71 - t98;
        const double strand_24_x = layer_1_x + t99;
        const double strand_24_y = 0.014 - layer_1_y + t100;
        const double strand_24_z_by_q71 = layer_1_z_by_q71 - t99;
        const double strand_24_z = layer_1_z + t98;
        const double t235 = strand_24_x * strand_24_x_by_q71 - strand_24_y * layer_1_y_by_q71
            - strand_24_z * strand_24_z_by_q71;
        const double t236 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24 = sinew_sqrt(t236);
        const double t237 = 1.0 / length_24;
        const double length_24_by_q71 = t235 * t237;
        const double t238 = t228 + f[23 * n + state] * length_23_by_q71 + f[24 * n + state]
            * length_24_by_q71;
        const double strand_24_x_by_q73 = layer_1_x_by_q73 - t105;
        const double strand_24_y_by_q73 = layer_1_y_by_q73 - t106;
        const double strand_24_z_by_q73 = layer_1_z_by_q73 - t107;
        const double t239 = strand_24_x * strand_24_x_by_q73 - strand_24_y * strand_24_y_by_q73
            + strand_24_z * strand_24_z_by_q73;
        const double length_24_by_q73 = t239 * t237;
        const double t240 = t230 + f[23 * n + state] * length_23_by_q73 + f[24 * n + state]
            * length_24_by_q73;
        const double strand_25_x_by_q71 = layer_1_x_by_q71 - t110;
        const double strand_25_x = layer_1_x + t111;
        const double strand_25_y = 0.015 - layer_1_y + t112;
        const double strand_25_z_by_q71 = layer_1_z_by_q71 - t111;
        const double strand_25_z = layer_1_z + t110;
        const double t241 = strand_25_x * strand_25_x_by_q71 - strand_25_y * layer_1_y_by_q71
            - strand_25_z * strand_25_z_by_q71;
        const double t242 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25 = sinew_sqrt(t242);
        const double t243 = 1.0 / length_25;
        const double length_25_by_q71 = t241 * t243;
        const double strand_25_x_by_q73 = layer_1_x_by_q73 - t116;
        const double strand_25_y_by_q73 = layer_1_y_by_q73 - t117;
        const double strand_25_z_by_q73 = layer_1_z_by_q73 - t118;
        const double t244 = strand_25_x * strand_25_x_by_q73 - strand_25_y * strand_25_y_by_q73
            + strand_25_z * strand_25_z_by_q73;
        const double length_25_by_q73 = t244 * t243;
        const double strand_26_x_by_q71 = layer_1_x_by_q71 - t120;
        const double strand_26_x = layer_1_x + t121;
        const double strand_26_y = 0.017 - layer_1_y + t122;
        const double strand_26_z_by_q71 = layer_1_z_by_q71 - t121;
        const double strand_26_z = layer_1_z + t120;
        const double t245 = strand_26_x * strand_26_x_by_q71 - strand_26_y * layer_1_y_by_q71
            - strand_26_z * strand_26_z_by_q71;
        const double t246 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26 = sinew_sqrt(t246);
        const double t247 = 1.0 / length_26;
        const double length_26_by_q71 = t245 * t247;
        const double t248 = t238 + f[25 * n + state] * length_25_by_q71 + f[26 * n + state]
            * length_26_by_q71;
        const double strand_26_x_by_q73 = layer_1_x_by_q73 - t127;
        const double strand_26_y_by_q73 = layer_1_y_by_q73 - t128;
        const double strand_26_z_by_q73 = layer_1_z_by_q73 - t129;
        const double t249 = strand_26_x * strand_26_x_by_q73 - strand_26_y * strand_26_y_by_q73
            + strand_26_z * strand_26_z_by_q73;
        const double length_26_by_q73 = t249 * t247;
        const double t250 = t240 + f[25 * n + state] * length_25_by_q73 + f[26 * n + state]
            * length_26_by_q73;
        const double strand_27_y = 0.019 - layer_1_y;
        const double t251 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71
            - strand_27_y * layer_1_y_by_q71;
        const double t252 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y
            * strand_27_y;
        const double length_27 = sinew_sqrt(t252);
        const double t253 = 1.0 / length_27;
        const double length_27_by_q71 = t251 * t253;
        const double t254 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73
            - strand_27_y * layer_1_y_by_q73;
        const double length_27_by_q73 = t254 * t253;
        const double strand_28_x_by_q71 = layer_1_x_by_q71 + t120;
        const double strand_28_x = layer_1_x - t121;
        const double strand_28_y = 0.02 - layer_1_y - t122;
        const double strand_28_z_by_q71 = layer_1_z_by_q71 + t121;
        const double strand_28_z = layer_1_z - t120;
        const double t255 = strand_28_x * strand_28_x_by_q71 - strand_28_y * layer_1_y_by_q71
            - strand_28_z * strand_28_z_by_q71;
        const double t256 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28 = sinew_sqrt(t256);
        const double t257 = 1.0 / length_28;
        const double length_28_by_q71 = t255 * t257;
        const double t258 = t248 + f[27 * n + state] * length_27_by_q71 + f[28 * n + state]
            * length_28_by_q71;
        const double strand_28_x_by_q73 = layer_1_x_by_q73 + t127;
        const double strand_28_y_by_q73 = layer_1_y_by_q73 + t128;
        const double strand_28_z_by_q73 = layer_1_z_by_q73 + t129;
        const double t259 = strand_28_x * strand_28_x_by_q73 - strand_28_y * strand_28_y_by_q73
            + strand_28_z * strand_28_z_by_q73;
        const double length_28_by_q73 = t259 * t257;
        const double t260 = t250 + f[27 * n + state] * length_27_by_q73 + f[28 * n + state]
            * length_28_by_q73;
        const double strand_29_x_by_q71 = layer_1_x_by_q71 + t110;
        const double strand_29_x = layer_1_x - t111;
        const double strand_29_y = 0.022 - layer_1_y - t112;
        const double strand_29_z_by_q71 = layer_1_z_by_q71 + t111;
        const double strand_29_z = layer_1_z - t110;
        const double t261 = strand_29_x * strand_29_x_by_q71 - strand_29_y * layer_1_y_by_q71
            - strand_29_z * strand_29_z_by_q71;
        const double t262 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29 = sinew_sqrt(t262);
        const double t263 = 1.0 / length_29;
        const double length_29_by_q71 = t261 * t263;
        const double strand_29_x_by_q73 = layer_1_x_by_q73 + t116;
        const double strand_29_y_by_q73 = layer_1_y_by_q73 + t117;
        const double strand_29_z_by_q73 = layer_1_z_by_q73 + t118;
        const double t264 = strand_29_x * strand_29_x_by_q73 - strand_29_y * strand_29_y_by_q73
            + strand_29_z * strand_29_z_by_q73;
        const double length_29_by_q73 = t264 * t263;
        const double strand_30_x_by_q71 = layer_1_x_by_q71 + t98;
        const double strand_30_x = layer_1_x - t99;
        const double strand_30_y = 0.023 - layer_1_y - t100;
        const double strand_30_z_by_q71 = layer_1_z_by_q71 + t99;
        const double strand_30_z = layer_1_z - t98;
        const double t265 = strand_30_x * strand_30_x_by_q71 - strand_30_y * layer_1_y_by_q71
            - strand_30_z * strand_30_z_by_q71;
        const double t266 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30 = sinew_sqrt(t266);
        const double t267 = 1.0 / length_30;
        const double length_30_by_q71 = t265 * t267;
        const double t268 = t258 + f[29 * n + state] * length_29_by_q71 + f[30 * n + state]
            * length_30_by_q71;
        const double strand_30_x_by_q73 = layer_1_x_by_q73 + t105;
        const double strand_30_y_by_q73 = layer_1_y_by_q73 + t106;
        const double strand_30_z_by_q73 = layer_1_z_by_q73 + t107;
        const double t269 = strand_30_x * strand_30_x_by_q73 - strand_30_y * strand_30_y_by_q73
            + strand_30_z * strand_30_z_by_q73;
        const double length_30_by_q73 = t269 * t267;
        const double t270 = t260 + f[29 * n + state] * length_29_by_q73 + f[30 * n + state]
            * length_30_by_q73;
        const double strand_31_x_by_q71 = layer_1_x_by_q71 + t88;
        const double strand_31_x = layer_1_x - t89;
        const double strand_31_y = 0.025 - layer_1_y - t90;
        const double strand_31_z_by_q71 = layer_1_z_by_q71 + t89;
        const double strand_31_z = layer_1_z - t88;
        const double t271 = strand_31_x * strand_31_x_by_q71 - strand_31_y * layer_1_y_by_q71
            - strand_31_z * strand_31_z_by_q71;
        const double t272 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31 = sinew_sqrt(t272);
        const double t273 = 1.0 / length_31;
        const double length_31_by_q71 = t271 * t273;
        const double strand_31_x_by_q73 = layer_1_x_by_q73 + t94;
        const double strand_31_y_by_q73 = layer_1_y_by_q73 + t95;
        const double strand_31_z_by_q73 = layer_1_z_by_q73 + t96;
        const double t274 = strand_31_x * strand_31_x_by_q73 - strand_31_y * strand_31_y_by_q73
            + strand_31_z * strand_31_z_by_q73;
        const double length_31_by_q73 = t274 * t273;
        const double strand_32_x_by_q71 = layer_1_x_by_q71 + t76;
        const double strand_32_x = layer_1_x - t77;
        const double strand_32_y = 0.027 - layer_1_y - t78;
        const double strand_32_z_by_q71 = layer_1_z_by_q71 + t77;
        const double strand_32_z = layer_1_z - t76;
        const double t275 = strand_32_x * strand_32_x_by_q71 - strand_32_y * layer_1_y_by_q71
            - strand_32_z * strand_32_z_by_q71;
        const double t276 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32 = sinew_sqrt(t276);
        const double t277 = 1.0 / length_32;
        const double length_32_by_q71 = t275 * t277;
        const double t278 = t268 + f[31 * n + state] * length_31_by_q71 + f[32 * n + state]
            * length_32_by_q71;
        const double strand_32_x_by_q73 = layer_1_x_by_q73 + t83;
        const double strand_32_y_by_q73 = layer_1_y_by_q73 + t84;
        const double strand_32_z_by_q73 = layer_1_z_by_q73 + t85;
        const double t279 = strand_32_x * strand_32_x_by_q73 - strand_32_y * strand_32_y_by_q73
            + strand_32_z * strand_32_z_by_q73;
        const double length_32_by_q73 = t279 * t277;
        const double t280 = t270 + f[31 * n + state] * length_31_by_q73 + f[32 * n + state]
            * length_32_by_q73;
        const double strand_33_x_by_q71 = layer_1_x_by_q71 + t54;
        const double strand_33_x = layer_1_x - t55;
        const double strand_33_y = 0.028 - layer_1_y - t56;
        const double strand_33_z_by_q71 = layer_1_z_by_q71 + t55;
        const double strand_33_z = layer_1_z - t54;
        const double t281 = strand_33_x * strand_33_x_by_q71 - strand_33_y * layer_1_y_by_q71
            - strand_33_z * strand_33_z_by_q71;
        const double t282 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33 = sinew_sqrt(t282);
        const double t283 = 1.0 / length_33;
        const double length_33_by_q71 = t281 * t283;
        const double strand_33_x_by_q73 = layer_1_x_by_q73 + t72;
        const double strand_33_y_by_q73 = layer_1_y_by_q73 + t73;
        const double strand_33_z_by_q73 = layer_1_z_by_q73 + t74;
        const double t284 = strand_33_x * strand_33_x_by_q73 - strand_33_y * strand_33_y_by_q73
            + strand_33_z * strand_33_z_by_q73;
        const double length_33_by_q73 = t284 * t283;
        const double strand_34_x_by_q71 = layer_1_x_by_q71 + t33;
        const double strand_34_x = layer_1_x - t40;
        const double strand_34_y = 0.03 - layer_1_y - t46;
        const double strand_34_z_by_q71 = layer_1_z_by_q71 + t40;
        const double strand_34_z = layer_1_z - t33;
        const double t285 = strand_34_x * strand_34_x_by_q71 - strand_34_y * layer_1_y_by_q71
            - strand_34_z * strand_34_z_by_q71;
        const double t286 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34 = sinew_sqrt(t286);
        const double t287 = 1.0 / length_34;
        const double length_34_by_q71 = t285 * t287;
        const double t288 = t278 + f[33 * n + state] * length_33_by_q71 + f[34 * n + state]
            * length_34_by_q71;
        const double strand_34_x_by_q73 = layer_1_x_by_q73 + t64;
        const double strand_34_y_by_q73 = layer_1_y_by_q73 + t67;
        const double strand_34_z_by_q73 = layer_1_z_by_q73 + t70;
        const double t289 = strand_34_x * strand_34_x_by_q73 - strand_34_y * strand_34_y_by_q73
            + strand_34_z * strand_34_z_by_q73;
        const double length_34_by_q73 = t289 * t287;
        const double t290 = t280 + f[33 * n + state] * length_33_by_q73 + f[34 * n + state]
            * length_34_by_q73;
        const double strand_35_x_by_q71 = layer_1_x_by_q71 + t171;
        const double strand_35_x = layer_1_x - t172;
        const double strand_35_y = 0.031 - layer_1_y - t173;
        const double strand_35_z_by_q71 = layer_1_z_by_q71 + t172;
        const double strand_35_z = layer_1_z - t171;
        const double t291 = strand_35_x * strand_35_x_by_q71 - strand_35_y * layer_1_y_by_q71
            - strand_35_z * strand_35_z_by_q71;
        const double t292 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35 = sinew_sqrt(t292);
        const double t293 = 1.0 / length_35;
        const double length_35_by_q71 = t291 * t293;
        const double strand_35_x_by_q73 = layer_1_x_by_q73 + t177;
        const double strand_35_y_by_q73 = layer_1_y_by_q73 + t178;
        const double strand_35_z_by_q73 = layer_1_z_by_q73 + t179;
        const double t294 = strand_35_x * strand_35_x_by_q73 - strand_35_y * strand_35_y_by_q73
            + strand_35_z * strand_35_z_by_q73;
        const double length_35_by_q73 = t294 * t293;
        const double strand_36_x_by_q71 = layer_1_x_by_q71 + t181;
        const double strand_36_x = layer_1_x - t182;
        const double strand_36_y = 0.033 - layer_1_y - t183;
        const double strand_36_z_by_q71 = layer_1_z_by_q71 + t182;
        const double strand_36_z = layer_1_z - t181;
        const double t295 = strand_36_x * strand_36_x_by_q71 - strand_36_y * layer_1_y_by_q71
            - strand_36_z * strand_36_z_by_q71;
        const double t296 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36 = sinew_sqrt(t296);
        const double t297 = 1.0 / length_36;
        const double length_36_by_q71 = t295 * t297;
        const double t298 = t288 + f[35 * n + state] * length_35_by_q71 + f[36 * n + state]
            * length_36_by_q71;
        const double strand_36_x_by_q73 = layer_1_x_by_q73 + t188;
        const double strand_36_y_by_q73 = layer_1_y_by_q73 + t189;
        const double strand_36_z_by_q73 = layer_1_z_by_q73 + t190;
        const double t299 = strand_36_x * strand_36_x_by_q73 - strand_36_y * strand_36_y_by_q73
            + strand_36_z * strand_36_z_by_q73;
        const double length_36_by_q73 = t299 * t297;
        const double t300 = t290 + f[35 * n + state] * length_35_by_q73 + f[36 * n + state]
            * length_36_by_q73;
        const double strand_37_x_by_q71 = layer_1_x_by_q71 + t193;
        const double strand_37_x = layer_1_x - t194;
        const double strand_37_y = 0.035 - layer_1_y - t195;
        const double strand_37_z_by_q71 = layer_1_z_by_q71 + t194;
        const double strand_37_z = layer_1_z - t193;
        const double t301 = strand_37_x * strand_37_x_by_q71 - strand_37_y * layer_1_y_by_q71
            - strand_37_z * strand_37_z_by_q71;
        const double t302 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37 = sinew_sqrt(t302);
        const double t303 = 1.0 / length_37;
        const double length_37_by_q71 = t301 * t303;
        const double strand_37_x_by_q73 = layer_1_x_by_q73 + t199;
        const double strand_37_y_by_q73 = layer_1_y_by_q73 + t200;
        const double strand_37_z_by_q73 = layer_1_z_by_q73 + t201;
        const double t304 = strand_37_x * strand_37_x_by_q73 - strand_37_y * strand_37_y_by_q73
            + strand_37_z * strand_37_z_by_q73;
        const double length_37_by_q73 = t304 * t303;
        tau[state] = -(t298 + f[37 * n + state] * length_37_by_q71);
        tau[1 * n + state] = t300 + f[37 * n + state] * length_37_by_q73;
    }
}
