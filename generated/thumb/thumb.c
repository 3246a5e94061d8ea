/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Thumb: tensegrity base with four straight tendons, hinge PIP and DIP
 *
 * Made by: sinew generate models/thumb
 * Model:   sha256 a1887dfbbeca57cfa47ae5f680c6749b28b13c33cd3d097b0d35ffdcc7f65850
 * Do not edit: change the model and generate again.
 */
#include "thumb.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

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

SINEW_NOT_INLINE static void thumb_part_1(const double h[SINEW_AT_LEAST(4)], double q10, double q11,
    double part[SINEW_AT_LEAST(10)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q10, q11);
    const double sin_q10 = sines1.s[0];
    const double cos_q10 = sines1.c[0];
    const double sin_q11 = sines1.s[1];
    const double cos_q11 = sines1.c[1];
    const double t2 = 0.006 * cos_q10;
    const double t3 = 0.03 - t2;
    const double t4 = 0.005 * sin_q11;
    const double t5 = 0.047 * cos_q11;
    const double along_2 = t4 - t5;
    const double t6 = sin_q10 * along_2;
    const double gap_y_6 = t3 - t6;
    const double t7 = 0.005 * cos_q11;
    const double t8 = 0.047 * sin_q11;
    const double up_2 = t7 + t8;
    const double gap_z_2 = 0.025 - up_2;
    const double t9 = gap_z_2 * gap_z_2;
    const double t10 = 0.006 * sin_q10;
    const double t11 = 0.002 - t10;
    const double t12 = cos_q10 * along_2;
    const double gap_x_6 = t11 + t12;
    const double stretch_6 = sinew_sqrt(t9 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
    const double error_6 = h[3] - stretch_6;
    const double t13 = error_6 * error_6;
    const double along = t4 + t5;
    const double t14 = sin_q10 * along;
    const double gap_y_4 = t3 + t14;
    const double up = t7 - t8;
    const double gap_z = 0.025 - up;
    const double t15 = gap_z * gap_z;
    const double t16 = cos_q10 * along;
    const double gap_x_4 = t11 - t16;
    const double stretch_4 = sinew_sqrt(t15 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
    const double error_4 = h[2] - stretch_4;
    const double t17 = error_4 * error_4;
    const double t18 = 0.002 + t10;
    const double gap_x = t18 - t16;
    const double gap_y = t3 - t14;
    const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t15);
    const double error = h[0] - stretch;
    const double t19 = error * error;
    const double gap_x_2 = t18 + t12;
    const double gap_y_2 = t3 + t6;
    const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t9);
    const double error_2 = h[1] - stretch_2;
    const double t20 = error_2 * error_2;
    const double gap_y_2_by_q11 = sin_q10 * up_2;
    const double t21 = along_2 * gap_z_2;
    const double gap_x_2_by_q11 = cos_q10 * up_2;
    const double t22 = 1.0 / stretch_6;
    const double stretch_6_by_q11 = (t21 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
        * t22;
    const double gap_y_by_q11 = sin_q10 * up;
    const double t23 = along * gap_z;
    const double gap_x_by_q11 = cos_q10 * up;
    const double t24 = 1.0 / stretch_4;
    const double stretch_4_by_q11 = (t23 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11) * t24;
    const double t25 = 1.0 / stretch;
    const double stretch_by_q11 = (t23 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t25;
    const double t26 = 1.0 / stretch_2;
    const double stretch_2_by_q11 = (t21 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
        * t26;
    const double t27 = stretch_by_q11 * error + stretch_2_by_q11 * error_2 + stretch_4_by_q11
        * error_4;
    const double stretch_6_by_q10 = (gap_x_6 * (t2 + t6) - gap_y_6 * (t10 - t12)) * t22;
    const double stretch_4_by_q10 = (gap_x_4 * (t2 - t14) - gap_y_4 * (t10 + t16)) * t24;
    const double stretch_by_q10 = (gap_x * (t2 + t14) + gap_y * (t10 - t16)) * t25;
    const double stretch_2_by_q10 = (gap_x_2 * (t2 - t6) + gap_y_2 * (t10 + t12)) * t26;
    const double t28 = stretch_by_q10 * stretch_by_q11 + stretch_2_by_q10 * stretch_2_by_q11
        - stretch_4_by_q10 * stretch_4_by_q11;
    const double H_01 = t28 - stretch_6_by_q10 * stretch_6_by_q11;
    const double t29 = stretch_by_q10 * error + stretch_2_by_q10 * error_2 - stretch_4_by_q10
        * error_4;
    const double t30 = stretch_by_q11 * stretch_by_q11 + stretch_2_by_q11 * stretch_2_by_q11
        + stretch_4_by_q11 * stretch_4_by_q11;
    const double H_11 = t30 + stretch_6_by_q11 * stretch_6_by_q11;
    const double t31 = stretch_by_q10 * stretch_by_q10 + stretch_2_by_q10 * stretch_2_by_q10
        + stretch_4_by_q10 * stretch_4_by_q10;
    const double H_00 = t31 + stretch_6_by_q10 * stretch_6_by_q10;
    part[0] = t13;
    part[1] = t17;
    part[2] = t19;
    part[3] = t20;
    part[4] = t19 + t20 + t17 + t13;
    part[5] = t27 + stretch_6_by_q11 * error_6;
    part[6] = H_01;
    part[7] = t29 - stretch_6_by_q10 * error_6;
    part[8] = H_11;
    part[9] = H_00;
}

void thumb_forward_kinematics(const double q[SINEW_AT_LEAST(4)], double T[SINEW_AT_LEAST(16)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
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
    const double R41y = c1 * c4;
    const double o4x = 0.045 * c2 + 0.0298 * c3;
    const double R42y = s1 * c4;
    T[0] = R41y;
    T[1] = -s1;
    T[2] = -(c1 * s4);
    T[3] = c1 * o4x + 0.0201 * R41y;
    T[4] = R42y;
    T[5] = c1;
    T[6] = -(s1 * s4);
    T[7] = s1 * o4x + 0.0201 * R42y;
    T[8] = s4;
    T[9] = 0.0;
    T[10] = c4;
    T[11] = 0.045 * s2 + 0.0298 * s3 + 0.0201 * s4;
    T[12] = 0.0;
    T[13] = 0.0;
    T[14] = 0.0;
    T[15] = 1.0;
}

void thumb_tip_jacobian(const double q[SINEW_AT_LEAST(4)], double J[SINEW_AT_LEAST(24)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const struct sinew_sines2 sines2 = sinew_one_sincos2(phi3, phi4);
    const double s3 = sines2.s[0];
    const double c3 = sines2.c[0];
    const double s4 = sines2.s[1];
    const double c4 = sines2.c[1];
    J[13] = s1;
    J[14] = s1;
    J[15] = s1;
    const double l3x = 0.045 * c2;
    const double o4x = l3x + 0.0298 * c3;
    const double p4y = s1 * o4x;
    const double ptipy = p4y + 0.0201 * s1 * c4;
    J[0] = -ptipy;
    const double l3y = 0.045 * s2;
    const double o4y = l3y + 0.0298 * s3;
    const double ptipz = o4y + 0.0201 * s4;
    J[1] = -(c1 * ptipz);
    const double arm3_4 = l3y - ptipz;
    J[2] = c1 * arm3_4;
    const double arm4_4 = o4y - ptipz;
    J[3] = c1 * arm4_4;
    const double p4x = c1 * o4x;
    const double ptipx = p4x + 0.0201 * c1 * c4;
    J[4] = ptipx;
    J[5] = -(s1 * ptipz);
    J[6] = s1 * arm3_4;
    J[7] = s1 * arm4_4;
    J[8] = 0.0;
    J[16] = 0.0;
    J[9] = c1 * ptipx + s1 * ptipy;
    J[10] = -(c1 * (c1 * l3x - ptipx) + s1 * (s1 * l3x - ptipy));
    J[11] = -(c1 * (p4x - ptipx) + s1 * (p4y - ptipy));
    J[12] = 0.0;
    const double t3 = -c1;
    J[17] = t3;
    J[18] = t3;
    J[19] = t3;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = 0.0;
    J[20] = 1.0;
}

void thumb_mass_matrix(const double q[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double t3 = c2 * (2.4218999999999996e-05 * c2) + c3 * (4.3862e-06 * c3) - s4 * (3.7701e-07
        * s4);
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double j4x1 = 3.015e-05 * c4;
    const double j3x1 = 0.0001788 * c3;
    const double t4 = l4x * j4x1;
    const double t5 = l3x * (j3x1 + j4x1);
    const double Z1 = t3 + (l3x + l4x) * j4x1 + l3x * j3x1 + t4 + t5 + 7.250099999999999e-07;
    const double j4y1 = 3.015e-05 * s4;
    const double l3y = 0.045 * s2;
    const double lS3 = t5 + l3y * (0.0001788 * s3 + j4y1);
    const double lS4 = t4 + 0.0298 * s3 * j4y1;
    const double Z3 = 4.92521e-06 + (lS4 + lS4);
    const double M_4 = Z3 + lS3;
    const double M_2 = 4.3101e-07 + lS4;
    const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
    M[0] = Z1;
    M[1] = 0.0;
    M[2] = 0.0;
    M[3] = 0.0;
    M[4] = 0.0;
    M[5] = 2.4381e-05 + Z3 + (lS3 + lS3);
    M[6] = M_4;
    M[7] = M_2_2;
    M[8] = 0.0;
    M[9] = M_4;
    M[10] = Z3;
    M[11] = M_2;
    M[12] = 0.0;
    M[13] = M_2_2;
    M[14] = M_2;
    M[15] = 4.3101e-07;
}

void thumb_coriolis_matrix(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    double C[SINEW_AT_LEAST(16)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double j4y1 = 3.015e-05 * s4;
    const double K4yx = c4 * 3.7701e-07 * s4 + (l3x + l4x) * j4y1;
    const double j3y1 = 0.0001788 * s3;
    const double j4x1 = 3.015e-05 * c4;
    const double l4y = 0.0298 * s3;
    const double t3 = l4y * j4x1;
    const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + l3x * j3y1 + t3;
    const double j3x1 = 0.0001788 * c3;
    const double l3y = 0.045 * s2;
    const double t4 = l3y * (j3x1 + j4x1);
    const double K2yx = s2 * 2.4218999999999996e-05 * c2 + K3yx + t4;
    const double E2wQxx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double cD2y = qd[0] * K2yx;
    const double cD3y = qd[0] * K3yx;
    const double cD4y = qd[0] * K4yx;
    const double w3z = qd[1] + qd[2];
    const double w4z = qd[3] + w3z;
    const double G4y = j4y1 * w4z;
    const double G4x = j4x1 * w4z;
    const double C_2 = l4x * G4y - l4y * G4x;
    const double C_3 = w3z * (l4x * j4y1 - t3);
    const double Y3 = C_2 - C_3;
    const double C_8 = Y3 - qd[1] * (l3x * (j3y1 + j4y1) - t4);
    const double t5 = l3x * (G4y + j3y1 * w3z);
    const double t6 = l3y * (G4x + j3x1 * w3z);
    C[0] = -E2wQxx;
    C[1] = -cD2y;
    C[2] = -cD3y;
    C[3] = -cD4y;
    C[4] = cD2y;
    C[5] = -(C_8 + t5 - t6);
    C[6] = -(Y3 + t5 - t6);
    C[7] = -(C_2 + l3x * G4y - l3y * G4x);
    C[8] = cD3y;
    C[9] = -C_8;
    C[10] = -Y3;
    C[11] = -C_2;
    C[12] = cD4y;
    C[13] = C_3 + qd[1] * (l3x * j4y1 - l3y * j4x1);
    C[14] = C_3;
    C[15] = 0.0;
}

void thumb_gravity(const double q[SINEW_AT_LEAST(4)], double g[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[3] + phi3, phi3);
    const double c4 = sines1.c[0];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines4 = sinew_one_sincos(q[1]);
    const double c2 = sines4.c[0];
    const double n4 = 0.0002957715 * c4;
    const double n3 = n4 + 0.0017540280000000001 * c3;
    g[0] = 0.0;
    g[1] = n3 + 0.005959575 * c2;
    g[2] = n3;
    g[3] = n4;
}

void thumb_bias(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    double h[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double j4y1 = 3.015e-05 * s4;
    const double K4yx = c4 * 3.7701e-07 * s4 + (l3x + l4x) * j4y1;
    const double t3 = l3x * (0.0001788 * s3);
    const double j4x1 = 3.015e-05 * c4;
    const double t4 = 0.0298 * s3 * j4x1;
    const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + t3 + t4;
    const double j3x1 = 0.0001788 * c3;
    const double l3y = 0.045 * s2;
    const double K2yx = s2 * 2.4218999999999996e-05 * c2 + K3yx + l3y * (j3x1 + j4x1);
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double w2zz = qd[1] * qd[1];
    const double X3_4 = l4x * j4y1 - t4;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = t3 - l3y * j3x1;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double n2 = n3 + 0.005959575 * c2 - w3zz * X2_3 - w4zz * X2_4;
    const double w1zz = qd[0] * qd[0];
    h[0] = -((qd[0] + qd[0]) * R2yx);
    h[1] = n2 + w1zz * K2yx;
    h[2] = n3 + w1zz * K3yx;
    h[3] = n4 + w1zz * K4yx;
}

void thumb_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(4)],
    const double qd[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)], double h[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double j3u = 4.3862e-06 * c3;
    const double j2u = 2.4218999999999996e-05 * c2;
    const double j4u = 3.7701e-07 * s4;
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double o4x = l3x + l4x;
    const double j4x1 = 3.015e-05 * c4;
    const double j3x1 = 0.0001788 * c3;
    const double t3 = l4x * j4x1;
    const double S3x = j3x1 + j4x1;
    const double t4 = l3x * S3x;
    const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t3 + t4
        + 7.250099999999999e-07;
    M[0] = Z1;
    M[1] = 0.0;
    M[2] = 0.0;
    M[3] = 0.0;
    M[4] = 0.0;
    const double j4y1 = 3.015e-05 * s4;
    const double j3y1 = 0.0001788 * s3;
    const double l3y = 0.045 * s2;
    const double lS3 = t4 + l3y * (j3y1 + j4y1);
    const double l4y = 0.0298 * s3;
    const double lS4 = t3 + l4y * j4y1;
    const double Z3 = 4.92521e-06 + (lS4 + lS4);
    M[10] = Z3;
    M[5] = 2.4381e-05 + Z3 + (lS3 + lS3);
    const double M_4 = Z3 + lS3;
    M[6] = M_4;
    M[9] = M_4;
    const double M_2 = 4.3101e-07 + lS4;
    M[11] = M_2;
    M[12] = 0.0;
    M[14] = M_2;
    M[15] = 4.3101e-07;
    const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
    M[7] = M_2_2;
    M[8] = 0.0;
    M[13] = M_2_2;
    const double K4yx = c4 * j4u + o4x * j4y1;
    const double t5 = l3x * j3y1;
    const double t6 = l4y * j4x1;
    const double K3yx = s3 * j3u + K4yx + t5 + t6;
    const double K2yx = s2 * j2u + K3yx + l3y * S3x;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    h[0] = -((qd[0] + qd[0]) * R2yx);
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double w2zz = qd[1] * qd[1];
    const double X3_4 = l4x * j4y1 - t6;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = t5 - l3y * j3x1;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double n2 = n3 + 0.005959575 * c2 - w3zz * X2_3 - w4zz * X2_4;
    const double w1zz = qd[0] * qd[0];
    h[1] = n2 + K2yx * w1zz;
    h[2] = n3 + K3yx * w1zz;
    h[3] = n4 + K4yx * w1zz;
}

void thumb_forward_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    const double tau[SINEW_AT_LEAST(4)], double qdd[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double o4x = l3x + l4x;
    const double j4y1 = 3.015e-05 * s4;
    const double j4u = 3.7701e-07 * s4;
    const double K4yx = c4 * j4u + o4x * j4y1;
    const double j3u = 4.3862e-06 * c3;
    const double j3y1 = 0.0001788 * s3;
    const double t3 = l3x * j3y1;
    const double j4x1 = 3.015e-05 * c4;
    const double l4y = 0.0298 * s3;
    const double t4 = l4y * j4x1;
    const double K3yx = s3 * j3u + K4yx + t3 + t4;
    const double j2u = 2.4218999999999996e-05 * c2;
    const double j3x1 = 0.0001788 * c3;
    const double S3x = j3x1 + j4x1;
    const double l3y = 0.045 * s2;
    const double K2yx = s2 * j2u + K3yx + l3y * S3x;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double t5 = l4x * j4x1;
    const double t6 = l3x * S3x;
    const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t5 + t6
        + 7.250099999999999e-07;
    const double x1 = (tau[0] + (qd[0] + qd[0]) * R2yx) * (1.0 / Z1);
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double w2zz = qd[1] * qd[1];
    const double X3_4 = l4x * j4y1 - t4;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = t3 - l3y * j3x1;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double w1zz = qd[0] * qd[0];
    const double y4 = tau[3] - n4 - K4yx * w1zz;
    const double lS4 = t5 + l4y * j4y1;
    const double M = 4.3101e-07 + lS4;
    const double L4_3 = 2320131.783485302 * M;
    const double b3 = tau[2] - n3 - K3yx * w1zz - y4 * L4_3;
    const double Z3 = 4.92521e-06 + (lS4 + lS4);
    const double lS3 = t6 + l3y * (j3y1 + j4y1);
    const double M_2 = M + l3x * j4x1 + l3y * j4y1;
    const double A3_2 = Z3 + lS3 - M_2 * L4_3;
    const double r3 = 1.0 / (Z3 - M * L4_3);
    const double L3_2 = A3_2 * r3;
    const double L4_2 = 2320131.783485302 * M_2;
    const double t7 = tau[1] - n3 - 0.005959575 * c2 + w3zz * X2_3 + w4zz * X2_4 - K2yx * w1zz - y4
        * L4_2;
    const double A2_2 = 2.4381e-05 + Z3 + (lS3 + lS3) - M_2 * L4_2;
    const double x2 = (t7 - b3 * L3_2) * (1.0 / (A2_2 - A3_2 * L3_2));
    const double x3 = b3 * r3 - L3_2 * x2;
    const double x4 = 2320131.783485302 * y4 - L4_3 * x3 - L4_2 * x2;
    qdd[0] = x1;
    qdd[1] = x2;
    qdd[2] = x3;
    qdd[3] = x4;
}

void thumb_inverse_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    const double qdd[SINEW_AT_LEAST(4)], double tau[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double l4x = 0.0298 * c3;
    const double l3x = 0.045 * c2;
    const double o4x = l3x + l4x;
    const double j4y1 = 3.015e-05 * s4;
    const double j4u = 3.7701e-07 * s4;
    const double K4yx = c4 * j4u + o4x * j4y1;
    const double j3u = 4.3862e-06 * c3;
    const double j3y1 = 0.0001788 * s3;
    const double t3 = l3x * j3y1;
    const double j4x1 = 3.015e-05 * c4;
    const double l4y = 0.0298 * s3;
    const double t4 = l4y * j4x1;
    const double K3yx = s3 * j3u + K4yx + t3 + t4;
    const double j2u = 2.4218999999999996e-05 * c2;
    const double j3x1 = 0.0001788 * c3;
    const double S3x = j3x1 + j4x1;
    const double l3y = 0.045 * s2;
    const double K2yx = s2 * j2u + K3yx + l3y * S3x;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double t5 = l3x * j3x1;
    const double t6 = l4x * j4x1;
    const double t7 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + t5 + t6 + l3x * S3x
        + 7.2501e-07;
    const double D2_4 = l3x * j4x1 + l3y * j4y1;
    const double al3z = qdd[1] + qdd[2];
    const double al4z = qdd[3] + al3z;
    const double lS4 = t6 + l4y * j4y1;
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double w2zz = qd[1] * qd[1];
    const double t8 = 4.3101e-07 * al4z + 9.81 * j4x1 + qdd[1] * D2_4 + lS4 * al3z + w2zz * X2_4;
    const double X3_4 = l4x * j4y1 - t4;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double n4 = t8 + w3zz * X3_4;
    const double D2_3 = t5 + l3y * j3y1;
    const double X2_3 = t3 - l3y * j3x1;
    const double t9 = n4 + 4.4942e-06 * al3z + 9.81 * j3x1 + qdd[1] * D2_3 + lS4 * al4z + w2zz
        * X2_3;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double n3 = t9 - w4zz * X3_4;
    const double t10 = n3 + 2.4381e-05 * qdd[1] + 0.005959575 * c2 + al3z * D2_3 - w3zz * X2_3
        + al4z * D2_4;
    const double w1zz = qd[0] * qd[0];
    tau[0] = qdd[0] * t7 - (qd[0] + qd[0]) * R2yx;
    tau[1] = t10 - w4zz * X2_4 + w1zz * K2yx;
    tau[2] = n3 + w1zz * K3yx;
    tau[3] = n4 + w1zz * K4yx;
}

void thumb_tendon_lengths(const double q[SINEW_AT_LEAST(4)], double h[SINEW_AT_LEAST(8)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const double t2 = 0.005 * (c1 * s2);
    const double t3 = 0.006 * s1;
    const double t4 = t2 - t3;
    const double t5 = 0.047 * (c1 * c2);
    const double A_lengthdx = 0.002 - t4 - t5;
    const double t6 = 0.005 * (s1 * s2);
    const double t7 = 0.006 * c1;
    const double t8 = 0.03 - (t6 + t7);
    const double t9 = 0.047 * (s1 * c2);
    const double A_lengthdy = t8 - t9;
    const double t10 = 0.025 - 0.005 * c2;
    const double t11 = 0.047 * s2;
    const double A_lengthdz = t10 + t11;
    const double t12 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t12);
    const double t13 = t2 + t3;
    const double B_lengthdx = 0.002 + t13 - t5;
    const double t14 = 0.03 + (t6 - t7);
    const double B_lengthdy = t14 - t9;
    const double B_lengthdz = t10 - t11;
    const double t15 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t15);
    const double C_lengthdx = 0.002 - t13 - t5;
    const double C_lengthdy = t14 + t9;
    const double C_length = sinew_sqrt(t12 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double D_lengthdx = 0.002 + t4 - t5;
    const double D_lengthdy = t8 + t9;
    const double D_length = sinew_sqrt(t15 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t16 = 0.0065 * q[2];
    const double t17 = 0.0055 * q[3] - t16;
    h[0] = A_length;
    h[1] = B_length;
    h[2] = C_length;
    h[3] = D_length;
    h[4] = t16;
    h[5] = -t16;
    h[6] = t17;
    h[7] = -t17;
}

void thumb_coupling_matrix(const double q[SINEW_AT_LEAST(4)], double P[SINEW_AT_LEAST(32)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const double R21x = c1 * c2;
    const double t2 = 0.047 * R21x;
    const double t3 = 0.006 * s1;
    const double R21y = c1 * s2;
    const double t4 = 0.005 * R21y;
    const double t5 = t4 - t3;
    const double pA_length_tox = t5 + t2;
    const double R22x = s1 * c2;
    const double t6 = 0.047 * R22x;
    const double t7 = 0.006 * c1;
    const double R22y = s1 * s2;
    const double t8 = 0.005 * R22y;
    const double t9 = t8 + t7;
    const double pA_length_toy = t9 + t6;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double t10 = 0.047 * s2;
    const double t11 = 0.025 - 0.005 * c2;
    const double A_lengthdz = t11 + t10;
    const double t12 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t12);
    const double t13 = 1.0 / A_length;
    const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t13;
    P[0] = -A_length_by_q0;
    const double t14 = 0.005 * s2;
    const double t15 = 0.047 * c2;
    const double t16 = A_lengthdz * (t14 + t15);
    const double t17 = 0.005 * R21x;
    const double t18 = 0.047 * R21y;
    const double pA_length_tox_by_q1 = t17 - t18;
    const double t19 = 0.005 * R22x;
    const double t20 = 0.047 * R22y;
    const double pA_length_toy_by_q1 = t19 - t20;
    const double t21 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t16;
    P[1] = -(t21 * t13);
    P[2] = 0.0;
    P[3] = 0.0;
    const double t22 = t4 + t3;
    const double pB_length_tox = t22 - t2;
    const double t23 = t8 - t7;
    const double pB_length_toy = t23 - t6;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double B_lengthdz = t11 - t10;
    const double t24 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t24);
    const double t25 = 1.0 / B_length;
    const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t25;
    P[4] = B_length_by_q0;
    const double t26 = B_lengthdz * (t14 - t15);
    const double pB_length_tox_by_q1 = t17 + t18;
    const double pB_length_toy_by_q1 = t19 + t20;
    const double t27 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t26;
    P[5] = t27 * t25;
    P[6] = 0.0;
    P[7] = 0.0;
    const double pC_length_tox = t22 + t2;
    const double pC_length_toy = t23 + t6;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double C_length = sinew_sqrt(t12 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t28 = 1.0 / C_length;
    const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t28;
    P[8] = C_length_by_q0;
    const double t29 = t16 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
    P[9] = t29 * t28;
    P[10] = 0.0;
    P[11] = 0.0;
    const double pD_length_tox = t5 - t2;
    const double pD_length_toy = t9 - t6;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double D_length = sinew_sqrt(t24 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t30 = 1.0 / D_length;
    const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t30;
    P[12] = -D_length_by_q0;
    const double t31 = t26 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
    P[13] = t31 * t30;
    P[14] = 0.0;
    P[15] = 0.0;
    P[16] = 0.0;
    P[17] = 0.0;
    P[19] = 0.0;
    P[20] = 0.0;
    P[21] = 0.0;
    P[23] = 0.0;
    P[24] = 0.0;
    P[25] = 0.0;
    P[28] = 0.0;
    P[29] = 0.0;
    P[18] = 0.0065;
    P[30] = 0.0065;
    P[22] = -0.0065;
    P[26] = -0.0065;
    P[27] = 0.0055;
    P[31] = -0.0055;
}

void thumb_joint_torque(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)],
    double tau[SINEW_AT_LEAST(4)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const double R21x = c1 * c2;
    const double t2 = 0.047 * R21x;
    const double t3 = 0.006 * s1;
    const double R21y = c1 * s2;
    const double t4 = 0.005 * R21y;
    const double t5 = t4 - t3;
    const double pD_length_tox = t5 - t2;
    const double R22x = s1 * c2;
    const double t6 = 0.047 * R22x;
    const double t7 = 0.006 * c1;
    const double R22y = s1 * s2;
    const double t8 = 0.005 * R22y;
    const double t9 = t8 + t7;
    const double pD_length_toy = t9 - t6;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double t10 = 0.047 * s2;
    const double t11 = 0.025 - 0.005 * c2;
    const double B_lengthdz = t11 - t10;
    const double t12 = B_lengthdz * B_lengthdz;
    const double D_length = sinew_sqrt(t12 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t13 = 1.0 / D_length;
    const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t13;
    const double t14 = t4 + t3;
    const double pC_length_tox = t14 + t2;
    const double t15 = t8 - t7;
    const double pC_length_toy = t15 + t6;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double A_lengthdz = t11 + t10;
    const double t16 = A_lengthdz * A_lengthdz;
    const double C_length = sinew_sqrt(t16 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t17 = 1.0 / C_length;
    const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t17;
    const double pA_length_tox = t5 + t2;
    const double pA_length_toy = t9 + t6;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t16);
    const double t18 = 1.0 / A_length;
    const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t18;
    const double pB_length_tox = t14 - t2;
    const double pB_length_toy = t15 - t6;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t12);
    const double t19 = 1.0 / B_length;
    const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t19;
    const double t20 = f[0] * A_length_by_q0 - f[1] * B_length_by_q0 - f[2] * C_length_by_q0 + f[3]
        * D_length_by_q0;
    const double t21 = 0.005 * R22x;
    const double t22 = 0.047 * R22y;
    const double pB_length_toy_by_q1 = t21 + t22;
    const double t23 = 0.005 * s2;
    const double t24 = 0.047 * c2;
    const double t25 = B_lengthdz * (t23 - t24);
    const double t26 = 0.005 * R21x;
    const double t27 = 0.047 * R21y;
    const double pB_length_tox_by_q1 = t26 + t27;
    const double t28 = t25 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
    const double pA_length_toy_by_q1 = t21 - t22;
    const double t29 = A_lengthdz * (t23 + t24);
    const double pA_length_tox_by_q1 = t26 - t27;
    const double t30 = t29 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
    const double t31 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t29;
    const double t32 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t25;
    const double t33 = f[0] * (t31 * t18) - f[1] * (t32 * t19) - f[2] * (t30 * t17) - f[3] * (t28
        * t13);
    tau[0] = t20;
    tau[1] = t33;
    tau[2] = -(0.0065 * (f[4] - f[5] - f[6] + f[7]));
    tau[3] = -(0.0055 * (f[6] - f[7]));
}

void thumb_joint_stiffness(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)],
    const double kt[SINEW_AT_LEAST(8)], double K[SINEW_AT_LEAST(16)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const double t2 = 0.0065 * kt[6] + 0.0065 * kt[7];
    const double t3 = -(0.0055 * t2);
    const double K3_3 = 4.225e-05 * (kt[4] + kt[5]) + 0.0065 * t2;
    const double R21y = c1 * s2;
    const double t4 = 0.005 * R21y;
    const double t5 = 0.006 * s1;
    const double t6 = t4 - t5;
    const double R21x = c1 * c2;
    const double t7 = 0.047 * R21x;
    const double pA_length_tox = t6 + t7;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double R22y = s1 * s2;
    const double t8 = 0.005 * R22y;
    const double t9 = 0.006 * c1;
    const double t10 = t8 + t9;
    const double R22x = s1 * c2;
    const double t11 = 0.047 * R22x;
    const double pA_length_toy = t10 + t11;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double t12 = 0.005 * c2;
    const double t13 = 0.047 * s2;
    const double pA_length_toz = t12 - t13;
    const double A_lengthdz = 0.025 - pA_length_toz;
    const double t14 = A_lengthdz * A_lengthdz;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t14);
    const double t15 = 1.0 / A_length;
    const double t16 = 0.005 * R21x;
    const double t17 = 0.047 * R21y;
    const double pA_length_tox_by_q1 = t16 - t17;
    const double t18 = 0.005 * R22x;
    const double t19 = 0.047 * R22y;
    const double pA_length_toy_by_q1 = t18 - t19;
    const double t20 = 0.005 * s2;
    const double t21 = 0.047 * c2;
    const double pA_length_toz_by_q1 = t20 + t21;
    const double t22 = A_lengthdz * pA_length_toz_by_q1;
    const double t23 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t22;
    const double A_length_by_q1 = t23 * t15;
    const double pA_length_tox_by_q1_2_by_q1 = t4 + t7;
    const double t24 = pA_length_toz * A_lengthdz;
    const double pA_length_toy_by_q1_2_by_q1 = t8 + t11;
    const double t25 = t24 + A_lengthdx * pA_length_tox_by_q1_2_by_q1 + A_lengthdy
        * pA_length_toy_by_q1_2_by_q1;
    const double t26 = pA_length_tox_by_q1 * pA_length_tox_by_q1;
    const double t27 = pA_length_toy_by_q1 * pA_length_toy_by_q1;
    const double t28 = pA_length_toz_by_q1 * pA_length_toz_by_q1;
    const double A_length_by_q1_2_by_q1 = (t25 + t26 + t27 + t28 - A_length_by_q1 * A_length_by_q1)
        * t15;
    const double t29 = t4 + t5;
    const double pB_length_tox = t29 - t7;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double t30 = t8 - t9;
    const double pB_length_toy = t30 - t11;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double pB_length_toz = t12 + t13;
    const double B_lengthdz = 0.025 - pB_length_toz;
    const double t31 = B_lengthdz * B_lengthdz;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t31);
    const double t32 = 1.0 / B_length;
    const double pB_length_tox_by_q1 = t16 + t17;
    const double pB_length_toy_by_q1 = t18 + t19;
    const double pB_length_toz_by_q1 = t20 - t21;
    const double t33 = B_lengthdz * pB_length_toz_by_q1;
    const double t34 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t33;
    const double B_length_by_q1 = t34 * t32;
    const double pB_length_tox_by_q1_2_by_q1 = t4 - t7;
    const double t35 = pB_length_toz * B_lengthdz;
    const double pB_length_toy_by_q1_2_by_q1 = t8 - t11;
    const double t36 = t35 - B_lengthdx * pB_length_tox_by_q1_2_by_q1 - B_lengthdy
        * pB_length_toy_by_q1_2_by_q1;
    const double t37 = pB_length_tox_by_q1 * pB_length_tox_by_q1;
    const double t38 = pB_length_toy_by_q1 * pB_length_toy_by_q1;
    const double t39 = pB_length_toz_by_q1 * pB_length_toz_by_q1;
    const double B_length_by_q1_2_by_q1 = (t36 + t37 + t38 + t39 - B_length_by_q1 * B_length_by_q1)
        * t32;
    const double pC_length_tox = t29 + t7;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double pC_length_toy = t30 + t11;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double C_length = sinew_sqrt(t14 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t40 = 1.0 / C_length;
    const double t41 = t22 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
    const double C_length_by_q1 = t41 * t40;
    const double t42 = t24 + C_lengthdx * pA_length_tox_by_q1_2_by_q1 - C_lengthdy
        * pA_length_toy_by_q1_2_by_q1;
    const double C_length_by_q1_2_by_q1 = (t42 + t26 + t27 + t28 - C_length_by_q1 * C_length_by_q1)
        * t40;
    const double t43 = f[0] * A_length_by_q1_2_by_q1 + f[1] * B_length_by_q1_2_by_q1 + f[2]
        * C_length_by_q1_2_by_q1;
    const double pD_length_tox = t6 - t7;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double pD_length_toy = t10 - t11;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double D_length = sinew_sqrt(t31 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t44 = 1.0 / D_length;
    const double t45 = t33 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
    const double D_length_by_q1 = t45 * t44;
    const double t46 = t35 - D_lengthdx * pB_length_tox_by_q1_2_by_q1 + D_lengthdy
        * pB_length_toy_by_q1_2_by_q1;
    const double D_length_by_q1_2_by_q1 = (t46 + t37 + t38 + t39 - D_length_by_q1 * D_length_by_q1)
        * t44;
    const double t47 = t43 + f[3] * D_length_by_q1_2_by_q1 + A_length_by_q1 * (kt[0]
        * A_length_by_q1);
    const double t48 = t47 + B_length_by_q1 * (kt[1] * B_length_by_q1) + C_length_by_q1 * (kt[2]
        * C_length_by_q1);
    const double K2_2 = t48 + D_length_by_q1 * (kt[3] * D_length_by_q1);
    const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t32;
    const double t49 = B_lengthdx - pB_length_tox;
    const double t50 = B_lengthdy - pB_length_toy;
    const double t51 = pB_length_tox_by_q1 * t50 + pB_length_toy_by_q1 * -t49 - B_length_by_q0
        * B_length_by_q1;
    const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t15;
    const double t52 = A_lengthdx + pA_length_tox;
    const double t53 = A_lengthdy + pA_length_toy;
    const double t54 = pA_length_toy_by_q1 * t52 - pA_length_tox_by_q1 * t53 - A_length_by_q0
        * A_length_by_q1;
    const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t40;
    const double t55 = pC_length_toy - C_lengthdy;
    const double t56 = C_lengthdx + pC_length_tox;
    const double t57 = pA_length_tox_by_q1 * -t55 + pA_length_toy_by_q1 * t56 - C_length_by_q0
        * C_length_by_q1;
    const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t44;
    const double t58 = D_lengthdx - pD_length_tox;
    const double t59 = D_lengthdy + pD_length_toy;
    const double t60 = pB_length_toy_by_q1 * -t58 - pB_length_tox_by_q1 * t59 + D_length_by_q0
        * D_length_by_q1;
    const double t61 = f[0] * (t54 * t15) + f[1] * (t51 * t32) + f[2] * (t57 * t40) + f[3] * (t60
        * t44);
    const double w1_1 = kt[0] * A_length_by_q0;
    const double w2_1 = kt[1] * B_length_by_q0;
    const double w3_1 = kt[2] * C_length_by_q0;
    const double t62 = t61 + A_length_by_q1 * w1_1 + B_length_by_q1 * w2_1 + C_length_by_q1 * w3_1;
    const double w4_1 = kt[3] * D_length_by_q0;
    const double K1_2 = t62 - D_length_by_q1 * w4_1;
    const double t63 = pA_length_toy * t53 + pA_length_tox * t52 - A_length_by_q0 * A_length_by_q0;
    const double t64 = pB_length_toy * t50 + pB_length_tox * t49 + B_length_by_q0 * B_length_by_q0;
    const double t65 = pC_length_toy * t55 + pC_length_tox * t56 - C_length_by_q0 * C_length_by_q0;
    const double t66 = pD_length_tox * t58 - pD_length_toy * t59 + D_length_by_q0 * D_length_by_q0;
    const double t67 = f[0] * (t63 * t15) - f[1] * (t64 * t32) + f[2] * (t65 * t40) - f[3] * (t66
        * t44);
    const double t68 = t67 + A_length_by_q0 * w1_1 + B_length_by_q0 * w2_1 + C_length_by_q0 * w3_1;
    K[0] = t68 + D_length_by_q0 * w4_1;
    K[1] = K1_2;
    K[2] = 0.0;
    K[3] = 0.0;
    K[4] = K1_2;
    K[5] = K2_2;
    K[6] = 0.0;
    K[7] = 0.0;
    K[8] = 0.0;
    K[9] = 0.0;
    K[10] = K3_3;
    K[11] = t3;
    K[12] = 0.0;
    K[13] = 0.0;
    K[14] = t3;
    K[15] = 3.0249999999999997e-05 * (kt[6] + kt[7]);
}

void thumb_tendon_hessian(const double q[SINEW_AT_LEAST(4)], double H[SINEW_AT_LEAST(128)])
{
    for (int i1 = 0; i1 < 8; ++i1) {
        H[2 + 16 * i1] = 0.0;
        H[3 + 16 * i1] = 0.0;
        H[6 + 16 * i1] = 0.0;
        H[7 + 16 * i1] = 0.0;
        H[8 + 16 * i1] = 0.0;
        H[9 + 16 * i1] = 0.0;
        H[10 + 16 * i1] = 0.0;
        H[11 + 16 * i1] = 0.0;
        H[12 + 16 * i1] = 0.0;
        H[13 + 16 * i1] = 0.0;
        H[14 + 16 * i1] = 0.0;
        H[15 + 16 * i1] = 0.0;
    }
    for (int i2 = 0; i2 < 4; ++i2) {
        H[64 + 16 * i2] = 0.0;
        H[65 + 16 * i2] = 0.0;
        H[68 + 16 * i2] = 0.0;
        H[69 + 16 * i2] = 0.0;
    }
    const struct sinew_sines2 sines3 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines3.s[0];
    const double c1 = sines3.c[0];
    const double s2 = sines3.s[1];
    const double c2 = sines3.c[1];
    const double t4 = 0.005 * c2;
    const double t5 = 0.047 * s2;
    const double pA_length_toz = t4 - t5;
    const double A_lengthdz = 0.025 - pA_length_toz;
    const double t6 = A_lengthdz * A_lengthdz;
    const double R21x = c1 * c2;
    const double t7 = 0.047 * R21x;
    const double t8 = 0.006 * s1;
    const double R21y = c1 * s2;
    const double t9 = 0.005 * R21y;
    const double t10 = t9 - t8;
    const double pA_length_tox = t10 + t7;
    const double A_lengthdx = 0.002 - pA_length_tox;
    const double R22x = s1 * c2;
    const double t11 = 0.047 * R22x;
    const double t12 = 0.006 * c1;
    const double R22y = s1 * s2;
    const double t13 = 0.005 * R22y;
    const double t14 = t13 + t12;
    const double pA_length_toy = t14 + t11;
    const double A_lengthdy = 0.03 - pA_length_toy;
    const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t6);
    const double t15 = 1.0 / A_length;
    const double t16 = A_lengthdy + pA_length_toy;
    const double t17 = A_lengthdx + pA_length_tox;
    const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t15;
    const double t18 = pA_length_toy * t16 + pA_length_tox * t17 - A_length_by_q0 * A_length_by_q0;
    H[0] = t18 * t15;
    const double t19 = 0.005 * R22x;
    const double t20 = 0.047 * R22y;
    const double pA_length_toy_by_q1 = t19 - t20;
    const double t21 = 0.005 * R21x;
    const double t22 = 0.047 * R21y;
    const double pA_length_tox_by_q1 = t21 - t22;
    const double t23 = 0.005 * s2;
    const double t24 = 0.047 * c2;
    const double pA_length_toz_by_q1 = t23 + t24;
    const double t25 = A_lengthdz * pA_length_toz_by_q1;
    const double t26 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t25;
    const double A_length_by_q1 = t26 * t15;
    const double t27 = pA_length_toy_by_q1 * t17 - pA_length_tox_by_q1 * t16 - A_length_by_q0
        * A_length_by_q1;
    const double A_length_by_q0_2_by_q1 = t27 * t15;
    H[1] = A_length_by_q0_2_by_q1;
    H[4] = A_length_by_q0_2_by_q1;
    const double t28 = pA_length_toz_by_q1 * pA_length_toz_by_q1;
    const double t29 = pA_length_toy_by_q1 * pA_length_toy_by_q1;
    const double t30 = pA_length_tox_by_q1 * pA_length_tox_by_q1;
    const double pA_length_toy_by_q1_2_by_q1 = t13 + t11;
    const double t31 = pA_length_toz * A_lengthdz;
    const double pA_length_tox_by_q1_2_by_q1 = t9 + t7;
    const double t32 = t31 + A_lengthdx * pA_length_tox_by_q1_2_by_q1 + A_lengthdy
        * pA_length_toy_by_q1_2_by_q1;
    const double A_length_by_q1_2_by_q1 = (t32 + t30 + t29 + t28 - A_length_by_q1 * A_length_by_q1)
        * t15;
    H[5] = A_length_by_q1_2_by_q1;
    const double pB_length_toz = t4 + t5;
    const double B_lengthdz = 0.025 - pB_length_toz;
    const double t33 = B_lengthdz * B_lengthdz;
    const double t34 = t9 + t8;
    const double pB_length_tox = t34 - t7;
    const double B_lengthdx = 0.002 + pB_length_tox;
    const double t35 = t13 - t12;
    const double pB_length_toy = t35 - t11;
    const double B_lengthdy = 0.03 + pB_length_toy;
    const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t33);
    const double t36 = 1.0 / B_length;
    const double t37 = B_lengthdy - pB_length_toy;
    const double t38 = B_lengthdx - pB_length_tox;
    const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t36;
    const double t39 = pB_length_toy * t37 + pB_length_tox * t38 + B_length_by_q0 * B_length_by_q0;
    H[16] = -(t39 * t36);
    const double pB_length_tox_by_q1 = t21 + t22;
    const double pB_length_toy_by_q1 = t19 + t20;
    const double pB_length_toz_by_q1 = t23 - t24;
    const double t40 = B_lengthdz * pB_length_toz_by_q1;
    const double t41 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t40;
    const double B_length_by_q1 = t41 * t36;
    const double t42 = pB_length_tox_by_q1 * t37 + pB_length_toy_by_q1 * -t38 - B_length_by_q0
        * B_length_by_q1;
    const double B_length_by_q0_2_by_q1 = t42 * t36;
    H[17] = B_length_by_q0_2_by_q1;
    H[20] = B_length_by_q0_2_by_q1;
    const double t43 = pB_length_toz_by_q1 * pB_length_toz_by_q1;
    const double t44 = pB_length_toy_by_q1 * pB_length_toy_by_q1;
    const double t45 = pB_length_tox_by_q1 * pB_length_tox_by_q1;
    const double pB_length_toy_by_q1_2_by_q1 = t13 - t11;
    const double t46 = pB_length_toz * B_lengthdz;
    const double pB_length_tox_by_q1_2_by_q1 = t9 - t7;
    const double t47 = t46 - B_lengthdx * pB_length_tox_by_q1_2_by_q1 - B_lengthdy
        * pB_length_toy_by_q1_2_by_q1;
    const double B_length_by_q1_2_by_q1 = (t47 + t45 + t44 + t43 - B_length_by_q1 * B_length_by_q1)
        * t36;
    H[21] = B_length_by_q1_2_by_q1;
    const double pC_length_toy = t35 + t11;
    const double C_lengthdy = 0.03 + pC_length_toy;
    const double pC_length_tox = t34 + t7;
    const double C_lengthdx = 0.002 - pC_length_tox;
    const double C_length = sinew_sqrt(t6 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
    const double t48 = 1.0 / C_length;
    const double t49 = pC_length_toy - C_lengthdy;
    const double t50 = C_lengthdx + pC_length_tox;
    const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t48;
    const double t51 = pC_length_toy * t49 + pC_length_tox * t50 - C_length_by_q0 * C_length_by_q0;
    H[32] = t51 * t48;
    const double t52 = t25 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
    const double C_length_by_q1 = t52 * t48;
    const double t53 = pA_length_tox_by_q1 * -t49 + pA_length_toy_by_q1 * t50 - C_length_by_q0
        * C_length_by_q1;
    const double C_length_by_q0_2_by_q1 = t53 * t48;
    H[33] = C_length_by_q0_2_by_q1;
    H[36] = C_length_by_q0_2_by_q1;
    const double t54 = t31 + C_lengthdx * pA_length_tox_by_q1_2_by_q1 - C_lengthdy
        * pA_length_toy_by_q1_2_by_q1;
    const double C_length_by_q1_2_by_q1 = (t54 + t30 + t29 + t28 - C_length_by_q1 * C_length_by_q1)
        * t48;
    H[37] = C_length_by_q1_2_by_q1;
    const double pD_length_toy = t14 - t11;
    const double D_lengthdy = 0.03 - pD_length_toy;
    const double pD_length_tox = t10 - t7;
    const double D_lengthdx = 0.002 + pD_length_tox;
    const double D_length = sinew_sqrt(t33 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
    const double t55 = 1.0 / D_length;
    const double t56 = D_lengthdx - pD_length_tox;
    const double t57 = D_lengthdy + pD_length_toy;
    const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t55;
    const double t58 = pD_length_tox * t56 - pD_length_toy * t57 + D_length_by_q0 * D_length_by_q0;
    H[48] = -(t58 * t55);
    const double t59 = t40 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
    const double D_length_by_q1 = t59 * t55;
    const double t60 = pB_length_toy_by_q1 * -t56 - pB_length_tox_by_q1 * t57 + D_length_by_q0
        * D_length_by_q1;
    const double D_length_by_q0_2_by_q1 = t60 * t55;
    H[49] = D_length_by_q0_2_by_q1;
    H[52] = D_length_by_q0_2_by_q1;
    const double t61 = t46 - D_lengthdx * pB_length_tox_by_q1_2_by_q1 + D_lengthdy
        * pB_length_toy_by_q1_2_by_q1;
    const double D_length_by_q1_2_by_q1 = (t61 + t45 + t44 + t43 - D_length_by_q1 * D_length_by_q1)
        * t55;
    H[53] = D_length_by_q1_2_by_q1;
}

void thumb_link_position(const double h[SINEW_AT_LEAST(4)], const double q_start[SINEW_AT_LEAST(2)],
    double q[SINEW_AT_LEAST(2)], double correction[SINEW_AT_LEAST(1)], int *status)
{
    const double start_q10 = sinew_min(sinew_max(q_start[0], -1.5), 1.5);
    const double start_q11 = sinew_min(sinew_max(q_start[1], -1.5), 1.5);
    double part_1[10];
    thumb_part_1(h, start_q10, start_q11, part_1);
    const double cost = 0.5 * part_1[4];
    const double d = 1.0001 * part_1[8];
    const double a = 1.0001 * part_1[9];
    const double safe = sinew_max(a * d - part_1[6] * part_1[6], 1e-24 + 1e-09 * a * d);
    const double t1 = 1.0 / safe;
    const double step = sinew_min(sinew_max(-((part_1[6] * part_1[5] - part_1[7] * d) * t1), -0.5),
        0.5);
    const double q10 = start_q10 + step;
    const double step_2 = sinew_min(sinew_max(-((part_1[6] * part_1[7] - part_1[5] * a) * t1),
        -0.5), 0.5);
    const double q11 = start_q11 + step_2;
    double part_1_2[10];
    thumb_part_1(h, q10, q11, part_1_2);
    const double cost_2 = 0.5 * part_1_2[4];
    const double better = cost - cost_2;
    const double kept_8 = sinew_choose(better, cost_2, cost);
    const double kept = sinew_choose(better, q10, start_q10);
    const double kept_4 = sinew_choose(better, -part_1_2[7], -part_1[7]);
    const double kept_14 = sinew_choose(better, part_1_2[8], part_1[8]);
    const double kept_16 = sinew_choose(better, 1e-05, 0.001);
    const double t2 = 1.0 + kept_16;
    const double d_2 = kept_14 * t2;
    const double kept_6 = sinew_choose(better, -part_1_2[5], -part_1[5]);
    const double kept_12 = sinew_choose(better, part_1_2[6], part_1[6]);
    const double kept_10 = sinew_choose(better, part_1_2[9], part_1[9]);
    const double a_2 = kept_10 * t2;
    const double safe_2 = sinew_max(a_2 * d_2 - kept_12 * kept_12, 1e-24 + 1e-09 * a_2 * d_2);
    const double t3 = 1.0 / safe_2;
    const double step_4 = sinew_min(sinew_max(-((kept_4 * d_2 - kept_6 * kept_12) * t3), -0.5),
        0.5);
    const double q10_2 = kept + step_4;
    const double kept_2 = sinew_choose(better, q11, start_q11);
    const double step_6 = sinew_min(sinew_max((kept_4 * kept_12 - kept_6 * a_2) * t3, -0.5), 0.5);
    const double q11_2 = kept_2 + step_6;
    double part_1_3[10];
    thumb_part_1(h, q10_2, q11_2, part_1_3);
    const double cost_4 = 0.5 * part_1_3[4];
    const double better_2 = kept_8 - cost_4;
    const double kept_26 = sinew_choose(better_2, cost_4, kept_8);
    const double kept_18 = sinew_choose(better_2, q10_2, kept);
    const double kept_22 = sinew_choose(better_2, -part_1_3[7], kept_4);
    const double kept_32 = sinew_choose(better_2, part_1_3[8], kept_14);
    const double kept_34 = sinew_choose(better_2, 0.1 * kept_16, 10.0 * kept_16);
    const double t4 = 1.0 + kept_34;
    const double d_4 = kept_32 * t4;
    const double kept_24 = sinew_choose(better_2, -part_1_3[5], kept_6);
    const double kept_30 = sinew_choose(better_2, part_1_3[6], kept_12);
    const double kept_28 = sinew_choose(better_2, part_1_3[9], kept_10);
    const double a_4 = kept_28 * t4;
    const double safe_4 = sinew_max(a_4 * d_4 - kept_30 * kept_30, 1e-24 + 1e-09 * a_4 * d_4);
    const double t5 = 1.0 / safe_4;
    const double step_8 = sinew_min(sinew_max(-((kept_22 * d_4 - kept_24 * kept_30) * t5), -0.5),
        0.5);
    const double q10_4 = kept_18 + step_8;
    const double kept_20 = sinew_choose(better_2, q11_2, kept_2);
    const double step_10 = sinew_min(sinew_max((kept_22 * kept_30 - kept_24 * a_4) * t5, -0.5),
        0.5);
    const double q11_4 = kept_20 + step_10;
    double part_1_4[10];
    thumb_part_1(h, q10_4, q11_4, part_1_4);
    const double cost_6 = 0.5 * part_1_4[4];
    const double better_4 = kept_26 - cost_6;
    const double kept_36 = sinew_choose(better_4, q10_4, kept_18);
    const double kept_40 = sinew_choose(better_4, -part_1_4[7], kept_22);
    const double kept_50 = sinew_choose(better_4, part_1_4[8], kept_32);
    const double kept_52 = sinew_choose(better_4, 0.1 * kept_34, 10.0 * kept_34);
    const double t6 = 1.0 + kept_52;
    const double d_6 = kept_50 * t6;
    const double kept_42 = sinew_choose(better_4, -part_1_4[5], kept_24);
    const double kept_48 = sinew_choose(better_4, part_1_4[6], kept_30);
    const double kept_46 = sinew_choose(better_4, part_1_4[9], kept_28);
    const double a_6 = kept_46 * t6;
    const double safe_6 = sinew_max(a_6 * d_6 - kept_48 * kept_48, 1e-24 + 1e-09 * a_6 * d_6);
    const double t7 = 1.0 / safe_6;
    const double step_12 = sinew_min(sinew_max(-((kept_40 * d_6 - kept_42 * kept_48) * t7), -0.5),
        0.5);
    const double q10_6 = kept_36 + step_12;
    const double kept_38 = sinew_choose(better_4, q11_4, kept_20);
    const double step_14 = sinew_min(sinew_max((kept_40 * kept_48 - kept_42 * a_6) * t7, -0.5),
        0.5);
    const double q11_6 = kept_38 + step_14;
    double part_1_5[10];
    thumb_part_1(h, q10_6, q11_6, part_1_5);
    const double better_6 = sinew_choose(better_4, cost_6, kept_26) - 0.5 * part_1_5[4];
    const double kept_58 = sinew_choose(better_6, -part_1_5[7], kept_40);
    const double kept_68 = sinew_choose(better_6, part_1_5[8], kept_50);
    const double kept_60 = sinew_choose(better_6, -part_1_5[5], kept_42);
    const double kept_66 = sinew_choose(better_6, part_1_5[6], kept_48);
    const double kept_64 = sinew_choose(better_6, part_1_5[9], kept_46);
    const double safe_8 = sinew_max(kept_64 * kept_68 - kept_66 * kept_66, 1e-24 + 1e-09 * kept_64
        * kept_68);
    const double t8 = 1.0 / safe_8;
    const double step_16 = sinew_min(sinew_max(-((kept_58 * kept_68 - kept_60 * kept_66) * t8),
        -0.5), 0.5);
    const double step_18 = sinew_min(sinew_max((kept_58 * kept_66 - kept_60 * kept_64) * t8, -0.5),
        0.5);
    const double correction_2 = sinew_sqrt(step_16 * step_16 + step_18 * step_18);
    q[0] = sinew_choose(better_6, q10_6, kept_36);
    q[1] = sinew_choose(better_6, q11_6, kept_38);
    correction[0] = correction_2;
    *status = (int)sinew_choose(1e-06 - correction_2, 0.0, 1.0);
}

void thumb_link_position_warm(const double h[SINEW_AT_LEAST(4)],
    const double q_start[SINEW_AT_LEAST(2)], double q[SINEW_AT_LEAST(2)],
    double correction[SINEW_AT_LEAST(1)], int *status)
{
    const double start_q10 = sinew_min(sinew_max(q_start[0], -1.5), 1.5);
    const double start_q11 = sinew_min(sinew_max(q_start[1], -1.5), 1.5);
    double part_1[10];
    thumb_part_1(h, start_q10, start_q11, part_1);
    const double d = 1.0001 * part_1[8];
    const double a = 1.0001 * part_1[9];
    const double safe = sinew_max(a * d - part_1[6] * part_1[6], 1e-24 + 1e-09 * a * d);
    const double t1 = 1.0 / safe;
    const double step_2 = sinew_min(sinew_max(-((part_1[6] * part_1[7] - part_1[5] * a) * t1),
        -0.5), 0.5);
    const double q11 = start_q11 + step_2;
    const double step = sinew_min(sinew_max(-((part_1[6] * part_1[5] - part_1[7] * d) * t1), -0.5),
        0.5);
    const double q10 = start_q10 + step;
    double part_1_2[10];
    thumb_part_1(h, q10, q11, part_1_2);
    const double better = 0.5 * (part_1[4] - part_1_2[2] - part_1_2[3] - part_1_2[1] - part_1_2[0]);
    const double kept_4 = sinew_choose(better, -part_1_2[7], -part_1[7]);
    const double kept_14 = sinew_choose(better, part_1_2[8], part_1[8]);
    const double kept_6 = sinew_choose(better, -part_1_2[5], -part_1[5]);
    const double kept_12 = sinew_choose(better, part_1_2[6], part_1[6]);
    const double kept_10 = sinew_choose(better, part_1_2[9], part_1[9]);
    const double safe_2 = sinew_max(kept_10 * kept_14 - kept_12 * kept_12, 1e-24 + 1e-09 * kept_10
        * kept_14);
    const double t2 = 1.0 / safe_2;
    const double step_4 = sinew_min(sinew_max(-((kept_4 * kept_14 - kept_6 * kept_12) * t2), -0.5),
        0.5);
    const double step_6 = sinew_min(sinew_max((kept_4 * kept_12 - kept_6 * kept_10) * t2, -0.5),
        0.5);
    const double correction_2 = sinew_sqrt(step_4 * step_4 + step_6 * step_6);
    q[0] = sinew_choose(better, q10, start_q10);
    q[1] = sinew_choose(better, q11, start_q11);
    correction[0] = correction_2;
    *status = (int)sinew_choose(1e-06 - correction_2, 0.0, 1.0);
}

void thumb_link_position_gradient_step(const double h[SINEW_AT_LEAST(4)],
    const double search[SINEW_AT_LEAST(6)], double next[SINEW_AT_LEAST(6)])
{
    const double step = sinew_min(sinew_max(-(search[2] * search[4]), -0.5), 0.5);
    const double start_q10 = sinew_min(sinew_max(search[0], -1.5), 1.5);
    const double q10 = start_q10 + step;
    const double step_2 = sinew_min(sinew_max(-(search[3] * search[4]), -0.5), 0.5);
    const double start_q11 = sinew_min(sinew_max(search[1], -1.5), 1.5);
    const double q11 = start_q11 + step_2;
    double part_1[10];
    thumb_part_1(h, q10, q11, part_1);
    const double cost = 0.5 * part_1[4];
    const double better = search[5] - cost;
    const double kept_4 = sinew_choose(better, -part_1[7], search[2]);
    const double kept_6 = sinew_choose(better, -part_1[5], search[3]);
    const double kept_8 = sinew_choose(better, search[4], 0.5 * search[4]);
    next[0] = sinew_choose(better, q10, start_q10);
    next[1] = sinew_choose(better, q11, start_q11);
    next[2] = kept_4;
    next[3] = kept_6;
    next[4] = kept_8;
    next[5] = sinew_choose(better, cost, search[5]);
}

void thumb_link_position_status(const double h[SINEW_AT_LEAST(4)],
    const double q[SINEW_AT_LEAST(2)], double correction[SINEW_AT_LEAST(1)], int *status)
{
    double part_1[10];
    thumb_part_1(h, sinew_min(sinew_max(q[0], -1.5), 1.5), sinew_min(sinew_max(q[1], -1.5), 1.5),
        part_1);
    const double determinant = part_1[9] * part_1[8] - part_1[6] * part_1[6];
    const double safe = sinew_max(determinant, 1e-24 + 1e-09 * part_1[9] * part_1[8]);
    const double t1 = 1.0 / safe;
    const double step = sinew_min(sinew_max(-((part_1[6] * part_1[5] - part_1[8] * part_1[7]) * t1),
        -0.5), 0.5);
    const double step_2 = sinew_min(sinew_max((part_1[9] * part_1[5] - part_1[6] * part_1[7]) * t1,
        -0.5), 0.5);
    const double correction_2 = sinew_sqrt(step * step + step_2 * step_2);
    correction[0] = correction_2;
    *status = (int)sinew_choose(1e-06 - correction_2, 0.0, 1.0);
}

void thumb_link_position_covariance(const double q[SINEW_AT_LEAST(2)], double sigma,
    double covariance[SINEW_AT_LEAST(4)], int *status)
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], q[0]);
    const double sin_q11 = sines1.s[0];
    const double cos_q11 = sines1.c[0];
    const double sin_q10 = sines1.s[1];
    const double cos_q10 = sines1.c[1];
    const double t2 = 0.005 * sin_q11;
    const double t3 = 0.047 * cos_q11;
    const double along = t2 + t3;
    const double t4 = cos_q10 * along;
    const double t5 = 0.006 * sin_q10;
    const double t6 = 0.002 + t5;
    const double gap_x = t6 - t4;
    const double t7 = sin_q10 * along;
    const double t8 = 0.006 * cos_q10;
    const double t9 = 0.03 - t8;
    const double gap_y = t9 - t7;
    const double t10 = 0.005 * cos_q11;
    const double t11 = 0.047 * sin_q11;
    const double up = t10 - t11;
    const double gap_z = 0.025 - up;
    const double t12 = gap_z * gap_z;
    const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t12);
    const double t13 = 1.0 / stretch;
    const double gap_x_by_q11 = cos_q10 * up;
    const double t14 = along * gap_z;
    const double gap_y_by_q11 = sin_q10 * up;
    const double stretch_by_q11 = (t14 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t13;
    const double along_2 = t2 - t3;
    const double t15 = cos_q10 * along_2;
    const double gap_x_2 = t6 + t15;
    const double t16 = sin_q10 * along_2;
    const double gap_y_2 = t9 + t16;
    const double up_2 = t10 + t11;
    const double gap_z_2 = 0.025 - up_2;
    const double t17 = gap_z_2 * gap_z_2;
    const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t17);
    const double t18 = 1.0 / stretch_2;
    const double gap_x_2_by_q11 = cos_q10 * up_2;
    const double t19 = along_2 * gap_z_2;
    const double gap_y_2_by_q11 = sin_q10 * up_2;
    const double stretch_2_by_q11 = (t19 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
        * t18;
    const double t20 = 0.002 - t5;
    const double gap_x_4 = t20 - t4;
    const double gap_y_4 = t9 + t7;
    const double stretch_4 = sinew_sqrt(t12 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
    const double t21 = 1.0 / stretch_4;
    const double stretch_4_by_q11 = (t14 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11) * t21;
    const double t22 = stretch_by_q11 * stretch_by_q11 + stretch_2_by_q11 * stretch_2_by_q11
        + stretch_4_by_q11 * stretch_4_by_q11;
    const double gap_x_6 = t20 + t15;
    const double gap_y_6 = t9 - t16;
    const double stretch_6 = sinew_sqrt(t17 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
    const double t23 = 1.0 / stretch_6;
    const double stretch_6_by_q11 = (t19 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
        * t23;
    const double H_11 = t22 + stretch_6_by_q11 * stretch_6_by_q11;
    const double stretch_by_q10 = (gap_x * (t8 + t7) + gap_y * (t5 - t4)) * t13;
    const double stretch_2_by_q10 = (gap_x_2 * (t8 - t16) + gap_y_2 * (t5 + t15)) * t18;
    const double stretch_4_by_q10 = (gap_x_4 * (t8 - t7) - gap_y_4 * (t5 + t4)) * t21;
    const double t24 = stretch_by_q10 * stretch_by_q10 + stretch_2_by_q10 * stretch_2_by_q10
        + stretch_4_by_q10 * stretch_4_by_q10;
    const double stretch_6_by_q10 = (gap_x_6 * (t8 + t16) - gap_y_6 * (t5 - t15)) * t23;
    const double H_00 = t24 + stretch_6_by_q10 * stretch_6_by_q10;
    const double t25 = stretch_by_q10 * stretch_by_q11 + stretch_2_by_q10 * stretch_2_by_q11
        - stretch_4_by_q10 * stretch_4_by_q11;
    const double H_01 = t25 - stretch_6_by_q10 * stretch_6_by_q11;
    const double determinant = H_00 * H_11 - H_01 * H_01;
    const double determinant_floor = 1e-24 + 1e-09 * H_00 * H_11;
    const double deviation = sinew_min(sinew_max(sigma, 0.0), 1.0);
    const double scale = deviation * deviation / sinew_max(determinant, determinant_floor);
    const double t26 = -(H_01 * scale);
    covariance[0] = H_11 * scale;
    covariance[1] = t26;
    covariance[2] = t26;
    covariance[3] = H_00 * scale;
    *status = (int)sinew_choose(determinant - determinant_floor, 0.0, 1.0);
}

void thumb_hinge_position(const double h[SINEW_AT_LEAST(4)], double q[SINEW_AT_LEAST(2)])
{
    const double t1 = h[0] - h[1];
    q[0] = 76.92307692307692 * t1;
    q[1] = 90.90909090909092 * (t1 + h[2] - h[3]);
}

void thumb_bending_angles(const double q[SINEW_AT_LEAST(4)], double angles[SINEW_AT_LEAST(8)])
{
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[0], q[1]);
    const double s1 = sines1.s[0];
    const double c1 = sines1.c[0];
    const double s2 = sines1.s[1];
    const double c2 = sines1.c[1];
    const double R21y = c1 * s2;
    const double t2 = 0.005 * R21y;
    const double t3 = 0.006 * s1;
    const double t4 = t2 - t3;
    const double R21x = c1 * c2;
    const double t5 = 0.047 * R21x;
    const double A_stretch_dx = 0.002 - t4 - t5;
    const double t6 = 0.025 - 0.005 * c2;
    const double t7 = 0.047 * s2;
    const double A_stretch_dz = t6 + t7;
    const double t8 = s2 * A_stretch_dz;
    const double R22y = s1 * s2;
    const double t9 = 0.005 * R22y;
    const double t10 = 0.006 * c1;
    const double t11 = 0.03 - (t9 + t10);
    const double R22x = s1 * c2;
    const double t12 = 0.047 * R22x;
    const double A_stretch_dy = t11 - t12;
    const double A_stretch_end_dx = t8 - R21x * A_stretch_dx - R22x * A_stretch_dy;
    const double t13 = c2 * A_stretch_dz;
    const double A_stretch_end_dz = t13 + R21y * A_stretch_dx + R22y * A_stretch_dy;
    const double A_stretch_end_asidey = 0.02 * A_stretch_end_dx - 0.045 * A_stretch_end_dz;
    const double A_stretch_end_dy = c1 * A_stretch_dy - s1 * A_stretch_dx;
    const double A_stretch_end_asidex = 0.02 * A_stretch_end_dy - 0.024 * A_stretch_end_dz;
    const double t14 = A_stretch_end_asidex * A_stretch_end_asidex + A_stretch_end_asidey
        * A_stretch_end_asidey;
    const double A_stretch_end_asidez = 0.024 * A_stretch_end_dx - 0.045 * A_stretch_end_dy;
    const double t15 = 0.02 * A_stretch_end_dz + 0.024 * A_stretch_end_dy + 0.045
        * A_stretch_end_dx;
    const double t16 = sinew_one_atan2(sinew_sqrt(t14 + A_stretch_end_asidez
        * A_stretch_end_asidez), t15);
    const double t17 = 0.024 * A_stretch_dz;
    const double A_stretch_start_asidex = 0.02 * A_stretch_dy - t17;
    const double t18 = 0.045 * A_stretch_dz;
    const double A_stretch_start_asidey = 0.02 * A_stretch_dx + t18;
    const double t19 = A_stretch_start_asidex * A_stretch_start_asidex + A_stretch_start_asidey
        * A_stretch_start_asidey;
    const double A_stretch_start_asidez = 0.024 * A_stretch_dx + 0.045 * A_stretch_dy;
    const double t20 = 0.02 * A_stretch_dz;
    const double t21 = sinew_one_atan2(sinew_sqrt(t19 + A_stretch_start_asidez
        * A_stretch_start_asidez), t20 + 0.024 * A_stretch_dy - 0.045 * A_stretch_dx);
    const double t22 = t2 + t3;
    const double B_stretch_dx = 0.002 + t22 - t5;
    const double B_stretch_dz = t6 - t7;
    const double t23 = s2 * B_stretch_dz;
    const double t24 = 0.03 + (t9 - t10);
    const double B_stretch_dy = t24 - t12;
    const double B_stretch_end_dx = t23 + R21x * B_stretch_dx + R22x * B_stretch_dy;
    const double t25 = c2 * B_stretch_dz;
    const double B_stretch_end_dz = t25 - R21y * B_stretch_dx - R22y * B_stretch_dy;
    const double B_stretch_end_asidey = 0.02 * B_stretch_end_dx + 0.045 * B_stretch_end_dz;
    const double B_stretch_end_dy = c1 * B_stretch_dy - s1 * B_stretch_dx;
    const double B_stretch_end_asidex = 0.02 * B_stretch_end_dy - 0.024 * B_stretch_end_dz;
    const double t26 = B_stretch_end_asidex * B_stretch_end_asidex + B_stretch_end_asidey
        * B_stretch_end_asidey;
    const double B_stretch_end_asidez = 0.024 * B_stretch_end_dx + 0.045 * B_stretch_end_dy;
    const double t27 = 0.02 * B_stretch_end_dz + 0.024 * B_stretch_end_dy - 0.045
        * B_stretch_end_dx;
    const double t28 = sinew_one_atan2(sinew_sqrt(t26 + B_stretch_end_asidez
        * B_stretch_end_asidez), t27);
    const double t29 = 0.024 * B_stretch_dz;
    const double B_stretch_start_asidex = 0.02 * B_stretch_dy - t29;
    const double t30 = 0.045 * B_stretch_dz;
    const double B_stretch_start_asidey = 0.02 * B_stretch_dx + t30;
    const double t31 = B_stretch_start_asidex * B_stretch_start_asidex + B_stretch_start_asidey
        * B_stretch_start_asidey;
    const double B_stretch_start_asidez = 0.024 * B_stretch_dx + 0.045 * B_stretch_dy;
    const double t32 = 0.02 * B_stretch_dz;
    const double t33 = sinew_one_atan2(sinew_sqrt(t31 + B_stretch_start_asidez
        * B_stretch_start_asidez), t32 + 0.024 * B_stretch_dy - 0.045 * B_stretch_dx);
    const double C_stretch_dx = 0.002 - t22 - t5;
    const double C_stretch_dy = t24 + t12;
    const double C_stretch_end_dx = t8 - R21x * C_stretch_dx + R22x * C_stretch_dy;
    const double C_stretch_end_dz = t13 + R21y * C_stretch_dx - R22y * C_stretch_dy;
    const double C_stretch_end_asidey = 0.02 * C_stretch_end_dx - 0.045 * C_stretch_end_dz;
    const double C_stretch_end_dy = c1 * C_stretch_dy + s1 * C_stretch_dx;
    const double C_stretch_end_asidex = 0.02 * C_stretch_end_dy - 0.024 * C_stretch_end_dz;
    const double t34 = C_stretch_end_asidex * C_stretch_end_asidex + C_stretch_end_asidey
        * C_stretch_end_asidey;
    const double C_stretch_end_asidez = 0.024 * C_stretch_end_dx - 0.045 * C_stretch_end_dy;
    const double t35 = 0.02 * C_stretch_end_dz + 0.024 * C_stretch_end_dy + 0.045
        * C_stretch_end_dx;
    const double t36 = sinew_one_atan2(sinew_sqrt(t34 + C_stretch_end_asidez
        * C_stretch_end_asidez), t35);
    const double C_stretch_start_asidex = 0.02 * C_stretch_dy - t17;
    const double C_stretch_start_asidey = 0.02 * C_stretch_dx + t18;
    const double t37 = C_stretch_start_asidex * C_stretch_start_asidex + C_stretch_start_asidey
        * C_stretch_start_asidey;
    const double C_stretch_start_asidez = 0.024 * C_stretch_dx + 0.045 * C_stretch_dy;
    const double t38 = sinew_one_atan2(sinew_sqrt(t37 + C_stretch_start_asidez
        * C_stretch_start_asidez), t20 + 0.024 * C_stretch_dy - 0.045 * C_stretch_dx);
    const double D_stretch_dx = 0.002 + t4 - t5;
    const double D_stretch_dy = t11 + t12;
    const double D_stretch_end_dx = t23 + R21x * D_stretch_dx - R22x * D_stretch_dy;
    const double D_stretch_end_dz = t25 - R21y * D_stretch_dx + R22y * D_stretch_dy;
    const double D_stretch_end_asidey = 0.02 * D_stretch_end_dx + 0.045 * D_stretch_end_dz;
    const double D_stretch_end_dy = c1 * D_stretch_dy + s1 * D_stretch_dx;
    const double D_stretch_end_asidex = 0.02 * D_stretch_end_dy - 0.024 * D_stretch_end_dz;
    const double t39 = D_stretch_end_asidex * D_stretch_end_asidex + D_stretch_end_asidey
        * D_stretch_end_asidey;
    const double D_stretch_end_asidez = 0.024 * D_stretch_end_dx + 0.045 * D_stretch_end_dy;
    const double t40 = 0.02 * D_stretch_end_dz + 0.024 * D_stretch_end_dy - 0.045
        * D_stretch_end_dx;
    const double t41 = sinew_one_atan2(sinew_sqrt(t39 + D_stretch_end_asidez
        * D_stretch_end_asidez), t40);
    const double D_stretch_start_asidex = 0.02 * D_stretch_dy - t29;
    const double D_stretch_start_asidey = 0.02 * D_stretch_dx + t30;
    const double t42 = D_stretch_start_asidex * D_stretch_start_asidex + D_stretch_start_asidey
        * D_stretch_start_asidey;
    const double D_stretch_start_asidez = 0.024 * D_stretch_dx + 0.045 * D_stretch_dy;
    const double t43 = sinew_one_atan2(sinew_sqrt(t42 + D_stretch_start_asidez
        * D_stretch_start_asidez), t32 + 0.024 * D_stretch_dy - 0.045 * D_stretch_dx);
    const double t44 = sinew_max(q[2], -q[2]);
    const double t45 = t44 + sinew_max(q[3], -q[3]);
    angles[0] = t21 + t16;
    angles[1] = t33 + t28;
    angles[2] = t38 + t36;
    angles[3] = t43 + t41;
    angles[4] = t44;
    angles[5] = t44;
    angles[6] = t45;
    angles[7] = t45;
}
