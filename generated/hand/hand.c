/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The complete hand: 19 finger coordinates, two wrist angles, 38 tendons
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f
 * Do not edit: change the model and generate again.
 */
#include "hand.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

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

SINEW_NOT_INLINE static void hand_part_1(const double q_wrist[SINEW_AT_LEAST(2)],
    double part[SINEW_AT_LEAST(16)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
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
    const double t3 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t3;
    const double z_plane_x = u_y * cos_A;
    const double sin_A = (p_y * root - p_z * limited) * t3;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double M_x = cos_q71 * M_e;
    const double x_plane_x = u_y * sin_A;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double t4 = 0.004 - M_x + 0.018 * z_x + 0.004 * x_x;
    const double t5 = 0.01 * z_x;
    const double y_x = cos_q71 * u_e;
    const double layer_0_x = t4 - t5 + 0.011 * y_x;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double origin_z = sin_q71 * M_e - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t6 = 0.004 * x_z;
    const double t7 = 0.01 * z_z;
    const double y_z = sin_q71 * u_e;
    const double layer_0_z = 0.008 - origin_z - t6 - t7 + 0.011 * y_z;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double z_plane_y = u_e * cos_A;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double layer_1_x = t4 + t5 + 0.013 * y_x;
    const double layer_1_z = 0.028 - origin_z - t6 + t7 + 0.013 * y_z;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    part[0] = t2;
    part[1] = z_x;
    part[2] = M_x;
    part[3] = x_x;
    part[4] = y_x;
    part[5] = z_z;
    part[6] = origin_z;
    part[7] = x_z;
    part[8] = y_z;
    part[9] = across + across;
    part[10] = z_plane_y;
    part[11] = M_y + 0.018 * z_plane_y;
    part[12] = u_e * sin_A;
    part[13] = across_by_y + across_by_y;
    part[14] = across_38 + across_38;
    part[15] = across_by_y_2 + across_by_y_2;
}

void hand_fingertips(const double q[SINEW_AT_LEAST(19)], const double q_wrist[SINEW_AT_LEAST(2)],
    double in_palm[SINEW_AT_LEAST(80)], double in_forearm[SINEW_AT_LEAST(80)])
{
    double part_1[16];
    hand_part_1(q_wrist, part_1);
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const double phi3_8 = q[16] + q[17];
    const double phi4_8 = phi3_8 + 1.2222222222222223 * q[17];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], phi4);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s4 = sines1.s[1];
    const double c4 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines2.s[0];
    const double c2 = sines2.c[0];
    const double s3 = sines2.s[1];
    const double c3 = sines2.c[1];
    const struct sinew_sines2 sines3 = sinew_one_sincos2(q[15], phi4_8);
    const double s1_8 = sines3.s[0];
    const double c1_8 = sines3.c[0];
    const double s4_8 = sines3.s[1];
    const double c4_8 = sines3.c[1];
    const struct sinew_sines2 sines4 = sinew_one_sincos2(q[16], phi3_8);
    const double s2_8 = sines4.s[0];
    const double c2_8 = sines4.c[0];
    const double s3_8 = sines4.s[1];
    const double c3_8 = sines4.c[1];
    const struct sinew_sines sines5 = sinew_one_sincos(q[18]);
    const double sin2 = sines5.s[0];
    const double cos2 = sines5.c[0];
    in_palm[66] = s1_8;
    const double ptipz_8 = 0.032304 * s2_8 + 0.02384 * s3_8 + 0.01608 * s4_8;
    const double t6 = 0.01 * cos2;
    const double A = 1.2 - cos2;
    const double reach_squared_2 = sinew_max(sin2 * sin2 + A * A, 1e-12);
    const double t7 = 1.0 / reach_squared_2;
    const double reach_2 = sinew_sqrt(reach_squared_2);
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double limited_2 = sinew_min(sinew_max(C, -reach_2), reach_2);
    const double slack = 0.6944444444444444 * (C + reach_2) * (C - reach_2);
    const double side = 1.2 * sinew_sqrt(sinew_max(-slack, 1e-12));
    const double along = 0.012 - t6 + 0.011 * ((sin2 * side - A * limited_2) * t7);
    const double t8 = 0.01 * sin2;
    const double across = t8 - 0.011 * ((sin2 * limited_2 + A * side) * t7);
    const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
    const double t9 = 1.0 / length;
    const double cos3 = along * t9;
    const double R42x_8 = s1_8 * c4_8;
    const double t10 = 0.0048 + (0.032304 * c2_8 + 0.02384 * c3_8);
    const double ptipy_8 = s1_8 * t10 + 0.00456 * c1_8 + 0.01608 * R42x_8;
    const double t11 = 0.006 + ptipy_8;
    const double sin3 = across * t9;
    const double placed_58 = sin3 * t11 + 0.01 - t8 - cos3 * ptipz_8;
    const double u_y = 23.80952380952381 * part_1[0];
    const double placed_50 = 0.027 - cos3 * t11 - t6 - sin3 * ptipz_8;
    const double R41x_8 = c1_8 * c4_8;
    in_palm[64] = R41x_8;
    const double placed_42 = c1_8 * t10 + 0.065 - 0.00456 * s1_8 + 0.01608 * R41x_8;
    in_palm[67] = placed_42;
    const double seen_118 = part_1[6] - part_1[7] * placed_42 - part_1[8] * placed_50 - part_1[5]
        * placed_58;
    in_forearm[75] = seen_118;
    in_forearm[76] = 0.0;
    in_forearm[77] = 0.0;
    in_forearm[78] = 0.0;
    in_forearm[79] = 1.0;
    const double placed_56 = sin3 * c1_8;
    in_palm[74] = placed_56;
    const double placed_48 = cos3 * c1_8;
    const double seen_116 = part_1[7] * s1_8 + part_1[8] * placed_48 - part_1[5] * placed_56;
    in_forearm[74] = -seen_116;
    const double R42y_8 = s1_8 * s4_8;
    const double placed_54 = cos3 * c4_8 + sin3 * R42y_8;
    in_palm[73] = placed_54;
    const double placed_46 = cos3 * R42y_8 - sin3 * c4_8;
    const double R41y_8 = c1_8 * s4_8;
    const double seen_114 = part_1[7] * R41y_8 - part_1[8] * placed_46 + part_1[5] * placed_54;
    in_forearm[73] = seen_114;
    const double placed_52 = cos3 * s4_8 - sin3 * R42x_8;
    in_palm[72] = placed_52;
    const double placed_44 = cos3 * R42x_8 + sin3 * s4_8;
    in_palm[68] = placed_44;
    const double seen_112 = part_1[7] * R41x_8 - part_1[8] * placed_44 - part_1[5] * placed_52;
    in_forearm[72] = -seen_112;
    const double seen_110 = part_1[11] - u_y * placed_50 - part_1[12] * placed_42 + part_1[10]
        * placed_58;
    in_forearm[71] = seen_110;
    const double seen_108 = u_y * placed_48 + part_1[12] * s1_8 + part_1[10] * placed_56;
    in_forearm[70] = -seen_108;
    const double seen_106 = u_y * placed_46 - part_1[12] * R41y_8 + part_1[10] * placed_54;
    in_forearm[69] = -seen_106;
    const double seen_104 = u_y * placed_44 - part_1[12] * R41x_8 - part_1[10] * placed_52;
    in_forearm[68] = seen_104;
    const double origin_x = part_1[2] - 0.018 * part_1[1];
    const double seen_102 = origin_x + part_1[3] * placed_42 - part_1[4] * placed_50 - part_1[1]
        * placed_58;
    in_forearm[67] = seen_102;
    const double seen_100 = part_1[3] * s1_8 - part_1[4] * placed_48 + part_1[1] * placed_56;
    in_forearm[66] = seen_100;
    const double seen_98 = part_1[3] * R41y_8 + part_1[4] * placed_46 - part_1[1] * placed_54;
    in_forearm[65] = -seen_98;
    const double seen_96 = part_1[3] * R41x_8 + part_1[4] * placed_44 + part_1[1] * placed_52;
    in_forearm[64] = seen_96;
    const double ptipz = 0.045 * s2 + 0.0298 * s3 + 0.0201 * s4;
    const double R42y = s1 * c4;
    const double o4x = 0.045 * c2 + 0.0298 * c3;
    const double ptipy = s1 * o4x + 0.0201 * R42y;
    const double placed_22 = 0.01 - 0.5000000000000001 * ptipz + 0.8660254037844386 * ptipy;
    const double R41y = c1 * c4;
    const double ptipx = c1 * o4x + 0.0201 * R41y;
    const double placed_14 = 0.03 + 0.3830222215594891 * ptipy + 0.6427876096865393 * ptipx
        + 0.6634139481689384 * ptipz;
    in_palm[7] = placed_14;
    const double placed_6 = 0.01 - 0.32139380484326974 * ptipy - 0.5566703992264193 * ptipz
        + 0.766044443118978 * ptipx;
    in_palm[3] = placed_6;
    const double seen_22 = part_1[6] - part_1[7] * placed_6 + part_1[8] * placed_14 - part_1[5]
        * placed_22;
    in_forearm[11] = seen_22;
    in_forearm[60] = 0.0;
    in_forearm[61] = 0.0;
    in_forearm[62] = 0.0;
    in_forearm[63] = 1.0;
    const double R42x = s1 * s4;
    const double placed_20 = 0.5000000000000001 * c4 + 0.8660254037844386 * R42x;
    in_palm[10] = placed_20;
    const double R41x = c1 * s4;
    const double placed_12 = 0.3830222215594891 * R42x + 0.6427876096865393 * R41x
        - 0.6634139481689384 * c4;
    const double placed_4 = 0.32139380484326974 * R42x - 0.5566703992264193 * c4 - 0.766044443118978
        * R41x;
    in_palm[2] = placed_4;
    const double seen_20 = part_1[7] * placed_4 + part_1[8] * placed_12 - part_1[5] * placed_20;
    in_forearm[10] = -seen_20;
    const double placed_18 = 0.8660254037844386 * c1;
    const double placed_10 = 0.3830222215594891 * c1 - 0.6427876096865393 * s1;
    in_palm[5] = placed_10;
    const double placed_2 = 0.32139380484326974 * c1 + 0.766044443118978 * s1;
    const double seen_18 = part_1[7] * placed_2 + part_1[8] * placed_10 - part_1[5] * placed_18;
    in_forearm[9] = seen_18;
    const double placed_16 = 0.5000000000000001 * s4 - 0.8660254037844386 * R42y;
    in_palm[8] = placed_16;
    const double placed_8 = 0.3830222215594891 * R42y + 0.6427876096865393 * R41y
        + 0.6634139481689384 * s4;
    in_palm[4] = placed_8;
    const double placed = 0.32139380484326974 * R42y + 0.5566703992264193 * s4 - 0.766044443118978
        * R41y;
    const double seen_16 = part_1[7] * placed + part_1[8] * placed_8 + part_1[5] * placed_16;
    in_forearm[8] = seen_16;
    const double seen_14 = part_1[11] + u_y * placed_14 - part_1[12] * placed_6 + part_1[10]
        * placed_22;
    in_forearm[7] = seen_14;
    const double seen_12 = u_y * placed_12 + part_1[12] * placed_4 + part_1[10] * placed_20;
    in_forearm[6] = -seen_12;
    const double seen_10 = u_y * placed_10 + part_1[12] * placed_2 + part_1[10] * placed_18;
    in_forearm[5] = seen_10;
    const double seen_8 = u_y * placed_8 + part_1[12] * placed - part_1[10] * placed_16;
    in_forearm[4] = seen_8;
    const double seen_6 = origin_x + part_1[3] * placed_6 + part_1[4] * placed_14 - part_1[1]
        * placed_22;
    in_forearm[3] = seen_6;
    const double seen_4 = part_1[3] * placed_4 - part_1[4] * placed_12 + part_1[1] * placed_20;
    in_forearm[2] = seen_4;
    const double seen_2 = part_1[3] * placed_2 - part_1[4] * placed_10 + part_1[1] * placed_18;
    in_forearm[1] = -seen_2;
    const double seen = part_1[3] * placed - part_1[4] * placed_8 - part_1[1] * placed_16;
    in_forearm[0] = -seen;
    in_palm[75] = -placed_58;
    in_palm[76] = 0.0;
    in_palm[77] = 0.0;
    in_palm[78] = 0.0;
    in_palm[79] = 1.0;
    in_palm[71] = -placed_50;
    in_palm[70] = -placed_48;
    in_palm[69] = -placed_46;
    in_palm[65] = -R41y_8;
    in_palm[11] = -placed_22;
    in_palm[60] = 0.0;
    in_palm[61] = 0.0;
    in_palm[62] = 0.0;
    in_palm[63] = 1.0;
    in_palm[9] = -placed_18;
    in_palm[6] = -placed_12;
    in_palm[1] = -placed_2;
    in_palm[0] = -placed;
    static const double table13[3][12] = {
        {1.0, 0.006, 0.04038, 0.0298, 0.07, 0.0057, 0.0201, 1.0, 0.021, 0.0057, 0.0201,
            23.80952380952381},
        {1.0, 0.00648, 0.0436104, 0.032184, 0.072, 0.006156, 0.021708, 1.0, 0.007, 0.006156,
            0.021708, 23.80952380952381},
        {1.2222222222222223, 0.006, 0.04038, 0.0298, 0.07, 0.0057, 0.0201, -1.0, 0.007, -0.0057,
            -0.0201, -23.80952380952381}};
    static const unsigned short element14[3] = {7, 11, 14};
    for (int i12 = 0; i12 < 3; ++i12) {
        const struct sinew_sines sines15 = sinew_one_sincos(q[4 + 4 * i12]);
        const double s1_2 = sines15.s[0];
        const double c1_2 = sines15.c[0];
        const double phi3_2 = q[5 + 4 * i12] + q[6 + 4 * i12];
        const double phi4_2 = table13[i12][0] * q[element14[i12]] + phi3_2;
        const struct sinew_sines sines16 = sinew_one_sincos(phi4_2);
        const double s4_2 = sines16.s[0];
        const double c4_2 = sines16.c[0];
        const double R41x_2 = c1_2 * c4_2;
        const double R42x_2 = s1_2 * c4_2;
        const double seen_3 = part_1[3] * R41x_2 + part_1[4] * R42x_2 + part_1[1] * s4_2;
        const double R41y_2 = c1_2 * s4_2;
        const double R42y_2 = s1_2 * s4_2;
        const double seen_5 = part_1[3] * R41y_2 + part_1[4] * R42y_2 - part_1[1] * c4_2;
        const struct sinew_sines sines17 = sinew_one_sincos(q[5 + 4 * i12]);
        const double s2_2 = sines17.s[0];
        const double c2_2 = sines17.c[0];
        const struct sinew_sines sines18 = sinew_one_sincos(phi3_2);
        const double s3_2 = sines18.s[0];
        const double c3_2 = sines18.c[0];
        const double o4x_2 = table13[i12][2] * c2_2 + table13[i12][3] * c3_2;
        const double t19 = table13[i12][1] + o4x_2;
        const double placed_3 = c1_2 * t19 + table13[i12][4] - table13[i12][5] * s1_2
            + table13[i12][6] * R41x_2;
        const double t20 = table13[i12][7] * (s1_2 * t19) + table13[i12][8] + table13[i12][9]
            * c1_2;
        const double placed_5 = t20 + table13[i12][10] * R42x_2;
        const double t21 = origin_x + part_1[3] * placed_3 + table13[i12][7] * (part_1[4]
            * placed_5);
        const double o4y = table13[i12][2] * s2_2 + table13[i12][3] * s3_2;
        const double ptipz_2 = o4y + table13[i12][6] * s4_2;
        const double seen_7 = u_y * R42x_2 - part_1[12] * R41x_2 - part_1[10] * s4_2;
        const double seen_9 = u_y * R42y_2 - part_1[12] * R41y_2 + part_1[10] * c4_2;
        const double t22 = part_1[11] + table13[i12][11] * part_1[0] * placed_5 - part_1[12]
            * placed_3;
        const double seen_11 = part_1[7] * R41x_2 - part_1[8] * R42x_2 - part_1[5] * s4_2;
        const double seen_13 = part_1[7] * R41y_2 - part_1[8] * R42y_2 + part_1[5] * c4_2;
        const double t23 = part_1[6] - part_1[7] * placed_3 + table13[i12][7] * (part_1[8]
            * placed_5);
        in_forearm[12 + 16 * i12] = 0.0;
        in_forearm[13 + 16 * i12] = 0.0;
        in_forearm[14 + 16 * i12] = 0.0;
        in_forearm[15 + 16 * i12] = 1.0;
        in_forearm[16 + 16 * i12] = seen_3;
        in_forearm[17 + 16 * i12] = -seen_5;
        in_forearm[18 + 16 * i12] = part_1[3] * s1_2 - part_1[4] * c1_2;
        in_forearm[19 + 16 * i12] = t21 + part_1[1] * ptipz_2;
        in_forearm[20 + 16 * i12] = seen_7;
        in_forearm[21 + 16 * i12] = -seen_9;
        in_forearm[22 + 16 * i12] = -(u_y * c1_2 + part_1[12] * s1_2);
        in_forearm[23 + 16 * i12] = t22 - part_1[10] * ptipz_2;
        in_forearm[24 + 16 * i12] = -seen_11;
        in_forearm[25 + 16 * i12] = seen_13;
        in_forearm[26 + 16 * i12] = -(part_1[7] * s1_2 + part_1[8] * c1_2);
        in_forearm[27 + 16 * i12] = t23 + part_1[5] * ptipz_2;
        in_palm[12 + 16 * i12] = 0.0;
        in_palm[13 + 16 * i12] = 0.0;
        in_palm[14 + 16 * i12] = 0.0;
        in_palm[15 + 16 * i12] = 1.0;
        in_palm[16 + 16 * i12] = R41x_2;
        in_palm[17 + 16 * i12] = -R41y_2;
        in_palm[18 + 16 * i12] = s1_2;
        in_palm[19 + 16 * i12] = placed_3;
        in_palm[20 + 16 * i12] = R42x_2;
        in_palm[21 + 16 * i12] = -R42y_2;
        in_palm[22 + 16 * i12] = -c1_2;
        in_palm[23 + 16 * i12] = table13[i12][7] * placed_5;
        in_palm[24 + 16 * i12] = s4_2;
        in_palm[25 + 16 * i12] = c4_2;
        in_palm[26 + 16 * i12] = 0.0;
        in_palm[27 + 16 * i12] = ptipz_2;
    }
}

