/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model index over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/index
 * Model:   sha256 87dae3bf2513ab5836c918f869de07d956d21148227d4e316059a4cbc5f06f25
 * Do not edit: change the model and generate again.
 */
#include "index_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void index_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT T)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        const double R41x = c1 * c4;
        const double t1 = 0.006 + (0.04038 * c2 + 0.0298 * c3);
        const double R42x = s1 * c4;
        T[state] = R41x;
        T[1 * n + state] = -(c1 * s4);
        T[2 * n + state] = s1;
        T[3 * n + state] = c1 * t1 - 0.0057 * s1 + 0.0201 * R41x;
        T[4 * n + state] = R42x;
        T[5 * n + state] = -(s1 * s4);
        T[6 * n + state] = -c1;
        T[7 * n + state] = s1 * t1 + 0.0057 * c1 + 0.0201 * R42x;
        T[8 * n + state] = s4;
        T[9 * n + state] = c4;
        T[10 * n + state] = 0.0;
        T[11 * n + state] = 0.04038 * s2 + 0.0298 * s3 + 0.0201 * s4;
        T[12 * n + state] = 0.0;
        T[13 * n + state] = 0.0;
        T[14 * n + state] = 0.0;
        T[15 * n + state] = 1.0;
    }
}

void index_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double l3x = 0.04038 * c2;
        const double o4x = l3x + 0.0298 * c3;
        const double p2y = 0.006 * s1;
        const double p4y = p2y + s1 * o4x;
        const double ptipy = p4y + 0.0057 * c1 + 0.0201 * s1 * c4;
        const double l3y = 0.04038 * s2;
        const double o4y = l3y + 0.0298 * s3;
        const double ptipz = o4y + 0.0201 * s4;
        const double arm3_4 = l3y - ptipz;
        const double arm4_4 = o4y - ptipz;
        const double p2x = 0.006 * c1;
        const double p4x = p2x + c1 * o4x;
        const double ptipx = p4x - 0.0057 * s1 + 0.0201 * c1 * c4;
        const double t1 = -c1;
        J[state] = -ptipy;
        J[1 * n + state] = -(c1 * ptipz);
        J[2 * n + state] = c1 * arm3_4;
        J[3 * n + state] = c1 * arm4_4;
        J[4 * n + state] = ptipx;
        J[5 * n + state] = -(s1 * ptipz);
        J[6 * n + state] = s1 * arm3_4;
        J[7 * n + state] = s1 * arm4_4;
        J[8 * n + state] = 0.0;
        J[9 * n + state] = -(c1 * (p2x - ptipx) + s1 * (p2y - ptipy));
        J[10 * n + state] = -(c1 * (p2x + c1 * l3x - ptipx) + s1 * (p2y + s1 * l3x - ptipy));
        J[11 * n + state] = -(c1 * (p4x - ptipx) + s1 * (p4y - ptipy));
        J[12 * n + state] = 0.0;
        J[13 * n + state] = s1;
        J[14 * n + state] = s1;
        J[15 * n + state] = s1;
        J[16 * n + state] = 0.0;
        J[17 * n + state] = t1;
        J[18 * n + state] = t1;
        J[19 * n + state] = t1;
        J[20 * n + state] = 1.0;
        J[21 * n + state] = 0.0;
        J[22 * n + state] = 0.0;
        J[23 * n + state] = 0.0;
    }
}

