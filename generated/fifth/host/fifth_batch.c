/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model fifth over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/fifth
 * Model:   sha256 ae27d826145740fcb6e3f8c3b6f00dad5a582dbf0da2c06f617ce673f467b351
 * Do not edit: change the model and generate again.
 */
#include "fifth_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void fifth_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        const double R41x = c1 * c4;
        const double t1 = 0.0048 + (0.032304 * c2 + 0.02384 * c3);
        const double R42x = s1 * c4;
        const double ptipz = 0.032304 * s2 + 0.02384 * s3 + 0.01608 * s4;
        T[state] = R41x;
        T[1 * n + state] = -(c1 * s4);
        T[2 * n + state] = s1;
        T[3 * n + state] = c1 * t1 - 0.00456 * s1 + 0.01608 * R41x;
        T[4 * n + state] = R42x;
        T[5 * n + state] = -(s1 * s4);
        T[6 * n + state] = -c1;
        T[7 * n + state] = s1 * t1 + 0.00456 * c1 + 0.01608 * R42x;
        T[8 * n + state] = s4;
        T[9 * n + state] = c4;
        T[10 * n + state] = 0.0;
        T[11 * n + state] = ptipz;
        T[12 * n + state] = 0.0;
        T[13 * n + state] = 0.0;
        T[14 * n + state] = 0.0;
        T[15 * n + state] = 1.0;
    }
}

void fifth_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double p2y = 0.0048 * s1;
        const double l3x = 0.032304 * c2;
        const double o4x = l3x + 0.02384 * c3;
        const double p4y = p2y + s1 * o4x;
        const double ptipy = p4y + 0.00456 * c1 + 0.01608 * s1 * c4;
        const double l3y = 0.032304 * s2;
        const double o4y = l3y + 0.02384 * s3;
        const double ptipz = o4y + 0.01608 * s4;
        const double arm3_4 = l3y - ptipz;
        const double t1 = 1.2222222222222223 * c1;
        const double arm4_4 = o4y - ptipz;
        const double p2x = 0.0048 * c1;
        const double p4x = p2x + c1 * o4x;
        const double ptipx = p4x - 0.00456 * s1 + 0.01608 * c1 * c4;
        const double t2 = 1.2222222222222223 * s1;
        const double t3 = c1 * (p2x + c1 * l3x - ptipx) + s1 * (p2y + s1 * l3x - ptipy) + t1 * (p4x
            - ptipx);
        J[state] = -ptipy;
        J[1 * n + state] = -(c1 * ptipz);
        J[2 * n + state] = c1 * arm3_4 + t1 * arm4_4;
        J[3 * n + state] = ptipx;
        J[4 * n + state] = -(s1 * ptipz);
        J[5 * n + state] = s1 * arm3_4 + t2 * arm4_4;
        J[6 * n + state] = 0.0;
        J[7 * n + state] = -(c1 * (p2x - ptipx) + s1 * (p2y - ptipy));
        J[8 * n + state] = -(t3 + t2 * (p4y - ptipy));
        J[9 * n + state] = 0.0;
        J[10 * n + state] = s1;
        J[11 * n + state] = 2.2222222222222223 * s1;
        J[12 * n + state] = 0.0;
        J[13 * n + state] = -c1;
        J[14 * n + state] = -(2.2222222222222223 * c1);
        J[15 * n + state] = 1.0;
        J[16 * n + state] = 0.0;
        J[17 * n + state] = 0.0;
    }
}

