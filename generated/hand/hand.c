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

void hand_fingertips(const double q[SINEW_AT_LEAST(19)], const double q_wrist[SINEW_AT_LEAST(2)],
    double in_palm[SINEW_AT_LEAST(80)], double in_forearm[SINEW_AT_LEAST(80)])
{
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
    const struct sinew_sines2 sines5 = sinew_one_sincos2(q[18], q_wrist[0]);
    const double sin2 = sines5.s[0];
    const double cos2 = sines5.c[0];
    const double sin_q71 = sines5.s[1];
    const double cos_q71 = sines5.c[1];
    const struct sinew_sines sines6 = sinew_one_sincos(q_wrist[1]);
    const double sin_q73 = sines6.s[0];
    const double cos_q73 = sines6.c[0];
    in_palm[66] = s1_8;
    const double l3y_8 = 0.032304 * s2_8;
    const double l4y_8 = 0.02384 * s3_8;
    const double o4y_8 = l3y_8 + l4y_8;
    const double ptipz_8 = o4y_8 + 0.01608 * s4_8;
    const double t7 = 0.01 * cos2;
    const double A = 1.2 - cos2;
    const double reach_squared_2 = sinew_max(sin2 * sin2 + A * A, 1e-12);
    const double t8 = 1.0 / reach_squared_2;
    const double reach_2 = sinew_sqrt(reach_squared_2);
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double limited_2 = sinew_min(sinew_max(C, -reach_2), reach_2);
    const double slack = 0.6944444444444444 * (C + reach_2) * (C - reach_2);
    const double root_2 = sinew_sqrt(sinew_max(-slack, 1e-12));
    const double side = 1.2 * root_2;
    const double cos4 = (sin2 * side - A * limited_2) * t8;
    const double along = 0.012 - t7 + 0.011 * cos4;
    const double t9 = 0.01 * sin2;
    const double sin4 = (sin2 * limited_2 + A * side) * t8;
    const double across = t9 - 0.011 * sin4;
    const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
    const double t10 = 1.0 / length;
    const double cos3 = along * t10;
    const double R42x_8 = s1_8 * c4_8;
    const double l3x_8 = 0.032304 * c2_8;
    const double l4x_8 = 0.02384 * c3_8;
    const double o4x_8 = l3x_8 + l4x_8;
    const double t11 = 0.0048 + o4x_8;
    const double ptipy_8 = s1_8 * t11 + 0.00456 * c1_8 + 0.01608 * R42x_8;
    const double t12 = 0.006 + ptipy_8;
    const double sin3 = across * t10;
    const double placed_58 = sin3 * t12 + 0.01 - t9 - cos3 * ptipz_8;
    const double p_z = 0.036 * cos_q71;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double ratio = 0.003796 / B_to_C0_squared;
    const double C_e = B_e * ratio;
    const double u_e = 23.80952380952381 * (B_e - C_e);
    const double C_y = 0.002 * ratio * (21.0 - 500.0 * B_y);
    const double M_y = 0.5 * (B_y - C_y);
    const double s_y = 0.021 - M_y;
    const double M_e = 0.5 * (B_e + C_e);
    const double s_e = M_e - 0.036 * sin_q71;
    const double u_y = 23.80952380952381 * (B_y + C_y);
    const double p_y = u_e * s_y + u_y * s_e;
    const double reach_squared = sinew_max(p_y * p_y + p_z * p_z, 1.296e-15);
    const double t13 = 1.0 / reach_squared;
    const double reach = sinew_sqrt(reach_squared);
    const double p_x = u_e * s_e - u_y * s_y;
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double limited = sinew_min(sinew_max(-projection, -reach), reach);
    const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
        * reach_squared);
    const double root = sinew_sqrt(clearance);
    const double sin_A = (p_y * root - p_z * limited) * t13;
    const double cos_A = (p_y * limited + p_z * root) * t13;
    const double z_plane_x = u_y * cos_A;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double y_z = sin_q71 * u_e;
    const double placed_50 = 0.027 - cos3 * t12 - t7 - sin3 * ptipz_8;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double R41x_8 = c1_8 * c4_8;
    in_palm[64] = R41x_8;
    const double placed_42 = c1_8 * t11 + 0.065 - 0.00456 * s1_8 + 0.01608 * R41x_8;
    in_palm[67] = placed_42;
    const double x_plane_x = u_y * sin_A;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double seen_118 = origin_z - x_z * placed_42 - y_z * placed_50 - z_z * placed_58;
    in_forearm[75] = seen_118;
    in_forearm[76] = 0.0;
    in_forearm[77] = 0.0;
    in_forearm[78] = 0.0;
    in_forearm[79] = 1.0;
    const double placed_56 = sin3 * c1_8;
    in_palm[74] = placed_56;
    const double placed_48 = cos3 * c1_8;
    const double seen_116 = x_z * s1_8 + y_z * placed_48 - z_z * placed_56;
    in_forearm[74] = -seen_116;
    const double R42y_8 = s1_8 * s4_8;
    const double placed_54 = cos3 * c4_8 + sin3 * R42y_8;
    in_palm[73] = placed_54;
    const double placed_46 = cos3 * R42y_8 - sin3 * c4_8;
    const double R41y_8 = c1_8 * s4_8;
    const double seen_114 = x_z * R41y_8 - y_z * placed_46 + z_z * placed_54;
    in_forearm[73] = seen_114;
    const double placed_52 = cos3 * s4_8 - sin3 * R42x_8;
    in_palm[72] = placed_52;
    const double placed_44 = cos3 * R42x_8 + sin3 * s4_8;
    in_palm[68] = placed_44;
    const double seen_112 = x_z * R41x_8 - y_z * placed_44 - z_z * placed_52;
    in_forearm[72] = -seen_112;
    const double z_plane_y = u_e * cos_A;
    const double x_plane_y = u_e * sin_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double seen_110 = origin_y - u_y * placed_50 - x_plane_y * placed_42 + z_plane_y
        * placed_58;
    in_forearm[71] = seen_110;
    const double seen_108 = u_y * placed_48 + x_plane_y * s1_8 + z_plane_y * placed_56;
    in_forearm[70] = -seen_108;
    const double seen_106 = u_y * placed_46 - x_plane_y * R41y_8 + z_plane_y * placed_54;
    in_forearm[69] = -seen_106;
    const double seen_104 = u_y * placed_44 - x_plane_y * R41x_8 - z_plane_y * placed_52;
    in_forearm[68] = seen_104;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double y_x = cos_q71 * u_e;
    const double M_x = cos_q71 * M_e;
    const double origin_x = M_x - 0.018 * z_x;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double seen_102 = origin_x + x_x * placed_42 - y_x * placed_50 - z_x * placed_58;
    in_forearm[67] = seen_102;
    const double seen_100 = x_x * s1_8 - y_x * placed_48 + z_x * placed_56;
    in_forearm[66] = seen_100;
    const double seen_98 = x_x * R41y_8 + y_x * placed_46 - z_x * placed_54;
    in_forearm[65] = -seen_98;
    const double seen_96 = x_x * R41x_8 + y_x * placed_44 + z_x * placed_52;
    in_forearm[64] = seen_96;
    const double l3y = 0.045 * s2;
    const double l4y = 0.0298 * s3;
    const double o4y = l3y + l4y;
    const double ptipz = o4y + 0.0201 * s4;
    const double R42y = s1 * c4;
    const double l3x = 0.045 * c2;
    const double l4x = 0.0298 * c3;
    const double o4x = l3x + l4x;
    const double p4y = s1 * o4x;
    const double ptipy = p4y + 0.0201 * R42y;
    const double placed_22 = 0.01 - 0.5000000000000001 * ptipz + 0.8660254037844386 * ptipy;
    const double R41y = c1 * c4;
    const double p4x = c1 * o4x;
    const double ptipx = p4x + 0.0201 * R41y;
    const double placed_14 = 0.03 + 0.3830222215594891 * ptipy + 0.6427876096865393 * ptipx
        + 0.6634139481689384 * ptipz;
    in_palm[7] = placed_14;
    const double placed_6 = 0.01 - 0.32139380484326974 * ptipy - 0.5566703992264193 * ptipz
        + 0.766044443118978 * ptipx;
    in_palm[3] = placed_6;
    const double seen_22 = origin_z - x_z * placed_6 + y_z * placed_14 - z_z * placed_22;
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
    const double seen_20 = x_z * placed_4 + y_z * placed_12 - z_z * placed_20;
    in_forearm[10] = -seen_20;
    const double placed_18 = 0.8660254037844386 * c1;
    const double placed_10 = 0.3830222215594891 * c1 - 0.6427876096865393 * s1;
    in_palm[5] = placed_10;
    const double placed_2 = 0.32139380484326974 * c1 + 0.766044443118978 * s1;
    const double seen_18 = x_z * placed_2 + y_z * placed_10 - z_z * placed_18;
    in_forearm[9] = seen_18;
    const double placed_16 = 0.5000000000000001 * s4 - 0.8660254037844386 * R42y;
    in_palm[8] = placed_16;
    const double placed_8 = 0.3830222215594891 * R42y + 0.6427876096865393 * R41y
        + 0.6634139481689384 * s4;
    in_palm[4] = placed_8;
    const double placed = 0.32139380484326974 * R42y + 0.5566703992264193 * s4 - 0.766044443118978
        * R41y;
    const double seen_16 = x_z * placed + y_z * placed_8 + z_z * placed_16;
    in_forearm[8] = seen_16;
    const double seen_14 = origin_y + u_y * placed_14 - x_plane_y * placed_6 + z_plane_y
        * placed_22;
    in_forearm[7] = seen_14;
    const double seen_12 = u_y * placed_12 + x_plane_y * placed_4 + z_plane_y * placed_20;
    in_forearm[6] = -seen_12;
    const double seen_10 = u_y * placed_10 + x_plane_y * placed_2 + z_plane_y * placed_18;
    in_forearm[5] = seen_10;
    const double seen_8 = u_y * placed_8 + x_plane_y * placed - z_plane_y * placed_16;
    in_forearm[4] = seen_8;
    const double seen_6 = origin_x + x_x * placed_6 + y_x * placed_14 - z_x * placed_22;
    in_forearm[3] = seen_6;
    const double seen_4 = x_x * placed_4 - y_x * placed_12 + z_x * placed_20;
    in_forearm[2] = seen_4;
    const double seen_2 = x_x * placed_2 - y_x * placed_10 + z_x * placed_18;
    in_forearm[1] = -seen_2;
    const double seen = x_x * placed - y_x * placed_8 - z_x * placed_16;
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
    static const double table15[3][11] = {
        {1.0, 0.006, 0.04038, 0.0298, 0.07, 0.0057, 0.0201, 1.0, 0.021, 0.0057, 0.0201},
        {1.0, 0.00648, 0.0436104, 0.032184, 0.072, 0.006156, 0.021708, 1.0, 0.007, 0.006156,
            0.021708},
        {1.2222222222222223, 0.006, 0.04038, 0.0298, 0.07, 0.0057, 0.0201, -1.0, 0.007, -0.0057,
            -0.0201}};
    static const unsigned short element16[3] = {7, 11, 14};
    for (int i14 = 0; i14 < 3; ++i14) {
        const struct sinew_sines sines17 = sinew_one_sincos(q[4 + 4 * i14]);
        const double s1_2 = sines17.s[0];
        const double c1_2 = sines17.c[0];
        const double phi3_2 = q[5 + 4 * i14] + q[6 + 4 * i14];
        const double phi4_2 = table15[i14][0] * q[element16[i14]] + phi3_2;
        const struct sinew_sines sines18 = sinew_one_sincos(phi4_2);
        const double s4_2 = sines18.s[0];
        const double c4_2 = sines18.c[0];
        const double R41x_2 = c1_2 * c4_2;
        const double R42x_2 = s1_2 * c4_2;
        const double seen_3 = x_x * R41x_2 + y_x * R42x_2 + z_x * s4_2;
        const double R41y_2 = c1_2 * s4_2;
        const double R42y_2 = s1_2 * s4_2;
        const double seen_5 = x_x * R41y_2 + y_x * R42y_2 - z_x * c4_2;
        const double seen_7 = x_x * s1_2 - y_x * c1_2;
        const struct sinew_sines sines19 = sinew_one_sincos(q[5 + 4 * i14]);
        const double s2_2 = sines19.s[0];
        const double c2_2 = sines19.c[0];
        const struct sinew_sines sines20 = sinew_one_sincos(phi3_2);
        const double s3_2 = sines20.s[0];
        const double c3_2 = sines20.c[0];
        const double o4x_2 = table15[i14][2] * c2_2 + table15[i14][3] * c3_2;
        const double t21 = table15[i14][1] + o4x_2;
        const double placed_3 = c1_2 * t21 + table15[i14][4] - table15[i14][5] * s1_2
            + table15[i14][6] * R41x_2;
        const double t22 = table15[i14][7] * (s1_2 * t21) + table15[i14][8] + table15[i14][9]
            * c1_2;
        const double placed_5 = t22 + table15[i14][10] * R42x_2;
        const double o4y_2 = table15[i14][2] * s2_2 + table15[i14][3] * s3_2;
        const double ptipz_2 = o4y_2 + table15[i14][6] * s4_2;
        const double seen_9 = origin_x + x_x * placed_3 + table15[i14][7] * (y_x * placed_5) + z_x
            * ptipz_2;
        const double seen_11 = u_y * R42x_2 - x_plane_y * R41x_2 - z_plane_y * s4_2;
        const double seen_13 = u_y * R42y_2 - x_plane_y * R41y_2 + z_plane_y * c4_2;
        const double seen_15 = u_y * c1_2 + x_plane_y * s1_2;
        const double seen_17 = origin_y + table15[i14][7] * (u_y * placed_5) - x_plane_y * placed_3
            - z_plane_y * ptipz_2;
        const double seen_19 = x_z * R41x_2 - y_z * R42x_2 - z_z * s4_2;
        const double seen_21 = x_z * R41y_2 - y_z * R42y_2 + z_z * c4_2;
        const double seen_23 = x_z * s1_2 + y_z * c1_2;
        const double seen_24 = origin_z - x_z * placed_3 + table15[i14][7] * (y_z * placed_5) + z_z
            * ptipz_2;
        in_forearm[12 + 16 * i14] = 0.0;
        in_forearm[13 + 16 * i14] = 0.0;
        in_forearm[14 + 16 * i14] = 0.0;
        in_forearm[15 + 16 * i14] = 1.0;
        in_forearm[16 + 16 * i14] = seen_3;
        in_forearm[17 + 16 * i14] = -seen_5;
        in_forearm[18 + 16 * i14] = seen_7;
        in_forearm[19 + 16 * i14] = seen_9;
        in_forearm[20 + 16 * i14] = seen_11;
        in_forearm[21 + 16 * i14] = -seen_13;
        in_forearm[22 + 16 * i14] = -seen_15;
        in_forearm[23 + 16 * i14] = seen_17;
        in_forearm[24 + 16 * i14] = -seen_19;
        in_forearm[25 + 16 * i14] = seen_21;
        in_forearm[26 + 16 * i14] = -seen_23;
        in_forearm[27 + 16 * i14] = seen_24;
        in_palm[12 + 16 * i14] = 0.0;
        in_palm[13 + 16 * i14] = 0.0;
        in_palm[14 + 16 * i14] = 0.0;
        in_palm[15 + 16 * i14] = 1.0;
        in_palm[16 + 16 * i14] = R41x_2;
        in_palm[17 + 16 * i14] = -R41y_2;
        in_palm[18 + 16 * i14] = s1_2;
        in_palm[19 + 16 * i14] = placed_3;
        in_palm[20 + 16 * i14] = R42x_2;
        in_palm[21 + 16 * i14] = -R42y_2;
        in_palm[22 + 16 * i14] = -c1_2;
        in_palm[23 + 16 * i14] = table15[i14][7] * placed_5;
        in_palm[24 + 16 * i14] = s4_2;
        in_palm[25 + 16 * i14] = c4_2;
        in_palm[26 + 16 * i14] = 0.0;
        in_palm[27 + 16 * i14] = ptipz_2;
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
    const double t3 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t3;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t3;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double t4 = gravity[1] * u_e;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double turned = gravity[0] * x_x - t4 * sin_A - gravity[2] * x_z;
    const double turned_2 = u_e * (gravity[0] * cos_q71 + gravity[2] * sin_q71) + gravity[1] * u_y;
    const double turned_6 = 0.6427876096865393 * turned_2 + 0.766044443118978 * turned;
    const double z_plane_x = u_y * cos_A;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double turned_4 = gravity[0] * z_x - t4 * cos_A + gravity[2] * z_z;
    const double turned_8 = 0.32139380484326974 * turned - 0.3830222215594891 * turned_2
        + 0.8660254037844386 * turned_4;
    const double turned_10 = 0.5000000000000001 * turned_4 - 0.5566703992264193 * turned
        + 0.6634139481689384 * turned_2;
    const double A = 1.2 - cos2;
    const double reach_squared_2 = sinew_max(sin2 * sin2 + A * A, 1e-12);
    const double reach_2 = sinew_sqrt(reach_squared_2);
    const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
    const double slack = 0.6944444444444444 * (C + reach_2) * (C - reach_2);
    const double root_2 = sinew_sqrt(sinew_max(-slack, 1e-12));
    const double side = 1.2 * root_2;
    const double limited_2 = sinew_min(sinew_max(C, -reach_2), reach_2);
    const double t5 = 1.0 / reach_squared_2;
    const double cos4 = (sin2 * side - A * limited_2) * t5;
    const double along = 0.012 - 0.01 * cos2 + 0.011 * cos4;
    const double sin4 = (sin2 * limited_2 + A * side) * t5;
    const double across = 0.01 * sin2 - 0.011 * sin4;
    const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
    const double t6 = 1.0 / length;
    const double sin3 = across * t6;
    const double cos3 = along * t6;
    const double turned_12 = cos3 * turned_2 - sin3 * turned_4;
    const double turned_14 = cos3 * turned_4 + sin3 * turned_2;
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
    g[13] = turned_12;
    g[14] = turned_14;
}

void hand_tendon_lengths(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], double h[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines2.s[0];
    const double cos_q71 = sines2.c[0];
    const double sin_q73 = sines2.s[1];
    const double cos_q73 = sines2.c[1];
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
    const double t3 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - p_z * limited) * t3;
    const double x_plane_x = u_y * sin_A;
    const double cos_A = (p_y * limited + p_z * root) * t3;
    const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
    const double M_x = cos_q71 * M_e;
    const double z_plane_x = u_y * cos_A;
    const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
    const double t4 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t5 = 0.01 * z_x;
    const double layer_0_x = t4 - t5;
    const double y_x = cos_q71 * u_e;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t6 = origin_y + 0.004 * u_e * sin_A;
    const double t7 = 0.01 * z_plane_y;
    const double layer_0_y = t6 - t7;
    const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
    const double t8 = 0.004 * x_z;
    const double t9 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t8 - t9;
    const double y_z = sin_q71 * u_e;
    const double layer_1_x = t4 + t5;
    const double layer_1_y = t6 + t7;
    const double layer_1_z = 0.028 - origin_z - t8 + t9;
    static const double table13[18][4] = {{0.011, 0.007, 0.013, 0.006},
        {0.01, 0.008, 0.011, 0.007}, {0.008, 0.01, 0.01, 0.009}, {0.006, 0.011, 0.008, 0.011},
        {0.005, 0.013, 0.006, 0.012}, {0.003, 0.015, 0.005, 0.014},
        {0.002, 0.016, 0.003, 0.015}, {-0.002, 0.019, 0.002, 0.017},
        {-0.003, 0.021, -0.002, 0.02}, {-0.005, 0.023, -0.003, 0.022},
        {-0.006, 0.024, -0.005, 0.023}, {-0.008, 0.026, -0.006, 0.025},
        {-0.01, 0.027, -0.008, 0.027}, {-0.011, 0.029, -0.01, 0.028},
        {-0.013, 0.031, -0.011, 0.03}, {-0.014, 0.032, -0.013, 0.031},
        {-0.016, 0.034, -0.014, 0.033}, {-0.018, 0.035, -0.016, 0.035}};
    double kept11[18];
    double kept12[18];
    for (int i10 = 0; i10 < 18; ++i10) {
        const double strand_x = layer_0_x + table13[i10][0] * y_x;
        const double strand_y = table13[i10][1] - layer_0_y + table13[i10][0] * u_y;
        const double strand_z = layer_0_z + table13[i10][0] * y_z;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double strand_x_2 = layer_1_x + table13[i10][2] * y_x;
        const double strand_y_2 = table13[i10][3] - layer_1_y + table13[i10][2] * u_y;
        const double strand_z_2 = layer_1_z + table13[i10][2] * y_z;
        const double t14 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t14);
        kept11[i10] = length;
        kept12[i10] = length_2;
    }
    const double R21y = c1 * s2;
    const double t15 = 0.005 * R21y;
    const double t16 = 0.006 * s1;
    const double t17 = t15 - t16;
    const double R21x = c1 * c2;
    const double t18 = 0.047 * R21x;
    const double A_lengthdx = 0.002 - t17 - t18;
    const double R22y = s1 * s2;
    const double t19 = 0.005 * R22y;
    const double t20 = 0.006 * c1;
    const double t21 = 0.03 - (t19 + t20);
    const double R22x = s1 * c2;
    const double t22 = 0.047 * R22x;
    const double A_lengthdy = t21 - t22;
    const double t23 = 0.025 - 0.005 * c2;
    const double t24 = 0.047 * s2;
    const double A_lengthdz = t23 + t24;
    const double t25 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t25);
    h[0] = A_length + kept11[0];
    const double t26 = t15 + t16;
    const double B_lengthdx = 0.002 + t26 - t18;
    const double t27 = 0.03 + (t19 - t20);
    const double B_lengthdy = t27 - t22;
    const double B_lengthdz = t23 - t24;
    const double t28 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t28);
    h[1] = B_length + kept11[1];
    const double C_lengthdx = 0.002 - t26 - t18;
    const double C_lengthdy = t27 + t22;
    const double C_length = sinew_sqrt(t25 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    h[2] = C_length + kept11[2];
    const double D_lengthdx = 0.002 + t17 - t18;
    const double D_lengthdy = t21 + t22;
    const double D_length = sinew_sqrt(t28 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    h[3] = D_length + kept11[3];
    const double t29 = 0.0065 * q[2];
    h[4] = kept11[4] + t29;
    h[5] = kept11[5] - t29;
    const double t30 = 0.0055 * q[3];
    h[6] = kept11[6] + t30 - t29;
    const double strand_7_y = 0.018 - layer_0_y;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    h[7] = length_7 - t30 + t29;
    const double t31 = 0.0065 * q[4];
    const double t32 = 0.0065 * q[5];
    h[8] = kept11[7] + t31 + t32;
    h[9] = kept11[8] + t31 - t32;
    h[10] = kept11[9] - t31 + t32;
    h[11] = kept11[10] - t31 - t32;
    const double t33 = 0.0055 * q[6];
    h[12] = kept11[11] + t33;
    h[13] = kept11[12] - t33;
    const double t34 = 0.0045 * q[7];
    h[14] = kept11[13] - t34 + t33;
    h[15] = kept11[14] + t34 - t33;
    const double t35 = 0.0065 * q[8];
    const double t36 = 0.0065 * q[9];
    h[16] = kept11[15] + t35 + t36;
    h[17] = kept11[16] + t35 - t36;
    h[18] = kept11[17] - t35 + t36;
    h[19] = kept12[0] - t35 - t36;
    const double t37 = 0.0055 * q[10];
    h[20] = kept12[1] + t37;
    h[21] = kept12[2] - t37;
    const double t38 = 0.0045 * q[11];
    h[22] = kept12[3] - t38 + t37;
    h[23] = kept12[4] + t38 - t37;
    const double t39 = 0.0065 * q[12];
    const double t40 = 0.0065 * q[13];
    h[24] = kept12[5] + t39 + t40;
    h[25] = kept12[6] + t39 - t40;
    h[26] = kept12[7] - t39 + t40;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t41 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t41);
    h[27] = length_27 - t39 - t40;
    const double t42 = 0.011000000000000001 * q[14];
    h[28] = kept12[8] + t42;
    h[29] = kept12[9] - t42;
    const double t43 = 0.0052 * q[15];
    const double t44 = 0.0052 * q[16];
    h[30] = kept12[10] + t43 + t44;
    h[31] = kept12[11] + t43 - t44;
    h[32] = kept12[12] - t43 + t44;
    h[33] = kept12[13] - t43 - t44;
    const double t45 = 0.0088 * q[17];
    h[34] = kept12[14] + t45;
    h[35] = kept12[15] - t45;
    const double length_3 = 0.007853981633974483 - 0.005 * q[18];
    h[36] = -(length_3 - kept12[16]);
    h[37] = length_3 + kept12[17];
}

