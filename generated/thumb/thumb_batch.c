/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The functions of the model thumb over many states: element k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/thumb
 * Model:   sha256 a1887dfbbeca57cfa47ae5f680c6749b28b13c33cd3d097b0d35ffdcc7f65850
 * Do not edit: change the model and generate again.
 */
#include "thumb_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void thumb_forward_kinematics_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT T)
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
        const double R41x = c1 * s4;
        const double l4x = 0.0298 * c3;
        const double l3x = 0.045 * c2;
        const double o4x = l3x + l4x;
        const double p4x = c1 * o4x;
        const double ptipx = p4x + 0.0201 * R41y;
        const double R42y = s1 * c4;
        const double R42x = s1 * s4;
        const double p4y = s1 * o4x;
        const double ptipy = p4y + 0.0201 * R42y;
        const double l4y = 0.0298 * s3;
        const double l3y = 0.045 * s2;
        const double o4y = l3y + l4y;
        const double ptipz = o4y + 0.0201 * s4;
        T[state] = R41y;
        T[1 * n + state] = -s1;
        T[2 * n + state] = -R41x;
        T[3 * n + state] = ptipx;
        T[4 * n + state] = R42y;
        T[5 * n + state] = c1;
        T[6 * n + state] = -R42x;
        T[7 * n + state] = ptipy;
        T[8 * n + state] = s4;
        T[9 * n + state] = 0.0;
        T[10 * n + state] = c4;
        T[11 * n + state] = ptipz;
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
        const double l4x = 0.0298 * c3;
        const double l3x = 0.045 * c2;
        const double o4x = l3x + l4x;
        const double p4y = s1 * o4x;
        const double ptipy = p4y + 0.0201 * s1 * c4;
        const double l4y = 0.0298 * s3;
        const double l3y = 0.045 * s2;
        const double o4y = l3y + l4y;
        const double ptipz = o4y + 0.0201 * s4;
        const double arm3_4 = l3y - ptipz;
        const double arm4_4 = o4y - ptipz;
        const double p4x = c1 * o4x;
        const double ptipx = p4x + 0.0201 * c1 * c4;
        const double p3x = c1 * l3x;
        const double arm3 = p3x - ptipx;
        const double p3y = s1 * l3x;
        const double arm3_2 = p3y - ptipy;
        const double arm4 = p4x - ptipx;
        const double arm4_2 = p4y - ptipy;
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
        J[10 * n + state] = -(c1 * arm3 + s1 * arm3_2);
        J[11 * n + state] = -(c1 * arm4 + s1 * arm4_2);
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
        const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t1 + t2 + 7.250099999999999e-07;
        const double j4y1 = 3.015e-05 * s4;
        const double j3y1 = 0.0001788 * s3;
        const double S3y = j3y1 + j4y1;
        const double l3y = 0.045 * s2;
        const double lS3 = t2 + l3y * S3y;
        const double l4y = 0.0298 * s3;
        const double lS4 = t1 + l4y * j4y1;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double Z2 = 2.4381e-05 + Z3 + (lS3 + lS3);
        const double M_4 = Z3 + lS3;
        const double M_2 = 4.3101e-07 + lS4;
        const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
        M[state] = Z1;
        M[1 * n + state] = 0.0;
        M[2 * n + state] = 0.0;
        M[3 * n + state] = 0.0;
        M[4 * n + state] = 0.0;
        M[5 * n + state] = Z2;
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

