/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model hand over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f
 * Do not edit: change the model and generate again.
 */
#include "hand_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void hand_fingertips_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, double *SINEW_RESTRICT in_palm,
    double *SINEW_RESTRICT in_forearm)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        const double phi3_2 = q[5 * n + state] + q[6 * n + state];
        const double phi4_2 = q[7 * n + state] + phi3_2;
        const double phi3_4 = q[9 * n + state] + q[10 * n + state];
        const double phi4_4 = q[11 * n + state] + phi3_4;
        const double phi3_6 = q[13 * n + state] + q[14 * n + state];
        const double phi4_6 = phi3_6 + 1.2222222222222223 * q[14 * n + state];
        const double phi3_8 = q[16 * n + state] + q[17 * n + state];
        const double phi4_8 = phi3_8 + 1.2222222222222223 * q[17 * n + state];
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s1_2, c1_2;
        sinew_sincos(q[4 * n + state], &s1_2, &c1_2);
        double s4_2, c4_2;
        sinew_sincos(phi4_2, &s4_2, &c4_2);
        double s2_2, c2_2;
        sinew_sincos(q[5 * n + state], &s2_2, &c2_2);
        double s3_2, c3_2;
        sinew_sincos(phi3_2, &s3_2, &c3_2);
        double s1_4, c1_4;
        sinew_sincos(q[8 * n + state], &s1_4, &c1_4);
        double s4_4, c4_4;
        sinew_sincos(phi4_4, &s4_4, &c4_4);
        double s2_4, c2_4;
        sinew_sincos(q[9 * n + state], &s2_4, &c2_4);
        double s3_4, c3_4;
        sinew_sincos(phi3_4, &s3_4, &c3_4);
        double s1_6, c1_6;
        sinew_sincos(q[12 * n + state], &s1_6, &c1_6);
        double s4_6, c4_6;
        sinew_sincos(phi4_6, &s4_6, &c4_6);
        double s2_6, c2_6;
        sinew_sincos(q[13 * n + state], &s2_6, &c2_6);
        double s3_6, c3_6;
        sinew_sincos(phi3_6, &s3_6, &c3_6);
        double s1_8, c1_8;
        sinew_sincos(q[15 * n + state], &s1_8, &c1_8);
        double s4_8, c4_8;
        sinew_sincos(phi4_8, &s4_8, &c4_8);
        double s2_8, c2_8;
        sinew_sincos(q[16 * n + state], &s2_8, &c2_8);
        double s3_8, c3_8;
        sinew_sincos(phi3_8, &s3_8, &c3_8);
        double sin2, cos2;
        sinew_sincos(q[18 * n + state], &sin2, &cos2);
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
        const double ptipz_8 = 0.032304 * s2_8 + 0.02384 * s3_8 + 0.01608 * s4_8;
        const double t1 = 0.01 * cos2;
        const double A = 1.2 - cos2;
        const double reach_squared_2 = sinew_max(sin2 * sin2 + A * A, 1e-12);
        const double t2 = 1.0 / reach_squared_2;
        const double reach_2 = sinew_sqrt(reach_squared_2);
        const double C = 1.0045454545454546 - 1.0909090909090908 * cos2;
        const double limited_2 = sinew_min(sinew_max(C, -reach_2), reach_2);
        const double slack = 0.6944444444444444 * (C + reach_2) * (C - reach_2);
        const double side = 1.2 * sinew_sqrt(sinew_max(-slack, 1e-12));
        const double along = 0.012 - t1 + 0.011 * ((sin2 * side - A * limited_2) * t2);
        const double t3 = 0.01 * sin2;
        const double across = t3 - 0.011 * ((sin2 * limited_2 + A * side) * t2);
        const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
        const double t4 = 1.0 / length;
        const double cos3 = along * t4;
        const double R42x_8 = s1_8 * c4_8;
        const double t5 = 0.0048 + (0.032304 * c2_8 + 0.02384 * c3_8);
        const double ptipy_8 = s1_8 * t5 + 0.00456 * c1_8 + 0.01608 * R42x_8;
        const double t6 = 0.006 + ptipy_8;
        const double sin3 = across * t4;
        const double placed_58 = sin3 * t6 + 0.01 - t3 - cos3 * ptipz_8;
        const double p_z = 0.036 * cos_q71;
        const double B_e = 0.074565407529229 * sin_q73;
        const double B_y = 0.074565407529229 * cos_q73;
        const double ratio = 0.003796 / (0.007324 - 0.084 * B_y);
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
        const double t7 = 1.0 / reach_squared;
        const double reach = sinew_sqrt(reach_squared);
        const double p_x = u_e * s_e - u_y * s_y;
        const double projection = 0.034722222222222224 - 13.88888888888889 * (reach_squared + p_x
            * p_x);
        const double limited = sinew_min(sinew_max(-projection, -reach), reach);
        const double clearance = sinew_max((reach + limited) * (reach - limited), 1e-12
            * reach_squared);
        const double root = sinew_sqrt(clearance);
        const double sin_A = (p_y * root - p_z * limited) * t7;
        const double cos_A = (p_y * limited + p_z * root) * t7;
        const double z_plane_x = u_y * cos_A;
        const double z_z = cos_q71 * sin_A + sin_q71 * z_plane_x;
        const double y_z = sin_q71 * u_e;
        const double placed_50 = 0.027 - cos3 * t6 - t1 - sin3 * ptipz_8;
        const double origin_z = sin_q71 * M_e - 0.018 * z_z;
        const double R41x_8 = c1_8 * c4_8;
        const double placed_42 = c1_8 * t5 + 0.065 - 0.00456 * s1_8 + 0.01608 * R41x_8;
        const double x_plane_x = u_y * sin_A;
        const double x_z = cos_q71 * cos_A - sin_q71 * x_plane_x;
        const double seen_118 = origin_z - x_z * placed_42 - y_z * placed_50 - z_z * placed_58;
        const double placed_56 = sin3 * c1_8;
        const double placed_48 = cos3 * c1_8;
        const double seen_116 = x_z * s1_8 + y_z * placed_48 - z_z * placed_56;
        const double R42y_8 = s1_8 * s4_8;
        const double placed_54 = cos3 * c4_8 + sin3 * R42y_8;
        const double placed_46 = cos3 * R42y_8 - sin3 * c4_8;
        const double R41y_8 = c1_8 * s4_8;
        const double seen_114 = x_z * R41y_8 - y_z * placed_46 + z_z * placed_54;
        const double placed_52 = cos3 * s4_8 - sin3 * R42x_8;
        const double placed_44 = cos3 * R42x_8 + sin3 * s4_8;
        const double seen_112 = x_z * R41x_8 - y_z * placed_44 - z_z * placed_52;
        const double z_plane_y = u_e * cos_A;
        const double x_plane_y = u_e * sin_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double seen_110 = origin_y - u_y * placed_50 - x_plane_y * placed_42 + z_plane_y
            * placed_58;
        const double seen_108 = u_y * placed_48 + x_plane_y * s1_8 + z_plane_y * placed_56;
        const double seen_106 = u_y * placed_46 - x_plane_y * R41y_8 + z_plane_y * placed_54;
        const double seen_104 = u_y * placed_44 - x_plane_y * R41x_8 - z_plane_y * placed_52;
        const double z_x = cos_q71 * z_plane_x - sin_q71 * sin_A;
        const double y_x = cos_q71 * u_e;
        const double origin_x = cos_q71 * M_e - 0.018 * z_x;
        const double x_x = cos_q71 * x_plane_x + sin_q71 * cos_A;
        const double seen_102 = origin_x + x_x * placed_42 - y_x * placed_50 - z_x * placed_58;
        const double seen_100 = x_x * s1_8 - y_x * placed_48 + z_x * placed_56;
        const double seen_98 = x_x * R41y_8 + y_x * placed_46 - z_x * placed_54;
        const double seen_96 = x_x * R41x_8 + y_x * placed_44 + z_x * placed_52;
        const double ptipz_6 = 0.04038 * s2_6 + 0.0298 * s3_6 + 0.0201 * s4_6;
        const double R42x_6 = s1_6 * c4_6;
        const double t8 = 0.006 + (0.04038 * c2_6 + 0.0298 * c3_6);
        const double placed_40 = 0.007 - s1_6 * t8 - 0.0057 * c1_6 - 0.0201 * R42x_6;
        const double R41x_6 = c1_6 * c4_6;
        const double placed_36 = c1_6 * t8 + 0.07 - 0.0057 * s1_6 + 0.0201 * R41x_6;
        const double seen_94 = origin_z - x_z * placed_36 - y_z * placed_40 + z_z * ptipz_6;
        const double R42y_6 = s1_6 * s4_6;
        const double R41y_6 = c1_6 * s4_6;
        const double seen_86 = origin_y - u_y * placed_40 - x_plane_y * placed_36 - z_plane_y
            * ptipz_6;
        const double seen_82 = u_y * R42y_6 - x_plane_y * R41y_6 + z_plane_y * c4_6;
        const double seen_80 = u_y * R42x_6 - x_plane_y * R41x_6 - z_plane_y * s4_6;
        const double seen_78 = origin_x + x_x * placed_36 - y_x * placed_40 + z_x * ptipz_6;
        const double ptipz_4 = 0.0436104 * s2_4 + 0.032184 * s3_4 + 0.021708 * s4_4;
        const double R42x_4 = s1_4 * c4_4;
        const double t9 = 0.00648 + (0.0436104 * c2_4 + 0.032184 * c3_4);
        const double placed_34 = s1_4 * t9 + 0.007 + 0.006156 * c1_4 + 0.021708 * R42x_4;
        const double R41x_4 = c1_4 * c4_4;
        const double placed_30 = c1_4 * t9 + 0.072 - 0.006156 * s1_4 + 0.021708 * R41x_4;
        const double seen_70 = origin_z - x_z * placed_30 + y_z * placed_34 + z_z * ptipz_4;
        const double R42y_4 = s1_4 * s4_4;
        const double R41y_4 = c1_4 * s4_4;
        const double seen_62 = origin_y + u_y * placed_34 - x_plane_y * placed_30 - z_plane_y
            * ptipz_4;
        const double seen_58 = u_y * R42y_4 - x_plane_y * R41y_4 + z_plane_y * c4_4;
        const double seen_56 = u_y * R42x_4 - x_plane_y * R41x_4 - z_plane_y * s4_4;
        const double seen_54 = origin_x + x_x * placed_30 + y_x * placed_34 + z_x * ptipz_4;
        const double ptipz_2 = 0.04038 * s2_2 + 0.0298 * s3_2 + 0.0201 * s4_2;
        const double R42x_2 = s1_2 * c4_2;
        const double t10 = 0.006 + (0.04038 * c2_2 + 0.0298 * c3_2);
        const double placed_28 = s1_2 * t10 + 0.021 + 0.0057 * c1_2 + 0.0201 * R42x_2;
        const double R41x_2 = c1_2 * c4_2;
        const double placed_24 = c1_2 * t10 + 0.07 - 0.0057 * s1_2 + 0.0201 * R41x_2;
        const double seen_46 = origin_z - x_z * placed_24 + y_z * placed_28 + z_z * ptipz_2;
        const double R42y_2 = s1_2 * s4_2;
        const double R41y_2 = c1_2 * s4_2;
        const double seen_38 = origin_y + u_y * placed_28 - x_plane_y * placed_24 - z_plane_y
            * ptipz_2;
        const double seen_34 = u_y * R42y_2 - x_plane_y * R41y_2 + z_plane_y * c4_2;
        const double seen_32 = u_y * R42x_2 - x_plane_y * R41x_2 - z_plane_y * s4_2;
        const double seen_30 = origin_x + x_x * placed_24 + y_x * placed_28 + z_x * ptipz_2;
        const double ptipz = 0.045 * s2 + 0.0298 * s3 + 0.0201 * s4;
        const double R42y = s1 * c4;
        const double o4x = 0.045 * c2 + 0.0298 * c3;
        const double ptipy = s1 * o4x + 0.0201 * R42y;
        const double placed_22 = 0.01 - 0.5000000000000001 * ptipz + 0.8660254037844386 * ptipy;
        const double R41y = c1 * c4;
        const double ptipx = c1 * o4x + 0.0201 * R41y;
        const double placed_14 = 0.03 + 0.3830222215594891 * ptipy + 0.6427876096865393 * ptipx
            + 0.6634139481689384 * ptipz;
        const double placed_6 = 0.01 - 0.32139380484326974 * ptipy - 0.5566703992264193 * ptipz
            + 0.766044443118978 * ptipx;
        const double seen_22 = origin_z - x_z * placed_6 + y_z * placed_14 - z_z * placed_22;
        const double R42x = s1 * s4;
        const double placed_20 = 0.5000000000000001 * c4 + 0.8660254037844386 * R42x;
        const double R41x = c1 * s4;
        const double placed_12 = 0.3830222215594891 * R42x + 0.6427876096865393 * R41x
            - 0.6634139481689384 * c4;
        const double placed_4 = 0.32139380484326974 * R42x - 0.5566703992264193 * c4
            - 0.766044443118978 * R41x;
        const double seen_20 = x_z * placed_4 + y_z * placed_12 - z_z * placed_20;
        const double placed_18 = 0.8660254037844386 * c1;
        const double placed_10 = 0.3830222215594891 * c1 - 0.6427876096865393 * s1;
        const double placed_2 = 0.32139380484326974 * c1 + 0.766044443118978 * s1;
        const double seen_18 = x_z * placed_2 + y_z * placed_10 - z_z * placed_18;
        const double placed_16 = 0.5000000000000001 * s4 - 0.8660254037844386 * R42y;
        const double placed_8 = 0.3830222215594891 * R42y + 0.6427876096865393 * R41y
            + 0.6634139481689384 * s4;
        const double placed = 0.32139380484326974 * R42y + 0.5566703992264193 * s4
            - 0.766044443118978 * R41y;
        const double seen_16 = x_z * placed + y_z * placed_8 + z_z * placed_16;
        const double seen_14 = origin_y + u_y * placed_14 - x_plane_y * placed_6 + z_plane_y
            * placed_22;
        const double seen_12 = u_y * placed_12 + x_plane_y * placed_4 + z_plane_y * placed_20;
        const double seen_10 = u_y * placed_10 + x_plane_y * placed_2 + z_plane_y * placed_18;
        const double seen_8 = u_y * placed_8 + x_plane_y * placed - z_plane_y * placed_16;
        const double seen_6 = origin_x + x_x * placed_6 + y_x * placed_14 - z_x * placed_22;
        const double seen_4 = x_x * placed_4 - y_x * placed_12 + z_x * placed_20;
        const double seen_2 = x_x * placed_2 - y_x * placed_10 + z_x * placed_18;
        const double seen = x_x * placed - y_x * placed_8 - z_x * placed_16;
        in_palm[state] = -placed;
        in_palm[1 * n + state] = -placed_2;
        in_palm[2 * n + state] = placed_4;
        in_palm[3 * n + state] = placed_6;
        in_palm[4 * n + state] = placed_8;
        in_palm[5 * n + state] = placed_10;
        in_palm[6 * n + state] = -placed_12;
        in_palm[7 * n + state] = placed_14;
        in_palm[8 * n + state] = placed_16;
        in_palm[9 * n + state] = -placed_18;
        in_palm[10 * n + state] = placed_20;
        in_palm[11 * n + state] = -placed_22;
        in_palm[12 * n + state] = 0.0;
        in_palm[13 * n + state] = 0.0;
        in_palm[14 * n + state] = 0.0;
        in_palm[15 * n + state] = 1.0;
        in_palm[16 * n + state] = R41x_2;
        in_palm[17 * n + state] = -R41y_2;
        in_palm[18 * n + state] = s1_2;
        in_palm[19 * n + state] = placed_24;
        in_palm[20 * n + state] = R42x_2;
        in_palm[21 * n + state] = -R42y_2;
        in_palm[22 * n + state] = -c1_2;
        in_palm[23 * n + state] = placed_28;
        in_palm[24 * n + state] = s4_2;
        in_palm[25 * n + state] = c4_2;
        in_palm[26 * n + state] = 0.0;
        in_palm[27 * n + state] = ptipz_2;
        in_palm[28 * n + state] = 0.0;
        in_palm[29 * n + state] = 0.0;
        in_palm[30 * n + state] = 0.0;
        in_palm[31 * n + state] = 1.0;
        in_palm[32 * n + state] = R41x_4;
        in_palm[33 * n + state] = -R41y_4;
        in_palm[34 * n + state] = s1_4;
        in_palm[35 * n + state] = placed_30;
        in_palm[36 * n + state] = R42x_4;
        in_palm[37 * n + state] = -R42y_4;
        in_palm[38 * n + state] = -c1_4;
        in_palm[39 * n + state] = placed_34;
        in_palm[40 * n + state] = s4_4;
        in_palm[41 * n + state] = c4_4;
        in_palm[42 * n + state] = 0.0;
        in_palm[43 * n + state] = ptipz_4;
        in_palm[44 * n + state] = 0.0;
        in_palm[45 * n + state] = 0.0;
        in_palm[46 * n + state] = 0.0;
        in_palm[47 * n + state] = 1.0;
        in_palm[48 * n + state] = R41x_6;
        in_palm[49 * n + state] = -R41y_6;
        in_palm[50 * n + state] = s1_6;
        in_palm[51 * n + state] = placed_36;
        in_palm[52 * n + state] = R42x_6;
        in_palm[53 * n + state] = -R42y_6;
        in_palm[54 * n + state] = -c1_6;
        in_palm[55 * n + state] = -placed_40;
        in_palm[56 * n + state] = s4_6;
        in_palm[57 * n + state] = c4_6;
        in_palm[58 * n + state] = 0.0;
        in_palm[59 * n + state] = ptipz_6;
        in_palm[60 * n + state] = 0.0;
        in_palm[61 * n + state] = 0.0;
        in_palm[62 * n + state] = 0.0;
        in_palm[63 * n + state] = 1.0;
        in_palm[64 * n + state] = R41x_8;
        in_palm[65 * n + state] = -R41y_8;
        in_palm[66 * n + state] = s1_8;
        in_palm[67 * n + state] = placed_42;
        in_palm[68 * n + state] = placed_44;
        in_palm[69 * n + state] = -placed_46;
        in_palm[70 * n + state] = -placed_48;
        in_palm[71 * n + state] = -placed_50;
        in_palm[72 * n + state] = placed_52;
        in_palm[73 * n + state] = placed_54;
        in_palm[74 * n + state] = placed_56;
        in_palm[75 * n + state] = -placed_58;
        in_palm[76 * n + state] = 0.0;
        in_palm[77 * n + state] = 0.0;
        in_palm[78 * n + state] = 0.0;
        in_palm[79 * n + state] = 1.0;
        in_forearm[state] = -seen;
        in_forearm[1 * n + state] = -seen_2;
        in_forearm[2 * n + state] = seen_4;
        in_forearm[3 * n + state] = seen_6;
        in_forearm[4 * n + state] = seen_8;
        in_forearm[5 * n + state] = seen_10;
        in_forearm[6 * n + state] = -seen_12;
        in_forearm[7 * n + state] = seen_14;
        in_forearm[8 * n + state] = seen_16;
        in_forearm[9 * n + state] = seen_18;
        in_forearm[10 * n + state] = -seen_20;
        in_forearm[11 * n + state] = seen_22;
        in_forearm[12 * n + state] = 0.0;
        in_forearm[13 * n + state] = 0.0;
        in_forearm[14 * n + state] = 0.0;
        in_forearm[15 * n + state] = 1.0;
        in_forearm[16 * n + state] = x_x * R41x_2 + y_x * R42x_2 + z_x * s4_2;
        in_forearm[17 * n + state] = -(x_x * R41y_2 + y_x * R42y_2 - z_x * c4_2);
        in_forearm[18 * n + state] = x_x * s1_2 - y_x * c1_2;
        in_forearm[19 * n + state] = seen_30;
        in_forearm[20 * n + state] = seen_32;
        in_forearm[21 * n + state] = -seen_34;
        in_forearm[22 * n + state] = -(u_y * c1_2 + x_plane_y * s1_2);
        in_forearm[23 * n + state] = seen_38;
        in_forearm[24 * n + state] = -(x_z * R41x_2 - y_z * R42x_2 - z_z * s4_2);
        in_forearm[25 * n + state] = x_z * R41y_2 - y_z * R42y_2 + z_z * c4_2;
        in_forearm[26 * n + state] = -(x_z * s1_2 + y_z * c1_2);
        in_forearm[27 * n + state] = seen_46;
        in_forearm[28 * n + state] = 0.0;
        in_forearm[29 * n + state] = 0.0;
        in_forearm[30 * n + state] = 0.0;
        in_forearm[31 * n + state] = 1.0;
        in_forearm[32 * n + state] = x_x * R41x_4 + y_x * R42x_4 + z_x * s4_4;
        in_forearm[33 * n + state] = -(x_x * R41y_4 + y_x * R42y_4 - z_x * c4_4);
        in_forearm[34 * n + state] = x_x * s1_4 - y_x * c1_4;
        in_forearm[35 * n + state] = seen_54;
        in_forearm[36 * n + state] = seen_56;
        in_forearm[37 * n + state] = -seen_58;
        in_forearm[38 * n + state] = -(u_y * c1_4 + x_plane_y * s1_4);
        in_forearm[39 * n + state] = seen_62;
        in_forearm[40 * n + state] = -(x_z * R41x_4 - y_z * R42x_4 - z_z * s4_4);
        in_forearm[41 * n + state] = x_z * R41y_4 - y_z * R42y_4 + z_z * c4_4;
        in_forearm[42 * n + state] = -(x_z * s1_4 + y_z * c1_4);
        in_forearm[43 * n + state] = seen_70;
        in_forearm[44 * n + state] = 0.0;
        in_forearm[45 * n + state] = 0.0;
        in_forearm[46 * n + state] = 0.0;
        in_forearm[47 * n + state] = 1.0;
        in_forearm[48 * n + state] = x_x * R41x_6 + y_x * R42x_6 + z_x * s4_6;
        in_forearm[49 * n + state] = -(x_x * R41y_6 + y_x * R42y_6 - z_x * c4_6);
        in_forearm[50 * n + state] = x_x * s1_6 - y_x * c1_6;
        in_forearm[51 * n + state] = seen_78;
        in_forearm[52 * n + state] = seen_80;
        in_forearm[53 * n + state] = -seen_82;
        in_forearm[54 * n + state] = -(u_y * c1_6 + x_plane_y * s1_6);
        in_forearm[55 * n + state] = seen_86;
        in_forearm[56 * n + state] = -(x_z * R41x_6 - y_z * R42x_6 - z_z * s4_6);
        in_forearm[57 * n + state] = x_z * R41y_6 - y_z * R42y_6 + z_z * c4_6;
        in_forearm[58 * n + state] = -(x_z * s1_6 + y_z * c1_6);
        in_forearm[59 * n + state] = seen_94;
        in_forearm[60 * n + state] = 0.0;
        in_forearm[61 * n + state] = 0.0;
        in_forearm[62 * n + state] = 0.0;
        in_forearm[63 * n + state] = 1.0;
        in_forearm[64 * n + state] = seen_96;
        in_forearm[65 * n + state] = -seen_98;
        in_forearm[66 * n + state] = seen_100;
        in_forearm[67 * n + state] = seen_102;
        in_forearm[68 * n + state] = seen_104;
        in_forearm[69 * n + state] = -seen_106;
        in_forearm[70 * n + state] = -seen_108;
        in_forearm[71 * n + state] = seen_110;
        in_forearm[72 * n + state] = -seen_112;
        in_forearm[73 * n + state] = seen_114;
        in_forearm[74 * n + state] = -seen_116;
        in_forearm[75 * n + state] = seen_118;
        in_forearm[76 * n + state] = 0.0;
        in_forearm[77 * n + state] = 0.0;
        in_forearm[78 * n + state] = 0.0;
        in_forearm[79 * n + state] = 1.0;
    }
}

void hand_finger_gravity_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, const double *SINEW_RESTRICT gravity,
    double *SINEW_RESTRICT g)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
        double sin2, cos2;
        sinew_sincos(q[18 * n + state], &sin2, &cos2);
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
        const double t2 = gravity[1 * n + state] * u_e;
        const double turned = gravity[state] * (cos_q71 * x_plane_x + sin_q71 * cos_A) - t2 * sin_A
            - gravity[2 * n + state] * (cos_q71 * cos_A - sin_q71 * x_plane_x);
        const double turned_2 = u_e * (gravity[state] * cos_q71 + gravity[2 * n + state] * sin_q71)
            + gravity[1 * n + state] * u_y;
        const double turned_6 = 0.6427876096865393 * turned_2 + 0.766044443118978 * turned;
        const double z_plane_x = u_y * cos_A;
        const double turned_4 = gravity[state] * (cos_q71 * z_plane_x - sin_q71 * sin_A) - t2
            * cos_A + gravity[2 * n + state] * (cos_q71 * sin_A + sin_q71 * z_plane_x);
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
        const double t3 = 1.0 / reach_squared_2;
        const double along = 0.012 - 0.01 * cos2 + 0.011 * ((sin2 * side - A * limited_2) * t3);
        const double across = 0.01 * sin2 - 0.011 * ((sin2 * limited_2 + A * side) * t3);
        const double length = sinew_sqrt(sinew_max(along * along + across * across, 1.44e-16));
        const double t4 = 1.0 / length;
        const double sin3 = across * t4;
        const double cos3 = along * t4;
        g[state] = turned_6;
        g[1 * n + state] = -turned_8;
        g[2 * n + state] = turned_10;
        g[3 * n + state] = turned;
        g[4 * n + state] = turned_2;
        g[5 * n + state] = turned_4;
        g[6 * n + state] = turned;
        g[7 * n + state] = turned_2;
        g[8 * n + state] = turned_4;
        g[9 * n + state] = turned;
        g[10 * n + state] = turned_2;
        g[11 * n + state] = turned_4;
        g[12 * n + state] = turned;
        g[13 * n + state] = cos3 * turned_2 - sin3 * turned_4;
        g[14 * n + state] = cos3 * turned_4 + sin3 * turned_2;
    }
}