void fifth_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double t1 = c2 * (6.37008946786e-06 * c2) + c3 * (1.427316736e-06 * c3) + c4
            * (1.185619968e-07 * c4);
        const double l4x = 0.02384 * c3;
        const double l3x = 0.032304 * c2;
        const double j4x1 = 1.234944e-05 * c4;
        const double j3x1 = 7.323648000000001e-05 * c3;
        const double t2 = l4x * j4x1;
        const double S3x = j3x1 + j4x1;
        const double t3 = l3x * S3x;
        const double t4 = t1 + (l3x + l4x) * j4x1 + l3x * j3x1 + t2 + t3 + 0.0096 * (0.000223285248
            * c2 + S3x);
        const double j4yz = 5.2855603200000006e-08 * s4;
        const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
        const double K2yz = 4.1084485632e-07 * s2 + K3yz;
        const double t5 = K3yz + 1.2222222222222223 * j4yz;
        const double j4y1 = 1.234944e-05 * s4;
        const double l3y = 0.032304 * s2;
        const double lS3 = t3 + l3y * (7.323648000000001e-05 * s3 + j4y1);
        const double lS4 = t2 + 0.02384 * s3 * j4y1;
        const double Z3 = 1.6288227328e-06 + (lS4 + lS4);
        const double M_2 = 1.462099968e-07 + lS4;
        const double t6 = Z3 + lS3 + 1.2222222222222223 * (M_2 + l3x * j4x1 + l3y * j4y1);
        M[state] = t4 + 4.357300224e-07;
        M[1 * n + state] = K2yz;
        M[2 * n + state] = t5;
        M[3 * n + state] = K2yz;
        M[4 * n + state] = 6.45303346786e-06 + Z3 + (lS3 + lS3);
        M[5 * n + state] = t6;
        M[6 * n + state] = t5;
        M[7 * n + state] = t6;
        M[8 * n + state] = 2.1841246435555558e-07 + Z3 + 2.4444444444444446 * M_2;
    }
}

void fifth_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double l4x = 0.02384 * c3;
        const double l3x = 0.032304 * c2;
        const double j4y1 = 1.234944e-05 * s4;
        const double K4yx = s4 * 1.185619968e-07 * c4 + (l3x + l4x) * j4y1;
        const double j3y1 = 7.323648000000001e-05 * s3;
        const double j4x1 = 1.234944e-05 * c4;
        const double l4y = 0.02384 * s3;
        const double t1 = l4y * j4x1;
        const double K3yx = s3 * 1.427316736e-06 * c3 + K4yx + l3x * j3y1 + t1;
        const double j3x1 = 7.323648000000001e-05 * c3;
        const double l3y = 0.032304 * s2;
        const double t2 = l3y * (j3x1 + j4x1);
        const double K2yx = s2 * 6.37008946786e-06 * c2 + K3yx + t2;
        const double t3 = 1.2222222222222223 * qd[2 * n + state];
        const double E2wQxx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + t3 * K4yx;
        const double S3y = j3y1 + j4y1;
        const double S2y = 0.000223285248 * s2 + S3y;
        const double E2wpx = qd[1 * n + state] * S2y + qd[2 * n + state] * S3y + t3 * j4y1;
        const double cD2y = qd[state] * K2yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = w3z + t3;
        const double T4y = 5.2855603200000006e-08 * c4 * w4z;
        const double T3y = T4y + 2.2996254720000002e-07 * c3 * w3z;
        const double do2y = 0.0048 * qd[state];
        const double t4 = do2y * S2y;
        const double cH2z = T3y + qd[1 * n + state] * 4.1084485632e-07 * c2 - cD2y - t4;
        const double cD3y = qd[state] * K3yx;
        const double t5 = do2y * S3y;
        const double cD4y = qd[state] * K4yx;
        const double t6 = do2y * j4y1;
        const double G4y = j4y1 * w4z;
        const double G4x = j4x1 * w4z;
        const double C_2 = l4x * G4y - l4y * G4x;
        const double C_3 = w3z * (l4x * j4y1 - t1);
        const double Y3 = C_2 - C_3;
        const double C_8 = Y3 - qd[1 * n + state] * (l3x * S3y - t2);
        const double t7 = l3x * (G4y + j3y1 * w3z);
        const double t8 = l3y * (G4x + j3x1 * w3z);
        const double C_4 = C_3 + qd[1 * n + state] * (l3x * j4y1 - l3y * j4x1);
        C[state] = -(E2wQxx + 0.0048 * E2wpx);
        C[1 * n + state] = cH2z;
        C[2 * n + state] = T3y - cD3y - t5 + 1.2222222222222223 * (T4y - cD4y - t6);
        C[3 * n + state] = cD2y + t4;
        C[4 * n + state] = -(C_8 + t7 - t8);
        C[5 * n + state] = -(Y3 + t7 - t8 + 1.2222222222222223 * (C_2 + l3x * G4y - l3y * G4x));
        C[6 * n + state] = cD3y + t5 + 1.2222222222222223 * (cD4y + t6);
        C[7 * n + state] = -(C_8 - 1.2222222222222223 * C_4);
        C[8 * n + state] = -(1.2222222222222223 * Y3 + Y3);
    }
}

