/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The simulated finger: an FMI 3.0 co-simulation unit, as an importer sees it. */
#ifndef PLANT_H
#define PLANT_H

enum { JOINTS = 4, TENDONS = 8 };

typedef struct plant plant;

/* Loads the unit whose unpacked contents are in `folder`; q [rad] is where it starts, at rest. Null,
 * with a line on standard error, where that cannot be. */
plant *plant_open(const char *folder, const double q[JOINTS]);
void plant_close(plant *p);

/* Joint angles [rad] and rates [rad/s]. */
void plant_read(plant *p, double q[JOINTS], double qd[JOINTS]);
/* Moves on by `step` seconds under these tendon forces [N]; 0 where the unit fails. */
int plant_step(plant *p, const double f[TENDONS], double step);

#endif
