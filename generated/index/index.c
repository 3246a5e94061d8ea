/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Index finger: abduction, three flexion joints, eight tendons
 *
 * Made by: sinew generate models/index
 * Model:   sha256 87dae3bf2513ab5836c918f869de07d956d21148227d4e316059a4cbc5f06f25
 * Do not edit: change the model and generate again.
 */
#include "index.h"

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

void index_forward_kinematics(const double q[SINEW_AT_LEAST(4)], double T[SINEW_AT_LEAST(16)])
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
    const double R41x = c1 * c4;
    const double t3 = 0.006 + (0.04038 * c2 + 0.0298 * c3);
    const double R42x = s1 * c4;
    T[0] = R41x;
    T[1] = -(c1 * s4);
    T[2] = s1;
    T[3] = c1 * t3 - 0.0057 * s1 + 0.0201 * R41x;
    T[4] = R42x;
    T[5] = -(s1 * s4);
    T[6] = -c1;
    T[7] = s1 * t3 + 0.0057 * c1 + 0.0201 * R42x;
    T[8] = s4;
    T[9] = c4;
    T[10] = 0.0;
    T[11] = 0.04038 * s2 + 0.0298 * s3 + 0.0201 * s4;
    T[12] = 0.0;
    T[13] = 0.0;
    T[14] = 0.0;
    T[15] = 1.0;
}

void index_tip_jacobian(const double q[SINEW_AT_LEAST(4)], double J[SINEW_AT_LEAST(24)])
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
    const double l3x = 0.04038 * c2;
    const double o4x = l3x + 0.0298 * c3;
    const double p2y = 0.006 * s1;
    const double p4y = p2y + s1 * o4x;
    const double ptipy = p4y + 0.0057 * c1 + 0.0201 * s1 * c4;
    J[0] = -ptipy;
    const double l3y = 0.04038 * s2;
    const double o4y = l3y + 0.0298 * s3;
    const double ptipz = o4y + 0.0201 * s4;
    J[1] = -(c1 * ptipz);
    const double arm3_4 = l3y - ptipz;
    J[2] = c1 * arm3_4;
    const double arm4_4 = o4y - ptipz;
    J[3] = c1 * arm4_4;
    const double p2x = 0.006 * c1;
    const double p4x = p2x + c1 * o4x;
    const double ptipx = p4x - 0.0057 * s1 + 0.0201 * c1 * c4;
    J[4] = ptipx;
    J[5] = -(s1 * ptipz);
    J[6] = s1 * arm3_4;
    J[7] = s1 * arm4_4;
    J[8] = 0.0;
    J[16] = 0.0;
    J[9] = -(c1 * (p2x - ptipx) + s1 * (p2y - ptipy));
    J[10] = -(c1 * (p2x + c1 * l3x - ptipx) + s1 * (p2y + s1 * l3x - ptipy));
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

void index_mass_matrix(const double q[SINEW_AT_LEAST(4)], double M[SINEW_AT_LEAST(16)])
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
    const double t3 = c2 * (1.94855328e-05 * c2) + c3 * (4.3862e-06 * c3) + c4 * (3.7701e-07 * c4);
    const double l4x = 0.0298 * c3;
    const double l3x = 0.04038 * c2;
    const double j4x1 = 3.015e-05 * c4;
    const double j3x1 = 0.0001788 * c3;
    const double t4 = l4x * j4x1;
    const double S3x = j3x1 + j4x1;
    const double t5 = l3x * S3x;
    const double t6 = t3 + (l3x + l4x) * j4x1 + l3x * j3x1 + t4 + t5 + 0.012 * (0.00054513 * c2
        + S3x);
    const double j4yz = 1.613025e-07 * s4;
    const double K3yz = 7.0179e-07 * s3 + j4yz;
    const double K2yz = 1.253799e-06 * s2 + K3yz;
    const double j4y1 = 3.015e-05 * s4;
    const double l3y = 0.04038 * s2;
    const double lS3 = t5 + l3y * (0.0001788 * s3 + j4y1);
    const double lS4 = t4 + 0.0298 * s3 * j4y1;
    const double Z3 = 4.92521e-06 + (lS4 + lS4);
    const double M_4 = Z3 + lS3;
    const double M_2 = 4.3101e-07 + lS4;
    const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
    M[0] = t6 + 1.1373674999999997e-06;
    M[1] = K2yz;
    M[2] = K3yz;
    M[3] = j4yz;
    M[4] = K2yz;
    M[5] = 1.96475328e-05 + Z3 + (lS3 + lS3);
    M[6] = M_4;
    M[7] = M_2_2;
    M[8] = K3yz;
    M[9] = M_4;
    M[10] = Z3;
    M[11] = M_2;
    M[12] = j4yz;
    M[13] = M_2_2;
    M[14] = M_2;
    M[15] = 4.3101e-07;
}

