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

SINEW_NOT_INLINE static void wrist_part_1(double q71, double q73, double part[SINEW_AT_LEAST(53)])
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
    const double root = sinew_sqrt(sinew_max(t22, t23));
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
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double t33 = cos_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t34 = sin_q71 * x_plane_x;
    const double x_x_by_q71 = t33 + cos_q71 * x_plane_x_by_q71 - t34 + sin_q71 * cos_A_by_q71;
    const double t35 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    const double t36 = 0.01 * z_x_by_q71;
    const double y_z = sin_q71 * u_e;
    part[1] = y_z;
    const double t37 = 0.011 * y_z;
    const double layer_0_x_by_q71 = t35 + t36 - t37;
    part[2] = layer_0_x_by_q71;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double t38 = 0.004 * u_e;
    const double t39 = 0.018 * z_plane_y_by_q71 + t38 * sin_A_by_q71;
    const double t40 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t39 - t40;
    part[3] = layer_0_y_by_q71;
    const double t41 = cos_q71 * z_plane_x;
    const double t42 = sin_q71 * sin_A;
    const double z_z_by_q71 = t41 + cos_q71 * sin_A_by_q71 - t42 + sin_q71 * z_plane_x_by_q71;
    const double M_x = cos_q71 * M_e;
    const double t43 = cos_q71 * x_plane_x;
    const double t44 = sin_q71 * cos_A;
    const double x_z_by_q71 = t43 - cos_q71 * cos_A_by_q71 + t44 + sin_q71 * x_plane_x_by_q71;
    const double t45 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    const double t46 = 0.01 * z_z_by_q71;
    const double y_x = cos_q71 * u_e;
    part[4] = y_x;
    const double t47 = 0.011 * y_x;
    const double layer_0_z_by_q71 = t45 + t46 - t47;
    part[5] = layer_0_z_by_q71;
    const double z_x = t41 - t42;
    const double t48 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t43 + t44);
    const double t49 = 0.01 * z_x;
    const double layer_0_x = t48 - t49 + t47;
    part[6] = layer_0_x;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t50 = 0.004 * (u_e * sin_A);
    const double t51 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t50 + t51 + 0.011 * u_y;
    part[7] = layer_0_y;
    const double z_z = t30 + t31;
    const double origin_z = M_z - 0.018 * z_z;
    const double t52 = 0.004 * (t33 - t34);
    const double t53 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t52 - t53 + t37;
    part[8] = layer_0_z;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    const double t54 = 1.0 / length_0;
    part[9] = t54;
    const double t55 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
        * layer_0_z_by_q71;
    part[10] = t55 * t54;
    const double t56 = 0.013 * y_x;
    const double t57 = 0.013 * y_z;
    const double layer_1_x_by_q71 = t35 - t36 - t57;
    part[11] = layer_1_x_by_q71;
    const double layer_1_y_by_q71 = t39 + t40;
    part[12] = layer_1_y_by_q71;
    const double layer_1_z_by_q71 = t45 - t46 - t56;
    part[13] = layer_1_z_by_q71;
    const double layer_1_x = t48 + t49 + t56;
    part[14] = layer_1_x;
    const double layer_1_y = 0.006 - origin_y - t50 - t51 + 0.013 * u_y;
    part[15] = layer_1_y;
    const double layer_1_z = 0.028 - origin_z - t52 + t53 + t57;
    part[16] = layer_1_z;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    const double t58 = 1.0 / length_19;
    part[17] = t58;
    const double t59 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
        * layer_1_z_by_q71;
    part[18] = t59 * t58;
    const double t60 = root_by_q71 + root_by_q71;
    const double t61 = limited_by_q71 + limited_by_q71;
    const double t62 = reach_by_q71 * reach_by_q71;
    const double t63 = t62 + t62;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t64 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t12, t64 + t64 + t8 * p_y_by_q71_by_q71
        - t9 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t63) * t13;
    const double t65 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t65
        * p_x_by_q71 + t17 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t19, -(reach_by_q71_by_q71 * t15
        - projection_by_q71_by_q71 * t16), reach_by_q71_by_q71);
    const double t66 = t63 - t61 * limited_by_q71 + t21 * reach_by_q71_by_q71 - t20
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t24, t66, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t60 * root_by_q71) * t25;
    const double t67 = p_y * limited_by_q71_by_q71 - t27 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t68 = p_y_by_q71 + p_y_by_q71;
    const double t69 = p_z_by_q71 + p_z_by_q71;
    const double t70 = t67 - cos_A * reach_squared_by_q71_by_q71 - t68 * limited_by_q71 - t69
        * root_by_q71;
    const double t71 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t70 - t71 * cos_A_by_q71) * t28;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t72 = p_y * root_by_q71_by_q71 + t29 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t73 = t72 - sin_A * reach_squared_by_q71_by_q71 - t68 * root_by_q71 + t69
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t73 - t71 * sin_A_by_q71) * t28;
    const double t74 = t41 - cos_q71 * z_plane_x_by_q71_by_q71 - t42 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t75 = cos_q71 + cos_q71;
    const double t76 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t74 + t75 * sin_A_by_q71 + t76 * z_plane_x_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t77 = t43 - cos_q71 * x_plane_x_by_q71_by_q71 + t44 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t77 - t75 * cos_A_by_q71 + t76 * x_plane_x_by_q71;
    const double t78 = M_x - 0.018 * z_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t79 = 0.01 * z_x_by_q71_by_q71;
    part[19] = t78 + t79 - t47;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double t80 = 0.018 * z_plane_y_by_q71_by_q71 + t38 * sin_A_by_q71_by_q71;
    const double t81 = 0.01 * z_plane_y_by_q71_by_q71;
    part[20] = t80 - t81;
    const double t82 = t30 - cos_q71 * sin_A_by_q71_by_q71 + t31 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t82 - t75 * z_plane_x_by_q71 + t76 * sin_A_by_q71;
    const double t83 = t33 - cos_q71 * cos_A_by_q71_by_q71 - t34 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t83 + t75 * x_plane_x_by_q71 + t76 * cos_A_by_q71;
    const double t84 = M_z - 0.018 * z_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t85 = 0.01 * z_z_by_q71_by_q71;
    part[21] = t84 + t85 - t37;
    part[22] = t78 - t79 - t56;
    part[23] = t80 + t81;
    part[24] = t84 - t85 - t57;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t2;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t3;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t86 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t86;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double u_y_by_q73 = t7 - 23.80952380952381 * C_y_by_q73;
    part[25] = u_y_by_q73;
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
    const double t87 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t87 * t28;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t88 = cos_q71 * z_plane_x_by_q73;
    const double t89 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t89 * t28;
    const double t90 = sin_q71 * sin_A_by_q73;
    const double z_x_by_q73 = t88 - t90;
    const double M_z_by_q71_by_q73 = cos_q71 * M_e_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t91 = cos_q71 * x_plane_x_by_q73;
    const double t92 = sin_q71 * cos_A_by_q73;
    const double t93 = M_z_by_q71_by_q73 - 0.018 * z_x_by_q73 - 0.004 * (t91 + t92);
    const double t94 = 0.01 * z_x_by_q73;
    part[26] = t93 + t94;
    part[27] = cos_q71 * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double t95 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73 + sin_A
        * u_e_by_q73);
    const double t96 = 0.01 * z_plane_y_by_q73;
    part[28] = t95 + t96;
    const double t97 = sin_q71 * z_plane_x_by_q73;
    part[29] = t97;
    const double t98 = cos_q71 * sin_A_by_q73;
    const double z_z_by_q73 = t98 + t97;
    const double M_x_by_q71_by_q73 = sin_q71 * M_e_by_q73;
    part[30] = M_x_by_q71_by_q73;
    const double t99 = sin_q71 * x_plane_x_by_q73;
    const double t100 = cos_q71 * cos_A_by_q73;
    const double t101 = M_x_by_q71_by_q73 - 0.018 * z_z_by_q73 + 0.004 * (t100 - t99);
    const double t102 = 0.01 * z_z_by_q73;
    part[31] = t101 + t102;
    part[32] = sin_q71 * u_e_by_q73;
    part[33] = t93 - t94;
    part[34] = t95 - t96;
    part[35] = t101 - t102;
    const double t103 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t12, t8 * p_y_by_q71_by_q73 - t68
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t103) * t13;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t17
        * p_z * u_e_by_q73 - t65 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t19, -(reach_by_q71_by_q73 * t15
        - projection_by_q71_by_q73 * t16), reach_by_q71_by_q73);
    const double t104 = t21 * reach_by_q71_by_q73 - t20 * limited_by_q71_by_q73 + t103 - t61
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t24, t104, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t60 * root_by_q73) * t25;
    const double t105 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t106 = t105 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t107 = t106 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t107 * t28;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    part[36] = t98 - cos_q71 * z_plane_x_by_q71_by_q73;
    const double t108 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t109 = t108 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t110 = t109 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t110 * t28;
    part[37] = sin_q71 * sin_A_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t100 + cos_q71 * x_plane_x_by_q71_by_q73 - t99 + sin_q71
        * cos_A_by_q71_by_q73;
    part[38] = x_x_by_q71_by_q73;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double t111 = 0.018 * z_plane_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t112 = 0.01 * z_plane_y_by_q71_by_q73;
    part[39] = t111 - t112;
    const double z_z_by_q71_by_q73 = cos_q71 * sin_A_by_q71_by_q73 + t88 - t90 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t91 - cos_q71 * cos_A_by_q71_by_q73 + t92 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t113 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t114 = 0.01 * z_z_by_q71_by_q73;
    part[40] = t113 + t114;
    part[41] = t111 + t112;
    part[42] = t113 - t114;
    const double t115 = u_y_by_q73 + u_y_by_q73;
    part[43] = t115;
    const double t116 = reach_by_q73 * reach_by_q73;
    const double t117 = t116 + t116;
    const double t118 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t118 * t2;
    const double C_y_by_q73_by_q73 = t86 - 0.002 * ratio_by_q73_by_q73 * t3 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t4 - 23.80952380952381 * C_y_by_q73_by_q73;
    part[44] = u_y_by_q73_by_q73;
    const double t119 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t7 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t120 = u_e_by_q73 + u_e_by_q73;
    const double p_y_by_q73_by_q73 = t119 - s_y * u_e_by_q73_by_q73 + t120 * M_y_by_q73 - t115
        * M_e_by_q73;
    const double t121 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t12, t121 * p_y_by_q73 + t8
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t117) * t13;
    const double t122 = t117 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t21
        * reach_by_q73_by_q73;
    const double t123 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t124 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t124 - s_y * u_y_by_q73_by_q73 - t120 * M_e_by_q73 - t115
        * M_y_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t19, -(reach_by_q73_by_q73 * t15 - (t123 - t17
        * p_x_by_q73_by_q73) * t16), reach_by_q73_by_q73);
    const double clearance_by_q73_by_q73 = sinew_choose(t24, t122 - t20 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t125 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t125 * t25;
    const double t126 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t127 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t128 = t126 - sin_A * reach_squared_by_q73_by_q73 + t121 * root_by_q73 - t127
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t128 * t28;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t115 * sin_A_by_q73;
    const double t129 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t130 = t129 - cos_A * reach_squared_by_q73_by_q73 + t121 * limited_by_q73 - t127
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t130 * t28;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t115 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t131 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t132 = 0.01 * z_x_by_q73_by_q73;
    part[45] = t131 - t132;
    part[46] = cos_q71 * u_e_by_q73_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t120 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t120 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t133 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t134 = 0.01 * z_plane_y_by_q73_by_q73;
    part[47] = t133 + t134;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t135 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t136 = 0.01 * z_z_by_q73_by_q73;
    part[48] = t135 - t136;
    part[49] = sin_q71 * u_e_by_q73_by_q73;
    part[50] = t131 + t132;
    part[51] = t133 - t134;
    part[52] = t135 + t136;
}

