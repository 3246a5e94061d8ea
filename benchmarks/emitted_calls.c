/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The emitted C of one robot behind one calling convention. ROBOT is the robot's name, SIZE its number
 * of joints; timed.c and timed_batch.c are what only_functions.awk leaves of the emitted files.
 */
#include "calls.h"

#define JOINED_OF(a, b) a##b
#define JOINED(a, b) JOINED_OF(a, b)

#include "timed.c"
#include "timed_batch.c"

dynamics_call sinew_inverse_dynamics, sinew_bias, sinew_mass_matrix, sinew_both,
    sinew_forward_dynamics;
batch_call sinew_batch;

void sinew_inverse_dynamics(const double *q, const double *qd, const double *u, double *out) {
    JOINED(ROBOT, _inverse_dynamics)(q, qd, u, out);
}

void sinew_bias(const double *q, const double *qd, const double *u, double *out) {
    (void)u;
    JOINED(ROBOT, _bias)(q, qd, out);
}

void sinew_mass_matrix(const double *q, const double *qd, const double *u, double *out) {
    (void)qd, (void)u;
    JOINED(ROBOT, _mass_matrix)(q, out);
}

void sinew_both(const double *q, const double *qd, const double *u, double *out) {
    (void)u;
    JOINED(ROBOT, _mass_matrix_and_bias)(q, qd, out, out + SIZE * SIZE);
}

void sinew_forward_dynamics(const double *q, const double *qd, const double *u, double *out) {
    JOINED(ROBOT, _forward_dynamics)(q, qd, u, out);
}

void sinew_batch(int count, const double *q, const double *qd, const double *u, double *out) {
    JOINED(ROBOT, _inverse_dynamics_batch)(count, q, qd, u, out);
}