void index_coriolis_matrix(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
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
    const double l3x = 0.04038 * c2;
    const double j4y1 = 3.015e-05 * s4;
    const double K4yx = s4 * 3.7701e-07 * c4 + (l3x + l4x) * j4y1;
    const double j3y1 = 0.0001788 * s3;
    const double j4x1 = 3.015e-05 * c4;
    const double l4y = 0.0298 * s3;
    const double t3 = l4y * j4x1;
    const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + l3x * j3y1 + t3;
    const double j3x1 = 0.0001788 * c3;
    const double l3y = 0.04038 * s2;
    const double t4 = l3y * (j3x1 + j4x1);
    const double K2yx = s2 * 1.94855328e-05 * c2 + K3yx + t4;
    const double E2wQxx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double S3y = j3y1 + j4y1;
    const double S2y = 0.00054513 * s2 + S3y;
    const double E2sQxx = E2wQxx + 0.006 * (qd[1] * S2y + qd[2] * S3y + qd[3] * j4y1);
    const double cD2y = qd[0] * K2yx;
    const double w3z = qd[1] + qd[2];
    const double w4z = qd[3] + w3z;
    const double T4y = 1.613025e-07 * c4 * w4z;
    const double T3y = T4y + 7.0179e-07 * c3 * w3z;
    const double do2y = 0.006 * qd[0];
    const double t5 = do2y * S2y;
    const double cH2z = T3y + qd[1] * 1.253799e-06 * c2 - cD2y - t5;
    const double cD3y = qd[0] * K3yx;
    const double t6 = do2y * S3y;
    const double cD4y = qd[0] * K4yx;
    const double t7 = do2y * j4y1;
    const double G4y = j4y1 * w4z;
    const double G4x = j4x1 * w4z;
    const double C_2 = l4x * G4y - l4y * G4x;
    const double C_3 = w3z * (l4x * j4y1 - t3);
    const double Y3 = C_2 - C_3;
    const double C_8 = Y3 - qd[1] * (l3x * S3y - t4);
    const double t8 = l3x * (G4y + j3y1 * w3z);
    const double t9 = l3y * (G4x + j3x1 * w3z);
    C[0] = -E2sQxx;
    C[1] = cH2z;
    C[2] = T3y - cD3y - t6;
    C[3] = T4y - cD4y - t7;
    C[4] = cD2y + t5;
    C[5] = -(C_8 + t8 - t9);
    C[6] = -(Y3 + t8 - t9);
    C[7] = -(C_2 + l3x * G4y - l3y * G4x);
    C[8] = cD3y + t6;
    C[9] = -C_8;
    C[10] = -Y3;
    C[11] = -C_2;
    C[12] = cD4y + t7;
    C[13] = C_3 + qd[1] * (l3x * j4y1 - l3y * j4x1);
    C[14] = C_3;
    C[15] = 0.0;
}