void hand_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
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
        const double t11 = 0.005 * (c1 * s2);
        const double t12 = 0.006 * s1;
        const double t13 = t11 - t12;
        const double t14 = 0.047 * (c1 * c2);
        const double A_lengthdx = 0.002 - t13 - t14;
        const double t15 = 0.005 * (s1 * s2);
        const double t16 = 0.006 * c1;
        const double t17 = 0.03 - (t15 + t16);
        const double t18 = 0.047 * (s1 * c2);
        const double A_lengthdy = t17 - t18;
        const double t19 = 0.025 - 0.005 * c2;
        const double t20 = 0.047 * s2;
        const double A_lengthdz = t19 + t20;
        const double t21 = A_lengthdz * A_lengthdz;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t21);
        const double strand_1_x = layer_0_x - 0.001 * y_x;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double strand_1_z = layer_0_z - 0.001 * y_z;
        const double t22 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double t23 = t11 + t12;
        const double B_lengthdx = 0.002 + t23 - t14;
        const double t24 = 0.03 + (t15 - t16);
        const double B_lengthdy = t24 - t18;
        const double B_lengthdz = t19 - t20;
        const double t25 = B_lengthdz * B_lengthdz;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t25);
        const double t26 = 0.003 * y_x;
        const double strand_2_x = layer_0_x - t26;
        const double t27 = 0.003 * u_y;
        const double strand_2_y = 0.003 + layer_0_y - t27;
        const double t28 = 0.003 * y_z;
        const double strand_2_z = layer_0_z - t28;
        const double t29 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double C_lengthdx = 0.002 - t23 - t14;
        const double C_lengthdy = t24 + t18;
        const double C_length = sinew_sqrt(t21 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t30 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t30;
        const double t31 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t31;
        const double t32 = 0.005 * y_z;
        const double strand_3_z = layer_0_z - t32;
        const double t33 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double D_lengthdx = 0.002 + t13 - t14;
        const double D_lengthdy = t17 + t18;
        const double D_length = sinew_sqrt(t25 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double strand_4_x = layer_0_x - 0.006 * y_x;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double strand_4_z = layer_0_z - 0.006 * y_z;
        const double t34 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double t35 = 0.0065 * q[2 * n + state];
        const double t36 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t36;
        const double t37 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t37;
        const double t38 = 0.008 * y_z;
        const double strand_5_z = layer_0_z - t38;
        const double t39 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double strand_6_x = layer_0_x - 0.009 * y_x;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double strand_6_z = layer_0_z - 0.009 * y_z;
        const double t40 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double t41 = 0.0055 * q[3 * n + state];
        const double strand_7_x = layer_0_x - t4;
        const double strand_7_y = 0.011 + layer_0_y - t7;
        const double strand_7_z = layer_0_z - t10;
        const double t42 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double t43 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t43;
        const double t44 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t44;
        const double t45 = 0.013 * y_z;
        const double strand_8_z = layer_0_z - t45;
        const double t46 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double t47 = 0.0065 * q[4 * n + state];
        const double t48 = 0.0065 * q[5 * n + state];
        const double strand_9_x = layer_0_x - 0.014 * y_x;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double strand_9_z = layer_0_z - 0.014 * y_z;
        const double t49 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double t50 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t50;
        const double t51 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t51;
        const double t52 = 0.016 * y_z;
        const double strand_10_z = layer_0_z - t52;
        const double t53 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double strand_11_x = layer_0_x - 0.017 * y_x;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double strand_11_z = layer_0_z - 0.017 * y_z;
        const double t54 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double t55 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t55;
        const double t56 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t56;
        const double t57 = 0.019 * y_z;
        const double strand_12_z = layer_0_z - t57;
        const double t58 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double t59 = 0.0055 * q[6 * n + state];
        const double t60 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t60;
        const double t61 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t61;
        const double t62 = 0.021 * y_z;
        const double strand_13_z = layer_0_z - t62;
        const double t63 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double strand_14_x = layer_0_x - 0.022 * y_x;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double strand_14_z = layer_0_z - 0.022 * y_z;
        const double t64 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double t65 = 0.0045 * q[7 * n + state];
        const double t66 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t66;
        const double t67 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t67;
        const double t68 = 0.024 * y_z;
        const double strand_15_z = layer_0_z - t68;
        const double t69 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double strand_16_x = layer_0_x - 0.025 * y_x;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double strand_16_z = layer_0_z - 0.025 * y_z;
        const double t70 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double t71 = 0.0065 * q[8 * n + state];
        const double t72 = 0.0065 * q[9 * n + state];
        const double t73 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t73;
        const double t74 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t74;
        const double t75 = 0.027 * y_z;
        const double strand_17_z = layer_0_z - t75;
        const double t76 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double t77 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t77;
        const double t78 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t78;
        const double t79 = 0.029 * y_z;
        const double strand_18_z = layer_0_z - t79;
        const double t80 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double layer_1_x = t2 + t3 + t43;
        const double layer_1_y = 0.006 - origin_y - t5 - t6 + t44;
        const double layer_1_z = 0.028 - origin_z - t8 + t9 + t45;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double strand_20_x = layer_1_x - 0.002 * y_x;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double strand_20_z = layer_1_z - 0.002 * y_z;
        const double t81 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double t82 = 0.0055 * q[10 * n + state];
        const double strand_21_x = layer_1_x - t26;
        const double strand_21_y = 0.003 + layer_1_y - t27;
        const double strand_21_z = layer_1_z - t28;
        const double t83 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double strand_22_x = layer_1_x - t30;
        const double strand_22_y = 0.005 + layer_1_y - t31;
        const double strand_22_z = layer_1_z - t32;
        const double t84 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double t85 = 0.0045 * q[11 * n + state];
        const double strand_23_x = layer_1_x - 0.007 * y_x;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double strand_23_z = layer_1_z - 0.007 * y_z;
        const double t86 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double strand_24_x = layer_1_x - t36;
        const double strand_24_y = 0.008 + layer_1_y - t37;
        const double strand_24_z = layer_1_z - t38;
        const double t87 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double t88 = 0.0065 * q[12 * n + state];
        const double t89 = 0.0065 * q[13 * n + state];
        const double strand_25_x = layer_1_x - 0.01 * y_x;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double strand_25_z = layer_1_z - 0.01 * y_z;
        const double t90 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double strand_26_x = layer_1_x - t4;
        const double strand_26_y = 0.011 + layer_1_y - t7;
        const double strand_26_z = layer_1_z - t10;
        const double t91 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double strand_27_x = layer_1_x - t43;
        const double strand_27_y = 0.013 + layer_1_y - t44;
        const double strand_27_z = layer_1_z - t45;
        const double t92 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double strand_28_x = layer_1_x - 0.015 * y_x;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double strand_28_z = layer_1_z - 0.015 * y_z;
        const double t93 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double t94 = 0.011000000000000001 * q[14 * n + state];
        const double strand_29_x = layer_1_x - t50;
        const double strand_29_y = 0.016 + layer_1_y - t51;
        const double strand_29_z = layer_1_z - t52;
        const double t95 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double strand_30_x = layer_1_x - 0.018 * y_x;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double strand_30_z = layer_1_z - 0.018 * y_z;
        const double t96 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double t97 = 0.0052 * q[15 * n + state];
        const double t98 = 0.0052 * q[16 * n + state];
        const double strand_31_x = layer_1_x - t55;
        const double strand_31_y = 0.019 + layer_1_y - t56;
        const double strand_31_z = layer_1_z - t57;
        const double t99 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double strand_32_x = layer_1_x - t60;
        const double strand_32_y = 0.021 + layer_1_y - t61;
        const double strand_32_z = layer_1_z - t62;
        const double t100 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double strand_33_x = layer_1_x - 0.023 * y_x;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double strand_33_z = layer_1_z - 0.023 * y_z;
        const double t101 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double strand_34_x = layer_1_x - t66;
        const double strand_34_y = 0.024 + layer_1_y - t67;
        const double strand_34_z = layer_1_z - t68;
        const double t102 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double t103 = 0.0088 * q[17 * n + state];
        const double strand_35_x = layer_1_x - 0.026 * y_x;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double strand_35_z = layer_1_z - 0.026 * y_z;
        const double t104 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double strand_36_x = layer_1_x - t73;
        const double strand_36_y = 0.027 + layer_1_y - t74;
        const double strand_36_z = layer_1_z - t75;
        const double t105 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length = 0.007853981633974483 - 0.005 * q[18 * n + state];
        const double strand_37_x = layer_1_x - t77;
        const double strand_37_y = 0.029 + layer_1_y - t78;
        const double strand_37_z = layer_1_z - t79;
        const double t106 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        h[state] = A_length + length_0;
        h[1 * n + state] = B_length + sinew_sqrt(t22);
        h[2 * n + state] = C_length + sinew_sqrt(t29);
        h[3 * n + state] = D_length + sinew_sqrt(t33);
        h[4 * n + state] = sinew_sqrt(t34) + t35;
        h[5 * n + state] = sinew_sqrt(t39) - t35;
        h[6 * n + state] = sinew_sqrt(t40) + t41 - t35;
        h[7 * n + state] = sinew_sqrt(t42) - t41 + t35;
        h[8 * n + state] = sinew_sqrt(t46) + t47 + t48;
        h[9 * n + state] = sinew_sqrt(t49) + t47 - t48;
        h[10 * n + state] = sinew_sqrt(t53) - t47 + t48;
        h[11 * n + state] = sinew_sqrt(t54) - t47 - t48;
        h[12 * n + state] = sinew_sqrt(t58) + t59;
        h[13 * n + state] = sinew_sqrt(t63) - t59;
        h[14 * n + state] = sinew_sqrt(t64) - t65 + t59;
        h[15 * n + state] = sinew_sqrt(t69) + t65 - t59;
        h[16 * n + state] = sinew_sqrt(t70) + t71 + t72;
        h[17 * n + state] = sinew_sqrt(t76) + t71 - t72;
        h[18 * n + state] = sinew_sqrt(t80) - t71 + t72;
        h[19 * n + state] = length_19 - t71 - t72;
        h[20 * n + state] = sinew_sqrt(t81) + t82;
        h[21 * n + state] = sinew_sqrt(t83) - t82;
        h[22 * n + state] = sinew_sqrt(t84) - t85 + t82;
        h[23 * n + state] = sinew_sqrt(t86) + t85 - t82;
        h[24 * n + state] = sinew_sqrt(t87) + t88 + t89;
        h[25 * n + state] = sinew_sqrt(t90) + t88 - t89;
        h[26 * n + state] = sinew_sqrt(t91) - t88 + t89;
        h[27 * n + state] = sinew_sqrt(t92) - t88 - t89;
        h[28 * n + state] = sinew_sqrt(t93) + t94;
        h[29 * n + state] = sinew_sqrt(t95) - t94;
        h[30 * n + state] = sinew_sqrt(t96) + t97 + t98;
        h[31 * n + state] = sinew_sqrt(t99) + t97 - t98;
        h[32 * n + state] = sinew_sqrt(t100) - t97 + t98;
        h[33 * n + state] = sinew_sqrt(t101) - t97 - t98;
        h[34 * n + state] = sinew_sqrt(t102) + t103;
        h[35 * n + state] = sinew_sqrt(t104) - t103;
        h[36 * n + state] = -(length - sinew_sqrt(t105));
        h[37 * n + state] = length + sinew_sqrt(t106);
    }
}

