/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model lever behind one calling convention.
 *
 * Made by: sinew generate models/lever
 * Model:   sha256 15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c
 * Do not edit: change the model and generate again.
 */
#include "lever_catalogue.h"

#include "lever.h"

static void call_state(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    lever_state(x[0], y + 0);
}
static const double state_theta_low[] = {0.09548248781986068};
static const double state_theta_high[] = {0.8377580409572781};
static const sinew_argument state_inputs[] = {
    {"theta", "rad", 1, 1, state_theta_low, state_theta_high},
};
static const sinew_argument state_outputs[] = {
    {"out", "m, m, N, N/m", 4, 1, 0, 0},
};

static void call_slope(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    lever_slope(x[0], y + 0);
}
static const double slope_theta_low[] = {0.09548248781986068};
static const double slope_theta_high[] = {0.8377580409572781};
static const sinew_argument slope_inputs[] = {
    {"theta", "rad", 1, 1, slope_theta_low, slope_theta_high},
};
static const sinew_argument slope_outputs[] = {
    {"out", "m/rad, N m/rad", 2, 1, 0, 0},
};

static void call_angle(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    lever_angle(x[0], x[1], y + 0, y + 1);
}
static const double angle_elongation_low[] = {0.0};
static const double angle_elongation_high[] = {0.01};
static const double angle_theta_low[] = {0.09548248781986068};
static const double angle_theta_high[] = {0.8377580409572781};
static const sinew_argument angle_inputs[] = {
    {"elongation", "m", 1, 1, angle_elongation_low, angle_elongation_high},
    {"theta", "rad", 1, 1, angle_theta_low, angle_theta_high},
};
static const sinew_argument angle_outputs[] = {
    {"theta_lever", "rad", 1, 1, 0, 0},
    {"residual", "m", 1, 1, 0, 0},
};

static void call_status(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    int status;
    lever_status(x[0], &status);
    y[0] = (double)status;
}
static const double status_theta_low[] = {0.09548248781986068};
static const double status_theta_high[] = {0.8377580409572781};
static const sinew_argument status_inputs[] = {
    {"theta", "rad", 1, 1, status_theta_low, status_theta_high},
};
static const sinew_argument status_outputs[] = {
    {"status", "1", 1, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"lever_state", 1, 1, 1, 4, state_inputs, state_outputs, call_state},
    {"lever_slope", 1, 1, 1, 2, slope_inputs, slope_outputs, call_slope},
    {"lever_angle", 2, 2, 2, 2, angle_inputs, angle_outputs, call_angle},
    {"lever_status", 1, 1, 1, 1, status_inputs, status_outputs, call_status},
};

const sinew_catalogue lever_catalogue = {"lever",
    "15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c", 8, 4, functions};
