/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Four questions to the emitted model of the index finger. SI units; matrices row by row. */
#include <stdio.h>

#include "index.h"

static const char *const joints[4] = {"q20", "q21", "q22", "q23"};

static void print_torques(const double tau[4])
{
    for (int i = 0; i < 4; ++i) printf(" %s %.1f%s", joints[i], 1e3 * tau[i], i < 3 ? "," : "\n");
}

int main(void)
{
    const double q[4] = {0.0, 0.5, 0.6, 0.4}; /* rad: abduction and three flexion joints */

    double pose[16];
    index_forward_kinematics(q, pose);
    printf("tip at x = %.1f mm, z = %.1f mm\n", 1e3 * pose[3], 1e3 * pose[11]);

    double holding[4];
    index_gravity(q, holding);
    printf("holding torques [mN m]:");
    print_torques(holding);

    double lengths[8];
    index_tendon_lengths(q, lengths);
    printf("tendon paths [mm]:");
    for (int i = 0; i < 8; ++i) printf(" h%d %.2f%s", i + 1, 1e3 * lengths[i], i < 7 ? "," : "\n");

    const double force[8] = {10.0, 0, 0, 0, 10.0, 0, 0, 0}; /* N; tendons pull */
    double pulled[4];
    index_joint_torque(q, force, pulled);
    printf("torques of 10 N in h1 and h5 [mN m]:");
    print_torques(pulled);
    return 0;
}