SINEW_NOT_INLINE static void wrist_part_2(double q71, double q73, double part[SINEW_AT_LEAST(26)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q71, q73);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double t2 = 23.80952380952381 * B_y;
    const double t3 = 1.0 / (0.007324 - 0.084 * B_y);
    const double ratio = 0.003796 * t3;
    const double B_e = 0.074565407529229 * sin_q73;
    const double ratio_by_q73 = ratio * (0.084 * B_e) * t3;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double u_e_by_q73 = t2 + 23.80952380952381 * C_e_by_q73;
    part[0] = cos_q71 * u_e_by_q73;
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
    part[1] = u_y;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t9 = p_y * p_y;
    const double reach_squared = sinew_max(t9 + t4, 1.296e-15);
    const double t10 = 1.0 / reach_squared;
    const double t11 = -(1.296e-15 - t9 - t4);
    const double t12 = p_y + p_y;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t7;
    const double u_y_by_q73 = t5 - 23.80952380952381 * C_y_by_q73;
    part[2] = u_y_by_q73;
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
    const double root = sinew_sqrt(sinew_max(t15, t14));
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
    const double t28 = 0.01 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
    const double t29 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    part[3] = t29 + t28;
    const double y_x = cos_q71 * u_e;
    part[4] = y_x;
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
    part[5] = layer_0_x;
    const double y_z = sin_q71 * u_e;
    part[6] = y_z;
    const double t37 = 0.011 * y_z;
    const double t38 = cos_q71 * sin_A;
    const double t39 = sin_q71 * z_plane_x;
    const double z_z = t38 + t39;
    const double t40 = 0.01 * z_z;
    const double t41 = cos_q71 * cos_A;
    const double t42 = sin_q71 * x_plane_x;
    const double t43 = 0.004 * (t41 - t42);
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double layer_0_z = 0.008 - origin_z - t43 - t40 + t37;
    part[7] = layer_0_z;
    const double z_plane_y = u_e * cos_A;
    const double t44 = 0.01 * z_plane_y;
    const double t45 = 0.004 * (u_e * sin_A);
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t45 + t44 + 0.011 * u_y;
    part[8] = layer_0_y;
    const double t46 = 0.013 * y_x;
    const double t47 = 0.013 * y_z;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    part[9] = length_0;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double t48 = 0.01 * z_plane_y_by_q73;
    const double t49 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73 + sin_A
        * u_e_by_q73);
    part[10] = t49 + t48;
    part[11] = sin_q71 * u_e_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double t50 = 0.01 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
    const double t51 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    part[12] = t51 + t50;
    part[13] = t29 - t28;
    const double layer_1_x = t36 + t33 + t46;
    part[14] = layer_1_x;
    const double layer_1_z = 0.028 - origin_z - t43 + t40 + t47;
    part[15] = layer_1_z;
    const double layer_1_y = 0.006 - origin_y - t45 - t44 + 0.013 * u_y;
    part[16] = layer_1_y;
    const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y + layer_1_z
        * layer_1_z);
    part[17] = length_19;
    part[18] = t49 - t48;
    part[19] = t51 - t50;
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
    const double t52 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t52 - sin_A * reach_squared_by_q71) * t10;
    const double t53 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t53 - cos_A * reach_squared_by_q71) * t10;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double z_x_by_q71 = t38 - cos_q71 * z_plane_x_by_q71 + t39 + sin_q71 * sin_A_by_q71;
    const double t54 = 0.01 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t41 + cos_q71 * x_plane_x_by_q71 - t42 + sin_q71 * cos_A_by_q71;
    const double t55 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    part[20] = t55 + t54 - t37;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double t56 = 0.01 * z_plane_y_by_q71;
    const double t57 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
    part[21] = t57 - t56;
    const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t31 + sin_q71 * z_plane_x_by_q71;
    const double t58 = 0.01 * z_z_by_q71;
    const double x_z_by_q71 = t35 - cos_q71 * cos_A_by_q71 + t34 + sin_q71 * x_plane_x_by_q71;
    const double t59 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    part[22] = t59 + t58 - t30;
    part[23] = t55 - t54 - t47;
    part[24] = t57 + t56;
    part[25] = t59 - t58 - t46;
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
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t5 = 0.004 * (u_e * sin_A);
    const double t6 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t5 + t6 + 0.011 * u_y;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double origin_z = sin_q71 * M_e - 0.018 * z_z;
    const double t7 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
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
        h[20 + i9] = length;
        h[1 + i9] = sinew_sqrt(t11);
    }
}