void hand_finger_gravity(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], const double gravity[SINEW_AT_LEAST(3)],
    double g[SINEW_AT_LEAST(15)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(q[18]);
    const double sin2 = sines2.s[0];
    const double cos2 = sines2.c[0];
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
    const double t3 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t3;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t3;
    const double t4 = gravity[1] * u_e;
    const double turned = gravity[0] * (cos_q71 * x_plane_x + sin_q71 * cos_A) - t4 * sin_A
        - gravity[2] * (cos_q71 * cos_A - sin_q71 * x_plane_x);
    const double turned_2 = u_e * (gravity[0] * cos_q71 + gravity[2] * sin_q71) + gravity[1] * u_y;
    const double turned_6 = 0.6427876096865393 * turned_2 + 0.766044443118978 * turned;
    const double z_plane_x = u_y * cos_A;
    const double turned_4 = gravity[0] * (cos_q71 * z_plane_x - sin_q71 * sin_A) - t4 * cos_A
        + gravity[2] * (cos_q71 * sin_A + sin_q71 * z_plane_x);
    const double turned_8 = 0.32139380484326974 * turned - 0.3830222215594891 * turned_2
        + 0.8660254037844386 * turned_4;
    const double turned_10 = 0.5000000000000001 * turned_4 - 0.5566703992264193 * turned
        + 0.6634139481689384 * turned_2;
    const double A = 1.2 - cos2;
    const double reach_squared_2 = sinew_max(sin2 * sin2 + A * A, 1e-12);
    const double reach_2 = sinew_sqrt(reach_squared_2);
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double slack = 0.6944444444444444 * (C + reach_2) * (C - reach_2);
    const double side = 1.2 * sinew_sqrt(sinew_max(-slack, 1e-12));
    const double limited_2 = sinew_min(sinew_max(C, -reach_2), reach_2);
    const double t5 = 1.0 / reach_squared_2;
    const double along = 0.012 - 0.01 * cos2 + 0.011 * ((sin2 * side - A * limited_2) * t5);
    const double across = 0.01 * sin2 - 0.011 * ((sin2 * limited_2 + A * side) * t5);
    const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
    const double t6 = 1.0 / length;
    const double sin3 = across * t6;
    const double cos3 = along * t6;
    g[0] = turned_6;
    g[1] = -turned_8;
    g[2] = turned_10;
    g[3] = turned;
    g[4] = turned_2;
    g[5] = turned_4;
    g[6] = turned;
    g[7] = turned_2;
    g[8] = turned_4;
    g[9] = turned;
    g[10] = turned_2;
    g[11] = turned_4;
    g[12] = turned;
    g[13] = cos3 * turned_2 - sin3 * turned_4;
    g[14] = cos3 * turned_4 + sin3 * turned_2;
}

void hand_tendon_lengths(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], double h[SINEW_AT_LEAST(38)])
{
    double part_1[16];
    hand_part_1(q_wrist, part_1);
    const double u_y = 23.80952380952381 * part_1[0];
    const double t1 = 0.004 * part_1[12];
    const double t2 = 0.01 * part_1[10];
    const double layer_0_y = 0.007 - part_1[11] - t1 + t2 + 0.011 * u_y;
    const double across_by_y_squared = 0.5 * (part_1[4] * part_1[4] + part_1[8] * part_1[8]);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double layer_1_y = 0.006 - part_1[11] - t1 - t2 + 0.013 * u_y;
    static const double table6[18][3] = {{0.002, 0.001, 0.001}, {0.003, 0.003, 0.003},
        {0.005, 0.005, 0.004}, {0.007, 0.006, 0.006}, {0.008, 0.008, 0.008},
        {0.01, 0.009, 0.009}, {0.011, 0.011, 0.011}, {0.013, 0.013, 0.012},
        {0.015, 0.014, 0.014}, {0.016, 0.016, 0.016}, {0.018, 0.017, 0.017},
        {0.019, 0.019, 0.019}, {0.021, 0.021, 0.02}, {0.023, 0.022, 0.022},
        {0.024, 0.024, 0.024}, {0.026, 0.025, 0.025}, {0.027, 0.027, 0.027},
        {0.029, 0.029, 0.028}};
    double kept4[18];
    double kept5[18];
    for (int i3 = 0; i3 < 18; ++i3) {
        const double across_slope = part_1[15] - table6[i3][0] * twice_across_4;
        const double across = part_1[14] - table6[i3][0] * across_slope;
        const double strand_y = table6[i3][1] + layer_1_y - table6[i3][0] * u_y;
        const double across_2 = part_1[9] - table6[i3][1] * (part_1[13] - table6[i3][1]
            * twice_across_4);
        const double strand_y_2 = table6[i3][2] + layer_0_y - table6[i3][1] * u_y;
        const double length = sinew_sqrt(across_2 + strand_y_2 * strand_y_2);
        kept4[i3] = length;
        kept5[i3] = sinew_sqrt(across + strand_y * strand_y);
    }
    const struct sinew_sines2 sines7 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines7.s[0];
    const double c1 = sines7.c[0];
    const double s2 = sines7.s[1];
    const double c2 = sines7.c[1];
    const double length_0 = sinew_sqrt(part_1[9] + layer_0_y * layer_0_y);
    const double t8 = 0.005 * (c1 * s2);
    const double t9 = 0.006 * s1;
    const double t10 = t8 - t9;
    const double t11 = 0.047 * (c1 * c2);
    const double A_lengthdx = 0.002 - t10 - t11;
    const double t12 = 0.005 * (s1 * s2);
    const double t13 = 0.006 * c1;
    const double t14 = 0.03 - (t12 + t13);
    const double t15 = 0.047 * (s1 * c2);
    const double A_lengthdy = t14 - t15;
    const double t16 = 0.025 - 0.005 * c2;
    const double t17 = 0.047 * s2;
    const double A_lengthdz = t16 + t17;
    const double t18 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t18);
    h[0] = A_length + length_0;
    const double t19 = t8 + t9;
    const double B_lengthdx = 0.002 + t19 - t11;
    const double t20 = 0.03 + (t12 - t13);
    const double B_lengthdy = t20 - t15;
    const double B_lengthdz = t16 - t17;
    const double t21 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t21);
    h[1] = B_length + kept4[0];
    const double C_lengthdx = 0.002 - t19 - t11;
    const double C_lengthdy = t20 + t15;
    const double C_length = sinew_sqrt(t18 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    h[2] = C_length + kept4[1];
    const double D_lengthdx = 0.002 + t10 - t11;
    const double D_lengthdy = t14 + t15;
    const double D_length = sinew_sqrt(t21 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    h[3] = D_length + kept4[2];
    const double t22 = 0.0065 * q[2];
    h[4] = kept4[3] + t22;
    h[5] = kept4[4] - t22;
    const double t23 = 0.0055 * q[3];
    h[6] = kept4[5] + t23 - t22;
    h[7] = kept4[6] - t23 + t22;
    const double t24 = 0.0065 * q[4];
    const double t25 = 0.0065 * q[5];
    h[8] = kept4[7] + t24 + t25;
    h[9] = kept4[8] + t24 - t25;
    h[10] = kept4[9] - t24 + t25;
    h[11] = kept4[10] - t24 - t25;
    const double t26 = 0.0055 * q[6];
    h[12] = kept4[11] + t26;
    h[13] = kept4[12] - t26;
    const double t27 = 0.0045 * q[7];
    h[14] = kept4[13] - t27 + t26;
    h[15] = kept4[14] + t27 - t26;
    const double t28 = 0.0065 * q[8];
    const double t29 = 0.0065 * q[9];
    h[16] = kept4[15] + t28 + t29;
    h[17] = kept4[16] + t28 - t29;
    h[18] = kept4[17] - t28 + t29;
    const double length_19 = sinew_sqrt(part_1[14] + layer_1_y * layer_1_y);
    h[19] = length_19 - t28 - t29;
    const double t30 = 0.0055 * q[10];
    h[20] = kept5[0] + t30;
    h[21] = kept5[1] - t30;
    const double t31 = 0.0045 * q[11];
    h[22] = kept5[2] - t31 + t30;
    h[23] = kept5[3] + t31 - t30;
    const double t32 = 0.0065 * q[12];
    const double t33 = 0.0065 * q[13];
    h[24] = kept5[4] + t32 + t33;
    h[25] = kept5[5] + t32 - t33;
    h[26] = kept5[6] - t32 + t33;
    h[27] = kept5[7] - t32 - t33;
    const double t34 = 0.011000000000000001 * q[14];
    h[28] = kept5[8] + t34;
    h[29] = kept5[9] - t34;
    const double t35 = 0.0052 * q[15];
    const double t36 = 0.0052 * q[16];
    h[30] = kept5[10] + t35 + t36;
    h[31] = kept5[11] + t35 - t36;
    h[32] = kept5[12] - t35 + t36;
    h[33] = kept5[13] - t35 - t36;
    const double t37 = 0.0088 * q[17];
    h[34] = kept5[14] + t37;
    h[35] = kept5[15] - t37;
    const double length_2 = 0.007853981633974483 - 0.005 * q[18];
    h[36] = -(length_2 - kept5[16]);
    h[37] = length_2 + kept5[17];
}

void hand_coupling_matrix(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], double P[SINEW_AT_LEAST(798)])
{
    double wrist_passage_h[38];
    double wrist_passage_P[76];
    hand_wrist_passage(q_wrist, wrist_passage_h, wrist_passage_P);
    for (int i1 = 0; i1 < 20; ++i1) {
        P[10 + 21 * i1] = 0.0;
        P[11 + 21 * i1] = 0.0;
        P[12 + 21 * i1] = 0.0;
        P[13 + 21 * i1] = 0.0;
        P[14 + 21 * i1] = 0.0;
        P[15 + 21 * i1] = 0.0;
        P[16 + 21 * i1] = 0.0;
        P[17 + 21 * i1] = 0.0;
        P[18 + 21 * i1] = 0.0;
    }
    for (int i2 = 0; i2 < 18; ++i2) {
        P[420 + 21 * i2] = 0.0;
        P[421 + 21 * i2] = 0.0;
        P[422 + 21 * i2] = 0.0;
        P[423 + 21 * i2] = 0.0;
        P[424 + 21 * i2] = 0.0;
        P[425 + 21 * i2] = 0.0;
        P[426 + 21 * i2] = 0.0;
        P[427 + 21 * i2] = 0.0;
        P[428 + 21 * i2] = 0.0;
        P[429 + 21 * i2] = 0.0;
    }
    for (int i3 = 0; i3 < 10; ++i3) {
        P[84 + 21 * i3] = 0.0;
        P[85 + 21 * i3] = 0.0;
        P[91 + 21 * i3] = 0.0;
        P[92 + 21 * i3] = 0.0;
        P[93 + 21 * i3] = 0.0;
    }
    for (int i4 = 0; i4 < 10; ++i4) {
        P[435 + 21 * i4] = 0.0;
        P[436 + 21 * i4] = 0.0;
        P[437 + 21 * i4] = 0.0;
        P[438 + 21 * i4] = 0.0;
    }
    for (int i5 = 0; i5 < 10; ++i5) {
        P[598 + 21 * i5] = 0.0;
        P[599 + 21 * i5] = 0.0;
        P[600 + 21 * i5] = 0.0;
        P[601 + 21 * i5] = 0.0;
    }
    for (int i6 = 0; i6 < 6; ++i6) {
        P[294 + 21 * i6] = 0.0;
        P[295 + 21 * i6] = 0.0;
        P[296 + 21 * i6] = 0.0;
        P[297 + 21 * i6] = 0.0;
        P[298 + 21 * i6] = 0.0;
        P[299 + 21 * i6] = 0.0;
    }
    for (int i7 = 0; i7 < 4; ++i7) {
        P[2 + 21 * i7] = 0.0;
        P[3 + 21 * i7] = 0.0;
        P[4 + 21 * i7] = 0.0;
        P[5 + 21 * i7] = 0.0;
        P[6 + 21 * i7] = 0.0;
        P[7 + 21 * i7] = 0.0;
        P[8 + 21 * i7] = 0.0;
        P[9 + 21 * i7] = 0.0;
    }
    for (int i8 = 0; i8 < 6; ++i8) {
        P[170 + 21 * i8] = 0.0;
        P[171 + 21 * i8] = 0.0;
    }
    for (int i9 = 0; i9 < 6; ++i9) {
        P[644 + 21 * i9] = 0.0;
        P[648 + 21 * i9] = 0.0;
    }
    const struct sinew_sines2 sines10 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines10.s[0];
    const double c1 = sines10.c[0];
    const double s2 = sines10.s[1];
    const double c2 = sines10.c[1];
    const double R21y = c1 * s2;
    const double t11 = 0.005 * R21y;
    const double t12 = 0.006 * s1;
    const double t13 = t11 - t12;
    const double R21x = c1 * c2;
    const double t14 = 0.047 * R21x;
    const double pD_length_tox = t13 - t14;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double t15 = 0.025 - 0.005 * c2;
    const double t16 = 0.047 * s2;
    const double B_lengthdz = t15 - t16;
    const double t17 = B_lengthdz * B_lengthdz;
    const double R22y = s1 * s2;
    const double t18 = 0.005 * R22y;
    const double t19 = 0.006 * c1;
    const double t20 = t18 + t19;
    const double R22x = s1 * c2;
    const double t21 = 0.047 * R22x;
    const double pD_length_toy = t20 - t21;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_length = sinew_sqrt(t17 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t22 = 1.0 / D_length;
    const double t23 = 0.005 * R21x;
    const double t24 = 0.047 * R21y;
    const double pB_length_tox_by_q_1 = t23 + t24;
    const double t25 = 0.005 * s2;
    const double t26 = 0.047 * c2;
    const double t27 = B_lengthdz * (t25 - t26);
    const double t28 = 0.005 * R22x;
    const double t29 = 0.047 * R22y;
    const double pB_length_toy_by_q_1 = t28 + t29;
    const double t30 = t27 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy * pB_length_toy_by_q_1;
    P[64] = t30 * t22;
    P[82] = wrist_passage_P[6];
    P[83] = wrist_passage_P[7];
    P[86] = 0.0065;
    P[87] = 0.0;
    P[88] = 0.0;
    P[89] = 0.0;
    P[90] = 0.0;
    P[103] = wrist_passage_P[8];
    P[104] = wrist_passage_P[9];
    P[107] = -0.0065;
    P[108] = 0.0;
    P[109] = 0.0;
    P[110] = 0.0;
    P[111] = 0.0;
    P[124] = wrist_passage_P[10];
    P[125] = wrist_passage_P[11];
    P[128] = -0.0065;
    P[129] = 0.0055;
    P[130] = 0.0;
    P[131] = 0.0;
    P[132] = 0.0;
    P[145] = wrist_passage_P[12];
    P[146] = wrist_passage_P[13];
    P[149] = 0.0065;
    P[150] = -0.0055;
    P[151] = 0.0;
    P[152] = 0.0;
    P[153] = 0.0;
    P[166] = wrist_passage_P[14];
    P[167] = wrist_passage_P[15];
    P[172] = 0.0065;
    P[173] = 0.0065;
    P[174] = 0.0;
    P[187] = wrist_passage_P[16];
    P[188] = wrist_passage_P[17];
    P[193] = 0.0065;
    P[194] = -0.0065;
    P[195] = 0.0;
    P[208] = wrist_passage_P[18];
    P[209] = wrist_passage_P[19];
    P[214] = -0.0065;
    P[215] = 0.0065;
    P[216] = 0.0;
    P[229] = wrist_passage_P[20];
    P[230] = wrist_passage_P[21];
    P[235] = -0.0065;
    P[236] = -0.0065;
    P[237] = 0.0;
    P[250] = wrist_passage_P[22];
    P[251] = wrist_passage_P[23];
    P[256] = 0.0;
    P[257] = 0.0;
    P[258] = 0.0055;
    P[271] = wrist_passage_P[24];
    P[272] = wrist_passage_P[25];
    P[277] = 0.0;
    P[278] = 0.0;
    P[279] = -0.0055;
    P[292] = wrist_passage_P[26];
    P[293] = wrist_passage_P[27];
    P[300] = 0.0055;
    P[301] = -0.0045;
    P[302] = 0.0;
    P[303] = 0.0;
    P[313] = wrist_passage_P[28];
    P[314] = wrist_passage_P[29];
    P[321] = -0.0055;
    P[322] = 0.0045;
    P[323] = 0.0;
    P[324] = 0.0;
    P[334] = wrist_passage_P[30];
    P[335] = wrist_passage_P[31];
    P[342] = 0.0;
    P[343] = 0.0;
    P[344] = 0.0065;
    P[345] = 0.0065;
    P[355] = wrist_passage_P[32];
    P[356] = wrist_passage_P[33];
    P[363] = 0.0;
    P[364] = 0.0;
    P[365] = 0.0065;
    P[366] = -0.0065;
    P[376] = wrist_passage_P[34];
    P[377] = wrist_passage_P[35];
    P[384] = 0.0;
    P[385] = 0.0;
    P[386] = -0.0065;
    P[387] = 0.0065;
    P[397] = wrist_passage_P[36];
    P[398] = wrist_passage_P[37];
    P[405] = 0.0;
    P[406] = 0.0;
    P[407] = -0.0065;
    P[408] = -0.0065;
    P[418] = wrist_passage_P[38];
    P[419] = wrist_passage_P[39];
    P[430] = 0.0055;
    P[431] = 0.0;
    P[432] = 0.0;
    P[433] = 0.0;
    P[434] = 0.0;
    P[439] = wrist_passage_P[40];
    P[440] = wrist_passage_P[41];
    P[451] = -0.0055;
    P[452] = 0.0;
    P[453] = 0.0;
    P[454] = 0.0;
    P[455] = 0.0;
    P[460] = wrist_passage_P[42];
    P[461] = wrist_passage_P[43];
    P[472] = 0.0055;
    P[473] = -0.0045;
    P[474] = 0.0;
    P[475] = 0.0;
    P[476] = 0.0;
    P[481] = wrist_passage_P[44];
    P[482] = wrist_passage_P[45];
    P[493] = -0.0055;
    P[494] = 0.0045;
    P[495] = 0.0;
    P[496] = 0.0;
    P[497] = 0.0;
    P[502] = wrist_passage_P[46];
    P[503] = wrist_passage_P[47];
    P[514] = 0.0;
    P[515] = 0.0;
    P[516] = 0.0065;
    P[517] = 0.0065;
    P[518] = 0.0;
    P[523] = wrist_passage_P[48];
    P[524] = wrist_passage_P[49];
    P[535] = 0.0;
    P[536] = 0.0;
    P[537] = 0.0065;
    P[538] = -0.0065;
    P[539] = 0.0;
    P[544] = wrist_passage_P[50];
    P[545] = wrist_passage_P[51];
    P[556] = 0.0;
    P[557] = 0.0;
    P[558] = -0.0065;
    P[559] = 0.0065;
    P[560] = 0.0;
    P[565] = wrist_passage_P[52];
    P[566] = wrist_passage_P[53];
    P[577] = 0.0;
    P[578] = 0.0;
    P[579] = -0.0065;
    P[580] = -0.0065;
    P[581] = 0.0;
    P[586] = wrist_passage_P[54];
    P[587] = wrist_passage_P[55];
    P[602] = 0.011000000000000001;
    P[607] = wrist_passage_P[56];
    P[608] = wrist_passage_P[57];
    P[623] = -0.011000000000000001;
    P[628] = wrist_passage_P[58];
    P[629] = wrist_passage_P[59];
    P[645] = 0.0052;
    P[646] = 0.0052;
    P[647] = 0.0;
    P[649] = wrist_passage_P[60];
    P[650] = wrist_passage_P[61];
    P[666] = 0.0052;
    P[667] = -0.0052;
    P[668] = 0.0;
    P[670] = wrist_passage_P[62];
    P[671] = wrist_passage_P[63];
    P[687] = -0.0052;
    P[688] = 0.0052;
    P[689] = 0.0;
    P[691] = wrist_passage_P[64];
    P[692] = wrist_passage_P[65];
    P[708] = -0.0052;
    P[709] = -0.0052;
    P[710] = 0.0;
    P[712] = wrist_passage_P[66];
    P[713] = wrist_passage_P[67];
    P[729] = 0.0;
    P[730] = 0.0;
    P[731] = 0.0088;
    P[733] = wrist_passage_P[68];
    P[734] = wrist_passage_P[69];
    P[750] = 0.0;
    P[751] = 0.0;
    P[752] = -0.0088;
    P[754] = wrist_passage_P[70];
    P[755] = wrist_passage_P[71];
    P[770] = 0.0;
    P[771] = 0.0;
    P[772] = 0.0;
    P[773] = 0.0;
    P[774] = 0.005;
    P[775] = wrist_passage_P[72];
    P[776] = wrist_passage_P[73];
    P[791] = 0.0;
    P[792] = 0.0;
    P[793] = 0.0;
    P[794] = 0.0;
    P[795] = -0.005;
    P[796] = wrist_passage_P[74];
    P[797] = wrist_passage_P[75];
    const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t22;
    P[63] = -D_length_by_q_0;
    const double t31 = t11 + t12;
    const double pC_length_tox = t31 + t14;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double A_lengthdz = t15 + t16;
    const double t32 = A_lengthdz * A_lengthdz;
    const double t33 = t18 - t19;
    const double pC_length_toy = t33 + t21;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_length = sinew_sqrt(t32 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t34 = 1.0 / C_length;
    const double pA_length_tox_by_q_1 = t23 - t24;
    const double t35 = A_lengthdz * (t25 + t26);
    const double pA_length_toy_by_q_1 = t28 - t29;
    const double t36 = t35 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy * pA_length_toy_by_q_1;
    P[43] = t36 * t34;
    P[61] = wrist_passage_P[4];
    P[62] = wrist_passage_P[5];
    const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t34;
    P[42] = C_length_by_q_0;
    const double pB_length_tox = t31 - t14;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double pB_length_toy = t33 - t21;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t17);
    const double t37 = 1.0 / B_length;
    const double t38 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1 + t27;
    P[22] = t38 * t37;
    P[40] = wrist_passage_P[2];
    P[41] = wrist_passage_P[3];
    const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t37;
    P[21] = B_length_by_q_0;
    const double pA_length_tox = t13 + t14;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double pA_length_toy = t20 + t21;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t32);
    const double t39 = 1.0 / A_length;
    const double t40 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1 - t35;
    P[1] = -(t40 * t39);
    P[19] = wrist_passage_P[0];
    P[20] = wrist_passage_P[1];
    const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t39;
    P[0] = -A_length_by_q_0;
}

