/* SPDX-License-Identifier: BSD-2-Clause
 *
 * loop <unit> [--without-model]: the finger follows a motion under a controller at 3 kHz. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "index.h"
#include "plant.h"

static const double rate = 3000.0;      /* Hz */
static const double pretension = 5.0;   /* N */
static const double stiffness = 4000.0; /* 1/s^2: of the error */
static const double damping = 130.0;    /* 1/s */

/* Where the finger is to be at a time: each joint swings by itself. */
static void motion(double t, double q[JOINTS], double qd[JOINTS], double qdd[JOINTS])
{
    static const double centre[JOINTS] = {0.0, 0.6, 0.7, 0.5}, swing[JOINTS] = {0.15, 0.3, 0.3, 0.2};
    for (int i = 0; i < JOINTS; ++i) {
        const double w = 6.283185307 * (0.8 + 0.3 * i);
        q[i] = centre[i] - swing[i] * cos(w * t);
        qd[i] = swing[i] * w * sin(w * t);
        qdd[i] = swing[i] * w * w * cos(w * t);
    }
}

/* tau = M (qdd + corrections) + C qd + g; without the model a constant inertia stands for M, and
 * nothing for the rest. */
static void torques(const double q[JOINTS], const double qd[JOINTS], double t, int with_model,
                    double tau[JOINTS])
{
    static const double typical[JOINTS] = {2e-5, 2e-5, 8e-6, 1e-6}; /* kg m^2 */
    double wanted[JOINTS], wanted_rate[JOINTS], acceleration[JOINTS];
    motion(t, wanted, wanted_rate, acceleration);
    for (int i = 0; i < JOINTS; ++i) {
        const double correction =
            stiffness * (wanted[i] - q[i]) + damping * (wanted_rate[i] - qd[i]);
        acceleration[i] = with_model ? acceleration[i] + correction : correction;
        tau[i] = typical[i] * correction;
    }
    if (with_model) index_inverse_dynamics(q, qd, acceleration, tau);
    if (with_model)
        for (int i = 0; i < JOINTS; ++i) tau[i] += 1e-4 * wanted_rate[i]; /* the joints' damping */
}

/* Forces of pairs of antagonists: one above the pretension, the other at it. The radii are those of
 * the coupling matrix. */
static void share(const double tau[JOINTS], double f[TENDONS])
{
    double P[TENDONS * JOINTS];
    const double zero[JOINTS] = {0};
    index_coupling_matrix(zero, P);
    const double r20 = P[0], r21 = P[1], r22 = P[4 * JOINTS + 2], r23 = P[7 * JOINTS + 3];
    /* h7 and h8 turn q23; what they do to q22 is taken up by h5 and h6. */
    const double d = -tau[3] / r23;
    const double c = -tau[2] / r22 + d;
    const double a = -0.5 * (tau[0] / r20 + tau[1] / r21), b = -0.5 * (tau[0] / r20 - tau[1] / r21);
    f[0] = pretension + fmax(a, 0), f[3] = pretension + fmax(-a, 0);
    f[1] = pretension + fmax(b, 0), f[2] = pretension + fmax(-b, 0);
    f[4] = pretension + fmax(c, 0), f[5] = pretension + fmax(-c, 0);
    f[7] = pretension + fmax(d, 0), f[6] = pretension + fmax(-d, 0);
}

int main(int argc, char **argv)
{
    const int with_model = !(argc > 2 && strcmp(argv[2], "--without-model") == 0);
    double q[JOINTS], qd[JOINTS], unused[JOINTS], tau[JOINTS], f[TENDONS], largest = 0;
    motion(0, q, qd, unused);
    plant *finger = argc > 1 ? plant_open(argv[1], q) : 0;
    if (!finger) return fprintf(stderr, "usage: loop <unit> [--without-model]\n"), 2;
    for (int k = 0; k < 2 * (int)rate; ++k) {
        const double t = k / rate;
        plant_read(finger, q, qd);
        torques(q, qd, t, with_model, tau);
        share(tau, f);
        if (!plant_step(finger, f, 1 / rate)) return fprintf(stderr, "the unit fails\n"), 1;
        double wanted[JOINTS];
        motion(t, wanted, qd, unused);
        for (int i = 0; i < JOINTS; ++i) largest = fmax(largest, fabs(wanted[i] - q[i]));
    }
    plant_close(finger);
    printf("largest error over 2 s: %.3g mrad\n", 1e3 * largest);
    return with_model ? largest > 2e-3 : largest > 1.0 || largest < 2e-2;
}