void wrist_tendon_jacobian(double q71, double q73, double P[SINEW_AT_LEAST(76)])
{
    double part_2[26];
    wrist_part_2(q71, q73, part_2);
    const double t1 = 1.0 / part_2[9];
    const double length_0_by_q71 = (part_2[5] * part_2[20] - part_2[8] * part_2[21] - part_2[7]
        * part_2[22]) * t1;
    P[0] = length_0_by_q71;
    const double layer_0_x_by_q73 = part_2[3] - 0.011 * part_2[0];
    const double layer_0_y_by_q73 = part_2[10] - 0.011 * part_2[2];
    const double layer_0_z_by_q73 = part_2[12] - 0.011 * part_2[11];
    const double t2 = part_2[5] * layer_0_x_by_q73 - part_2[8] * layer_0_y_by_q73 + part_2[7]
        * layer_0_z_by_q73;
    P[1] = -(t2 * t1);
    const double t3 = part_2[14] * part_2[23] - part_2[16] * part_2[24] - part_2[15] * part_2[25];
    const double t4 = 1.0 / part_2[17];
    P[38] = t3 * t4;
    const double layer_1_x_by_q73 = part_2[13] - 0.013 * part_2[0];
    const double layer_1_y_by_q73 = part_2[18] - 0.013 * part_2[2];
    const double layer_1_z_by_q73 = part_2[19] - 0.013 * part_2[11];
    const double t5 = part_2[14] * layer_1_x_by_q73 - part_2[16] * layer_1_y_by_q73 + part_2[15]
        * layer_1_z_by_q73;
    P[39] = -(t5 * t4);
    static const double table7[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i6 = 0; i6 < 18; ++i6) {
        const double t8 = table7[i6][0] * part_2[4];
        const double strand_x = part_2[5] - t8;
        const double t9 = table7[i6][0] * part_2[6];
        const double strand_y = table7[i6][1] + part_2[8] - table7[i6][0] * part_2[1];
        const double strand_z = part_2[7] - t9;
        const double t10 = strand_x * (part_2[20] + t9) - strand_y * part_2[21] - strand_z
            * (part_2[22] + t8);
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t11 = 1.0 / length;
        const double strand_x_by_q73 = layer_0_x_by_q73 + table7[i6][0] * part_2[0];
        const double strand_y_by_q73 = layer_0_y_by_q73 + table7[i6][0] * part_2[2];
        const double strand_z_by_q73 = layer_0_z_by_q73 + table7[i6][0] * part_2[11];
        const double t12 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        P[2 + 2 * i6] = t10 * t11;
        P[3 + 2 * i6] = -(t12 * t11);
    }
    static const double table14[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i13 = 0; i13 < 18; ++i13) {
        const double t15 = table14[i13][0] * part_2[4];
        const double strand_x_2 = part_2[14] - t15;
        const double t16 = table14[i13][0] * part_2[6];
        const double strand_y_2 = table14[i13][1] + part_2[16] - table14[i13][0] * part_2[1];
        const double strand_z_2 = part_2[15] - t16;
        const double t17 = strand_x_2 * (part_2[23] + t16) - strand_y_2 * part_2[24] - strand_z_2
            * (part_2[25] + t15);
        const double t18 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double t19 = 1.0 / sinew_sqrt(t18);
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + table14[i13][0] * part_2[0];
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table14[i13][0] * part_2[2];
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + table14[i13][0] * part_2[11];
        const double t20 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        P[40 + 2 * i13] = t17 * t19;
        P[41 + 2 * i13] = -(t20 * t19);
    }
}

