/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model thumb over many states; element k
 *     of state i is at [k * count + i].
 *
 * Made by: sinew generate models/thumb
 * Model:   sha256 a1887dfbbeca57cfa47ae5f680c6749b28b13c33cd3d097b0d35ffdcc7f65850
 * Do not edit: change the model and generate again.
 */
#include "thumb_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void thumb_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q,
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
        const double R41y = c1 * c4;
        const double o4x = 0.045 * c2 + 0.0298 * c3;
        const double R42y = s1 * c4;
        T[state] = R41y;
        T[1 * n + state] = -s1;
        T[2 * n + state] = -(c1 * s4);
        T[3 * n + state] = c1 * o4x + 0.0201 * R41y;
        T[4 * n + state] = R42y;
        T[5 * n + state] = c1;
        T[6 * n + state] = -(s1 * s4);
        T[7 * n + state] = s1 * o4x + 0.0201 * R42y;
        T[8 * n + state] = s4;
        T[9 * n + state] = 0.0;
        T[10 * n + state] = c4;
        T[11 * n + state] = 0.045 * s2 + 0.0298 * s3 + 0.0201 * s4;
        T[12 * n + state] = 0.0;
        T[13 * n + state] = 0.0;
        T[14 * n + state] = 0.0;
        T[15 * n + state] = 1.0;
    }
}

void thumb_tip_jacobian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT J)
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
        const double l3x = 0.045 * c2;
        const double o4x = l3x + 0.0298 * c3;
        const double p4y = s1 * o4x;
        const double ptipy = p4y + 0.0201 * s1 * c4;
        const double l3y = 0.045 * s2;
        const double o4y = l3y + 0.0298 * s3;
        const double ptipz = o4y + 0.0201 * s4;
        const double arm3_4 = l3y - ptipz;
        const double arm4_4 = o4y - ptipz;
        const double p4x = c1 * o4x;
        const double ptipx = p4x + 0.0201 * c1 * c4;
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
        J[9 * n + state] = c1 * ptipx + s1 * ptipy;
        J[10 * n + state] = -(c1 * (c1 * l3x - ptipx) + s1 * (s1 * l3x - ptipy));
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

void thumb_mass_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT M)
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
        const double t1 = c2 * (2.4218999999999996e-05 * c2) + c3 * (4.3862e-06 * c3) - s4
            * (3.7701e-07 * s4);
        const double l4x = 0.0298 * c3;
        const double l3x = 0.045 * c2;
        const double j4x1 = 3.015e-05 * c4;
        const double j3x1 = 0.0001788 * c3;
        const double t2 = l4x * j4x1;
        const double t3 = l3x * (j3x1 + j4x1);
        const double Z1 = t1 + (l3x + l4x) * j4x1 + l3x * j3x1 + t2 + t3 + 7.250099999999999e-07;
        const double j4y1 = 3.015e-05 * s4;
        const double l3y = 0.045 * s2;
        const double lS3 = t3 + l3y * (0.0001788 * s3 + j4y1);
        const double lS4 = t2 + 0.0298 * s3 * j4y1;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double M_4 = Z3 + lS3;
        const double M_2 = 4.3101e-07 + lS4;
        const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
        M[state] = Z1;
        M[1 * n + state] = 0.0;
        M[2 * n + state] = 0.0;
        M[3 * n + state] = 0.0;
        M[4 * n + state] = 0.0;
        M[5 * n + state] = 2.4381e-05 + Z3 + (lS3 + lS3);
        M[6 * n + state] = M_4;
        M[7 * n + state] = M_2_2;
        M[8 * n + state] = 0.0;
        M[9 * n + state] = M_4;
        M[10 * n + state] = Z3;
        M[11 * n + state] = M_2;
        M[12 * n + state] = 0.0;
        M[13 * n + state] = M_2_2;
        M[14 * n + state] = M_2;
        M[15 * n + state] = 4.3101e-07;
    }
}

void thumb_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q,
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
        const double l3x = 0.045 * c2;
        const double j4y1 = 3.015e-05 * s4;
        const double K4yx = c4 * 3.7701e-07 * s4 + (l3x + l4x) * j4y1;
        const double j3y1 = 0.0001788 * s3;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t1 = l4y * j4x1;
        const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + l3x * j3y1 + t1;
        const double j3x1 = 0.0001788 * c3;
        const double l3y = 0.045 * s2;
        const double t2 = l3y * (j3x1 + j4x1);
        const double K2yx = s2 * 2.4218999999999996e-05 * c2 + K3yx + t2;
        const double E2wQxx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n
            + state] * K4yx;
        const double cD2y = qd[state] * K2yx;
        const double cD3y = qd[state] * K3yx;
        const double cD4y = qd[state] * K4yx;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w4z = qd[3 * n + state] + w3z;
        const double G4y = j4y1 * w4z;
        const double G4x = j4x1 * w4z;
        const double C_2 = l4x * G4y - l4y * G4x;
        const double C_3 = w3z * (l4x * j4y1 - t1);
        const double Y3 = C_2 - C_3;
        const double C_8 = Y3 - qd[1 * n + state] * (l3x * (j3y1 + j4y1) - t2);
        const double t3 = l3x * (G4y + j3y1 * w3z);
        const double t4 = l3y * (G4x + j3x1 * w3z);
        const double C_4 = C_3 + qd[1 * n + state] * (l3x * j4y1 - l3y * j4x1);
        C[state] = -E2wQxx;
        C[1 * n + state] = -cD2y;
        C[2 * n + state] = -cD3y;
        C[3 * n + state] = -cD4y;
        C[4 * n + state] = cD2y;
        C[5 * n + state] = -(C_8 + t3 - t4);
        C[6 * n + state] = -(Y3 + t3 - t4);
        C[7 * n + state] = -(C_2 + l3x * G4y - l3y * G4x);
        C[8 * n + state] = cD3y;
        C[9 * n + state] = -C_8;
        C[10 * n + state] = -Y3;
        C[11 * n + state] = -C_2;
        C[12 * n + state] = cD4y;
        C[13 * n + state] = C_4;
        C[14 * n + state] = C_3;
        C[15 * n + state] = 0.0;
    }
}

void thumb_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g)
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
        g[1 * n + state] = n3 + 0.005959575 * c2;
        g[2 * n + state] = n3;
        g[3 * n + state] = n4;
    }
}

void thumb_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd,
    double *SINEW_RESTRICT h)
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
        const double l3x = 0.045 * c2;
        const double j4y1 = 3.015e-05 * s4;
        const double K4yx = c4 * 3.7701e-07 * s4 + (l3x + l4x) * j4y1;
        const double t1 = l3x * (0.0001788 * s3);
        const double j4x1 = 3.015e-05 * c4;
        const double t2 = 0.0298 * s3 * j4x1;
        const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + t1 + t2;
        const double j3x1 = 0.0001788 * c3;
        const double l3y = 0.045 * s2;
        const double K2yx = s2 * 2.4218999999999996e-05 * c2 + K3yx + l3y * (j3x1 + j4x1);
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double X3_4 = l4x * j4y1 - t2;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = t1 - l3y * j3x1;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double n2 = n3 + 0.005959575 * c2 - w3zz * X2_3 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        h[state] = -((qd[state] + qd[state]) * R2yx);
        h[1 * n + state] = n2 + w1zz * K2yx;
        h[2 * n + state] = n3 + w1zz * K3yx;
        h[3 * n + state] = n4 + w1zz * K4yx;
    }
}

void thumb_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q,
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
        const double j2u = 2.4218999999999996e-05 * c2;
        const double j4u = 3.7701e-07 * s4;
        const double l4x = 0.0298 * c3;
        const double l3x = 0.045 * c2;
        const double o4x = l3x + l4x;
        const double j4x1 = 3.015e-05 * c4;
        const double j3x1 = 0.0001788 * c3;
        const double t1 = l4x * j4x1;
        const double S3x = j3x1 + j4x1;
        const double t2 = l3x * S3x;
        const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t1 + t2
            + 7.250099999999999e-07;
        const double j4y1 = 3.015e-05 * s4;
        const double j3y1 = 0.0001788 * s3;
        const double l3y = 0.045 * s2;
        const double lS3 = t2 + l3y * (j3y1 + j4y1);
        const double l4y = 0.0298 * s3;
        const double lS4 = t1 + l4y * j4y1;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double M_4 = Z3 + lS3;
        const double M_2 = 4.3101e-07 + lS4;
        const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
        const double K4yx = c4 * j4u + o4x * j4y1;
        const double t3 = l3x * j3y1;
        const double t4 = l4y * j4x1;
        const double K3yx = s3 * j3u + K4yx + t3 + t4;
        const double K2yx = s2 * j2u + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double X3_4 = l4x * j4y1 - t4;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = t3 - l3y * j3x1;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double n2 = n3 + 0.005959575 * c2 - w3zz * X2_3 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        M[state] = Z1;
        M[1 * n + state] = 0.0;
        M[2 * n + state] = 0.0;
        M[3 * n + state] = 0.0;
        M[4 * n + state] = 0.0;
        M[5 * n + state] = 2.4381e-05 + Z3 + (lS3 + lS3);
        M[6 * n + state] = M_4;
        M[7 * n + state] = M_2_2;
        M[8 * n + state] = 0.0;
        M[9 * n + state] = M_4;
        M[10 * n + state] = Z3;
        M[11 * n + state] = M_2;
        M[12 * n + state] = 0.0;
        M[13 * n + state] = M_2_2;
        M[14 * n + state] = M_2;
        M[15 * n + state] = 4.3101e-07;
        h[state] = -((qd[state] + qd[state]) * R2yx);
        h[1 * n + state] = n2 + K2yx * w1zz;
        h[2 * n + state] = n3 + K3yx * w1zz;
        h[3 * n + state] = n4 + K4yx * w1zz;
    }
}

void thumb_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd)
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
        const double l3x = 0.045 * c2;
        const double o4x = l3x + l4x;
        const double j4y1 = 3.015e-05 * s4;
        const double j4u = 3.7701e-07 * s4;
        const double K4yx = c4 * j4u + o4x * j4y1;
        const double j3u = 4.3862e-06 * c3;
        const double j3y1 = 0.0001788 * s3;
        const double t1 = l3x * j3y1;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t2 = l4y * j4x1;
        const double K3yx = s3 * j3u + K4yx + t1 + t2;
        const double j2u = 2.4218999999999996e-05 * c2;
        const double j3x1 = 0.0001788 * c3;
        const double S3x = j3x1 + j4x1;
        const double l3y = 0.045 * s2;
        const double K2yx = s2 * j2u + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double y1 = tau[state] + (qd[state] + qd[state]) * R2yx;
        const double t3 = l4x * j4x1;
        const double t4 = l3x * S3x;
        const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t3 + t4
            + 7.250099999999999e-07;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double X3_4 = l4x * j4y1 - t2;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double n4 = 9.81 * j4x1 + w2zz * X2_4 + w3zz * X3_4;
        const double X2_3 = t1 - l3y * j3x1;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double n3 = n4 + 9.81 * j3x1 + w2zz * X2_3 - w4zz * X3_4;
        const double w1zz = qd[state] * qd[state];
        const double y4 = tau[3 * n + state] - n4 - K4yx * w1zz;
        const double lS4 = t3 + l4y * j4y1;
        const double M = 4.3101e-07 + lS4;
        const double L4_3 = 2320131.783485302 * M;
        const double b3 = tau[2 * n + state] - n3 - K3yx * w1zz - y4 * L4_3;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double lS3 = t4 + l3y * (j3y1 + j4y1);
        const double M_2 = M + l3x * j4x1 + l3y * j4y1;
        const double A3_2 = Z3 + lS3 - M_2 * L4_3;
        const double r3 = 1.0 / (Z3 - M * L4_3);
        const double L3_2 = A3_2 * r3;
        const double t5 = tau[1 * n + state] - n3 - 0.005959575 * c2 + w3zz * X2_3 + w4zz * X2_4
            - K2yx * w1zz;
        const double L4_2 = 2320131.783485302 * M_2;
        const double A2_2 = 2.4381e-05 + Z3 + (lS3 + lS3) - M_2 * L4_2;
        const double x2 = (t5 - y4 * L4_2 - b3 * L3_2) * (1.0 / (A2_2 - A3_2 * L3_2));
        const double x3 = b3 * r3 - L3_2 * x2;
        const double x4 = 2320131.783485302 * y4 - L4_3 * x3 - L4_2 * x2;
        qdd[state] = y1 * (1.0 / Z1);
        qdd[1 * n + state] = x2;
        qdd[2 * n + state] = x3;
        qdd[3 * n + state] = x4;
    }
}

void thumb_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau)
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
        const double l3x = 0.045 * c2;
        const double o4x = l3x + l4x;
        const double j4y1 = 3.015e-05 * s4;
        const double j4u = 3.7701e-07 * s4;
        const double K4yx = c4 * j4u + o4x * j4y1;
        const double j3u = 4.3862e-06 * c3;
        const double j3y1 = 0.0001788 * s3;
        const double t1 = l3x * j3y1;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t2 = l4y * j4x1;
        const double K3yx = s3 * j3u + K4yx + t1 + t2;
        const double j2u = 2.4218999999999996e-05 * c2;
        const double j3x1 = 0.0001788 * c3;
        const double S3x = j3x1 + j4x1;
        const double l3y = 0.045 * s2;
        const double K2yx = s2 * j2u + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state]
            * K4yx;
        const double t3 = l3x * j3x1;
        const double t4 = l4x * j4x1;
        const double t5 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + t3 + t4 + l3x * S3x
            + 7.2501e-07;
        const double N1z = qdd[state] * t5 - (qd[state] + qd[state]) * R2yx;
        const double D2_4 = l3x * j4x1 + l3y * j4y1;
        const double al3z = qdd[1 * n + state] + qdd[2 * n + state];
        const double al4z = qdd[3 * n + state] + al3z;
        const double lS4 = t4 + l4y * j4y1;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double t6 = 4.3101e-07 * al4z + 9.81 * j4x1 + qdd[1 * n + state] * D2_4 + lS4 * al3z
            + w2zz * X2_4;
        const double X3_4 = l4x * j4y1 - t2;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double n4 = t6 + w3zz * X3_4;
        const double D2_3 = t3 + l3y * j3y1;
        const double t7 = n4 + 4.4942e-06 * al3z + 9.81 * j3x1 + qdd[1 * n + state] * D2_3 + lS4
            * al4z;
        const double X2_3 = t1 - l3y * j3x1;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double n3 = t7 + w2zz * X2_3 - w4zz * X3_4;
        const double t8 = n3 + 2.4381e-05 * qdd[1 * n + state] + 0.005959575 * c2 + al3z * D2_3
            - w3zz * X2_3;
        const double w1zz = qd[state] * qd[state];
        const double t2_2 = t8 + al4z * D2_4 - w4zz * X2_4 + w1zz * K2yx;
        tau[state] = N1z;
        tau[1 * n + state] = t2_2;
        tau[2 * n + state] = n3 + w1zz * K3yx;
        tau[3 * n + state] = n4 + w1zz * K4yx;
    }
}

