/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Tendon forces with which the left fingertip presses to the right. */
#include <math.h>
#include <stdio.h>

#include "gripper.h"

enum { JOINTS = 4, TENDONS = 6 };
enum { FLEXOR, BASE_FLEXOR, EXTENSOR }; /* the left finger's tendons; its joints are 0 and 1 */

/* Joint torques of a force [N] along x at the tip: the first row of the Jacobian. */
static void torque_of_push(const double q[JOINTS], double push, double tau[JOINTS])
{
    double jacobian[6 * JOINTS];
    gripper_tip_jacobian(q, jacobian);
    for (int j = 0; j < JOINTS; ++j) tau[j] = push * jacobian[j];
}

/* The smallest forces f >= 0 with -P^T f = tau at the left finger's joints. The flexor and the
 * extensor pull against each other: one of them may rest. */
static int tendon_forces(const double q[JOINTS], const double tau[JOINTS], double f[TENDONS])
{
    double P[TENDONS * JOINTS];
    gripper_coupling_matrix(q, P);
    const double tip = -tau[1] / P[FLEXOR * JOINTS + 1]; /* what the flexor pulls more than the other */
    f[FLEXOR] = fmax(tip, 0.0);
    f[EXTENSOR] = fmax(-tip, 0.0);
    const double base = -tau[0] / P[BASE_FLEXOR * JOINTS]; /* flexors together less the extensor */
    f[BASE_FLEXOR] = base - tip;
    return f[BASE_FLEXOR] >= 0.0;
}

int main(void)
{
    static const char *const names[] = {"left_flexor", "left_base_flexor", "left_extensor"};
    const double q[JOINTS] = {0.5, 0.6, 0.5, 0.6}; /* rad */
    double tau[JOINTS], made[JOINTS], f[TENDONS] = {0};
    torque_of_push(q, 2.0, tau);
    if (!tendon_forces(q, tau, f)) {
        printf("pulling alone cannot do it\n");
        return 1;
    }
    for (int i = 0; i < 3; ++i) printf("%s %.2f N\n", names[i], f[i]);
    gripper_joint_torque(q, f, made);
    printf("the tendons press with %.2f N\n", 2.0 * made[0] / tau[0]);
    return fabs(made[0] - tau[0]) + fabs(made[1] - tau[1]) > 1e-12;
}
