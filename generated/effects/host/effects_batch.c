/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model effects over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/effects
 * Model:   sha256 69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f
 * Do not edit: change the model and generate again.
 */
#include "effects_batch.h"

#include <stddef.h>

#include "sinew_math.h"

#if defined(__GNUC__) && !defined(__clang__)
#define SINEW_STATES_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SINEW_STATES_ARE_INDEPENDENT
#endif

void effects_inertia_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[2 * n + state];
    }
}

void effects_viscous_level_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[1 * n + state];
    }
}

void effects_coulomb_level_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[6 * n + state];
    }
}

void effects_offset_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    (void)signals;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = 1.0;
    }
}

void effects_viscous_asymmetry_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = sinew_max(signals[1 * n + state], -signals[1 * n + state]);
    }
}

void effects_coulomb_asymmetry_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = sinew_max(signals[6 * n + state], -signals[6 * n + state]);
    }
}

void effects_stribeck_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(signals[6 * n + state], -signals[6 * n + state]);
        const double t2 = signals[1 * n + state] * signals[1 * n + state] / (shape[state]
            * shape[state]);
        const double t3 = signals[6 * n + state] * sinew_exp(-t2) / sinew_max(shape[1 * n + state]
            - shape[1 * n + state] * t1 + t1, 1e-06);
        columns[state] = t3;
    }
}

void effects_concave_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 1.0 / shape[state];
        const double t2 = sinew_max(sinew_max(signals[1 * n + state], -signals[1 * n + state]) * t1,
            1e-06);
        const double t3 = sinew_log(1.0 + sinew_exp(shape[1 * n + state] * sinew_log(t2))) / shape[1
            * n + state];
        columns[state] = signals[1 * n + state] * sinew_exp(-t3) * t1;
    }
}

void effects_concave_power_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(signals[6 * n + state], -signals[6 * n + state]);
        const double t2 = sinew_max(signals[1 * n + state], -signals[1 * n + state]) / shape[state];
        const double t3 = signals[6 * n + state] * sinew_exp(shape[1 * n + state]
            * sinew_log(sinew_max(t2, 1e-06)));
        const double t4 = t3 / sinew_max(shape[2 * n + state] - shape[2 * n + state] * t1 + t1,
            1e-06);
        columns[state] = t4;
    }
}

void effects_quadratic_friction_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[1 * n + state] * sinew_max(signals[1 * n + state], -signals[1 * n
            + state]);
        columns[state] = t1;
    }
}

void effects_load_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(signals[6 * n + state], -signals[6 * n + state]);
        const double t2 = signals[6 * n + state] * sinew_max(signals[4 * n + state], -signals[4 * n
            + state]);
        columns[state] = t2 / sinew_max(shape[state] - shape[state] * t1 + t1, 1e-06);
    }
}

void effects_friction_drift_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(signals[6 * n + state], -signals[6 * n + state]);
        const double t2 = signals[6 * n + state] * (1.0 - sinew_exp(-(signals[5 * n + state]
            / shape[state])));
        const double t3 = t2 / sinew_max(shape[1 * n + state] - shape[1 * n + state] * t1 + t1,
            1e-06);
        columns[state] = t3;
    }
}

void effects_position_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_max(signals[6 * n + state], -signals[6 * n + state]);
        const double t2 = signals[state] * signals[6 * n + state] / sinew_max(shape[state]
            - shape[state] * t1 + t1, 1e-06);
        columns[state] = t2;
    }
}

void effects_ripple_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[state] * shape[state];
        double s2, c3;
        sinew_sincos(t1, &s2, &c3);
        columns[state] = s2;
        columns[1 * n + state] = c3;
    }
}

void effects_load_ripple_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[state] * shape[state];
        double s2, c3;
        sinew_sincos(t1, &s2, &c3);
        columns[state] = signals[4 * n + state] * s2;
        columns[1 * n + state] = signals[4 * n + state] * c3;
    }
}

void effects_gear_elasticity_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[3 * n + state];
    }
}