void thumb_coriolis_matrix_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT C)
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
        const double K4xx_by_q3 = c4 * (3.7701e-07 * (s4 * 2.0)) + o4x * j4y1;
        const double j3xx_by_q1 = s3 * (4.3862e-06 * (c3 * 2.0));
        const double l4y = 0.0298 * s3;
        const double l3y = 0.045 * s2;
        const double o4y = l3y + l4y;
        const double j4x1 = 3.015e-05 * c4;
        const double t1 = s2 * (2.4218999999999996e-05 * (c2 * 2.0)) + j3xx_by_q1 + K4xx_by_q3 + o4y * j4x1;
        const double j3y1 = 0.0001788 * s3;
        const double t2 = l3x * j3y1;
        const double j3x1 = 0.0001788 * c3;
        const double t3 = l4x * j4y1;
        const double t4 = l4y * j4x1;
        const double S3y = j3y1 + j4y1;
        const double t5 = l3x * S3y;
        const double S3x = j3x1 + j4x1;
        const double t6 = l3y * S3x;
        const double K2xx_by_q1 = t1 + t2 + l3y * j3x1 + t3 + t4 + t5 + t6;
        const double hq2 = 0.5 * qd[1 * n + state];
        const double K2xx_by_q2 = t4 * 2.0 + j3xx_by_q1 + K4xx_by_q3 + t2 + t3 + t5;
        const double hq3 = 0.5 * qd[2 * n + state];
        const double K3xx_by_q3 = K4xx_by_q3 + t3;
        const double t7 = l3x * j4y1;
        const double K2xx_by_q3 = K3xx_by_q3 + t7;
        const double hq4 = 0.5 * qd[3 * n + state];
        const double hq1 = 0.5 * qd[state];
        const double t8 = K2xx_by_q1 * hq1;
        const double t9 = K2xx_by_q2 * hq1;
        const double t10 = K2xx_by_q3 * hq1;
        const double lS4_by_q3 = t3 - t4;
        const double Z3_by_q3 = lS4_by_q3 + lS4_by_q3;
        const double lS3_2_by_q2 = t7 - l3y * j4x1;
        const double Z2_by_q3 = Z3_by_q3 + (lS3_2_by_q2 + lS3_2_by_q2);
        const double lS3_by_q2 = t5 - t6;
        const double t11 = lS3_by_q2 + lS3_by_q2;
        const double t12 = t11 * hq3;
        const double t13 = t11 * hq2;
        const double M_4_by_q3 = lS3_2_by_q2 + Z3_by_q3;
        const double G234 = M_4_by_q3 + lS3_2_by_q2;
        const double t14 = Z2_by_q3 * hq2;
        const double M_2_by_q3 = lS3_2_by_q2 + lS4_by_q3;
        const double G423 = M_4_by_q3 - lS3_2_by_q2;
        const double t15 = Z3_by_q3 * hq4;
        const double t16 = Z3_by_q3 * hq3;
        const double t17 = hq2 * G423;
        C[state] = -(K2xx_by_q1 * hq2 + K2xx_by_q2 * hq3 + K2xx_by_q3 * hq4);
        C[1 * n + state] = -t8;
        C[2 * n + state] = -t9;
        C[3 * n + state] = -t10;
        C[4 * n + state] = t8;
        C[5 * n + state] = -(t12 + Z2_by_q3 * hq4);
        C[6 * n + state] = -(t12 + t13 + hq4 * G234);
        C[7 * n + state] = -(t14 + hq3 * G234 + (hq4 + hq4) * M_2_by_q3);
        C[8 * n + state] = t9;
        C[9 * n + state] = -(hq4 * G423 - t13);
        C[10 * n + state] = -t15;
        C[11 * n + state] = -(t16 + t15 + t17);
        C[12 * n + state] = t10;
        C[13 * n + state] = t14 + hq3 * G423;
        C[14 * n + state] = t17 + t16;
        C[15 * n + state] = 0.0;
    }
}

void thumb_gravity_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT g)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double phi3 = q[1 * n + state] + q[2 * n + state];
        const double phi4 = q[3 * n + state] + phi3;
        double s1, c4;
        sinew_sincos(phi4, &s1, &c4);
        double s2, c3;
        sinew_sincos(phi3, &s2, &c3);
        double s3, c2;
        sinew_sincos(q[1 * n + state], &s3, &c2);
        const double n4 = 0.0002957715 * c4;
        const double n3 = n4 + 0.0017540280000000001 * c3;
        const double n2 = n3 + 0.005959575 * c2;
        g[state] = 0.0;
        g[1 * n + state] = n2;
        g[2 * n + state] = n3;
        g[3 * n + state] = n4;
    }
}