void fifth_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s1, c4;
        sinew_sincos(phi4, &s1, &c4);
        double s2, c3;
        sinew_sincos(phi3, &s2, &c3);
        double s3, c2;
        sinew_sincos(q[1 * n + state], &s3, &c2);
        const double n4 = 0.00012114800640000001 * c4;
        const double n3 = n4 + 0.0007184498688000002 * c3;
        g[state] = 0.0;
        g[1 * n + state] = n3 + 0.00219042828288 * c2;
        g[2 * n + state] = n3 + 1.2222222222222223 * n4;
    }
}

void fifth_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double l3x = 0.032304 * c2;
        const double o3x = 0.0048 + l3x;
        const double l4x = 0.02384 * c3;
        const double j4y1 = 1.234944e-05 * s4;
        const double K4yx = s4 * 1.185619968e-07 * c4 + (o3x + l4x) * j4y1;
        const double j3y1 = 7.323648000000001e-05 * s3;
        const double j4x1 = 1.234944e-05 * c4;
        const double t1 = 0.02384 * s3 * j4x1;
        const double K3yx = s3 * 1.427316736e-06 * c3 + K4yx + o3x * j3y1 + t1;
        const double j3x1 = 7.323648000000001e-05 * c3;
        const double l3y = 0.032304 * s2;
        const double K2yx = s2 * (6.37008946786e-06 * c2 + 1.0717691904e-06) + K3yx + l3y * (j3x1
            + j4x1);
        const double t2 = 1.2222222222222223 * qd[2 * n + state];
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + t2 * K4yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = w3z + t2;
        const double w4zz = w4z * w4z;
        const double w3zz = w3z * w3z;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double t3 = 5.2855603200000006e-08 * c4 * w4zz + 2.2996254720000002e-07 * c3 * w3zz
            + 4.1084485632e-07 * c2 * w2zz;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double X3_4 = l4x * j4y1 - t1;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = l3x * j3y1 - l3y * j3x1;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double n2 = n3 + 0.00219042828288 * c2 - w3zz * X2_3 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        h[state] = t3 - (qd[state] + qd[state]) * R2yx;
        h[1 * n + state] = n2 + w1zz * K2yx;
        h[2 * n + state] = n3 + w1zz * K3yx + 1.2222222222222223 * (n4 + w1zz * K4yx);
    }
}