void index_gravity(const double q[SINEW_AT_LEAST(4)], double g[SINEW_AT_LEAST(4)])
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
    g[1] = n3 + 0.005347725300000001 * c2;
    g[2] = n3;
    g[3] = n4;
}

void index_bias(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    double h[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(phi4, phi3);
    const double s4 = sines1.s[0];
    const double c4 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(q[1]);
    const double s2 = sines2.s[0];
    const double c2 = sines2.c[0];
    const double l3x = 0.04038 * c2;
    const double o3x = 0.006 + l3x;
    const double l4x = 0.0298 * c3;
    const double j4y1 = 3.015e-05 * s4;
    const double K4yx = s4 * 3.7701e-07 * c4 + (o3x + l4x) * j4y1;
    const double j3y1 = 0.0001788 * s3;
    const double j4x1 = 3.015e-05 * c4;
    const double t3 = 0.0298 * s3 * j4x1;
    const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + o3x * j3y1 + t3;
    const double j3x1 = 0.0001788 * c3;
    const double l3y = 0.04038 * s2;
    const double K2yx = s2 * (1.94855328e-05 * c2 + 3.27078e-06) + K3yx + l3y * (j3x1 + j4x1);
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double w3z = qd[1] + qd[2];
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double w3zz = w3z * w3z;
    const double w2zz = qd[1] * qd[1];
    const double t4 = 1.613025e-07 * c4 * w4zz + 7.0179e-07 * c3 * w3zz + 1.253799e-06 * c2 * w2zz;
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double X3_4 = l4x * j4y1 - t3;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = l3x * j3y1 - l3y * j3x1;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double n2 = n3 + 0.005347725300000001 * c2 - w3zz * X2_3 - w4zz * X2_4;
    const double w1zz = qd[0] * qd[0];
    h[0] = t4 - (qd[0] + qd[0]) * R2yx;
    h[1] = n2 + w1zz * K2yx;
    h[2] = n3 + w1zz * K3yx;
    h[3] = n4 + w1zz * K4yx;
}

void index_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(4)],
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
    const double j2u = 1.94855328e-05 * c2;
    const double j4u = 3.7701e-07 * c4;
    const double l3x = 0.04038 * c2;
    const double o3x = 0.006 + l3x;
    const double l4x = 0.0298 * c3;
    const double o4x = o3x + l4x;
    const double j4x1 = 3.015e-05 * c4;
    const double j3x1 = 0.0001788 * c3;
    const double t3 = l4x * j4x1;
    const double j2x1 = 0.00054513 * c2;
    const double t4 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t3 + 0.006 * j2x1;
    const double S3x = j3x1 + j4x1;
    const double t5 = l3x * S3x;
    const double Z1 = t4 + t5 + 0.006 * (j2x1 + S3x) + 1.1373674999999997e-06;
    M[0] = Z1;
    const double j4yz = 1.613025e-07 * s4;
    M[3] = j4yz;
    M[12] = j4yz;
    const double K3yz = 7.0179e-07 * s3 + j4yz;
    M[2] = K3yz;
    M[8] = K3yz;
    const double K2yz = 1.253799e-06 * s2 + K3yz;
    M[1] = K2yz;
    M[4] = K2yz;
    const double j4y1 = 3.015e-05 * s4;
    const double j3y1 = 0.0001788 * s3;
    const double l3y = 0.04038 * s2;
    const double lS3 = t5 + l3y * (j3y1 + j4y1);
    const double l4y = 0.0298 * s3;
    const double lS4 = t3 + l4y * j4y1;
    const double Z3 = 4.92521e-06 + (lS4 + lS4);
    M[10] = Z3;
    M[5] = 1.96475328e-05 + Z3 + (lS3 + lS3);
    const double M_4 = Z3 + lS3;
    M[6] = M_4;
    M[9] = M_4;
    const double M_2 = 4.3101e-07 + lS4;
    M[11] = M_2;
    M[14] = M_2;
    M[15] = 4.3101e-07;
    const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
    M[7] = M_2_2;
    M[13] = M_2_2;
    const double K4yx = s4 * j4u + o4x * j4y1;
    const double t6 = l4y * j4x1;
    const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t6;
    const double K2yx = s2 * (j2u + 3.27078e-06) + K3yx + l3y * S3x;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double w3z = qd[1] + qd[2];
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double w3zz = w3z * w3z;
    const double w2zz = qd[1] * qd[1];
    const double t7 = 1.613025e-07 * c4 * w4zz + 7.0179e-07 * c3 * w3zz + 1.253799e-06 * c2 * w2zz;
    h[0] = t7 - (qd[0] + qd[0]) * R2yx;
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double X3_4 = l4x * j4y1 - t6;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = l3x * j3y1 - l3y * j3x1;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double n2 = n3 + 9.81 * j2x1 - w3zz * X2_3 - w4zz * X2_4;
    const double w1zz = qd[0] * qd[0];
    h[1] = n2 + K2yx * w1zz;
    h[2] = n3 + K3yx * w1zz;
    h[3] = n4 + K4yx * w1zz;
}