void index_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double t1 = c2 * (1.94855328e-05 * c2) + c3 * (4.3862e-06 * c3) + c4 * (3.7701e-07
            * c4);
        const double l4x = 0.0298 * c3;
        const double l3x = 0.04038 * c2;
        const double j4x1 = 3.015e-05 * c4;
        const double j3x1 = 0.0001788 * c3;
        const double t2 = l4x * j4x1;
        const double S3x = j3x1 + j4x1;
        const double t3 = l3x * S3x;
        const double t4 = t1 + (l3x + l4x) * j4x1 + l3x * j3x1 + t2 + t3 + 0.012 * (0.00054513 * c2
            + S3x);
        const double j4yz = 1.613025e-07 * s4;
        const double K3yz = 7.0179e-07 * s3 + j4yz;
        const double K2yz = 1.253799e-06 * s2 + K3yz;
        const double j4y1 = 3.015e-05 * s4;
        const double l3y = 0.04038 * s2;
        const double lS3 = t3 + l3y * (0.0001788 * s3 + j4y1);
        const double lS4 = t2 + 0.0298 * s3 * j4y1;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double M_4 = Z3 + lS3;
        const double M_2 = 4.3101e-07 + lS4;
        const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
        M[state] = t4 + 1.1373674999999997e-06;
        M[1 * n + state] = K2yz;
        M[2 * n + state] = K3yz;
        M[3 * n + state] = j4yz;
        M[4 * n + state] = K2yz;
        M[5 * n + state] = 1.96475328e-05 + Z3 + (lS3 + lS3);
        M[6 * n + state] = M_4;
        M[7 * n + state] = M_2_2;
        M[8 * n + state] = K3yz;
        M[9 * n + state] = M_4;
        M[10 * n + state] = Z3;
        M[11 * n + state] = M_2;
        M[12 * n + state] = j4yz;
        M[13 * n + state] = M_2_2;
        M[14 * n + state] = M_2;
        M[15 * n + state] = 4.3101e-07;
    }
}

void index_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double l4x = 0.0298 * c3;
        const double l3x = 0.04038 * c2;
        const double j4y1 = 3.015e-05 * s4;
        const double K4yx = s4 * 3.7701e-07 * c4 + (l3x + l4x) * j4y1;
        const double j3y1 = 0.0001788 * s3;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t1 = l4y * j4x1;
        const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + l3x * j3y1 + t1;
        const double j3x1 = 0.0001788 * c3;
        const double l3y = 0.04038 * s2;
        const double t2 = l3y * (j3x1 + j4x1);
        const double K2yx = s2 * 1.94855328e-05 * c2 + K3yx + t2;
        const double E2wQxx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n
            + state] * K4yx;
        const double S3y = j3y1 + j4y1;
        const double S2y = 0.00054513 * s2 + S3y;
        const double E2wpx = qd[1 * n + state] * S2y + qd[2 * n + state] * S3y + qd[3 * n + state]
            * j4y1;
        const double cD2y = qd[state] * K2yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = qd[3 * n + state] + w3z;
        const double T4y = 1.613025e-07 * c4 * w4z;
        const double T3y = T4y + 7.0179e-07 * c3 * w3z;
        const double do2y = 0.006 * qd[state];
        const double t3 = do2y * S2y;
        const double cH2z = T3y + qd[1 * n + state] * 1.253799e-06 * c2 - cD2y - t3;
        const double cD3y = qd[state] * K3yx;
        const double t4 = do2y * S3y;
        const double cD4y = qd[state] * K4yx;
        const double t5 = do2y * j4y1;
        const double G4y = j4y1 * w4z;
        const double G4x = j4x1 * w4z;
        const double C_2 = l4x * G4y - l4y * G4x;
        const double C_3 = w3z * (l4x * j4y1 - t1);
        const double Y3 = C_2 - C_3;
        const double C_8 = Y3 - qd[1 * n + state] * (l3x * S3y - t2);
        const double t6 = l3x * (G4y + j3y1 * w3z);
        const double t7 = l3y * (G4x + j3x1 * w3z);
        const double C_4 = C_3 + qd[1 * n + state] * (l3x * j4y1 - l3y * j4x1);
        C[state] = -(E2wQxx + 0.006 * E2wpx);
        C[1 * n + state] = cH2z;
        C[2 * n + state] = T3y - cD3y - t4;
        C[3 * n + state] = T4y - cD4y - t5;
        C[4 * n + state] = cD2y + t3;
        C[5 * n + state] = -(C_8 + t6 - t7);
        C[6 * n + state] = -(Y3 + t6 - t7);
        C[7 * n + state] = -(C_2 + l3x * G4y - l3y * G4x);
        C[8 * n + state] = cD3y + t4;
        C[9 * n + state] = -C_8;
        C[10 * n + state] = -Y3;
        C[11 * n + state] = -C_2;
        C[12 * n + state] = cD4y + t5;
        C[13 * n + state] = C_4;
        C[14 * n + state] = C_3;
        C[15 * n + state] = 0.0;
    }
}