void fifth_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double j3u = 1.427316736e-06 * c3;
        const double j2u = 6.37008946786e-06 * c2;
        const double j4u = 1.185619968e-07 * c4;
        const double l3x = 0.032304 * c2;
        const double o3x = 0.0048 + l3x;
        const double l4x = 0.02384 * c3;
        const double o4x = o3x + l4x;
        const double j4x1 = 1.234944e-05 * c4;
        const double j3x1 = 7.323648000000001e-05 * c3;
        const double t1 = l4x * j4x1;
        const double j2x1 = 0.000223285248 * c2;
        const double t2 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t1 + 0.0048
            * j2x1;
        const double S3x = j3x1 + j4x1;
        const double t3 = l3x * S3x;
        const double Z1 = t2 + t3 + 0.0048 * (j2x1 + S3x) + 4.357300224e-07;
        const double j4yz = 5.2855603200000006e-08 * s4;
        const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
        const double K2yz = 4.1084485632e-07 * s2 + K3yz;
        const double t4 = K3yz + 1.2222222222222223 * j4yz;
        const double j4y1 = 1.234944e-05 * s4;
        const double j3y1 = 7.323648000000001e-05 * s3;
        const double l3y = 0.032304 * s2;
        const double lS3 = t3 + l3y * (j3y1 + j4y1);
        const double l4y = 0.02384 * s3;
        const double lS4 = t1 + l4y * j4y1;
        const double Z3 = 1.6288227328e-06 + (lS4 + lS4);
        const double M_2 = 1.462099968e-07 + lS4;
        const double t5 = Z3 + lS3 + 1.2222222222222223 * (M_2 + l3x * j4x1 + l3y * j4y1);
        const double K4yx = s4 * j4u + o4x * j4y1;
        const double t6 = l4y * j4x1;
        const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t6;
        const double K2yx = s2 * (j2u + 1.0717691904e-06) + K3yx + l3y * S3x;
        const double t7 = 1.2222222222222223 * qd[2 * n + state];
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + t7 * K4yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = w3z + t7;
        const double w4zz = w4z * w4z;
        const double w3zz = w3z * w3z;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double t8 = 5.2855603200000006e-08 * c4 * w4zz + 2.2996254720000002e-07 * c3 * w3zz
            + 4.1084485632e-07 * c2 * w2zz;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double X3_4 = l4x * j4y1 - t6;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = l3x * j3y1 - l3y * j3x1;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double n2 = n3 + 9.81 * j2x1 - w3zz * X2_3 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        M[state] = Z1;
        M[1 * n + state] = K2yz;
        M[2 * n + state] = t4;
        M[3 * n + state] = K2yz;
        M[4 * n + state] = 6.45303346786e-06 + Z3 + (lS3 + lS3);
        M[5 * n + state] = t5;
        M[6 * n + state] = t4;
        M[7 * n + state] = t5;
        M[8 * n + state] = 2.1841246435555558e-07 + Z3 + 2.4444444444444446 * M_2;
        h[state] = t8 - (qd[state] + qd[state]) * R2yx;
        h[1 * n + state] = n2 + K2yx * w1zz;
        h[2 * n + state] = n3 + K3yx * w1zz + 1.2222222222222223 * (n4 + K4yx * w1zz);
    }
}

void fifth_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double j2x1 = 0.000223285248 * c2;
        const double j3x1 = 7.323648000000001e-05 * c3;
        const double j4x1 = 1.234944e-05 * c4;
        const double S3x = j3x1 + j4x1;
        const double l3x = 0.032304 * c2;
        const double t1 = l3x * S3x;
        const double l4x = 0.02384 * c3;
        const double t2 = l4x * j4x1;
        const double o3x = 0.0048 + l3x;
        const double o4x = o3x + l4x;
        const double j2u = 6.37008946786e-06 * c2;
        const double j3u = 1.427316736e-06 * c3;
        const double j4u = 1.185619968e-07 * c4;
        const double t3 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t2 + 0.0048
            * j2x1;
        const double j4yz = 5.2855603200000006e-08 * s4;
        const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
        const double t4 = 1e+16 * K3yz + 12222222222222224.0 * j4yz;
        const double l4y = 0.02384 * s3;
        const double j4y1 = 1.234944e-05 * s4;
        const double lS4 = t2 + l4y * j4y1;
        const double M = 1.462099968e-07 + lS4;
        const double Z3 = 1.6288227328e-06 + (lS4 + lS4);
        const double r3 = 0.40909090909090906 / (8.935055360000001e-08 + M + 0.40909090909090906
            * Z3);
        const double t5 = 1e-16 * r3;
        const double L3_1 = t5 * t4;
        const double l3y = 0.032304 * s2;
        const double j3y1 = 7.323648000000001e-05 * s3;
        const double lS3 = t1 + l3y * (j3y1 + j4y1);
        const double t6 = 1e+16 * (Z3 + lS3) + 12222222222222224.0 * (M + l3x * j4x1 + l3y * j4y1);
        const double L3_2 = t5 * t6;
        const double t7 = 1e-16 * L3_2;
        const double A2_1 = 4.1084485632e-07 * s2 + K3yz - t7 * t4;
        const double A2_2 = 6.45303346786e-06 + Z3 + (lS3 + lS3) - t7 * t6;
        const double r2 = 1.0 / A2_2;
        const double L2_1 = A2_1 * r2;
        const double A1_1_2 = t3 + t1 + 0.0048 * (j2x1 + S3x) - 1e-16 * L3_1 * t4 - A2_1 * L2_1
            + 4.357300224e-07;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double t8 = 1.2222222222222223 * qd[2 * n + state];
        const double w4z = w3z + t8;
        const double w4zz = w4z * w4z;
        const double t9 = tau[state] - 5.2855603200000006e-08 * c4 * w4zz - 2.2996254720000002e-07
            * c3 * w3zz;
        const double K4yx = s4 * j4u + o4x * j4y1;
        const double t10 = l4y * j4x1;
        const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t10;
        const double K2yx = s2 * (j2u + 1.0717691904e-06) + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + t8 * K4yx;
        const double w1zz = qd[state] * qd[state];
        const double X3_4 = l4x * j4y1 - t10;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = l3x * j3y1 - l3y * j3x1;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double y3 = tau[2 * n + state] - n3 - K3yx * w1zz - 1.2222222222222223 * (n4 + K4yx
            * w1zz);
        const double t11 = t9 - 4.1084485632e-07 * c2 * w2zz + (qd[state] + qd[state]) * R2yx - y3
            * L3_1;
        const double t12 = tau[1 * n + state] - n3 - 9.81 * j2x1 + w3zz * X2_3 + w4zz * X2_4 - K2yx
            * w1zz;
        const double b2 = t12 - y3 * L3_2;
        const double x1 = (t11 - b2 * L2_1) * (1.0 / A1_1_2);
        const double x2 = b2 * r2 - L2_1 * x1;
        qdd[state] = x1;
        qdd[1 * n + state] = x2;
        qdd[2 * n + state] = y3 * r3 - L3_2 * x2 - L3_1 * x1;
    }
}

