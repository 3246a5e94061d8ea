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
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t5 = 0.004 * x_plane_y;
    const double t6 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t5 + t6 + 0.011 * u_y;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t7 = 0.004 * x_z;
    const double t8 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t7 - t8 + 0.011 * y_z;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    h[0] = length_0;
    const double layer_1_x = t3 + t4 + 0.013 * y_x;
    const double layer_1_y = 0.006 - origin_y - t5 - t6 + 0.013 * u_y;
    const double layer_1_z = 0.028 - origin_z - t7 + t8 + 0.013 * y_z;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    h[19] = length_19;
    static const double table10[18][3] = {{0.002, 0.001, 0.001}, {0.003, 0.003, 0.003},
        {0.005, 0.005, 0.004}, {0.007, 0.006, 0.006}, {0.008, 0.008, 0.008},
        {0.01, 0.009, 0.009}, {0.011, 0.011, 0.011}, {0.013, 0.013, 0.012},
        {0.015, 0.014, 0.014}, {0.016, 0.016, 0.016}, {0.018, 0.017, 0.017},
        {0.019, 0.019, 0.019}, {0.021, 0.021, 0.02}, {0.023, 0.022, 0.022},
        {0.024, 0.024, 0.024}, {0.026, 0.025, 0.025}, {0.027, 0.027, 0.027},
        {0.029, 0.029, 0.028}};
    for (int i9 = 0; i9 < 18; ++i9) {
        const double strand_x = layer_1_x - table10[i9][0] * y_x;
        const double strand_y = table10[i9][1] + layer_1_y - table10[i9][0] * u_y;
        const double strand_z = layer_1_z - table10[i9][0] * y_z;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double strand_x_2 = layer_0_x - table10[i9][1] * y_x;
        const double strand_y_2 = table10[i9][2] + layer_0_y - table10[i9][1] * u_y;
        const double strand_z_2 = layer_0_z - table10[i9][1] * y_z;
        const double t11 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t11);
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
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t42 = origin_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
    const double t43 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t42 - t43;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t44 = 0.004 * x_plane_y;
    const double t45 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t44 + t45 + 0.011 * u_y;
    const double z_z_by_q71 = t35 + cos_q71 * sin_A_by_q71 - t36 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t37 - cos_q71 * cos_A_by_q71 + t38 + sin_q71 * x_plane_x_by_q71;
    const double t46 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t47 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t46 + t47 - t41;
    const double z_z = t27 + t28;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t30 - t31;
    const double t48 = 0.004 * x_z;
    const double t49 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t48 - t49 + t34;
    const double t50 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
        * layer_0_z_by_q71;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    const double t51 = 1.0 / length_0;
    const double length_0_by_q71 = t50 * t51;
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
    const double t52 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t52 * t26;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t53 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t53 * t26;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t54 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t55 = 0.01 * z_x_by_q73;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double layer_0_x_by_q73 = t54 + t55 - 0.011 * y_x_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t56 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t57 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t56 + t57 - 0.011 * u_y_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t58 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t59 = 0.01 * z_z_by_q73;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double layer_0_z_by_q73 = t58 + t59 - 0.011 * y_z_by_q73;
    const double t60 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
        * layer_0_z_by_q73;
    const double length_0_by_q73 = t60 * t51;
    P[1] = -length_0_by_q73;
    const double t61 = 0.013 * y_z;
    const double t62 = 0.013 * y_x;
    const double layer_1_x_by_q71 = t32 - t33 - t61;
    const double layer_1_x = t39 + t40 + t62;
    const double layer_1_y_by_q71 = t42 + t43;
    const double layer_1_y = 0.006 - origin_y - t44 - t45 + 0.013 * u_y;
    const double layer_1_z_by_q71 = t46 - t47 - t62;
    const double layer_1_z = 0.028 - origin_z - t48 + t49 + t61;
    const double t63 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
        * layer_1_z_by_q71;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    const double t64 = 1.0 / length_19;
    const double length_19_by_q71 = t63 * t64;
    P[38] = length_19_by_q71;
    const double layer_1_x_by_q73 = t54 - t55 - 0.013 * y_x_by_q73;
    const double layer_1_y_by_q73 = t56 - t57 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t58 - t59 - 0.013 * y_z_by_q73;
    const double t65 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
        * layer_1_z_by_q73;
    const double length_19_by_q73 = t65 * t64;
    P[39] = -length_19_by_q73;
    static const double table67[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i66 = 0; i66 < 18; ++i66) {
        const double t68 = table67[i66][0] * y_x;
        const double strand_x = layer_0_x - t68;
        const double t69 = table67[i66][0] * y_z;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t69;
        const double strand_y = table67[i66][1] + layer_0_y - table67[i66][0] * u_y;
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
        P[2 + 2 * i66] = length_by_q71;
        P[3 + 2 * i66] = -length_by_q73;
    }
    static const double table74[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i73 = 0; i73 < 18; ++i73) {
        const double t75 = table74[i73][0] * y_x;
        const double strand_x_2 = layer_1_x - t75;
        const double t76 = table74[i73][0] * y_z;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t76;
        const double strand_y_2 = table74[i73][1] + layer_1_y - table74[i73][0] * u_y;
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
        P[40 + 2 * i73] = length_by_q71_2;
        P[41 + 2 * i73] = -length_by_q73_2;
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
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t58 = 0.004 * u_e;
    const double t59 = origin_y_by_q71_by_q71 + t58 * sin_A_by_q71_by_q71;
    const double t60 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t59 - t60;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t61 = 0.004 * x_plane_y;
    const double t62 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t61 + t62 + 0.011 * u_y;
    const double t63 = layer_0_x * layer_0_x_by_q71_by_q71 - layer_0_y * layer_0_y_by_q71_by_q71;
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
    const double y_z = sin_q71 * u_e;
    const double t72 = 0.011 * y_z;
    const double layer_0_z_by_q71_by_q71 = t70 + t71 - t72;
    const double z_z = t64 + t65;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t67 - t68;
    const double t73 = 0.004 * x_z;
    const double t74 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t73 - t74 + t72;
    const double z_x_by_q71 = t64 - cos_q71 * z_plane_x_by_q71 + t65 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_x_by_q71 = t67 + cos_q71 * x_plane_x_by_q71 - t68 + sin_q71 * cos_A_by_q71;
    const double t75 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t76 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t75 + t76 - t72;
    const double t77 = t63 + layer_0_z * layer_0_z_by_q71_by_q71 + layer_0_x_by_q71
        * layer_0_x_by_q71;
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
    const double layer_0_z_by_q71 = t81 + t82 - t55;
    const double t83 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
        * layer_0_z_by_q71;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    const double t84 = 1.0 / length_0;
    const double length_0_by_q71 = t83 * t84;
    const double t85 = t77 + t80 + layer_0_z_by_q71 * layer_0_z_by_q71 - length_0_by_q71
        * length_0_by_q71;
    const double length_0_by_q71_by_q71 = t85 * t84;
    H[0] = length_0_by_q71_by_q71;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t86 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t86;
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
    const double t87 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t12, t8 * p_y_by_q71_by_q73 - t36
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t87) * t13;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t17
        * p_z * u_e_by_q73 - t31 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t19, -(reach_by_q71_by_q73 * t15
        - projection_by_q71_by_q73 * t16), reach_by_q71_by_q73);
    const double t88 = t21 * reach_by_q71_by_q73 - t20 * limited_by_q71_by_q73 + t87 - t27
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t24, t88, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t26 * root_by_q73) * t25;
    const double t89 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t90 = t89 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t91 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t91 * t35;
    const double t92 = t90 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t92 * t35;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t93 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t93 * t35;
    const double t94 = cos_q71 * sin_A_by_q73;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t95 = sin_q71 * z_plane_x_by_q73;
    const double t96 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t97 = t96 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t98 = t97 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t98 * t35;
    const double z_x_by_q71_by_q73 = t94 - cos_q71 * z_plane_x_by_q71_by_q73 + t95 + sin_q71
        * sin_A_by_q71_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_x_by_q71_by_q73 = M_z_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double t99 = cos_q71 * cos_A_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t100 = sin_q71 * x_plane_x_by_q73;
    const double x_x_by_q71_by_q73 = t99 + cos_q71 * x_plane_x_by_q71_by_q73 - t100 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t101 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t102 = 0.01 * z_x_by_q71_by_q73;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t103 = 0.011 * y_z_by_q73;
    const double layer_0_x_by_q71_by_q73 = t101 + t102 - t103;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t104 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t105 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t104 - t105;
    const double t106 = layer_0_x * layer_0_x_by_q71_by_q73 - layer_0_y * layer_0_y_by_q71_by_q73;
    const double t107 = cos_q71 * z_plane_x_by_q73;
    const double t108 = sin_q71 * sin_A_by_q73;
    const double z_z_by_q71_by_q73 = t107 + cos_q71 * sin_A_by_q71_by_q73 - t108 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_z_by_q71_by_q73 = M_x_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double t109 = cos_q71 * x_plane_x_by_q73;
    const double t110 = sin_q71 * cos_A_by_q73;
    const double x_z_by_q71_by_q73 = t109 - cos_q71 * cos_A_by_q71_by_q73 + t110 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t111 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t112 = 0.01 * z_z_by_q71_by_q73;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double t113 = 0.011 * y_x_by_q73;
    const double layer_0_z_by_q71_by_q73 = t111 + t112 - t113;
    const double z_x_by_q73 = t107 - t108;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_x_by_q73 = t109 + t110;
    const double t114 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t115 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t114 + t115 - t113;
    const double t116 = t106 - layer_0_z * layer_0_z_by_q71_by_q73 - layer_0_x_by_q71
        * layer_0_x_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t117 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t118 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t117 + t118 - 0.011 * u_y_by_q73;
    const double z_z_by_q73 = t94 + t95;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = t99 - t100;
    const double t119 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t120 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t119 + t120 - t103;
    const double t121 = t116 - layer_0_y_by_q71 * layer_0_y_by_q73 + layer_0_z_by_q71
        * layer_0_z_by_q73;
    const double t122 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
        * layer_0_z_by_q73;
    const double length_0_by_q73 = t122 * t84;
    const double length_0_by_q71_by_q73 = (t121 + length_0_by_q71 * length_0_by_q73) * t84;
    H[1] = length_0_by_q71_by_q73;
    H[2] = length_0_by_q71_by_q73;
    const double t123 = reach_by_q73 * reach_by_q73;
    const double t124 = t123 + t123;
    const double t125 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t125 * t2;
    const double C_y_by_q73_by_q73 = t86 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t126 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t127 = u_e_by_q73 + u_e_by_q73;
    const double t128 = u_y_by_q73 + u_y_by_q73;
    const double p_y_by_q73_by_q73 = t126 - s_y * u_e_by_q73_by_q73 + t127 * M_y_by_q73 - t128
        * M_e_by_q73;
    const double t129 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t12, t129 * p_y_by_q73 + t8
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t124) * t13;
    const double t130 = t124 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t21
        * reach_by_q73_by_q73;
    const double t131 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t132 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t132 - s_y * u_y_by_q73_by_q73 - t127 * M_e_by_q73 - t128
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t131 - t17 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t19, -(reach_by_q73_by_q73 * t15
        - projection_by_q73_by_q73 * t16), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t24, t130 - t20 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t133 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t133 * t25;
    const double t134 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t135 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t136 = t134 - sin_A * reach_squared_by_q73_by_q73 + t129 * root_by_q73 - t135
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t136 * t35;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t128 * sin_A_by_q73;
    const double t137 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t138 = t137 - cos_A * reach_squared_by_q73_by_q73 + t129 * limited_by_q73 - t135
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t138 * t35;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t128 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t139 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t140 = 0.01 * z_x_by_q73_by_q73;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t139 - t140 - 0.011 * y_x_by_q73_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t127 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t127 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t141 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t142 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t141 + t142 - 0.011 * u_y_by_q73_by_q73;
    const double t143 = layer_0_x * layer_0_x_by_q73_by_q73 + layer_0_y * layer_0_y_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t144 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t145 = 0.01 * z_z_by_q73_by_q73;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t144 - t145 - 0.011 * y_z_by_q73_by_q73;
    const double t146 = t143 + layer_0_z * layer_0_z_by_q73_by_q73 + layer_0_x_by_q73
        * layer_0_x_by_q73;
    const double t147 = t146 + layer_0_y_by_q73 * layer_0_y_by_q73 + layer_0_z_by_q73
        * layer_0_z_by_q73;
    const double length_0_by_q73_by_q73 = (t147 - length_0_by_q73 * length_0_by_q73) * t84;
    H[3] = length_0_by_q73_by_q73;
    const double t148 = 0.013 * y_x;
    const double t149 = 0.013 * y_z;
    const double t150 = 0.013 * y_z_by_q73;
    const double t151 = 0.013 * y_x_by_q73;
    const double layer_1_x_by_q71_by_q71 = t53 - t54 - t148;
    const double layer_1_x = t56 + t57 + t148;
    const double layer_1_y_by_q71_by_q71 = t59 + t60;
    const double layer_1_y = 0.006 - origin_y - t61 - t62 + 0.013 * u_y;
    const double t152 = layer_1_x * layer_1_x_by_q71_by_q71 - layer_1_y * layer_1_y_by_q71_by_q71;
    const double layer_1_z_by_q71_by_q71 = t70 - t71 - t149;
    const double layer_1_z = 0.028 - origin_z - t73 + t74 + t149;
    const double layer_1_x_by_q71 = t75 - t76 - t149;
    const double t153 = t152 + layer_1_z * layer_1_z_by_q71_by_q71 + layer_1_x_by_q71
        * layer_1_x_by_q71;
    const double layer_1_y_by_q71 = t78 + t79;
    const double t154 = layer_1_y_by_q71 * layer_1_y_by_q71;
    const double layer_1_z_by_q71 = t81 - t82 - t148;
    const double t155 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
        * layer_1_z_by_q71;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    const double t156 = 1.0 / length_19;
    const double length_19_by_q71 = t155 * t156;
    const double t157 = t153 + t154 + layer_1_z_by_q71 * layer_1_z_by_q71 - length_19_by_q71
        * length_19_by_q71;
    const double length_19_by_q71_by_q71 = t157 * t156;
    H[76] = length_19_by_q71_by_q71;
    const double layer_1_x_by_q71_by_q73 = t101 - t102 - t150;
    const double layer_1_y_by_q71_by_q73 = t104 + t105;
    const double t158 = layer_1_x * layer_1_x_by_q71_by_q73 - layer_1_y * layer_1_y_by_q71_by_q73;
    const double layer_1_z_by_q71_by_q73 = t111 - t112 - t151;
    const double layer_1_x_by_q73 = t114 - t115 - t151;
    const double t159 = t158 - layer_1_z * layer_1_z_by_q71_by_q73 - layer_1_x_by_q71
        * layer_1_x_by_q73;
    const double layer_1_y_by_q73 = t117 - t118 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t119 - t120 - t150;
    const double t160 = t159 - layer_1_y_by_q71 * layer_1_y_by_q73 + layer_1_z_by_q71
        * layer_1_z_by_q73;
    const double t161 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
        * layer_1_z_by_q73;
    const double length_19_by_q73 = t161 * t156;
    const double length_19_by_q71_by_q73 = (t160 + length_19_by_q71 * length_19_by_q73) * t156;
    H[77] = length_19_by_q71_by_q73;
    H[78] = length_19_by_q71_by_q73;
    const double layer_1_x_by_q73_by_q73 = t139 + t140 - 0.013 * y_x_by_q73_by_q73;
    const double layer_1_y_by_q73_by_q73 = t141 - t142 - 0.013 * u_y_by_q73_by_q73;
    const double t162 = layer_1_x * layer_1_x_by_q73_by_q73 + layer_1_y * layer_1_y_by_q73_by_q73;
    const double layer_1_z_by_q73_by_q73 = t144 + t145 - 0.013 * y_z_by_q73_by_q73;
    const double t163 = t162 + layer_1_z * layer_1_z_by_q73_by_q73 + layer_1_x_by_q73
        * layer_1_x_by_q73;
    const double t164 = t163 + layer_1_y_by_q73 * layer_1_y_by_q73 + layer_1_z_by_q73
        * layer_1_z_by_q73;
    const double length_19_by_q73_by_q73 = (t164 - length_19_by_q73 * length_19_by_q73) * t156;
    H[79] = length_19_by_q73_by_q73;
    static const double table166[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i165 = 0; i165 < 18; ++i165) {
        const double t167 = table166[i165][0] * y_x;
        const double strand_x = layer_0_x - t167;
        const double strand_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 + t167;
        const double strand_y = table166[i165][1] + layer_0_y - table166[i165][0] * u_y;
        const double t168 = table166[i165][0] * y_z;
        const double strand_z = layer_0_z - t168;
        const double strand_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 + t168;
        const double t169 = strand_x * strand_x_by_q71_by_q71 - strand_y * layer_0_y_by_q71_by_q71
            + strand_z * strand_z_by_q71_by_q71;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t168;
        const double strand_z_by_q71 = layer_0_z_by_q71 + t167;
        const double t170 = t169 + t80 + strand_x_by_q71 * strand_x_by_q71 + strand_z_by_q71
            * strand_z_by_q71;
        const double t171 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t172 = 1.0 / length;
        const double length_by_q71 = t171 * t172;
        const double length_by_q71_by_q71 = (t170 - length_by_q71 * length_by_q71) * t172;
        const double t173 = table166[i165][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 + t173;
        const double t174 = table166[i165][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 + t174;
        const double t175 = strand_x * strand_x_by_q71_by_q73 - strand_y * layer_0_y_by_q71_by_q73
            - strand_z * strand_z_by_q71_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 + table166[i165][0] * u_y_by_q73;
        const double strand_x_by_q73 = layer_0_x_by_q73 + t174;
        const double t176 = t175 - layer_0_y_by_q71 * strand_y_by_q73 - strand_x_by_q71
            * strand_x_by_q73;
        const double strand_z_by_q73 = layer_0_z_by_q73 + t173;
        const double t177 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t177 * t172;
        const double length_by_q71_by_q73 = (t176 + strand_z_by_q71 * strand_z_by_q73
            + length_by_q71 * length_by_q73) * t172;
        const double strand_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 + table166[i165][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 + table166[i165][0]
            * u_y_by_q73_by_q73;
        const double strand_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 + table166[i165][0]
            * y_z_by_q73_by_q73;
        const double t178 = strand_x * strand_x_by_q73_by_q73 + strand_y * strand_y_by_q73_by_q73
            + strand_z * strand_z_by_q73_by_q73;
        const double t179 = t178 + strand_x_by_q73 * strand_x_by_q73 + strand_y_by_q73
            * strand_y_by_q73;
        const double length_by_q73_by_q73 = (t179 + strand_z_by_q73 * strand_z_by_q73
            - length_by_q73 * length_by_q73) * t172;
        H[4 + 4 * i165] = length_by_q71_by_q71;
        H[5 + 4 * i165] = length_by_q71_by_q73;
        H[6 + 4 * i165] = length_by_q71_by_q73;
        H[7 + 4 * i165] = length_by_q73_by_q73;
    }
    static const double table181[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i180 = 0; i180 < 18; ++i180) {
        const double t182 = table181[i180][0] * y_x;
        const double strand_x_2 = layer_1_x - t182;
        const double strand_x_by_q71_by_q71_2 = layer_1_x_by_q71_by_q71 + t182;
        const double strand_y_2 = table181[i180][1] + layer_1_y - table181[i180][0] * u_y;
        const double t183 = strand_x_2 * strand_x_by_q71_by_q71_2 - strand_y_2
            * layer_1_y_by_q71_by_q71;
        const double t184 = table181[i180][0] * y_z;
        const double strand_z_2 = layer_1_z - t184;
        const double strand_z_by_q71_by_q71_2 = layer_1_z_by_q71_by_q71 + t184;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t184;
        const double t185 = t183 + strand_z_2 * strand_z_by_q71_by_q71_2 + t154 + strand_x_by_q71_2
            * strand_x_by_q71_2;
        const double strand_z_by_q71_2 = layer_1_z_by_q71 + t182;
        const double t186 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_1_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t187 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t187);
        const double t188 = 1.0 / length_2;
        const double length_by_q71_2 = t186 * t188;
        const double t189 = t185 + strand_z_by_q71_2 * strand_z_by_q71_2 - length_by_q71_2
            * length_by_q71_2;
        const double length_by_q71_by_q71_2 = t189 * t188;
        const double t190 = table181[i180][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_2 = layer_1_x_by_q71_by_q73 + t190;
        const double t191 = strand_x_2 * strand_x_by_q71_by_q73_2 - strand_y_2
            * layer_1_y_by_q71_by_q73;
        const double t192 = table181[i180][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_2 = layer_1_z_by_q71_by_q73 + t192;
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table181[i180][0] * u_y_by_q73;
        const double t193 = t191 - strand_z_2 * strand_z_by_q71_by_q73_2 - layer_1_y_by_q71
            * strand_y_by_q73_2;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + t192;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + t190;
        const double t194 = t193 - strand_x_by_q71_2 * strand_x_by_q73_2 + strand_z_by_q71_2
            * strand_z_by_q73_2;
        const double t195 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t195 * t188;
        const double length_by_q71_by_q73_2 = (t194 + length_by_q71_2 * length_by_q73_2) * t188;
        const double strand_x_by_q73_by_q73_2 = layer_1_x_by_q73_by_q73 + table181[i180][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_2 = layer_1_y_by_q73_by_q73 + table181[i180][0]
            * u_y_by_q73_by_q73;
        const double t196 = strand_x_2 * strand_x_by_q73_by_q73_2 + strand_y_2
            * strand_y_by_q73_by_q73_2;
        const double strand_z_by_q73_by_q73_2 = layer_1_z_by_q73_by_q73 + table181[i180][0]
            * y_z_by_q73_by_q73;
        const double t197 = t196 + strand_z_2 * strand_z_by_q73_by_q73_2 + strand_x_by_q73_2
            * strand_x_by_q73_2;
        const double t198 = t197 + strand_y_by_q73_2 * strand_y_by_q73_2 + strand_z_by_q73_2
            * strand_z_by_q73_2;
        const double length_by_q73_by_q73_2 = (t198 - length_by_q73_2 * length_by_q73_2) * t188;
        H[80 + 4 * i180] = length_by_q71_by_q71_2;
        H[81 + 4 * i180] = length_by_q71_by_q73_2;
        H[82 + 4 * i180] = length_by_q71_by_q73_2;
        H[83 + 4 * i180] = length_by_q73_by_q73_2;
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
    const double z_plane_y_by_t = u_e * cos_A_by_t + cos_A * u_e_by_t;
    const double origin_y_by_t = M_y_by_t - 0.018 * z_plane_y_by_t;
    const double x_plane_y_by_t = u_e * sin_A_by_t + sin_A * u_e_by_t;
    const double t20 = origin_y_by_t - 0.004 * x_plane_y_by_t;
    const double t21 = 0.01 * z_plane_y_by_t;
    const double layer_0_y_by_t = t20 + t21 - 0.011 * u_y_by_t;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t22 = 0.004 * x_plane_y;
    const double t23 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t22 + t23 + 0.011 * u_y;
    const double z_z_by_t = cos_q71 * sin_A_by_t + sin_q71 * z_plane_x_by_t - sin_A * cos_q71_by_t
        + z_plane_x * sin_q71_by_t;
    const double M_z_by_t = sin_q71 * M_e_by_t + M_e * sin_q71_by_t;
    const double origin_z_by_t = M_z_by_t - 0.018 * z_z_by_t;
    const double x_z_by_t = cos_q71 * cos_A_by_t - sin_q71 * x_plane_x_by_t - cos_A * cos_q71_by_t
        - x_plane_x * sin_q71_by_t;
    const double t24 = origin_z_by_t + 0.004 * x_z_by_t;
    const double t25 = 0.01 * z_z_by_t;
    const double y_z_by_t = sin_q71 * u_e_by_t + u_e * sin_q71_by_t;
    const double layer_0_z_by_t = t24 + t25 - 0.011 * y_z_by_t;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t26 = 0.004 * x_z;
    const double t27 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t26 - t27 + 0.011 * y_z;
    const double t28 = layer_0_x * layer_0_x_by_t - layer_0_y * layer_0_y_by_t + layer_0_z
        * layer_0_z_by_t;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    const double length_0_by_t = t28 / length_0;
    delta_theta_rate[0] = 200.0 * length_0_by_t;
    const double layer_1_x_by_t = t16 - t17 - 0.013 * y_x_by_t;
    const double layer_1_x = t18 + t19 + 0.013 * y_x;
    const double layer_1_y_by_t = t20 - t21 - 0.013 * u_y_by_t;
    const double layer_1_y = 0.006 - origin_y - t22 - t23 + 0.013 * u_y;
    const double layer_1_z_by_t = t24 - t25 - 0.013 * y_z_by_t;
    const double layer_1_z = 0.028 - origin_z - t26 + t27 + 0.013 * y_z;
    const double t29 = layer_1_x * layer_1_x_by_t - layer_1_y * layer_1_y_by_t + layer_1_z
        * layer_1_z_by_t;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    const double length_19_by_t = t29 / length_19;
    delta_theta_rate[19] = 200.0 * length_19_by_t;
    static const double table31[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i30 = 0; i30 < 18; ++i30) {
        const double strand_x = layer_0_x - table31[i30][0] * y_x;
        const double strand_x_by_t = layer_0_x_by_t + table31[i30][0] * y_x_by_t;
        const double strand_y = table31[i30][1] + layer_0_y - table31[i30][0] * u_y;
        const double strand_y_by_t = layer_0_y_by_t + table31[i30][0] * u_y_by_t;
        const double strand_z = layer_0_z - table31[i30][0] * y_z;
        const double strand_z_by_t = layer_0_z_by_t + table31[i30][0] * y_z_by_t;
        const double t32 = strand_x * strand_x_by_t - strand_y * strand_y_by_t + strand_z
            * strand_z_by_t;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double length_by_t = t32 / length;
        delta_theta_rate[1 + i30] = 200.0 * length_by_t;
    }
    static const double table34[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i33 = 0; i33 < 18; ++i33) {
        const double strand_x_2 = layer_1_x - table34[i33][0] * y_x;
        const double strand_x_by_t_2 = layer_1_x_by_t + table34[i33][0] * y_x_by_t;
        const double strand_y_2 = table34[i33][1] + layer_1_y - table34[i33][0] * u_y;
        const double strand_y_by_t_2 = layer_1_y_by_t + table34[i33][0] * u_y_by_t;
        const double strand_z_2 = layer_1_z - table34[i33][0] * y_z;
        const double strand_z_by_t_2 = layer_1_z_by_t + table34[i33][0] * y_z_by_t;
        const double t35 = strand_x_2 * strand_x_by_t_2 - strand_y_2 * strand_y_by_t_2 + strand_z_2
            * strand_z_by_t_2;
        const double t36 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t36);
        const double length_by_t_2 = t35 / length_2;
        delta_theta_rate[20 + i33] = 200.0 * length_by_t_2;
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
    const double t29 = 0.011 * y_x;
    const double t30 = sin_q71 * sin_A;
    const double z_plane_x = u_y * cos_A;
    const double t31 = cos_q71 * z_plane_x;
    const double z_x = t31 - t30;
    const double t32 = 0.01 * z_x;
    const double t33 = sin_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t34 = cos_q71 * x_plane_x;
    const double x_x = t34 + t33;
    const double M_x = cos_q71 * M_e;
    const double t35 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double layer_0_x = t35 - t32 + t29;
    const double y_z = sin_q71 * u_e;
    const double t36 = 0.011 * y_z;
    const double t37 = cos_q71 * sin_A;
    const double t38 = sin_q71 * z_plane_x;
    const double z_z = t37 + t38;
    const double t39 = 0.01 * z_z;
    const double t40 = cos_q71 * cos_A;
    const double t41 = sin_q71 * x_plane_x;
    const double x_z = t40 - t41;
    const double t42 = 0.004 * x_z;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double layer_0_z = 0.008 - origin_z - t42 - t39 + t36;
    const double z_plane_y = u_e * cos_A;
    const double t43 = 0.01 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t44 = 0.004 * x_plane_y;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t44 + t43 + 0.011 * u_y;
    const double t45 = 0.013 * y_x;
    const double t46 = 0.013 * y_z;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    const double per_length_0 = f[0] / length_0;
    const double pull_0_x = layer_0_x * per_length_0;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double t47 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double pull_0_y = layer_0_y * per_length_0;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double t48 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double pull_0_z = layer_0_z * per_length_0;
    const double layer_1_x = t35 + t32 + t45;
    const double layer_1_z = 0.028 - origin_z - t42 + t39 + t46;
    const double layer_1_y = 0.006 - origin_y - t44 - t43 + 0.013 * u_y;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    const double per_length_19 = f[19] / length_19;
    const double pull_19_x = layer_1_x * per_length_19;
    const double pull_19_y = layer_1_y * per_length_19;
    const double pull_19_z = layer_1_z * per_length_19;
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
    const double z_x_by_q71 = t37 - cos_q71 * z_plane_x_by_q71 + t38 + sin_q71 * sin_A_by_q71;
    const double t51 = 0.01 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t40 + cos_q71 * x_plane_x_by_q71 - t41 + sin_q71 * cos_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double t52 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double layer_0_x_by_q71 = t52 + t51 - t36;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double z_z_by_q71 = t31 + cos_q71 * sin_A_by_q71 - t30 + sin_q71 * z_plane_x_by_q71;
    const double t53 = 0.01 * z_z_by_q71;
    const double x_z_by_q71 = t34 - cos_q71 * cos_A_by_q71 + t33 + sin_q71 * x_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double t54 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double layer_0_z_by_q71 = t54 + t53 - t29;
    const double layer_1_x_by_q71 = t52 - t51 - t46;
    const double layer_1_z_by_q71 = t54 - t53 - t45;
    static const double table62[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    double sum56 = -0.0;
    double sum57 = -0.0;
    double sum58 = -0.0;
    double sum59 = pull_0_z;
    double sum60 = pull_0_y;
    double sum61 = pull_0_x;
    for (int i55 = 0; i55 < 18; ++i55) {
        const double before63 = sum56;
        const double before64 = sum57;
        const double before65 = sum58;
        const double before66 = sum59;
        const double before67 = sum60;
        const double before68 = sum61;
        const double strand_z = layer_0_z - table62[i55][0] * y_z;
        const double strand_x = layer_0_x - table62[i55][0] * y_x;
        const double strand_y = table62[i55][1] + layer_0_y - table62[i55][0] * u_y;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double per_length = f[1 + i55] / length;
        const double t69 = table62[i55][0] * per_length;
        const double pull_by_y_z = strand_z * t69;
        const double pull_by_y_y = strand_y * t69;
        const double pull_by_y_x = strand_x * t69;
        const double pull_z = strand_z * per_length;
        const double pull_y = strand_y * per_length;
        const double pull_x = strand_x * per_length;
        sum56 = before63 + pull_by_y_z;
        sum57 = before64 + pull_by_y_y;
        sum58 = before65 + pull_by_y_x;
        sum59 = before66 + pull_z;
        sum60 = before67 + pull_y;
        sum61 = before68 + pull_x;
    }
    static const double table77[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    double sum71 = -0.0;
    double sum72 = -0.0;
    double sum73 = -0.0;
    double sum74 = pull_19_z;
    double sum75 = pull_19_y;
    double sum76 = pull_19_x;
    for (int i70 = 0; i70 < 18; ++i70) {
        const double before78 = sum71;
        const double before79 = sum72;
        const double before80 = sum73;
        const double before81 = sum74;
        const double before82 = sum75;
        const double before83 = sum76;
        const double strand_z_2 = layer_1_z - table77[i70][0] * y_z;
        const double strand_x_2 = layer_1_x - table77[i70][0] * y_x;
        const double strand_y_2 = table77[i70][1] + layer_1_y - table77[i70][0] * u_y;
        const double t84 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t84);
        const double per_length_2 = f[20 + i70] / length_2;
        const double t85 = table77[i70][0] * per_length_2;
        const double pull_by_y_z_2 = strand_z_2 * t85;
        const double pull_by_y_y_2 = strand_y_2 * t85;
        const double pull_by_y_x_2 = strand_x_2 * t85;
        const double pull_z_2 = strand_z_2 * per_length_2;
        const double pull_y_2 = strand_y_2 * per_length_2;
        const double pull_x_2 = strand_x_2 * per_length_2;
        sum71 = before78 + pull_by_y_z_2;
        sum72 = before79 + pull_by_y_y_2;
        sum73 = before80 + pull_by_y_x_2;
        sum74 = before81 + pull_z_2;
        sum75 = before82 + pull_y_2;
        sum76 = before83 + pull_x_2;
    }
    const double t86 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t28 + t86 - 0.011 * y_x_by_q73;
    const double t87 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t47 + t87 - 0.011 * u_y_by_q73;
    const double t88 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t48 + t88 - 0.011 * y_z_by_q73;
    const double t89 = sum61 * layer_0_x_by_q73 - sum60 * layer_0_y_by_q73 + sum59
        * layer_0_z_by_q73;
    const double layer_1_x_by_q73 = t28 - t86 - 0.013 * y_x_by_q73;
    const double layer_1_y_by_q73 = t47 - t87 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t48 - t88 - 0.013 * y_z_by_q73;
    const double t90 = t89 + sum76 * layer_1_x_by_q73 - sum75 * layer_1_y_by_q73 + sum74
        * layer_1_z_by_q73;
    const double pull_by_y = sum58 + sum73;
    const double pull_by_y_2 = sum57 + sum72;
    const double pull_by_y_4 = sum56 + sum71;
    const double t91 = t90 + pull_by_y * y_x_by_q73 - pull_by_y_2 * u_y_by_q73 + pull_by_y_4
        * y_z_by_q73;
    const double t92 = 0.01 * z_plane_y_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t93 = origin_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
    const double layer_0_y_by_q71 = t93 - t92;
    const double t94 = y_x * pull_by_y_4 - y_z * pull_by_y - sum61 * layer_0_x_by_q71 + sum60
        * layer_0_y_by_q71;
    const double layer_1_y_by_q71 = t93 + t92;
    const double t95 = t94 + sum59 * layer_0_z_by_q71 - sum76 * layer_1_x_by_q71 + sum75
        * layer_1_y_by_q71;
    tau[0] = t95 + sum74 * layer_1_z_by_q71;
    tau[1] = t91;
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
    const double t26 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double t27 = p_z * root;
    const double t28 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + t27) * t28;
    const double cos_A_by_q71 = (t26 - cos_A * reach_squared_by_q71) * t28;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t29 = p_z * limited;
    const double sin_A = (p_y * root - t29) * t28;
    const double t30 = cos_q71 * sin_A;
    const double z_plane_x = u_y * cos_A;
    const double t31 = sin_q71 * z_plane_x;
    const double t32 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t32 - sin_A * reach_squared_by_q71) * t28;
    const double z_x_by_q71 = t30 - cos_q71 * z_plane_x_by_q71 + t31 + sin_q71 * sin_A_by_q71;
    const double M_z = sin_q71 * M_e;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double t33 = cos_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t34 = sin_q71 * x_plane_x;
    const double x_x_by_q71 = t33 + cos_q71 * x_plane_x_by_q71 - t34 + sin_q71 * cos_A_by_q71;
    const double t35 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t36 = 0.01 * z_x_by_q71;
    const double y_z = sin_q71 * u_e;
    const double t37 = 0.011 * y_z;
    const double layer_0_x_by_q71 = t35 + t36 - t37;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t38 = 0.004 * u_e;
    const double t39 = origin_y_by_q71 + t38 * sin_A_by_q71;
    const double t40 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t39 - t40;
    const double t41 = layer_0_x_by_q71 * layer_0_x_by_q71 + layer_0_y_by_q71 * layer_0_y_by_q71;
    const double t42 = cos_q71 * z_plane_x;
    const double t43 = sin_q71 * sin_A;
    const double z_z_by_q71 = t42 + cos_q71 * sin_A_by_q71 - t43 + sin_q71 * z_plane_x_by_q71;
    const double M_x = cos_q71 * M_e;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double t44 = cos_q71 * x_plane_x;
    const double t45 = sin_q71 * cos_A;
    const double x_z_by_q71 = t44 - cos_q71 * cos_A_by_q71 + t45 + sin_q71 * x_plane_x_by_q71;
    const double t46 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t47 = 0.01 * z_z_by_q71;
    const double y_x = cos_q71 * u_e;
    const double t48 = 0.011 * y_x;
    const double layer_0_z_by_q71 = t46 + t47 - t48;
    const double along_38 = t41 + layer_0_z_by_q71 * layer_0_z_by_q71;
    const double z_x = t42 - t43;
    const double x_x = t44 + t45;
    const double t49 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t50 = 0.01 * z_x;
    const double layer_0_x = t49 - t50 + t48;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double x_plane_y = u_e * sin_A;
    const double t51 = 0.004 * x_plane_y;
    const double t52 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t51 + t52 + 0.011 * u_y;
    const double z_z = t30 + t31;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t33 - t34;
    const double t53 = 0.004 * x_z;
    const double t54 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t53 - t54 + t37;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    const double t55 = 1.0 / length_0;
    const double per_length_0 = f[0] * t55;
    const double t56 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
        * layer_0_z_by_q71;
    const double length_0_by_q71 = t56 * t55;
    const double across_0 = k[0] - per_length_0;
    const double t57 = y_x + y_x;
    const double t58 = y_z + y_z;
    const double along_by_y_4 = t57 * layer_0_z_by_q71 + t58 * layer_0_x_by_q71;
    const double along_by_y_squared_4 = y_x * y_x + y_z * y_z;
    const double t59 = 0.013 * y_x;
    const double t60 = 0.013 * y_z;
    const double layer_1_x_by_q71 = t35 - t36 - t60;
    const double layer_1_y_by_q71 = t39 + t40;
    const double t61 = layer_1_x_by_q71 * layer_1_x_by_q71 + layer_1_y_by_q71 * layer_1_y_by_q71;
    const double layer_1_z_by_q71 = t46 - t47 - t59;
    const double along_40 = t61 + layer_1_z_by_q71 * layer_1_z_by_q71;
    const double layer_1_x = t49 + t50 + t59;
    const double layer_1_y = 0.006 - origin_y - t51 - t52 + 0.013 * u_y;
    const double layer_1_z = 0.028 - origin_z - t53 + t54 + t60;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    const double t62 = 1.0 / length_19;
    const double per_length_19 = f[19] * t62;
    const double t63 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
        * layer_1_z_by_q71;
    const double length_19_by_q71 = t63 * t62;
    const double across_19 = k[19] - per_length_19;
    const double t64 = per_length_19 * along_40 + across_19 * length_19_by_q71 * length_19_by_q71;
    const double along_by_y_6 = t57 * layer_1_z_by_q71 + t58 * layer_1_x_by_q71;
    const double pull_0_x = layer_0_x * per_length_0;
    const double t65 = root_by_q71 + root_by_q71;
    const double t66 = limited_by_q71 + limited_by_q71;
    const double t67 = reach_by_q71 * reach_by_q71;
    const double t68 = t67 + t67;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t69 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t12, t69 + t69 + t8 * p_y_by_q71_by_q71
        - t9 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t68) * t13;
    const double t70 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t70
        * p_x_by_q71 + t17 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t19, -(reach_by_q71_by_q71 * t15
        - projection_by_q71_by_q71 * t16), reach_by_q71_by_q71);
    const double t71 = t68 - t66 * limited_by_q71 + t21 * reach_by_q71_by_q71 - t20
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t24, t71, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t65 * root_by_q71) * t25;
    const double t72 = p_y * limited_by_q71_by_q71 - t27 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t73 = p_y_by_q71 + p_y_by_q71;
    const double t74 = p_z_by_q71 + p_z_by_q71;
    const double t75 = t72 - cos_A * reach_squared_by_q71_by_q71 - t73 * limited_by_q71 - t74
        * root_by_q71;
    const double t76 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t75 - t76 * cos_A_by_q71) * t28;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t77 = p_y * root_by_q71_by_q71 + t29 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t78 = t77 - sin_A * reach_squared_by_q71_by_q71 - t73 * root_by_q71 + t74
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t78 - t76 * sin_A_by_q71) * t28;
    const double t79 = t42 - cos_q71 * z_plane_x_by_q71_by_q71 - t43 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t80 = cos_q71 + cos_q71;
    const double t81 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t79 + t80 * sin_A_by_q71 + t81 * z_plane_x_by_q71;
    const double origin_x_by_q71_by_q71 = M_x - 0.018 * z_x_by_q71_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t82 = t44 - cos_q71 * x_plane_x_by_q71_by_q71 + t45 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t82 - t80 * cos_A_by_q71 + t81 * x_plane_x_by_q71;
    const double t83 = origin_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t84 = 0.01 * z_x_by_q71_by_q71;
    const double layer_0_x_by_q71_by_q71 = t83 + t84 - t48;
    const double pull_0_y = layer_0_y * per_length_0;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double pull_0_z = layer_0_z * per_length_0;
    const double t85 = t30 - cos_q71 * sin_A_by_q71_by_q71 + t31 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t85 - t80 * z_plane_x_by_q71 + t81 * sin_A_by_q71;
    const double origin_z_by_q71_by_q71 = M_z - 0.018 * z_z_by_q71_by_q71;
    const double t86 = t33 - cos_q71 * cos_A_by_q71_by_q71 - t34 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t86 + t80 * x_plane_x_by_q71 + t81 * cos_A_by_q71;
    const double t87 = origin_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t88 = 0.01 * z_z_by_q71_by_q71;
    const double layer_0_z_by_q71_by_q71 = t87 + t88 - t37;
    const double pull_19_x = layer_1_x * per_length_19;
    const double layer_1_x_by_q71_by_q71 = t83 - t84 - t59;
    const double pull_19_y = layer_1_y * per_length_19;
    const double pull_19_z = layer_1_z * per_length_19;
    const double layer_1_z_by_q71_by_q71 = t87 - t88 - t60;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t89 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t89;
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
    const double t90 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t90 * t28;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t91 = cos_q71 * z_plane_x_by_q73;
    const double t92 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t92 * t28;
    const double t93 = sin_q71 * sin_A_by_q73;
    const double z_x_by_q73 = t91 - t93;
    const double M_z_by_q71_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t94 = cos_q71 * x_plane_x_by_q73;
    const double t95 = sin_q71 * cos_A_by_q73;
    const double x_x_by_q73 = t94 + t95;
    const double t96 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t97 = 0.01 * z_x_by_q73;
    const double y_z_by_q71_by_q73 = cos_q71 * u_e_by_q73;
    const double t98 = 0.011 * y_z_by_q71_by_q73;
    const double layer_0_x_by_q73 = t96 + t97 - t98;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t99 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t100 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t99 + t100 - 0.011 * u_y_by_q73;
    const double t101 = layer_0_x_by_q71 * layer_0_x_by_q73 + layer_0_y_by_q71 * layer_0_y_by_q73;
    const double t102 = sin_q71 * z_plane_x_by_q73;
    const double t103 = cos_q71 * sin_A_by_q73;
    const double z_z_by_q73 = t103 + t102;
    const double M_x_by_q71_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_x_by_q71_by_q73 - 0.018 * z_z_by_q73;
    const double t104 = sin_q71 * x_plane_x_by_q73;
    const double t105 = cos_q71 * cos_A_by_q73;
    const double x_z_by_q73 = t105 - t104;
    const double t106 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t107 = 0.01 * z_z_by_q73;
    const double y_x_by_q71_by_q73 = sin_q71 * u_e_by_q73;
    const double t108 = 0.011 * y_x_by_q71_by_q73;
    const double layer_0_z_by_q73 = t106 + t107 - t108;
    const double along = t101 - layer_0_z_by_q71 * layer_0_z_by_q73;
    const double t109 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
        * layer_0_z_by_q73;
    const double length_0_by_q73 = t109 * t55;
    const double K_0 = per_length_0 * along + length_0_by_q71 * length_0_by_q73 * across_0;
    const double t110 = y_x * layer_0_z_by_q73 - y_z * layer_0_x_by_q73 - layer_0_x_by_q71
        * y_z_by_q71_by_q73;
    const double along_by_y = t110 - u_y_by_q73 * layer_0_y_by_q71 + y_x_by_q71_by_q73
        * layer_0_z_by_q71;
    const double along_by_y_squared = y_x * y_x_by_q71_by_q73 - y_z * y_z_by_q71_by_q73;
    const double t111 = 0.013 * y_z_by_q71_by_q73;
    const double t112 = 0.013 * y_x_by_q71_by_q73;
    const double layer_1_x_by_q73 = t96 - t97 - t111;
    const double layer_1_y_by_q73 = t99 - t100 - 0.013 * u_y_by_q73;
    const double t113 = layer_1_x_by_q71 * layer_1_x_by_q73 + layer_1_y_by_q71 * layer_1_y_by_q73;
    const double layer_1_z_by_q73 = t106 - t107 - t112;
    const double along_19 = t113 - layer_1_z_by_q71 * layer_1_z_by_q73;
    const double t114 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
        * layer_1_z_by_q73;
    const double length_19_by_q73 = t114 * t62;
    const double K_19 = per_length_19 * along_19 + length_19_by_q71 * length_19_by_q73 * across_19;
    const double t115 = y_x * layer_1_z_by_q73 - y_z * layer_1_x_by_q73 - u_y_by_q73
        * layer_1_y_by_q71;
    const double along_by_y_2 = t115 + y_x_by_q71_by_q73 * layer_1_z_by_q71 - layer_1_x_by_q71
        * y_z_by_q71_by_q73;
    const double t116 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t12, t8 * p_y_by_q71_by_q73 - t73
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t116) * t13;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t17
        * p_z * u_e_by_q73 - t70 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t19, -(reach_by_q71_by_q73 * t15
        - projection_by_q71_by_q73 * t16), reach_by_q71_by_q73);
    const double t117 = t21 * reach_by_q71_by_q73 - t20 * limited_by_q71_by_q73 + t116 - t66
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t24, t117, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t65 * root_by_q73) * t25;
    const double t118 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t119 = t118 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t120 = t119 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t120 * t28;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t121 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t122 = t121 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t123 = t122 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t123 * t28;
    const double z_x_by_q71_by_q73 = t103 - cos_q71 * z_plane_x_by_q71_by_q73 + sin_q71
        * sin_A_by_q71_by_q73 + t102;
    const double origin_x_by_q71_by_q73 = M_x_by_q71_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t105 + cos_q71 * x_plane_x_by_q71_by_q73 - t104 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t124 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t125 = 0.01 * z_x_by_q71_by_q73;
    const double layer_0_x_by_q71_by_q73 = t124 + t125 - t108;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double z_z_by_q71_by_q73 = cos_q71 * sin_A_by_q71_by_q73 + t91 - t93 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t94 - cos_q71 * cos_A_by_q71_by_q73 + t95 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t126 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t127 = 0.01 * z_z_by_q71_by_q73;
    const double layer_0_z_by_q71_by_q73 = t126 + t127 - t98;
    const double layer_1_x_by_q71_by_q73 = t124 - t125 - t112;
    const double layer_1_z_by_q71_by_q73 = t126 - t127 - t111;
    const double t128 = layer_0_x_by_q73 * layer_0_x_by_q73 + layer_0_y_by_q73 * layer_0_y_by_q73;
    const double along_42 = t128 + layer_0_z_by_q73 * layer_0_z_by_q73;
    const double t129 = y_x_by_q71_by_q73 + y_x_by_q71_by_q73;
    const double t130 = u_y_by_q73 + u_y_by_q73;
    const double t131 = y_z_by_q71_by_q73 + y_z_by_q71_by_q73;
    const double along_by_y_8 = t130 * layer_0_y_by_q73 + t129 * layer_0_z_by_q73 + t131
        * layer_0_x_by_q73;
    const double along_by_y_squared_8 = u_y_by_q73 * u_y_by_q73 + y_x_by_q71_by_q73
        * y_x_by_q71_by_q73 + y_z_by_q71_by_q73 * y_z_by_q71_by_q73;
    const double t132 = layer_1_x_by_q73 * layer_1_x_by_q73 + layer_1_y_by_q73 * layer_1_y_by_q73;
    const double along_44 = t132 + layer_1_z_by_q73 * layer_1_z_by_q73;
    const double t133 = per_length_19 * along_44 + across_19 * length_19_by_q73 * length_19_by_q73;
    const double along_by_y_10 = t130 * layer_1_y_by_q73 + t129 * layer_1_z_by_q73 + t131
        * layer_1_x_by_q73;
    const double t134 = reach_by_q73 * reach_by_q73;
    const double t135 = t134 + t134;
    const double t136 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t136 * t2;
    const double C_y_by_q73_by_q73 = t89 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t137 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t138 = u_e_by_q73 + u_e_by_q73;
    const double p_y_by_q73_by_q73 = t137 - s_y * u_e_by_q73_by_q73 + t138 * M_y_by_q73 - t130
        * M_e_by_q73;
    const double t139 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t12, t139 * p_y_by_q73 + t8
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t135) * t13;
    const double t140 = t135 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t21
        * reach_by_q73_by_q73;
    const double t141 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t142 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t142 - s_y * u_y_by_q73_by_q73 - t138 * M_e_by_q73 - t130
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t141 - t17 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t19, -(reach_by_q73_by_q73 * t15
        - projection_by_q73_by_q73 * t16), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t24, t140 - t20 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t143 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t143 * t25;
    const double t144 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t145 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t146 = t144 - sin_A * reach_squared_by_q73_by_q73 + t139 * root_by_q73 - t145
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t146 * t28;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t130 * sin_A_by_q73;
    const double t147 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t148 = t147 - cos_A * reach_squared_by_q73_by_q73 + t139 * limited_by_q73 - t145
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t148 * t28;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t130 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t149 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t138 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t138 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t150 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t151 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    static const double table162[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    double sum153 = K_0;
    double sum154 = per_length_0 * along_42 + across_0 * length_0_by_q73 * length_0_by_q73;
    double sum155 = per_length_0 * along_38 + across_0 * length_0_by_q71 * length_0_by_q71;
    double sum156 = -0.0;
    double sum157 = -0.0;
    double sum158 = -0.0;
    double sum159 = pull_0_z;
    double sum160 = pull_0_y;
    double sum161 = pull_0_x;
    for (int i152 = 0; i152 < 18; ++i152) {
        const double before163 = sum153;
        const double before164 = sum154;
        const double before165 = sum155;
        const double before166 = sum156;
        const double before167 = sum157;
        const double before168 = sum158;
        const double before169 = sum159;
        const double before170 = sum160;
        const double before171 = sum161;
        const double t172 = table162[i152][0] * y_x;
        const double strand_x = layer_0_x - t172;
        const double strand_y = table162[i152][1] + layer_0_y - table162[i152][0] * u_y;
        const double t173 = table162[i152][0] * y_z;
        const double strand_z = layer_0_z - t173;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t174 = 1.0 / length;
        const double per_length = f[1 + i152] * t174;
        const double slope = along_by_y + table162[i152][0] * along_by_y_squared;
        const double along_2 = along - table162[i152][0] * slope;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t173;
        const double strand_z_by_q71 = layer_0_z_by_q71 + t172;
        const double t175 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length_by_q71 = t175 * t174;
        const double strand_x_by_q73 = layer_0_x_by_q73 + table162[i152][0] * y_z_by_q71_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 + table162[i152][0] * u_y_by_q73;
        const double strand_z_by_q73 = layer_0_z_by_q73 + table162[i152][0] * y_x_by_q71_by_q73;
        const double t176 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t176 * t174;
        const double across = k[1 + i152] - per_length;
        const double t177 = before163 + per_length * along_2 + length_by_q71 * length_by_q73
            * across;
        const double slope_4 = along_by_y_8 + table162[i152][0] * along_by_y_squared_8;
        const double along_3 = along_42 + table162[i152][0] * slope_4;
        const double t178 = before164 + per_length * along_3 + across * length_by_q73
            * length_by_q73;
        const double slope_2 = along_by_y_4 + table162[i152][0] * along_by_y_squared_4;
        const double along_4 = along_38 + table162[i152][0] * slope_2;
        const double t179 = before165 + per_length * along_4 + across * length_by_q71
            * length_by_q71;
        const double t180 = table162[i152][0] * per_length;
        const double pull_by_y_y = strand_y * t180;
        const double pull_by_y_z = strand_z * t180;
        const double pull_by_y_x = strand_x * t180;
        const double pull_z = strand_z * per_length;
        const double pull_y = strand_y * per_length;
        const double pull_x = strand_x * per_length;
        sum153 = t177;
        sum154 = t178;
        sum155 = t179;
        sum156 = before166 + pull_by_y_y;
        sum157 = before167 + pull_by_y_z;
        sum158 = before168 + pull_by_y_x;
        sum159 = before169 + pull_z;
        sum160 = before170 + pull_y;
        sum161 = before171 + pull_x;
    }
    static const double table191[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    double sum182 = K_19;
    double sum183 = t133;
    double sum184 = t64;
    double sum185 = -0.0;
    double sum186 = -0.0;
    double sum187 = -0.0;
    double sum188 = pull_19_z;
    double sum189 = pull_19_y;
    double sum190 = pull_19_x;
    for (int i181 = 0; i181 < 18; ++i181) {
        const double before192 = sum182;
        const double before193 = sum183;
        const double before194 = sum184;
        const double before195 = sum185;
        const double before196 = sum186;
        const double before197 = sum187;
        const double before198 = sum188;
        const double before199 = sum189;
        const double before200 = sum190;
        const double t201 = table191[i181][0] * y_x;
        const double strand_x_2 = layer_1_x - t201;
        const double strand_y_2 = table191[i181][1] + layer_1_y - table191[i181][0] * u_y;
        const double t202 = table191[i181][0] * y_z;
        const double strand_z_2 = layer_1_z - t202;
        const double t203 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t203);
        const double t204 = 1.0 / length_2;
        const double per_length_2 = f[20 + i181] * t204;
        const double slope_3 = along_by_y_2 + table191[i181][0] * along_by_y_squared;
        const double along_5 = along_19 - table191[i181][0] * slope_3;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t202;
        const double strand_z_by_q71_2 = layer_1_z_by_q71 + t201;
        const double t205 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_1_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double length_by_q71_2 = t205 * t204;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + table191[i181][0] * y_z_by_q71_by_q73;
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table191[i181][0] * u_y_by_q73;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + table191[i181][0] * y_x_by_q71_by_q73;
        const double t206 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t206 * t204;
        const double across_2 = k[20 + i181] - per_length_2;
        const double t207 = before192 + per_length_2 * along_5 + length_by_q71_2 * length_by_q73_2
            * across_2;
        const double slope_4_2 = along_by_y_10 + table191[i181][0] * along_by_y_squared_8;
        const double along_6 = along_44 + table191[i181][0] * slope_4_2;
        const double t208 = before193 + per_length_2 * along_6 + across_2 * length_by_q73_2
            * length_by_q73_2;
        const double slope_2_2 = along_by_y_6 + table191[i181][0] * along_by_y_squared_4;
        const double along_7 = along_40 + table191[i181][0] * slope_2_2;
        const double t209 = before194 + per_length_2 * along_7 + across_2 * length_by_q71_2
            * length_by_q71_2;
        const double t210 = table191[i181][0] * per_length_2;
        const double pull_by_y_y_2 = strand_y_2 * t210;
        const double pull_by_y_z_2 = strand_z_2 * t210;
        const double pull_by_y_x_2 = strand_x_2 * t210;
        const double pull_z_2 = strand_z_2 * per_length_2;
        const double pull_y_2 = strand_y_2 * per_length_2;
        const double pull_x_2 = strand_x_2 * per_length_2;
        sum182 = t207;
        sum183 = t208;
        sum184 = t209;
        sum185 = before195 + pull_by_y_y_2;
        sum186 = before196 + pull_by_y_z_2;
        sum187 = before197 + pull_by_y_x_2;
        sum188 = before198 + pull_z_2;
        sum189 = before199 + pull_y_2;
        sum190 = before200 + pull_x_2;
    }
    const double pull_by_y = sum158 + sum187;
    const double pull_by_y_4 = sum157 + sum186;
    const double t211 = sum155 + sum184 + y_x * pull_by_y + y_z * pull_by_y_4 + sum161
        * layer_0_x_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t212 = origin_y_by_q71_by_q71 + t38 * sin_A_by_q71_by_q71;
    const double t213 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t212 - t213;
    const double t214 = t211 - sum160 * layer_0_y_by_q71_by_q71 + sum159 * layer_0_z_by_q71_by_q71;
    const double layer_1_y_by_q71_by_q71 = t212 + t213;
    const double t215 = t214 + sum190 * layer_1_x_by_q71_by_q71 - sum189 * layer_1_y_by_q71_by_q71;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t216 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t217 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t216 - t217;
    const double t218 = sum153 + sum182 - sum161 * layer_0_x_by_q71_by_q73 + sum160
        * layer_0_y_by_q71_by_q73;
    const double t219 = t218 + sum159 * layer_0_z_by_q71_by_q73 - sum190 * layer_1_x_by_q71_by_q73;
    const double layer_1_y_by_q71_by_q73 = t216 + t217;
    const double t220 = t219 + sum189 * layer_1_y_by_q71_by_q73 + sum188 * layer_1_z_by_q71_by_q73;
    const double K_01 = t220 - y_x_by_q71_by_q73 * pull_by_y + y_z_by_q71_by_q73 * pull_by_y_4;
    const double t221 = -K_01;
    const double t222 = 0.01 * z_x_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t149 - t222 - 0.011 * y_x_by_q73_by_q73;
    const double t223 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t150 + t223 - 0.011 * u_y_by_q73_by_q73;
    const double t224 = sum154 + sum183 + sum161 * layer_0_x_by_q73_by_q73 + sum160
        * layer_0_y_by_q73_by_q73;
    const double t225 = 0.01 * z_z_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t151 - t225 - 0.011 * y_z_by_q73_by_q73;
    const double layer_1_x_by_q73_by_q73 = t149 + t222 - 0.013 * y_x_by_q73_by_q73;
    const double t226 = t224 + sum159 * layer_0_z_by_q73_by_q73 + sum190 * layer_1_x_by_q73_by_q73;
    const double layer_1_y_by_q73_by_q73 = t150 - t223 - 0.013 * u_y_by_q73_by_q73;
    const double layer_1_z_by_q73_by_q73 = t151 + t225 - 0.013 * y_z_by_q73_by_q73;
    const double t227 = t226 + sum189 * layer_1_y_by_q73_by_q73 + sum188 * layer_1_z_by_q73_by_q73;
    const double pull_by_y_2 = sum156 + sum185;
    const double t228 = t227 + pull_by_y * y_x_by_q73_by_q73 + pull_by_y_2 * u_y_by_q73_by_q73
        + pull_by_y_4 * y_z_by_q73_by_q73;
    K[0] = t215 + sum188 * layer_1_z_by_q71_by_q71;
    K[1] = t221;
    K[2] = t221;
    K[3] = t228;
}
