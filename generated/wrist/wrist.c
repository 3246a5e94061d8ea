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
        const double t32 = 0.021 + 0.021 * t21 + 0.036 * (v_x * t20 - v_z * t19) - 0.074565407529229
            * (t24 * t25 + t28 * t26);
        const double t33 = 0.074565407529229 * s13;
        const double t34 = t33 * t29;
        const double t35 = 0.036 - 0.021 * t20 + 0.036 * (v_x * t21 + v_y * t19) - t34;
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
    const double cos_half_tilt_8 = sinew_sqrt(sinew_max(0.5 + 0.5 * cos_tilt_8, 1e-12));
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
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double z_plane_x = u_y * cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double M_x = cos_q71 * M_e;
    const double x_plane_x = u_y * sin_A;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double t3 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t4 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double layer_0_x = t3 - t4 + 0.011 * y_x;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t5 = 0.004 * x_z;
    const double t6 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t5 - t6 + 0.011 * y_z;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t7 = 0.004 * x_plane_y;
    const double t8 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t7 + t8 + 0.011 * u_y;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    h[0] = length_0;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double layer_1_x = t3 + t4 + 0.013 * y_x;
    const double layer_1_z = 0.028 - origin_z - t5 + t6 + 0.013 * y_z;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double layer_1_y = 0.006 - origin_y - t7 - t8 + 0.013 * u_y;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    h[19] = length_19;
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    static const double table10[18][3] = {{0.002, 0.001, 0.001}, {0.003, 0.003, 0.003},
        {0.005, 0.005, 0.004}, {0.007, 0.006, 0.006}, {0.008, 0.008, 0.008},
        {0.01, 0.009, 0.009}, {0.011, 0.011, 0.011}, {0.013, 0.013, 0.012},
        {0.015, 0.014, 0.014}, {0.016, 0.016, 0.016}, {0.018, 0.017, 0.017},
        {0.019, 0.019, 0.019}, {0.021, 0.021, 0.02}, {0.023, 0.022, 0.022},
        {0.024, 0.024, 0.024}, {0.026, 0.025, 0.025}, {0.027, 0.027, 0.027},
        {0.029, 0.029, 0.028}};
    for (int i9 = 0; i9 < 18; ++i9) {
        const double across_slope = twice_across_8 - table10[i9][0] * twice_across_4;
        const double across_2 = twice_across_6 - table10[i9][0] * across_slope;
        const double strand_y = table10[i9][1] + layer_1_y - table10[i9][0] * u_y;
        const double length = sinew_sqrt(across_2 + strand_y * strand_y);
        const double across_3 = twice_across - table10[i9][1] * (twice_across_2 - table10[i9][1]
            * twice_across_4);
        const double strand_y_2 = table10[i9][2] + layer_0_y - table10[i9][1] * u_y;
        const double length_2 = sinew_sqrt(across_3 + strand_y_2 * strand_y_2);
        h[20 + i9] = length;
        h[1 + i9] = length_2;
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
    const double y_z = sin_q71 * u_e;
    const double t34 = 0.011 * y_z;
    const double layer_0_x_by_q71 = t32 + t33 - t34;
    const double t35 = cos_q71 * z_plane_x;
    const double t36 = sin_q71 * sin_A;
    const double z_x = t35 - t36;
    const double M_x = cos_q71 * M_e;
    const double t37 = cos_q71 * x_plane_x;
    const double t38 = sin_q71 * cos_A;
    const double x_x = t37 + t38;
    const double t39 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t40 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double t41 = 0.011 * y_x;
    const double layer_0_x = t39 - t40 + t41;
    const double z_z_by_q71 = t35 + cos_q71 * sin_A_by_q71 - t36 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t37 - cos_q71 * cos_A_by_q71 + t38 + sin_q71 * x_plane_x_by_q71;
    const double t42 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t43 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t42 + t43 - t41;
    const double z_z = t27 + t28;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t30 - t31;
    const double t44 = 0.004 * x_z;
    const double t45 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t44 - t45 + t34;
    const double across_by_q71 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t46 = origin_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
    const double t47 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t46 - t47;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t48 = 0.004 * x_plane_y;
    const double t49 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t48 + t49 + 0.011 * u_y;
    const double half_square_by = across_by_q71 - layer_0_y * layer_0_y_by_q71;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double t50 = 1.0 / length_0;
    const double length_0_by_q71 = half_square_by * t50;
    P[0] = length_0_by_q71;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    const double u_e_by_q73 = t4 + 23.80952380952381 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double reach_squared_by_q73 = sinew_choose(t11, t8 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t16 * p_x_by_q73;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t12;
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
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t53 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t54 = 0.01 * z_x_by_q73;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double layer_0_x_by_q73 = t53 + t54 - 0.011 * y_x_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t55 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t56 = 0.01 * z_z_by_q73;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double layer_0_z_by_q73 = t55 + t56 - 0.011 * y_z_by_q73;
    const double across_by_q73 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t57 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t58 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t57 + t58 - 0.011 * u_y_by_q73;
    const double half_square_by_76 = across_by_q73 - layer_0_y * layer_0_y_by_q73;
    const double length_0_by_q73 = half_square_by_76 * t50;
    P[1] = -length_0_by_q73;
    const double across_by_y_by_q71 = y_x * (layer_0_z + layer_0_x_by_q71) - y_z * (layer_0_x
        + layer_0_z_by_q71);
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double across_by_y_by_q73 = y_x * layer_0_x_by_q73 + y_z * layer_0_z_by_q73 - layer_0_x
        * y_x_by_q73 - layer_0_z * y_z_by_q73;
    const double across_by_y_squared_by_q73 = y_x * y_x_by_q73 + y_z * y_z_by_q73;
    const double t59 = 0.013 * y_z;
    const double layer_1_x_by_q71 = t32 - t33 - t59;
    const double t60 = 0.013 * y_x;
    const double layer_1_x = t39 + t40 + t60;
    const double layer_1_z_by_q71 = t42 - t43 - t60;
    const double layer_1_z = 0.028 - origin_z - t44 + t45 + t59;
    const double across_38_by_q71 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71;
    const double layer_1_y_by_q71 = t46 + t47;
    const double layer_1_y = 0.006 - origin_y - t48 - t49 + 0.013 * u_y;
    const double half_square_by_38 = across_38_by_q71 - layer_1_y * layer_1_y_by_q71;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double t61 = 1.0 / length_19;
    const double length_19_by_q71 = half_square_by_38 * t61;
    P[38] = length_19_by_q71;
    const double layer_1_x_by_q73 = t53 - t54 - 0.013 * y_x_by_q73;
    const double layer_1_z_by_q73 = t55 - t56 - 0.013 * y_z_by_q73;
    const double across_38_by_q73 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73;
    const double layer_1_y_by_q73 = t57 - t58 - 0.013 * u_y_by_q73;
    const double half_square_by_114 = across_38_by_q73 - layer_1_y * layer_1_y_by_q73;
    const double length_19_by_q73 = half_square_by_114 * t61;
    P[39] = -length_19_by_q73;
    const double across_by_y_2_by_q71 = y_x * (layer_1_z + layer_1_x_by_q71) - y_z * (layer_1_x
        + layer_1_z_by_q71);
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double across_by_y_2_by_q73 = y_x * layer_1_x_by_q73 + y_z * layer_1_z_by_q73 - layer_1_x
        * y_x_by_q73 - layer_1_z * y_z_by_q73;
    static const double table63[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i62 = 0; i62 < 18; ++i62) {
        const double across_2 = across_by_q71 - table63[i62][0] * across_by_y_by_q71;
        const double strand_y = table63[i62][1] + layer_0_y - table63[i62][0] * u_y;
        const double half_square_by_2 = across_2 - strand_y * layer_0_y_by_q71;
        const double across_3 = twice_across - table63[i62][0] * (twice_across_2 - table63[i62][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        const double t64 = 1.0 / length;
        const double length_by_q71 = half_square_by_2 * t64;
        const double across_slope = across_by_y_by_q73 + table63[i62][0]
            * across_by_y_squared_by_q73;
        const double across_4 = across_by_q73 - table63[i62][0] * across_slope;
        const double half_square_by_3 = across_4 - strand_y * (layer_0_y_by_q73 + table63[i62][0]
            * u_y_by_q73);
        const double length_by_q73 = half_square_by_3 * t64;
        P[2 + 2 * i62] = length_by_q71;
        P[3 + 2 * i62] = -length_by_q73;
    }
    static const double table66[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i65 = 0; i65 < 18; ++i65) {
        const double across_5 = across_38_by_q71 - table66[i65][0] * across_by_y_2_by_q71;
        const double strand_y_2 = table66[i65][1] + layer_1_y - table66[i65][0] * u_y;
        const double half_square_by_4 = across_5 - strand_y_2 * layer_1_y_by_q71;
        const double across_slope_2 = twice_across_8 - table66[i65][0] * twice_across_4;
        const double across_6 = twice_across_6 - table66[i65][0] * across_slope_2;
        const double length_2 = sinew_sqrt(across_6 + strand_y_2 * strand_y_2);
        const double t67 = 1.0 / length_2;
        const double length_by_q71_2 = half_square_by_4 * t67;
        const double across_slope_3 = across_by_y_2_by_q73 + table66[i65][0]
            * across_by_y_squared_by_q73;
        const double across_7 = across_38_by_q73 - table66[i65][0] * across_slope_3;
        const double strand_y_by = layer_1_y_by_q73 + table66[i65][0] * u_y_by_q73;
        const double half_square_by_5 = across_7 - strand_y_2 * strand_y_by;
        const double length_by_q73_2 = half_square_by_5 * t67;
        P[40 + 2 * i65] = length_by_q71_2;
        P[41 + 2 * i65] = -length_by_q73_2;
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
    const double y_x = cos_q71 * u_e;
    const double t55 = 0.011 * y_x;
    const double layer_0_x_by_q71_by_q71 = t53 + t54 - t55;
    const double z_x = t41 - t43;
    const double x_x = t50 + t51;
    const double t56 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t57 = 0.01 * z_x;
    const double layer_0_x = t56 - t57 + t55;
    const double t58 = cos_q71 * sin_A;
    const double t59 = sin_q71 * z_plane_x;
    const double t60 = t58 - cos_q71 * sin_A_by_q71_by_q71 + t59 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t60 - t48 * z_plane_x_by_q71 + t49 * sin_A_by_q71;
    const double M_z = sin_q71 * M_e;
    const double origin_z_by_q71_by_q71 = M_z - 0.018 * z_z_by_q71_by_q71;
    const double t61 = cos_q71 * cos_A;
    const double t62 = sin_q71 * x_plane_x;
    const double t63 = t61 - cos_q71 * cos_A_by_q71_by_q71 - t62 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t63 + t48 * x_plane_x_by_q71 + t49 * cos_A_by_q71;
    const double t64 = origin_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t65 = 0.01 * z_z_by_q71_by_q71;
    const double y_z = sin_q71 * u_e;
    const double t66 = 0.011 * y_z;
    const double layer_0_z_by_q71_by_q71 = t64 + t65 - t66;
    const double z_z = t58 + t59;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t61 - t62;
    const double t67 = 0.004 * x_z;
    const double t68 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t67 - t68 + t66;
    const double t69 = layer_0_x * layer_0_x_by_q71_by_q71 + layer_0_z * layer_0_z_by_q71_by_q71;
    const double z_x_by_q71 = t58 - cos_q71 * z_plane_x_by_q71 + t59 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_x_by_q71 = t61 + cos_q71 * x_plane_x_by_q71 - t62 + sin_q71 * cos_A_by_q71;
    const double t70 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t71 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t70 + t71 - t66;
    const double z_z_by_q71 = t41 + cos_q71 * sin_A_by_q71 - t43 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t50 - cos_q71 * cos_A_by_q71 + t51 + sin_q71 * x_plane_x_by_q71;
    const double t72 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t73 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t72 + t73 - t55;
    const double across_by_q71_by_q71 = t69 + layer_0_x_by_q71 * layer_0_x_by_q71 + layer_0_z_by_q71
        * layer_0_z_by_q71;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t74 = 0.004 * u_e;
    const double t75 = origin_y_by_q71_by_q71 + t74 * sin_A_by_q71_by_q71;
    const double t76 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t75 - t76;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t77 = 0.004 * x_plane_y;
    const double t78 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t77 + t78 + 0.011 * u_y;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t79 = origin_y_by_q71 + t74 * sin_A_by_q71;
    const double t80 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t79 - t80;
    const double t81 = layer_0_y_by_q71 * layer_0_y_by_q71;
    const double across_by_q71 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71;
    const double half_square_by = across_by_q71 - layer_0_y * layer_0_y_by_q71;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double t82 = 1.0 / length_0;
    const double length_0_by_q71 = half_square_by * t82;
    const double curvature = across_by_q71_by_q71 - layer_0_y * layer_0_y_by_q71_by_q71 + t81
        - length_0_by_q71 * length_0_by_q71;
    H[0] = curvature * t82;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t83 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t83;
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
    const double t84 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t12, t8 * p_y_by_q71_by_q73 - t36
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t84) * t13;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t17
        * p_z * u_e_by_q73 - t31 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t19, -(reach_by_q71_by_q73 * t15
        - projection_by_q71_by_q73 * t16), reach_by_q71_by_q73);
    const double t85 = t21 * reach_by_q71_by_q73 - t20 * limited_by_q71_by_q73 + t84 - t27
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t24, t85, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t26 * root_by_q73) * t25;
    const double t86 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t87 = t86 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t88 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t88 * t35;
    const double t89 = t87 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t89 * t35;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t90 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t90 * t35;
    const double t91 = cos_q71 * sin_A_by_q73;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t92 = sin_q71 * z_plane_x_by_q73;
    const double t93 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t94 = t93 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t95 = t94 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t95 * t35;
    const double z_x_by_q71_by_q73 = t91 - cos_q71 * z_plane_x_by_q71_by_q73 + t92 + sin_q71
        * sin_A_by_q71_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_x_by_q71_by_q73 = M_z_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double t96 = cos_q71 * cos_A_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t97 = sin_q71 * x_plane_x_by_q73;
    const double x_x_by_q71_by_q73 = t96 + cos_q71 * x_plane_x_by_q71_by_q73 - t97 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t98 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t99 = 0.01 * z_x_by_q71_by_q73;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t100 = 0.011 * y_z_by_q73;
    const double layer_0_x_by_q71_by_q73 = t98 + t99 - t100;
    const double t101 = cos_q71 * z_plane_x_by_q73;
    const double t102 = sin_q71 * sin_A_by_q73;
    const double z_z_by_q71_by_q73 = t101 + cos_q71 * sin_A_by_q71_by_q73 - t102 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_z_by_q71_by_q73 = M_x_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double t103 = cos_q71 * x_plane_x_by_q73;
    const double t104 = sin_q71 * cos_A_by_q73;
    const double x_z_by_q71_by_q73 = t103 - cos_q71 * cos_A_by_q71_by_q73 + t104 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t105 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t106 = 0.01 * z_z_by_q71_by_q73;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double t107 = 0.011 * y_x_by_q73;
    const double layer_0_z_by_q71_by_q73 = t105 + t106 - t107;
    const double t108 = layer_0_x * layer_0_x_by_q71_by_q73 - layer_0_z * layer_0_z_by_q71_by_q73;
    const double z_x_by_q73 = t101 - t102;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_x_by_q73 = t103 + t104;
    const double t109 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t110 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t109 + t110 - t107;
    const double z_z_by_q73 = t91 + t92;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = t96 - t97;
    const double t111 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t112 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t111 + t112 - t100;
    const double across_by_q71_by_q73 = t108 - layer_0_x_by_q71 * layer_0_x_by_q73
        + layer_0_z_by_q71 * layer_0_z_by_q73;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t113 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t114 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t113 - t114;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t115 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t116 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t115 + t116 - 0.011 * u_y_by_q73;
    const double t117 = across_by_q71_by_q73 - layer_0_y * layer_0_y_by_q71_by_q73
        - layer_0_y_by_q71 * layer_0_y_by_q73;
    const double across_by_q73 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73;
    const double half_square_by_76 = across_by_q73 - layer_0_y * layer_0_y_by_q73;
    const double length_0_by_q73 = half_square_by_76 * t82;
    const double curvature_76 = t117 + length_0_by_q71 * length_0_by_q73;
    const double t118 = curvature_76 * t82;
    H[1] = t118;
    H[2] = t118;
    const double t119 = reach_by_q73 * reach_by_q73;
    const double t120 = t119 + t119;
    const double t121 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t121 * t2;
    const double C_y_by_q73_by_q73 = t83 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t122 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t123 = u_e_by_q73 + u_e_by_q73;
    const double t124 = u_y_by_q73 + u_y_by_q73;
    const double p_y_by_q73_by_q73 = t122 - s_y * u_e_by_q73_by_q73 + t123 * M_y_by_q73 - t124
        * M_e_by_q73;
    const double t125 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t12, t125 * p_y_by_q73 + t8
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t120) * t13;
    const double t126 = t120 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t21
        * reach_by_q73_by_q73;
    const double t127 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t128 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t128 - s_y * u_y_by_q73_by_q73 - t123 * M_e_by_q73 - t124
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t127 - t17 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t19, -(reach_by_q73_by_q73 * t15
        - projection_by_q73_by_q73 * t16), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t24, t126 - t20 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t129 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t129 * t25;
    const double t130 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t131 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t132 = t130 - sin_A * reach_squared_by_q73_by_q73 + t125 * root_by_q73 - t131
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t132 * t35;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t124 * sin_A_by_q73;
    const double t133 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t134 = t133 - cos_A * reach_squared_by_q73_by_q73 + t125 * limited_by_q73 - t131
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t134 * t35;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t124 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t135 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t136 = 0.01 * z_x_by_q73_by_q73;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t135 - t136 - 0.011 * y_x_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t137 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t138 = 0.01 * z_z_by_q73_by_q73;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t137 - t138 - 0.011 * y_z_by_q73_by_q73;
    const double t139 = layer_0_x * layer_0_x_by_q73_by_q73 + layer_0_z * layer_0_z_by_q73_by_q73;
    const double across_by_q73_by_q73 = t139 + layer_0_x_by_q73 * layer_0_x_by_q73
        + layer_0_z_by_q73 * layer_0_z_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t123 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t123 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t140 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t141 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t140 + t141 - 0.011 * u_y_by_q73_by_q73;
    const double t142 = across_by_q73_by_q73 + layer_0_y * layer_0_y_by_q73_by_q73
        + layer_0_y_by_q73 * layer_0_y_by_q73;
    const double curvature_152 = t142 - length_0_by_q73 * length_0_by_q73;
    H[3] = curvature_152 * t82;
    const double t143 = y_x * layer_0_x;
    const double t144 = y_z * layer_0_z;
    const double t145 = t143 - y_x * layer_0_x_by_q71_by_q71 + t144 - y_z * layer_0_z_by_q71_by_q71;
    const double t146 = y_x + y_x;
    const double t147 = y_z + y_z;
    const double across_by_y_by_q71_by_q71 = t145 + t146 * layer_0_z_by_q71 + t147
        * layer_0_x_by_q71;
    const double t148 = y_x * y_x;
    const double t149 = y_z * y_z;
    const double t150 = t148 + t149;
    const double across_by_y_squared_by_q71_by_q71 = t150 - t148 - t149;
    const double t151 = layer_0_z + layer_0_x_by_q71;
    const double t152 = layer_0_x + layer_0_z_by_q71;
    const double across_by_y_by_q71 = y_x * t151 - y_z * t152;
    const double across_by_y = t143 + t144;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across_by_y_squared = 0.5 * t150;
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double t153 = y_z_by_q73 * t152 - y_x_by_q73 * t151 + y_z * (layer_0_z_by_q71_by_q73
        - layer_0_x_by_q73);
    const double across_by_y_by_q71_by_q73 = t153 + y_x * (layer_0_z_by_q73
        - layer_0_x_by_q71_by_q73);
    const double across_by_y_by_q73 = y_x * layer_0_x_by_q73 + y_z * layer_0_z_by_q73 - layer_0_x
        * y_x_by_q73 - layer_0_z * y_z_by_q73;
    const double across_by_y_squared_by_q73 = y_x * y_x_by_q73 + y_z * y_z_by_q73;
    const double t154 = y_x * layer_0_x_by_q73_by_q73 + y_z * layer_0_z_by_q73_by_q73 - layer_0_x
        * y_x_by_q73_by_q73;
    const double t155 = y_x_by_q73 + y_x_by_q73;
    const double t156 = y_z_by_q73 + y_z_by_q73;
    const double across_by_y_by_q73_by_q73 = t154 - layer_0_z * y_z_by_q73_by_q73 - t155
        * layer_0_x_by_q73 - t156 * layer_0_z_by_q73;
    const double t157 = y_x * y_x_by_q73_by_q73 + y_z * y_z_by_q73_by_q73 - y_x_by_q73 * y_x_by_q73;
    const double across_by_y_squared_by_q73_by_q73 = t157 - y_z_by_q73 * y_z_by_q73;
    const double t158 = 0.013 * y_x;
    const double layer_1_x_by_q71_by_q71 = t53 - t54 - t158;
    const double layer_1_x = t56 + t57 + t158;
    const double t159 = 0.013 * y_z;
    const double layer_1_z_by_q71_by_q71 = t64 - t65 - t159;
    const double layer_1_z = 0.028 - origin_z - t67 + t68 + t159;
    const double t160 = layer_1_x * layer_1_x_by_q71_by_q71 + layer_1_z * layer_1_z_by_q71_by_q71;
    const double layer_1_x_by_q71 = t70 - t71 - t159;
    const double layer_1_z_by_q71 = t72 - t73 - t158;
    const double across_38_by_q71_by_q71 = t160 + layer_1_x_by_q71 * layer_1_x_by_q71
        + layer_1_z_by_q71 * layer_1_z_by_q71;
    const double layer_1_y_by_q71_by_q71 = t75 + t76;
    const double layer_1_y = 0.006 - origin_y - t77 - t78 + 0.013 * u_y;
    const double layer_1_y_by_q71 = t79 + t80;
    const double t161 = layer_1_y_by_q71 * layer_1_y_by_q71;
    const double across_38_by_q71 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71;
    const double half_square_by_38 = across_38_by_q71 - layer_1_y * layer_1_y_by_q71;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double t162 = 1.0 / length_19;
    const double length_19_by_q71 = half_square_by_38 * t162;
    const double curvature_38 = across_38_by_q71_by_q71 - layer_1_y * layer_1_y_by_q71_by_q71 + t161
        - length_19_by_q71 * length_19_by_q71;
    H[76] = curvature_38 * t162;
    const double t163 = 0.013 * y_z_by_q73;
    const double layer_1_x_by_q71_by_q73 = t98 - t99 - t163;
    const double t164 = 0.013 * y_x_by_q73;
    const double layer_1_z_by_q71_by_q73 = t105 - t106 - t164;
    const double t165 = layer_1_x * layer_1_x_by_q71_by_q73 - layer_1_z * layer_1_z_by_q71_by_q73;
    const double layer_1_x_by_q73 = t109 - t110 - t164;
    const double layer_1_z_by_q73 = t111 - t112 - t163;
    const double across_38_by_q71_by_q73 = t165 - layer_1_x_by_q71 * layer_1_x_by_q73
        + layer_1_z_by_q71 * layer_1_z_by_q73;
    const double layer_1_y_by_q71_by_q73 = t113 + t114;
    const double layer_1_y_by_q73 = t115 - t116 - 0.013 * u_y_by_q73;
    const double t166 = across_38_by_q71_by_q73 - layer_1_y * layer_1_y_by_q71_by_q73
        - layer_1_y_by_q71 * layer_1_y_by_q73;
    const double across_38_by_q73 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73;
    const double half_square_by_114 = across_38_by_q73 - layer_1_y * layer_1_y_by_q73;
    const double length_19_by_q73 = half_square_by_114 * t162;
    const double curvature_114 = t166 + length_19_by_q71 * length_19_by_q73;
    const double t167 = curvature_114 * t162;
    H[77] = t167;
    H[78] = t167;
    const double layer_1_x_by_q73_by_q73 = t135 + t136 - 0.013 * y_x_by_q73_by_q73;
    const double layer_1_z_by_q73_by_q73 = t137 + t138 - 0.013 * y_z_by_q73_by_q73;
    const double t168 = layer_1_x * layer_1_x_by_q73_by_q73 + layer_1_z * layer_1_z_by_q73_by_q73;
    const double across_38_by_q73_by_q73 = t168 + layer_1_x_by_q73 * layer_1_x_by_q73
        + layer_1_z_by_q73 * layer_1_z_by_q73;
    const double layer_1_y_by_q73_by_q73 = t140 - t141 - 0.013 * u_y_by_q73_by_q73;
    const double t169 = across_38_by_q73_by_q73 + layer_1_y * layer_1_y_by_q73_by_q73
        + layer_1_y_by_q73 * layer_1_y_by_q73;
    const double curvature_190 = t169 - length_19_by_q73 * length_19_by_q73;
    H[79] = curvature_190 * t162;
    const double t170 = y_x * layer_1_x;
    const double t171 = y_z * layer_1_z;
    const double t172 = t170 - y_x * layer_1_x_by_q71_by_q71 + t171 - y_z * layer_1_z_by_q71_by_q71;
    const double across_by_y_2_by_q71_by_q71 = t172 + t146 * layer_1_z_by_q71 + t147
        * layer_1_x_by_q71;
    const double t173 = layer_1_z + layer_1_x_by_q71;
    const double t174 = layer_1_x + layer_1_z_by_q71;
    const double across_by_y_2_by_q71 = y_x * t173 - y_z * t174;
    const double across_by_y_2 = t170 + t171;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double t175 = y_z_by_q73 * t174 - y_x_by_q73 * t173 + y_z * (layer_1_z_by_q71_by_q73
        - layer_1_x_by_q73);
    const double across_by_y_2_by_q71_by_q73 = t175 + y_x * (layer_1_z_by_q73
        - layer_1_x_by_q71_by_q73);
    const double across_by_y_2_by_q73 = y_x * layer_1_x_by_q73 + y_z * layer_1_z_by_q73 - layer_1_x
        * y_x_by_q73 - layer_1_z * y_z_by_q73;
    const double t176 = y_x * layer_1_x_by_q73_by_q73 + y_z * layer_1_z_by_q73_by_q73 - layer_1_x
        * y_x_by_q73_by_q73;
    const double across_by_y_2_by_q73_by_q73 = t176 - layer_1_z * y_z_by_q73_by_q73 - t155
        * layer_1_x_by_q73 - t156 * layer_1_z_by_q73;
    static const double table178[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i177 = 0; i177 < 18; ++i177) {
        const double across_slope = across_by_y_by_q71_by_q71 - table178[i177][0]
            * across_by_y_squared_by_q71_by_q71;
        const double across_2 = across_by_q71_by_q71 + table178[i177][0] * across_slope;
        const double strand_y = table178[i177][1] + layer_0_y - table178[i177][0] * u_y;
        const double across_3 = across_by_q71 - table178[i177][0] * across_by_y_by_q71;
        const double half_square_by_2 = across_3 - strand_y * layer_0_y_by_q71;
        const double t179 = table178[i177][0] * (twice_across_2 - table178[i177][0]
            * twice_across_4);
        const double across_4 = twice_across - t179;
        const double length = sinew_sqrt(across_4 + strand_y * strand_y);
        const double t180 = 1.0 / length;
        const double length_by_q71 = half_square_by_2 * t180;
        const double curvature_2 = across_2 - strand_y * layer_0_y_by_q71_by_q71 + t81
            - length_by_q71 * length_by_q71;
        const double across_5 = across_by_q71_by_q73 + table178[i177][0]
            * across_by_y_by_q71_by_q73;
        const double t181 = layer_0_y_by_q73 + table178[i177][0] * u_y_by_q73;
        const double across_slope_2 = across_by_y_by_q73 + table178[i177][0]
            * across_by_y_squared_by_q73;
        const double across_6 = across_by_q73 - table178[i177][0] * across_slope_2;
        const double half_square_by_3 = across_6 - strand_y * t181;
        const double length_by_q73 = half_square_by_3 * t180;
        const double curvature_3 = across_5 - strand_y * layer_0_y_by_q71_by_q73 - layer_0_y_by_q71
            * t181 + length_by_q71 * length_by_q73;
        const double t182 = curvature_3 * t180;
        const double across_slope_3 = across_by_y_by_q73_by_q73 + table178[i177][0]
            * across_by_y_squared_by_q73_by_q73;
        const double across_7 = across_by_q73_by_q73 - table178[i177][0] * across_slope_3;
        const double strand_y_by = layer_0_y_by_q73_by_q73 + table178[i177][0] * u_y_by_q73_by_q73;
        const double curvature_4 = across_7 + strand_y * strand_y_by + t181 * t181 - length_by_q73
            * length_by_q73;
        H[4 + 4 * i177] = curvature_2 * t180;
        H[5 + 4 * i177] = t182;
        H[6 + 4 * i177] = t182;
        H[7 + 4 * i177] = curvature_4 * t180;
    }
    static const double table184[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i183 = 0; i183 < 18; ++i183) {
        const double across_slope_4 = across_by_y_2_by_q71_by_q71 - table184[i183][0]
            * across_by_y_squared_by_q71_by_q71;
        const double across_8 = across_38_by_q71_by_q71 + table184[i183][0] * across_slope_4;
        const double strand_y_2 = table184[i183][1] + layer_1_y - table184[i183][0] * u_y;
        const double across_9 = across_38_by_q71 - table184[i183][0] * across_by_y_2_by_q71;
        const double half_square_by_4 = across_9 - strand_y_2 * layer_1_y_by_q71;
        const double across_slope_5 = twice_across_8 - table184[i183][0] * twice_across_4;
        const double across_10 = twice_across_6 - table184[i183][0] * across_slope_5;
        const double length_2 = sinew_sqrt(across_10 + strand_y_2 * strand_y_2);
        const double t185 = 1.0 / length_2;
        const double length_by_q71_2 = half_square_by_4 * t185;
        const double curvature_5 = across_8 - strand_y_2 * layer_1_y_by_q71_by_q71 + t161
            - length_by_q71_2 * length_by_q71_2;
        const double across_11 = across_38_by_q71_by_q73 + table184[i183][0]
            * across_by_y_2_by_q71_by_q73;
        const double strand_y_by_2 = layer_1_y_by_q73 + table184[i183][0] * u_y_by_q73;
        const double t186 = across_11 - strand_y_2 * layer_1_y_by_q71_by_q73 - layer_1_y_by_q71
            * strand_y_by_2;
        const double across_slope_6 = across_by_y_2_by_q73 + table184[i183][0]
            * across_by_y_squared_by_q73;
        const double across_12 = across_38_by_q73 - table184[i183][0] * across_slope_6;
        const double half_square_by_5 = across_12 - strand_y_2 * strand_y_by_2;
        const double length_by_q73_2 = half_square_by_5 * t185;
        const double curvature_6 = t186 + length_by_q71_2 * length_by_q73_2;
        const double t187 = curvature_6 * t185;
        const double across_slope_7 = across_by_y_2_by_q73_by_q73 + table184[i183][0]
            * across_by_y_squared_by_q73_by_q73;
        const double across_13 = across_38_by_q73_by_q73 - table184[i183][0] * across_slope_7;
        const double strand_y_by_3 = layer_1_y_by_q73_by_q73 + table184[i183][0]
            * u_y_by_q73_by_q73;
        const double curvature_7 = across_13 + strand_y_2 * strand_y_by_3 + strand_y_by_2
            * strand_y_by_2 - length_by_q73_2 * length_by_q73_2;
        H[80 + 4 * i183] = curvature_5 * t185;
        H[81 + 4 * i183] = t187;
        H[82 + 4 * i183] = t187;
        H[83 + 4 * i183] = curvature_7 * t185;
    }
}