void index_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        double s1, c4;
        sinew_sincos(q[3 * n + state] + phi3, &s1, &c4);
        double s2, c3;
        sinew_sincos(phi3, &s2, &c3);
        double s3, c2;
        sinew_sincos(q[1 * n + state], &s3, &c2);
        const double n4 = 0.0002957715 * c4;
        const double n3 = n4 + 0.0017540280000000001 * c3;
        g[state] = 0.0;
        g[1 * n + state] = n3 + 0.005347725300000001 * c2;
        g[2 * n + state] = n3;
        g[3 * n + state] = n4;
    }
}

void index_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double l3x = 0.04038 * c2;
        const double o3x = 0.006 + l3x;
        const double l4x = 0.0298 * c3;
        const double j4y1 = 3.015e-05 * s4;
        const double K4yx = s4 * 3.7701e-07 * c4 + (o3x + l4x) * j4y1;
        const double j3y1 = 0.0001788 * s3;
        const double j4x1 = 3.015e-05 * c4;
        const double t1 = 0.0298 * s3 * j4x1;
        const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + o3x * j3y1 + t1;
        const double j3x1 = 0.0001788 * c3;
        const double l3y = 0.04038 * s2;
        const double K2yx = s2 * (1.94855328e-05 * c2 + 3.27078e-06) + K3yx + l3y * (j3x1 + j4x1);
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double w3zz = w3z * w3z;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double t2 = 1.613025e-07 * c4 * w4zz + 7.0179e-07 * c3 * w3zz + 1.253799e-06 * c2
            * w2zz;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double X3_4 = l4x * j4y1 - t1;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = l3x * j3y1 - l3y * j3x1;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double n2 = n3 + 0.005347725300000001 * c2 - w3zz * X2_3 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        h[state] = t2 - (qd[state] + qd[state]) * R2yx;
        h[1 * n + state] = n2 + w1zz * K2yx;
        h[2 * n + state] = n3 + w1zz * K3yx;
        h[3 * n + state] = n4 + w1zz * K4yx;
    }
}

void index_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        const double j3u = 4.3862e-06 * c3;
        const double j2u = 1.94855328e-05 * c2;
        const double j4u = 3.7701e-07 * c4;
        const double l3x = 0.04038 * c2;
        const double o3x = 0.006 + l3x;
        const double l4x = 0.0298 * c3;
        const double o4x = o3x + l4x;
        const double j4x1 = 3.015e-05 * c4;
        const double j3x1 = 0.0001788 * c3;
        const double t1 = l4x * j4x1;
        const double j2x1 = 0.00054513 * c2;
        const double t2 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t1 + 0.006
            * j2x1;
        const double S3x = j3x1 + j4x1;
        const double t3 = l3x * S3x;
        const double Z1 = t2 + t3 + 0.006 * (j2x1 + S3x) + 1.1373674999999997e-06;
        const double j4yz = 1.613025e-07 * s4;
        const double K3yz = 7.0179e-07 * s3 + j4yz;
        const double K2yz = 1.253799e-06 * s2 + K3yz;
        const double j4y1 = 3.015e-05 * s4;
        const double j3y1 = 0.0001788 * s3;
        const double l3y = 0.04038 * s2;
        const double lS3 = t3 + l3y * (j3y1 + j4y1);
        const double l4y = 0.0298 * s3;
        const double lS4 = t1 + l4y * j4y1;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double M_4 = Z3 + lS3;
        const double M_2 = 4.3101e-07 + lS4;
        const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
        const double K4yx = s4 * j4u + o4x * j4y1;
        const double t4 = l4y * j4x1;
        const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t4;
        const double K2yx = s2 * (j2u + 3.27078e-06) + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double w3zz = w3z * w3z;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double t5 = 1.613025e-07 * c4 * w4zz + 7.0179e-07 * c3 * w3zz + 1.253799e-06 * c2
            * w2zz;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double X3_4 = l4x * j4y1 - t4;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = l3x * j3y1 - l3y * j3x1;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double n2 = n3 + 9.81 * j2x1 - w3zz * X2_3 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        M[state] = Z1;
        M[1 * n + state] = K2yz;
        M[2 * n + state] = K3yz;
        M[3 * n + state] = j4yz;
        M[4 * n + state] = K2yz;
        M[5 * n + state] = 1.96475328e-05 + Z3 + (lS3 + lS3);
        M[6 * n + state] = M_4;
        M[7 * n + state] = M_2_2;
        M[8 * n + state] = K3yz;
        M[9 * n + state] = M_4;
        M[10 * n + state] = Z3;
        M[11 * n + state] = M_2;
        M[12 * n + state] = j4yz;
        M[13 * n + state] = M_2_2;
        M[14 * n + state] = M_2;
        M[15 * n + state] = 4.3101e-07;
        h[state] = t5 - (qd[state] + qd[state]) * R2yx;
        h[1 * n + state] = n2 + K2yx * w1zz;
        h[2 * n + state] = n3 + K3yx * w1zz;
        h[3 * n + state] = n4 + K4yx * w1zz;
    }
}