void thumb_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT h)
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
        const double K4yx = c4 * 3.7701e-07 * s4 + o4x * j4y1;
        const double j3y1 = 0.0001788 * s3;
        const double t1 = l3x * j3y1;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t2 = l4y * j4x1;
        const double K3yx = s3 * 4.3862e-06 * c3 + K4yx + t1 + t2;
        const double j3x1 = 0.0001788 * c3;
        const double S3x = j3x1 + j4x1;
        const double l3y = 0.045 * s2;
        const double K2yx = s2 * 2.4218999999999996e-05 * c2 + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state] * K4yx;
        const double w_2y = qd[state] + qd[state];
        const double Q2y = w_2y * R2yx;
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
        const double t2_2 = n2 + w1zz * K2yx;
        const double t3 = n3 + w1zz * K3yx;
        const double t4 = n4 + w1zz * K4yx;
        h[state] = -Q2y;
        h[1 * n + state] = t2_2;
        h[2 * n + state] = t3;
        h[3 * n + state] = t4;
    }
}

void thumb_mass_matrix_and_bias_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd, double *SINEW_RESTRICT M, double *SINEW_RESTRICT h)
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
        const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t1 + t2 + 7.250099999999999e-07;
        const double j4y1 = 3.015e-05 * s4;
        const double j3y1 = 0.0001788 * s3;
        const double S3y = j3y1 + j4y1;
        const double l3y = 0.045 * s2;
        const double lS3 = t2 + l3y * S3y;
        const double l4y = 0.0298 * s3;
        const double lS4 = t1 + l4y * j4y1;
        const double Z3 = 4.92521e-06 + (lS4 + lS4);
        const double Z2 = 2.4381e-05 + Z3 + (lS3 + lS3);
        const double M_4 = Z3 + lS3;
        const double M_2 = 4.3101e-07 + lS4;
        const double M_2_2 = M_2 + l3x * j4x1 + l3y * j4y1;
        const double j4xy = c4 * j4u;
        const double K4yx = j4xy + o4x * j4y1;
        const double j3xy = s3 * j3u;
        const double t3 = l3x * j3y1;
        const double t4 = l4y * j4x1;
        const double K3yx = j3xy + K4yx + t3 + t4;
        const double j2xy = s2 * j2u;
        const double K2yx = j2xy + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state] * K4yx;
        const double w_2y = qd[state] + qd[state];
        const double Q2y = w_2y * R2yx;
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
        const double t2_2 = n2 + K2yx * w1zz;
        const double t3_2 = n3 + K3yx * w1zz;
        const double t4_2 = n4 + K4yx * w1zz;
        M[state] = Z1;
        M[1 * n + state] = 0.0;
        M[2 * n + state] = 0.0;
        M[3 * n + state] = 0.0;
        M[4 * n + state] = 0.0;
        M[5 * n + state] = Z2;
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
        h[state] = -Q2y;
        h[1 * n + state] = t2_2;
        h[2 * n + state] = t3_2;
        h[3 * n + state] = t4_2;
    }
}