void hand_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, double *SINEW_RESTRICT P)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double t1 = 1.0 / (0.007324 - 0.084 * B_y);
        const double ratio = 0.003796 * t1;
        const double B_e = 0.074565407529229 * sin_q73;
        const double ratio_by_q73 = ratio * (0.084 * B_e) * t1;
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
        const double root = sinew_sqrt(sinew_max(t20, t21));
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
        const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t27 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t28 = 0.01 * z_x_by_q73;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t29 = 0.013 * y_x_by_q73;
        const double layer_1_x_by_q73 = t27 - t28 - t29;
        const double t30 = 0.029 * y_x_by_q73;
        const double z_plane_x = u_y * cos_A;
        const double t31 = cos_q71 * z_plane_x;
        const double t32 = sin_q71 * sin_A;
        const double z_x = t31 - t32;
        const double M_x = cos_q71 * M_e;
        const double x_plane_x = u_y * sin_A;
        const double t33 = cos_q71 * x_plane_x;
        const double t34 = sin_q71 * cos_A;
        const double t35 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t33 + t34);
        const double t36 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double t37 = 0.013 * y_x;
        const double layer_1_x = t35 + t36 + t37;
        const double t38 = 0.029 * y_x;
        const double strand_37_x = layer_1_x - t38;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t39 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t40 = 0.01 * z_plane_y_by_q73;
        const double t41 = 0.013 * u_y_by_q73;
        const double layer_1_y_by_q73 = t39 - t40 - t41;
        const double t42 = 0.029 * u_y_by_q73;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t43 = 0.004 * (u_e * sin_A);
        const double t44 = 0.01 * z_plane_y;
        const double t45 = 0.013 * u_y;
        const double layer_1_y = 0.006 - origin_y - t43 - t44 + t45;
        const double t46 = 0.029 * u_y;
        const double strand_37_y = 0.029 + layer_1_y - t46;
        const double t47 = strand_37_x * (layer_1_x_by_q73 + t30) - strand_37_y * (layer_1_y_by_q73
            + t42);
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t48 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t49 = 0.01 * z_z_by_q73;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t50 = 0.013 * y_z_by_q73;
        const double layer_1_z_by_q73 = t48 - t49 - t50;
        const double t51 = 0.029 * y_z_by_q73;
        const double t52 = sin_q71 * z_plane_x;
        const double t53 = cos_q71 * sin_A;
        const double z_z = t53 + t52;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double t54 = sin_q71 * x_plane_x;
        const double t55 = cos_q71 * cos_A;
        const double t56 = 0.004 * (t55 - t54);
        const double t57 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double t58 = 0.013 * y_z;
        const double layer_1_z = 0.028 - origin_z - t56 + t57 + t58;
        const double t59 = 0.029 * y_z;
        const double strand_37_z = layer_1_z - t59;
        const double t60 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double t61 = 1.0 / sinew_sqrt(t60);
        const double length_37_by_q73 = (t47 + strand_37_z * (layer_1_z_by_q73 + t51)) * t61;
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
        const double t62 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double cos_A_by_q71 = (t62 - cos_A * reach_squared_by_q71) * t24;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double t63 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t63 - sin_A * reach_squared_by_q71) * t24;
        const double z_x_by_q71 = t53 - cos_q71 * z_plane_x_by_q71 + t52 + sin_q71 * sin_A_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double x_x_by_q71 = t55 + cos_q71 * x_plane_x_by_q71 - t54 + sin_q71 * cos_A_by_q71;
        const double t64 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
        const double t65 = 0.01 * z_x_by_q71;
        const double layer_1_x_by_q71 = t64 - t65 - t58;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t66 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t67 = 0.01 * z_plane_y_by_q71;
        const double layer_1_y_by_q71 = t66 + t67;
        const double z_z_by_q71 = t31 + cos_q71 * sin_A_by_q71 - t32 + sin_q71 * z_plane_x_by_q71;
        const double x_z_by_q71 = t33 - cos_q71 * cos_A_by_q71 + t34 + sin_q71 * x_plane_x_by_q71;
        const double t68 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t69 = 0.01 * z_z_by_q71;
        const double layer_1_z_by_q71 = t68 - t69 - t37;
        const double t70 = strand_37_x * (layer_1_x_by_q71 + t59) - strand_37_y * layer_1_y_by_q71
            - strand_37_z * (layer_1_z_by_q71 + t38);
        const double t71 = 0.027 * y_x_by_q73;
        const double t72 = 0.027 * y_x;
        const double strand_36_x = layer_1_x - t72;
        const double t73 = 0.027 * u_y_by_q73;
        const double t74 = 0.027 * u_y;
        const double strand_36_y = 0.027 + layer_1_y - t74;
        const double t75 = strand_36_x * (layer_1_x_by_q73 + t71) - strand_36_y * (layer_1_y_by_q73
            + t73);
        const double t76 = 0.027 * y_z_by_q73;
        const double t77 = 0.027 * y_z;
        const double strand_36_z = layer_1_z - t77;
        const double t78 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double t79 = 1.0 / sinew_sqrt(t78);
        const double length_36_by_q73 = (t75 + strand_36_z * (layer_1_z_by_q73 + t76)) * t79;
        const double t80 = strand_36_x * (layer_1_x_by_q71 + t77) - strand_36_y * layer_1_y_by_q71
            - strand_36_z * (layer_1_z_by_q71 + t72);
        const double t81 = 0.026 * y_x;
        const double strand_35_x = layer_1_x - t81;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double t82 = strand_35_x * (layer_1_x_by_q73 + 0.026 * y_x_by_q73) - strand_35_y
            * (layer_1_y_by_q73 + 0.026 * u_y_by_q73);
        const double t83 = 0.026 * y_z;
        const double strand_35_z = layer_1_z - t83;
        const double t84 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double t85 = 1.0 / sinew_sqrt(t84);
        const double length_35_by_q73 = (t82 + strand_35_z * (layer_1_z_by_q73 + 0.026
            * y_z_by_q73)) * t85;
        const double t86 = strand_35_x * (layer_1_x_by_q71 + t83) - strand_35_y * layer_1_y_by_q71
            - strand_35_z * (layer_1_z_by_q71 + t81);
        const double t87 = 0.024 * y_x_by_q73;
        const double t88 = 0.024 * y_x;
        const double strand_34_x = layer_1_x - t88;
        const double t89 = 0.024 * u_y_by_q73;
        const double t90 = 0.024 * u_y;
        const double strand_34_y = 0.024 + layer_1_y - t90;
        const double t91 = strand_34_x * (layer_1_x_by_q73 + t87) - strand_34_y * (layer_1_y_by_q73
            + t89);
        const double t92 = 0.024 * y_z_by_q73;
        const double t93 = 0.024 * y_z;
        const double strand_34_z = layer_1_z - t93;
        const double t94 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double t95 = 1.0 / sinew_sqrt(t94);
        const double length_34_by_q73 = (t91 + strand_34_z * (layer_1_z_by_q73 + t92)) * t95;
        const double t96 = strand_34_x * (layer_1_x_by_q71 + t93) - strand_34_y * layer_1_y_by_q71
            - strand_34_z * (layer_1_z_by_q71 + t88);
        const double t97 = 0.023 * y_x;
        const double strand_33_x = layer_1_x - t97;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double t98 = strand_33_x * (layer_1_x_by_q73 + 0.023 * y_x_by_q73) - strand_33_y
            * (layer_1_y_by_q73 + 0.023 * u_y_by_q73);
        const double t99 = 0.023 * y_z;
        const double strand_33_z = layer_1_z - t99;
        const double t100 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double t101 = 1.0 / sinew_sqrt(t100);
        const double length_33_by_q73 = (t98 + strand_33_z * (layer_1_z_by_q73 + 0.023
            * y_z_by_q73)) * t101;
        const double t102 = strand_33_x * (layer_1_x_by_q71 + t99) - strand_33_y * layer_1_y_by_q71
            - strand_33_z * (layer_1_z_by_q71 + t97);
        const double t103 = 0.021 * y_x_by_q73;
        const double t104 = 0.021 * y_x;
        const double strand_32_x = layer_1_x - t104;
        const double t105 = 0.021 * u_y_by_q73;
        const double t106 = 0.021 * u_y;
        const double strand_32_y = 0.021 + layer_1_y - t106;
        const double t107 = strand_32_x * (layer_1_x_by_q73 + t103) - strand_32_y
            * (layer_1_y_by_q73 + t105);
        const double t108 = 0.021 * y_z_by_q73;
        const double t109 = 0.021 * y_z;
        const double strand_32_z = layer_1_z - t109;
        const double t110 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double t111 = 1.0 / sinew_sqrt(t110);
        const double length_32_by_q73 = (t107 + strand_32_z * (layer_1_z_by_q73 + t108)) * t111;
        const double t112 = strand_32_x * (layer_1_x_by_q71 + t109) - strand_32_y * layer_1_y_by_q71
            - strand_32_z * (layer_1_z_by_q71 + t104);
        const double t113 = 0.019 * y_x_by_q73;
        const double t114 = 0.019 * y_x;
        const double strand_31_x = layer_1_x - t114;
        const double t115 = 0.019 * u_y_by_q73;
        const double t116 = 0.019 * u_y;
        const double strand_31_y = 0.019 + layer_1_y - t116;
        const double t117 = strand_31_x * (layer_1_x_by_q73 + t113) - strand_31_y
            * (layer_1_y_by_q73 + t115);
        const double t118 = 0.019 * y_z_by_q73;
        const double t119 = 0.019 * y_z;
        const double strand_31_z = layer_1_z - t119;
        const double t120 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double t121 = 1.0 / sinew_sqrt(t120);
        const double length_31_by_q73 = (t117 + strand_31_z * (layer_1_z_by_q73 + t118)) * t121;
        const double t122 = strand_31_x * (layer_1_x_by_q71 + t119) - strand_31_y * layer_1_y_by_q71
            - strand_31_z * (layer_1_z_by_q71 + t114);
        const double t123 = 0.018 * y_x;
        const double strand_30_x = layer_1_x - t123;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double t124 = strand_30_x * (layer_1_x_by_q73 + 0.018 * y_x_by_q73) - strand_30_y
            * (layer_1_y_by_q73 + 0.018 * u_y_by_q73);
        const double t125 = 0.018 * y_z;
        const double strand_30_z = layer_1_z - t125;
        const double t126 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double t127 = 1.0 / sinew_sqrt(t126);
        const double length_30_by_q73 = (t124 + strand_30_z * (layer_1_z_by_q73 + 0.018
            * y_z_by_q73)) * t127;
        const double t128 = strand_30_x * (layer_1_x_by_q71 + t125) - strand_30_y * layer_1_y_by_q71
            - strand_30_z * (layer_1_z_by_q71 + t123);
        const double t129 = 0.016 * y_x_by_q73;
        const double t130 = 0.016 * y_x;
        const double strand_29_x = layer_1_x - t130;
        const double t131 = 0.016 * u_y_by_q73;
        const double t132 = 0.016 * u_y;
        const double strand_29_y = 0.016 + layer_1_y - t132;
        const double t133 = strand_29_x * (layer_1_x_by_q73 + t129) - strand_29_y
            * (layer_1_y_by_q73 + t131);
        const double t134 = 0.016 * y_z_by_q73;
        const double t135 = 0.016 * y_z;
        const double strand_29_z = layer_1_z - t135;
        const double t136 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double t137 = 1.0 / sinew_sqrt(t136);
        const double length_29_by_q73 = (t133 + strand_29_z * (layer_1_z_by_q73 + t134)) * t137;
        const double t138 = strand_29_x * (layer_1_x_by_q71 + t135) - strand_29_y * layer_1_y_by_q71
            - strand_29_z * (layer_1_z_by_q71 + t130);
        const double t139 = 0.015 * y_x;
        const double strand_28_x = layer_1_x - t139;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double t140 = strand_28_x * (layer_1_x_by_q73 + 0.015 * y_x_by_q73) - strand_28_y
            * (layer_1_y_by_q73 + 0.015 * u_y_by_q73);
        const double t141 = 0.015 * y_z;
        const double strand_28_z = layer_1_z - t141;
        const double t142 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double t143 = 1.0 / sinew_sqrt(t142);
        const double length_28_by_q73 = (t140 + strand_28_z * (layer_1_z_by_q73 + 0.015
            * y_z_by_q73)) * t143;
        const double t144 = strand_28_x * (layer_1_x_by_q71 + t141) - strand_28_y * layer_1_y_by_q71
            - strand_28_z * (layer_1_z_by_q71 + t139);
        const double strand_27_x = layer_1_x - t37;
        const double strand_27_y = 0.013 + layer_1_y - t45;
        const double t145 = strand_27_x * (layer_1_x_by_q73 + t29) - strand_27_y * (layer_1_y_by_q73
            + t41);
        const double strand_27_z = layer_1_z - t58;
        const double t146 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double t147 = 1.0 / sinew_sqrt(t146);
        const double length_27_by_q73 = (t145 + strand_27_z * (layer_1_z_by_q73 + t50)) * t147;
        const double t148 = strand_27_x * (layer_1_x_by_q71 + t58) - strand_27_y * layer_1_y_by_q71
            - strand_27_z * (layer_1_z_by_q71 + t37);
        const double t149 = 0.011 * y_x_by_q73;
        const double t150 = 0.011 * y_x;
        const double strand_26_x = layer_1_x - t150;
        const double t151 = 0.011 * u_y_by_q73;
        const double t152 = 0.011 * u_y;
        const double strand_26_y = 0.011 + layer_1_y - t152;
        const double t153 = strand_26_x * (layer_1_x_by_q73 + t149) - strand_26_y
            * (layer_1_y_by_q73 + t151);
        const double t154 = 0.011 * y_z_by_q73;
        const double t155 = 0.011 * y_z;
        const double strand_26_z = layer_1_z - t155;
        const double t156 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double t157 = 1.0 / sinew_sqrt(t156);
        const double length_26_by_q73 = (t153 + strand_26_z * (layer_1_z_by_q73 + t154)) * t157;
        const double t158 = strand_26_x * (layer_1_x_by_q71 + t155) - strand_26_y * layer_1_y_by_q71
            - strand_26_z * (layer_1_z_by_q71 + t150);
        const double t159 = 0.01 * y_x;
        const double strand_25_x = layer_1_x - t159;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double t160 = strand_25_x * (layer_1_x_by_q73 + 0.01 * y_x_by_q73) - strand_25_y
            * (layer_1_y_by_q73 + 0.01 * u_y_by_q73);
        const double t161 = 0.01 * y_z;
        const double strand_25_z = layer_1_z - t161;
        const double t162 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double t163 = 1.0 / sinew_sqrt(t162);
        const double length_25_by_q73 = (t160 + strand_25_z * (layer_1_z_by_q73 + 0.01
            * y_z_by_q73)) * t163;
        const double t164 = strand_25_x * (layer_1_x_by_q71 + t161) - strand_25_y * layer_1_y_by_q71
            - strand_25_z * (layer_1_z_by_q71 + t159);
        const double t165 = 0.008 * y_x_by_q73;
        const double t166 = 0.008 * y_x;
        const double strand_24_x = layer_1_x - t166;
        const double t167 = 0.008 * u_y_by_q73;
        const double t168 = 0.008 * u_y;
        const double strand_24_y = 0.008 + layer_1_y - t168;
        const double t169 = strand_24_x * (layer_1_x_by_q73 + t165) - strand_24_y
            * (layer_1_y_by_q73 + t167);
        const double t170 = 0.008 * y_z_by_q73;
        const double t171 = 0.008 * y_z;
        const double strand_24_z = layer_1_z - t171;
        const double t172 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double t173 = 1.0 / sinew_sqrt(t172);
        const double length_24_by_q73 = (t169 + strand_24_z * (layer_1_z_by_q73 + t170)) * t173;
        const double t174 = strand_24_x * (layer_1_x_by_q71 + t171) - strand_24_y * layer_1_y_by_q71
            - strand_24_z * (layer_1_z_by_q71 + t166);
        const double t175 = 0.007 * y_x;
        const double strand_23_x = layer_1_x - t175;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double t176 = strand_23_x * (layer_1_x_by_q73 + 0.007 * y_x_by_q73) - strand_23_y
            * (layer_1_y_by_q73 + 0.007 * u_y_by_q73);
        const double t177 = 0.007 * y_z;
        const double strand_23_z = layer_1_z - t177;
        const double t178 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double t179 = 1.0 / sinew_sqrt(t178);
        const double length_23_by_q73 = (t176 + strand_23_z * (layer_1_z_by_q73 + 0.007
            * y_z_by_q73)) * t179;
        const double t180 = strand_23_x * (layer_1_x_by_q71 + t177) - strand_23_y * layer_1_y_by_q71
            - strand_23_z * (layer_1_z_by_q71 + t175);
        const double t181 = 0.005 * y_x_by_q73;
        const double t182 = 0.005 * y_x;
        const double strand_22_x = layer_1_x - t182;
        const double t183 = 0.005 * u_y_by_q73;
        const double t184 = 0.005 * u_y;
        const double strand_22_y = 0.005 + layer_1_y - t184;
        const double t185 = strand_22_x * (layer_1_x_by_q73 + t181) - strand_22_y
            * (layer_1_y_by_q73 + t183);
        const double t186 = 0.005 * y_z_by_q73;
        const double t187 = 0.005 * y_z;
        const double strand_22_z = layer_1_z - t187;
        const double t188 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double t189 = 1.0 / sinew_sqrt(t188);
        const double length_22_by_q73 = (t185 + strand_22_z * (layer_1_z_by_q73 + t186)) * t189;
        const double t190 = strand_22_x * (layer_1_x_by_q71 + t187) - strand_22_y * layer_1_y_by_q71
            - strand_22_z * (layer_1_z_by_q71 + t182);
        const double t191 = 0.003 * y_x_by_q73;
        const double t192 = 0.003 * y_x;
        const double strand_21_x = layer_1_x - t192;
        const double t193 = 0.003 * u_y_by_q73;
        const double t194 = 0.003 * u_y;
        const double strand_21_y = 0.003 + layer_1_y - t194;
        const double t195 = strand_21_x * (layer_1_x_by_q73 + t191) - strand_21_y
            * (layer_1_y_by_q73 + t193);
        const double t196 = 0.003 * y_z_by_q73;
        const double t197 = 0.003 * y_z;
        const double strand_21_z = layer_1_z - t197;
        const double t198 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double t199 = 1.0 / sinew_sqrt(t198);
        const double length_21_by_q73 = (t195 + strand_21_z * (layer_1_z_by_q73 + t196)) * t199;
        const double t200 = strand_21_x * (layer_1_x_by_q71 + t197) - strand_21_y * layer_1_y_by_q71
            - strand_21_z * (layer_1_z_by_q71 + t192);
        const double t201 = 0.002 * y_x;
        const double strand_20_x = layer_1_x - t201;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double t202 = strand_20_x * (layer_1_x_by_q73 + 0.002 * y_x_by_q73) - strand_20_y
            * (layer_1_y_by_q73 + 0.002 * u_y_by_q73);
        const double t203 = 0.002 * y_z;
        const double strand_20_z = layer_1_z - t203;
        const double t204 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double t205 = 1.0 / sinew_sqrt(t204);
        const double length_20_by_q73 = (t202 + strand_20_z * (layer_1_z_by_q73 + 0.002
            * y_z_by_q73)) * t205;
        const double t206 = strand_20_x * (layer_1_x_by_q71 + t203) - strand_20_y * layer_1_y_by_q71
            - strand_20_z * (layer_1_z_by_q71 + t201);
        const double t207 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
            * layer_1_z_by_q73;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double t208 = 1.0 / length_19;
        const double t209 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
            * layer_1_z_by_q71;
        const double layer_0_x_by_q73 = t27 + t28 - t149;
        const double layer_0_x = t35 - t36 + t150;
        const double strand_18_x = layer_0_x - t38;
        const double layer_0_y_by_q73 = t39 + t40 - t151;
        const double layer_0_y = 0.007 - origin_y - t43 + t44 + t152;
        const double strand_18_y = 0.028 + layer_0_y - t46;
        const double t210 = strand_18_x * (layer_0_x_by_q73 + t30) - strand_18_y * (layer_0_y_by_q73
            + t42);
        const double layer_0_z_by_q73 = t48 + t49 - t154;
        const double layer_0_z = 0.008 - origin_z - t56 - t57 + t155;
        const double strand_18_z = layer_0_z - t59;
        const double t211 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double t212 = 1.0 / sinew_sqrt(t211);
        const double length_18_by_q73 = (t210 + strand_18_z * (layer_0_z_by_q73 + t51)) * t212;
        const double layer_0_x_by_q71 = t64 + t65 - t155;
        const double layer_0_y_by_q71 = t66 - t67;
        const double layer_0_z_by_q71 = t68 + t69 - t150;
        const double t213 = strand_18_x * (layer_0_x_by_q71 + t59) - strand_18_y * layer_0_y_by_q71
            - strand_18_z * (layer_0_z_by_q71 + t38);
        const double strand_17_x = layer_0_x - t72;
        const double strand_17_y = 0.027 + layer_0_y - t74;
        const double t214 = strand_17_x * (layer_0_x_by_q73 + t71) - strand_17_y * (layer_0_y_by_q73
            + t73);
        const double strand_17_z = layer_0_z - t77;
        const double t215 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double t216 = 1.0 / sinew_sqrt(t215);
        const double length_17_by_q73 = (t214 + strand_17_z * (layer_0_z_by_q73 + t76)) * t216;
        const double t217 = strand_17_x * (layer_0_x_by_q71 + t77) - strand_17_y * layer_0_y_by_q71
            - strand_17_z * (layer_0_z_by_q71 + t72);
        const double t218 = 0.025 * y_x;
        const double strand_16_x = layer_0_x - t218;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double t219 = strand_16_x * (layer_0_x_by_q73 + 0.025 * y_x_by_q73) - strand_16_y
            * (layer_0_y_by_q73 + 0.025 * u_y_by_q73);
        const double t220 = 0.025 * y_z;
        const double strand_16_z = layer_0_z - t220;
        const double t221 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double t222 = 1.0 / sinew_sqrt(t221);
        const double length_16_by_q73 = (t219 + strand_16_z * (layer_0_z_by_q73 + 0.025
            * y_z_by_q73)) * t222;
        const double t223 = strand_16_x * (layer_0_x_by_q71 + t220) - strand_16_y * layer_0_y_by_q71
            - strand_16_z * (layer_0_z_by_q71 + t218);
        const double strand_15_x = layer_0_x - t88;
        const double strand_15_y = 0.024 + layer_0_y - t90;
        const double t224 = strand_15_x * (layer_0_x_by_q73 + t87) - strand_15_y * (layer_0_y_by_q73
            + t89);
        const double strand_15_z = layer_0_z - t93;
        const double t225 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double t226 = 1.0 / sinew_sqrt(t225);
        const double length_15_by_q73 = (t224 + strand_15_z * (layer_0_z_by_q73 + t92)) * t226;
        const double t227 = strand_15_x * (layer_0_x_by_q71 + t93) - strand_15_y * layer_0_y_by_q71
            - strand_15_z * (layer_0_z_by_q71 + t88);
        const double t228 = 0.022 * y_x;
        const double strand_14_x = layer_0_x - t228;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double t229 = strand_14_x * (layer_0_x_by_q73 + 0.022 * y_x_by_q73) - strand_14_y
            * (layer_0_y_by_q73 + 0.022 * u_y_by_q73);
        const double t230 = 0.022 * y_z;
        const double strand_14_z = layer_0_z - t230;
        const double t231 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double t232 = 1.0 / sinew_sqrt(t231);
        const double length_14_by_q73 = (t229 + strand_14_z * (layer_0_z_by_q73 + 0.022
            * y_z_by_q73)) * t232;
        const double t233 = strand_14_x * (layer_0_x_by_q71 + t230) - strand_14_y * layer_0_y_by_q71
            - strand_14_z * (layer_0_z_by_q71 + t228);
        const double strand_13_x = layer_0_x - t104;
        const double strand_13_y = 0.02 + layer_0_y - t106;
        const double t234 = strand_13_x * (layer_0_x_by_q73 + t103) - strand_13_y
            * (layer_0_y_by_q73 + t105);
        const double strand_13_z = layer_0_z - t109;
        const double t235 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double t236 = 1.0 / sinew_sqrt(t235);
        const double length_13_by_q73 = (t234 + strand_13_z * (layer_0_z_by_q73 + t108)) * t236;
        const double t237 = strand_13_x * (layer_0_x_by_q71 + t109) - strand_13_y * layer_0_y_by_q71
            - strand_13_z * (layer_0_z_by_q71 + t104);
        const double strand_12_x = layer_0_x - t114;
        const double strand_12_y = 0.019 + layer_0_y - t116;
        const double t238 = strand_12_x * (layer_0_x_by_q73 + t113) - strand_12_y
            * (layer_0_y_by_q73 + t115);
        const double strand_12_z = layer_0_z - t119;
        const double t239 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double t240 = 1.0 / sinew_sqrt(t239);
        const double length_12_by_q73 = (t238 + strand_12_z * (layer_0_z_by_q73 + t118)) * t240;
        const double t241 = strand_12_x * (layer_0_x_by_q71 + t119) - strand_12_y * layer_0_y_by_q71
            - strand_12_z * (layer_0_z_by_q71 + t114);
        const double t242 = 0.017 * y_x;
        const double strand_11_x = layer_0_x - t242;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double t243 = strand_11_x * (layer_0_x_by_q73 + 0.017 * y_x_by_q73) - strand_11_y
            * (layer_0_y_by_q73 + 0.017 * u_y_by_q73);
        const double t244 = 0.017 * y_z;
        const double strand_11_z = layer_0_z - t244;
        const double t245 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double t246 = 1.0 / sinew_sqrt(t245);
        const double length_11_by_q73 = (t243 + strand_11_z * (layer_0_z_by_q73 + 0.017
            * y_z_by_q73)) * t246;
        const double t247 = strand_11_x * (layer_0_x_by_q71 + t244) - strand_11_y * layer_0_y_by_q71
            - strand_11_z * (layer_0_z_by_q71 + t242);
        const double strand_10_x = layer_0_x - t130;
        const double strand_10_y = 0.016 + layer_0_y - t132;
        const double t248 = strand_10_x * (layer_0_x_by_q73 + t129) - strand_10_y
            * (layer_0_y_by_q73 + t131);
        const double strand_10_z = layer_0_z - t135;
        const double t249 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double t250 = 1.0 / sinew_sqrt(t249);
        const double length_10_by_q73 = (t248 + strand_10_z * (layer_0_z_by_q73 + t134)) * t250;
        const double t251 = strand_10_x * (layer_0_x_by_q71 + t135) - strand_10_y * layer_0_y_by_q71
            - strand_10_z * (layer_0_z_by_q71 + t130);
        const double t252 = 0.014 * y_x;
        const double strand_9_x = layer_0_x - t252;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double t253 = strand_9_x * (layer_0_x_by_q73 + 0.014 * y_x_by_q73) - strand_9_y
            * (layer_0_y_by_q73 + 0.014 * u_y_by_q73);
        const double t254 = 0.014 * y_z;
        const double strand_9_z = layer_0_z - t254;
        const double t255 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double t256 = 1.0 / sinew_sqrt(t255);
        const double length_9_by_q73 = (t253 + strand_9_z * (layer_0_z_by_q73 + 0.014 * y_z_by_q73))
            * t256;
        const double t257 = strand_9_x * (layer_0_x_by_q71 + t254) - strand_9_y * layer_0_y_by_q71
            - strand_9_z * (layer_0_z_by_q71 + t252);
        const double strand_8_x = layer_0_x - t37;
        const double strand_8_y = 0.012 + layer_0_y - t45;
        const double t258 = strand_8_x * (layer_0_x_by_q73 + t29) - strand_8_y * (layer_0_y_by_q73
            + t41);
        const double strand_8_z = layer_0_z - t58;
        const double t259 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double t260 = 1.0 / sinew_sqrt(t259);
        const double length_8_by_q73 = (t258 + strand_8_z * (layer_0_z_by_q73 + t50)) * t260;
        const double t261 = strand_8_x * (layer_0_x_by_q71 + t58) - strand_8_y * layer_0_y_by_q71
            - strand_8_z * (layer_0_z_by_q71 + t37);
        const double strand_7_x = layer_0_x - t150;
        const double strand_7_y = 0.011 + layer_0_y - t152;
        const double t262 = strand_7_x * (layer_0_x_by_q73 + t149) - strand_7_y * (layer_0_y_by_q73
            + t151);
        const double strand_7_z = layer_0_z - t155;
        const double t263 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double t264 = 1.0 / sinew_sqrt(t263);
        const double length_7_by_q73 = (t262 + strand_7_z * (layer_0_z_by_q73 + t154)) * t264;
        const double t265 = strand_7_x * (layer_0_x_by_q71 + t155) - strand_7_y * layer_0_y_by_q71
            - strand_7_z * (layer_0_z_by_q71 + t150);
        const double t266 = 0.009 * y_x;
        const double strand_6_x = layer_0_x - t266;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double t267 = strand_6_x * (layer_0_x_by_q73 + 0.009 * y_x_by_q73) - strand_6_y
            * (layer_0_y_by_q73 + 0.009 * u_y_by_q73);
        const double t268 = 0.009 * y_z;
        const double strand_6_z = layer_0_z - t268;
        const double t269 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double t270 = 1.0 / sinew_sqrt(t269);
        const double length_6_by_q73 = (t267 + strand_6_z * (layer_0_z_by_q73 + 0.009 * y_z_by_q73))
            * t270;
        const double t271 = strand_6_x * (layer_0_x_by_q71 + t268) - strand_6_y * layer_0_y_by_q71
            - strand_6_z * (layer_0_z_by_q71 + t266);
        const double strand_5_x = layer_0_x - t166;
        const double strand_5_y = 0.008 + layer_0_y - t168;
        const double t272 = strand_5_x * (layer_0_x_by_q73 + t165) - strand_5_y * (layer_0_y_by_q73
            + t167);
        const double strand_5_z = layer_0_z - t171;
        const double t273 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double t274 = 1.0 / sinew_sqrt(t273);
        const double length_5_by_q73 = (t272 + strand_5_z * (layer_0_z_by_q73 + t170)) * t274;
        const double t275 = strand_5_x * (layer_0_x_by_q71 + t171) - strand_5_y * layer_0_y_by_q71
            - strand_5_z * (layer_0_z_by_q71 + t166);
        const double t276 = 0.006 * y_x;
        const double strand_4_x = layer_0_x - t276;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double t277 = strand_4_x * (layer_0_x_by_q73 + 0.006 * y_x_by_q73) - strand_4_y
            * (layer_0_y_by_q73 + 0.006 * u_y_by_q73);
        const double t278 = 0.006 * y_z;
        const double strand_4_z = layer_0_z - t278;
        const double t279 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double t280 = 1.0 / sinew_sqrt(t279);
        const double length_4_by_q73 = (t277 + strand_4_z * (layer_0_z_by_q73 + 0.006 * y_z_by_q73))
            * t280;
        const double t281 = strand_4_x * (layer_0_x_by_q71 + t278) - strand_4_y * layer_0_y_by_q71
            - strand_4_z * (layer_0_z_by_q71 + t276);
        const double strand_3_x = layer_0_x - t182;
        const double strand_3_y = 0.004 + layer_0_y - t184;
        const double t282 = strand_3_x * (layer_0_x_by_q73 + t181) - strand_3_y * (layer_0_y_by_q73
            + t183);
        const double strand_3_z = layer_0_z - t187;
        const double t283 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double t284 = 1.0 / sinew_sqrt(t283);
        const double length_3_by_q73 = (t282 + strand_3_z * (layer_0_z_by_q73 + t186)) * t284;
        const double t285 = strand_3_x * (layer_0_x_by_q71 + t187) - strand_3_y * layer_0_y_by_q71
            - strand_3_z * (layer_0_z_by_q71 + t182);
        const double R21y = c1 * s2;
        const double t286 = 0.005 * R21y;
        const double t287 = 0.006 * s1;
        const double t288 = t286 - t287;
        const double R21x = c1 * c2;
        const double t289 = 0.047 * R21x;
        const double pD_length_tox = t288 - t289;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double t290 = 0.025 - 0.005 * c2;
        const double t291 = 0.047 * s2;
        const double B_lengthdz = t290 - t291;
        const double t292 = B_lengthdz * B_lengthdz;
        const double R22y = s1 * s2;
        const double t293 = 0.005 * R22y;
        const double t294 = 0.006 * c1;
        const double t295 = t293 + t294;
        const double R22x = s1 * c2;
        const double t296 = 0.047 * R22x;
        const double pD_length_toy = t295 - t296;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_length = sinew_sqrt(t292 + D_lengthdx * D_lengthdx + D_lengthdy
            * D_lengthdy);
        const double t297 = 1.0 / D_length;
        const double t298 = 0.005 * R21x;
        const double t299 = 0.047 * R21y;
        const double pB_length_tox_by_q_1 = t298 + t299;
        const double t300 = 0.005 * s2;
        const double t301 = 0.047 * c2;
        const double t302 = B_lengthdz * (t300 - t301);
        const double t303 = 0.005 * R22x;
        const double t304 = 0.047 * R22y;
        const double pB_length_toy_by_q_1 = t303 + t304;
        const double t305 = t302 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy
            * pB_length_toy_by_q_1;
        const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx)
            * t297;
        const double strand_2_x = layer_0_x - t192;
        const double strand_2_y = 0.003 + layer_0_y - t194;
        const double t306 = strand_2_x * (layer_0_x_by_q73 + t191) - strand_2_y * (layer_0_y_by_q73
            + t193);
        const double strand_2_z = layer_0_z - t197;
        const double t307 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double t308 = 1.0 / sinew_sqrt(t307);
        const double length_2_by_q73 = (t306 + strand_2_z * (layer_0_z_by_q73 + t196)) * t308;
        const double t309 = strand_2_x * (layer_0_x_by_q71 + t197) - strand_2_y * layer_0_y_by_q71
            - strand_2_z * (layer_0_z_by_q71 + t192);
        const double t310 = t286 + t287;
        const double pC_length_tox = t310 + t289;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double A_lengthdz = t290 + t291;
        const double t311 = A_lengthdz * A_lengthdz;
        const double t312 = t293 - t294;
        const double pC_length_toy = t312 + t296;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_length = sinew_sqrt(t311 + C_lengthdx * C_lengthdx + C_lengthdy
            * C_lengthdy);
        const double t313 = 1.0 / C_length;
        const double pA_length_tox_by_q_1 = t298 - t299;
        const double t314 = A_lengthdz * (t300 + t301);
        const double pA_length_toy_by_q_1 = t303 - t304;
        const double t315 = t314 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy
            * pA_length_toy_by_q_1;
        const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx)
            * t313;
        const double t316 = 0.001 * y_x;
        const double strand_1_x = layer_0_x - t316;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double t317 = strand_1_x * (layer_0_x_by_q73 + 0.001 * y_x_by_q73) - strand_1_y
            * (layer_0_y_by_q73 + 0.001 * u_y_by_q73);
        const double t318 = 0.001 * y_z;
        const double strand_1_z = layer_0_z - t318;
        const double t319 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double t320 = 1.0 / sinew_sqrt(t319);
        const double length_1_by_q73 = (t317 + strand_1_z * (layer_0_z_by_q73 + 0.001 * y_z_by_q73))
            * t320;
        const double t321 = strand_1_x * (layer_0_x_by_q71 + t318) - strand_1_y * layer_0_y_by_q71
            - strand_1_z * (layer_0_z_by_q71 + t316);
        const double pB_length_tox = t310 - t289;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double pB_length_toy = t312 - t296;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy
            + t292);
        const double t322 = 1.0 / B_length;
        const double t323 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1
            + t302;
        const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx)
            * t322;
        const double t324 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
            * layer_0_z_by_q73;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double t325 = 1.0 / length_0;
        const double t326 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
            * layer_0_z_by_q71;
        const double pA_length_tox = t288 + t289;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double pA_length_toy = t295 + t296;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy
            + t311);
        const double t327 = 1.0 / A_length;
        const double t328 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1
            - t314;
        const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx)
            * t327;
        P[state] = -A_length_by_q_0;
        P[1 * n + state] = -(t328 * t327);
        P[2 * n + state] = 0.0;
        P[3 * n + state] = 0.0;
        P[4 * n + state] = 0.0;
        P[5 * n + state] = 0.0;
        P[6 * n + state] = 0.0;
        P[7 * n + state] = 0.0;
        P[8 * n + state] = 0.0;
        P[9 * n + state] = 0.0;
        P[10 * n + state] = 0.0;
        P[11 * n + state] = 0.0;
        P[12 * n + state] = 0.0;
        P[13 * n + state] = 0.0;
        P[14 * n + state] = 0.0;
        P[15 * n + state] = 0.0;
        P[16 * n + state] = 0.0;
        P[17 * n + state] = 0.0;
        P[18 * n + state] = 0.0;
        P[19 * n + state] = t326 * t325;
        P[20 * n + state] = -(t324 * t325);
        P[21 * n + state] = B_length_by_q_0;
        P[22 * n + state] = t323 * t322;
        P[23 * n + state] = 0.0;
        P[24 * n + state] = 0.0;
        P[25 * n + state] = 0.0;
        P[26 * n + state] = 0.0;
        P[27 * n + state] = 0.0;
        P[28 * n + state] = 0.0;
        P[29 * n + state] = 0.0;
        P[30 * n + state] = 0.0;
        P[31 * n + state] = 0.0;
        P[32 * n + state] = 0.0;
        P[33 * n + state] = 0.0;
        P[34 * n + state] = 0.0;
        P[35 * n + state] = 0.0;
        P[36 * n + state] = 0.0;
        P[37 * n + state] = 0.0;
        P[38 * n + state] = 0.0;
        P[39 * n + state] = 0.0;
        P[40 * n + state] = t321 * t320;
        P[41 * n + state] = -length_1_by_q73;
        P[42 * n + state] = C_length_by_q_0;
        P[43 * n + state] = t315 * t313;
        P[44 * n + state] = 0.0;
        P[45 * n + state] = 0.0;
        P[46 * n + state] = 0.0;
        P[47 * n + state] = 0.0;
        P[48 * n + state] = 0.0;
        P[49 * n + state] = 0.0;
        P[50 * n + state] = 0.0;
        P[51 * n + state] = 0.0;
        P[52 * n + state] = 0.0;
        P[53 * n + state] = 0.0;
        P[54 * n + state] = 0.0;
        P[55 * n + state] = 0.0;
        P[56 * n + state] = 0.0;
        P[57 * n + state] = 0.0;
        P[58 * n + state] = 0.0;
        P[59 * n + state] = 0.0;
        P[60 * n + state] = 0.0;
        P[61 * n + state] = t309 * t308;
        P[62 * n + state] = -length_2_by_q73;
        P[63 * n + state] = -D_length_by_q_0;
        P[64 * n + state] = t305 * t297;
        P[65 * n + state] = 0.0;
        P[66 * n + state] = 0.0;
        P[67 * n + state] = 0.0;
        P[68 * n + state] = 0.0;
        P[69 * n + state] = 0.0;
        P[70 * n + state] = 0.0;
        P[71 * n + state] = 0.0;
        P[72 * n + state] = 0.0;
        P[73 * n + state] = 0.0;
        P[74 * n + state] = 0.0;
        P[75 * n + state] = 0.0;
        P[76 * n + state] = 0.0;
        P[77 * n + state] = 0.0;
        P[78 * n + state] = 0.0;
        P[79 * n + state] = 0.0;
        P[80 * n + state] = 0.0;
        P[81 * n + state] = 0.0;
        P[82 * n + state] = t285 * t284;
        P[83 * n + state] = -length_3_by_q73;
        P[84 * n + state] = 0.0;
        P[85 * n + state] = 0.0;
        P[86 * n + state] = 0.0065;
        P[87 * n + state] = 0.0;
        P[88 * n + state] = 0.0;
        P[89 * n + state] = 0.0;
        P[90 * n + state] = 0.0;
        P[91 * n + state] = 0.0;
        P[92 * n + state] = 0.0;
        P[93 * n + state] = 0.0;
        P[94 * n + state] = 0.0;
        P[95 * n + state] = 0.0;
        P[96 * n + state] = 0.0;
        P[97 * n + state] = 0.0;
        P[98 * n + state] = 0.0;
        P[99 * n + state] = 0.0;
        P[100 * n + state] = 0.0;
        P[101 * n + state] = 0.0;
        P[102 * n + state] = 0.0;
        P[103 * n + state] = t281 * t280;
        P[104 * n + state] = -length_4_by_q73;
        P[105 * n + state] = 0.0;
        P[106 * n + state] = 0.0;
        P[107 * n + state] = -0.0065;
        P[108 * n + state] = 0.0;
        P[109 * n + state] = 0.0;
        P[110 * n + state] = 0.0;
        P[111 * n + state] = 0.0;
        P[112 * n + state] = 0.0;
        P[113 * n + state] = 0.0;
        P[114 * n + state] = 0.0;
        P[115 * n + state] = 0.0;
        P[116 * n + state] = 0.0;
        P[117 * n + state] = 0.0;
        P[118 * n + state] = 0.0;
        P[119 * n + state] = 0.0;
        P[120 * n + state] = 0.0;
        P[121 * n + state] = 0.0;
        P[122 * n + state] = 0.0;
        P[123 * n + state] = 0.0;
        P[124 * n + state] = t275 * t274;
        P[125 * n + state] = -length_5_by_q73;
        P[126 * n + state] = 0.0;
        P[127 * n + state] = 0.0;
        P[128 * n + state] = -0.0065;
        P[129 * n + state] = 0.0055;
        P[130 * n + state] = 0.0;
        P[131 * n + state] = 0.0;
        P[132 * n + state] = 0.0;
        P[133 * n + state] = 0.0;
        P[134 * n + state] = 0.0;
        P[135 * n + state] = 0.0;
        P[136 * n + state] = 0.0;
        P[137 * n + state] = 0.0;
        P[138 * n + state] = 0.0;
        P[139 * n + state] = 0.0;
        P[140 * n + state] = 0.0;
        P[141 * n + state] = 0.0;
        P[142 * n + state] = 0.0;
        P[143 * n + state] = 0.0;
        P[144 * n + state] = 0.0;
        P[145 * n + state] = t271 * t270;
        P[146 * n + state] = -length_6_by_q73;
        P[147 * n + state] = 0.0;
        P[148 * n + state] = 0.0;
        P[149 * n + state] = 0.0065;
        P[150 * n + state] = -0.0055;
        P[151 * n + state] = 0.0;
        P[152 * n + state] = 0.0;
        P[153 * n + state] = 0.0;
        P[154 * n + state] = 0.0;
        P[155 * n + state] = 0.0;
        P[156 * n + state] = 0.0;
        P[157 * n + state] = 0.0;
        P[158 * n + state] = 0.0;
        P[159 * n + state] = 0.0;
        P[160 * n + state] = 0.0;
        P[161 * n + state] = 0.0;
        P[162 * n + state] = 0.0;
        P[163 * n + state] = 0.0;
        P[164 * n + state] = 0.0;
        P[165 * n + state] = 0.0;
        P[166 * n + state] = t265 * t264;
        P[167 * n + state] = -length_7_by_q73;
        P[168 * n + state] = 0.0;
        P[169 * n + state] = 0.0;
        P[170 * n + state] = 0.0;
        P[171 * n + state] = 0.0;
        P[172 * n + state] = 0.0065;
        P[173 * n + state] = 0.0065;
        P[174 * n + state] = 0.0;
        P[175 * n + state] = 0.0;
        P[176 * n + state] = 0.0;
        P[177 * n + state] = 0.0;
        P[178 * n + state] = 0.0;
        P[179 * n + state] = 0.0;
        P[180 * n + state] = 0.0;
        P[181 * n + state] = 0.0;
        P[182 * n + state] = 0.0;
        P[183 * n + state] = 0.0;
        P[184 * n + state] = 0.0;
        P[185 * n + state] = 0.0;
        P[186 * n + state] = 0.0;
        P[187 * n + state] = t261 * t260;
        P[188 * n + state] = -length_8_by_q73;
        P[189 * n + state] = 0.0;
        P[190 * n + state] = 0.0;
        P[191 * n + state] = 0.0;
        P[192 * n + state] = 0.0;
        P[193 * n + state] = 0.0065;
        P[194 * n + state] = -0.0065;
        P[195 * n + state] = 0.0;
        P[196 * n + state] = 0.0;
        P[197 * n + state] = 0.0;
        P[198 * n + state] = 0.0;
        P[199 * n + state] = 0.0;
        P[200 * n + state] = 0.0;
        P[201 * n + state] = 0.0;
        P[202 * n + state] = 0.0;
        P[203 * n + state] = 0.0;
        P[204 * n + state] = 0.0;
        P[205 * n + state] = 0.0;
        P[206 * n + state] = 0.0;
        P[207 * n + state] = 0.0;
        P[208 * n + state] = t257 * t256;
        P[209 * n + state] = -length_9_by_q73;
        P[210 * n + state] = 0.0;
        P[211 * n + state] = 0.0;
        P[212 * n + state] = 0.0;
        P[213 * n + state] = 0.0;
        P[214 * n + state] = -0.0065;
        P[215 * n + state] = 0.0065;
        P[216 * n + state] = 0.0;
        P[217 * n + state] = 0.0;
        P[218 * n + state] = 0.0;
        P[219 * n + state] = 0.0;
        P[220 * n + state] = 0.0;
        P[221 * n + state] = 0.0;
        P[222 * n + state] = 0.0;
        P[223 * n + state] = 0.0;
        P[224 * n + state] = 0.0;
        P[225 * n + state] = 0.0;
        P[226 * n + state] = 0.0;
        P[227 * n + state] = 0.0;
        P[228 * n + state] = 0.0;
        P[229 * n + state] = t251 * t250;
        P[230 * n + state] = -length_10_by_q73;
        P[231 * n + state] = 0.0;
        P[232 * n + state] = 0.0;
        P[233 * n + state] = 0.0;
        P[234 * n + state] = 0.0;
        P[235 * n + state] = -0.0065;
        P[236 * n + state] = -0.0065;
        P[237 * n + state] = 0.0;
        P[238 * n + state] = 0.0;
        P[239 * n + state] = 0.0;
        P[240 * n + state] = 0.0;
        P[241 * n + state] = 0.0;
        P[242 * n + state] = 0.0;
        P[243 * n + state] = 0.0;
        P[244 * n + state] = 0.0;
        P[245 * n + state] = 0.0;
        P[246 * n + state] = 0.0;
        P[247 * n + state] = 0.0;
        P[248 * n + state] = 0.0;
        P[249 * n + state] = 0.0;
        P[250 * n + state] = t247 * t246;
        P[251 * n + state] = -length_11_by_q73;
        P[252 * n + state] = 0.0;
        P[253 * n + state] = 0.0;
        P[254 * n + state] = 0.0;
        P[255 * n + state] = 0.0;
        P[256 * n + state] = 0.0;
        P[257 * n + state] = 0.0;
        P[258 * n + state] = 0.0055;
        P[259 * n + state] = 0.0;
        P[260 * n + state] = 0.0;
        P[261 * n + state] = 0.0;
        P[262 * n + state] = 0.0;
        P[263 * n + state] = 0.0;
        P[264 * n + state] = 0.0;
        P[265 * n + state] = 0.0;
        P[266 * n + state] = 0.0;
        P[267 * n + state] = 0.0;
        P[268 * n + state] = 0.0;
        P[269 * n + state] = 0.0;
        P[270 * n + state] = 0.0;
        P[271 * n + state] = t241 * t240;
        P[272 * n + state] = -length_12_by_q73;
        P[273 * n + state] = 0.0;
        P[274 * n + state] = 0.0;
        P[275 * n + state] = 0.0;
        P[276 * n + state] = 0.0;
        P[277 * n + state] = 0.0;
        P[278 * n + state] = 0.0;
        P[279 * n + state] = -0.0055;
        P[280 * n + state] = 0.0;
        P[281 * n + state] = 0.0;
        P[282 * n + state] = 0.0;
        P[283 * n + state] = 0.0;
        P[284 * n + state] = 0.0;
        P[285 * n + state] = 0.0;
        P[286 * n + state] = 0.0;
        P[287 * n + state] = 0.0;
        P[288 * n + state] = 0.0;
        P[289 * n + state] = 0.0;
        P[290 * n + state] = 0.0;
        P[291 * n + state] = 0.0;
        P[292 * n + state] = t237 * t236;
        P[293 * n + state] = -length_13_by_q73;
        P[294 * n + state] = 0.0;
        P[295 * n + state] = 0.0;
        P[296 * n + state] = 0.0;
        P[297 * n + state] = 0.0;
        P[298 * n + state] = 0.0;
        P[299 * n + state] = 0.0;
        P[300 * n + state] = 0.0055;
        P[301 * n + state] = -0.0045;
        P[302 * n + state] = 0.0;
        P[303 * n + state] = 0.0;
        P[304 * n + state] = 0.0;
        P[305 * n + state] = 0.0;
        P[306 * n + state] = 0.0;
        P[307 * n + state] = 0.0;
        P[308 * n + state] = 0.0;
        P[309 * n + state] = 0.0;
        P[310 * n + state] = 0.0;
        P[311 * n + state] = 0.0;
        P[312 * n + state] = 0.0;
        P[313 * n + state] = t233 * t232;
        P[314 * n + state] = -length_14_by_q73;
        P[315 * n + state] = 0.0;
        P[316 * n + state] = 0.0;
        P[317 * n + state] = 0.0;
        P[318 * n + state] = 0.0;
        P[319 * n + state] = 0.0;
        P[320 * n + state] = 0.0;
        P[321 * n + state] = -0.0055;
        P[322 * n + state] = 0.0045;
        P[323 * n + state] = 0.0;
        P[324 * n + state] = 0.0;
        P[325 * n + state] = 0.0;
        P[326 * n + state] = 0.0;
        P[327 * n + state] = 0.0;
        P[328 * n + state] = 0.0;
        P[329 * n + state] = 0.0;
        P[330 * n + state] = 0.0;
        P[331 * n + state] = 0.0;
        P[332 * n + state] = 0.0;
        P[333 * n + state] = 0.0;
        P[334 * n + state] = t227 * t226;
        P[335 * n + state] = -length_15_by_q73;
        P[336 * n + state] = 0.0;
        P[337 * n + state] = 0.0;
        P[338 * n + state] = 0.0;
        P[339 * n + state] = 0.0;
        P[340 * n + state] = 0.0;
        P[341 * n + state] = 0.0;
        P[342 * n + state] = 0.0;
        P[343 * n + state] = 0.0;
        P[344 * n + state] = 0.0065;
        P[345 * n + state] = 0.0065;
        P[346 * n + state] = 0.0;
        P[347 * n + state] = 0.0;
        P[348 * n + state] = 0.0;
        P[349 * n + state] = 0.0;
        P[350 * n + state] = 0.0;
        P[351 * n + state] = 0.0;
        P[352 * n + state] = 0.0;
        P[353 * n + state] = 0.0;
        P[354 * n + state] = 0.0;
        P[355 * n + state] = t223 * t222;
        P[356 * n + state] = -length_16_by_q73;
        P[357 * n + state] = 0.0;
        P[358 * n + state] = 0.0;
        P[359 * n + state] = 0.0;
        P[360 * n + state] = 0.0;
        P[361 * n + state] = 0.0;
        P[362 * n + state] = 0.0;
        P[363 * n + state] = 0.0;
        P[364 * n + state] = 0.0;
        P[365 * n + state] = 0.0065;
        P[366 * n + state] = -0.0065;
        P[367 * n + state] = 0.0;
        P[368 * n + state] = 0.0;
        P[369 * n + state] = 0.0;
        P[370 * n + state] = 0.0;
        P[371 * n + state] = 0.0;
        P[372 * n + state] = 0.0;
        P[373 * n + state] = 0.0;
        P[374 * n + state] = 0.0;
        P[375 * n + state] = 0.0;
        P[376 * n + state] = t217 * t216;
        P[377 * n + state] = -length_17_by_q73;
        P[378 * n + state] = 0.0;
        P[379 * n + state] = 0.0;
        P[380 * n + state] = 0.0;
        P[381 * n + state] = 0.0;
        P[382 * n + state] = 0.0;
        P[383 * n + state] = 0.0;
        P[384 * n + state] = 0.0;
        P[385 * n + state] = 0.0;
        P[386 * n + state] = -0.0065;
        P[387 * n + state] = 0.0065;
        P[388 * n + state] = 0.0;
        P[389 * n + state] = 0.0;
        P[390 * n + state] = 0.0;
        P[391 * n + state] = 0.0;
        P[392 * n + state] = 0.0;
        P[393 * n + state] = 0.0;
        P[394 * n + state] = 0.0;
        P[395 * n + state] = 0.0;
        P[396 * n + state] = 0.0;
        P[397 * n + state] = t213 * t212;
        P[398 * n + state] = -length_18_by_q73;
        P[399 * n + state] = 0.0;
        P[400 * n + state] = 0.0;
        P[401 * n + state] = 0.0;
        P[402 * n + state] = 0.0;
        P[403 * n + state] = 0.0;
        P[404 * n + state] = 0.0;
        P[405 * n + state] = 0.0;
        P[406 * n + state] = 0.0;
        P[407 * n + state] = -0.0065;
        P[408 * n + state] = -0.0065;
        P[409 * n + state] = 0.0;
        P[410 * n + state] = 0.0;
        P[411 * n + state] = 0.0;
        P[412 * n + state] = 0.0;
        P[413 * n + state] = 0.0;
        P[414 * n + state] = 0.0;
        P[415 * n + state] = 0.0;
        P[416 * n + state] = 0.0;
        P[417 * n + state] = 0.0;
        P[418 * n + state] = t209 * t208;
        P[419 * n + state] = -(t207 * t208);
        P[420 * n + state] = 0.0;
        P[421 * n + state] = 0.0;
        P[422 * n + state] = 0.0;
        P[423 * n + state] = 0.0;
        P[424 * n + state] = 0.0;
        P[425 * n + state] = 0.0;
        P[426 * n + state] = 0.0;
        P[427 * n + state] = 0.0;
        P[428 * n + state] = 0.0;
        P[429 * n + state] = 0.0;
        P[430 * n + state] = 0.0055;
        P[431 * n + state] = 0.0;
        P[432 * n + state] = 0.0;
        P[433 * n + state] = 0.0;
        P[434 * n + state] = 0.0;
        P[435 * n + state] = 0.0;
        P[436 * n + state] = 0.0;
        P[437 * n + state] = 0.0;
        P[438 * n + state] = 0.0;
        P[439 * n + state] = t206 * t205;
        P[440 * n + state] = -length_20_by_q73;
        P[441 * n + state] = 0.0;
        P[442 * n + state] = 0.0;
        P[443 * n + state] = 0.0;
        P[444 * n + state] = 0.0;
        P[445 * n + state] = 0.0;
        P[446 * n + state] = 0.0;
        P[447 * n + state] = 0.0;
        P[448 * n + state] = 0.0;
        P[449 * n + state] = 0.0;
        P[450 * n + state] = 0.0;
        P[451 * n + state] = -0.0055;
        P[452 * n + state] = 0.0;
        P[453 * n + state] = 0.0;
        P[454 * n + state] = 0.0;
        P[455 * n + state] = 0.0;
        P[456 * n + state] = 0.0;
        P[457 * n + state] = 0.0;
        P[458 * n + state] = 0.0;
        P[459 * n + state] = 0.0;
        P[460 * n + state] = t200 * t199;
        P[461 * n + state] = -length_21_by_q73;
        P[462 * n + state] = 0.0;
        P[463 * n + state] = 0.0;
        P[464 * n + state] = 0.0;
        P[465 * n + state] = 0.0;
        P[466 * n + state] = 0.0;
        P[467 * n + state] = 0.0;
        P[468 * n + state] = 0.0;
        P[469 * n + state] = 0.0;
        P[470 * n + state] = 0.0;
        P[471 * n + state] = 0.0;
        P[472 * n + state] = 0.0055;
        P[473 * n + state] = -0.0045;
        P[474 * n + state] = 0.0;
        P[475 * n + state] = 0.0;
        P[476 * n + state] = 0.0;
        P[477 * n + state] = 0.0;
        P[478 * n + state] = 0.0;
        P[479 * n + state] = 0.0;
        P[480 * n + state] = 0.0;
        P[481 * n + state] = t190 * t189;
        P[482 * n + state] = -length_22_by_q73;
        P[483 * n + state] = 0.0;
        P[484 * n + state] = 0.0;
        P[485 * n + state] = 0.0;
        P[486 * n + state] = 0.0;
        P[487 * n + state] = 0.0;
        P[488 * n + state] = 0.0;
        P[489 * n + state] = 0.0;
        P[490 * n + state] = 0.0;
        P[491 * n + state] = 0.0;
        P[492 * n + state] = 0.0;
        P[493 * n + state] = -0.0055;
        P[494 * n + state] = 0.0045;
        P[495 * n + state] = 0.0;
        P[496 * n + state] = 0.0;
        P[497 * n + state] = 0.0;
        P[498 * n + state] = 0.0;
        P[499 * n + state] = 0.0;
        P[500 * n + state] = 0.0;
        P[501 * n + state] = 0.0;
        P[502 * n + state] = t180 * t179;
        P[503 * n + state] = -length_23_by_q73;
        P[504 * n + state] = 0.0;
        P[505 * n + state] = 0.0;
        P[506 * n + state] = 0.0;
        P[507 * n + state] = 0.0;
        P[508 * n + state] = 0.0;
        P[509 * n + state] = 0.0;
        P[510 * n + state] = 0.0;
        P[511 * n + state] = 0.0;
        P[512 * n + state] = 0.0;
        P[513 * n + state] = 0.0;
        P[514 * n + state] = 0.0;
        P[515 * n + state] = 0.0;
        P[516 * n + state] = 0.0065;
        P[517 * n + state] = 0.0065;
        P[518 * n + state] = 0.0;
        P[519 * n + state] = 0.0;
        P[520 * n + state] = 0.0;
        P[521 * n + state] = 0.0;
        P[522 * n + state] = 0.0;
        P[523 * n + state] = t174 * t173;
        P[524 * n + state] = -length_24_by_q73;
        P[525 * n + state] = 0.0;
        P[526 * n + state] = 0.0;
        P[527 * n + state] = 0.0;
        P[528 * n + state] = 0.0;
        P[529 * n + state] = 0.0;
        P[530 * n + state] = 0.0;
        P[531 * n + state] = 0.0;
        P[532 * n + state] = 0.0;
        P[533 * n + state] = 0.0;
        P[534 * n + state] = 0.0;
        P[535 * n + state] = 0.0;
        P[536 * n + state] = 0.0;
        P[537 * n + state] = 0.0065;
        P[538 * n + state] = -0.0065;
        P[539 * n + state] = 0.0;
        P[540 * n + state] = 0.0;
        P[541 * n + state] = 0.0;
        P[542 * n + state] = 0.0;
        P[543 * n + state] = 0.0;
        P[544 * n + state] = t164 * t163;
        P[545 * n + state] = -length_25_by_q73;
        P[546 * n + state] = 0.0;
        P[547 * n + state] = 0.0;
        P[548 * n + state] = 0.0;
        P[549 * n + state] = 0.0;
        P[550 * n + state] = 0.0;
        P[551 * n + state] = 0.0;
        P[552 * n + state] = 0.0;
        P[553 * n + state] = 0.0;
        P[554 * n + state] = 0.0;
        P[555 * n + state] = 0.0;
        P[556 * n + state] = 0.0;
        P[557 * n + state] = 0.0;
        P[558 * n + state] = -0.0065;
        P[559 * n + state] = 0.0065;
        P[560 * n + state] = 0.0;
        P[561 * n + state] = 0.0;
        P[562 * n + state] = 0.0;
        P[563 * n + state] = 0.0;
        P[564 * n + state] = 0.0;
        P[565 * n + state] = t158 * t157;
        P[566 * n + state] = -length_26_by_q73;
        P[567 * n + state] = 0.0;
        P[568 * n + state] = 0.0;
        P[569 * n + state] = 0.0;
        P[570 * n + state] = 0.0;
        P[571 * n + state] = 0.0;
        P[572 * n + state] = 0.0;
        P[573 * n + state] = 0.0;
        P[574 * n + state] = 0.0;
        P[575 * n + state] = 0.0;
        P[576 * n + state] = 0.0;
        P[577 * n + state] = 0.0;
        P[578 * n + state] = 0.0;
        P[579 * n + state] = -0.0065;
        P[580 * n + state] = -0.0065;
        P[581 * n + state] = 0.0;
        P[582 * n + state] = 0.0;
        P[583 * n + state] = 0.0;
        P[584 * n + state] = 0.0;
        P[585 * n + state] = 0.0;
        P[586 * n + state] = t148 * t147;
        P[587 * n + state] = -length_27_by_q73;
        P[588 * n + state] = 0.0;
        P[589 * n + state] = 0.0;
        P[590 * n + state] = 0.0;
        P[591 * n + state] = 0.0;
        P[592 * n + state] = 0.0;
        P[593 * n + state] = 0.0;
        P[594 * n + state] = 0.0;
        P[595 * n + state] = 0.0;
        P[596 * n + state] = 0.0;
        P[597 * n + state] = 0.0;
        P[598 * n + state] = 0.0;
        P[599 * n + state] = 0.0;
        P[600 * n + state] = 0.0;
        P[601 * n + state] = 0.0;
        P[602 * n + state] = 0.011000000000000001;
        P[603 * n + state] = 0.0;
        P[604 * n + state] = 0.0;
        P[605 * n + state] = 0.0;
        P[606 * n + state] = 0.0;
        P[607 * n + state] = t144 * t143;
        P[608 * n + state] = -length_28_by_q73;
        P[609 * n + state] = 0.0;
        P[610 * n + state] = 0.0;
        P[611 * n + state] = 0.0;
        P[612 * n + state] = 0.0;
        P[613 * n + state] = 0.0;
        P[614 * n + state] = 0.0;
        P[615 * n + state] = 0.0;
        P[616 * n + state] = 0.0;
        P[617 * n + state] = 0.0;
        P[618 * n + state] = 0.0;
        P[619 * n + state] = 0.0;
        P[620 * n + state] = 0.0;
        P[621 * n + state] = 0.0;
        P[622 * n + state] = 0.0;
        P[623 * n + state] = -0.011000000000000001;
        P[624 * n + state] = 0.0;
        P[625 * n + state] = 0.0;
        P[626 * n + state] = 0.0;
        P[627 * n + state] = 0.0;
        P[628 * n + state] = t138 * t137;
        P[629 * n + state] = -length_29_by_q73;
        P[630 * n + state] = 0.0;
        P[631 * n + state] = 0.0;
        P[632 * n + state] = 0.0;
        P[633 * n + state] = 0.0;
        P[634 * n + state] = 0.0;
        P[635 * n + state] = 0.0;
        P[636 * n + state] = 0.0;
        P[637 * n + state] = 0.0;
        P[638 * n + state] = 0.0;
        P[639 * n + state] = 0.0;
        P[640 * n + state] = 0.0;
        P[641 * n + state] = 0.0;
        P[642 * n + state] = 0.0;
        P[643 * n + state] = 0.0;
        P[644 * n + state] = 0.0;
        P[645 * n + state] = 0.0052;
        P[646 * n + state] = 0.0052;
        P[647 * n + state] = 0.0;
        P[648 * n + state] = 0.0;
        P[649 * n + state] = t128 * t127;
        P[650 * n + state] = -length_30_by_q73;
        P[651 * n + state] = 0.0;
        P[652 * n + state] = 0.0;
        P[653 * n + state] = 0.0;
        P[654 * n + state] = 0.0;
        P[655 * n + state] = 0.0;
        P[656 * n + state] = 0.0;
        P[657 * n + state] = 0.0;
        P[658 * n + state] = 0.0;
        P[659 * n + state] = 0.0;
        P[660 * n + state] = 0.0;
        P[661 * n + state] = 0.0;
        P[662 * n + state] = 0.0;
        P[663 * n + state] = 0.0;
        P[664 * n + state] = 0.0;
        P[665 * n + state] = 0.0;
        P[666 * n + state] = 0.0052;
        P[667 * n + state] = -0.0052;
        P[668 * n + state] = 0.0;
        P[669 * n + state] = 0.0;
        P[670 * n + state] = t122 * t121;
        P[671 * n + state] = -length_31_by_q73;
        P[672 * n + state] = 0.0;
        P[673 * n + state] = 0.0;
        P[674 * n + state] = 0.0;
        P[675 * n + state] = 0.0;
        P[676 * n + state] = 0.0;
        P[677 * n + state] = 0.0;
        P[678 * n + state] = 0.0;
        P[679 * n + state] = 0.0;
        P[680 * n + state] = 0.0;
        P[681 * n + state] = 0.0;
        P[682 * n + state] = 0.0;
        P[683 * n + state] = 0.0;
        P[684 * n + state] = 0.0;
        P[685 * n + state] = 0.0;
        P[686 * n + state] = 0.0;
        P[687 * n + state] = -0.0052;
        P[688 * n + state] = 0.0052;
        P[689 * n + state] = 0.0;
        P[690 * n + state] = 0.0;
        P[691 * n + state] = t112 * t111;
        P[692 * n + state] = -length_32_by_q73;
        P[693 * n + state] = 0.0;
        P[694 * n + state] = 0.0;
        P[695 * n + state] = 0.0;
        P[696 * n + state] = 0.0;
        P[697 * n + state] = 0.0;
        P[698 * n + state] = 0.0;
        P[699 * n + state] = 0.0;
        P[700 * n + state] = 0.0;
        P[701 * n + state] = 0.0;
        P[702 * n + state] = 0.0;
        P[703 * n + state] = 0.0;
        P[704 * n + state] = 0.0;
        P[705 * n + state] = 0.0;
        P[706 * n + state] = 0.0;
        P[707 * n + state] = 0.0;
        P[708 * n + state] = -0.0052;
        P[709 * n + state] = -0.0052;
        P[710 * n + state] = 0.0;
        P[711 * n + state] = 0.0;
        P[712 * n + state] = t102 * t101;
        P[713 * n + state] = -length_33_by_q73;
        P[714 * n + state] = 0.0;
        P[715 * n + state] = 0.0;
        P[716 * n + state] = 0.0;
        P[717 * n + state] = 0.0;
        P[718 * n + state] = 0.0;
        P[719 * n + state] = 0.0;
        P[720 * n + state] = 0.0;
        P[721 * n + state] = 0.0;
        P[722 * n + state] = 0.0;
        P[723 * n + state] = 0.0;
        P[724 * n + state] = 0.0;
        P[725 * n + state] = 0.0;
        P[726 * n + state] = 0.0;
        P[727 * n + state] = 0.0;
        P[728 * n + state] = 0.0;
        P[729 * n + state] = 0.0;
        P[730 * n + state] = 0.0;
        P[731 * n + state] = 0.0088;
        P[732 * n + state] = 0.0;
        P[733 * n + state] = t96 * t95;
        P[734 * n + state] = -length_34_by_q73;
        P[735 * n + state] = 0.0;
        P[736 * n + state] = 0.0;
        P[737 * n + state] = 0.0;
        P[738 * n + state] = 0.0;
        P[739 * n + state] = 0.0;
        P[740 * n + state] = 0.0;
        P[741 * n + state] = 0.0;
        P[742 * n + state] = 0.0;
        P[743 * n + state] = 0.0;
        P[744 * n + state] = 0.0;
        P[745 * n + state] = 0.0;
        P[746 * n + state] = 0.0;
        P[747 * n + state] = 0.0;
        P[748 * n + state] = 0.0;
        P[749 * n + state] = 0.0;
        P[750 * n + state] = 0.0;
        P[751 * n + state] = 0.0;
        P[752 * n + state] = -0.0088;
        P[753 * n + state] = 0.0;
        P[754 * n + state] = t86 * t85;
        P[755 * n + state] = -length_35_by_q73;
        P[756 * n + state] = 0.0;
        P[757 * n + state] = 0.0;
        P[758 * n + state] = 0.0;
        P[759 * n + state] = 0.0;
        P[760 * n + state] = 0.0;
        P[761 * n + state] = 0.0;
        P[762 * n + state] = 0.0;
        P[763 * n + state] = 0.0;
        P[764 * n + state] = 0.0;
        P[765 * n + state] = 0.0;
        P[766 * n + state] = 0.0;
        P[767 * n + state] = 0.0;
        P[768 * n + state] = 0.0;
        P[769 * n + state] = 0.0;
        P[770 * n + state] = 0.0;
        P[771 * n + state] = 0.0;
        P[772 * n + state] = 0.0;
        P[773 * n + state] = 0.0;
        P[774 * n + state] = 0.005;
        P[775 * n + state] = t80 * t79;
        P[776 * n + state] = -length_36_by_q73;
        P[777 * n + state] = 0.0;
        P[778 * n + state] = 0.0;
        P[779 * n + state] = 0.0;
        P[780 * n + state] = 0.0;
        P[781 * n + state] = 0.0;
        P[782 * n + state] = 0.0;
        P[783 * n + state] = 0.0;
        P[784 * n + state] = 0.0;
        P[785 * n + state] = 0.0;
        P[786 * n + state] = 0.0;
        P[787 * n + state] = 0.0;
        P[788 * n + state] = 0.0;
        P[789 * n + state] = 0.0;
        P[790 * n + state] = 0.0;
        P[791 * n + state] = 0.0;
        P[792 * n + state] = 0.0;
        P[793 * n + state] = 0.0;
        P[794 * n + state] = 0.0;
        P[795 * n + state] = -0.005;
        P[796 * n + state] = t70 * t61;
        P[797 * n + state] = -length_37_by_q73;
    }
}