void thumb_tendon_lengths_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT h)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double t1 = 0.005 * (c1 * s2);
        const double t2 = 0.006 * s1;
        const double t3 = t1 - t2;
        const double t4 = 0.047 * (c1 * c2);
        const double A_lengthdx = 0.002 - t3 - t4;
        const double t5 = 0.005 * (s1 * s2);
        const double t6 = 0.006 * c1;
        const double t7 = 0.03 - (t5 + t6);
        const double t8 = 0.047 * (s1 * c2);
        const double A_lengthdy = t7 - t8;
        const double t9 = 0.025 - 0.005 * c2;
        const double t10 = 0.047 * s2;
        const double A_lengthdz = t9 + t10;
        const double t11 = A_lengthdz * A_lengthdz;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t11);
        const double t12 = t1 + t2;
        const double B_lengthdx = 0.002 + t12 - t4;
        const double t13 = 0.03 + (t5 - t6);
        const double B_lengthdy = t13 - t8;
        const double B_lengthdz = t9 - t10;
        const double t14 = B_lengthdz * B_lengthdz;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t14);
        const double C_lengthdx = 0.002 - t12 - t4;
        const double C_lengthdy = t13 + t8;
        const double C_length = sinew_sqrt(t11 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double D_lengthdx = 0.002 + t3 - t4;
        const double D_lengthdy = t7 + t8;
        const double D_length = sinew_sqrt(t14 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t15 = 0.0065 * q[2 * n + state];
        const double t16 = 0.0055 * q[3 * n + state] - t15;
        h[state] = A_length;
        h[1 * n + state] = B_length;
        h[2 * n + state] = C_length;
        h[3 * n + state] = D_length;
        h[4 * n + state] = t15;
        h[5 * n + state] = -t15;
        h[6 * n + state] = t16;
        h[7 * n + state] = -t16;
    }
}

void thumb_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT P)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double R21x = c1 * c2;
        const double t1 = 0.047 * R21x;
        const double t2 = 0.006 * s1;
        const double R21y = c1 * s2;
        const double t3 = 0.005 * R21y;
        const double t4 = t3 - t2;
        const double pA_length_tox = t4 + t1;
        const double R22x = s1 * c2;
        const double t5 = 0.047 * R22x;
        const double t6 = 0.006 * c1;
        const double R22y = s1 * s2;
        const double t7 = 0.005 * R22y;
        const double t8 = t7 + t6;
        const double pA_length_toy = t8 + t5;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double t9 = 0.047 * s2;
        const double t10 = 0.025 - 0.005 * c2;
        const double A_lengthdz = t10 + t9;
        const double t11 = A_lengthdz * A_lengthdz;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t11);
        const double t12 = 1.0 / A_length;
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx)
            * t12;
        const double t13 = 0.005 * s2;
        const double t14 = 0.047 * c2;
        const double t15 = A_lengthdz * (t13 + t14);
        const double t16 = 0.005 * R21x;
        const double t17 = 0.047 * R21y;
        const double pA_length_tox_by_q1 = t16 - t17;
        const double t18 = 0.005 * R22x;
        const double t19 = 0.047 * R22y;
        const double pA_length_toy_by_q1 = t18 - t19;
        const double t20 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1
            - t15;
        const double t21 = t3 + t2;
        const double pB_length_tox = t21 - t1;
        const double t22 = t7 - t6;
        const double pB_length_toy = t22 - t5;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double B_lengthdz = t10 - t9;
        const double t23 = B_lengthdz * B_lengthdz;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t23);
        const double t24 = 1.0 / B_length;
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx)
            * t24;
        const double t25 = B_lengthdz * (t13 - t14);
        const double pB_length_tox_by_q1 = t16 + t17;
        const double pB_length_toy_by_q1 = t18 + t19;
        const double t26 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1
            + t25;
        const double pC_length_tox = t21 + t1;
        const double pC_length_toy = t22 + t5;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double C_length = sinew_sqrt(t11 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t27 = 1.0 / C_length;
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx)
            * t27;
        const double t28 = t15 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy
            * pA_length_toy_by_q1;
        const double pD_length_tox = t4 - t1;
        const double pD_length_toy = t8 - t5;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double D_length = sinew_sqrt(t23 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t29 = 1.0 / D_length;
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx)
            * t29;
        const double t30 = t25 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy
            * pB_length_toy_by_q1;
        P[state] = -A_length_by_q0;
        P[1 * n + state] = -(t20 * t12);
        P[2 * n + state] = 0.0;
        P[3 * n + state] = 0.0;
        P[4 * n + state] = B_length_by_q0;
        P[5 * n + state] = t26 * t24;
        P[6 * n + state] = 0.0;
        P[7 * n + state] = 0.0;
        P[8 * n + state] = C_length_by_q0;
        P[9 * n + state] = t28 * t27;
        P[10 * n + state] = 0.0;
        P[11 * n + state] = 0.0;
        P[12 * n + state] = -D_length_by_q0;
        P[13 * n + state] = t30 * t29;
        P[14 * n + state] = 0.0;
        P[15 * n + state] = 0.0;
        P[16 * n + state] = 0.0;
        P[17 * n + state] = 0.0;
        P[18 * n + state] = 0.0065;
        P[19 * n + state] = 0.0;
        P[20 * n + state] = 0.0;
        P[21 * n + state] = 0.0;
        P[22 * n + state] = -0.0065;
        P[23 * n + state] = 0.0;
        P[24 * n + state] = 0.0;
        P[25 * n + state] = 0.0;
        P[26 * n + state] = -0.0065;
        P[27 * n + state] = 0.0055;
        P[28 * n + state] = 0.0;
        P[29 * n + state] = 0.0;
        P[30 * n + state] = 0.0065;
        P[31 * n + state] = -0.0055;
    }
}

void thumb_joint_torque_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double R21x = c1 * c2;
        const double t1 = 0.047 * R21x;
        const double t2 = 0.006 * s1;
        const double R21y = c1 * s2;
        const double t3 = 0.005 * R21y;
        const double t4 = t3 - t2;
        const double pD_length_tox = t4 - t1;
        const double R22x = s1 * c2;
        const double t5 = 0.047 * R22x;
        const double t6 = 0.006 * c1;
        const double R22y = s1 * s2;
        const double t7 = 0.005 * R22y;
        const double t8 = t7 + t6;
        const double pD_length_toy = t8 - t5;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double t9 = 0.047 * s2;
        const double t10 = 0.025 - 0.005 * c2;
        const double B_lengthdz = t10 - t9;
        const double t11 = B_lengthdz * B_lengthdz;
        const double D_length = sinew_sqrt(t11 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t12 = 1.0 / D_length;
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx)
            * t12;
        const double t13 = t3 + t2;
        const double pC_length_tox = t13 + t1;
        const double t14 = t7 - t6;
        const double pC_length_toy = t14 + t5;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double A_lengthdz = t10 + t9;
        const double t15 = A_lengthdz * A_lengthdz;
        const double C_length = sinew_sqrt(t15 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t16 = 1.0 / C_length;
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx)
            * t16;
        const double pA_length_tox = t4 + t1;
        const double pA_length_toy = t8 + t5;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t15);
        const double t17 = 1.0 / A_length;
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx)
            * t17;
        const double pB_length_tox = t13 - t1;
        const double pB_length_toy = t14 - t5;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t11);
        const double t18 = 1.0 / B_length;
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx)
            * t18;
        const double t19 = f[state] * A_length_by_q0 - f[1 * n + state] * B_length_by_q0 - f[2 * n
            + state] * C_length_by_q0;
        const double t20 = 0.005 * R22x;
        const double t21 = 0.047 * R22y;
        const double pB_length_toy_by_q1 = t20 + t21;
        const double t22 = 0.005 * s2;
        const double t23 = 0.047 * c2;
        const double t24 = B_lengthdz * (t22 - t23);
        const double t25 = 0.005 * R21x;
        const double t26 = 0.047 * R21y;
        const double pB_length_tox_by_q1 = t25 + t26;
        const double t27 = t24 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy
            * pB_length_toy_by_q1;
        const double pA_length_toy_by_q1 = t20 - t21;
        const double t28 = A_lengthdz * (t22 + t23);
        const double pA_length_tox_by_q1 = t25 - t26;
        const double t29 = t28 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy
            * pA_length_toy_by_q1;
        const double t30 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1
            - t28;
        const double t31 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1
            + t24;
        const double t32 = f[state] * (t30 * t17) - f[1 * n + state] * (t31 * t18) - f[2 * n
            + state] * (t29 * t16);
        const double t33 = f[4 * n + state] - f[5 * n + state] - f[6 * n + state] + f[7 * n
            + state];
        tau[state] = t19 + f[3 * n + state] * D_length_by_q0;
        tau[1 * n + state] = t32 - f[3 * n + state] * (t27 * t12);
        tau[2 * n + state] = -(0.0065 * t33);
        tau[3 * n + state] = -(0.0055 * (f[6 * n + state] - f[7 * n + state]));
    }
}