void fifth_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = phi3 + 1.2222222222222223 * q[2 * n + state];
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double al3z = qdd[1 * n + state] + qdd[2 * n + state];
        const double e3y = c3 * al3z - s3 * w3zz;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double a3y = 9.81 + 0.032304 * (qdd[1 * n + state] * c2 - s2 * w2zz);
        const double j4x1 = 1.234944e-05 * c4;
        const double al4z = al3z + 1.2222222222222223 * qdd[2 * n + state];
        const double e3x = c3 * w3zz + s3 * al3z;
        const double e2x = qdd[1 * n + state] * s2 + c2 * w2zz;
        const double a3x = 0.032304 * e2x;
        const double j4y1 = 1.234944e-05 * s4;
        const double n4 = 1.462099968e-07 * al4z + j4x1 * (a3y + 0.02384 * e3y) + j4y1 * (a3x
            + 0.02384 * e3x);
        const double j3x1 = 7.323648000000001e-05 * c3;
        const double j3y1 = 7.323648000000001e-05 * s3;
        const double t1 = 1.2222222222222223 * qd[2 * n + state];
        const double w4z = w3z + t1;
        const double w4zz = w4z * w4z;
        const double F4y = 1.234944e-05 * (c4 * al4z - s4 * w4zz);
        const double l4x = 0.02384 * c3;
        const double e4x = c4 * w4zz + s4 * al4z;
        const double F4x = 1.234944e-05 * e4x;
        const double l4y = 0.02384 * s3;
        const double n3 = n4 + 1.482612736e-06 * al3z + j3x1 * a3y + j3y1 * a3x + l4x * F4y + l4y
            * F4x;
        const double j4yz = 5.2855603200000006e-08 * s4;
        const double K3yz = 2.2996254720000002e-07 * s3 + j4yz;
        const double l3x = 0.032304 * c2;
        const double o3x = 0.0048 + l3x;
        const double o4x = o3x + l4x;
        const double j4u = 1.185619968e-07 * c4;
        const double K4yx = s4 * j4u + o4x * j4y1;
        const double j3u = 1.427316736e-06 * c3;
        const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + l4y * j4x1;
        const double w1zz = qd[state] * qd[state];
        const double t2 = n3 + qdd[state] * K3yz + w1zz * K3yx + 1.2222222222222223 * (n4
            + qdd[state] * j4yz + w1zz * K4yx);
        const double j2x1 = 0.000223285248 * c2;
        const double t3 = n3 + 6.45303346786e-06 * qdd[1 * n + state] + 9.81 * j2x1 + l3x * (F4y
            + 7.323648000000001e-05 * e3y);
        const double l3y = 0.032304 * s2;
        const double n2 = t3 + l3y * (F4x + 7.323648000000001e-05 * e3x);
        const double j2u = 6.37008946786e-06 * c2;
        const double S3x = j3x1 + j4x1;
        const double K2yx = s2 * (j2u + 1.0717691904e-06) + K3yx + l3y * S3x;
        const double t2_2 = n2 + qdd[state] * (4.1084485632e-07 * s2 + K3yz) + w1zz * K2yx;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + t1 * K4yx;
        const double t4 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + l4x * j4x1
            + 0.0048 * j2x1;
        const double t5 = qdd[state] * (t4 + l3x * S3x + 0.0048 * (j2x1 + S3x)
            + 4.3573002239999995e-07);
        const double t6 = t5 + 5.2855603200000006e-08 * e4x + 2.2996254720000002e-07 * e3x
            + 4.1084485632e-07 * e2x;
        tau[state] = t6 - (qd[state] + qd[state]) * R2yx;
        tau[1 * n + state] = t2_2;
        tau[2 * n + state] = t2;
    }
}