void wrist_tendon_hessian(double q71, double q73, double H[SINEW_AT_LEAST(152)])
{
    double part_1[53];
    wrist_part_1(q71, q73, part_1);
    const double t1 = part_1[6] * part_1[19] - part_1[7] * part_1[20] + part_1[8] * part_1[21]
        + part_1[2] * part_1[2];
    const double t2 = part_1[3] * part_1[3];
    const double length_0_by_q71_by_q71 = (t1 + t2 + part_1[5] * part_1[5] - part_1[10]
        * part_1[10]) * part_1[9];
    H[0] = length_0_by_q71_by_q71;
    const double z_x_by_q71_by_q73 = part_1[36] + part_1[29] + part_1[37];
    const double t3 = part_1[30] - 0.018 * z_x_by_q71_by_q73 + 0.004 * part_1[38];
    const double t4 = 0.01 * z_x_by_q71_by_q73;
    const double t5 = 0.011 * part_1[32];
    const double layer_0_x_by_q71_by_q73 = t3 + t4 - t5;
    const double t6 = 0.011 * part_1[27];
    const double layer_0_z_by_q71_by_q73 = part_1[40] - t6;
    const double t7 = part_1[6] * layer_0_x_by_q71_by_q73 - part_1[7] * part_1[39] - part_1[8]
        * layer_0_z_by_q71_by_q73;
    const double layer_0_x_by_q73 = part_1[26] - t6;
    const double layer_0_y_by_q73 = part_1[28] - 0.011 * part_1[25];
    const double layer_0_z_by_q73 = part_1[31] - t5;
    const double t8 = t7 - part_1[2] * layer_0_x_by_q73 - part_1[3] * layer_0_y_by_q73 + part_1[5]
        * layer_0_z_by_q73;
    const double t9 = part_1[6] * layer_0_x_by_q73 - part_1[7] * layer_0_y_by_q73 + part_1[8]
        * layer_0_z_by_q73;
    const double length_0_by_q73 = t9 * part_1[9];
    const double length_0_by_q71_by_q73 = (t8 + part_1[10] * length_0_by_q73) * part_1[9];
    H[1] = length_0_by_q71_by_q73;
    H[2] = length_0_by_q71_by_q73;
    const double layer_0_x_by_q73_by_q73 = part_1[45] - 0.011 * part_1[46];
    const double layer_0_y_by_q73_by_q73 = part_1[47] - 0.011 * part_1[44];
    const double t10 = part_1[6] * layer_0_x_by_q73_by_q73 + part_1[7] * layer_0_y_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = part_1[48] - 0.011 * part_1[49];
    const double t11 = t10 + part_1[8] * layer_0_z_by_q73_by_q73 + layer_0_x_by_q73
        * layer_0_x_by_q73;
    const double t12 = t11 + layer_0_y_by_q73 * layer_0_y_by_q73 + layer_0_z_by_q73
        * layer_0_z_by_q73;
    const double length_0_by_q73_by_q73 = (t12 - length_0_by_q73 * length_0_by_q73) * part_1[9];
    H[3] = length_0_by_q73_by_q73;
    const double t13 = 0.013 * part_1[32];
    const double t14 = 0.013 * part_1[27];
    const double t15 = part_1[14] * part_1[22] - part_1[15] * part_1[23] + part_1[16] * part_1[24];
    const double t16 = part_1[12] * part_1[12];
    const double t17 = t15 + part_1[11] * part_1[11] + t16 + part_1[13] * part_1[13] - part_1[18]
        * part_1[18];
    H[76] = t17 * part_1[17];
    const double layer_1_x_by_q71_by_q73 = t3 - t4 - t13;
    const double layer_1_z_by_q71_by_q73 = part_1[42] - t14;
    const double t18 = part_1[14] * layer_1_x_by_q71_by_q73 - part_1[15] * part_1[41] - part_1[16]
        * layer_1_z_by_q71_by_q73;
    const double layer_1_x_by_q73 = part_1[33] - t14;
    const double layer_1_y_by_q73 = part_1[34] - 0.013 * part_1[25];
    const double layer_1_z_by_q73 = part_1[35] - t13;
    const double t19 = t18 - part_1[11] * layer_1_x_by_q73 - part_1[12] * layer_1_y_by_q73
        + part_1[13] * layer_1_z_by_q73;
    const double t20 = part_1[14] * layer_1_x_by_q73 - part_1[15] * layer_1_y_by_q73 + part_1[16]
        * layer_1_z_by_q73;
    const double length_19_by_q73 = t20 * part_1[17];
    const double length_19_by_q71_by_q73 = (t19 + part_1[18] * length_19_by_q73) * part_1[17];
    H[77] = length_19_by_q71_by_q73;
    H[78] = length_19_by_q71_by_q73;
    const double layer_1_x_by_q73_by_q73 = part_1[50] - 0.013 * part_1[46];
    const double layer_1_y_by_q73_by_q73 = part_1[51] - 0.013 * part_1[44];
    const double t21 = part_1[14] * layer_1_x_by_q73_by_q73 + part_1[15] * layer_1_y_by_q73_by_q73;
    const double layer_1_z_by_q73_by_q73 = part_1[52] - 0.013 * part_1[49];
    const double t22 = t21 + part_1[16] * layer_1_z_by_q73_by_q73 + layer_1_x_by_q73
        * layer_1_x_by_q73;
    const double t23 = t22 + layer_1_y_by_q73 * layer_1_y_by_q73 + layer_1_z_by_q73
        * layer_1_z_by_q73;
    const double length_19_by_q73_by_q73 = (t23 - length_19_by_q73 * length_19_by_q73) * part_1[17];
    H[79] = length_19_by_q73_by_q73;
    static const double table25[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i24 = 0; i24 < 18; ++i24) {
        const double t26 = table25[i24][0] * part_1[4];
        const double strand_x = part_1[6] - t26;
        const double strand_y = table25[i24][1] + part_1[7] - table25[i24][0] * part_1[0];
        const double t27 = table25[i24][0] * part_1[1];
        const double strand_z = part_1[8] - t27;
        const double t28 = strand_x * (part_1[19] + t26) - strand_y * part_1[20] + strand_z
            * (part_1[21] + t27);
        const double strand_x_by_q71 = part_1[2] + t27;
        const double strand_z_by_q71 = part_1[5] + t26;
        const double t29 = t28 + t2 + strand_x_by_q71 * strand_x_by_q71 + strand_z_by_q71
            * strand_z_by_q71;
        const double t30 = strand_x * strand_x_by_q71 - strand_y * part_1[3] - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t31 = 1.0 / length;
        const double length_by_q71 = t30 * t31;
        const double length_by_q71_by_q71 = (t29 - length_by_q71 * length_by_q71) * t31;
        const double t32 = table25[i24][0] * part_1[32];
        const double t33 = table25[i24][0] * part_1[27];
        const double t34 = strand_x * (layer_0_x_by_q71_by_q73 + t32) - strand_y * part_1[39]
            - strand_z * (layer_0_z_by_q71_by_q73 + t33);
        const double strand_y_by_q73 = layer_0_y_by_q73 + table25[i24][0] * part_1[25];
        const double strand_x_by_q73 = layer_0_x_by_q73 + t33;
        const double strand_z_by_q73 = layer_0_z_by_q73 + t32;
        const double t35 = t34 - part_1[3] * strand_y_by_q73 - strand_x_by_q71 * strand_x_by_q73
            + strand_z_by_q71 * strand_z_by_q73;
        const double t36 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t36 * t31;
        const double length_by_q71_by_q73 = (t35 + length_by_q71 * length_by_q73) * t31;
        const double strand_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 + table25[i24][0]
            * part_1[46];
        const double strand_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 + table25[i24][0]
            * part_1[44];
        const double strand_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 + table25[i24][0]
            * part_1[49];
        const double t37 = strand_x * strand_x_by_q73_by_q73 + strand_y * strand_y_by_q73_by_q73
            + strand_z * strand_z_by_q73_by_q73;
        const double t38 = t37 + strand_x_by_q73 * strand_x_by_q73 + strand_y_by_q73
            * strand_y_by_q73;
        const double length_by_q73_by_q73 = (t38 + strand_z_by_q73 * strand_z_by_q73 - length_by_q73
            * length_by_q73) * t31;
        H[4 + 4 * i24] = length_by_q71_by_q71;
        H[5 + 4 * i24] = length_by_q71_by_q73;
        H[6 + 4 * i24] = length_by_q71_by_q73;
        H[7 + 4 * i24] = length_by_q73_by_q73;
    }
    static const double table40[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i39 = 0; i39 < 18; ++i39) {
        const double t41 = table40[i39][0] * part_1[4];
        const double strand_x_2 = part_1[14] - t41;
        const double strand_y_2 = table40[i39][1] + part_1[15] - table40[i39][0] * part_1[0];
        const double t42 = table40[i39][0] * part_1[1];
        const double strand_z_2 = part_1[16] - t42;
        const double t43 = strand_x_2 * (part_1[22] + t41) - strand_y_2 * part_1[23] + strand_z_2
            * (part_1[24] + t42);
        const double strand_x_by_q71_2 = part_1[11] + t42;
        const double strand_z_by_q71_2 = part_1[13] + t41;
        const double t44 = t43 + t16 + strand_x_by_q71_2 * strand_x_by_q71_2 + strand_z_by_q71_2
            * strand_z_by_q71_2;
        const double t45 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * part_1[12] - strand_z_2
            * strand_z_by_q71_2;
        const double t46 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double t47 = 1.0 / sinew_sqrt(t46);
        const double length_by_q71_2 = t45 * t47;
        const double length_by_q71_by_q71_2 = (t44 - length_by_q71_2 * length_by_q71_2) * t47;
        const double t48 = table40[i39][0] * part_1[32];
        const double t49 = table40[i39][0] * part_1[27];
        const double t50 = strand_x_2 * (layer_1_x_by_q71_by_q73 + t48) - strand_y_2 * part_1[41]
            - strand_z_2 * (layer_1_z_by_q71_by_q73 + t49);
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table40[i39][0] * part_1[25];
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + t49;
        const double t51 = t50 - part_1[12] * strand_y_by_q73_2 - strand_x_by_q71_2
            * strand_x_by_q73_2;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + t48;
        const double t52 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t52 * t47;
        const double t53 = t51 + strand_z_by_q71_2 * strand_z_by_q73_2 + length_by_q71_2
            * length_by_q73_2;
        const double length_by_q71_by_q73_2 = t53 * t47;
        const double strand_x_by_q73_by_q73_2 = layer_1_x_by_q73_by_q73 + table40[i39][0]
            * part_1[46];
        const double strand_y_by_q73_by_q73_2 = layer_1_y_by_q73_by_q73 + table40[i39][0]
            * part_1[44];
        const double t54 = strand_x_2 * strand_x_by_q73_by_q73_2 + strand_y_2
            * strand_y_by_q73_by_q73_2;
        const double strand_z_by_q73_by_q73_2 = layer_1_z_by_q73_by_q73 + table40[i39][0]
            * part_1[49];
        const double t55 = t54 + strand_z_2 * strand_z_by_q73_by_q73_2 + strand_x_by_q73_2
            * strand_x_by_q73_2;
        const double t56 = t55 + strand_y_by_q73_2 * strand_y_by_q73_2 + strand_z_by_q73_2
            * strand_z_by_q73_2;
        const double length_by_q73_by_q73_2 = (t56 - length_by_q73_2 * length_by_q73_2) * t47;
        H[80 + 4 * i39] = length_by_q71_by_q71_2;
        H[81 + 4 * i39] = length_by_q71_by_q73_2;
        H[82 + 4 * i39] = length_by_q71_by_q73_2;
        H[83 + 4 * i39] = length_by_q73_by_q73_2;
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
    const double z_plane_y_by_t = u_e * cos_A_by_t + cos_A * u_e_by_t;
    const double t20 = M_y_by_t - 0.018 * z_plane_y_by_t - 0.004 * (u_e * sin_A_by_t + sin_A
        * u_e_by_t);
    const double t21 = 0.01 * z_plane_y_by_t;
    const double layer_0_y_by_t = t20 + t21 - 0.011 * u_y_by_t;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t22 = 0.004 * (u_e * sin_A);
    const double t23 = 0.01 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t22 + t23 + 0.011 * u_y;
    const double z_z_by_t = cos_q71 * sin_A_by_t + sin_q71 * z_plane_x_by_t - sin_A * cos_q71_by_t
        + z_plane_x * sin_q71_by_t;
    const double origin_z_by_t = sin_q71 * M_e_by_t + M_e * sin_q71_by_t - 0.018 * z_z_by_t;
    const double x_z_by_t = cos_q71 * cos_A_by_t - sin_q71 * x_plane_x_by_t - cos_A * cos_q71_by_t
        - x_plane_x * sin_q71_by_t;
    const double t24 = origin_z_by_t + 0.004 * x_z_by_t;
    const double t25 = 0.01 * z_z_by_t;
    const double y_z_by_t = sin_q71 * u_e_by_t + u_e * sin_q71_by_t;
    const double layer_0_z_by_t = t24 + t25 - 0.011 * y_z_by_t;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double origin_z = sin_q71 * M_e - 0.018 * z_z;
    const double t26 = 0.004 * (cos_q71 * cos_A - sin_q71 * x_plane_x);
    const double t27 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t26 - t27 + 0.011 * y_z;
    const double t28 = layer_0_x * layer_0_x_by_t - layer_0_y * layer_0_y_by_t + layer_0_z
        * layer_0_z_by_t;
    const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
        * layer_0_z);
    delta_theta_rate[0] = 200.0 * (t28 / length_0);
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
    delta_theta_rate[19] = 200.0 * (t29 / length_19);
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
        delta_theta_rate[1 + i30] = 200.0 * (t32 / length);
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
        delta_theta_rate[20 + i33] = 200.0 * (t35 / sinew_sqrt(t36));
    }
}