void hand_coupling_matrix(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], double P[SINEW_AT_LEAST(798)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines2.s[0];
    const double cos_q71 = sines2.c[0];
    const double sin_q73 = sines2.s[1];
    const double cos_q73 = sines2.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double t3 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t3;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t3;
    const double t4 = 21.0 - 500.0 * B_y;
    const double C_e = B_e * ratio;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t4;
    const double t5 = 0.5 * B_e;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t6 = 23.80952380952381 * B_e;
    const double u_e = t6 - 23.80952380952381 * C_e;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double t7 = 0.5 * B_y;
    const double M_e_by_q73 = t7 - 0.5 * C_e_by_q73;
    const double C_y = 0.002 * ratio * t4;
    const double t8 = 23.80952380952381 * B_y;
    const double u_y = t8 + 23.80952380952381 * C_y;
    const double u_y_by_q73 = t6 - 23.80952380952381 * C_y_by_q73;
    const double M_e = t5 + 0.5 * C_e;
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
    const double limited = sinew_min(t18, reach);
    const double t20 = limited + limited;
    const double t21 = reach + reach;
    const double t22 = (reach + limited) * (reach - limited);
    const double t23 = 1e-12 * reach_squared;
    const double t24 = -(t23 - t22);
    const double clearance_by_q73 = sinew_choose(t24, t21 * reach_by_q73 - t20 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double clearance = sinew_max(t22, t23);
    const double root = sinew_sqrt(clearance);
    const double t25 = 1.0 / root;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t25;
    const double t26 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t26;
    const double t27 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t27 * t26;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double sin_A = (p_y * root - p_z * limited) * t26;
    const double t28 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t28 * t26;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t29 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t30 = 0.01 * z_x_by_q73;
    const double layer_1_x_by_q73 = t29 - t30;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double x_plane_x = u_y * sin_A;
    const double t31 = cos_q71 * x_plane_x;
    const double t32 = sin_q71 * cos_A;
    const double x_x = t31 + t32;
    const double M_x = cos_q71 * M_e;
    const double z_plane_x = u_y * cos_A;
    const double t33 = cos_q71 * z_plane_x;
    const double t34 = sin_q71 * sin_A;
    const double z_x = t33 - t34;
    const double t35 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t36 = 0.01 * z_x;
    const double layer_1_x = t35 + t36;
    const double y_x = cos_q71 * u_e;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t37 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t38 = 0.01 * z_plane_y_by_q73;
    const double layer_1_y_by_q73 = t37 - t38;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t39 = 0.004 * u_e;
    const double t40 = origin_y + t39 * sin_A;
    const double t41 = 0.01 * z_plane_y;
    const double layer_1_y = t40 + t41;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t42 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t43 = 0.01 * z_z_by_q73;
    const double layer_1_z_by_q73 = t42 - t43;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t44 = sin_q71 * z_plane_x;
    const double t45 = cos_q71 * sin_A;
    const double z_z = t45 + t44;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t46 = sin_q71 * x_plane_x;
    const double t47 = cos_q71 * cos_A;
    const double x_z = t47 - t46;
    const double t48 = 0.004 * x_z;
    const double t49 = 0.01 * z_z;
    const double layer_1_z = 0.028 - origin_z - t48 + t49;
    const double y_z = sin_q71 * u_e;
    const double p_y_by_q71 = u_y * p_z;
    const double reach_squared_by_q71 = sinew_choose(t12, -(t9 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t16;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t13 * u_e * p_z;
    const double limited_by_q71 = sinew_choose(t19, -(reach_by_q71 * t17 - projection_by_q71 * t15),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t24, t21 * reach_by_q71 - t20 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t25;
    const double t50 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t50 - cos_A * reach_squared_by_q71) * t26;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double t51 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t51 - sin_A * reach_squared_by_q71) * t26;
    const double z_x_by_q71 = t45 - cos_q71 * z_plane_x_by_q71 + t44 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t47 + cos_q71 * x_plane_x_by_q71 - t46 + sin_q71 * cos_A_by_q71;
    const double t52 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t53 = 0.01 * z_x_by_q71;
    const double layer_1_x_by_q71 = t52 - t53;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t54 = origin_y_by_q71 + t39 * sin_A_by_q71;
    const double t55 = 0.01 * z_plane_y_by_q71;
    const double layer_1_y_by_q71 = t54 + t55;
    const double z_z_by_q71 = t33 + cos_q71 * sin_A_by_q71 - t34 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t31 - cos_q71 * cos_A_by_q71 + t32 + sin_q71 * x_plane_x_by_q71;
    const double t56 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t57 = 0.01 * z_z_by_q71;
    const double layer_1_z_by_q71 = t56 - t57;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t58 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double t59 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t59);
    const double t60 = 1.0 / length_27;
    const double length_27_by_q73 = t58 * t60;
    P[587] = -length_27_by_q73;
    const double t61 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double length_27_by_q71 = t61 * t60;
    P[586] = length_27_by_q71;
    const double layer_0_x_by_q73 = t29 + t30;
    const double layer_0_x = t35 - t36;
    const double layer_0_y_by_q73 = t37 + t38;
    const double layer_0_y = t40 - t41;
    const double layer_0_z_by_q73 = t42 + t43;
    const double layer_0_z = 0.008 - origin_z - t48 - t49;
    const double layer_0_x_by_q71 = t52 + t53;
    const double layer_0_y_by_q71 = t54 - t55;
    const double layer_0_z_by_q71 = t56 + t57;
    const double strand_7_y = 0.018 - layer_0_y;
    const double t62 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t63 = 1.0 / length_7;
    const double length_7_by_q73 = t62 * t63;
    P[167] = -length_7_by_q73;
    P[567] = 0.0;
    P[568] = 0.0;
    P[569] = 0.0;
    P[570] = 0.0;
    P[571] = 0.0;
    P[572] = 0.0;
    P[573] = 0.0;
    P[574] = 0.0;
    P[575] = 0.0;
    P[576] = 0.0;
    P[577] = 0.0;
    P[578] = 0.0;
    P[579] = -0.0065;
    P[580] = -0.0065;
    P[581] = 0.0;
    P[582] = 0.0;
    P[583] = 0.0;
    P[584] = 0.0;
    P[585] = 0.0;
    const double t64 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7_by_q71 = t64 * t63;
    P[166] = length_7_by_q71;
    const double R21y = c1 * s2;
    const double t65 = 0.005 * R21y;
    const double t66 = 0.006 * s1;
    const double t67 = t65 - t66;
    const double R21x = c1 * c2;
    const double t68 = 0.047 * R21x;
    const double pD_length_tox = t67 - t68;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double t69 = 0.025 - 0.005 * c2;
    const double t70 = 0.047 * s2;
    const double B_lengthdz = t69 - t70;
    const double t71 = B_lengthdz * B_lengthdz;
    const double R22y = s1 * s2;
    const double t72 = 0.005 * R22y;
    const double t73 = 0.006 * c1;
    const double t74 = t72 + t73;
    const double R22x = s1 * c2;
    const double t75 = 0.047 * R22x;
    const double pD_length_toy = t74 - t75;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_length = sinew_sqrt(t71 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t76 = 1.0 / D_length;
    const double t77 = 0.005 * R21x;
    const double t78 = 0.047 * R21y;
    const double pB_length_tox_by_q_1 = t77 + t78;
    const double t79 = 0.005 * s2;
    const double t80 = 0.047 * c2;
    const double pB_length_toz_by_q_1 = t79 - t80;
    const double t81 = B_lengthdz * pB_length_toz_by_q_1;
    const double t82 = 0.005 * R22x;
    const double t83 = 0.047 * R22y;
    const double pB_length_toy_by_q_1 = t82 + t83;
    const double t84 = t81 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy * pB_length_toy_by_q_1;
    const double D_length_by_q_1 = t84 * t76;
    P[64] = D_length_by_q_1;
    P[65] = 0.0;
    P[66] = 0.0;
    P[67] = 0.0;
    P[68] = 0.0;
    P[69] = 0.0;
    P[70] = 0.0;
    P[71] = 0.0;
    P[72] = 0.0;
    P[73] = 0.0;
    P[74] = 0.0;
    P[75] = 0.0;
    P[76] = 0.0;
    P[77] = 0.0;
    P[78] = 0.0;
    P[79] = 0.0;
    P[80] = 0.0;
    P[81] = 0.0;
    P[84] = 0.0;
    P[85] = 0.0;
    P[86] = 0.0065;
    P[87] = 0.0;
    P[88] = 0.0;
    P[89] = 0.0;
    P[90] = 0.0;
    P[91] = 0.0;
    P[92] = 0.0;
    P[93] = 0.0;
    P[94] = 0.0;
    P[95] = 0.0;
    P[96] = 0.0;
    P[97] = 0.0;
    P[98] = 0.0;
    P[99] = 0.0;
    P[100] = 0.0;
    P[101] = 0.0;
    P[102] = 0.0;
    P[105] = 0.0;
    P[106] = 0.0;
    P[107] = -0.0065;
    P[108] = 0.0;
    P[109] = 0.0;
    P[110] = 0.0;
    P[111] = 0.0;
    P[112] = 0.0;
    P[113] = 0.0;
    P[114] = 0.0;
    P[115] = 0.0;
    P[116] = 0.0;
    P[117] = 0.0;
    P[118] = 0.0;
    P[119] = 0.0;
    P[120] = 0.0;
    P[121] = 0.0;
    P[122] = 0.0;
    P[123] = 0.0;
    P[126] = 0.0;
    P[127] = 0.0;
    P[128] = -0.0065;
    P[129] = 0.0055;
    P[130] = 0.0;
    P[131] = 0.0;
    P[132] = 0.0;
    P[133] = 0.0;
    P[134] = 0.0;
    P[135] = 0.0;
    P[136] = 0.0;
    P[137] = 0.0;
    P[138] = 0.0;
    P[139] = 0.0;
    P[140] = 0.0;
    P[141] = 0.0;
    P[142] = 0.0;
    P[143] = 0.0;
    P[144] = 0.0;
    P[147] = 0.0;
    P[148] = 0.0;
    P[149] = 0.0065;
    P[150] = -0.0055;
    P[151] = 0.0;
    P[152] = 0.0;
    P[153] = 0.0;
    P[154] = 0.0;
    P[155] = 0.0;
    P[156] = 0.0;
    P[157] = 0.0;
    P[158] = 0.0;
    P[159] = 0.0;
    P[160] = 0.0;
    P[161] = 0.0;
    P[162] = 0.0;
    P[163] = 0.0;
    P[164] = 0.0;
    P[165] = 0.0;
    const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t76;
    P[63] = -D_length_by_q_0;
    const double t85 = t65 + t66;
    const double pC_length_tox = t85 + t68;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double A_lengthdz = t69 + t70;
    const double t86 = A_lengthdz * A_lengthdz;
    const double t87 = t72 - t73;
    const double pC_length_toy = t87 + t75;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_length = sinew_sqrt(t86 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t88 = 1.0 / C_length;
    const double pA_length_tox_by_q_1 = t77 - t78;
    const double pA_length_toz_by_q_1 = t79 + t80;
    const double t89 = A_lengthdz * pA_length_toz_by_q_1;
    const double pA_length_toy_by_q_1 = t82 - t83;
    const double t90 = t89 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy * pA_length_toy_by_q_1;
    const double C_length_by_q_1 = t90 * t88;
    P[43] = C_length_by_q_1;
    P[44] = 0.0;
    P[45] = 0.0;
    P[46] = 0.0;
    P[47] = 0.0;
    P[48] = 0.0;
    P[49] = 0.0;
    P[50] = 0.0;
    P[51] = 0.0;
    P[52] = 0.0;
    P[53] = 0.0;
    P[54] = 0.0;
    P[55] = 0.0;
    P[56] = 0.0;
    P[57] = 0.0;
    P[58] = 0.0;
    P[59] = 0.0;
    P[60] = 0.0;
    const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t88;
    P[42] = C_length_by_q_0;
    const double pB_length_tox = t85 - t68;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double pB_length_toy = t87 - t75;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t71);
    const double t91 = 1.0 / B_length;
    const double t92 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1 + t81;
    const double B_length_by_q_1 = t92 * t91;
    P[22] = B_length_by_q_1;
    P[23] = 0.0;
    P[24] = 0.0;
    P[25] = 0.0;
    P[26] = 0.0;
    P[27] = 0.0;
    P[28] = 0.0;
    P[29] = 0.0;
    P[30] = 0.0;
    P[31] = 0.0;
    P[32] = 0.0;
    P[33] = 0.0;
    P[34] = 0.0;
    P[35] = 0.0;
    P[36] = 0.0;
    P[37] = 0.0;
    P[38] = 0.0;
    P[39] = 0.0;
    const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t91;
    P[21] = B_length_by_q_0;
    const double pA_length_tox = t67 + t68;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double pA_length_toy = t74 + t75;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t86);
    const double t93 = 1.0 / A_length;
    const double t94 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1 - t89;
    const double A_length_by_q_1 = t94 * t93;
    P[1] = -A_length_by_q_1;
    P[2] = 0.0;
    P[3] = 0.0;
    P[4] = 0.0;
    P[5] = 0.0;
    P[6] = 0.0;
    P[7] = 0.0;
    P[8] = 0.0;
    P[9] = 0.0;
    P[10] = 0.0;
    P[11] = 0.0;
    P[12] = 0.0;
    P[13] = 0.0;
    P[14] = 0.0;
    P[15] = 0.0;
    P[16] = 0.0;
    P[17] = 0.0;
    P[18] = 0.0;
    const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t93;
    P[0] = -A_length_by_q_0;
    static const double table96[11][8] = {{0.0065, 0.0065, 0.0, 0.0, 0.0, 0.0, 0.002, 0.019},
        {0.0065, -0.0065, 0.0, 0.0, 0.0, 0.0, 0.003, 0.021},
        {-0.0065, 0.0065, 0.0, 0.0, 0.0, 0.0, 0.005, 0.023},
        {-0.0065, -0.0065, 0.0, 0.0, 0.0, 0.0, 0.006, 0.024},
        {0.0, 0.0, 0.0055, 0.0, 0.0, 0.0, 0.008, 0.026},
        {0.0, 0.0, -0.0055, 0.0, 0.0, 0.0, 0.01, 0.027},
        {0.0, 0.0, 0.0055, -0.0045, 0.0, 0.0, 0.011, 0.029},
        {0.0, 0.0, -0.0055, 0.0045, 0.0, 0.0, 0.013, 0.031},
        {0.0, 0.0, 0.0, 0.0, 0.0065, 0.0065, 0.014, 0.032},
        {0.0, 0.0, 0.0, 0.0, 0.0065, -0.0065, 0.016, 0.034},
        {0.0, 0.0, 0.0, 0.0, -0.0065, 0.0065, 0.018, 0.035}};
    for (int i95 = 0; i95 < 11; ++i95) {
        const double t97 = table96[i95][6] * y_x;
        const double strand_x = layer_0_x - t97;
        const double t98 = table96[i95][6] * y_z;
        const double strand_x_by_q71 = layer_0_x_by_q71 + t98;
        const double strand_y = table96[i95][7] - layer_0_y - table96[i95][6] * u_y;
        const double strand_z = layer_0_z - t98;
        const double strand_z_by_q71 = layer_0_z_by_q71 + t97;
        const double t99 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t100 = 1.0 / length;
        const double length_by_q71 = t99 * t100;
        const double strand_x_by_q73 = layer_0_x_by_q73 + table96[i95][6] * y_x_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 + table96[i95][6] * u_y_by_q73;
        const double strand_z_by_q73 = layer_0_z_by_q73 + table96[i95][6] * y_z_by_q73;
        const double t101 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t101 * t100;
        P[168 + 21 * i95] = 0.0;
        P[169 + 21 * i95] = 0.0;
        P[170 + 21 * i95] = 0.0;
        P[171 + 21 * i95] = 0.0;
        P[172 + 21 * i95] = table96[i95][0];
        P[173 + 21 * i95] = table96[i95][1];
        P[174 + 21 * i95] = table96[i95][2];
        P[175 + 21 * i95] = table96[i95][3];
        P[176 + 21 * i95] = table96[i95][4];
        P[177 + 21 * i95] = table96[i95][5];
        P[178 + 21 * i95] = 0.0;
        P[179 + 21 * i95] = 0.0;
        P[180 + 21 * i95] = 0.0;
        P[181 + 21 * i95] = 0.0;
        P[182 + 21 * i95] = 0.0;
        P[183 + 21 * i95] = 0.0;
        P[184 + 21 * i95] = 0.0;
        P[185 + 21 * i95] = 0.0;
        P[186 + 21 * i95] = 0.0;
        P[187 + 21 * i95] = length_by_q71;
        P[188 + 21 * i95] = -length_by_q73;
    }
    static const double table103[10][7] = {
        {0.011000000000000001, 0.0, 0.0, 0.0, 0.0, 0.002, 0.02},
        {-0.011000000000000001, 0.0, 0.0, 0.0, 0.0, 0.003, 0.022},
        {0.0, 0.0052, 0.0052, 0.0, 0.0, 0.005, 0.023},
        {0.0, 0.0052, -0.0052, 0.0, 0.0, 0.006, 0.025},
        {0.0, -0.0052, 0.0052, 0.0, 0.0, 0.008, 0.027},
        {0.0, -0.0052, -0.0052, 0.0, 0.0, 0.01, 0.028},
        {0.0, 0.0, 0.0, 0.0088, 0.0, 0.011, 0.03}, {0.0, 0.0, 0.0, -0.0088, 0.0, 0.013, 0.031},
        {0.0, 0.0, 0.0, 0.0, 0.005, 0.014, 0.033}, {0.0, 0.0, 0.0, 0.0, -0.005, 0.016, 0.035}};
    for (int i102 = 0; i102 < 10; ++i102) {
        const double t104 = table103[i102][5] * y_x;
        const double strand_x_2 = layer_1_x - t104;
        const double t105 = table103[i102][5] * y_z;
        const double strand_x_by_q71_2 = layer_1_x_by_q71 + t105;
        const double strand_y_2 = table103[i102][6] - layer_1_y - table103[i102][5] * u_y;
        const double strand_z_2 = layer_1_z - t105;
        const double strand_z_by_q71_2 = layer_1_z_by_q71 + t104;
        const double t106 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_1_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t107 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t107);
        const double t108 = 1.0 / length_2;
        const double length_by_q71_2 = t106 * t108;
        const double strand_x_by_q73_2 = layer_1_x_by_q73 + table103[i102][5] * y_x_by_q73;
        const double strand_y_by_q73_2 = layer_1_y_by_q73 + table103[i102][5] * u_y_by_q73;
        const double strand_z_by_q73_2 = layer_1_z_by_q73 + table103[i102][5] * y_z_by_q73;
        const double t109 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t109 * t108;
        P[588 + 21 * i102] = 0.0;
        P[589 + 21 * i102] = 0.0;
        P[590 + 21 * i102] = 0.0;
        P[591 + 21 * i102] = 0.0;
        P[592 + 21 * i102] = 0.0;
        P[593 + 21 * i102] = 0.0;
        P[594 + 21 * i102] = 0.0;
        P[595 + 21 * i102] = 0.0;
        P[596 + 21 * i102] = 0.0;
        P[597 + 21 * i102] = 0.0;
        P[598 + 21 * i102] = 0.0;
        P[599 + 21 * i102] = 0.0;
        P[600 + 21 * i102] = 0.0;
        P[601 + 21 * i102] = 0.0;
        P[602 + 21 * i102] = table103[i102][0];
        P[603 + 21 * i102] = table103[i102][1];
        P[604 + 21 * i102] = table103[i102][2];
        P[605 + 21 * i102] = table103[i102][3];
        P[606 + 21 * i102] = table103[i102][4];
        P[607 + 21 * i102] = length_by_q71_2;
        P[608 + 21 * i102] = -length_by_q73_2;
    }
    static const double table111[8][7] = {{-0.0065, 0.0, 0.0, 0.0, 0.0, 0.013, 0.006},
        {0.0, 0.0055, 0.0, 0.0, 0.0, 0.011, 0.007}, {0.0, -0.0055, 0.0, 0.0, 0.0, 0.01, 0.009},
        {0.0, 0.0055, -0.0045, 0.0, 0.0, 0.008, 0.011},
        {0.0, -0.0055, 0.0045, 0.0, 0.0, 0.006, 0.012},
        {0.0, 0.0, 0.0, 0.0065, 0.0065, 0.005, 0.014},
        {0.0, 0.0, 0.0, 0.0065, -0.0065, 0.003, 0.015},
        {0.0, 0.0, 0.0, -0.0065, 0.0065, 0.002, 0.017}};
    for (int i110 = 0; i110 < 8; ++i110) {
        const double t112 = table111[i110][5] * y_x;
        const double strand_x_3 = layer_1_x + t112;
        const double t113 = table111[i110][5] * y_z;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t113;
        const double strand_y_3 = table111[i110][6] - layer_1_y + table111[i110][5] * u_y;
        const double strand_z_3 = layer_1_z + t113;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t112;
        const double t114 = strand_x_3 * strand_x_by_q71_3 - strand_y_3 * layer_1_y_by_q71
            - strand_z_3 * strand_z_by_q71_3;
        const double t115 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t115);
        const double t116 = 1.0 / length_3;
        const double length_by_q71_3 = t114 * t116;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table111[i110][5] * y_x_by_q73;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table111[i110][5] * u_y_by_q73;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table111[i110][5] * y_z_by_q73;
        const double t117 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double length_by_q73_3 = t117 * t116;
        P[399 + 21 * i110] = 0.0;
        P[400 + 21 * i110] = 0.0;
        P[401 + 21 * i110] = 0.0;
        P[402 + 21 * i110] = 0.0;
        P[403 + 21 * i110] = 0.0;
        P[404 + 21 * i110] = 0.0;
        P[405 + 21 * i110] = 0.0;
        P[406 + 21 * i110] = 0.0;
        P[407 + 21 * i110] = table111[i110][0];
        P[408 + 21 * i110] = table111[i110][0];
        P[409 + 21 * i110] = table111[i110][1];
        P[410 + 21 * i110] = table111[i110][2];
        P[411 + 21 * i110] = table111[i110][3];
        P[412 + 21 * i110] = table111[i110][4];
        P[413 + 21 * i110] = 0.0;
        P[414 + 21 * i110] = 0.0;
        P[415 + 21 * i110] = 0.0;
        P[416 + 21 * i110] = 0.0;
        P[417 + 21 * i110] = 0.0;
        P[418 + 21 * i110] = length_by_q71_3;
        P[419 + 21 * i110] = -length_by_q73_3;
    }
    static const double table119[7][2] = {{0.011, 0.007}, {0.01, 0.008}, {0.008, 0.01},
        {0.006, 0.011}, {0.005, 0.013}, {0.003, 0.015}, {0.002, 0.016}};
    for (int i118 = 0; i118 < 7; ++i118) {
        const double t120 = table119[i118][0] * y_x;
        const double strand_x_4 = layer_0_x + t120;
        const double strand_x_by_q73_4 = layer_0_x_by_q73 - table119[i118][0] * y_x_by_q73;
        const double strand_y_4 = table119[i118][1] - layer_0_y + table119[i118][0] * u_y;
        const double strand_y_by_q73_4 = layer_0_y_by_q73 - table119[i118][0] * u_y_by_q73;
        const double t121 = table119[i118][0] * y_z;
        const double strand_z_4 = layer_0_z + t121;
        const double strand_z_by_q73_4 = layer_0_z_by_q73 - table119[i118][0] * y_z_by_q73;
        const double t122 = strand_x_4 * strand_x_by_q73_4 - strand_y_4 * strand_y_by_q73_4
            + strand_z_4 * strand_z_by_q73_4;
        const double t123 = strand_x_4 * strand_x_4 + strand_y_4 * strand_y_4 + strand_z_4
            * strand_z_4;
        const double length_4 = sinew_sqrt(t123);
        const double t124 = 1.0 / length_4;
        const double length_by_q73_4 = t122 * t124;
        const double strand_x_by_q71_4 = layer_0_x_by_q71 - t121;
        const double strand_z_by_q71_4 = layer_0_z_by_q71 - t120;
        const double t125 = strand_x_4 * strand_x_by_q71_4 - strand_y_4 * layer_0_y_by_q71
            - strand_z_4 * strand_z_by_q71_4;
        const double length_by_q71_4 = t125 * t124;
        P[20 + 21 * i118] = -length_by_q73_4;
        P[19 + 21 * i118] = length_by_q71_4;
    }
}