void thumb_forward_dynamics_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT tau, double *SINEW_RESTRICT qdd)
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
        const double j4xy = c4 * j4u;
        const double K4yx = j4xy + o4x * j4y1;
        const double j3u = 4.3862e-06 * c3;
        const double j3xy = s3 * j3u;
        const double j3y1 = 0.0001788 * s3;
        const double t1 = l3x * j3y1;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t2 = l4y * j4x1;
        const double K3yx = j3xy + K4yx + t1 + t2;
        const double j2u = 2.4218999999999996e-05 * c2;
        const double j2xy = s2 * j2u;
        const double j3x1 = 0.0001788 * c3;
        const double S3x = j3x1 + j4x1;
        const double l3y = 0.045 * s2;
        const double K2yx = j2xy + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state] * K4yx;
        const double w_2y = qd[state] + qd[state];
        const double Q2y = w_2y * R2yx;
        const double y1 = tau[state] + Q2y;
        const double t3 = l4x * j4x1;
        const double t4 = l3x * S3x;
        const double Z1 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + l3x * j3x1 + t3 + t4 + 7.250099999999999e-07;
        const double r1 = 1.0 / Z1;
        const double x1 = y1 * r1;
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
        const double S3y = j3y1 + j4y1;
        const double lS3 = t4 + l3y * S3y;
        const double M_4 = Z3 + lS3;
        const double M_2 = M + l3x * j4x1 + l3y * j4y1;
        const double A3_2 = M_4 - M_2 * L4_3;
        const double A3_3 = Z3 - M * L4_3;
        const double r3 = 1.0 / A3_3;
        const double L3_2 = A3_2 * r3;
        const double t5 = tau[1 * n + state] - n3 - 0.005959575 * c2 + w3zz * X2_3 + w4zz * X2_4 - K2yx * w1zz;
        const double L4_2 = 2320131.783485302 * M_2;
        const double b2_2 = t5 - y4 * L4_2 - b3 * L3_2;
        const double Z2 = 2.4381e-05 + Z3 + (lS3 + lS3);
        const double A2_2 = Z2 - M_2 * L4_2;
        const double A2_2_2 = A2_2 - A3_2 * L3_2;
        const double r2 = 1.0 / A2_2_2;
        const double x2 = b2_2 * r2;
        const double x3 = b3 * r3 - L3_2 * x2;
        const double x4 = 2320131.783485302 * y4 - L4_3 * x3 - L4_2 * x2;
        qdd[state] = x1;
        qdd[1 * n + state] = x2;
        qdd[2 * n + state] = x3;
        qdd[3 * n + state] = x4;
    }
}

void thumb_inverse_dynamics_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT qd, const double *SINEW_RESTRICT qdd, double *SINEW_RESTRICT tau)
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
        const double j4xy = c4 * j4u;
        const double K4yx = j4xy + o4x * j4y1;
        const double j3u = 4.3862e-06 * c3;
        const double j3xy = s3 * j3u;
        const double j3y1 = 0.0001788 * s3;
        const double t1 = l3x * j3y1;
        const double j4x1 = 3.015e-05 * c4;
        const double l4y = 0.0298 * s3;
        const double t2 = l4y * j4x1;
        const double K3yx = j3xy + K4yx + t1 + t2;
        const double j2u = 2.4218999999999996e-05 * c2;
        const double j2xy = s2 * j2u;
        const double j3x1 = 0.0001788 * c3;
        const double S3x = j3x1 + j4x1;
        const double l3y = 0.045 * s2;
        const double K2yx = j2xy + K3yx + l3y * S3x;
        const double R2yx = qd[1 * n + state] * K2yx + qd[2 * n + state] * K3yx + qd[3 * n + state] * K4yx;
        const double w_2y = qd[state] + qd[state];
        const double t3 = l3x * j3x1;
        const double t4 = l4x * j4x1;
        const double t5 = c2 * j2u + c3 * j3u - s4 * j4u + o4x * j4x1 + t3 + t4 + l3x * S3x + 7.2501e-07;
        const double N1z = qdd[state] * t5 - w_2y * R2yx;
        const double D2_4 = l3x * j4x1 + l3y * j4y1;
        const double al3z = qdd[1 * n + state] + qdd[2 * n + state];
        const double al4z = qdd[3 * n + state] + al3z;
        const double lS4 = t4 + l4y * j4y1;
        const double X2_4 = l3x * j4y1 - l3y * j4x1;
        const double w2zz = qd[1 * n + state] * qd[1 * n + state];
        const double t6 = 4.3101e-07 * al4z + 9.81 * j4x1 + qdd[1 * n + state] * D2_4 + lS4 * al3z + w2zz * X2_4;
        const double X3_4 = l4x * j4y1 - t2;
        const double w3z = qd[1 * n + state] + qd[2 * n + state];
        const double w3zz = w3z * w3z;
        const double n4 = t6 + w3zz * X3_4;
        const double D2_3 = t3 + l3y * j3y1;
        const double t7 = n4 + 4.4942e-06 * al3z + 9.81 * j3x1 + qdd[1 * n + state] * D2_3 + lS4 * al4z;
        const double X2_3 = t1 - l3y * j3x1;
        const double w4z = qd[3 * n + state] + w3z;
        const double w4zz = w4z * w4z;
        const double n3 = t7 + w2zz * X2_3 - w4zz * X3_4;
        const double t8 = n3 + 2.4381e-05 * qdd[1 * n + state] + 0.005959575 * c2 + al3z * D2_3 - w3zz * X2_3;
        const double n2 = t8 + al4z * D2_4 - w4zz * X2_4;
        const double w1zz = qd[state] * qd[state];
        const double t2_2 = n2 + w1zz * K2yx;
        const double t3_2 = n3 + w1zz * K3yx;
        const double t4_2 = n4 + w1zz * K4yx;
        tau[state] = N1z;
        tau[1 * n + state] = t2_2;
        tau[2 * n + state] = t3_2;
        tau[3 * n + state] = t4_2;
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
        const double R21y = c1 * s2;
        const double t1 = 0.005 * R21y;
        const double t2 = 0.006 * s1;
        const double t3 = t1 - t2;
        const double R21x = c1 * c2;
        const double t4 = 0.047 * R21x;
        const double A_lengthdx = 0.002 - t3 - t4;
        const double R22y = s1 * s2;
        const double t5 = 0.005 * R22y;
        const double t6 = 0.006 * c1;
        const double t7 = 0.03 - (t5 + t6);
        const double R22x = s1 * c2;
        const double t8 = 0.047 * R22x;
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

