/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Fifth finger: coupled PIP and DIP, three coordinates, six tendons
 *
 * Made by: sinew generate models/fifth
 * Model:   sha256 ae27d826145740fcb6e3f8c3b6f00dad5a582dbf0da2c06f617ce673f467b351
 * Do not edit: change the model and generate again.
 */
#include "fifth.h"

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

void fifth_forward_kinematics(const double q[SINEW_AT_LEAST(3)], double T[SINEW_AT_LEAST(16)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
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
    const double t3 = 0.0048 + (0.032304 * c2 + 0.02384 * c3);
    const double R42x = s1 * c4;
    const double ptipz = 0.032304 * s2 + 0.02384 * s3 + 0.01608 * s4;
    T[0] = R41x;
    T[1] = -(c1 * s4);
    T[2] = s1;
    T[3] = c1 * t3 - 0.00456 * s1 + 0.01608 * R41x;
    T[4] = R42x;
    T[5] = -(s1 * s4);
    T[6] = -c1;
    T[7] = s1 * t3 + 0.00456 * c1 + 0.01608 * R42x;
    T[8] = s4;
    T[9] = c4;
    T[10] = 0.0;
    T[11] = ptipz;
    T[12] = 0.0;
    T[13] = 0.0;
    T[14] = 0.0;
    T[15] = 1.0;
}

void fifth_tip_jacobian(const double q[SINEW_AT_LEAST(3)], double J[SINEW_AT_LEAST(18)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
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
    J[10] = s1;
    const double p2y = 0.0048 * s1;
    const double l3x = 0.032304 * c2;
    const double o4x = l3x + 0.02384 * c3;
    const double p4y = p2y + s1 * o4x;
    const double ptipy = p4y + 0.00456 * c1 + 0.01608 * s1 * c4;
    J[0] = -ptipy;
    const double l3y = 0.032304 * s2;
    const double o4y = l3y + 0.02384 * s3;
    const double ptipz = o4y + 0.01608 * s4;
    J[1] = -(c1 * ptipz);
    const double arm3_4 = l3y - ptipz;
    const double t3 = 1.2222222222222223 * c1;
    const double arm4_4 = o4y - ptipz;
    J[2] = c1 * arm3_4 + t3 * arm4_4;
    const double p2x = 0.0048 * c1;
    const double p4x = p2x + c1 * o4x;
    const double ptipx = p4x - 0.00456 * s1 + 0.01608 * c1 * c4;
    J[3] = ptipx;
    J[4] = -(s1 * ptipz);
    const double t4 = 1.2222222222222223 * s1;
    J[5] = s1 * arm3_4 + t4 * arm4_4;
    J[6] = 0.0;
    J[7] = -(c1 * (p2x - ptipx) + s1 * (p2y - ptipy));
    const double t5 = c1 * (p2x + c1 * l3x - ptipx) + s1 * (p2y + s1 * l3x - ptipy) + t3 * (p4x
        - ptipx);
    J[8] = -(t5 + t4 * (p4y - ptipy));
    J[9] = 0.0;
    J[11] = 2.2222222222222223 * s1;
    J[12] = 0.0;
    J[13] = -c1;
    J[14] = -(2.2222222222222223 * c1);
    J[16] = 0.0;
    J[17] = 0.0;
    J[15] = 1.0;
}

void fifth_mass_matrix(const double q[SINEW_AT_LEAST(3)], double M[SINEW_AT_LEAST(9)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double t3 = c2 * (6.37008946786e-06 * c2) + c3 * (1.427316736e-06 * c3) + c4
        * (1.185619968e-07 * c4);
    const double l4x = 0.02384 * c3;
    const double l3x = 0.032304 * c2;
    const double j4x1 = 1.234944e-05 * c4;
    const double j3x1 = 7.323648000000001e-05 * c3;
    const double t4 = l4x * j4x1;
    const double S3x = j3x1 + j4x1;
    const double t5 = l3x * S3x;
    const double t6 = t3 + (l3x + l4x) * j4x1 + l3x * j3x1 + t4 + t5 + 0.0096 * (0.000223285248 * c2
        + S3x);
    const double j4yz = 5.2855603200000006e-08 * s4;
    const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
    const double K2yz = 4.1084485632e-07 * s2 + K3yz;
    const double t7 = K3yz + 1.2222222222222223 * j4yz;
    const double j4y1 = 1.234944e-05 * s4;
    const double l3y = 0.032304 * s2;
    const double lS3 = t5 + l3y * (7.323648000000001e-05 * s3 + j4y1);
    const double lS4 = t4 + 0.02384 * s3 * j4y1;
    const double Z3 = 1.6288227328e-06 + (lS4 + lS4);
    const double M_2 = 1.462099968e-07 + lS4;
    const double t8 = Z3 + lS3 + 1.2222222222222223 * (M_2 + l3x * j4x1 + l3y * j4y1);
    M[0] = t6 + 4.357300224e-07;
    M[1] = K2yz;
    M[2] = t7;
    M[3] = K2yz;
    M[4] = 6.45303346786e-06 + Z3 + (lS3 + lS3);
    M[5] = t8;
    M[6] = t7;
    M[7] = t8;
    M[8] = 2.1841246435555558e-07 + Z3 + 2.4444444444444446 * M_2;
}

void fifth_coriolis_matrix(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    double C[SINEW_AT_LEAST(9)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double l4x = 0.02384 * c3;
    const double l3x = 0.032304 * c2;
    const double j4y1 = 1.234944e-05 * s4;
    const double K4yx = s4 * 1.185619968e-07 * c4 + (l3x + l4x) * j4y1;
    const double j3y1 = 7.323648000000001e-05 * s3;
    const double j4x1 = 1.234944e-05 * c4;
    const double l4y = 0.02384 * s3;
    const double t3 = l4y * j4x1;
    const double K3yx = s3 * 1.427316736e-06 * c3 + K4yx + l3x * j3y1 + t3;
    const double j3x1 = 7.323648000000001e-05 * c3;
    const double l3y = 0.032304 * s2;
    const double t4 = l3y * (j3x1 + j4x1);
    const double K2yx = s2 * 6.37008946786e-06 * c2 + K3yx + t4;
    const double t5 = 1.2222222222222223 * qd[2];
    const double S3y = j3y1 + j4y1;
    const double S2y = 0.000223285248 * s2 + S3y;
    const double E2sQxx = qd[1] * K2yx + qd[2] * K3yx + t5 * K4yx + 0.0048 * (qd[1] * S2y + qd[2]
        * S3y + t5 * j4y1);
    const double cD2y = qd[0] * K2yx;
    const double w3z = qd[1] + qd[2];
    const double w4z = w3z + t5;
    const double T4y = 5.2855603200000006e-08 * c4 * w4z;
    const double T3y = T4y + 2.2996254720000002e-07 * c3 * w3z;
    const double do2y = 0.0048 * qd[0];
    const double t6 = do2y * S2y;
    const double cH2z = T3y + qd[1] * 4.1084485632e-07 * c2 - cD2y - t6;
    const double cD3y = qd[0] * K3yx;
    const double t7 = do2y * S3y;
    const double cD4y = qd[0] * K4yx;
    const double t8 = do2y * j4y1;
    const double G4y = j4y1 * w4z;
    const double G4x = j4x1 * w4z;
    const double C_2 = l4x * G4y - l4y * G4x;
    const double C_3 = w3z * (l4x * j4y1 - t3);
    const double Y3 = C_2 - C_3;
    const double C_8 = Y3 - qd[1] * (l3x * S3y - t4);
    const double t9 = l3x * (G4y + j3y1 * w3z);
    const double t10 = l3y * (G4x + j3x1 * w3z);
    C[0] = -E2sQxx;
    C[1] = cH2z;
    C[2] = T3y - cD3y - t7 + 1.2222222222222223 * (T4y - cD4y - t8);
    C[3] = cD2y + t6;
    C[4] = -(C_8 + t9 - t10);
    C[5] = -(Y3 + t9 - t10 + 1.2222222222222223 * (C_2 + l3x * G4y - l3y * G4x));
    C[6] = cD3y + t7 + 1.2222222222222223 * (cD4y + t8);
    C[7] = -(C_8 - 1.2222222222222223 * (C_3 + qd[1] * (l3x * j4y1 - l3y * j4x1)));
    C[8] = -(1.2222222222222223 * Y3 + Y3);
}

void fifth_gravity(const double q[SINEW_AT_LEAST(3)], double g[SINEW_AT_LEAST(3)])
{
    const double phi3 = q[1] + q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(phi3 + 1.2222222222222223 * q[2], phi3);
    const double c4 = sines1.c[0];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines4 = sinew_one_sincos(q[1]);
    const double c2 = sines4.c[0];
    const double n4 = 0.00012114800640000001 * c4;
    const double n3 = n4 + 0.0007184498688000002 * c3;
    g[0] = 0.0;
    g[1] = n3 + 0.00219042828288 * c2;
    g[2] = n3 + 1.2222222222222223 * n4;
}

void fifth_bias(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    double h[SINEW_AT_LEAST(3)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(phi4, phi3);
    const double s4 = sines1.s[0];
    const double c4 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(q[1]);
    const double s2 = sines2.s[0];
    const double c2 = sines2.c[0];
    const double l3x = 0.032304 * c2;
    const double o3x = 0.0048 + l3x;
    const double l4x = 0.02384 * c3;
    const double j4y1 = 1.234944e-05 * s4;
    const double K4yx = s4 * 1.185619968e-07 * c4 + (o3x + l4x) * j4y1;
    const double j3y1 = 7.323648000000001e-05 * s3;
    const double j4x1 = 1.234944e-05 * c4;
    const double t3 = 0.02384 * s3 * j4x1;
    const double K3yx = s3 * 1.427316736e-06 * c3 + K4yx + o3x * j3y1 + t3;
    const double j3x1 = 7.323648000000001e-05 * c3;
    const double l3y = 0.032304 * s2;
    const double K2yx = s2 * (6.37008946786e-06 * c2 + 1.0717691904e-06) + K3yx + l3y * (j3x1
        + j4x1);
    const double t4 = 1.2222222222222223 * qd[2];
    const double w3z = qd[1] + qd[2];
    const double w4z = w3z + t4;
    const double w4zz = w4z * w4z;
    const double w3zz = w3z * w3z;
    const double w2zz = qd[1] * qd[1];
    const double t5 = 5.2855603200000006e-08 * c4 * w4zz + 2.2996254720000002e-07 * c3 * w3zz
        + 4.1084485632e-07 * c2 * w2zz;
    const double Q2y = t5 - (qd[0] + qd[0]) * (qd[1] * K2yx + qd[2] * K3yx + t4 * K4yx);
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double X3_4 = l4x * j4y1 - t3;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = l3x * j3y1 - l3y * j3x1;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double n2 = n3 + 0.00219042828288 * c2 - w3zz * X2_3 - w4zz * X2_4;
    const double w1zz = qd[0] * qd[0];
    h[0] = Q2y;
    h[1] = n2 + w1zz * K2yx;
    h[2] = n3 + w1zz * K3yx + 1.2222222222222223 * (n4 + w1zz * K4yx);
}

void fifth_mass_matrix_and_bias(const double q[SINEW_AT_LEAST(3)],
    const double qd[SINEW_AT_LEAST(3)], double M[SINEW_AT_LEAST(9)], double h[SINEW_AT_LEAST(3)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(q[1], phi3);
    const double s2 = sines1.s[0];
    const double c2 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(phi4);
    const double s4 = sines2.s[0];
    const double c4 = sines2.c[0];
    const double j3u = 1.427316736e-06 * c3;
    const double j2u = 6.37008946786e-06 * c2;
    const double j4u = 1.185619968e-07 * c4;
    const double l3x = 0.032304 * c2;
    const double o3x = 0.0048 + l3x;
    const double l4x = 0.02384 * c3;
    const double o4x = o3x + l4x;
    const double j4x1 = 1.234944e-05 * c4;
    const double j3x1 = 7.323648000000001e-05 * c3;
    const double t3 = l4x * j4x1;
    const double j2x1 = 0.000223285248 * c2;
    const double t4 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t3 + 0.0048 * j2x1;
    const double S3x = j3x1 + j4x1;
    const double t5 = l3x * S3x;
    const double Z1 = t4 + t5 + 0.0048 * (j2x1 + S3x) + 4.357300224e-07;
    const double j4yz = 5.2855603200000006e-08 * s4;
    const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
    const double K2yz = 4.1084485632e-07 * s2 + K3yz;
    const double t6 = K3yz + 1.2222222222222223 * j4yz;
    const double j4y1 = 1.234944e-05 * s4;
    const double j3y1 = 7.323648000000001e-05 * s3;
    const double l3y = 0.032304 * s2;
    const double lS3 = t5 + l3y * (j3y1 + j4y1);
    const double l4y = 0.02384 * s3;
    const double lS4 = t3 + l4y * j4y1;
    const double Z3 = 1.6288227328e-06 + (lS4 + lS4);
    const double M_2 = 1.462099968e-07 + lS4;
    const double t7 = Z3 + lS3 + 1.2222222222222223 * (M_2 + l3x * j4x1 + l3y * j4y1);
    const double K4yx = s4 * j4u + o4x * j4y1;
    const double t8 = l4y * j4x1;
    const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t8;
    const double K2yx = s2 * (j2u + 1.0717691904e-06) + K3yx + l3y * S3x;
    const double t9 = 1.2222222222222223 * qd[2];
    const double w3z = qd[1] + qd[2];
    const double w4z = w3z + t9;
    const double w4zz = w4z * w4z;
    const double w3zz = w3z * w3z;
    const double w2zz = qd[1] * qd[1];
    const double t10 = 5.2855603200000006e-08 * c4 * w4zz + 2.2996254720000002e-07 * c3 * w3zz
        + 4.1084485632e-07 * c2 * w2zz;
    const double Q2y = t10 - (qd[0] + qd[0]) * (qd[1] * K2yx + qd[2] * K3yx + t9 * K4yx);
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double X3_4 = l4x * j4y1 - t8;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = l3x * j3y1 - l3y * j3x1;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double n2 = n3 + 9.81 * j2x1 - w3zz * X2_3 - w4zz * X2_4;
    const double w1zz = qd[0] * qd[0];
    M[0] = Z1;
    M[1] = K2yz;
    M[2] = t6;
    M[3] = K2yz;
    M[4] = 6.45303346786e-06 + Z3 + (lS3 + lS3);
    M[5] = t7;
    M[6] = t6;
    M[7] = t7;
    M[8] = 2.1841246435555558e-07 + Z3 + 2.4444444444444446 * M_2;
    h[0] = Q2y;
    h[1] = n2 + K2yx * w1zz;
    h[2] = n3 + K3yx * w1zz + 1.2222222222222223 * (n4 + K4yx * w1zz);
}

void fifth_forward_dynamics(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    const double tau[SINEW_AT_LEAST(3)], double qdd[SINEW_AT_LEAST(3)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
    const struct sinew_sines2 sines1 = sinew_one_sincos2(phi4, phi3);
    const double s4 = sines1.s[0];
    const double c4 = sines1.c[0];
    const double s3 = sines1.s[1];
    const double c3 = sines1.c[1];
    const struct sinew_sines sines2 = sinew_one_sincos(q[1]);
    const double s2 = sines2.s[0];
    const double c2 = sines2.c[0];
    const double j2x1 = 0.000223285248 * c2;
    const double j3x1 = 7.323648000000001e-05 * c3;
    const double j4x1 = 1.234944e-05 * c4;
    const double S3x = j3x1 + j4x1;
    const double l3x = 0.032304 * c2;
    const double t3 = l3x * S3x;
    const double l4x = 0.02384 * c3;
    const double t4 = l4x * j4x1;
    const double o3x = 0.0048 + l3x;
    const double o4x = o3x + l4x;
    const double j2u = 6.37008946786e-06 * c2;
    const double j3u = 1.427316736e-06 * c3;
    const double j4u = 1.185619968e-07 * c4;
    const double t5 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t4 + 0.0048 * j2x1;
    const double j4yz = 5.2855603200000006e-08 * s4;
    const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
    const double t6 = 1e+16 * K3yz + 12222222222222224.0 * j4yz;
    const double l4y = 0.02384 * s3;
    const double j4y1 = 1.234944e-05 * s4;
    const double lS4 = t4 + l4y * j4y1;
    const double M = 1.462099968e-07 + lS4;
    const double Z3 = 1.6288227328e-06 + (lS4 + lS4);
    const double r3 = 0.40909090909090906 / (8.935055360000001e-08 + M + 0.40909090909090906 * Z3);
    const double t7 = 1e-16 * r3;
    const double L3_1 = t7 * t6;
    const double l3y = 0.032304 * s2;
    const double j3y1 = 7.323648000000001e-05 * s3;
    const double lS3 = t3 + l3y * (j3y1 + j4y1);
    const double t8 = 1e+16 * (Z3 + lS3) + 12222222222222224.0 * (M + l3x * j4x1 + l3y * j4y1);
    const double L3_2 = t7 * t8;
    const double t9 = 1e-16 * L3_2;
    const double A2_1 = 4.1084485632e-07 * s2 + K3yz - t9 * t6;
    const double A2_2 = 6.45303346786e-06 + Z3 + (lS3 + lS3) - t9 * t8;
    const double r2 = 1.0 / A2_2;
    const double L2_1 = A2_1 * r2;
    const double A1_1_2 = t5 + t3 + 0.0048 * (j2x1 + S3x) - 1e-16 * L3_1 * t6 - A2_1 * L2_1
        + 4.357300224e-07;
    const double w2zz = qd[1] * qd[1];
    const double w3z = qd[1] + qd[2];
    const double w3zz = w3z * w3z;
    const double t10 = 1.2222222222222223 * qd[2];
    const double w4z = w3z + t10;
    const double w4zz = w4z * w4z;
    const double t11 = tau[0] - 5.2855603200000006e-08 * c4 * w4zz - 2.2996254720000002e-07 * c3
        * w3zz;
    const double K4yx = s4 * j4u + o4x * j4y1;
    const double t12 = l4y * j4x1;
    const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t12;
    const double K2yx = s2 * (j2u + 1.0717691904e-06) + K3yx + l3y * S3x;
    const double t13 = t11 - 4.1084485632e-07 * c2 * w2zz + (qd[0] + qd[0]) * (qd[1] * K2yx + qd[2]
        * K3yx + t10 * K4yx);
    const double w1zz = qd[0] * qd[0];
    const double X3_4 = l4x * j4y1 - t12;
    const double X2_4 = l3x * j4y1 - l3y * j4x1;
    const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
    const double X2_3 = l3x * j3y1 - l3y * j3x1;
    const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
    const double y3 = tau[2] - n3 - K3yx * w1zz - 1.2222222222222223 * (n4 + K4yx * w1zz);
    const double b2 = tau[1] - n3 - 9.81 * j2x1 + w3zz * X2_3 + w4zz * X2_4 - K2yx * w1zz - y3
        * L3_2;
    const double x1 = (t13 - y3 * L3_1 - b2 * L2_1) * (1.0 / A1_1_2);
    const double x2 = b2 * r2 - L2_1 * x1;
    qdd[0] = x1;
    qdd[1] = x2;
    qdd[2] = y3 * r3 - L3_2 * x2 - L3_1 * x1;
}

void fifth_inverse_dynamics(const double q[SINEW_AT_LEAST(3)], const double qd[SINEW_AT_LEAST(3)],
    const double qdd[SINEW_AT_LEAST(3)], double tau[SINEW_AT_LEAST(3)])
{
    const double phi3 = q[1] + q[2];
    const double phi4 = phi3 + 1.2222222222222223 * q[2];
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
    const double a3y = 9.81 + 0.032304 * (qdd[1] * c2 - s2 * w2zz);
    const double j4x1 = 1.234944e-05 * c4;
    const double al4z = al3z + 1.2222222222222223 * qdd[2];
    const double e3x = c3 * w3zz + s3 * al3z;
    const double e2x = qdd[1] * s2 + c2 * w2zz;
    const double a3x = 0.032304 * e2x;
    const double j4y1 = 1.234944e-05 * s4;
    const double n4 = 1.462099968e-07 * al4z + j4x1 * (a3y + 0.02384 * e3y) + j4y1 * (a3x + 0.02384
        * e3x);
    const double j3x1 = 7.323648000000001e-05 * c3;
    const double j3y1 = 7.323648000000001e-05 * s3;
    const double t3 = 1.2222222222222223 * qd[2];
    const double w4z = w3z + t3;
    const double w4zz = w4z * w4z;
    const double F4y = 1.234944e-05 * (c4 * al4z - s4 * w4zz);
    const double l4x = 0.02384 * c3;
    const double e4x = c4 * w4zz + s4 * al4z;
    const double F4x = 1.234944e-05 * e4x;
    const double l4y = 0.02384 * s3;
    const double n3 = n4 + 1.482612736e-06 * al3z + j3x1 * a3y + j3y1 * a3x + l4x * F4y + l4y * F4x;
    const double j4yz = 5.2855603200000006e-08 * s4;
    const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
    const double l3x = 0.032304 * c2;
    const double o3x = 0.0048 + l3x;
    const double o4x = o3x + l4x;
    const double j4u = 1.185619968e-07 * c4;
    const double K4yx = s4 * j4u + o4x * j4y1;
    const double j3u = 1.427316736e-06 * c3;
    const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + l4y * j4x1;
    const double w1zz = qd[0] * qd[0];
    const double t4 = n3 + qdd[0] * K3yz + w1zz * K3yx + 1.2222222222222223 * (n4 + qdd[0] * j4yz
        + w1zz * K4yx);
    const double j2x1 = 0.000223285248 * c2;
    const double t5 = n3 + 6.45303346786e-06 * qdd[1] + 9.81 * j2x1 + l3x * (F4y
        + 7.323648000000001e-05 * e3y);
    const double l3y = 0.032304 * s2;
    const double n2 = t5 + l3y * (F4x + 7.323648000000001e-05 * e3x);
    const double j2u = 6.37008946786e-06 * c2;
    const double S3x = j3x1 + j4x1;
    const double K2yx = s2 * (j2u + 1.0717691904e-06) + K3yx + l3y * S3x;
    const double t2 = n2 + qdd[0] * (4.1084485632e-07 * s2 + K3yz) + w1zz * K2yx;
    const double t6 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + l4x * j4x1 + 0.0048
        * j2x1;
    const double t7 = qdd[0] * (t6 + l3x * S3x + 0.0048 * (j2x1 + S3x) + 4.3573002239999995e-07);
    const double t8 = t7 + 5.2855603200000006e-08 * e4x + 2.2996254720000002e-07 * e3x
        + 4.1084485632e-07 * e2x;
    const double N1z = t8 - (qd[0] + qd[0]) * (qd[1] * K2yx + qd[2] * K3yx + t3 * K4yx);
    tau[0] = N1z;
    tau[1] = t2;
    tau[2] = t4;
}

void fifth_tendon_lengths(const double q[SINEW_AT_LEAST(3)], double h[SINEW_AT_LEAST(6)])
{
    const double t1 = 0.0052 * q[0];
    const double t2 = 0.0052 * q[1];
    const double t3 = t1 + t2;
    const double t4 = t1 - t2;
    const double t5 = 0.0088 * q[2];
    h[0] = t3;
    h[1] = t4;
    h[2] = -t4;
    h[3] = -t3;
    h[4] = t5;
    h[5] = -t5;
}

void fifth_coupling_matrix(const double q[SINEW_AT_LEAST(3)], double P[SINEW_AT_LEAST(18)])
{
    (void)q;
    P[0] = 0.0052;
    P[1] = 0.0052;
    P[2] = 0.0;
    P[3] = 0.0052;
    P[4] = -0.0052;
    P[5] = 0.0;
    P[6] = -0.0052;
    P[7] = 0.0052;
    P[8] = 0.0;
    P[9] = -0.0052;
    P[10] = -0.0052;
    P[11] = 0.0;
    P[12] = 0.0;
    P[13] = 0.0;
    P[14] = 0.0088;
    P[15] = 0.0;
    P[16] = 0.0;
    P[17] = -0.0088;
}

void fifth_joint_torque(const double q[SINEW_AT_LEAST(3)], const double f[SINEW_AT_LEAST(6)],
    double tau[SINEW_AT_LEAST(3)])
{
    (void)q;
    const double t1 = 0.0052 * f[0];
    const double t2 = 0.0052 * f[1];
    const double t3 = 0.0052 * f[2];
    const double t4 = 0.0052 * f[3];
    tau[0] = -(t1 + t2 - t3 - t4);
    tau[1] = -(t1 - t2 + t3 - t4);
    tau[2] = -(0.0088 * (f[4] - f[5]));
}

void fifth_joint_stiffness(const double q[SINEW_AT_LEAST(3)], const double f[SINEW_AT_LEAST(6)],
    const double kt[SINEW_AT_LEAST(6)], double K[SINEW_AT_LEAST(9)])
{
    (void)q;
    (void)f;
    const double t1 = 2.704e-05 * kt[0];
    const double t2 = 2.704e-05 * kt[1];
    const double t3 = 2.704e-05 * kt[2];
    const double t4 = 2.704e-05 * kt[3];
    const double K1_1 = t1 + t2 + t3 + t4;
    const double K1_2 = t1 - t2 - t3 + t4;
    K[0] = K1_1;
    K[1] = K1_2;
    K[2] = 0.0;
    K[3] = K1_2;
    K[4] = K1_1;
    K[5] = 0.0;
    K[6] = 0.0;
    K[7] = 0.0;
    K[8] = 7.744e-05 * (kt[4] + kt[5]);
}

void fifth_tendon_hessian(const double q[SINEW_AT_LEAST(3)], double H[SINEW_AT_LEAST(54)])
{
    (void)q;
    for (int i1 = 0; i1 < 6; ++i1) {
        H[9 * i1] = 0.0;
        H[1 + 9 * i1] = 0.0;
        H[2 + 9 * i1] = 0.0;
        H[3 + 9 * i1] = 0.0;
        H[4 + 9 * i1] = 0.0;
        H[5 + 9 * i1] = 0.0;
        H[6 + 9 * i1] = 0.0;
        H[7 + 9 * i1] = 0.0;
        H[8 + 9 * i1] = 0.0;
    }
}

void fifth_link_position(const double h[SINEW_AT_LEAST(6)], double q[SINEW_AT_LEAST(3)])
{
    const double t1 = 48.07692307692308 * h[0];
    const double t2 = 48.07692307692308 * h[1];
    const double t3 = 48.07692307692308 * h[2];
    const double t4 = 48.07692307692308 * h[3];
    q[0] = t1 + t2 - t3 - t4;
    q[1] = t1 - t2 + t3 - t4;
    q[2] = 56.81818181818181 * (h[4] - h[5]);
}

void fifth_link_position_covariance(double sigma, double covariance[SINEW_AT_LEAST(9)])
{
    const double variance = sigma * sigma;
    const double t1 = 9245.562130177515 * variance;
    covariance[0] = t1;
    covariance[1] = 0.0;
    covariance[2] = 0.0;
    covariance[3] = 0.0;
    covariance[4] = t1;
    covariance[5] = 0.0;
    covariance[6] = 0.0;
    covariance[7] = 0.0;
    covariance[8] = 6456.611570247934 * variance;
}

void fifth_bending_angles(const double q[SINEW_AT_LEAST(3)], double angles[SINEW_AT_LEAST(6)])
{
    const double t1 = sinew_max(q[0], -q[0]) + sinew_max(q[1], -q[1]);
    const double t2 = 1.2222222222222223 * q[2];
    const double t3 = sinew_max(q[2], -q[2]) + sinew_max(t2, -t2);
    angles[0] = t1;
    angles[1] = t1;
    angles[2] = t1;
    angles[3] = t1;
    angles[4] = t3;
    angles[5] = t3;
}