void effects_gear_resonance_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[7 * n + state] * memory[2 * n + state];
        const double t2 = 4.0 * memory[1 * n + state] + t1;
        const double t3 = shape[state] * shape[state];
        const double t4 = shape[state] * shape[1 * n + state] * (memory[1 * n + state] + memory[1
            * n + state] + t1);
        const double t5 = 4.0 * (signals[2 * n + state] + t4) + (4.0 * memory[state] + signals[7 * n
            + state] * t2) * t3;
        const double t6 = signals[7 * n + state] * signals[7 * n + state];
        const double t7 = 4.0 + 4.0 * signals[7 * n + state] * shape[state] * shape[1 * n + state]
            + t6 * t3;
        const double t8 = 1.0 / t7;
        const double t9 = -(t5 * t8);
        const double t10 = 0.5 * signals[7 * n + state];
        columns[state] = t9;
        next[state] = memory[state] + 0.25 * signals[7 * n + state] * t2 - 0.25 * t5 * t6 * t8;
        next[1 * n + state] = memory[1 * n + state] + t10 * memory[2 * n + state] - t10 * t5 * t8;
        next[2 * n + state] = t9;
    }
}

void effects_torsion_spring_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[state];
    }
}

void effects_offset_drift_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[5 * n + state];
    }
}

void effects_cable_torque_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_min(sinew_max((signals[state] - shape[state]) / shape[1 * n
            + state], -1.0), 1.0);
        const double t2 = 1.0 - (t1 + t1) * t1;
        const double t3 = (t2 + t2) * t1;
        const double t4 = t3 + t1;
        const double t5 = (t4 + t4) * t1;
        const double t6 = t2 - t5;
        const double t7 = t3 + (t6 + t6) * t1;
        const double t8 = t7 + t1;
        const double t9 = t2 - (t8 + t8) * t1 - t5;
        columns[state] = 1.0;
        columns[1 * n + state] = t1;
        columns[2 * n + state] = -t2;
        columns[3 * n + state] = -t4;
        columns[4 * n + state] = t6;
        columns[5 * n + state] = t8;
        columns[6 * n + state] = -t9;
        columns[7 * n + state] = -(t7 + (t9 + t9) * t1 + t1);
    }
}

void effects_cable_torque_cubic_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_min(sinew_max((signals[state] - shape[state]) / shape[1 * n
            + state], -1.0), 1.0);
        const double t2 = 1.0 - (t1 + t1) * t1;
        columns[state] = 1.0;
        columns[1 * n + state] = t1;
        columns[2 * n + state] = -t2;
        columns[3 * n + state] = -((t2 + t2) * t1 + t1);
    }
}

void effects_inertial_backlash_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = memory[2 * n + state] + signals[2 * n + state] * signals[7 * n + state]
            / shape[state];
        const double t2 = 1.0 - memory[state] + memory[1 * n + state] + signals[7 * n + state] * t1;
        const double t3 = sinew_min(sinew_max(t2, 0.0), 1.0);
        const double t4 = -(shape[1 * n + state] * t1);
        const double t5 = sinew_choose(-t3, t4, sinew_choose(-(1.0 - t3), t4, t1));
        columns[state] = -(shape[state] * (memory[2 * n + state] - t5) / signals[7 * n + state]);
        next[state] = 1.0;
        next[1 * n + state] = t3;
        next[2 * n + state] = t5;
    }
}

void effects_loaded_backlash_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[4 * n + state] * shape[1 * n + state];
        const double t2 = memory[2 * n + state] + signals[7 * n + state] * (signals[2 * n + state]
            + t1) / shape[state];
        const double t3 = memory[1 * n + state] + signals[7 * n + state] * t2 + (1.0
            - memory[state]) * sinew_choose(t1, 1.0, 0.0);
        const double t4 = sinew_min(sinew_max(t3, 0.0), 1.0);
        const double t5 = -(shape[2 * n + state] * t2);
        const double t6 = sinew_choose(-t4, t5, sinew_choose(-(1.0 - t4), t5, t2));
        columns[state] = -(shape[state] * (memory[2 * n + state] - t6) / signals[7 * n + state]);
        next[state] = 1.0;
        next[1 * n + state] = t4;
        next[2 * n + state] = t6;
    }
}

void effects_link_elasticity_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[9 * n + state] * signals[10 * n + state];
    }
}

void effects_link_resonance_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = 1.0 - memory[state];
        const double t2 = signals[2 * n + state] - signals[8 * n + state];
        const double t3 = shape[state] * shape[state];
        const double t4 = 1.0 / t3;
        const double t5 = signals[7 * n + state] * memory[3 * n + state];
        const double t6 = 4.0 * memory[2 * n + state] + t5;
        const double t7 = 4.0 * memory[1 * n + state] + signals[7 * n + state] * t6 + 4.0 * t1 * t2
            * t4;
        const double t8 = shape[state] * shape[1 * n + state] * (memory[2 * n + state] + memory[2
            * n + state] + t5);
        const double t9 = 4.0 * (signals[8 * n + state] + t8) + t7 * t3;
        const double t10 = signals[7 * n + state] * signals[7 * n + state];
        const double t11 = 4.0 + 4.0 * signals[7 * n + state] * shape[state] * shape[1 * n + state]
            + t10 * t3;
        const double t12 = 1.0 / t11;
        const double t13 = memory[1 * n + state] + 0.25 * signals[7 * n + state] * t6 + t1 * t2
            * t4;
        const double t14 = 0.5 * signals[7 * n + state];
        columns[state] = -(signals[9 * n + state] * t9 * t12);
        next[state] = 1.0;
        next[1 * n + state] = t13 - 0.25 * t9 * t10 * t12;
        next[2 * n + state] = memory[2 * n + state] + t14 * memory[3 * n + state] - t14 * t9 * t12;
        next[3 * n + state] = -(t9 * t12);
    }
}