void index_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s4, c4;
        sinew_sincos(phi4, &s4, &c4);
        double s3, c3;
        sinew_sincos(phi3, &s3, &c3);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double j4yz = 1.613025e-07 * s4;
        const double L4_1 = 2320131.783485302 * j4yz;
        const double j2x1 = 0.00054513 * c2;
        const double j3x1 = 0.0001788 * c3;
        const double j4x1 = 3.015e-05 * c4;
        const double S3x = j3x1 + j4x1;
        const double l3x = 0.04038 * c2;
        const double t1 = l3x * S3x;
        const double l4x = 0.0298 * c3;
        const double t2 = l4x * j4x1;
        const double o3x = 0.006 + l3x;
        const double o4x = o3x + l4x;
        const double j4u = 3.7701e-07 * c4;
        const double j2u = 1.94855328e-05 * c2;
        const double j3u = 4.3862e-06 * c3;
        const double t3 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + t2 + 0.006
            * j2x1;
        const double K3yz = 7.0179e-07 * s3 + j4yz;
        const double l4y = 0.0298 * s3;
        const double j4y1 = 3.015e-05 * s4;
        const double lS4 = t2 + l4y * j4y1;
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
        const double lS3 = t1 + l3y * (j3y1 + j4y1);
        const double A3_2 = Z3 + lS3 - M_2 * L4_3;
        const double L3_2 = A3_2 * r3;
        const double A2_1_2 = 1.253799e-06 * s2 + K3yz - j4yz * L4_2 - A3_1 * L3_2;
        const double A2_2 = 1.96475328e-05 + Z3 + (lS3 + lS3) - M_2 * L4_2;
        const double r2 = 1.0 / (A2_2 - A3_2 * L3_2);
        const double L2_1 = A2_1_2 * r2;
        const double t4 = t3 + t1 + 0.006 * (j2x1 + S3x) - j4yz * L4_1 - A3_1 * L3_1 - A2_1_2
            * L2_1;
        const double w1zz = qd[state] * qd[state];
        const double K4yx = s4 * j4u + o4x * j4y1;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double t5 = l4y * j4x1;
        const double X3_4 = l4x * j4y1 - t5;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double y4 = tau[3 * n + state] - n4 - K4yx * w1zz;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double t6 = tau[state] - 1.613025e-07 * c4 * w4zz - 7.0179e-07 * c3 * w3zz
            - 1.253799e-06 * c2 * w2zz;
        const double K3yx = s3 * j3u + K4yx + o3x * j3y1 + t5;
        const double K2yx = s2 * (j2u + 3.27078e-06) + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double X2_3 = l3x * j3y1 - l3y * j3x1;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double b3 = tau[2 * n + state] - n3 - K3yx * w1zz - y4 * L4_3;
        const double t7 = tau[1 * n + state] - n3 - 9.81 * j2x1 + w3zz * X2_3 + w4zz * X2_4 - K2yx
            * w1zz;
        const double b2_2 = t7 - y4 * L4_2 - b3 * L3_2;
        const double b1_4 = t6 + (qd[state] + qd[state]) * R2yx - y4 * L4_1 - b3 * L3_1 - b2_2
            * L2_1;
        const double x1 = b1_4 * (1.0 / (t4 + 1.1373674999999997e-06));
        const double x2 = b2_2 * r2 - L2_1 * x1;
        const double x3 = b3 * r3 - L3_2 * x2 - L3_1 * x1;
        const double x4 = 2320131.783485302 * y4 - L4_3 * x3 - L4_2 * x2 - L4_1 * x1;
        qdd[state] = x1;
        qdd[1 * n + state] = x2;
        qdd[2 * n + state] = x3;
        qdd[3 * n + state] = x4;
    }
}