void thumb_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double K4_4 = 3.0249999999999997e-05 * (kt[6 * n + state] + kt[7 * n + state]);
        const double t1 = 0.0065 * kt[6 * n + state] + 0.0065 * kt[7 * n + state];
        const double t2 = -(0.0055 * t1);
        const double K3_3 = 4.225e-05 * (kt[4 * n + state] + kt[5 * n + state]) + 0.0065 * t1;
        const double R21y = c1 * s2;
        const double t3 = 0.005 * R21y;
        const double t4 = 0.006 * s1;
        const double t5 = t3 - t4;
        const double R21x = c1 * c2;
        const double t6 = 0.047 * R21x;
        const double pA_length_tox = t5 + t6;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double R22y = s1 * s2;
        const double t7 = 0.005 * R22y;
        const double t8 = 0.006 * c1;
        const double t9 = t7 + t8;
        const double R22x = s1 * c2;
        const double t10 = 0.047 * R22x;
        const double pA_length_toy = t9 + t10;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double t11 = 0.005 * c2;
        const double t12 = 0.047 * s2;
        const double pA_length_toz = t11 - t12;
        const double A_lengthdz = 0.025 - pA_length_toz;
        const double t13 = A_lengthdz * A_lengthdz;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t13);
        const double t14 = 1.0 / A_length;
        const double t15 = 0.005 * R21x;
        const double t16 = 0.047 * R21y;
        const double pA_length_tox_by_q1 = t15 - t16;
        const double t17 = 0.005 * R22x;
        const double t18 = 0.047 * R22y;
        const double pA_length_toy_by_q1 = t17 - t18;
        const double t19 = 0.005 * s2;
        const double t20 = 0.047 * c2;
        const double pA_length_toz_by_q1 = t19 + t20;
        const double t21 = A_lengthdz * pA_length_toz_by_q1;
        const double t22 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1
            - t21;
        const double A_length_by_q1 = t22 * t14;
        const double pA_length_tox_by_q1_2_by_q1 = t3 + t6;
        const double t23 = pA_length_toz * A_lengthdz;
        const double pA_length_toy_by_q1_2_by_q1 = t7 + t10;
        const double t24 = t23 + A_lengthdx * pA_length_tox_by_q1_2_by_q1 + A_lengthdy
            * pA_length_toy_by_q1_2_by_q1;
        const double t25 = pA_length_tox_by_q1 * pA_length_tox_by_q1;
        const double t26 = pA_length_toy_by_q1 * pA_length_toy_by_q1;
        const double t27 = pA_length_toz_by_q1 * pA_length_toz_by_q1;
        const double A_length_by_q1_2_by_q1 = (t24 + t25 + t26 + t27 - A_length_by_q1
            * A_length_by_q1) * t14;
        const double t28 = t3 + t4;
        const double pB_length_tox = t28 - t6;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double t29 = t7 - t8;
        const double pB_length_toy = t29 - t10;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double pB_length_toz = t11 + t12;
        const double B_lengthdz = 0.025 - pB_length_toz;
        const double t30 = B_lengthdz * B_lengthdz;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t30);
        const double t31 = 1.0 / B_length;
        const double pB_length_tox_by_q1 = t15 + t16;
        const double pB_length_toy_by_q1 = t17 + t18;
        const double pB_length_toz_by_q1 = t19 - t20;
        const double t32 = B_lengthdz * pB_length_toz_by_q1;
        const double t33 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1
            + t32;
        const double B_length_by_q1 = t33 * t31;
        const double pB_length_tox_by_q1_2_by_q1 = t3 - t6;
        const double t34 = pB_length_toz * B_lengthdz;
        const double pB_length_toy_by_q1_2_by_q1 = t7 - t10;
        const double t35 = t34 - B_lengthdx * pB_length_tox_by_q1_2_by_q1 - B_lengthdy
            * pB_length_toy_by_q1_2_by_q1;
        const double t36 = pB_length_tox_by_q1 * pB_length_tox_by_q1;
        const double t37 = pB_length_toy_by_q1 * pB_length_toy_by_q1;
        const double t38 = pB_length_toz_by_q1 * pB_length_toz_by_q1;
        const double B_length_by_q1_2_by_q1 = (t35 + t36 + t37 + t38 - B_length_by_q1
            * B_length_by_q1) * t31;
        const double t39 = f[state] * A_length_by_q1_2_by_q1 + f[1 * n + state]
            * B_length_by_q1_2_by_q1;
        const double pC_length_tox = t28 + t6;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double pC_length_toy = t29 + t10;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_length = sinew_sqrt(t13 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t40 = 1.0 / C_length;
        const double t41 = t21 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy
            * pA_length_toy_by_q1;
        const double C_length_by_q1 = t41 * t40;
        const double t42 = t23 + C_lengthdx * pA_length_tox_by_q1_2_by_q1 - C_lengthdy
            * pA_length_toy_by_q1_2_by_q1;
        const double C_length_by_q1_2_by_q1 = (t42 + t25 + t26 + t27 - C_length_by_q1
            * C_length_by_q1) * t40;
        const double pD_length_tox = t5 - t6;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double pD_length_toy = t9 - t10;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_length = sinew_sqrt(t30 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t43 = 1.0 / D_length;
        const double t44 = t32 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy
            * pB_length_toy_by_q1;
        const double D_length_by_q1 = t44 * t43;
        const double t45 = t34 - D_lengthdx * pB_length_tox_by_q1_2_by_q1 + D_lengthdy
            * pB_length_toy_by_q1_2_by_q1;
        const double D_length_by_q1_2_by_q1 = (t45 + t36 + t37 + t38 - D_length_by_q1
            * D_length_by_q1) * t43;
        const double t46 = t39 + f[2 * n + state] * C_length_by_q1_2_by_q1 + f[3 * n + state]
            * D_length_by_q1_2_by_q1;
        const double t47 = t46 + A_length_by_q1 * (kt[state] * A_length_by_q1) + B_length_by_q1
            * (kt[1 * n + state] * B_length_by_q1);
        const double K2_2 = t47 + C_length_by_q1 * (kt[2 * n + state] * C_length_by_q1)
            + D_length_by_q1 * (kt[3 * n + state] * D_length_by_q1);
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx)
            * t31;
        const double t48 = B_lengthdx - pB_length_tox;
        const double t49 = B_lengthdy - pB_length_toy;
        const double t50 = pB_length_tox_by_q1 * t49 + pB_length_toy_by_q1 * -t48 - B_length_by_q0
            * B_length_by_q1;
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx)
            * t14;
        const double t51 = A_lengthdx + pA_length_tox;
        const double t52 = A_lengthdy + pA_length_toy;
        const double t53 = pA_length_toy_by_q1 * t51 - pA_length_tox_by_q1 * t52 - A_length_by_q0
            * A_length_by_q1;
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx)
            * t40;
        const double t54 = pC_length_toy - C_lengthdy;
        const double t55 = C_lengthdx + pC_length_tox;
        const double t56 = pA_length_tox_by_q1 * -t54 + pA_length_toy_by_q1 * t55 - C_length_by_q0
            * C_length_by_q1;
        const double t57 = f[state] * (t53 * t14) + f[1 * n + state] * (t50 * t31) + f[2 * n
            + state] * (t56 * t40);
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx)
            * t43;
        const double t58 = D_lengthdx - pD_length_tox;
        const double t59 = D_lengthdy + pD_length_toy;
        const double t60 = pB_length_toy_by_q1 * -t58 - pB_length_tox_by_q1 * t59 + D_length_by_q0
            * D_length_by_q1;
        const double w1_1 = kt[state] * A_length_by_q0;
        const double w2_1 = kt[1 * n + state] * B_length_by_q0;
        const double t61 = t57 + f[3 * n + state] * (t60 * t43) + A_length_by_q1 * w1_1
            + B_length_by_q1 * w2_1;
        const double w3_1 = kt[2 * n + state] * C_length_by_q0;
        const double w4_1 = kt[3 * n + state] * D_length_by_q0;
        const double K1_2 = t61 + C_length_by_q1 * w3_1 - D_length_by_q1 * w4_1;
        const double t62 = pA_length_toy * t52 + pA_length_tox * t51 - A_length_by_q0
            * A_length_by_q0;
        const double t63 = pB_length_toy * t49 + pB_length_tox * t48 + B_length_by_q0
            * B_length_by_q0;
        const double t64 = pC_length_toy * t54 + pC_length_tox * t55 - C_length_by_q0
            * C_length_by_q0;
        const double t65 = f[state] * (t62 * t14) - f[1 * n + state] * (t63 * t31) + f[2 * n
            + state] * (t64 * t40);
        const double t66 = pD_length_tox * t58 - pD_length_toy * t59 + D_length_by_q0
            * D_length_by_q0;
        const double t67 = t65 - f[3 * n + state] * (t66 * t43) + A_length_by_q0 * w1_1
            + B_length_by_q0 * w2_1;
        const double K1_1 = t67 + C_length_by_q0 * w3_1 + D_length_by_q0 * w4_1;
        K[state] = K1_1;
        K[1 * n + state] = K1_2;
        K[2 * n + state] = 0.0;
        K[3 * n + state] = 0.0;
        K[4 * n + state] = K1_2;
        K[5 * n + state] = K2_2;
        K[6 * n + state] = 0.0;
        K[7 * n + state] = 0.0;
        K[8 * n + state] = 0.0;
        K[9 * n + state] = 0.0;
        K[10 * n + state] = K3_3;
        K[11 * n + state] = t2;
        K[12 * n + state] = 0.0;
        K[13 * n + state] = 0.0;
        K[14 * n + state] = t2;
        K[15 * n + state] = K4_4;
    }
}

void thumb_tendon_hessian_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT H)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double t1 = 0.005 * c2;
        const double t2 = 0.047 * s2;
        const double pA_length_toz = t1 - t2;
        const double A_lengthdz = 0.025 - pA_length_toz;
        const double t3 = A_lengthdz * A_lengthdz;
        const double R21x = c1 * c2;
        const double t4 = 0.047 * R21x;
        const double t5 = 0.006 * s1;
        const double R21y = c1 * s2;
        const double t6 = 0.005 * R21y;
        const double t7 = t6 - t5;
        const double pA_length_tox = t7 + t4;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double R22x = s1 * c2;
        const double t8 = 0.047 * R22x;
        const double t9 = 0.006 * c1;
        const double R22y = s1 * s2;
        const double t10 = 0.005 * R22y;
        const double t11 = t10 + t9;
        const double pA_length_toy = t11 + t8;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t3);
        const double t12 = 1.0 / A_length;
        const double t13 = A_lengthdy + pA_length_toy;
        const double t14 = A_lengthdx + pA_length_tox;
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx)
            * t12;
        const double t15 = pA_length_toy * t13 + pA_length_tox * t14 - A_length_by_q0
            * A_length_by_q0;
        const double t16 = 0.005 * R22x;
        const double t17 = 0.047 * R22y;
        const double pA_length_toy_by_q1 = t16 - t17;
        const double t18 = 0.005 * R21x;
        const double t19 = 0.047 * R21y;
        const double pA_length_tox_by_q1 = t18 - t19;
        const double t20 = 0.005 * s2;
        const double t21 = 0.047 * c2;
        const double pA_length_toz_by_q1 = t20 + t21;
        const double t22 = A_lengthdz * pA_length_toz_by_q1;
        const double t23 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1
            - t22;
        const double A_length_by_q1 = t23 * t12;
        const double t24 = pA_length_toy_by_q1 * t14 - pA_length_tox_by_q1 * t13 - A_length_by_q0
            * A_length_by_q1;
        const double A_length_by_q0_2_by_q1 = t24 * t12;
        const double t25 = pA_length_toz_by_q1 * pA_length_toz_by_q1;
        const double t26 = pA_length_toy_by_q1 * pA_length_toy_by_q1;
        const double t27 = pA_length_tox_by_q1 * pA_length_tox_by_q1;
        const double pA_length_toy_by_q1_2_by_q1 = t10 + t8;
        const double t28 = pA_length_toz * A_lengthdz;
        const double pA_length_tox_by_q1_2_by_q1 = t6 + t4;
        const double t29 = t28 + A_lengthdx * pA_length_tox_by_q1_2_by_q1 + A_lengthdy
            * pA_length_toy_by_q1_2_by_q1;
        const double A_length_by_q1_2_by_q1 = (t29 + t27 + t26 + t25 - A_length_by_q1
            * A_length_by_q1) * t12;
        const double pB_length_toz = t1 + t2;
        const double B_lengthdz = 0.025 - pB_length_toz;
        const double t30 = B_lengthdz * B_lengthdz;
        const double t31 = t6 + t5;
        const double pB_length_tox = t31 - t4;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double t32 = t10 - t9;
        const double pB_length_toy = t32 - t8;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t30);
        const double t33 = 1.0 / B_length;
        const double t34 = B_lengthdy - pB_length_toy;
        const double t35 = B_lengthdx - pB_length_tox;
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx)
            * t33;
        const double t36 = pB_length_toy * t34 + pB_length_tox * t35 + B_length_by_q0
            * B_length_by_q0;
        const double pB_length_tox_by_q1 = t18 + t19;
        const double pB_length_toy_by_q1 = t16 + t17;
        const double pB_length_toz_by_q1 = t20 - t21;
        const double t37 = B_lengthdz * pB_length_toz_by_q1;
        const double t38 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1
            + t37;
        const double B_length_by_q1 = t38 * t33;
        const double t39 = pB_length_tox_by_q1 * t34 + pB_length_toy_by_q1 * -t35 - B_length_by_q0
            * B_length_by_q1;
        const double B_length_by_q0_2_by_q1 = t39 * t33;
        const double t40 = pB_length_toz_by_q1 * pB_length_toz_by_q1;
        const double t41 = pB_length_toy_by_q1 * pB_length_toy_by_q1;
        const double t42 = pB_length_tox_by_q1 * pB_length_tox_by_q1;
        const double pB_length_toy_by_q1_2_by_q1 = t10 - t8;
        const double t43 = pB_length_toz * B_lengthdz;
        const double pB_length_tox_by_q1_2_by_q1 = t6 - t4;
        const double t44 = t43 - B_lengthdx * pB_length_tox_by_q1_2_by_q1 - B_lengthdy
            * pB_length_toy_by_q1_2_by_q1;
        const double B_length_by_q1_2_by_q1 = (t44 + t42 + t41 + t40 - B_length_by_q1
            * B_length_by_q1) * t33;
        const double pC_length_toy = t32 + t8;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double pC_length_tox = t31 + t4;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double C_length = sinew_sqrt(t3 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t45 = 1.0 / C_length;
        const double t46 = pC_length_toy - C_lengthdy;
        const double t47 = C_lengthdx + pC_length_tox;
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx)
            * t45;
        const double t48 = pC_length_toy * t46 + pC_length_tox * t47 - C_length_by_q0
            * C_length_by_q0;
        const double t49 = t22 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy
            * pA_length_toy_by_q1;
        const double C_length_by_q1 = t49 * t45;
        const double t50 = pA_length_tox_by_q1 * -t46 + pA_length_toy_by_q1 * t47 - C_length_by_q0
            * C_length_by_q1;
        const double C_length_by_q0_2_by_q1 = t50 * t45;
        const double t51 = t28 + C_lengthdx * pA_length_tox_by_q1_2_by_q1 - C_lengthdy
            * pA_length_toy_by_q1_2_by_q1;
        const double C_length_by_q1_2_by_q1 = (t51 + t27 + t26 + t25 - C_length_by_q1
            * C_length_by_q1) * t45;
        const double pD_length_toy = t11 - t8;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double pD_length_tox = t7 - t4;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double D_length = sinew_sqrt(t30 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t52 = 1.0 / D_length;
        const double t53 = D_lengthdx - pD_length_tox;
        const double t54 = D_lengthdy + pD_length_toy;
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx)
            * t52;
        const double t55 = pD_length_tox * t53 - pD_length_toy * t54 + D_length_by_q0
            * D_length_by_q0;
        const double t56 = t37 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy
            * pB_length_toy_by_q1;
        const double D_length_by_q1 = t56 * t52;
        const double t57 = pB_length_toy_by_q1 * -t53 - pB_length_tox_by_q1 * t54 + D_length_by_q0
            * D_length_by_q1;
        const double D_length_by_q0_2_by_q1 = t57 * t52;
        const double t58 = t43 - D_lengthdx * pB_length_tox_by_q1_2_by_q1 + D_lengthdy
            * pB_length_toy_by_q1_2_by_q1;
        const double D_length_by_q1_2_by_q1 = (t58 + t42 + t41 + t40 - D_length_by_q1
            * D_length_by_q1) * t52;
        H[state] = t15 * t12;
        H[1 * n + state] = A_length_by_q0_2_by_q1;
        H[2 * n + state] = 0.0;
        H[3 * n + state] = 0.0;
        H[4 * n + state] = A_length_by_q0_2_by_q1;
        H[5 * n + state] = A_length_by_q1_2_by_q1;
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
        H[16 * n + state] = -(t36 * t33);
        H[17 * n + state] = B_length_by_q0_2_by_q1;
        H[18 * n + state] = 0.0;
        H[19 * n + state] = 0.0;
        H[20 * n + state] = B_length_by_q0_2_by_q1;
        H[21 * n + state] = B_length_by_q1_2_by_q1;
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
        H[32 * n + state] = t48 * t45;
        H[33 * n + state] = C_length_by_q0_2_by_q1;
        H[34 * n + state] = 0.0;
        H[35 * n + state] = 0.0;
        H[36 * n + state] = C_length_by_q0_2_by_q1;
        H[37 * n + state] = C_length_by_q1_2_by_q1;
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
        H[48 * n + state] = -(t55 * t52);
        H[49 * n + state] = D_length_by_q0_2_by_q1;
        H[50 * n + state] = 0.0;
        H[51 * n + state] = 0.0;
        H[52 * n + state] = D_length_by_q0_2_by_q1;
        H[53 * n + state] = D_length_by_q1_2_by_q1;
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

