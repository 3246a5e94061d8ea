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

/* Parts: what several functions compute alike, or one at several places. */

SINEW_NOT_INLINE static void wrist_part_1(double q71, double q73, double part[SINEW_AT_LEAST(55)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared_by_q73_by_q73 = 0.084 * B_y;
    const double t2 = 1.0 / (0.007324 - B_to_C0_squared_by_q73_by_q73);
    const double ratio = 0.003796 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t3;
    const double t4 = 23.80952380952381 * B_y;
    const double u_y = t4 + 23.80952380952381 * C_y;
    part[0] = u_y;
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
    const double root = sinew_sqrt(sinew_max(t11, t12));
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
    const double t20 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t18 + t19);
    const double t21 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    part[1] = y_x;
    const double t22 = 0.011 * y_x;
    const double layer_0_x = t20 - t21 + t22;
    part[2] = layer_0_x;
    const double t23 = sin_q71 * z_plane_x;
    const double t24 = cos_q71 * sin_A;
    const double z_z = t24 + t23;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t25 = sin_q71 * x_plane_x;
    const double t26 = cos_q71 * cos_A;
    const double t27 = 0.004 * (t26 - t25);
    const double t28 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    part[3] = y_z;
    const double t29 = 0.011 * y_z;
    const double layer_0_z = 0.008 - origin_z - t27 - t28 + t29;
    part[4] = layer_0_z;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    part[5] = twice_across;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t30 = 0.004 * (u_e * sin_A);
    const double t31 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t30 + t31 + 0.011 * u_y;
    part[6] = layer_0_y;
    const double t32 = 0.013 * y_x;
    const double layer_1_x = t20 + t21 + t32;
    part[7] = layer_1_x;
    const double t33 = 0.013 * y_z;
    const double layer_1_z = 0.028 - origin_z - t27 + t28 + t33;
    part[8] = layer_1_z;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    part[9] = twice_across_6;
    const double layer_1_y = 0.006 - origin_y - t30 - t31 + 0.013 * u_y;
    part[10] = layer_1_y;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    part[11] = u_y_by_q73;
    const double t34 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t34;
    const double u_e_by_q73 = t4 + 23.80952380952381 * C_e_by_q73;
    const double y_x_by_q71_by_q73 = sin_q71 * u_e_by_q73;
    part[12] = y_x_by_q71_by_q73;
    const double y_z_by_q71_by_q73 = cos_q71 * u_e_by_q73;
    part[13] = y_z_by_q71_by_q73;
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
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t51 = cos_q71 * x_plane_x_by_q73;
    const double t52 = sin_q71 * cos_A_by_q73;
    const double t53 = M_z_by_q71_by_q73 - 0.018 * z_x_by_q73 - 0.004 * (t51 + t52);
    const double t54 = 0.01 * z_x_by_q73;
    const double t55 = 0.011 * y_z_by_q71_by_q73;
    const double layer_0_x_by_q73 = t53 + t54 - t55;
    part[14] = layer_0_x_by_q73;
    const double t56 = sin_q71 * z_plane_x_by_q73;
    part[15] = t56;
    const double t57 = cos_q71 * sin_A_by_q73;
    const double z_z_by_q73 = t57 + t56;
    const double M_x_by_q71_by_q73 = sin_q71 * M_e_by_q73;
    part[16] = M_x_by_q71_by_q73;
    const double t58 = sin_q71 * x_plane_x_by_q73;
    const double t59 = cos_q71 * cos_A_by_q73;
    const double t60 = M_x_by_q71_by_q73 - 0.018 * z_z_by_q73 + 0.004 * (t59 - t58);
    const double t61 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t60 + t61 - 0.011 * y_x_by_q71_by_q73;
    part[17] = layer_0_z_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double t62 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73 + sin_A
        * u_e_by_q73);
    const double t63 = 0.01 * z_plane_y_by_q73;
    part[18] = t62 + t63;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    part[19] = 1.0 / length_0;
    const double t64 = y_x * layer_0_x_by_q73 + y_z * layer_0_z_by_q73 - layer_0_x
        * y_z_by_q71_by_q73;
    part[20] = t64 - layer_0_z * y_x_by_q71_by_q73;
    const double t65 = 0.013 * y_z_by_q71_by_q73;
    const double layer_1_x_by_q73 = t53 - t54 - t65;
    part[21] = layer_1_x_by_q73;
    const double layer_1_z_by_q73 = t60 - t61 - 0.013 * y_x_by_q71_by_q73;
    part[22] = layer_1_z_by_q73;
    part[23] = t62 - t63;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    part[24] = 1.0 / length_19;
    const double t66 = y_x * layer_1_x_by_q73 + y_z * layer_1_z_by_q73 - layer_1_x
        * y_z_by_q71_by_q73;
    part[25] = t66 - layer_1_z * y_x_by_q71_by_q73;
    const double t67 = u_y_by_q73 + u_y_by_q73;
    part[26] = t67;
    const double t68 = reach_by_q73 * reach_by_q73;
    const double t69 = t68 + t68;
    const double t70 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t70 * t2;
    const double C_y_by_q73_by_q73 = t34 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    part[27] = u_y_by_q73_by_q73;
    const double t71 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t72 = u_e_by_q73 + u_e_by_q73;
    const double p_y_by_q73_by_q73 = t71 - s_y * u_e_by_q73_by_q73 + t72 * M_y_by_q73 - t67
        * M_e_by_q73;
    const double t73 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t36, t73 * p_y_by_q73 + t35
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t69) * t40;
    const double t74 = t69 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t44
        * reach_by_q73_by_q73;
    const double t75 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t76 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t76 - s_y * u_y_by_q73_by_q73 - t72 * M_e_by_q73 - t67
        * M_y_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t42, -(reach_by_q73_by_q73 * t41 - (t75 - t37
        * p_x_by_q73_by_q73) * t39), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t45, t74 - t43 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t77 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t77 * t46;
    const double t78 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t79 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t80 = t78 - sin_A * reach_squared_by_q73_by_q73 + t73 * root_by_q73 - t79
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t80 * t14;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t67 * sin_A_by_q73;
    const double t81 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t82 = t81 - cos_A * reach_squared_by_q73_by_q73 + t73 * limited_by_q73 - t79
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t82 * t14;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t67 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t83 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t84 = 0.01 * z_x_by_q73_by_q73;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    part[28] = y_x_by_q73_by_q73;
    part[29] = t83 - t84 - 0.011 * y_x_by_q73_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t72 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t72 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t85 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t86 = 0.01 * z_plane_y_by_q73_by_q73;
    part[30] = t85 + t86;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t87 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t88 = 0.01 * z_z_by_q73_by_q73;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    part[31] = y_z_by_q73_by_q73;
    part[32] = t87 - t88 - 0.011 * y_z_by_q73_by_q73;
    part[33] = t83 + t84 - 0.013 * y_x_by_q73_by_q73;
    part[34] = t85 - t86;
    part[35] = t87 + t88 - 0.013 * y_z_by_q73_by_q73;
    const double p_y_by_q71 = u_y * p_z;
    const double t89 = p_z + p_z;
    const double reach_squared_by_q71 = sinew_choose(t36, -(t35 * p_y_by_q71 + t89 * p_z_by_q71),
        0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t40;
    const double p_x_by_q71 = u_e * p_z;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t37 * p_x_by_q71;
    const double limited_by_q71 = sinew_choose(t42, -(reach_by_q71 * t41 - projection_by_q71 * t39),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t45, t44 * reach_by_q71 - t43 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t46;
    const double t90 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t90 - cos_A * reach_squared_by_q71) * t14;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t91 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t91 - sin_A * reach_squared_by_q71) * t14;
    const double z_x_by_q71 = t24 - cos_q71 * z_plane_x_by_q71 + t23 + sin_q71 * sin_A_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t26 + cos_q71 * x_plane_x_by_q71 - t25 + sin_q71 * cos_A_by_q71;
    const double t92 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    const double t93 = 0.01 * z_x_by_q71;
    part[36] = t92 + t93 - t29;
    const double z_z_by_q71 = t15 + cos_q71 * sin_A_by_q71 - t17 + sin_q71 * z_plane_x_by_q71;
    const double x_z_by_q71 = t18 - cos_q71 * cos_A_by_q71 + t19 + sin_q71 * x_plane_x_by_q71;
    const double t94 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    const double t95 = 0.01 * z_z_by_q71;
    part[37] = t94 + t95 - t22;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double t96 = 0.004 * u_e;
    const double t97 = 0.018 * z_plane_y_by_q71 + t96 * sin_A_by_q71;
    const double t98 = 0.01 * z_plane_y_by_q71;
    part[38] = t97 - t98;
    part[39] = t92 - t93 - t33;
    part[40] = t94 - t95 - t32;
    part[41] = t97 + t98;
    const double t99 = root_by_q71 + root_by_q71;
    const double t100 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double t101 = p_y_by_q71 + p_y_by_q71;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t36, t35 * p_y_by_q71_by_q73 - t101
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t100) * t40;
    const double t102 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t37
        * p_z * u_e_by_q73 - t102 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t42, -(reach_by_q71_by_q73 * t41
        - projection_by_q71_by_q73 * t39), reach_by_q71_by_q73);
    const double t103 = limited_by_q71 + limited_by_q71;
    const double t104 = t44 * reach_by_q71_by_q73 - t43 * limited_by_q71_by_q73 + t100 - t103
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t45, t104, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t99 * root_by_q73) * t46;
    const double t105 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t106 = t105 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t107 = t106 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t107 * t14;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    part[42] = t57 - cos_q71 * z_plane_x_by_q71_by_q73;
    const double t108 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t109 = t108 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t110 = t109 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t110 * t14;
    part[43] = sin_q71 * sin_A_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t59 + cos_q71 * x_plane_x_by_q71_by_q73 - t58 + sin_q71
        * cos_A_by_q71_by_q73;
    part[44] = x_x_by_q71_by_q73;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double t111 = 0.018 * z_plane_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t112 = 0.01 * z_plane_y_by_q71_by_q73;
    part[45] = t111 - t112;
    const double z_z_by_q71_by_q73 = cos_q71 * sin_A_by_q71_by_q73 + t48 - t50 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t51 - cos_q71 * cos_A_by_q71_by_q73 + t52 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t113 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t114 = 0.01 * z_z_by_q71_by_q73;
    part[46] = t113 + t114 - t55;
    part[47] = t111 + t112;
    part[48] = t113 - t114 - t65;
    const double t115 = reach_by_q71 * reach_by_q71;
    const double t116 = t115 + t115;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t117 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t36, t117 + t117 + t35
        * p_y_by_q71_by_q71 - t89 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t116) * t40;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t102
        * p_x_by_q71 + t37 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t42, -(reach_by_q71_by_q71 * t41
        - projection_by_q71_by_q71 * t39), reach_by_q71_by_q71);
    const double t118 = t116 - t103 * limited_by_q71 + t44 * reach_by_q71_by_q71 - t43
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t45, t118, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t99 * root_by_q71) * t46;
    const double t119 = p_y * limited_by_q71_by_q71 - t13 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t120 = p_z_by_q71 + p_z_by_q71;
    const double t121 = t119 - cos_A * reach_squared_by_q71_by_q71 - t101 * limited_by_q71 - t120
        * root_by_q71;
    const double t122 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t121 - t122 * cos_A_by_q71) * t14;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t123 = p_y * root_by_q71_by_q71 + t16 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t124 = t123 - sin_A * reach_squared_by_q71_by_q71 - t101 * root_by_q71 + t120
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t124 - t122 * sin_A_by_q71) * t14;
    const double t125 = t15 - cos_q71 * z_plane_x_by_q71_by_q71 - t17 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t126 = cos_q71 + cos_q71;
    const double t127 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t125 + t126 * sin_A_by_q71 + t127 * z_plane_x_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t128 = t18 - cos_q71 * x_plane_x_by_q71_by_q71 + t19 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t128 - t126 * cos_A_by_q71 + t127 * x_plane_x_by_q71;
    const double t129 = M_x - 0.018 * z_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t130 = 0.01 * z_x_by_q71_by_q71;
    part[49] = t129 + t130 - t22;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double t131 = 0.018 * z_plane_y_by_q71_by_q71 + t96 * sin_A_by_q71_by_q71;
    const double t132 = 0.01 * z_plane_y_by_q71_by_q71;
    part[50] = t131 - t132;
    const double t133 = t24 - cos_q71 * sin_A_by_q71_by_q71 + t23 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t133 - t126 * z_plane_x_by_q71 + t127 * sin_A_by_q71;
    const double t134 = t26 - cos_q71 * cos_A_by_q71_by_q71 - t25 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t134 + t126 * x_plane_x_by_q71 + t127 * cos_A_by_q71;
    const double t135 = M_z - 0.018 * z_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t136 = 0.01 * z_z_by_q71_by_q71;
    part[51] = t135 + t136 - t29;
    part[52] = t129 - t130 - t32;
    part[53] = t131 + t132;
    part[54] = t135 - t136 - t33;
}