void hand_joint_torque(const double q[SINEW_AT_LEAST(19)], const double q_wrist[SINEW_AT_LEAST(2)],
    const double f[SINEW_AT_LEAST(38)], double tau[SINEW_AT_LEAST(21)])
{
    double wrist_passage_h[38];
    double wrist_passage_P[76];
    hand_wrist_passage(q_wrist, wrist_passage_h, wrist_passage_P);
    static const double table2[3][3] = {{1.0, -0.0065, -0.0055}, {-1.0, -0.0055, 0.0045},
        {-1.0, -0.0055, 0.0045}};
    for (int i1 = 0; i1 < 3; ++i1) {
        const double t3 = f[4 + 8 * i1] - f[5 + 8 * i1] - table2[i1][0] * f[6 + 8 * i1]
            + table2[i1][0] * f[7 + 8 * i1];
        const double t4 = 0.0065 * f[8 + 8 * i1];
        const double t5 = 0.0065 * f[9 + 8 * i1];
        const double t6 = 0.0065 * f[10 + 8 * i1];
        const double t7 = 0.0065 * f[11 + 8 * i1];
        tau[2 + 4 * i1] = table2[i1][1] * t3;
        tau[3 + 4 * i1] = table2[i1][2] * (f[6 + 8 * i1] - f[7 + 8 * i1]);
        tau[4 + 4 * i1] = -(t4 + t5 - t6 - t7);
        tau[5 + 4 * i1] = -(t4 - t5 + t6 - t7);
    }
    const struct sinew_sines2 sines8 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines8.s[0];
    const double c1 = sines8.c[0];
    const double s2 = sines8.s[1];
    const double c2 = sines8.c[1];
    const double t9 = f[0] * wrist_passage_P[0] + f[1] * wrist_passage_P[2] + f[2]
        * wrist_passage_P[4];
    const double t10 = f[0] * -wrist_passage_P[1] + f[1] * -wrist_passage_P[3] + f[2]
        * -wrist_passage_P[5];
    const double t11 = t9 + f[3] * wrist_passage_P[6] + f[4] * wrist_passage_P[8] + f[5]
        * wrist_passage_P[10];
    const double t12 = t10 + f[3] * -wrist_passage_P[7] + f[4] * -wrist_passage_P[9] + f[5]
        * -wrist_passage_P[11];
    const double t13 = t11 + f[6] * wrist_passage_P[12] + f[7] * wrist_passage_P[14] + f[8]
        * wrist_passage_P[16];
    const double t14 = t12 + f[6] * -wrist_passage_P[13] + f[7] * -wrist_passage_P[15] + f[8]
        * -wrist_passage_P[17];
    const double t15 = t13 + f[9] * wrist_passage_P[18] + f[10] * wrist_passage_P[20] + f[11]
        * wrist_passage_P[22];
    const double t16 = t14 + f[9] * -wrist_passage_P[19] + f[10] * -wrist_passage_P[21] + f[11]
        * -wrist_passage_P[23];
    const double t17 = t15 + f[12] * wrist_passage_P[24] + f[13] * wrist_passage_P[26] + f[14]
        * wrist_passage_P[28];
    const double t18 = t16 + f[12] * -wrist_passage_P[25] + f[13] * -wrist_passage_P[27] + f[14]
        * -wrist_passage_P[29];
    const double R21y = c1 * s2;
    const double t19 = 0.005 * R21y;
    const double t20 = 0.006 * s1;
    const double t21 = t19 - t20;
    const double R21x = c1 * c2;
    const double t22 = 0.047 * R21x;
    const double pA_length_tox = t21 + t22;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double R22y = s1 * s2;
    const double t23 = 0.005 * R22y;
    const double t24 = 0.006 * c1;
    const double t25 = t23 + t24;
    const double R22x = s1 * c2;
    const double t26 = 0.047 * R22x;
    const double pA_length_toy = t25 + t26;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double t27 = 0.025 - 0.005 * c2;
    const double t28 = 0.047 * s2;
    const double A_lengthdz = t27 + t28;
    const double t29 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t29);
    const double t30 = 1.0 / A_length;
    const double t31 = 0.005 * R21x;
    const double t32 = 0.047 * R21y;
    const double pA_length_tox_by_q_1 = t31 - t32;
    const double t33 = 0.005 * R22x;
    const double t34 = 0.047 * R22y;
    const double pA_length_toy_by_q_1 = t33 - t34;
    const double t35 = 0.005 * s2;
    const double t36 = 0.047 * c2;
    const double t37 = A_lengthdz * (t35 + t36);
    const double t38 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1 - t37;
    const double t39 = t19 + t20;
    const double pB_length_tox = t39 - t22;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double t40 = t23 - t24;
    const double pB_length_toy = t40 - t26;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_lengthdz = t27 - t28;
    const double t41 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t41);
    const double t42 = 1.0 / B_length;
    const double pB_length_tox_by_q_1 = t31 + t32;
    const double pB_length_toy_by_q_1 = t33 + t34;
    const double t43 = B_lengthdz * (t35 - t36);
    const double t44 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1 + t43;
    const double pC_length_tox = t39 + t22;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double pC_length_toy = t40 + t26;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_length = sinew_sqrt(t29 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t45 = 1.0 / C_length;
    const double t46 = t37 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy * pA_length_toy_by_q_1;
    const double pD_length_tox = t21 - t22;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double pD_length_toy = t25 - t26;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_length = sinew_sqrt(t41 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t47 = 1.0 / D_length;
    const double t48 = t43 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy * pB_length_toy_by_q_1;
    const double t49 = f[0] * (t38 * t30) - f[1] * (t44 * t42) - f[2] * (t46 * t45) - f[3] * (t48
        * t47);
    tau[1] = t49;
    const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t30;
    const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t42;
    const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t45;
    const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t47;
    const double t50 = f[0] * A_length_by_q_0 - f[1] * B_length_by_q_0 - f[2] * C_length_by_q_0
        + f[3] * D_length_by_q_0;
    tau[0] = t50;
    const double t51 = t17 + f[15] * wrist_passage_P[30] + f[16] * wrist_passage_P[32] + f[17]
        * wrist_passage_P[34];
    const double t52 = t18 + f[15] * -wrist_passage_P[31] + f[16] * -wrist_passage_P[33] + f[17]
        * -wrist_passage_P[35];
    const double t53 = t51 + f[18] * wrist_passage_P[36] + f[19] * wrist_passage_P[38] + f[20]
        * wrist_passage_P[40];
    const double t54 = t52 + f[18] * -wrist_passage_P[37] + f[19] * -wrist_passage_P[39] + f[20]
        * -wrist_passage_P[41];
    const double t55 = t53 + f[21] * wrist_passage_P[42] + f[22] * wrist_passage_P[44] + f[23]
        * wrist_passage_P[46];
    const double t56 = t54 + f[21] * -wrist_passage_P[43] + f[22] * -wrist_passage_P[45] + f[23]
        * -wrist_passage_P[47];
    const double t57 = t55 + f[24] * wrist_passage_P[48] + f[25] * wrist_passage_P[50] + f[26]
        * wrist_passage_P[52];
    const double t58 = t56 + f[24] * -wrist_passage_P[49] + f[25] * -wrist_passage_P[51] + f[26]
        * -wrist_passage_P[53];
    const double t59 = t57 + f[27] * wrist_passage_P[54] + f[28] * wrist_passage_P[56] + f[29]
        * wrist_passage_P[58];
    const double t60 = t58 + f[27] * -wrist_passage_P[55] + f[28] * -wrist_passage_P[57] + f[29]
        * -wrist_passage_P[59];
    tau[14] = -(0.011000000000000001 * (f[28] - f[29]));
    const double t61 = 0.0052 * f[30];
    const double t62 = 0.0052 * f[31];
    const double t63 = t59 + f[30] * wrist_passage_P[60] + f[31] * wrist_passage_P[62] + f[32]
        * wrist_passage_P[64];
    const double t64 = t60 + f[30] * -wrist_passage_P[61] + f[31] * -wrist_passage_P[63] + f[32]
        * -wrist_passage_P[65];
    const double t65 = 0.0052 * f[32];
    const double t66 = 0.0052 * f[33];
    tau[16] = -(t61 - t62 + t65 - t66);
    tau[15] = -(t61 + t62 - t65 - t66);
    const double t67 = t63 + f[33] * wrist_passage_P[66] + f[34] * wrist_passage_P[68] + f[35]
        * wrist_passage_P[70];
    const double t68 = t64 + f[33] * -wrist_passage_P[67] + f[34] * -wrist_passage_P[69] + f[35]
        * -wrist_passage_P[71];
    tau[17] = -(0.0088 * (f[34] - f[35]));
    tau[20] = t68 + f[36] * -wrist_passage_P[73] + f[37] * -wrist_passage_P[75];
    tau[18] = -(0.005 * (f[36] - f[37]));
    tau[19] = -(t67 + f[36] * wrist_passage_P[72] + f[37] * wrist_passage_P[74]);
}

void hand_joint_stiffness(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], const double f[SINEW_AT_LEAST(38)],
    const double kt[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(441)])
{
    double h[38];
    double P[76];
    hand_wrist_passage(q_wrist, h, P);
    double K_wrist[4];
    hand_wrist_stiffness(q_wrist, h, P, f, kt, K_wrist);
    hand_whole_stiffness(q, P, f, kt, K_wrist, K);
}

void hand_feedforward(const double q_wrist[SINEW_AT_LEAST(2)],
    double delta_theta[SINEW_AT_LEAST(38)])
{
    double part_1[16];
    hand_part_1(q_wrist, part_1);
    const double u_y = 23.80952380952381 * part_1[0];
    const double t1 = 0.004 * part_1[12];
    const double t2 = 0.01 * part_1[10];
    const double layer_0_y = 0.007 - part_1[11] - t1 + t2 + 0.011 * u_y;
    const double length_0 = sinew_sqrt(part_1[9] + layer_0_y * layer_0_y);
    delta_theta[0] = 200.0 * (0.04661544808322666 - length_0);
    const double across_by_y_squared = 0.5 * (part_1[4] * part_1[4] + part_1[8] * part_1[8]);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
    const double layer_1_y = 0.006 - part_1[11] - t1 - t2 + 0.013 * u_y;
    const double length_19 = sinew_sqrt(part_1[14] + layer_1_y * layer_1_y);
    delta_theta[19] = 200.0 * (0.046561786907291264 - length_19);
    static const double table4[18][5] = {
        {0.04661544808322666, 0.001, 0.001, 0.04661544808322666, 0.002},
        {0.04661544808322666, 0.003, 0.003, 0.046561786907291264, 0.003},
        {0.04669047011971501, 0.005, 0.004, 0.046561786907291264, 0.005},
        {0.04661544808322666, 0.006, 0.006, 0.04661544808322666, 0.007},
        {0.04661544808322666, 0.008, 0.008, 0.046561786907291264, 0.008},
        {0.04661544808322666, 0.009, 0.009, 0.04661544808322666, 0.01},
        {0.04661544808322666, 0.011, 0.011, 0.046561786907291264, 0.011},
        {0.04669047011971501, 0.013, 0.012, 0.046561786907291264, 0.013},
        {0.04661544808322666, 0.014, 0.014, 0.04661544808322666, 0.015},
        {0.04661544808322666, 0.016, 0.016, 0.046561786907291264, 0.016},
        {0.04661544808322666, 0.017, 0.017, 0.04661544808322666, 0.018},
        {0.04661544808322666, 0.019, 0.019, 0.046561786907291264, 0.019},
        {0.04669047011971501, 0.021, 0.02, 0.046561786907291264, 0.021},
        {0.04661544808322666, 0.022, 0.022, 0.04661544808322666, 0.023},
        {0.04661544808322666, 0.024, 0.024, 0.046561786907291264, 0.024},
        {0.04661544808322666, 0.025, 0.025, 0.04661544808322666, 0.026},
        {0.04661544808322666, 0.027, 0.027, 0.046561786907291264, 0.027},
        {0.04669047011971501, 0.029, 0.028, 0.046561786907291264, 0.029}};
    for (int i3 = 0; i3 < 18; ++i3) {
        const double across = part_1[9] - table4[i3][1] * (part_1[13] - table4[i3][1]
            * twice_across_4);
        const double strand_y = table4[i3][2] + layer_0_y - table4[i3][1] * u_y;
        const double change = table4[i3][0] - sinew_sqrt(across + strand_y * strand_y);
        const double across_slope = part_1[15] - table4[i3][4] * twice_across_4;
        const double across_2 = part_1[14] - table4[i3][4] * across_slope;
        const double strand_y_2 = table4[i3][1] + layer_1_y - table4[i3][4] * u_y;
        const double length = sinew_sqrt(across_2 + strand_y_2 * strand_y_2);
        delta_theta[1 + i3] = 200.0 * change;
        delta_theta[20 + i3] = 200.0 * (table4[i3][3] - length);
    }
}