void index_forward_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    const double tau[SINEW_AT_LEAST(4)], double qdd[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(phi4, phi3);
    const double s4 = sines1.s[0];
    const double c4 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(q[1]);
    const double s2 = sines2.s[0];
    const double c2 = sines2.c[0];
    const double j4yz = 1.613025e-07 * s4;
    const double L4_1 = 2320131.783485302 * j4yz;
    const double j2x1 = 0.00054513 * c2;
    const double j3x1 = 0.0001788 * c3;
    const double j4x1 = 3.015e-05 * c4;
    const double S3x = j3x1 + j4x1;
    const double l3x = 0.04038 * c2;
    const double t3 = l3x * S3x;
    const double l4x = 0.0298 * c3;
    const double t4 = l4x * j4x1;
    const double o3x = 0.006 + l3x;
    const double o4x = o3x + l4x;
    const double j4u = 3.7701e-07 * c4;
    const double j2u = 1.94855328e-05 * c2;
    const double j3u = 4.3862e-06 * c3;
    const double t5 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t4 + 0.006 * j2x1;
    const double K3yz = 7.0179e-07 * s3 + j4yz;
    const double l4y = 0.0298 * s3;
    const double j4y1 = 3.015e-05 * s4;
    const double lS4 = t4 + l4y * j4y1;
    const double M = 4.3101e-07 + lS4;
    const double L4_3 = 2320131.783485302 * M;
    const double A3_1 = K3yz - j4yz * L4_3;
    const double Z3 = 4.92521e-06 + (lS4 + lS4);
    const double r3 = 1.0 / (Z3 - M * L4_3);
    const double L3_1 = A3_1 * r3;
    const double l3y = 0.04038 * s2;
    const double M_2 = M + l3x * j4x1 + l3y * j4y1;
    const double L4_2 = 2320131.783485302 * M_2;
    const double j3y1 = 0.0001788 * s3;
    const double lS3 = t3 + l3y * (j3y1 + j4y1);
    const double A3_2 = Z3 + lS3 - M_2 * L4_3;
    const double L3_2 = A3_2 * r3;
    const double A2_1_2 = 1.253799e-06 * s2 + K3yz - j4yz * L4_2 - A3_1 * L3_2;
    const double A2_2 = 1.96475328e-05 + Z3 + (lS3 + lS3) - M_2 * L4_2;
    const double r2 = 1.0 / (A2_2 - A3_2 * L3_2);
    const double L2_1 = A2_1_2 * r2;
    const double t6 = t5 + t3 + 0.006 * (j2x1 + S3x) - j4yz * L4_1 - A3_1 * L3_1 - A2_1_2 * L2_1;
    const double w1zz = qd[0] * qd[0];
    const double K4yx = s4 * j4u + o4x * j4y1;
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double t7 = l4y * j4x1;
    const double X3_4 = l4x * j4y1 - t7;
    const double w2zz = qd[1] * qd[1];
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double y4 = tau[3] - n4 - K4yx * w1zz;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double t8 = tau[0] - 1.613025e-07 * c4 * w4zz - 7.0179e-07 * c3 * w3zz - 1.253799e-06 * c2
        * w2zz;
    const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t7;
    const double K2yx = s2 * (j2u + 3.27078e-06) + K3yx + l3y * S3x;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double X2_3 = l3x * j3y1 - l3y * j3x1;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double b3 = tau[2] - n3 - K3yx * w1zz - y4 * L4_3;
    const double t9 = tau[1] - n3 - 9.81 * j2x1 + w3zz * X2_3 + w4zz * X2_4 - K2yx * w1zz - y4
        * L4_2;
    const double b2_2 = t9 - b3 * L3_2;
    const double b1_4 = t8 + (qd[0] + qd[0]) * R2yx - y4 * L4_1 - b3 * L3_1 - b2_2 * L2_1;
    const double x1 = b1_4 * (1.0 / (t6 + 1.1373674999999997e-06));
    const double x2 = b2_2 * r2 - L2_1 * x1;
    const double x3 = b3 * r3 - L3_2 * x2 - L3_1 * x1;
    const double x4 = 2320131.783485302 * y4 - L4_3 * x3 - L4_2 * x2 - L4_1 * x1;
    qdd[0] = x1;
    qdd[1] = x2;
    qdd[2] = x3;
    qdd[3] = x4;
}

