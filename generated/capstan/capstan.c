/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Friction of a guided tendon, capstan law
 *
 * Made by: sinew generate models/capstan
 * Model:   sha256 9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea
 * Do not edit: change the model and generate again.
 */
#include "capstan.h"

#include "sinew_math.h"

#ifdef __GNUC__
#define SINEW_NOT_INLINE __attribute__((noinline))
#else
#define SINEW_NOT_INLINE
#endif

SINEW_NOT_INLINE static double sinew_one_exp(double x)
{
    return sinew_exp(x);
}

void capstan_friction_force(double tension, double bending, double velocity,
    double force[SINEW_AT_LEAST(1)])
{
    const double limited_velocity = sinew_min(sinew_max(velocity, -1e+05), 1e+05);
    const double direction = limited_velocity / sinew_sqrt(1e-08 + limited_velocity
        * limited_velocity);
    const double angle = sinew_min(sinew_max(bending, 0.0), 100.0);
    const double t1 = direction * sinew_max(tension, 0.0) * (1.0 - sinew_one_exp(-(0.1 * angle)));
    force[0] = -t1;
}

void capstan_transmitted_force(double tension, double bending, double velocity,
    double force[SINEW_AT_LEAST(1)])
{
    const double limited_velocity = sinew_min(sinew_max(velocity, -1e+05), 1e+05);
    const double direction = limited_velocity / sinew_sqrt(1e-08 + limited_velocity
        * limited_velocity);
    const double angle = sinew_min(sinew_max(bending, 0.0), 100.0);
    force[0] = sinew_max(tension, 0.0) * sinew_one_exp(-(0.1 * angle * direction));
}
