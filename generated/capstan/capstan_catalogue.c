/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model capstan behind one calling convention.
 *
 * Made by: sinew generate models/capstan
 * Model:   sha256 9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea
 * Do not edit: change the model and generate again.
 */
#include "capstan_catalogue.h"

#include "capstan.h"

static void call_friction_force(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    capstan_friction_force(x[0], x[1], x[2], y + 0);
}
static const double friction_force_tension_low[] = {0.0};
static const double friction_force_tension_high[] = {100.0};
static const double friction_force_bending_low[] = {0.0};
static const double friction_force_bending_high[] = {6.3};
static const double friction_force_velocity_low[] = {-0.1};
static const double friction_force_velocity_high[] = {0.1};
static const sinew_argument friction_force_inputs[] = {
    {"tension", "N", 1, 1, friction_force_tension_low, friction_force_tension_high},
    {"bending", "rad", 1, 1, friction_force_bending_low, friction_force_bending_high},
    {"velocity", "m/s", 1, 1, friction_force_velocity_low, friction_force_velocity_high},
};
static const sinew_argument friction_force_outputs[] = {
    {"force", "N", 1, 1, 0, 0},
};

static void call_transmitted_force(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    capstan_transmitted_force(x[0], x[1], x[2], y + 0);
}
static const double transmitted_force_tension_low[] = {0.0};
static const double transmitted_force_tension_high[] = {100.0};
static const double transmitted_force_bending_low[] = {0.0};
static const double transmitted_force_bending_high[] = {6.3};
static const double transmitted_force_velocity_low[] = {-0.1};
static const double transmitted_force_velocity_high[] = {0.1};
static const sinew_argument transmitted_force_inputs[] = {
    {"tension", "N", 1, 1, transmitted_force_tension_low, transmitted_force_tension_high},
    {"bending", "rad", 1, 1, transmitted_force_bending_low, transmitted_force_bending_high},
    {"velocity", "m/s", 1, 1, transmitted_force_velocity_low, transmitted_force_velocity_high},
};
static const sinew_argument transmitted_force_outputs[] = {
    {"force", "N", 1, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"capstan_friction_force", 3, 1, 3, 1, friction_force_inputs, friction_force_outputs,
        call_friction_force},
    {"capstan_transmitted_force", 3, 1, 3, 1, transmitted_force_inputs, transmitted_force_outputs,
        call_transmitted_force},
};

const sinew_catalogue capstan_catalogue = {"capstan",
    "9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea", 8, 2, functions};
