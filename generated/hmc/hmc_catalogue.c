/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model hmc behind one calling convention.
 *
 * Made by: sinew generate models/hmc
 * Model:   sha256 c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7
 * Do not edit: change the model and generate again.
 */
#include "hmc_catalogue.h"

#include "hmc.h"

static void call_four_bar(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hmc_four_bar(x[0], y + 0);
}
static const double four_bar_theta2_low[] = {1.0471975511965976};
static const double four_bar_theta2_high[] = {2.0943951023931953};
static const sinew_argument four_bar_inputs[] = {
    {"theta2", "rad", 1, 1, four_bar_theta2_low, four_bar_theta2_high},
};
static const sinew_argument four_bar_outputs[] = {
    {"out", "rad, rad, 1, 1", 4, 1, 0, 0},
};

static void call_locking(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    int status;
    hmc_locking(x[0], y + 0, &status);
    y[1] = (double)status;
}
static const double locking_theta2_low[] = {1.0471975511965976};
static const double locking_theta2_high[] = {2.0943951023931953};
static const sinew_argument locking_inputs[] = {
    {"theta2", "rad", 1, 1, locking_theta2_low, locking_theta2_high},
};
static const sinew_argument locking_outputs[] = {
    {"distance", "rad", 1, 1, 0, 0},
    {"status", "1", 1, 1, 0, 0},
};

static void call_coupler_pose(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hmc_coupler_pose(x[0], y + 0);
}
static const double coupler_pose_theta2_low[] = {1.0471975511965976};
static const double coupler_pose_theta2_high[] = {2.0943951023931953};
static const sinew_argument coupler_pose_inputs[] = {
    {"theta2", "rad", 1, 1, coupler_pose_theta2_low, coupler_pose_theta2_high},
};
static const sinew_argument coupler_pose_outputs[] = {
    {"T", "1 and m", 4, 4, 0, 0},
};

static void call_tendon_lengths(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    hmc_tendon_lengths(x[0], y + 0);
}
static const double tendon_lengths_theta2_low[] = {1.0471975511965976};
static const double tendon_lengths_theta2_high[] = {2.0943951023931953};
static const sinew_argument tendon_lengths_inputs[] = {
    {"theta2", "rad", 1, 1, tendon_lengths_theta2_low, tendon_lengths_theta2_high},
};
static const sinew_argument tendon_lengths_outputs[] = {
    {"h", "m", 2, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"hmc_four_bar", 1, 1, 1, 4, four_bar_inputs, four_bar_outputs, call_four_bar},
    {"hmc_locking", 1, 2, 1, 2, locking_inputs, locking_outputs, call_locking},
    {"hmc_coupler_pose", 1, 1, 1, 16, coupler_pose_inputs, coupler_pose_outputs, call_coupler_pose},
    {"hmc_tendon_lengths", 1, 1, 1, 2, tendon_lengths_inputs, tendon_lengths_outputs,
        call_tendon_lengths},
};

const sinew_catalogue hmc_catalogue = {"hmc",
    "c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7", 8, 4, functions};