void index_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
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
        const double a3y = 9.81 + 0.04038 * (qdd[1 * n + state] * c2 - s2 * w2zz);
        const double j4x1 = 3.015e-05 * c4;
        const double al4z = qdd[3 * n + state] + al3z;
        const double e3x = c3 * w3zz + s3 * al3z;
        const double e2x = qdd[1 * n + state] * s2 + c2 * w2zz;
        const double a3x = 0.04038 * e2x;
        const double j4y1 = 3.015e-05 * s4;
        const double n4 = 4.3101e-07 * al4z + j4x1 * (a3y + 0.0298 * e3y) + j4y1 * (a3x + 0.0298
            * e3x);
        const double j4yz = 1.613025e-07 * s4;
        const double l3x = 0.04038 * c2;
        const double o3x = 0.006 + l3x;
        const double l4x = 0.0298 * c3;
        const double o4x = o3x + l4x;
        const double j4u = 3.7701e-07 * c4;
        const double K4yx = s4 * j4u + o4x * j4y1;
        const double w1zz = qd[state] * qd[state];
        const double j3x1 = 0.0001788 * c3;
        const double j3y1 = 0.0001788 * s3;
        const double w4z = qd[3 * n + state] + w3z;
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
        const double t1 = n3 + 1.96475328e-05 * qdd[1 * n + state] + 9.81 * j2x1 + l3x * (F4y
            + 0.0001788 * e3y);
        const double l3y = 0.04038 * s2;
        const double t2 = t1 + l3y * (F4x + 0.0001788 * e3x) + qdd[state] * (1.253799e-06 * s2
            + K3yz);
        const double j2u = 1.94855328e-05 * c2;
        const double S3x = j3x1 + j4x1;
        const double K2yx = s2 * (j2u + 3.27078e-06) + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double t3 = c2 * j2u + c3 * j3u + c4 * j4u + o4x * j4x1 + o3x * j3x1 + l4x * j4x1
            + 0.006 * j2x1;
        const double t4 = qdd[state] * (t3 + l3x * S3x + 0.006 * (j2x1 + S3x)
            + 1.1373675000000002e-06);
        const double N1z = t4 + 1.613025e-07 * e4x + 7.0179e-07 * e3x + 1.253799e-06 * e2x
            - (qd[state] + qd[state]) * R2yx;
        tau[state] = N1z;
        tau[1 * n + state] = t2 + w1zz * K2yx;
        tau[2 * n + state] = n3 + qdd[state] * K3yz + w1zz * K3yx;
        tau[3 * n + state] = n4 + qdd[state] * j4yz + w1zz * K4yx;
    }
}

void index_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 0.0065 * q[state];
        const double t2 = 0.0065 * q[1 * n + state];
        const double t3 = t1 + t2;
        const double t4 = t1 - t2;
        const double t5 = 0.0055 * q[2 * n + state];
        const double t6 = 0.0045 * q[3 * n + state] - t5;
        h[state] = t3;
        h[1 * n + state] = t4;
        h[2 * n + state] = -t4;
        h[3 * n + state] = -t3;
        h[4 * n + state] = t5;
        h[5 * n + state] = -t5;
        h[6 * n + state] = -t6;
        h[7 * n + state] = t6;
    }
}

void index_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P)
{
    const size_t n = (size_t)count;
    (void)q;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        P[state] = 0.0065;
        P[1 * n + state] = 0.0065;
        P[2 * n + state] = 0.0;
        P[3 * n + state] = 0.0;
        P[4 * n + state] = 0.0065;
        P[5 * n + state] = -0.0065;
        P[6 * n + state] = 0.0;
        P[7 * n + state] = 0.0;
        P[8 * n + state] = -0.0065;
        P[9 * n + state] = 0.0065;
        P[10 * n + state] = 0.0;
        P[11 * n + state] = 0.0;
        P[12 * n + state] = -0.0065;
        P[13 * n + state] = -0.0065;
        P[14 * n + state] = 0.0;
        P[15 * n + state] = 0.0;
        P[16 * n + state] = 0.0;
        P[17 * n + state] = 0.0;
        P[18 * n + state] = 0.0055;
        P[19 * n + state] = 0.0;
        P[20 * n + state] = 0.0;
        P[21 * n + state] = 0.0;
        P[22 * n + state] = -0.0055;
        P[23 * n + state] = 0.0;
        P[24 * n + state] = 0.0;
        P[25 * n + state] = 0.0;
        P[26 * n + state] = 0.0055;
        P[27 * n + state] = -0.0045;
        P[28 * n + state] = 0.0;
        P[29 * n + state] = 0.0;
        P[30 * n + state] = -0.0055;
        P[31 * n + state] = 0.0045;
    }
}

