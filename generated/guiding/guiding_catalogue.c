/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model guiding behind one calling convention.
 *
 * Made by: sinew generate models/guiding
 * Model:   sha256 46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b
 * Do not edit: change the model and generate again.
 */
#include "guiding_catalogue.h"

#include "guiding.h"

static void call_friction_force(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    guiding_friction_force(x[0], x[1], y + 0);
}
static const double friction_force_bending_low[] = {0.0};
static const double friction_force_bending_high[] = {6.3};
static const double friction_force_velocity_low[] = {-0.1};
static const double friction_force_velocity_high[] = {0.1};
static const sinew_argument friction_force_inputs[] = {
    {"bending", "rad", 1, 1, friction_force_bending_low, friction_force_bending_high},
    {"velocity", "m/s", 1, 1, friction_force_velocity_low, friction_force_velocity_high},
};
static const sinew_argument friction_force_outputs[] = {
    {"force", "N", 1, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"guiding_friction_force", 2, 1, 2, 1, friction_force_inputs, friction_force_outputs,
        call_friction_force},
};

const sinew_catalogue guiding_catalogue = {"guiding",
    "46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b", 8, 1, functions};