void index_inverse_dynamics(const double q[SINEW_AT_LEAST(4)], const double qd[SINEW_AT_LEAST(4)],
    const double qdd[SINEW_AT_LEAST(4)], double tau[SINEW_AT_LEAST(4)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = q[3] + phi3;
    const struct sinew_sines2 sines1 = sinew_one_sincos2(phi4, phi3);
    const double s4 = sines1.s[0];
    const double c4 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(q[1]);
    const double s2 = sines2.s[0];
    const double c2 = sines2.c[0];
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double al3z = qdd[1] + qdd[2];
    const double e3y = c3 * al3z - s3 * w3zz;
    const double w2zz = qd[1] * qd[1];
    const double a3y = 9.81 + 0.04038 * (qdd[1] * c2 - s2 * w2zz);
    const double j4x1 = 3.015e-05 * c4;
    const double al4z = qdd[3] + al3z;
    const double e3x = c3 * w3zz + s3 * al3z;
    const double e2x = qdd[1] * s2 + c2 * w2zz;
    const double a3x = 0.04038 * e2x;
    const double j4y1 = 3.015e-05 * s4;
    const double n4 = 4.3101e-07 * al4z + j4x1 * (a3y + 0.0298 * e3y) + j4y1 * (a3x + 0.0298 * e3x);
    const double j4yz = 1.613025e-07 * s4;
    const double l3x = 0.04038 * c2;
    const double o3x = 0.006 + l3x;
    const double l4x = 0.0298 * c3;
    const double o4x = o3x + l4x;
    const double j4u = 3.7701e-07 * c4;
    const double K4yx = s4 * j4u + o4x * j4y1;
    const double w1zz = qd[0] * qd[0];
    const double j3x1 = 0.0001788 * c3;
    const double j3y1 = 0.0001788 * s3;
    const double w4z = qd[3] + w3z;
    const double w4zz = w4z * w4z;
    const double F4y = 3.015e-05 * (c4 * al4z - s4 * w4zz);
    const double e4x = c4 * w4zz + s4 * al4z;
    const double F4x = 3.015e-05 * e4x;
    const double l4y = 0.0298 * s3;
    const double n3 = n4 + 4.4942e-06 * al3z + j3x1 * a3y + j3y1 * a3x + l4x * F4y + l4y * F4x;
    const double K3yz = 7.0179e-07 * s3 + j4yz;
    const double j3u = 4.3862e-06 * c3;
    const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + l4y * j4x1;
    const double j2x1 = 0.00054513 * c2;
    const double t3 = n3 + 1.96475328e-05 * qdd[1] + 9.81 * j2x1 + l3x * (F4y + 0.0001788 * e3y);
    const double l3y = 0.04038 * s2;
    const double j2u = 1.94855328e-05 * c2;
    const double S3x = j3x1 + j4x1;
    const double K2yx = s2 * (j2u + 3.27078e-06) + K3yx + l3y * S3x;
    const double t2 = t3 + l3y * (F4x + 0.0001788 * e3x) + qdd[0] * (1.253799e-06 * s2 + K3yz)
        + w1zz * K2yx;
    const double R2yx = qd[1] * K2yx + qd[2] * K3yx + qd[3] * K4yx;
    const double t4 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + l4x * j4x1 + 0.006
        * j2x1;
    const double t5 = qdd[0] * (t4 + l3x * S3x + 0.006 * (j2x1 + S3x) + 1.1373675000000002e-06);
    const double N1z = t5 + 1.613025e-07 * e4x + 7.0179e-07 * e3x + 1.253799e-06 * e2x - (qd[0]
        + qd[0]) * R2yx;
    tau[0] = N1z;
    tau[1] = t2;
    tau[2] = n3 + qdd[0] * K3yz + w1zz * K3yx;
    tau[3] = n4 + qdd[0] * j4yz + w1zz * K4yx;
}

void index_tendon_lengths(const double q[SINEW_AT_LEAST(4)], double h[SINEW_AT_LEAST(8)])
{
    const double t1 = 0.0065 * q[0];
    const double t2 = 0.0065 * q[1];
    const double t3 = t1 + t2;
    const double t4 = t1 - t2;
    const double t5 = 0.0055 * q[2];
    const double t6 = 0.0045 * q[3] - t5;
    h[0] = t3;
    h[1] = t4;
    h[2] = -t4;
    h[3] = -t3;
    h[4] = t5;
    h[5] = -t5;
    h[6] = -t6;
    h[7] = t6;
}

void index_coupling_matrix(const double q[SINEW_AT_LEAST(4)], double P[SINEW_AT_LEAST(32)])
{
    (void)q;
    P[0] = 0.0065;
    P[1] = 0.0065;
    P[2] = 0.0;
    P[3] = 0.0;
    P[4] = 0.0065;
    P[5] = -0.0065;
    P[6] = 0.0;
    P[7] = 0.0;
    P[8] = -0.0065;
    P[9] = 0.0065;
    P[10] = 0.0;
    P[11] = 0.0;
    P[12] = -0.0065;
    P[13] = -0.0065;
    P[14] = 0.0;
    P[15] = 0.0;
    P[16] = 0.0;
    P[17] = 0.0;
    P[18] = 0.0055;
    P[19] = 0.0;
    P[20] = 0.0;
    P[21] = 0.0;
    P[22] = -0.0055;
    P[23] = 0.0;
    P[24] = 0.0;
    P[25] = 0.0;
    P[26] = 0.0055;
    P[27] = -0.0045;
    P[28] = 0.0;
    P[29] = 0.0;
    P[30] = -0.0055;
    P[31] = 0.0045;
}

void index_joint_torque(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)],
    double tau[SINEW_AT_LEAST(4)])
{
    (void)q;
    const double t1 = 0.0065 * f[0];
    const double t2 = 0.0065 * f[1];
    const double t3 = 0.0065 * f[2];
    const double t4 = 0.0065 * f[3];
    tau[0] = -(t1 + t2 - t3 - t4);
    tau[1] = -(t1 - t2 + t3 - t4);
    tau[2] = -(0.0055 * (f[4] - f[5] + f[6] - f[7]));
    tau[3] = 0.0045 * (f[6] - f[7]);
}