void hand_joint_torque(const double q[SINEW_AT_LEAST(19)], const double q_wrist[SINEW_AT_LEAST(2)],
    const double f[SINEW_AT_LEAST(38)], double tau[SINEW_AT_LEAST(21)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines2.s[0];
    const double cos_q71 = sines2.c[0];
    const double sin_q73 = sines2.s[1];
    const double cos_q73 = sines2.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared = 0.007324 - 0.084 * B_y;
    const double t3 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t3;
    const double t4 = 21.0 - 500.0 * B_y;
    const double C_y = 0.002 * ratio * t4;
    const double t5 = 23.80952380952381 * B_y;
    const double u_y = t5 + 23.80952380952381 * C_y;
    const double B_e = 0.074565407529229 * sin_q73;
    const double C_e = B_e * ratio;
    const double t6 = 0.5 * B_e;
    const double M_e = t6 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double t7 = 0.5 * B_y;
    const double M_y = t7 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double t8 = 23.80952380952381 * B_e;
    const double u_e = t8 - 23.80952380952381 * C_e;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t9 = p_y + p_y;
    const double p_z = 0.036 * cos_q71;
    const double p_y_by_q71 = u_y * p_z;
    const double t10 = p_y * p_y;
    const double t11 = p_z * p_z;
    const double t12 = -(1.296e-15 - t10 - t11);
    const double reach_squared_by_q71 = sinew_choose(t12, -(t9 * p_y_by_q71 + (p_z + p_z)
        * p_z_by_q71), 0.0);
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
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t17 * u_e * p_z;
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
    const double t27 = 1.0 / reach_squared;
    const double cos_A = (p_y * limited + p_z * root) * t27;
    const double cos_A_by_q71 = (t26 - cos_A * reach_squared_by_q71) * t27;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double sin_A = (p_y * root - p_z * limited) * t27;
    const double t28 = cos_q71 * sin_A;
    const double z_plane_x = u_y * cos_A;
    const double t29 = sin_q71 * z_plane_x;
    const double t30 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t30 - sin_A * reach_squared_by_q71) * t27;
    const double z_x_by_q71 = t28 - cos_q71 * z_plane_x_by_q71 + t29 + sin_q71 * sin_A_by_q71;
    const double M_z = sin_q71 * M_e;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double t31 = cos_q71 * cos_A;
    const double x_plane_x = u_y * sin_A;
    const double t32 = sin_q71 * x_plane_x;
    const double x_x_by_q71 = t31 + cos_q71 * x_plane_x_by_q71 - t32 + sin_q71 * cos_A_by_q71;
    const double t33 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t34 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t33 + t34;
    const double y_z = sin_q71 * u_e;
    const double t35 = 0.011 * y_z;
    const double t36 = cos_q71 * x_plane_x;
    const double t37 = sin_q71 * cos_A;
    const double x_x = t36 + t37;
    const double M_x = cos_q71 * M_e;
    const double t38 = cos_q71 * z_plane_x;
    const double t39 = sin_q71 * sin_A;
    const double z_x = t38 - t39;
    const double t40 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t41 = 0.01 * z_x;
    const double layer_0_x = t40 - t41;
    const double y_x = cos_q71 * u_e;
    const double t42 = 0.011 * y_x;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t43 = 0.004 * u_e;
    const double t44 = origin_y_by_q71 + t43 * sin_A_by_q71;
    const double t45 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t44 - t45;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t46 = origin_y + t43 * sin_A;
    const double t47 = 0.01 * z_plane_y;
    const double layer_0_y = t46 - t47;
    const double z_z_by_q71 = t38 + cos_q71 * sin_A_by_q71 - t39 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t36 - cos_q71 * cos_A_by_q71 + t37 + sin_q71 * x_plane_x_by_q71;
    const double t48 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t49 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t48 + t49;
    const double z_z = t28 + t29;
    const double origin_z = M_z - 0.018 * z_z;
    const double x_z = t31 - t32;
    const double t50 = 0.004 * x_z;
    const double t51 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t50 - t51;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t3;
    const double C_e_by_q73 = B_e * ratio_by_q73 - B_y * ratio;
    const double M_e_by_q73 = t7 - 0.5 * C_e_by_q73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t4;
    const double M_y_by_q73 = t6 + 0.5 * C_y_by_q73;
    const double u_y_by_q73 = t8 - 23.80952380952381 * C_y_by_q73;
    const double u_e_by_q73 = t5 + 23.80952380952381 * C_e_by_q73;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double reach_squared_by_q73 = sinew_choose(t12, t9 * p_y_by_q73, 0.0);
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t13;
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t17 * p_x_by_q73;
    const double limited_by_q73 = sinew_choose(t19, -(reach_by_q73 * t15 - projection_by_q73 * t16),
        reach_by_q73);
    const double clearance_by_q73 = sinew_choose(t24, t21 * reach_by_q73 - t20 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double root_by_q73 = 0.5 * clearance_by_q73 * t25;
    const double t52 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t52 * t27;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t53 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t53 * t27;
    const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
    const double t54 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t55 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t54 + t55;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double t56 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t57 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t56 + t57;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
    const double t58 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t59 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t58 + t59;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    static const double table63[7][2] = {{0.011, 0.007}, {0.01, 0.008}, {0.008, 0.01},
        {0.006, 0.011}, {0.005, 0.013}, {0.003, 0.015}, {0.002, 0.016}};
    double kept61[7];
    double kept62[7];
    for (int i60 = 0; i60 < 7; ++i60) {
        const double t64 = table63[i60][0] * y_x;
        const double strand_x = layer_0_x + t64;
        const double strand_x_by_q73 = layer_0_x_by_q73 - table63[i60][0] * y_x_by_q73;
        const double strand_y = table63[i60][1] - layer_0_y + table63[i60][0] * u_y;
        const double strand_y_by_q73 = layer_0_y_by_q73 - table63[i60][0] * u_y_by_q73;
        const double t65 = table63[i60][0] * y_z;
        const double strand_z = layer_0_z + t65;
        const double strand_z_by_q73 = layer_0_z_by_q73 - table63[i60][0] * y_z_by_q73;
        const double t66 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t67 = 1.0 / length;
        const double length_by_q73 = t66 * t67;
        const double strand_x_by_q71 = layer_0_x_by_q71 - t65;
        const double strand_z_by_q71 = layer_0_z_by_q71 - t64;
        const double t68 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length_by_q71 = t68 * t67;
        kept61[i60] = f[i60] * length_by_q71;
        kept62[i60] = f[i60] * length_by_q73;
    }
    const double t69 = 0.01 * y_z;
    const double t70 = 0.01 * y_x;
    const double t71 = 0.008 * y_z;
    const double t72 = 0.008 * y_x;
    const double t73 = 0.006 * y_z;
    const double t74 = 0.006 * y_x;
    const double t75 = 0.005 * y_z;
    const double t76 = 0.005 * y_x;
    const double t77 = 0.003 * y_z;
    const double t78 = 0.003 * y_x;
    const double t79 = 0.002 * y_z;
    const double t80 = 0.002 * y_x;
    const double t81 = kept61[0] + kept61[1] + kept61[2] + kept61[3] + kept61[4] + kept61[5]
        + kept61[6];
    const double t82 = kept62[0] + kept62[1] + kept62[2] + kept62[3] + kept62[4] + kept62[5]
        + kept62[6];
    const double strand_7_y = 0.018 - layer_0_y;
    const double t83 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t84 = 1.0 / length_7;
    const double length_7_by_q71 = t83 * t84;
    const double t85 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7_by_q73 = t85 * t84;
    const double t86 = 0.013 * y_z;
    const double t87 = 0.013 * y_x;
    const double t88 = 0.014 * y_z;
    const double t89 = 0.014 * y_x;
    const double t90 = 0.016 * y_z;
    const double t91 = 0.016 * y_x;
    static const double table95[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    double sum93 = t82 + f[7] * length_7_by_q73;
    double sum94 = t81 + f[7] * length_7_by_q71;
    for (int i92 = 0; i92 < 11; ++i92) {
        const double before96 = sum93;
        const double before97 = sum94;
        const double t98 = table95[i92][0] * y_x;
        const double strand_x_2 = layer_0_x - t98;
        const double strand_x_by_q73_2 = layer_0_x_by_q73 + table95[i92][0] * y_x_by_q73;
        const double strand_y_2 = table95[i92][1] - layer_0_y - table95[i92][0] * u_y;
        const double strand_y_by_q73_2 = layer_0_y_by_q73 + table95[i92][0] * u_y_by_q73;
        const double t99 = table95[i92][0] * y_z;
        const double strand_z_2 = layer_0_z - t99;
        const double strand_z_by_q73_2 = layer_0_z_by_q73 + table95[i92][0] * y_z_by_q73;
        const double t100 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double t101 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t101);
        const double t102 = 1.0 / length_2;
        const double length_by_q73_2 = t100 * t102;
        const double strand_x_by_q71_2 = layer_0_x_by_q71 + t99;
        const double strand_z_by_q71_2 = layer_0_z_by_q71 + t98;
        const double t103 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_0_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double length_by_q71_2 = t103 * t102;
        sum93 = before96 + f[8 + i92] * length_by_q73_2;
        sum94 = before97 + f[8 + i92] * length_by_q71_2;
    }
    const double layer_1_x_by_q71 = t33 - t34;
    const double layer_1_x = t40 + t41;
    const double layer_1_y_by_q71 = t44 + t45;
    const double layer_1_y = t46 + t47;
    const double layer_1_z_by_q71 = t48 - t49;
    const double layer_1_z = 0.028 - origin_z - t50 + t51;
    const double layer_1_x_by_q73 = t54 - t55;
    const double layer_1_y_by_q73 = t56 - t57;
    const double layer_1_z_by_q73 = t58 - t59;
    static const double table107[8][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017}};
    double sum105 = sum93;
    double sum106 = sum94;
    for (int i104 = 0; i104 < 8; ++i104) {
        const double before108 = sum105;
        const double before109 = sum106;
        const double t110 = table107[i104][0] * y_x;
        const double strand_x_3 = layer_1_x + t110;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table107[i104][0] * y_x_by_q73;
        const double strand_y_3 = table107[i104][1] - layer_1_y + table107[i104][0] * u_y;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table107[i104][0] * u_y_by_q73;
        const double t111 = table107[i104][0] * y_z;
        const double strand_z_3 = layer_1_z + t111;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table107[i104][0] * y_z_by_q73;
        const double t112 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double t113 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t113);
        const double t114 = 1.0 / length_3;
        const double length_by_q73_3 = t112 * t114;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t111;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t110;
        const double t115 = strand_x_3 * strand_x_by_q71_3 - strand_y_3 * layer_1_y_by_q71
            - strand_z_3 * strand_z_by_q71_3;
        const double length_by_q71_3 = t115 * t114;
        sum105 = before108 + f[19 + i104] * length_by_q73_3;
        sum106 = before109 + f[19 + i104] * length_by_q71_3;
    }
    const double strand_27_y = 0.019 - layer_1_y;
    const double t116 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double t117 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t117);
    const double t118 = 1.0 / length_27;
    const double length_27_by_q71 = t116 * t118;
    const double t119 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double length_27_by_q73 = t119 * t118;
    const double strand_28_x_by_q71 = layer_1_x_by_q71 + t79;
    const double strand_28_x = layer_1_x - t80;
    const double strand_28_y = 0.02 - layer_1_y - 0.002 * u_y;
    const double strand_28_z_by_q71 = layer_1_z_by_q71 + t80;
    const double strand_28_z = layer_1_z - t79;
    const double t120 = strand_28_x * strand_28_x_by_q71 - strand_28_y * layer_1_y_by_q71
        - strand_28_z * strand_28_z_by_q71;
    static const double table124[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    double sum122 = sum105 + f[27] * length_27_by_q73;
    double kept123[10];
    for (int i121 = 0; i121 < 10; ++i121) {
        const double before125 = sum122;
        const double strand_x_4 = layer_1_x - table124[i121][0] * y_x;
        const double strand_x_by_q73_4 = layer_1_x_by_q73 + table124[i121][0] * y_x_by_q73;
        const double strand_y_4 = table124[i121][1] - layer_1_y - table124[i121][0] * u_y;
        const double strand_y_by_q73_4 = layer_1_y_by_q73 + table124[i121][0] * u_y_by_q73;
        const double strand_z_4 = layer_1_z - table124[i121][0] * y_z;
        const double strand_z_by_q73_4 = layer_1_z_by_q73 + table124[i121][0] * y_z_by_q73;
        const double t126 = strand_x_4 * strand_x_by_q73_4 - strand_y_4 * strand_y_by_q73_4
            + strand_z_4 * strand_z_by_q73_4;
        const double t127 = strand_x_4 * strand_x_4 + strand_y_4 * strand_y_4 + strand_z_4
            * strand_z_4;
        const double length_4 = sinew_sqrt(t127);
        const double t128 = 1.0 / length_4;
        const double length_by_q73_4 = t126 * t128;
        sum122 = before125 + f[28 + i121] * length_by_q73_4;
        kept123[i121] = t128;
    }
    const double length_28_by_q71 = t120 * kept123[0];
    const double strand_29_x_by_q71 = layer_1_x_by_q71 + t77;
    const double strand_29_x = layer_1_x - t78;
    const double strand_29_y = 0.022 - layer_1_y - 0.003 * u_y;
    const double strand_29_z_by_q71 = layer_1_z_by_q71 + t78;
    const double strand_29_z = layer_1_z - t77;
    const double t129 = strand_29_x * strand_29_x_by_q71 - strand_29_y * layer_1_y_by_q71
        - strand_29_z * strand_29_z_by_q71;
    const double length_29_by_q71 = t129 * kept123[1];
    const double t130 = sum106 + f[27] * length_27_by_q71 + f[28] * length_28_by_q71 + f[29]
        * length_29_by_q71;
    tau[14] = -(0.011000000000000001 * (f[28] - f[29]));
    const double strand_30_x_by_q71 = layer_1_x_by_q71 + t75;
    const double strand_30_x = layer_1_x - t76;
    const double strand_30_y = 0.023 - layer_1_y - 0.005 * u_y;
    const double strand_30_z_by_q71 = layer_1_z_by_q71 + t76;
    const double strand_30_z = layer_1_z - t75;
    const double t131 = strand_30_x * strand_30_x_by_q71 - strand_30_y * layer_1_y_by_q71
        - strand_30_z * strand_30_z_by_q71;
    const double length_30_by_q71 = t131 * kept123[2];
    const double t132 = 0.0052 * f[30];
    const double strand_31_x_by_q71 = layer_1_x_by_q71 + t73;
    const double strand_31_x = layer_1_x - t74;
    const double strand_31_y = 0.025 - layer_1_y - 0.006 * u_y;
    const double strand_31_z_by_q71 = layer_1_z_by_q71 + t74;
    const double strand_31_z = layer_1_z - t73;
    const double t133 = strand_31_x * strand_31_x_by_q71 - strand_31_y * layer_1_y_by_q71
        - strand_31_z * strand_31_z_by_q71;
    const double length_31_by_q71 = t133 * kept123[3];
    const double t134 = 0.0052 * f[31];
    const double strand_32_x_by_q71 = layer_1_x_by_q71 + t71;
    const double strand_32_x = layer_1_x - t72;
    const double strand_32_y = 0.027 - layer_1_y - 0.008 * u_y;
    const double strand_32_z_by_q71 = layer_1_z_by_q71 + t72;
    const double strand_32_z = layer_1_z - t71;
    const double t135 = strand_32_x * strand_32_x_by_q71 - strand_32_y * layer_1_y_by_q71
        - strand_32_z * strand_32_z_by_q71;
    const double length_32_by_q71 = t135 * kept123[4];
    const double t136 = t130 + f[30] * length_30_by_q71 + f[31] * length_31_by_q71 + f[32]
        * length_32_by_q71;
    const double t137 = 0.0052 * f[32];
    const double strand_33_x_by_q71 = layer_1_x_by_q71 + t69;
    const double strand_33_x = layer_1_x - t70;
    const double strand_33_y = 0.028 - layer_1_y - 0.01 * u_y;
    const double strand_33_z_by_q71 = layer_1_z_by_q71 + t70;
    const double strand_33_z = layer_1_z - t69;
    const double t138 = strand_33_x * strand_33_x_by_q71 - strand_33_y * layer_1_y_by_q71
        - strand_33_z * strand_33_z_by_q71;
    const double length_33_by_q71 = t138 * kept123[5];
    const double t139 = 0.0052 * f[33];
    tau[16] = -(t132 - t134 + t137 - t139);
    tau[15] = -(t132 + t134 - t137 - t139);
    const double strand_34_x_by_q71 = layer_1_x_by_q71 + t35;
    const double strand_34_x = layer_1_x - t42;
    const double strand_34_y = 0.03 - layer_1_y - 0.011 * u_y;
    const double strand_34_z_by_q71 = layer_1_z_by_q71 + t42;
    const double strand_34_z = layer_1_z - t35;
    const double t140 = strand_34_x * strand_34_x_by_q71 - strand_34_y * layer_1_y_by_q71
        - strand_34_z * strand_34_z_by_q71;
    const double length_34_by_q71 = t140 * kept123[6];
    const double R21y = c1 * s2;
    const double t141 = 0.005 * R21y;
    const double t142 = 0.006 * s1;
    const double t143 = t141 - t142;
    const double R21x = c1 * c2;
    const double t144 = 0.047 * R21x;
    const double pA_length_tox = t143 + t144;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double R22y = s1 * s2;
    const double t145 = 0.005 * R22y;
    const double t146 = 0.006 * c1;
    const double t147 = t145 + t146;
    const double R22x = s1 * c2;
    const double t148 = 0.047 * R22x;
    const double pA_length_toy = t147 + t148;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double t149 = 0.025 - 0.005 * c2;
    const double t150 = 0.047 * s2;
    const double A_lengthdz = t149 + t150;
    const double t151 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t151);
    const double t152 = 1.0 / A_length;
    const double t153 = 0.005 * R21x;
    const double t154 = 0.047 * R21y;
    const double pA_length_tox_by_q_1 = t153 - t154;
    const double t155 = 0.005 * R22x;
    const double t156 = 0.047 * R22y;
    const double pA_length_toy_by_q_1 = t155 - t156;
    const double t157 = 0.005 * s2;
    const double t158 = 0.047 * c2;
    const double pA_length_toz_by_q_1 = t157 + t158;
    const double t159 = A_lengthdz * pA_length_toz_by_q_1;
    const double t160 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1
        - t159;
    const double A_length_by_q_1 = t160 * t152;
    const double t161 = t141 + t142;
    const double pB_length_tox = t161 - t144;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double t162 = t145 - t146;
    const double pB_length_toy = t162 - t148;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_lengthdz = t149 - t150;
    const double t163 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t163);
    const double t164 = 1.0 / B_length;
    const double pB_length_tox_by_q_1 = t153 + t154;
    const double pB_length_toy_by_q_1 = t155 + t156;
    const double pB_length_toz_by_q_1 = t157 - t158;
    const double t165 = B_lengthdz * pB_length_toz_by_q_1;
    const double t166 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1
        + t165;
    const double B_length_by_q_1 = t166 * t164;
    const double pC_length_tox = t161 + t144;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double pC_length_toy = t162 + t148;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_length = sinew_sqrt(t151 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t167 = 1.0 / C_length;
    const double t168 = t159 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy
        * pA_length_toy_by_q_1;
    const double C_length_by_q_1 = t168 * t167;
    const double pD_length_tox = t143 - t144;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double pD_length_toy = t147 - t148;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_length = sinew_sqrt(t163 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t169 = 1.0 / D_length;
    const double t170 = t165 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy
        * pB_length_toy_by_q_1;
    const double D_length_by_q_1 = t170 * t169;
    const double t171 = f[0] * A_length_by_q_1 - f[1] * B_length_by_q_1 - f[2] * C_length_by_q_1
        - f[3] * D_length_by_q_1;
    tau[1] = t171;
    const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t152;
    const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t164;
    const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t167;
    const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t169;
    const double t172 = f[0] * A_length_by_q_0 - f[1] * B_length_by_q_0 - f[2] * C_length_by_q_0
        + f[3] * D_length_by_q_0;
    tau[0] = t172;
    const double strand_35_x_by_q71 = layer_1_x_by_q71 + t86;
    const double strand_35_x = layer_1_x - t87;
    const double strand_35_y = 0.031 - layer_1_y - 0.013 * u_y;
    const double strand_35_z_by_q71 = layer_1_z_by_q71 + t87;
    const double strand_35_z = layer_1_z - t86;
    const double t173 = strand_35_x * strand_35_x_by_q71 - strand_35_y * layer_1_y_by_q71
        - strand_35_z * strand_35_z_by_q71;
    const double length_35_by_q71 = t173 * kept123[7];
    const double t174 = t136 + f[33] * length_33_by_q71 + f[34] * length_34_by_q71 + f[35]
        * length_35_by_q71;
    tau[17] = -(0.0088 * (f[34] - f[35]));
    const double strand_36_x_by_q71 = layer_1_x_by_q71 + t88;
    const double strand_36_x = layer_1_x - t89;
    const double strand_36_y = 0.033 - layer_1_y - 0.014 * u_y;
    const double strand_36_z_by_q71 = layer_1_z_by_q71 + t89;
    const double strand_36_z = layer_1_z - t88;
    const double t175 = strand_36_x * strand_36_x_by_q71 - strand_36_y * layer_1_y_by_q71
        - strand_36_z * strand_36_z_by_q71;
    const double length_36_by_q71 = t175 * kept123[8];
    const double strand_37_x_by_q71 = layer_1_x_by_q71 + t90;
    const double strand_37_x = layer_1_x - t91;
    const double strand_37_y = 0.035 - layer_1_y - 0.016 * u_y;
    const double strand_37_z_by_q71 = layer_1_z_by_q71 + t91;
    const double strand_37_z = layer_1_z - t90;
    const double t176 = strand_37_x * strand_37_x_by_q71 - strand_37_y * layer_1_y_by_q71
        - strand_37_z * strand_37_z_by_q71;
    const double length_37_by_q71 = t176 * kept123[9];
    tau[20] = sum122;
    tau[18] = -(0.005 * (f[36] - f[37]));
    tau[19] = -(t174 + f[36] * length_36_by_q71 + f[37] * length_37_by_q71);
    static const double table178[3][3] = {{1.0, -0.0065, -0.0055}, {-1.0, -0.0055, 0.0045},
        {-1.0, -0.0055, 0.0045}};
    for (int i177 = 0; i177 < 3; ++i177) {
        const double t179 = f[4 + 8 * i177] - f[5 + 8 * i177] - table178[i177][0] * f[6 + 8 * i177]
            + table178[i177][0] * f[7 + 8 * i177];
        const double t180 = 0.0065 * f[8 + 8 * i177];
        const double t181 = 0.0065 * f[9 + 8 * i177];
        const double t182 = 0.0065 * f[10 + 8 * i177];
        const double t183 = 0.0065 * f[11 + 8 * i177];
        tau[2 + 4 * i177] = table178[i177][1] * t179;
        tau[3 + 4 * i177] = table178[i177][2] * (f[6 + 8 * i177] - f[7 + 8 * i177]);
        tau[4 + 4 * i177] = -(t180 + t181 - t182 - t183);
        tau[5 + 4 * i177] = -(t180 - t181 + t182 - t183);
    }
}

void hand_joint_stiffness(const double q[SINEW_AT_LEAST(19)],
    const double q_wrist[SINEW_AT_LEAST(2)], const double f[SINEW_AT_LEAST(38)],
    const double kt[SINEW_AT_LEAST(38)], double K[SINEW_AT_LEAST(441)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
    const double sin_q71 = sines2.s[0];
    const double cos_q71 = sines2.c[0];
    const double sin_q73 = sines2.s[1];
    const double cos_q73 = sines2.c[1];
    const double B_y = 0.074565407529229 * cos_q73;
    const double B_to_C0_squared_by_q73_by_q73 = 0.084 * B_y;
    const double B_to_C0_squared = 0.007324 - B_to_C0_squared_by_q73_by_q73;
    const double t3 = 1.0 / B_to_C0_squared;
    const double ratio = 0.003796 * t3;
    const double B_e = 0.074565407529229 * sin_q73;
    const double B_to_C0_squared_by_q73 = 0.084 * B_e;
    const double ratio_by_q73 = ratio * B_to_C0_squared_by_q73 * t3;
    const double t4 = 21.0 - 500.0 * B_y;
    const double C_e = B_e * ratio;
    const double C_y_by_q73 = C_e - 0.002 * ratio_by_q73 * t4;
    const double t5 = 0.5 * B_e;
    const double M_y_by_q73 = t5 + 0.5 * C_y_by_q73;
    const double t6 = 23.80952380952381 * B_e;
    const double u_e = t6 - 23.80952380952381 * C_e;
    const double t7 = B_y * ratio;
    const double C_e_by_q73 = B_e * ratio_by_q73 - t7;
    const double t8 = 0.5 * B_y;
    const double M_e_by_q73 = t8 - 0.5 * C_e_by_q73;
    const double C_y = 0.002 * ratio * t4;
    const double t9 = 23.80952380952381 * B_y;
    const double u_y = t9 + 23.80952380952381 * C_y;
    const double u_y_by_q73 = t6 - 23.80952380952381 * C_y_by_q73;
    const double M_e = t5 + 0.5 * C_e;
    const double p_z_by_q71 = 0.036 * sin_q71;
    const double s_e = M_e - p_z_by_q71;
    const double u_e_by_q73 = t9 + 23.80952380952381 * C_e_by_q73;
    const double M_y = t8 - 0.5 * C_y;
    const double s_y = 0.021 - M_y;
    const double p_y_by_q73 = u_e * M_y_by_q73 + u_y * M_e_by_q73 - s_e * u_y_by_q73 + s_y
        * u_e_by_q73;
    const double p_y = u_e * s_y + u_y * s_e;
    const double t10 = p_y + p_y;
    const double t11 = p_y * p_y;
    const double p_z = 0.036 * cos_q71;
    const double t12 = p_z * p_z;
    const double t13 = -(1.296e-15 - t11 - t12);
    const double reach_squared_by_q73 = sinew_choose(t13, t10 * p_y_by_q73, 0.0);
    const double p_x_by_q73 = u_e * M_e_by_q73 - u_y * M_y_by_q73 + s_e * u_e_by_q73 + s_y
        * u_y_by_q73;
    const double p_x = u_e * s_e - u_y * s_y;
    const double t14 = 27.77777777777778 * p_x;
    const double projection_by_q73 = 13.88888888888889 * reach_squared_by_q73 + t14 * p_x_by_q73;
    const double reach_squared = sinew_max(t11 + t12, 1.296e-15);
    const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
        * p_x);
    const double reach = sinew_sqrt(reach_squared);
    const double t15 = reach - projection;
    const double t16 = sinew_choose(t15, 1.0, 0.0);
    const double t17 = 1.0 / reach;
    const double reach_by_q73 = 0.5 * reach_squared_by_q73 * t17;
    const double t18 = sinew_choose(t15, 0.0, 1.0);
    const double t19 = sinew_max(-projection, -reach);
    const double t20 = reach - t19;
    const double limited_by_q73 = sinew_choose(t20, -(reach_by_q73 * t18 - projection_by_q73 * t16),
        reach_by_q73);
    const double t21 = reach_by_q73 * reach_by_q73;
    const double t22 = t21 + t21;
    const double t23 = ratio * B_to_C0_squared_by_q73_by_q73 - (B_to_C0_squared_by_q73
        + B_to_C0_squared_by_q73) * ratio_by_q73;
    const double ratio_by_q73_by_q73 = t23 * t3;
    const double C_y_by_q73_by_q73 = t7 - 0.002 * ratio_by_q73_by_q73 * t4 - (B_e + B_e)
        * ratio_by_q73;
    const double M_y_by_q73_by_q73 = t8 + 0.5 * C_y_by_q73_by_q73;
    const double C_e_by_q73_by_q73 = C_e + B_e * ratio_by_q73_by_q73 + (B_y + B_y) * ratio_by_q73;
    const double M_e_by_q73_by_q73 = t5 + 0.5 * C_e_by_q73_by_q73;
    const double u_y_by_q73_by_q73 = t9 - 23.80952380952381 * C_y_by_q73_by_q73;
    const double t24 = u_e * M_y_by_q73_by_q73 - u_y * M_e_by_q73_by_q73 - s_e * u_y_by_q73_by_q73;
    const double u_e_by_q73_by_q73 = t6 - 23.80952380952381 * C_e_by_q73_by_q73;
    const double t25 = u_e_by_q73 + u_e_by_q73;
    const double t26 = u_y_by_q73 + u_y_by_q73;
    const double p_y_by_q73_by_q73 = t24 - s_y * u_e_by_q73_by_q73 + t25 * M_y_by_q73 - t26
        * M_e_by_q73;
    const double t27 = p_y_by_q73 + p_y_by_q73;
    const double reach_squared_by_q73_by_q73 = sinew_choose(t13, t27 * p_y_by_q73 + t10
        * p_y_by_q73_by_q73, 0.0);
    const double reach_by_q73_by_q73 = 0.5 * (reach_squared_by_q73_by_q73 - t22) * t17;
    const double t28 = reach + reach;
    const double t29 = t22 - (limited_by_q73 + limited_by_q73) * limited_by_q73 + t28
        * reach_by_q73_by_q73;
    const double t30 = 13.88888888888889 * reach_squared_by_q73_by_q73 + 27.77777777777778
        * p_x_by_q73 * p_x_by_q73;
    const double t31 = u_e * M_e_by_q73_by_q73 + u_y * M_y_by_q73_by_q73 + s_e * u_e_by_q73_by_q73;
    const double p_x_by_q73_by_q73 = t31 - s_y * u_y_by_q73_by_q73 - t25 * M_e_by_q73 - t26
        * M_y_by_q73;
    const double projection_by_q73_by_q73 = t30 - t14 * p_x_by_q73_by_q73;
    const double limited_by_q73_by_q73 = sinew_choose(t20, -(reach_by_q73_by_q73 * t18
        - projection_by_q73_by_q73 * t16), reach_by_q73_by_q73);
    const double limited = sinew_min(t19, reach);
    const double t32 = limited + limited;
    const double t33 = (reach + limited) * (reach - limited);
    const double t34 = 1e-12 * reach_squared;
    const double t35 = -(t34 - t33);
    const double clearance_by_q73_by_q73 = sinew_choose(t35, t29 - t32 * limited_by_q73_by_q73,
        1e-12 * reach_squared_by_q73_by_q73);
    const double clearance_by_q73 = sinew_choose(t35, t28 * reach_by_q73 - t32 * limited_by_q73,
        1e-12 * reach_squared_by_q73);
    const double clearance = sinew_max(t33, t34);
    const double root = sinew_sqrt(clearance);
    const double t36 = 1.0 / root;
    const double root_by_q73 = 0.5 * clearance_by_q73 * t36;
    const double t37 = 0.5 * (clearance_by_q73_by_q73 - (root_by_q73 + root_by_q73) * root_by_q73);
    const double root_by_q73_by_q73 = t37 * t36;
    const double t38 = p_y * root_by_q73_by_q73 - p_z * limited_by_q73_by_q73 + root
        * p_y_by_q73_by_q73;
    const double t39 = p_z * limited;
    const double t40 = 1.0 / reach_squared;
    const double sin_A = (p_y * root - t39) * t40;
    const double t41 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
        * reach_squared_by_q73;
    const double sin_A_by_q73 = t41 * t40;
    const double t42 = reach_squared_by_q73 + reach_squared_by_q73;
    const double t43 = t38 - sin_A * reach_squared_by_q73_by_q73 + t27 * root_by_q73 - t42
        * sin_A_by_q73;
    const double sin_A_by_q73_by_q73 = t43 * t40;
    const double x_plane_x_by_q73_by_q73 = u_y * sin_A_by_q73_by_q73 - sin_A * u_y_by_q73_by_q73
        - t26 * sin_A_by_q73;
    const double t44 = p_y * limited_by_q73_by_q73 + p_z * root_by_q73_by_q73 + limited
        * p_y_by_q73_by_q73;
    const double t45 = p_z * root;
    const double cos_A = (p_y * limited + t45) * t40;
    const double t46 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
        * reach_squared_by_q73;
    const double cos_A_by_q73 = t46 * t40;
    const double t47 = t44 - cos_A * reach_squared_by_q73_by_q73 + t27 * limited_by_q73 - t42
        * cos_A_by_q73;
    const double cos_A_by_q73_by_q73 = t47 * t40;
    const double x_x_by_q73_by_q73 = cos_q71 * x_plane_x_by_q73_by_q73 + sin_q71
        * cos_A_by_q73_by_q73;
    const double z_plane_x_by_q73_by_q73 = u_y * cos_A_by_q73_by_q73 - cos_A * u_y_by_q73_by_q73
        - t26 * cos_A_by_q73;
    const double z_x_by_q73_by_q73 = cos_q71 * z_plane_x_by_q73_by_q73 - sin_q71
        * sin_A_by_q73_by_q73;
    const double M_x_by_q73_by_q73 = cos_q71 * M_e_by_q73_by_q73;
    const double origin_x_by_q73_by_q73 = M_x_by_q73_by_q73 + 0.018 * z_x_by_q73_by_q73;
    const double t48 = origin_x_by_q73_by_q73 + 0.004 * x_x_by_q73_by_q73;
    const double t49 = 0.01 * z_x_by_q73_by_q73;
    const double layer_0_x_by_q73_by_q73 = t48 - t49;
    const double y_x_by_q73_by_q73 = cos_q71 * u_e_by_q73_by_q73;
    const double strand_0_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - 0.011 * y_x_by_q73_by_q73;
    const double x_plane_x = u_y * sin_A;
    const double t50 = cos_q71 * x_plane_x;
    const double t51 = sin_q71 * cos_A;
    const double x_x = t50 + t51;
    const double M_x = cos_q71 * M_e;
    const double z_plane_x = u_y * cos_A;
    const double t52 = cos_q71 * z_plane_x;
    const double t53 = sin_q71 * sin_A;
    const double z_x = t52 - t53;
    const double t54 = 0.004 * (1.0 + x_x) - M_x + 0.018 * z_x;
    const double t55 = 0.01 * z_x;
    const double layer_0_x = t54 - t55;
    const double y_x = cos_q71 * u_e;
    const double t56 = 0.011 * y_x;
    const double strand_0_x = layer_0_x + t56;
    const double x_plane_y_by_q73_by_q73 = u_e * sin_A_by_q73_by_q73 - sin_A * u_e_by_q73_by_q73
        + t25 * sin_A_by_q73;
    const double z_plane_y_by_q73_by_q73 = u_e * cos_A_by_q73_by_q73 - cos_A * u_e_by_q73_by_q73
        + t25 * cos_A_by_q73;
    const double origin_y_by_q73_by_q73 = M_y_by_q73_by_q73 - 0.018 * z_plane_y_by_q73_by_q73;
    const double t57 = origin_y_by_q73_by_q73 - 0.004 * x_plane_y_by_q73_by_q73;
    const double t58 = 0.01 * z_plane_y_by_q73_by_q73;
    const double layer_0_y_by_q73_by_q73 = t57 + t58;
    const double strand_0_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - 0.011 * u_y_by_q73_by_q73;
    const double z_plane_y = u_e * cos_A;
    const double origin_y = M_y + 0.018 * z_plane_y;
    const double t59 = 0.004 * u_e;
    const double t60 = origin_y + t59 * sin_A;
    const double t61 = 0.01 * z_plane_y;
    const double layer_0_y = t60 - t61;
    const double strand_0_y = 0.007 - layer_0_y + 0.011 * u_y;
    const double t62 = strand_0_x * strand_0_x_by_q73_by_q73 + strand_0_y
        * strand_0_y_by_q73_by_q73;
    const double x_z_by_q73_by_q73 = cos_q71 * cos_A_by_q73_by_q73 - sin_q71
        * x_plane_x_by_q73_by_q73;
    const double z_z_by_q73_by_q73 = cos_q71 * sin_A_by_q73_by_q73 + sin_q71
        * z_plane_x_by_q73_by_q73;
    const double M_z_by_q73_by_q73 = sin_q71 * M_e_by_q73_by_q73;
    const double origin_z_by_q73_by_q73 = M_z_by_q73_by_q73 + 0.018 * z_z_by_q73_by_q73;
    const double t63 = origin_z_by_q73_by_q73 - 0.004 * x_z_by_q73_by_q73;
    const double t64 = 0.01 * z_z_by_q73_by_q73;
    const double layer_0_z_by_q73_by_q73 = t63 - t64;
    const double y_z_by_q73_by_q73 = sin_q71 * u_e_by_q73_by_q73;
    const double strand_0_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - 0.011 * y_z_by_q73_by_q73;
    const double t65 = sin_q71 * z_plane_x;
    const double t66 = cos_q71 * sin_A;
    const double z_z = t66 + t65;
    const double M_z = sin_q71 * M_e;
    const double origin_z = M_z - 0.018 * z_z;
    const double t67 = sin_q71 * x_plane_x;
    const double t68 = cos_q71 * cos_A;
    const double x_z = t68 - t67;
    const double t69 = 0.004 * x_z;
    const double t70 = 0.01 * z_z;
    const double layer_0_z = 0.008 - origin_z - t69 - t70;
    const double y_z = sin_q71 * u_e;
    const double t71 = 0.011 * y_z;
    const double strand_0_z = layer_0_z + t71;
    const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
    const double t72 = cos_q71 * z_plane_x_by_q73;
    const double t73 = sin_q71 * sin_A_by_q73;
    const double z_x_by_q73 = t72 - t73;
    const double M_x_by_q73 = cos_q71 * M_e_by_q73;
    const double origin_x_by_q73 = M_x_by_q73 - 0.018 * z_x_by_q73;
    const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
    const double t74 = cos_q71 * x_plane_x_by_q73;
    const double t75 = sin_q71 * cos_A_by_q73;
    const double x_x_by_q73 = t74 + t75;
    const double t76 = origin_x_by_q73 - 0.004 * x_x_by_q73;
    const double t77 = 0.01 * z_x_by_q73;
    const double layer_0_x_by_q73 = t76 + t77;
    const double y_x_by_q73 = cos_q71 * u_e_by_q73;
    const double t78 = 0.011 * y_x_by_q73;
    const double strand_0_x_by_q73 = layer_0_x_by_q73 - t78;
    const double t79 = t62 + strand_0_z * strand_0_z_by_q73_by_q73 + strand_0_x_by_q73
        * strand_0_x_by_q73;
    const double x_plane_y_by_q73 = u_e * sin_A_by_q73 + sin_A * u_e_by_q73;
    const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
    const double origin_y_by_q73 = M_y_by_q73 - 0.018 * z_plane_y_by_q73;
    const double t80 = origin_y_by_q73 - 0.004 * x_plane_y_by_q73;
    const double t81 = 0.01 * z_plane_y_by_q73;
    const double layer_0_y_by_q73 = t80 + t81;
    const double strand_0_y_by_q73 = layer_0_y_by_q73 - 0.011 * u_y_by_q73;
    const double t82 = sin_q71 * z_plane_x_by_q73;
    const double t83 = cos_q71 * sin_A_by_q73;
    const double z_z_by_q73 = t83 + t82;
    const double M_z_by_q73 = sin_q71 * M_e_by_q73;
    const double origin_z_by_q73 = M_z_by_q73 - 0.018 * z_z_by_q73;
    const double t84 = sin_q71 * x_plane_x_by_q73;
    const double t85 = cos_q71 * cos_A_by_q73;
    const double x_z_by_q73 = t85 - t84;
    const double t86 = origin_z_by_q73 + 0.004 * x_z_by_q73;
    const double t87 = 0.01 * z_z_by_q73;
    const double layer_0_z_by_q73 = t86 + t87;
    const double y_z_by_q73 = sin_q71 * u_e_by_q73;
    const double t88 = 0.011 * y_z_by_q73;
    const double strand_0_z_by_q73 = layer_0_z_by_q73 - t88;
    const double t89 = t79 + strand_0_y_by_q73 * strand_0_y_by_q73 + strand_0_z_by_q73
        * strand_0_z_by_q73;
    const double t90 = strand_0_x * strand_0_x_by_q73 - strand_0_y * strand_0_y_by_q73 + strand_0_z
        * strand_0_z_by_q73;
    const double t91 = strand_0_x * strand_0_x + strand_0_y * strand_0_y + strand_0_z * strand_0_z;
    const double length_0 = sinew_sqrt(t91);
    const double t92 = 1.0 / length_0;
    const double length_0_by_q73 = t90 * t92;
    const double t93 = length_0_by_q73 * length_0_by_q73;
    const double length_0_by_q73_by_q73 = (t89 - t93) * t92;
    const double K_0_4 = f[0] * length_0_by_q73_by_q73 + kt[0] * t93;
    const double p_y_by_q71 = u_y * p_z;
    const double t94 = p_z + p_z;
    const double reach_squared_by_q71 = sinew_choose(t13, -(t10 * p_y_by_q71 + t94 * p_z_by_q71),
        0.0);
    const double reach_by_q71 = 0.5 * reach_squared_by_q71 * t17;
    const double p_x_by_q71 = u_e * p_z;
    const double projection_by_q71 = 13.88888888888889 * reach_squared_by_q71 - t14 * p_x_by_q71;
    const double limited_by_q71 = sinew_choose(t20, -(reach_by_q71 * t18 - projection_by_q71 * t16),
        reach_by_q71);
    const double clearance_by_q71 = sinew_choose(t35, t28 * reach_by_q71 - t32 * limited_by_q71,
        1e-12 * reach_squared_by_q71);
    const double root_by_q71 = 0.5 * clearance_by_q71 * t36;
    const double t95 = root_by_q71 + root_by_q71;
    const double t96 = (reach_by_q71 + reach_by_q71) * reach_by_q73;
    const double t97 = p_y_by_q71 + p_y_by_q71;
    const double p_y_by_q71_by_q73 = p_z * u_y_by_q73;
    const double reach_squared_by_q71_by_q73 = sinew_choose(t13, t10 * p_y_by_q71_by_q73 - t97
        * p_y_by_q73, 0.0);
    const double reach_by_q71_by_q73 = 0.5 * (reach_squared_by_q71_by_q73 - t96) * t17;
    const double t98 = 27.77777777777778 * p_x_by_q71;
    const double projection_by_q71_by_q73 = 13.88888888888889 * reach_squared_by_q71_by_q73 - t14
        * p_z * u_e_by_q73 - t98 * p_x_by_q73;
    const double limited_by_q71_by_q73 = sinew_choose(t20, -(reach_by_q71_by_q73 * t18
        - projection_by_q71_by_q73 * t16), reach_by_q71_by_q73);
    const double t99 = limited_by_q71 + limited_by_q71;
    const double t100 = t28 * reach_by_q71_by_q73 - t32 * limited_by_q71_by_q73 + t96 - t99
        * limited_by_q73;
    const double clearance_by_q71_by_q73 = sinew_choose(t35, t100, 1e-12
        * reach_squared_by_q71_by_q73);
    const double root_by_q71_by_q73 = 0.5 * (clearance_by_q71_by_q73 - t95 * root_by_q73) * t36;
    const double t101 = p_y * limited_by_q71_by_q73 + p_z * root_by_q71_by_q73 + limited
        * p_y_by_q71_by_q73;
    const double t102 = t101 - cos_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * limited_by_q73
        - p_z_by_q71 * root_by_q73;
    const double t103 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
        * p_z_by_q71;
    const double cos_A_by_q71 = (t103 - cos_A * reach_squared_by_q71) * t40;
    const double t104 = t102 - reach_squared_by_q71 * cos_A_by_q73 + limited_by_q71 * p_y_by_q73
        - cos_A_by_q71 * reach_squared_by_q73;
    const double cos_A_by_q71_by_q73 = t104 * t40;
    const double z_plane_x_by_q71_by_q73 = u_y * cos_A_by_q71_by_q73 - cos_A_by_q71 * u_y_by_q73;
    const double t105 = p_y * root_by_q71_by_q73 - p_z * limited_by_q71_by_q73 + root
        * p_y_by_q71_by_q73;
    const double t106 = t105 - sin_A * reach_squared_by_q71_by_q73 - p_y_by_q71 * root_by_q73
        + p_z_by_q71 * limited_by_q73;
    const double t107 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
        * p_y_by_q71;
    const double sin_A_by_q71 = (t107 - sin_A * reach_squared_by_q71) * t40;
    const double t108 = t106 - reach_squared_by_q71 * sin_A_by_q73 + root_by_q71 * p_y_by_q73
        - sin_A_by_q71 * reach_squared_by_q73;
    const double sin_A_by_q71_by_q73 = t108 * t40;
    const double z_x_by_q71_by_q73 = t83 - cos_q71 * z_plane_x_by_q71_by_q73 + t82 + sin_q71
        * sin_A_by_q71_by_q73;
    const double origin_x_by_q71_by_q73 = M_z_by_q73 - 0.018 * z_x_by_q71_by_q73;
    const double x_plane_x_by_q71_by_q73 = u_y * sin_A_by_q71_by_q73 - sin_A_by_q71 * u_y_by_q73;
    const double x_x_by_q71_by_q73 = t85 + cos_q71 * x_plane_x_by_q71_by_q73 - t84 + sin_q71
        * cos_A_by_q71_by_q73;
    const double t109 = origin_x_by_q71_by_q73 + 0.004 * x_x_by_q71_by_q73;
    const double t110 = 0.01 * z_x_by_q71_by_q73;
    const double layer_0_x_by_q71_by_q73 = t109 + t110;
    const double strand_0_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t88;
    const double x_plane_y_by_q71_by_q73 = u_e * sin_A_by_q71_by_q73 + sin_A_by_q71 * u_e_by_q73;
    const double z_plane_y_by_q71_by_q73 = u_e * cos_A_by_q71_by_q73 + cos_A_by_q71 * u_e_by_q73;
    const double origin_y_by_q71_by_q73 = 0.018 * z_plane_y_by_q71_by_q73;
    const double t111 = origin_y_by_q71_by_q73 + 0.004 * x_plane_y_by_q71_by_q73;
    const double t112 = 0.01 * z_plane_y_by_q71_by_q73;
    const double layer_0_y_by_q71_by_q73 = t111 - t112;
    const double t113 = strand_0_x * strand_0_x_by_q71_by_q73 - strand_0_y
        * layer_0_y_by_q71_by_q73;
    const double z_z_by_q71_by_q73 = t72 + cos_q71 * sin_A_by_q71_by_q73 - t73 + sin_q71
        * z_plane_x_by_q71_by_q73;
    const double origin_z_by_q71_by_q73 = M_x_by_q73 - 0.018 * z_z_by_q71_by_q73;
    const double x_z_by_q71_by_q73 = t74 - cos_q71 * cos_A_by_q71_by_q73 + t75 + sin_q71
        * x_plane_x_by_q71_by_q73;
    const double t114 = origin_z_by_q71_by_q73 - 0.004 * x_z_by_q71_by_q73;
    const double t115 = 0.01 * z_z_by_q71_by_q73;
    const double layer_0_z_by_q71_by_q73 = t114 + t115;
    const double strand_0_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t78;
    const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
    const double z_x_by_q71 = t66 - cos_q71 * z_plane_x_by_q71 + t65 + sin_q71 * sin_A_by_q71;
    const double origin_x_by_q71 = M_z - 0.018 * z_x_by_q71;
    const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
    const double x_x_by_q71 = t68 + cos_q71 * x_plane_x_by_q71 - t67 + sin_q71 * cos_A_by_q71;
    const double t116 = origin_x_by_q71 + 0.004 * x_x_by_q71;
    const double t117 = 0.01 * z_x_by_q71;
    const double layer_0_x_by_q71 = t116 + t117;
    const double strand_0_x_by_q71 = layer_0_x_by_q71 - t71;
    const double t118 = t113 - strand_0_z * strand_0_z_by_q71_by_q73 - strand_0_x_by_q71
        * strand_0_x_by_q73;
    const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
    const double origin_y_by_q71 = 0.018 * z_plane_y_by_q71;
    const double t119 = origin_y_by_q71 + t59 * sin_A_by_q71;
    const double t120 = 0.01 * z_plane_y_by_q71;
    const double layer_0_y_by_q71 = t119 - t120;
    const double z_z_by_q71 = t52 + cos_q71 * sin_A_by_q71 - t53 + sin_q71 * z_plane_x_by_q71;
    const double origin_z_by_q71 = M_x - 0.018 * z_z_by_q71;
    const double x_z_by_q71 = t50 - cos_q71 * cos_A_by_q71 + t51 + sin_q71 * x_plane_x_by_q71;
    const double t121 = origin_z_by_q71 - 0.004 * x_z_by_q71;
    const double t122 = 0.01 * z_z_by_q71;
    const double layer_0_z_by_q71 = t121 + t122;
    const double strand_0_z_by_q71 = layer_0_z_by_q71 - t56;
    const double t123 = t118 - layer_0_y_by_q71 * strand_0_y_by_q73 + strand_0_z_by_q71
        * strand_0_z_by_q73;
    const double t124 = strand_0_x * strand_0_x_by_q71 - strand_0_y * layer_0_y_by_q71 - strand_0_z
        * strand_0_z_by_q71;
    const double length_0_by_q71 = t124 * t92;
    const double length_0_by_q71_by_q73 = (t123 + length_0_by_q71 * length_0_by_q73) * t92;
    const double K_0 = f[0] * length_0_by_q71_by_q73 - kt[0] * length_0_by_q71 * length_0_by_q73;
    const double t125 = reach_by_q71 * reach_by_q71;
    const double t126 = t125 + t125;
    const double p_y_by_q71_by_q71 = u_y * p_z_by_q71;
    const double t127 = p_y_by_q71 * p_y_by_q71 + p_z_by_q71 * p_z_by_q71;
    const double reach_squared_by_q71_by_q71 = sinew_choose(t13, t127 + t127 + t10
        * p_y_by_q71_by_q71 - t94 * p_z, 0.0);
    const double reach_by_q71_by_q71 = 0.5 * (reach_squared_by_q71_by_q71 - t126) * t17;
    const double projection_by_q71_by_q71 = 13.88888888888889 * reach_squared_by_q71_by_q71 + t98
        * p_x_by_q71 + t14 * u_e * p_z_by_q71;
    const double limited_by_q71_by_q71 = sinew_choose(t20, -(reach_by_q71_by_q71 * t18
        - projection_by_q71_by_q71 * t16), reach_by_q71_by_q71);
    const double t128 = t126 - t99 * limited_by_q71 + t28 * reach_by_q71_by_q71 - t32
        * limited_by_q71_by_q71;
    const double clearance_by_q71_by_q71 = sinew_choose(t35, t128, 1e-12
        * reach_squared_by_q71_by_q71);
    const double root_by_q71_by_q71 = 0.5 * (clearance_by_q71_by_q71 - t95 * root_by_q71) * t36;
    const double t129 = p_y * limited_by_q71_by_q71 - t45 + p_z * root_by_q71_by_q71 + limited
        * p_y_by_q71_by_q71;
    const double t130 = p_z_by_q71 + p_z_by_q71;
    const double t131 = t129 - cos_A * reach_squared_by_q71_by_q71 - t97 * limited_by_q71 - t130
        * root_by_q71;
    const double t132 = reach_squared_by_q71 + reach_squared_by_q71;
    const double cos_A_by_q71_by_q71 = (t131 - t132 * cos_A_by_q71) * t40;
    const double z_plane_x_by_q71_by_q71 = u_y * cos_A_by_q71_by_q71;
    const double t133 = p_y * root_by_q71_by_q71 + t39 - p_z * limited_by_q71_by_q71 + root
        * p_y_by_q71_by_q71;
    const double t134 = t133 - sin_A * reach_squared_by_q71_by_q71 - t97 * root_by_q71 + t130
        * limited_by_q71;
    const double sin_A_by_q71_by_q71 = (t134 - t132 * sin_A_by_q71) * t40;
    const double t135 = t52 - cos_q71 * z_plane_x_by_q71_by_q71 - t53 + sin_q71
        * sin_A_by_q71_by_q71;
    const double t136 = cos_q71 + cos_q71;
    const double t137 = sin_q71 + sin_q71;
    const double z_x_by_q71_by_q71 = t135 + t136 * sin_A_by_q71 + t137 * z_plane_x_by_q71;
    const double origin_x_by_q71_by_q71 = M_x - 0.018 * z_x_by_q71_by_q71;
    const double x_plane_x_by_q71_by_q71 = u_y * sin_A_by_q71_by_q71;
    const double t138 = t50 - cos_q71 * x_plane_x_by_q71_by_q71 + t51 - sin_q71
        * cos_A_by_q71_by_q71;
    const double x_x_by_q71_by_q71 = t138 - t136 * cos_A_by_q71 + t137 * x_plane_x_by_q71;
    const double t139 = origin_x_by_q71_by_q71 - 0.004 * x_x_by_q71_by_q71;
    const double t140 = 0.01 * z_x_by_q71_by_q71;
    const double layer_0_x_by_q71_by_q71 = t139 + t140;
    const double strand_0_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t56;
    const double z_plane_y_by_q71_by_q71 = u_e * cos_A_by_q71_by_q71;
    const double origin_y_by_q71_by_q71 = 0.018 * z_plane_y_by_q71_by_q71;
    const double t141 = origin_y_by_q71_by_q71 + t59 * sin_A_by_q71_by_q71;
    const double t142 = 0.01 * z_plane_y_by_q71_by_q71;
    const double layer_0_y_by_q71_by_q71 = t141 - t142;
    const double t143 = strand_0_x * strand_0_x_by_q71_by_q71 - strand_0_y
        * layer_0_y_by_q71_by_q71;
    const double t144 = t66 - cos_q71 * sin_A_by_q71_by_q71 + t65 - sin_q71
        * z_plane_x_by_q71_by_q71;
    const double z_z_by_q71_by_q71 = t144 - t136 * z_plane_x_by_q71 + t137 * sin_A_by_q71;
    const double origin_z_by_q71_by_q71 = M_z - 0.018 * z_z_by_q71_by_q71;
    const double t145 = t68 - cos_q71 * cos_A_by_q71_by_q71 - t67 + sin_q71
        * x_plane_x_by_q71_by_q71;
    const double x_z_by_q71_by_q71 = t145 + t136 * x_plane_x_by_q71 + t137 * cos_A_by_q71;
    const double t146 = origin_z_by_q71_by_q71 + 0.004 * x_z_by_q71_by_q71;
    const double t147 = 0.01 * z_z_by_q71_by_q71;
    const double layer_0_z_by_q71_by_q71 = t146 + t147;
    const double strand_0_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t71;
    const double t148 = t143 + strand_0_z * strand_0_z_by_q71_by_q71 + strand_0_x_by_q71
        * strand_0_x_by_q71;
    const double t149 = layer_0_y_by_q71 * layer_0_y_by_q71;
    const double t150 = length_0_by_q71 * length_0_by_q71;
    const double length_0_by_q71_by_q71 = (t148 + t149 + strand_0_z_by_q71 * strand_0_z_by_q71
        - t150) * t92;
    const double K_0_2 = f[0] * length_0_by_q71_by_q71 + kt[0] * t150;
    static const double table157[5][2] = {{0.01, 0.008}, {0.008, 0.01}, {0.006, 0.011},
        {0.005, 0.013}, {0.003, 0.015}};
    double sum152 = K_0;
    double sum153 = K_0_4;
    double sum154 = K_0_2;
    double kept155[5];
    double kept156[5];
    for (int i151 = 0; i151 < 5; ++i151) {
        const double before158 = sum152;
        const double before159 = sum153;
        const double before160 = sum154;
        const double t161 = table157[i151][0] * y_x;
        const double strand_x = layer_0_x + t161;
        const double t162 = table157[i151][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t162;
        const double strand_y = table157[i151][1] - layer_0_y + table157[i151][0] * u_y;
        const double t163 = table157[i151][0] * y_z;
        const double strand_z = layer_0_z + t163;
        const double t164 = table157[i151][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t164;
        const double t165 = strand_x * strand_x_by_q71_by_q73 - strand_y * layer_0_y_by_q71_by_q73
            - strand_z * strand_z_by_q71_by_q73;
        const double strand_y_by_q73 = layer_0_y_by_q73 - table157[i151][0] * u_y_by_q73;
        const double strand_x_by_q71 = layer_0_x_by_q71 - t163;
        const double strand_x_by_q73 = layer_0_x_by_q73 - t164;
        const double t166 = t165 - layer_0_y_by_q71 * strand_y_by_q73 - strand_x_by_q71
            * strand_x_by_q73;
        const double strand_z_by_q71 = layer_0_z_by_q71 - t161;
        const double strand_z_by_q73 = layer_0_z_by_q73 - t162;
        const double t167 = strand_x * strand_x_by_q71 - strand_y * layer_0_y_by_q71 - strand_z
            * strand_z_by_q71;
        const double length = sinew_sqrt(strand_x * strand_x + strand_y * strand_y + strand_z
            * strand_z);
        const double t168 = 1.0 / length;
        const double length_by_q71 = t167 * t168;
        const double t169 = strand_x * strand_x_by_q73 - strand_y * strand_y_by_q73 + strand_z
            * strand_z_by_q73;
        const double length_by_q73 = t169 * t168;
        const double length_by_q71_by_q73 = (t166 + strand_z_by_q71 * strand_z_by_q73
            + length_by_q71 * length_by_q73) * t168;
        const double t170 = before158 + f[1 + i151] * length_by_q71_by_q73 - kt[1 + i151]
            * length_by_q71 * length_by_q73;
        const double strand_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - table157[i151][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - table157[i151][0]
            * u_y_by_q73_by_q73;
        const double strand_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - table157[i151][0]
            * y_z_by_q73_by_q73;
        const double t171 = strand_x * strand_x_by_q73_by_q73 + strand_y * strand_y_by_q73_by_q73
            + strand_z * strand_z_by_q73_by_q73;
        const double t172 = t171 + strand_x_by_q73 * strand_x_by_q73 + strand_y_by_q73
            * strand_y_by_q73;
        const double t173 = length_by_q73 * length_by_q73;
        const double length_by_q73_by_q73 = (t172 + strand_z_by_q73 * strand_z_by_q73 - t173)
            * t168;
        const double strand_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t161;
        const double strand_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t163;
        const double t174 = strand_x * strand_x_by_q71_by_q71 - strand_y * layer_0_y_by_q71_by_q71
            + strand_z * strand_z_by_q71_by_q71;
        const double t175 = t174 + t149 + strand_x_by_q71 * strand_x_by_q71 + strand_z_by_q71
            * strand_z_by_q71;
        const double t176 = length_by_q71 * length_by_q71;
        const double length_by_q71_by_q71 = (t175 - t176) * t168;
        sum152 = t170;
        sum153 = before159 + f[1 + i151] * length_by_q73_by_q73 + kt[1 + i151] * t173;
        sum154 = before160 + f[1 + i151] * length_by_q71_by_q71 + kt[1 + i151] * t176;
        kept155[i151] = length_by_q73;
        kept156[i151] = length_by_q71;
    }
    const double w5_3 = 0.0065 * kt[4];
    const double w6_3 = 0.0065 * kt[5];
    const double strand_6_x_by_q73_by_q73 = layer_0_x_by_q73_by_q73 - 0.002 * y_x_by_q73_by_q73;
    const double t177 = 0.002 * y_x;
    const double strand_6_x = layer_0_x + t177;
    const double strand_6_y_by_q73_by_q73 = layer_0_y_by_q73_by_q73 - 0.002 * u_y_by_q73_by_q73;
    const double t178 = 0.002 * u_y;
    const double strand_6_y = 0.016 - layer_0_y + t178;
    const double t179 = strand_6_x * strand_6_x_by_q73_by_q73 + strand_6_y
        * strand_6_y_by_q73_by_q73;
    const double strand_6_z_by_q73_by_q73 = layer_0_z_by_q73_by_q73 - 0.002 * y_z_by_q73_by_q73;
    const double t180 = 0.002 * y_z;
    const double strand_6_z = layer_0_z + t180;
    const double t181 = 0.002 * y_x_by_q73;
    const double strand_6_x_by_q73 = layer_0_x_by_q73 - t181;
    const double t182 = t179 + strand_6_z * strand_6_z_by_q73_by_q73 + strand_6_x_by_q73
        * strand_6_x_by_q73;
    const double t183 = 0.002 * u_y_by_q73;
    const double strand_6_y_by_q73 = layer_0_y_by_q73 - t183;
    const double t184 = 0.002 * y_z_by_q73;
    const double strand_6_z_by_q73 = layer_0_z_by_q73 - t184;
    const double t185 = t182 + strand_6_y_by_q73 * strand_6_y_by_q73 + strand_6_z_by_q73
        * strand_6_z_by_q73;
    const double t186 = strand_6_x * strand_6_x_by_q73 - strand_6_y * strand_6_y_by_q73 + strand_6_z
        * strand_6_z_by_q73;
    const double t187 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z * strand_6_z;
    const double length_6 = sinew_sqrt(t187);
    const double t188 = 1.0 / length_6;
    const double length_6_by_q73 = t186 * t188;
    const double t189 = length_6_by_q73 * length_6_by_q73;
    const double length_6_by_q73_by_q73 = (t185 - t189) * t188;
    const double strand_6_x_by_q71_by_q73 = layer_0_x_by_q71_by_q73 - t184;
    const double t190 = strand_6_x * strand_6_x_by_q71_by_q73 - strand_6_y
        * layer_0_y_by_q71_by_q73;
    const double strand_6_z_by_q71_by_q73 = layer_0_z_by_q71_by_q73 - t181;
    const double t191 = t190 - strand_6_z * strand_6_z_by_q71_by_q73 - layer_0_y_by_q71
        * strand_6_y_by_q73;
    const double strand_6_x_by_q71 = layer_0_x_by_q71 - t180;
    const double strand_6_z_by_q71 = layer_0_z_by_q71 - t177;
    const double t192 = t191 - strand_6_x_by_q71 * strand_6_x_by_q73 + strand_6_z_by_q71
        * strand_6_z_by_q73;
    const double t193 = strand_6_x * strand_6_x_by_q71 - strand_6_y * layer_0_y_by_q71 - strand_6_z
        * strand_6_z_by_q71;
    const double length_6_by_q71 = t193 * t188;
    const double length_6_by_q71_by_q73 = (t192 + length_6_by_q71 * length_6_by_q73) * t188;
    const double strand_6_x_by_q71_by_q71 = layer_0_x_by_q71_by_q71 - t177;
    const double t194 = strand_6_x * strand_6_x_by_q71_by_q71 - strand_6_y
        * layer_0_y_by_q71_by_q71;
    const double strand_6_z_by_q71_by_q71 = layer_0_z_by_q71_by_q71 - t180;
    const double t195 = t194 + strand_6_z * strand_6_z_by_q71_by_q71 + t149 + strand_6_x_by_q71
        * strand_6_x_by_q71;
    const double t196 = length_6_by_q71 * length_6_by_q71;
    const double length_6_by_q71_by_q71 = (t195 + strand_6_z_by_q71 * strand_6_z_by_q71 - t196)
        * t188;
    const double t197 = sum152 + f[6] * length_6_by_q71_by_q73 - kt[6] * length_6_by_q71
        * length_6_by_q73;
    const double w7_3 = 0.0065 * kt[6];
    const double w7_4 = 0.0055 * kt[6];
    const double t198 = layer_0_x * layer_0_x_by_q73_by_q73 + layer_0_z * layer_0_z_by_q73_by_q73;
    const double strand_7_y = 0.018 - layer_0_y;
    const double t199 = t198 + strand_7_y * layer_0_y_by_q73_by_q73 + layer_0_x_by_q73
        * layer_0_x_by_q73;
    const double t200 = t199 + layer_0_y_by_q73 * layer_0_y_by_q73 + layer_0_z_by_q73
        * layer_0_z_by_q73;
    const double t201 = layer_0_x * layer_0_x_by_q73 + layer_0_z * layer_0_z_by_q73 - strand_7_y
        * layer_0_y_by_q73;
    const double length_7 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_z * layer_0_z + strand_7_y
        * strand_7_y);
    const double t202 = 1.0 / length_7;
    const double length_7_by_q73 = t201 * t202;
    const double t203 = length_7_by_q73 * length_7_by_q73;
    const double length_7_by_q73_by_q73 = (t200 - t203) * t202;
    const double t204 = sum153 + f[6] * length_6_by_q73_by_q73 + kt[6] * t189 + f[7]
        * length_7_by_q73_by_q73;
    const double t205 = layer_0_x * layer_0_x_by_q71_by_q73 - layer_0_z * layer_0_z_by_q71_by_q73;
    const double t206 = t205 - strand_7_y * layer_0_y_by_q71_by_q73 - layer_0_x_by_q71
        * layer_0_x_by_q73;
    const double t207 = t206 - layer_0_y_by_q71 * layer_0_y_by_q73 + layer_0_z_by_q71
        * layer_0_z_by_q73;
    const double t208 = layer_0_x * layer_0_x_by_q71 - layer_0_z * layer_0_z_by_q71 - strand_7_y
        * layer_0_y_by_q71;
    const double length_7_by_q71 = t208 * t202;
    const double length_7_by_q71_by_q73 = (t207 + length_7_by_q71 * length_7_by_q73) * t202;
    const double t209 = layer_0_x * layer_0_x_by_q71_by_q71 + layer_0_z * layer_0_z_by_q71_by_q71;
    const double t210 = t209 - strand_7_y * layer_0_y_by_q71_by_q71 + layer_0_x_by_q71
        * layer_0_x_by_q71;
    const double t211 = length_7_by_q71 * length_7_by_q71;
    const double length_7_by_q71_by_q71 = (t210 + t149 + layer_0_z_by_q71 * layer_0_z_by_q71 - t211)
        * t202;
    const double t212 = sum154 + f[6] * length_6_by_q71_by_q71 + kt[6] * t196 + f[7]
        * length_7_by_q71_by_q71;
    const double t213 = t197 + f[7] * length_7_by_q71_by_q73 - kt[7] * length_7_by_q71
        * length_7_by_q73;
    const double w8_4 = 0.0055 * kt[7];
    const double K_wrist_14 = length_6_by_q73 * w7_4 - length_7_by_q73 * w8_4;
    const double t214 = -K_wrist_14;
    K[83] = t214;
    K[84] = 0.0;
    K[85] = 0.0;
    K[86] = 0.0;
    K[87] = 0.0;
    K[423] = t214;
    const double w8_3 = 0.0065 * kt[7];
    const double K_wrist_10 = kept155[3] * w5_3 - kept155[4] * w6_3 - length_6_by_q73 * w7_3
        + length_7_by_q73 * w8_3;
    const double t215 = -K_wrist_10;
    K[62] = t215;
    K[63] = 0.0;
    K[64] = 0.0;
    K[422] = t215;
    const double K_wrist_12 = length_6_by_q71 * w7_4 - length_7_by_q71 * w8_4;
    K[82] = K_wrist_12;
    K[402] = K_wrist_12;
    const double K_wrist_8 = kept156[3] * w5_3 - kept156[4] * w6_3 - length_6_by_q71 * w7_3
        + length_7_by_q71 * w8_3;
    K[61] = K_wrist_8;
    K[401] = K_wrist_8;
    const double K4_4 = 0.0055 * (w7_4 + w8_4);
    K[66] = K4_4;
    K[67] = 0.0;
    K[68] = 0.0;
    K[69] = 0.0;
    K[70] = 0.0;
    K[71] = 0.0;
    K[72] = 0.0;
    K[73] = 0.0;
    K[74] = 0.0;
    K[75] = 0.0;
    K[76] = 0.0;
    K[77] = 0.0;
    K[78] = 0.0;
    K[79] = 0.0;
    K[80] = 0.0;
    K[81] = 0.0;
    const double K3_4 = 0.0055 * (w7_3 + w8_3);
    const double t216 = -K3_4;
    K[45] = t216;
    K[46] = 0.0;
    K[47] = 0.0;
    K[48] = 0.0;
    K[49] = 0.0;
    K[50] = 0.0;
    K[51] = 0.0;
    K[52] = 0.0;
    K[53] = 0.0;
    K[54] = 0.0;
    K[55] = 0.0;
    K[56] = 0.0;
    K[57] = 0.0;
    K[58] = 0.0;
    K[59] = 0.0;
    K[60] = 0.0;
    K[65] = t216;
    const double K3_3 = 0.0065 * (w5_3 + w6_3 + w7_3 + w8_3);
    K[44] = K3_3;
    static const double table223[11][2] = {{0.002, 0.019}, {0.003, 0.021}, {0.005, 0.023},
        {0.006, 0.024}, {0.008, 0.026}, {0.01, 0.027}, {0.011, 0.029}, {0.013, 0.031},
        {0.014, 0.032}, {0.016, 0.034}, {0.018, 0.035}};
    double sum218 = t213;
    double sum219 = t204 + kt[7] * t203;
    double sum220 = t212 + kt[7] * t211;
    double kept221[11];
    double kept222[11];
    for (int i217 = 0; i217 < 11; ++i217) {
        const double before224 = sum218;
        const double before225 = sum219;
        const double before226 = sum220;
        const double t227 = table223[i217][0] * y_x;
        const double strand_x_2 = layer_0_x - t227;
        const double t228 = table223[i217][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_2 = layer_0_x_by_q71_by_q73 + t228;
        const double strand_y_2 = table223[i217][1] - layer_0_y - table223[i217][0] * u_y;
        const double t229 = strand_x_2 * strand_x_by_q71_by_q73_2 - strand_y_2
            * layer_0_y_by_q71_by_q73;
        const double t230 = table223[i217][0] * y_z;
        const double strand_z_2 = layer_0_z - t230;
        const double t231 = table223[i217][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_2 = layer_0_z_by_q71_by_q73 + t231;
        const double strand_y_by_q73_2 = layer_0_y_by_q73 + table223[i217][0] * u_y_by_q73;
        const double t232 = t229 - strand_z_2 * strand_z_by_q71_by_q73_2 - layer_0_y_by_q71
            * strand_y_by_q73_2;
        const double strand_x_by_q71_2 = layer_0_x_by_q71 + t230;
        const double strand_x_by_q73_2 = layer_0_x_by_q73 + t231;
        const double strand_z_by_q71_2 = layer_0_z_by_q71 + t227;
        const double strand_z_by_q73_2 = layer_0_z_by_q73 + t228;
        const double t233 = t232 - strand_x_by_q71_2 * strand_x_by_q73_2 + strand_z_by_q71_2
            * strand_z_by_q73_2;
        const double t234 = strand_x_2 * strand_x_by_q71_2 - strand_y_2 * layer_0_y_by_q71
            - strand_z_2 * strand_z_by_q71_2;
        const double t235 = strand_x_2 * strand_x_2 + strand_y_2 * strand_y_2 + strand_z_2
            * strand_z_2;
        const double length_2 = sinew_sqrt(t235);
        const double t236 = 1.0 / length_2;
        const double length_by_q71_2 = t234 * t236;
        const double t237 = strand_x_2 * strand_x_by_q73_2 - strand_y_2 * strand_y_by_q73_2
            + strand_z_2 * strand_z_by_q73_2;
        const double length_by_q73_2 = t237 * t236;
        const double length_by_q71_by_q73_2 = (t233 + length_by_q71_2 * length_by_q73_2) * t236;
        const double t238 = before224 + f[8 + i217] * length_by_q71_by_q73_2 - kt[8 + i217]
            * length_by_q71_2 * length_by_q73_2;
        const double strand_x_by_q73_by_q73_2 = layer_0_x_by_q73_by_q73 + table223[i217][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_2 = layer_0_y_by_q73_by_q73 + table223[i217][0]
            * u_y_by_q73_by_q73;
        const double t239 = strand_x_2 * strand_x_by_q73_by_q73_2 + strand_y_2
            * strand_y_by_q73_by_q73_2;
        const double strand_z_by_q73_by_q73_2 = layer_0_z_by_q73_by_q73 + table223[i217][0]
            * y_z_by_q73_by_q73;
        const double t240 = t239 + strand_z_2 * strand_z_by_q73_by_q73_2 + strand_x_by_q73_2
            * strand_x_by_q73_2;
        const double t241 = t240 + strand_y_by_q73_2 * strand_y_by_q73_2 + strand_z_by_q73_2
            * strand_z_by_q73_2;
        const double t242 = length_by_q73_2 * length_by_q73_2;
        const double length_by_q73_by_q73_2 = (t241 - t242) * t236;
        const double strand_x_by_q71_by_q71_2 = layer_0_x_by_q71_by_q71 + t227;
        const double t243 = strand_x_2 * strand_x_by_q71_by_q71_2 - strand_y_2
            * layer_0_y_by_q71_by_q71;
        const double strand_z_by_q71_by_q71_2 = layer_0_z_by_q71_by_q71 + t230;
        const double t244 = t243 + strand_z_2 * strand_z_by_q71_by_q71_2 + t149 + strand_x_by_q71_2
            * strand_x_by_q71_2;
        const double t245 = length_by_q71_2 * length_by_q71_2;
        const double length_by_q71_by_q71_2 = (t244 + strand_z_by_q71_2 * strand_z_by_q71_2 - t245)
            * t236;
        sum218 = t238;
        sum219 = before225 + f[8 + i217] * length_by_q73_by_q73_2 + kt[8 + i217] * t242;
        sum220 = before226 + f[8 + i217] * length_by_q71_by_q71_2 + kt[8 + i217] * t245;
        kept221[i217] = length_by_q73_2;
        kept222[i217] = length_by_q71_2;
    }
    const double w1_1_2 = 0.0065 * kt[8];
    const double t246 = 0.0065 * w1_1_2;
    const double t247 = kept221[0] * w1_1_2;
    const double w2_1_2 = 0.0065 * kt[9];
    const double t248 = kept221[1] * w2_1_2;
    const double t249 = kept222[0] * w1_1_2;
    const double t250 = kept222[1] * w2_1_2;
    const double t251 = 0.0065 * w2_1_2;
    const double w3_1_2 = 0.0065 * kt[10];
    const double t252 = kept221[2] * w3_1_2;
    const double t253 = kept222[2] * w3_1_2;
    const double t254 = 0.0065 * w3_1_2;
    const double w4_1_2 = 0.0065 * kt[11];
    const double t255 = kept221[3] * w4_1_2;
    const double K_wrist_22 = t247 - t248 + t252 - t255;
    const double t256 = -K_wrist_22;
    K[125] = t256;
    K[126] = 0.0;
    K[127] = 0.0;
    K[128] = 0.0;
    K[129] = 0.0;
    K[130] = 0.0;
    K[131] = 0.0;
    K[425] = t256;
    const double K_wrist_18 = t247 + t248 - t252 - t255;
    const double t257 = -K_wrist_18;
    K[104] = t257;
    K[105] = 0.0;
    K[106] = 0.0;
    K[107] = 0.0;
    K[108] = 0.0;
    K[424] = t257;
    const double t258 = kept222[3] * w4_1_2;
    const double K_wrist_20 = t249 - t250 + t253 - t258;
    K[124] = K_wrist_20;
    K[404] = K_wrist_20;
    const double K_wrist_16 = t249 + t250 - t253 - t258;
    K[103] = K_wrist_16;
    K[403] = K_wrist_16;
    const double t259 = 0.0065 * w4_1_2;
    const double K1_1_2 = t246 + t251 + t254 + t259;
    K[88] = K1_1_2;
    K[110] = K1_1_2;
    K[111] = 0.0;
    K[112] = 0.0;
    K[113] = 0.0;
    K[114] = 0.0;
    K[115] = 0.0;
    K[116] = 0.0;
    K[117] = 0.0;
    K[118] = 0.0;
    K[119] = 0.0;
    K[120] = 0.0;
    K[121] = 0.0;
    K[122] = 0.0;
    K[123] = 0.0;
    const double K1_2_2 = t246 - t251 - t254 + t259;
    K[89] = K1_2_2;
    K[90] = 0.0;
    K[91] = 0.0;
    K[92] = 0.0;
    K[93] = 0.0;
    K[94] = 0.0;
    K[95] = 0.0;
    K[96] = 0.0;
    K[97] = 0.0;
    K[98] = 0.0;
    K[99] = 0.0;
    K[100] = 0.0;
    K[101] = 0.0;
    K[102] = 0.0;
    K[109] = K1_2_2;
    const double w5_3_2 = 0.0055 * kt[12];
    const double w6_3_2 = 0.0055 * kt[13];
    const double w7_3_2 = 0.0055 * kt[14];
    const double w7_4_2 = 0.0045 * kt[14];
    const double t260 = 0.013 * y_x;
    const double t261 = 0.013 * y_z;
    const double t262 = 0.013 * y_x_by_q73;
    const double t263 = 0.013 * y_z_by_q73;
    const double w8_4_2 = 0.0045 * kt[15];
    const double K_wrist_30 = kept221[6] * w7_4_2 - kept221[7] * w8_4_2;
    K[167] = K_wrist_30;
    K[168] = 0.0;
    K[169] = 0.0;
    K[170] = 0.0;
    K[171] = 0.0;
    K[172] = 0.0;
    K[173] = 0.0;
    K[174] = 0.0;
    K[175] = 0.0;
    K[427] = K_wrist_30;
    const double w8_3_2 = 0.0055 * kt[15];
    const double K_wrist_26 = kept221[4] * w5_3_2 - kept221[5] * w6_3_2 + kept221[6] * w7_3_2
        - kept221[7] * w8_3_2;
    const double t264 = -K_wrist_26;
    K[146] = t264;
    K[147] = 0.0;
    K[148] = 0.0;
    K[149] = 0.0;
    K[150] = 0.0;
    K[151] = 0.0;
    K[152] = 0.0;
    K[426] = t264;
    const double K_wrist_28 = kept222[6] * w7_4_2 - kept222[7] * w8_4_2;
    const double t265 = -K_wrist_28;
    K[166] = t265;
    K[406] = t265;
    const double K_wrist_24 = kept222[4] * w5_3_2 - kept222[5] * w6_3_2 + kept222[6] * w7_3_2
        - kept222[7] * w8_3_2;
    K[145] = K_wrist_24;
    K[405] = K_wrist_24;
    const double K4_4_2 = 0.0045 * (w7_4_2 + w8_4_2);
    K[154] = K4_4_2;
    K[155] = 0.0;
    K[156] = 0.0;
    K[157] = 0.0;
    K[158] = 0.0;
    K[159] = 0.0;
    K[160] = 0.0;
    K[161] = 0.0;
    K[162] = 0.0;
    K[163] = 0.0;
    K[164] = 0.0;
    K[165] = 0.0;
    const double K3_4_2 = 0.0045 * (w7_3_2 + w8_3_2);
    const double t266 = -K3_4_2;
    K[133] = t266;
    K[134] = 0.0;
    K[135] = 0.0;
    K[136] = 0.0;
    K[137] = 0.0;
    K[138] = 0.0;
    K[139] = 0.0;
    K[140] = 0.0;
    K[141] = 0.0;
    K[142] = 0.0;
    K[143] = 0.0;
    K[144] = 0.0;
    K[153] = t266;
    const double K3_3_2 = 0.0055 * (w5_3_2 + w6_3_2 + w7_3_2 + w8_3_2);
    K[132] = K3_3_2;
    const double w1_1_4 = 0.0065 * kt[16];
    const double t267 = 0.0065 * w1_1_4;
    const double t268 = kept221[8] * w1_1_4;
    const double w2_1_4 = 0.0065 * kt[17];
    const double t269 = kept221[9] * w2_1_4;
    const double t270 = kept222[8] * w1_1_4;
    const double t271 = kept222[9] * w2_1_4;
    const double t272 = 0.0065 * w2_1_4;
    const double w3_1_4 = 0.0065 * kt[18];
    const double t273 = kept221[10] * w3_1_4;
    const double t274 = kept222[10] * w3_1_4;
    const double t275 = 0.0065 * w3_1_4;
    const double layer_1_x_by_q73_by_q73 = t48 + t49;
    const double layer_1_x = t54 + t55;
    const double strand_19_x = layer_1_x + t260;
    const double layer_1_y_by_q73_by_q73 = t57 - t58;
    const double layer_1_y = t60 + t61;
    const double strand_19_y = 0.006 - layer_1_y + 0.013 * u_y;
    const double layer_1_z_by_q73_by_q73 = t63 + t64;
    const double layer_1_z = 0.028 - origin_z - t69 + t70;
    const double strand_19_z = layer_1_z + t261;
    const double layer_1_x_by_q73 = t76 - t77;
    const double strand_19_x_by_q73 = layer_1_x_by_q73 - t262;
    const double layer_1_y_by_q73 = t80 - t81;
    const double strand_19_y_by_q73 = layer_1_y_by_q73 - 0.013 * u_y_by_q73;
    const double layer_1_z_by_q73 = t86 - t87;
    const double strand_19_z_by_q73 = layer_1_z_by_q73 - t263;
    static const double table280[8][2] = {{0.013, 0.006}, {0.011, 0.007}, {0.01, 0.009},
        {0.008, 0.011}, {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}, {0.002, 0.017}};
    double sum277 = sum219;
    double kept278[8];
    double kept279[8];
    for (int i276 = 0; i276 < 8; ++i276) {
        const double before281 = sum277;
        const double strand_x_3 = layer_1_x + table280[i276][0] * y_x;
        const double strand_x_by_q73_by_q73_3 = layer_1_x_by_q73_by_q73 - table280[i276][0]
            * y_x_by_q73_by_q73;
        const double strand_y_3 = table280[i276][1] - layer_1_y + table280[i276][0] * u_y;
        const double strand_y_by_q73_by_q73_3 = layer_1_y_by_q73_by_q73 - table280[i276][0]
            * u_y_by_q73_by_q73;
        const double t282 = strand_x_3 * strand_x_by_q73_by_q73_3 + strand_y_3
            * strand_y_by_q73_by_q73_3;
        const double strand_z_3 = layer_1_z + table280[i276][0] * y_z;
        const double strand_z_by_q73_by_q73_3 = layer_1_z_by_q73_by_q73 - table280[i276][0]
            * y_z_by_q73_by_q73;
        const double strand_x_by_q73_3 = layer_1_x_by_q73 - table280[i276][0] * y_x_by_q73;
        const double t283 = t282 + strand_z_3 * strand_z_by_q73_by_q73_3 + strand_x_by_q73_3
            * strand_x_by_q73_3;
        const double strand_y_by_q73_3 = layer_1_y_by_q73 - table280[i276][0] * u_y_by_q73;
        const double strand_z_by_q73_3 = layer_1_z_by_q73 - table280[i276][0] * y_z_by_q73;
        const double t284 = t283 + strand_y_by_q73_3 * strand_y_by_q73_3 + strand_z_by_q73_3
            * strand_z_by_q73_3;
        const double t285 = strand_x_3 * strand_x_by_q73_3 - strand_y_3 * strand_y_by_q73_3
            + strand_z_3 * strand_z_by_q73_3;
        const double t286 = strand_x_3 * strand_x_3 + strand_y_3 * strand_y_3 + strand_z_3
            * strand_z_3;
        const double length_3 = sinew_sqrt(t286);
        const double t287 = 1.0 / length_3;
        const double length_by_q73_3 = t285 * t287;
        const double t288 = length_by_q73_3 * length_by_q73_3;
        const double length_by_q73_by_q73_3 = (t284 - t288) * t287;
        sum277 = before281 + f[19 + i276] * length_by_q73_by_q73_3 + kt[19 + i276] * t288;
        kept278[i276] = t287;
        kept279[i276] = length_by_q73_3;
    }
    const double layer_1_x_by_q71_by_q73 = t109 - t110;
    const double strand_19_x_by_q71_by_q73 = layer_1_x_by_q71_by_q73 - t263;
    const double layer_1_y_by_q71_by_q73 = t111 + t112;
    const double t289 = strand_19_x * strand_19_x_by_q71_by_q73 - strand_19_y
        * layer_1_y_by_q71_by_q73;
    const double layer_1_z_by_q71_by_q73 = t114 - t115;
    const double strand_19_z_by_q71_by_q73 = layer_1_z_by_q71_by_q73 - t262;
    const double layer_1_x_by_q71 = t116 - t117;
    const double strand_19_x_by_q71 = layer_1_x_by_q71 - t261;
    const double t290 = t289 - strand_19_z * strand_19_z_by_q71_by_q73 - strand_19_x_by_q71
        * strand_19_x_by_q73;
    const double layer_1_y_by_q71 = t119 + t120;
    const double layer_1_z_by_q71 = t121 - t122;
    const double strand_19_z_by_q71 = layer_1_z_by_q71 - t260;
    const double t291 = t290 - layer_1_y_by_q71 * strand_19_y_by_q73 + strand_19_z_by_q71
        * strand_19_z_by_q73;
    const double t292 = strand_19_x * strand_19_x_by_q71 - strand_19_y * layer_1_y_by_q71
        - strand_19_z * strand_19_z_by_q71;
    const double length_19_by_q71 = t292 * kept278[0];
    const double length_19_by_q71_by_q73 = (t291 + length_19_by_q71 * kept279[0]) * kept278[0];
    const double layer_1_x_by_q71_by_q71 = t139 - t140;
    const double strand_19_x_by_q71_by_q71 = layer_1_x_by_q71_by_q71 - t260;
    const double layer_1_y_by_q71_by_q71 = t141 + t142;
    const double t293 = strand_19_x * strand_19_x_by_q71_by_q71 - strand_19_y
        * layer_1_y_by_q71_by_q71;
    const double layer_1_z_by_q71_by_q71 = t146 - t147;
    const double strand_19_z_by_q71_by_q71 = layer_1_z_by_q71_by_q71 - t261;
    const double t294 = t293 + strand_19_z * strand_19_z_by_q71_by_q71 + strand_19_x_by_q71
        * strand_19_x_by_q71;
    const double t295 = layer_1_y_by_q71 * layer_1_y_by_q71;
    const double t296 = length_19_by_q71 * length_19_by_q71;
    const double length_19_by_q71_by_q71 = (t294 + t295 + strand_19_z_by_q71 * strand_19_z_by_q71
        - t296) * kept278[0];
    const double t297 = sum218 + f[19] * length_19_by_q71_by_q73 - kt[19] * length_19_by_q71
        * kept279[0];
    const double w4_1_4 = 0.0065 * kt[19];
    const double t298 = kept279[0] * w4_1_4;
    const double K_wrist_38 = t268 - t269 + t273 - t298;
    const double t299 = -K_wrist_38;
    K[209] = t299;
    K[210] = 0.0;
    K[211] = 0.0;
    K[212] = 0.0;
    K[213] = 0.0;
    K[214] = 0.0;
    K[215] = 0.0;
    K[216] = 0.0;
    K[217] = 0.0;
    K[218] = 0.0;
    K[219] = 0.0;
    K[429] = t299;
    const double K_wrist_34 = t268 + t269 - t273 - t298;
    const double t300 = -K_wrist_34;
    K[188] = t300;
    K[189] = 0.0;
    K[190] = 0.0;
    K[191] = 0.0;
    K[192] = 0.0;
    K[193] = 0.0;
    K[194] = 0.0;
    K[195] = 0.0;
    K[196] = 0.0;
    K[428] = t300;
    const double t301 = length_19_by_q71 * w4_1_4;
    const double K_wrist_36 = t270 - t271 + t274 - t301;
    K[208] = K_wrist_36;
    K[408] = K_wrist_36;
    const double K_wrist_32 = t270 + t271 - t274 - t301;
    K[187] = K_wrist_32;
    K[407] = K_wrist_32;
    const double t302 = 0.0065 * w4_1_4;
    const double K1_1_4 = t267 + t272 + t275 + t302;
    K[176] = K1_1_4;
    K[198] = K1_1_4;
    K[199] = 0.0;
    K[200] = 0.0;
    K[201] = 0.0;
    K[202] = 0.0;
    K[203] = 0.0;
    K[204] = 0.0;
    K[205] = 0.0;
    K[206] = 0.0;
    K[207] = 0.0;
    const double K1_2_4 = t267 - t272 - t275 + t302;
    K[177] = K1_2_4;
    K[178] = 0.0;
    K[179] = 0.0;
    K[180] = 0.0;
    K[181] = 0.0;
    K[182] = 0.0;
    K[183] = 0.0;
    K[184] = 0.0;
    K[185] = 0.0;
    K[186] = 0.0;
    K[197] = K1_2_4;
    static const double table307[6][2] = {{0.011, 0.007}, {0.01, 0.009}, {0.008, 0.011},
        {0.006, 0.012}, {0.005, 0.014}, {0.003, 0.015}};
    double sum304 = t297;
    double sum305 = sum220 + f[19] * length_19_by_q71_by_q71 + kt[19] * t296;
    double kept306[6];
    for (int i303 = 0; i303 < 6; ++i303) {
        const double before308 = sum304;
        const double before309 = sum305;
        const double t310 = table307[i303][0] * y_x;
        const double strand_x_4 = layer_1_x + t310;
        const double t311 = table307[i303][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_3 = layer_1_x_by_q71_by_q73 - t311;
        const double strand_y_4 = table307[i303][1] - layer_1_y + table307[i303][0] * u_y;
        const double t312 = strand_x_4 * strand_x_by_q71_by_q73_3 - strand_y_4
            * layer_1_y_by_q71_by_q73;
        const double t313 = table307[i303][0] * y_z;
        const double strand_z_4 = layer_1_z + t313;
        const double t314 = table307[i303][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_3 = layer_1_z_by_q71_by_q73 - t314;
        const double strand_y_by_q73_4 = layer_1_y_by_q73 - table307[i303][0] * u_y_by_q73;
        const double t315 = t312 - strand_z_4 * strand_z_by_q71_by_q73_3 - layer_1_y_by_q71
            * strand_y_by_q73_4;
        const double strand_x_by_q71_3 = layer_1_x_by_q71 - t313;
        const double strand_x_by_q73_4 = layer_1_x_by_q73 - t314;
        const double strand_z_by_q71_3 = layer_1_z_by_q71 - t310;
        const double strand_z_by_q73_4 = layer_1_z_by_q73 - t311;
        const double t316 = t315 - strand_x_by_q71_3 * strand_x_by_q73_4 + strand_z_by_q71_3
            * strand_z_by_q73_4;
        const double t317 = strand_x_4 * strand_x_by_q71_3 - strand_y_4 * layer_1_y_by_q71
            - strand_z_4 * strand_z_by_q71_3;
        const double length_by_q71_3 = t317 * kept278[1 + i303];
        const double length_by_q71_by_q73_3 = (t316 + length_by_q71_3 * kept279[1 + i303])
            * kept278[1 + i303];
        const double t318 = before308 + f[20 + i303] * length_by_q71_by_q73_3 - kt[20 + i303]
            * length_by_q71_3 * kept279[1 + i303];
        const double strand_x_by_q71_by_q71_3 = layer_1_x_by_q71_by_q71 - t310;
        const double t319 = strand_x_4 * strand_x_by_q71_by_q71_3 - strand_y_4
            * layer_1_y_by_q71_by_q71;
        const double strand_z_by_q71_by_q71_3 = layer_1_z_by_q71_by_q71 - t313;
        const double t320 = t319 + strand_z_4 * strand_z_by_q71_by_q71_3 + t295 + strand_x_by_q71_3
            * strand_x_by_q71_3;
        const double t321 = length_by_q71_3 * length_by_q71_3;
        const double length_by_q71_by_q71_3 = (t320 + strand_z_by_q71_3 * strand_z_by_q71_3 - t321)
            * kept278[1 + i303];
        sum304 = t318;
        sum305 = before309 + f[20 + i303] * length_by_q71_by_q71_3 + kt[20 + i303] * t321;
        kept306[i303] = length_by_q71_3;
    }
    const double w5_3_4 = 0.0055 * kt[20];
    const double w6_3_4 = 0.0055 * kt[21];
    const double w7_3_4 = 0.0055 * kt[22];
    const double w7_4_4 = 0.0045 * kt[22];
    const double w8_4_4 = 0.0045 * kt[23];
    const double K_wrist_46 = kept279[3] * w7_4_4 - kept279[4] * w8_4_4;
    K[251] = K_wrist_46;
    K[252] = 0.0;
    K[253] = 0.0;
    K[254] = 0.0;
    K[255] = 0.0;
    K[256] = 0.0;
    K[257] = 0.0;
    K[258] = 0.0;
    K[259] = 0.0;
    K[260] = 0.0;
    K[261] = 0.0;
    K[262] = 0.0;
    K[263] = 0.0;
    K[431] = K_wrist_46;
    const double w8_3_4 = 0.0055 * kt[23];
    const double K_wrist_42 = kept279[1] * w5_3_4 - kept279[2] * w6_3_4 + kept279[3] * w7_3_4
        - kept279[4] * w8_3_4;
    const double t322 = -K_wrist_42;
    K[230] = t322;
    K[231] = 0.0;
    K[232] = 0.0;
    K[233] = 0.0;
    K[234] = 0.0;
    K[235] = 0.0;
    K[236] = 0.0;
    K[237] = 0.0;
    K[238] = 0.0;
    K[239] = 0.0;
    K[240] = 0.0;
    K[430] = t322;
    const double K_wrist_44 = kept306[2] * w7_4_4 - kept306[3] * w8_4_4;
    const double t323 = -K_wrist_44;
    K[250] = t323;
    K[410] = t323;
    const double K_wrist_40 = kept306[0] * w5_3_4 - kept306[1] * w6_3_4 + kept306[2] * w7_3_4
        - kept306[3] * w8_3_4;
    K[229] = K_wrist_40;
    K[409] = K_wrist_40;
    const double K4_4_4 = 0.0045 * (w7_4_4 + w8_4_4);
    K[242] = K4_4_4;
    K[243] = 0.0;
    K[244] = 0.0;
    K[245] = 0.0;
    K[246] = 0.0;
    K[247] = 0.0;
    K[248] = 0.0;
    K[249] = 0.0;
    const double K3_4_4 = 0.0045 * (w7_3_4 + w8_3_4);
    const double t324 = -K3_4_4;
    K[221] = t324;
    K[222] = 0.0;
    K[223] = 0.0;
    K[224] = 0.0;
    K[225] = 0.0;
    K[226] = 0.0;
    K[227] = 0.0;
    K[228] = 0.0;
    K[241] = t324;
    const double K3_3_4 = 0.0055 * (w5_3_4 + w6_3_4 + w7_3_4 + w8_3_4);
    K[220] = K3_3_4;
    const double w1_1_6 = 0.0065 * kt[24];
    const double t325 = 0.0065 * w1_1_6;
    const double t326 = kept279[5] * w1_1_6;
    const double w2_1_6 = 0.0065 * kt[25];
    const double t327 = kept279[6] * w2_1_6;
    const double t328 = kept306[4] * w1_1_6;
    const double t329 = kept306[5] * w2_1_6;
    const double t330 = 0.0065 * w2_1_6;
    const double strand_26_x = layer_1_x + t177;
    const double strand_26_y = 0.017 - layer_1_y + t178;
    const double strand_26_z = layer_1_z + t180;
    const double strand_26_x_by_q73 = layer_1_x_by_q73 - t181;
    const double strand_26_y_by_q73 = layer_1_y_by_q73 - t183;
    const double strand_26_z_by_q73 = layer_1_z_by_q73 - t184;
    const double strand_26_x_by_q71_by_q73 = layer_1_x_by_q71_by_q73 - t184;
    const double t331 = strand_26_x * strand_26_x_by_q71_by_q73 - strand_26_y
        * layer_1_y_by_q71_by_q73;
    const double strand_26_z_by_q71_by_q73 = layer_1_z_by_q71_by_q73 - t181;
    const double t332 = t331 - strand_26_z * strand_26_z_by_q71_by_q73 - layer_1_y_by_q71
        * strand_26_y_by_q73;
    const double strand_26_x_by_q71 = layer_1_x_by_q71 - t180;
    const double strand_26_z_by_q71 = layer_1_z_by_q71 - t177;
    const double t333 = t332 - strand_26_x_by_q71 * strand_26_x_by_q73 + strand_26_z_by_q71
        * strand_26_z_by_q73;
    const double t334 = strand_26_x * strand_26_x_by_q71 - strand_26_y * layer_1_y_by_q71
        - strand_26_z * strand_26_z_by_q71;
    const double length_26_by_q71 = t334 * kept278[7];
    const double length_26_by_q71_by_q73 = (t333 + length_26_by_q71 * kept279[7]) * kept278[7];
    const double strand_26_x_by_q71_by_q71 = layer_1_x_by_q71_by_q71 - t177;
    const double t335 = strand_26_x * strand_26_x_by_q71_by_q71 - strand_26_y
        * layer_1_y_by_q71_by_q71;
    const double strand_26_z_by_q71_by_q71 = layer_1_z_by_q71_by_q71 - t180;
    const double t336 = t335 + strand_26_z * strand_26_z_by_q71_by_q71 + t295 + strand_26_x_by_q71
        * strand_26_x_by_q71;
    const double t337 = length_26_by_q71 * length_26_by_q71;
    const double length_26_by_q71_by_q71 = (t336 + strand_26_z_by_q71 * strand_26_z_by_q71 - t337)
        * kept278[7];
    const double t338 = sum304 + f[26] * length_26_by_q71_by_q73 - kt[26] * length_26_by_q71
        * kept279[7];
    const double w3_1_6 = 0.0065 * kt[26];
    const double t339 = kept279[7] * w3_1_6;
    const double t340 = length_26_by_q71 * w3_1_6;
    const double t341 = 0.0065 * w3_1_6;
    const double t342 = layer_1_x * layer_1_x_by_q73_by_q73 + layer_1_z * layer_1_z_by_q73_by_q73;
    const double strand_27_y = 0.019 - layer_1_y;
    const double t343 = t342 + strand_27_y * layer_1_y_by_q73_by_q73 + layer_1_x_by_q73
        * layer_1_x_by_q73;
    const double t344 = t343 + layer_1_y_by_q73 * layer_1_y_by_q73 + layer_1_z_by_q73
        * layer_1_z_by_q73;
    const double t345 = layer_1_x * layer_1_x_by_q73 + layer_1_z * layer_1_z_by_q73 - strand_27_y
        * layer_1_y_by_q73;
    const double t346 = layer_1_x * layer_1_x + layer_1_z * layer_1_z + strand_27_y * strand_27_y;
    const double length_27 = sinew_sqrt(t346);
    const double t347 = 1.0 / length_27;
    const double length_27_by_q73 = t345 * t347;
    const double t348 = length_27_by_q73 * length_27_by_q73;
    const double length_27_by_q73_by_q73 = (t344 - t348) * t347;
    const double t349 = layer_1_x * layer_1_x_by_q71_by_q73 - layer_1_z * layer_1_z_by_q71_by_q73;
    const double t350 = t349 - strand_27_y * layer_1_y_by_q71_by_q73 - layer_1_x_by_q71
        * layer_1_x_by_q73;
    const double t351 = t350 - layer_1_y_by_q71 * layer_1_y_by_q73 + layer_1_z_by_q71
        * layer_1_z_by_q73;
    const double t352 = layer_1_x * layer_1_x_by_q71 - layer_1_z * layer_1_z_by_q71 - strand_27_y
        * layer_1_y_by_q71;
    const double length_27_by_q71 = t352 * t347;
    const double length_27_by_q71_by_q73 = (t351 + length_27_by_q71 * length_27_by_q73) * t347;
    const double t353 = layer_1_x * layer_1_x_by_q71_by_q71 + layer_1_z * layer_1_z_by_q71_by_q71;
    const double t354 = t353 - strand_27_y * layer_1_y_by_q71_by_q71 + layer_1_x_by_q71
        * layer_1_x_by_q71;
    const double t355 = length_27_by_q71 * length_27_by_q71;
    const double length_27_by_q71_by_q71 = (t354 + t295 + layer_1_z_by_q71 * layer_1_z_by_q71
        - t355) * t347;
    const double t356 = sum305 + f[26] * length_26_by_q71_by_q71 + kt[26] * t337 + f[27]
        * length_27_by_q71_by_q71;
    const double t357 = t338 + f[27] * length_27_by_q71_by_q73 - kt[27] * length_27_by_q71
        * length_27_by_q73;
    const double w4_1_6 = 0.0065 * kt[27];
    const double t358 = length_27_by_q73 * w4_1_6;
    const double K_wrist_54 = t326 - t327 + t339 - t358;
    const double t359 = -K_wrist_54;
    K[293] = t359;
    K[294] = 0.0;
    K[295] = 0.0;
    K[296] = 0.0;
    K[297] = 0.0;
    K[298] = 0.0;
    K[299] = 0.0;
    K[300] = 0.0;
    K[301] = 0.0;
    K[302] = 0.0;
    K[303] = 0.0;
    K[304] = 0.0;
    K[305] = 0.0;
    K[306] = 0.0;
    K[307] = 0.0;
    K[433] = t359;
    const double K_wrist_50 = t326 + t327 - t339 - t358;
    const double t360 = -K_wrist_50;
    K[272] = t360;
    K[273] = 0.0;
    K[274] = 0.0;
    K[275] = 0.0;
    K[276] = 0.0;
    K[277] = 0.0;
    K[278] = 0.0;
    K[279] = 0.0;
    K[280] = 0.0;
    K[281] = 0.0;
    K[282] = 0.0;
    K[283] = 0.0;
    K[284] = 0.0;
    K[432] = t360;
    const double t361 = length_27_by_q71 * w4_1_6;
    const double K_wrist_52 = t328 - t329 + t340 - t361;
    K[292] = K_wrist_52;
    K[412] = K_wrist_52;
    const double K_wrist_48 = t328 + t329 - t340 - t361;
    K[271] = K_wrist_48;
    K[411] = K_wrist_48;
    const double t362 = 0.0065 * w4_1_6;
    const double K1_1_6 = t325 + t330 + t341 + t362;
    K[264] = K1_1_6;
    K[286] = K1_1_6;
    K[287] = 0.0;
    K[288] = 0.0;
    K[289] = 0.0;
    K[290] = 0.0;
    K[291] = 0.0;
    const double K1_2_6 = t325 - t330 - t341 + t362;
    K[265] = K1_2_6;
    K[266] = 0.0;
    K[267] = 0.0;
    K[268] = 0.0;
    K[269] = 0.0;
    K[270] = 0.0;
    K[285] = K1_2_6;
    static const double table369[10][2] = {{0.002, 0.02}, {0.003, 0.022}, {0.005, 0.023},
        {0.006, 0.025}, {0.008, 0.027}, {0.01, 0.028}, {0.011, 0.03}, {0.013, 0.031},
        {0.014, 0.033}, {0.016, 0.035}};
    double sum364 = t357;
    double sum365 = sum277 + f[27] * length_27_by_q73_by_q73 + kt[27] * t348;
    double sum366 = t356 + kt[27] * t355;
    double kept367[10];
    double kept368[10];
    for (int i363 = 0; i363 < 10; ++i363) {
        const double before370 = sum364;
        const double before371 = sum365;
        const double before372 = sum366;
        const double t373 = table369[i363][0] * y_x;
        const double strand_x_5 = layer_1_x - t373;
        const double t374 = table369[i363][0] * y_z_by_q73;
        const double strand_x_by_q71_by_q73_4 = layer_1_x_by_q71_by_q73 + t374;
        const double strand_y_5 = table369[i363][1] - layer_1_y - table369[i363][0] * u_y;
        const double t375 = strand_x_5 * strand_x_by_q71_by_q73_4 - strand_y_5
            * layer_1_y_by_q71_by_q73;
        const double t376 = table369[i363][0] * y_z;
        const double strand_z_5 = layer_1_z - t376;
        const double t377 = table369[i363][0] * y_x_by_q73;
        const double strand_z_by_q71_by_q73_4 = layer_1_z_by_q71_by_q73 + t377;
        const double strand_y_by_q73_5 = layer_1_y_by_q73 + table369[i363][0] * u_y_by_q73;
        const double t378 = t375 - strand_z_5 * strand_z_by_q71_by_q73_4 - layer_1_y_by_q71
            * strand_y_by_q73_5;
        const double strand_x_by_q71_4 = layer_1_x_by_q71 + t376;
        const double strand_x_by_q73_5 = layer_1_x_by_q73 + t377;
        const double strand_z_by_q71_4 = layer_1_z_by_q71 + t373;
        const double strand_z_by_q73_5 = layer_1_z_by_q73 + t374;
        const double t379 = t378 - strand_x_by_q71_4 * strand_x_by_q73_5 + strand_z_by_q71_4
            * strand_z_by_q73_5;
        const double t380 = strand_x_5 * strand_x_by_q71_4 - strand_y_5 * layer_1_y_by_q71
            - strand_z_5 * strand_z_by_q71_4;
        const double t381 = strand_x_5 * strand_x_5 + strand_y_5 * strand_y_5 + strand_z_5
            * strand_z_5;
        const double length_4 = sinew_sqrt(t381);
        const double t382 = 1.0 / length_4;
        const double length_by_q71_4 = t380 * t382;
        const double t383 = strand_x_5 * strand_x_by_q73_5 - strand_y_5 * strand_y_by_q73_5
            + strand_z_5 * strand_z_by_q73_5;
        const double length_by_q73_4 = t383 * t382;
        const double length_by_q71_by_q73_4 = (t379 + length_by_q71_4 * length_by_q73_4) * t382;
        const double t384 = before370 + f[28 + i363] * length_by_q71_by_q73_4 - kt[28 + i363]
            * length_by_q71_4 * length_by_q73_4;
        const double strand_x_by_q73_by_q73_4 = layer_1_x_by_q73_by_q73 + table369[i363][0]
            * y_x_by_q73_by_q73;
        const double strand_y_by_q73_by_q73_4 = layer_1_y_by_q73_by_q73 + table369[i363][0]
            * u_y_by_q73_by_q73;
        const double t385 = strand_x_5 * strand_x_by_q73_by_q73_4 + strand_y_5
            * strand_y_by_q73_by_q73_4;
        const double strand_z_by_q73_by_q73_4 = layer_1_z_by_q73_by_q73 + table369[i363][0]
            * y_z_by_q73_by_q73;
        const double t386 = t385 + strand_z_5 * strand_z_by_q73_by_q73_4 + strand_x_by_q73_5
            * strand_x_by_q73_5;
        const double t387 = t386 + strand_y_by_q73_5 * strand_y_by_q73_5 + strand_z_by_q73_5
            * strand_z_by_q73_5;
        const double t388 = length_by_q73_4 * length_by_q73_4;
        const double length_by_q73_by_q73_4 = (t387 - t388) * t382;
        const double strand_x_by_q71_by_q71_4 = layer_1_x_by_q71_by_q71 + t373;
        const double t389 = strand_x_5 * strand_x_by_q71_by_q71_4 - strand_y_5
            * layer_1_y_by_q71_by_q71;
        const double strand_z_by_q71_by_q71_4 = layer_1_z_by_q71_by_q71 + t376;
        const double t390 = t389 + strand_z_5 * strand_z_by_q71_by_q71_4 + t295 + strand_x_by_q71_4
            * strand_x_by_q71_4;
        const double t391 = length_by_q71_4 * length_by_q71_4;
        const double length_by_q71_by_q71_4 = (t390 + strand_z_by_q71_4 * strand_z_by_q71_4 - t391)
            * t382;
        sum364 = t384;
        sum365 = before371 + f[28 + i363] * length_by_q73_by_q73_4 + kt[28 + i363] * t388;
        sum366 = before372 + f[28 + i363] * length_by_q71_by_q71_4 + kt[28 + i363] * t391;
        kept367[i363] = length_by_q73_4;
        kept368[i363] = length_by_q71_4;
    }
    const double w5_3_6 = 0.011000000000000001 * kt[28];
    const double w6_3_6 = 0.011000000000000001 * kt[29];
    const double K_wrist_58 = kept367[0] * w5_3_6 - kept367[1] * w6_3_6;
    const double t392 = -K_wrist_58;
    K[314] = t392;
    K[315] = 0.0;
    K[316] = 0.0;
    K[317] = 0.0;
    K[318] = 0.0;
    K[319] = 0.0;
    K[320] = 0.0;
    K[321] = 0.0;
    K[322] = 0.0;
    K[323] = 0.0;
    K[324] = 0.0;
    K[325] = 0.0;
    K[326] = 0.0;
    K[327] = 0.0;
    K[328] = 0.0;
    K[329] = 0.0;
    K[434] = t392;
    const double K_wrist_56 = kept368[0] * w5_3_6 - kept368[1] * w6_3_6;
    K[313] = K_wrist_56;
    K[413] = K_wrist_56;
    const double K3_3_6 = 0.011000000000000001 * (w5_3_6 + w6_3_6);
    K[308] = K3_3_6;
    K[309] = 0.0;
    K[310] = 0.0;
    K[311] = 0.0;
    K[312] = 0.0;
    const double w1_1_8 = 0.0052 * kt[30];
    const double t393 = 0.0052 * w1_1_8;
    const double t394 = kept367[2] * w1_1_8;
    const double w2_1_8 = 0.0052 * kt[31];
    const double t395 = kept367[3] * w2_1_8;
    const double t396 = kept368[2] * w1_1_8;
    const double t397 = kept368[3] * w2_1_8;
    const double t398 = 0.0052 * w2_1_8;
    const double w3_1_8 = 0.0052 * kt[32];
    const double t399 = kept367[4] * w3_1_8;
    const double t400 = kept368[4] * w3_1_8;
    const double t401 = 0.0052 * w3_1_8;
    const double w4_1_8 = 0.0052 * kt[33];
    const double t402 = kept367[5] * w4_1_8;
    const double K_wrist_66 = t394 - t395 + t399 - t402;
    const double t403 = -K_wrist_66;
    K[356] = t403;
    K[357] = 0.0;
    K[358] = 0.0;
    K[359] = 0.0;
    K[360] = 0.0;
    K[361] = 0.0;
    K[362] = 0.0;
    K[363] = 0.0;
    K[364] = 0.0;
    K[365] = 0.0;
    K[366] = 0.0;
    K[367] = 0.0;
    K[368] = 0.0;
    K[369] = 0.0;
    K[370] = 0.0;
    K[371] = 0.0;
    K[372] = 0.0;
    K[373] = 0.0;
    K[436] = t403;
    const double K_wrist_62 = t394 + t395 - t399 - t402;
    const double t404 = -K_wrist_62;
    K[335] = t404;
    K[336] = 0.0;
    K[337] = 0.0;
    K[338] = 0.0;
    K[339] = 0.0;
    K[340] = 0.0;
    K[341] = 0.0;
    K[342] = 0.0;
    K[343] = 0.0;
    K[344] = 0.0;
    K[345] = 0.0;
    K[346] = 0.0;
    K[347] = 0.0;
    K[348] = 0.0;
    K[349] = 0.0;
    K[350] = 0.0;
    K[435] = t404;
    const double t405 = kept368[5] * w4_1_8;
    const double K_wrist_64 = t396 - t397 + t400 - t405;
    K[355] = K_wrist_64;
    K[415] = K_wrist_64;
    const double K_wrist_60 = t396 + t397 - t400 - t405;
    K[334] = K_wrist_60;
    K[414] = K_wrist_60;
    const double t406 = 0.0052 * w4_1_8;
    const double K1_1_8 = t393 + t398 + t401 + t406;
    K[330] = K1_1_8;
    K[352] = K1_1_8;
    K[353] = 0.0;
    K[354] = 0.0;
    const double K1_2_8 = t393 - t398 - t401 + t406;
    K[331] = K1_2_8;
    K[332] = 0.0;
    K[333] = 0.0;
    K[351] = K1_2_8;
    const double R21y = c1 * s2;
    const double t407 = 0.005 * R21y;
    const double t408 = 0.006 * s1;
    const double t409 = t407 - t408;
    const double R21x = c1 * c2;
    const double t410 = 0.047 * R21x;
    const double pA_length_tox = t409 + t410;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double R22y = s1 * s2;
    const double t411 = 0.005 * R22y;
    const double t412 = 0.006 * c1;
    const double t413 = t411 + t412;
    const double R22x = s1 * c2;
    const double t414 = 0.047 * R22x;
    const double pA_length_toy = t413 + t414;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double t415 = 0.005 * c2;
    const double t416 = 0.047 * s2;
    const double pA_length_toz = t415 - t416;
    const double A_lengthdz = 0.025 - pA_length_toz;
    const double t417 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t417);
    const double t418 = 1.0 / A_length;
    const double t419 = 0.005 * R21x;
    const double t420 = 0.047 * R21y;
    const double pA_length_tox_by_q_1 = t419 - t420;
    const double t421 = 0.005 * R22x;
    const double t422 = 0.047 * R22y;
    const double pA_length_toy_by_q_1 = t421 - t422;
    const double t423 = 0.005 * s2;
    const double t424 = 0.047 * c2;
    const double pA_length_toz_by_q_1 = t423 + t424;
    const double t425 = A_lengthdz * pA_length_toz_by_q_1;
    const double t426 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1
        - t425;
    const double A_length_by_q_1 = t426 * t418;
    const double w1_2 = kt[0] * A_length_by_q_1;
    const double t427 = t407 + t408;
    const double pB_length_tox = t427 - t410;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double t428 = t411 - t412;
    const double pB_length_toy = t428 - t414;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double pB_length_toz = t415 + t416;
    const double B_lengthdz = 0.025 - pB_length_toz;
    const double t429 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t429);
    const double t430 = 1.0 / B_length;
    const double pB_length_tox_by_q_1 = t419 + t420;
    const double pB_length_toy_by_q_1 = t421 + t422;
    const double pB_length_toz_by_q_1 = t423 - t424;
    const double t431 = B_lengthdz * pB_length_toz_by_q_1;
    const double t432 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1
        + t431;
    const double B_length_by_q_1 = t432 * t430;
    const double w2_2 = kt[1] * B_length_by_q_1;
    const double pC_length_tox = t427 + t410;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double pC_length_toy = t428 + t414;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_length = sinew_sqrt(t417 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t433 = 1.0 / C_length;
    const double t434 = t425 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy
        * pA_length_toy_by_q_1;
    const double C_length_by_q_1 = t434 * t433;
    const double w3_2 = kt[2] * C_length_by_q_1;
    const double pD_length_tox = t409 - t410;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double pD_length_toy = t413 - t414;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_length = sinew_sqrt(t429 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t435 = 1.0 / D_length;
    const double t436 = t431 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy
        * pB_length_toy_by_q_1;
    const double D_length_by_q_1 = t436 * t435;
    const double w4_2 = kt[3] * D_length_by_q_1;
    const double K_wrist_6 = length_0_by_q73 * w1_2 - kept155[0] * w2_2 - kept155[1] * w3_2
        - kept155[2] * w4_2;
    K[41] = K_wrist_6;
    K[42] = 0.0;
    K[43] = 0.0;
    K[421] = K_wrist_6;
    const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t418;
    const double w1_1 = kt[0] * A_length_by_q_0;
    const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t430;
    const double w2_1 = kt[1] * B_length_by_q_0;
    const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t433;
    const double w3_1 = kt[2] * C_length_by_q_0;
    const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t435;
    const double w4_1 = kt[3] * D_length_by_q_0;
    const double K_wrist_2 = length_0_by_q73 * w1_1 - kept155[0] * w2_1 - kept155[1] * w3_1
        + kept155[2] * w4_1;
    K[20] = K_wrist_2;
    K[420] = K_wrist_2;
    const double K_wrist_4 = length_0_by_q71 * w1_2 - kept156[0] * w2_2 - kept156[1] * w3_2
        - kept156[2] * w4_2;
    const double t437 = -K_wrist_4;
    K[40] = t437;
    K[400] = t437;
    const double K_wrist = length_0_by_q71 * w1_1 - kept156[0] * w2_1 - kept156[1] * w3_1
        + kept156[2] * w4_1;
    const double t438 = -K_wrist;
    K[19] = t438;
    K[399] = t438;
    const double pA_length_tox_by_q_1_2_by_q_1 = t407 + t410;
    const double t439 = pA_length_toz * A_lengthdz;
    const double pA_length_toy_by_q_1_2_by_q_1 = t411 + t414;
    const double t440 = t439 + A_lengthdx * pA_length_tox_by_q_1_2_by_q_1 + A_lengthdy
        * pA_length_toy_by_q_1_2_by_q_1;
    const double t441 = pA_length_tox_by_q_1 * pA_length_tox_by_q_1;
    const double t442 = pA_length_toy_by_q_1 * pA_length_toy_by_q_1;
    const double t443 = pA_length_toz_by_q_1 * pA_length_toz_by_q_1;
    const double A_length_by_q_1_2_by_q_1 = (t440 + t441 + t442 + t443 - A_length_by_q_1
        * A_length_by_q_1) * t418;
    const double pB_length_tox_by_q_1_2_by_q_1 = t407 - t410;
    const double t444 = pB_length_toz * B_lengthdz;
    const double pB_length_toy_by_q_1_2_by_q_1 = t411 - t414;
    const double t445 = t444 - B_lengthdx * pB_length_tox_by_q_1_2_by_q_1 - B_lengthdy
        * pB_length_toy_by_q_1_2_by_q_1;
    const double t446 = pB_length_tox_by_q_1 * pB_length_tox_by_q_1;
    const double t447 = pB_length_toy_by_q_1 * pB_length_toy_by_q_1;
    const double t448 = pB_length_toz_by_q_1 * pB_length_toz_by_q_1;
    const double B_length_by_q_1_2_by_q_1 = (t445 + t446 + t447 + t448 - B_length_by_q_1
        * B_length_by_q_1) * t430;
    const double t449 = t439 + C_lengthdx * pA_length_tox_by_q_1_2_by_q_1 - C_lengthdy
        * pA_length_toy_by_q_1_2_by_q_1;
    const double C_length_by_q_1_2_by_q_1 = (t449 + t441 + t442 + t443 - C_length_by_q_1
        * C_length_by_q_1) * t433;
    const double t450 = f[0] * A_length_by_q_1_2_by_q_1 + f[1] * B_length_by_q_1_2_by_q_1 + f[2]
        * C_length_by_q_1_2_by_q_1;
    const double t451 = t444 - D_lengthdx * pB_length_tox_by_q_1_2_by_q_1 + D_lengthdy
        * pB_length_toy_by_q_1_2_by_q_1;
    const double D_length_by_q_1_2_by_q_1 = (t451 + t446 + t447 + t448 - D_length_by_q_1
        * D_length_by_q_1) * t435;
    const double t452 = t450 + f[3] * D_length_by_q_1_2_by_q_1 + A_length_by_q_1 * w1_2
        + B_length_by_q_1 * w2_2;
    const double K2_2 = t452 + C_length_by_q_1 * w3_2 + D_length_by_q_1 * w4_2;
    K[22] = K2_2;
    K[23] = 0.0;
    K[24] = 0.0;
    K[25] = 0.0;
    K[26] = 0.0;
    K[27] = 0.0;
    K[28] = 0.0;
    K[29] = 0.0;
    K[30] = 0.0;
    K[31] = 0.0;
    K[32] = 0.0;
    K[33] = 0.0;
    K[34] = 0.0;
    K[35] = 0.0;
    K[36] = 0.0;
    K[37] = 0.0;
    K[38] = 0.0;
    K[39] = 0.0;
    const double t453 = B_lengthdx - pB_length_tox;
    const double t454 = B_lengthdy - pB_length_toy;
    const double t455 = pB_length_tox_by_q_1 * t454 + pB_length_toy_by_q_1 * -t453 - B_length_by_q_0
        * B_length_by_q_1;
    const double B_length_by_q_0_2_by_q_1 = t455 * t430;
    const double t456 = A_lengthdx + pA_length_tox;
    const double t457 = A_lengthdy + pA_length_toy;
    const double t458 = pA_length_toy_by_q_1 * t456 - pA_length_tox_by_q_1 * t457 - A_length_by_q_0
        * A_length_by_q_1;
    const double A_length_by_q_0_2_by_q_1 = t458 * t418;
    const double t459 = pC_length_toy - C_lengthdy;
    const double t460 = C_lengthdx + pC_length_tox;
    const double t461 = pA_length_tox_by_q_1 * -t459 + pA_length_toy_by_q_1 * t460 - C_length_by_q_0
        * C_length_by_q_1;
    const double C_length_by_q_0_2_by_q_1 = t461 * t433;
    const double t462 = f[0] * A_length_by_q_0_2_by_q_1 + f[1] * B_length_by_q_0_2_by_q_1 + f[2]
        * C_length_by_q_0_2_by_q_1;
    const double t463 = D_lengthdx - pD_length_tox;
    const double t464 = D_lengthdy + pD_length_toy;
    const double t465 = pB_length_toy_by_q_1 * -t463 - pB_length_tox_by_q_1 * t464 + D_length_by_q_0
        * D_length_by_q_1;
    const double D_length_by_q_0_2_by_q_1 = t465 * t435;
    const double t466 = t462 + f[3] * D_length_by_q_0_2_by_q_1 + A_length_by_q_1 * w1_1
        + B_length_by_q_1 * w2_1;
    const double K1_2 = t466 + C_length_by_q_1 * w3_1 - D_length_by_q_1 * w4_1;
    K[1] = K1_2;
    K[2] = 0.0;
    K[3] = 0.0;
    K[4] = 0.0;
    K[5] = 0.0;
    K[6] = 0.0;
    K[7] = 0.0;
    K[8] = 0.0;
    K[9] = 0.0;
    K[10] = 0.0;
    K[11] = 0.0;
    K[12] = 0.0;
    K[13] = 0.0;
    K[14] = 0.0;
    K[15] = 0.0;
    K[16] = 0.0;
    K[17] = 0.0;
    K[18] = 0.0;
    K[21] = K1_2;
    const double t467 = pA_length_toy * t457 + pA_length_tox * t456 - A_length_by_q_0
        * A_length_by_q_0;
    const double A_length_by_q_0_2_by_q_0 = t467 * t418;
    const double t468 = pB_length_toy * t454 + pB_length_tox * t453 + B_length_by_q_0
        * B_length_by_q_0;
    const double B_length_by_q_0_2_by_q_0 = t468 * t430;
    const double t469 = pC_length_toy * t459 + pC_length_tox * t460 - C_length_by_q_0
        * C_length_by_q_0;
    const double C_length_by_q_0_2_by_q_0 = t469 * t433;
    const double t470 = f[0] * A_length_by_q_0_2_by_q_0 - f[1] * B_length_by_q_0_2_by_q_0 + f[2]
        * C_length_by_q_0_2_by_q_0;
    const double t471 = pD_length_tox * t463 - pD_length_toy * t464 + D_length_by_q_0
        * D_length_by_q_0;
    const double D_length_by_q_0_2_by_q_0 = t471 * t435;
    const double t472 = t470 - f[3] * D_length_by_q_0_2_by_q_0 + A_length_by_q_0 * w1_1
        + B_length_by_q_0 * w2_1;
    const double K1_1 = t472 + C_length_by_q_0 * w3_1 + D_length_by_q_0 * w4_1;
    K[0] = K1_1;
    const double w5_3_8 = 0.0088 * kt[34];
    const double w6_3_8 = 0.0088 * kt[35];
    const double K_wrist_70 = kept367[6] * w5_3_8 - kept367[7] * w6_3_8;
    const double t473 = -K_wrist_70;
    K[377] = t473;
    K[378] = 0.0;
    K[379] = 0.0;
    K[380] = 0.0;
    K[381] = 0.0;
    K[382] = 0.0;
    K[383] = 0.0;
    K[384] = 0.0;
    K[385] = 0.0;
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
    K[437] = t473;
    const double K_wrist_68 = kept368[6] * w5_3_8 - kept368[7] * w6_3_8;
    K[376] = K_wrist_68;
    K[416] = K_wrist_68;
    const double K3_3_8 = 0.0088 * (w5_3_8 + w6_3_8);
    K[374] = K3_3_8;
    K[375] = 0.0;
    const double w1_1_10 = 0.005 * kt[36];
    K[440] = sum365;
    K[419] = sum364;
    K[439] = sum364;
    const double w2_1_10 = 0.005 * kt[37];
    const double K_wrist_74 = kept367[8] * w1_1_10 - kept367[9] * w2_1_10;
    const double t474 = -K_wrist_74;
    K[398] = t474;
    K[438] = t474;
    K[418] = sum366;
    const double K_wrist_72 = kept368[8] * w1_1_10 - kept368[9] * w2_1_10;
    K[397] = K_wrist_72;
    K[417] = K_wrist_72;
    const double K1_1_10 = 0.005 * (w1_1_10 + w2_1_10);
    K[396] = K1_1_10;
}

void hand_feedforward(const double q_wrist[SINEW_AT_LEAST(2)],
    double delta_theta[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
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

void hand_feedforward_rate(const double q_wrist[SINEW_AT_LEAST(2)],
    const double qd_wrist[SINEW_AT_LEAST(2)], double delta_theta_rate[SINEW_AT_LEAST(38)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
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
    const double t49 = 200.0 * qd_wrist[1];
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
    const double t58 = 200.0 * qd_wrist[0];
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

void hand_wrist_passage(const double q_wrist[SINEW_AT_LEAST(2)], double h[SINEW_AT_LEAST(38)],
    double P[SINEW_AT_LEAST(76)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q_wrist[0], q_wrist[1]);
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
    h[27] = length_27;
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
    h[7] = length_7;
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
        h[8 + i64] = length;
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
        h[28 + i71] = length_2;
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
        h[19 + i79] = length_3;
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
        h[i87] = length_4;
    }
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
    const double a4x_8 = a3x_8 + 0.02384 * e3x_8;
    const double j4y1_8 = 1.234944e-05 * s4_8;
    const double e3y_8 = c3_8 * al3z_8 - s3_8 * w3zz_8;
    const double e2y_8 = qdd[16] * c2_8 - s2_8 * w2zz_8;
    const double a3y_8 = g[14] - 0.032304 * e2y_8;
    const double a4y_8 = a3y_8 - 0.02384 * e3y_8;
    const double j4x1_8 = 1.234944e-05 * c4_8;
    const double al4z_8 = al3z_8 + 1.2222222222222223 * qdd[17];
    const double n4_8 = 1.462099968e-07 * al4z_8 - j4x1_8 * a4y_8 + j4y1_8 * a4x_8;
    const double j3x1_8 = 7.323648000000001e-05 * c3_8;
    const double j3y1_8 = 7.323648000000001e-05 * s3_8;
    const double t11 = 1.2222222222222223 * qd[17];
    const double w4z_8 = w3z_8 + t11;
    const double w4zz_8 = w4z_8 * w4z_8;
    const double e4y_8 = c4_8 * al4z_8 - s4_8 * w4zz_8;
    const double F4y_8 = 1.234944e-05 * e4y_8;
    const double l4x_8 = 0.02384 * c3_8;
    const double t12 = n4_8 + 1.482612736e-06 * al3z_8 - j3x1_8 * a3y_8 + j3y1_8 * a3x_8 + l4x_8
        * F4y_8;
    const double e4x_8 = c4_8 * w4zz_8 + s4_8 * al4z_8;
    const double F4x_8 = 1.234944e-05 * e4x_8;
    const double l4y_8 = 0.02384 * s3_8;
    const double n3_8 = t12 + l4y_8 * F4x_8;
    const double j4yz_6 = 5.2855603200000006e-08 * s4_8;
    const double j3yz_6 = 2.2996254720000002e-07 * s3_8;
    const double K3yz_6 = j3yz_6 + j4yz_6;
    const double l3x_8 = 0.032304 * c2_8;
    const double o4x_8 = l3x_8 + l4x_8;
    const double j4u_8 = 1.185619968e-07 * c4_8;
    const double j4xy_8 = s4_8 * j4u_8;
    const double K4yx_8 = j4xy_8 + o4x_8 * j4y1_8;
    const double j3u_8 = 1.427316736e-06 * c3_8;
    const double j3xy_8 = s3_8 * j3u_8;
    const double K3yx_8 = j3xy_8 + K4yx_8 + l3x_8 * j3y1_8 + l4y_8 * j4x1_8;
    const double t3_8 = n3_8 + qdd[15] * K3yz_6 + w1zz_8 * K3yx_8;
    const double t4_8 = n4_8 + qdd[15] * j4yz_6 + w1zz_8 * K4yx_8;
    tau[17] = t3_8 + 1.2222222222222223 * t4_8;
    const double j2x1_8 = 0.000223285248 * c2_8;
    const double j2y1_8 = 0.000223285248 * s2_8;
    const double F3y_8 = F4y_8 + 7.323648000000001e-05 * e3y_8;
    const double t13 = n3_8 + 6.45303346786e-06 * qdd[16] - g[14] * j2x1_8 + b2x_6 * j2y1_8 + l3x_8
        * F3y_8;
    const double F3x_8 = F4x_8 + 7.323648000000001e-05 * e3x_8;
    const double l3y_8 = 0.032304 * s2_8;
    const double n2_8 = t13 + l3y_8 * F3x_8;
    const double j2yz_6 = 4.1084485632e-07 * s2_8;
    const double K2yz_6 = j2yz_6 + K3yz_6;
    const double j2u_8 = 6.37008946786e-06 * c2_8;
    const double j2xy_8 = s2_8 * j2u_8;
    const double S3x_8 = j3x1_8 + j4x1_8;
    const double K2yx_8 = j2xy_8 + K3yx_8 + l3y_8 * S3x_8;
    const double t2_8 = n2_8 + qdd[15] * K2yz_6 + w1zz_8 * K2yx_8;
    tau[16] = t2_8;
    const double R2yx_8 = qd[16] * K2yx_8 + qd[17] * K3yx_8 + t11 * K4yx_8;
    const double w_2y_8 = qd[15] + qd[15];
    const double t14 = c2_8 * j2u_8 + c3_8 * j3u_8 + c4_8 * j4u_8 + o4x_8 * j4x1_8 + l3x_8 * j3x1_8;
    const double t15 = qdd[15] * (t14 + l4x_8 * j4x1_8 + l3x_8 * S3x_8 + 4.3573002239999995e-07);
    const double t16 = t15 + 5.2855603200000006e-08 * e4x_8 + 2.2996254720000002e-07 * e3x_8
        + 4.1084485632e-07 * e2x_8;
    const double S2x_8 = j2x1_8 + S3x_8;
    const double a1y_8 = g[12] * s1_8 - g[13] * c1_8;
    const double b2y_6 = a1y_8 + 0.0048 * qdd[15];
    const double t17 = t16 + b2y_6 * S2x_8 - w_2y_8 * R2yx_8 + 1.271808e-05 * a1x_8 + 4.66944e-05
        * a1y_8;
    const double S3y_8 = j3y1_8 + j4y1_8;
    const double S2y_8 = j2y1_8 + S3y_8;
    const double R2y_8 = qd[16] * S2y_8 + qd[17] * S3y_8 + t11 * j4y1_8;
    const double P2z_8 = qdd[15] * S2x_8 - w_2y_8 * R2y_8;
    const double N1z_8 = t17 + 0.0048 * P2z_8;
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
    const double a4x_6 = a3x_6 + 0.0298 * e3x_6;
    const double j4y1_6 = 3.015e-05 * s4_6;
    const double e3y_6 = c3_6 * al3z_6 - s3_6 * w3zz_6;
    const double e2y_6 = qdd[13] * c2_6 - s2_6 * w2zz_6;
    const double a3y_6 = g[11] - 0.04038 * e2y_6;
    const double a4y_6 = a3y_6 - 0.0298 * e3y_6;
    const double j4x1_6 = 3.015e-05 * c4_6;
    const double al4z_6 = al3z_6 + 1.2222222222222223 * qdd[14];
    const double n4_6 = 4.3101e-07 * al4z_6 - j4x1_6 * a4y_6 + j4y1_6 * a4x_6;
    const double j3x1_6 = 0.0001788 * c3_6;
    const double j3y1_6 = 0.0001788 * s3_6;
    const double t18 = 1.2222222222222223 * qd[14];
    const double w4z_6 = w3z_6 + t18;
    const double w4zz_6 = w4z_6 * w4z_6;
    const double e4y_6 = c4_6 * al4z_6 - s4_6 * w4zz_6;
    const double F4y_6 = 3.015e-05 * e4y_6;
    const double l4x_6 = 0.0298 * c3_6;
    const double t19 = n4_6 + 4.4942e-06 * al3z_6 - j3x1_6 * a3y_6 + j3y1_6 * a3x_6 + l4x_6 * F4y_6;
    const double e4x_6 = c4_6 * w4zz_6 + s4_6 * al4z_6;
    const double F4x_6 = 3.015e-05 * e4x_6;
    const double l4y_6 = 0.0298 * s3_6;
    const double n3_6 = t19 + l4y_6 * F4x_6;
    const double j4yz_4 = 1.613025e-07 * s4_6;
    const double j3yz_4 = 7.0179e-07 * s3_6;
    const double K3yz_4 = j3yz_4 + j4yz_4;
    const double l3x_6 = 0.04038 * c2_6;
    const double o4x_6 = l3x_6 + l4x_6;
    const double j4u_6 = 3.7701e-07 * c4_6;
    const double j4xy_6 = s4_6 * j4u_6;
    const double K4yx_6 = j4xy_6 + o4x_6 * j4y1_6;
    const double j3u_6 = 4.3862e-06 * c3_6;
    const double j3xy_6 = s3_6 * j3u_6;
    const double K3yx_6 = j3xy_6 + K4yx_6 + l3x_6 * j3y1_6 + l4y_6 * j4x1_6;
    const double t3_6 = n3_6 + qdd[12] * K3yz_4 + w1zz_6 * K3yx_6;
    const double t4_6 = n4_6 + qdd[12] * j4yz_4 + w1zz_6 * K4yx_6;
    tau[14] = t3_6 + 1.2222222222222223 * t4_6;
    const double j2x1_6 = 0.00054513 * c2_6;
    const double j2y1_6 = 0.00054513 * s2_6;
    const double F3y_6 = F4y_6 + 0.0001788 * e3y_6;
    const double t20 = n3_6 + 1.96475328e-05 * qdd[13] - g[11] * j2x1_6 + b2x_4 * j2y1_6 + l3x_6
        * F3y_6;
    const double F3x_6 = F4x_6 + 0.0001788 * e3x_6;
    const double l3y_6 = 0.04038 * s2_6;
    const double n2_6 = t20 + l3y_6 * F3x_6;
    const double j2yz_4 = 1.253799e-06 * s2_6;
    const double K2yz_4 = j2yz_4 + K3yz_4;
    const double j2u_6 = 1.94855328e-05 * c2_6;
    const double j2xy_6 = s2_6 * j2u_6;
    const double S3x_6 = j3x1_6 + j4x1_6;
    const double K2yx_6 = j2xy_6 + K3yx_6 + l3y_6 * S3x_6;
    const double t2_6 = n2_6 + qdd[12] * K2yz_4 + w1zz_6 * K2yx_6;
    tau[13] = t2_6;
    const double R2yx_6 = qd[13] * K2yx_6 + qd[14] * K3yx_6 + t18 * K4yx_6;
    const double w_2y_6 = qd[12] + qd[12];
    const double t21 = c2_6 * j2u_6 + c3_6 * j3u_6 + c4_6 * j4u_6 + o4x_6 * j4x1_6 + l3x_6 * j3x1_6;
    const double t22 = qdd[12] * (t21 + l4x_6 * j4x1_6 + l3x_6 * S3x_6 + 1.1373675000000002e-06);
    const double S2x_6 = j2x1_6 + S3x_6;
    const double a1y_6 = g[9] * s1_6 - g[10] * c1_6;
    const double b2y_4 = a1y_6 + 0.006 * qdd[12];
    const double t23 = t22 + 1.613025e-07 * e4x_6 + 7.0179e-07 * e3x_6 + 1.253799e-06 * e2x_6
        + b2y_4 * S2x_6;
    const double S3y_6 = j3y1_6 + j4y1_6;
    const double S2y_6 = j2y1_6 + S3y_6;
    const double R2y_6 = qd[13] * S2y_6 + qd[14] * S3y_6 + t18 * j4y1_6;
    const double P2z_6 = qdd[12] * S2x_6 - w_2y_6 * R2y_6;
    const double N1z_6 = t23 - w_2y_6 * R2yx_6 + 3.105e-05 * a1x_6 + 0.000114 * a1y_6 + 0.006
        * P2z_6;
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
    const double a4x_4 = a3x_4 + 0.032184 * e3x_4;
    const double j4y1_4 = 4.101874214400001e-05 * s4_4;
    const double e3y_4 = c3_4 * al3z_4 - s3_4 * w3zz_4;
    const double e2y_4 = qdd[9] * c2_4 - s2_4 * w2zz_4;
    const double a3y_4 = g[8] - 0.0436104 * e2y_4;
    const double a4y_4 = a3y_4 - 0.032184 * e3y_4;
    const double j4x1_4 = 4.101874214400001e-05 * c4_4;
    const double al4z_4 = qdd[11] + al3z_4;
    const double n4_4 = 6.27635460330976e-07 * al4z_4 - j4x1_4 * a4y_4 + j4y1_4 * a4x_4;
    const double j4yz_2 = 2.3700629210803204e-07 * s4_4;
    const double l4x_4 = 0.032184 * c3_4;
    const double l3x_4 = 0.0436104 * c2_4;
    const double o4x_4 = l3x_4 + l4x_4;
    const double j4u_4 = 5.59611012330976e-07 * c4_4;
    const double j4xy_4 = s4_4 * j4u_4;
    const double K4yx_4 = j4xy_4 + o4x_4 * j4y1_4;
    const double t4_4 = n4_4 + qdd[8] * j4yz_2 + w1zz_4 * K4yx_4;
    tau[11] = t4_4;
    const double j3x1_4 = 0.000243255426048 * c3_4;
    const double j3y1_4 = 0.000243255426048 * s3_4;
    const double w4z_4 = qd[11] + w3z_4;
    const double w4zz_4 = w4z_4 * w4z_4;
    const double e4y_4 = c4_4 * al4z_4 - s4_4 * w4zz_4;
    const double F4y_4 = 4.101874214400001e-05 * e4y_4;
    const double t24 = n4_4 + 6.592134974646623e-06 * al3z_4 - j3x1_4 * a3y_4 + j3y1_4 * a3x_4
        + l4x_4 * F4y_4;
    const double e4x_4 = c4_4 * w4zz_4 + s4_4 * al4z_4;
    const double F4x_4 = 4.101874214400001e-05 * e4x_4;
    const double l4y_4 = 0.032184 * s3_4;
    const double n3_4 = t24 + l4y_4 * F4x_4;
    const double j3yz_2 = 1.031159751017472e-06 * s3_4;
    const double K3yz_2 = j3yz_2 + j4yz_2;
    const double j3u_4 = 6.456086078646624e-06 * c3_4;
    const double j3xy_4 = s3_4 * j3u_4;
    const double K3yx_4 = j3xy_4 + K4yx_4 + l3x_4 * j3y1_4 + l4y_4 * j4x1_4;
    const double t3_4 = n3_4 + qdd[8] * K3yz_2 + w1zz_4 * K3yx_4;
    tau[10] = t3_4;
    const double j2x1_4 = 0.0007416433467648001 * c2_4;
    const double j2y1_4 = 0.0007416433467648001 * s2_4;
    const double F3y_4 = F4y_4 + 0.000243255426048 * e3y_4;
    const double t25 = n3_4 + 2.8851692681126364e-05 * qdd[9] - g[8] * j2x1_4 + b2x_2 * j2y1_4
        + l3x_4 * F3y_4;
    const double F3x_4 = F4x_4 + 0.000243255426048 * e3x_4;
    const double l3y_4 = 0.0436104 * s2_4;
    const double n2_4 = t25 + l3y_4 * F3x_4;
    const double j2yz_2 = 1.8422420733637633e-06 * s2_4;
    const double K2yz_2 = j2yz_2 + K3yz_2;
    const double j2u_4 = 2.8647619337126362e-05 * c2_4;
    const double j2xy_4 = s2_4 * j2u_4;
    const double S3x_4 = j3x1_4 + j4x1_4;
    const double K2yx_4 = j2xy_4 + K3yx_4 + l3y_4 * S3x_4;
    const double t2_4 = n2_4 + qdd[8] * K2yz_2 + w1zz_4 * K2yx_4;
    tau[9] = t2_4;
    const double R2yx_4 = qd[9] * K2yx_4 + qd[10] * K3yx_4 + qd[11] * K4yx_4;
    const double w_2y_4 = qd[8] + qd[8];
    const double t26 = c2_4 * j2u_4 + c3_4 * j3u_4 + c4_4 * j4u_4 + o4x_4 * j4x1_4 + l3x_4 * j3x1_4;
    const double t27 = qdd[8] * (t26 + l4x_4 * j4x1_4 + l3x_4 * S3x_4 + 1.599477303123424e-06)
        + 2.3700629210803204e-07 * e4x_4;
    const double S2x_4 = j2x1_4 + S3x_4;
    const double a1y_4 = g[6] * s1_4 - g[7] * c1_4;
    const double b2y_2 = a1y_4 + 0.00648 * qdd[8];
    const double t28 = t27 + 1.031159751017472e-06 * e3x_4 + 1.8422420733637633e-06 * e2x_4 + b2y_2
        * S2x_4;
    const double t29 = t28 - w_2y_4 * R2yx_4 + 4.2243182208000006e-05 * a1x_4 + 0.00015509574144
        * a1y_4;
    const double S3y_4 = j3y1_4 + j4y1_4;
    const double S2y_4 = j2y1_4 + S3y_4;
    const double R2y_4 = qd[9] * S2y_4 + qd[10] * S3y_4 + qd[11] * j4y1_4;
    const double P2z_4 = qdd[8] * S2x_4 - w_2y_4 * R2y_4;
    const double N1z_4 = t29 + 0.00648 * P2z_4;
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
    const double a4x_2 = a3x_2 + 0.0298 * e3x_2;
    const double j4y1_2 = 3.015e-05 * s4_2;
    const double e3y_2 = c3_2 * al3z_2 - s3_2 * w3zz_2;
    const double e2y_2 = qdd[5] * c2_2 - s2_2 * w2zz_2;
    const double a3y_2 = g[5] - 0.04038 * e2y_2;
    const double a4y_2 = a3y_2 - 0.0298 * e3y_2;
    const double j4x1_2 = 3.015e-05 * c4_2;
    const double al4z_2 = qdd[7] + al3z_2;
    const double n4_2 = 4.3101e-07 * al4z_2 - j4x1_2 * a4y_2 + j4y1_2 * a4x_2;
    const double j4yz = 1.613025e-07 * s4_2;
    const double l4x_2 = 0.0298 * c3_2;
    const double l3x_2 = 0.04038 * c2_2;
    const double o4x_2 = l3x_2 + l4x_2;
    const double j4u_2 = 3.7701e-07 * c4_2;
    const double j4xy_2 = s4_2 * j4u_2;
    const double K4yx_2 = j4xy_2 + o4x_2 * j4y1_2;
    const double t4_2 = n4_2 + qdd[4] * j4yz + w1zz_2 * K4yx_2;
    tau[7] = t4_2;
    const double j3x1_2 = 0.0001788 * c3_2;
    const double j3y1_2 = 0.0001788 * s3_2;
    const double w4z_2 = qd[7] + w3z_2;
    const double w4zz_2 = w4z_2 * w4z_2;
    const double e4y_2 = c4_2 * al4z_2 - s4_2 * w4zz_2;
    const double F4y_2 = 3.015e-05 * e4y_2;
    const double t30 = n4_2 + 4.4942e-06 * al3z_2 - j3x1_2 * a3y_2 + j3y1_2 * a3x_2 + l4x_2 * F4y_2;
    const double e4x_2 = c4_2 * w4zz_2 + s4_2 * al4z_2;
    const double F4x_2 = 3.015e-05 * e4x_2;
    const double l4y_2 = 0.0298 * s3_2;
    const double n3_2 = t30 + l4y_2 * F4x_2;
    const double j3yz = 7.0179e-07 * s3_2;
    const double K3yz = j3yz + j4yz;
    const double j3u_2 = 4.3862e-06 * c3_2;
    const double j3xy_2 = s3_2 * j3u_2;
    const double K3yx_2 = j3xy_2 + K4yx_2 + l3x_2 * j3y1_2 + l4y_2 * j4x1_2;
    const double t3_2 = n3_2 + qdd[4] * K3yz + w1zz_2 * K3yx_2;
    tau[6] = t3_2;
    const double j2x1_2 = 0.00054513 * c2_2;
    const double j2y1_2 = 0.00054513 * s2_2;
    const double F3y_2 = F4y_2 + 0.0001788 * e3y_2;
    const double t31 = n3_2 + 1.96475328e-05 * qdd[5] - g[5] * j2x1_2 + b2x * j2y1_2 + l3x_2
        * F3y_2;
    const double F3x_2 = F4x_2 + 0.0001788 * e3x_2;
    const double l3y_2 = 0.04038 * s2_2;
    const double n2_2 = t31 + l3y_2 * F3x_2;
    const double j2yz = 1.253799e-06 * s2_2;
    const double K2yz = j2yz + K3yz;
    const double j2u_2 = 1.94855328e-05 * c2_2;
    const double j2xy_2 = s2_2 * j2u_2;
    const double S3x_2 = j3x1_2 + j4x1_2;
    const double K2yx_2 = j2xy_2 + K3yx_2 + l3y_2 * S3x_2;
    const double t2_2 = n2_2 + qdd[4] * K2yz + w1zz_2 * K2yx_2;
    tau[5] = t2_2;
    const double R2yx_2 = qd[5] * K2yx_2 + qd[6] * K3yx_2 + qd[7] * K4yx_2;
    const double w_2y_2 = qd[4] + qd[4];
    const double t32 = c2_2 * j2u_2 + c3_2 * j3u_2 + c4_2 * j4u_2 + o4x_2 * j4x1_2 + l3x_2 * j3x1_2;
    const double t33 = qdd[4] * (t32 + l4x_2 * j4x1_2 + l3x_2 * S3x_2 + 1.1373675000000002e-06)
        + 1.613025e-07 * e4x_2;
    const double S2x_2 = j2x1_2 + S3x_2;
    const double a1y_2 = g[3] * s1_2 - g[4] * c1_2;
    const double b2y = a1y_2 + 0.006 * qdd[4];
    const double t34 = t33 + 7.0179e-07 * e3x_2 + 1.253799e-06 * e2x_2 + b2y * S2x_2 - w_2y_2
        * R2yx_2;
    const double S3y_2 = j3y1_2 + j4y1_2;
    const double S2y_2 = j2y1_2 + S3y_2;
    const double R2y_2 = qd[5] * S2y_2 + qd[6] * S3y_2 + qd[7] * j4y1_2;
    const double P2z_2 = qdd[4] * S2x_2 - w_2y_2 * R2y_2;
    const double N1z_2 = t34 + 3.105e-05 * a1x_2 + 0.000114 * a1y_2 + 0.006 * P2z_2;
    tau[4] = N1z_2;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double al3z = qdd[1] + qdd[2];
    const double e3y = c3 * al3z - s3 * w3zz;
    const double w2zz = qd[1] * qd[1];
    const double e2y = qdd[1] * c2 - s2 * w2zz;
    const double a3y = g[2] - 0.045 * e2y;
    const double a4y = a3y - 0.0298 * e3y;
    const double j4x1 = 3.015e-05 * c4;
    const double al4z = qdd[3] + al3z;
    const double e2x = qdd[1] * s2 + c2 * w2zz;
    const double a1x = g[0] * c1 + g[1] * s1;
    const double a3x = a1x + 0.045 * e2x;
    const double e3x = c3 * w3zz + s3 * al3z;
    const double a4x = a3x + 0.0298 * e3x;
    const double j4y1 = 3.015e-05 * s4;
    const double n4 = 4.3101e-07 * al4z - j4x1 * a4y + j4y1 * a4x;
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double o4x = l3x + l4x;
    const double j4u = 3.7701e-07 * s4;
    const double j4xy = c4 * j4u;
    const double K4yx = j4xy + o4x * j4y1;
    const double w1zz = qd[0] * qd[0];
    const double t4 = n4 + w1zz * K4yx;
    tau[3] = t4;
    const double j3x1 = 0.0001788 * c3;
    const double j3y1 = 0.0001788 * s3;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double e4x = c4 * al4z - s4 * w4zz;
    const double F4y = 3.015e-05 * e4x;
    const double e4y = c4 * w4zz + s4 * al4z;
    const double F4x = 3.015e-05 * e4y;
    const double l4y = 0.0298 * s3;
    const double n3 = n4 + 4.4942e-06 * al3z - j3x1 * a3y + j3y1 * a3x + l4x * F4y + l4y * F4x;
    const double j3u = 4.3862e-06 * c3;
    const double j3xy = s3 * j3u;
    const double K3yx = j3xy + K4yx + l3x * j3y1 + l4y * j4x1;
    const double t3 = n3 + w1zz * K3yx;
    tau[2] = t3;
    const double j2x1 = 0.0006075 * c2;
    const double F3y = F4y + 0.0001788 * e3y;
    const double t35 = n3 + 2.4381e-05 * qdd[1] - g[2] * j2x1 + a1x * 0.0006075 * s2 + l3x * F3y;
    const double F3x = F4x + 0.0001788 * e3x;
    const double l3y = 0.045 * s2;
    const double j2u = 2.4218999999999996e-05 * c2;
    const double j2xy = s2 * j2u;
    const double S3x = j3x1 + j4x1;
    const double K2yx = j2xy + K3yx + l3y * S3x;
    const double t2 = t35 + l3y * F3x + w1zz * K2yx;
    tau[1] = t2;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double w_2y = qd[0] + qd[0];
    const double t36 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + l4x * j4x1 + l3x
        * S3x;
    const double S2x = j2x1 + S3x;
    const double a1y = g[0] * s1 - g[1] * c1;
    const double N1z = qdd[0] * (t36 + 7.2501e-07) + a1y * S2x - w_2y * R2yx;
    tau[0] = N1z;
}