void hand_feedforward_rate(const double q_wrist[SINEW_AT_LEAST(2)],
    const double qd_wrist[SINEW_AT_LEAST(2)], double delta_theta_rate[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double t2 = 1.0 / (0.007324 - 0.084 * B_y);
    const double ratio = 0.003796 * t2;
    const double B_y_by_t = 0.074565407529229 * (qd_wrist[1] * sin_q73);
    const double ratio_by_t = ratio * (0.084 * B_y_by_t) * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_e_by_t = 0.074565407529229 * (qd_wrist[1] * cos_q73);
    const double C_e_by_t = B_e * ratio_by_t - ratio * B_e_by_t;
    const double M_e_by_t = 0.5 * (B_e_by_t - C_e_by_t);
    const double sin_q71_by_t = qd_wrist[0] * cos_q71;
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
    const double cos_q71_by_t = qd_wrist[0] * sin_q71;
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

void hand_wrist_passage(const double q_wrist[SINEW_AT_LEAST(2)], double h[SINEW_AT_LEAST(38)],
    double P[SINEW_AT_LEAST(76)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double t2 = 1.0 / (0.007324 - 0.084 * B_y);
    const double ratio = 0.003796 * t2;
    const double B_e = 0.074565407529229 * sin_q73;
    const double ratio_by_q73 = ratio * (0.084 * B_e) * t2;
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
    const double root = sinew_sqrt(sinew_max(t21, t22));
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
    const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t28 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t29 = 0.01 * z_x_by_q73;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double layer_1_x_by_q73 = t28 - t29 - 0.013 * y_x_by_q73;
    const double y_x = cos_q71 * u_e;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t30 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t31 = 0.01 * z_z_by_q73;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double layer_1_z_by_q73 = t30 - t31 - 0.013 * y_z_by_q73;
    const double y_z = sin_q71 * u_e;
    const double z_plane_x = u_y * cos_A;
    const double t32 = cos_q71 * z_plane_x;
    const double t33 = sin_q71 * sin_A;
    const double z_x = t32 - t33;
    const double M_x = cos_q71 * M_e;
    const double x_plane_x = u_y * sin_A;
    const double t34 = cos_q71 * x_plane_x;
    const double t35 = sin_q71 * cos_A;
    const double t36 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t34 + t35);
    const double t37 = 0.01 * z_x;
    const double t38 = 0.013 * y_x;
    const double layer_1_x = t36 + t37 + t38;
    const double t39 = sin_q71 * z_plane_x;
    const double t40 = cos_q71 * sin_A;
    const double z_z = t40 + t39;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t41 = sin_q71 * x_plane_x;
    const double t42 = cos_q71 * cos_A;
    const double t43 = 0.004 * (t42 - t41);
    const double t44 = 0.01 * z_z;
    const double t45 = 0.013 * y_z;
    const double layer_1_z = 0.028 - origin_z - t43 + t44 + t45;
    const double across_by_y_2_by_q73 = y_x * layer_1_x_by_q73 + y_z * layer_1_z_by_q73 - layer_1_x
        * y_x_by_q73 - layer_1_z * y_z_by_q73;
    const double across_by_y_squared_by_q73 = y_x * y_x_by_q73 + y_z * y_z_by_q73;
    const double across_38_by_q73 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double t46 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73 + sin_A
        * u_e_by_q73);
    const double t47 = 0.01 * z_plane_y_by_q73;
    const double layer_1_y_by_q73 = t46 - t47 - 0.013 * u_y_by_q73;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t48 = 0.004 * (u_e * sin_A);
    const double t49 = 0.01 * z_plane_y;
    const double layer_1_y = 0.006 - origin_y - t48 - t49 + 0.013 * u_y;
    const double across_38 = 0.5 * (layer_1_x * layer_1_x + layer_1_z * layer_1_z);
    const double twice_across_6 = across_38 + across_38;
    const double across_by_y_2 = y_x * layer_1_x + y_z * layer_1_z;
    const double twice_across_8 = across_by_y_2 + across_by_y_2;
    const double across_by_y_squared = 0.5 * (y_x * y_x + y_z * y_z);
    const double twice_across_4 = across_by_y_squared + across_by_y_squared;
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
    const double z_x_by_q71 = t40 - cos_q71 * z_plane_x_by_q71 + t39 + sin_q71 * sin_A_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t42 + cos_q71 * x_plane_x_by_q71 - t41 + sin_q71 * cos_A_by_q71;
    const double t52 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    const double t53 = 0.01 * z_x_by_q71;
    const double layer_1_x_by_q71 = t52 - t53 - t45;
    const double z_z_by_q71 = t32 + cos_q71 * sin_A_by_q71 - t33 + sin_q71 * z_plane_x_by_q71;
    const double x_z_by_q71 = t34 - cos_q71 * cos_A_by_q71 + t35 + sin_q71 * x_plane_x_by_q71;
    const double t54 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    const double t55 = 0.01 * z_z_by_q71;
    const double layer_1_z_by_q71 = t54 - t55 - t38;
    const double across_by_y_2_by_q71 = y_x * (layer_1_z + layer_1_x_by_q71) - y_z * (layer_1_x
        + layer_1_z_by_q71);
    const double across_38_by_q71 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double t56 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
    const double t57 = 0.01 * z_plane_y_by_q71;
    const double layer_1_y_by_q71 = t56 + t57;
    const double half_square_by_114 = across_38_by_q73 - layer_1_y * layer_1_y_by_q73;
    const double length_19 = sinew_sqrt(twice_across_6 + layer_1_y * layer_1_y);
    h[19] = length_19;
    const double t58 = 1.0 / length_19;
    P[39] = -(half_square_by_114 * t58);
    const double half_square_by_38 = across_38_by_q71 - layer_1_y * layer_1_y_by_q71;
    P[38] = half_square_by_38 * t58;
    const double layer_0_x_by_q73 = t28 + t29 - 0.011 * y_x_by_q73;
    const double layer_0_z_by_q73 = t30 + t31 - 0.011 * y_z_by_q73;
    const double t59 = 0.011 * y_x;
    const double layer_0_x = t36 - t37 + t59;
    const double t60 = 0.011 * y_z;
    const double layer_0_z = 0.008 - origin_z - t43 - t44 + t60;
    const double across_by_y_by_q73 = y_x * layer_0_x_by_q73 + y_z * layer_0_z_by_q73 - layer_0_x
        * y_x_by_q73 - layer_0_z * y_z_by_q73;
    const double across_by_q73 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73;
    const double layer_0_y_by_q73 = t46 + t47 - 0.011 * u_y_by_q73;
    const double layer_0_y = 0.007 - origin_y - t48 + t49 + 0.011 * u_y;
    const double across = 0.5 * (layer_0_x * layer_0_x + layer_0_z * layer_0_z);
    const double twice_across = across + across;
    const double across_by_y = y_x * layer_0_x + y_z * layer_0_z;
    const double twice_across_2 = across_by_y + across_by_y;
    const double layer_0_x_by_q71 = t52 + t53 - t60;
    const double layer_0_z_by_q71 = t54 + t55 - t59;
    const double across_by_y_by_q71 = y_x * (layer_0_z + layer_0_x_by_q71) - y_z * (layer_0_x
        + layer_0_z_by_q71);
    const double across_by_q71 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71;
    const double layer_0_y_by_q71 = t56 - t57;
    const double half_square_by_76 = across_by_q73 - layer_0_y * layer_0_y_by_q73;
    const double length_0 = sinew_sqrt(twice_across + layer_0_y * layer_0_y);
    h[0] = length_0;
    const double t61 = 1.0 / length_0;
    P[1] = -(half_square_by_76 * t61);
    const double half_square_by = across_by_q71 - layer_0_y * layer_0_y_by_q71;
    P[0] = half_square_by * t61;
    static const double table63[18][2] = {{0.001, 0.001}, {0.003, 0.003}, {0.005, 0.004},
        {0.006, 0.006}, {0.008, 0.008}, {0.009, 0.009}, {0.011, 0.011}, {0.013, 0.012},
        {0.014, 0.014}, {0.016, 0.016}, {0.017, 0.017}, {0.019, 0.019}, {0.021, 0.02},
        {0.022, 0.022}, {0.024, 0.024}, {0.025, 0.025}, {0.027, 0.027}, {0.029, 0.028}};
    for (int i62 = 0; i62 < 18; ++i62) {
        const double across_2 = across_by_q71 - table63[i62][0] * across_by_y_by_q71;
        const double strand_y = table63[i62][1] + layer_0_y - table63[i62][0] * u_y;
        const double across_3 = twice_across - table63[i62][0] * (twice_across_2 - table63[i62][0]
            * twice_across_4);
        const double length = sinew_sqrt(across_3 + strand_y * strand_y);
        const double t64 = 1.0 / length;
        const double length_by_q71 = (across_2 - strand_y * layer_0_y_by_q71) * t64;
        const double across_slope = across_by_y_by_q73 + table63[i62][0]
            * across_by_y_squared_by_q73;
        const double across_4 = across_by_q73 - table63[i62][0] * across_slope;
        const double half_square_by_2 = across_4 - strand_y * (layer_0_y_by_q73 + table63[i62][0]
            * u_y_by_q73);
        P[2 + 2 * i62] = length_by_q71;
        P[3 + 2 * i62] = -(half_square_by_2 * t64);
        h[1 + i62] = length;
    }
    static const double table66[18][2] = {{0.002, 0.001}, {0.003, 0.003}, {0.005, 0.005},
        {0.007, 0.006}, {0.008, 0.008}, {0.01, 0.009}, {0.011, 0.011}, {0.013, 0.013},
        {0.015, 0.014}, {0.016, 0.016}, {0.018, 0.017}, {0.019, 0.019}, {0.021, 0.021},
        {0.023, 0.022}, {0.024, 0.024}, {0.026, 0.025}, {0.027, 0.027}, {0.029, 0.029}};
    for (int i65 = 0; i65 < 18; ++i65) {
        const double across_5 = across_38_by_q71 - table66[i65][0] * across_by_y_2_by_q71;
        const double strand_y_2 = table66[i65][1] + layer_1_y - table66[i65][0] * u_y;
        const double across_slope_2 = twice_across_8 - table66[i65][0] * twice_across_4;
        const double across_6 = twice_across_6 - table66[i65][0] * across_slope_2;
        const double length_2 = sinew_sqrt(across_6 + strand_y_2 * strand_y_2);
        const double t67 = 1.0 / length_2;
        const double length_by_q71_2 = (across_5 - strand_y_2 * layer_1_y_by_q71) * t67;
        const double across_slope_3 = across_by_y_2_by_q73 + table66[i65][0]
            * across_by_y_squared_by_q73;
        const double across_7 = across_38_by_q73 - table66[i65][0] * across_slope_3;
        const double strand_y_by = layer_1_y_by_q73 + table66[i65][0] * u_y_by_q73;
        const double length_by_q73 = (across_7 - strand_y_2 * strand_y_by) * t67;
        P[40 + 2 * i65] = length_by_q71_2;
        P[41 + 2 * i65] = -length_by_q73;
        h[20 + i65] = length_2;
    }
}

void hand_wrist_stiffness(const double q_wrist[SINEW_AT_LEAST(2)],
    const double h[SINEW_AT_LEAST(38)], const double P[SINEW_AT_LEAST(76)],
    const double f[SINEW_AT_LEAST(38)], const double kt[SINEW_AT_LEAST(38)],
    double K_wrist[SINEW_AT_LEAST(4)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines1.s[0];
    const double cos_q71 = sines1.c[0];
    const double sin_q73 = sines1.s[1];
    const double cos_q73 = sines1.c[1];
    const double B_e = 0.074565407529229 * sin_q73;
    const double t2 = 23.80952380952381 * B_e;
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared_by_q73_by_q73 = 0.084 * B_y;
    const double t3 = 1.0 / (0.007324 - B_to_C0_squared_by_q73_by_q73);
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio = 0.003796 * t3;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t3;
    const double C_e = B_e * ratio;
    const double t4 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t4 * t3;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double u_e_by_q73_by_q73 = t2 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double u_e = t2 - 23.80952380952381 * C_e;
    const double p_z = 0.036 * cos_q71;
    const double t5 = p_z * p_z;
    const double t6 = 0.5 * B_y;
    const double t7 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t7;
    const double M_y = t6 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double t8 = 0.5 * B_e;
    const double M_e = t8 + 0.5 * C_e;
    const double s_e = M_e - p_z_by_q71;
    const double t9 = 23.80952380952381 * B_y;
    const double u_y = t9 + 23.80952380952381 * C_y;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t10 = p_y * p_y;
    const double reach_squared = sinew_max(t10 + t5, 1.296e-15);
    const double t11 = 1.0 / reach_squared;
    const double reach = sinew_sqrt(reach_squared);
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double t12 = sinew_max(-projection, -reach);
    const double limited = sinew_min(t12, reach);
    const double t13 = p_z * limited;
    const double t14 = 1e-12 * reach_squared;
    const double t15 = (reach + limited) * (reach - limited);
    const double root = sinew_sqrt(sinew_max(t15, t14));
    const double sin_A = (p_y * root - t13) * t11;
    const double t16 = p_z * root;
    const double cos_A = (p_y * limited + t16) * t11;
    const double t17 = B_y * ratio;
    const double C_y_by_q73_by_q73 = t17 - 0.002 * ratio_by_q73_by_q73 * t7 - (B_e + B_e)
        * ratio_by_q73;
    const double u_y_by_q73_by_q73 = t9 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double z_plane_y = u_e * cos_A;
    const double t18 = 0.01 * z_plane_y;
    const double t19 = 0.004 * (u_e * sin_A);
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double layer_0_y = 0.007 - origin_y - t19 + t18 + 0.011 * u_y;
    const double layer_1_y = 0.006 - origin_y - t19 - t18 + 0.013 * u_y;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t17;
    const double u_e_by_q73 = t9 + 23.80952380952381 * C_e_by_q73;
    const double t20 = u_e_by_q73 + u_e_by_q73;
    const double t21 = -(1.296e-15 - t10 - t5);
    const double t22 = p_y + p_y;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t7;
    const double u_y_by_q73 = t2 - 23.80952380952381 * C_y_by_q73;
    const double M_y_by_q73 = t8 + 0.5 * C_y_by_q73;
    const double M_e_by_q73 = t6 - 0.5 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double reach_squared_by_q73 = sinew_choose(t21, t22 * p_y_by_q73, 0.0);
    const double t23 = reach - t12;
    const double t24 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t24;
    const double t25 = reach - projection;
    const double t26 = sinew_choose(t25, 0.0, 1.0);
    const double t27 = sinew_choose(t25, 1.0, 0.0);
    const double t28 = 27.77777777777778 * p_x;
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t28 * p_x_by_q73;
    const double limited_by_q73 = sinew_choose(t23, -(reach_by_q73 * t26 - projection_by_q73 * t27),
        reach_by_q73);
    const double t29 = 1.0 / root;
    const double t30 = -(t14 - t15);
    const double t31 = reach + reach;
    const double t32 = limited + limited;
    const double clearance_by_q73 = sinew_choose(t30, t31 * reach_by_q73 - t32 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double root_by_q73 = 0.5 * clearance_by_q73 * t29;
    const double t33 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t33 * t11;
    const double t34 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t35 = p_y_by_q73 + p_y_by_q73;
    const double t36 = u_y_by_q73 + u_y_by_q73;
    const double M_y_by_q73_by_q73 = t6 + 0.5 * C_y_by_q73_by_q73;
    const double M_e_by_q73_by_q73 = t8 + 0.5 * C_e_by_q73_by_q73;
    const double t37 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double p_y_by_q73_by_q73 = t37 - s_y * u_e_by_q73_by_q73 + t20 * M_y_by_q73 - t36
        * M_e_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t21, t35 * p_y_by_q73 + t22
        * p_y_by_q73_by_q73, 0.0);
    const double t38 = reach_by_q73 * reach_by_q73;
    const double t39 = t38 + t38;
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t39) * t24;
    const double t40 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t40 - s_y * u_y_by_q73_by_q73 - t20 * M_e_by_q73 - t36
        * M_y_by_q73;
    const double t41 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t23, -(reach_by_q73_by_q73 * t26 - (t41 - t28
        * p_x_by_q73_by_q73) * t27), reach_by_q73_by_q73);
    const double t42 = t39 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t31
        * reach_by_q73_by_q73;
    const double clearance_by_q73_by_q73 = sinew_choose(t30, t42 - t32 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double t43 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t43 * t29;
    const double t44 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t45 = t44 - cos_A * reach_squared_by_q73_by_q73 + t35 * limited_by_q73 - t34
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t45 * t11;
    const double t46 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t46 * t11;
    const double t47 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t48 = t47 - sin_A * reach_squared_by_q73_by_q73 + t35 * root_by_q73 - t34
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t48 * t11;
    const double t49 = p_z + p_z;
    const double p_y_by_q71 = u_y * p_z;
    const double reach_squared_by_q71 = sinew_choose(t21, -(t22 * p_y_by_q71 + t49 * p_z_by_q71),
        0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t24;
    const double p_x_by_q71 = u_e * p_z;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t28 * p_x_by_q71;
    const double limited_by_q71 = sinew_choose(t23, -(reach_by_q71 * t26 - projection_by_q71 * t27),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t30, t31 * reach_by_q71 - t32 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t29;
    const double t50 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t50 - cos_A * reach_squared_by_q71) * t11;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double t51 = p_y_by_q71 + p_y_by_q71;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t21, t22 * p_y_by_q71_by_q73 - t51
        * p_y_by_q73, 0.0);
    const double t52 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t52) * t24;
    const double t53 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t28
        * p_z * u_e_by_q73 - t53 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t23, -(reach_by_q71_by_q73 * t26
        - projection_by_q71_by_q73 * t27), reach_by_q71_by_q73);
    const double t54 = limited_by_q71 + limited_by_q71;
    const double t55 = t31 * reach_by_q71_by_q73 - t32 * limited_by_q71_by_q73 + t52 - t54
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t30, t55, 1e-12
        * reach_squared_by_q71_by_q73);
    const double t56 = root_by_q71 + root_by_q71;
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t56 * root_by_q73) * t29;
    const double t57 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t58 = t57 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t59 = t58 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t59 * t11;
    const double t60 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t60 - sin_A * reach_squared_by_q71) * t11;
    const double t61 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t62 = t61 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t63 = t62 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t63 * t11;
    const double t64 = reach_squared_by_q71 + reach_squared_by_q71;
    const double t65 = p_z_by_q71 + p_z_by_q71;
    const double t66 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t21, t66 + t66 + t22 * p_y_by_q71_by_q71
        - t49 * p_z, 0.0);
    const double t67 = reach_by_q71 * reach_by_q71;
    const double t68 = t67 + t67;
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t68) * t24;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t53
        * p_x_by_q71 + t28 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t23, -(reach_by_q71_by_q71 * t26
        - projection_by_q71_by_q71 * t27), reach_by_q71_by_q71);
    const double t69 = t68 - t54 * limited_by_q71 + t31 * reach_by_q71_by_q71 - t32
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t30, t69, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t56 * root_by_q71) * t29;
    const double t70 = p_y * limited_by_q71_by_q71 - t16 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t71 = t70 - cos_A * reach_squared_by_q71_by_q71 - t51 * limited_by_q71 - t65
        * root_by_q71;
    const double cos_A_by_q71_by_q71 = (t71 - t64 * cos_A_by_q71) * t11;
    const double t72 = p_y * root_by_q71_by_q71 + t13 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t73 = t72 - sin_A * reach_squared_by_q71_by_q71 - t51 * root_by_q71 + t65
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t73 - t64 * sin_A_by_q71) * t11;
    static const double table83[18][3] = {{0.001, 0.001, 0.002}, {0.003, 0.003, 0.003},
        {0.004, 0.005, 0.005}, {0.006, 0.006, 0.007}, {0.008, 0.008, 0.008},
        {0.009, 0.009, 0.01}, {0.011, 0.011, 0.011}, {0.012, 0.013, 0.013},
        {0.014, 0.014, 0.015}, {0.016, 0.016, 0.016}, {0.017, 0.017, 0.018},
        {0.019, 0.019, 0.019}, {0.02, 0.021, 0.021}, {0.022, 0.022, 0.023},
        {0.024, 0.024, 0.024}, {0.025, 0.025, 0.026}, {0.027, 0.027, 0.027},
        {0.028, 0.029, 0.029}};
    double sum75 = -0.0;
    double sum76 = layer_0_y * (f[0] / h[0]);
    double sum77 = -0.0;
    double sum78 = -0.0;
    double sum79 = -0.0;
    double sum80 = layer_1_y * (f[19] / h[19]);
    double sum81 = -0.0;
    double sum82 = -0.0;
    for (int i74 = 0; i74 < 18; ++i74) {
        const double before84 = sum75;
        const double before85 = sum76;
        const double before86 = sum77;
        const double before87 = sum78;
        const double before88 = sum79;
        const double before89 = sum80;
        const double before90 = sum81;
        const double before91 = sum82;
        const double strand_y = table83[i74][0] + layer_0_y - table83[i74][1] * u_y;
        const double per_length = f[1 + i74] / h[1 + i74];
        const double t92 = table83[i74][1] * per_length;
        const double strand_y_2 = table83[i74][1] + layer_1_y - table83[i74][2] * u_y;
        const double per_length_2 = f[20 + i74] / h[20 + i74];
        const double t93 = table83[i74][2] * per_length_2;
        sum75 = before84 + strand_y * t92;
        sum76 = before85 + strand_y * per_length;
        sum77 = before86 + table83[i74][1] * t92;
        sum78 = before87 + t92;
        sum79 = before88 + strand_y_2 * t93;
        sum80 = before89 + strand_y_2 * per_length_2;
        sum81 = before90 + table83[i74][2] * t93;
        sum82 = before91 + t93;
    }
    double sum95 = -0.0;
    double sum96 = -0.0;
    double sum97 = -0.0;
    double sum98 = -0.0;
    double sum99 = -0.0;
    double sum100 = -0.0;
    double sum101 = -0.0;
    double sum102 = -0.0;
    for (int i94 = 0; i94 < 19; ++i94) {
        const double before103 = sum95;
        const double before104 = sum96;
        const double before105 = sum97;
        const double before106 = sum98;
        const double before107 = sum99;
        const double before108 = sum100;
        const double before109 = sum101;
        const double before110 = sum102;
        const double per_length_3 = f[i94] / h[i94];
        const double t111 = kt[i94] - per_length_3;
        const double per_length_4 = f[19 + i94] / h[19 + i94];
        const double across = kt[19 + i94] - per_length_4;
        const double K = P[38 + 2 * i94] * P[39 + 2 * i94] * across;
        sum95 = before103 + t111 * P[2 * i94] * P[2 * i94];
        sum96 = before104 + P[2 * i94] * P[1 + 2 * i94] * t111;
        sum97 = before105 + t111 * P[1 + 2 * i94] * P[1 + 2 * i94];
        sum98 = before106 + per_length_3;
        sum99 = before107 + across * P[38 + 2 * i94] * P[38 + 2 * i94];
        sum100 = before108 + K;
        sum101 = before109 + across * P[39 + 2 * i94] * P[39 + 2 * i94];
        sum102 = before110 + per_length_4;
    }
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double y_z = sin_q71 * u_e;
    const double t112 = 0.013 * y_z;
    const double t113 = cos_q71 * sin_A;
    const double z_plane_x = u_y * cos_A;
    const double t114 = sin_q71 * z_plane_x;
    const double z_z = t113 + t114;
    const double t115 = 0.01 * z_z;
    const double t116 = cos_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t117 = sin_q71 * x_plane_x;
    const double t118 = 0.004 * (t116 - t117);
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double layer_1_z = 0.028 - origin_z - t118 + t115 + t112;
    const double t119 = sum77 + sum81;
    const double t120 = 0.011 * y_z;
    const double layer_0_z = 0.008 - origin_z - t118 - t115 + t120;
    const double pull_axis_z_4 = y_z * t119 - layer_0_z * sum78 - layer_1_z * sum82;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double y_x = cos_q71 * u_e;
    const double t121 = 0.013 * y_x;
    const double t122 = sin_q71 * sin_A;
    const double t123 = cos_q71 * z_plane_x;
    const double z_x = t123 - t122;
    const double t124 = 0.01 * z_x;
    const double t125 = sin_q71 * cos_A;
    const double t126 = cos_q71 * x_plane_x;
    const double M_x = cos_q71 * M_e;
    const double t127 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t126 + t125);
    const double layer_1_x = t127 + t124 + t121;
    const double t128 = 0.011 * y_x;
    const double layer_0_x = t127 - t124 + t128;
    const double pull_axis_x_4 = y_x * t119 - layer_0_x * sum78 - layer_1_x * sum82;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t20 * cos_A_by_q73;
    const double t129 = 0.01 * z_plane_y_by_q73_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t20 * sin_A_by_q73;
    const double t130 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double y_z_by_q71_by_q73 = cos_q71 * u_e_by_q73;
    const double t131 = y_z_by_q71_by_q73 + y_z_by_q71_by_q73;
    const double t132 = 0.013 * y_z_by_q71_by_q73;
    const double t133 = sin_q71 * sin_A_by_q73;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t134 = cos_q71 * z_plane_x_by_q73;
    const double z_x_by_q73 = t134 - t133;
    const double t135 = 0.01 * z_x_by_q73;
    const double t136 = sin_q71 * cos_A_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t137 = cos_q71 * x_plane_x_by_q73;
    const double M_z_by_q71_by_q73 = cos_q71 * M_e_by_q73;
    const double t138 = M_z_by_q71_by_q73 - 0.018 * z_x_by_q73 - 0.004 * (t137 + t136);
    const double layer_1_x_by_q73 = t138 - t135 - t132;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double t139 = 0.01 * z_plane_y_by_q73;
    const double t140 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73 + sin_A
        * u_e_by_q73);
    const double layer_1_y_by_q73 = t140 - t139 - 0.013 * u_y_by_q73;
    const double y_x_by_q71_by_q73 = sin_q71 * u_e_by_q73;
    const double t141 = y_x_by_q71_by_q73 + y_x_by_q71_by_q73;
    const double t142 = 0.013 * y_x_by_q71_by_q73;
    const double t143 = cos_q71 * sin_A_by_q73;
    const double t144 = sin_q71 * z_plane_x_by_q73;
    const double z_z_by_q73 = t143 + t144;
    const double t145 = 0.01 * z_z_by_q73;
    const double t146 = cos_q71 * cos_A_by_q73;
    const double t147 = sin_q71 * x_plane_x_by_q73;
    const double M_x_by_q71_by_q73 = sin_q71 * M_e_by_q73;
    const double t148 = M_x_by_q71_by_q73 - 0.018 * z_z_by_q73 + 0.004 * (t146 - t147);
    const double layer_1_z_by_q73 = t148 - t145 - t142;
    const double mixed_10 = t36 * layer_1_y_by_q73 + t141 * layer_1_z_by_q73 + t131
        * layer_1_x_by_q73;
    const double t149 = layer_1_x_by_q73 * layer_1_x_by_q73 + layer_1_y_by_q73 * layer_1_y_by_q73;
    const double along_10 = t149 + layer_1_z_by_q73 * layer_1_z_by_q73;
    const double t150 = 0.011 * y_z_by_q71_by_q73;
    const double layer_0_x_by_q73 = t138 + t135 - t150;
    const double layer_0_y_by_q73 = t140 + t139 - 0.011 * u_y_by_q73;
    const double t151 = 0.011 * y_x_by_q71_by_q73;
    const double layer_0_z_by_q73 = t148 + t145 - t151;
    const double mixed_8 = t36 * layer_0_y_by_q73 + t141 * layer_0_z_by_q73 + t131
        * layer_0_x_by_q73;
    const double turned_8 = u_y_by_q73 * u_y_by_q73 + y_x_by_q71_by_q73 * y_x_by_q71_by_q73
        + y_z_by_q71_by_q73 * y_z_by_q71_by_q73;
    const double t152 = layer_0_x_by_q73 * layer_0_x_by_q73 + layer_0_y_by_q73 * layer_0_y_by_q73;
    const double along_8 = t152 + layer_0_z_by_q73 * layer_0_z_by_q73;
    const double pull_x = y_x * sum78 - layer_0_x * sum98;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t36 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double t153 = 0.01 * z_x_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t36 * sin_A_by_q73;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double t154 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t155 = turned_8 * t119 + sum97 + sum101 + sum98 * along_8 + sum78 * mixed_8
        - pull_x * (t154 - t153 - 0.011 * y_x_by_q73_by_q73);
    const double pull_z = y_z * sum78 - layer_0_z * sum98;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double t156 = 0.01 * z_z_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double t157 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t158 = t155 + sum76 * (t130 + t129 - 0.011 * u_y_by_q73_by_q73) - pull_z * (t157
        - t156 - 0.011 * y_z_by_q73_by_q73);
    const double pull_x_2 = y_x * sum82 - layer_1_x * sum102;
    const double t159 = t158 + sum102 * along_10 + sum82 * mixed_10 - pull_x_2 * (t154 + t153
        - 0.013 * y_x_by_q73_by_q73);
    const double pull_z_2 = y_z * sum82 - layer_1_z * sum102;
    const double t160 = t159 + sum80 * (t130 - t129 - 0.013 * u_y_by_q73_by_q73) - pull_z_2 * (t157
        + t156 - 0.013 * y_z_by_q73_by_q73);
    const double t161 = t160 - pull_axis_x_4 * y_x_by_q73_by_q73 + (sum75 + sum79)
        * u_y_by_q73_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double t162 = 0.01 * z_plane_y_by_q71_by_q73;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double t163 = 0.018 * z_plane_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double z_x_by_q71 = t113 - cos_q71 * z_plane_x_by_q71 + t114 + sin_q71 * sin_A_by_q71;
    const double t164 = 0.01 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t116 + cos_q71 * x_plane_x_by_q71 - t117 + sin_q71 * cos_A_by_q71;
    const double t165 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
    const double layer_1_x_by_q71 = t165 - t164 - t112;
    const double z_z_by_q71 = t123 + cos_q71 * sin_A_by_q71 - t122 + sin_q71 * z_plane_x_by_q71;
    const double t166 = 0.01 * z_z_by_q71;
    const double x_z_by_q71 = t126 - cos_q71 * cos_A_by_q71 + t125 + sin_q71 * x_plane_x_by_q71;
    const double t167 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
    const double layer_1_z_by_q71 = t167 - t166 - t121;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double t168 = 0.01 * z_plane_y_by_q71;
    const double t169 = 0.004 * u_e;
    const double t170 = 0.018 * z_plane_y_by_q71 + t169 * sin_A_by_q71;
    const double layer_1_y_by_q71 = t170 + t168;
    const double t171 = y_x * layer_1_z_by_q73 - y_z * layer_1_x_by_q73 - u_y_by_q73
        * layer_1_y_by_q71;
    const double mixed_2 = t171 + y_x_by_q71_by_q73 * layer_1_z_by_q71 - y_z_by_q71_by_q73
        * layer_1_x_by_q71;
    const double t172 = layer_1_x_by_q71 * layer_1_x_by_q73 + layer_1_y_by_q71 * layer_1_y_by_q73;
    const double along_2 = t172 - layer_1_z_by_q71 * layer_1_z_by_q73;
    const double layer_0_z_by_q71 = t167 + t166 - t128;
    const double layer_0_y_by_q71 = t170 - t168;
    const double layer_0_x_by_q71 = t165 + t164 - t120;
    const double t173 = y_x * layer_0_z_by_q73 - y_z * layer_0_x_by_q73 - layer_0_x_by_q71
        * y_z_by_q71_by_q73;
    const double mixed = t173 - layer_0_y_by_q71 * u_y_by_q73 + layer_0_z_by_q71
        * y_x_by_q71_by_q73;
    const double turned = y_x * y_x_by_q71_by_q73 - y_z * y_z_by_q71_by_q73;
    const double t174 = layer_0_x_by_q71 * layer_0_x_by_q73 + layer_0_y_by_q71 * layer_0_y_by_q73;
    const double along = t174 - layer_0_z_by_q71 * layer_0_z_by_q73;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double z_x_by_q71_by_q73 = t143 - cos_q71 * z_plane_x_by_q71_by_q73 + sin_q71
        * sin_A_by_q71_by_q73 + t144;
    const double t175 = 0.01 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t146 + cos_q71 * x_plane_x_by_q71_by_q73 - t147 + sin_q71
        * cos_A_by_q71_by_q73;
    const double origin_x_by_q71_by_q73 = M_x_by_q71_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double t176 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t177 = turned * t119 + sum96 + sum100 - sum98 * along + sum78 * mixed - pull_x
        * (t176 + t175 - t151);
    const double z_z_by_q71_by_q73 = cos_q71 * sin_A_by_q71_by_q73 + t134 - t133 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double t178 = 0.01 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t137 - cos_q71 * cos_A_by_q71_by_q73 + t136 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_z_by_q71_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double t179 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t180 = t177 - sum76 * (t163 - t162) + pull_z * (t179 + t178 - t150) - sum102
        * along_2;
    const double t181 = t180 + sum82 * mixed_2 - pull_x_2 * (t176 - t175 - t142) - sum80 * (t163
        + t162);
    const double t182 = t181 + pull_z_2 * (t179 - t178 - t132) - y_x_by_q71_by_q73 * pull_axis_x_4;
    const double K_01 = t182 + y_z_by_q71_by_q73 * pull_axis_z_4;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double t183 = 0.01 * z_plane_y_by_q71_by_q71;
    const double t184 = 0.018 * z_plane_y_by_q71_by_q71 + t169 * sin_A_by_q71_by_q71;
    const double t185 = y_x + y_x;
    const double t186 = y_z + y_z;
    const double mixed_6 = t185 * layer_1_z_by_q71 + t186 * layer_1_x_by_q71;
    const double t187 = layer_1_x_by_q71 * layer_1_x_by_q71 + layer_1_y_by_q71 * layer_1_y_by_q71;
    const double along_6 = t187 + layer_1_z_by_q71 * layer_1_z_by_q71;
    const double mixed_4 = t185 * layer_0_z_by_q71 + t186 * layer_0_x_by_q71;
    const double t188 = (y_x * y_x + y_z * y_z) * t119 + sum95 + sum99 - y_x * pull_axis_x_4 - y_z
        * pull_axis_z_4;
    const double t189 = layer_0_x_by_q71 * layer_0_x_by_q71 + layer_0_y_by_q71 * layer_0_y_by_q71;
    const double along_4 = t189 + layer_0_z_by_q71 * layer_0_z_by_q71;
    const double t190 = sin_q71 + sin_q71;
    const double t191 = cos_q71 + cos_q71;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t192 = t123 - cos_q71 * z_plane_x_by_q71_by_q71 - t122 + sin_q71
        * sin_A_by_q71_by_q71;
    const double z_x_by_q71_by_q71 = t192 + t191 * sin_A_by_q71 + t190 * z_plane_x_by_q71;
    const double t193 = 0.01 * z_x_by_q71_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t194 = t126 - cos_q71 * x_plane_x_by_q71_by_q71 + t125 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t194 - t191 * cos_A_by_q71 + t190 * x_plane_x_by_q71;
    const double t195 = M_x - 0.018 * z_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t196 = t188 + sum98 * along_4 + sum78 * mixed_4 - pull_x * (t195 + t193 - t128)
        - sum76 * (t184 - t183);
    const double t197 = t113 - cos_q71 * sin_A_by_q71_by_q71 + t114 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t197 - t191 * z_plane_x_by_q71 + t190 * sin_A_by_q71;
    const double t198 = 0.01 * z_z_by_q71_by_q71;
    const double t199 = t116 - cos_q71 * cos_A_by_q71_by_q71 - t117 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t199 + t191 * x_plane_x_by_q71 + t190 * cos_A_by_q71;
    const double t200 = M_z - 0.018 * z_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t201 = t196 - pull_z * (t200 + t198 - t120) + sum102 * along_6 + sum82 * mixed_6;
    const double t202 = t201 - pull_x_2 * (t195 - t193 - t121) - sum80 * (t184 + t183) - pull_z_2
        * (t200 - t198 - t112);
    K_wrist[0] = t202;
    K_wrist[1] = K_01;
    K_wrist[2] = K_01;
    K_wrist[3] = t161 - pull_axis_z_4 * y_z_by_q73_by_q73;
}