void index_joint_stiffness(const double q[SINEW_AT_LEAST(4)], const double f[SINEW_AT_LEAST(8)],
    const double kt[SINEW_AT_LEAST(8)], double K[SINEW_AT_LEAST(16)])
{
    (void)q;
    (void)f;
    const double t1 = 4.225e-05 * kt[0];
    const double t2 = 4.225e-05 * kt[1];
    const double t3 = 4.225e-05 * kt[2];
    const double t4 = 4.225e-05 * kt[3];
    const double K1_1 = t1 + t2 + t3 + t4;
    const double K1_2 = t1 - t2 - t3 + t4;
    const double t5 = 0.0055 * kt[6] + 0.0055 * kt[7];
    const double K3_3 = 3.0249999999999997e-05 * (kt[4] + kt[5]) + 0.0055 * t5;
    const double t6 = -(0.0045 * t5);
    K[0] = K1_1;
    K[1] = K1_2;
    K[2] = 0.0;
    K[3] = 0.0;
    K[4] = K1_2;
    K[5] = K1_1;
    K[6] = 0.0;
    K[7] = 0.0;
    K[8] = 0.0;
    K[9] = 0.0;
    K[10] = K3_3;
    K[11] = t6;
    K[12] = 0.0;
    K[13] = 0.0;
    K[14] = t6;
    K[15] = 2.0249999999999998e-05 * (kt[6] + kt[7]);
}