void hand_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT q_wrist, const double *SINEW_RESTRICT f,
    double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
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
        const double t34 = 0.001 * y_z;
        const double t35 = cos_q71 * z_plane_x;
        const double t36 = sin_q71 * sin_A;
        const double z_x = t35 - t36;
        const double M_x = cos_q71 * M_e;
        const double t37 = cos_q71 * x_plane_x;
        const double t38 = sin_q71 * cos_A;
        const double t39 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t37 + t38);
        const double t40 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double t41 = 0.011 * y_x;
        const double layer_0_x = t39 - t40 + t41;
        const double t42 = 0.001 * y_x;
        const double strand_1_x = layer_0_x - t42;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t43 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t44 = 0.01 * z_plane_y_by_q71;
        const double layer_0_y_by_q71 = t43 - t44;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t45 = 0.004 * (u_e * sin_A);
        const double t46 = 0.01 * z_plane_y;
        const double t47 = 0.011 * u_y;
        const double layer_0_y = 0.007 - origin_y - t45 + t46 + t47;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double z_z_by_q71 = t35 + cos_q71 * sin_A_by_q71 - t36 + sin_q71 * z_plane_x_by_q71;
        const double x_z_by_q71 = t37 - cos_q71 * cos_A_by_q71 + t38 + sin_q71 * x_plane_x_by_q71;
        const double t48 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t49 = 0.01 * z_z_by_q71;
        const double layer_0_z_by_q71 = t48 + t49 - t41;
        const double z_z = t26 + t27;
        const double origin_z = M_z - 0.018 * z_z;
        const double t50 = 0.004 * (t29 - t30);
        const double t51 = 0.01 * z_z;
        const double layer_0_z = 0.008 - origin_z - t50 - t51 + t33;
        const double strand_1_z = layer_0_z - t34;
        const double t52 = strand_1_x * (layer_0_x_by_q71 + t34) - strand_1_y * layer_0_y_by_q71
            - strand_1_z * (layer_0_z_by_q71 + t42);
        const double t53 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double t54 = 1.0 / sinew_sqrt(t53);
        const double t55 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
            * layer_0_z_by_q71;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double t56 = 1.0 / length_0;
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
        const double t57 = p_y * limited_by_q73 + p_z * root_by_q73 + limited * p_y_by_q73 - cos_A
            * reach_squared_by_q73;
        const double cos_A_by_q73 = t57 * t25;
        const double z_plane_x_by_q73 = u_y * cos_A_by_q73 - cos_A * u_y_by_q73;
        const double t58 = p_y * root_by_q73 - p_z * limited_by_q73 + root * p_y_by_q73 - sin_A
            * reach_squared_by_q73;
        const double sin_A_by_q73 = t58 * t25;
        const double z_x_by_q73 = cos_q71 * z_plane_x_by_q73 - sin_q71 * sin_A_by_q73;
        const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t59 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t60 = 0.01 * z_x_by_q73;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t61 = 0.011 * y_x_by_q73;
        const double layer_0_x_by_q73 = t59 + t60 - t61;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t62 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t63 = 0.01 * z_plane_y_by_q73;
        const double t64 = 0.011 * u_y_by_q73;
        const double layer_0_y_by_q73 = t62 + t63 - t64;
        const double t65 = strand_1_x * (layer_0_x_by_q73 + 0.001 * y_x_by_q73) - strand_1_y
            * (layer_0_y_by_q73 + 0.001 * u_y_by_q73);
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t66 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t67 = 0.01 * z_z_by_q73;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t68 = 0.011 * y_z_by_q73;
        const double layer_0_z_by_q73 = t66 + t67 - t68;
        const double length_1_by_q73 = (t65 + strand_1_z * (layer_0_z_by_q73 + 0.001 * y_z_by_q73))
            * t54;
        const double t69 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
            * layer_0_z_by_q73;
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
        const double t76 = f[state] * (t55 * t56) + f[1 * n + state] * (t52 * t54) + f[2 * n
            + state] * (t73 * t75);
        const double t77 = 0.003 * y_x_by_q73;
        const double t78 = 0.003 * u_y_by_q73;
        const double t79 = strand_2_x * (layer_0_x_by_q73 + t77) - strand_2_y * (layer_0_y_by_q73
            + t78);
        const double t80 = 0.003 * y_z_by_q73;
        const double length_2_by_q73 = (t79 + strand_2_z * (layer_0_z_by_q73 + t80)) * t75;
        const double t81 = f[state] * (t69 * t56) + f[1 * n + state] * length_1_by_q73 + f[2 * n
            + state] * length_2_by_q73;
        const double t82 = 0.005 * y_z;
        const double t83 = 0.005 * y_x;
        const double strand_3_x = layer_0_x - t83;
        const double t84 = 0.005 * u_y;
        const double strand_3_y = 0.004 + layer_0_y - t84;
        const double strand_3_z = layer_0_z - t82;
        const double t85 = strand_3_x * (layer_0_x_by_q71 + t82) - strand_3_y * layer_0_y_by_q71
            - strand_3_z * (layer_0_z_by_q71 + t83);
        const double t86 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double t87 = 1.0 / sinew_sqrt(t86);
        const double t88 = 0.005 * y_x_by_q73;
        const double t89 = 0.005 * u_y_by_q73;
        const double t90 = strand_3_x * (layer_0_x_by_q73 + t88) - strand_3_y * (layer_0_y_by_q73
            + t89);
        const double t91 = 0.005 * y_z_by_q73;
        const double length_3_by_q73 = (t90 + strand_3_z * (layer_0_z_by_q73 + t91)) * t87;
        const double t92 = 0.006 * y_z;
        const double t93 = 0.006 * y_x;
        const double strand_4_x = layer_0_x - t93;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double strand_4_z = layer_0_z - t92;
        const double t94 = strand_4_x * (layer_0_x_by_q71 + t92) - strand_4_y * layer_0_y_by_q71
            - strand_4_z * (layer_0_z_by_q71 + t93);
        const double t95 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double t96 = 1.0 / sinew_sqrt(t95);
        const double t97 = strand_4_x * (layer_0_x_by_q73 + 0.006 * y_x_by_q73) - strand_4_y
            * (layer_0_y_by_q73 + 0.006 * u_y_by_q73);
        const double length_4_by_q73 = (t97 + strand_4_z * (layer_0_z_by_q73 + 0.006 * y_z_by_q73))
            * t96;
        const double t98 = t81 + f[3 * n + state] * length_3_by_q73 + f[4 * n + state]
            * length_4_by_q73;
        const double t99 = 0.008 * y_z;
        const double t100 = 0.008 * y_x;
        const double strand_5_x = layer_0_x - t100;
        const double t101 = 0.008 * u_y;
        const double strand_5_y = 0.008 + layer_0_y - t101;
        const double strand_5_z = layer_0_z - t99;
        const double t102 = strand_5_x * (layer_0_x_by_q71 + t99) - strand_5_y * layer_0_y_by_q71
            - strand_5_z * (layer_0_z_by_q71 + t100);
        const double t103 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double t104 = 1.0 / sinew_sqrt(t103);
        const double t105 = t76 + f[3 * n + state] * (t85 * t87) + f[4 * n + state] * (t94 * t96)
            + f[5 * n + state] * (t102 * t104);
        const double t106 = 0.008 * y_x_by_q73;
        const double t107 = 0.008 * u_y_by_q73;
        const double t108 = strand_5_x * (layer_0_x_by_q73 + t106) - strand_5_y * (layer_0_y_by_q73
            + t107);
        const double t109 = 0.008 * y_z_by_q73;
        const double length_5_by_q73 = (t108 + strand_5_z * (layer_0_z_by_q73 + t109)) * t104;
        const double t110 = 0.009 * y_z;
        const double t111 = 0.009 * y_x;
        const double strand_6_x = layer_0_x - t111;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double strand_6_z = layer_0_z - t110;
        const double t112 = strand_6_x * (layer_0_x_by_q71 + t110) - strand_6_y * layer_0_y_by_q71
            - strand_6_z * (layer_0_z_by_q71 + t111);
        const double t113 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double t114 = 1.0 / sinew_sqrt(t113);
        const double t115 = strand_6_x * (layer_0_x_by_q73 + 0.009 * y_x_by_q73) - strand_6_y
            * (layer_0_y_by_q73 + 0.009 * u_y_by_q73);
        const double length_6_by_q73 = (t115 + strand_6_z * (layer_0_z_by_q73 + 0.009 * y_z_by_q73))
            * t114;
        const double t116 = t98 + f[5 * n + state] * length_5_by_q73 + f[6 * n + state]
            * length_6_by_q73;
        const double strand_7_x = layer_0_x - t41;
        const double strand_7_y = 0.011 + layer_0_y - t47;
        const double strand_7_z = layer_0_z - t33;
        const double t117 = strand_7_x * (layer_0_x_by_q71 + t33) - strand_7_y * layer_0_y_by_q71
            - strand_7_z * (layer_0_z_by_q71 + t41);
        const double t118 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double t119 = 1.0 / sinew_sqrt(t118);
        const double t120 = t105 + f[6 * n + state] * (t112 * t114) + f[7 * n + state] * (t117
            * t119);
        const double t121 = strand_7_x * (layer_0_x_by_q73 + t61) - strand_7_y * (layer_0_y_by_q73
            + t64);
        const double length_7_by_q73 = (t121 + strand_7_z * (layer_0_z_by_q73 + t68)) * t119;
        const double t122 = f[4 * n + state] - f[5 * n + state] - f[6 * n + state] + f[7 * n
            + state];
        const double t123 = 0.013 * y_z;
        const double t124 = 0.013 * y_x;
        const double strand_8_x = layer_0_x - t124;
        const double t125 = 0.013 * u_y;
        const double strand_8_y = 0.012 + layer_0_y - t125;
        const double strand_8_z = layer_0_z - t123;
        const double t126 = strand_8_x * (layer_0_x_by_q71 + t123) - strand_8_y * layer_0_y_by_q71
            - strand_8_z * (layer_0_z_by_q71 + t124);
        const double t127 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double t128 = 1.0 / sinew_sqrt(t127);
        const double t129 = 0.013 * y_x_by_q73;
        const double t130 = 0.013 * u_y_by_q73;
        const double t131 = strand_8_x * (layer_0_x_by_q73 + t129) - strand_8_y * (layer_0_y_by_q73
            + t130);
        const double t132 = 0.013 * y_z_by_q73;
        const double length_8_by_q73 = (t131 + strand_8_z * (layer_0_z_by_q73 + t132)) * t128;
        const double t133 = t116 + f[7 * n + state] * length_7_by_q73 + f[8 * n + state]
            * length_8_by_q73;
        const double t134 = 0.0065 * f[8 * n + state];
        const double t135 = 0.014 * y_z;
        const double t136 = 0.014 * y_x;
        const double strand_9_x = layer_0_x - t136;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double strand_9_z = layer_0_z - t135;
        const double t137 = strand_9_x * (layer_0_x_by_q71 + t135) - strand_9_y * layer_0_y_by_q71
            - strand_9_z * (layer_0_z_by_q71 + t136);
        const double t138 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double t139 = 1.0 / sinew_sqrt(t138);
        const double t140 = t120 + f[8 * n + state] * (t126 * t128) + f[9 * n + state] * (t137
            * t139);
        const double t141 = strand_9_x * (layer_0_x_by_q73 + 0.014 * y_x_by_q73) - strand_9_y
            * (layer_0_y_by_q73 + 0.014 * u_y_by_q73);
        const double length_9_by_q73 = (t141 + strand_9_z * (layer_0_z_by_q73 + 0.014 * y_z_by_q73))
            * t139;
        const double t142 = 0.0065 * f[9 * n + state];
        const double t143 = 0.016 * y_z;
        const double t144 = 0.016 * y_x;
        const double strand_10_x = layer_0_x - t144;
        const double t145 = 0.016 * u_y;
        const double strand_10_y = 0.016 + layer_0_y - t145;
        const double strand_10_z = layer_0_z - t143;
        const double t146 = strand_10_x * (layer_0_x_by_q71 + t143) - strand_10_y * layer_0_y_by_q71
            - strand_10_z * (layer_0_z_by_q71 + t144);
        const double t147 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double t148 = 1.0 / sinew_sqrt(t147);
        const double t149 = 0.016 * y_x_by_q73;
        const double t150 = 0.016 * u_y_by_q73;
        const double t151 = strand_10_x * (layer_0_x_by_q73 + t149) - strand_10_y
            * (layer_0_y_by_q73 + t150);
        const double t152 = 0.016 * y_z_by_q73;
        const double length_10_by_q73 = (t151 + strand_10_z * (layer_0_z_by_q73 + t152)) * t148;
        const double t153 = t133 + f[9 * n + state] * length_9_by_q73 + f[10 * n + state]
            * length_10_by_q73;
        const double t154 = 0.0065 * f[10 * n + state];
        const double t155 = 0.017 * y_z;
        const double t156 = 0.017 * y_x;
        const double strand_11_x = layer_0_x - t156;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double strand_11_z = layer_0_z - t155;
        const double t157 = strand_11_x * (layer_0_x_by_q71 + t155) - strand_11_y * layer_0_y_by_q71
            - strand_11_z * (layer_0_z_by_q71 + t156);
        const double t158 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double t159 = 1.0 / sinew_sqrt(t158);
        const double t160 = t140 + f[10 * n + state] * (t146 * t148) + f[11 * n + state] * (t157
            * t159);
        const double t161 = strand_11_x * (layer_0_x_by_q73 + 0.017 * y_x_by_q73) - strand_11_y
            * (layer_0_y_by_q73 + 0.017 * u_y_by_q73);
        const double length_11_by_q73 = (t161 + strand_11_z * (layer_0_z_by_q73 + 0.017
            * y_z_by_q73)) * t159;
        const double t162 = 0.0065 * f[11 * n + state];
        const double t163 = 0.019 * y_z;
        const double t164 = 0.019 * y_x;
        const double strand_12_x = layer_0_x - t164;
        const double t165 = 0.019 * u_y;
        const double strand_12_y = 0.019 + layer_0_y - t165;
        const double strand_12_z = layer_0_z - t163;
        const double t166 = strand_12_x * (layer_0_x_by_q71 + t163) - strand_12_y * layer_0_y_by_q71
            - strand_12_z * (layer_0_z_by_q71 + t164);
        const double t167 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double t168 = 1.0 / sinew_sqrt(t167);
        const double t169 = 0.019 * y_x_by_q73;
        const double t170 = 0.019 * u_y_by_q73;
        const double t171 = strand_12_x * (layer_0_x_by_q73 + t169) - strand_12_y
            * (layer_0_y_by_q73 + t170);
        const double t172 = 0.019 * y_z_by_q73;
        const double length_12_by_q73 = (t171 + strand_12_z * (layer_0_z_by_q73 + t172)) * t168;
        const double t173 = t153 + f[11 * n + state] * length_11_by_q73 + f[12 * n + state]
            * length_12_by_q73;
        const double t174 = 0.021 * y_z;
        const double t175 = 0.021 * y_x;
        const double strand_13_x = layer_0_x - t175;
        const double t176 = 0.021 * u_y;
        const double strand_13_y = 0.02 + layer_0_y - t176;
        const double strand_13_z = layer_0_z - t174;
        const double t177 = strand_13_x * (layer_0_x_by_q71 + t174) - strand_13_y * layer_0_y_by_q71
            - strand_13_z * (layer_0_z_by_q71 + t175);
        const double t178 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double t179 = 1.0 / sinew_sqrt(t178);
        const double t180 = t160 + f[12 * n + state] * (t166 * t168) + f[13 * n + state] * (t177
            * t179);
        const double t181 = 0.021 * y_x_by_q73;
        const double t182 = 0.021 * u_y_by_q73;
        const double t183 = strand_13_x * (layer_0_x_by_q73 + t181) - strand_13_y
            * (layer_0_y_by_q73 + t182);
        const double t184 = 0.021 * y_z_by_q73;
        const double length_13_by_q73 = (t183 + strand_13_z * (layer_0_z_by_q73 + t184)) * t179;
        const double t185 = 0.022 * y_z;
        const double t186 = 0.022 * y_x;
        const double strand_14_x = layer_0_x - t186;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double strand_14_z = layer_0_z - t185;
        const double t187 = strand_14_x * (layer_0_x_by_q71 + t185) - strand_14_y * layer_0_y_by_q71
            - strand_14_z * (layer_0_z_by_q71 + t186);
        const double t188 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double t189 = 1.0 / sinew_sqrt(t188);
        const double t190 = strand_14_x * (layer_0_x_by_q73 + 0.022 * y_x_by_q73) - strand_14_y
            * (layer_0_y_by_q73 + 0.022 * u_y_by_q73);
        const double length_14_by_q73 = (t190 + strand_14_z * (layer_0_z_by_q73 + 0.022
            * y_z_by_q73)) * t189;
        const double t191 = t173 + f[13 * n + state] * length_13_by_q73 + f[14 * n + state]
            * length_14_by_q73;
        const double t192 = 0.024 * y_z;
        const double t193 = 0.024 * y_x;
        const double strand_15_x = layer_0_x - t193;
        const double t194 = 0.024 * u_y;
        const double strand_15_y = 0.024 + layer_0_y - t194;
        const double strand_15_z = layer_0_z - t192;
        const double t195 = strand_15_x * (layer_0_x_by_q71 + t192) - strand_15_y * layer_0_y_by_q71
            - strand_15_z * (layer_0_z_by_q71 + t193);
        const double t196 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double t197 = 1.0 / sinew_sqrt(t196);
        const double t198 = t180 + f[14 * n + state] * (t187 * t189) + f[15 * n + state] * (t195
            * t197);
        const double t199 = 0.024 * y_x_by_q73;
        const double t200 = 0.024 * u_y_by_q73;
        const double t201 = strand_15_x * (layer_0_x_by_q73 + t199) - strand_15_y
            * (layer_0_y_by_q73 + t200);
        const double t202 = 0.024 * y_z_by_q73;
        const double length_15_by_q73 = (t201 + strand_15_z * (layer_0_z_by_q73 + t202)) * t197;
        const double t203 = f[12 * n + state] - f[13 * n + state] + f[14 * n + state] - f[15 * n
            + state];
        const double t204 = 0.025 * y_z;
        const double t205 = 0.025 * y_x;
        const double strand_16_x = layer_0_x - t205;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double strand_16_z = layer_0_z - t204;
        const double t206 = strand_16_x * (layer_0_x_by_q71 + t204) - strand_16_y * layer_0_y_by_q71
            - strand_16_z * (layer_0_z_by_q71 + t205);
        const double t207 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double t208 = 1.0 / sinew_sqrt(t207);
        const double t209 = strand_16_x * (layer_0_x_by_q73 + 0.025 * y_x_by_q73) - strand_16_y
            * (layer_0_y_by_q73 + 0.025 * u_y_by_q73);
        const double length_16_by_q73 = (t209 + strand_16_z * (layer_0_z_by_q73 + 0.025
            * y_z_by_q73)) * t208;
        const double t210 = t191 + f[15 * n + state] * length_15_by_q73 + f[16 * n + state]
            * length_16_by_q73;
        const double t211 = 0.0065 * f[16 * n + state];
        const double R21y = c1 * s2;
        const double t212 = 0.005 * R21y;
        const double t213 = 0.006 * s1;
        const double t214 = t212 - t213;
        const double R21x = c1 * c2;
        const double t215 = 0.047 * R21x;
        const double pA_length_tox = t214 + t215;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double R22y = s1 * s2;
        const double t216 = 0.005 * R22y;
        const double t217 = 0.006 * c1;
        const double t218 = t216 + t217;
        const double R22x = s1 * c2;
        const double t219 = 0.047 * R22x;
        const double pA_length_toy = t218 + t219;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double t220 = 0.025 - 0.005 * c2;
        const double t221 = 0.047 * s2;
        const double A_lengthdz = t220 + t221;
        const double t222 = A_lengthdz * A_lengthdz;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy
            + t222);
        const double t223 = 1.0 / A_length;
        const double t224 = 0.005 * R21x;
        const double t225 = 0.047 * R21y;
        const double pA_length_tox_by_q_1 = t224 - t225;
        const double t226 = 0.005 * R22x;
        const double t227 = 0.047 * R22y;
        const double pA_length_toy_by_q_1 = t226 - t227;
        const double t228 = 0.005 * s2;
        const double t229 = 0.047 * c2;
        const double t230 = A_lengthdz * (t228 + t229);
        const double t231 = A_lengthdx * pA_length_tox_by_q_1 + A_lengthdy * pA_length_toy_by_q_1
            - t230;
        const double t232 = t212 + t213;
        const double pB_length_tox = t232 - t215;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double t233 = t216 - t217;
        const double pB_length_toy = t233 - t219;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double B_lengthdz = t220 - t221;
        const double t234 = B_lengthdz * B_lengthdz;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy
            + t234);
        const double t235 = 1.0 / B_length;
        const double pB_length_tox_by_q_1 = t224 + t225;
        const double pB_length_toy_by_q_1 = t226 + t227;
        const double t236 = B_lengthdz * (t228 - t229);
        const double t237 = B_lengthdx * pB_length_tox_by_q_1 + B_lengthdy * pB_length_toy_by_q_1
            + t236;
        const double pC_length_tox = t232 + t215;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double pC_length_toy = t233 + t219;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_length = sinew_sqrt(t222 + C_lengthdx * C_lengthdx + C_lengthdy
            * C_lengthdy);
        const double t238 = 1.0 / C_length;
        const double t239 = t230 - C_lengthdx * pA_length_tox_by_q_1 + C_lengthdy
            * pA_length_toy_by_q_1;
        const double t240 = f[state] * (t231 * t223) - f[1 * n + state] * (t237 * t235) - f[2 * n
            + state] * (t239 * t238);
        const double pD_length_tox = t214 - t215;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double pD_length_toy = t218 - t219;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_length = sinew_sqrt(t234 + D_lengthdx * D_lengthdx + D_lengthdy
            * D_lengthdy);
        const double t241 = 1.0 / D_length;
        const double t242 = t236 + D_lengthdx * pB_length_tox_by_q_1 - D_lengthdy
            * pB_length_toy_by_q_1;
        const double A_length_by_q_0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx)
            * t223;
        const double B_length_by_q_0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx)
            * t235;
        const double C_length_by_q_0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx)
            * t238;
        const double t243 = f[state] * A_length_by_q_0 - f[1 * n + state] * B_length_by_q_0 - f[2
            * n + state] * C_length_by_q_0;
        const double D_length_by_q_0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx)
            * t241;
        const double t244 = 0.027 * y_z;
        const double t245 = 0.027 * y_x;
        const double strand_17_x = layer_0_x - t245;
        const double t246 = 0.027 * u_y;
        const double strand_17_y = 0.027 + layer_0_y - t246;
        const double strand_17_z = layer_0_z - t244;
        const double t247 = strand_17_x * (layer_0_x_by_q71 + t244) - strand_17_y * layer_0_y_by_q71
            - strand_17_z * (layer_0_z_by_q71 + t245);
        const double t248 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double t249 = 1.0 / sinew_sqrt(t248);
        const double t250 = t198 + f[16 * n + state] * (t206 * t208) + f[17 * n + state] * (t247
            * t249);
        const double t251 = 0.027 * y_x_by_q73;
        const double t252 = 0.027 * u_y_by_q73;
        const double t253 = strand_17_x * (layer_0_x_by_q73 + t251) - strand_17_y
            * (layer_0_y_by_q73 + t252);
        const double t254 = 0.027 * y_z_by_q73;
        const double length_17_by_q73 = (t253 + strand_17_z * (layer_0_z_by_q73 + t254)) * t249;
        const double t255 = 0.0065 * f[17 * n + state];
        const double t256 = 0.029 * y_z;
        const double t257 = 0.029 * y_x;
        const double strand_18_x = layer_0_x - t257;
        const double t258 = 0.029 * u_y;
        const double strand_18_y = 0.028 + layer_0_y - t258;
        const double strand_18_z = layer_0_z - t256;
        const double t259 = strand_18_x * (layer_0_x_by_q71 + t256) - strand_18_y * layer_0_y_by_q71
            - strand_18_z * (layer_0_z_by_q71 + t257);
        const double t260 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double t261 = 1.0 / sinew_sqrt(t260);
        const double t262 = 0.029 * y_x_by_q73;
        const double t263 = 0.029 * u_y_by_q73;
        const double t264 = strand_18_x * (layer_0_x_by_q73 + t262) - strand_18_y
            * (layer_0_y_by_q73 + t263);
        const double t265 = 0.029 * y_z_by_q73;
        const double length_18_by_q73 = (t264 + strand_18_z * (layer_0_z_by_q73 + t265)) * t261;
        const double t266 = t210 + f[17 * n + state] * length_17_by_q73 + f[18 * n + state]
            * length_18_by_q73;
        const double t267 = 0.0065 * f[18 * n + state];
        const double layer_1_x_by_q71 = t31 - t32 - t123;
        const double layer_1_x = t39 + t40 + t124;
        const double layer_1_y_by_q71 = t43 + t44;
        const double layer_1_y = 0.006 - origin_y - t45 - t46 + t125;
        const double layer_1_z_by_q71 = t48 - t49 - t124;
        const double layer_1_z = 0.028 - origin_z - t50 + t51 + t123;
        const double t268 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
            * layer_1_z_by_q71;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double t269 = 1.0 / length_19;
        const double t270 = t250 + f[18 * n + state] * (t259 * t261) + f[19 * n + state] * (t268
            * t269);
        const double layer_1_x_by_q73 = t59 - t60 - t129;
        const double layer_1_y_by_q73 = t62 - t63 - t130;
        const double layer_1_z_by_q73 = t66 - t67 - t132;
        const double t271 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
            * layer_1_z_by_q73;
        const double t272 = 0.0065 * f[19 * n + state];
        const double t273 = 0.002 * y_z;
        const double t274 = 0.002 * y_x;
        const double strand_20_x = layer_1_x - t274;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double strand_20_z = layer_1_z - t273;
        const double t275 = strand_20_x * (layer_1_x_by_q71 + t273) - strand_20_y * layer_1_y_by_q71
            - strand_20_z * (layer_1_z_by_q71 + t274);
        const double t276 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double t277 = 1.0 / sinew_sqrt(t276);
        const double t278 = strand_20_x * (layer_1_x_by_q73 + 0.002 * y_x_by_q73) - strand_20_y
            * (layer_1_y_by_q73 + 0.002 * u_y_by_q73);
        const double length_20_by_q73 = (t278 + strand_20_z * (layer_1_z_by_q73 + 0.002
            * y_z_by_q73)) * t277;
        const double t279 = t266 + f[19 * n + state] * (t271 * t269) + f[20 * n + state]
            * length_20_by_q73;
        const double strand_21_x = layer_1_x - t71;
        const double strand_21_y = 0.003 + layer_1_y - t72;
        const double strand_21_z = layer_1_z - t70;
        const double t280 = strand_21_x * (layer_1_x_by_q71 + t70) - strand_21_y * layer_1_y_by_q71
            - strand_21_z * (layer_1_z_by_q71 + t71);
        const double t281 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double t282 = 1.0 / sinew_sqrt(t281);
        const double t283 = t270 + f[20 * n + state] * (t275 * t277) + f[21 * n + state] * (t280
            * t282);
        const double t284 = strand_21_x * (layer_1_x_by_q73 + t77) - strand_21_y * (layer_1_y_by_q73
            + t78);
        const double length_21_by_q73 = (t284 + strand_21_z * (layer_1_z_by_q73 + t80)) * t282;
        const double strand_22_x = layer_1_x - t83;
        const double strand_22_y = 0.005 + layer_1_y - t84;
        const double strand_22_z = layer_1_z - t82;
        const double t285 = strand_22_x * (layer_1_x_by_q71 + t82) - strand_22_y * layer_1_y_by_q71
            - strand_22_z * (layer_1_z_by_q71 + t83);
        const double t286 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double t287 = 1.0 / sinew_sqrt(t286);
        const double t288 = strand_22_x * (layer_1_x_by_q73 + t88) - strand_22_y * (layer_1_y_by_q73
            + t89);
        const double length_22_by_q73 = (t288 + strand_22_z * (layer_1_z_by_q73 + t91)) * t287;
        const double t289 = t279 + f[21 * n + state] * length_21_by_q73 + f[22 * n + state]
            * length_22_by_q73;
        const double t290 = 0.007 * y_z;
        const double t291 = 0.007 * y_x;
        const double strand_23_x = layer_1_x - t291;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double strand_23_z = layer_1_z - t290;
        const double t292 = strand_23_x * (layer_1_x_by_q71 + t290) - strand_23_y * layer_1_y_by_q71
            - strand_23_z * (layer_1_z_by_q71 + t291);
        const double t293 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double t294 = 1.0 / sinew_sqrt(t293);
        const double t295 = t283 + f[22 * n + state] * (t285 * t287) + f[23 * n + state] * (t292
            * t294);
        const double t296 = strand_23_x * (layer_1_x_by_q73 + 0.007 * y_x_by_q73) - strand_23_y
            * (layer_1_y_by_q73 + 0.007 * u_y_by_q73);
        const double length_23_by_q73 = (t296 + strand_23_z * (layer_1_z_by_q73 + 0.007
            * y_z_by_q73)) * t294;
        const double t297 = f[20 * n + state] - f[21 * n + state] + f[22 * n + state] - f[23 * n
            + state];
        const double strand_24_x = layer_1_x - t100;
        const double strand_24_y = 0.008 + layer_1_y - t101;
        const double strand_24_z = layer_1_z - t99;
        const double t298 = strand_24_x * (layer_1_x_by_q71 + t99) - strand_24_y * layer_1_y_by_q71
            - strand_24_z * (layer_1_z_by_q71 + t100);
        const double t299 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double t300 = 1.0 / sinew_sqrt(t299);
        const double t301 = strand_24_x * (layer_1_x_by_q73 + t106) - strand_24_y
            * (layer_1_y_by_q73 + t107);
        const double length_24_by_q73 = (t301 + strand_24_z * (layer_1_z_by_q73 + t109)) * t300;
        const double t302 = t289 + f[23 * n + state] * length_23_by_q73 + f[24 * n + state]
            * length_24_by_q73;
        const double t303 = 0.0065 * f[24 * n + state];
        const double t304 = 0.01 * y_z;
        const double t305 = 0.01 * y_x;
        const double strand_25_x = layer_1_x - t305;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double strand_25_z = layer_1_z - t304;
        const double t306 = strand_25_x * (layer_1_x_by_q71 + t304) - strand_25_y * layer_1_y_by_q71
            - strand_25_z * (layer_1_z_by_q71 + t305);
        const double t307 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double t308 = 1.0 / sinew_sqrt(t307);
        const double t309 = t295 + f[24 * n + state] * (t298 * t300) + f[25 * n + state] * (t306
            * t308);
        const double t310 = strand_25_x * (layer_1_x_by_q73 + 0.01 * y_x_by_q73) - strand_25_y
            * (layer_1_y_by_q73 + 0.01 * u_y_by_q73);
        const double length_25_by_q73 = (t310 + strand_25_z * (layer_1_z_by_q73 + 0.01
            * y_z_by_q73)) * t308;
        const double t311 = 0.0065 * f[25 * n + state];
        const double strand_26_x = layer_1_x - t41;
        const double strand_26_y = 0.011 + layer_1_y - t47;
        const double strand_26_z = layer_1_z - t33;
        const double t312 = strand_26_x * (layer_1_x_by_q71 + t33) - strand_26_y * layer_1_y_by_q71
            - strand_26_z * (layer_1_z_by_q71 + t41);
        const double t313 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double t314 = 1.0 / sinew_sqrt(t313);
        const double t315 = strand_26_x * (layer_1_x_by_q73 + t61) - strand_26_y * (layer_1_y_by_q73
            + t64);
        const double length_26_by_q73 = (t315 + strand_26_z * (layer_1_z_by_q73 + t68)) * t314;
        const double t316 = t302 + f[25 * n + state] * length_25_by_q73 + f[26 * n + state]
            * length_26_by_q73;
        const double t317 = 0.0065 * f[26 * n + state];
        const double strand_27_x = layer_1_x - t124;
        const double strand_27_y = 0.013 + layer_1_y - t125;
        const double strand_27_z = layer_1_z - t123;
        const double t318 = strand_27_x * (layer_1_x_by_q71 + t123) - strand_27_y * layer_1_y_by_q71
            - strand_27_z * (layer_1_z_by_q71 + t124);
        const double t319 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double t320 = 1.0 / sinew_sqrt(t319);
        const double t321 = t309 + f[26 * n + state] * (t312 * t314) + f[27 * n + state] * (t318
            * t320);
        const double t322 = strand_27_x * (layer_1_x_by_q73 + t129) - strand_27_y
            * (layer_1_y_by_q73 + t130);
        const double length_27_by_q73 = (t322 + strand_27_z * (layer_1_z_by_q73 + t132)) * t320;
        const double t323 = 0.0065 * f[27 * n + state];
        const double t324 = 0.015 * y_z;
        const double t325 = 0.015 * y_x;
        const double strand_28_x = layer_1_x - t325;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double strand_28_z = layer_1_z - t324;
        const double t326 = strand_28_x * (layer_1_x_by_q71 + t324) - strand_28_y * layer_1_y_by_q71
            - strand_28_z * (layer_1_z_by_q71 + t325);
        const double t327 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double t328 = 1.0 / sinew_sqrt(t327);
        const double t329 = strand_28_x * (layer_1_x_by_q73 + 0.015 * y_x_by_q73) - strand_28_y
            * (layer_1_y_by_q73 + 0.015 * u_y_by_q73);
        const double length_28_by_q73 = (t329 + strand_28_z * (layer_1_z_by_q73 + 0.015
            * y_z_by_q73)) * t328;
        const double t330 = t316 + f[27 * n + state] * length_27_by_q73 + f[28 * n + state]
            * length_28_by_q73;
        const double strand_29_x = layer_1_x - t144;
        const double strand_29_y = 0.016 + layer_1_y - t145;
        const double strand_29_z = layer_1_z - t143;
        const double t331 = strand_29_x * (layer_1_x_by_q71 + t143) - strand_29_y * layer_1_y_by_q71
            - strand_29_z * (layer_1_z_by_q71 + t144);
        const double t332 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double t333 = 1.0 / sinew_sqrt(t332);
        const double t334 = t321 + f[28 * n + state] * (t326 * t328) + f[29 * n + state] * (t331
            * t333);
        const double t335 = strand_29_x * (layer_1_x_by_q73 + t149) - strand_29_y
            * (layer_1_y_by_q73 + t150);
        const double length_29_by_q73 = (t335 + strand_29_z * (layer_1_z_by_q73 + t152)) * t333;
        const double t336 = 0.018 * y_z;
        const double t337 = 0.018 * y_x;
        const double strand_30_x = layer_1_x - t337;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double strand_30_z = layer_1_z - t336;
        const double t338 = strand_30_x * (layer_1_x_by_q71 + t336) - strand_30_y * layer_1_y_by_q71
            - strand_30_z * (layer_1_z_by_q71 + t337);
        const double t339 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double t340 = 1.0 / sinew_sqrt(t339);
        const double t341 = strand_30_x * (layer_1_x_by_q73 + 0.018 * y_x_by_q73) - strand_30_y
            * (layer_1_y_by_q73 + 0.018 * u_y_by_q73);
        const double length_30_by_q73 = (t341 + strand_30_z * (layer_1_z_by_q73 + 0.018
            * y_z_by_q73)) * t340;
        const double t342 = t330 + f[29 * n + state] * length_29_by_q73 + f[30 * n + state]
            * length_30_by_q73;
        const double t343 = 0.0052 * f[30 * n + state];
        const double strand_31_x = layer_1_x - t164;
        const double strand_31_y = 0.019 + layer_1_y - t165;
        const double strand_31_z = layer_1_z - t163;
        const double t344 = strand_31_x * (layer_1_x_by_q71 + t163) - strand_31_y * layer_1_y_by_q71
            - strand_31_z * (layer_1_z_by_q71 + t164);
        const double t345 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double t346 = 1.0 / sinew_sqrt(t345);
        const double t347 = t334 + f[30 * n + state] * (t338 * t340) + f[31 * n + state] * (t344
            * t346);
        const double t348 = strand_31_x * (layer_1_x_by_q73 + t169) - strand_31_y
            * (layer_1_y_by_q73 + t170);
        const double length_31_by_q73 = (t348 + strand_31_z * (layer_1_z_by_q73 + t172)) * t346;
        const double t349 = 0.0052 * f[31 * n + state];
        const double strand_32_x = layer_1_x - t175;
        const double strand_32_y = 0.021 + layer_1_y - t176;
        const double strand_32_z = layer_1_z - t174;
        const double t350 = strand_32_x * (layer_1_x_by_q71 + t174) - strand_32_y * layer_1_y_by_q71
            - strand_32_z * (layer_1_z_by_q71 + t175);
        const double t351 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double t352 = 1.0 / sinew_sqrt(t351);
        const double t353 = strand_32_x * (layer_1_x_by_q73 + t181) - strand_32_y
            * (layer_1_y_by_q73 + t182);
        const double length_32_by_q73 = (t353 + strand_32_z * (layer_1_z_by_q73 + t184)) * t352;
        const double t354 = t342 + f[31 * n + state] * length_31_by_q73 + f[32 * n + state]
            * length_32_by_q73;
        const double t355 = 0.0052 * f[32 * n + state];
        const double t356 = 0.023 * y_z;
        const double t357 = 0.023 * y_x;
        const double strand_33_x = layer_1_x - t357;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double strand_33_z = layer_1_z - t356;
        const double t358 = strand_33_x * (layer_1_x_by_q71 + t356) - strand_33_y * layer_1_y_by_q71
            - strand_33_z * (layer_1_z_by_q71 + t357);
        const double t359 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double t360 = 1.0 / sinew_sqrt(t359);
        const double t361 = t347 + f[32 * n + state] * (t350 * t352) + f[33 * n + state] * (t358
            * t360);
        const double t362 = strand_33_x * (layer_1_x_by_q73 + 0.023 * y_x_by_q73) - strand_33_y
            * (layer_1_y_by_q73 + 0.023 * u_y_by_q73);
        const double length_33_by_q73 = (t362 + strand_33_z * (layer_1_z_by_q73 + 0.023
            * y_z_by_q73)) * t360;
        const double t363 = 0.0052 * f[33 * n + state];
        const double strand_34_x = layer_1_x - t193;
        const double strand_34_y = 0.024 + layer_1_y - t194;
        const double strand_34_z = layer_1_z - t192;
        const double t364 = strand_34_x * (layer_1_x_by_q71 + t192) - strand_34_y * layer_1_y_by_q71
            - strand_34_z * (layer_1_z_by_q71 + t193);
        const double t365 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double t366 = 1.0 / sinew_sqrt(t365);
        const double t367 = strand_34_x * (layer_1_x_by_q73 + t199) - strand_34_y
            * (layer_1_y_by_q73 + t200);
        const double length_34_by_q73 = (t367 + strand_34_z * (layer_1_z_by_q73 + t202)) * t366;
        const double t368 = t354 + f[33 * n + state] * length_33_by_q73 + f[34 * n + state]
            * length_34_by_q73;
        const double t369 = 0.026 * y_z;
        const double t370 = 0.026 * y_x;
        const double strand_35_x = layer_1_x - t370;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double strand_35_z = layer_1_z - t369;
        const double t371 = strand_35_x * (layer_1_x_by_q71 + t369) - strand_35_y * layer_1_y_by_q71
            - strand_35_z * (layer_1_z_by_q71 + t370);
        const double t372 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double t373 = 1.0 / sinew_sqrt(t372);
        const double t374 = t361 + f[34 * n + state] * (t364 * t366) + f[35 * n + state] * (t371
            * t373);
        const double t375 = strand_35_x * (layer_1_x_by_q73 + 0.026 * y_x_by_q73) - strand_35_y
            * (layer_1_y_by_q73 + 0.026 * u_y_by_q73);
        const double length_35_by_q73 = (t375 + strand_35_z * (layer_1_z_by_q73 + 0.026
            * y_z_by_q73)) * t373;
        const double strand_36_x = layer_1_x - t245;
        const double strand_36_y = 0.027 + layer_1_y - t246;
        const double strand_36_z = layer_1_z - t244;
        const double t376 = strand_36_x * (layer_1_x_by_q71 + t244) - strand_36_y * layer_1_y_by_q71
            - strand_36_z * (layer_1_z_by_q71 + t245);
        const double t377 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double t378 = 1.0 / sinew_sqrt(t377);
        const double t379 = strand_36_x * (layer_1_x_by_q73 + t251) - strand_36_y
            * (layer_1_y_by_q73 + t252);
        const double length_36_by_q73 = (t379 + strand_36_z * (layer_1_z_by_q73 + t254)) * t378;
        const double t380 = t368 + f[35 * n + state] * length_35_by_q73 + f[36 * n + state]
            * length_36_by_q73;
        const double strand_37_x = layer_1_x - t257;
        const double strand_37_y = 0.029 + layer_1_y - t258;
        const double strand_37_z = layer_1_z - t256;
        const double t381 = strand_37_x * (layer_1_x_by_q71 + t256) - strand_37_y * layer_1_y_by_q71
            - strand_37_z * (layer_1_z_by_q71 + t257);
        const double t382 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double t383 = 1.0 / sinew_sqrt(t382);
        const double t384 = t374 + f[36 * n + state] * (t376 * t378) + f[37 * n + state] * (t381
            * t383);
        const double t385 = strand_37_x * (layer_1_x_by_q73 + t262) - strand_37_y
            * (layer_1_y_by_q73 + t263);
        const double length_37_by_q73 = (t385 + strand_37_z * (layer_1_z_by_q73 + t265)) * t383;
        tau[state] = t243 + f[3 * n + state] * D_length_by_q_0;
        tau[1 * n + state] = t240 - f[3 * n + state] * (t242 * t241);
        tau[2 * n + state] = -(0.0065 * t122);
        tau[3 * n + state] = -(0.0055 * (f[6 * n + state] - f[7 * n + state]));
        tau[4 * n + state] = -(t134 + t142 - t154 - t162);
        tau[5 * n + state] = -(t134 - t142 + t154 - t162);
        tau[6 * n + state] = -(0.0055 * t203);
        tau[7 * n + state] = 0.0045 * (f[14 * n + state] - f[15 * n + state]);
        tau[8 * n + state] = -(t211 + t255 - t267 - t272);
        tau[9 * n + state] = -(t211 - t255 + t267 - t272);
        tau[10 * n + state] = -(0.0055 * t297);
        tau[11 * n + state] = 0.0045 * (f[22 * n + state] - f[23 * n + state]);
        tau[12 * n + state] = -(t303 + t311 - t317 - t323);
        tau[13 * n + state] = -(t303 - t311 + t317 - t323);
        tau[14 * n + state] = -(0.011000000000000001 * (f[28 * n + state] - f[29 * n + state]));
        tau[15 * n + state] = -(t343 + t349 - t355 - t363);
        tau[16 * n + state] = -(t343 - t349 + t355 - t363);
        tau[17 * n + state] = -(0.0088 * (f[34 * n + state] - f[35 * n + state]));
        tau[18 * n + state] = -(0.005 * (f[36 * n + state] - f[37 * n + state]));
        tau[19 * n + state] = -t384;
        tau[20 * n + state] = t380 + f[37 * n + state] * length_37_by_q73;
    }
}