void index_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    (void)q;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 0.0065 * f[state];
        const double t2 = 0.0065 * f[1 * n + state];
        const double t3 = 0.0065 * f[2 * n + state];
        const double t4 = 0.0065 * f[3 * n + state];
        const double t5 = f[4 * n + state] - f[5 * n + state] + f[6 * n + state] - f[7 * n + state];
        tau[state] = -(t1 + t2 - t3 - t4);
        tau[1 * n + state] = -(t1 - t2 + t3 - t4);
        tau[2 * n + state] = -(0.0055 * t5);
        tau[3 * n + state] = 0.0045 * (f[6 * n + state] - f[7 * n + state]);
    }
}

void index_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K)
{
    const size_t n = (size_t)count;
    (void)q;
    (void)f;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 4.225e-05 * kt[state];
        const double t2 = 4.225e-05 * kt[1 * n + state];
        const double t3 = 4.225e-05 * kt[2 * n + state];
        const double t4 = 4.225e-05 * kt[3 * n + state];
        const double K1_1 = t1 + t2 + t3 + t4;
        const double K1_2 = t1 - t2 - t3 + t4;
        const double t5 = 0.0055 * kt[6 * n + state] + 0.0055 * kt[7 * n + state];
        const double K3_3 = 3.0249999999999997e-05 * (kt[4 * n + state] + kt[5 * n + state])
            + 0.0055 * t5;
        const double t6 = -(0.0045 * t5);
        const double K4_4 = 2.0249999999999998e-05 * (kt[6 * n + state] + kt[7 * n + state]);
        K[state] = K1_1;
        K[1 * n + state] = K1_2;
        K[2 * n + state] = 0.0;
        K[3 * n + state] = 0.0;
        K[4 * n + state] = K1_2;
        K[5 * n + state] = K1_1;
        K[6 * n + state] = 0.0;
        K[7 * n + state] = 0.0;
        K[8 * n + state] = 0.0;
        K[9 * n + state] = 0.0;
        K[10 * n + state] = K3_3;
        K[11 * n + state] = t6;
        K[12 * n + state] = 0.0;
        K[13 * n + state] = 0.0;
        K[14 * n + state] = t6;
        K[15 * n + state] = K4_4;
    }
}