SINEW_NOT_INLINE static void wrist_part_2(double q71, double q73, double part[SINEW_AT_LEAST(34)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    part[0] = cos_q71;
    part[1] = sin_q71;
    const double B_y = 0.074565407529229 * cos_q73;
    const double t2 = 1.0 / (0.007324 - 0.084 * B_y);
    const double ratio = 0.003796 * t2;
    const double t3 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t3;
    const double t4 = 23.80952380952381 * B_y;
    const double u_y = t4 + 23.80952380952381 * C_y;
    part[2] = u_y;
    const double B_e = 0.074565407529229 * sin_q73;
    const double C_e = B_e * ratio;
    const double t5 = 0.5 * B_e;
    const double M_e = t5 + 0.5 * C_e;
    part[3] = M_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double t6 = 0.5 * B_y;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double t7 = 23.80952380952381 * B_e;
    const double u_e = t7 - 23.80952380952381 * C_e;
    part[4] = u_e;
    const double p_y = u_e * s_y + u_y * s_e;
    part[5] = p_y;
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
    const double root = sinew_sqrt(sinew_max(t11, t12));
    const double t13 = 1.0 / reach_squared;
    part[6] = t13;
    const double cos_A = (p_y * limited + p_z * root) * t13;
    part[7] = cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t13;
    part[8] = sin_A;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t14 = 0.004 * (u_e * sin_A);
    const double t15 = 0.01 * z_plane_y;
    part[9] = 0.007 - origin_y - t14 + t15;
    part[10] = 0.006 - origin_y - t14 - t15;
    const double ratio_by_q73 = ratio * (0.084 * B_e) * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    part[11] = u_y_by_q73;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double u_e_by_q73 = t4 + 23.80952380952381 * C_e_by_q73;
    const double y_x_by_q71_by_q73 = sin_q71 * u_e_by_q73;
    part[12] = y_x_by_q71_by_q73;
    const double y_z_by_q71_by_q73 = cos_q71 * u_e_by_q73;
    part[13] = y_z_by_q71_by_q73;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double t16 = p_y + p_y;
    const double t17 = -(1.296e-15 - t8 - t9);
    const double reach_squared_by_q73 = sinew_choose(t17, t16 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double t18 = 27.77777777777778 * p_x;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t18 * p_x_by_q73;
    const double t19 = reach - projection;
    const double t20 = sinew_choose(t19, 1.0, 0.0);
    part[14] = t20;
    const double t21 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t21;
    const double t22 = sinew_choose(t19, 0.0, 1.0);
    const double t23 = reach - t10;
    part[15] = t23;
    const double limited_by_q73 = sinew_choose(t23, -(reach_by_q73 * t22 - projection_by_q73 * t20),
        reach_by_q73);
    const double t24 = limited + limited;
    part[16] = t24;
    const double t25 = reach + reach;
    const double t26 = t12 - t11;
    part[17] = t26;
    const double clearance_by_q73 = sinew_choose(-t26, t25 * reach_by_q73 - t24 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double t27 = 1.0 / root;
    part[18] = t27;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t27;
    const double t28 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t28 * t13;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t29 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t29 * t13;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t30 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t31 = 0.01 * z_x_by_q73;
    part[19] = t30 + t31 - 0.011 * y_z_by_q71_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t32 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t33 = 0.01 * z_z_by_q73;
    part[20] = t32 + t33 - 0.011 * y_x_by_q71_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double t34 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73 + sin_A
        * u_e_by_q73);
    const double t35 = 0.01 * z_plane_y_by_q73;
    part[21] = t34 + t35;
    part[22] = t30 - t31 - 0.013 * y_z_by_q71_by_q73;
    part[23] = t32 - t33 - 0.013 * y_x_by_q71_by_q73;
    part[24] = t34 - t35;
    const double p_y_by_q71 = u_y * p_z;
    const double reach_squared_by_q71 = sinew_choose(t17, -(t16 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
    part[25] = reach_squared_by_q71;
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t21;
    part[26] = reach_by_q71;
    part[27] = reach_by_q71 * t22;
    part[28] = t25 * reach_by_q71;
    part[29] = limited * p_y_by_q71;
    part[30] = root * p_z_by_q71;
    part[31] = limited * p_z_by_q71;
    part[32] = root * p_y_by_q71;
    part[33] = t18 * u_e;
}

SINEW_NOT_INLINE static void wrist_part_3(double q71, double q73, double part[SINEW_AT_LEAST(10)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
    const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
    const double t2 = B_y + C_y;
    const double u_y = 23.80952380952381 * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double C_e = B_e * ratio;
    const double s_e = 0.5 * (B_e + C_e) - 0.036 * sin_q71;
    const double s_y = 0.5 * (C_y - B_y) + 0.021;
    const double t3 = B_e - C_e;
    const double u_e = 23.80952380952381 * t3;
    const double p_y = u_e * s_y + u_y * s_e;
    const double p_z = 0.036 * cos_q71;
    const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    part[0] = cos_q71;
    part[1] = sin_q71;
    part[2] = sin_q73;
    part[3] = cos_q73;
    part[4] = t2;
    part[5] = t3;
    part[6] = p_y;
    part[7] = reach_squared;
    part[8] = projection;
    part[9] = sinew_sqrt(reach_squared);
}

void wrist_pose(double q71, double q73, double T[SINEW_AT_LEAST(16)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double z_plane_x = u_y * cos_A;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double z_plane_y = u_e * cos_A;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    T[0] = cos_q71 * x_plane_x + sin_q71 * cos_A;
    T[1] = cos_q71 * u_e;
    T[2] = z_x;
    T[3] = cos_q71 * M_e - 0.018 * z_x;
    T[4] = -(u_e * sin_A);
    T[5] = u_y;
    T[6] = -z_plane_y;
    T[7] = M_y + 0.018 * z_plane_y;
    T[8] = -(cos_q71 * cos_A - sin_q71 * x_plane_x);
    T[9] = sin_q71 * u_e;
    T[10] = z_z;
    T[11] = sin_q71 * M_e - 0.018 * z_z;
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
    const double t2 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double z_plane_x = u_y * cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    ABC[0] = cos_q71 * M_e - 0.036 * (cos_q71 * z_plane_x - sin_q71 * sin_A);
    ABC[1] = M_y + 0.036 * u_e * cos_A;
    ABC[2] = sin_q71 * M_e - 0.036 * (cos_q71 * sin_A + sin_q71 * z_plane_x);
    ABC[3] = cos_q71 * B_e;
    ABC[4] = B_y;
    ABC[5] = sin_q71 * B_e;
    ABC[6] = cos_q71 * C_e;
    ABC[7] = -C_y;
    ABC[8] = sin_q71 * C_e;
}

void wrist_palm_angles(double q71, double q73, double angles[SINEW_AT_LEAST(2)])
{
    double part_3[10];
    wrist_part_3(q71, q73, part_3);
    const double p_z = 0.036 * part_3[0];
    const double limited = sinew_min(sinew_max(-part_3[8], -part_3[9]), part_3[9]);
    const double clearance = sinew_max((part_3[9] + limited) * (part_3[9] - limited), 1e-12
        * part_3[7]);
    const double root = sinew_sqrt(clearance);
    const double t1 = 1.0 / part_3[7];
    const double sin_A = (part_3[6] * root - p_z * limited) * t1;
    const double x_plane_x = 23.80952380952381 * part_3[4] * sin_A;
    const double cos_A = (part_3[6] * limited + p_z * root) * t1;
    const double x_z = part_3[0] * cos_A - part_3[1] * x_plane_x;
    const double x_x = part_3[0] * x_plane_x + part_3[1] * cos_A;
    const double t2 = sinew_min(sinew_max(-(23.80952380952381 * part_3[5] * sin_A), -1.0), 1.0);
    angles[0] = sinew_one_atan2(-x_z, x_x);
    angles[1] = sinew_one_asin(t2);
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
    const double cos_half_tilt_8 = sinew_sqrt(sinew_max(0.5 + 0.5 * (v_e_8 * t53), 1e-12));
    const double cos_sum_8 = 0.5632638698251111 * cos_half_tilt_8;
    const double sin_sum_8 = sinew_sqrt(1.0 - cos_sum_8 * cos_sum_8);
    const double sin_half_tilt_8 = 0.5 * (v_y * t53) / cos_half_tilt_8;
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
    double part_3[10];
    wrist_part_3(q71, q73, part_3);
    const double t1 = sinew_one_atan2(sinew_max(part_3[2], -part_3[2]), sinew_max(part_3[3],
        -part_3[3]));
    const double height = sinew_sqrt(sinew_max(part_3[9] * part_3[9] - part_3[8] * part_3[8], 0.0));
    distance[0] = t1;
    distance[1] = sinew_one_atan2(height, sinew_max(-part_3[8], part_3[8]));
}

void wrist_status(double q71, double q73, int *status)
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q73, q71);
    const double sin_q73 = sines1.s[0];
    const double cos_q73 = sines1.c[0];
    const double sin_q71 = sines1.s[1];
    const double cos_q71 = sines1.c[1];
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
    const double t2 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t2;
    const double z_plane_x = u_y * cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t2;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double x_plane_x = u_y * sin_A;
    const double t3 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * (cos_q71 * x_plane_x + sin_q71
        * cos_A);
    const double t4 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double layer_0_x = t3 - t4 + 0.011 * y_x;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double origin_z = sin_q71 * M_e - 0.018 * z_z;
    const double t5 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
    const double t6 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t5 - t6 + 0.011 * y_z;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t7 = 0.004 * (u_e * sin_A);
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
    double part_2[34];
    wrist_part_2(q71, q73, part_2);
    const double p_z = 0.036 * part_2[0];
    const double projection_by_q71 = 13.88888888888889 * part_2[25] - part_2[33] * p_z;
    const double limited_by_q71 = sinew_choose(part_2[15], -(part_2[27] - projection_by_q71
        * part_2[14]), part_2[26]);
    const double clearance_by_q71 = sinew_choose(-part_2[17], part_2[28] - part_2[16]
        * limited_by_q71, 1e-12 * part_2[25]);
    const double root_by_q71 = 0.5 * clearance_by_q71 * part_2[18];
    const double t1 = part_2[5] * limited_by_q71 + p_z * root_by_q71 - part_2[29] - part_2[30]
        - part_2[7] * part_2[25];
    const double cos_A_by_q71 = t1 * part_2[6];
    const double z_plane_x_by_q71 = part_2[2] * cos_A_by_q71;
    const double t2 = part_2[0] * part_2[8];
    const double z_plane_x = part_2[2] * part_2[7];
    const double t3 = part_2[1] * z_plane_x;
    const double t4 = part_2[5] * root_by_q71 - p_z * limited_by_q71 + part_2[31] - part_2[32]
        - part_2[8] * part_2[25];
    const double sin_A_by_q71 = t4 * part_2[6];
    const double z_x_by_q71 = t2 - part_2[0] * z_plane_x_by_q71 + t3 + part_2[1] * sin_A_by_q71;
    const double M_z = part_2[1] * part_2[3];
    const double x_plane_x_by_q71 = part_2[2] * sin_A_by_q71;
    const double t5 = part_2[0] * part_2[7];
    const double x_plane_x = part_2[2] * part_2[8];
    const double t6 = part_2[1] * x_plane_x;
    const double x_x_by_q71 = t5 + part_2[0] * x_plane_x_by_q71 - t6 + part_2[1] * cos_A_by_q71;
    const double t7 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    const double t8 = 0.01 * z_x_by_q71;
    const double y_z = part_2[1] * part_2[4];
    const double t9 = 0.011 * y_z;
    const double layer_0_x_by_q71 = t7 + t8 - t9;
    const double t10 = part_2[0] * z_plane_x;
    const double t11 = part_2[1] * part_2[8];
    const double z_x = t10 - t11;
    const double M_x = part_2[0] * part_2[3];
    const double t12 = part_2[0] * x_plane_x;
    const double t13 = part_2[1] * part_2[7];
    const double t14 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t12 + t13);
    const double t15 = 0.01 * z_x;
    const double y_x = part_2[0] * part_2[4];
    const double t16 = 0.011 * y_x;
    const double layer_0_x = t14 - t15 + t16;
    const double z_z_by_q71 = t10 + part_2[0] * sin_A_by_q71 - t11 + part_2[1] * z_plane_x_by_q71;
    const double x_z_by_q71 = t12 - part_2[0] * cos_A_by_q71 + t13 + part_2[1] * x_plane_x_by_q71;
    const double t17 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    const double t18 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t17 + t18 - t16;
    const double z_z = t2 + t3;
    const double origin_z = M_z - 0.018 * z_z;
    const double t19 = 0.004 * (t5 - t6);
    const double t20 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t19 - t20 + t9;
    const double across_by_q71 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71;
    const double z_plane_y_by_q71 = part_2[4] * cos_A_by_q71;
    const double t21 = 0.018 * z_plane_y_by_q71 + 0.004 * part_2[4] * sin_A_by_q71;
    const double t22 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t21 - t22;
    const double layer_0_y = part_2[9] + 0.011 * part_2[2];
    const double half_square_by = across_by_q71 - layer_0_y * layer_0_y_by_q71;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double t23 = 1.0 / length_0;
    P[0] = half_square_by * t23;
    const double across_by_q73 = layer_0_x * part_2[19] + layer_0_z * part_2[20];
    const double layer_0_y_by_q73 = part_2[21] - 0.011 * part_2[11];
    const double half_square_by_76 = across_by_q73 - layer_0_y * layer_0_y_by_q73;
    P[1] = -(half_square_by_76 * t23);
    const double across_by_y_by_q71 = y_x * (layer_0_z + layer_0_x_by_q71) - y_z * (layer_0_x
        + layer_0_z_by_q71);
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double across_by_y_by_q73 = y_x * part_2[19] + y_z * part_2[20] - layer_0_x * part_2[13]
        - layer_0_z * part_2[12];
    const double across_by_y_squared_by_q73 = y_x * part_2[13] + y_z * part_2[12];
    const double t24 = 0.013 * y_z;
    const double layer_1_x_by_q71 = t7 - t8 - t24;
    const double t25 = 0.013 * y_x;
    const double layer_1_x = t14 + t15 + t25;
    const double layer_1_z_by_q71 = t17 - t18 - t25;
    const double layer_1_z = 0.028 - origin_z - t19 + t20 + t24;
    const double across_38_by_q71 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71;
    const double layer_1_y_by_q71 = t21 + t22;
    const double layer_1_y = part_2[10] + 0.013 * part_2[2];
    const double half_square_by_38 = across_38_by_q71 - layer_1_y * layer_1_y_by_q71;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double t26 = 1.0 / length_19;
    P[38] = half_square_by_38 * t26;
    const double across_38_by_q73 = layer_1_x * part_2[22] + layer_1_z * part_2[23];
    const double layer_1_y_by_q73 = part_2[24] - 0.013 * part_2[11];
    const double half_square_by_114 = across_38_by_q73 - layer_1_y * layer_1_y_by_q73;
    P[39] = -(half_square_by_114 * t26);
    const double across_by_y_2_by_q71 = y_x * (layer_1_z + layer_1_x_by_q71) - y_z * (layer_1_x
        + layer_1_z_by_q71);
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double across_by_y_2_by_q73 = y_x * part_2[22] + y_z * part_2[23] - layer_1_x * part_2[13]
        - layer_1_z * part_2[12];
    static const double table28[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i27 = 0; i27 < 18; ++i27) {
        const double across_2 = across_by_q71 - table28[i27][0] * across_by_y_by_q71;
        const double strand_y = table28[i27][1] + layer_0_y - table28[i27][0] * part_2[2];
        const double across_3 = twice_across - table28[i27][0] * (twice_across_2 - table28[i27][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        const double t29 = 1.0 / length;
        const double length_by_q71 = (across_2 - strand_y * layer_0_y_by_q71) * t29;
        const double across_slope = across_by_y_by_q73 + table28[i27][0]
            * across_by_y_squared_by_q73;
        const double across_4 = across_by_q73 - table28[i27][0] * across_slope;
        const double half_square_by_2 = across_4 - strand_y * (layer_0_y_by_q73 + table28[i27][0]
            * part_2[11]);
        P[2 + 2 * i27] = length_by_q71;
        P[3 + 2 * i27] = -(half_square_by_2 * t29);
    }
    static const double table31[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i30 = 0; i30 < 18; ++i30) {
        const double across_5 = across_38_by_q71 - table31[i30][0] * across_by_y_2_by_q71;
        const double strand_y_2 = table31[i30][1] + layer_1_y - table31[i30][0] * part_2[2];
        const double across_slope_2 = twice_across_8 - table31[i30][0] * twice_across_4;
        const double across_6 = twice_across_6 - table31[i30][0] * across_slope_2;
        const double length_2 = sinew_sqrt(across_6 + strand_y_2 * strand_y_2);
        const double t32 = 1.0 / length_2;
        const double length_by_q71_2 = (across_5 - strand_y_2 * layer_1_y_by_q71) * t32;
        const double across_slope_3 = across_by_y_2_by_q73 + table31[i30][0]
            * across_by_y_squared_by_q73;
        const double across_7 = across_38_by_q73 - table31[i30][0] * across_slope_3;
        const double strand_y_by = layer_1_y_by_q73 + table31[i30][0] * part_2[11];
        const double length_by_q73 = (across_7 - strand_y_2 * strand_y_by) * t32;
        P[40 + 2 * i30] = length_by_q71_2;
        P[41 + 2 * i30] = -length_by_q73;
    }
}

void wrist_tendon_hessian(double q71, double q73, double H[SINEW_AT_LEAST(152)])
{
    double part_1[55];
    wrist_part_1(q71, q73, part_1);
    const double t1 = part_1[2] * part_1[49] + part_1[4] * part_1[51] + part_1[36] * part_1[36];
    const double across_by_q71_by_q71 = t1 + part_1[37] * part_1[37];
    const double t2 = part_1[38] * part_1[38];
    const double across_by_q71 = part_1[2] * part_1[36] - part_1[4] * part_1[37];
    const double length_0_by_q71 = (across_by_q71 - part_1[6] * part_1[38]) * part_1[19];
    const double curvature = across_by_q71_by_q71 - part_1[6] * part_1[50] + t2 - length_0_by_q71
        * length_0_by_q71;
    H[0] = curvature * part_1[19];
    const double z_x_by_q71_by_q73 = part_1[42] + part_1[15] + part_1[43];
    const double t3 = part_1[16] - 0.018 * z_x_by_q71_by_q73 + 0.004 * part_1[44];
    const double t4 = 0.01 * z_x_by_q71_by_q73;
    const double layer_0_x_by_q71_by_q73 = t3 + t4 - 0.011 * part_1[12];
    const double t5 = part_1[2] * layer_0_x_by_q71_by_q73 - part_1[4] * part_1[46] - part_1[36]
        * part_1[14];
    const double across_by_q71_by_q73 = t5 + part_1[37] * part_1[17];
    const double layer_0_y_by_q73 = part_1[18] - 0.011 * part_1[11];
    const double t6 = across_by_q71_by_q73 - part_1[6] * part_1[45] - part_1[38] * layer_0_y_by_q73;
    const double across_by_q73 = part_1[2] * part_1[14] + part_1[4] * part_1[17];
    const double half_square_by_76 = across_by_q73 - part_1[6] * layer_0_y_by_q73;
    const double length_0_by_q73 = half_square_by_76 * part_1[19];
    const double t7 = (t6 + length_0_by_q71 * length_0_by_q73) * part_1[19];
    H[1] = t7;
    H[2] = t7;
    const double t8 = part_1[2] * part_1[29] + part_1[4] * part_1[32] + part_1[14] * part_1[14];
    const double across_by_q73_by_q73 = t8 + part_1[17] * part_1[17];
    const double layer_0_y_by_q73_by_q73 = part_1[30] - 0.011 * part_1[27];
    const double t9 = across_by_q73_by_q73 + part_1[6] * layer_0_y_by_q73_by_q73 + layer_0_y_by_q73
        * layer_0_y_by_q73;
    H[3] = (t9 - length_0_by_q73 * length_0_by_q73) * part_1[19];
    const double t10 = part_1[1] * part_1[2];
    const double t11 = part_1[3] * part_1[4];
    const double t12 = part_1[1] + part_1[1];
    const double t13 = t10 - part_1[1] * part_1[49] + t11 - part_1[3] * part_1[51] + t12
        * part_1[37];
    const double t14 = part_1[3] + part_1[3];
    const double across_by_y_by_q71_by_q71 = t13 + t14 * part_1[36];
    const double t15 = part_1[1] * part_1[1];
    const double t16 = part_1[3] * part_1[3];
    const double t17 = t15 + t16;
    const double across_by_y_squared_by_q71_by_q71 = t17 - t15 - t16;
    const double t18 = part_1[4] + part_1[36];
    const double t19 = part_1[2] + part_1[37];
    const double across_by_y_by_q71 = part_1[1] * t18 - part_1[3] * t19;
    const double across_by_y = t10 + t11;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across_by_y_squared = 0.5 * t17;
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double t20 = part_1[12] * t19 - part_1[13] * t18 + part_1[3] * (part_1[46] - part_1[14]);
    const double across_by_y_by_q71_by_q73 = t20 + part_1[1] * (part_1[17]
        - layer_0_x_by_q71_by_q73);
    const double across_by_y_squared_by_q73 = part_1[1] * part_1[13] + part_1[3] * part_1[12];
    const double t21 = part_1[1] * part_1[29] + part_1[3] * part_1[32] - part_1[2] * part_1[28]
        - part_1[4] * part_1[31];
    const double t22 = part_1[13] + part_1[13];
    const double t23 = part_1[12] + part_1[12];
    const double across_by_y_by_q73_by_q73 = t21 - t22 * part_1[14] - t23 * part_1[17];
    const double t24 = part_1[1] * part_1[28] + part_1[3] * part_1[31] - part_1[13] * part_1[13];
    const double across_by_y_squared_by_q73_by_q73 = t24 - part_1[12] * part_1[12];
    const double t25 = part_1[7] * part_1[52] + part_1[8] * part_1[54] + part_1[39] * part_1[39];
    const double across_38_by_q71_by_q71 = t25 + part_1[40] * part_1[40];
    const double t26 = part_1[41] * part_1[41];
    const double across_38_by_q71 = part_1[7] * part_1[39] - part_1[8] * part_1[40];
    const double half_square_by_38 = across_38_by_q71 - part_1[10] * part_1[41];
    const double length_19_by_q71 = half_square_by_38 * part_1[24];
    const double curvature_38 = across_38_by_q71_by_q71 - part_1[10] * part_1[53] + t26
        - length_19_by_q71 * length_19_by_q71;
    H[76] = curvature_38 * part_1[24];
    const double layer_1_x_by_q71_by_q73 = t3 - t4 - 0.013 * part_1[12];
    const double t27 = part_1[7] * layer_1_x_by_q71_by_q73 - part_1[8] * part_1[48] - part_1[39]
        * part_1[21];
    const double across_38_by_q71_by_q73 = t27 + part_1[40] * part_1[22];
    const double layer_1_y_by_q73 = part_1[23] - 0.013 * part_1[11];
    const double t28 = across_38_by_q71_by_q73 - part_1[10] * part_1[47] - part_1[41]
        * layer_1_y_by_q73;
    const double across_38_by_q73 = part_1[7] * part_1[21] + part_1[8] * part_1[22];
    const double half_square_by_114 = across_38_by_q73 - part_1[10] * layer_1_y_by_q73;
    const double length_19_by_q73 = half_square_by_114 * part_1[24];
    const double curvature_114 = t28 + length_19_by_q71 * length_19_by_q73;
    const double t29 = curvature_114 * part_1[24];
    H[77] = t29;
    H[78] = t29;
    const double t30 = part_1[7] * part_1[33] + part_1[8] * part_1[35] + part_1[21] * part_1[21];
    const double across_38_by_q73_by_q73 = t30 + part_1[22] * part_1[22];
    const double layer_1_y_by_q73_by_q73 = part_1[34] - 0.013 * part_1[27];
    const double t31 = across_38_by_q73_by_q73 + part_1[10] * layer_1_y_by_q73_by_q73
        + layer_1_y_by_q73 * layer_1_y_by_q73;
    const double curvature_190 = t31 - length_19_by_q73 * length_19_by_q73;
    H[79] = curvature_190 * part_1[24];
    const double t32 = part_1[1] * part_1[7];
    const double t33 = part_1[3] * part_1[8];
    const double t34 = t32 - part_1[1] * part_1[52] + t33 - part_1[3] * part_1[54] + t12
        * part_1[40];
    const double across_by_y_2_by_q71_by_q71 = t34 + t14 * part_1[39];
    const double t35 = part_1[8] + part_1[39];
    const double t36 = part_1[7] + part_1[40];
    const double across_by_y_2_by_q71 = part_1[1] * t35 - part_1[3] * t36;
    const double across_by_y_2 = t32 + t33;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double t37 = part_1[12] * t36 - part_1[13] * t35 + part_1[3] * (part_1[48] - part_1[21]);
    const double across_by_y_2_by_q71_by_q73 = t37 + part_1[1] * (part_1[22]
        - layer_1_x_by_q71_by_q73);
    const double t38 = part_1[1] * part_1[33] + part_1[3] * part_1[35] - part_1[7] * part_1[28]
        - part_1[8] * part_1[31];
    const double across_by_y_2_by_q73_by_q73 = t38 - t22 * part_1[21] - t23 * part_1[22];
    static const double table40[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i39 = 0; i39 < 18; ++i39) {
        const double across_slope = across_by_y_by_q71_by_q71 - table40[i39][0]
            * across_by_y_squared_by_q71_by_q71;
        const double across = across_by_q71_by_q71 + table40[i39][0] * across_slope;
        const double strand_y = table40[i39][1] + part_1[6] - table40[i39][0] * part_1[0];
        const double across_2 = across_by_q71 - table40[i39][0] * across_by_y_by_q71;
        const double across_3 = part_1[5] - table40[i39][0] * (twice_across_2 - table40[i39][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        const double t41 = 1.0 / length;
        const double length_by_q71 = (across_2 - strand_y * part_1[38]) * t41;
        const double curvature_2 = across - strand_y * part_1[50] + t2 - length_by_q71
            * length_by_q71;
        const double across_4 = across_by_q71_by_q73 + table40[i39][0] * across_by_y_by_q71_by_q73;
        const double t42 = layer_0_y_by_q73 + table40[i39][0] * part_1[11];
        const double across_slope_2 = part_1[20] + table40[i39][0] * across_by_y_squared_by_q73;
        const double across_5 = across_by_q73 - table40[i39][0] * across_slope_2;
        const double length_by_q73 = (across_5 - strand_y * t42) * t41;
        const double curvature_3 = across_4 - strand_y * part_1[45] - part_1[38] * t42
            + length_by_q71 * length_by_q73;
        const double t43 = curvature_3 * t41;
        const double across_slope_3 = across_by_y_by_q73_by_q73 + table40[i39][0]
            * across_by_y_squared_by_q73_by_q73;
        const double across_6 = across_by_q73_by_q73 - table40[i39][0] * across_slope_3;
        const double strand_y_by = layer_0_y_by_q73_by_q73 + table40[i39][0] * part_1[27];
        const double curvature_4 = across_6 + strand_y * strand_y_by + t42 * t42 - length_by_q73
            * length_by_q73;
        H[4 + 4 * i39] = curvature_2 * t41;
        H[5 + 4 * i39] = t43;
        H[6 + 4 * i39] = t43;
        H[7 + 4 * i39] = curvature_4 * t41;
    }
    static const double table45[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i44 = 0; i44 < 18; ++i44) {
        const double across_slope_4 = across_by_y_2_by_q71_by_q71 - table45[i44][0]
            * across_by_y_squared_by_q71_by_q71;
        const double across_7 = across_38_by_q71_by_q71 + table45[i44][0] * across_slope_4;
        const double strand_y_2 = table45[i44][1] + part_1[10] - table45[i44][0] * part_1[0];
        const double across_8 = across_38_by_q71 - table45[i44][0] * across_by_y_2_by_q71;
        const double across_slope_5 = twice_across_8 - table45[i44][0] * twice_across_4;
        const double across_9 = part_1[9] - table45[i44][0] * across_slope_5;
        const double length_2 = sinew_sqrt(across_9 + strand_y_2 * strand_y_2);
        const double t46 = 1.0 / length_2;
        const double length_by_q71_2 = (across_8 - strand_y_2 * part_1[41]) * t46;
        const double curvature_5 = across_7 - strand_y_2 * part_1[53] + t26 - length_by_q71_2
            * length_by_q71_2;
        const double across_10 = across_38_by_q71_by_q73 + table45[i44][0]
            * across_by_y_2_by_q71_by_q73;
        const double strand_y_by_2 = layer_1_y_by_q73 + table45[i44][0] * part_1[11];
        const double across_slope_6 = part_1[25] + table45[i44][0] * across_by_y_squared_by_q73;
        const double across_11 = across_38_by_q73 - table45[i44][0] * across_slope_6;
        const double length_by_q73_2 = (across_11 - strand_y_2 * strand_y_by_2) * t46;
        const double curvature_6 = across_10 - strand_y_2 * part_1[47] - part_1[41] * strand_y_by_2
            + length_by_q71_2 * length_by_q73_2;
        const double t47 = curvature_6 * t46;
        const double across_slope_7 = across_by_y_2_by_q73_by_q73 + table45[i44][0]
            * across_by_y_squared_by_q73_by_q73;
        const double across_12 = across_38_by_q73_by_q73 - table45[i44][0] * across_slope_7;
        const double strand_y_by_3 = layer_1_y_by_q73_by_q73 + table45[i44][0] * part_1[27];
        const double curvature_7 = across_12 + strand_y_2 * strand_y_by_3 + strand_y_by_2
            * strand_y_by_2 - length_by_q73_2 * length_by_q73_2;
        H[80 + 4 * i44] = curvature_5 * t46;
        H[81 + 4 * i44] = t47;
        H[82 + 4 * i44] = t47;
        H[83 + 4 * i44] = curvature_7 * t46;
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
    const double B_to_C0_squared = 0.007324 - 0.084 * (0.074565407529229 * cos_q73);
    const double B_e = 0.074565407529229 * sin_q73;
    const double M_e = 0.5 * (B_e + B_e * (0.003796 / B_to_C0_squared));
    const double t3 = -pose_T[8];
    const double t4 = 0.004 * t3;
    const double t5 = 0.01 * pose_T[10];
    const double layer_0_z = 0.008 - pose_T[11] - t4 - t5 + 0.011 * pose_T[9];
    const double t6 = 0.004 - cos_q71 * M_e + 0.018 * pose_T[2] + 0.004 * pose_T[0];
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
    const double t2 = 1.0 / (0.007324 - 0.084 * B_y);
    const double ratio = 0.003796 * t2;
    const double B_y_by_t = 0.074565407529229 * (dq73 * sin_q73);
    const double ratio_by_t = ratio * (0.084 * B_y_by_t) * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_e_by_t = 0.074565407529229 * (dq73 * cos_q73);
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
    const double root = sinew_sqrt(sinew_max(t11, t12));
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
    const double origin_x_by_t = cos_q71 * M_e_by_t - M_e * cos_q71_by_t - 0.018 * z_x_by_t;
    const double x_plane_x_by_t = u_y * sin_A_by_t - sin_A * u_y_by_t;
    const double x_plane_x = u_y * sin_A;
    const double x_x_by_t = cos_q71 * x_plane_x_by_t + sin_q71 * cos_A_by_t + cos_A * sin_q71_by_t
        - x_plane_x * cos_q71_by_t;
    const double t16 = origin_x_by_t - 0.004 * x_x_by_t;
    const double t17 = 0.01 * z_x_by_t;
    const double y_x_by_t = cos_q71 * u_e_by_t - u_e * cos_q71_by_t;
    const double layer_0_x_by_t = t16 + t17 - 0.011 * y_x_by_t;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double t18 = 0.004 - cos_q71 * M_e + 0.018 * z_x + 0.004 * (cos_q71 * x_plane_x + sin_q71
        * cos_A);
    const double t19 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double layer_0_x = t18 - t19 + 0.011 * y_x;
    const double z_z_by_t = cos_q71 * sin_A_by_t + sin_q71 * z_plane_x_by_t - sin_A * cos_q71_by_t
        + z_plane_x * sin_q71_by_t;
    const double origin_z_by_t = sin_q71 * M_e_by_t + M_e * sin_q71_by_t - 0.018 * z_z_by_t;
    const double x_z_by_t = cos_q71 * cos_A_by_t - sin_q71 * x_plane_x_by_t - cos_A * cos_q71_by_t
        - x_plane_x * sin_q71_by_t;
    const double t20 = origin_z_by_t + 0.004 * x_z_by_t;
    const double t21 = 0.01 * z_z_by_t;
    const double y_z_by_t = sin_q71 * u_e_by_t + u_e * sin_q71_by_t;
    const double layer_0_z_by_t = t20 + t21 - 0.011 * y_z_by_t;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double origin_z = sin_q71 * M_e - 0.018 * z_z;
    const double t22 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
    const double t23 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t22 - t23 + 0.011 * y_z;
    const double across_by_t = layer_0_x * layer_0_x_by_t + layer_0_z * layer_0_z_by_t;
    const double z_plane_y_by_t = u_e * cos_A_by_t + cos_A * u_e_by_t;
    const double t24 = M_y_by_t - 0.018 * z_plane_y_by_t - 0.004 * (u_e * sin_A_by_t + sin_A
        * u_e_by_t);
    const double t25 = 0.01 * z_plane_y_by_t;
    const double layer_0_y_by_t = t24 + t25 - 0.011 * u_y_by_t;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t26 = 0.004 * (u_e * sin_A);
    const double t27 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t26 + t27 + 0.011 * u_y;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double length_0_by_t = (across_by_t - layer_0_y * layer_0_y_by_t) / length_0;
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
    delta_theta_rate[19] = 200.0 * (half_square_by_38 / length_19);
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
        const double half_square_by = across_2 - strand_y * (layer_0_y_by_t + table29[i28][0]
            * u_y_by_t);
        const double across_3 = twice_across - table29[i28][0] * (twice_across_2 - table29[i28][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        delta_theta_rate[1 + i28] = 200.0 * (half_square_by / length);
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
        const double across_slope_3 = twice_across_8 - table31[i30][0] * twice_across_4;
        const double across_5 = twice_across_6 - table31[i30][0] * across_slope_3;
        const double length_2 = sinew_sqrt(across_5 + strand_y_2 * strand_y_2);
        const double length_by_t = (across_4 - strand_y_2 * strand_y_by) / length_2;
        delta_theta_rate[20 + i30] = 200.0 * length_by_t;
    }
}

void wrist_joint_torque(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    double tau[SINEW_AT_LEAST(2)])
{
    double part_2[34];
    wrist_part_2(q71, q73, part_2);
    const double p_z = 0.036 * part_2[0];
    const double y_x = part_2[0] * part_2[4];
    const double layer_0_y = part_2[9] + 0.011 * part_2[2];
    const double y_z = part_2[1] * part_2[4];
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double t1 = 0.011 * y_x;
    const double t2 = part_2[1] * part_2[8];
    const double z_plane_x = part_2[2] * part_2[7];
    const double t3 = part_2[0] * z_plane_x;
    const double z_x = t3 - t2;
    const double t4 = 0.01 * z_x;
    const double t5 = part_2[1] * part_2[7];
    const double x_plane_x = part_2[2] * part_2[8];
    const double t6 = part_2[0] * x_plane_x;
    const double M_x = part_2[0] * part_2[3];
    const double t7 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t6 + t5);
    const double layer_0_x = t7 - t4 + t1;
    const double t8 = 0.011 * y_z;
    const double t9 = part_2[0] * part_2[8];
    const double t10 = part_2[1] * z_plane_x;
    const double z_z = t9 + t10;
    const double t11 = 0.01 * z_z;
    const double t12 = part_2[0] * part_2[7];
    const double t13 = part_2[1] * x_plane_x;
    const double t14 = 0.004 * (t12 - t13);
    const double M_z = part_2[1] * part_2[3];
    const double origin_z = M_z - 0.018 * z_z;
    const double layer_0_z = 0.008 - origin_z - t14 - t11 + t8;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    const double per_length_0 = f[0] / length_0;
    const double layer_1_y = part_2[10] + 0.013 * part_2[2];
    const double t15 = 0.013 * y_x;
    const double layer_1_x = t7 + t4 + t15;
    const double t16 = 0.013 * y_z;
    const double layer_1_z = 0.028 - origin_z - t14 + t11 + t16;
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    const double per_length_19 = f[19] / length_19;
    const double projection_by_q71 = 13.88888888888889 * part_2[25] - part_2[33] * p_z;
    const double limited_by_q71 = sinew_choose(part_2[15], -(part_2[27] - projection_by_q71
        * part_2[14]), part_2[26]);
    const double clearance_by_q71 = sinew_choose(-part_2[17], part_2[28] - part_2[16]
        * limited_by_q71, 1e-12 * part_2[25]);
    const double root_by_q71 = 0.5 * clearance_by_q71 * part_2[18];
    const double t17 = part_2[5] * root_by_q71 - p_z * limited_by_q71 + part_2[31] - part_2[32]
        - part_2[8] * part_2[25];
    const double sin_A_by_q71 = t17 * part_2[6];
    const double t18 = part_2[5] * limited_by_q71 + p_z * root_by_q71 - part_2[29] - part_2[30]
        - part_2[7] * part_2[25];
    const double cos_A_by_q71 = t18 * part_2[6];
    const double z_plane_x_by_q71 = part_2[2] * cos_A_by_q71;
    const double z_x_by_q71 = t9 - part_2[0] * z_plane_x_by_q71 + t10 + part_2[1] * sin_A_by_q71;
    const double t19 = 0.01 * z_x_by_q71;
    const double x_plane_x_by_q71 = part_2[2] * sin_A_by_q71;
    const double x_x_by_q71 = t12 + part_2[0] * x_plane_x_by_q71 - t13 + part_2[1] * cos_A_by_q71;
    const double t20 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    const double z_z_by_q71 = t3 + part_2[0] * sin_A_by_q71 - t2 + part_2[1] * z_plane_x_by_q71;
    const double t21 = 0.01 * z_z_by_q71;
    const double x_z_by_q71 = t6 - part_2[0] * cos_A_by_q71 + t5 + part_2[1] * x_plane_x_by_q71;
    const double t22 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    static const double table29[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.004, 0.005},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.012, 0.013},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.02, 0.021},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.028, 0.029}};
    double sum24 = -0.0;
    double sum25 = -0.0;
    double sum26 = layer_0_y * per_length_0;
    double sum27 = -0.0;
    double sum28 = per_length_0;
    for (int i23 = 0; i23 < 18; ++i23) {
        const double before30 = sum24;
        const double before31 = sum25;
        const double before32 = sum26;
        const double before33 = sum27;
        const double before34 = sum28;
        const double strand_y = table29[i23][0] + layer_0_y - table29[i23][1] * part_2[2];
        const double across_2 = twice_across - table29[i23][1] * (twice_across_2 - table29[i23][1]
            * twice_across_4);
        const double length = sinew_sqrt(across_2 + strand_y * strand_y);
        const double per_length = f[1 + i23] / length;
        const double t35 = table29[i23][1] * per_length;
        sum24 = before30 + strand_y * t35;
        sum25 = before31 + table29[i23][1] * t35;
        sum26 = before32 + strand_y * per_length;
        sum27 = before33 + t35;
        sum28 = before34 + per_length;
    }
    static const double table42[18][2] = {{0.001, 0.002}, {0.003, 0.003}, {0.005, 0.005},
        {0.006, 0.007}, {0.008, 0.008}, {0.009, 0.01}, {0.011, 0.011}, {0.013, 0.013},
        {0.014, 0.015}, {0.016, 0.016}, {0.017, 0.018}, {0.019, 0.019}, {0.021, 0.021},
        {0.022, 0.023}, {0.024, 0.024}, {0.025, 0.026}, {0.027, 0.027}, {0.029, 0.029}};
    double sum37 = -0.0;
    double sum38 = -0.0;
    double sum39 = layer_1_y * per_length_19;
    double sum40 = -0.0;
    double sum41 = per_length_19;
    for (int i36 = 0; i36 < 18; ++i36) {
        const double before43 = sum37;
        const double before44 = sum38;
        const double before45 = sum39;
        const double before46 = sum40;
        const double before47 = sum41;
        const double strand_y_2 = table42[i36][0] + layer_1_y - table42[i36][1] * part_2[2];
        const double across_slope = twice_across_8 - table42[i36][1] * twice_across_4;
        const double across_3 = twice_across_6 - table42[i36][1] * across_slope;
        const double length_2 = sinew_sqrt(across_3 + strand_y_2 * strand_y_2);
        const double per_length_2 = f[20 + i36] / length_2;
        const double t48 = table42[i36][1] * per_length_2;
        sum37 = before43 + strand_y_2 * t48;
        sum38 = before44 + table42[i36][1] * t48;
        sum39 = before45 + strand_y_2 * per_length_2;
        sum40 = before46 + t48;
        sum41 = before47 + per_length_2;
    }
    const double pull_x = y_x * sum27 - layer_0_x * sum28;
    const double pull_z = y_z * sum27 - layer_0_z * sum28;
    const double t49 = pull_x * part_2[19] + sum26 * (part_2[21] - 0.011 * part_2[11]) + pull_z
        * part_2[20];
    const double pull_x_2 = y_x * sum40 - layer_1_x * sum41;
    const double pull_z_2 = y_z * sum40 - layer_1_z * sum41;
    const double t50 = t49 + pull_x_2 * part_2[22] + sum39 * (part_2[24] - 0.013 * part_2[11])
        + pull_z_2 * part_2[23];
    const double t51 = sum25 + sum38;
    const double pull_axis_x_4 = y_x * t51 - layer_0_x * sum27 - layer_1_x * sum40;
    const double pull_axis_z_4 = y_z * t51 - layer_0_z * sum27 - layer_1_z * sum40;
    const double t52 = t50 + pull_axis_x_4 * part_2[13] + (sum24 + sum37) * part_2[11]
        + pull_axis_z_4 * part_2[12];
    const double z_plane_y_by_q71 = part_2[4] * cos_A_by_q71;
    const double t53 = 0.01 * z_plane_y_by_q71;
    const double t54 = 0.018 * z_plane_y_by_q71 + 0.004 * part_2[4] * sin_A_by_q71;
    const double t55 = y_x * pull_axis_z_4 - y_z * pull_axis_x_4 - pull_x * (t20 + t19 - t8) - sum26
        * (t54 - t53);
    const double t56 = t55 + pull_z * (t22 + t21 - t1) - pull_x_2 * (t20 - t19 - t16) - sum39 * (t54
        + t53);
    tau[0] = -(t56 + pull_z_2 * (t22 - t21 - t15));
    tau[1] = -t52;
}

void wrist_joint_stiffness(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    const double k[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(4)])
{
    double part_1[55];
    wrist_part_1(q71, q73, part_1);
    const double across_by_y = part_1[1] * part_1[2] + part_1[3] * part_1[4];
    const double twice_across_2 = across_by_y + across_by_y;
    const double turned_4 = part_1[1] * part_1[1] + part_1[3] * part_1[3];
    const double across_by_y_squared = 0.5 * turned_4;
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double across_by_y_2 = part_1[1] * part_1[7] + part_1[3] * part_1[8];
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double across_by_q73 = part_1[2] * part_1[14] + part_1[4] * part_1[17];
    const double layer_0_y_by_q73 = part_1[18] - 0.011 * part_1[11];
    const double half_square_by_76 = across_by_q73 - part_1[6] * layer_0_y_by_q73;
    const double length_0_by_q73 = half_square_by_76 * part_1[19];
    const double per_length_0 = f[0] * part_1[19];
    const double across_0 = k[0] - per_length_0;
    const double across_by_y_squared_by_q73 = part_1[1] * part_1[13] + part_1[3] * part_1[12];
    const double across_38_by_q73 = part_1[7] * part_1[21] + part_1[8] * part_1[22];
    const double layer_1_y_by_q73 = part_1[23] - 0.013 * part_1[11];
    const double half_square_by_114 = across_38_by_q73 - part_1[10] * layer_1_y_by_q73;
    const double length_19_by_q73 = half_square_by_114 * part_1[24];
    const double per_length_19 = f[19] * part_1[24];
    const double across_19 = k[19] - per_length_19;
    const double across_by_q71 = part_1[2] * part_1[36] - part_1[4] * part_1[37];
    const double length_0_by_q71 = (across_by_q71 - part_1[6] * part_1[38]) * part_1[19];
    const double K_0 = length_0_by_q71 * length_0_by_q73 * across_0;
    const double across_by_y_by_q71 = part_1[1] * (part_1[4] + part_1[36]) - part_1[3] * (part_1[2]
        + part_1[37]);
    const double across_38_by_q71 = part_1[7] * part_1[39] - part_1[8] * part_1[40];
    const double half_square_by_38 = across_38_by_q71 - part_1[10] * part_1[41];
    const double length_19_by_q71 = half_square_by_38 * part_1[24];
    const double K_19 = length_19_by_q71 * length_19_by_q73 * across_19;
    const double across_by_y_2_by_q71 = part_1[1] * (part_1[8] + part_1[39]) - part_1[3]
        * (part_1[7] + part_1[40]);
    static const double table10[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    double sum2 = K_0;
    double sum3 = across_0 * length_0_by_q73 * length_0_by_q73;
    double sum4 = across_0 * length_0_by_q71 * length_0_by_q71;
    double sum5 = -0.0;
    double sum6 = -0.0;
    double sum7 = part_1[6] * per_length_0;
    double sum8 = -0.0;
    double sum9 = per_length_0;
    for (int i1 = 0; i1 < 18; ++i1) {
        const double before11 = sum2;
        const double before12 = sum3;
        const double before13 = sum4;
        const double before14 = sum5;
        const double before15 = sum6;
        const double before16 = sum7;
        const double before17 = sum8;
        const double before18 = sum9;
        const double across = across_by_q71 - table10[i1][0] * across_by_y_by_q71;
        const double strand_y = table10[i1][1] + part_1[6] - table10[i1][0] * part_1[0];
        const double across_2 = part_1[5] - table10[i1][0] * (twice_across_2 - table10[i1][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_2 + strand_y * strand_y);
        const double t19 = 1.0 / length;
        const double length_by_q71 = (across - strand_y * part_1[38]) * t19;
        const double across_slope = part_1[20] + table10[i1][0] * across_by_y_squared_by_q73;
        const double across_3 = across_by_q73 - table10[i1][0] * across_slope;
        const double half_square_by = across_3 - strand_y * (layer_0_y_by_q73 + table10[i1][0]
            * part_1[11]);
        const double length_by_q73 = half_square_by * t19;
        const double per_length = f[1 + i1] * t19;
        const double t20 = k[1 + i1] - per_length;
        const double t21 = table10[i1][0] * per_length;
        sum2 = before11 + length_by_q71 * length_by_q73 * t20;
        sum3 = before12 + t20 * length_by_q73 * length_by_q73;
        sum4 = before13 + t20 * length_by_q71 * length_by_q71;
        sum5 = before14 + strand_y * t21;
        sum6 = before15 + table10[i1][0] * t21;
        sum7 = before16 + strand_y * per_length;
        sum8 = before17 + t21;
        sum9 = before18 + per_length;
    }
    static const double table31[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    double sum23 = K_19;
    double sum24 = across_19 * length_19_by_q73 * length_19_by_q73;
    double sum25 = across_19 * length_19_by_q71 * length_19_by_q71;
    double sum26 = -0.0;
    double sum27 = -0.0;
    double sum28 = part_1[10] * per_length_19;
    double sum29 = -0.0;
    double sum30 = per_length_19;
    for (int i22 = 0; i22 < 18; ++i22) {
        const double before32 = sum23;
        const double before33 = sum24;
        const double before34 = sum25;
        const double before35 = sum26;
        const double before36 = sum27;
        const double before37 = sum28;
        const double before38 = sum29;
        const double before39 = sum30;
        const double across_4 = across_38_by_q71 - table31[i22][0] * across_by_y_2_by_q71;
        const double strand_y_2 = table31[i22][1] + part_1[10] - table31[i22][0] * part_1[0];
        const double across_slope_2 = twice_across_8 - table31[i22][0] * twice_across_4;
        const double across_5 = part_1[9] - table31[i22][0] * across_slope_2;
        const double length_2 = sinew_sqrt(across_5 + strand_y_2 * strand_y_2);
        const double t40 = 1.0 / length_2;
        const double length_by_q71_2 = (across_4 - strand_y_2 * part_1[41]) * t40;
        const double across_slope_3 = part_1[25] + table31[i22][0] * across_by_y_squared_by_q73;
        const double across_6 = across_38_by_q73 - table31[i22][0] * across_slope_3;
        const double strand_y_by = layer_1_y_by_q73 + table31[i22][0] * part_1[11];
        const double length_by_q73_2 = (across_6 - strand_y_2 * strand_y_by) * t40;
        const double per_length_2 = f[20 + i22] * t40;
        const double t41 = k[20 + i22] - per_length_2;
        const double t42 = table31[i22][0] * per_length_2;
        sum23 = before32 + length_by_q71_2 * length_by_q73_2 * t41;
        sum24 = before33 + t41 * length_by_q73_2 * length_by_q73_2;
        sum25 = before34 + t41 * length_by_q71_2 * length_by_q71_2;
        sum26 = before35 + strand_y_2 * t42;
        sum27 = before36 + table31[i22][0] * t42;
        sum28 = before37 + strand_y_2 * per_length_2;
        sum29 = before38 + t42;
        sum30 = before39 + per_length_2;
    }
    const double t43 = sum6 + sum27;
    const double turned_8 = part_1[11] * part_1[11] + part_1[12] * part_1[12] + part_1[13]
        * part_1[13];
    const double along_8 = part_1[14] * part_1[14] + layer_0_y_by_q73 * layer_0_y_by_q73
        + part_1[17] * part_1[17];
    const double t44 = part_1[12] + part_1[12];
    const double t45 = part_1[13] + part_1[13];
    const double mixed_8 = part_1[26] * layer_0_y_by_q73 + t44 * part_1[17] + t45 * part_1[14];
    const double pull_x = part_1[1] * sum8 - part_1[2] * sum9;
    const double t46 = turned_8 * t43 + sum3 + sum24 + sum9 * along_8 + sum8 * mixed_8 - pull_x
        * part_1[29];
    const double pull_z = part_1[3] * sum8 - part_1[4] * sum9;
    const double along_10 = part_1[21] * part_1[21] + layer_1_y_by_q73 * layer_1_y_by_q73
        + part_1[22] * part_1[22];
    const double t47 = t46 + sum7 * (part_1[30] - 0.011 * part_1[27]) - pull_z * part_1[32] + sum30
        * along_10;
    const double mixed_10 = part_1[26] * layer_1_y_by_q73 + t44 * part_1[22] + t45 * part_1[21];
    const double pull_x_2 = part_1[1] * sum29 - part_1[7] * sum30;
    const double t48 = t47 + sum29 * mixed_10 - pull_x_2 * part_1[33] + sum28 * (part_1[34] - 0.013
        * part_1[27]);
    const double pull_z_2 = part_1[3] * sum29 - part_1[8] * sum30;
    const double pull_axis_x_4 = part_1[1] * t43 - part_1[2] * sum8 - part_1[7] * sum29;
    const double t49 = t48 - pull_z_2 * part_1[35] - pull_axis_x_4 * part_1[28] + (sum5 + sum26)
        * part_1[27];
    const double pull_axis_z_4 = part_1[3] * t43 - part_1[4] * sum8 - part_1[8] * sum29;
    const double turned = part_1[1] * part_1[12] - part_1[3] * part_1[13];
    const double along = part_1[36] * part_1[14] + part_1[38] * layer_0_y_by_q73 - part_1[37]
        * part_1[17];
    const double t50 = part_1[1] * part_1[17] - part_1[3] * part_1[14] - part_1[36] * part_1[13];
    const double mixed = t50 - part_1[38] * part_1[11] + part_1[37] * part_1[12];
    const double z_x_by_q71_by_q73 = part_1[42] + part_1[43] + part_1[15];
    const double t51 = part_1[16] - 0.018 * z_x_by_q71_by_q73 + 0.004 * part_1[44];
    const double t52 = 0.01 * z_x_by_q71_by_q73;
    const double t53 = sum2 - turned * t43 + sum23 + sum9 * along - sum8 * mixed + pull_x * (t51
        + t52 - 0.011 * part_1[12]);
    const double along_2 = part_1[39] * part_1[21] + part_1[41] * layer_1_y_by_q73 - part_1[40]
        * part_1[22];
    const double t54 = part_1[1] * part_1[22] - part_1[3] * part_1[21] - part_1[11] * part_1[41];
    const double mixed_2 = t54 + part_1[12] * part_1[40] - part_1[13] * part_1[39];
    const double t55 = t53 + sum7 * part_1[45] - pull_z * part_1[46] + sum30 * along_2 - sum29
        * mixed_2;
    const double t56 = t55 + pull_x_2 * (t51 - t52 - 0.013 * part_1[12]) + sum28 * part_1[47]
        - pull_z_2 * part_1[48];
    const double K_01 = t56 + part_1[12] * pull_axis_x_4 - part_1[13] * pull_axis_z_4;
    const double t57 = -K_01;
    const double t58 = turned_4 * t43 + sum4 + sum25 - part_1[1] * pull_axis_x_4 - part_1[3]
        * pull_axis_z_4;
    const double along_4 = part_1[36] * part_1[36] + part_1[38] * part_1[38] + part_1[37]
        * part_1[37];
    const double t59 = part_1[1] + part_1[1];
    const double t60 = part_1[3] + part_1[3];
    const double t61 = t58 + sum9 * along_4 + sum8 * (t59 * part_1[37] + t60 * part_1[36]) - pull_x
        * part_1[49];
    const double along_6 = part_1[39] * part_1[39] + part_1[41] * part_1[41] + part_1[40]
        * part_1[40];
    const double t62 = t61 - sum7 * part_1[50] - pull_z * part_1[51] + sum30 * along_6 + sum29
        * (t59 * part_1[40] + t60 * part_1[39]);
    K[0] = t62 - pull_x_2 * part_1[52] - sum28 * part_1[53] - pull_z_2 * part_1[54];
    K[1] = t57;
    K[2] = t57;
    K[3] = t49 - pull_axis_z_4 * part_1[31];
}