void hand_whole_stiffness(const double q[SINEW_AT_LEAST(19)], const double P[SINEW_AT_LEAST(76)],
    const double f[SINEW_AT_LEAST(38)], const double kt[SINEW_AT_LEAST(38)],
    const double K_wrist[SINEW_AT_LEAST(4)], double K[SINEW_AT_LEAST(441)])
{
    static const double table6[3][3] = {{1.0, 0.0065, 0.0055}, {-1.0, 0.0055, -0.0045},
        {-1.0, 0.0055, -0.0045}};
    double kept2[3];
    double kept3[3];
    double kept4[3];
    double kept5[3];
    for (int i1 = 0; i1 < 3; ++i1) {
        const double t7 = P[12 + 16 * i1] * kt[6 + 8 * i1];
        const double t8 = P[8 + 16 * i1] * kt[4 + 8 * i1] - P[10 + 16 * i1] * kt[5 + 8 * i1]
            - table6[i1][0] * t7;
        const double t9 = P[14 + 16 * i1] * kt[7 + 8 * i1];
        const double t10 = table6[i1][1] * (t8 + table6[i1][0] * t9);
        const double t11 = table6[i1][2] * (t7 - t9);
        const double t12 = 0.0065 * P[16 + 16 * i1] * kt[8 + 8 * i1];
        const double t13 = 0.0065 * P[18 + 16 * i1] * kt[9 + 8 * i1];
        const double t14 = 0.0065 * P[20 + 16 * i1] * kt[10 + 8 * i1];
        const double t15 = 0.0065 * P[22 + 16 * i1] * kt[11 + 8 * i1];
        const double K_wrist_2 = t12 + t13 - t14 - t15;
        const double K_wrist_3 = t12 - t13 + t14 - t15;
        K[401 + 4 * i1] = t10;
        K[402 + 4 * i1] = t11;
        K[403 + 4 * i1] = K_wrist_2;
        K[404 + 4 * i1] = K_wrist_3;
        kept2[i1] = t10;
        kept3[i1] = t11;
        kept4[i1] = K_wrist_2;
        kept5[i1] = K_wrist_3;
    }
    for (int i16 = 0; i16 < 10; ++i16) {
        K[10 + 21 * i16] = 0.0;
        K[11 + 21 * i16] = 0.0;
        K[12 + 21 * i16] = 0.0;
        K[13 + 21 * i16] = 0.0;
        K[14 + 21 * i16] = 0.0;
        K[15 + 21 * i16] = 0.0;
        K[16 + 21 * i16] = 0.0;
        K[17 + 21 * i16] = 0.0;
        K[18 + 21 * i16] = 0.0;
    }
    for (int i17 = 0; i17 < 11; ++i17) {
        K[168 + 21 * i17] = 0.0;
        K[169 + 21 * i17] = 0.0;
        K[170 + 21 * i17] = 0.0;
        K[171 + 21 * i17] = 0.0;
        K[172 + 21 * i17] = 0.0;
        K[173 + 21 * i17] = 0.0;
        K[174 + 21 * i17] = 0.0;
        K[175 + 21 * i17] = 0.0;
    }
    for (int i18 = 0; i18 < 6; ++i18) {
        K[260 + 21 * i18] = 0.0;
        K[261 + 21 * i18] = 0.0;
        K[262 + 21 * i18] = 0.0;
        K[263 + 21 * i18] = 0.0;
        K[270 + 21 * i18] = 0.0;
    }
    for (int i19 = 0; i19 < 6; ++i19) {
        K[6 + 21 * i19] = 0.0;
        K[7 + 21 * i19] = 0.0;
        K[8 + 21 * i19] = 0.0;
        K[9 + 21 * i19] = 0.0;
    }
    for (int i20 = 0; i20 < 4; ++i20) {
        K[84 + 21 * i20] = 0.0;
        K[85 + 21 * i20] = 0.0;
        K[86 + 21 * i20] = 0.0;
        K[87 + 21 * i20] = 0.0;
    }
    for (int i21 = 0; i21 < 4; ++i21) {
        K[224 + 21 * i21] = 0.0;
        K[225 + 21 * i21] = 0.0;
        K[226 + 21 * i21] = 0.0;
        K[227 + 21 * i21] = 0.0;
    }
    const struct sinew_sines2 sines22 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines22.s[0];
    const double c1 = sines22.c[0];
    const double s2 = sines22.s[1];
    const double c2 = sines22.c[1];
    const double t23 = 0.0065 * kt[6] + 0.0065 * kt[7];
    const double K3_3 = 4.225e-05 * (kt[4] + kt[5]) + 0.0065 * t23;
    K[44] = K3_3;
    const double t24 = -(0.0055 * t23);
    K[45] = t24;
    K[46] = 0.0;
    K[47] = 0.0;
    K[65] = t24;
    K[61] = kept2[0];
    const double t25 = P[13] * kt[6];
    const double t26 = P[15] * kt[7];
    const double K_wrist_10 = 0.0065 * (P[9] * kt[4] - P[11] * kt[5] - t25 + t26);
    K[62] = K_wrist_10;
    K[63] = 0.0;
    K[64] = 0.0;
    K[422] = K_wrist_10;
    K[66] = 3.0249999999999997e-05 * (kt[6] + kt[7]);
    K[67] = 0.0;
    K[68] = 0.0;
    K[82] = kept3[0];
    const double K_wrist_14 = 0.0055 * (t25 - t26);
    K[83] = K_wrist_14;
    K[423] = K_wrist_14;
    const double t27 = 4.225e-05 * kt[8];
    const double t28 = 4.225e-05 * kt[9];
    const double t29 = 4.225e-05 * kt[10];
    const double t30 = 4.225e-05 * kt[11];
    const double K1_1_2 = t27 + t28 + t29 + t30;
    K[88] = K1_1_2;
    K[110] = K1_1_2;
    const double K1_2_2 = t27 - t28 - t29 + t30;
    K[89] = K1_2_2;
    K[109] = K1_2_2;
    K[103] = kept4[0];
    const double t31 = 0.0065 * P[17] * kt[8];
    const double t32 = 0.0065 * P[19] * kt[9];
    const double t33 = 0.0065 * P[21] * kt[10];
    const double t34 = 0.0065 * P[23] * kt[11];
    const double K_wrist_18 = t31 + t32 - t33 - t34;
    K[104] = K_wrist_18;
    K[424] = K_wrist_18;
    K[124] = kept5[0];
    const double K_wrist_22 = t31 - t32 + t33 - t34;
    K[125] = K_wrist_22;
    K[130] = 0.0;
    K[131] = 0.0;
    K[425] = K_wrist_22;
    const double t35 = 0.0055 * kt[14] + 0.0055 * kt[15];
    const double K3_3_2 = 3.0249999999999997e-05 * (kt[12] + kt[13]) + 0.0055 * t35;
    K[132] = K3_3_2;
    const double t36 = -(0.0045 * t35);
    K[133] = t36;
    K[134] = 0.0;
    K[135] = 0.0;
    K[153] = t36;
    K[145] = kept2[1];
    const double t37 = P[29] * kt[14];
    const double t38 = P[31] * kt[15];
    const double K_wrist_26 = 0.0055 * (P[25] * kt[12] - P[27] * kt[13] + t37 - t38);
    K[146] = K_wrist_26;
    K[151] = 0.0;
    K[152] = 0.0;
    K[426] = K_wrist_26;
    const double K4_4_2 = 2.0249999999999998e-05 * (kt[14] + kt[15]);
    K[154] = K4_4_2;
    K[155] = 0.0;
    K[156] = 0.0;
    K[166] = kept3[1];
    const double t39 = -(0.0045 * (t37 - t38));
    K[167] = t39;
    K[427] = t39;
    const double t40 = 4.225e-05 * kt[16];
    const double t41 = 4.225e-05 * kt[17];
    const double t42 = 4.225e-05 * kt[18];
    const double t43 = 4.225e-05 * kt[19];
    const double K1_1_4 = t40 + t41 + t42 + t43;
    K[176] = K1_1_4;
    K[198] = K1_1_4;
    const double K1_2_4 = t40 - t41 - t42 + t43;
    K[177] = K1_2_4;
    K[197] = K1_2_4;
    K[187] = kept4[1];
    const double t44 = 0.0065 * P[33] * kt[16];
    const double t45 = 0.0065 * P[35] * kt[17];
    const double t46 = 0.0065 * P[37] * kt[18];
    const double t47 = 0.0065 * P[39] * kt[19];
    const double K_wrist_34 = t44 + t45 - t46 - t47;
    K[188] = K_wrist_34;
    K[428] = K_wrist_34;
    K[208] = kept5[1];
    const double K_wrist_38 = t44 - t45 + t46 - t47;
    K[209] = K_wrist_38;
    K[218] = 0.0;
    K[219] = 0.0;
    K[429] = K_wrist_38;
    const double t48 = 0.0055 * kt[22] + 0.0055 * kt[23];
    const double K3_3_4 = 3.0249999999999997e-05 * (kt[20] + kt[21]) + 0.0055 * t48;
    K[220] = K3_3_4;
    const double t49 = -(0.0045 * t48);
    K[221] = t49;
    K[222] = 0.0;
    K[223] = 0.0;
    K[228] = 0.0;
    K[241] = t49;
    K[229] = kept2[2];
    const double t50 = P[45] * kt[22];
    const double t51 = P[47] * kt[23];
    const double K_wrist_42 = 0.0055 * (P[41] * kt[20] - P[43] * kt[21] + t50 - t51);
    K[230] = K_wrist_42;
    K[239] = 0.0;
    K[240] = 0.0;
    K[430] = K_wrist_42;
    const double K4_4_4 = 2.0249999999999998e-05 * (kt[22] + kt[23]);
    K[242] = K4_4_4;
    K[243] = 0.0;
    K[244] = 0.0;
    K[249] = 0.0;
    K[250] = kept3[2];
    const double t52 = -(0.0045 * (t50 - t51));
    K[251] = t52;
    K[431] = t52;
    const double t53 = 4.225e-05 * kt[24];
    const double t54 = 4.225e-05 * kt[25];
    const double t55 = 4.225e-05 * kt[26];
    const double t56 = 4.225e-05 * kt[27];
    const double K1_1_6 = t53 + t54 + t55 + t56;
    K[264] = K1_1_6;
    K[286] = K1_1_6;
    const double K1_2_6 = t53 - t54 - t55 + t56;
    K[265] = K1_2_6;
    K[285] = K1_2_6;
    K[271] = kept4[2];
    const double t57 = 0.0065 * P[49] * kt[24];
    const double t58 = 0.0065 * P[51] * kt[25];
    const double t59 = 0.0065 * P[53] * kt[26];
    const double t60 = 0.0065 * P[55] * kt[27];
    const double K_wrist_50 = t57 + t58 - t59 - t60;
    K[272] = K_wrist_50;
    K[432] = K_wrist_50;
    K[292] = kept5[2];
    const double K_wrist_54 = t57 - t58 + t59 - t60;
    K[293] = K_wrist_54;
    K[306] = 0.0;
    K[307] = 0.0;
    K[433] = K_wrist_54;
    const double K3_3_6 = 0.00012100000000000003 * (kt[28] + kt[29]);
    K[308] = K3_3_6;
    K[309] = 0.0;
    K[310] = 0.0;
    K[311] = 0.0;
    const double K_wrist_56 = 0.011000000000000001 * (P[56] * kt[28] - P[58] * kt[29]);
    K[313] = K_wrist_56;
    K[413] = K_wrist_56;
    const double K_wrist_58 = 0.011000000000000001 * (P[57] * kt[28] - P[59] * kt[29]);
    K[314] = K_wrist_58;
    K[327] = 0.0;
    K[328] = 0.0;
    K[329] = 0.0;
    K[434] = K_wrist_58;
    const double t61 = 2.704e-05 * kt[30];
    const double t62 = 2.704e-05 * kt[31];
    const double t63 = 2.704e-05 * kt[32];
    const double t64 = 2.704e-05 * kt[33];
    const double K1_1_8 = t61 + t62 + t63 + t64;
    K[330] = K1_1_8;
    K[352] = K1_1_8;
    K[353] = 0.0;
    const double K1_2_8 = t61 - t62 - t63 + t64;
    K[331] = K1_2_8;
    K[332] = 0.0;
    K[351] = K1_2_8;
    const double t65 = 0.0052 * P[60] * kt[30];
    const double t66 = 0.0052 * P[62] * kt[31];
    const double t67 = 0.0052 * P[64] * kt[32];
    const double t68 = 0.0052 * P[66] * kt[33];
    const double K_wrist_60 = t65 + t66 - t67 - t68;
    K[334] = K_wrist_60;
    K[414] = K_wrist_60;
    const double t69 = 0.0052 * P[61] * kt[30];
    const double t70 = 0.0052 * P[63] * kt[31];
    const double t71 = 0.0052 * P[65] * kt[32];
    const double t72 = 0.0052 * P[67] * kt[33];
    const double K_wrist_62 = t69 + t70 - t71 - t72;
    K[335] = K_wrist_62;
    K[348] = 0.0;
    K[349] = 0.0;
    K[350] = 0.0;
    K[435] = K_wrist_62;
    const double K_wrist_64 = t65 - t66 + t67 - t68;
    K[355] = K_wrist_64;
    K[415] = K_wrist_64;
    const double K_wrist_66 = t69 - t70 + t71 - t72;
    K[356] = K_wrist_66;
    K[369] = 0.0;
    K[370] = 0.0;
    K[371] = 0.0;
    K[372] = 0.0;
    K[373] = 0.0;
    K[436] = K_wrist_66;
    K[374] = 7.744e-05 * (kt[34] + kt[35]);
    const double K_wrist_68 = 0.0088 * (P[68] * kt[34] - P[70] * kt[35]);
    K[376] = K_wrist_68;
    K[416] = K_wrist_68;
    const double K_wrist_70 = 0.0088 * (P[69] * kt[34] - P[71] * kt[35]);
    K[377] = K_wrist_70;
    K[386] = 0.0;
    K[387] = 0.0;
    K[388] = 0.0;
    K[389] = 0.0;
    K[390] = 0.0;
    K[391] = 0.0;
    K[392] = 0.0;
    K[393] = 0.0;
    K[394] = 0.0;
    K[395] = 0.0;
    K[437] = K_wrist_70;
    K[396] = 2.5e-05 * (kt[36] + kt[37]);
    const double t73 = 0.005 * c2;
    const double t74 = 0.047 * s2;
    const double pA_length_toz = t73 - t74;
    const double A_lengthdz = 0.025 - pA_length_toz;
    const double t75 = A_lengthdz * A_lengthdz;
    const double R21x = c1 * c2;
    const double t76 = 0.047 * R21x;
    const double t77 = 0.006 * s1;
    const double R21y = c1 * s2;
    const double t78 = 0.005 * R21y;
    const double t79 = t78 - t77;
    const double pA_length_tox = t79 + t76;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double R22x = s1 * c2;
    const double t80 = 0.047 * R22x;
    const double t81 = 0.006 * c1;
    const double R22y = s1 * s2;
    const double t82 = 0.005 * R22y;
    const double t83 = t82 + t81;
    const double pA_length_toy = t83 + t80;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t75);
    const double t84 = 1.0 / A_length;
    const double t85 = A_lengthdy + pA_length_toy;
    const double t86 = A_lengthdx + pA_length_tox;
    const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t84;
    const double t87 = pA_length_toy * t85 + pA_length_tox * t86 - A_length_by_q_0
        * A_length_by_q_0;
    const double pB_length_toz = t73 + t74;
    const double B_lengthdz = 0.025 - pB_length_toz;
    const double t88 = B_lengthdz * B_lengthdz;
    const double t89 = t78 + t77;
    const double pB_length_tox = t89 - t76;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double t90 = t82 - t81;
    const double pB_length_toy = t90 - t80;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t88);
    const double t91 = 1.0 / B_length;
    const double t92 = B_lengthdy - pB_length_toy;
    const double t93 = B_lengthdx - pB_length_tox;
    const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t91;
    const double t94 = pB_length_toy * t92 + pB_length_tox * t93 + B_length_by_q_0
        * B_length_by_q_0;
    const double t95 = 0.005 * R22x;
    const double t96 = 0.047 * R22y;
    const double pA_length_toy_by_q_1 = t95 - t96;
    const double t97 = 0.005 * R21x;
    const double t98 = 0.047 * R21y;
    const double pA_length_tox_by_q_1 = t97 - t98;
    const double t99 = 0.005 * s2;
    const double t100 = 0.047 * c2;
    const double pA_length_toz_by_q_1 = t99 + t100;
    const double t101 = A_lengthdz * pA_length_toz_by_q_1;
    const double t102 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1
        - t101;
    const double A_length_by_q_1 = t102 * t84;
    const double t103 = pA_length_toy_by_q_1 * t86 - pA_length_tox_by_q_1 * t85 - A_length_by_q_0
        * A_length_by_q_1;
    const double pB_length_tox_by_q_1 = t97 + t98;
    const double pB_length_toy_by_q_1 = t95 + t96;
    const double pB_length_toz_by_q_1 = t99 - t100;
    const double t104 = B_lengthdz * pB_length_toz_by_q_1;
    const double t105 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1
        + t104;
    const double B_length_by_q_1 = t105 * t91;
    const double t106 = pB_length_tox_by_q_1 * t92 + pB_length_toy_by_q_1 * -t93 - B_length_by_q_0
        * B_length_by_q_1;
    const double t107 = pA_length_toz_by_q_1 * pA_length_toz_by_q_1;
    const double t108 = pA_length_toy_by_q_1 * pA_length_toy_by_q_1;
    const double t109 = pA_length_tox_by_q_1 * pA_length_tox_by_q_1;
    const double pA_length_toy_by_q_1_2_by_q_1 = t82 + t80;
    const double t110 = pA_length_toz * A_lengthdz;
    const double pA_length_tox_by_q_1_2_by_q_1 = t78 + t76;
    const double t111 = t110 + A_lengthdx * pA_length_tox_by_q_1_2_by_q_1 + A_lengthdy
        * pA_length_toy_by_q_1_2_by_q_1;
    const double A_length_by_q_1_2_by_q_1 = (t111 + t109 + t108 + t107 - A_length_by_q_1
        * A_length_by_q_1) * t84;
    const double t112 = pB_length_toz_by_q_1 * pB_length_toz_by_q_1;
    const double t113 = pB_length_toy_by_q_1 * pB_length_toy_by_q_1;
    const double t114 = pB_length_tox_by_q_1 * pB_length_tox_by_q_1;
    const double pB_length_toy_by_q_1_2_by_q_1 = t82 - t80;
    const double t115 = pB_length_toz * B_lengthdz;
    const double pB_length_tox_by_q_1_2_by_q_1 = t78 - t76;
    const double t116 = t115 - B_lengthdx * pB_length_tox_by_q_1_2_by_q_1 - B_lengthdy
        * pB_length_toy_by_q_1_2_by_q_1;
    const double B_length_by_q_1_2_by_q_1 = (t116 + t114 + t113 + t112 - B_length_by_q_1
        * B_length_by_q_1) * t91;
    const double K_wrist_72 = 0.005 * (P[72] * kt[36] - P[74] * kt[37]);
    K[397] = K_wrist_72;
    K[417] = K_wrist_72;
    K[418] = K_wrist[0];
    K[419] = K_wrist[1];
    const double K_wrist_74 = 0.005 * (P[73] * kt[36] - P[75] * kt[37]);
    K[398] = K_wrist_74;
    K[438] = K_wrist_74;
    K[439] = K_wrist[2];
    K[440] = K_wrist[3];
    const double pC_length_toy = t90 + t80;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double pC_length_tox = t89 + t76;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double C_length = sinew_sqrt(t75 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t117 = 1.0 / C_length;
    const double t118 = pC_length_toy - C_lengthdy;
    const double t119 = C_lengthdx + pC_length_tox;
    const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t117;
    const double t120 = pC_length_toy * t118 + pC_length_tox * t119 - C_length_by_q_0
        * C_length_by_q_0;
    const double t121 = t101 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy
        * pA_length_toy_by_q_1;
    const double C_length_by_q_1 = t121 * t117;
    const double t122 = pA_length_tox_by_q_1 * -t118 + pA_length_toy_by_q_1 * t119 - C_length_by_q_0
        * C_length_by_q_1;
    const double t123 = t110 + C_lengthdx * pA_length_tox_by_q_1_2_by_q_1 - C_lengthdy
        * pA_length_toy_by_q_1_2_by_q_1;
    const double C_length_by_q_1_2_by_q_1 = (t123 + t109 + t108 + t107 - C_length_by_q_1
        * C_length_by_q_1) * t117;
    const double t124 = f[0] * A_length_by_q_1_2_by_q_1 + f[1] * B_length_by_q_1_2_by_q_1 + f[2]
        * C_length_by_q_1_2_by_q_1;
    const double pD_length_toy = t83 - t80;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double pD_length_tox = t79 - t76;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double D_length = sinew_sqrt(t88 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t125 = 1.0 / D_length;
    const double t126 = D_lengthdx - pD_length_tox;
    const double t127 = D_lengthdy + pD_length_toy;
    const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t125;
    const double t128 = pD_length_tox * t126 - pD_length_toy * t127 + D_length_by_q_0
        * D_length_by_q_0;
    const double t129 = f[0] * (t87 * t84) - f[1] * (t94 * t91) + f[2] * (t120 * t117) - f[3]
        * (t128 * t125);
    const double t130 = t104 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy
        * pB_length_toy_by_q_1;
    const double D_length_by_q_1 = t130 * t125;
    const double t131 = pB_length_toy_by_q_1 * -t126 - pB_length_tox_by_q_1 * t127 + D_length_by_q_0
        * D_length_by_q_1;
    const double t132 = f[0] * (t103 * t84) + f[1] * (t106 * t91) + f[2] * (t122 * t117) + f[3]
        * (t131 * t125);
    const double t133 = t115 - D_lengthdx * pB_length_tox_by_q_1_2_by_q_1 + D_lengthdy
        * pB_length_toy_by_q_1_2_by_q_1;
    const double D_length_by_q_1_2_by_q_1 = (t133 + t114 + t113 + t112 - D_length_by_q_1
        * D_length_by_q_1) * t125;
    const double w1_1 = kt[0] * A_length_by_q_0;
    const double t134 = t124 + f[3] * D_length_by_q_1_2_by_q_1 + A_length_by_q_1 * (kt[0]
        * A_length_by_q_1);
    const double w2_1 = kt[1] * B_length_by_q_0;
    const double t135 = P[0] * kt[0];
    const double t136 = P[2] * kt[1];
    const double t137 = P[1] * kt[0];
    const double t138 = P[3] * kt[1];
    const double w3_1 = kt[2] * C_length_by_q_0;
    const double t139 = t129 + A_length_by_q_0 * w1_1 + B_length_by_q_0 * w2_1 + C_length_by_q_0
        * w3_1;
    const double t140 = t132 + A_length_by_q_1 * w1_1 + B_length_by_q_1 * w2_1 + C_length_by_q_1
        * w3_1;
    const double t141 = P[4] * kt[2];
    const double t142 = P[5] * kt[2];
    const double t143 = t134 + B_length_by_q_1 * (kt[1] * B_length_by_q_1) + C_length_by_q_1
        * (kt[2] * C_length_by_q_1);
    const double w4_1 = kt[3] * D_length_by_q_0;
    K[0] = t139 + D_length_by_q_0 * w4_1;
    const double K1_2 = t140 - D_length_by_q_1 * w4_1;
    K[1] = K1_2;
    K[2] = 0.0;
    K[3] = 0.0;
    K[4] = 0.0;
    K[5] = 0.0;
    K[21] = K1_2;
    const double t144 = P[6] * kt[3];
    const double K_wrist_4 = t135 * A_length_by_q_0 - t136 * B_length_by_q_0 - t141
        * C_length_by_q_0 + t144 * D_length_by_q_0;
    const double t145 = -K_wrist_4;
    K[19] = t145;
    K[399] = t145;
    const double t146 = P[7] * kt[3];
    const double K_wrist_2_2 = t137 * A_length_by_q_0 - t138 * B_length_by_q_0 - t142
        * C_length_by_q_0 + t146 * D_length_by_q_0;
    const double t147 = -K_wrist_2_2;
    K[20] = t147;
    K[420] = t147;
    const double K2_2 = t143 + D_length_by_q_1 * (kt[3] * D_length_by_q_1);
    K[22] = K2_2;
    K[23] = 0.0;
    K[24] = 0.0;
    K[25] = 0.0;
    K[26] = 0.0;
    const double K_wrist_4_2 = t135 * A_length_by_q_1 - t136 * B_length_by_q_1 - t141
        * C_length_by_q_1 - t144 * D_length_by_q_1;
    const double t148 = -K_wrist_4_2;
    K[40] = t148;
    K[400] = t148;
    const double K_wrist_6 = t137 * A_length_by_q_1 - t138 * B_length_by_q_1 - t142
        * C_length_by_q_1 - t146 * D_length_by_q_1;
    const double t149 = -K_wrist_6;
    K[41] = t149;
    K[42] = 0.0;
    K[43] = 0.0;
    K[421] = t149;
}

void hand_inverse_dynamics(const double q[SINEW_AT_LEAST(18)], const double qd[SINEW_AT_LEAST(18)],
    const double qdd[SINEW_AT_LEAST(18)], const double g[SINEW_AT_LEAST(15)],
    double tau[SINEW_AT_LEAST(18)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const double phi3_2 = q[5] + q[6];
    const double phi4_2 = q[7] + phi3_2;
    const double phi3_4 = q[9] + q[10];
    const double phi4_4 = q[11] + phi3_4;
    const double phi3_6 = q[13] + q[14];
    const double phi4_6 = phi3_6 + 1.2222222222222223 * q[14];
    const double phi3_8 = q[16] + q[17];
    const double phi4_8 = phi3_8 + 1.2222222222222223 * q[17];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(phi4, q[0]);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double s1 = sines2.s[1];
    const double c1 = sines2.c[1];
    const struct sinew_sines2 sines3 = sinew_one_sincos2(phi4_2, phi3_2);
    const double s4_2 = sines3.s[0];
    const double c4_2 = sines3.c[0];
    const double s3_2 = sines3.s[1];
    const double c3_2 = sines3.c[1];
    const struct sinew_sines2 sines4 = sinew_one_sincos2(q[5], q[4]);
    const double s2_2 = sines4.s[0];
    const double c2_2 = sines4.c[0];
    const double s1_2 = sines4.s[1];
    const double c1_2 = sines4.c[1];
    const struct sinew_sines2 sines5 = sinew_one_sincos2(phi4_4, phi3_4);
    const double s4_4 = sines5.s[0];
    const double c4_4 = sines5.c[0];
    const double s3_4 = sines5.s[1];
    const double c3_4 = sines5.c[1];
    const struct sinew_sines2 sines6 = sinew_one_sincos2(q[9], q[8]);
    const double s2_4 = sines6.s[0];
    const double c2_4 = sines6.c[0];
    const double s1_4 = sines6.s[1];
    const double c1_4 = sines6.c[1];
    const struct sinew_sines2 sines7 = sinew_one_sincos2(phi4_6, phi3_6);
    const double s4_6 = sines7.s[0];
    const double c4_6 = sines7.c[0];
    const double s3_6 = sines7.s[1];
    const double c3_6 = sines7.c[1];
    const struct sinew_sines2 sines8 = sinew_one_sincos2(q[13], q[12]);
    const double s2_6 = sines8.s[0];
    const double c2_6 = sines8.c[0];
    const double s1_6 = sines8.s[1];
    const double c1_6 = sines8.c[1];
    const struct sinew_sines2 sines9 = sinew_one_sincos2(phi4_8, phi3_8);
    const double s4_8 = sines9.s[0];
    const double c4_8 = sines9.c[0];
    const double s3_8 = sines9.s[1];
    const double c3_8 = sines9.c[1];
    const struct sinew_sines2 sines10 = sinew_one_sincos2(q[16], q[15]);
    const double s2_8 = sines10.s[0];
    const double c2_8 = sines10.c[0];
    const double s1_8 = sines10.s[1];
    const double c1_8 = sines10.c[1];
    const double a1x_8 = g[12] * c1_8 + g[13] * s1_8;
    const double w1zz_8 = qd[15] * qd[15];
    const double b2x_6 = a1x_8 + 0.0048 * w1zz_8;
    const double w2zz_8 = qd[16] * qd[16];
    const double e2x_8 = qdd[16] * s2_8 + c2_8 * w2zz_8;
    const double a3x_8 = b2x_6 + 0.032304 * e2x_8;
    const double w3z_8 = qd[16] + qd[17];
    const double w3zz_8 = w3z_8 * w3z_8;
    const double al3z_8 = qdd[16] + qdd[17];
    const double e3x_8 = c3_8 * w3zz_8 + s3_8 * al3z_8;
    const double j4y1_8 = 1.234944e-05 * s4_8;
    const double e3y_8 = c3_8 * al3z_8 - s3_8 * w3zz_8;
    const double a3y_8 = g[14] - 0.032304 * (qdd[16] * c2_8 - s2_8 * w2zz_8);
    const double j4x1_8 = 1.234944e-05 * c4_8;
    const double al4z_8 = al3z_8 + 1.2222222222222223 * qdd[17];
    const double n4_8 = 1.462099968e-07 * al4z_8 - j4x1_8 * (a3y_8 - 0.02384 * e3y_8) + j4y1_8
        * (a3x_8 + 0.02384 * e3x_8);
    const double j3x1_8 = 7.323648000000001e-05 * c3_8;
    const double j3y1_8 = 7.323648000000001e-05 * s3_8;
    const double t11 = 1.2222222222222223 * qd[17];
    const double w4z_8 = w3z_8 + t11;
    const double w4zz_8 = w4z_8 * w4z_8;
    const double F4y_8 = 1.234944e-05 * (c4_8 * al4z_8 - s4_8 * w4zz_8);
    const double l4x_8 = 0.02384 * c3_8;
    const double t12 = n4_8 + 1.482612736e-06 * al3z_8 - j3x1_8 * a3y_8 + j3y1_8 * a3x_8 + l4x_8
        * F4y_8;
    const double e4x_8 = c4_8 * w4zz_8 + s4_8 * al4z_8;
    const double F4x_8 = 1.234944e-05 * e4x_8;
    const double l4y_8 = 0.02384 * s3_8;
    const double n3_8 = t12 + l4y_8 * F4x_8;
    const double j4yz_6 = 5.2855603200000006e-08 * s4_8;
    const double K3yz_6 = 2.2996254720000002e-07 * s3_8 + j4yz_6;
    const double l3x_8 = 0.032304 * c2_8;
    const double o4x_8 = l3x_8 + l4x_8;
    const double j4u_8 = 1.185619968e-07 * c4_8;
    const double K4yx_8 = s4_8 * j4u_8 + o4x_8 * j4y1_8;
    const double j3u_8 = 1.427316736e-06 * c3_8;
    const double K3yx_8 = s3_8 * j3u_8 + K4yx_8 + l3x_8 * j3y1_8 + l4y_8 * j4x1_8;
    const double t3_8 = n3_8 + qdd[15] * K3yz_6 + w1zz_8 * K3yx_8;
    const double t4_8 = n4_8 + qdd[15] * j4yz_6 + w1zz_8 * K4yx_8;
    tau[17] = t3_8 + 1.2222222222222223 * t4_8;
    const double j2x1_8 = 0.000223285248 * c2_8;
    const double j2y1_8 = 0.000223285248 * s2_8;
    const double t13 = n3_8 + 6.45303346786e-06 * qdd[16] - g[14] * j2x1_8 + b2x_6 * j2y1_8 + l3x_8
        * (F4y_8 + 7.323648000000001e-05 * e3y_8);
    const double l3y_8 = 0.032304 * s2_8;
    const double n2_8 = t13 + l3y_8 * (F4x_8 + 7.323648000000001e-05 * e3x_8);
    const double j2u_8 = 6.37008946786e-06 * c2_8;
    const double S3x_8 = j3x1_8 + j4x1_8;
    const double K2yx_8 = s2_8 * j2u_8 + K3yx_8 + l3y_8 * S3x_8;
    const double t2_8 = n2_8 + qdd[15] * (4.1084485632e-07 * s2_8 + K3yz_6) + w1zz_8 * K2yx_8;
    tau[16] = t2_8;
    const double R2yx_8 = qd[16] * K2yx_8 + qd[17] * K3yx_8 + t11 * K4yx_8;
    const double w_2y_8 = qd[15] + qd[15];
    const double t14 = c2_8 * j2u_8 + c3_8 * j3u_8 + c4_8 * j4u_8 + o4x_8 * j4x1_8 + l3x_8 * j3x1_8;
    const double t15 = qdd[15] * (t14 + l4x_8 * j4x1_8 + l3x_8 * S3x_8 + 4.3573002239999995e-07);
    const double t16 = t15 + 5.2855603200000006e-08 * e4x_8 + 2.2996254720000002e-07 * e3x_8
        + 4.1084485632e-07 * e2x_8;
    const double S2x_8 = j2x1_8 + S3x_8;
    const double a1y_8 = g[12] * s1_8 - g[13] * c1_8;
    const double t17 = t16 + (a1y_8 + 0.0048 * qdd[15]) * S2x_8 - w_2y_8 * R2yx_8 + 1.271808e-05
        * a1x_8;
    const double S3y_8 = j3y1_8 + j4y1_8;
    const double R2y_8 = qd[16] * (j2y1_8 + S3y_8) + qd[17] * S3y_8 + t11 * j4y1_8;
    const double N1z_8 = t17 + 4.66944e-05 * a1y_8 + 0.0048 * (qdd[15] * S2x_8 - w_2y_8 * R2y_8);
    tau[15] = N1z_8;
    const double a1x_6 = g[9] * c1_6 + g[10] * s1_6;
    const double w1zz_6 = qd[12] * qd[12];
    const double b2x_4 = a1x_6 + 0.006 * w1zz_6;
    const double w2zz_6 = qd[13] * qd[13];
    const double e2x_6 = qdd[13] * s2_6 + c2_6 * w2zz_6;
    const double a3x_6 = b2x_4 + 0.04038 * e2x_6;
    const double w3z_6 = qd[13] + qd[14];
    const double w3zz_6 = w3z_6 * w3z_6;
    const double al3z_6 = qdd[13] + qdd[14];
    const double e3x_6 = c3_6 * w3zz_6 + s3_6 * al3z_6;
    const double j4y1_6 = 3.015e-05 * s4_6;
    const double e3y_6 = c3_6 * al3z_6 - s3_6 * w3zz_6;
    const double a3y_6 = g[11] - 0.04038 * (qdd[13] * c2_6 - s2_6 * w2zz_6);
    const double j4x1_6 = 3.015e-05 * c4_6;
    const double al4z_6 = al3z_6 + 1.2222222222222223 * qdd[14];
    const double n4_6 = 4.3101e-07 * al4z_6 - j4x1_6 * (a3y_6 - 0.0298 * e3y_6) + j4y1_6 * (a3x_6
        + 0.0298 * e3x_6);
    const double j3x1_6 = 0.0001788 * c3_6;
    const double j3y1_6 = 0.0001788 * s3_6;
    const double t18 = 1.2222222222222223 * qd[14];
    const double w4z_6 = w3z_6 + t18;
    const double w4zz_6 = w4z_6 * w4z_6;
    const double F4y_6 = 3.015e-05 * (c4_6 * al4z_6 - s4_6 * w4zz_6);
    const double l4x_6 = 0.0298 * c3_6;
    const double t19 = n4_6 + 4.4942e-06 * al3z_6 - j3x1_6 * a3y_6 + j3y1_6 * a3x_6 + l4x_6 * F4y_6;
    const double e4x_6 = c4_6 * w4zz_6 + s4_6 * al4z_6;
    const double F4x_6 = 3.015e-05 * e4x_6;
    const double l4y_6 = 0.0298 * s3_6;
    const double n3_6 = t19 + l4y_6 * F4x_6;
    const double j4yz_4 = 1.613025e-07 * s4_6;
    const double K3yz_4 = 7.0179e-07 * s3_6 + j4yz_4;
    const double l3x_6 = 0.04038 * c2_6;
    const double o4x_6 = l3x_6 + l4x_6;
    const double j4u_6 = 3.7701e-07 * c4_6;
    const double K4yx_6 = s4_6 * j4u_6 + o4x_6 * j4y1_6;
    const double j3u_6 = 4.3862e-06 * c3_6;
    const double K3yx_6 = s3_6 * j3u_6 + K4yx_6 + l3x_6 * j3y1_6 + l4y_6 * j4x1_6;
    const double t3_6 = n3_6 + qdd[12] * K3yz_4 + w1zz_6 * K3yx_6;
    const double t4_6 = n4_6 + qdd[12] * j4yz_4 + w1zz_6 * K4yx_6;
    tau[14] = t3_6 + 1.2222222222222223 * t4_6;
    const double j2x1_6 = 0.00054513 * c2_6;
    const double j2y1_6 = 0.00054513 * s2_6;
    const double t20 = n3_6 + 1.96475328e-05 * qdd[13] - g[11] * j2x1_6 + b2x_4 * j2y1_6 + l3x_6
        * (F4y_6 + 0.0001788 * e3y_6);
    const double l3y_6 = 0.04038 * s2_6;
    const double n2_6 = t20 + l3y_6 * (F4x_6 + 0.0001788 * e3x_6);
    const double j2u_6 = 1.94855328e-05 * c2_6;
    const double S3x_6 = j3x1_6 + j4x1_6;
    const double K2yx_6 = s2_6 * j2u_6 + K3yx_6 + l3y_6 * S3x_6;
    const double t2_6 = n2_6 + qdd[12] * (1.253799e-06 * s2_6 + K3yz_4) + w1zz_6 * K2yx_6;
    tau[13] = t2_6;
    const double R2yx_6 = qd[13] * K2yx_6 + qd[14] * K3yx_6 + t18 * K4yx_6;
    const double w_2y_6 = qd[12] + qd[12];
    const double t21 = c2_6 * j2u_6 + c3_6 * j3u_6 + c4_6 * j4u_6 + o4x_6 * j4x1_6 + l3x_6 * j3x1_6;
    const double t22 = qdd[12] * (t21 + l4x_6 * j4x1_6 + l3x_6 * S3x_6 + 1.1373675000000002e-06);
    const double S2x_6 = j2x1_6 + S3x_6;
    const double a1y_6 = g[9] * s1_6 - g[10] * c1_6;
    const double t23 = t22 + 1.613025e-07 * e4x_6 + 7.0179e-07 * e3x_6 + 1.253799e-06 * e2x_6
        + (a1y_6 + 0.006 * qdd[12]) * S2x_6;
    const double S3y_6 = j3y1_6 + j4y1_6;
    const double R2y_6 = qd[13] * (j2y1_6 + S3y_6) + qd[14] * S3y_6 + t18 * j4y1_6;
    const double N1z_6 = t23 - w_2y_6 * R2yx_6 + 3.105e-05 * a1x_6 + 0.000114 * a1y_6 + 0.006
        * (qdd[12] * S2x_6 - w_2y_6 * R2y_6);
    tau[12] = N1z_6;
    const double a1x_4 = g[6] * c1_4 + g[7] * s1_4;
    const double w1zz_4 = qd[8] * qd[8];
    const double b2x_2 = a1x_4 + 0.00648 * w1zz_4;
    const double w2zz_4 = qd[9] * qd[9];
    const double e2x_4 = qdd[9] * s2_4 + c2_4 * w2zz_4;
    const double a3x_4 = b2x_2 + 0.0436104 * e2x_4;
    const double w3z_4 = qd[9] + qd[10];
    const double w3zz_4 = w3z_4 * w3z_4;
    const double al3z_4 = qdd[9] + qdd[10];
    const double e3x_4 = c3_4 * w3zz_4 + s3_4 * al3z_4;
    const double j4y1_4 = 4.101874214400001e-05 * s4_4;
    const double e3y_4 = c3_4 * al3z_4 - s3_4 * w3zz_4;
    const double a3y_4 = g[8] - 0.0436104 * (qdd[9] * c2_4 - s2_4 * w2zz_4);
    const double j4x1_4 = 4.101874214400001e-05 * c4_4;
    const double al4z_4 = qdd[11] + al3z_4;
    const double n4_4 = 6.27635460330976e-07 * al4z_4 - j4x1_4 * (a3y_4 - 0.032184 * e3y_4) + j4y1_4
        * (a3x_4 + 0.032184 * e3x_4);
    const double j4yz_2 = 2.3700629210803204e-07 * s4_4;
    const double l4x_4 = 0.032184 * c3_4;
    const double l3x_4 = 0.0436104 * c2_4;
    const double o4x_4 = l3x_4 + l4x_4;
    const double j4u_4 = 5.59611012330976e-07 * c4_4;
    const double K4yx_4 = s4_4 * j4u_4 + o4x_4 * j4y1_4;
    tau[11] = n4_4 + qdd[8] * j4yz_2 + w1zz_4 * K4yx_4;
    const double j3x1_4 = 0.000243255426048 * c3_4;
    const double j3y1_4 = 0.000243255426048 * s3_4;
    const double w4z_4 = qd[11] + w3z_4;
    const double w4zz_4 = w4z_4 * w4z_4;
    const double F4y_4 = 4.101874214400001e-05 * (c4_4 * al4z_4 - s4_4 * w4zz_4);
    const double t24 = n4_4 + 6.592134974646623e-06 * al3z_4 - j3x1_4 * a3y_4 + j3y1_4 * a3x_4
        + l4x_4 * F4y_4;
    const double e4x_4 = c4_4 * w4zz_4 + s4_4 * al4z_4;
    const double F4x_4 = 4.101874214400001e-05 * e4x_4;
    const double l4y_4 = 0.032184 * s3_4;
    const double n3_4 = t24 + l4y_4 * F4x_4;
    const double K3yz_2 = 1.031159751017472e-06 * s3_4 + j4yz_2;
    const double j3u_4 = 6.456086078646624e-06 * c3_4;
    const double K3yx_4 = s3_4 * j3u_4 + K4yx_4 + l3x_4 * j3y1_4 + l4y_4 * j4x1_4;
    tau[10] = n3_4 + qdd[8] * K3yz_2 + w1zz_4 * K3yx_4;
    const double j2x1_4 = 0.0007416433467648001 * c2_4;
    const double j2y1_4 = 0.0007416433467648001 * s2_4;
    const double t25 = n3_4 + 2.8851692681126364e-05 * qdd[9] - g[8] * j2x1_4 + b2x_2 * j2y1_4
        + l3x_4 * (F4y_4 + 0.000243255426048 * e3y_4);
    const double l3y_4 = 0.0436104 * s2_4;
    const double n2_4 = t25 + l3y_4 * (F4x_4 + 0.000243255426048 * e3x_4);
    const double j2u_4 = 2.8647619337126362e-05 * c2_4;
    const double S3x_4 = j3x1_4 + j4x1_4;
    const double K2yx_4 = s2_4 * j2u_4 + K3yx_4 + l3y_4 * S3x_4;
    const double t2_4 = n2_4 + qdd[8] * (1.8422420733637633e-06 * s2_4 + K3yz_2) + w1zz_4 * K2yx_4;
    tau[9] = t2_4;
    const double R2yx_4 = qd[9] * K2yx_4 + qd[10] * K3yx_4 + qd[11] * K4yx_4;
    const double w_2y_4 = qd[8] + qd[8];
    const double t26 = c2_4 * j2u_4 + c3_4 * j3u_4 + c4_4 * j4u_4 + o4x_4 * j4x1_4 + l3x_4 * j3x1_4;
    const double t27 = qdd[8] * (t26 + l4x_4 * j4x1_4 + l3x_4 * S3x_4 + 1.599477303123424e-06)
        + 2.3700629210803204e-07 * e4x_4;
    const double S2x_4 = j2x1_4 + S3x_4;
    const double a1y_4 = g[6] * s1_4 - g[7] * c1_4;
    const double t28 = t27 + 1.031159751017472e-06 * e3x_4 + 1.8422420733637633e-06 * e2x_4 + (a1y_4
        + 0.00648 * qdd[8]) * S2x_4;
    const double t29 = t28 - w_2y_4 * R2yx_4 + 4.2243182208000006e-05 * a1x_4 + 0.00015509574144
        * a1y_4;
    const double S3y_4 = j3y1_4 + j4y1_4;
    const double R2y_4 = qd[9] * (j2y1_4 + S3y_4) + qd[10] * S3y_4 + qd[11] * j4y1_4;
    const double N1z_4 = t29 + 0.00648 * (qdd[8] * S2x_4 - w_2y_4 * R2y_4);
    tau[8] = N1z_4;
    const double a1x_2 = g[3] * c1_2 + g[4] * s1_2;
    const double w1zz_2 = qd[4] * qd[4];
    const double b2x = a1x_2 + 0.006 * w1zz_2;
    const double w2zz_2 = qd[5] * qd[5];
    const double e2x_2 = qdd[5] * s2_2 + c2_2 * w2zz_2;
    const double a3x_2 = b2x + 0.04038 * e2x_2;
    const double w3z_2 = qd[5] + qd[6];
    const double w3zz_2 = w3z_2 * w3z_2;
    const double al3z_2 = qdd[5] + qdd[6];
    const double e3x_2 = c3_2 * w3zz_2 + s3_2 * al3z_2;
    const double j4y1_2 = 3.015e-05 * s4_2;
    const double e3y_2 = c3_2 * al3z_2 - s3_2 * w3zz_2;
    const double a3y_2 = g[5] - 0.04038 * (qdd[5] * c2_2 - s2_2 * w2zz_2);
    const double j4x1_2 = 3.015e-05 * c4_2;
    const double al4z_2 = qdd[7] + al3z_2;
    const double n4_2 = 4.3101e-07 * al4z_2 - j4x1_2 * (a3y_2 - 0.0298 * e3y_2) + j4y1_2 * (a3x_2
        + 0.0298 * e3x_2);
    const double j4yz = 1.613025e-07 * s4_2;
    const double l4x_2 = 0.0298 * c3_2;
    const double l3x_2 = 0.04038 * c2_2;
    const double o4x_2 = l3x_2 + l4x_2;
    const double j4u_2 = 3.7701e-07 * c4_2;
    const double K4yx_2 = s4_2 * j4u_2 + o4x_2 * j4y1_2;
    tau[7] = n4_2 + qdd[4] * j4yz + w1zz_2 * K4yx_2;
    const double j3x1_2 = 0.0001788 * c3_2;
    const double j3y1_2 = 0.0001788 * s3_2;
    const double w4z_2 = qd[7] + w3z_2;
    const double w4zz_2 = w4z_2 * w4z_2;
    const double F4y_2 = 3.015e-05 * (c4_2 * al4z_2 - s4_2 * w4zz_2);
    const double t30 = n4_2 + 4.4942e-06 * al3z_2 - j3x1_2 * a3y_2 + j3y1_2 * a3x_2 + l4x_2 * F4y_2;
    const double e4x_2 = c4_2 * w4zz_2 + s4_2 * al4z_2;
    const double F4x_2 = 3.015e-05 * e4x_2;
    const double l4y_2 = 0.0298 * s3_2;
    const double n3_2 = t30 + l4y_2 * F4x_2;
    const double K3yz = 7.0179e-07 * s3_2 + j4yz;
    const double j3u_2 = 4.3862e-06 * c3_2;
    const double K3yx_2 = s3_2 * j3u_2 + K4yx_2 + l3x_2 * j3y1_2 + l4y_2 * j4x1_2;
    tau[6] = n3_2 + qdd[4] * K3yz + w1zz_2 * K3yx_2;
    const double j2x1_2 = 0.00054513 * c2_2;
    const double j2y1_2 = 0.00054513 * s2_2;
    const double t31 = n3_2 + 1.96475328e-05 * qdd[5] - g[5] * j2x1_2 + b2x * j2y1_2 + l3x_2
        * (F4y_2 + 0.0001788 * e3y_2);
    const double l3y_2 = 0.04038 * s2_2;
    const double n2_2 = t31 + l3y_2 * (F4x_2 + 0.0001788 * e3x_2);
    const double j2u_2 = 1.94855328e-05 * c2_2;
    const double S3x_2 = j3x1_2 + j4x1_2;
    const double K2yx_2 = s2_2 * j2u_2 + K3yx_2 + l3y_2 * S3x_2;
    const double t2_2 = n2_2 + qdd[4] * (1.253799e-06 * s2_2 + K3yz) + w1zz_2 * K2yx_2;
    tau[5] = t2_2;
    const double R2yx_2 = qd[5] * K2yx_2 + qd[6] * K3yx_2 + qd[7] * K4yx_2;
    const double w_2y_2 = qd[4] + qd[4];
    const double t32 = c2_2 * j2u_2 + c3_2 * j3u_2 + c4_2 * j4u_2 + o4x_2 * j4x1_2 + l3x_2 * j3x1_2;
    const double t33 = qdd[4] * (t32 + l4x_2 * j4x1_2 + l3x_2 * S3x_2 + 1.1373675000000002e-06)
        + 1.613025e-07 * e4x_2;
    const double S2x_2 = j2x1_2 + S3x_2;
    const double a1y_2 = g[3] * s1_2 - g[4] * c1_2;
    const double t34 = t33 + 7.0179e-07 * e3x_2 + 1.253799e-06 * e2x_2 + (a1y_2 + 0.006 * qdd[4])
        * S2x_2;
    const double S3y_2 = j3y1_2 + j4y1_2;
    const double R2y_2 = qd[5] * (j2y1_2 + S3y_2) + qd[6] * S3y_2 + qd[7] * j4y1_2;
    const double N1z_2 = t34 - w_2y_2 * R2yx_2 + 3.105e-05 * a1x_2 + 0.000114 * a1y_2 + 0.006
        * (qdd[4] * S2x_2 - w_2y_2 * R2y_2);
    tau[4] = N1z_2;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double al3z = qdd[1] + qdd[2];
    const double e3y = c3 * al3z - s3 * w3zz;
    const double w2zz = qd[1] * qd[1];
    const double a3y = g[2] - 0.045 * (qdd[1] * c2 - s2 * w2zz);
    const double j4x1 = 3.015e-05 * c4;
    const double al4z = qdd[3] + al3z;
    const double a1x = g[0] * c1 + g[1] * s1;
    const double a3x = a1x + 0.045 * (qdd[1] * s2 + c2 * w2zz);
    const double e3x = c3 * w3zz + s3 * al3z;
    const double j4y1 = 3.015e-05 * s4;
    const double n4 = 4.3101e-07 * al4z - j4x1 * (a3y - 0.0298 * e3y) + j4y1 * (a3x + 0.0298 * e3x);
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double o4x = l3x + l4x;
    const double j4u = 3.7701e-07 * s4;
    const double K4yx = c4 * j4u + o4x * j4y1;
    const double w1zz = qd[0] * qd[0];
    tau[3] = n4 + w1zz * K4yx;
    const double j3x1 = 0.0001788 * c3;
    const double j3y1 = 0.0001788 * s3;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double F4y = 3.015e-05 * (c4 * al4z - s4 * w4zz);
    const double F4x = 3.015e-05 * (c4 * w4zz + s4 * al4z);
    const double l4y = 0.0298 * s3;
    const double n3 = n4 + 4.4942e-06 * al3z - j3x1 * a3y + j3y1 * a3x + l4x * F4y + l4y * F4x;
    const double j3u = 4.3862e-06 * c3;
    const double K3yx = s3 * j3u + K4yx + l3x * j3y1 + l4y * j4x1;
    tau[2] = n3 + w1zz * K3yx;
    const double j2x1 = 0.0006075 * c2;
    const double t35 = n3 + 2.4381e-05 * qdd[1] - g[2] * j2x1 + a1x * 0.0006075 * s2 + l3x * (F4y
        + 0.0001788 * e3y);
    const double l3y = 0.045 * s2;
    const double j2u = 2.4218999999999996e-05 * c2;
    const double S3x = j3x1 + j4x1;
    const double K2yx = s2 * j2u + K3yx + l3y * S3x;
    const double t2 = t35 + l3y * (F4x + 0.0001788 * e3x) + w1zz * K2yx;
    tau[1] = t2;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double t36 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + l4x * j4x1 + l3x
        * S3x;
    const double N1z = qdd[0] * (t36 + 7.2501e-07) + (g[0] * s1 - g[1] * c1) * (j2x1 + S3x) - (qd[0]
        + qd[0]) * R2yx;
    tau[0] = N1z;
}