void index_tendon_hessian(const double q[SINEW_AT_LEAST(4)], double H[SINEW_AT_LEAST(128)])
{
    (void)q;
    for (int i1 = 0; i1 < 8; ++i1) {
        H[16 * i1] = 0.0;
        H[1 + 16 * i1] = 0.0;
        H[2 + 16 * i1] = 0.0;
        H[3 + 16 * i1] = 0.0;
        H[4 + 16 * i1] = 0.0;
        H[5 + 16 * i1] = 0.0;
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
}

void index_link_position(const double h[SINEW_AT_LEAST(8)], double q[SINEW_AT_LEAST(4)])
{
    const double t1 = 38.46153846153846 * h[0];
    const double t2 = 38.46153846153846 * h[1];
    const double t3 = 38.46153846153846 * h[2];
    const double t4 = 38.46153846153846 * h[3];
    const double t5 = h[4] - h[5];
    q[0] = t1 + t2 - t3 - t4;
    q[1] = t1 - t2 + t3 - t4;
    q[2] = 90.90909090909092 * t5;
    q[3] = 111.11111111111111 * (t5 - h[6] + h[7]);
}

void index_link_position_covariance(double sigma, double covariance[SINEW_AT_LEAST(16)])
{
    const double variance = sigma * sigma;
    const double t1 = 5917.15976331361 * variance;
    const double t2 = 20202.0202020202 * variance;
    covariance[0] = t1;
    covariance[1] = 0.0;
    covariance[2] = 0.0;
    covariance[3] = 0.0;
    covariance[4] = 0.0;
    covariance[5] = t1;
    covariance[6] = 0.0;
    covariance[7] = 0.0;
    covariance[8] = 0.0;
    covariance[9] = 0.0;
    covariance[10] = 16528.92561983471 * variance;
    covariance[11] = t2;
    covariance[12] = 0.0;
    covariance[13] = 0.0;
    covariance[14] = t2;
    covariance[15] = 49382.71604938272 * variance;
}

void index_bending_angles(const double q[SINEW_AT_LEAST(4)], double angles[SINEW_AT_LEAST(8)])
{
    const double t1 = sinew_max(q[0], -q[0]) + sinew_max(q[1], -q[1]);
    const double t2 = sinew_max(q[2], -q[2]);
    const double t3 = t2 + sinew_max(q[3], -q[3]);
    angles[0] = t1;
    angles[1] = t1;
    angles[2] = t1;
    angles[3] = t1;
    angles[4] = t2;
    angles[5] = t2;
    angles[6] = t3;
    angles[7] = t3;
}