void wrist_joint_torque(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    double tau[SINEW_AT_LEAST(2)])
{
    double part_2[26];
    wrist_part_2(q71, q73, part_2);
    const double per_length_0 = f[0] / part_2[9];
    const double per_length_19 = f[19] / part_2[17];
    static const double table8[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    double sum2 = -0.0;
    double sum3 = -0.0;
    double sum4 = -0.0;
    double sum5 = part_2[7] * per_length_0;
    double sum6 = part_2[8] * per_length_0;
    double sum7 = part_2[5] * per_length_0;
    for (int i1 = 0; i1 < 18; ++i1) {
        const double before9 = sum2;
        const double before10 = sum3;
        const double before11 = sum4;
        const double before12 = sum5;
        const double before13 = sum6;
        const double before14 = sum7;
        const double strand_z = part_2[7] - table8[i1][0] * part_2[6];
        const double strand_x = part_2[5] - table8[i1][0] * part_2[4];
        const double strand_y = table8[i1][1] + part_2[8] - table8[i1][0] * part_2[1];
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double per_length = f[1 + i1] / length;
        const double t15 = table8[i1][0] * per_length;
        sum2 = before9 + strand_z * t15;
        sum3 = before10 + strand_y * t15;
        sum4 = before11 + strand_x * t15;
        sum5 = before12 + strand_z * per_length;
        sum6 = before13 + strand_y * per_length;
        sum7 = before14 + strand_x * per_length;
    }
    static const double table23[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    double sum17 = -0.0;
    double sum18 = -0.0;
    double sum19 = -0.0;
    double sum20 = part_2[15] * per_length_19;
    double sum21 = part_2[16] * per_length_19;
    double sum22 = part_2[14] * per_length_19;
    for (int i16 = 0; i16 < 18; ++i16) {
        const double before24 = sum17;
        const double before25 = sum18;
        const double before26 = sum19;
        const double before27 = sum20;
        const double before28 = sum21;
        const double before29 = sum22;
        const double strand_z_2 = part_2[15] - table23[i16][0] * part_2[6];
        const double strand_x_2 = part_2[14] - table23[i16][0] * part_2[4];
        const double strand_y_2 = table23[i16][1] + part_2[16] - table23[i16][0] * part_2[1];
        const double t30 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double per_length_2 = f[20 + i16] / sinew_sqrt(t30);
        const double t31 = table23[i16][0] * per_length_2;
        sum17 = before24 + strand_z_2 * t31;
        sum18 = before25 + strand_y_2 * t31;
        sum19 = before26 + strand_x_2 * t31;
        sum20 = before27 + strand_z_2 * per_length_2;
        sum21 = before28 + strand_y_2 * per_length_2;
        sum22 = before29 + strand_x_2 * per_length_2;
    }
    const double t32 = sum7 * (part_2[3] - 0.011 * part_2[0]) - sum6 * (part_2[10] - 0.011
        * part_2[2]);
    const double t33 = t32 + sum5 * (part_2[12] - 0.011 * part_2[11]) + sum22 * (part_2[13] - 0.013
        * part_2[0]);
    const double t34 = t33 - sum21 * (part_2[18] - 0.013 * part_2[2]) + sum20 * (part_2[19] - 0.013
        * part_2[11]);
    const double pull_by_y = sum4 + sum19;
    const double pull_by_y_4 = sum2 + sum17;
    const double t35 = t34 + pull_by_y * part_2[0] - (sum3 + sum18) * part_2[2] + pull_by_y_4
        * part_2[11];
    const double t36 = part_2[4] * pull_by_y_4 - part_2[6] * pull_by_y - sum7 * part_2[20] + sum6
        * part_2[21];
    const double t37 = t36 + sum5 * part_2[22] - sum22 * part_2[23] + sum21 * part_2[24] + sum20
        * part_2[25];
    tau[0] = t37;
    tau[1] = t35;
}

void wrist_joint_stiffness(double q71, double q73, const double f[SINEW_AT_LEAST(38)],
    const double k[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(4)])
{
    double part_1[53];
    wrist_part_1(q71, q73, part_1);
    const double along_38 = part_1[2] * part_1[2] + part_1[3] * part_1[3] + part_1[5] * part_1[5];
    const double per_length_0 = f[0] * part_1[9];
    const double across_0 = k[0] - per_length_0;
    const double t1 = part_1[4] + part_1[4];
    const double t2 = part_1[1] + part_1[1];
    const double along_by_y_4 = t1 * part_1[5] + t2 * part_1[2];
    const double along_by_y_squared_4 = part_1[4] * part_1[4] + part_1[1] * part_1[1];
    const double along_40 = part_1[11] * part_1[11] + part_1[12] * part_1[12] + part_1[13]
        * part_1[13];
    const double per_length_19 = f[19] * part_1[17];
    const double across_19 = k[19] - per_length_19;
    const double along_by_y_6 = t1 * part_1[13] + t2 * part_1[11];
    const double t3 = 0.011 * part_1[27];
    const double layer_0_x_by_q73 = part_1[26] - t3;
    const double layer_0_y_by_q73 = part_1[28] - 0.011 * part_1[25];
    const double t4 = 0.011 * part_1[32];
    const double layer_0_z_by_q73 = part_1[31] - t4;
    const double along = part_1[2] * layer_0_x_by_q73 + part_1[3] * layer_0_y_by_q73 - part_1[5]
        * layer_0_z_by_q73;
    const double t5 = part_1[6] * layer_0_x_by_q73 - part_1[7] * layer_0_y_by_q73 + part_1[8]
        * layer_0_z_by_q73;
    const double length_0_by_q73 = t5 * part_1[9];
    const double K_0 = per_length_0 * along + part_1[10] * length_0_by_q73 * across_0;
    const double t6 = part_1[4] * layer_0_z_by_q73 - part_1[1] * layer_0_x_by_q73 - part_1[2]
        * part_1[27];
    const double along_by_y = t6 - part_1[25] * part_1[3] + part_1[32] * part_1[5];
    const double along_by_y_squared = part_1[4] * part_1[32] - part_1[1] * part_1[27];
    const double t7 = 0.013 * part_1[27];
    const double t8 = 0.013 * part_1[32];
    const double layer_1_x_by_q73 = part_1[33] - t7;
    const double layer_1_y_by_q73 = part_1[34] - 0.013 * part_1[25];
    const double layer_1_z_by_q73 = part_1[35] - t8;
    const double along_19 = part_1[11] * layer_1_x_by_q73 + part_1[12] * layer_1_y_by_q73
        - part_1[13] * layer_1_z_by_q73;
    const double t9 = part_1[14] * layer_1_x_by_q73 - part_1[15] * layer_1_y_by_q73 + part_1[16]
        * layer_1_z_by_q73;
    const double length_19_by_q73 = t9 * part_1[17];
    const double K_19 = per_length_19 * along_19 + part_1[18] * length_19_by_q73 * across_19;
    const double t10 = part_1[4] * layer_1_z_by_q73 - part_1[1] * layer_1_x_by_q73 - part_1[25]
        * part_1[12];
    const double along_by_y_2 = t10 + part_1[32] * part_1[13] - part_1[11] * part_1[27];
    const double t11 = layer_0_x_by_q73 * layer_0_x_by_q73 + layer_0_y_by_q73 * layer_0_y_by_q73;
    const double along_42 = t11 + layer_0_z_by_q73 * layer_0_z_by_q73;
    const double t12 = part_1[32] + part_1[32];
    const double t13 = part_1[27] + part_1[27];
    const double along_by_y_8 = part_1[43] * layer_0_y_by_q73 + t12 * layer_0_z_by_q73 + t13
        * layer_0_x_by_q73;
    const double along_by_y_squared_8 = part_1[25] * part_1[25] + part_1[32] * part_1[32]
        + part_1[27] * part_1[27];
    const double t14 = layer_1_x_by_q73 * layer_1_x_by_q73 + layer_1_y_by_q73 * layer_1_y_by_q73;
    const double along_44 = t14 + layer_1_z_by_q73 * layer_1_z_by_q73;
    const double t15 = per_length_19 * along_44 + across_19 * length_19_by_q73 * length_19_by_q73;
    const double along_by_y_10 = part_1[43] * layer_1_y_by_q73 + t12 * layer_1_z_by_q73 + t13
        * layer_1_x_by_q73;
    static const double table26[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    double sum17 = K_0;
    double sum18 = per_length_0 * along_42 + across_0 * length_0_by_q73 * length_0_by_q73;
    double sum19 = per_length_0 * along_38 + across_0 * part_1[10] * part_1[10];
    double sum20 = -0.0;
    double sum21 = -0.0;
    double sum22 = -0.0;
    double sum23 = part_1[8] * per_length_0;
    double sum24 = part_1[7] * per_length_0;
    double sum25 = part_1[6] * per_length_0;
    for (int i16 = 0; i16 < 18; ++i16) {
        const double before27 = sum17;
        const double before28 = sum18;
        const double before29 = sum19;
        const double before30 = sum20;
        const double before31 = sum21;
        const double before32 = sum22;
        const double before33 = sum23;
        const double before34 = sum24;
        const double before35 = sum25;
        const double t36 = table26[i16][0] * part_1[4];
        const double strand_x = part_1[6] - t36;
        const double strand_y = table26[i16][1] + part_1[7] - table26[i16][0] * part_1[0];
        const double t37 = table26[i16][0] * part_1[1];
        const double strand_z = part_1[8] - t37;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t38 = 1.0 / length;
        const double per_length = f[1 + i16] * t38;
        const double slope = along_by_y + table26[i16][0] * along_by_y_squared;
        const double t39 = strand_x * (part_1[2] + t37) - strand_y * part_1[3] - strand_z
            * (part_1[5] + t36);
        const double length_by_q71 = t39 * t38;
        const double strand_x_by_q73 = layer_0_x_by_q73 + table26[i16][0] * part_1[27];
        const double strand_y_by_q73 = layer_0_y_by_q73 + table26[i16][0] * part_1[25];
        const double strand_z_by_q73 = layer_0_z_by_q73 + table26[i16][0] * part_1[32];
        const double t40 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t40 * t38;
        const double across = k[1 + i16] - per_length;
        const double t41 = before27 + per_length * (along - table26[i16][0] * slope) + length_by_q71
            * length_by_q73 * across;
        const double slope_4 = along_by_y_8 + table26[i16][0] * along_by_y_squared_8;
        const double t42 = before28 + per_length * (along_42 + table26[i16][0] * slope_4) + across
            * length_by_q73 * length_by_q73;
        const double slope_2 = along_by_y_4 + table26[i16][0] * along_by_y_squared_4;
        const double t43 = before29 + per_length * (along_38 + table26[i16][0] * slope_2) + across
            * length_by_q71 * length_by_q71;
        const double t44 = table26[i16][0] * per_length;
        sum17 = t41;
        sum18 = t42;
        sum19 = t43;
        sum20 = before30 + strand_y * t44;
        sum21 = before31 + strand_z * t44;
        sum22 = before32 + strand_x * t44;
        sum23 = before33 + strand_z * per_length;
        sum24 = before34 + strand_y * per_length;
        sum25 = before35 + strand_x * per_length;
    }
    static const double table55[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    double sum46 = K_19;
    double sum47 = t15;
    double sum48 = per_length_19 * along_40 + across_19 * part_1[18] * part_1[18];
    double sum49 = -0.0;
    double sum50 = -0.0;
    double sum51 = -0.0;
    double sum52 = part_1[16] * per_length_19;
    double sum53 = part_1[15] * per_length_19;
    double sum54 = part_1[14] * per_length_19;
    for (int i45 = 0; i45 < 18; ++i45) {
        const double before56 = sum46;
        const double before57 = sum47;
        const double before58 = sum48;
        const double before59 = sum49;
        const double before60 = sum50;
        const double before61 = sum51;
        const double before62 = sum52;
        const double before63 = sum53;
        const double before64 = sum54;
        const double t65 = table55[i45][0] * part_1[4];
        const double strand_x_2 = part_1[14] - t65;
        const double strand_y_2 = table55[i45][1] + part_1[15] - table55[i45][0] * part_1[0];
        const double t66 = table55[i45][0] * part_1[1];
        const double strand_z_2 = part_1[16] - t66;
        const double t67 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double t68 = 1.0 / sinew_sqrt(t67);
        const double per_length_2 = f[20 + i45] * t68;
        const double slope_3 = along_by_y_2 + table55[i45][0] * along_by_y_squared;
        const double t69 = strand_x_2 * (part_1[11] + t66) - strand_y_2 * part_1[12] - strand_z_2
            * (part_1[13] + t65);
        const double length_by_q71_2 = t69 * t68;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + table55[i45][0] * part_1[27];
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table55[i45][0] * part_1[25];
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + table55[i45][0] * part_1[32];
        const double t70 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t70 * t68;
        const double across_2 = k[20 + i45] - per_length_2;
        const double t71 = before56 + per_length_2 * (along_19 - table55[i45][0] * slope_3)
            + length_by_q71_2 * length_by_q73_2 * across_2;
        const double slope_4_2 = along_by_y_10 + table55[i45][0] * along_by_y_squared_8;
        const double t72 = before57 + per_length_2 * (along_44 + table55[i45][0] * slope_4_2)
            + across_2 * length_by_q73_2 * length_by_q73_2;
        const double slope_2_2 = along_by_y_6 + table55[i45][0] * along_by_y_squared_4;
        const double t73 = before58 + per_length_2 * (along_40 + table55[i45][0] * slope_2_2)
            + across_2 * length_by_q71_2 * length_by_q71_2;
        const double t74 = table55[i45][0] * per_length_2;
        sum46 = t71;
        sum47 = t72;
        sum48 = t73;
        sum49 = before59 + strand_y_2 * t74;
        sum50 = before60 + strand_z_2 * t74;
        sum51 = before61 + strand_x_2 * t74;
        sum52 = before62 + strand_z_2 * per_length_2;
        sum53 = before63 + strand_y_2 * per_length_2;
        sum54 = before64 + strand_x_2 * per_length_2;
    }
    const double pull_by_y = sum22 + sum51;
    const double pull_by_y_4 = sum21 + sum50;
    const double t75 = sum19 + sum48 + part_1[4] * pull_by_y + part_1[1] * pull_by_y_4 + sum25
        * part_1[19];
    const double t76 = t75 - sum24 * part_1[20] + sum23 * part_1[21] + sum54 * part_1[22] - sum53
        * part_1[23];
    const double z_x_by_q71_by_q73 = part_1[36] + part_1[37] + part_1[29];
    const double t77 = part_1[30] - 0.018 * z_x_by_q71_by_q73 + 0.004 * part_1[38];
    const double t78 = 0.01 * z_x_by_q71_by_q73;
    const double t79 = sum17 + sum46 - sum25 * (t77 + t78 - t4) + sum24 * part_1[39] + sum23
        * (part_1[40] - t3);
    const double t80 = t79 - sum54 * (t77 - t78 - t8) + sum53 * part_1[41] + sum52 * (part_1[42]
        - t7);
    const double K_01 = t80 - part_1[32] * pull_by_y + part_1[27] * pull_by_y_4;
    const double t81 = -K_01;
    const double t82 = sum18 + sum47 + sum25 * (part_1[45] - 0.011 * part_1[46]) + sum24
        * (part_1[47] - 0.011 * part_1[44]);
    const double t83 = t82 + sum23 * (part_1[48] - 0.011 * part_1[49]) + sum54 * (part_1[50] - 0.013
        * part_1[46]);
    const double t84 = t83 + sum53 * (part_1[51] - 0.013 * part_1[44]) + sum52 * (part_1[52] - 0.013
        * part_1[49]);
    const double t85 = t84 + pull_by_y * part_1[46] + (sum20 + sum49) * part_1[44] + pull_by_y_4
        * part_1[49];
    K[0] = t76 + sum52 * part_1[24];
    K[1] = t81;
    K[2] = t81;
    K[3] = t85;
}