void effects_link_backlash_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = memory[2 * n + state] + signals[7 * n + state] * signals[8 * n + state]
            / shape[state];
        const double t2 = sinew_choose(-(signals[2 * n + state] - signals[8 * n + state]), 1.0,
            0.0);
        const double t3 = memory[1 * n + state] + signals[7 * n + state] * t1 + (1.0
            - memory[state]) * t2;
        const double t4 = sinew_min(sinew_max(t3, 0.0), 1.0);
        const double t5 = -(shape[1 * n + state] * t1);
        const double t6 = sinew_choose(-t4, t5, sinew_choose(-(1.0 - t4), t5, t1));
        const double t7 = signals[9 * n + state] * shape[state] * (memory[2 * n + state] - t6)
            / signals[7 * n + state];
        columns[state] = -t7;
        next[state] = 1.0;
        next[1 * n + state] = t4;
        next[2 * n + state] = t6;
    }
}

void effects_guiding_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[4 * n + state] * signals[6 * n + state] * (signals[state]
            + shape[state]);
        columns[state] = t1;
    }
}

void effects_motor_side_guiding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[4 * n + state] * signals[6 * n + state] * (signals[state]
            + shape[state]);
        columns[state] = t1;
    }
}

void effects_guiding_presliding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[1 * n + state] * signals[7 * n + state] / shape[1 * n + state];
        const double t2 = sinew_exp(-sinew_abs(t1));
        const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[state]) * t2, -(1.0 - (1.0
            + memory[state]) * t2));
        columns[state] = signals[4 * n + state] * (signals[state] + shape[state]) * t3;
        next[state] = t3;
    }
}

void effects_guide_drag_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[6 * n + state] * (signals[state] + shape[state]);
    }
}

void effects_guide_drag_presliding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[1 * n + state] * signals[7 * n + state] / shape[1 * n + state];
        const double t2 = sinew_exp(-sinew_abs(t1));
        const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[state]) * t2, -(1.0 - (1.0
            + memory[state]) * t2));
        columns[state] = (signals[state] + shape[state]) * t3;
        next[state] = t3;
    }
}

void effects_force_sensor_scale_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[4 * n + state];
    }
}

void effects_force_sensor_offset_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    (void)signals;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = 1.0;
    }
}

void effects_tendon_radius_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        columns[state] = signals[4 * n + state];
    }
}

void effects_routing_offset_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        double s1, c2;
        sinew_sincos(signals[state], &s1, &c2);
        columns[state] = signals[4 * n + state] * s1;
        columns[1 * n + state] = signals[4 * n + state] * c2;
    }
}

void effects_presliding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[1 * n + state] * signals[7 * n + state] / shape[state];
        const double t2 = sinew_exp(-sinew_abs(t1));
        const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[state]) * t2, -(1.0 - (1.0
            + memory[state]) * t2));
        columns[state] = t3;
        next[state] = t3;
    }
}

void effects_soft_reversal_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = sinew_tanh(signals[1 * n + state] / shape[state]) - sinew_choose(signals[1
            * n + state], 1.0, -1.0);
        columns[state] = t1;
    }
}

void effects_late_reversal_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next)
{
    const size_t n = (size_t)count;
    SINEW_STATES_ARE_INDEPENDENT
    for (size_t state = 0; state < n; ++state) {
        const double t1 = signals[1 * n + state] * signals[7 * n + state] / shape[state];
        const double t2 = sinew_exp(-sinew_abs(t1));
        const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[state]) * t2, -(1.0 - (1.0
            + memory[state]) * t2));
        const double t4 = (sinew_choose(signals[1 * n + state], 1.0, -1.0) - t3)
            * sinew_max(signals[6 * n + state], -signals[6 * n + state]);
        columns[state] = -t4;
        next[state] = t3;
    }
}