void fifth_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 0.0052 * q[state];
        const double t2 = 0.0052 * q[1 * n + state];
        const double t3 = t1 + t2;
        const double t4 = t1 - t2;
        const double t5 = 0.0088 * q[2 * n + state];
        h[state] = t3;
        h[1 * n + state] = t4;
        h[2 * n + state] = -t4;
        h[3 * n + state] = -t3;
        h[4 * n + state] = t5;
        h[5 * n + state] = -t5;
    }
}

void fifth_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P)
{
    const size_t n = (size_t)count;
    (void)q;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        P[state] = 0.0052;
        P[1 * n + state] = 0.0052;
        P[2 * n + state] = 0.0;
        P[3 * n + state] = 0.0052;
        P[4 * n + state] = -0.0052;
        P[5 * n + state] = 0.0;
        P[6 * n + state] = -0.0052;
        P[7 * n + state] = 0.0052;
        P[8 * n + state] = 0.0;
        P[9 * n + state] = -0.0052;
        P[10 * n + state] = -0.0052;
        P[11 * n + state] = 0.0;
        P[12 * n + state] = 0.0;
        P[13 * n + state] = 0.0;
        P[14 * n + state] = 0.0088;
        P[15 * n + state] = 0.0;
        P[16 * n + state] = 0.0;
        P[17 * n + state] = -0.0088;
    }
}

void fifth_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    (void)q;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 0.0052 * f[state];
        const double t2 = 0.0052 * f[1 * n + state];
        const double t3 = 0.0052 * f[2 * n + state];
        const double t4 = 0.0052 * f[3 * n + state];
        tau[state] = -(t1 + t2 - t3 - t4);
        tau[1 * n + state] = -(t1 - t2 + t3 - t4);
        tau[2 * n + state] = -(0.0088 * (f[4 * n + state] - f[5 * n + state]));
    }
}

void fifth_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K)
{
    const size_t n = (size_t)count;
    (void)q;
    (void)f;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 2.704e-05 * kt[state];
        const double t2 = 2.704e-05 * kt[1 * n + state];
        const double t3 = 2.704e-05 * kt[2 * n + state];
        const double t4 = 2.704e-05 * kt[3 * n + state];
        const double K1_1 = t1 + t2 + t3 + t4;
        const double K1_2 = t1 - t2 - t3 + t4;
        const double K3_3 = 7.744e-05 * (kt[4 * n + state] + kt[5 * n + state]);
        K[state] = K1_1;
        K[1 * n + state] = K1_2;
        K[2 * n + state] = 0.0;
        K[3 * n + state] = K1_2;
        K[4 * n + state] = K1_1;
        K[5 * n + state] = 0.0;
        K[6 * n + state] = 0.0;
        K[7 * n + state] = 0.0;
        K[8 * n + state] = K3_3;
    }
}

