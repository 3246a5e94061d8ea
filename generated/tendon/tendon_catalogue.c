/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model tendon behind one calling convention.
 *
 * Made by: sinew generate models/tendon
 * Model:   sha256 9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747
 * Do not edit: change the model and generate again.
 */
#include "tendon_catalogue.h"

#include "tendon.h"

static void call_series_stiffness(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    tendon_series_stiffness(x[0], y + 0);
}
static const double series_stiffness_k_lever_low[] = {0.0};
static const double series_stiffness_k_lever_high[] = {50000.0};
static const sinew_argument series_stiffness_inputs[] = {
    {"k_lever", "N/m", 1, 1, series_stiffness_k_lever_low, series_stiffness_k_lever_high},
};
static const sinew_argument series_stiffness_outputs[] = {
    {"k", "N/m", 1, 1, 0, 0},
};

static void call_force(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    tendon_force(x[0], x[1], y + 0, y + 3);
}
static const double force_elongation_low[] = {-0.001};
static const double force_elongation_high[] = {0.014953332035956196};
static const double force_theta_low[] = {0.09548248781986068};
static const double force_theta_high[] = {0.8377580409572781};
static const sinew_argument force_inputs[] = {
    {"elongation", "m", 1, 1, force_elongation_low, force_elongation_high},
    {"theta", "rad", 1, 1, force_theta_low, force_theta_high},
};
static const sinew_argument force_outputs[] = {
    {"out", "N, N/m, rad", 3, 1, 0, 0},
    {"residual", "m", 1, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"tendon_series_stiffness", 1, 1, 1, 1, series_stiffness_inputs, series_stiffness_outputs,
        call_series_stiffness},
    {"tendon_force", 2, 2, 2, 4, force_inputs, force_outputs, call_force},
};

const sinew_catalogue tendon_catalogue = {"tendon",
    "9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747", 8, 2, functions};