void wrist_bending_angles(double q71, double q73, double angles[SINEW_AT_LEAST(38)])
{
    double pose_T[16];
    wrist_pose(q71, q73, pose_T);
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q73, q71);
    const double sin_q73 = sines1.s[0];
    const double cos_q73 = sines1.c[0];
    const double cos_q71 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double ratio = 0.003796 / B_to_C0_squared;
    const double B_e = 0.074565407529229 * sin_q73;
    const double C_e = B_e * ratio;
    const double M_e = 0.5 * (B_e + C_e);
    const double t3 = -pose_T[8];
    const double t4 = 0.004 * t3;
    const double t5 = 0.01 * pose_T[10];
    const double layer_0_z = 0.008 - pose_T[11] - t4 - t5 + 0.011 * pose_T[9];
    const double M_x = cos_q71 * M_e;
    const double t6 = 0.004 - M_x + 0.018 * pose_T[2] + 0.004 * pose_T[0];
    const double t7 = 0.01 * pose_T[2];
    const double layer_0_x = t6 - t7 + 0.011 * pose_T[1];
    const double aside_y = pose_T[0] * layer_0_z + t3 * layer_0_x;
    const double t8 = -pose_T[4];
    const double t9 = 0.004 * t8;
    const double t10 = 0.01 * -pose_T[6];
    const double layer_0_y = 0.007 - pose_T[7] - t9 + t10 + 0.011 * pose_T[5];
    const double aside_x = t8 * layer_0_z - t3 * layer_0_y;
    const double aside_z_2 = t8 * layer_0_x + pose_T[0] * layer_0_y;
    const double t11 = sinew_sqrt(aside_x * aside_x + aside_y * aside_y + aside_z_2 * aside_z_2);
    const double t12 = sinew_one_atan2(t11, t8 * layer_0_y - pose_T[0] * layer_0_x + t3
        * layer_0_z);
    const double t13 = sinew_one_atan2(sinew_sqrt(layer_0_y * layer_0_y + layer_0_z * layer_0_z),
        -layer_0_x);
    angles[0] = t12 + t13;
    const double layer_1_z = 0.028 - pose_T[11] - t4 + t5 + 0.013 * pose_T[9];
    const double layer_1_x = t6 + t7 + 0.013 * pose_T[1];
    const double aside_y_38 = pose_T[0] * layer_1_z + t3 * layer_1_x;
    const double layer_1_y = 0.006 - pose_T[7] - t9 - t10 + 0.013 * pose_T[5];
    const double aside_x_38 = t8 * layer_1_z - t3 * layer_1_y;
    const double aside_z_78 = t8 * layer_1_x + pose_T[0] * layer_1_y;
    const double t14 = aside_x_38 * aside_x_38 + aside_y_38 * aside_y_38 + aside_z_78 * aside_z_78;
    const double t15 = sinew_one_atan2(sinew_sqrt(t14), t8 * layer_1_y - pose_T[0] * layer_1_x + t3
        * layer_1_z);
    const double t16 = sinew_one_atan2(sinew_sqrt(layer_1_y * layer_1_y + layer_1_z * layer_1_z),
        -layer_1_x);
    angles[19] = t15 + t16;
    static const double table18[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i17 = 0; i17 < 18; ++i17) {
        const double strand_z = layer_0_z - table18[i17][0] * pose_T[9];
        const double strand_y = table18[i17][1] + layer_0_y - table18[i17][0] * pose_T[5];
        const double aside_x_2 = t8 * strand_z - t3 * strand_y;
        const double strand_x = layer_0_x - table18[i17][0] * pose_T[1];
        const double aside_y_2 = pose_T[0] * strand_z + t3 * strand_x;
        const double aside_z = t8 * strand_x + pose_T[0] * strand_y;
        const double t19 = sinew_sqrt(aside_x_2 * aside_x_2 + aside_y_2 * aside_y_2 + aside_z
            * aside_z);
        const double t20 = sinew_one_atan2(t19, t8 * strand_y - pose_T[0] * strand_x + t3
            * strand_z);
        const double t21 = sinew_one_atan2(sinew_sqrt(strand_y * strand_y + strand_z * strand_z),
            -strand_x);
        angles[1 + i17] = t20 + t21;
    }
    static const double table23[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i22 = 0; i22 < 18; ++i22) {
        const double strand_z_2 = layer_1_z - table23[i22][0] * pose_T[9];
        const double strand_y_2 = table23[i22][1] + layer_1_y - table23[i22][0] * pose_T[5];
        const double aside_x_3 = t8 * strand_z_2 - t3 * strand_y_2;
        const double strand_x_2 = layer_1_x - table23[i22][0] * pose_T[1];
        const double aside_y_3 = pose_T[0] * strand_z_2 + t3 * strand_x_2;
        const double aside_z_3 = t8 * strand_x_2 + pose_T[0] * strand_y_2;
        const double t24 = sinew_sqrt(aside_x_3 * aside_x_3 + aside_y_3 * aside_y_3 + aside_z_3
            * aside_z_3);
        const double t25 = sinew_one_atan2(t24, t8 * strand_y_2 - pose_T[0] * strand_x_2 + t3
            * strand_z_2);
        const double t26 = sinew_one_atan2(sinew_sqrt(strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2), -strand_x_2);
        angles[20 + i22] = t25 + t26;
    }
}

