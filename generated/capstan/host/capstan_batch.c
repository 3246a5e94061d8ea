/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model capstan over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/capstan
 * Model:   sha256 9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea
 * Do not edit: change the model and generate again.
 */
#include "capstan_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void capstan_friction_force_batch(int count, const double *SINEW_RESTRICT tension,
    const double *SINEW_RESTRICT bending, const double *SINEW_RESTRICT velocity,
    double *SINEW_RESTRICT force)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double limited_velocity = sinew_min(sinew_max(velocity[state], -1e+05), 1e+05);
        const double direction = limited_velocity / sinew_sqrt(1e-08 + limited_velocity
            * limited_velocity);
        const double angle = sinew_min(sinew_max(bending[state], 0.0), 100.0);
        const double t1 = direction * sinew_max(tension[state], 0.0) * (1.0 - sinew_exp(-(0.1
            * angle)));
        force[state] = -t1;
    }
}

void capstan_transmitted_force_batch(int count, const double *SINEW_RESTRICT tension,
    const double *SINEW_RESTRICT bending, const double *SINEW_RESTRICT velocity,
    double *SINEW_RESTRICT force)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double limited_velocity = sinew_min(sinew_max(velocity[state], -1e+05), 1e+05);
        const double direction = limited_velocity / sinew_sqrt(1e-08 + limited_velocity
            * limited_velocity);
        const double angle = sinew_min(sinew_max(bending[state], 0.0), 100.0);
        force[state] = sinew_max(tension[state], 0.0) * sinew_exp(-(0.1 * angle * direction));
    }
}