void hand_feedforward_batch(int count, const double *SINEW_RESTRICT q_wrist,
    double *SINEW_RESTRICT delta_theta)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
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

void hand_feedforward_rate_batch(int count, const double *SINEW_RESTRICT q_wrist,
    const double *SINEW_RESTRICT qd_wrist, double *SINEW_RESTRICT delta_theta_rate)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double t1 = 1.0 / (0.007324 - 0.084 * B_y);
        const double ratio = 0.003796 * t1;
        const double B_y_by_t = 0.074565407529229 * (qd_wrist[1 * n + state] * sin_q73);
        const double ratio_by_t = ratio * (0.084 * B_y_by_t) * t1;
        const double B_e = 0.074565407529229 * sin_q73;
        const double B_e_by_t = 0.074565407529229 * (qd_wrist[1 * n + state] * cos_q73);
        const double C_e_by_t = B_e * ratio_by_t - ratio * B_e_by_t;
        const double M_e_by_t = 0.5 * (B_e_by_t - C_e_by_t);
        const double sin_q71_by_t = qd_wrist[state] * cos_q71;
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
        const double cos_q71_by_t = qd_wrist[state] * sin_q71;
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

void hand_wrist_passage_batch(int count, const double *SINEW_RESTRICT q_wrist,
    double *SINEW_RESTRICT h, double *SINEW_RESTRICT P)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q71, cos_q71;
        sinew_sincos(q_wrist[state], &sin_q71, &cos_q71);
        double sin_q73, cos_q73;
        sinew_sincos(q_wrist[1 * n + state], &sin_q73, &cos_q73);
        const double B_y = 0.074565407529229 * cos_q73;
        const double t1 = 1.0 / (0.007324 - 0.084 * B_y);
        const double ratio = 0.003796 * t1;
        const double B_e = 0.074565407529229 * sin_q73;
        const double ratio_by_q73 = ratio * (0.084 * B_e) * t1;
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
        const double root = sinew_sqrt(sinew_max(t20, t21));
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
        const double origin_x_by_q73 = cos_q71 * M_e_by_q73 - 0.018 * z_x_by_q73;
        const double x_plane_x_by_q73 = u_y * sin_A_by_q73 - sin_A * u_y_by_q73;
        const double x_x_by_q73 = cos_q71 * x_plane_x_by_q73 + sin_q71 * cos_A_by_q73;
        const double t27 = origin_x_by_q73 - 0.004 * x_x_by_q73;
        const double t28 = 0.01 * z_x_by_q73;
        const double y_x_by_q73 = cos_q71 * u_e_by_q73;
        const double t29 = 0.013 * y_x_by_q73;
        const double layer_1_x_by_q73 = t27 - t28 - t29;
        const double t30 = 0.029 * y_x_by_q73;
        const double z_plane_x = u_y * cos_A;
        const double t31 = cos_q71 * z_plane_x;
        const double t32 = sin_q71 * sin_A;
        const double z_x = t31 - t32;
        const double M_x = cos_q71 * M_e;
        const double x_plane_x = u_y * sin_A;
        const double t33 = cos_q71 * x_plane_x;
        const double t34 = sin_q71 * cos_A;
        const double t35 = 0.004 - M_x + 0.018 * z_x + 0.004 * (t33 + t34);
        const double t36 = 0.01 * z_x;
        const double y_x = cos_q71 * u_e;
        const double t37 = 0.013 * y_x;
        const double layer_1_x = t35 + t36 + t37;
        const double t38 = 0.029 * y_x;
        const double strand_37_x = layer_1_x - t38;
        const double z_plane_y_by_q73 = u_e * cos_A_by_q73 + cos_A * u_e_by_q73;
        const double t39 = M_y_by_q73 - 0.018 * z_plane_y_by_q73 - 0.004 * (u_e * sin_A_by_q73
            + sin_A * u_e_by_q73);
        const double t40 = 0.01 * z_plane_y_by_q73;
        const double t41 = 0.013 * u_y_by_q73;
        const double layer_1_y_by_q73 = t39 - t40 - t41;
        const double t42 = 0.029 * u_y_by_q73;
        const double z_plane_y = u_e * cos_A;
        const double origin_y = M_y + 0.018 * z_plane_y;
        const double t43 = 0.004 * (u_e * sin_A);
        const double t44 = 0.01 * z_plane_y;
        const double t45 = 0.013 * u_y;
        const double layer_1_y = 0.006 - origin_y - t43 - t44 + t45;
        const double t46 = 0.029 * u_y;
        const double strand_37_y = 0.029 + layer_1_y - t46;
        const double t47 = strand_37_x * (layer_1_x_by_q73 + t30) - strand_37_y * (layer_1_y_by_q73
            + t42);
        const double z_z_by_q73 = cos_q71 * sin_A_by_q73 + sin_q71 * z_plane_x_by_q73;
        const double origin_z_by_q73 = sin_q71 * M_e_by_q73 - 0.018 * z_z_by_q73;
        const double x_z_by_q73 = cos_q71 * cos_A_by_q73 - sin_q71 * x_plane_x_by_q73;
        const double t48 = origin_z_by_q73 + 0.004 * x_z_by_q73;
        const double t49 = 0.01 * z_z_by_q73;
        const double y_z_by_q73 = sin_q71 * u_e_by_q73;
        const double t50 = 0.013 * y_z_by_q73;
        const double layer_1_z_by_q73 = t48 - t49 - t50;
        const double t51 = 0.029 * y_z_by_q73;
        const double t52 = sin_q71 * z_plane_x;
        const double t53 = cos_q71 * sin_A;
        const double z_z = t53 + t52;
        const double M_z = sin_q71 * M_e;
        const double origin_z = M_z - 0.018 * z_z;
        const double t54 = sin_q71 * x_plane_x;
        const double t55 = cos_q71 * cos_A;
        const double t56 = 0.004 * (t55 - t54);
        const double t57 = 0.01 * z_z;
        const double y_z = sin_q71 * u_e;
        const double t58 = 0.013 * y_z;
        const double layer_1_z = 0.028 - origin_z - t56 + t57 + t58;
        const double t59 = 0.029 * y_z;
        const double strand_37_z = layer_1_z - t59;
        const double t60 = strand_37_x * strand_37_x + strand_37_y * strand_37_y + strand_37_z
            * strand_37_z;
        const double length_37 = sinew_sqrt(t60);
        const double t61 = 1.0 / length_37;
        const double length_37_by_q73 = (t47 + strand_37_z * (layer_1_z_by_q73 + t51)) * t61;
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
        const double t62 = p_y * limited_by_q71 + p_z * root_by_q71 - limited * p_y_by_q71 - root
            * p_z_by_q71;
        const double cos_A_by_q71 = (t62 - cos_A * reach_squared_by_q71) * t24;
        const double z_plane_x_by_q71 = u_y * cos_A_by_q71;
        const double t63 = p_y * root_by_q71 - p_z * limited_by_q71 + limited * p_z_by_q71 - root
            * p_y_by_q71;
        const double sin_A_by_q71 = (t63 - sin_A * reach_squared_by_q71) * t24;
        const double z_x_by_q71 = t53 - cos_q71 * z_plane_x_by_q71 + t52 + sin_q71 * sin_A_by_q71;
        const double x_plane_x_by_q71 = u_y * sin_A_by_q71;
        const double x_x_by_q71 = t55 + cos_q71 * x_plane_x_by_q71 - t54 + sin_q71 * cos_A_by_q71;
        const double t64 = M_z - 0.018 * z_x_by_q71 + 0.004 * x_x_by_q71;
        const double t65 = 0.01 * z_x_by_q71;
        const double layer_1_x_by_q71 = t64 - t65 - t58;
        const double z_plane_y_by_q71 = u_e * cos_A_by_q71;
        const double t66 = 0.018 * z_plane_y_by_q71 + 0.004 * u_e * sin_A_by_q71;
        const double t67 = 0.01 * z_plane_y_by_q71;
        const double layer_1_y_by_q71 = t66 + t67;
        const double z_z_by_q71 = t31 + cos_q71 * sin_A_by_q71 - t32 + sin_q71 * z_plane_x_by_q71;
        const double x_z_by_q71 = t33 - cos_q71 * cos_A_by_q71 + t34 + sin_q71 * x_plane_x_by_q71;
        const double t68 = M_x - 0.018 * z_z_by_q71 - 0.004 * x_z_by_q71;
        const double t69 = 0.01 * z_z_by_q71;
        const double layer_1_z_by_q71 = t68 - t69 - t37;
        const double t70 = strand_37_x * (layer_1_x_by_q71 + t59) - strand_37_y * layer_1_y_by_q71
            - strand_37_z * (layer_1_z_by_q71 + t38);
        const double t71 = 0.027 * y_x_by_q73;
        const double t72 = 0.027 * y_x;
        const double strand_36_x = layer_1_x - t72;
        const double t73 = 0.027 * u_y_by_q73;
        const double t74 = 0.027 * u_y;
        const double strand_36_y = 0.027 + layer_1_y - t74;
        const double t75 = strand_36_x * (layer_1_x_by_q73 + t71) - strand_36_y * (layer_1_y_by_q73
            + t73);
        const double t76 = 0.027 * y_z_by_q73;
        const double t77 = 0.027 * y_z;
        const double strand_36_z = layer_1_z - t77;
        const double t78 = strand_36_x * strand_36_x + strand_36_y * strand_36_y + strand_36_z
            * strand_36_z;
        const double length_36 = sinew_sqrt(t78);
        const double t79 = 1.0 / length_36;
        const double length_36_by_q73 = (t75 + strand_36_z * (layer_1_z_by_q73 + t76)) * t79;
        const double t80 = strand_36_x * (layer_1_x_by_q71 + t77) - strand_36_y * layer_1_y_by_q71
            - strand_36_z * (layer_1_z_by_q71 + t72);
        const double t81 = 0.026 * y_x;
        const double strand_35_x = layer_1_x - t81;
        const double strand_35_y = 0.025 + layer_1_y - 0.026 * u_y;
        const double t82 = strand_35_x * (layer_1_x_by_q73 + 0.026 * y_x_by_q73) - strand_35_y
            * (layer_1_y_by_q73 + 0.026 * u_y_by_q73);
        const double t83 = 0.026 * y_z;
        const double strand_35_z = layer_1_z - t83;
        const double t84 = strand_35_x * strand_35_x + strand_35_y * strand_35_y + strand_35_z
            * strand_35_z;
        const double length_35 = sinew_sqrt(t84);
        const double t85 = 1.0 / length_35;
        const double length_35_by_q73 = (t82 + strand_35_z * (layer_1_z_by_q73 + 0.026
            * y_z_by_q73)) * t85;
        const double t86 = strand_35_x * (layer_1_x_by_q71 + t83) - strand_35_y * layer_1_y_by_q71
            - strand_35_z * (layer_1_z_by_q71 + t81);
        const double t87 = 0.024 * y_x_by_q73;
        const double t88 = 0.024 * y_x;
        const double strand_34_x = layer_1_x - t88;
        const double t89 = 0.024 * u_y_by_q73;
        const double t90 = 0.024 * u_y;
        const double strand_34_y = 0.024 + layer_1_y - t90;
        const double t91 = strand_34_x * (layer_1_x_by_q73 + t87) - strand_34_y * (layer_1_y_by_q73
            + t89);
        const double t92 = 0.024 * y_z_by_q73;
        const double t93 = 0.024 * y_z;
        const double strand_34_z = layer_1_z - t93;
        const double t94 = strand_34_x * strand_34_x + strand_34_y * strand_34_y + strand_34_z
            * strand_34_z;
        const double length_34 = sinew_sqrt(t94);
        const double t95 = 1.0 / length_34;
        const double length_34_by_q73 = (t91 + strand_34_z * (layer_1_z_by_q73 + t92)) * t95;
        const double t96 = strand_34_x * (layer_1_x_by_q71 + t93) - strand_34_y * layer_1_y_by_q71
            - strand_34_z * (layer_1_z_by_q71 + t88);
        const double t97 = 0.023 * y_x;
        const double strand_33_x = layer_1_x - t97;
        const double strand_33_y = 0.022 + layer_1_y - 0.023 * u_y;
        const double t98 = strand_33_x * (layer_1_x_by_q73 + 0.023 * y_x_by_q73) - strand_33_y
            * (layer_1_y_by_q73 + 0.023 * u_y_by_q73);
        const double t99 = 0.023 * y_z;
        const double strand_33_z = layer_1_z - t99;
        const double t100 = strand_33_x * strand_33_x + strand_33_y * strand_33_y + strand_33_z
            * strand_33_z;
        const double length_33 = sinew_sqrt(t100);
        const double t101 = 1.0 / length_33;
        const double length_33_by_q73 = (t98 + strand_33_z * (layer_1_z_by_q73 + 0.023
            * y_z_by_q73)) * t101;
        const double t102 = strand_33_x * (layer_1_x_by_q71 + t99) - strand_33_y * layer_1_y_by_q71
            - strand_33_z * (layer_1_z_by_q71 + t97);
        const double t103 = 0.021 * y_x_by_q73;
        const double t104 = 0.021 * y_x;
        const double strand_32_x = layer_1_x - t104;
        const double t105 = 0.021 * u_y_by_q73;
        const double t106 = 0.021 * u_y;
        const double strand_32_y = 0.021 + layer_1_y - t106;
        const double t107 = strand_32_x * (layer_1_x_by_q73 + t103) - strand_32_y
            * (layer_1_y_by_q73 + t105);
        const double t108 = 0.021 * y_z_by_q73;
        const double t109 = 0.021 * y_z;
        const double strand_32_z = layer_1_z - t109;
        const double t110 = strand_32_x * strand_32_x + strand_32_y * strand_32_y + strand_32_z
            * strand_32_z;
        const double length_32 = sinew_sqrt(t110);
        const double t111 = 1.0 / length_32;
        const double length_32_by_q73 = (t107 + strand_32_z * (layer_1_z_by_q73 + t108)) * t111;
        const double t112 = strand_32_x * (layer_1_x_by_q71 + t109) - strand_32_y * layer_1_y_by_q71
            - strand_32_z * (layer_1_z_by_q71 + t104);
        const double t113 = 0.019 * y_x_by_q73;
        const double t114 = 0.019 * y_x;
        const double strand_31_x = layer_1_x - t114;
        const double t115 = 0.019 * u_y_by_q73;
        const double t116 = 0.019 * u_y;
        const double strand_31_y = 0.019 + layer_1_y - t116;
        const double t117 = strand_31_x * (layer_1_x_by_q73 + t113) - strand_31_y
            * (layer_1_y_by_q73 + t115);
        const double t118 = 0.019 * y_z_by_q73;
        const double t119 = 0.019 * y_z;
        const double strand_31_z = layer_1_z - t119;
        const double t120 = strand_31_x * strand_31_x + strand_31_y * strand_31_y + strand_31_z
            * strand_31_z;
        const double length_31 = sinew_sqrt(t120);
        const double t121 = 1.0 / length_31;
        const double length_31_by_q73 = (t117 + strand_31_z * (layer_1_z_by_q73 + t118)) * t121;
        const double t122 = strand_31_x * (layer_1_x_by_q71 + t119) - strand_31_y * layer_1_y_by_q71
            - strand_31_z * (layer_1_z_by_q71 + t114);
        const double t123 = 0.018 * y_x;
        const double strand_30_x = layer_1_x - t123;
        const double strand_30_y = 0.017 + layer_1_y - 0.018 * u_y;
        const double t124 = strand_30_x * (layer_1_x_by_q73 + 0.018 * y_x_by_q73) - strand_30_y
            * (layer_1_y_by_q73 + 0.018 * u_y_by_q73);
        const double t125 = 0.018 * y_z;
        const double strand_30_z = layer_1_z - t125;
        const double t126 = strand_30_x * strand_30_x + strand_30_y * strand_30_y + strand_30_z
            * strand_30_z;
        const double length_30 = sinew_sqrt(t126);
        const double t127 = 1.0 / length_30;
        const double length_30_by_q73 = (t124 + strand_30_z * (layer_1_z_by_q73 + 0.018
            * y_z_by_q73)) * t127;
        const double t128 = strand_30_x * (layer_1_x_by_q71 + t125) - strand_30_y * layer_1_y_by_q71
            - strand_30_z * (layer_1_z_by_q71 + t123);
        const double t129 = 0.016 * y_x_by_q73;
        const double t130 = 0.016 * y_x;
        const double strand_29_x = layer_1_x - t130;
        const double t131 = 0.016 * u_y_by_q73;
        const double t132 = 0.016 * u_y;
        const double strand_29_y = 0.016 + layer_1_y - t132;
        const double t133 = strand_29_x * (layer_1_x_by_q73 + t129) - strand_29_y
            * (layer_1_y_by_q73 + t131);
        const double t134 = 0.016 * y_z_by_q73;
        const double t135 = 0.016 * y_z;
        const double strand_29_z = layer_1_z - t135;
        const double t136 = strand_29_x * strand_29_x + strand_29_y * strand_29_y + strand_29_z
            * strand_29_z;
        const double length_29 = sinew_sqrt(t136);
        const double t137 = 1.0 / length_29;
        const double length_29_by_q73 = (t133 + strand_29_z * (layer_1_z_by_q73 + t134)) * t137;
        const double t138 = strand_29_x * (layer_1_x_by_q71 + t135) - strand_29_y * layer_1_y_by_q71
            - strand_29_z * (layer_1_z_by_q71 + t130);
        const double t139 = 0.015 * y_x;
        const double strand_28_x = layer_1_x - t139;
        const double strand_28_y = 0.014 + layer_1_y - 0.015 * u_y;
        const double t140 = strand_28_x * (layer_1_x_by_q73 + 0.015 * y_x_by_q73) - strand_28_y
            * (layer_1_y_by_q73 + 0.015 * u_y_by_q73);
        const double t141 = 0.015 * y_z;
        const double strand_28_z = layer_1_z - t141;
        const double t142 = strand_28_x * strand_28_x + strand_28_y * strand_28_y + strand_28_z
            * strand_28_z;
        const double length_28 = sinew_sqrt(t142);
        const double t143 = 1.0 / length_28;
        const double length_28_by_q73 = (t140 + strand_28_z * (layer_1_z_by_q73 + 0.015
            * y_z_by_q73)) * t143;
        const double t144 = strand_28_x * (layer_1_x_by_q71 + t141) - strand_28_y * layer_1_y_by_q71
            - strand_28_z * (layer_1_z_by_q71 + t139);
        const double strand_27_x = layer_1_x - t37;
        const double strand_27_y = 0.013 + layer_1_y - t45;
        const double t145 = strand_27_x * (layer_1_x_by_q73 + t29) - strand_27_y * (layer_1_y_by_q73
            + t41);
        const double strand_27_z = layer_1_z - t58;
        const double t146 = strand_27_x * strand_27_x + strand_27_y * strand_27_y + strand_27_z
            * strand_27_z;
        const double length_27 = sinew_sqrt(t146);
        const double t147 = 1.0 / length_27;
        const double length_27_by_q73 = (t145 + strand_27_z * (layer_1_z_by_q73 + t50)) * t147;
        const double t148 = strand_27_x * (layer_1_x_by_q71 + t58) - strand_27_y * layer_1_y_by_q71
            - strand_27_z * (layer_1_z_by_q71 + t37);
        const double t149 = 0.011 * y_x_by_q73;
        const double t150 = 0.011 * y_x;
        const double strand_26_x = layer_1_x - t150;
        const double t151 = 0.011 * u_y_by_q73;
        const double t152 = 0.011 * u_y;
        const double strand_26_y = 0.011 + layer_1_y - t152;
        const double t153 = strand_26_x * (layer_1_x_by_q73 + t149) - strand_26_y
            * (layer_1_y_by_q73 + t151);
        const double t154 = 0.011 * y_z_by_q73;
        const double t155 = 0.011 * y_z;
        const double strand_26_z = layer_1_z - t155;
        const double t156 = strand_26_x * strand_26_x + strand_26_y * strand_26_y + strand_26_z
            * strand_26_z;
        const double length_26 = sinew_sqrt(t156);
        const double t157 = 1.0 / length_26;
        const double length_26_by_q73 = (t153 + strand_26_z * (layer_1_z_by_q73 + t154)) * t157;
        const double t158 = strand_26_x * (layer_1_x_by_q71 + t155) - strand_26_y * layer_1_y_by_q71
            - strand_26_z * (layer_1_z_by_q71 + t150);
        const double t159 = 0.01 * y_x;
        const double strand_25_x = layer_1_x - t159;
        const double strand_25_y = 0.009 + layer_1_y - 0.01 * u_y;
        const double t160 = strand_25_x * (layer_1_x_by_q73 + 0.01 * y_x_by_q73) - strand_25_y
            * (layer_1_y_by_q73 + 0.01 * u_y_by_q73);
        const double t161 = 0.01 * y_z;
        const double strand_25_z = layer_1_z - t161;
        const double t162 = strand_25_x * strand_25_x + strand_25_y * strand_25_y + strand_25_z
            * strand_25_z;
        const double length_25 = sinew_sqrt(t162);
        const double t163 = 1.0 / length_25;
        const double length_25_by_q73 = (t160 + strand_25_z * (layer_1_z_by_q73 + 0.01
            * y_z_by_q73)) * t163;
        const double t164 = strand_25_x * (layer_1_x_by_q71 + t161) - strand_25_y * layer_1_y_by_q71
            - strand_25_z * (layer_1_z_by_q71 + t159);
        const double t165 = 0.008 * y_x_by_q73;
        const double t166 = 0.008 * y_x;
        const double strand_24_x = layer_1_x - t166;
        const double t167 = 0.008 * u_y_by_q73;
        const double t168 = 0.008 * u_y;
        const double strand_24_y = 0.008 + layer_1_y - t168;
        const double t169 = strand_24_x * (layer_1_x_by_q73 + t165) - strand_24_y
            * (layer_1_y_by_q73 + t167);
        const double t170 = 0.008 * y_z_by_q73;
        const double t171 = 0.008 * y_z;
        const double strand_24_z = layer_1_z - t171;
        const double t172 = strand_24_x * strand_24_x + strand_24_y * strand_24_y + strand_24_z
            * strand_24_z;
        const double length_24 = sinew_sqrt(t172);
        const double t173 = 1.0 / length_24;
        const double length_24_by_q73 = (t169 + strand_24_z * (layer_1_z_by_q73 + t170)) * t173;
        const double t174 = strand_24_x * (layer_1_x_by_q71 + t171) - strand_24_y * layer_1_y_by_q71
            - strand_24_z * (layer_1_z_by_q71 + t166);
        const double t175 = 0.007 * y_x;
        const double strand_23_x = layer_1_x - t175;
        const double strand_23_y = 0.006 + layer_1_y - 0.007 * u_y;
        const double t176 = strand_23_x * (layer_1_x_by_q73 + 0.007 * y_x_by_q73) - strand_23_y
            * (layer_1_y_by_q73 + 0.007 * u_y_by_q73);
        const double t177 = 0.007 * y_z;
        const double strand_23_z = layer_1_z - t177;
        const double t178 = strand_23_x * strand_23_x + strand_23_y * strand_23_y + strand_23_z
            * strand_23_z;
        const double length_23 = sinew_sqrt(t178);
        const double t179 = 1.0 / length_23;
        const double length_23_by_q73 = (t176 + strand_23_z * (layer_1_z_by_q73 + 0.007
            * y_z_by_q73)) * t179;
        const double t180 = strand_23_x * (layer_1_x_by_q71 + t177) - strand_23_y * layer_1_y_by_q71
            - strand_23_z * (layer_1_z_by_q71 + t175);
        const double t181 = 0.005 * y_x_by_q73;
        const double t182 = 0.005 * y_x;
        const double strand_22_x = layer_1_x - t182;
        const double t183 = 0.005 * u_y_by_q73;
        const double t184 = 0.005 * u_y;
        const double strand_22_y = 0.005 + layer_1_y - t184;
        const double t185 = strand_22_x * (layer_1_x_by_q73 + t181) - strand_22_y
            * (layer_1_y_by_q73 + t183);
        const double t186 = 0.005 * y_z_by_q73;
        const double t187 = 0.005 * y_z;
        const double strand_22_z = layer_1_z - t187;
        const double t188 = strand_22_x * strand_22_x + strand_22_y * strand_22_y + strand_22_z
            * strand_22_z;
        const double length_22 = sinew_sqrt(t188);
        const double t189 = 1.0 / length_22;
        const double length_22_by_q73 = (t185 + strand_22_z * (layer_1_z_by_q73 + t186)) * t189;
        const double t190 = strand_22_x * (layer_1_x_by_q71 + t187) - strand_22_y * layer_1_y_by_q71
            - strand_22_z * (layer_1_z_by_q71 + t182);
        const double t191 = 0.003 * y_x_by_q73;
        const double t192 = 0.003 * y_x;
        const double strand_21_x = layer_1_x - t192;
        const double t193 = 0.003 * u_y_by_q73;
        const double t194 = 0.003 * u_y;
        const double strand_21_y = 0.003 + layer_1_y - t194;
        const double t195 = strand_21_x * (layer_1_x_by_q73 + t191) - strand_21_y
            * (layer_1_y_by_q73 + t193);
        const double t196 = 0.003 * y_z_by_q73;
        const double t197 = 0.003 * y_z;
        const double strand_21_z = layer_1_z - t197;
        const double t198 = strand_21_x * strand_21_x + strand_21_y * strand_21_y + strand_21_z
            * strand_21_z;
        const double length_21 = sinew_sqrt(t198);
        const double t199 = 1.0 / length_21;
        const double length_21_by_q73 = (t195 + strand_21_z * (layer_1_z_by_q73 + t196)) * t199;
        const double t200 = strand_21_x * (layer_1_x_by_q71 + t197) - strand_21_y * layer_1_y_by_q71
            - strand_21_z * (layer_1_z_by_q71 + t192);
        const double t201 = 0.002 * y_x;
        const double strand_20_x = layer_1_x - t201;
        const double strand_20_y = 0.001 + layer_1_y - 0.002 * u_y;
        const double t202 = strand_20_x * (layer_1_x_by_q73 + 0.002 * y_x_by_q73) - strand_20_y
            * (layer_1_y_by_q73 + 0.002 * u_y_by_q73);
        const double t203 = 0.002 * y_z;
        const double strand_20_z = layer_1_z - t203;
        const double t204 = strand_20_x * strand_20_x + strand_20_y * strand_20_y + strand_20_z
            * strand_20_z;
        const double length_20 = sinew_sqrt(t204);
        const double t205 = 1.0 / length_20;
        const double length_20_by_q73 = (t202 + strand_20_z * (layer_1_z_by_q73 + 0.002
            * y_z_by_q73)) * t205;
        const double t206 = strand_20_x * (layer_1_x_by_q71 + t203) - strand_20_y * layer_1_y_by_q71
            - strand_20_z * (layer_1_z_by_q71 + t201);
        const double t207 = layer_1_x * layer_1_x_by_q73 - layer_1_y * layer_1_y_by_q73 + layer_1_z
            * layer_1_z_by_q73;
        const double length_19 = sinew_sqrt(layer_1_x * layer_1_x + layer_1_y * layer_1_y
            + layer_1_z * layer_1_z);
        const double t208 = 1.0 / length_19;
        const double t209 = layer_1_x * layer_1_x_by_q71 - layer_1_y * layer_1_y_by_q71 - layer_1_z
            * layer_1_z_by_q71;
        const double layer_0_x_by_q73 = t27 + t28 - t149;
        const double layer_0_x = t35 - t36 + t150;
        const double strand_18_x = layer_0_x - t38;
        const double layer_0_y_by_q73 = t39 + t40 - t151;
        const double layer_0_y = 0.007 - origin_y - t43 + t44 + t152;
        const double strand_18_y = 0.028 + layer_0_y - t46;
        const double t210 = strand_18_x * (layer_0_x_by_q73 + t30) - strand_18_y * (layer_0_y_by_q73
            + t42);
        const double layer_0_z_by_q73 = t48 + t49 - t154;
        const double layer_0_z = 0.008 - origin_z - t56 - t57 + t155;
        const double strand_18_z = layer_0_z - t59;
        const double t211 = strand_18_x * strand_18_x + strand_18_y * strand_18_y + strand_18_z
            * strand_18_z;
        const double length_18 = sinew_sqrt(t211);
        const double t212 = 1.0 / length_18;
        const double length_18_by_q73 = (t210 + strand_18_z * (layer_0_z_by_q73 + t51)) * t212;
        const double layer_0_x_by_q71 = t64 + t65 - t155;
        const double layer_0_y_by_q71 = t66 - t67;
        const double layer_0_z_by_q71 = t68 + t69 - t150;
        const double t213 = strand_18_x * (layer_0_x_by_q71 + t59) - strand_18_y * layer_0_y_by_q71
            - strand_18_z * (layer_0_z_by_q71 + t38);
        const double strand_17_x = layer_0_x - t72;
        const double strand_17_y = 0.027 + layer_0_y - t74;
        const double t214 = strand_17_x * (layer_0_x_by_q73 + t71) - strand_17_y * (layer_0_y_by_q73
            + t73);
        const double strand_17_z = layer_0_z - t77;
        const double t215 = strand_17_x * strand_17_x + strand_17_y * strand_17_y + strand_17_z
            * strand_17_z;
        const double length_17 = sinew_sqrt(t215);
        const double t216 = 1.0 / length_17;
        const double length_17_by_q73 = (t214 + strand_17_z * (layer_0_z_by_q73 + t76)) * t216;
        const double t217 = strand_17_x * (layer_0_x_by_q71 + t77) - strand_17_y * layer_0_y_by_q71
            - strand_17_z * (layer_0_z_by_q71 + t72);
        const double t218 = 0.025 * y_x;
        const double strand_16_x = layer_0_x - t218;
        const double strand_16_y = 0.025 + layer_0_y - 0.025 * u_y;
        const double t219 = strand_16_x * (layer_0_x_by_q73 + 0.025 * y_x_by_q73) - strand_16_y
            * (layer_0_y_by_q73 + 0.025 * u_y_by_q73);
        const double t220 = 0.025 * y_z;
        const double strand_16_z = layer_0_z - t220;
        const double t221 = strand_16_x * strand_16_x + strand_16_y * strand_16_y + strand_16_z
            * strand_16_z;
        const double length_16 = sinew_sqrt(t221);
        const double t222 = 1.0 / length_16;
        const double length_16_by_q73 = (t219 + strand_16_z * (layer_0_z_by_q73 + 0.025
            * y_z_by_q73)) * t222;
        const double t223 = strand_16_x * (layer_0_x_by_q71 + t220) - strand_16_y * layer_0_y_by_q71
            - strand_16_z * (layer_0_z_by_q71 + t218);
        const double strand_15_x = layer_0_x - t88;
        const double strand_15_y = 0.024 + layer_0_y - t90;
        const double t224 = strand_15_x * (layer_0_x_by_q73 + t87) - strand_15_y * (layer_0_y_by_q73
            + t89);
        const double strand_15_z = layer_0_z - t93;
        const double t225 = strand_15_x * strand_15_x + strand_15_y * strand_15_y + strand_15_z
            * strand_15_z;
        const double length_15 = sinew_sqrt(t225);
        const double t226 = 1.0 / length_15;
        const double length_15_by_q73 = (t224 + strand_15_z * (layer_0_z_by_q73 + t92)) * t226;
        const double t227 = strand_15_x * (layer_0_x_by_q71 + t93) - strand_15_y * layer_0_y_by_q71
            - strand_15_z * (layer_0_z_by_q71 + t88);
        const double t228 = 0.022 * y_x;
        const double strand_14_x = layer_0_x - t228;
        const double strand_14_y = 0.022 + layer_0_y - 0.022 * u_y;
        const double t229 = strand_14_x * (layer_0_x_by_q73 + 0.022 * y_x_by_q73) - strand_14_y
            * (layer_0_y_by_q73 + 0.022 * u_y_by_q73);
        const double t230 = 0.022 * y_z;
        const double strand_14_z = layer_0_z - t230;
        const double t231 = strand_14_x * strand_14_x + strand_14_y * strand_14_y + strand_14_z
            * strand_14_z;
        const double length_14 = sinew_sqrt(t231);
        const double t232 = 1.0 / length_14;
        const double length_14_by_q73 = (t229 + strand_14_z * (layer_0_z_by_q73 + 0.022
            * y_z_by_q73)) * t232;
        const double t233 = strand_14_x * (layer_0_x_by_q71 + t230) - strand_14_y * layer_0_y_by_q71
            - strand_14_z * (layer_0_z_by_q71 + t228);
        const double strand_13_x = layer_0_x - t104;
        const double strand_13_y = 0.02 + layer_0_y - t106;
        const double t234 = strand_13_x * (layer_0_x_by_q73 + t103) - strand_13_y
            * (layer_0_y_by_q73 + t105);
        const double strand_13_z = layer_0_z - t109;
        const double t235 = strand_13_x * strand_13_x + strand_13_y * strand_13_y + strand_13_z
            * strand_13_z;
        const double length_13 = sinew_sqrt(t235);
        const double t236 = 1.0 / length_13;
        const double length_13_by_q73 = (t234 + strand_13_z * (layer_0_z_by_q73 + t108)) * t236;
        const double t237 = strand_13_x * (layer_0_x_by_q71 + t109) - strand_13_y * layer_0_y_by_q71
            - strand_13_z * (layer_0_z_by_q71 + t104);
        const double strand_12_x = layer_0_x - t114;
        const double strand_12_y = 0.019 + layer_0_y - t116;
        const double t238 = strand_12_x * (layer_0_x_by_q73 + t113) - strand_12_y
            * (layer_0_y_by_q73 + t115);
        const double strand_12_z = layer_0_z - t119;
        const double t239 = strand_12_x * strand_12_x + strand_12_y * strand_12_y + strand_12_z
            * strand_12_z;
        const double length_12 = sinew_sqrt(t239);
        const double t240 = 1.0 / length_12;
        const double length_12_by_q73 = (t238 + strand_12_z * (layer_0_z_by_q73 + t118)) * t240;
        const double t241 = strand_12_x * (layer_0_x_by_q71 + t119) - strand_12_y * layer_0_y_by_q71
            - strand_12_z * (layer_0_z_by_q71 + t114);
        const double t242 = 0.017 * y_x;
        const double strand_11_x = layer_0_x - t242;
        const double strand_11_y = 0.017 + layer_0_y - 0.017 * u_y;
        const double t243 = strand_11_x * (layer_0_x_by_q73 + 0.017 * y_x_by_q73) - strand_11_y
            * (layer_0_y_by_q73 + 0.017 * u_y_by_q73);
        const double t244 = 0.017 * y_z;
        const double strand_11_z = layer_0_z - t244;
        const double t245 = strand_11_x * strand_11_x + strand_11_y * strand_11_y + strand_11_z
            * strand_11_z;
        const double length_11 = sinew_sqrt(t245);
        const double t246 = 1.0 / length_11;
        const double length_11_by_q73 = (t243 + strand_11_z * (layer_0_z_by_q73 + 0.017
            * y_z_by_q73)) * t246;
        const double t247 = strand_11_x * (layer_0_x_by_q71 + t244) - strand_11_y * layer_0_y_by_q71
            - strand_11_z * (layer_0_z_by_q71 + t242);
        const double strand_10_x = layer_0_x - t130;
        const double strand_10_y = 0.016 + layer_0_y - t132;
        const double t248 = strand_10_x * (layer_0_x_by_q73 + t129) - strand_10_y
            * (layer_0_y_by_q73 + t131);
        const double strand_10_z = layer_0_z - t135;
        const double t249 = strand_10_x * strand_10_x + strand_10_y * strand_10_y + strand_10_z
            * strand_10_z;
        const double length_10 = sinew_sqrt(t249);
        const double t250 = 1.0 / length_10;
        const double length_10_by_q73 = (t248 + strand_10_z * (layer_0_z_by_q73 + t134)) * t250;
        const double t251 = strand_10_x * (layer_0_x_by_q71 + t135) - strand_10_y * layer_0_y_by_q71
            - strand_10_z * (layer_0_z_by_q71 + t130);
        const double t252 = 0.014 * y_x;
        const double strand_9_x = layer_0_x - t252;
        const double strand_9_y = 0.014 + layer_0_y - 0.014 * u_y;
        const double t253 = strand_9_x * (layer_0_x_by_q73 + 0.014 * y_x_by_q73) - strand_9_y
            * (layer_0_y_by_q73 + 0.014 * u_y_by_q73);
        const double t254 = 0.014 * y_z;
        const double strand_9_z = layer_0_z - t254;
        const double t255 = strand_9_x * strand_9_x + strand_9_y * strand_9_y + strand_9_z
            * strand_9_z;
        const double length_9 = sinew_sqrt(t255);
        const double t256 = 1.0 / length_9;
        const double length_9_by_q73 = (t253 + strand_9_z * (layer_0_z_by_q73 + 0.014 * y_z_by_q73))
            * t256;
        const double t257 = strand_9_x * (layer_0_x_by_q71 + t254) - strand_9_y * layer_0_y_by_q71
            - strand_9_z * (layer_0_z_by_q71 + t252);
        const double strand_8_x = layer_0_x - t37;
        const double strand_8_y = 0.012 + layer_0_y - t45;
        const double t258 = strand_8_x * (layer_0_x_by_q73 + t29) - strand_8_y * (layer_0_y_by_q73
            + t41);
        const double strand_8_z = layer_0_z - t58;
        const double t259 = strand_8_x * strand_8_x + strand_8_y * strand_8_y + strand_8_z
            * strand_8_z;
        const double length_8 = sinew_sqrt(t259);
        const double t260 = 1.0 / length_8;
        const double length_8_by_q73 = (t258 + strand_8_z * (layer_0_z_by_q73 + t50)) * t260;
        const double t261 = strand_8_x * (layer_0_x_by_q71 + t58) - strand_8_y * layer_0_y_by_q71
            - strand_8_z * (layer_0_z_by_q71 + t37);
        const double strand_7_x = layer_0_x - t150;
        const double strand_7_y = 0.011 + layer_0_y - t152;
        const double t262 = strand_7_x * (layer_0_x_by_q73 + t149) - strand_7_y * (layer_0_y_by_q73
            + t151);
        const double strand_7_z = layer_0_z - t155;
        const double t263 = strand_7_x * strand_7_x + strand_7_y * strand_7_y + strand_7_z
            * strand_7_z;
        const double length_7 = sinew_sqrt(t263);
        const double t264 = 1.0 / length_7;
        const double length_7_by_q73 = (t262 + strand_7_z * (layer_0_z_by_q73 + t154)) * t264;
        const double t265 = strand_7_x * (layer_0_x_by_q71 + t155) - strand_7_y * layer_0_y_by_q71
            - strand_7_z * (layer_0_z_by_q71 + t150);
        const double t266 = 0.009 * y_x;
        const double strand_6_x = layer_0_x - t266;
        const double strand_6_y = 0.009 + layer_0_y - 0.009 * u_y;
        const double t267 = strand_6_x * (layer_0_x_by_q73 + 0.009 * y_x_by_q73) - strand_6_y
            * (layer_0_y_by_q73 + 0.009 * u_y_by_q73);
        const double t268 = 0.009 * y_z;
        const double strand_6_z = layer_0_z - t268;
        const double t269 = strand_6_x * strand_6_x + strand_6_y * strand_6_y + strand_6_z
            * strand_6_z;
        const double length_6 = sinew_sqrt(t269);
        const double t270 = 1.0 / length_6;
        const double length_6_by_q73 = (t267 + strand_6_z * (layer_0_z_by_q73 + 0.009 * y_z_by_q73))
            * t270;
        const double t271 = strand_6_x * (layer_0_x_by_q71 + t268) - strand_6_y * layer_0_y_by_q71
            - strand_6_z * (layer_0_z_by_q71 + t266);
        const double strand_5_x = layer_0_x - t166;
        const double strand_5_y = 0.008 + layer_0_y - t168;
        const double t272 = strand_5_x * (layer_0_x_by_q73 + t165) - strand_5_y * (layer_0_y_by_q73
            + t167);
        const double strand_5_z = layer_0_z - t171;
        const double t273 = strand_5_x * strand_5_x + strand_5_y * strand_5_y + strand_5_z
            * strand_5_z;
        const double length_5 = sinew_sqrt(t273);
        const double t274 = 1.0 / length_5;
        const double length_5_by_q73 = (t272 + strand_5_z * (layer_0_z_by_q73 + t170)) * t274;
        const double t275 = strand_5_x * (layer_0_x_by_q71 + t171) - strand_5_y * layer_0_y_by_q71
            - strand_5_z * (layer_0_z_by_q71 + t166);
        const double t276 = 0.006 * y_x;
        const double strand_4_x = layer_0_x - t276;
        const double strand_4_y = 0.006 + layer_0_y - 0.006 * u_y;
        const double t277 = strand_4_x * (layer_0_x_by_q73 + 0.006 * y_x_by_q73) - strand_4_y
            * (layer_0_y_by_q73 + 0.006 * u_y_by_q73);
        const double t278 = 0.006 * y_z;
        const double strand_4_z = layer_0_z - t278;
        const double t279 = strand_4_x * strand_4_x + strand_4_y * strand_4_y + strand_4_z
            * strand_4_z;
        const double length_4 = sinew_sqrt(t279);
        const double t280 = 1.0 / length_4;
        const double length_4_by_q73 = (t277 + strand_4_z * (layer_0_z_by_q73 + 0.006 * y_z_by_q73))
            * t280;
        const double t281 = strand_4_x * (layer_0_x_by_q71 + t278) - strand_4_y * layer_0_y_by_q71
            - strand_4_z * (layer_0_z_by_q71 + t276);
        const double strand_3_x = layer_0_x - t182;
        const double strand_3_y = 0.004 + layer_0_y - t184;
        const double t282 = strand_3_x * (layer_0_x_by_q73 + t181) - strand_3_y * (layer_0_y_by_q73
            + t183);
        const double strand_3_z = layer_0_z - t187;
        const double t283 = strand_3_x * strand_3_x + strand_3_y * strand_3_y + strand_3_z
            * strand_3_z;
        const double length_3 = sinew_sqrt(t283);
        const double t284 = 1.0 / length_3;
        const double length_3_by_q73 = (t282 + strand_3_z * (layer_0_z_by_q73 + t186)) * t284;
        const double t285 = strand_3_x * (layer_0_x_by_q71 + t187) - strand_3_y * layer_0_y_by_q71
            - strand_3_z * (layer_0_z_by_q71 + t182);
        const double strand_2_x = layer_0_x - t192;
        const double strand_2_y = 0.003 + layer_0_y - t194;
        const double t286 = strand_2_x * (layer_0_x_by_q73 + t191) - strand_2_y * (layer_0_y_by_q73
            + t193);
        const double strand_2_z = layer_0_z - t197;
        const double t287 = strand_2_x * strand_2_x + strand_2_y * strand_2_y + strand_2_z
            * strand_2_z;
        const double length_2 = sinew_sqrt(t287);
        const double t288 = 1.0 / length_2;
        const double length_2_by_q73 = (t286 + strand_2_z * (layer_0_z_by_q73 + t196)) * t288;
        const double t289 = strand_2_x * (layer_0_x_by_q71 + t197) - strand_2_y * layer_0_y_by_q71
            - strand_2_z * (layer_0_z_by_q71 + t192);
        const double t290 = 0.001 * y_x;
        const double strand_1_x = layer_0_x - t290;
        const double strand_1_y = 0.001 + layer_0_y - 0.001 * u_y;
        const double t291 = strand_1_x * (layer_0_x_by_q73 + 0.001 * y_x_by_q73) - strand_1_y
            * (layer_0_y_by_q73 + 0.001 * u_y_by_q73);
        const double t292 = 0.001 * y_z;
        const double strand_1_z = layer_0_z - t292;
        const double t293 = strand_1_x * strand_1_x + strand_1_y * strand_1_y + strand_1_z
            * strand_1_z;
        const double length_1 = sinew_sqrt(t293);
        const double t294 = 1.0 / length_1;
        const double length_1_by_q73 = (t291 + strand_1_z * (layer_0_z_by_q73 + 0.001 * y_z_by_q73))
            * t294;
        const double t295 = strand_1_x * (layer_0_x_by_q71 + t292) - strand_1_y * layer_0_y_by_q71
            - strand_1_z * (layer_0_z_by_q71 + t290);
        const double t296 = layer_0_x * layer_0_x_by_q73 - layer_0_y * layer_0_y_by_q73 + layer_0_z
            * layer_0_z_by_q73;
        const double length_0 = sinew_sqrt(layer_0_x * layer_0_x + layer_0_y * layer_0_y + layer_0_z
            * layer_0_z);
        const double t297 = 1.0 / length_0;
        const double t298 = layer_0_x * layer_0_x_by_q71 - layer_0_y * layer_0_y_by_q71 - layer_0_z
            * layer_0_z_by_q71;
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
        P[state] = t298 * t297;
        P[1 * n + state] = -(t296 * t297);
        P[2 * n + state] = t295 * t294;
        P[3 * n + state] = -length_1_by_q73;
        P[4 * n + state] = t289 * t288;
        P[5 * n + state] = -length_2_by_q73;
        P[6 * n + state] = t285 * t284;
        P[7 * n + state] = -length_3_by_q73;
        P[8 * n + state] = t281 * t280;
        P[9 * n + state] = -length_4_by_q73;
        P[10 * n + state] = t275 * t274;
        P[11 * n + state] = -length_5_by_q73;
        P[12 * n + state] = t271 * t270;
        P[13 * n + state] = -length_6_by_q73;
        P[14 * n + state] = t265 * t264;
        P[15 * n + state] = -length_7_by_q73;
        P[16 * n + state] = t261 * t260;
        P[17 * n + state] = -length_8_by_q73;
        P[18 * n + state] = t257 * t256;
        P[19 * n + state] = -length_9_by_q73;
        P[20 * n + state] = t251 * t250;
        P[21 * n + state] = -length_10_by_q73;
        P[22 * n + state] = t247 * t246;
        P[23 * n + state] = -length_11_by_q73;
        P[24 * n + state] = t241 * t240;
        P[25 * n + state] = -length_12_by_q73;
        P[26 * n + state] = t237 * t236;
        P[27 * n + state] = -length_13_by_q73;
        P[28 * n + state] = t233 * t232;
        P[29 * n + state] = -length_14_by_q73;
        P[30 * n + state] = t227 * t226;
        P[31 * n + state] = -length_15_by_q73;
        P[32 * n + state] = t223 * t222;
        P[33 * n + state] = -length_16_by_q73;
        P[34 * n + state] = t217 * t216;
        P[35 * n + state] = -length_17_by_q73;
        P[36 * n + state] = t213 * t212;
        P[37 * n + state] = -length_18_by_q73;
        P[38 * n + state] = t209 * t208;
        P[39 * n + state] = -(t207 * t208);
        P[40 * n + state] = t206 * t205;
        P[41 * n + state] = -length_20_by_q73;
        P[42 * n + state] = t200 * t199;
        P[43 * n + state] = -length_21_by_q73;
        P[44 * n + state] = t190 * t189;
        P[45 * n + state] = -length_22_by_q73;
        P[46 * n + state] = t180 * t179;
        P[47 * n + state] = -length_23_by_q73;
        P[48 * n + state] = t174 * t173;
        P[49 * n + state] = -length_24_by_q73;
        P[50 * n + state] = t164 * t163;
        P[51 * n + state] = -length_25_by_q73;
        P[52 * n + state] = t158 * t157;
        P[53 * n + state] = -length_26_by_q73;
        P[54 * n + state] = t148 * t147;
        P[55 * n + state] = -length_27_by_q73;
        P[56 * n + state] = t144 * t143;
        P[57 * n + state] = -length_28_by_q73;
        P[58 * n + state] = t138 * t137;
        P[59 * n + state] = -length_29_by_q73;
        P[60 * n + state] = t128 * t127;
        P[61 * n + state] = -length_30_by_q73;
        P[62 * n + state] = t122 * t121;
        P[63 * n + state] = -length_31_by_q73;
        P[64 * n + state] = t112 * t111;
        P[65 * n + state] = -length_32_by_q73;
        P[66 * n + state] = t102 * t101;
        P[67 * n + state] = -length_33_by_q73;
        P[68 * n + state] = t96 * t95;
        P[69 * n + state] = -length_34_by_q73;
        P[70 * n + state] = t86 * t85;
        P[71 * n + state] = -length_35_by_q73;
        P[72 * n + state] = t80 * t79;
        P[73 * n + state] = -length_36_by_q73;
        P[74 * n + state] = t70 * t61;
        P[75 * n + state] = -length_37_by_q73;
    }
}

