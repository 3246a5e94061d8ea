/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Friction of a guided tendon, fitted form
 *
 * Made by: sinew generate models/guiding
 * Model:   sha256 46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b
 * Do not edit: change the model and generate again.
 */
#include "guiding.h"

#include "sinew_math.h"

static double sinew_one_exp(double x)
{
    return sinew_exp(x);
}

void guiding_friction_force(double bending, double velocity, double force[SINEW_AT_LEAST(1)])
{
    const double limited_velocity = sinew_min(sinew_max(velocity, -1e+05), 1e+05);
    const double direction = limited_velocity / sinew_sqrt(1e-08 + limited_velocity
        * limited_velocity);
    const double angle = sinew_min(sinew_max(bending, 0.0), 100.0);
    force[0] = -(6.0 * direction * (1.0 - sinew_one_exp(-(0.35 * angle))));
}