void thumb_coupling_matrix_batch(int count, const double *SINEW_RESTRICT q, double *SINEW_RESTRICT P)
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
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t12;
        const double t13 = 0.005 * s2;
        const double t14 = 0.047 * c2;
        const double pA_length_toz_by_q1 = t13 + t14;
        const double t15 = A_lengthdz * pA_length_toz_by_q1;
        const double t16 = 0.005 * R21x;
        const double t17 = 0.047 * R21y;
        const double pA_length_tox_by_q1 = t16 - t17;
        const double t18 = 0.005 * R22x;
        const double t19 = 0.047 * R22y;
        const double pA_length_toy_by_q1 = t18 - t19;
        const double t20 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t15;
        const double A_length_by_q1 = t20 * t12;
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
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t24;
        const double pB_length_toz_by_q1 = t13 - t14;
        const double t25 = B_lengthdz * pB_length_toz_by_q1;
        const double pB_length_tox_by_q1 = t16 + t17;
        const double pB_length_toy_by_q1 = t18 + t19;
        const double t26 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t25;
        const double B_length_by_q1 = t26 * t24;
        const double pC_length_tox = t21 + t1;
        const double pC_length_toy = t22 + t5;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double C_length = sinew_sqrt(t11 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t27 = 1.0 / C_length;
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t27;
        const double t28 = t15 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
        const double C_length_by_q1 = t28 * t27;
        const double pD_length_tox = t4 - t1;
        const double pD_length_toy = t8 - t5;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double D_length = sinew_sqrt(t23 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t29 = 1.0 / D_length;
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t29;
        const double t30 = t25 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
        const double D_length_by_q1 = t30 * t29;
        P[state] = -A_length_by_q0;
        P[1 * n + state] = -A_length_by_q1;
        P[2 * n + state] = 0.0;
        P[3 * n + state] = 0.0;
        P[4 * n + state] = B_length_by_q0;
        P[5 * n + state] = B_length_by_q1;
        P[6 * n + state] = 0.0;
        P[7 * n + state] = 0.0;
        P[8 * n + state] = C_length_by_q0;
        P[9 * n + state] = C_length_by_q1;
        P[10 * n + state] = 0.0;
        P[11 * n + state] = 0.0;
        P[12 * n + state] = -D_length_by_q0;
        P[13 * n + state] = D_length_by_q1;
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

void thumb_joint_torque_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT f, double *SINEW_RESTRICT tau)
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
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t12;
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
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t16;
        const double pA_length_tox = t4 + t1;
        const double pA_length_toy = t8 + t5;
        const double A_lengthdy = 0.03 - pA_length_toy;
        const double A_lengthdx = 0.002 - pA_length_tox;
        const double A_length = sinew_sqrt(A_lengthdx * A_lengthdx + A_lengthdy * A_lengthdy + t15);
        const double t17 = 1.0 / A_length;
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t17;
        const double pB_length_tox = t13 - t1;
        const double pB_length_toy = t14 - t5;
        const double B_lengthdy = 0.03 + pB_length_toy;
        const double B_lengthdx = 0.002 + pB_length_tox;
        const double B_length = sinew_sqrt(B_lengthdx * B_lengthdx + B_lengthdy * B_lengthdy + t11);
        const double t18 = 1.0 / B_length;
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t18;
        const double t19 = f[state] * A_length_by_q0 - f[1 * n + state] * B_length_by_q0 - f[2 * n + state] * C_length_by_q0;
        const double t20 = 0.005 * R22x;
        const double t21 = 0.047 * R22y;
        const double pB_length_toy_by_q1 = t20 + t21;
        const double t22 = 0.005 * s2;
        const double t23 = 0.047 * c2;
        const double pB_length_toz_by_q1 = t22 - t23;
        const double t24 = B_lengthdz * pB_length_toz_by_q1;
        const double t25 = 0.005 * R21x;
        const double t26 = 0.047 * R21y;
        const double pB_length_tox_by_q1 = t25 + t26;
        const double t27 = t24 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
        const double D_length_by_q1 = t27 * t12;
        const double pA_length_toy_by_q1 = t20 - t21;
        const double pA_length_toz_by_q1 = t22 + t23;
        const double t28 = A_lengthdz * pA_length_toz_by_q1;
        const double pA_length_tox_by_q1 = t25 - t26;
        const double t29 = t28 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
        const double C_length_by_q1 = t29 * t16;
        const double t30 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t28;
        const double A_length_by_q1 = t30 * t17;
        const double t31 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t24;
        const double B_length_by_q1 = t31 * t18;
        const double t32 = f[state] * A_length_by_q1 - f[1 * n + state] * B_length_by_q1 - f[2 * n + state] * C_length_by_q1;
        const double t33 = f[4 * n + state] - f[5 * n + state] - f[6 * n + state] + f[7 * n + state];
        tau[state] = t19 + f[3 * n + state] * D_length_by_q0;
        tau[1 * n + state] = t32 - f[3 * n + state] * D_length_by_q1;
        tau[2 * n + state] = -(0.0065 * t33);
        tau[3 * n + state] = -(0.0055 * (f[6 * n + state] - f[7 * n + state]));
    }
}