void wrist_feedforward(double q71, double q73, double delta_theta[SINEW_AT_LEAST(38)])
{
    double tendon_lengths_h[38];
    wrist_tendon_lengths(q71, q73, tendon_lengths_h);
    const double change_0 = 0.04661544808322666 - tendon_lengths_h[0];
    delta_theta[0] = 200.0 * change_0;
    const double change_1 = 0.04661544808322666 - tendon_lengths_h[1];
    delta_theta[1] = 200.0 * change_1;
    const double change_2 = 0.04661544808322666 - tendon_lengths_h[2];
    delta_theta[2] = 200.0 * change_2;
    const double change_3 = 0.04669047011971501 - tendon_lengths_h[3];
    delta_theta[3] = 200.0 * change_3;
    const double change_4 = 0.04661544808322666 - tendon_lengths_h[4];
    delta_theta[4] = 200.0 * change_4;
    const double change_5 = 0.04661544808322666 - tendon_lengths_h[5];
    delta_theta[5] = 200.0 * change_5;
    const double change_6 = 0.04661544808322666 - tendon_lengths_h[6];
    delta_theta[6] = 200.0 * change_6;
    const double change_7 = 0.04661544808322666 - tendon_lengths_h[7];
    delta_theta[7] = 200.0 * change_7;
    const double change_8 = 0.04669047011971501 - tendon_lengths_h[8];
    delta_theta[8] = 200.0 * change_8;
    const double change_9 = 0.04661544808322666 - tendon_lengths_h[9];
    delta_theta[9] = 200.0 * change_9;
    const double change_10 = 0.04661544808322666 - tendon_lengths_h[10];
    delta_theta[10] = 200.0 * change_10;
    const double change_11 = 0.04661544808322666 - tendon_lengths_h[11];
    delta_theta[11] = 200.0 * change_11;
    const double change_12 = 0.04661544808322666 - tendon_lengths_h[12];
    delta_theta[12] = 200.0 * change_12;
    const double change_13 = 0.04669047011971501 - tendon_lengths_h[13];
    delta_theta[13] = 200.0 * change_13;
    const double change_14 = 0.04661544808322666 - tendon_lengths_h[14];
    delta_theta[14] = 200.0 * change_14;
    const double change_15 = 0.04661544808322666 - tendon_lengths_h[15];
    delta_theta[15] = 200.0 * change_15;
    const double change_16 = 0.04661544808322666 - tendon_lengths_h[16];
    delta_theta[16] = 200.0 * change_16;
    const double change_17 = 0.04661544808322666 - tendon_lengths_h[17];
    delta_theta[17] = 200.0 * change_17;
    const double change_18 = 0.04669047011971501 - tendon_lengths_h[18];
    delta_theta[18] = 200.0 * change_18;
    const double change_19 = 0.046561786907291264 - tendon_lengths_h[19];
    delta_theta[19] = 200.0 * change_19;
    const double change_20 = 0.04661544808322666 - tendon_lengths_h[20];
    delta_theta[20] = 200.0 * change_20;
    const double change_21 = 0.046561786907291264 - tendon_lengths_h[21];
    delta_theta[21] = 200.0 * change_21;
    const double change_22 = 0.046561786907291264 - tendon_lengths_h[22];
    delta_theta[22] = 200.0 * change_22;
    const double change_23 = 0.04661544808322666 - tendon_lengths_h[23];
    delta_theta[23] = 200.0 * change_23;
    const double change_24 = 0.046561786907291264 - tendon_lengths_h[24];
    delta_theta[24] = 200.0 * change_24;
    const double change_25 = 0.04661544808322666 - tendon_lengths_h[25];
    delta_theta[25] = 200.0 * change_25;
    const double change_26 = 0.046561786907291264 - tendon_lengths_h[26];
    delta_theta[26] = 200.0 * change_26;
    const double change_27 = 0.046561786907291264 - tendon_lengths_h[27];
    delta_theta[27] = 200.0 * change_27;
    const double change_28 = 0.04661544808322666 - tendon_lengths_h[28];
    delta_theta[28] = 200.0 * change_28;
    const double change_29 = 0.046561786907291264 - tendon_lengths_h[29];
    delta_theta[29] = 200.0 * change_29;
    const double change_30 = 0.04661544808322666 - tendon_lengths_h[30];
    delta_theta[30] = 200.0 * change_30;
    const double change_31 = 0.046561786907291264 - tendon_lengths_h[31];
    delta_theta[31] = 200.0 * change_31;
    const double change_32 = 0.046561786907291264 - tendon_lengths_h[32];
    delta_theta[32] = 200.0 * change_32;
    const double change_33 = 0.04661544808322666 - tendon_lengths_h[33];
    delta_theta[33] = 200.0 * change_33;
    const double change_34 = 0.046561786907291264 - tendon_lengths_h[34];
    delta_theta[34] = 200.0 * change_34;
    const double change_35 = 0.04661544808322666 - tendon_lengths_h[35];
    delta_theta[35] = 200.0 * change_35;
    const double change_36 = 0.046561786907291264 - tendon_lengths_h[36];
    delta_theta[36] = 200.0 * change_36;
    const double change_37 = 0.046561786907291264 - tendon_lengths_h[37];
    delta_theta[37] = 200.0 * change_37;
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
    const double cos_q73_by_t = dq73 * sin_q73;
    const double B_y_by_t = 0.074565407529229 * cos_q73_by_t;
    const double B_to_C0_squared_by_t = 0.084 * B_y_by_t;
    const double ratio_by_t = ratio * B_to_C0_squared_by_t * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double sin_q73_by_t = dq73 * cos_q73;
    const double B_e_by_t = 0.074565407529229 * sin_q73_by_t;
    const double C_e_by_t = B_e * ratio_by_t - ratio * B_e_by_t;
    const double M_e_by_t = 0.5 * (B_e_by_t - C_e_by_t);
    const double sin_q71_by_t = dq71 * cos_q71;
    const double s_e_by_t = M_e_by_t - 0.036 * sin_q71_by_t;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t3;
    const double u_y = 23.80952380952381 * (B_y + C_y);
    const double C_y_by_t = ratio * B_y_by_t - 0.002 * ratio_by_t * t3;
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
    const double cos_q71_by_t = dq71 * sin_q71;
    const double p_z_by_t = 0.036 * cos_q71_by_t;
    const double p_z = 0.036 * cos_q71;
    const double t4 = p_y * p_y_by_t - p_z * p_z_by_t;
    const double t5 = p_y * p_y;
    const double t6 = p_z * p_z;
    const double reach_squared_by_t = sinew_choose(-(1.296e-15 - t5 - t6), t4 + t4, 0.0);
    const double p_x_by_t = u_e * s_e_by_t - u_y * M_y_by_t + s_e * u_e_by_t + s_y * u_y_by_t;
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection_by_t = 13.88888888888889 * reach_squared_by_t + 27.77777777777778 * p_x
        * p_x_by_t;
    const double reach_squared = sinew_max(t5 + t6, 1.296e-15);
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double reach = sinew_sqrt(reach_squared);
    const double t7 = reach - projection;
    const double reach_by_t = 0.5 * reach_squared_by_t / reach;
    const double t8 = reach_by_t * sinew_choose(t7, 0.0, 1.0) - projection_by_t * sinew_choose(t7,
        1.0, 0.0);
    const double t9 = sinew_max(-projection, -reach);
    const double limited_by_t = sinew_choose(reach - t9, -t8, reach_by_t);
    const double limited = sinew_min(t9, reach);
    const double t10 = reach * reach_by_t - limited * limited_by_t;
    const double t11 = (reach + limited) * (reach - limited);
    const double t12 = 1e-12 * reach_squared;
    const double clearance_by_t = sinew_choose(-(t12 - t11), t10 + t10, 1e-12 * reach_squared_by_t);
    const double clearance = sinew_max(t11, t12);
    const double root = sinew_sqrt(clearance);
    const double root_by_t = 0.5 * clearance_by_t / root;
    const double t13 = p_y * limited_by_t + p_z * root_by_t + limited * p_y_by_t - root * p_z_by_t;
    const double t14 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t14;
    const double cos_A_by_t = (t13 - cos_A * reach_squared_by_t) * t14;
    const double z_plane_x_by_t = u_y * cos_A_by_t - cos_A * u_y_by_t;
    const double t15 = p_y * root_by_t - p_z * limited_by_t + limited * p_z_by_t + root * p_y_by_t;
    const double sin_A = (p_y * root - p_z * limited) * t14;
    const double sin_A_by_t = (t15 - sin_A * reach_squared_by_t) * t14;
    const double z_plane_x = u_y * cos_A;
    const double z_x_by_t = cos_q71 * z_plane_x_by_t - sin_q71 * sin_A_by_t - sin_A * sin_q71_by_t
        - z_plane_x * cos_q71_by_t;
    const double M_x_by_t = cos_q71 * M_e_by_t - M_e * cos_q71_by_t;
    const double origin_x_by_t = M_x_by_t - 0.018 * z_x_by_t;
    const double x_plane_x_by_t = u_y * sin_A_by_t - sin_A * u_y_by_t;
    const double x_plane_x = u_y * sin_A;
    const double x_x_by_t = cos_q71 * x_plane_x_by_t + sin_q71 * cos_A_by_t + cos_A * sin_q71_by_t
        - x_plane_x * cos_q71_by_t;
    const double t16 = origin_x_by_t - 0.004 * x_x_by_t;
    const double t17 = 0.01 * z_x_by_t;
    const double y_x_by_t = cos_q71 * u_e_by_t - u_e * cos_q71_by_t;
    const double layer_0_x_by_t = t16 + t17 - 0.011 * y_x_by_t;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double M_x = cos_q71 * M_e;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double t18 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t19 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double layer_0_x = t18 - t19 + 0.011 * y_x;
    const double z_z_by_t = cos_q71 * sin_A_by_t + sin_q71 * z_plane_x_by_t - sin_A * cos_q71_by_t
        + z_plane_x * sin_q71_by_t;
    const double M_z_by_t = sin_q71 * M_e_by_t + M_e * sin_q71_by_t;
    const double origin_z_by_t = M_z_by_t - 0.018 * z_z_by_t;
    const double x_z_by_t = cos_q71 * cos_A_by_t - sin_q71 * x_plane_x_by_t - cos_A * cos_q71_by_t
        - x_plane_x * sin_q71_by_t;
    const double t20 = origin_z_by_t + 0.004 * x_z_by_t;
    const double t21 = 0.01 * z_z_by_t;
    const double y_z_by_t = sin_q71 * u_e_by_t + u_e * sin_q71_by_t;
    const double layer_0_z_by_t = t20 + t21 - 0.011 * y_z_by_t;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t22 = 0.004 * x_z;
    const double t23 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t22 - t23 + 0.011 * y_z;
    const double across_by_t = layer_0_x * layer_0_x_by_t + layer_0_z * layer_0_z_by_t;
    const double z_plane_y_by_t = u_e * cos_A_by_t + cos_A * u_e_by_t;
    const double origin_y_by_t = M_y_by_t - 0.018 * z_plane_y_by_t;
    const double x_plane_y_by_t = u_e * sin_A_by_t + sin_A * u_e_by_t;
    const double t24 = origin_y_by_t - 0.004 * x_plane_y_by_t;
    const double t25 = 0.01 * z_plane_y_by_t;
    const double layer_0_y_by_t = t24 + t25 - 0.011 * u_y_by_t;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t26 = 0.004 * x_plane_y;
    const double t27 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t26 + t27 + 0.011 * u_y;
    const double half_square_by = across_by_t - layer_0_y * layer_0_y_by_t;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double length_0_by_t = half_square_by / length_0;
    delta_theta_rate[0] = 200.0 * length_0_by_t;
    const double across_by_y_by_t = y_x * layer_0_x_by_t + y_z * layer_0_z_by_t - layer_0_x
        * y_x_by_t - layer_0_z * y_z_by_t;
    const double across_by_y_squared_by_t = y_x * y_x_by_t + y_z * y_z_by_t;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double layer_1_x_by_t = t16 - t17 - 0.013 * y_x_by_t;
    const double layer_1_x = t18 + t19 + 0.013 * y_x;
    const double layer_1_z_by_t = t20 - t21 - 0.013 * y_z_by_t;
    const double layer_1_z = 0.028 - origin_z - t22 + t23 + 0.013 * y_z;
    const double across_38_by_t = layer_1_x * layer_1_x_by_t + layer_1_z * layer_1_z_by_t;
    const double layer_1_y_by_t = t24 - t25 - 0.013 * u_y_by_t;
    const double layer_1_y = 0.006 - origin_y - t26 - t27 + 0.013 * u_y;
    const double half_square_by_38 = across_38_by_t - layer_1_y * layer_1_y_by_t;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double length_19_by_t = half_square_by_38 / length_19;
    delta_theta_rate[19] = 200.0 * length_19_by_t;
    const double across_by_y_2_by_t = y_x * layer_1_x_by_t + y_z * layer_1_z_by_t - layer_1_x
        * y_x_by_t - layer_1_z * y_z_by_t;
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    static const double table29[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i28 = 0; i28 < 18; ++i28) {
        const double across_slope = across_by_y_by_t + table29[i28][0] * across_by_y_squared_by_t;
        const double across_2 = across_by_t - table29[i28][0] * across_slope;
        const double strand_y = table29[i28][1] + layer_0_y - table29[i28][0] * u_y;
        const double half_square_by_2 = across_2 - strand_y * (layer_0_y_by_t + table29[i28][0]
            * u_y_by_t);
        const double across_3 = twice_across - table29[i28][0] * (twice_across_2 - table29[i28][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        const double length_by_t = half_square_by_2 / length;
        delta_theta_rate[1 + i28] = 200.0 * length_by_t;
    }
    static const double table31[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i30 = 0; i30 < 18; ++i30) {
        const double across_slope_2 = across_by_y_2_by_t + table31[i30][0]
            * across_by_y_squared_by_t;
        const double across_4 = across_38_by_t - table31[i30][0] * across_slope_2;
        const double strand_y_2 = table31[i30][1] + layer_1_y - table31[i30][0] * u_y;
        const double strand_y_by = layer_1_y_by_t + table31[i30][0] * u_y_by_t;
        const double half_square_by_3 = across_4 - strand_y_2 * strand_y_by;
        const double across_slope_3 = twice_across_8 - table31[i30][0] * twice_across_4;
        const double across_5 = twice_across_6 - table31[i30][0] * across_slope_3;
        const double length_2 = sinew_sqrt(across_5 + strand_y_2 * strand_y_2);
        const double length_by_t_2 = half_square_by_3 / length_2;
        delta_theta_rate[20 + i30] = 200.0 * length_by_t_2;
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
    const double t2 = 23.80952380952381 * B_y;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double t3 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t3;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t3;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double u_e_by_q73 = t2 + 23.80952380952381 * C_e_by_q73;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double p_z = 0.036 * cos_q71;
    const double t4 = p_z * p_z;
    const double t5 = 23.80952380952381 * B_e;
    const double C_e = B_e * ratio;
    const double u_e = t5 - 23.80952380952381 * C_e;
    const double t6 = 0.5 * B_y;
    const double t7 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t7;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double t8 = 0.5 * B_e;
    const double M_e = t8 + 0.5 * C_e;
    const double s_e = M_e - p_z_by_q71;
    const double u_y = t2 + 23.80952380952381 * C_y;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t9 = p_y * p_y;
    const double reach_squared = sinew_max(t9 + t4, 1.296e-15);
    const double t10 = 1.0 / reach_squared;
    const double t11 = -(1.296e-15 - t9 - t4);
    const double t12 = p_y + p_y;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t7;
    const double u_y_by_q73 = t5 - 23.80952380952381 * C_y_by_q73;
    const double M_y_by_q73 = t8 + 0.5 * C_y_by_q73;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double reach_squared_by_q73 = sinew_choose(t11, t12 * p_y_by_q73, 0.0);
    const double reach = sinew_sqrt(reach_squared);
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double t13 = sinew_max(-projection, -reach);
    const double limited = sinew_min(t13, reach);
    const double t14 = 1e-12 * reach_squared;
    const double t15 = (reach + limited) * (reach - limited);
    const double clearance = sinew_max(t15, t14);
    const double root = sinew_sqrt(clearance);
    const double sin_A = (p_y * root - p_z * limited) * t10;
    const double t16 = reach - t13;
    const double t17 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t17;
    const double t18 = reach - projection;
    const double t19 = sinew_choose(t18, 0.0, 1.0);
    const double t20 = sinew_choose(t18, 1.0, 0.0);
    const double t21 = 27.77777777777778 * p_x;
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t21 * p_x_by_q73;
    const double limited_by_q73 = sinew_choose(t16, -(reach_by_q73 * t19 - projection_by_q73 * t20),
        reach_by_q73);
    const double t22 = 1.0 / root;
    const double t23 = -(t14 - t15);
    const double t24 = reach + reach;
    const double t25 = limited + limited;
    const double clearance_by_q73 = sinew_choose(t23, t24 * reach_by_q73 - t25 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double root_by_q73 = 0.5 * clearance_by_q73 * t22;
    const double t26 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t26 * t10;
    const double cos_A = (p_y * limited + p_z * root) * t10;
    const double t27 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t27 * t10;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double t28 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double y_x = cos_q71 * u_e;
    const double z_plane_y = u_e * cos_A;
    const double t29 = 0.01 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t30 = 0.004 * x_plane_y;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t30 + t29 + 0.011 * u_y;
    const double y_z = sin_q71 * u_e;
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double t31 = 0.011 * y_x;
    const double t32 = sin_q71 * sin_A;
    const double z_plane_x = u_y * cos_A;
    const double t33 = cos_q71 * z_plane_x;
    const double z_x = t33 - t32;
    const double t34 = 0.01 * z_x;
    const double t35 = sin_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t36 = cos_q71 * x_plane_x;
    const double x_x = t36 + t35;
    const double M_x = cos_q71 * M_e;
    const double t37 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double layer_0_x = t37 - t34 + t31;
    const double t38 = 0.011 * y_z;
    const double t39 = cos_q71 * sin_A;
    const double t40 = sin_q71 * z_plane_x;
    const double z_z = t39 + t40;
    const double t41 = 0.01 * z_z;
    const double t42 = cos_q71 * cos_A;
    const double t43 = sin_q71 * x_plane_x;
    const double x_z = t42 - t43;
    const double t44 = 0.004 * x_z;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double layer_0_z = 0.008 - origin_z - t44 - t41 + t38;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double per_length_0 = f[0] / length_0;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double t45 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double pull_0 = layer_0_y * per_length_0;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double t46 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double layer_1_y = 0.006 - origin_y - t30 - t29 + 0.013 * u_y;
    const double t47 = 0.013 * y_x;
    const double layer_1_x = t37 + t34 + t47;
    const double t48 = 0.013 * y_z;
    const double layer_1_z = 0.028 - origin_z - t44 + t41 + t48;
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double per_length_19 = f[19] / length_19;
    const double pull_19_2 = layer_1_y * per_length_19;
    const double p_y_by_q71 = u_y * p_z;
    const double reach_squared_by_q71 = sinew_choose(t11, -(t12 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t17;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t21 * u_e * p_z;
    const double limited_by_q71 = sinew_choose(t16, -(reach_by_q71 * t19 - projection_by_q71 * t20),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t23, t24 * reach_by_q71 - t25 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t22;
    const double t49 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t49 - sin_A * reach_squared_by_q71) * t10;
    const double t50 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t50 - cos_A * reach_squared_by_q71) * t10;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double z_x_by_q71 = t39 - cos_q71 * z_plane_x_by_q71 + t40 + sin_q71 * sin_A_by_q71;
    const double t51 = 0.01 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t42 + cos_q71 * x_plane_x_by_q71 - t43 + sin_q71 * cos_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double t52 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double layer_0_x_by_q71 = t52 + t51 - t38;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double z_z_by_q71 = t33 + cos_q71 * sin_A_by_q71 - t32 + sin_q71 * z_plane_x_by_q71;
    const double t53 = 0.01 * z_z_by_q71;
    const double x_z_by_q71 = t36 - cos_q71 * cos_A_by_q71 + t35 + sin_q71 * x_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double t54 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double layer_0_z_by_q71 = t54 + t53 - t31;
    const double layer_1_x_by_q71 = t52 - t51 - t48;
    const double layer_1_z_by_q71 = t54 - t53 - t47;
    static const double table61[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.004, 0.005},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.012, 0.013},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.02, 0.021},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.028, 0.029}};
    double sum56 = -0.0;
    double sum57 = -0.0;
    double sum58 = pull_0;
    double sum59 = -0.0;
    double sum60 = per_length_0;
    for (int i55 = 0; i55 < 18; ++i55) {
        const double before62 = sum56;
        const double before63 = sum57;
        const double before64 = sum58;
        const double before65 = sum59;
        const double before66 = sum60;
        const double strand_y = table61[i55][0] + layer_0_y - table61[i55][1] * u_y;
        const double across_2 = twice_across - table61[i55][1] * (twice_across_2 - table61[i55][1]
            * twice_across_4);
        const double length = sinew_sqrt(across_2 + strand_y * strand_y);
        const double per_length = f[1 + i55] / length;
        const double t67 = table61[i55][1] * per_length;
        const double pull_by_y_along = strand_y * t67;
        const double pull = strand_y * per_length;
        sum56 = before62 + pull_by_y_along;
        sum57 = before63 + table61[i55][1] * t67;
        sum58 = before64 + pull;
        sum59 = before65 + t67;
        sum60 = before66 + per_length;
    }
    static const double table74[18][2] = {{0.001, 0.002}, {0.003, 0.003}, {0.005, 0.005},
        {0.006, 0.007}, {0.008, 0.008}, {0.009, 0.01}, {0.011, 0.011}, {0.013, 0.013},
        {0.014, 0.015}, {0.016, 0.016}, {0.017, 0.018}, {0.019, 0.019}, {0.021, 0.021},
        {0.022, 0.023}, {0.024, 0.024}, {0.025, 0.026}, {0.027, 0.027}, {0.029, 0.029}};
    double sum69 = -0.0;
    double sum70 = -0.0;
    double sum71 = pull_19_2;
    double sum72 = -0.0;
    double sum73 = per_length_19;
    for (int i68 = 0; i68 < 18; ++i68) {
        const double before75 = sum69;
        const double before76 = sum70;
        const double before77 = sum71;
        const double before78 = sum72;
        const double before79 = sum73;
        const double strand_y_2 = table74[i68][0] + layer_1_y - table74[i68][1] * u_y;
        const double across_slope = twice_across_8 - table74[i68][1] * twice_across_4;
        const double across_3 = twice_across_6 - table74[i68][1] * across_slope;
        const double length_2 = sinew_sqrt(across_3 + strand_y_2 * strand_y_2);
        const double per_length_2 = f[20 + i68] / length_2;
        const double t80 = table74[i68][1] * per_length_2;
        const double pull_by_y_along_2 = strand_y_2 * t80;
        sum69 = before75 + pull_by_y_along_2;
        sum70 = before76 + table74[i68][1] * t80;
        sum71 = before77 + strand_y_2 * per_length_2;
        sum72 = before78 + t80;
        sum73 = before79 + per_length_2;
    }
    const double t81 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t28 + t81 - 0.011 * y_x_by_q73;
    const double pull_x = y_x * sum59 - layer_0_x * sum60;
    const double t82 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t45 + t82 - 0.011 * u_y_by_q73;
    const double t83 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t46 + t83 - 0.011 * y_z_by_q73;
    const double pull_z = y_z * sum59 - layer_0_z * sum60;
    const double t84 = pull_x * layer_0_x_by_q73 + sum58 * layer_0_y_by_q73 + pull_z
        * layer_0_z_by_q73;
    const double layer_1_x_by_q73 = t28 - t81 - 0.013 * y_x_by_q73;
    const double pull_x_2 = y_x * sum72 - layer_1_x * sum73;
    const double layer_1_y_by_q73 = t45 - t82 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t46 - t83 - 0.013 * y_z_by_q73;
    const double pull_z_2 = y_z * sum72 - layer_1_z * sum73;
    const double t85 = t84 + pull_x_2 * layer_1_x_by_q73 + sum71 * layer_1_y_by_q73 + pull_z_2
        * layer_1_z_by_q73;
    const double t86 = sum57 + sum70;
    const double pull_axis_x_4 = y_x * t86 - layer_0_x * sum59 - layer_1_x * sum72;
    const double pull_axis_y_4 = sum56 + sum69;
    const double pull_axis_z_4 = y_z * t86 - layer_0_z * sum59 - layer_1_z * sum72;
    const double t87 = t85 + pull_axis_x_4 * y_x_by_q73 + pull_axis_y_4 * u_y_by_q73 + pull_axis_z_4
        * y_z_by_q73;
    const double t88 = 0.01 * z_plane_y_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t89 = origin_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
    const double layer_0_y_by_q71 = t89 - t88;
    const double t90 = y_x * pull_axis_z_4 - y_z * pull_axis_x_4 - pull_x * layer_0_x_by_q71 - sum58
        * layer_0_y_by_q71;
    const double layer_1_y_by_q71 = t89 + t88;
    const double t91 = t90 + pull_z * layer_0_z_by_q71 - pull_x_2 * layer_1_x_by_q71 - sum71
        * layer_1_y_by_q71;
    tau[0] = -(t91 + pull_z_2 * layer_1_z_by_q71);
    tau[1] = -t87;
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
    const double t8 = p_y * p_y;
    const double p_z = 0.036 * cos_q71;
    const double t9 = p_z * p_z;
    const double reach_squared = sinew_max(t8 + t9, 1.296e-15);
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double reach = sinew_sqrt(reach_squared);
    const double t10 = sinew_max(-projection, -reach);
    const double limited = sinew_min(t10, reach);
    const double t11 = (reach + limited) * (reach - limited);
    const double t12 = 1e-12 * reach_squared;
    const double clearance = sinew_max(t11, t12);
    const double root = sinew_sqrt(clearance);
    const double t13 = p_z * root;
    const double t14 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + t13) * t14;
    const double z_plane_x = u_y * cos_A;
    const double t15 = cos_q71 * z_plane_x;
    const double t16 = p_z * limited;
    const double sin_A = (p_y * root - t16) * t14;
    const double t17 = sin_q71 * sin_A;
    const double z_x = t15 - t17;
    const double M_x = cos_q71 * M_e;
    const double x_plane_x = u_y * sin_A;
    const double t18 = cos_q71 * x_plane_x;
    const double t19 = sin_q71 * cos_A;
    const double x_x = t18 + t19;
    const double t20 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t21 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double t22 = 0.011 * y_x;
    const double layer_0_x = t20 - t21 + t22;
    const double t23 = sin_q71 * z_plane_x;
    const double t24 = cos_q71 * sin_A;
    const double z_z = t24 + t23;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t25 = sin_q71 * x_plane_x;
    const double t26 = cos_q71 * cos_A;
    const double x_z = t26 - t25;
    const double t27 = 0.004 * x_z;
    const double t28 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double t29 = 0.011 * y_z;
    const double layer_0_z = 0.008 - origin_z - t27 - t28 + t29;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double turned_4 = y_x * y_x + y_z * y_z;
    const double across_by_y_squared = 0.5 * turned_4;
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t30 = 0.004 * x_plane_y;
    const double t31 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t30 + t31 + 0.011 * u_y;
    const double t32 = 0.013 * y_x;
    const double layer_1_x = t20 + t21 + t32;
    const double t33 = 0.013 * y_z;
    const double layer_1_z = 0.028 - origin_z - t27 + t28 + t33;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double layer_1_y = 0.006 - origin_y - t30 - t31 + 0.013 * u_y;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    const double t34 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t34;
    const double u_e_by_q73 = t4 + 23.80952380952381 * C_e_by_q73;
    const double y_x_by_q71_by_q73 = sin_q71 * u_e_by_q73;
    const double y_z_by_q71_by_q73 = cos_q71 * u_e_by_q73;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double t35 = p_y + p_y;
    const double t36 = -(1.296e-15 - t8 - t9);
    const double reach_squared_by_q73 = sinew_choose(t36, t35 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double t37 = 27.77777777777778 * p_x;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t37 * p_x_by_q73;
    const double t38 = reach - projection;
    const double t39 = sinew_choose(t38, 1.0, 0.0);
    const double t40 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t40;
    const double t41 = sinew_choose(t38, 0.0, 1.0);
    const double t42 = reach - t10;
    const double limited_by_q73 = sinew_choose(t42, -(reach_by_q73 * t41 - projection_by_q73 * t39),
        reach_by_q73);
    const double t43 = limited + limited;
    const double t44 = reach + reach;
    const double t45 = -(t12 - t11);
    const double clearance_by_q73 = sinew_choose(t45, t44 * reach_by_q73 - t43 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double t46 = 1.0 / root;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t46;
    const double t47 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t47 * t14;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t48 = cos_q71 * z_plane_x_by_q73;
    const double t49 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t49 * t14;
    const double t50 = sin_q71 * sin_A_by_q73;
    const double z_x_by_q73 = t48 - t50;
    const double M_z_by_q71_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t51 = cos_q71 * x_plane_x_by_q73;
    const double t52 = sin_q71 * cos_A_by_q73;
    const double x_x_by_q73 = t51 + t52;
    const double t53 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t54 = 0.01 * z_x_by_q73;
    const double t55 = 0.011 * y_z_by_q71_by_q73;
    const double layer_0_x_by_q73 = t53 + t54 - t55;
    const double t56 = sin_q71 * z_plane_x_by_q73;
    const double t57 = cos_q71 * sin_A_by_q73;
    const double z_z_by_q73 = t57 + t56;
    const double M_x_by_q71_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_x_by_q71_by_q73 - 0.018 * z_z_by_q73;
    const double t58 = sin_q71 * x_plane_x_by_q73;
    const double t59 = cos_q71 * cos_A_by_q73;
    const double x_z_by_q73 = t59 - t58;
    const double t60 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t61 = 0.01 * z_z_by_q73;
    const double t62 = 0.011 * y_x_by_q71_by_q73;
    const double layer_0_z_by_q73 = t60 + t61 - t62;
    const double across_by_q73 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t63 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t64 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t63 + t64 - 0.011 * u_y_by_q73;
    const double half_square_by_76 = across_by_q73 - layer_0_y * layer_0_y_by_q73;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double t65 = 1.0 / length_0;
    const double length_0_by_q73 = half_square_by_76 * t65;
    const double per_length_0 = f[0] * t65;
    const double across_0 = k[0] - per_length_0;
    const double t66 = y_x * layer_0_x_by_q73 + y_z * layer_0_z_by_q73 - layer_0_x
        * y_z_by_q71_by_q73;
    const double across_by_y_by_q73 = t66 - layer_0_z * y_x_by_q71_by_q73;
    const double across_by_y_squared_by_q73 = y_x * y_z_by_q71_by_q73 + y_z * y_x_by_q71_by_q73;
    const double t67 = 0.013 * y_z_by_q71_by_q73;
    const double layer_1_x_by_q73 = t53 - t54 - t67;
    const double t68 = 0.013 * y_x_by_q71_by_q73;
    const double layer_1_z_by_q73 = t60 - t61 - t68;
    const double across_38_by_q73 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73;
    const double layer_1_y_by_q73 = t63 - t64 - 0.013 * u_y_by_q73;
    const double half_square_by_114 = across_38_by_q73 - layer_1_y * layer_1_y_by_q73;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double t69 = 1.0 / length_19;
    const double length_19_by_q73 = half_square_by_114 * t69;
    const double per_length_19 = f[19] * t69;
    const double across_19 = k[19] - per_length_19;
    const double t70 = y_x * layer_1_x_by_q73 + y_z * layer_1_z_by_q73 - layer_1_x
        * y_z_by_q71_by_q73;
    const double across_by_y_2_by_q73 = t70 - layer_1_z * y_x_by_q71_by_q73;
    const double t71 = layer_0_x_by_q73 * layer_0_x_by_q73 + layer_0_y_by_q73 * layer_0_y_by_q73;
    const double along_8 = t71 + layer_0_z_by_q73 * layer_0_z_by_q73;
    const double t72 = y_x_by_q71_by_q73 + y_x_by_q71_by_q73;
    const double t73 = u_y_by_q73 + u_y_by_q73;
    const double t74 = y_z_by_q71_by_q73 + y_z_by_q71_by_q73;
    const double mixed_8 = t73 * layer_0_y_by_q73 + t72 * layer_0_z_by_q73 + t74 * layer_0_x_by_q73;
    const double t75 = reach_by_q73 * reach_by_q73;
    const double t76 = t75 + t75;
    const double t77 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t77 * t2;
    const double C_y_by_q73_by_q73 = t34 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t78 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t79 = u_e_by_q73 + u_e_by_q73;
    const double p_y_by_q73_by_q73 = t78 - s_y * u_e_by_q73_by_q73 + t79 * M_y_by_q73 - t73
        * M_e_by_q73;
    const double t80 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t36, t80 * p_y_by_q73 + t35
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t76) * t40;
    const double t81 = t76 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t44
        * reach_by_q73_by_q73;
    const double t82 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t83 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t83 - s_y * u_y_by_q73_by_q73 - t79 * M_e_by_q73 - t73
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t82 - t37 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t42, -(reach_by_q73_by_q73 * t41
        - projection_by_q73_by_q73 * t39), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t45, t81 - t43 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t84 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t84 * t46;
    const double t85 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t86 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t87 = t85 - sin_A * reach_squared_by_q73_by_q73 + t80 * root_by_q73 - t86
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t87 * t14;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t73 * sin_A_by_q73;
    const double t88 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t89 = t88 - cos_A * reach_squared_by_q73_by_q73 + t80 * limited_by_q73 - t86
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t89 * t14;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t73 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t90 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double pull_0 = layer_0_y * per_length_0;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t79 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t79 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t91 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t92 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double t93 = layer_1_x_by_q73 * layer_1_x_by_q73 + layer_1_y_by_q73 * layer_1_y_by_q73;
    const double along_10 = t93 + layer_1_z_by_q73 * layer_1_z_by_q73;
    const double mixed_10 = t73 * layer_1_y_by_q73 + t72 * layer_1_z_by_q73 + t74
        * layer_1_x_by_q73;
    const double pull_19_2 = layer_1_y * per_length_19;
    const double p_y_by_q71 = u_y * p_z;
    const double t94 = p_z + p_z;
    const double reach_squared_by_q71 = sinew_choose(t36, -(t35 * p_y_by_q71 + t94 * p_z_by_q71),
        0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t40;
    const double p_x_by_q71 = u_e * p_z;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t37 * p_x_by_q71;
    const double limited_by_q71 = sinew_choose(t42, -(reach_by_q71 * t41 - projection_by_q71 * t39),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t45, t44 * reach_by_q71 - t43 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t46;
    const double t95 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t95 - cos_A * reach_squared_by_q71) * t14;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t96 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t96 - sin_A * reach_squared_by_q71) * t14;
    const double z_x_by_q71 = t24 - cos_q71 * z_plane_x_by_q71 + t23 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t26 + cos_q71 * x_plane_x_by_q71 - t25 + sin_q71 * cos_A_by_q71;
    const double t97 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t98 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t97 + t98 - t29;
    const double z_z_by_q71 = t15 + cos_q71 * sin_A_by_q71 - t17 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t18 - cos_q71 * cos_A_by_q71 + t19 + sin_q71 * x_plane_x_by_q71;
    const double t99 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t100 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t99 + t100 - t22;
    const double across_by_q71 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t101 = 0.004 * u_e;
    const double t102 = origin_y_by_q71 + t101 * sin_A_by_q71;
    const double t103 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t102 - t103;
    const double half_square_by = across_by_q71 - layer_0_y * layer_0_y_by_q71;
    const double length_0_by_q71 = half_square_by * t65;
    const double K_0 = length_0_by_q71 * length_0_by_q73 * across_0;
    const double across_by_y_by_q71 = y_x * (layer_0_z + layer_0_x_by_q71) - y_z * (layer_0_x
        + layer_0_z_by_q71);
    const double layer_1_x_by_q71 = t97 - t98 - t33;
    const double layer_1_z_by_q71 = t99 - t100 - t32;
    const double across_38_by_q71 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71;
    const double layer_1_y_by_q71 = t102 + t103;
    const double half_square_by_38 = across_38_by_q71 - layer_1_y * layer_1_y_by_q71;
    const double length_19_by_q71 = half_square_by_38 * t69;
    const double K_19 = length_19_by_q71 * length_19_by_q73 * across_19;
    const double across_by_y_2_by_q71 = y_x * (layer_1_z + layer_1_x_by_q71) - y_z * (layer_1_x
        + layer_1_z_by_q71);
    const double t104 = layer_0_x_by_q71 * layer_0_x_by_q73 + layer_0_y_by_q71 * layer_0_y_by_q73;
    const double along = t104 - layer_0_z_by_q71 * layer_0_z_by_q73;
    const double t105 = y_x * layer_0_z_by_q73 - y_z * layer_0_x_by_q73 - layer_0_x_by_q71
        * y_z_by_q71_by_q73;
    const double mixed = t105 - layer_0_y_by_q71 * u_y_by_q73 + layer_0_z_by_q71
        * y_x_by_q71_by_q73;
    const double t106 = root_by_q71 + root_by_q71;
    const double t107 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double t108 = p_y_by_q71 + p_y_by_q71;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t36, t35 * p_y_by_q71_by_q73 - t108
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t107) * t40;
    const double t109 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t37
        * p_z * u_e_by_q73 - t109 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t42, -(reach_by_q71_by_q73 * t41
        - projection_by_q71_by_q73 * t39), reach_by_q71_by_q73);
    const double t110 = limited_by_q71 + limited_by_q71;
    const double t111 = t44 * reach_by_q71_by_q73 - t43 * limited_by_q71_by_q73 + t107 - t110
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t45, t111, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t106 * root_by_q73) * t46;
    const double t112 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t113 = t112 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t114 = t113 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t114 * t14;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t115 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t116 = t115 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t117 = t116 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t117 * t14;
    const double z_x_by_q71_by_q73 = t57 - cos_q71 * z_plane_x_by_q71_by_q73 + sin_q71
        * sin_A_by_q71_by_q73 + t56;
    const double origin_x_by_q71_by_q73 = M_x_by_q71_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t59 + cos_q71 * x_plane_x_by_q71_by_q73 - t58 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t118 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t119 = 0.01 * z_x_by_q71_by_q73;
    const double layer_0_x_by_q71_by_q73 = t118 + t119 - t62;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double z_z_by_q71_by_q73 = cos_q71 * sin_A_by_q71_by_q73 + t48 - t50 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t51 - cos_q71 * cos_A_by_q71_by_q73 + t52 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t120 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t121 = 0.01 * z_z_by_q71_by_q73;
    const double layer_0_z_by_q71_by_q73 = t120 + t121 - t55;
    const double t122 = layer_1_x_by_q71 * layer_1_x_by_q73 + layer_1_y_by_q71 * layer_1_y_by_q73;
    const double along_2 = t122 - layer_1_z_by_q71 * layer_1_z_by_q73;
    const double t123 = y_x * layer_1_z_by_q73 - y_z * layer_1_x_by_q73 - u_y_by_q73
        * layer_1_y_by_q71;
    const double mixed_2 = t123 + y_x_by_q71_by_q73 * layer_1_z_by_q71 - y_z_by_q71_by_q73
        * layer_1_x_by_q71;
    const double layer_1_x_by_q71_by_q73 = t118 - t119 - t68;
    const double layer_1_z_by_q71_by_q73 = t120 - t121 - t67;
    const double t124 = layer_0_x_by_q71 * layer_0_x_by_q71 + layer_0_y_by_q71 * layer_0_y_by_q71;
    const double along_4 = t124 + layer_0_z_by_q71 * layer_0_z_by_q71;
    const double t125 = y_x + y_x;
    const double t126 = y_z + y_z;
    const double mixed_4 = t125 * layer_0_z_by_q71 + t126 * layer_0_x_by_q71;
    const double t127 = reach_by_q71 * reach_by_q71;
    const double t128 = t127 + t127;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t129 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t36, t129 + t129 + t35
        * p_y_by_q71_by_q71 - t94 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t128) * t40;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t109
        * p_x_by_q71 + t37 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t42, -(reach_by_q71_by_q71 * t41
        - projection_by_q71_by_q71 * t39), reach_by_q71_by_q71);
    const double t130 = t128 - t110 * limited_by_q71 + t44 * reach_by_q71_by_q71 - t43
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t45, t130, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t106 * root_by_q71) * t46;
    const double t131 = p_y * limited_by_q71_by_q71 - t13 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t132 = p_z_by_q71 + p_z_by_q71;
    const double t133 = t131 - cos_A * reach_squared_by_q71_by_q71 - t108 * limited_by_q71 - t132
        * root_by_q71;
    const double t134 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t133 - t134 * cos_A_by_q71) * t14;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t135 = p_y * root_by_q71_by_q71 + t16 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t136 = t135 - sin_A * reach_squared_by_q71_by_q71 - t108 * root_by_q71 + t132
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t136 - t134 * sin_A_by_q71) * t14;
    const double t137 = t15 - cos_q71 * z_plane_x_by_q71_by_q71 - t17 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t138 = cos_q71 + cos_q71;
    const double t139 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t137 + t138 * sin_A_by_q71 + t139 * z_plane_x_by_q71;
    const double origin_x_by_q71_by_q71 = M_x - 0.018 * z_x_by_q71_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t140 = t18 - cos_q71 * x_plane_x_by_q71_by_q71 + t19 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t140 - t138 * cos_A_by_q71 + t139 * x_plane_x_by_q71;
    const double t141 = origin_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t142 = 0.01 * z_x_by_q71_by_q71;
    const double layer_0_x_by_q71_by_q71 = t141 + t142 - t22;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double t143 = t24 - cos_q71 * sin_A_by_q71_by_q71 + t23 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t143 - t138 * z_plane_x_by_q71 + t139 * sin_A_by_q71;
    const double origin_z_by_q71_by_q71 = M_z - 0.018 * z_z_by_q71_by_q71;
    const double t144 = t26 - cos_q71 * cos_A_by_q71_by_q71 - t25 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t144 + t138 * x_plane_x_by_q71 + t139 * cos_A_by_q71;
    const double t145 = origin_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t146 = 0.01 * z_z_by_q71_by_q71;
    const double layer_0_z_by_q71_by_q71 = t145 + t146 - t29;
    const double t147 = layer_1_x_by_q71 * layer_1_x_by_q71 + layer_1_y_by_q71 * layer_1_y_by_q71;
    const double along_6 = t147 + layer_1_z_by_q71 * layer_1_z_by_q71;
    const double mixed_6 = t125 * layer_1_z_by_q71 + t126 * layer_1_x_by_q71;
    const double layer_1_x_by_q71_by_q71 = t141 - t142 - t32;
    const double layer_1_z_by_q71_by_q71 = t145 - t146 - t33;
    static const double table157[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    double sum149 = K_0;
    double sum150 = across_0 * length_0_by_q73 * length_0_by_q73;
    double sum151 = across_0 * length_0_by_q71 * length_0_by_q71;
    double sum152 = -0.0;
    double sum153 = -0.0;
    double sum154 = pull_0;
    double sum155 = -0.0;
    double sum156 = per_length_0;
    for (int i148 = 0; i148 < 18; ++i148) {
        const double before158 = sum149;
        const double before159 = sum150;
        const double before160 = sum151;
        const double before161 = sum152;
        const double before162 = sum153;
        const double before163 = sum154;
        const double before164 = sum155;
        const double before165 = sum156;
        const double across_2 = across_by_q71 - table157[i148][0] * across_by_y_by_q71;
        const double strand_y = table157[i148][1] + layer_0_y - table157[i148][0] * u_y;
        const double half_square_by_2 = across_2 - strand_y * layer_0_y_by_q71;
        const double t166 = table157[i148][0] * (twice_across_2 - table157[i148][0]
            * twice_across_4);
        const double across_3 = twice_across - t166;
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        const double t167 = 1.0 / length;
        const double length_by_q71 = half_square_by_2 * t167;
        const double across_slope = across_by_y_by_q73 + table157[i148][0]
            * across_by_y_squared_by_q73;
        const double across_4 = across_by_q73 - table157[i148][0] * across_slope;
        const double half_square_by_3 = across_4 - strand_y * (layer_0_y_by_q73 + table157[i148][0]
            * u_y_by_q73);
        const double length_by_q73 = half_square_by_3 * t167;
        const double per_length = f[1 + i148] * t167;
        const double t168 = k[1 + i148] - per_length;
        const double K_2 = length_by_q71 * length_by_q73 * t168;
        const double t169 = table157[i148][0] * per_length;
        const double pull_by_y_along = strand_y * t169;
        const double pull = strand_y * per_length;
        sum149 = before158 + K_2;
        sum150 = before159 + t168 * length_by_q73 * length_by_q73;
        sum151 = before160 + t168 * length_by_q71 * length_by_q71;
        sum152 = before161 + pull_by_y_along;
        sum153 = before162 + table157[i148][0] * t169;
        sum154 = before163 + pull;
        sum155 = before164 + t169;
        sum156 = before165 + per_length;
    }
    static const double table179[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    double sum171 = K_19;
    double sum172 = across_19 * length_19_by_q73 * length_19_by_q73;
    double sum173 = across_19 * length_19_by_q71 * length_19_by_q71;
    double sum174 = -0.0;
    double sum175 = -0.0;
    double sum176 = pull_19_2;
    double sum177 = -0.0;
    double sum178 = per_length_19;
    for (int i170 = 0; i170 < 18; ++i170) {
        const double before180 = sum171;
        const double before181 = sum172;
        const double before182 = sum173;
        const double before183 = sum174;
        const double before184 = sum175;
        const double before185 = sum176;
        const double before186 = sum177;
        const double before187 = sum178;
        const double across_5 = across_38_by_q71 - table179[i170][0] * across_by_y_2_by_q71;
        const double strand_y_2 = table179[i170][1] + layer_1_y - table179[i170][0] * u_y;
        const double half_square_by_4 = across_5 - strand_y_2 * layer_1_y_by_q71;
        const double across_slope_2 = twice_across_8 - table179[i170][0] * twice_across_4;
        const double across_6 = twice_across_6 - table179[i170][0] * across_slope_2;
        const double length_2 = sinew_sqrt(across_6 + strand_y_2 * strand_y_2);
        const double t188 = 1.0 / length_2;
        const double length_by_q71_2 = half_square_by_4 * t188;
        const double across_slope_3 = across_by_y_2_by_q73 + table179[i170][0]
            * across_by_y_squared_by_q73;
        const double across_7 = across_38_by_q73 - table179[i170][0] * across_slope_3;
        const double strand_y_by = layer_1_y_by_q73 + table179[i170][0] * u_y_by_q73;
        const double half_square_by_5 = across_7 - strand_y_2 * strand_y_by;
        const double length_by_q73_2 = half_square_by_5 * t188;
        const double per_length_2 = f[20 + i170] * t188;
        const double t189 = k[20 + i170] - per_length_2;
        const double K_3 = length_by_q71_2 * length_by_q73_2 * t189;
        const double t190 = table179[i170][0] * per_length_2;
        const double pull_by_y_along_2 = strand_y_2 * t190;
        sum171 = before180 + K_3;
        sum172 = before181 + t189 * length_by_q73_2 * length_by_q73_2;
        sum173 = before182 + t189 * length_by_q71_2 * length_by_q71_2;
        sum174 = before183 + pull_by_y_along_2;
        sum175 = before184 + table179[i170][0] * t190;
        sum176 = before185 + strand_y_2 * per_length_2;
        sum177 = before186 + t190;
        sum178 = before187 + per_length_2;
    }
    const double t191 = sum153 + sum175;
    const double turned_8 = u_y_by_q73 * u_y_by_q73 + y_x_by_q71_by_q73 * y_x_by_q71_by_q73
        + y_z_by_q71_by_q73 * y_z_by_q71_by_q73;
    const double pull_x = y_x * sum155 - layer_0_x * sum156;
    const double t192 = 0.01 * z_x_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t90 - t192 - 0.011 * y_x_by_q73_by_q73;
    const double t193 = turned_8 * t191 + sum150 + sum172 + sum156 * along_8 + sum155 * mixed_8
        - pull_x * layer_0_x_by_q73_by_q73;
    const double t194 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t91 + t194 - 0.011 * u_y_by_q73_by_q73;
    const double pull_z = y_z * sum155 - layer_0_z * sum156;
    const double t195 = 0.01 * z_z_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t92 - t195 - 0.011 * y_z_by_q73_by_q73;
    const double t196 = t193 + sum154 * layer_0_y_by_q73_by_q73 - pull_z * layer_0_z_by_q73_by_q73;
    const double pull_x_2 = y_x * sum177 - layer_1_x * sum178;
    const double layer_1_x_by_q73_by_q73 = t90 + t192 - 0.013 * y_x_by_q73_by_q73;
    const double t197 = t196 + sum178 * along_10 + sum177 * mixed_10 - pull_x_2
        * layer_1_x_by_q73_by_q73;
    const double layer_1_y_by_q73_by_q73 = t91 - t194 - 0.013 * u_y_by_q73_by_q73;
    const double pull_z_2 = y_z * sum177 - layer_1_z * sum178;
    const double layer_1_z_by_q73_by_q73 = t92 + t195 - 0.013 * y_z_by_q73_by_q73;
    const double t198 = t197 + sum176 * layer_1_y_by_q73_by_q73 - pull_z_2
        * layer_1_z_by_q73_by_q73;
    const double pull_axis_x_4 = y_x * t191 - layer_0_x * sum155 - layer_1_x * sum177;
    const double pull_axis_y_4 = sum152 + sum174;
    const double t199 = t198 - pull_axis_x_4 * y_x_by_q73_by_q73 + pull_axis_y_4
        * u_y_by_q73_by_q73;
    const double pull_axis_z_4 = y_z * t191 - layer_0_z * sum155 - layer_1_z * sum177;
    const double turned = y_x * y_x_by_q71_by_q73 - y_z * y_z_by_q71_by_q73;
    const double t200 = sum149 - turned * t191 + sum171 + sum156 * along - sum155 * mixed + pull_x
        * layer_0_x_by_q71_by_q73;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t201 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t202 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t201 - t202;
    const double t203 = t200 + sum154 * layer_0_y_by_q71_by_q73 - pull_z * layer_0_z_by_q71_by_q73;
    const double t204 = t203 + sum178 * along_2 - sum177 * mixed_2 + pull_x_2
        * layer_1_x_by_q71_by_q73;
    const double layer_1_y_by_q71_by_q73 = t201 + t202;
    const double t205 = t204 + sum176 * layer_1_y_by_q71_by_q73 - pull_z_2
        * layer_1_z_by_q71_by_q73;
    const double K_01 = t205 + y_x_by_q71_by_q73 * pull_axis_x_4 - y_z_by_q71_by_q73
        * pull_axis_z_4;
    const double t206 = -K_01;
    const double t207 = turned_4 * t191 + sum151 + sum173 - y_x * pull_axis_x_4 - y_z
        * pull_axis_z_4;
    const double t208 = t207 + sum156 * along_4 + sum155 * mixed_4 - pull_x
        * layer_0_x_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t209 = origin_y_by_q71_by_q71 + t101 * sin_A_by_q71_by_q71;
    const double t210 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t209 - t210;
    const double t211 = t208 - sum154 * layer_0_y_by_q71_by_q71 - pull_z * layer_0_z_by_q71_by_q71;
    const double t212 = t211 + sum178 * along_6 + sum177 * mixed_6 - pull_x_2
        * layer_1_x_by_q71_by_q71;
    const double layer_1_y_by_q71_by_q71 = t209 + t210;
    const double t213 = t212 - sum176 * layer_1_y_by_q71_by_q71 - pull_z_2
        * layer_1_z_by_q71_by_q71;
    K[0] = t213;
    K[1] = t206;
    K[2] = t206;
    K[3] = t199 - pull_axis_z_4 * y_z_by_q73_by_q73;
}
