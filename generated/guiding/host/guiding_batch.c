/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model guiding over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/guiding
 * Model:   sha256 46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b
 * Do not edit: change the model and generate again.
 */
#include "guiding_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void guiding_friction_force_batch(int count, const double *SINEW_RESTRICT bending,
    const double *SINEW_RESTRICT velocity, double *SINEW_RESTRICT force)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double limited_velocity = sinew_min(sinew_max(velocity[state], -1e+05), 1e+05);
        const double direction = limited_velocity / sinew_sqrt(1e-08 + limited_velocity
            * limited_velocity);
        const double angle = sinew_min(sinew_max(bending[state], 0.0), 100.0);
        force[state] = -(6.0 * direction * (1.0 - sinew_exp(-(0.35 * angle))));
    }
}