void fifth_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT H)
{
    const size_t n = (size_t)count;
    (void)q;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        H[state] = 0.0;
        H[1 * n + state] = 0.0;
        H[2 * n + state] = 0.0;
        H[3 * n + state] = 0.0;
        H[4 * n + state] = 0.0;
        H[5 * n + state] = 0.0;
        H[6 * n + state] = 0.0;
        H[7 * n + state] = 0.0;
        H[8 * n + state] = 0.0;
        H[9 * n + state] = 0.0;
        H[10 * n + state] = 0.0;
        H[11 * n + state] = 0.0;
        H[12 * n + state] = 0.0;
        H[13 * n + state] = 0.0;
        H[14 * n + state] = 0.0;
        H[15 * n + state] = 0.0;
        H[16 * n + state] = 0.0;
        H[17 * n + state] = 0.0;
        H[18 * n + state] = 0.0;
        H[19 * n + state] = 0.0;
        H[20 * n + state] = 0.0;
        H[21 * n + state] = 0.0;
        H[22 * n + state] = 0.0;
        H[23 * n + state] = 0.0;
        H[24 * n + state] = 0.0;
        H[25 * n + state] = 0.0;
        H[26 * n + state] = 0.0;
        H[27 * n + state] = 0.0;
        H[28 * n + state] = 0.0;
        H[29 * n + state] = 0.0;
        H[30 * n + state] = 0.0;
        H[31 * n + state] = 0.0;
        H[32 * n + state] = 0.0;
        H[33 * n + state] = 0.0;
        H[34 * n + state] = 0.0;
        H[35 * n + state] = 0.0;
        H[36 * n + state] = 0.0;
        H[37 * n + state] = 0.0;
        H[38 * n + state] = 0.0;
        H[39 * n + state] = 0.0;
        H[40 * n + state] = 0.0;
        H[41 * n + state] = 0.0;
        H[42 * n + state] = 0.0;
        H[43 * n + state] = 0.0;
        H[44 * n + state] = 0.0;
        H[45 * n + state] = 0.0;
        H[46 * n + state] = 0.0;
        H[47 * n + state] = 0.0;
        H[48 * n + state] = 0.0;
        H[49 * n + state] = 0.0;
        H[50 * n + state] = 0.0;
        H[51 * n + state] = 0.0;
        H[52 * n + state] = 0.0;
        H[53 * n + state] = 0.0;
    }
}

void fifth_link_position_batch(int count, const double *SINEW_RESTRICT h, double *SINEW_RESTRICT q)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 48.07692307692308 * h[state];
        const double t2 = 48.07692307692308 * h[1 * n + state];
        const double t3 = 48.07692307692308 * h[2 * n + state];
        const double t4 = 48.07692307692308 * h[3 * n + state];
        q[state] = t1 + t2 - t3 - t4;
        q[1 * n + state] = t1 - t2 + t3 - t4;
        q[2 * n + state] = 56.81818181818181 * (h[4 * n + state] - h[5 * n + state]);
    }
}

void fifth_link_position_covariance_batch(int count, const double *SINEW_RESTRICT sigma,
    double *SINEW_RESTRICT covariance)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double variance = sigma[state] * sigma[state];
        const double t1 = 9245.562130177515 * variance;
        covariance[state] = t1;
        covariance[1 * n + state] = 0.0;
        covariance[2 * n + state] = 0.0;
        covariance[3 * n + state] = 0.0;
        covariance[4 * n + state] = t1;
        covariance[5 * n + state] = 0.0;
        covariance[6 * n + state] = 0.0;
        covariance[7 * n + state] = 0.0;
        covariance[8 * n + state] = 6456.611570247934 * variance;
    }
}

void fifth_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(q[state], -q[state]) + sinew_max(q[1 * n + state], -q[1 * n
            + state]);
        const double t2 = 1.2222222222222223 * q[2 * n + state];
        const double t3 = sinew_max(q[2 * n + state], -q[2 * n + state]) + sinew_max(t2, -t2);
        angles[state] = t1;
        angles[1 * n + state] = t1;
        angles[2 * n + state] = t1;
        angles[3 * n + state] = t1;
        angles[4 * n + state] = t3;
        angles[5 * n + state] = t3;
    }
}