void thumb_link_position_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q_start, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double start_q10 = sinew_min(sinew_max(q_start[state], -1.5), 1.5);
        const double start_q11 = sinew_min(sinew_max(q_start[1 * n + state], -1.5), 1.5);
        double sin_q10, cos_q10;
        sinew_sincos(start_q10, &sin_q10, &cos_q10);
        double sin_q11, cos_q11;
        sinew_sincos(start_q11, &sin_q11, &cos_q11);
        const double t1 = 0.006 * cos_q10;
        const double t2 = 0.03 - t1;
        const double t3 = 0.005 * sin_q11;
        const double t4 = 0.047 * cos_q11;
        const double along_2 = t3 - t4;
        const double t5 = sin_q10 * along_2;
        const double gap_y_6 = t2 - t5;
        const double t6 = 0.005 * cos_q11;
        const double t7 = 0.047 * sin_q11;
        const double up_2 = t6 + t7;
        const double gap_z_2 = 0.025 - up_2;
        const double t8 = gap_z_2 * gap_z_2;
        const double t9 = 0.006 * sin_q10;
        const double t10 = 0.002 - t9;
        const double t11 = cos_q10 * along_2;
        const double gap_x_6 = t10 + t11;
        const double stretch_6 = sinew_sqrt(t8 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
        const double error_6 = h[3 * n + state] - stretch_6;
        const double along = t3 + t4;
        const double t12 = sin_q10 * along;
        const double gap_y_4 = t2 + t12;
        const double up = t6 - t7;
        const double gap_z = 0.025 - up;
        const double t13 = gap_z * gap_z;
        const double t14 = cos_q10 * along;
        const double gap_x_4 = t10 - t14;
        const double stretch_4 = sinew_sqrt(t13 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
        const double error_4 = h[2 * n + state] - stretch_4;
        const double t15 = 0.002 + t9;
        const double gap_x = t15 - t14;
        const double gap_y = t2 - t12;
        const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t13);
        const double error = h[state] - stretch;
        const double gap_x_2 = t15 + t11;
        const double gap_y_2 = t2 + t5;
        const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t8);
        const double error_2 = h[1 * n + state] - stretch_2;
        const double t16 = error * error + error_2 * error_2 + error_4 * error_4 + error_6
            * error_6;
        const double cost = 0.5 * t16;
        const double gap_y_2_by_q11 = sin_q10 * up_2;
        const double t17 = along_2 * gap_z_2;
        const double gap_x_2_by_q11 = cos_q10 * up_2;
        const double t18 = 1.0 / stretch_6;
        const double stretch_6_by_q11 = (t17 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
            * t18;
        const double gap_y_by_q11 = sin_q10 * up;
        const double t19 = along * gap_z;
        const double gap_x_by_q11 = cos_q10 * up;
        const double t20 = 1.0 / stretch_4;
        const double stretch_4_by_q11 = (t19 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11)
            * t20;
        const double t21 = 1.0 / stretch;
        const double stretch_by_q11 = (t19 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t21;
        const double t22 = 1.0 / stretch_2;
        const double stretch_2_by_q11 = (t17 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
            * t22;
        const double t23 = stretch_by_q11 * error + stretch_2_by_q11 * error_2 + stretch_4_by_q11
            * error_4;
        const double gradient_1 = t23 + stretch_6_by_q11 * error_6;
        const double stretch_6_by_q10 = (gap_x_6 * (t1 + t5) - gap_y_6 * (t9 - t11)) * t18;
        const double stretch_4_by_q10 = (gap_x_4 * (t1 - t12) - gap_y_4 * (t9 + t14)) * t20;
        const double stretch_by_q10 = (gap_x * (t1 + t12) + gap_y * (t9 - t14)) * t21;
        const double stretch_2_by_q10 = (gap_x_2 * (t1 - t5) + gap_y_2 * (t9 + t11)) * t22;
        const double t24 = stretch_by_q10 * stretch_by_q11 + stretch_2_by_q10 * stretch_2_by_q11
            - stretch_4_by_q10 * stretch_4_by_q11;
        const double H_01 = t24 - stretch_6_by_q10 * stretch_6_by_q11;
        const double t25 = stretch_by_q10 * error + stretch_2_by_q10 * error_2 - stretch_4_by_q10
            * error_4;
        const double gradient_0 = t25 - stretch_6_by_q10 * error_6;
        const double t26 = stretch_by_q11 * stretch_by_q11 + stretch_2_by_q11 * stretch_2_by_q11
            + stretch_4_by_q11 * stretch_4_by_q11;
        const double H_11 = t26 + stretch_6_by_q11 * stretch_6_by_q11;
        const double d = 1.0001 * H_11;
        const double t27 = stretch_by_q10 * stretch_by_q10 + stretch_2_by_q10 * stretch_2_by_q10
            + stretch_4_by_q10 * stretch_4_by_q10;
        const double H_00 = t27 + stretch_6_by_q10 * stretch_6_by_q10;
        const double a = 1.0001 * H_00;
        const double safe = sinew_max(a * d - H_01 * H_01, 1e-24 + 1e-09 * a * d);
        const double t28 = 1.0 / safe;
        const double step = sinew_min(sinew_max(-((H_01 * gradient_1 - gradient_0 * d) * t28),
            -0.5), 0.5);
        const double q10 = start_q10 + step;
        double sin_q10_2, cos_q10_2;
        sinew_sincos(q10, &sin_q10_2, &cos_q10_2);
        const double t29 = 0.006 * cos_q10_2;
        const double t30 = 0.03 - t29;
        const double step_2 = sinew_min(sinew_max(-((H_01 * gradient_0 - gradient_1 * a) * t28),
            -0.5), 0.5);
        const double q11 = start_q11 + step_2;
        double sin_q11_2, cos_q11_2;
        sinew_sincos(q11, &sin_q11_2, &cos_q11_2);
        const double t31 = 0.005 * sin_q11_2;
        const double t32 = 0.047 * cos_q11_2;
        const double along_10 = t31 - t32;
        const double t33 = sin_q10_2 * along_10;
        const double gap_y_14 = t30 - t33;
        const double t34 = 0.005 * cos_q11_2;
        const double t35 = 0.047 * sin_q11_2;
        const double up_10 = t34 + t35;
        const double gap_z_10 = 0.025 - up_10;
        const double t36 = gap_z_10 * gap_z_10;
        const double t37 = 0.006 * sin_q10_2;
        const double t38 = 0.002 - t37;
        const double t39 = cos_q10_2 * along_10;
        const double gap_x_14 = t38 + t39;
        const double stretch_14 = sinew_sqrt(t36 + gap_x_14 * gap_x_14 + gap_y_14 * gap_y_14);
        const double error_14 = h[3 * n + state] - stretch_14;
        const double along_8 = t31 + t32;
        const double t40 = sin_q10_2 * along_8;
        const double gap_y_12 = t30 + t40;
        const double up_8 = t34 - t35;
        const double gap_z_8 = 0.025 - up_8;
        const double t41 = gap_z_8 * gap_z_8;
        const double t42 = cos_q10_2 * along_8;
        const double gap_x_12 = t38 - t42;
        const double stretch_12 = sinew_sqrt(t41 + gap_x_12 * gap_x_12 + gap_y_12 * gap_y_12);
        const double error_12 = h[2 * n + state] - stretch_12;
        const double t43 = 0.002 + t37;
        const double gap_x_8 = t43 - t42;
        const double gap_y_8 = t30 - t40;
        const double stretch_8 = sinew_sqrt(gap_x_8 * gap_x_8 + gap_y_8 * gap_y_8 + t41);
        const double error_8 = h[state] - stretch_8;
        const double gap_x_10 = t43 + t39;
        const double gap_y_10 = t30 + t33;
        const double stretch_10 = sinew_sqrt(gap_x_10 * gap_x_10 + gap_y_10 * gap_y_10 + t36);
        const double error_10 = h[1 * n + state] - stretch_10;
        const double t44 = error_8 * error_8 + error_10 * error_10 + error_12 * error_12 + error_14
            * error_14;
        const double cost_2 = 0.5 * t44;
        const double better = cost - cost_2;
        const double kept_8 = sinew_choose(better, cost_2, cost);
        const double kept = sinew_choose(better, q10, start_q10);
        const double t45 = 1.0 / stretch_8;
        const double stretch_8_by_q10 = (gap_x_8 * (t29 + t40) + gap_y_8 * (t37 - t42)) * t45;
        const double t46 = 1.0 / stretch_10;
        const double stretch_10_by_q10 = (gap_x_10 * (t29 - t33) + gap_y_10 * (t37 + t39)) * t46;
        const double t47 = 1.0 / stretch_12;
        const double stretch_12_by_q10 = (gap_x_12 * (t29 - t40) - gap_y_12 * (t37 + t42)) * t47;
        const double t48 = stretch_8_by_q10 * error_8 + stretch_10_by_q10 * error_10
            - stretch_12_by_q10 * error_12;
        const double t49 = 1.0 / stretch_14;
        const double stretch_14_by_q10 = (gap_x_14 * (t29 + t33) - gap_y_14 * (t37 - t39)) * t49;
        const double kept_4 = sinew_choose(better, -(t48 - stretch_14_by_q10 * error_14),
            -gradient_0);
        const double gap_y_8_by_q11 = sin_q10_2 * up_8;
        const double t50 = along_8 * gap_z_8;
        const double gap_x_8_by_q11 = cos_q10_2 * up_8;
        const double stretch_8_by_q11 = (t50 - gap_x_8 * gap_x_8_by_q11 - gap_y_8 * gap_y_8_by_q11)
            * t45;
        const double gap_y_10_by_q11 = sin_q10_2 * up_10;
        const double t51 = along_10 * gap_z_10;
        const double gap_x_10_by_q11 = cos_q10_2 * up_10;
        const double stretch_10_by_q11 = (t51 + gap_x_10 * gap_x_10_by_q11 + gap_y_10
            * gap_y_10_by_q11) * t46;
        const double t52 = stretch_8_by_q11 * stretch_8_by_q11 + stretch_10_by_q11
            * stretch_10_by_q11;
        const double stretch_12_by_q11 = (t50 - gap_x_12 * gap_x_8_by_q11 + gap_y_12
            * gap_y_8_by_q11) * t47;
        const double stretch_14_by_q11 = (t51 + gap_x_14 * gap_x_10_by_q11 - gap_y_14
            * gap_y_10_by_q11) * t49;
        const double H_11_2 = t52 + stretch_12_by_q11 * stretch_12_by_q11 + stretch_14_by_q11
            * stretch_14_by_q11;
        const double kept_14 = sinew_choose(better, H_11_2, H_11);
        const double kept_16 = sinew_choose(better, 1e-05, 0.001);
        const double t53 = 1.0 + kept_16;
        const double d_2 = kept_14 * t53;
        const double t54 = stretch_8_by_q11 * error_8 + stretch_10_by_q11 * error_10
            + stretch_12_by_q11 * error_12;
        const double kept_6 = sinew_choose(better, -(t54 + stretch_14_by_q11 * error_14),
            -gradient_1);
        const double t55 = stretch_8_by_q10 * stretch_8_by_q11 + stretch_10_by_q10
            * stretch_10_by_q11;
        const double H_01_2 = t55 - stretch_12_by_q10 * stretch_12_by_q11 - stretch_14_by_q10
            * stretch_14_by_q11;
        const double kept_12 = sinew_choose(better, H_01_2, H_01);
        const double t56 = stretch_8_by_q10 * stretch_8_by_q10 + stretch_10_by_q10
            * stretch_10_by_q10;
        const double H_00_2 = t56 + stretch_12_by_q10 * stretch_12_by_q10 + stretch_14_by_q10
            * stretch_14_by_q10;
        const double kept_10 = sinew_choose(better, H_00_2, H_00);
        const double a_2 = kept_10 * t53;
        const double safe_2 = sinew_max(a_2 * d_2 - kept_12 * kept_12, 1e-24 + 1e-09 * a_2 * d_2);
        const double t57 = 1.0 / safe_2;
        const double step_4 = sinew_min(sinew_max(-((kept_4 * d_2 - kept_6 * kept_12) * t57), -0.5),
            0.5);
        const double q10_2 = kept + step_4;
        double sin_q10_4, cos_q10_4;
        sinew_sincos(q10_2, &sin_q10_4, &cos_q10_4);
        const double t58 = 0.006 * sin_q10_4;
        const double t59 = 0.002 + t58;
        const double kept_2 = sinew_choose(better, q11, start_q11);
        const double step_6 = sinew_min(sinew_max((kept_4 * kept_12 - kept_6 * a_2) * t57, -0.5),
            0.5);
        const double q11_2 = kept_2 + step_6;
        double sin_q11_4, cos_q11_4;
        sinew_sincos(q11_2, &sin_q11_4, &cos_q11_4);
        const double t60 = 0.005 * sin_q11_4;
        const double t61 = 0.047 * cos_q11_4;
        const double along_16 = t60 + t61;
        const double t62 = cos_q10_4 * along_16;
        const double gap_x_16 = t59 - t62;
        const double t63 = 0.006 * cos_q10_4;
        const double t64 = 0.03 - t63;
        const double t65 = sin_q10_4 * along_16;
        const double gap_y_16 = t64 - t65;
        const double t66 = 0.005 * cos_q11_4;
        const double t67 = 0.047 * sin_q11_4;
        const double up_16 = t66 - t67;
        const double gap_z_16 = 0.025 - up_16;
        const double t68 = gap_z_16 * gap_z_16;
        const double stretch_16 = sinew_sqrt(gap_x_16 * gap_x_16 + gap_y_16 * gap_y_16 + t68);
        const double error_16 = h[state] - stretch_16;
        const double along_18 = t60 - t61;
        const double t69 = cos_q10_4 * along_18;
        const double gap_x_18 = t59 + t69;
        const double t70 = sin_q10_4 * along_18;
        const double gap_y_18 = t64 + t70;
        const double up_18 = t66 + t67;
        const double gap_z_18 = 0.025 - up_18;
        const double t71 = gap_z_18 * gap_z_18;
        const double stretch_18 = sinew_sqrt(gap_x_18 * gap_x_18 + gap_y_18 * gap_y_18 + t71);
        const double error_18 = h[1 * n + state] - stretch_18;
        const double t72 = 0.002 - t58;
        const double gap_x_20 = t72 - t62;
        const double gap_y_20 = t64 + t65;
        const double stretch_20 = sinew_sqrt(t68 + gap_x_20 * gap_x_20 + gap_y_20 * gap_y_20);
        const double error_20 = h[2 * n + state] - stretch_20;
        const double gap_x_22 = t72 + t69;
        const double gap_y_22 = t64 - t70;
        const double stretch_22 = sinew_sqrt(t71 + gap_x_22 * gap_x_22 + gap_y_22 * gap_y_22);
        const double error_22 = h[3 * n + state] - stretch_22;
        const double t73 = error_16 * error_16 + error_18 * error_18 + error_20 * error_20
            + error_22 * error_22;
        const double cost_4 = 0.5 * t73;
        const double better_2 = kept_8 - cost_4;
        const double kept_26 = sinew_choose(better_2, cost_4, kept_8);
        const double kept_18 = sinew_choose(better_2, q10_2, kept);
        const double t74 = 1.0 / stretch_16;
        const double stretch_16_by_q10 = (gap_x_16 * (t63 + t65) + gap_y_16 * (t58 - t62)) * t74;
        const double t75 = 1.0 / stretch_18;
        const double stretch_18_by_q10 = (gap_x_18 * (t63 - t70) + gap_y_18 * (t58 + t69)) * t75;
        const double t76 = 1.0 / stretch_20;
        const double stretch_20_by_q10 = (gap_x_20 * (t63 - t65) - gap_y_20 * (t58 + t62)) * t76;
        const double t77 = stretch_16_by_q10 * error_16 + stretch_18_by_q10 * error_18
            - stretch_20_by_q10 * error_20;
        const double t78 = 1.0 / stretch_22;
        const double stretch_22_by_q10 = (gap_x_22 * (t63 + t70) - gap_y_22 * (t58 - t69)) * t78;
        const double kept_22 = sinew_choose(better_2, -(t77 - stretch_22_by_q10 * error_22),
            kept_4);
        const double t79 = along_16 * gap_z_16;
        const double gap_x_16_by_q11 = cos_q10_4 * up_16;
        const double gap_y_16_by_q11 = sin_q10_4 * up_16;
        const double stretch_16_by_q11 = (t79 - gap_x_16 * gap_x_16_by_q11 - gap_y_16
            * gap_y_16_by_q11) * t74;
        const double t80 = along_18 * gap_z_18;
        const double gap_x_18_by_q11 = cos_q10_4 * up_18;
        const double gap_y_18_by_q11 = sin_q10_4 * up_18;
        const double stretch_18_by_q11 = (t80 + gap_x_18 * gap_x_18_by_q11 + gap_y_18
            * gap_y_18_by_q11) * t75;
        const double t81 = stretch_16_by_q11 * stretch_16_by_q11 + stretch_18_by_q11
            * stretch_18_by_q11;
        const double stretch_20_by_q11 = (t79 - gap_x_20 * gap_x_16_by_q11 + gap_y_20
            * gap_y_16_by_q11) * t76;
        const double stretch_22_by_q11 = (t80 + gap_x_22 * gap_x_18_by_q11 - gap_y_22
            * gap_y_18_by_q11) * t78;
        const double H_11_4 = t81 + stretch_20_by_q11 * stretch_20_by_q11 + stretch_22_by_q11
            * stretch_22_by_q11;
        const double kept_32 = sinew_choose(better_2, H_11_4, kept_14);
        const double kept_34 = sinew_choose(better_2, 0.1 * kept_16, 10.0 * kept_16);
        const double t82 = 1.0 + kept_34;
        const double d_4 = kept_32 * t82;
        const double t83 = stretch_16_by_q11 * error_16 + stretch_18_by_q11 * error_18
            + stretch_20_by_q11 * error_20;
        const double kept_24 = sinew_choose(better_2, -(t83 + stretch_22_by_q11 * error_22),
            kept_6);
        const double t84 = stretch_16_by_q10 * stretch_16_by_q11 + stretch_18_by_q10
            * stretch_18_by_q11;
        const double H_01_4 = t84 - stretch_20_by_q10 * stretch_20_by_q11 - stretch_22_by_q10
            * stretch_22_by_q11;
        const double kept_30 = sinew_choose(better_2, H_01_4, kept_12);
        const double t85 = stretch_16_by_q10 * stretch_16_by_q10 + stretch_18_by_q10
            * stretch_18_by_q10;
        const double H_00_4 = t85 + stretch_20_by_q10 * stretch_20_by_q10 + stretch_22_by_q10
            * stretch_22_by_q10;
        const double kept_28 = sinew_choose(better_2, H_00_4, kept_10);
        const double a_4 = kept_28 * t82;
        const double safe_4 = sinew_max(a_4 * d_4 - kept_30 * kept_30, 1e-24 + 1e-09 * a_4 * d_4);
        const double t86 = 1.0 / safe_4;
        const double step_8 = sinew_min(sinew_max(-((kept_22 * d_4 - kept_24 * kept_30) * t86),
            -0.5), 0.5);
        const double q10_4 = kept_18 + step_8;
        double sin_q10_6, cos_q10_6;
        sinew_sincos(q10_4, &sin_q10_6, &cos_q10_6);
        const double t87 = 0.006 * sin_q10_6;
        const double t88 = 0.002 + t87;
        const double kept_20 = sinew_choose(better_2, q11_2, kept_2);
        const double step_10 = sinew_min(sinew_max((kept_22 * kept_30 - kept_24 * a_4) * t86, -0.5),
            0.5);
        const double q11_4 = kept_20 + step_10;
        double sin_q11_6, cos_q11_6;
        sinew_sincos(q11_4, &sin_q11_6, &cos_q11_6);
        const double t89 = 0.005 * sin_q11_6;
        const double t90 = 0.047 * cos_q11_6;
        const double along_24 = t89 + t90;
        const double t91 = cos_q10_6 * along_24;
        const double gap_x_24 = t88 - t91;
        const double t92 = 0.006 * cos_q10_6;
        const double t93 = 0.03 - t92;
        const double t94 = sin_q10_6 * along_24;
        const double gap_y_24 = t93 - t94;
        const double t95 = 0.005 * cos_q11_6;
        const double t96 = 0.047 * sin_q11_6;
        const double up_24 = t95 - t96;
        const double gap_z_24 = 0.025 - up_24;
        const double t97 = gap_z_24 * gap_z_24;
        const double stretch_24 = sinew_sqrt(gap_x_24 * gap_x_24 + gap_y_24 * gap_y_24 + t97);
        const double error_24 = h[state] - stretch_24;
        const double along_26 = t89 - t90;
        const double t98 = cos_q10_6 * along_26;
        const double gap_x_26 = t88 + t98;
        const double t99 = sin_q10_6 * along_26;
        const double gap_y_26 = t93 + t99;
        const double up_26 = t95 + t96;
        const double gap_z_26 = 0.025 - up_26;
        const double t100 = gap_z_26 * gap_z_26;
        const double stretch_26 = sinew_sqrt(gap_x_26 * gap_x_26 + gap_y_26 * gap_y_26 + t100);
        const double error_26 = h[1 * n + state] - stretch_26;
        const double t101 = 0.002 - t87;
        const double gap_x_28 = t101 - t91;
        const double gap_y_28 = t93 + t94;
        const double stretch_28 = sinew_sqrt(t97 + gap_x_28 * gap_x_28 + gap_y_28 * gap_y_28);
        const double error_28 = h[2 * n + state] - stretch_28;
        const double gap_x_30 = t101 + t98;
        const double gap_y_30 = t93 - t99;
        const double stretch_30 = sinew_sqrt(t100 + gap_x_30 * gap_x_30 + gap_y_30 * gap_y_30);
        const double error_30 = h[3 * n + state] - stretch_30;
        const double t102 = error_24 * error_24 + error_26 * error_26 + error_28 * error_28
            + error_30 * error_30;
        const double cost_6 = 0.5 * t102;
        const double better_4 = kept_26 - cost_6;
        const double kept_36 = sinew_choose(better_4, q10_4, kept_18);
        const double t103 = 1.0 / stretch_24;
        const double stretch_24_by_q10 = (gap_x_24 * (t92 + t94) + gap_y_24 * (t87 - t91)) * t103;
        const double t104 = 1.0 / stretch_26;
        const double stretch_26_by_q10 = (gap_x_26 * (t92 - t99) + gap_y_26 * (t87 + t98)) * t104;
        const double t105 = 1.0 / stretch_28;
        const double stretch_28_by_q10 = (gap_x_28 * (t92 - t94) - gap_y_28 * (t87 + t91)) * t105;
        const double t106 = stretch_24_by_q10 * error_24 + stretch_26_by_q10 * error_26
            - stretch_28_by_q10 * error_28;
        const double t107 = 1.0 / stretch_30;
        const double stretch_30_by_q10 = (gap_x_30 * (t92 + t99) - gap_y_30 * (t87 - t98)) * t107;
        const double kept_40 = sinew_choose(better_4, -(t106 - stretch_30_by_q10 * error_30),
            kept_22);
        const double t108 = along_24 * gap_z_24;
        const double gap_x_24_by_q11 = cos_q10_6 * up_24;
        const double gap_y_24_by_q11 = sin_q10_6 * up_24;
        const double stretch_24_by_q11 = (t108 - gap_x_24 * gap_x_24_by_q11 - gap_y_24
            * gap_y_24_by_q11) * t103;
        const double t109 = along_26 * gap_z_26;
        const double gap_x_26_by_q11 = cos_q10_6 * up_26;
        const double gap_y_26_by_q11 = sin_q10_6 * up_26;
        const double stretch_26_by_q11 = (t109 + gap_x_26 * gap_x_26_by_q11 + gap_y_26
            * gap_y_26_by_q11) * t104;
        const double t110 = stretch_24_by_q11 * stretch_24_by_q11 + stretch_26_by_q11
            * stretch_26_by_q11;
        const double stretch_28_by_q11 = (t108 - gap_x_28 * gap_x_24_by_q11 + gap_y_28
            * gap_y_24_by_q11) * t105;
        const double stretch_30_by_q11 = (t109 + gap_x_30 * gap_x_26_by_q11 - gap_y_30
            * gap_y_26_by_q11) * t107;
        const double H_11_6 = t110 + stretch_28_by_q11 * stretch_28_by_q11 + stretch_30_by_q11
            * stretch_30_by_q11;
        const double kept_50 = sinew_choose(better_4, H_11_6, kept_32);
        const double kept_52 = sinew_choose(better_4, 0.1 * kept_34, 10.0 * kept_34);
        const double t111 = 1.0 + kept_52;
        const double d_6 = kept_50 * t111;
        const double t112 = stretch_24_by_q11 * error_24 + stretch_26_by_q11 * error_26
            + stretch_28_by_q11 * error_28;
        const double kept_42 = sinew_choose(better_4, -(t112 + stretch_30_by_q11 * error_30),
            kept_24);
        const double t113 = stretch_24_by_q10 * stretch_24_by_q11 + stretch_26_by_q10
            * stretch_26_by_q11;
        const double H_01_6 = t113 - stretch_28_by_q10 * stretch_28_by_q11 - stretch_30_by_q10
            * stretch_30_by_q11;
        const double kept_48 = sinew_choose(better_4, H_01_6, kept_30);
        const double t114 = stretch_24_by_q10 * stretch_24_by_q10 + stretch_26_by_q10
            * stretch_26_by_q10;
        const double H_00_6 = t114 + stretch_28_by_q10 * stretch_28_by_q10 + stretch_30_by_q10
            * stretch_30_by_q10;
        const double kept_46 = sinew_choose(better_4, H_00_6, kept_28);
        const double a_6 = kept_46 * t111;
        const double safe_6 = sinew_max(a_6 * d_6 - kept_48 * kept_48, 1e-24 + 1e-09 * a_6 * d_6);
        const double t115 = 1.0 / safe_6;
        const double step_12 = sinew_min(sinew_max(-((kept_40 * d_6 - kept_42 * kept_48) * t115),
            -0.5), 0.5);
        const double q10_6 = kept_36 + step_12;
        double sin_q10_8, cos_q10_8;
        sinew_sincos(q10_6, &sin_q10_8, &cos_q10_8);
        const double t116 = 0.006 * sin_q10_8;
        const double t117 = 0.002 + t116;
        const double kept_38 = sinew_choose(better_4, q11_4, kept_20);
        const double step_14 = sinew_min(sinew_max((kept_40 * kept_48 - kept_42 * a_6) * t115,
            -0.5), 0.5);
        const double q11_6 = kept_38 + step_14;
        double sin_q11_8, cos_q11_8;
        sinew_sincos(q11_6, &sin_q11_8, &cos_q11_8);
        const double t118 = 0.005 * sin_q11_8;
        const double t119 = 0.047 * cos_q11_8;
        const double along_32 = t118 + t119;
        const double t120 = cos_q10_8 * along_32;
        const double gap_x_32 = t117 - t120;
        const double t121 = 0.006 * cos_q10_8;
        const double t122 = 0.03 - t121;
        const double t123 = sin_q10_8 * along_32;
        const double gap_y_32 = t122 - t123;
        const double t124 = 0.005 * cos_q11_8;
        const double t125 = 0.047 * sin_q11_8;
        const double up_32 = t124 - t125;
        const double gap_z_32 = 0.025 - up_32;
        const double t126 = gap_z_32 * gap_z_32;
        const double stretch_32 = sinew_sqrt(gap_x_32 * gap_x_32 + gap_y_32 * gap_y_32 + t126);
        const double error_32 = h[state] - stretch_32;
        const double along_34 = t118 - t119;
        const double t127 = cos_q10_8 * along_34;
        const double gap_x_34 = t117 + t127;
        const double t128 = sin_q10_8 * along_34;
        const double gap_y_34 = t122 + t128;
        const double up_34 = t124 + t125;
        const double gap_z_34 = 0.025 - up_34;
        const double t129 = gap_z_34 * gap_z_34;
        const double stretch_34 = sinew_sqrt(gap_x_34 * gap_x_34 + gap_y_34 * gap_y_34 + t129);
        const double error_34 = h[1 * n + state] - stretch_34;
        const double t130 = 0.002 - t116;
        const double gap_x_36 = t130 - t120;
        const double gap_y_36 = t122 + t123;
        const double stretch_36 = sinew_sqrt(t126 + gap_x_36 * gap_x_36 + gap_y_36 * gap_y_36);
        const double error_36 = h[2 * n + state] - stretch_36;
        const double gap_x_38 = t130 + t127;
        const double gap_y_38 = t122 - t128;
        const double stretch_38 = sinew_sqrt(t129 + gap_x_38 * gap_x_38 + gap_y_38 * gap_y_38);
        const double error_38 = h[3 * n + state] - stretch_38;
        const double t131 = error_32 * error_32 + error_34 * error_34 + error_36 * error_36
            + error_38 * error_38;
        const double better_6 = sinew_choose(better_4, cost_6, kept_26) - 0.5 * t131;
        const double t132 = 1.0 / stretch_32;
        const double stretch_32_by_q10 = (gap_x_32 * (t121 + t123) + gap_y_32 * (t116 - t120))
            * t132;
        const double t133 = 1.0 / stretch_34;
        const double stretch_34_by_q10 = (gap_x_34 * (t121 - t128) + gap_y_34 * (t116 + t127))
            * t133;
        const double t134 = 1.0 / stretch_36;
        const double stretch_36_by_q10 = (gap_x_36 * (t121 - t123) - gap_y_36 * (t116 + t120))
            * t134;
        const double t135 = stretch_32_by_q10 * error_32 + stretch_34_by_q10 * error_34
            - stretch_36_by_q10 * error_36;
        const double t136 = 1.0 / stretch_38;
        const double stretch_38_by_q10 = (gap_x_38 * (t121 + t128) - gap_y_38 * (t116 - t127))
            * t136;
        const double kept_58 = sinew_choose(better_6, -(t135 - stretch_38_by_q10 * error_38),
            kept_40);
        const double t137 = along_32 * gap_z_32;
        const double gap_x_32_by_q11 = cos_q10_8 * up_32;
        const double gap_y_32_by_q11 = sin_q10_8 * up_32;
        const double stretch_32_by_q11 = (t137 - gap_x_32 * gap_x_32_by_q11 - gap_y_32
            * gap_y_32_by_q11) * t132;
        const double t138 = along_34 * gap_z_34;
        const double gap_x_34_by_q11 = cos_q10_8 * up_34;
        const double gap_y_34_by_q11 = sin_q10_8 * up_34;
        const double stretch_34_by_q11 = (t138 + gap_x_34 * gap_x_34_by_q11 + gap_y_34
            * gap_y_34_by_q11) * t133;
        const double t139 = stretch_32_by_q11 * stretch_32_by_q11 + stretch_34_by_q11
            * stretch_34_by_q11;
        const double stretch_36_by_q11 = (t137 - gap_x_36 * gap_x_32_by_q11 + gap_y_36
            * gap_y_32_by_q11) * t134;
        const double stretch_38_by_q11 = (t138 + gap_x_38 * gap_x_34_by_q11 - gap_y_38
            * gap_y_34_by_q11) * t136;
        const double H_11_8 = t139 + stretch_36_by_q11 * stretch_36_by_q11 + stretch_38_by_q11
            * stretch_38_by_q11;
        const double kept_68 = sinew_choose(better_6, H_11_8, kept_50);
        const double t140 = stretch_32_by_q11 * error_32 + stretch_34_by_q11 * error_34
            + stretch_36_by_q11 * error_36;
        const double kept_60 = sinew_choose(better_6, -(t140 + stretch_38_by_q11 * error_38),
            kept_42);
        const double t141 = stretch_32_by_q10 * stretch_32_by_q11 + stretch_34_by_q10
            * stretch_34_by_q11;
        const double H_01_8 = t141 - stretch_36_by_q10 * stretch_36_by_q11 - stretch_38_by_q10
            * stretch_38_by_q11;
        const double kept_66 = sinew_choose(better_6, H_01_8, kept_48);
        const double t142 = stretch_32_by_q10 * stretch_32_by_q10 + stretch_34_by_q10
            * stretch_34_by_q10;
        const double H_00_8 = t142 + stretch_36_by_q10 * stretch_36_by_q10 + stretch_38_by_q10
            * stretch_38_by_q10;
        const double kept_64 = sinew_choose(better_6, H_00_8, kept_46);
        const double safe_8 = sinew_max(kept_64 * kept_68 - kept_66 * kept_66, 1e-24 + 1e-09
            * kept_64 * kept_68);
        const double t143 = 1.0 / safe_8;
        const double step_16 = sinew_min(sinew_max(-((kept_58 * kept_68 - kept_60 * kept_66)
            * t143), -0.5), 0.5);
        const double step_18 = sinew_min(sinew_max((kept_58 * kept_66 - kept_60 * kept_64) * t143,
            -0.5), 0.5);
        const double correction_2 = sinew_sqrt(step_16 * step_16 + step_18 * step_18);
        q[state] = sinew_choose(better_6, q10_6, kept_36);
        q[1 * n + state] = sinew_choose(better_6, q11_6, kept_38);
        correction[state] = correction_2;
        status[state] = (int)sinew_choose(1e-06 - correction_2, 0.0, 1.0);
    }
}

void thumb_link_position_warm_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q_start, double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double start_q10 = sinew_min(sinew_max(q_start[state], -1.5), 1.5);
        const double start_q11 = sinew_min(sinew_max(q_start[1 * n + state], -1.5), 1.5);
        double sin_q10, cos_q10;
        sinew_sincos(start_q10, &sin_q10, &cos_q10);
        double sin_q11, cos_q11;
        sinew_sincos(start_q11, &sin_q11, &cos_q11);
        const double t1 = 0.005 * sin_q11;
        const double t2 = 0.047 * cos_q11;
        const double along = t1 + t2;
        const double t3 = cos_q10 * along;
        const double t4 = 0.006 * sin_q10;
        const double t5 = 0.002 + t4;
        const double gap_x = t5 - t3;
        const double t6 = sin_q10 * along;
        const double t7 = 0.006 * cos_q10;
        const double t8 = 0.03 - t7;
        const double gap_y = t8 - t6;
        const double t9 = 0.005 * cos_q11;
        const double t10 = 0.047 * sin_q11;
        const double up = t9 - t10;
        const double gap_z = 0.025 - up;
        const double t11 = gap_z * gap_z;
        const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t11);
        const double t12 = 1.0 / stretch;
        const double gap_x_by_q11 = cos_q10 * up;
        const double t13 = along * gap_z;
        const double gap_y_by_q11 = sin_q10 * up;
        const double stretch_by_q11 = (t13 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t12;
        const double along_2 = t1 - t2;
        const double t14 = cos_q10 * along_2;
        const double gap_x_2 = t5 + t14;
        const double t15 = sin_q10 * along_2;
        const double gap_y_2 = t8 + t15;
        const double up_2 = t9 + t10;
        const double gap_z_2 = 0.025 - up_2;
        const double t16 = gap_z_2 * gap_z_2;
        const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t16);
        const double t17 = 1.0 / stretch_2;
        const double gap_x_2_by_q11 = cos_q10 * up_2;
        const double t18 = along_2 * gap_z_2;
        const double gap_y_2_by_q11 = sin_q10 * up_2;
        const double stretch_2_by_q11 = (t18 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
            * t17;
        const double t19 = 0.002 - t4;
        const double gap_x_4 = t19 - t3;
        const double gap_y_4 = t8 + t6;
        const double stretch_4 = sinew_sqrt(t11 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
        const double t20 = 1.0 / stretch_4;
        const double stretch_4_by_q11 = (t13 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11)
            * t20;
        const double t21 = stretch_by_q11 * stretch_by_q11 + stretch_2_by_q11 * stretch_2_by_q11
            + stretch_4_by_q11 * stretch_4_by_q11;
        const double gap_x_6 = t19 + t14;
        const double gap_y_6 = t8 - t15;
        const double stretch_6 = sinew_sqrt(t16 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
        const double t22 = 1.0 / stretch_6;
        const double stretch_6_by_q11 = (t18 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
            * t22;
        const double H_11 = t21 + stretch_6_by_q11 * stretch_6_by_q11;
        const double d = 1.0001 * H_11;
        const double stretch_by_q10 = (gap_x * (t7 + t6) + gap_y * (t4 - t3)) * t12;
        const double stretch_2_by_q10 = (gap_x_2 * (t7 - t15) + gap_y_2 * (t4 + t14)) * t17;
        const double stretch_4_by_q10 = (gap_x_4 * (t7 - t6) - gap_y_4 * (t4 + t3)) * t20;
        const double t23 = stretch_by_q10 * stretch_by_q10 + stretch_2_by_q10 * stretch_2_by_q10
            + stretch_4_by_q10 * stretch_4_by_q10;
        const double stretch_6_by_q10 = (gap_x_6 * (t7 + t15) - gap_y_6 * (t4 - t14)) * t22;
        const double H_00 = t23 + stretch_6_by_q10 * stretch_6_by_q10;
        const double a = 1.0001 * H_00;
        const double t24 = stretch_by_q10 * stretch_by_q11 + stretch_2_by_q10 * stretch_2_by_q11
            - stretch_4_by_q10 * stretch_4_by_q11;
        const double H_01 = t24 - stretch_6_by_q10 * stretch_6_by_q11;
        const double safe = sinew_max(a * d - H_01 * H_01, 1e-24 + 1e-09 * a * d);
        const double t25 = 1.0 / safe;
        const double error = h[state] - stretch;
        const double error_2 = h[1 * n + state] - stretch_2;
        const double error_4 = h[2 * n + state] - stretch_4;
        const double t26 = stretch_by_q11 * error + stretch_2_by_q11 * error_2 + stretch_4_by_q11
            * error_4;
        const double error_6 = h[3 * n + state] - stretch_6;
        const double gradient_1 = t26 + stretch_6_by_q11 * error_6;
        const double t27 = stretch_by_q10 * error + stretch_2_by_q10 * error_2 - stretch_4_by_q10
            * error_4;
        const double gradient_0 = t27 - stretch_6_by_q10 * error_6;
        const double step_2 = sinew_min(sinew_max(-((H_01 * gradient_0 - gradient_1 * a) * t25),
            -0.5), 0.5);
        const double q11 = start_q11 + step_2;
        double sin_q11_2, cos_q11_2;
        sinew_sincos(q11, &sin_q11_2, &cos_q11_2);
        const double t28 = 0.005 * sin_q11_2;
        const double t29 = 0.047 * cos_q11_2;
        const double along_8 = t28 + t29;
        const double step = sinew_min(sinew_max(-((H_01 * gradient_1 - gradient_0 * d) * t25),
            -0.5), 0.5);
        const double q10 = start_q10 + step;
        double sin_q10_2, cos_q10_2;
        sinew_sincos(q10, &sin_q10_2, &cos_q10_2);
        const double t30 = cos_q10_2 * along_8;
        const double t31 = 0.006 * sin_q10_2;
        const double t32 = 0.002 + t31;
        const double gap_x_8 = t32 - t30;
        const double t33 = sin_q10_2 * along_8;
        const double t34 = 0.006 * cos_q10_2;
        const double t35 = 0.03 - t34;
        const double gap_y_8 = t35 - t33;
        const double t36 = 0.005 * cos_q11_2;
        const double t37 = 0.047 * sin_q11_2;
        const double up_8 = t36 - t37;
        const double gap_z_8 = 0.025 - up_8;
        const double t38 = gap_z_8 * gap_z_8;
        const double stretch_8 = sinew_sqrt(gap_x_8 * gap_x_8 + gap_y_8 * gap_y_8 + t38);
        const double error_8 = h[state] - stretch_8;
        const double t39 = error * error + error_2 * error_2 + error_4 * error_4 + error_6
            * error_6;
        const double along_10 = t28 - t29;
        const double t40 = cos_q10_2 * along_10;
        const double gap_x_10 = t32 + t40;
        const double t41 = sin_q10_2 * along_10;
        const double gap_y_10 = t35 + t41;
        const double up_10 = t36 + t37;
        const double gap_z_10 = 0.025 - up_10;
        const double t42 = gap_z_10 * gap_z_10;
        const double stretch_10 = sinew_sqrt(gap_x_10 * gap_x_10 + gap_y_10 * gap_y_10 + t42);
        const double error_10 = h[1 * n + state] - stretch_10;
        const double t43 = 0.002 - t31;
        const double gap_x_12 = t43 - t30;
        const double gap_y_12 = t35 + t33;
        const double stretch_12 = sinew_sqrt(t38 + gap_x_12 * gap_x_12 + gap_y_12 * gap_y_12);
        const double error_12 = h[2 * n + state] - stretch_12;
        const double gap_x_14 = t43 + t40;
        const double gap_y_14 = t35 - t41;
        const double stretch_14 = sinew_sqrt(t42 + gap_x_14 * gap_x_14 + gap_y_14 * gap_y_14);
        const double error_14 = h[3 * n + state] - stretch_14;
        const double t44 = t39 - error_8 * error_8 - error_10 * error_10 - error_12 * error_12
            - error_14 * error_14;
        const double better = 0.5 * t44;
        const double t45 = 1.0 / stretch_8;
        const double stretch_8_by_q10 = (gap_x_8 * (t34 + t33) + gap_y_8 * (t31 - t30)) * t45;
        const double t46 = 1.0 / stretch_10;
        const double stretch_10_by_q10 = (gap_x_10 * (t34 - t41) + gap_y_10 * (t31 + t40)) * t46;
        const double t47 = 1.0 / stretch_12;
        const double stretch_12_by_q10 = (gap_x_12 * (t34 - t33) - gap_y_12 * (t31 + t30)) * t47;
        const double t48 = stretch_8_by_q10 * error_8 + stretch_10_by_q10 * error_10
            - stretch_12_by_q10 * error_12;
        const double t49 = 1.0 / stretch_14;
        const double stretch_14_by_q10 = (gap_x_14 * (t34 + t41) - gap_y_14 * (t31 - t40)) * t49;
        const double kept_4 = sinew_choose(better, -(t48 - stretch_14_by_q10 * error_14),
            -gradient_0);
        const double gap_x_8_by_q11 = cos_q10_2 * up_8;
        const double t50 = along_8 * gap_z_8;
        const double gap_y_8_by_q11 = sin_q10_2 * up_8;
        const double stretch_8_by_q11 = (t50 - gap_x_8 * gap_x_8_by_q11 - gap_y_8 * gap_y_8_by_q11)
            * t45;
        const double gap_x_10_by_q11 = cos_q10_2 * up_10;
        const double t51 = along_10 * gap_z_10;
        const double gap_y_10_by_q11 = sin_q10_2 * up_10;
        const double stretch_10_by_q11 = (t51 + gap_x_10 * gap_x_10_by_q11 + gap_y_10
            * gap_y_10_by_q11) * t46;
        const double t52 = stretch_8_by_q11 * stretch_8_by_q11 + stretch_10_by_q11
            * stretch_10_by_q11;
        const double stretch_12_by_q11 = (t50 - gap_x_12 * gap_x_8_by_q11 + gap_y_12
            * gap_y_8_by_q11) * t47;
        const double stretch_14_by_q11 = (t51 + gap_x_14 * gap_x_10_by_q11 - gap_y_14
            * gap_y_10_by_q11) * t49;
        const double H_11_2 = t52 + stretch_12_by_q11 * stretch_12_by_q11 + stretch_14_by_q11
            * stretch_14_by_q11;
        const double kept_14 = sinew_choose(better, H_11_2, H_11);
        const double t53 = stretch_8_by_q11 * error_8 + stretch_10_by_q11 * error_10
            + stretch_12_by_q11 * error_12;
        const double kept_6 = sinew_choose(better, -(t53 + stretch_14_by_q11 * error_14),
            -gradient_1);
        const double t54 = stretch_8_by_q10 * stretch_8_by_q11 + stretch_10_by_q10
            * stretch_10_by_q11;
        const double H_01_2 = t54 - stretch_12_by_q10 * stretch_12_by_q11 - stretch_14_by_q10
            * stretch_14_by_q11;
        const double kept_12 = sinew_choose(better, H_01_2, H_01);
        const double t55 = stretch_8_by_q10 * stretch_8_by_q10 + stretch_10_by_q10
            * stretch_10_by_q10;
        const double H_00_2 = t55 + stretch_12_by_q10 * stretch_12_by_q10 + stretch_14_by_q10
            * stretch_14_by_q10;
        const double kept_10 = sinew_choose(better, H_00_2, H_00);
        const double safe_2 = sinew_max(kept_10 * kept_14 - kept_12 * kept_12, 1e-24 + 1e-09
            * kept_10 * kept_14);
        const double t56 = 1.0 / safe_2;
        const double step_4 = sinew_min(sinew_max(-((kept_4 * kept_14 - kept_6 * kept_12) * t56),
            -0.5), 0.5);
        const double step_6 = sinew_min(sinew_max((kept_4 * kept_12 - kept_6 * kept_10) * t56,
            -0.5), 0.5);
        const double correction_2 = sinew_sqrt(step_4 * step_4 + step_6 * step_6);
        q[state] = sinew_choose(better, q10, start_q10);
        q[1 * n + state] = sinew_choose(better, q11, start_q11);
        correction[state] = correction_2;
        status[state] = (int)sinew_choose(1e-06 - correction_2, 0.0, 1.0);
    }
}

void thumb_link_position_gradient_step_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT search, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double step = sinew_min(sinew_max(-(search[2 * n + state] * search[4 * n + state]),
            -0.5), 0.5);
        const double start_q10 = sinew_min(sinew_max(search[state], -1.5), 1.5);
        const double q10 = start_q10 + step;
        const double step_2 = sinew_min(sinew_max(-(search[3 * n + state] * search[4 * n + state]),
            -0.5), 0.5);
        const double start_q11 = sinew_min(sinew_max(search[1 * n + state], -1.5), 1.5);
        const double q11 = start_q11 + step_2;
        double sin_q10, cos_q10;
        sinew_sincos(q10, &sin_q10, &cos_q10);
        double sin_q11, cos_q11;
        sinew_sincos(q11, &sin_q11, &cos_q11);
        const double t1 = 0.005 * sin_q11;
        const double t2 = 0.047 * cos_q11;
        const double along = t1 + t2;
        const double t3 = cos_q10 * along;
        const double t4 = 0.006 * sin_q10;
        const double t5 = 0.002 + t4;
        const double gap_x = t5 - t3;
        const double t6 = sin_q10 * along;
        const double t7 = 0.006 * cos_q10;
        const double t8 = 0.03 - t7;
        const double gap_y = t8 - t6;
        const double t9 = 0.005 * cos_q11;
        const double t10 = 0.047 * sin_q11;
        const double up = t9 - t10;
        const double gap_z = 0.025 - up;
        const double t11 = gap_z * gap_z;
        const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t11);
        const double error = h[state] - stretch;
        const double along_2 = t1 - t2;
        const double t12 = cos_q10 * along_2;
        const double gap_x_2 = t5 + t12;
        const double t13 = sin_q10 * along_2;
        const double gap_y_2 = t8 + t13;
        const double up_2 = t9 + t10;
        const double gap_z_2 = 0.025 - up_2;
        const double t14 = gap_z_2 * gap_z_2;
        const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t14);
        const double error_2 = h[1 * n + state] - stretch_2;
        const double t15 = 0.002 - t4;
        const double gap_x_4 = t15 - t3;
        const double gap_y_4 = t8 + t6;
        const double stretch_4 = sinew_sqrt(t11 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
        const double error_4 = h[2 * n + state] - stretch_4;
        const double gap_x_6 = t15 + t12;
        const double gap_y_6 = t8 - t13;
        const double stretch_6 = sinew_sqrt(t14 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
        const double error_6 = h[3 * n + state] - stretch_6;
        const double t16 = error * error + error_2 * error_2 + error_4 * error_4 + error_6
            * error_6;
        const double cost = 0.5 * t16;
        const double better = search[5 * n + state] - cost;
        const double t17 = 1.0 / stretch;
        const double stretch_by_q10 = (gap_x * (t7 + t6) + gap_y * (t4 - t3)) * t17;
        const double t18 = 1.0 / stretch_2;
        const double stretch_2_by_q10 = (gap_x_2 * (t7 - t13) + gap_y_2 * (t4 + t12)) * t18;
        const double t19 = 1.0 / stretch_4;
        const double stretch_4_by_q10 = (gap_x_4 * (t7 - t6) - gap_y_4 * (t4 + t3)) * t19;
        const double t20 = stretch_by_q10 * error + stretch_2_by_q10 * error_2 - stretch_4_by_q10
            * error_4;
        const double t21 = 1.0 / stretch_6;
        const double stretch_6_by_q10 = (gap_x_6 * (t7 + t13) - gap_y_6 * (t4 - t12)) * t21;
        const double kept_4 = sinew_choose(better, -(t20 - stretch_6_by_q10 * error_6), search[2 * n
            + state]);
        const double gap_x_by_q11 = cos_q10 * up;
        const double t22 = along * gap_z;
        const double gap_y_by_q11 = sin_q10 * up;
        const double stretch_by_q11 = (t22 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t17;
        const double gap_x_2_by_q11 = cos_q10 * up_2;
        const double t23 = along_2 * gap_z_2;
        const double gap_y_2_by_q11 = sin_q10 * up_2;
        const double stretch_2_by_q11 = (t23 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
            * t18;
        const double stretch_4_by_q11 = (t22 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11)
            * t19;
        const double t24 = stretch_by_q11 * error + stretch_2_by_q11 * error_2 + stretch_4_by_q11
            * error_4;
        const double stretch_6_by_q11 = (t23 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
            * t21;
        const double kept_6 = sinew_choose(better, -(t24 + stretch_6_by_q11 * error_6), search[3 * n
            + state]);
        const double kept_8 = sinew_choose(better, search[4 * n + state], 0.5 * search[4 * n
            + state]);
        const double kept_10 = sinew_choose(better, cost, search[5 * n + state]);
        next[state] = sinew_choose(better, q10, start_q10);
        next[1 * n + state] = sinew_choose(better, q11, start_q11);
        next[2 * n + state] = kept_4;
        next[3 * n + state] = kept_6;
        next[4 * n + state] = kept_8;
        next[5 * n + state] = kept_10;
    }
}

void thumb_link_position_status_batch(int count, const double *SINEW_RESTRICT h,
    const double *SINEW_RESTRICT q, double *SINEW_RESTRICT correction, int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double start_q10 = sinew_min(sinew_max(q[state], -1.5), 1.5);
        const double start_q11 = sinew_min(sinew_max(q[1 * n + state], -1.5), 1.5);
        double sin_q10, cos_q10;
        sinew_sincos(start_q10, &sin_q10, &cos_q10);
        double sin_q11, cos_q11;
        sinew_sincos(start_q11, &sin_q11, &cos_q11);
        const double t1 = 0.005 * sin_q11;
        const double t2 = 0.047 * cos_q11;
        const double along = t1 + t2;
        const double t3 = cos_q10 * along;
        const double t4 = 0.006 * sin_q10;
        const double t5 = 0.002 + t4;
        const double gap_x = t5 - t3;
        const double t6 = sin_q10 * along;
        const double t7 = 0.006 * cos_q10;
        const double t8 = 0.03 - t7;
        const double gap_y = t8 - t6;
        const double t9 = 0.005 * cos_q11;
        const double t10 = 0.047 * sin_q11;
        const double up = t9 - t10;
        const double gap_z = 0.025 - up;
        const double t11 = gap_z * gap_z;
        const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t11);
        const double t12 = 1.0 / stretch;
        const double gap_x_by_q11 = cos_q10 * up;
        const double t13 = along * gap_z;
        const double gap_y_by_q11 = sin_q10 * up;
        const double stretch_by_q11 = (t13 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t12;
        const double along_2 = t1 - t2;
        const double t14 = cos_q10 * along_2;
        const double gap_x_2 = t5 + t14;
        const double t15 = sin_q10 * along_2;
        const double gap_y_2 = t8 + t15;
        const double up_2 = t9 + t10;
        const double gap_z_2 = 0.025 - up_2;
        const double t16 = gap_z_2 * gap_z_2;
        const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t16);
        const double t17 = 1.0 / stretch_2;
        const double gap_x_2_by_q11 = cos_q10 * up_2;
        const double t18 = along_2 * gap_z_2;
        const double gap_y_2_by_q11 = sin_q10 * up_2;
        const double stretch_2_by_q11 = (t18 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
            * t17;
        const double t19 = 0.002 - t4;
        const double gap_x_4 = t19 - t3;
        const double gap_y_4 = t8 + t6;
        const double stretch_4 = sinew_sqrt(t11 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
        const double t20 = 1.0 / stretch_4;
        const double stretch_4_by_q11 = (t13 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11)
            * t20;
        const double t21 = stretch_by_q11 * stretch_by_q11 + stretch_2_by_q11 * stretch_2_by_q11
            + stretch_4_by_q11 * stretch_4_by_q11;
        const double gap_x_6 = t19 + t14;
        const double gap_y_6 = t8 - t15;
        const double stretch_6 = sinew_sqrt(t16 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
        const double t22 = 1.0 / stretch_6;
        const double stretch_6_by_q11 = (t18 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
            * t22;
        const double H_11 = t21 + stretch_6_by_q11 * stretch_6_by_q11;
        const double stretch_by_q10 = (gap_x * (t7 + t6) + gap_y * (t4 - t3)) * t12;
        const double stretch_2_by_q10 = (gap_x_2 * (t7 - t15) + gap_y_2 * (t4 + t14)) * t17;
        const double stretch_4_by_q10 = (gap_x_4 * (t7 - t6) - gap_y_4 * (t4 + t3)) * t20;
        const double t23 = stretch_by_q10 * stretch_by_q10 + stretch_2_by_q10 * stretch_2_by_q10
            + stretch_4_by_q10 * stretch_4_by_q10;
        const double stretch_6_by_q10 = (gap_x_6 * (t7 + t15) - gap_y_6 * (t4 - t14)) * t22;
        const double H_00 = t23 + stretch_6_by_q10 * stretch_6_by_q10;
        const double t24 = stretch_by_q10 * stretch_by_q11 + stretch_2_by_q10 * stretch_2_by_q11
            - stretch_4_by_q10 * stretch_4_by_q11;
        const double H_01 = t24 - stretch_6_by_q10 * stretch_6_by_q11;
        const double safe = sinew_max(H_00 * H_11 - H_01 * H_01, 1e-24 + 1e-09 * H_00 * H_11);
        const double t25 = 1.0 / safe;
        const double error = h[state] - stretch;
        const double error_2 = h[1 * n + state] - stretch_2;
        const double error_4 = h[2 * n + state] - stretch_4;
        const double t26 = stretch_by_q11 * error + stretch_2_by_q11 * error_2 + stretch_4_by_q11
            * error_4;
        const double error_6 = h[3 * n + state] - stretch_6;
        const double gradient_1 = t26 + stretch_6_by_q11 * error_6;
        const double t27 = stretch_by_q10 * error + stretch_2_by_q10 * error_2 - stretch_4_by_q10
            * error_4;
        const double gradient_0 = t27 - stretch_6_by_q10 * error_6;
        const double step = sinew_min(sinew_max(-((H_01 * gradient_1 - H_11 * gradient_0) * t25),
            -0.5), 0.5);
        const double step_2 = sinew_min(sinew_max((H_00 * gradient_1 - H_01 * gradient_0) * t25,
            -0.5), 0.5);
        const double correction_2 = sinew_sqrt(step * step + step_2 * step_2);
        correction[state] = correction_2;
        status[state] = (int)sinew_choose(1e-06 - correction_2, 0.0, 1.0);
    }
}

void thumb_link_position_covariance_batch(int count, const double *SINEW_RESTRICT q,
    const double *SINEW_RESTRICT sigma, double *SINEW_RESTRICT covariance,
    int *SINEW_RESTRICT status)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double sin_q11, cos_q11;
        sinew_sincos(q[1 * n + state], &sin_q11, &cos_q11);
        double sin_q10, cos_q10;
        sinew_sincos(q[state], &sin_q10, &cos_q10);
        const double t1 = 0.005 * sin_q11;
        const double t2 = 0.047 * cos_q11;
        const double along = t1 + t2;
        const double t3 = cos_q10 * along;
        const double t4 = 0.006 * sin_q10;
        const double t5 = 0.002 + t4;
        const double gap_x = t5 - t3;
        const double t6 = sin_q10 * along;
        const double t7 = 0.006 * cos_q10;
        const double t8 = 0.03 - t7;
        const double gap_y = t8 - t6;
        const double t9 = 0.005 * cos_q11;
        const double t10 = 0.047 * sin_q11;
        const double up = t9 - t10;
        const double gap_z = 0.025 - up;
        const double t11 = gap_z * gap_z;
        const double stretch = sinew_sqrt(gap_x * gap_x + gap_y * gap_y + t11);
        const double t12 = 1.0 / stretch;
        const double gap_x_by_q11 = cos_q10 * up;
        const double t13 = along * gap_z;
        const double gap_y_by_q11 = sin_q10 * up;
        const double stretch_by_q11 = (t13 - gap_x * gap_x_by_q11 - gap_y * gap_y_by_q11) * t12;
        const double along_2 = t1 - t2;
        const double t14 = cos_q10 * along_2;
        const double gap_x_2 = t5 + t14;
        const double t15 = sin_q10 * along_2;
        const double gap_y_2 = t8 + t15;
        const double up_2 = t9 + t10;
        const double gap_z_2 = 0.025 - up_2;
        const double t16 = gap_z_2 * gap_z_2;
        const double stretch_2 = sinew_sqrt(gap_x_2 * gap_x_2 + gap_y_2 * gap_y_2 + t16);
        const double t17 = 1.0 / stretch_2;
        const double gap_x_2_by_q11 = cos_q10 * up_2;
        const double t18 = along_2 * gap_z_2;
        const double gap_y_2_by_q11 = sin_q10 * up_2;
        const double stretch_2_by_q11 = (t18 + gap_x_2 * gap_x_2_by_q11 + gap_y_2 * gap_y_2_by_q11)
            * t17;
        const double t19 = 0.002 - t4;
        const double gap_x_4 = t19 - t3;
        const double gap_y_4 = t8 + t6;
        const double stretch_4 = sinew_sqrt(t11 + gap_x_4 * gap_x_4 + gap_y_4 * gap_y_4);
        const double t20 = 1.0 / stretch_4;
        const double stretch_4_by_q11 = (t13 - gap_x_4 * gap_x_by_q11 + gap_y_4 * gap_y_by_q11)
            * t20;
        const double t21 = stretch_by_q11 * stretch_by_q11 + stretch_2_by_q11 * stretch_2_by_q11
            + stretch_4_by_q11 * stretch_4_by_q11;
        const double gap_x_6 = t19 + t14;
        const double gap_y_6 = t8 - t15;
        const double stretch_6 = sinew_sqrt(t16 + gap_x_6 * gap_x_6 + gap_y_6 * gap_y_6);
        const double t22 = 1.0 / stretch_6;
        const double stretch_6_by_q11 = (t18 + gap_x_6 * gap_x_2_by_q11 - gap_y_6 * gap_y_2_by_q11)
            * t22;
        const double H_11 = t21 + stretch_6_by_q11 * stretch_6_by_q11;
        const double stretch_by_q10 = (gap_x * (t7 + t6) + gap_y * (t4 - t3)) * t12;
        const double stretch_2_by_q10 = (gap_x_2 * (t7 - t15) + gap_y_2 * (t4 + t14)) * t17;
        const double stretch_4_by_q10 = (gap_x_4 * (t7 - t6) - gap_y_4 * (t4 + t3)) * t20;
        const double t23 = stretch_by_q10 * stretch_by_q10 + stretch_2_by_q10 * stretch_2_by_q10
            + stretch_4_by_q10 * stretch_4_by_q10;
        const double stretch_6_by_q10 = (gap_x_6 * (t7 + t15) - gap_y_6 * (t4 - t14)) * t22;
        const double H_00 = t23 + stretch_6_by_q10 * stretch_6_by_q10;
        const double t24 = stretch_by_q10 * stretch_by_q11 + stretch_2_by_q10 * stretch_2_by_q11
            - stretch_4_by_q10 * stretch_4_by_q11;
        const double H_01 = t24 - stretch_6_by_q10 * stretch_6_by_q11;
        const double determinant = H_00 * H_11 - H_01 * H_01;
        const double determinant_floor = 1e-24 + 1e-09 * H_00 * H_11;
        const double deviation = sinew_min(sinew_max(sigma[state], 0.0), 1.0);
        const double scale = deviation * deviation / sinew_max(determinant, determinant_floor);
        const double t25 = -(H_01 * scale);
        covariance[state] = H_11 * scale;
        covariance[1 * n + state] = t25;
        covariance[2 * n + state] = t25;
        covariance[3 * n + state] = H_00 * scale;
        status[state] = (int)sinew_choose(determinant - determinant_floor, 0.0, 1.0);
    }
}

void thumb_hinge_position_batch(int count, const double *SINEW_RESTRICT h, double *SINEW_RESTRICT q)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = h[state] - h[1 * n + state];
        q[state] = 76.92307692307692 * t1;
        q[1 * n + state] = 90.90909090909092 * (t1 + h[2 * n + state] - h[3 * n + state]);
    }
}

void thumb_bending_angles_batch(int count, const double *SINEW_RESTRICT q,
    double *SINEW_RESTRICT angles)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double R21y = c1 * s2;
        const double t1 = 0.005 * R21y;
        const double t2 = 0.006 * s1;
        const double t3 = t1 - t2;
        const double R21x = c1 * c2;
        const double t4 = 0.047 * R21x;
        const double A_stretch_dx = 0.002 - t3 - t4;
        const double t5 = 0.025 - 0.005 * c2;
        const double t6 = 0.047 * s2;
        const double A_stretch_dz = t5 + t6;
        const double t7 = s2 * A_stretch_dz;
        const double R22y = s1 * s2;
        const double t8 = 0.005 * R22y;
        const double t9 = 0.006 * c1;
        const double t10 = 0.03 - (t8 + t9);
        const double R22x = s1 * c2;
        const double t11 = 0.047 * R22x;
        const double A_stretch_dy = t10 - t11;
        const double A_stretch_end_dx = t7 - R21x * A_stretch_dx - R22x * A_stretch_dy;
        const double t12 = c2 * A_stretch_dz;
        const double A_stretch_end_dz = t12 + R21y * A_stretch_dx + R22y * A_stretch_dy;
        const double A_stretch_end_asidey = 0.02 * A_stretch_end_dx - 0.045 * A_stretch_end_dz;
        const double A_stretch_end_dy = c1 * A_stretch_dy - s1 * A_stretch_dx;
        const double A_stretch_end_asidex = 0.02 * A_stretch_end_dy - 0.024 * A_stretch_end_dz;
        const double t13 = A_stretch_end_asidex * A_stretch_end_asidex + A_stretch_end_asidey
            * A_stretch_end_asidey;
        const double A_stretch_end_asidez = 0.024 * A_stretch_end_dx - 0.045 * A_stretch_end_dy;
        const double t14 = 0.02 * A_stretch_end_dz + 0.024 * A_stretch_end_dy + 0.045
            * A_stretch_end_dx;
        const double t15 = sinew_atan2(sinew_sqrt(t13 + A_stretch_end_asidez
            * A_stretch_end_asidez), t14);
        const double t16 = 0.024 * A_stretch_dz;
        const double A_stretch_start_asidex = 0.02 * A_stretch_dy - t16;
        const double t17 = 0.045 * A_stretch_dz;
        const double A_stretch_start_asidey = 0.02 * A_stretch_dx + t17;
        const double t18 = A_stretch_start_asidex * A_stretch_start_asidex + A_stretch_start_asidey
            * A_stretch_start_asidey;
        const double A_stretch_start_asidez = 0.024 * A_stretch_dx + 0.045 * A_stretch_dy;
        const double t19 = 0.02 * A_stretch_dz;
        const double t20 = sinew_atan2(sinew_sqrt(t18 + A_stretch_start_asidez
            * A_stretch_start_asidez), t19 + 0.024 * A_stretch_dy - 0.045 * A_stretch_dx);
        const double t21 = t1 + t2;
        const double B_stretch_dx = 0.002 + t21 - t4;
        const double B_stretch_dz = t5 - t6;
        const double t22 = s2 * B_stretch_dz;
        const double t23 = 0.03 + (t8 - t9);
        const double B_stretch_dy = t23 - t11;
        const double B_stretch_end_dx = t22 + R21x * B_stretch_dx + R22x * B_stretch_dy;
        const double t24 = c2 * B_stretch_dz;
        const double B_stretch_end_dz = t24 - R21y * B_stretch_dx - R22y * B_stretch_dy;
        const double B_stretch_end_asidey = 0.02 * B_stretch_end_dx + 0.045 * B_stretch_end_dz;
        const double B_stretch_end_dy = c1 * B_stretch_dy - s1 * B_stretch_dx;
        const double B_stretch_end_asidex = 0.02 * B_stretch_end_dy - 0.024 * B_stretch_end_dz;
        const double t25 = B_stretch_end_asidex * B_stretch_end_asidex + B_stretch_end_asidey
            * B_stretch_end_asidey;
        const double B_stretch_end_asidez = 0.024 * B_stretch_end_dx + 0.045 * B_stretch_end_dy;
        const double t26 = 0.02 * B_stretch_end_dz + 0.024 * B_stretch_end_dy - 0.045
            * B_stretch_end_dx;
        const double t27 = sinew_atan2(sinew_sqrt(t25 + B_stretch_end_asidez
            * B_stretch_end_asidez), t26);
        const double t28 = 0.024 * B_stretch_dz;
        const double B_stretch_start_asidex = 0.02 * B_stretch_dy - t28;
        const double t29 = 0.045 * B_stretch_dz;
        const double B_stretch_start_asidey = 0.02 * B_stretch_dx + t29;
        const double t30 = B_stretch_start_asidex * B_stretch_start_asidex + B_stretch_start_asidey
            * B_stretch_start_asidey;
        const double B_stretch_start_asidez = 0.024 * B_stretch_dx + 0.045 * B_stretch_dy;
        const double t31 = 0.02 * B_stretch_dz;
        const double t32 = sinew_atan2(sinew_sqrt(t30 + B_stretch_start_asidez
            * B_stretch_start_asidez), t31 + 0.024 * B_stretch_dy - 0.045 * B_stretch_dx);
        const double C_stretch_dx = 0.002 - t21 - t4;
        const double C_stretch_dy = t23 + t11;
        const double C_stretch_end_dx = t7 - R21x * C_stretch_dx + R22x * C_stretch_dy;
        const double C_stretch_end_dz = t12 + R21y * C_stretch_dx - R22y * C_stretch_dy;
        const double C_stretch_end_asidey = 0.02 * C_stretch_end_dx - 0.045 * C_stretch_end_dz;
        const double C_stretch_end_dy = c1 * C_stretch_dy + s1 * C_stretch_dx;
        const double C_stretch_end_asidex = 0.02 * C_stretch_end_dy - 0.024 * C_stretch_end_dz;
        const double t33 = C_stretch_end_asidex * C_stretch_end_asidex + C_stretch_end_asidey
            * C_stretch_end_asidey;
        const double C_stretch_end_asidez = 0.024 * C_stretch_end_dx - 0.045 * C_stretch_end_dy;
        const double t34 = 0.02 * C_stretch_end_dz + 0.024 * C_stretch_end_dy + 0.045
            * C_stretch_end_dx;
        const double t35 = sinew_atan2(sinew_sqrt(t33 + C_stretch_end_asidez
            * C_stretch_end_asidez), t34);
        const double C_stretch_start_asidex = 0.02 * C_stretch_dy - t16;
        const double C_stretch_start_asidey = 0.02 * C_stretch_dx + t17;
        const double t36 = C_stretch_start_asidex * C_stretch_start_asidex + C_stretch_start_asidey
            * C_stretch_start_asidey;
        const double C_stretch_start_asidez = 0.024 * C_stretch_dx + 0.045 * C_stretch_dy;
        const double t37 = sinew_atan2(sinew_sqrt(t36 + C_stretch_start_asidez
            * C_stretch_start_asidez), t19 + 0.024 * C_stretch_dy - 0.045 * C_stretch_dx);
        const double D_stretch_dx = 0.002 + t3 - t4;
        const double D_stretch_dy = t10 + t11;
        const double D_stretch_end_dx = t22 + R21x * D_stretch_dx - R22x * D_stretch_dy;
        const double D_stretch_end_dz = t24 - R21y * D_stretch_dx + R22y * D_stretch_dy;
        const double D_stretch_end_asidey = 0.02 * D_stretch_end_dx + 0.045 * D_stretch_end_dz;
        const double D_stretch_end_dy = c1 * D_stretch_dy + s1 * D_stretch_dx;
        const double D_stretch_end_asidex = 0.02 * D_stretch_end_dy - 0.024 * D_stretch_end_dz;
        const double t38 = D_stretch_end_asidex * D_stretch_end_asidex + D_stretch_end_asidey
            * D_stretch_end_asidey;
        const double D_stretch_end_asidez = 0.024 * D_stretch_end_dx + 0.045 * D_stretch_end_dy;
        const double t39 = 0.02 * D_stretch_end_dz + 0.024 * D_stretch_end_dy - 0.045
            * D_stretch_end_dx;
        const double t40 = sinew_atan2(sinew_sqrt(t38 + D_stretch_end_asidez
            * D_stretch_end_asidez), t39);
        const double D_stretch_start_asidex = 0.02 * D_stretch_dy - t28;
        const double D_stretch_start_asidey = 0.02 * D_stretch_dx + t29;
        const double t41 = D_stretch_start_asidex * D_stretch_start_asidex + D_stretch_start_asidey
            * D_stretch_start_asidey;
        const double D_stretch_start_asidez = 0.024 * D_stretch_dx + 0.045 * D_stretch_dy;
        const double t42 = sinew_atan2(sinew_sqrt(t41 + D_stretch_start_asidez
            * D_stretch_start_asidez), t31 + 0.024 * D_stretch_dy - 0.045 * D_stretch_dx);
        const double t43 = sinew_max(q[2 * n + state], -q[2 * n + state]);
        const double t44 = t43 + sinew_max(q[3 * n + state], -q[3 * n + state]);
        angles[state] = t20 + t15;
        angles[1 * n + state] = t32 + t27;
        angles[2 * n + state] = t37 + t35;
        angles[3 * n + state] = t42 + t40;
        angles[4 * n + state] = t43;
        angles[5 * n + state] = t43;
        angles[6 * n + state] = t44;
        angles[7 * n + state] = t44;
    }
}