void thumb_joint_stiffness_batch(int count, const double *SINEW_RESTRICT q, const double *SINEW_RESTRICT f, const double *SINEW_RESTRICT kt, double *SINEW_RESTRICT K)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c1;
        sinew_sincos(q[state], &s1, &c1);
        double s2, c2;
        sinew_sincos(q[1 * n + state], &s2, &c2);
        const double K4_4 = 3.0249999999999997e-05 * (kt[6 * n + state] + kt[7 * n + state]);
        const double w7_3 = 0.0065 * kt[6 * n + state];
        const double w8_3 = 0.0065 * kt[7 * n + state];
        const double t1 = w7_3 + w8_3;
        const double K3_4 = 0.0055 * t1;
        const double t2 = -K3_4;
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
        const double t22 = A_lengthdx * pA_length_tox_by_q1 + A_lengthdy * pA_length_toy_by_q1 - t21;
        const double A_length_by_q1 = t22 * t14;
        const double pA_length_tox_by_q1_2_by_q1 = t3 + t6;
        const double t23 = pA_length_toz * A_lengthdz;
        const double pA_length_toy_by_q1_2_by_q1 = t7 + t10;
        const double t24 = t23 + A_lengthdx * pA_length_tox_by_q1_2_by_q1 + A_lengthdy * pA_length_toy_by_q1_2_by_q1;
        const double t25 = pA_length_tox_by_q1 * pA_length_tox_by_q1;
        const double t26 = pA_length_toy_by_q1 * pA_length_toy_by_q1;
        const double t27 = pA_length_toz_by_q1 * pA_length_toz_by_q1;
        const double A_length_by_q1_2_by_q1 = (t24 + t25 + t26 + t27 - A_length_by_q1 * A_length_by_q1) * t14;
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
        const double t33 = B_lengthdx * pB_length_tox_by_q1 + B_lengthdy * pB_length_toy_by_q1 + t32;
        const double B_length_by_q1 = t33 * t31;
        const double pB_length_tox_by_q1_2_by_q1 = t3 - t6;
        const double t34 = pB_length_toz * B_lengthdz;
        const double pB_length_toy_by_q1_2_by_q1 = t7 - t10;
        const double t35 = t34 - B_lengthdx * pB_length_tox_by_q1_2_by_q1 - B_lengthdy * pB_length_toy_by_q1_2_by_q1;
        const double t36 = pB_length_tox_by_q1 * pB_length_tox_by_q1;
        const double t37 = pB_length_toy_by_q1 * pB_length_toy_by_q1;
        const double t38 = pB_length_toz_by_q1 * pB_length_toz_by_q1;
        const double B_length_by_q1_2_by_q1 = (t35 + t36 + t37 + t38 - B_length_by_q1 * B_length_by_q1) * t31;
        const double t39 = f[state] * A_length_by_q1_2_by_q1 + f[1 * n + state] * B_length_by_q1_2_by_q1;
        const double pC_length_tox = t28 + t6;
        const double C_lengthdx = 0.002 - pC_length_tox;
        const double pC_length_toy = t29 + t10;
        const double C_lengthdy = 0.03 + pC_length_toy;
        const double C_length = sinew_sqrt(t13 + C_lengthdx * C_lengthdx + C_lengthdy * C_lengthdy);
        const double t40 = 1.0 / C_length;
        const double t41 = t21 - C_lengthdx * pA_length_tox_by_q1 + C_lengthdy * pA_length_toy_by_q1;
        const double C_length_by_q1 = t41 * t40;
        const double t42 = t23 + C_lengthdx * pA_length_tox_by_q1_2_by_q1 - C_lengthdy * pA_length_toy_by_q1_2_by_q1;
        const double C_length_by_q1_2_by_q1 = (t42 + t25 + t26 + t27 - C_length_by_q1 * C_length_by_q1) * t40;
        const double pD_length_tox = t5 - t6;
        const double D_lengthdx = 0.002 + pD_length_tox;
        const double pD_length_toy = t9 - t10;
        const double D_lengthdy = 0.03 - pD_length_toy;
        const double D_length = sinew_sqrt(t30 + D_lengthdx * D_lengthdx + D_lengthdy * D_lengthdy);
        const double t43 = 1.0 / D_length;
        const double t44 = t32 + D_lengthdx * pB_length_tox_by_q1 - D_lengthdy * pB_length_toy_by_q1;
        const double D_length_by_q1 = t44 * t43;
        const double t45 = t34 - D_lengthdx * pB_length_tox_by_q1_2_by_q1 + D_lengthdy * pB_length_toy_by_q1_2_by_q1;
        const double D_length_by_q1_2_by_q1 = (t45 + t36 + t37 + t38 - D_length_by_q1 * D_length_by_q1) * t43;
        const double t46 = t39 + f[2 * n + state] * C_length_by_q1_2_by_q1 + f[3 * n + state] * D_length_by_q1_2_by_q1;
        const double w1_2 = kt[state] * A_length_by_q1;
        const double w2_2 = kt[1 * n + state] * B_length_by_q1;
        const double w3_2 = kt[2 * n + state] * C_length_by_q1;
        const double t47 = t46 + A_length_by_q1 * w1_2 + B_length_by_q1 * w2_2 + C_length_by_q1 * w3_2;
        const double w4_2 = kt[3 * n + state] * D_length_by_q1;
        const double K2_2 = t47 + D_length_by_q1 * w4_2;
        const double B_length_by_q0 = (pB_length_tox * B_lengthdy - pB_length_toy * B_lengthdx) * t31;
        const double t48 = B_lengthdx - pB_length_tox;
        const double t49 = B_lengthdy - pB_length_toy;
        const double t50 = pB_length_tox_by_q1 * t49 + pB_length_toy_by_q1 * -t48 - B_length_by_q0 * B_length_by_q1;
        const double B_length_by_q0_2_by_q1 = t50 * t31;
        const double A_length_by_q0 = (pA_length_tox * A_lengthdy - pA_length_toy * A_lengthdx) * t14;
        const double t51 = A_lengthdx + pA_length_tox;
        const double t52 = A_lengthdy + pA_length_toy;
        const double t53 = pA_length_toy_by_q1 * t51 - pA_length_tox_by_q1 * t52 - A_length_by_q0 * A_length_by_q1;
        const double A_length_by_q0_2_by_q1 = t53 * t14;
        const double t54 = f[state] * A_length_by_q0_2_by_q1 + f[1 * n + state] * B_length_by_q0_2_by_q1;
        const double C_length_by_q0 = (pC_length_tox * C_lengthdy + pC_length_toy * C_lengthdx) * t40;
        const double t55 = pC_length_toy - C_lengthdy;
        const double t56 = C_lengthdx + pC_length_tox;
        const double t57 = pA_length_tox_by_q1 * -t55 + pA_length_toy_by_q1 * t56 - C_length_by_q0 * C_length_by_q1;
        const double C_length_by_q0_2_by_q1 = t57 * t40;
        const double D_length_by_q0 = (pD_length_tox * D_lengthdy + pD_length_toy * D_lengthdx) * t43;
        const double t58 = D_lengthdx - pD_length_tox;
        const double t59 = D_lengthdy + pD_length_toy;
        const double t60 = pB_length_toy_by_q1 * -t58 - pB_length_tox_by_q1 * t59 + D_length_by_q0 * D_length_by_q1;
        const double D_length_by_q0_2_by_q1 = t60 * t43;
        const double t61 = t54 + f[2 * n + state] * C_length_by_q0_2_by_q1 + f[3 * n + state] * D_length_by_q0_2_by_q1;
        const double w1_1 = kt[state] * A_length_by_q0;
        const double w2_1 = kt[1 * n + state] * B_length_by_q0;
        const double w3_1 = kt[2 * n + state] * C_length_by_q0;
        const double t62 = t61 + A_length_by_q1 * w1_1 + B_length_by_q1 * w2_1 + C_length_by_q1 * w3_1;
        const double w4_1 = kt[3 * n + state] * D_length_by_q0;
        const double K1_2 = t62 - D_length_by_q1 * w4_1;
        const double t63 = pA_length_toy * t52 + pA_length_tox * t51 - A_length_by_q0 * A_length_by_q0;
        const double A_length_by_q0_2_by_q0 = t63 * t14;
        const double t64 = pB_length_toy * t49 + pB_length_tox * t48 + B_length_by_q0 * B_length_by_q0;
        const double B_length_by_q0_2_by_q0 = t64 * t31;
        const double t65 = f[state] * A_length_by_q0_2_by_q0 - f[1 * n + state] * B_length_by_q0_2_by_q0;
        const double t66 = pC_length_toy * t55 + pC_length_tox * t56 - C_length_by_q0 * C_length_by_q0;
        const double C_length_by_q0_2_by_q0 = t66 * t40;
        const double t67 = pD_length_tox * t58 - pD_length_toy * t59 + D_length_by_q0 * D_length_by_q0;
        const double D_length_by_q0_2_by_q0 = t67 * t43;
        const double t68 = t65 + f[2 * n + state] * C_length_by_q0_2_by_q0 - f[3 * n + state] * D_length_by_q0_2_by_q0;
        const double t69 = t68 + A_length_by_q0 * w1_1 + B_length_by_q0 * w2_1 + C_length_by_q0 * w3_1;
        const double K1_1 = t69 + D_length_by_q0 * w4_1;
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
