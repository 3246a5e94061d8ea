/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Wrist: double inverted parallelogram with 38 tendons
 *
 * Made by: sinew generate models/wrist
 * Model:   sha256 5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011
 * Do not edit: change the model and generate again.
 */
#include "wrist.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

SINEW_NOT_INLINE static double sinew_one_asin(double x)
{
    return sinew_asin(x);
}

SINEW_NOT_INLINE static double sinew_one_atan2(double y, double x)
{
    return sinew_atan2(y, x);
}

struct sinew_sines {
    double s[1], c[1];
};

SINEW_NOT_INLINE static struct sinew_sines sinew_one_sincos(double x)
{
    struct sinew_sines y;
    sinew_sincos(x, y.s, y.c);
    return y;
}

struct sinew_sines2 {
    double s[2], c[2];
};

SINEW_NOT_INLINE static struct sinew_sines2 sinew_one_sincos2(double x0, double x1)
{
    struct sinew_sines2 y;
    const double x[2] = {x0, x1};
    sinew_sincos2(x, y.s, y.c);
    return y;
}

void wrist_pose(double q71, double q73, double T[SINEW_AT_LEAST(16)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t2;
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
    T[0] = x_x;
    T[1] = y_x;
    T[2] = z_x;
    T[3] = origin_x;
    T[4] = -x_plane_y;
    T[5] = u_y;
    T[6] = -z_plane_y;
    T[7] = origin_y;
    T[8] = -x_z;
    T[9] = y_z;
    T[10] = z_z;
    T[11] = origin_z;
    T[12] = 0.0;
    T[13] = 0.0;
    T[14] = 0.0;
    T[15] = 1.0;
}

void wrist_points(double q71, double q73, double ABC[SINEW_AT_LEAST(9)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double z_plane_x = u_y * cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double M_x = cos_q71 * M_e;
    ABC[0] = M_x - 0.036 * z_x;
    ABC[1] = M_y + 0.036 * u_e * cos_A;
    ABC[2] = M_z - 0.036 * z_z;
    ABC[3] = B_x;
    ABC[4] = B_y;
    ABC[5] = B_z;
    ABC[6] = C_x;
    ABC[7] = -C_y;
    ABC[8] = C_z;
}

void wrist_palm_angles(double q71, double q73, double angles[SINEW_AT_LEAST(2)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double x_plane_y = u_e * sin_A;
    angles[0] = sinew_one_atan2(-x_z, x_x);
    angles[1] = sinew_one_asin(sinew_min(sinew_max(-x_plane_y, -1.0), 1.0));
}

void wrist_bar_angles(double flexion, double abduction, double q[SINEW_AT_LEAST(2)],
    double residual[SINEW_AT_LEAST(1)], int *status)
{
    const double limited_flexion = sinew_min(sinew_max(flexion, -1.5), 1.5);
    const double t1 = 0.5 * limited_flexion;
    const double limited_abduction = sinew_min(sinew_max(abduction, -1.5), 1.5);
    const struct sinew_sines2 sines2 = sinew_one_sincos2(t1, limited_abduction);
    const double c4 = sines2.c[0];
    const double v_y = sines2.s[1];
    const double level = sines2.c[1];
    const struct sinew_sines sines5 = sinew_one_sincos(limited_flexion);
    const double s6 = sines5.s[0];
    const double c7 = sines5.c[0];
    const double q71_start = t1 + sinew_one_asin(0.584304725845076 * c4);
    const double v_x = level * c7;
    const double v_z = level * s6;
    const double t8 = v_y * v_y;
    const double t9 = 1e-12 - t8;
    double sum11 = q71_start;
    for (int i10 = 0; i10 < 4; ++i10) {
        const struct sinew_sines sines12 = sinew_one_sincos(sum11);
        const double s13 = sines12.s[0];
        const double c14 = sines12.c[0];
        const double t15 = v_x * c14 + v_z * s13;
        const double t16 = t15 * t15;
        const double t17 = 1.0 / sinew_sqrt(sinew_max(t8 + t16, 1e-12));
        const double t18 = v_y * t17;
        const double t19 = c14 * t18;
        const double t20 = s13 * t18;
        const double t21 = t15 * t17;
        const double t22 = 0.074565407529229 * c14;
        const double t23 = 0.5 * t21;
        const double t24 = sinew_sqrt(sinew_max(0.5 + t23, 1e-12));
        const double t25 = 0.5632638698251111 * t24;
        const double t26 = sinew_sqrt(1.0 - t25 * t25);
        const double t27 = 1.0 / t24;
        const double t28 = 0.5 * t18 * t27;
        const double t29 = t24 * t26 - t28 * t25;
        const double t30 = t22 * t29;
        const double t31 = 0.021 * t19 + 0.036 * (v_y * t20 + v_z * t21) + t30;
        const double t32 = 0.021 * (1.0 + t21) + 0.036 * (v_x * t20 - v_z * t19) - 0.074565407529229
            * (t24 * t25 + t28 * t26);
        const double t33 = 0.074565407529229 * s13;
        const double t34 = t33 * t29;
        const double t35 = 0.036 * (1.0 + (v_x * t21 + v_y * t19)) - 0.021 * t20 - t34;
        const double t36 = v_x * s13 - v_z * c14;
        const double t37 = t15 * t36 * sinew_choose(-(t9 - t16), 1.0, 0.0) * t17;
        const double t38 = t18 * t37 * t17;
        const double t39 = t20 - c14 * t38;
        const double t40 = t19 + s13 * t38;
        const double t41 = (t36 - t21 * t37) * t17;
        const double t42 = 0.25 * t41 * sinew_choose(0.499999999999 + t23, 1.0, 0.0) * t27;
        const double t43 = 0.5632638698251111 * t42;
        const double t44 = t25 * t43 / t26;
        const double t45 = 0.5 * (t38 + (t28 + t28) * t42) * t27;
        const double t46 = t24 * t44 + t28 * t43 - t25 * t45 - t26 * t42;
        const double t47 = 0.021 * t41 - 0.036 * (v_x * t40 + v_z * t39) - 0.074565407529229 * (t24
            * t43 - t28 * t44 + t25 * t42 - t26 * t45);
        const double t48 = t31 * (0.021 * t39 - 0.036 * (v_y * t40 - v_z * t41) - t22 * t46 + t34)
            + t32 * t47;
        const double t49 = t48 + t35 * (0.021 * t40 + 0.036 * (v_x * t41 + v_y * t39) + t30 + t33
            * t46);
        const double t50 = -t49;
        const double t51 = (0.001898 - 0.5 * (t31 * t31 + t32 * t32 + t35 * t35))
            / sinew_choose(t50, sinew_max(t50, 1.8e-09), sinew_min(t50, -1.8e-09));
        sum11 = sum11 + sinew_min(sinew_max(t51, -0.2), 0.2);
    }
    const struct sinew_sines sines52 = sinew_one_sincos(sum11);
    const double sin_q71_8 = sines52.s[0];
    const double cos_q71_8 = sines52.c[0];
    const double v_e_8 = v_x * cos_q71_8 + v_z * sin_q71_8;
    const double v_length_8 = sinew_sqrt(sinew_max(t8 + v_e_8 * v_e_8, 1e-12));
    const double t53 = 1.0 / v_length_8;
    const double cos_tilt_8 = v_e_8 * t53;
    const double cos_half_tilt_8 = sinew_sqrt(sinew_max(0.5 * (1.0 + cos_tilt_8), 1e-12));
    const double cos_sum_8 = 0.5632638698251111 * cos_half_tilt_8;
    const double sin_sum_8 = sinew_sqrt(1.0 - cos_sum_8 * cos_sum_8);
    const double sin_tilt_8 = v_y * t53;
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
    const double t54 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t54;
    const double sin_A = (p_y * root - p_z * limited) * t54;
    const double x_plane_x = u_y_10 * sin_A;
    const double x_z = cos_q71_8 * cos_A - sin_q71_8 * x_plane_x;
    const double x_plane_y = u_e * sin_A;
    const double aside_x = v_y * x_z - v_z * x_plane_y;
    const double x_x = cos_q71_8 * x_plane_x + sin_q71_8 * cos_A;
    const double aside_y = v_x * x_z + v_z * x_x;
    const double aside_z = v_x * x_plane_y + v_y * x_x;
    const double error_sine = sinew_sqrt(aside_x * aside_x + aside_y * aside_y + aside_z * aside_z);
    const double residual_2 = sinew_one_atan2(error_sine, v_x * x_x - v_y * x_plane_y - v_z * x_z);
    const double t55 = flexion - limited_flexion;
    const double t56 = abduction - limited_abduction;
    const double t57 = sinew_choose(1e-06 - residual_2 - sinew_max(-t55, t55) - sinew_max(-t56,
        t56), sinew_choose(-(1e-06 - sin_q73_8), 0.0, 1.0), 1.0);
    q[0] = sum11;
    q[1] = sinew_one_atan2(sin_q73_8, cos_q73_8);
    residual[0] = residual_2;
    *status = (int)t57;
}

void wrist_singularity(double q71, double q73, double distance[SINEW_AT_LEAST(2)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q73, q71);
    const double sin_q73 = sines1.s[0];
    const double cos_q73 = sines1.c[0];
    const double sin_q71 = sines1.s[1];
    const double cos_q71 = sines1.c[1];
    const double t2 = sinew_one_atan2(sinew_max(sin_q73, -sin_q73), sinew_max(cos_q73, -cos_q73));
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
    distance[0] = t2;
    distance[1] = sinew_one_atan2(height, sinew_max(-projection, projection));
}

void wrist_status(double q71, double q73, int *status)
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q73, q71);
    const double sin_q73 = sines1.s[0];
    const double cos_q73 = sines1.c[0];
    const double sin_q71 = sines1.s[1];
    const double cos_q71 = sines1.c[1];
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
    const double t2 = sinew_choose(0.999999999999 * reach * reach - projection * projection, 0.0,
        1.0);
    *status = (int)sinew_choose(-(1e-06 - sin_q73), t2, 1.0);
}

void wrist_tendon_lengths(double q71, double q73, double h[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double M_x = cos_q71 * M_e;
    const double z_plane_x = u_y * cos_A;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double t3 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t4 = 0.01 * z_x;
    const double layer_0_x = t3 - t4;
    const double y_x = cos_q71 * u_e;
    const double t5 = 0.011 * y_x;
    const double strand_0_x = layer_0_x + t5;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t6 = origin_y + 0.004 * u_e * sin_A;
    const double t7 = 0.01 * z_plane_y;
    const double layer_0_y = t6 - t7;
    const double t8 = 0.011 * u_y;
    const double strand_0_y = 0.007 - layer_0_y + t8;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t9 = 0.004 * x_z;
    const double t10 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t9 - t10;
    const double y_z = sin_q71 * u_e;
    const double t11 = 0.011 * y_z;
    const double strand_0_z = layer_0_z + t11;
    const double t12 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z * strand_0_z;
    const double length_0 = sinew_sqrt(t12);
    h[0] = length_0;
    const double t13 = 0.01 * y_x;
    const double strand_1_x = layer_0_x + t13;
    const double t14 = 0.01 * u_y;
    const double strand_1_y = 0.008 - layer_0_y + t14;
    const double t15 = 0.01 * y_z;
    const double strand_1_z = layer_0_z + t15;
    const double t16 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z * strand_1_z;
    const double length_1 = sinew_sqrt(t16);
    h[1] = length_1;
    const double t17 = 0.008 * y_x;
    const double strand_2_x = layer_0_x + t17;
    const double t18 = 0.008 * u_y;
    const double strand_2_y = 0.01 - layer_0_y + t18;
    const double t19 = 0.008 * y_z;
    const double strand_2_z = layer_0_z + t19;
    const double t20 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z * strand_2_z;
    const double length_2 = sinew_sqrt(t20);
    h[2] = length_2;
    const double t21 = 0.006 * y_x;
    const double strand_3_x = layer_0_x + t21;
    const double t22 = 0.006 * u_y;
    const double strand_3_y = 0.011 - layer_0_y + t22;
    const double t23 = 0.006 * y_z;
    const double strand_3_z = layer_0_z + t23;
    const double t24 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z * strand_3_z;
    const double length_3 = sinew_sqrt(t24);
    h[3] = length_3;
    const double t25 = 0.005 * y_x;
    const double strand_4_x = layer_0_x + t25;
    const double t26 = 0.005 * u_y;
    const double strand_4_y = 0.013 - layer_0_y + t26;
    const double t27 = 0.005 * y_z;
    const double strand_4_z = layer_0_z + t27;
    const double t28 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z * strand_4_z;
    const double length_4 = sinew_sqrt(t28);
    h[4] = length_4;
    const double t29 = 0.003 * y_x;
    const double strand_5_x = layer_0_x + t29;
    const double t30 = 0.003 * u_y;
    const double strand_5_y = 0.015 - layer_0_y + t30;
    const double t31 = 0.003 * y_z;
    const double strand_5_z = layer_0_z + t31;
    const double t32 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z * strand_5_z;
    const double length_5 = sinew_sqrt(t32);
    h[5] = length_5;
    const double t33 = 0.002 * y_x;
    const double strand_6_x = layer_0_x + t33;
    const double t34 = 0.002 * u_y;
    const double strand_6_y = 0.016 - layer_0_y + t34;
    const double t35 = 0.002 * y_z;
    const double strand_6_z = layer_0_z + t35;
    const double t36 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z * strand_6_z;
    const double length_6 = sinew_sqrt(t36);
    h[6] = length_6;
    const double strand_7_y = 0.018 - layer_0_y;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    h[7] = length_7;
    const double layer_1_x = t3 + t4;
    const double strand_19_x = layer_1_x + 0.013 * y_x;
    const double layer_1_y = t6 + t7;
    const double strand_19_y = 0.006 - layer_1_y + 0.013 * u_y;
    const double layer_1_z = 0.028 - origin_z - t9 + t10;
    const double strand_19_z = layer_1_z + 0.013 * y_z;
    const double t37 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
        * strand_19_z;
    const double length_19 = sinew_sqrt(t37);
    h[19] = length_19;
    const double strand_20_x = layer_1_x + t5;
    const double strand_20_y = 0.007 - layer_1_y + t8;
    const double strand_20_z = layer_1_z + t11;
    const double t38 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
        * strand_20_z;
    const double length_20 = sinew_sqrt(t38);
    h[20] = length_20;
    const double strand_21_x = layer_1_x + t13;
    const double strand_21_y = 0.009 - layer_1_y + t14;
    const double strand_21_z = layer_1_z + t15;
    const double t39 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
        * strand_21_z;
    const double length_21 = sinew_sqrt(t39);
    h[21] = length_21;
    const double strand_22_x = layer_1_x + t17;
    const double strand_22_y = 0.011 - layer_1_y + t18;
    const double strand_22_z = layer_1_z + t19;
    const double t40 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
        * strand_22_z;
    const double length_22 = sinew_sqrt(t40);
    h[22] = length_22;
    const double strand_23_x = layer_1_x + t21;
    const double strand_23_y = 0.012 - layer_1_y + t22;
    const double strand_23_z = layer_1_z + t23;
    const double t41 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
        * strand_23_z;
    const double length_23 = sinew_sqrt(t41);
    h[23] = length_23;
    const double strand_24_x = layer_1_x + t25;
    const double strand_24_y = 0.014 - layer_1_y + t26;
    const double strand_24_z = layer_1_z + t27;
    const double t42 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
        * strand_24_z;
    const double length_24 = sinew_sqrt(t42);
    h[24] = length_24;
    const double strand_25_x = layer_1_x + t29;
    const double strand_25_y = 0.015 - layer_1_y + t30;
    const double strand_25_z = layer_1_z + t31;
    const double t43 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
        * strand_25_z;
    const double length_25 = sinew_sqrt(t43);
    h[25] = length_25;
    const double strand_26_x = layer_1_x + t33;
    const double strand_26_y = 0.017 - layer_1_y + t34;
    const double strand_26_z = layer_1_z + t35;
    const double t44 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
        * strand_26_z;
    const double length_26 = sinew_sqrt(t44);
    h[26] = length_26;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t45 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t45);
    h[27] = length_27;
    static const double table47[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    for (int i46 = 0; i46 < 11; ++i46) {
        const double strand_x = layer_0_x - table47[i46][0] * y_x;
        const double strand_y = table47[i46][1] - layer_0_y - table47[i46][0] * u_y;
        const double strand_z = layer_0_z - table47[i46][0] * y_z;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        h[8 + i46] = length;
    }
    static const double table49[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    for (int i48 = 0; i48 < 10; ++i48) {
        const double strand_x_2 = layer_1_x - table49[i48][0] * y_x;
        const double strand_y_2 = table49[i48][1] - layer_1_y - table49[i48][0] * u_y;
        const double strand_z_2 = layer_1_z - table49[i48][0] * y_z;
        const double t50 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_8 = sinew_sqrt(t50);
        h[28 + i48] = length_8;
    }
}

void wrist_tendon_jacobian(double q71, double q73, double P[SINEW_AT_LEAST(76)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double t2 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_e = B_e * ratio;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double t4 = 0.5 * B_e;
    const double M_y_by_q73 = t4 + 0.5 * C_y_by_q73;
    const double t5 = 23.80952380952381 * B_e;
    const double u_e = t5 - 23.80952380952381 * C_e;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double t6 = 0.5 * B_y;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double C_y = 0.002 * ratio * t3;
    const double t7 = 23.80952380952381 * B_y;
    const double u_y = t7 + 23.80952380952381 * C_y;
    const double u_y_by_q73 = t5 - 23.80952380952381 * C_y_by_q73;
    const double M_e = t4 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double u_e_by_q73 = t7 + 23.80952380952381 * C_e_by_q73;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t8 = p_y + p_y;
    const double t9 = p_y * p_y;
    const double p_z = 0.036 * cos_q71;
    const double t10 = p_z * p_z;
    const double t11 = -(1.296e-15 - t9 - t10);
    const double reach_squared_by_q73 = sinew_choose(t11, t8 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double p_x = u_e * s_e - u_y * s_y;
    const double t12 = 27.77777777777778 * p_x;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t12 * p_x_by_q73;
    const double reach_squared = sinew_max(t9 + t10, 1.296e-15);
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double reach = sinew_sqrt(reach_squared);
    const double t13 = reach - projection;
    const double t14 = sinew_choose(t13, 1.0, 0.0);
    const double t15 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t15;
    const double t16 = sinew_choose(t13, 0.0, 1.0);
    const double t17 = sinew_max(-projection, -reach);
    const double t18 = reach - t17;
    const double limited_by_q73 = sinew_choose(t18, -(reach_by_q73 * t16 - projection_by_q73 * t14),
        reach_by_q73);
    const double limited = sinew_min(t17, reach);
    const double t19 = limited + limited;
    const double t20 = reach + reach;
    const double t21 = (reach + limited) * (reach - limited);
    const double t22 = 1e-12 * reach_squared;
    const double t23 = -(t22 - t21);
    const double clearance_by_q73 = sinew_choose(t23, t20 * reach_by_q73 - t19 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double clearance = sinew_max(t21, t22);
    const double root = sinew_sqrt(clearance);
    const double t24 = 1.0 / root;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t24;
    const double t25 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t25;
    const double t26 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t26 * t25;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double sin_A = (p_y * root - p_z * limited) * t25;
    const double t27 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t27 * t25;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t28 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t29 = 0.01 * z_x_by_q73;
    const double layer_1_x_by_q73 = t28 - t29;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
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
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t36 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t37 = 0.01 * z_plane_y_by_q73;
    const double layer_1_y_by_q73 = t36 - t37;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t38 = 0.004 * u_e;
    const double t39 = origin_y + t38 * sin_A;
    const double t40 = 0.01 * z_plane_y;
    const double layer_1_y = t39 + t40;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t41 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t42 = 0.01 * z_z_by_q73;
    const double layer_1_z_by_q73 = t41 - t42;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t43 = sin_q71 * z_plane_x;
    const double t44 = cos_q71 * sin_A;
    const double z_z = t44 + t43;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t45 = sin_q71 * x_plane_x;
    const double t46 = cos_q71 * cos_A;
    const double x_z = t46 - t45;
    const double t47 = 0.004 * x_z;
    const double t48 = 0.01 * z_z;
    const double layer_1_z = 0.028 - origin_z - t47 + t48;
    const double y_z = sin_q71 * u_e;
    const double p_y_by_q71 = u_y * p_z;
    const double reach_squared_by_q71 = sinew_choose(t11, -(t8 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t15;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t12 * u_e * p_z;
    const double limited_by_q71 = sinew_choose(t18, -(reach_by_q71 * t16 - projection_by_q71 * t14),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t23, t20 * reach_by_q71 - t19 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t24;
    const double t49 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t49 - cos_A * reach_squared_by_q71) * t25;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t50 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t50 - sin_A * reach_squared_by_q71) * t25;
    const double z_x_by_q71 = t44 - cos_q71 * z_plane_x_by_q71 + t43 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t46 + cos_q71 * x_plane_x_by_q71 - t45 + sin_q71 * cos_A_by_q71;
    const double t51 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t52 = 0.01 * z_x_by_q71;
    const double layer_1_x_by_q71 = t51 - t52;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t53 = origin_y_by_q71 + t38 * sin_A_by_q71;
    const double t54 = 0.01 * z_plane_y_by_q71;
    const double layer_1_y_by_q71 = t53 + t54;
    const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t33 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t30 - cos_q71 * cos_A_by_q71 + t31 + sin_q71 * x_plane_x_by_q71;
    const double t55 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t56 = 0.01 * z_z_by_q71;
    const double layer_1_z_by_q71 = t55 - t56;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t57 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double t58 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t58);
    const double t59 = 1.0 / length_27;
    const double length_27_by_q73 = t57 * t59;
    P[55] = -length_27_by_q73;
    const double t60 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double length_27_by_q71 = t60 * t59;
    P[54] = length_27_by_q71;
    const double layer_0_x_by_q73 = t28 + t29;
    const double layer_0_x = t34 - t35;
    const double layer_0_y_by_q73 = t36 + t37;
    const double layer_0_y = t39 - t40;
    const double layer_0_z_by_q73 = t41 + t42;
    const double layer_0_z = 0.008 - origin_z - t47 - t48;
    const double layer_0_x_by_q71 = t51 + t52;
    const double layer_0_y_by_q71 = t53 - t54;
    const double layer_0_z_by_q71 = t55 + t56;
    const double strand_7_y = 0.018 - layer_0_y;
    const double t61 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t62 = 1.0 / length_7;
    const double length_7_by_q73 = t61 * t62;
    P[15] = -length_7_by_q73;
    const double t63 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7_by_q71 = t63 * t62;
    P[14] = length_7_by_q71;
    static const double table65[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    for (int i64 = 0; i64 < 11; ++i64) {
        const double t66 = table65[i64][0] * y_x;
        const double strand_x = layer_0_x - t66;
        const double t67 = table65[i64][0] * y_z;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t67;
        const double strand_y = table65[i64][1] - layer_0_y - table65[i64][0] * u_y;
        const double strand_z = layer_0_z - t67;
        const double strand_z_by_q71 = layer_0_z_by_q71 + t66;
        const double t68 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t69 = 1.0 / length;
        const double length_by_q71 = t68 * t69;
        const double strand_x_by_q73 = layer_0_x_by_q73 + table65[i64][0] * y_x_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 + table65[i64][0] * u_y_by_q73;
        const double strand_z_by_q73 = layer_0_z_by_q73 + table65[i64][0] * y_z_by_q73;
        const double t70 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t70 * t69;
        P[16 + 2 * i64] = length_by_q71;
        P[17 + 2 * i64] = -length_by_q73;
    }
    static const double table72[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    for (int i71 = 0; i71 < 10; ++i71) {
        const double t73 = table72[i71][0] * y_x;
        const double strand_x_2 = layer_1_x - t73;
        const double t74 = table72[i71][0] * y_z;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t74;
        const double strand_y_2 = table72[i71][1] - layer_1_y - table72[i71][0] * u_y;
        const double strand_z_2 = layer_1_z - t74;
        const double strand_z_by_q71_2 = layer_1_z_by_q71 + t73;
        const double t75 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_1_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t76 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t76);
        const double t77 = 1.0 / length_2;
        const double length_by_q71_2 = t75 * t77;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + table72[i71][0] * y_x_by_q73;
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table72[i71][0] * u_y_by_q73;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + table72[i71][0] * y_z_by_q73;
        const double t78 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t78 * t77;
        P[56 + 2 * i71] = length_by_q71_2;
        P[57 + 2 * i71] = -length_by_q73_2;
    }
    static const double table80[8][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017}};
    for (int i79 = 0; i79 < 8; ++i79) {
        const double t81 = table80[i79][0] * y_x;
        const double strand_x_3 = layer_1_x + t81;
        const double t82 = table80[i79][0] * y_z;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t82;
        const double strand_y_3 = table80[i79][1] - layer_1_y + table80[i79][0] * u_y;
        const double strand_z_3 = layer_1_z + t82;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t81;
        const double t83 = strand_x_3 * strand_x_by_q71_3 - strand_y_3 * layer_1_y_by_q71
            - strand_z_3 * strand_z_by_q71_3;
        const double t84 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t84);
        const double t85 = 1.0 / length_3;
        const double length_by_q71_3 = t83 * t85;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table80[i79][0] * y_x_by_q73;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table80[i79][0] * u_y_by_q73;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table80[i79][0] * y_z_by_q73;
        const double t86 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double length_by_q73_3 = t86 * t85;
        P[38 + 2 * i79] = length_by_q71_3;
        P[39 + 2 * i79] = -length_by_q73_3;
    }
    static const double table88[7][2] = {{0.011, 0.007}, {0.01, 0.008}, {0.008, 0.01},
        {0.006, 0.011}, {0.005, 0.013}, {0.003, 0.015}, {0.002, 0.016}};
    for (int i87 = 0; i87 < 7; ++i87) {
        const double t89 = table88[i87][0] * y_x;
        const double strand_x_4 = layer_0_x + t89;
        const double t90 = table88[i87][0] * y_z;
        const double strand_x_by_q71_4 = layer_0_x_by_q71 - t90;
        const double strand_y_4 = table88[i87][1] - layer_0_y + table88[i87][0] * u_y;
        const double strand_z_4 = layer_0_z + t90;
        const double strand_z_by_q71_4 = layer_0_z_by_q71 - t89;
        const double t91 = strand_x_4 * strand_x_by_q71_4 - strand_y_4 * layer_0_y_by_q71
            - strand_z_4 * strand_z_by_q71_4;
        const double t92 = strand_x_4 * strand_x_4 + strand_y_4 * strand_y_4 + strand_z_4
            * strand_z_4;
        const double length_4 = sinew_sqrt(t92);
        const double t93 = 1.0 / length_4;
        const double length_by_q71_4 = t91 * t93;
        const double strand_x_by_q73_4 = layer_0_x_by_q73 - table88[i87][0] * y_x_by_q73;
        const double strand_y_by_q73_4 = layer_0_y_by_q73 - table88[i87][0] * u_y_by_q73;
        const double strand_z_by_q73_4 = layer_0_z_by_q73 - table88[i87][0] * y_z_by_q73;
        const double t94 = strand_x_4 * strand_x_by_q73_4 - strand_y_4 * strand_y_by_q73_4
            + strand_z_4 * strand_z_by_q73_4;
        const double length_by_q73_4 = t94 * t93;
        P[2 * i87] = length_by_q71_4;
        P[1 + 2 * i87] = -length_by_q73_4;
    }
}

void wrist_tendon_hessian(double q71, double q73, double H[SINEW_AT_LEAST(152)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared_by_q73_by_q73 = 0.084 * B_y;
    const double B_to_C0_squared = 0.007324 - B_to_C0_squared_by_q73_by_q73;
    const double t2 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t3;
    const double t4 = 23.80952380952381 * B_y;
    const double u_y = t4 + 23.80952380952381 * C_y;
    const double B_e = 0.074565407529229 * sin_q73;
    const double C_e = B_e * ratio;
    const double t5 = 0.5 * B_e;
    const double M_e = t5 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double t6 = 0.5 * B_y;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double t7 = 23.80952380952381 * B_e;
    const double u_e = t7 - 23.80952380952381 * C_e;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t8 = p_y + p_y;
    const double p_z = 0.036 * cos_q71;
    const double p_y_by_q71 = u_y * p_z;
    const double t9 = p_z + p_z;
    const double t10 = p_y * p_y;
    const double t11 = p_z * p_z;
    const double t12 = -(1.296e-15 - t10 - t11);
    const double reach_squared_by_q71 = sinew_choose(t12, -(t8 * p_y_by_q71 + t9 * p_z_by_q71),
        0.0);
    const double reach_squared = sinew_max(t10 + t11, 1.296e-15);
    const double reach = sinew_sqrt(reach_squared);
    const double t13 = 1.0 / reach;
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t13;
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double t14 = reach - projection;
    const double t15 = sinew_choose(t14, 0.0, 1.0);
    const double t16 = sinew_choose(t14, 1.0, 0.0);
    const double t17 = 27.77777777777778 * p_x;
    const double p_x_by_q71 = u_e * p_z;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t17 * p_x_by_q71;
    const double t18 = sinew_max(-projection, -reach);
    const double t19 = reach - t18;
    const double limited_by_q71 = sinew_choose(t19, -(reach_by_q71 * t15 - projection_by_q71 * t16),
        reach_by_q71);
    const double limited = sinew_min(t18, reach);
    const double t20 = limited + limited;
    const double t21 = reach + reach;
    const double t22 = (reach + limited) * (reach - limited);
    const double t23 = 1e-12 * reach_squared;
    const double t24 = -(t23 - t22);
    const double clearance_by_q71 = sinew_choose(t24, t21 * reach_by_q71 - t20 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double clearance = sinew_max(t22, t23);
    const double root = sinew_sqrt(clearance);
    const double t25 = 1.0 / root;
    const double root_by_q71 = 0.5 * clearance_by_q71 * t25;
    const double t26 = root_by_q71 + root_by_q71;
    const double t27 = limited_by_q71 + limited_by_q71;
    const double t28 = reach_by_q71 * reach_by_q71;
    const double t29 = t28 + t28;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t30 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t12, t30 + t30 + t8 * p_y_by_q71_by_q71
        - t9 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t29) * t13;
    const double t31 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t31
        * p_x_by_q71 + t17 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t19, -(reach_by_q71_by_q71 * t15
        - projection_by_q71_by_q71 * t16), reach_by_q71_by_q71);
    const double t32 = t29 - t27 * limited_by_q71 + t21 * reach_by_q71_by_q71 - t20
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t24, t32, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t26 * root_by_q71) * t25;
    const double t33 = p_z * root;
    const double t34 = p_y * limited_by_q71_by_q71 - t33 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t35 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + t33) * t35;
    const double t36 = p_y_by_q71 + p_y_by_q71;
    const double t37 = p_z_by_q71 + p_z_by_q71;
    const double t38 = t34 - cos_A * reach_squared_by_q71_by_q71 - t36 * limited_by_q71 - t37
        * root_by_q71;
    const double t39 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t39 - cos_A * reach_squared_by_q71) * t35;
    const double t40 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t38 - t40 * cos_A_by_q71) * t35;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double z_plane_x = u_y * cos_A;
    const double t41 = cos_q71 * z_plane_x;
    const double t42 = p_z * limited;
    const double sin_A = (p_y * root - t42) * t35;
    const double t43 = sin_q71 * sin_A;
    const double t44 = p_y * root_by_q71_by_q71 + t42 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t45 = t44 - sin_A * reach_squared_by_q71_by_q71 - t36 * root_by_q71 + t37
        * limited_by_q71;
    const double t46 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t46 - sin_A * reach_squared_by_q71) * t35;
    const double sin_A_by_q71_by_q71 = (t45 - t40 * sin_A_by_q71) * t35;
    const double t47 = t41 - cos_q71 * z_plane_x_by_q71_by_q71 - t43 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t48 = cos_q71 + cos_q71;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t49 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t47 + t48 * sin_A_by_q71 + t49 * z_plane_x_by_q71;
    const double M_x = cos_q71 * M_e;
    const double origin_x_by_q71_by_q71 = M_x - 0.018 * z_x_by_q71_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double x_plane_x = u_y * sin_A;
    const double t50 = cos_q71 * x_plane_x;
    const double t51 = sin_q71 * cos_A;
    const double t52 = t50 - cos_q71 * x_plane_x_by_q71_by_q71 + t51 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71_by_q71 = t52 - t48 * cos_A_by_q71 + t49 * x_plane_x_by_q71;
    const double t53 = origin_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t54 = 0.01 * z_x_by_q71_by_q71;
    const double layer_0_x_by_q71_by_q71 = t53 + t54;
    const double y_x = cos_q71 * u_e;
    const double t55 = 0.011 * y_x;
    const double strand_0_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t55;
    const double x_x = t50 + t51;
    const double z_x = t41 - t43;
    const double t56 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t57 = 0.01 * z_x;
    const double layer_0_x = t56 - t57;
    const double strand_0_x = layer_0_x + t55;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t58 = 0.004 * u_e;
    const double t59 = origin_y_by_q71_by_q71 + t58 * sin_A_by_q71_by_q71;
    const double t60 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t59 - t60;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t61 = origin_y + t58 * sin_A;
    const double t62 = 0.01 * z_plane_y;
    const double layer_0_y = t61 - t62;
    const double strand_0_y = 0.007 - layer_0_y + 0.011 * u_y;
    const double t63 = strand_0_x * strand_0_x_by_q71_by_q71 - strand_0_y * layer_0_y_by_q71_by_q71;
    const double t64 = cos_q71 * sin_A;
    const double t65 = sin_q71 * z_plane_x;
    const double t66 = t64 - cos_q71 * sin_A_by_q71_by_q71 + t65 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t66 - t48 * z_plane_x_by_q71 + t49 * sin_A_by_q71;
    const double M_z = sin_q71 * M_e;
    const double origin_z_by_q71_by_q71 = M_z - 0.018 * z_z_by_q71_by_q71;
    const double t67 = cos_q71 * cos_A;
    const double t68 = sin_q71 * x_plane_x;
    const double t69 = t67 - cos_q71 * cos_A_by_q71_by_q71 - t68 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t69 + t48 * x_plane_x_by_q71 + t49 * cos_A_by_q71;
    const double t70 = origin_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t71 = 0.01 * z_z_by_q71_by_q71;
    const double layer_0_z_by_q71_by_q71 = t70 + t71;
    const double y_z = sin_q71 * u_e;
    const double t72 = 0.011 * y_z;
    const double strand_0_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t72;
    const double z_z = t64 + t65;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t67 - t68;
    const double t73 = 0.004 * x_z;
    const double t74 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t73 - t74;
    const double strand_0_z = layer_0_z + t72;
    const double z_x_by_q71 = t64 - cos_q71 * z_plane_x_by_q71 + t65 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_x_by_q71 = t67 + cos_q71 * x_plane_x_by_q71 - t68 + sin_q71 * cos_A_by_q71;
    const double t75 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t76 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t75 + t76;
    const double strand_0_x_by_q71 = layer_0_x_by_q71 - t72;
    const double t77 = t63 + strand_0_z * strand_0_z_by_q71_by_q71 + strand_0_x_by_q71
        * strand_0_x_by_q71;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t78 = origin_y_by_q71 + t58 * sin_A_by_q71;
    const double t79 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t78 - t79;
    const double t80 = layer_0_y_by_q71 * layer_0_y_by_q71;
    const double z_z_by_q71 = t41 + cos_q71 * sin_A_by_q71 - t43 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t50 - cos_q71 * cos_A_by_q71 + t51 + sin_q71 * x_plane_x_by_q71;
    const double t81 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t82 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t81 + t82;
    const double strand_0_z_by_q71 = layer_0_z_by_q71 - t55;
    const double t83 = strand_0_x * strand_0_x_by_q71 - strand_0_y * layer_0_y_by_q71 - strand_0_z
        * strand_0_z_by_q71;
    const double t84 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z * strand_0_z;
    const double length_0 = sinew_sqrt(t84);
    const double t85 = 1.0 / length_0;
    const double length_0_by_q71 = t83 * t85;
    const double t86 = t77 + t80 + strand_0_z_by_q71 * strand_0_z_by_q71 - length_0_by_q71
        * length_0_by_q71;
    const double length_0_by_q71_by_q71 = t86 * t85;
    H[0] = length_0_by_q71_by_q71;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t87 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t87;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    const double u_e_by_q73 = t4 + 23.80952380952381 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double reach_squared_by_q73 = sinew_choose(t12, t8 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t17 * p_x_by_q73;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t13;
    const double limited_by_q73 = sinew_choose(t19, -(reach_by_q73 * t15 - projection_by_q73 * t16),
        reach_by_q73);
    const double clearance_by_q73 = sinew_choose(t24, t21 * reach_by_q73 - t20 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double root_by_q73 = 0.5 * clearance_by_q73 * t25;
    const double t88 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t12, t8 * p_y_by_q71_by_q73 - t36
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t88) * t13;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t17
        * p_z * u_e_by_q73 - t31 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t19, -(reach_by_q71_by_q73 * t15
        - projection_by_q71_by_q73 * t16), reach_by_q71_by_q73);
    const double t89 = t21 * reach_by_q71_by_q73 - t20 * limited_by_q71_by_q73 + t88 - t27
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t24, t89, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t26 * root_by_q73) * t25;
    const double t90 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t91 = t90 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t92 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t92 * t35;
    const double t93 = t91 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t93 * t35;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t94 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t94 * t35;
    const double t95 = cos_q71 * sin_A_by_q73;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t96 = sin_q71 * z_plane_x_by_q73;
    const double t97 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t98 = t97 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t99 = t98 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t99 * t35;
    const double z_x_by_q71_by_q73 = t95 - cos_q71 * z_plane_x_by_q71_by_q73 + t96 + sin_q71
        * sin_A_by_q71_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_x_by_q71_by_q73 = M_z_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double t100 = cos_q71 * cos_A_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t101 = sin_q71 * x_plane_x_by_q73;
    const double x_x_by_q71_by_q73 = t100 + cos_q71 * x_plane_x_by_q71_by_q73 - t101 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t102 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t103 = 0.01 * z_x_by_q71_by_q73;
    const double layer_0_x_by_q71_by_q73 = t102 + t103;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t104 = 0.011 * y_z_by_q73;
    const double strand_0_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t104;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t105 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t106 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t105 - t106;
    const double t107 = strand_0_x * strand_0_x_by_q71_by_q73 - strand_0_y
        * layer_0_y_by_q71_by_q73;
    const double t108 = cos_q71 * z_plane_x_by_q73;
    const double t109 = sin_q71 * sin_A_by_q73;
    const double z_z_by_q71_by_q73 = t108 + cos_q71 * sin_A_by_q71_by_q73 - t109 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_z_by_q71_by_q73 = M_x_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double t110 = cos_q71 * x_plane_x_by_q73;
    const double t111 = sin_q71 * cos_A_by_q73;
    const double x_z_by_q71_by_q73 = t110 - cos_q71 * cos_A_by_q71_by_q73 + t111 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t112 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t113 = 0.01 * z_z_by_q71_by_q73;
    const double layer_0_z_by_q71_by_q73 = t112 + t113;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double t114 = 0.011 * y_x_by_q73;
    const double strand_0_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t114;
    const double z_x_by_q73 = t108 - t109;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_x_by_q73 = t110 + t111;
    const double t115 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t116 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t115 + t116;
    const double strand_0_x_by_q73 = layer_0_x_by_q73 - t114;
    const double t117 = t107 - strand_0_z * strand_0_z_by_q71_by_q73 - strand_0_x_by_q71
        * strand_0_x_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t118 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t119 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t118 + t119;
    const double strand_0_y_by_q73 = layer_0_y_by_q73 - 0.011 * u_y_by_q73;
    const double z_z_by_q73 = t95 + t96;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = t100 - t101;
    const double t120 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t121 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t120 + t121;
    const double strand_0_z_by_q73 = layer_0_z_by_q73 - t104;
    const double t122 = t117 - layer_0_y_by_q71 * strand_0_y_by_q73 + strand_0_z_by_q71
        * strand_0_z_by_q73;
    const double t123 = strand_0_x * strand_0_x_by_q73 - strand_0_y * strand_0_y_by_q73 + strand_0_z
        * strand_0_z_by_q73;
    const double length_0_by_q73 = t123 * t85;
    const double length_0_by_q71_by_q73 = (t122 + length_0_by_q71 * length_0_by_q73) * t85;
    H[1] = length_0_by_q71_by_q73;
    H[2] = length_0_by_q71_by_q73;
    const double t124 = reach_by_q73 * reach_by_q73;
    const double t125 = t124 + t124;
    const double t126 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t126 * t2;
    const double C_y_by_q73_by_q73 = t87 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t127 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t128 = u_e_by_q73 + u_e_by_q73;
    const double t129 = u_y_by_q73 + u_y_by_q73;
    const double p_y_by_q73_by_q73 = t127 - s_y * u_e_by_q73_by_q73 + t128 * M_y_by_q73 - t129
        * M_e_by_q73;
    const double t130 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t12, t130 * p_y_by_q73 + t8
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t125) * t13;
    const double t131 = t125 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t21
        * reach_by_q73_by_q73;
    const double t132 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t133 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t133 - s_y * u_y_by_q73_by_q73 - t128 * M_e_by_q73 - t129
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t132 - t17 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t19, -(reach_by_q73_by_q73 * t15
        - projection_by_q73_by_q73 * t16), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t24, t131 - t20 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t134 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t134 * t25;
    const double t135 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t136 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t137 = t135 - sin_A * reach_squared_by_q73_by_q73 + t130 * root_by_q73 - t136
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t137 * t35;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t129 * sin_A_by_q73;
    const double t138 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t139 = t138 - cos_A * reach_squared_by_q73_by_q73 + t130 * limited_by_q73 - t136
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t139 * t35;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t129 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t140 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t141 = 0.01 * z_x_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t140 - t141;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double strand_0_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - 0.011 * y_x_by_q73_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t128 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t128 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t142 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t143 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t142 + t143;
    const double strand_0_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - 0.011 * u_y_by_q73_by_q73;
    const double t144 = strand_0_x * strand_0_x_by_q73_by_q73 + strand_0_y
        * strand_0_y_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t145 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t146 = 0.01 * z_z_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t145 - t146;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double strand_0_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - 0.011 * y_z_by_q73_by_q73;
    const double t147 = t144 + strand_0_z * strand_0_z_by_q73_by_q73 + strand_0_x_by_q73
        * strand_0_x_by_q73;
    const double t148 = t147 + strand_0_y_by_q73 * strand_0_y_by_q73 + strand_0_z_by_q73
        * strand_0_z_by_q73;
    const double length_0_by_q73_by_q73 = (t148 - length_0_by_q73 * length_0_by_q73) * t85;
    H[3] = length_0_by_q73_by_q73;
    const double t149 = 0.002 * y_x;
    const double strand_6_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t149;
    const double strand_6_x = layer_0_x + t149;
    const double t150 = 0.002 * u_y;
    const double strand_6_y = 0.016 - layer_0_y + t150;
    const double t151 = strand_6_x * strand_6_x_by_q71_by_q71 - strand_6_y
        * layer_0_y_by_q71_by_q71;
    const double t152 = 0.002 * y_z;
    const double strand_6_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t152;
    const double strand_6_z = layer_0_z + t152;
    const double strand_6_x_by_q71 = layer_0_x_by_q71 - t152;
    const double t153 = t151 + strand_6_z * strand_6_z_by_q71_by_q71 + t80 + strand_6_x_by_q71
        * strand_6_x_by_q71;
    const double strand_6_z_by_q71 = layer_0_z_by_q71 - t149;
    const double t154 = strand_6_x * strand_6_x_by_q71 - strand_6_y * layer_0_y_by_q71 - strand_6_z
        * strand_6_z_by_q71;
    const double t155 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z * strand_6_z;
    const double length_6 = sinew_sqrt(t155);
    const double t156 = 1.0 / length_6;
    const double length_6_by_q71 = t154 * t156;
    const double t157 = t153 + strand_6_z_by_q71 * strand_6_z_by_q71 - length_6_by_q71
        * length_6_by_q71;
    const double length_6_by_q71_by_q71 = t157 * t156;
    H[24] = length_6_by_q71_by_q71;
    const double t158 = 0.002 * y_z_by_q73;
    const double strand_6_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t158;
    const double t159 = strand_6_x * strand_6_x_by_q71_by_q73 - strand_6_y
        * layer_0_y_by_q71_by_q73;
    const double t160 = 0.002 * y_x_by_q73;
    const double strand_6_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t160;
    const double t161 = 0.002 * u_y_by_q73;
    const double strand_6_y_by_q73 = layer_0_y_by_q73 - t161;
    const double t162 = t159 - strand_6_z * strand_6_z_by_q71_by_q73 - layer_0_y_by_q71
        * strand_6_y_by_q73;
    const double strand_6_x_by_q73 = layer_0_x_by_q73 - t160;
    const double strand_6_z_by_q73 = layer_0_z_by_q73 - t158;
    const double t163 = t162 - strand_6_x_by_q71 * strand_6_x_by_q73 + strand_6_z_by_q71
        * strand_6_z_by_q73;
    const double t164 = strand_6_x * strand_6_x_by_q73 - strand_6_y * strand_6_y_by_q73 + strand_6_z
        * strand_6_z_by_q73;
    const double length_6_by_q73 = t164 * t156;
    const double length_6_by_q71_by_q73 = (t163 + length_6_by_q71 * length_6_by_q73) * t156;
    H[25] = length_6_by_q71_by_q73;
    H[26] = length_6_by_q71_by_q73;
    const double t165 = 0.002 * y_x_by_q73_by_q73;
    const double strand_6_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - t165;
    const double t166 = 0.002 * u_y_by_q73_by_q73;
    const double strand_6_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - t166;
    const double t167 = strand_6_x * strand_6_x_by_q73_by_q73 + strand_6_y
        * strand_6_y_by_q73_by_q73;
    const double t168 = 0.002 * y_z_by_q73_by_q73;
    const double strand_6_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - t168;
    const double t169 = t167 + strand_6_z * strand_6_z_by_q73_by_q73 + strand_6_x_by_q73
        * strand_6_x_by_q73;
    const double t170 = t169 + strand_6_y_by_q73 * strand_6_y_by_q73 + strand_6_z_by_q73
        * strand_6_z_by_q73;
    const double length_6_by_q73_by_q73 = (t170 - length_6_by_q73 * length_6_by_q73) * t156;
    H[27] = length_6_by_q73_by_q73;
    const double t171 = layer_0_x * layer_0_x_by_q71_by_q71 + layer_0_z * layer_0_z_by_q71_by_q71;
    const double strand_7_y = 0.018 - layer_0_y;
    const double t172 = t171 - strand_7_y * layer_0_y_by_q71_by_q71 + layer_0_x_by_q71
        * layer_0_x_by_q71;
    const double t173 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t174 = 1.0 / length_7;
    const double length_7_by_q71 = t173 * t174;
    const double t175 = t172 + t80 + layer_0_z_by_q71 * layer_0_z_by_q71 - length_7_by_q71
        * length_7_by_q71;
    const double length_7_by_q71_by_q71 = t175 * t174;
    H[28] = length_7_by_q71_by_q71;
    const double t176 = layer_0_x * layer_0_x_by_q71_by_q73 - layer_0_z * layer_0_z_by_q71_by_q73;
    const double t177 = t176 - strand_7_y * layer_0_y_by_q71_by_q73 - layer_0_x_by_q71
        * layer_0_x_by_q73;
    const double t178 = t177 - layer_0_y_by_q71 * layer_0_y_by_q73 + layer_0_z_by_q71
        * layer_0_z_by_q73;
    const double t179 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7_by_q73 = t179 * t174;
    const double length_7_by_q71_by_q73 = (t178 + length_7_by_q71 * length_7_by_q73) * t174;
    H[29] = length_7_by_q71_by_q73;
    H[30] = length_7_by_q71_by_q73;
    const double t180 = layer_0_x * layer_0_x_by_q73_by_q73 + layer_0_z * layer_0_z_by_q73_by_q73;
    const double t181 = t180 + strand_7_y * layer_0_y_by_q73_by_q73 + layer_0_x_by_q73
        * layer_0_x_by_q73;
    const double t182 = t181 + layer_0_y_by_q73 * layer_0_y_by_q73 + layer_0_z_by_q73
        * layer_0_z_by_q73;
    const double length_7_by_q73_by_q73 = (t182 - length_7_by_q73 * length_7_by_q73) * t174;
    H[31] = length_7_by_q73_by_q73;
    const double t183 = 0.013 * y_x;
    const double t184 = 0.013 * y_z;
    const double t185 = 0.013 * y_z_by_q73;
    const double t186 = 0.013 * y_x_by_q73;
    const double layer_1_x_by_q71_by_q71 = t53 - t54;
    const double strand_19_x_by_q71_by_q71 = layer_1_x_by_q71_by_q71 - t183;
    const double layer_1_x = t56 + t57;
    const double strand_19_x = layer_1_x + t183;
    const double layer_1_y_by_q71_by_q71 = t59 + t60;
    const double layer_1_y = t61 + t62;
    const double strand_19_y = 0.006 - layer_1_y + 0.013 * u_y;
    const double t187 = strand_19_x * strand_19_x_by_q71_by_q71 - strand_19_y
        * layer_1_y_by_q71_by_q71;
    const double layer_1_z_by_q71_by_q71 = t70 - t71;
    const double strand_19_z_by_q71_by_q71 = layer_1_z_by_q71_by_q71 - t184;
    const double layer_1_z = 0.028 - origin_z - t73 + t74;
    const double strand_19_z = layer_1_z + t184;
    const double layer_1_x_by_q71 = t75 - t76;
    const double strand_19_x_by_q71 = layer_1_x_by_q71 - t184;
    const double t188 = t187 + strand_19_z * strand_19_z_by_q71_by_q71 + strand_19_x_by_q71
        * strand_19_x_by_q71;
    const double layer_1_y_by_q71 = t78 + t79;
    const double t189 = layer_1_y_by_q71 * layer_1_y_by_q71;
    const double layer_1_z_by_q71 = t81 - t82;
    const double strand_19_z_by_q71 = layer_1_z_by_q71 - t183;
    const double t190 = strand_19_x * strand_19_x_by_q71 - strand_19_y * layer_1_y_by_q71
        - strand_19_z * strand_19_z_by_q71;
    const double t191 = strand_19_x * strand_19_x + strand_19_y * strand_19_y + strand_19_z
        * strand_19_z;
    const double length_19 = sinew_sqrt(t191);
    const double t192 = 1.0 / length_19;
    const double length_19_by_q71 = t190 * t192;
    const double t193 = t188 + t189 + strand_19_z_by_q71 * strand_19_z_by_q71 - length_19_by_q71
        * length_19_by_q71;
    const double length_19_by_q71_by_q71 = t193 * t192;
    H[76] = length_19_by_q71_by_q71;
    const double layer_1_x_by_q71_by_q73 = t102 - t103;
    const double strand_19_x_by_q71_by_q73 = layer_1_x_by_q71_by_q73 - t185;
    const double layer_1_y_by_q71_by_q73 = t105 + t106;
    const double t194 = strand_19_x * strand_19_x_by_q71_by_q73 - strand_19_y
        * layer_1_y_by_q71_by_q73;
    const double layer_1_z_by_q71_by_q73 = t112 - t113;
    const double strand_19_z_by_q71_by_q73 = layer_1_z_by_q71_by_q73 - t186;
    const double layer_1_x_by_q73 = t115 - t116;
    const double strand_19_x_by_q73 = layer_1_x_by_q73 - t186;
    const double t195 = t194 - strand_19_z * strand_19_z_by_q71_by_q73 - strand_19_x_by_q71
        * strand_19_x_by_q73;
    const double layer_1_y_by_q73 = t118 - t119;
    const double strand_19_y_by_q73 = layer_1_y_by_q73 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t120 - t121;
    const double strand_19_z_by_q73 = layer_1_z_by_q73 - t185;
    const double t196 = t195 - layer_1_y_by_q71 * strand_19_y_by_q73 + strand_19_z_by_q71
        * strand_19_z_by_q73;
    const double t197 = strand_19_x * strand_19_x_by_q73 - strand_19_y * strand_19_y_by_q73
        + strand_19_z * strand_19_z_by_q73;
    const double length_19_by_q73 = t197 * t192;
    const double length_19_by_q71_by_q73 = (t196 + length_19_by_q71 * length_19_by_q73) * t192;
    H[77] = length_19_by_q71_by_q73;
    H[78] = length_19_by_q71_by_q73;
    const double layer_1_x_by_q73_by_q73 = t140 + t141;
    const double strand_19_x_by_q73_by_q73 = layer_1_x_by_q73_by_q73 - 0.013 * y_x_by_q73_by_q73;
    const double layer_1_y_by_q73_by_q73 = t142 - t143;
    const double strand_19_y_by_q73_by_q73 = layer_1_y_by_q73_by_q73 - 0.013 * u_y_by_q73_by_q73;
    const double t198 = strand_19_x * strand_19_x_by_q73_by_q73 + strand_19_y
        * strand_19_y_by_q73_by_q73;
    const double layer_1_z_by_q73_by_q73 = t145 + t146;
    const double strand_19_z_by_q73_by_q73 = layer_1_z_by_q73_by_q73 - 0.013 * y_z_by_q73_by_q73;
    const double t199 = t198 + strand_19_z * strand_19_z_by_q73_by_q73 + strand_19_x_by_q73
        * strand_19_x_by_q73;
    const double t200 = t199 + strand_19_y_by_q73 * strand_19_y_by_q73 + strand_19_z_by_q73
        * strand_19_z_by_q73;
    const double length_19_by_q73_by_q73 = (t200 - length_19_by_q73 * length_19_by_q73) * t192;
    H[79] = length_19_by_q73_by_q73;
    const double strand_26_x_by_q71_by_q71 = layer_1_x_by_q71_by_q71 - t149;
    const double strand_26_x = layer_1_x + t149;
    const double strand_26_y = 0.017 - layer_1_y + t150;
    const double t201 = strand_26_x * strand_26_x_by_q71_by_q71 - strand_26_y
        * layer_1_y_by_q71_by_q71;
    const double strand_26_z_by_q71_by_q71 = layer_1_z_by_q71_by_q71 - t152;
    const double strand_26_z = layer_1_z + t152;
    const double strand_26_x_by_q71 = layer_1_x_by_q71 - t152;
    const double t202 = t201 + strand_26_z * strand_26_z_by_q71_by_q71 + t189 + strand_26_x_by_q71
        * strand_26_x_by_q71;
    const double strand_26_z_by_q71 = layer_1_z_by_q71 - t149;
    const double t203 = strand_26_x * strand_26_x_by_q71 - strand_26_y * layer_1_y_by_q71
        - strand_26_z * strand_26_z_by_q71;
    const double t204 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
        * strand_26_z;
    const double length_26 = sinew_sqrt(t204);
    const double t205 = 1.0 / length_26;
    const double length_26_by_q71 = t203 * t205;
    const double t206 = t202 + strand_26_z_by_q71 * strand_26_z_by_q71 - length_26_by_q71
        * length_26_by_q71;
    const double length_26_by_q71_by_q71 = t206 * t205;
    H[104] = length_26_by_q71_by_q71;
    const double strand_26_x_by_q71_by_q73 = layer_1_x_by_q71_by_q73 - t158;
    const double t207 = strand_26_x * strand_26_x_by_q71_by_q73 - strand_26_y
        * layer_1_y_by_q71_by_q73;
    const double strand_26_z_by_q71_by_q73 = layer_1_z_by_q71_by_q73 - t160;
    const double strand_26_y_by_q73 = layer_1_y_by_q73 - t161;
    const double t208 = t207 - strand_26_z * strand_26_z_by_q71_by_q73 - layer_1_y_by_q71
        * strand_26_y_by_q73;
    const double strand_26_x_by_q73 = layer_1_x_by_q73 - t160;
    const double strand_26_z_by_q73 = layer_1_z_by_q73 - t158;
    const double t209 = t208 - strand_26_x_by_q71 * strand_26_x_by_q73 + strand_26_z_by_q71
        * strand_26_z_by_q73;
    const double t210 = strand_26_x * strand_26_x_by_q73 - strand_26_y * strand_26_y_by_q73
        + strand_26_z * strand_26_z_by_q73;
    const double length_26_by_q73 = t210 * t205;
    const double length_26_by_q71_by_q73 = (t209 + length_26_by_q71 * length_26_by_q73) * t205;
    H[105] = length_26_by_q71_by_q73;
    H[106] = length_26_by_q71_by_q73;
    const double strand_26_x_by_q73_by_q73 = layer_1_x_by_q73_by_q73 - t165;
    const double strand_26_y_by_q73_by_q73 = layer_1_y_by_q73_by_q73 - t166;
    const double t211 = strand_26_x * strand_26_x_by_q73_by_q73 + strand_26_y
        * strand_26_y_by_q73_by_q73;
    const double strand_26_z_by_q73_by_q73 = layer_1_z_by_q73_by_q73 - t168;
    const double t212 = t211 + strand_26_z * strand_26_z_by_q73_by_q73 + strand_26_x_by_q73
        * strand_26_x_by_q73;
    const double t213 = t212 + strand_26_y_by_q73 * strand_26_y_by_q73 + strand_26_z_by_q73
        * strand_26_z_by_q73;
    const double length_26_by_q73_by_q73 = (t213 - length_26_by_q73 * length_26_by_q73) * t205;
    H[107] = length_26_by_q73_by_q73;
    const double t214 = layer_1_x * layer_1_x_by_q71_by_q71 + layer_1_z * layer_1_z_by_q71_by_q71;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t215 = t214 - strand_27_y * layer_1_y_by_q71_by_q71 + layer_1_x_by_q71
        * layer_1_x_by_q71;
    const double t216 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double t217 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t217);
    const double t218 = 1.0 / length_27;
    const double length_27_by_q71 = t216 * t218;
    const double t219 = t215 + t189 + layer_1_z_by_q71 * layer_1_z_by_q71 - length_27_by_q71
        * length_27_by_q71;
    const double length_27_by_q71_by_q71 = t219 * t218;
    H[108] = length_27_by_q71_by_q71;
    const double t220 = layer_1_x * layer_1_x_by_q71_by_q73 - layer_1_z * layer_1_z_by_q71_by_q73;
    const double t221 = t220 - strand_27_y * layer_1_y_by_q71_by_q73 - layer_1_x_by_q71
        * layer_1_x_by_q73;
    const double t222 = t221 - layer_1_y_by_q71 * layer_1_y_by_q73 + layer_1_z_by_q71
        * layer_1_z_by_q73;
    const double t223 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double length_27_by_q73 = t223 * t218;
    const double length_27_by_q71_by_q73 = (t222 + length_27_by_q71 * length_27_by_q73) * t218;
    H[109] = length_27_by_q71_by_q73;
    H[110] = length_27_by_q71_by_q73;
    const double t224 = layer_1_x * layer_1_x_by_q73_by_q73 + layer_1_z * layer_1_z_by_q73_by_q73;
    const double t225 = t224 + strand_27_y * layer_1_y_by_q73_by_q73 + layer_1_x_by_q73
        * layer_1_x_by_q73;
    const double t226 = t225 + layer_1_y_by_q73 * layer_1_y_by_q73 + layer_1_z_by_q73
        * layer_1_z_by_q73;
    const double length_27_by_q73_by_q73 = (t226 - length_27_by_q73 * length_27_by_q73) * t218;
    H[111] = length_27_by_q73_by_q73;
    static const double table228[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    for (int i227 = 0; i227 < 11; ++i227) {
        const double t229 = table228[i227][0] * y_x;
        const double strand_x = layer_0_x - t229;
        const double strand_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 + t229;
        const double strand_y = table228[i227][1] - layer_0_y - table228[i227][0] * u_y;
        const double t230 = table228[i227][0] * y_z;
        const double strand_z = layer_0_z - t230;
        const double strand_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 + t230;
        const double t231 = strand_x * strand_x_by_q71_by_q71 - strand_y * layer_0_y_by_q71_by_q71
            + strand_z * strand_z_by_q71_by_q71;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t230;
        const double strand_z_by_q71 = layer_0_z_by_q71 + t229;
        const double t232 = t231 + t80 + strand_x_by_q71 * strand_x_by_q71 + strand_z_by_q71
            * strand_z_by_q71;
        const double t233 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t234 = 1.0 / length;
        const double length_by_q71 = t233 * t234;
        const double length_by_q71_by_q71 = (t232 - length_by_q71 * length_by_q71) * t234;
        const double t235 = table228[i227][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 + t235;
        const double t236 = table228[i227][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 + t236;
        const double t237 = strand_x * strand_x_by_q71_by_q73 - strand_y * layer_0_y_by_q71_by_q73
            - strand_z * strand_z_by_q71_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 + table228[i227][0] * u_y_by_q73;
        const double strand_x_by_q73 = layer_0_x_by_q73 + t236;
        const double t238 = t237 - layer_0_y_by_q71 * strand_y_by_q73 - strand_x_by_q71
            * strand_x_by_q73;
        const double strand_z_by_q73 = layer_0_z_by_q73 + t235;
        const double t239 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t239 * t234;
        const double length_by_q71_by_q73 = (t238 + strand_z_by_q71 * strand_z_by_q73
            + length_by_q71 * length_by_q73) * t234;
        const double strand_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 + table228[i227][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 + table228[i227][0]
            * u_y_by_q73_by_q73;
        const double strand_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 + table228[i227][0]
            * y_z_by_q73_by_q73;
        const double t240 = strand_x * strand_x_by_q73_by_q73 + strand_y * strand_y_by_q73_by_q73
            + strand_z * strand_z_by_q73_by_q73;
        const double t241 = t240 + strand_x_by_q73 * strand_x_by_q73 + strand_y_by_q73
            * strand_y_by_q73;
        const double length_by_q73_by_q73 = (t241 + strand_z_by_q73 * strand_z_by_q73
            - length_by_q73 * length_by_q73) * t234;
        H[32 + 4 * i227] = length_by_q71_by_q71;
        H[33 + 4 * i227] = length_by_q71_by_q73;
        H[34 + 4 * i227] = length_by_q71_by_q73;
        H[35 + 4 * i227] = length_by_q73_by_q73;
    }
    static const double table243[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    for (int i242 = 0; i242 < 10; ++i242) {
        const double t244 = table243[i242][0] * y_x;
        const double strand_x_2 = layer_1_x - t244;
        const double strand_x_by_q71_by_q71_2 = layer_1_x_by_q71_by_q71 + t244;
        const double strand_y_2 = table243[i242][1] - layer_1_y - table243[i242][0] * u_y;
        const double t245 = strand_x_2 * strand_x_by_q71_by_q71_2 - strand_y_2
            * layer_1_y_by_q71_by_q71;
        const double t246 = table243[i242][0] * y_z;
        const double strand_z_2 = layer_1_z - t246;
        const double strand_z_by_q71_by_q71_2 = layer_1_z_by_q71_by_q71 + t246;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t246;
        const double t247 = t245 + strand_z_2 * strand_z_by_q71_by_q71_2 + t189 + strand_x_by_q71_2
            * strand_x_by_q71_2;
        const double strand_z_by_q71_2 = layer_1_z_by_q71 + t244;
        const double t248 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_1_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t249 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t249);
        const double t250 = 1.0 / length_2;
        const double length_by_q71_2 = t248 * t250;
        const double t251 = t247 + strand_z_by_q71_2 * strand_z_by_q71_2 - length_by_q71_2
            * length_by_q71_2;
        const double length_by_q71_by_q71_2 = t251 * t250;
        const double t252 = table243[i242][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_2 = layer_1_x_by_q71_by_q73 + t252;
        const double t253 = strand_x_2 * strand_x_by_q71_by_q73_2 - strand_y_2
            * layer_1_y_by_q71_by_q73;
        const double t254 = table243[i242][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_2 = layer_1_z_by_q71_by_q73 + t254;
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table243[i242][0] * u_y_by_q73;
        const double t255 = t253 - strand_z_2 * strand_z_by_q71_by_q73_2 - layer_1_y_by_q71
            * strand_y_by_q73_2;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + t254;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + t252;
        const double t256 = t255 - strand_x_by_q71_2 * strand_x_by_q73_2 + strand_z_by_q71_2
            * strand_z_by_q73_2;
        const double t257 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t257 * t250;
        const double length_by_q71_by_q73_2 = (t256 + length_by_q71_2 * length_by_q73_2) * t250;
        const double strand_x_by_q73_by_q73_2 = layer_1_x_by_q73_by_q73 + table243[i242][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_2 = layer_1_y_by_q73_by_q73 + table243[i242][0]
            * u_y_by_q73_by_q73;
        const double t258 = strand_x_2 * strand_x_by_q73_by_q73_2 + strand_y_2
            * strand_y_by_q73_by_q73_2;
        const double strand_z_by_q73_by_q73_2 = layer_1_z_by_q73_by_q73 + table243[i242][0]
            * y_z_by_q73_by_q73;
        const double t259 = t258 + strand_z_2 * strand_z_by_q73_by_q73_2 + strand_x_by_q73_2
            * strand_x_by_q73_2;
        const double t260 = t259 + strand_y_by_q73_2 * strand_y_by_q73_2 + strand_z_by_q73_2
            * strand_z_by_q73_2;
        const double length_by_q73_by_q73_2 = (t260 - length_by_q73_2 * length_by_q73_2) * t250;
        H[112 + 4 * i242] = length_by_q71_by_q71_2;
        H[113 + 4 * i242] = length_by_q71_by_q73_2;
        H[114 + 4 * i242] = length_by_q71_by_q73_2;
        H[115 + 4 * i242] = length_by_q73_by_q73_2;
    }
    static const double table262[6][2] = {{0.011, 0.007}, {0.01, 0.009}, {0.008, 0.011},
        {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}};
    for (int i261 = 0; i261 < 6; ++i261) {
        const double t263 = table262[i261][0] * y_x;
        const double strand_x_3 = layer_1_x + t263;
        const double strand_x_by_q71_by_q71_3 = layer_1_x_by_q71_by_q71 - t263;
        const double strand_y_3 = table262[i261][1] - layer_1_y + table262[i261][0] * u_y;
        const double t264 = strand_x_3 * strand_x_by_q71_by_q71_3 - strand_y_3
            * layer_1_y_by_q71_by_q71;
        const double t265 = table262[i261][0] * y_z;
        const double strand_z_3 = layer_1_z + t265;
        const double strand_z_by_q71_by_q71_3 = layer_1_z_by_q71_by_q71 - t265;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t265;
        const double t266 = t264 + strand_z_3 * strand_z_by_q71_by_q71_3 + t189 + strand_x_by_q71_3
            * strand_x_by_q71_3;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t263;
        const double t267 = strand_x_3 * strand_x_by_q71_3 - strand_y_3 * layer_1_y_by_q71
            - strand_z_3 * strand_z_by_q71_3;
        const double t268 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t268);
        const double t269 = 1.0 / length_3;
        const double length_by_q71_3 = t267 * t269;
        const double t270 = t266 + strand_z_by_q71_3 * strand_z_by_q71_3 - length_by_q71_3
            * length_by_q71_3;
        const double length_by_q71_by_q71_3 = t270 * t269;
        const double t271 = table262[i261][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_3 = layer_1_x_by_q71_by_q73 - t271;
        const double t272 = strand_x_3 * strand_x_by_q71_by_q73_3 - strand_y_3
            * layer_1_y_by_q71_by_q73;
        const double t273 = table262[i261][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_3 = layer_1_z_by_q71_by_q73 - t273;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table262[i261][0] * u_y_by_q73;
        const double t274 = t272 - strand_z_3 * strand_z_by_q71_by_q73_3 - layer_1_y_by_q71
            * strand_y_by_q73_3;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - t273;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - t271;
        const double t275 = t274 - strand_x_by_q71_3 * strand_x_by_q73_3 + strand_z_by_q71_3
            * strand_z_by_q73_3;
        const double t276 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double length_by_q73_3 = t276 * t269;
        const double length_by_q71_by_q73_3 = (t275 + length_by_q71_3 * length_by_q73_3) * t269;
        const double strand_x_by_q73_by_q73_3 = layer_1_x_by_q73_by_q73 - table262[i261][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_3 = layer_1_y_by_q73_by_q73 - table262[i261][0]
            * u_y_by_q73_by_q73;
        const double t277 = strand_x_3 * strand_x_by_q73_by_q73_3 + strand_y_3
            * strand_y_by_q73_by_q73_3;
        const double strand_z_by_q73_by_q73_3 = layer_1_z_by_q73_by_q73 - table262[i261][0]
            * y_z_by_q73_by_q73;
        const double t278 = t277 + strand_z_3 * strand_z_by_q73_by_q73_3 + strand_x_by_q73_3
            * strand_x_by_q73_3;
        const double t279 = t278 + strand_y_by_q73_3 * strand_y_by_q73_3 + strand_z_by_q73_3
            * strand_z_by_q73_3;
        const double length_by_q73_by_q73_3 = (t279 - length_by_q73_3 * length_by_q73_3) * t269;
        H[80 + 4 * i261] = length_by_q71_by_q71_3;
        H[81 + 4 * i261] = length_by_q71_by_q73_3;
        H[82 + 4 * i261] = length_by_q71_by_q73_3;
        H[83 + 4 * i261] = length_by_q73_by_q73_3;
    }
    static const double table281[5][2] = {{0.01, 0.008}, {0.008, 0.01}, {0.006, 0.011},
        {0.005, 0.013}, {0.003, 0.015}};
    for (int i280 = 0; i280 < 5; ++i280) {
        const double t282 = table281[i280][0] * y_x;
        const double strand_x_4 = layer_0_x + t282;
        const double strand_x_by_q71_by_q71_4 = layer_0_x_by_q71_by_q71 - t282;
        const double strand_y_4 = table281[i280][1] - layer_0_y + table281[i280][0] * u_y;
        const double t283 = strand_x_4 * strand_x_by_q71_by_q71_4 - strand_y_4
            * layer_0_y_by_q71_by_q71;
        const double t284 = table281[i280][0] * y_z;
        const double strand_z_4 = layer_0_z + t284;
        const double strand_z_by_q71_by_q71_4 = layer_0_z_by_q71_by_q71 - t284;
        const double strand_x_by_q71_4 = layer_0_x_by_q71 - t284;
        const double t285 = t283 + strand_z_4 * strand_z_by_q71_by_q71_4 + t80 + strand_x_by_q71_4
            * strand_x_by_q71_4;
        const double strand_z_by_q71_4 = layer_0_z_by_q71 - t282;
        const double t286 = strand_x_4 * strand_x_by_q71_4 - strand_y_4 * layer_0_y_by_q71
            - strand_z_4 * strand_z_by_q71_4;
        const double t287 = strand_x_4 * strand_x_4 + strand_y_4 * strand_y_4 + strand_z_4
            * strand_z_4;
        const double length_4 = sinew_sqrt(t287);
        const double t288 = 1.0 / length_4;
        const double length_by_q71_4 = t286 * t288;
        const double t289 = t285 + strand_z_by_q71_4 * strand_z_by_q71_4 - length_by_q71_4
            * length_by_q71_4;
        const double length_by_q71_by_q71_4 = t289 * t288;
        const double t290 = table281[i280][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_4 = layer_0_x_by_q71_by_q73 - t290;
        const double t291 = strand_x_4 * strand_x_by_q71_by_q73_4 - strand_y_4
            * layer_0_y_by_q71_by_q73;
        const double t292 = table281[i280][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_4 = layer_0_z_by_q71_by_q73 - t292;
        const double strand_y_by_q73_4 = layer_0_y_by_q73 - table281[i280][0] * u_y_by_q73;
        const double t293 = t291 - strand_z_4 * strand_z_by_q71_by_q73_4 - layer_0_y_by_q71
            * strand_y_by_q73_4;
        const double strand_x_by_q73_4 = layer_0_x_by_q73 - t292;
        const double strand_z_by_q73_4 = layer_0_z_by_q73 - t290;
        const double t294 = t293 - strand_x_by_q71_4 * strand_x_by_q73_4 + strand_z_by_q71_4
            * strand_z_by_q73_4;
        const double t295 = strand_x_4 * strand_x_by_q73_4 - strand_y_4 * strand_y_by_q73_4
            + strand_z_4 * strand_z_by_q73_4;
        const double length_by_q73_4 = t295 * t288;
        const double length_by_q71_by_q73_4 = (t294 + length_by_q71_4 * length_by_q73_4) * t288;
        const double strand_x_by_q73_by_q73_4 = layer_0_x_by_q73_by_q73 - table281[i280][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_4 = layer_0_y_by_q73_by_q73 - table281[i280][0]
            * u_y_by_q73_by_q73;
        const double t296 = strand_x_4 * strand_x_by_q73_by_q73_4 + strand_y_4
            * strand_y_by_q73_by_q73_4;
        const double strand_z_by_q73_by_q73_4 = layer_0_z_by_q73_by_q73 - table281[i280][0]
            * y_z_by_q73_by_q73;
        const double t297 = t296 + strand_z_4 * strand_z_by_q73_by_q73_4 + strand_x_by_q73_4
            * strand_x_by_q73_4;
        const double t298 = t297 + strand_y_by_q73_4 * strand_y_by_q73_4 + strand_z_by_q73_4
            * strand_z_by_q73_4;
        const double length_by_q73_by_q73_4 = (t298 - length_by_q73_4 * length_by_q73_4) * t288;
        H[4 + 4 * i280] = length_by_q71_by_q71_4;
        H[5 + 4 * i280] = length_by_q71_by_q73_4;
        H[6 + 4 * i280] = length_by_q71_by_q73_4;
        H[7 + 4 * i280] = length_by_q73_by_q73_4;
    }
}

void wrist_bending_angles(double q71, double q73, double angles[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q73, q71);
    const double sin_q73 = sines1.s[0];
    const double cos_q73 = sines1.c[0];
    const double sin_q71 = sines1.s[1];
    const double cos_q71 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double z_plane_x = u_y * cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_plane_x = u_y * sin_A;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t3 = 0.004 * x_z;
    const double t4 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t3 - t4;
    const double y_z = sin_q71 * u_e;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double M_x = cos_q71 * M_e;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double t5 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t6 = 0.01 * z_x;
    const double layer_0_x = t5 - t6;
    const double y_x = cos_q71 * u_e;
    const double x_plane_y = u_e * sin_A;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t7 = origin_y + 0.004 * x_plane_y;
    const double t8 = 0.01 * z_plane_y;
    const double layer_0_y = t7 - t8;
    const double aside_y_14 = x_x * layer_0_z + x_z * layer_0_x;
    const double strand_7_y = 0.018 - layer_0_y;
    const double aside_x_14 = x_plane_y * layer_0_z - x_z * strand_7_y;
    const double aside_z_30 = x_plane_y * layer_0_x + x_x * strand_7_y;
    const double t9 = aside_x_14 * aside_x_14 + aside_y_14 * aside_y_14 + aside_z_30 * aside_z_30;
    const double t10 = sinew_one_atan2(sinew_sqrt(t9), x_plane_y * strand_7_y - x_x * layer_0_x
        + x_z * layer_0_z);
    const double t11 = sinew_one_atan2(sinew_sqrt(layer_0_z * layer_0_z + strand_7_y * strand_7_y),
        -layer_0_x);
    angles[7] = t10 + t11;
    const double layer_1_z = 0.028 - origin_z - t3 + t4;
    const double layer_1_x = t5 + t6;
    const double layer_1_y = t7 + t8;
    const double aside_y_54 = x_x * layer_1_z + x_z * layer_1_x;
    const double strand_27_y = 0.019 - layer_1_y;
    const double aside_x_54 = x_plane_y * layer_1_z - x_z * strand_27_y;
    const double aside_z_110 = x_plane_y * layer_1_x + x_x * strand_27_y;
    const double t12 = aside_x_54 * aside_x_54 + aside_y_54 * aside_y_54 + aside_z_110
        * aside_z_110;
    const double t13 = sinew_one_atan2(sinew_sqrt(t12), x_plane_y * strand_27_y - x_x * layer_1_x
        + x_z * layer_1_z);
    const double t14 = sinew_one_atan2(sinew_sqrt(layer_1_z * layer_1_z + strand_27_y
        * strand_27_y), -layer_1_x);
    angles[27] = t13 + t14;
    static const unsigned short element16[18] = {0, 1, 2, 3, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14,
        15, 16, 17, 18};
    static const double table17[18][2] = {{0.011, 0.007}, {0.01, 0.008}, {0.008, 0.01},
        {0.006, 0.011}, {0.005, 0.013}, {0.003, 0.015}, {0.002, 0.016}, {-0.002, 0.019},
        {-0.003, 0.021}, {-0.005, 0.023}, {-0.006, 0.024}, {-0.008, 0.026}, {-0.01, 0.027},
        {-0.011, 0.029}, {-0.013, 0.031}, {-0.014, 0.032}, {-0.016, 0.034}, {-0.018, 0.035}};
    for (int i15 = 0; i15 < 18; ++i15) {
        const double strand_z = layer_0_z + table17[i15][0] * y_z;
        const double strand_y = table17[i15][1] - layer_0_y + table17[i15][0] * u_y;
        const double t18 = x_plane_y * strand_z - x_z * strand_y;
        const double strand_x = layer_0_x + table17[i15][0] * y_x;
        const double t19 = x_x * strand_z + x_z * strand_x;
        const double aside_z = x_plane_y * strand_x + x_x * strand_y;
        const double t20 = sinew_one_atan2(sinew_sqrt(t18 * t18 + t19 * t19 + aside_z * aside_z),
            x_plane_y * strand_y - x_x * strand_x + x_z * strand_z);
        const double t21 = sinew_one_atan2(sinew_sqrt(strand_y * strand_y + strand_z * strand_z),
            -strand_x);
        angles[element16[i15]] = t20 + t21;
    }
    static const unsigned short element23[18] = {19, 20, 21, 22, 23, 24, 25, 26, 28, 29, 30, 31,
        32, 33, 34, 35, 36, 37};
    static const double table24[18][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017},
        {-0.002, 0.02}, {-0.003, 0.022}, {-0.005, 0.023}, {-0.006, 0.025}, {-0.008, 0.027},
        {-0.01, 0.028}, {-0.011, 0.03}, {-0.013, 0.031}, {-0.014, 0.033}, {-0.016, 0.035}};
    for (int i22 = 0; i22 < 18; ++i22) {
        const double strand_z_2 = layer_1_z + table24[i22][0] * y_z;
        const double strand_y_2 = table24[i22][1] - layer_1_y + table24[i22][0] * u_y;
        const double aside_x = x_plane_y * strand_z_2 - x_z * strand_y_2;
        const double strand_x_2 = layer_1_x + table24[i22][0] * y_x;
        const double aside_y = x_x * strand_z_2 + x_z * strand_x_2;
        const double aside_z_2 = x_plane_y * strand_x_2 + x_x * strand_y_2;
        const double t25 = sinew_sqrt(aside_x * aside_x + aside_y * aside_y + aside_z_2
            * aside_z_2);
        const double t26 = sinew_one_atan2(t25, x_plane_y * strand_y_2 - x_x * strand_x_2 + x_z
            * strand_z_2);
        const double t27 = sinew_one_atan2(sinew_sqrt(strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2), -strand_x_2);
        angles[element23[i22]] = t26 + t27;
    }
}

void wrist_feedforward(double q71, double q73, double delta_theta[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double M_x = cos_q71 * M_e;
    const double z_plane_x = u_y * cos_A;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double t3 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t4 = 0.01 * z_x;
    const double layer_0_x = t3 - t4;
    const double y_x = cos_q71 * u_e;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t5 = origin_y + 0.004 * u_e * sin_A;
    const double t6 = 0.01 * z_plane_y;
    const double layer_0_y = t5 - t6;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t7 = 0.004 * x_z;
    const double t8 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t7 - t8;
    const double y_z = sin_q71 * u_e;
    const double strand_7_y = 0.018 - layer_0_y;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double change_7 = 0.04661544808322666 - length_7;
    delta_theta[7] = 200.0 * change_7;
    const double layer_1_x = t3 + t4;
    const double layer_1_y = t5 + t6;
    const double layer_1_z = 0.028 - origin_z - t7 + t8;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t9 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t9);
    const double change_27 = 0.046561786907291264 - length_27;
    delta_theta[27] = 200.0 * change_27;
    static const double table11[11][3] = {{0.04669047011971501, 0.002, 0.019},
        {0.04661544808322666, 0.003, 0.021}, {0.04661544808322666, 0.005, 0.023},
        {0.04661544808322666, 0.006, 0.024}, {0.04661544808322666, 0.008, 0.026},
        {0.04669047011971501, 0.01, 0.027}, {0.04661544808322666, 0.011, 0.029},
        {0.04661544808322666, 0.013, 0.031}, {0.04661544808322666, 0.014, 0.032},
        {0.04661544808322666, 0.016, 0.034}, {0.04669047011971501, 0.018, 0.035}};
    for (int i10 = 0; i10 < 11; ++i10) {
        const double strand_x = layer_0_x - table11[i10][1] * y_x;
        const double strand_y = table11[i10][2] - layer_0_y - table11[i10][1] * u_y;
        const double strand_z = layer_0_z - table11[i10][1] * y_z;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double change = table11[i10][0] - length;
        delta_theta[8 + i10] = 200.0 * change;
    }
    static const double table13[10][3] = {{0.04661544808322666, 0.002, 0.02},
        {0.046561786907291264, 0.003, 0.022}, {0.04661544808322666, 0.005, 0.023},
        {0.046561786907291264, 0.006, 0.025}, {0.046561786907291264, 0.008, 0.027},
        {0.04661544808322666, 0.01, 0.028}, {0.046561786907291264, 0.011, 0.03},
        {0.04661544808322666, 0.013, 0.031}, {0.046561786907291264, 0.014, 0.033},
        {0.046561786907291264, 0.016, 0.035}};
    for (int i12 = 0; i12 < 10; ++i12) {
        const double strand_x_2 = layer_1_x - table13[i12][1] * y_x;
        const double strand_y_2 = table13[i12][2] - layer_1_y - table13[i12][1] * u_y;
        const double strand_z_2 = layer_1_z - table13[i12][1] * y_z;
        const double t14 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t14);
        const double change_2 = table13[i12][0] - length_2;
        delta_theta[28 + i12] = 200.0 * change_2;
    }
    static const double table16[8][3] = {{0.046561786907291264, 0.013, 0.006},
        {0.04661544808322666, 0.011, 0.007}, {0.046561786907291264, 0.01, 0.009},
        {0.046561786907291264, 0.008, 0.011}, {0.04661544808322666, 0.006, 0.012},
        {0.046561786907291264, 0.005, 0.014}, {0.04661544808322666, 0.003, 0.015},
        {0.046561786907291264, 0.002, 0.017}};
    for (int i15 = 0; i15 < 8; ++i15) {
        const double strand_x_3 = layer_1_x + table16[i15][1] * y_x;
        const double strand_y_3 = table16[i15][2] - layer_1_y + table16[i15][1] * u_y;
        const double strand_z_3 = layer_1_z + table16[i15][1] * y_z;
        const double t17 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t17);
        const double change_3 = table16[i15][0] - length_3;
        delta_theta[19 + i15] = 200.0 * change_3;
    }
    static const double table19[7][3] = {{0.04661544808322666, 0.011, 0.007},
        {0.04661544808322666, 0.01, 0.008}, {0.04661544808322666, 0.008, 0.01},
        {0.04669047011971501, 0.006, 0.011}, {0.04661544808322666, 0.005, 0.013},
        {0.04661544808322666, 0.003, 0.015}, {0.04661544808322666, 0.002, 0.016}};
    for (int i18 = 0; i18 < 7; ++i18) {
        const double strand_x_4 = layer_0_x + table19[i18][1] * y_x;
        const double strand_y_4 = table19[i18][2] - layer_0_y + table19[i18][1] * u_y;
        const double strand_z_4 = layer_0_z + table19[i18][1] * y_z;
        const double t20 = strand_x_4 * strand_x_4 + strand_y_4 * strand_y_4 + strand_z_4
            * strand_z_4;
        const double length_4 = sinew_sqrt(t20);
        const double change_4 = table19[i18][0] - length_4;
        delta_theta[i18] = 200.0 * change_4;
    }
}

void wrist_feedforward_rate(double q71, double q73, double dq71, double dq73,
    double delta_theta_rate[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double t2 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_e = B_e * ratio;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double t4 = 0.5 * B_e;
    const double M_y_by_q73 = t4 + 0.5 * C_y_by_q73;
    const double t5 = 23.80952380952381 * B_e;
    const double u_e = t5 - 23.80952380952381 * C_e;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double t6 = 0.5 * B_y;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double C_y = 0.002 * ratio * t3;
    const double t7 = 23.80952380952381 * B_y;
    const double u_y = t7 + 23.80952380952381 * C_y;
    const double u_y_by_q73 = t5 - 23.80952380952381 * C_y_by_q73;
    const double M_e = t4 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double u_e_by_q73 = t7 + 23.80952380952381 * C_e_by_q73;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t8 = p_y + p_y;
    const double t9 = p_y * p_y;
    const double p_z = 0.036 * cos_q71;
    const double t10 = p_z * p_z;
    const double t11 = -(1.296e-15 - t9 - t10);
    const double reach_squared_by_q73 = sinew_choose(t11, t8 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double p_x = u_e * s_e - u_y * s_y;
    const double t12 = 27.77777777777778 * p_x;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t12 * p_x_by_q73;
    const double reach_squared = sinew_max(t9 + t10, 1.296e-15);
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double reach = sinew_sqrt(reach_squared);
    const double t13 = reach - projection;
    const double t14 = sinew_choose(t13, 1.0, 0.0);
    const double t15 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t15;
    const double t16 = sinew_choose(t13, 0.0, 1.0);
    const double t17 = sinew_max(-projection, -reach);
    const double t18 = reach - t17;
    const double limited_by_q73 = sinew_choose(t18, -(reach_by_q73 * t16 - projection_by_q73 * t14),
        reach_by_q73);
    const double limited = sinew_min(t17, reach);
    const double t19 = limited + limited;
    const double t20 = reach + reach;
    const double t21 = (reach + limited) * (reach - limited);
    const double t22 = 1e-12 * reach_squared;
    const double t23 = -(t22 - t21);
    const double clearance_by_q73 = sinew_choose(t23, t20 * reach_by_q73 - t19 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double clearance = sinew_max(t21, t22);
    const double root = sinew_sqrt(clearance);
    const double t24 = 1.0 / root;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t24;
    const double t25 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t25;
    const double t26 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t26 * t25;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double sin_A = (p_y * root - p_z * limited) * t25;
    const double t27 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t27 * t25;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t28 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t29 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t28 + t29;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
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
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t36 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t37 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t36 + t37;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t38 = 0.004 * u_e;
    const double t39 = origin_y + t38 * sin_A;
    const double t40 = 0.01 * z_plane_y;
    const double layer_0_y = t39 - t40;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t41 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t42 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t41 + t42;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t43 = sin_q71 * z_plane_x;
    const double t44 = cos_q71 * sin_A;
    const double z_z = t44 + t43;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t45 = sin_q71 * x_plane_x;
    const double t46 = cos_q71 * cos_A;
    const double x_z = t46 - t45;
    const double t47 = 0.004 * x_z;
    const double t48 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t47 - t48;
    const double y_z = sin_q71 * u_e;
    const double t49 = 200.0 * dq73;
    const double p_y_by_q71 = u_y * p_z;
    const double reach_squared_by_q71 = sinew_choose(t11, -(t8 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t15;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t12 * u_e * p_z;
    const double limited_by_q71 = sinew_choose(t18, -(reach_by_q71 * t16 - projection_by_q71 * t14),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t23, t20 * reach_by_q71 - t19 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t24;
    const double t50 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t50 - cos_A * reach_squared_by_q71) * t25;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t51 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t51 - sin_A * reach_squared_by_q71) * t25;
    const double z_x_by_q71 = t44 - cos_q71 * z_plane_x_by_q71 + t43 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t46 + cos_q71 * x_plane_x_by_q71 - t45 + sin_q71 * cos_A_by_q71;
    const double t52 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t53 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t52 + t53;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t54 = origin_y_by_q71 + t38 * sin_A_by_q71;
    const double t55 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t54 - t55;
    const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t33 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t30 - cos_q71 * cos_A_by_q71 + t31 + sin_q71 * x_plane_x_by_q71;
    const double t56 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t57 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t56 + t57;
    const double t58 = 200.0 * dq71;
    const double strand_7_y = 0.018 - layer_0_y;
    const double t59 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t60 = 1.0 / length_7;
    const double length_7_by_q73 = t59 * t60;
    const double t61 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7_by_q71 = t61 * t60;
    delta_theta_rate[7] = -(t58 * length_7_by_q71 - t49 * length_7_by_q73);
    const double layer_1_x_by_q73 = t28 - t29;
    const double layer_1_x = t34 + t35;
    const double layer_1_y_by_q73 = t36 - t37;
    const double layer_1_y = t39 + t40;
    const double layer_1_z_by_q73 = t41 - t42;
    const double layer_1_z = 0.028 - origin_z - t47 + t48;
    const double layer_1_x_by_q71 = t52 - t53;
    const double layer_1_y_by_q71 = t54 + t55;
    const double layer_1_z_by_q71 = t56 - t57;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t62 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double t63 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t63);
    const double t64 = 1.0 / length_27;
    const double length_27_by_q73 = t62 * t64;
    const double t65 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double length_27_by_q71 = t65 * t64;
    delta_theta_rate[27] = -(t58 * length_27_by_q71 - t49 * length_27_by_q73);
    static const double table67[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    for (int i66 = 0; i66 < 11; ++i66) {
        const double t68 = table67[i66][0] * y_x;
        const double strand_x = layer_0_x - t68;
        const double t69 = table67[i66][0] * y_z;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t69;
        const double strand_y = table67[i66][1] - layer_0_y - table67[i66][0] * u_y;
        const double strand_z = layer_0_z - t69;
        const double strand_z_by_q71 = layer_0_z_by_q71 + t68;
        const double t70 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t71 = 1.0 / length;
        const double length_by_q71 = t70 * t71;
        const double strand_x_by_q73 = layer_0_x_by_q73 + table67[i66][0] * y_x_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 + table67[i66][0] * u_y_by_q73;
        const double strand_z_by_q73 = layer_0_z_by_q73 + table67[i66][0] * y_z_by_q73;
        const double t72 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t72 * t71;
        delta_theta_rate[8 + i66] = -(t58 * length_by_q71 - t49 * length_by_q73);
    }
    static const double table74[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    for (int i73 = 0; i73 < 10; ++i73) {
        const double t75 = table74[i73][0] * y_x;
        const double strand_x_2 = layer_1_x - t75;
        const double t76 = table74[i73][0] * y_z;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t76;
        const double strand_y_2 = table74[i73][1] - layer_1_y - table74[i73][0] * u_y;
        const double strand_z_2 = layer_1_z - t76;
        const double strand_z_by_q71_2 = layer_1_z_by_q71 + t75;
        const double t77 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_1_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t78 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t78);
        const double t79 = 1.0 / length_2;
        const double length_by_q71_2 = t77 * t79;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + table74[i73][0] * y_x_by_q73;
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table74[i73][0] * u_y_by_q73;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + table74[i73][0] * y_z_by_q73;
        const double t80 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t80 * t79;
        delta_theta_rate[28 + i73] = -(t58 * length_by_q71_2 - t49 * length_by_q73_2);
    }
    static const double table82[8][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017}};
    for (int i81 = 0; i81 < 8; ++i81) {
        const double t83 = table82[i81][0] * y_x;
        const double strand_x_3 = layer_1_x + t83;
        const double t84 = table82[i81][0] * y_z;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t84;
        const double strand_y_3 = table82[i81][1] - layer_1_y + table82[i81][0] * u_y;
        const double strand_z_3 = layer_1_z + t84;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t83;
        const double t85 = strand_x_3 * strand_x_by_q71_3 - strand_y_3 * layer_1_y_by_q71
            - strand_z_3 * strand_z_by_q71_3;
        const double t86 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t86);
        const double t87 = 1.0 / length_3;
        const double length_by_q71_3 = t85 * t87;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table82[i81][0] * y_x_by_q73;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table82[i81][0] * u_y_by_q73;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table82[i81][0] * y_z_by_q73;
        const double t88 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double length_by_q73_3 = t88 * t87;
        delta_theta_rate[19 + i81] = -(t58 * length_by_q71_3 - t49 * length_by_q73_3);
    }
    static const double table90[7][2] = {{0.011, 0.007}, {0.01, 0.008}, {0.008, 0.01},
        {0.006, 0.011}, {0.005, 0.013}, {0.003, 0.015}, {0.002, 0.016}};
    for (int i89 = 0; i89 < 7; ++i89) {
        const double t91 = table90[i89][0] * y_x;
        const double strand_x_4 = layer_0_x + t91;
        const double t92 = table90[i89][0] * y_z;
        const double strand_x_by_q71_4 = layer_0_x_by_q71 - t92;
        const double strand_y_4 = table90[i89][1] - layer_0_y + table90[i89][0] * u_y;
        const double strand_z_4 = layer_0_z + t92;
        const double strand_z_by_q71_4 = layer_0_z_by_q71 - t91;
        const double t93 = strand_x_4 * strand_x_by_q71_4 - strand_y_4 * layer_0_y_by_q71
            - strand_z_4 * strand_z_by_q71_4;
        const double t94 = strand_x_4 * strand_x_4 + strand_y_4 * strand_y_4 + strand_z_4
            * strand_z_4;
        const double length_4 = sinew_sqrt(t94);
        const double t95 = 1.0 / length_4;
        const double length_by_q71_4 = t93 * t95;
        const double strand_x_by_q73_4 = layer_0_x_by_q73 - table90[i89][0] * y_x_by_q73;
        const double strand_y_by_q73_4 = layer_0_y_by_q73 - table90[i89][0] * u_y_by_q73;
        const double strand_z_by_q73_4 = layer_0_z_by_q73 - table90[i89][0] * y_z_by_q73;
        const double t96 = strand_x_4 * strand_x_by_q73_4 - strand_y_4 * strand_y_by_q73_4
            + strand_z_4 * strand_z_by_q73_4;
        const double length_by_q73_4 = t96 * t95;
        delta_theta_rate[i89] = -(t58 * length_by_q71_4 - t49 * length_by_q73_4);
    }
}

void wrist_joint_torque(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    double tau[SINEW_AT_LEAST(2)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double t2 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t3;
    const double t4 = 23.80952380952381 * B_y;
    const double u_y = t4 + 23.80952380952381 * C_y;
    const double B_e = 0.074565407529229 * sin_q73;
    const double C_e = B_e * ratio;
    const double t5 = 0.5 * B_e;
    const double M_e = t5 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double t6 = 0.5 * B_y;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double t7 = 23.80952380952381 * B_e;
    const double u_e = t7 - 23.80952380952381 * C_e;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t8 = p_y + p_y;
    const double p_z = 0.036 * cos_q71;
    const double p_y_by_q71 = u_y * p_z;
    const double t9 = p_y * p_y;
    const double t10 = p_z * p_z;
    const double t11 = -(1.296e-15 - t9 - t10);
    const double reach_squared_by_q71 = sinew_choose(t11, -(t8 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
    const double reach_squared = sinew_max(t9 + t10, 1.296e-15);
    const double reach = sinew_sqrt(reach_squared);
    const double t12 = 1.0 / reach;
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t12;
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double t13 = reach - projection;
    const double t14 = sinew_choose(t13, 0.0, 1.0);
    const double t15 = sinew_choose(t13, 1.0, 0.0);
    const double t16 = 27.77777777777778 * p_x;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t16 * u_e * p_z;
    const double t17 = sinew_max(-projection, -reach);
    const double t18 = reach - t17;
    const double limited_by_q71 = sinew_choose(t18, -(reach_by_q71 * t14 - projection_by_q71 * t15),
        reach_by_q71);
    const double limited = sinew_min(t17, reach);
    const double t19 = limited + limited;
    const double t20 = reach + reach;
    const double t21 = (reach + limited) * (reach - limited);
    const double t22 = 1e-12 * reach_squared;
    const double t23 = -(t22 - t21);
    const double clearance_by_q71 = sinew_choose(t23, t20 * reach_by_q71 - t19 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double clearance = sinew_max(t21, t22);
    const double root = sinew_sqrt(clearance);
    const double t24 = 1.0 / root;
    const double root_by_q71 = 0.5 * clearance_by_q71 * t24;
    const double t25 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double t26 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t26;
    const double cos_A_by_q71 = (t25 - cos_A * reach_squared_by_q71) * t26;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double sin_A = (p_y * root - p_z * limited) * t26;
    const double t27 = cos_q71 * sin_A;
    const double z_plane_x = u_y * cos_A;
    const double t28 = sin_q71 * z_plane_x;
    const double t29 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t29 - sin_A * reach_squared_by_q71) * t26;
    const double z_x_by_q71 = t27 - cos_q71 * z_plane_x_by_q71 + t28 + sin_q71 * sin_A_by_q71;
    const double M_z = sin_q71 * M_e;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double t30 = cos_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t31 = sin_q71 * x_plane_x;
    const double x_x_by_q71 = t30 + cos_q71 * x_plane_x_by_q71 - t31 + sin_q71 * cos_A_by_q71;
    const double t32 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t33 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t32 + t33;
    const double y_z = sin_q71 * u_e;
    const double t34 = 0.011 * y_z;
    const double t35 = cos_q71 * x_plane_x;
    const double t36 = sin_q71 * cos_A;
    const double x_x = t35 + t36;
    const double M_x = cos_q71 * M_e;
    const double t37 = cos_q71 * z_plane_x;
    const double t38 = sin_q71 * sin_A;
    const double z_x = t37 - t38;
    const double t39 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t40 = 0.01 * z_x;
    const double layer_0_x = t39 - t40;
    const double y_x = cos_q71 * u_e;
    const double t41 = 0.011 * y_x;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t42 = 0.004 * u_e;
    const double t43 = origin_y_by_q71 + t42 * sin_A_by_q71;
    const double t44 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t43 - t44;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t45 = origin_y + t42 * sin_A;
    const double t46 = 0.01 * z_plane_y;
    const double layer_0_y = t45 - t46;
    const double z_z_by_q71 = t37 + cos_q71 * sin_A_by_q71 - t38 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t35 - cos_q71 * cos_A_by_q71 + t36 + sin_q71 * x_plane_x_by_q71;
    const double t47 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t48 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t47 + t48;
    const double z_z = t27 + t28;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t30 - t31;
    const double t49 = 0.004 * x_z;
    const double t50 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t49 - t50;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    const double u_e_by_q73 = t4 + 23.80952380952381 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double reach_squared_by_q73 = sinew_choose(t11, t8 * p_y_by_q73, 0.0);
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t12;
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t16 * p_x_by_q73;
    const double limited_by_q73 = sinew_choose(t18, -(reach_by_q73 * t14 - projection_by_q73 * t15),
        reach_by_q73);
    const double clearance_by_q73 = sinew_choose(t23, t20 * reach_by_q73 - t19 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double root_by_q73 = 0.5 * clearance_by_q73 * t24;
    const double t51 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t51 * t26;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t52 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t52 * t26;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t53 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t54 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t53 + t54;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double t55 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t56 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t55 + t56;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t57 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t58 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t57 + t58;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    static const double table62[7][2] = {{0.011, 0.007}, {0.01, 0.008}, {0.008, 0.01},
        {0.006, 0.011}, {0.005, 0.013}, {0.003, 0.015}, {0.002, 0.016}};
    double kept60[7];
    double kept61[7];
    for (int i59 = 0; i59 < 7; ++i59) {
        const double t63 = table62[i59][0] * y_x;
        const double strand_x = layer_0_x + t63;
        const double strand_x_by_q73 = layer_0_x_by_q73 - table62[i59][0] * y_x_by_q73;
        const double strand_y = table62[i59][1] - layer_0_y + table62[i59][0] * u_y;
        const double strand_y_by_q73 = layer_0_y_by_q73 - table62[i59][0] * u_y_by_q73;
        const double t64 = table62[i59][0] * y_z;
        const double strand_z = layer_0_z + t64;
        const double strand_z_by_q73 = layer_0_z_by_q73 - table62[i59][0] * y_z_by_q73;
        const double t65 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t66 = 1.0 / length;
        const double length_by_q73 = t65 * t66;
        const double strand_x_by_q71 = layer_0_x_by_q71 - t64;
        const double strand_z_by_q71 = layer_0_z_by_q71 - t63;
        const double t67 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length_by_q71 = t67 * t66;
        kept60[i59] = f[i59] * length_by_q71;
        kept61[i59] = f[i59] * length_by_q73;
    }
    const double t68 = 0.01 * y_z;
    const double t69 = 0.01 * y_x;
    const double t70 = 0.008 * y_z;
    const double t71 = 0.008 * y_x;
    const double t72 = 0.006 * y_z;
    const double t73 = 0.006 * y_x;
    const double t74 = 0.005 * y_z;
    const double t75 = 0.005 * y_x;
    const double t76 = 0.003 * y_z;
    const double t77 = 0.003 * y_x;
    const double t78 = 0.002 * y_z;
    const double t79 = 0.002 * y_x;
    const double t80 = kept60[0] + kept60[1] + kept60[2] + kept60[3] + kept60[4] + kept60[5]
        + kept60[6];
    const double t81 = kept61[0] + kept61[1] + kept61[2] + kept61[3] + kept61[4] + kept61[5]
        + kept61[6];
    const double strand_7_y = 0.018 - layer_0_y;
    const double t82 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t83 = 1.0 / length_7;
    const double length_7_by_q71 = t82 * t83;
    const double t84 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7_by_q73 = t84 * t83;
    const double t85 = 0.013 * y_z;
    const double t86 = 0.013 * y_x;
    const double t87 = 0.014 * y_z;
    const double t88 = 0.014 * y_x;
    const double t89 = 0.016 * y_z;
    const double t90 = 0.016 * y_x;
    static const double table94[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    double sum92 = t81 + f[7] * length_7_by_q73;
    double sum93 = t80 + f[7] * length_7_by_q71;
    for (int i91 = 0; i91 < 11; ++i91) {
        const double before95 = sum92;
        const double before96 = sum93;
        const double t97 = table94[i91][0] * y_x;
        const double strand_x_2 = layer_0_x - t97;
        const double strand_x_by_q73_2 = layer_0_x_by_q73 + table94[i91][0] * y_x_by_q73;
        const double strand_y_2 = table94[i91][1] - layer_0_y - table94[i91][0] * u_y;
        const double strand_y_by_q73_2 = layer_0_y_by_q73 + table94[i91][0] * u_y_by_q73;
        const double t98 = table94[i91][0] * y_z;
        const double strand_z_2 = layer_0_z - t98;
        const double strand_z_by_q73_2 = layer_0_z_by_q73 + table94[i91][0] * y_z_by_q73;
        const double t99 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double t100 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t100);
        const double t101 = 1.0 / length_2;
        const double length_by_q73_2 = t99 * t101;
        const double strand_x_by_q71_2 = layer_0_x_by_q71 + t98;
        const double strand_z_by_q71_2 = layer_0_z_by_q71 + t97;
        const double t102 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_0_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double length_by_q71_2 = t102 * t101;
        sum92 = before95 + f[8 + i91] * length_by_q73_2;
        sum93 = before96 + f[8 + i91] * length_by_q71_2;
    }
    const double layer_1_x_by_q71 = t32 - t33;
    const double layer_1_x = t39 + t40;
    const double layer_1_y_by_q71 = t43 + t44;
    const double layer_1_y = t45 + t46;
    const double layer_1_z_by_q71 = t47 - t48;
    const double layer_1_z = 0.028 - origin_z - t49 + t50;
    const double layer_1_x_by_q73 = t53 - t54;
    const double layer_1_y_by_q73 = t55 - t56;
    const double layer_1_z_by_q73 = t57 - t58;
    static const double table106[8][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017}};
    double sum104 = sum92;
    double sum105 = sum93;
    for (int i103 = 0; i103 < 8; ++i103) {
        const double before107 = sum104;
        const double before108 = sum105;
        const double t109 = table106[i103][0] * y_x;
        const double strand_x_3 = layer_1_x + t109;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table106[i103][0] * y_x_by_q73;
        const double strand_y_3 = table106[i103][1] - layer_1_y + table106[i103][0] * u_y;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table106[i103][0] * u_y_by_q73;
        const double t110 = table106[i103][0] * y_z;
        const double strand_z_3 = layer_1_z + t110;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table106[i103][0] * y_z_by_q73;
        const double t111 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double t112 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t112);
        const double t113 = 1.0 / length_3;
        const double length_by_q73_3 = t111 * t113;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t110;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t109;
        const double t114 = strand_x_3 * strand_x_by_q71_3 - strand_y_3 * layer_1_y_by_q71
            - strand_z_3 * strand_z_by_q71_3;
        const double length_by_q71_3 = t114 * t113;
        sum104 = before107 + f[19 + i103] * length_by_q73_3;
        sum105 = before108 + f[19 + i103] * length_by_q71_3;
    }
    const double strand_27_y = 0.019 - layer_1_y;
    const double t115 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double t116 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t116);
    const double t117 = 1.0 / length_27;
    const double length_27_by_q71 = t115 * t117;
    const double t118 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double length_27_by_q73 = t118 * t117;
    const double strand_28_x_by_q71 = layer_1_x_by_q71 + t78;
    const double strand_28_x = layer_1_x - t79;
    const double strand_28_y = 0.02 - layer_1_y - 0.002 * u_y;
    const double strand_28_z_by_q71 = layer_1_z_by_q71 + t79;
    const double strand_28_z = layer_1_z - t78;
    const double t119 = strand_28_x * strand_28_x_by_q71 - strand_28_y * layer_1_y_by_q71
        - strand_28_z * strand_28_z_by_q71;
    const double t120 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
        * strand_28_z;
    const double length_28 = sinew_sqrt(t120);
    const double t121 = 1.0 / length_28;
    const double length_28_by_q71 = t119 * t121;
    const double strand_28_x_by_q73 = layer_1_x_by_q73 + 0.002 * y_x_by_q73;
    const double strand_28_y_by_q73 = layer_1_y_by_q73 + 0.002 * u_y_by_q73;
    const double strand_28_z_by_q73 = layer_1_z_by_q73 + 0.002 * y_z_by_q73;
    const double t122 = strand_28_x * strand_28_x_by_q73 - strand_28_y * strand_28_y_by_q73
        + strand_28_z * strand_28_z_by_q73;
    const double length_28_by_q73 = t122 * t121;
    const double strand_29_x_by_q71 = layer_1_x_by_q71 + t76;
    const double strand_29_x = layer_1_x - t77;
    const double strand_29_y = 0.022 - layer_1_y - 0.003 * u_y;
    const double strand_29_z_by_q71 = layer_1_z_by_q71 + t77;
    const double strand_29_z = layer_1_z - t76;
    const double t123 = strand_29_x * strand_29_x_by_q71 - strand_29_y * layer_1_y_by_q71
        - strand_29_z * strand_29_z_by_q71;
    const double t124 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
        * strand_29_z;
    const double length_29 = sinew_sqrt(t124);
    const double t125 = 1.0 / length_29;
    const double length_29_by_q71 = t123 * t125;
    const double t126 = sum105 + f[27] * length_27_by_q71 + f[28] * length_28_by_q71 + f[29]
        * length_29_by_q71;
    const double strand_29_x_by_q73 = layer_1_x_by_q73 + 0.003 * y_x_by_q73;
    const double strand_29_y_by_q73 = layer_1_y_by_q73 + 0.003 * u_y_by_q73;
    const double strand_29_z_by_q73 = layer_1_z_by_q73 + 0.003 * y_z_by_q73;
    const double t127 = strand_29_x * strand_29_x_by_q73 - strand_29_y * strand_29_y_by_q73
        + strand_29_z * strand_29_z_by_q73;
    const double length_29_by_q73 = t127 * t125;
    const double t128 = sum104 + f[27] * length_27_by_q73 + f[28] * length_28_by_q73 + f[29]
        * length_29_by_q73;
    const double strand_30_x_by_q71 = layer_1_x_by_q71 + t74;
    const double strand_30_x = layer_1_x - t75;
    const double strand_30_y = 0.023 - layer_1_y - 0.005 * u_y;
    const double strand_30_z_by_q71 = layer_1_z_by_q71 + t75;
    const double strand_30_z = layer_1_z - t74;
    const double t129 = strand_30_x * strand_30_x_by_q71 - strand_30_y * layer_1_y_by_q71
        - strand_30_z * strand_30_z_by_q71;
    const double t130 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
        * strand_30_z;
    const double length_30 = sinew_sqrt(t130);
    const double t131 = 1.0 / length_30;
    const double length_30_by_q71 = t129 * t131;
    const double strand_30_x_by_q73 = layer_1_x_by_q73 + 0.005 * y_x_by_q73;
    const double strand_30_y_by_q73 = layer_1_y_by_q73 + 0.005 * u_y_by_q73;
    const double strand_30_z_by_q73 = layer_1_z_by_q73 + 0.005 * y_z_by_q73;
    const double t132 = strand_30_x * strand_30_x_by_q73 - strand_30_y * strand_30_y_by_q73
        + strand_30_z * strand_30_z_by_q73;
    const double length_30_by_q73 = t132 * t131;
    const double strand_31_x_by_q71 = layer_1_x_by_q71 + t72;
    const double strand_31_x = layer_1_x - t73;
    const double strand_31_y = 0.025 - layer_1_y - 0.006 * u_y;
    const double strand_31_z_by_q71 = layer_1_z_by_q71 + t73;
    const double strand_31_z = layer_1_z - t72;
    const double t133 = strand_31_x * strand_31_x_by_q71 - strand_31_y * layer_1_y_by_q71
        - strand_31_z * strand_31_z_by_q71;
    const double t134 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
        * strand_31_z;
    const double length_31 = sinew_sqrt(t134);
    const double t135 = 1.0 / length_31;
    const double length_31_by_q71 = t133 * t135;
    const double strand_31_x_by_q73 = layer_1_x_by_q73 + 0.006 * y_x_by_q73;
    const double strand_31_y_by_q73 = layer_1_y_by_q73 + 0.006 * u_y_by_q73;
    const double strand_31_z_by_q73 = layer_1_z_by_q73 + 0.006 * y_z_by_q73;
    const double t136 = strand_31_x * strand_31_x_by_q73 - strand_31_y * strand_31_y_by_q73
        + strand_31_z * strand_31_z_by_q73;
    const double length_31_by_q73 = t136 * t135;
    const double strand_32_x_by_q71 = layer_1_x_by_q71 + t70;
    const double strand_32_x = layer_1_x - t71;
    const double strand_32_y = 0.027 - layer_1_y - 0.008 * u_y;
    const double strand_32_z_by_q71 = layer_1_z_by_q71 + t71;
    const double strand_32_z = layer_1_z - t70;
    const double t137 = strand_32_x * strand_32_x_by_q71 - strand_32_y * layer_1_y_by_q71
        - strand_32_z * strand_32_z_by_q71;
    const double t138 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
        * strand_32_z;
    const double length_32 = sinew_sqrt(t138);
    const double t139 = 1.0 / length_32;
    const double length_32_by_q71 = t137 * t139;
    const double t140 = t126 + f[30] * length_30_by_q71 + f[31] * length_31_by_q71 + f[32]
        * length_32_by_q71;
    const double strand_32_x_by_q73 = layer_1_x_by_q73 + 0.008 * y_x_by_q73;
    const double strand_32_y_by_q73 = layer_1_y_by_q73 + 0.008 * u_y_by_q73;
    const double strand_32_z_by_q73 = layer_1_z_by_q73 + 0.008 * y_z_by_q73;
    const double t141 = strand_32_x * strand_32_x_by_q73 - strand_32_y * strand_32_y_by_q73
        + strand_32_z * strand_32_z_by_q73;
    const double length_32_by_q73 = t141 * t139;
    const double t142 = t128 + f[30] * length_30_by_q73 + f[31] * length_31_by_q73 + f[32]
        * length_32_by_q73;
    const double strand_33_x_by_q71 = layer_1_x_by_q71 + t68;
    const double strand_33_x = layer_1_x - t69;
    const double strand_33_y = 0.028 - layer_1_y - 0.01 * u_y;
    const double strand_33_z_by_q71 = layer_1_z_by_q71 + t69;
    const double strand_33_z = layer_1_z - t68;
    const double t143 = strand_33_x * strand_33_x_by_q71 - strand_33_y * layer_1_y_by_q71
        - strand_33_z * strand_33_z_by_q71;
    const double t144 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
        * strand_33_z;
    const double length_33 = sinew_sqrt(t144);
    const double t145 = 1.0 / length_33;
    const double length_33_by_q71 = t143 * t145;
    const double strand_33_x_by_q73 = layer_1_x_by_q73 + 0.01 * y_x_by_q73;
    const double strand_33_y_by_q73 = layer_1_y_by_q73 + 0.01 * u_y_by_q73;
    const double strand_33_z_by_q73 = layer_1_z_by_q73 + 0.01 * y_z_by_q73;
    const double t146 = strand_33_x * strand_33_x_by_q73 - strand_33_y * strand_33_y_by_q73
        + strand_33_z * strand_33_z_by_q73;
    const double length_33_by_q73 = t146 * t145;
    const double strand_34_x_by_q71 = layer_1_x_by_q71 + t34;
    const double strand_34_x = layer_1_x - t41;
    const double strand_34_y = 0.03 - layer_1_y - 0.011 * u_y;
    const double strand_34_z_by_q71 = layer_1_z_by_q71 + t41;
    const double strand_34_z = layer_1_z - t34;
    const double t147 = strand_34_x * strand_34_x_by_q71 - strand_34_y * layer_1_y_by_q71
        - strand_34_z * strand_34_z_by_q71;
    const double t148 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
        * strand_34_z;
    const double length_34 = sinew_sqrt(t148);
    const double t149 = 1.0 / length_34;
    const double length_34_by_q71 = t147 * t149;
    const double strand_34_x_by_q73 = layer_1_x_by_q73 + 0.011 * y_x_by_q73;
    const double strand_34_y_by_q73 = layer_1_y_by_q73 + 0.011 * u_y_by_q73;
    const double strand_34_z_by_q73 = layer_1_z_by_q73 + 0.011 * y_z_by_q73;
    const double t150 = strand_34_x * strand_34_x_by_q73 - strand_34_y * strand_34_y_by_q73
        + strand_34_z * strand_34_z_by_q73;
    const double length_34_by_q73 = t150 * t149;
    const double strand_35_x_by_q71 = layer_1_x_by_q71 + t85;
    const double strand_35_x = layer_1_x - t86;
    const double strand_35_y = 0.031 - layer_1_y - 0.013 * u_y;
    const double strand_35_z_by_q71 = layer_1_z_by_q71 + t86;
    const double strand_35_z = layer_1_z - t85;
    const double t151 = strand_35_x * strand_35_x_by_q71 - strand_35_y * layer_1_y_by_q71
        - strand_35_z * strand_35_z_by_q71;
    const double t152 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
        * strand_35_z;
    const double length_35 = sinew_sqrt(t152);
    const double t153 = 1.0 / length_35;
    const double length_35_by_q71 = t151 * t153;
    const double t154 = t140 + f[33] * length_33_by_q71 + f[34] * length_34_by_q71 + f[35]
        * length_35_by_q71;
    const double strand_35_x_by_q73 = layer_1_x_by_q73 + 0.013 * y_x_by_q73;
    const double strand_35_y_by_q73 = layer_1_y_by_q73 + 0.013 * u_y_by_q73;
    const double strand_35_z_by_q73 = layer_1_z_by_q73 + 0.013 * y_z_by_q73;
    const double t155 = strand_35_x * strand_35_x_by_q73 - strand_35_y * strand_35_y_by_q73
        + strand_35_z * strand_35_z_by_q73;
    const double length_35_by_q73 = t155 * t153;
    const double t156 = t142 + f[33] * length_33_by_q73 + f[34] * length_34_by_q73 + f[35]
        * length_35_by_q73;
    const double strand_36_x_by_q71 = layer_1_x_by_q71 + t87;
    const double strand_36_x = layer_1_x - t88;
    const double strand_36_y = 0.033 - layer_1_y - 0.014 * u_y;
    const double strand_36_z_by_q71 = layer_1_z_by_q71 + t88;
    const double strand_36_z = layer_1_z - t87;
    const double t157 = strand_36_x * strand_36_x_by_q71 - strand_36_y * layer_1_y_by_q71
        - strand_36_z * strand_36_z_by_q71;
    const double t158 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
        * strand_36_z;
    const double length_36 = sinew_sqrt(t158);
    const double t159 = 1.0 / length_36;
    const double length_36_by_q71 = t157 * t159;
    const double strand_36_x_by_q73 = layer_1_x_by_q73 + 0.014 * y_x_by_q73;
    const double strand_36_y_by_q73 = layer_1_y_by_q73 + 0.014 * u_y_by_q73;
    const double strand_36_z_by_q73 = layer_1_z_by_q73 + 0.014 * y_z_by_q73;
    const double t160 = strand_36_x * strand_36_x_by_q73 - strand_36_y * strand_36_y_by_q73
        + strand_36_z * strand_36_z_by_q73;
    const double length_36_by_q73 = t160 * t159;
    const double strand_37_x_by_q71 = layer_1_x_by_q71 + t89;
    const double strand_37_x = layer_1_x - t90;
    const double strand_37_y = 0.035 - layer_1_y - 0.016 * u_y;
    const double strand_37_z_by_q71 = layer_1_z_by_q71 + t90;
    const double strand_37_z = layer_1_z - t89;
    const double t161 = strand_37_x * strand_37_x_by_q71 - strand_37_y * layer_1_y_by_q71
        - strand_37_z * strand_37_z_by_q71;
    const double t162 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
        * strand_37_z;
    const double length_37 = sinew_sqrt(t162);
    const double t163 = 1.0 / length_37;
    const double length_37_by_q71 = t161 * t163;
    const double strand_37_x_by_q73 = layer_1_x_by_q73 + 0.016 * y_x_by_q73;
    const double strand_37_y_by_q73 = layer_1_y_by_q73 + 0.016 * u_y_by_q73;
    const double strand_37_z_by_q73 = layer_1_z_by_q73 + 0.016 * y_z_by_q73;
    const double t164 = strand_37_x * strand_37_x_by_q73 - strand_37_y * strand_37_y_by_q73
        + strand_37_z * strand_37_z_by_q73;
    const double length_37_by_q73 = t164 * t163;
    tau[0] = -(t154 + f[36] * length_36_by_q71 + f[37] * length_37_by_q71);
    tau[1] = t156 + f[36] * length_36_by_q73 + f[37] * length_37_by_q73;
}

void wrist_joint_stiffness(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    const double k[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(4)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared_by_q73_by_q73 = 0.084 * B_y;
    const double B_to_C0_squared = 0.007324 - B_to_C0_squared_by_q73_by_q73;
    const double t2 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_e = B_e * ratio;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double t4 = 0.5 * B_e;
    const double M_y_by_q73 = t4 + 0.5 * C_y_by_q73;
    const double t5 = 23.80952380952381 * B_e;
    const double u_e = t5 - 23.80952380952381 * C_e;
    const double t6 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t6;
    const double t7 = 0.5 * B_y;
    const double M_e_by_q73 = t7 - 0.5 * C_e_by_q73;
    const double C_y = 0.002 * ratio * t3;
    const double t8 = 23.80952380952381 * B_y;
    const double u_y = t8 + 23.80952380952381 * C_y;
    const double u_y_by_q73 = t5 - 23.80952380952381 * C_y_by_q73;
    const double M_e = t4 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double u_e_by_q73 = t8 + 23.80952380952381 * C_e_by_q73;
    const double M_y = t7 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t9 = p_y + p_y;
    const double t10 = p_y * p_y;
    const double p_z = 0.036 * cos_q71;
    const double t11 = p_z * p_z;
    const double t12 = -(1.296e-15 - t10 - t11);
    const double reach_squared_by_q73 = sinew_choose(t12, t9 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double p_x = u_e * s_e - u_y * s_y;
    const double t13 = 27.77777777777778 * p_x;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t13 * p_x_by_q73;
    const double reach_squared = sinew_max(t10 + t11, 1.296e-15);
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double reach = sinew_sqrt(reach_squared);
    const double t14 = reach - projection;
    const double t15 = sinew_choose(t14, 1.0, 0.0);
    const double t16 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t16;
    const double t17 = sinew_choose(t14, 0.0, 1.0);
    const double t18 = sinew_max(-projection, -reach);
    const double t19 = reach - t18;
    const double limited_by_q73 = sinew_choose(t19, -(reach_by_q73 * t17 - projection_by_q73 * t15),
        reach_by_q73);
    const double t20 = reach_by_q73 * reach_by_q73;
    const double t21 = t20 + t20;
    const double t22 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t22 * t2;
    const double C_y_by_q73_by_q73 = t6 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t7 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t4 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t8 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t23 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t5 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t24 = u_e_by_q73 + u_e_by_q73;
    const double t25 = u_y_by_q73 + u_y_by_q73;
    const double p_y_by_q73_by_q73 = t23 - s_y * u_e_by_q73_by_q73 + t24 * M_y_by_q73 - t25
        * M_e_by_q73;
    const double t26 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t12, t26 * p_y_by_q73 + t9
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t21) * t16;
    const double t27 = reach + reach;
    const double t28 = t21 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t27
        * reach_by_q73_by_q73;
    const double t29 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t30 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t30 - s_y * u_y_by_q73_by_q73 - t24 * M_e_by_q73 - t25
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t29 - t13 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t19, -(reach_by_q73_by_q73 * t17
        - projection_by_q73_by_q73 * t15), reach_by_q73_by_q73);
    const double limited = sinew_min(t18, reach);
    const double t31 = limited + limited;
    const double t32 = (reach + limited) * (reach - limited);
    const double t33 = 1e-12 * reach_squared;
    const double t34 = -(t33 - t32);
    const double clearance_by_q73_by_q73 = sinew_choose(t34, t28 - t31 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double clearance_by_q73 = sinew_choose(t34, t27 * reach_by_q73 - t31 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double clearance = sinew_max(t32, t33);
    const double root = sinew_sqrt(clearance);
    const double t35 = 1.0 / root;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t35;
    const double t36 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t36 * t35;
    const double t37 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t38 = p_z * limited;
    const double t39 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - t38) * t39;
    const double t40 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t40 * t39;
    const double t41 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t42 = t37 - sin_A * reach_squared_by_q73_by_q73 + t26 * root_by_q73 - t41
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t42 * t39;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t25 * sin_A_by_q73;
    const double t43 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t44 = p_z * root;
    const double cos_A = (p_y * limited + t44) * t39;
    const double t45 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t45 * t39;
    const double t46 = t43 - cos_A * reach_squared_by_q73_by_q73 + t26 * limited_by_q73 - t41
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t46 * t39;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t25 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t47 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t48 = 0.01 * z_x_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t47 - t48;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double strand_0_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - 0.011 * y_x_by_q73_by_q73;
    const double x_plane_x = u_y * sin_A;
    const double t49 = cos_q71 * x_plane_x;
    const double t50 = sin_q71 * cos_A;
    const double x_x = t49 + t50;
    const double M_x = cos_q71 * M_e;
    const double z_plane_x = u_y * cos_A;
    const double t51 = cos_q71 * z_plane_x;
    const double t52 = sin_q71 * sin_A;
    const double z_x = t51 - t52;
    const double t53 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t54 = 0.01 * z_x;
    const double layer_0_x = t53 - t54;
    const double y_x = cos_q71 * u_e;
    const double t55 = 0.011 * y_x;
    const double strand_0_x = layer_0_x + t55;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t24 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t24 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t56 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t57 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t56 + t57;
    const double strand_0_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - 0.011 * u_y_by_q73_by_q73;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t58 = 0.004 * u_e;
    const double t59 = origin_y + t58 * sin_A;
    const double t60 = 0.01 * z_plane_y;
    const double layer_0_y = t59 - t60;
    const double strand_0_y = 0.007 - layer_0_y + 0.011 * u_y;
    const double t61 = strand_0_x * strand_0_x_by_q73_by_q73 + strand_0_y
        * strand_0_y_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t62 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t63 = 0.01 * z_z_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t62 - t63;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double strand_0_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - 0.011 * y_z_by_q73_by_q73;
    const double t64 = sin_q71 * z_plane_x;
    const double t65 = cos_q71 * sin_A;
    const double z_z = t65 + t64;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t66 = sin_q71 * x_plane_x;
    const double t67 = cos_q71 * cos_A;
    const double x_z = t67 - t66;
    const double t68 = 0.004 * x_z;
    const double t69 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t68 - t69;
    const double y_z = sin_q71 * u_e;
    const double t70 = 0.011 * y_z;
    const double strand_0_z = layer_0_z + t70;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t71 = cos_q71 * z_plane_x_by_q73;
    const double t72 = sin_q71 * sin_A_by_q73;
    const double z_x_by_q73 = t71 - t72;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t73 = cos_q71 * x_plane_x_by_q73;
    const double t74 = sin_q71 * cos_A_by_q73;
    const double x_x_by_q73 = t73 + t74;
    const double t75 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t76 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t75 + t76;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double t77 = 0.011 * y_x_by_q73;
    const double strand_0_x_by_q73 = layer_0_x_by_q73 - t77;
    const double t78 = t61 + strand_0_z * strand_0_z_by_q73_by_q73 + strand_0_x_by_q73
        * strand_0_x_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t79 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t80 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t79 + t80;
    const double strand_0_y_by_q73 = layer_0_y_by_q73 - 0.011 * u_y_by_q73;
    const double t81 = sin_q71 * z_plane_x_by_q73;
    const double t82 = cos_q71 * sin_A_by_q73;
    const double z_z_by_q73 = t82 + t81;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double t83 = sin_q71 * x_plane_x_by_q73;
    const double t84 = cos_q71 * cos_A_by_q73;
    const double x_z_by_q73 = t84 - t83;
    const double t85 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t86 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t85 + t86;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t87 = 0.011 * y_z_by_q73;
    const double strand_0_z_by_q73 = layer_0_z_by_q73 - t87;
    const double t88 = t78 + strand_0_y_by_q73 * strand_0_y_by_q73 + strand_0_z_by_q73
        * strand_0_z_by_q73;
    const double t89 = strand_0_x * strand_0_x_by_q73 - strand_0_y * strand_0_y_by_q73 + strand_0_z
        * strand_0_z_by_q73;
    const double t90 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z * strand_0_z;
    const double length_0 = sinew_sqrt(t90);
    const double t91 = 1.0 / length_0;
    const double length_0_by_q73 = t89 * t91;
    const double t92 = length_0_by_q73 * length_0_by_q73;
    const double length_0_by_q73_by_q73 = (t88 - t92) * t91;
    const double K_0_4 = f[0] * length_0_by_q73_by_q73 + k[0] * t92;
    const double p_y_by_q71 = u_y * p_z;
    const double t93 = p_z + p_z;
    const double reach_squared_by_q71 = sinew_choose(t12, -(t9 * p_y_by_q71 + t93 * p_z_by_q71),
        0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t16;
    const double p_x_by_q71 = u_e * p_z;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t13 * p_x_by_q71;
    const double limited_by_q71 = sinew_choose(t19, -(reach_by_q71 * t17 - projection_by_q71 * t15),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t34, t27 * reach_by_q71 - t31 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t35;
    const double t94 = root_by_q71 + root_by_q71;
    const double t95 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double t96 = p_y_by_q71 + p_y_by_q71;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t12, t9 * p_y_by_q71_by_q73 - t96
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t95) * t16;
    const double t97 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t13
        * p_z * u_e_by_q73 - t97 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t19, -(reach_by_q71_by_q73 * t17
        - projection_by_q71_by_q73 * t15), reach_by_q71_by_q73);
    const double t98 = limited_by_q71 + limited_by_q71;
    const double t99 = t27 * reach_by_q71_by_q73 - t31 * limited_by_q71_by_q73 + t95 - t98
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t34, t99, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t94 * root_by_q73) * t35;
    const double t100 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t101 = t100 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t102 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t102 - cos_A * reach_squared_by_q71) * t39;
    const double t103 = t101 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t103 * t39;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t104 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t105 = t104 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t106 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t106 - sin_A * reach_squared_by_q71) * t39;
    const double t107 = t105 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t107 * t39;
    const double z_x_by_q71_by_q73 = t82 - cos_q71 * z_plane_x_by_q71_by_q73 + t81 + sin_q71
        * sin_A_by_q71_by_q73;
    const double origin_x_by_q71_by_q73 = M_z_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t84 + cos_q71 * x_plane_x_by_q71_by_q73 - t83 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t108 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t109 = 0.01 * z_x_by_q71_by_q73;
    const double layer_0_x_by_q71_by_q73 = t108 + t109;
    const double strand_0_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t87;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t110 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t111 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t110 - t111;
    const double t112 = strand_0_x * strand_0_x_by_q71_by_q73 - strand_0_y
        * layer_0_y_by_q71_by_q73;
    const double z_z_by_q71_by_q73 = t71 + cos_q71 * sin_A_by_q71_by_q73 - t72 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_x_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t73 - cos_q71 * cos_A_by_q71_by_q73 + t74 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t113 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t114 = 0.01 * z_z_by_q71_by_q73;
    const double layer_0_z_by_q71_by_q73 = t113 + t114;
    const double strand_0_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t77;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double z_x_by_q71 = t65 - cos_q71 * z_plane_x_by_q71 + t64 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t67 + cos_q71 * x_plane_x_by_q71 - t66 + sin_q71 * cos_A_by_q71;
    const double t115 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t116 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t115 + t116;
    const double strand_0_x_by_q71 = layer_0_x_by_q71 - t70;
    const double t117 = t112 - strand_0_z * strand_0_z_by_q71_by_q73 - strand_0_x_by_q71
        * strand_0_x_by_q73;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t118 = origin_y_by_q71 + t58 * sin_A_by_q71;
    const double t119 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t118 - t119;
    const double z_z_by_q71 = t51 + cos_q71 * sin_A_by_q71 - t52 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t49 - cos_q71 * cos_A_by_q71 + t50 + sin_q71 * x_plane_x_by_q71;
    const double t120 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t121 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t120 + t121;
    const double strand_0_z_by_q71 = layer_0_z_by_q71 - t55;
    const double t122 = t117 - layer_0_y_by_q71 * strand_0_y_by_q73 + strand_0_z_by_q71
        * strand_0_z_by_q73;
    const double t123 = strand_0_x * strand_0_x_by_q71 - strand_0_y * layer_0_y_by_q71 - strand_0_z
        * strand_0_z_by_q71;
    const double length_0_by_q71 = t123 * t91;
    const double length_0_by_q71_by_q73 = (t122 + length_0_by_q71 * length_0_by_q73) * t91;
    const double K_0 = f[0] * length_0_by_q71_by_q73 - k[0] * length_0_by_q71 * length_0_by_q73;
    const double t124 = reach_by_q71 * reach_by_q71;
    const double t125 = t124 + t124;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t126 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t12, t126 + t126 + t9
        * p_y_by_q71_by_q71 - t93 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t125) * t16;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t97
        * p_x_by_q71 + t13 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t19, -(reach_by_q71_by_q71 * t17
        - projection_by_q71_by_q71 * t15), reach_by_q71_by_q71);
    const double t127 = t125 - t98 * limited_by_q71 + t27 * reach_by_q71_by_q71 - t31
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t34, t127, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t94 * root_by_q71) * t35;
    const double t128 = p_y * limited_by_q71_by_q71 - t44 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t129 = p_z_by_q71 + p_z_by_q71;
    const double t130 = t128 - cos_A * reach_squared_by_q71_by_q71 - t96 * limited_by_q71 - t129
        * root_by_q71;
    const double t131 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t130 - t131 * cos_A_by_q71) * t39;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t132 = p_y * root_by_q71_by_q71 + t38 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t133 = t132 - sin_A * reach_squared_by_q71_by_q71 - t96 * root_by_q71 + t129
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t133 - t131 * sin_A_by_q71) * t39;
    const double t134 = t51 - cos_q71 * z_plane_x_by_q71_by_q71 - t52 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t135 = cos_q71 + cos_q71;
    const double t136 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t134 + t135 * sin_A_by_q71 + t136 * z_plane_x_by_q71;
    const double origin_x_by_q71_by_q71 = M_x - 0.018 * z_x_by_q71_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t137 = t49 - cos_q71 * x_plane_x_by_q71_by_q71 + t50 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t137 - t135 * cos_A_by_q71 + t136 * x_plane_x_by_q71;
    const double t138 = origin_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t139 = 0.01 * z_x_by_q71_by_q71;
    const double layer_0_x_by_q71_by_q71 = t138 + t139;
    const double strand_0_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t55;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t140 = origin_y_by_q71_by_q71 + t58 * sin_A_by_q71_by_q71;
    const double t141 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t140 - t141;
    const double t142 = strand_0_x * strand_0_x_by_q71_by_q71 - strand_0_y
        * layer_0_y_by_q71_by_q71;
    const double t143 = t65 - cos_q71 * sin_A_by_q71_by_q71 + t64 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t143 - t135 * z_plane_x_by_q71 + t136 * sin_A_by_q71;
    const double origin_z_by_q71_by_q71 = M_z - 0.018 * z_z_by_q71_by_q71;
    const double t144 = t67 - cos_q71 * cos_A_by_q71_by_q71 - t66 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t144 + t135 * x_plane_x_by_q71 + t136 * cos_A_by_q71;
    const double t145 = origin_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t146 = 0.01 * z_z_by_q71_by_q71;
    const double layer_0_z_by_q71_by_q71 = t145 + t146;
    const double strand_0_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t70;
    const double t147 = t142 + strand_0_z * strand_0_z_by_q71_by_q71 + strand_0_x_by_q71
        * strand_0_x_by_q71;
    const double t148 = layer_0_y_by_q71 * layer_0_y_by_q71;
    const double t149 = length_0_by_q71 * length_0_by_q71;
    const double length_0_by_q71_by_q71 = (t147 + t148 + strand_0_z_by_q71 * strand_0_z_by_q71
        - t149) * t91;
    const double K_0_2 = f[0] * length_0_by_q71_by_q71 + k[0] * t149;
    static const double table154[5][2] = {{0.01, 0.008}, {0.008, 0.01}, {0.006, 0.011},
        {0.005, 0.013}, {0.003, 0.015}};
    double sum151 = K_0;
    double sum152 = K_0_4;
    double sum153 = K_0_2;
    for (int i150 = 0; i150 < 5; ++i150) {
        const double before155 = sum151;
        const double before156 = sum152;
        const double before157 = sum153;
        const double t158 = table154[i150][0] * y_x;
        const double strand_x = layer_0_x + t158;
        const double t159 = table154[i150][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t159;
        const double strand_y = table154[i150][1] - layer_0_y + table154[i150][0] * u_y;
        const double t160 = table154[i150][0] * y_z;
        const double strand_z = layer_0_z + t160;
        const double t161 = table154[i150][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t161;
        const double t162 = strand_x * strand_x_by_q71_by_q73 - strand_y * layer_0_y_by_q71_by_q73
            - strand_z * strand_z_by_q71_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 - table154[i150][0] * u_y_by_q73;
        const double strand_x_by_q71 = layer_0_x_by_q71 - t160;
        const double strand_x_by_q73 = layer_0_x_by_q73 - t161;
        const double t163 = t162 - layer_0_y_by_q71 * strand_y_by_q73 - strand_x_by_q71
            * strand_x_by_q73;
        const double strand_z_by_q71 = layer_0_z_by_q71 - t158;
        const double strand_z_by_q73 = layer_0_z_by_q73 - t159;
        const double t164 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t165 = 1.0 / length;
        const double length_by_q71 = t164 * t165;
        const double t166 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t166 * t165;
        const double length_by_q71_by_q73 = (t163 + strand_z_by_q71 * strand_z_by_q73
            + length_by_q71 * length_by_q73) * t165;
        const double t167 = before155 + f[1 + i150] * length_by_q71_by_q73 - k[1 + i150]
            * length_by_q71 * length_by_q73;
        const double strand_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - table154[i150][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - table154[i150][0]
            * u_y_by_q73_by_q73;
        const double strand_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - table154[i150][0]
            * y_z_by_q73_by_q73;
        const double t168 = strand_x * strand_x_by_q73_by_q73 + strand_y * strand_y_by_q73_by_q73
            + strand_z * strand_z_by_q73_by_q73;
        const double t169 = t168 + strand_x_by_q73 * strand_x_by_q73 + strand_y_by_q73
            * strand_y_by_q73;
        const double t170 = length_by_q73 * length_by_q73;
        const double length_by_q73_by_q73 = (t169 + strand_z_by_q73 * strand_z_by_q73 - t170)
            * t165;
        const double strand_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t158;
        const double strand_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t160;
        const double t171 = strand_x * strand_x_by_q71_by_q71 - strand_y * layer_0_y_by_q71_by_q71
            + strand_z * strand_z_by_q71_by_q71;
        const double t172 = t171 + t148 + strand_x_by_q71 * strand_x_by_q71 + strand_z_by_q71
            * strand_z_by_q71;
        const double t173 = length_by_q71 * length_by_q71;
        const double length_by_q71_by_q71 = (t172 - t173) * t165;
        sum151 = t167;
        sum152 = before156 + f[1 + i150] * length_by_q73_by_q73 + k[1 + i150] * t170;
        sum153 = before157 + f[1 + i150] * length_by_q71_by_q71 + k[1 + i150] * t173;
    }
    const double strand_6_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - 0.002 * y_x_by_q73_by_q73;
    const double t174 = 0.002 * y_x;
    const double strand_6_x = layer_0_x + t174;
    const double strand_6_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - 0.002 * u_y_by_q73_by_q73;
    const double t175 = 0.002 * u_y;
    const double strand_6_y = 0.016 - layer_0_y + t175;
    const double t176 = strand_6_x * strand_6_x_by_q73_by_q73 + strand_6_y
        * strand_6_y_by_q73_by_q73;
    const double strand_6_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - 0.002 * y_z_by_q73_by_q73;
    const double t177 = 0.002 * y_z;
    const double strand_6_z = layer_0_z + t177;
    const double t178 = 0.002 * y_x_by_q73;
    const double strand_6_x_by_q73 = layer_0_x_by_q73 - t178;
    const double t179 = t176 + strand_6_z * strand_6_z_by_q73_by_q73 + strand_6_x_by_q73
        * strand_6_x_by_q73;
    const double t180 = 0.002 * u_y_by_q73;
    const double strand_6_y_by_q73 = layer_0_y_by_q73 - t180;
    const double t181 = 0.002 * y_z_by_q73;
    const double strand_6_z_by_q73 = layer_0_z_by_q73 - t181;
    const double t182 = t179 + strand_6_y_by_q73 * strand_6_y_by_q73 + strand_6_z_by_q73
        * strand_6_z_by_q73;
    const double t183 = strand_6_x * strand_6_x_by_q73 - strand_6_y * strand_6_y_by_q73 + strand_6_z
        * strand_6_z_by_q73;
    const double t184 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z * strand_6_z;
    const double length_6 = sinew_sqrt(t184);
    const double t185 = 1.0 / length_6;
    const double length_6_by_q73 = t183 * t185;
    const double t186 = length_6_by_q73 * length_6_by_q73;
    const double length_6_by_q73_by_q73 = (t182 - t186) * t185;
    const double strand_6_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t181;
    const double t187 = strand_6_x * strand_6_x_by_q71_by_q73 - strand_6_y
        * layer_0_y_by_q71_by_q73;
    const double strand_6_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t178;
    const double t188 = t187 - strand_6_z * strand_6_z_by_q71_by_q73 - layer_0_y_by_q71
        * strand_6_y_by_q73;
    const double strand_6_x_by_q71 = layer_0_x_by_q71 - t177;
    const double strand_6_z_by_q71 = layer_0_z_by_q71 - t174;
    const double t189 = t188 - strand_6_x_by_q71 * strand_6_x_by_q73 + strand_6_z_by_q71
        * strand_6_z_by_q73;
    const double t190 = strand_6_x * strand_6_x_by_q71 - strand_6_y * layer_0_y_by_q71 - strand_6_z
        * strand_6_z_by_q71;
    const double length_6_by_q71 = t190 * t185;
    const double length_6_by_q71_by_q73 = (t189 + length_6_by_q71 * length_6_by_q73) * t185;
    const double strand_6_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t174;
    const double t191 = strand_6_x * strand_6_x_by_q71_by_q71 - strand_6_y
        * layer_0_y_by_q71_by_q71;
    const double strand_6_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t177;
    const double t192 = t191 + strand_6_z * strand_6_z_by_q71_by_q71 + t148 + strand_6_x_by_q71
        * strand_6_x_by_q71;
    const double t193 = length_6_by_q71 * length_6_by_q71;
    const double length_6_by_q71_by_q71 = (t192 + strand_6_z_by_q71 * strand_6_z_by_q71 - t193)
        * t185;
    const double t194 = sum151 + f[6] * length_6_by_q71_by_q73 - k[6] * length_6_by_q71
        * length_6_by_q73;
    const double t195 = layer_0_x * layer_0_x_by_q73_by_q73 + layer_0_z * layer_0_z_by_q73_by_q73;
    const double strand_7_y = 0.018 - layer_0_y;
    const double t196 = t195 + strand_7_y * layer_0_y_by_q73_by_q73 + layer_0_x_by_q73
        * layer_0_x_by_q73;
    const double t197 = t196 + layer_0_y_by_q73 * layer_0_y_by_q73 + layer_0_z_by_q73
        * layer_0_z_by_q73;
    const double t198 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t199 = 1.0 / length_7;
    const double length_7_by_q73 = t198 * t199;
    const double t200 = length_7_by_q73 * length_7_by_q73;
    const double length_7_by_q73_by_q73 = (t197 - t200) * t199;
    const double t201 = sum152 + f[6] * length_6_by_q73_by_q73 + k[6] * t186 + f[7]
        * length_7_by_q73_by_q73;
    const double t202 = layer_0_x * layer_0_x_by_q71_by_q73 - layer_0_z * layer_0_z_by_q71_by_q73;
    const double t203 = t202 - strand_7_y * layer_0_y_by_q71_by_q73 - layer_0_x_by_q71
        * layer_0_x_by_q73;
    const double t204 = t203 - layer_0_y_by_q71 * layer_0_y_by_q73 + layer_0_z_by_q71
        * layer_0_z_by_q73;
    const double t205 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7_by_q71 = t205 * t199;
    const double length_7_by_q71_by_q73 = (t204 + length_7_by_q71 * length_7_by_q73) * t199;
    const double t206 = layer_0_x * layer_0_x_by_q71_by_q71 + layer_0_z * layer_0_z_by_q71_by_q71;
    const double t207 = t206 - strand_7_y * layer_0_y_by_q71_by_q71 + layer_0_x_by_q71
        * layer_0_x_by_q71;
    const double t208 = length_7_by_q71 * length_7_by_q71;
    const double length_7_by_q71_by_q71 = (t207 + t148 + layer_0_z_by_q71 * layer_0_z_by_q71 - t208)
        * t199;
    const double t209 = sum153 + f[6] * length_6_by_q71_by_q71 + k[6] * t193 + f[7]
        * length_7_by_q71_by_q71;
    const double t210 = t194 + f[7] * length_7_by_q71_by_q73 - k[7] * length_7_by_q71
        * length_7_by_q73;
    const double t211 = 0.013 * y_x;
    const double t212 = 0.013 * y_z;
    const double t213 = 0.013 * y_x_by_q73;
    const double t214 = 0.013 * y_z_by_q73;
    static const double table219[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    double sum216 = t210;
    double sum217 = t201 + k[7] * t200;
    double sum218 = t209 + k[7] * t208;
    for (int i215 = 0; i215 < 11; ++i215) {
        const double before220 = sum216;
        const double before221 = sum217;
        const double before222 = sum218;
        const double t223 = table219[i215][0] * y_x;
        const double strand_x_2 = layer_0_x - t223;
        const double t224 = table219[i215][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_2 = layer_0_x_by_q71_by_q73 + t224;
        const double strand_y_2 = table219[i215][1] - layer_0_y - table219[i215][0] * u_y;
        const double t225 = strand_x_2 * strand_x_by_q71_by_q73_2 - strand_y_2
            * layer_0_y_by_q71_by_q73;
        const double t226 = table219[i215][0] * y_z;
        const double strand_z_2 = layer_0_z - t226;
        const double t227 = table219[i215][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_2 = layer_0_z_by_q71_by_q73 + t227;
        const double strand_y_by_q73_2 = layer_0_y_by_q73 + table219[i215][0] * u_y_by_q73;
        const double t228 = t225 - strand_z_2 * strand_z_by_q71_by_q73_2 - layer_0_y_by_q71
            * strand_y_by_q73_2;
        const double strand_x_by_q71_2 = layer_0_x_by_q71 + t226;
        const double strand_x_by_q73_2 = layer_0_x_by_q73 + t227;
        const double strand_z_by_q71_2 = layer_0_z_by_q71 + t223;
        const double strand_z_by_q73_2 = layer_0_z_by_q73 + t224;
        const double t229 = t228 - strand_x_by_q71_2 * strand_x_by_q73_2 + strand_z_by_q71_2
            * strand_z_by_q73_2;
        const double t230 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_0_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t231 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t231);
        const double t232 = 1.0 / length_2;
        const double length_by_q71_2 = t230 * t232;
        const double t233 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t233 * t232;
        const double length_by_q71_by_q73_2 = (t229 + length_by_q71_2 * length_by_q73_2) * t232;
        const double t234 = before220 + f[8 + i215] * length_by_q71_by_q73_2 - k[8 + i215]
            * length_by_q71_2 * length_by_q73_2;
        const double strand_x_by_q73_by_q73_2 = layer_0_x_by_q73_by_q73 + table219[i215][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_2 = layer_0_y_by_q73_by_q73 + table219[i215][0]
            * u_y_by_q73_by_q73;
        const double t235 = strand_x_2 * strand_x_by_q73_by_q73_2 + strand_y_2
            * strand_y_by_q73_by_q73_2;
        const double strand_z_by_q73_by_q73_2 = layer_0_z_by_q73_by_q73 + table219[i215][0]
            * y_z_by_q73_by_q73;
        const double t236 = t235 + strand_z_2 * strand_z_by_q73_by_q73_2 + strand_x_by_q73_2
            * strand_x_by_q73_2;
        const double t237 = t236 + strand_y_by_q73_2 * strand_y_by_q73_2 + strand_z_by_q73_2
            * strand_z_by_q73_2;
        const double t238 = length_by_q73_2 * length_by_q73_2;
        const double length_by_q73_by_q73_2 = (t237 - t238) * t232;
        const double strand_x_by_q71_by_q71_2 = layer_0_x_by_q71_by_q71 + t223;
        const double t239 = strand_x_2 * strand_x_by_q71_by_q71_2 - strand_y_2
            * layer_0_y_by_q71_by_q71;
        const double strand_z_by_q71_by_q71_2 = layer_0_z_by_q71_by_q71 + t226;
        const double t240 = t239 + strand_z_2 * strand_z_by_q71_by_q71_2 + t148 + strand_x_by_q71_2
            * strand_x_by_q71_2;
        const double t241 = length_by_q71_2 * length_by_q71_2;
        const double length_by_q71_by_q71_2 = (t240 + strand_z_by_q71_2 * strand_z_by_q71_2 - t241)
            * t232;
        sum216 = t234;
        sum217 = before221 + f[8 + i215] * length_by_q73_by_q73_2 + k[8 + i215] * t238;
        sum218 = before222 + f[8 + i215] * length_by_q71_by_q71_2 + k[8 + i215] * t241;
    }
    const double layer_1_x_by_q73_by_q73 = t47 + t48;
    const double layer_1_x = t53 + t54;
    const double strand_19_x = layer_1_x + t211;
    const double layer_1_y_by_q73_by_q73 = t56 - t57;
    const double layer_1_y = t59 + t60;
    const double strand_19_y = 0.006 - layer_1_y + 0.013 * u_y;
    const double layer_1_z_by_q73_by_q73 = t62 + t63;
    const double layer_1_z = 0.028 - origin_z - t68 + t69;
    const double strand_19_z = layer_1_z + t212;
    const double layer_1_x_by_q73 = t75 - t76;
    const double strand_19_x_by_q73 = layer_1_x_by_q73 - t213;
    const double layer_1_y_by_q73 = t79 - t80;
    const double strand_19_y_by_q73 = layer_1_y_by_q73 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t85 - t86;
    const double strand_19_z_by_q73 = layer_1_z_by_q73 - t214;
    static const double table246[8][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017}};
    double sum243 = sum217;
    double kept244[8];
    double kept245[8];
    for (int i242 = 0; i242 < 8; ++i242) {
        const double before247 = sum243;
        const double strand_x_3 = layer_1_x + table246[i242][0] * y_x;
        const double strand_x_by_q73_by_q73_3 = layer_1_x_by_q73_by_q73 - table246[i242][0]
            * y_x_by_q73_by_q73;
        const double strand_y_3 = table246[i242][1] - layer_1_y + table246[i242][0] * u_y;
        const double strand_y_by_q73_by_q73_3 = layer_1_y_by_q73_by_q73 - table246[i242][0]
            * u_y_by_q73_by_q73;
        const double t248 = strand_x_3 * strand_x_by_q73_by_q73_3 + strand_y_3
            * strand_y_by_q73_by_q73_3;
        const double strand_z_3 = layer_1_z + table246[i242][0] * y_z;
        const double strand_z_by_q73_by_q73_3 = layer_1_z_by_q73_by_q73 - table246[i242][0]
            * y_z_by_q73_by_q73;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table246[i242][0] * y_x_by_q73;
        const double t249 = t248 + strand_z_3 * strand_z_by_q73_by_q73_3 + strand_x_by_q73_3
            * strand_x_by_q73_3;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table246[i242][0] * u_y_by_q73;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table246[i242][0] * y_z_by_q73;
        const double t250 = t249 + strand_y_by_q73_3 * strand_y_by_q73_3 + strand_z_by_q73_3
            * strand_z_by_q73_3;
        const double t251 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double t252 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t252);
        const double t253 = 1.0 / length_3;
        const double length_by_q73_3 = t251 * t253;
        const double t254 = length_by_q73_3 * length_by_q73_3;
        const double length_by_q73_by_q73_3 = (t250 - t254) * t253;
        sum243 = before247 + f[19 + i242] * length_by_q73_by_q73_3 + k[19 + i242] * t254;
        kept244[i242] = t253;
        kept245[i242] = length_by_q73_3;
    }
    const double layer_1_x_by_q71_by_q73 = t108 - t109;
    const double strand_19_x_by_q71_by_q73 = layer_1_x_by_q71_by_q73 - t214;
    const double layer_1_y_by_q71_by_q73 = t110 + t111;
    const double t255 = strand_19_x * strand_19_x_by_q71_by_q73 - strand_19_y
        * layer_1_y_by_q71_by_q73;
    const double layer_1_z_by_q71_by_q73 = t113 - t114;
    const double strand_19_z_by_q71_by_q73 = layer_1_z_by_q71_by_q73 - t213;
    const double layer_1_x_by_q71 = t115 - t116;
    const double strand_19_x_by_q71 = layer_1_x_by_q71 - t212;
    const double t256 = t255 - strand_19_z * strand_19_z_by_q71_by_q73 - strand_19_x_by_q71
        * strand_19_x_by_q73;
    const double layer_1_y_by_q71 = t118 + t119;
    const double layer_1_z_by_q71 = t120 - t121;
    const double strand_19_z_by_q71 = layer_1_z_by_q71 - t211;
    const double t257 = t256 - layer_1_y_by_q71 * strand_19_y_by_q73 + strand_19_z_by_q71
        * strand_19_z_by_q73;
    const double t258 = strand_19_x * strand_19_x_by_q71 - strand_19_y * layer_1_y_by_q71
        - strand_19_z * strand_19_z_by_q71;
    const double length_19_by_q71 = t258 * kept244[0];
    const double length_19_by_q71_by_q73 = (t257 + length_19_by_q71 * kept245[0]) * kept244[0];
    const double layer_1_x_by_q71_by_q71 = t138 - t139;
    const double strand_19_x_by_q71_by_q71 = layer_1_x_by_q71_by_q71 - t211;
    const double layer_1_y_by_q71_by_q71 = t140 + t141;
    const double t259 = strand_19_x * strand_19_x_by_q71_by_q71 - strand_19_y
        * layer_1_y_by_q71_by_q71;
    const double layer_1_z_by_q71_by_q71 = t145 - t146;
    const double strand_19_z_by_q71_by_q71 = layer_1_z_by_q71_by_q71 - t212;
    const double t260 = t259 + strand_19_z * strand_19_z_by_q71_by_q71 + strand_19_x_by_q71
        * strand_19_x_by_q71;
    const double t261 = layer_1_y_by_q71 * layer_1_y_by_q71;
    const double t262 = length_19_by_q71 * length_19_by_q71;
    const double length_19_by_q71_by_q71 = (t260 + t261 + strand_19_z_by_q71 * strand_19_z_by_q71
        - t262) * kept244[0];
    const double t263 = sum216 + f[19] * length_19_by_q71_by_q73 - k[19] * length_19_by_q71
        * kept245[0];
    static const double table267[6][2] = {{0.011, 0.007}, {0.01, 0.009}, {0.008, 0.011},
        {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}};
    double sum265 = t263;
    double sum266 = sum218 + f[19] * length_19_by_q71_by_q71 + k[19] * t262;
    for (int i264 = 0; i264 < 6; ++i264) {
        const double before268 = sum265;
        const double before269 = sum266;
        const double t270 = table267[i264][0] * y_x;
        const double strand_x_4 = layer_1_x + t270;
        const double t271 = table267[i264][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_3 = layer_1_x_by_q71_by_q73 - t271;
        const double strand_y_4 = table267[i264][1] - layer_1_y + table267[i264][0] * u_y;
        const double t272 = strand_x_4 * strand_x_by_q71_by_q73_3 - strand_y_4
            * layer_1_y_by_q71_by_q73;
        const double t273 = table267[i264][0] * y_z;
        const double strand_z_4 = layer_1_z + t273;
        const double t274 = table267[i264][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_3 = layer_1_z_by_q71_by_q73 - t274;
        const double strand_y_by_q73_4 = layer_1_y_by_q73 - table267[i264][0] * u_y_by_q73;
        const double t275 = t272 - strand_z_4 * strand_z_by_q71_by_q73_3 - layer_1_y_by_q71
            * strand_y_by_q73_4;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t273;
        const double strand_x_by_q73_4 = layer_1_x_by_q73 - t274;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t270;
        const double strand_z_by_q73_4 = layer_1_z_by_q73 - t271;
        const double t276 = t275 - strand_x_by_q71_3 * strand_x_by_q73_4 + strand_z_by_q71_3
            * strand_z_by_q73_4;
        const double t277 = strand_x_4 * strand_x_by_q71_3 - strand_y_4 * layer_1_y_by_q71
            - strand_z_4 * strand_z_by_q71_3;
        const double length_by_q71_3 = t277 * kept244[1 + i264];
        const double length_by_q71_by_q73_3 = (t276 + length_by_q71_3 * kept245[1 + i264])
            * kept244[1 + i264];
        const double t278 = before268 + f[20 + i264] * length_by_q71_by_q73_3 - k[20 + i264]
            * length_by_q71_3 * kept245[1 + i264];
        const double strand_x_by_q71_by_q71_3 = layer_1_x_by_q71_by_q71 - t270;
        const double t279 = strand_x_4 * strand_x_by_q71_by_q71_3 - strand_y_4
            * layer_1_y_by_q71_by_q71;
        const double strand_z_by_q71_by_q71_3 = layer_1_z_by_q71_by_q71 - t273;
        const double t280 = t279 + strand_z_4 * strand_z_by_q71_by_q71_3 + t261 + strand_x_by_q71_3
            * strand_x_by_q71_3;
        const double t281 = length_by_q71_3 * length_by_q71_3;
        const double length_by_q71_by_q71_3 = (t280 + strand_z_by_q71_3 * strand_z_by_q71_3 - t281)
            * kept244[1 + i264];
        sum265 = t278;
        sum266 = before269 + f[20 + i264] * length_by_q71_by_q71_3 + k[20 + i264] * t281;
    }
    const double strand_26_x = layer_1_x + t174;
    const double strand_26_y = 0.017 - layer_1_y + t175;
    const double strand_26_z = layer_1_z + t177;
    const double strand_26_x_by_q73 = layer_1_x_by_q73 - t178;
    const double strand_26_y_by_q73 = layer_1_y_by_q73 - t180;
    const double strand_26_z_by_q73 = layer_1_z_by_q73 - t181;
    const double strand_26_x_by_q71_by_q73 = layer_1_x_by_q71_by_q73 - t181;
    const double t282 = strand_26_x * strand_26_x_by_q71_by_q73 - strand_26_y
        * layer_1_y_by_q71_by_q73;
    const double strand_26_z_by_q71_by_q73 = layer_1_z_by_q71_by_q73 - t178;
    const double t283 = t282 - strand_26_z * strand_26_z_by_q71_by_q73 - layer_1_y_by_q71
        * strand_26_y_by_q73;
    const double strand_26_x_by_q71 = layer_1_x_by_q71 - t177;
    const double strand_26_z_by_q71 = layer_1_z_by_q71 - t174;
    const double t284 = t283 - strand_26_x_by_q71 * strand_26_x_by_q73 + strand_26_z_by_q71
        * strand_26_z_by_q73;
    const double t285 = strand_26_x * strand_26_x_by_q71 - strand_26_y * layer_1_y_by_q71
        - strand_26_z * strand_26_z_by_q71;
    const double length_26_by_q71 = t285 * kept244[7];
    const double length_26_by_q71_by_q73 = (t284 + length_26_by_q71 * kept245[7]) * kept244[7];
    const double strand_26_x_by_q71_by_q71 = layer_1_x_by_q71_by_q71 - t174;
    const double t286 = strand_26_x * strand_26_x_by_q71_by_q71 - strand_26_y
        * layer_1_y_by_q71_by_q71;
    const double strand_26_z_by_q71_by_q71 = layer_1_z_by_q71_by_q71 - t177;
    const double t287 = t286 + strand_26_z * strand_26_z_by_q71_by_q71 + t261 + strand_26_x_by_q71
        * strand_26_x_by_q71;
    const double t288 = length_26_by_q71 * length_26_by_q71;
    const double length_26_by_q71_by_q71 = (t287 + strand_26_z_by_q71 * strand_26_z_by_q71 - t288)
        * kept244[7];
    const double t289 = sum265 + f[26] * length_26_by_q71_by_q73 - k[26] * length_26_by_q71
        * kept245[7];
    const double t290 = layer_1_x * layer_1_x_by_q73_by_q73 + layer_1_z * layer_1_z_by_q73_by_q73;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t291 = t290 + strand_27_y * layer_1_y_by_q73_by_q73 + layer_1_x_by_q73
        * layer_1_x_by_q73;
    const double t292 = t291 + layer_1_y_by_q73 * layer_1_y_by_q73 + layer_1_z_by_q73
        * layer_1_z_by_q73;
    const double t293 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double t294 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t294);
    const double t295 = 1.0 / length_27;
    const double length_27_by_q73 = t293 * t295;
    const double t296 = length_27_by_q73 * length_27_by_q73;
    const double length_27_by_q73_by_q73 = (t292 - t296) * t295;
    const double t297 = layer_1_x * layer_1_x_by_q71_by_q73 - layer_1_z * layer_1_z_by_q71_by_q73;
    const double t298 = t297 - strand_27_y * layer_1_y_by_q71_by_q73 - layer_1_x_by_q71
        * layer_1_x_by_q73;
    const double t299 = t298 - layer_1_y_by_q71 * layer_1_y_by_q73 + layer_1_z_by_q71
        * layer_1_z_by_q73;
    const double t300 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double length_27_by_q71 = t300 * t295;
    const double length_27_by_q71_by_q73 = (t299 + length_27_by_q71 * length_27_by_q73) * t295;
    const double t301 = layer_1_x * layer_1_x_by_q71_by_q71 + layer_1_z * layer_1_z_by_q71_by_q71;
    const double t302 = t301 - strand_27_y * layer_1_y_by_q71_by_q71 + layer_1_x_by_q71
        * layer_1_x_by_q71;
    const double t303 = length_27_by_q71 * length_27_by_q71;
    const double length_27_by_q71_by_q71 = (t302 + t261 + layer_1_z_by_q71 * layer_1_z_by_q71
        - t303) * t295;
    const double t304 = sum266 + f[26] * length_26_by_q71_by_q71 + k[26] * t288 + f[27]
        * length_27_by_q71_by_q71;
    const double t305 = t289 + f[27] * length_27_by_q71_by_q73 - k[27] * length_27_by_q71
        * length_27_by_q73;
    static const double table310[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    double sum307 = t305;
    double sum308 = sum243 + f[27] * length_27_by_q73_by_q73 + k[27] * t296;
    double sum309 = t304 + k[27] * t303;
    for (int i306 = 0; i306 < 10; ++i306) {
        const double before311 = sum307;
        const double before312 = sum308;
        const double before313 = sum309;
        const double t314 = table310[i306][0] * y_x;
        const double strand_x_5 = layer_1_x - t314;
        const double t315 = table310[i306][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_4 = layer_1_x_by_q71_by_q73 + t315;
        const double strand_y_5 = table310[i306][1] - layer_1_y - table310[i306][0] * u_y;
        const double t316 = strand_x_5 * strand_x_by_q71_by_q73_4 - strand_y_5
            * layer_1_y_by_q71_by_q73;
        const double t317 = table310[i306][0] * y_z;
        const double strand_z_5 = layer_1_z - t317;
        const double t318 = table310[i306][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_4 = layer_1_z_by_q71_by_q73 + t318;
        const double strand_y_by_q73_5 = layer_1_y_by_q73 + table310[i306][0] * u_y_by_q73;
        const double t319 = t316 - strand_z_5 * strand_z_by_q71_by_q73_4 - layer_1_y_by_q71
            * strand_y_by_q73_5;
        const double strand_x_by_q71_4 = layer_1_x_by_q71 + t317;
        const double strand_x_by_q73_5 = layer_1_x_by_q73 + t318;
        const double strand_z_by_q71_4 = layer_1_z_by_q71 + t314;
        const double strand_z_by_q73_5 = layer_1_z_by_q73 + t315;
        const double t320 = t319 - strand_x_by_q71_4 * strand_x_by_q73_5 + strand_z_by_q71_4
            * strand_z_by_q73_5;
        const double t321 = strand_x_5 * strand_x_by_q71_4 - strand_y_5 * layer_1_y_by_q71
            - strand_z_5 * strand_z_by_q71_4;
        const double t322 = strand_x_5 * strand_x_5 + strand_y_5 * strand_y_5 + strand_z_5
            * strand_z_5;
        const double length_4 = sinew_sqrt(t322);
        const double t323 = 1.0 / length_4;
        const double length_by_q71_4 = t321 * t323;
        const double t324 = strand_x_5 * strand_x_by_q73_5 - strand_y_5 * strand_y_by_q73_5
            + strand_z_5 * strand_z_by_q73_5;
        const double length_by_q73_4 = t324 * t323;
        const double length_by_q71_by_q73_4 = (t320 + length_by_q71_4 * length_by_q73_4) * t323;
        const double t325 = before311 + f[28 + i306] * length_by_q71_by_q73_4 - k[28 + i306]
            * length_by_q71_4 * length_by_q73_4;
        const double strand_x_by_q73_by_q73_4 = layer_1_x_by_q73_by_q73 + table310[i306][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_4 = layer_1_y_by_q73_by_q73 + table310[i306][0]
            * u_y_by_q73_by_q73;
        const double t326 = strand_x_5 * strand_x_by_q73_by_q73_4 + strand_y_5
            * strand_y_by_q73_by_q73_4;
        const double strand_z_by_q73_by_q73_4 = layer_1_z_by_q73_by_q73 + table310[i306][0]
            * y_z_by_q73_by_q73;
        const double t327 = t326 + strand_z_5 * strand_z_by_q73_by_q73_4 + strand_x_by_q73_5
            * strand_x_by_q73_5;
        const double t328 = t327 + strand_y_by_q73_5 * strand_y_by_q73_5 + strand_z_by_q73_5
            * strand_z_by_q73_5;
        const double t329 = length_by_q73_4 * length_by_q73_4;
        const double length_by_q73_by_q73_4 = (t328 - t329) * t323;
        const double strand_x_by_q71_by_q71_4 = layer_1_x_by_q71_by_q71 + t314;
        const double t330 = strand_x_5 * strand_x_by_q71_by_q71_4 - strand_y_5
            * layer_1_y_by_q71_by_q71;
        const double strand_z_by_q71_by_q71_4 = layer_1_z_by_q71_by_q71 + t317;
        const double t331 = t330 + strand_z_5 * strand_z_by_q71_by_q71_4 + t261 + strand_x_by_q71_4
            * strand_x_by_q71_4;
        const double t332 = length_by_q71_4 * length_by_q71_4;
        const double length_by_q71_by_q71_4 = (t331 + strand_z_by_q71_4 * strand_z_by_q71_4 - t332)
            * t323;
        sum307 = t325;
        sum308 = before312 + f[28 + i306] * length_by_q73_by_q73_4 + k[28 + i306] * t329;
        sum309 = before313 + f[28 + i306] * length_by_q71_by_q71_4 + k[28 + i306] * t332;
    }
    K[0] = sum309;
    K[1] = sum307;
    K[2] = sum307;
    K[3] = sum308;
}