void index_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT H)
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
        H[54 * n + state] = 0.0;
        H[55 * n + state] = 0.0;
        H[56 * n + state] = 0.0;
        H[57 * n + state] = 0.0;
        H[58 * n + state] = 0.0;
        H[59 * n + state] = 0.0;
        H[60 * n + state] = 0.0;
        H[61 * n + state] = 0.0;
        H[62 * n + state] = 0.0;
        H[63 * n + state] = 0.0;
        H[64 * n + state] = 0.0;
        H[65 * n + state] = 0.0;
        H[66 * n + state] = 0.0;
        H[67 * n + state] = 0.0;
        H[68 * n + state] = 0.0;
        H[69 * n + state] = 0.0;
        H[70 * n + state] = 0.0;
        H[71 * n + state] = 0.0;
        H[72 * n + state] = 0.0;
        H[73 * n + state] = 0.0;
        H[74 * n + state] = 0.0;
        H[75 * n + state] = 0.0;
        H[76 * n + state] = 0.0;
        H[77 * n + state] = 0.0;
        H[78 * n + state] = 0.0;
        H[79 * n + state] = 0.0;
        H[80 * n + state] = 0.0;
        H[81 * n + state] = 0.0;
        H[82 * n + state] = 0.0;
        H[83 * n + state] = 0.0;
        H[84 * n + state] = 0.0;
        H[85 * n + state] = 0.0;
        H[86 * n + state] = 0.0;
        H[87 * n + state] = 0.0;
        H[88 * n + state] = 0.0;
        H[89 * n + state] = 0.0;
        H[90 * n + state] = 0.0;
        H[91 * n + state] = 0.0;
        H[92 * n + state] = 0.0;
        H[93 * n + state] = 0.0;
        H[94 * n + state] = 0.0;
        H[95 * n + state] = 0.0;
        H[96 * n + state] = 0.0;
        H[97 * n + state] = 0.0;
        H[98 * n + state] = 0.0;
        H[99 * n + state] = 0.0;
        H[100 * n + state] = 0.0;
        H[101 * n + state] = 0.0;
        H[102 * n + state] = 0.0;
        H[103 * n + state] = 0.0;
        H[104 * n + state] = 0.0;
        H[105 * n + state] = 0.0;
        H[106 * n + state] = 0.0;
        H[107 * n + state] = 0.0;
        H[108 * n + state] = 0.0;
        H[109 * n + state] = 0.0;
        H[110 * n + state] = 0.0;
        H[111 * n + state] = 0.0;
        H[112 * n + state] = 0.0;
        H[113 * n + state] = 0.0;
        H[114 * n + state] = 0.0;
        H[115 * n + state] = 0.0;
        H[116 * n + state] = 0.0;
        H[117 * n + state] = 0.0;
        H[118 * n + state] = 0.0;
        H[119 * n + state] = 0.0;
        H[120 * n + state] = 0.0;
        H[121 * n + state] = 0.0;
        H[122 * n + state] = 0.0;
        H[123 * n + state] = 0.0;
        H[124 * n + state] = 0.0;
        H[125 * n + state] = 0.0;
        H[126 * n + state] = 0.0;
        H[127 * n + state] = 0.0;
    }
}

void index_link_position_batch(int count, const double *SINEW_RESTRICT h, double *SINEW_RESTRICT q)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 38.46153846153846 * h[state];
        const double t2 = 38.46153846153846 * h[1 * n + state];
        const double t3 = 38.46153846153846 * h[2 * n + state];
        const double t4 = 38.46153846153846 * h[3 * n + state];
        const double t5 = h[4 * n + state] - h[5 * n + state];
        q[state] = t1 + t2 - t3 - t4;
        q[1 * n + state] = t1 - t2 + t3 - t4;
        q[2 * n + state] = 90.90909090909092 * t5;
        q[3 * n + state] = 111.11111111111111 * (t5 - h[6 * n + state] + h[7 * n + state]);
    }
}

void index_link_position_covariance_batch(int count, const double *SINEW_RESTRICT sigma,
    double *SINEW_RESTRICT covariance)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double variance = sigma[state] * sigma[state];
        const double t1 = 5917.15976331361 * variance;
        const double t2 = 20202.0202020202 * variance;
        covariance[state] = t1;
        covariance[1 * n + state] = 0.0;
        covariance[2 * n + state] = 0.0;
        covariance[3 * n + state] = 0.0;
        covariance[4 * n + state] = 0.0;
        covariance[5 * n + state] = t1;
        covariance[6 * n + state] = 0.0;
        covariance[7 * n + state] = 0.0;
        covariance[8 * n + state] = 0.0;
        covariance[9 * n + state] = 0.0;
        covariance[10 * n + state] = 16528.92561983471 * variance;
        covariance[11 * n + state] = t2;
        covariance[12 * n + state] = 0.0;
        covariance[13 * n + state] = 0.0;
        covariance[14 * n + state] = t2;
        covariance[15 * n + state] = 49382.71604938272 * variance;
    }
}

void index_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(q[state], -q[state]) + sinew_max(q[1 * n + state], -q[1 * n
            + state]);
        const double t2 = sinew_max(q[2 * n + state], -q[2 * n + state]);
        const double t3 = t2 + sinew_max(q[3 * n + state], -q[3 * n + state]);
        angles[state] = t1;
        angles[1 * n + state] = t1;
        angles[2 * n + state] = t1;
        angles[3 * n + state] = t1;
        angles[4 * n + state] = t2;
        angles[5 * n + state] = t2;
        angles[6 * n + state] = t3;
        angles[7 * n + state] = t3;
    }
}