void hand_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd,
    const double *SINEW_RESTRICT g, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        const double phi3_2 = q[5 * n + state] + q[6 * n + state];
        const double phi4_2 = q[7 * n + state] + phi3_2;
        const double phi3_4 = q[9 * n + state] + q[10 * n + state];
        const double phi4_4 = q[11 * n + state] + phi3_4;
        const double phi3_6 = q[13 * n + state] + q[14 * n + state];
        const double phi4_6 = phi3_6 + 1.2222222222222223 * q[14 * n + state];
        const double phi3_8 = q[16 * n + state] + q[17 * n + state];
        const double phi4_8 = phi3_8 + 1.2222222222222223 * q[17 * n + state];
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s4_2, c4_2;
        sinew_sincos(phi4_2, &s4_2, &c4_2);
        double s3_2, c3_2;
        sinew_sincos(phi3_2, &s3_2, &c3_2);
        double s2_2, c2_2;
        sinew_sincos(q[5 * n + state], &s2_2, &c2_2);
        double s1_2, c1_2;
        sinew_sincos(q[4 * n + state], &s1_2, &c1_2);
        double s4_4, c4_4;
        sinew_sincos(phi4_4, &s4_4, &c4_4);
        double s3_4, c3_4;
        sinew_sincos(phi3_4, &s3_4, &c3_4);
        double s2_4, c2_4;
        sinew_sincos(q[9 * n + state], &s2_4, &c2_4);
        double s1_4, c1_4;
        sinew_sincos(q[8 * n + state], &s1_4, &c1_4);
        double s4_6, c4_6;
        sinew_sincos(phi4_6, &s4_6, &c4_6);
        double s3_6, c3_6;
        sinew_sincos(phi3_6, &s3_6, &c3_6);
        double s2_6, c2_6;
        sinew_sincos(q[13 * n + state], &s2_6, &c2_6);
        double s1_6, c1_6;
        sinew_sincos(q[12 * n + state], &s1_6, &c1_6);
        double s4_8, c4_8;
        sinew_sincos(phi4_8, &s4_8, &c4_8);
        double s3_8, c3_8;
        sinew_sincos(phi3_8, &s3_8, &c3_8);
        double s2_8, c2_8;
        sinew_sincos(q[16 * n + state], &s2_8, &c2_8);
        double s1_8, c1_8;
        sinew_sincos(q[15 * n + state], &s1_8, &c1_8);
        const double a1x_8 = g[12 * n + state] * c1_8 + g[13 * n + state] * s1_8;
        const double w1zz_8 = qd[15 * n + state] * qd[15 * n + state];
        const double b2x_6 = a1x_8 + 0.0048 * w1zz_8;
        const double w2zz_8 = qd[16 * n + state] * qd[16 * n + state];
        const double e2x_8 = qdd[16 * n + state] * s2_8 + c2_8 * w2zz_8;
        const double a3x_8 = b2x_6 + 0.032304 * e2x_8;
        const double w3z_8 = qd[16 * n + state] + qd[17 * n + state];
        const double w3zz_8 = w3z_8 * w3z_8;
        const double al3z_8 = qdd[16 * n + state] + qdd[17 * n + state];
        const double e3x_8 = c3_8 * w3zz_8 + s3_8 * al3z_8;
        const double j4y1_8 = 1.234944e-05 * s4_8;
        const double e3y_8 = c3_8 * al3z_8 - s3_8 * w3zz_8;
        const double e2y_8 = qdd[16 * n + state] * c2_8 - s2_8 * w2zz_8;
        const double a3y_8 = g[14 * n + state] - 0.032304 * e2y_8;
        const double j4x1_8 = 1.234944e-05 * c4_8;
        const double al4z_8 = al3z_8 + 1.2222222222222223 * qdd[17 * n + state];
        const double n4_8 = 1.462099968e-07 * al4z_8 - j4x1_8 * (a3y_8 - 0.02384 * e3y_8) + j4y1_8
            * (a3x_8 + 0.02384 * e3x_8);
        const double j3x1_8 = 7.323648000000001e-05 * c3_8;
        const double j3y1_8 = 7.323648000000001e-05 * s3_8;
        const double t1 = 1.2222222222222223 * qd[17 * n + state];
        const double w4z_8 = w3z_8 + t1;
        const double w4zz_8 = w4z_8 * w4z_8;
        const double F4y_8 = 1.234944e-05 * (c4_8 * al4z_8 - s4_8 * w4zz_8);
        const double l4x_8 = 0.02384 * c3_8;
        const double t2 = n4_8 + 1.482612736e-06 * al3z_8 - j3x1_8 * a3y_8 + j3y1_8 * a3x_8 + l4x_8
            * F4y_8;
        const double e4x_8 = c4_8 * w4zz_8 + s4_8 * al4z_8;
        const double F4x_8 = 1.234944e-05 * e4x_8;
        const double l4y_8 = 0.02384 * s3_8;
        const double n3_8 = t2 + l4y_8 * F4x_8;
        const double j4yz_6 = 5.2855603200000006e-08 * s4_8;
        const double K3yz_6 = 2.2996254720000002e-07 * s3_8 + j4yz_6;
        const double l3x_8 = 0.032304 * c2_8;
        const double o4x_8 = l3x_8 + l4x_8;
        const double j4u_8 = 1.185619968e-07 * c4_8;
        const double K4yx_8 = s4_8 * j4u_8 + o4x_8 * j4y1_8;
        const double j3u_8 = 1.427316736e-06 * c3_8;
        const double K3yx_8 = s3_8 * j3u_8 + K4yx_8 + l3x_8 * j3y1_8 + l4y_8 * j4x1_8;
        const double t3_8 = n3_8 + qdd[15 * n + state] * K3yz_6 + w1zz_8 * K3yx_8;
        const double t4_8 = n4_8 + qdd[15 * n + state] * j4yz_6 + w1zz_8 * K4yx_8;
        const double j2x1_8 = 0.000223285248 * c2_8;
        const double t3 = n3_8 + 6.45303346786e-06 * qdd[16 * n + state] - g[14 * n + state]
            * j2x1_8;
        const double j2y1_8 = 0.000223285248 * s2_8;
        const double l3y_8 = 0.032304 * s2_8;
        const double n2_8 = t3 + b2x_6 * j2y1_8 + l3x_8 * (F4y_8 + 7.323648000000001e-05 * e3y_8)
            + l3y_8 * (F4x_8 + 7.323648000000001e-05 * e3x_8);
        const double j2u_8 = 6.37008946786e-06 * c2_8;
        const double S3x_8 = j3x1_8 + j4x1_8;
        const double K2yx_8 = s2_8 * j2u_8 + K3yx_8 + l3y_8 * S3x_8;
        const double t2_8 = n2_8 + qdd[15 * n + state] * (4.1084485632e-07 * s2_8 + K3yz_6) + w1zz_8
            * K2yx_8;
        const double R2yx_8 = qd[16 * n + state] * K2yx_8 + qd[17 * n + state] * K3yx_8 + t1
            * K4yx_8;
        const double w_2y_8 = qd[15 * n + state] + qd[15 * n + state];
        const double t4 = c2_8 * j2u_8 + c3_8 * j3u_8 + c4_8 * j4u_8 + o4x_8 * j4x1_8 + l3x_8
            * j3x1_8;
        const double t5 = qdd[15 * n + state] * (t4 + l4x_8 * j4x1_8 + l3x_8 * S3x_8
            + 4.3573002239999995e-07);
        const double t6 = t5 + 5.2855603200000006e-08 * e4x_8 + 2.2996254720000002e-07 * e3x_8
            + 4.1084485632e-07 * e2x_8;
        const double S2x_8 = j2x1_8 + S3x_8;
        const double a1y_8 = g[12 * n + state] * s1_8 - g[13 * n + state] * c1_8;
        const double t7 = t6 + (a1y_8 + 0.0048 * qdd[15 * n + state]) * S2x_8 - w_2y_8 * R2yx_8
            + 1.271808e-05 * a1x_8;
        const double S3y_8 = j3y1_8 + j4y1_8;
        const double R2y_8 = qd[16 * n + state] * (j2y1_8 + S3y_8) + qd[17 * n + state] * S3y_8 + t1
            * j4y1_8;
        const double P2z_8 = qdd[15 * n + state] * S2x_8 - w_2y_8 * R2y_8;
        const double N1z_8 = t7 + 4.66944e-05 * a1y_8 + 0.0048 * P2z_8;
        const double a1x_6 = g[9 * n + state] * c1_6 + g[10 * n + state] * s1_6;
        const double w1zz_6 = qd[12 * n + state] * qd[12 * n + state];
        const double b2x_4 = a1x_6 + 0.006 * w1zz_6;
        const double w2zz_6 = qd[13 * n + state] * qd[13 * n + state];
        const double e2x_6 = qdd[13 * n + state] * s2_6 + c2_6 * w2zz_6;
        const double a3x_6 = b2x_4 + 0.04038 * e2x_6;
        const double w3z_6 = qd[13 * n + state] + qd[14 * n + state];
        const double w3zz_6 = w3z_6 * w3z_6;
        const double al3z_6 = qdd[13 * n + state] + qdd[14 * n + state];
        const double e3x_6 = c3_6 * w3zz_6 + s3_6 * al3z_6;
        const double j4y1_6 = 3.015e-05 * s4_6;
        const double e3y_6 = c3_6 * al3z_6 - s3_6 * w3zz_6;
        const double e2y_6 = qdd[13 * n + state] * c2_6 - s2_6 * w2zz_6;
        const double a3y_6 = g[11 * n + state] - 0.04038 * e2y_6;
        const double j4x1_6 = 3.015e-05 * c4_6;
        const double al4z_6 = al3z_6 + 1.2222222222222223 * qdd[14 * n + state];
        const double n4_6 = 4.3101e-07 * al4z_6 - j4x1_6 * (a3y_6 - 0.0298 * e3y_6) + j4y1_6
            * (a3x_6 + 0.0298 * e3x_6);
        const double j3x1_6 = 0.0001788 * c3_6;
        const double j3y1_6 = 0.0001788 * s3_6;
        const double t8 = 1.2222222222222223 * qd[14 * n + state];
        const double w4z_6 = w3z_6 + t8;
        const double w4zz_6 = w4z_6 * w4z_6;
        const double F4y_6 = 3.015e-05 * (c4_6 * al4z_6 - s4_6 * w4zz_6);
        const double l4x_6 = 0.0298 * c3_6;
        const double t9 = n4_6 + 4.4942e-06 * al3z_6 - j3x1_6 * a3y_6 + j3y1_6 * a3x_6 + l4x_6
            * F4y_6;
        const double e4x_6 = c4_6 * w4zz_6 + s4_6 * al4z_6;
        const double F4x_6 = 3.015e-05 * e4x_6;
        const double l4y_6 = 0.0298 * s3_6;
        const double n3_6 = t9 + l4y_6 * F4x_6;
        const double j4yz_4 = 1.613025e-07 * s4_6;
        const double K3yz_4 = 7.0179e-07 * s3_6 + j4yz_4;
        const double l3x_6 = 0.04038 * c2_6;
        const double o4x_6 = l3x_6 + l4x_6;
        const double j4u_6 = 3.7701e-07 * c4_6;
        const double K4yx_6 = s4_6 * j4u_6 + o4x_6 * j4y1_6;
        const double j3u_6 = 4.3862e-06 * c3_6;
        const double K3yx_6 = s3_6 * j3u_6 + K4yx_6 + l3x_6 * j3y1_6 + l4y_6 * j4x1_6;
        const double t3_6 = n3_6 + qdd[12 * n + state] * K3yz_4 + w1zz_6 * K3yx_6;
        const double t4_6 = n4_6 + qdd[12 * n + state] * j4yz_4 + w1zz_6 * K4yx_6;
        const double j2x1_6 = 0.00054513 * c2_6;
        const double j2y1_6 = 0.00054513 * s2_6;
        const double t10 = n3_6 + 1.96475328e-05 * qdd[13 * n + state] - g[11 * n + state] * j2x1_6
            + b2x_4 * j2y1_6;
        const double l3y_6 = 0.04038 * s2_6;
        const double n2_6 = t10 + l3x_6 * (F4y_6 + 0.0001788 * e3y_6) + l3y_6 * (F4x_6 + 0.0001788
            * e3x_6);
        const double j2u_6 = 1.94855328e-05 * c2_6;
        const double S3x_6 = j3x1_6 + j4x1_6;
        const double K2yx_6 = s2_6 * j2u_6 + K3yx_6 + l3y_6 * S3x_6;
        const double t2_6 = n2_6 + qdd[12 * n + state] * (1.253799e-06 * s2_6 + K3yz_4) + w1zz_6
            * K2yx_6;
        const double R2yx_6 = qd[13 * n + state] * K2yx_6 + qd[14 * n + state] * K3yx_6 + t8
            * K4yx_6;
        const double w_2y_6 = qd[12 * n + state] + qd[12 * n + state];
        const double t11 = c2_6 * j2u_6 + c3_6 * j3u_6 + c4_6 * j4u_6 + o4x_6 * j4x1_6 + l3x_6
            * j3x1_6;
        const double t12 = qdd[12 * n + state] * (t11 + l4x_6 * j4x1_6 + l3x_6 * S3x_6
            + 1.1373675000000002e-06);
        const double S2x_6 = j2x1_6 + S3x_6;
        const double a1y_6 = g[9 * n + state] * s1_6 - g[10 * n + state] * c1_6;
        const double t13 = t12 + 1.613025e-07 * e4x_6 + 7.0179e-07 * e3x_6 + 1.253799e-06 * e2x_6
            + (a1y_6 + 0.006 * qdd[12 * n + state]) * S2x_6;
        const double S3y_6 = j3y1_6 + j4y1_6;
        const double R2y_6 = qd[13 * n + state] * (j2y1_6 + S3y_6) + qd[14 * n + state] * S3y_6 + t8
            * j4y1_6;
        const double P2z_6 = qdd[12 * n + state] * S2x_6 - w_2y_6 * R2y_6;
        const double N1z_6 = t13 - w_2y_6 * R2yx_6 + 3.105e-05 * a1x_6 + 0.000114 * a1y_6 + 0.006
            * P2z_6;
        const double a1x_4 = g[6 * n + state] * c1_4 + g[7 * n + state] * s1_4;
        const double w1zz_4 = qd[8 * n + state] * qd[8 * n + state];
        const double b2x_2 = a1x_4 + 0.00648 * w1zz_4;
        const double w2zz_4 = qd[9 * n + state] * qd[9 * n + state];
        const double e2x_4 = qdd[9 * n + state] * s2_4 + c2_4 * w2zz_4;
        const double a3x_4 = b2x_2 + 0.0436104 * e2x_4;
        const double w3z_4 = qd[9 * n + state] + qd[10 * n + state];
        const double w3zz_4 = w3z_4 * w3z_4;
        const double al3z_4 = qdd[9 * n + state] + qdd[10 * n + state];
        const double e3x_4 = c3_4 * w3zz_4 + s3_4 * al3z_4;
        const double j4y1_4 = 4.101874214400001e-05 * s4_4;
        const double e3y_4 = c3_4 * al3z_4 - s3_4 * w3zz_4;
        const double e2y_4 = qdd[9 * n + state] * c2_4 - s2_4 * w2zz_4;
        const double a3y_4 = g[8 * n + state] - 0.0436104 * e2y_4;
        const double j4x1_4 = 4.101874214400001e-05 * c4_4;
        const double al4z_4 = qdd[11 * n + state] + al3z_4;
        const double n4_4 = 6.27635460330976e-07 * al4z_4 - j4x1_4 * (a3y_4 - 0.032184 * e3y_4)
            + j4y1_4 * (a3x_4 + 0.032184 * e3x_4);
        const double j4yz_2 = 2.3700629210803204e-07 * s4_4;
        const double l4x_4 = 0.032184 * c3_4;
        const double l3x_4 = 0.0436104 * c2_4;
        const double o4x_4 = l3x_4 + l4x_4;
        const double j4u_4 = 5.59611012330976e-07 * c4_4;
        const double K4yx_4 = s4_4 * j4u_4 + o4x_4 * j4y1_4;
        const double t4_4 = n4_4 + qdd[8 * n + state] * j4yz_2 + w1zz_4 * K4yx_4;
        const double j3x1_4 = 0.000243255426048 * c3_4;
        const double j3y1_4 = 0.000243255426048 * s3_4;
        const double w4z_4 = qd[11 * n + state] + w3z_4;
        const double w4zz_4 = w4z_4 * w4z_4;
        const double F4y_4 = 4.101874214400001e-05 * (c4_4 * al4z_4 - s4_4 * w4zz_4);
        const double t14 = n4_4 + 6.592134974646623e-06 * al3z_4 - j3x1_4 * a3y_4 + j3y1_4 * a3x_4
            + l4x_4 * F4y_4;
        const double e4x_4 = c4_4 * w4zz_4 + s4_4 * al4z_4;
        const double F4x_4 = 4.101874214400001e-05 * e4x_4;
        const double l4y_4 = 0.032184 * s3_4;
        const double n3_4 = t14 + l4y_4 * F4x_4;
        const double K3yz_2 = 1.031159751017472e-06 * s3_4 + j4yz_2;
        const double j3u_4 = 6.456086078646624e-06 * c3_4;
        const double K3yx_4 = s3_4 * j3u_4 + K4yx_4 + l3x_4 * j3y1_4 + l4y_4 * j4x1_4;
        const double t3_4 = n3_4 + qdd[8 * n + state] * K3yz_2 + w1zz_4 * K3yx_4;
        const double j2x1_4 = 0.0007416433467648001 * c2_4;
        const double t15 = n3_4 + 2.8851692681126364e-05 * qdd[9 * n + state] - g[8 * n + state]
            * j2x1_4;
        const double j2y1_4 = 0.0007416433467648001 * s2_4;
        const double l3y_4 = 0.0436104 * s2_4;
        const double n2_4 = t15 + b2x_2 * j2y1_4 + l3x_4 * (F4y_4 + 0.000243255426048 * e3y_4)
            + l3y_4 * (F4x_4 + 0.000243255426048 * e3x_4);
        const double j2u_4 = 2.8647619337126362e-05 * c2_4;
        const double S3x_4 = j3x1_4 + j4x1_4;
        const double K2yx_4 = s2_4 * j2u_4 + K3yx_4 + l3y_4 * S3x_4;
        const double t2_4 = n2_4 + qdd[8 * n + state] * (1.8422420733637633e-06 * s2_4 + K3yz_2)
            + w1zz_4 * K2yx_4;
        const double R2yx_4 = qd[9 * n + state] * K2yx_4 + qd[10 * n + state] * K3yx_4 + qd[11 * n
            + state] * K4yx_4;
        const double w_2y_4 = qd[8 * n + state] + qd[8 * n + state];
        const double t16 = c2_4 * j2u_4 + c3_4 * j3u_4 + c4_4 * j4u_4 + o4x_4 * j4x1_4 + l3x_4
            * j3x1_4;
        const double t17 = qdd[8 * n + state] * (t16 + l4x_4 * j4x1_4 + l3x_4 * S3x_4
            + 1.599477303123424e-06);
        const double t18 = t17 + 2.3700629210803204e-07 * e4x_4 + 1.031159751017472e-06 * e3x_4
            + 1.8422420733637633e-06 * e2x_4;
        const double S2x_4 = j2x1_4 + S3x_4;
        const double a1y_4 = g[6 * n + state] * s1_4 - g[7 * n + state] * c1_4;
        const double t19 = t18 + (a1y_4 + 0.00648 * qdd[8 * n + state]) * S2x_4 - w_2y_4 * R2yx_4
            + 4.2243182208000006e-05 * a1x_4;
        const double S3y_4 = j3y1_4 + j4y1_4;
        const double R2y_4 = qd[9 * n + state] * (j2y1_4 + S3y_4) + qd[10 * n + state] * S3y_4
            + qd[11 * n + state] * j4y1_4;
        const double P2z_4 = qdd[8 * n + state] * S2x_4 - w_2y_4 * R2y_4;
        const double N1z_4 = t19 + 0.00015509574144 * a1y_4 + 0.00648 * P2z_4;
        const double a1x_2 = g[3 * n + state] * c1_2 + g[4 * n + state] * s1_2;
        const double w1zz_2 = qd[4 * n + state] * qd[4 * n + state];
        const double b2x = a1x_2 + 0.006 * w1zz_2;
        const double w2zz_2 = qd[5 * n + state] * qd[5 * n + state];
        const double e2x_2 = qdd[5 * n + state] * s2_2 + c2_2 * w2zz_2;
        const double a3x_2 = b2x + 0.04038 * e2x_2;
        const double w3z_2 = qd[5 * n + state] + qd[6 * n + state];
        const double w3zz_2 = w3z_2 * w3z_2;
        const double al3z_2 = qdd[5 * n + state] + qdd[6 * n + state];
        const double e3x_2 = c3_2 * w3zz_2 + s3_2 * al3z_2;
        const double j4y1_2 = 3.015e-05 * s4_2;
        const double e3y_2 = c3_2 * al3z_2 - s3_2 * w3zz_2;
        const double e2y_2 = qdd[5 * n + state] * c2_2 - s2_2 * w2zz_2;
        const double a3y_2 = g[5 * n + state] - 0.04038 * e2y_2;
        const double j4x1_2 = 3.015e-05 * c4_2;
        const double al4z_2 = qdd[7 * n + state] + al3z_2;
        const double n4_2 = 4.3101e-07 * al4z_2 - j4x1_2 * (a3y_2 - 0.0298 * e3y_2) + j4y1_2
            * (a3x_2 + 0.0298 * e3x_2);
        const double j4yz = 1.613025e-07 * s4_2;
        const double l4x_2 = 0.0298 * c3_2;
        const double l3x_2 = 0.04038 * c2_2;
        const double o4x_2 = l3x_2 + l4x_2;
        const double j4u_2 = 3.7701e-07 * c4_2;
        const double K4yx_2 = s4_2 * j4u_2 + o4x_2 * j4y1_2;
        const double t4_2 = n4_2 + qdd[4 * n + state] * j4yz + w1zz_2 * K4yx_2;
        const double j3x1_2 = 0.0001788 * c3_2;
        const double j3y1_2 = 0.0001788 * s3_2;
        const double w4z_2 = qd[7 * n + state] + w3z_2;
        const double w4zz_2 = w4z_2 * w4z_2;
        const double F4y_2 = 3.015e-05 * (c4_2 * al4z_2 - s4_2 * w4zz_2);
        const double t20 = n4_2 + 4.4942e-06 * al3z_2 - j3x1_2 * a3y_2 + j3y1_2 * a3x_2 + l4x_2
            * F4y_2;
        const double e4x_2 = c4_2 * w4zz_2 + s4_2 * al4z_2;
        const double F4x_2 = 3.015e-05 * e4x_2;
        const double l4y_2 = 0.0298 * s3_2;
        const double n3_2 = t20 + l4y_2 * F4x_2;
        const double K3yz = 7.0179e-07 * s3_2 + j4yz;
        const double j3u_2 = 4.3862e-06 * c3_2;
        const double K3yx_2 = s3_2 * j3u_2 + K4yx_2 + l3x_2 * j3y1_2 + l4y_2 * j4x1_2;
        const double t3_2 = n3_2 + qdd[4 * n + state] * K3yz + w1zz_2 * K3yx_2;
        const double j2x1_2 = 0.00054513 * c2_2;
        const double j2y1_2 = 0.00054513 * s2_2;
        const double t21 = n3_2 + 1.96475328e-05 * qdd[5 * n + state] - g[5 * n + state] * j2x1_2
            + b2x * j2y1_2;
        const double l3y_2 = 0.04038 * s2_2;
        const double n2_2 = t21 + l3x_2 * (F4y_2 + 0.0001788 * e3y_2) + l3y_2 * (F4x_2 + 0.0001788
            * e3x_2);
        const double j2u_2 = 1.94855328e-05 * c2_2;
        const double S3x_2 = j3x1_2 + j4x1_2;
        const double K2yx_2 = s2_2 * j2u_2 + K3yx_2 + l3y_2 * S3x_2;
        const double t2_2 = n2_2 + qdd[4 * n + state] * (1.253799e-06 * s2_2 + K3yz) + w1zz_2
            * K2yx_2;
        const double R2yx_2 = qd[5 * n + state] * K2yx_2 + qd[6 * n + state] * K3yx_2 + qd[7 * n
            + state] * K4yx_2;
        const double w_2y_2 = qd[4 * n + state] + qd[4 * n + state];
        const double t22 = c2_2 * j2u_2 + c3_2 * j3u_2 + c4_2 * j4u_2 + o4x_2 * j4x1_2 + l3x_2
            * j3x1_2;
        const double t23 = qdd[4 * n + state] * (t22 + l4x_2 * j4x1_2 + l3x_2 * S3x_2
            + 1.1373675000000002e-06);
        const double S2x_2 = j2x1_2 + S3x_2;
        const double a1y_2 = g[3 * n + state] * s1_2 - g[4 * n + state] * c1_2;
        const double t24 = t23 + 1.613025e-07 * e4x_2 + 7.0179e-07 * e3x_2 + 1.253799e-06 * e2x_2
            + (a1y_2 + 0.006 * qdd[4 * n + state]) * S2x_2;
        const double S3y_2 = j3y1_2 + j4y1_2;
        const double R2y_2 = qd[5 * n + state] * (j2y1_2 + S3y_2) + qd[6 * n + state] * S3y_2 + qd[7
            * n + state] * j4y1_2;
        const double P2z_2 = qdd[4 * n + state] * S2x_2 - w_2y_2 * R2y_2;
        const double N1z_2 = t24 - w_2y_2 * R2yx_2 + 3.105e-05 * a1x_2 + 0.000114 * a1y_2 + 0.006
            * P2z_2;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double al3z = qdd[1 * n + state] + qdd[2 * n + state];
        const double e3y = c3 * al3z - s3 * w3zz;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double a3y = g[2 * n + state] - 0.045 * (qdd[1 * n + state] * c2 - s2 * w2zz);
        const double j4x1 = 3.015e-05 * c4;
        const double al4z = qdd[3 * n + state] + al3z;
        const double a1x = g[state] * c1 + g[1 * n + state] * s1;
        const double a3x = a1x + 0.045 * (qdd[1 * n + state] * s2 + c2 * w2zz);
        const double e3x = c3 * w3zz + s3 * al3z;
        const double j4y1 = 3.015e-05 * s4;
        const double n4 = 4.3101e-07 * al4z - j4x1 * (a3y - 0.0298 * e3y) + j4y1 * (a3x + 0.0298
            * e3x);
        const double l4x = 0.0298 * c3;
        const double l3x = 0.045 * c2;
        const double o4x = l3x + l4x;
        const double j4u = 3.7701e-07 * s4;
        const double K4yx = c4 * j4u + o4x * j4y1;
        const double w1zz = qd[state] * qd[state];
        const double j3x1 = 0.0001788 * c3;
        const double j3y1 = 0.0001788 * s3;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double F4y = 3.015e-05 * (c4 * al4z - s4 * w4zz);
        const double F4x = 3.015e-05 * (c4 * w4zz + s4 * al4z);
        const double l4y = 0.0298 * s3;
        const double n3 = n4 + 4.4942e-06 * al3z - j3x1 * a3y + j3y1 * a3x + l4x * F4y + l4y * F4x;
        const double j3u = 4.3862e-06 * c3;
        const double K3yx = s3 * j3u + K4yx + l3x * j3y1 + l4y * j4x1;
        const double j2x1 = 0.0006075 * c2;
        const double t25 = n3 + 2.4381e-05 * qdd[1 * n + state] - g[2 * n + state] * j2x1 + a1x
            * 0.0006075 * s2;
        const double l3y = 0.045 * s2;
        const double n2 = t25 + l3x * (F4y + 0.0001788 * e3y) + l3y * (F4x + 0.0001788 * e3x);
        const double j2u = 2.4218999999999996e-05 * c2;
        const double S3x = j3x1 + j4x1;
        const double K2yx = s2 * j2u + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double t26 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + l4x * j4x1
            + l3x * S3x;
        const double t27 = qdd[state] * (t26 + 7.2501e-07) + (g[state] * s1 - g[1 * n + state] * c1)
            * (j2x1 + S3x);
        tau[state] = t27 - (qd[state] + qd[state]) * R2yx;
        tau[1 * n + state] = n2 + w1zz * K2yx;
        tau[2 * n + state] = n3 + w1zz * K3yx;
        tau[3 * n + state] = n4 + w1zz * K4yx;
        tau[4 * n + state] = N1z_2;
        tau[5 * n + state] = t2_2;
        tau[6 * n + state] = t3_2;
        tau[7 * n + state] = t4_2;
        tau[8 * n + state] = N1z_4;
        tau[9 * n + state] = t2_4;
        tau[10 * n + state] = t3_4;
        tau[11 * n + state] = t4_4;
        tau[12 * n + state] = N1z_6;
        tau[13 * n + state] = t2_6;
        tau[14 * n + state] = t3_6 + 1.2222222222222223 * t4_6;
        tau[15 * n + state] = N1z_8;
        tau[16 * n + state] = t2_8;
        tau[17 * n + state] = t3_8 + 1.2222222222222223 * t4_8;
    }
}
