/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Regressors of the effects that a diagnosis looks for
 *
 * Made by: sinew generate models/effects
 * Model:   sha256 69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f
 * Do not edit: change the model and generate again.
 */
#include "effects.h"

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

SINEW_NOT_INLINE static double sinew_one_log(double x)
{
    return sinew_log(x);
}

struct sinew_sines {
    double s[1], c[1];
};

SINEW_NOT_INLINE static struct sinew_sines sinew_one_sincos(double x)
{
    struct sinew_sines y;
    sinew_sincos(x, y.s, y.c);
    return y;
}

static double sinew_one_tanh(double x)
{
    return sinew_tanh(x);
}

void effects_inertia(const double signals[SINEW_AT_LEAST(11)], double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[2];
}

void effects_viscous_level(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[1];
}

void effects_coulomb_level(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[6];
}

void effects_offset(const double signals[SINEW_AT_LEAST(11)], double columns[SINEW_AT_LEAST(1)])
{
    (void)signals;
    columns[0] = 1.0;
}

void effects_viscous_asymmetry(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = sinew_max(signals[1], -signals[1]);
}

void effects_coulomb_asymmetry(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = sinew_max(signals[6], -signals[6]);
}

void effects_stribeck(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_max(signals[6], -signals[6]);
    const double t2 = signals[6] * sinew_one_exp(-(signals[1] * signals[1] / (shape[0]
        * shape[0])));
    columns[0] = t2 / sinew_max(shape[1] - shape[1] * t1 + t1, 1e-06);
}

void effects_concave_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = 1.0 / shape[0];
    const double t2 = shape[1] * sinew_one_log(sinew_max(sinew_max(signals[1], -signals[1]) * t1,
        1e-06));
    const double t3 = signals[1] * sinew_one_exp(-(sinew_one_log(1.0 + sinew_one_exp(t2))
        / shape[1]));
    columns[0] = t3 * t1;
}

void effects_concave_power(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(3)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_max(signals[6], -signals[6]);
    const double t2 = sinew_one_log(sinew_max(sinew_max(signals[1], -signals[1]) / shape[0],
        1e-06));
    const double t3 = signals[6] * sinew_one_exp(shape[1] * t2) / sinew_max(shape[2] - shape[2] * t1
        + t1, 1e-06);
    columns[0] = t3;
}

void effects_quadratic_friction(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[1] * sinew_max(signals[1], -signals[1]);
}

void effects_load_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_max(signals[6], -signals[6]);
    const double t2 = signals[6] * sinew_max(signals[4], -signals[4]) / sinew_max(shape[0]
        - shape[0] * t1 + t1, 1e-06);
    columns[0] = t2;
}

void effects_friction_drift(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_max(signals[6], -signals[6]);
    const double t2 = signals[6] * (1.0 - sinew_one_exp(-(signals[5] / shape[0])))
        / sinew_max(shape[1] - shape[1] * t1 + t1, 1e-06);
    columns[0] = t2;
}

void effects_position_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_max(signals[6], -signals[6]);
    const double t2 = signals[0] * signals[6] / sinew_max(shape[0] - shape[0] * t1 + t1, 1e-06);
    columns[0] = t2;
}

void effects_ripple(const double signals[SINEW_AT_LEAST(11)], const double shape[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(2)])
{
    const double t1 = signals[0] * shape[0];
    const struct sinew_sines sines2 = sinew_one_sincos(t1);
    const double s3 = sines2.s[0];
    const double c4 = sines2.c[0];
    columns[0] = s3;
    columns[1] = c4;
}

void effects_load_ripple(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(2)])
{
    const double t1 = signals[0] * shape[0];
    const struct sinew_sines sines2 = sinew_one_sincos(t1);
    const double s3 = sines2.s[0];
    const double c4 = sines2.c[0];
    columns[0] = signals[4] * s3;
    columns[1] = signals[4] * c4;
}

void effects_gear_elasticity(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[3];
}

void effects_gear_resonance(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)])
{
    const double t1 = signals[7] * memory[2];
    const double t2 = 4.0 * memory[1] + t1;
    const double t3 = shape[0] * shape[0];
    const double t4 = 4.0 * (signals[2] + shape[0] * shape[1] * (memory[1] + memory[1] + t1)) + (4.0
        * memory[0] + signals[7] * t2) * t3;
    const double t5 = signals[7] * signals[7];
    const double t6 = 1.0 / (4.0 + 4.0 * signals[7] * shape[0] * shape[1] + t5 * t3);
    const double t7 = -(t4 * t6);
    const double t8 = 0.5 * signals[7];
    columns[0] = t7;
    next[0] = memory[0] + 0.25 * signals[7] * t2 - 0.25 * t4 * t5 * t6;
    next[1] = memory[1] + t8 * memory[2] - t8 * t4 * t6;
    next[2] = t7;
}

void effects_torsion_spring(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[0];
}

void effects_offset_drift(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[5];
}

void effects_cable_torque(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(8)])
{
    const double t1 = sinew_min(sinew_max((signals[0] - shape[0]) / shape[1], -1.0), 1.0);
    const double t2 = 1.0 - (t1 + t1) * t1;
    const double t3 = (t2 + t2) * t1;
    const double t4 = t3 + t1;
    const double t5 = (t4 + t4) * t1;
    const double t6 = t2 - t5;
    const double t7 = t3 + (t6 + t6) * t1;
    const double t8 = t7 + t1;
    const double t9 = t2 - (t8 + t8) * t1 - t5;
    columns[0] = 1.0;
    columns[1] = t1;
    columns[2] = -t2;
    columns[3] = -t4;
    columns[4] = t6;
    columns[5] = t8;
    columns[6] = -t9;
    columns[7] = -(t7 + (t9 + t9) * t1 + t1);
}

void effects_cable_torque_cubic(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(4)])
{
    const double t1 = sinew_min(sinew_max((signals[0] - shape[0]) / shape[1], -1.0), 1.0);
    const double t2 = 1.0 - (t1 + t1) * t1;
    columns[0] = 1.0;
    columns[1] = t1;
    columns[2] = -t2;
    columns[3] = -((t2 + t2) * t1 + t1);
}

void effects_inertial_backlash(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)])
{
    const double t1 = memory[2] + signals[2] * signals[7] / shape[0];
    const double t2 = sinew_min(sinew_max(1.0 - memory[0] + memory[1] + signals[7] * t1, 0.0), 1.0);
    const double t3 = -(shape[1] * t1);
    const double t4 = sinew_choose(-t2, t3, sinew_choose(-(1.0 - t2), t3, t1));
    columns[0] = -(shape[0] * (memory[2] - t4) / signals[7]);
    next[0] = 1.0;
    next[1] = t2;
    next[2] = t4;
}

void effects_loaded_backlash(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(3)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)])
{
    const double t1 = signals[4] * shape[1];
    const double t2 = memory[2] + signals[7] * (signals[2] + t1) / shape[0];
    const double t3 = memory[1] + signals[7] * t2 + (1.0 - memory[0]) * sinew_choose(t1, 1.0, 0.0);
    const double t4 = sinew_min(sinew_max(t3, 0.0), 1.0);
    const double t5 = -(shape[2] * t2);
    const double t6 = sinew_choose(-t4, t5, sinew_choose(-(1.0 - t4), t5, t2));
    columns[0] = -(shape[0] * (memory[2] - t6) / signals[7]);
    next[0] = 1.0;
    next[1] = t4;
    next[2] = t6;
}

void effects_link_elasticity(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[9] * signals[10];
}

void effects_link_resonance(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(4)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(4)])
{
    const double t1 = 1.0 - memory[0];
    const double t2 = signals[2] - signals[8];
    const double t3 = shape[0] * shape[0];
    const double t4 = 1.0 / t3;
    const double t5 = signals[7] * memory[3];
    const double t6 = 4.0 * memory[2] + t5;
    const double t7 = 4.0 * (signals[8] + shape[0] * shape[1] * (memory[2] + memory[2] + t5)) + (4.0
        * memory[1] + signals[7] * t6 + 4.0 * t1 * t2 * t4) * t3;
    const double t8 = signals[7] * signals[7];
    const double t9 = 1.0 / (4.0 + 4.0 * signals[7] * shape[0] * shape[1] + t8 * t3);
    const double t10 = 0.5 * signals[7];
    columns[0] = -(signals[9] * t7 * t9);
    next[0] = 1.0;
    next[1] = memory[1] + 0.25 * signals[7] * t6 + t1 * t2 * t4 - 0.25 * t7 * t8 * t9;
    next[2] = memory[2] + t10 * memory[3] - t10 * t7 * t9;
    next[3] = -(t7 * t9);
}

void effects_link_backlash(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)])
{
    const double t1 = memory[2] + signals[7] * signals[8] / shape[0];
    const double t2 = memory[1] + signals[7] * t1 + (1.0 - memory[0]) * sinew_choose(-(signals[2]
        - signals[8]), 1.0, 0.0);
    const double t3 = sinew_min(sinew_max(t2, 0.0), 1.0);
    const double t4 = -(shape[1] * t1);
    const double t5 = sinew_choose(-t3, t4, sinew_choose(-(1.0 - t3), t4, t1));
    columns[0] = -(signals[9] * shape[0] * (memory[2] - t5) / signals[7]);
    next[0] = 1.0;
    next[1] = t3;
    next[2] = t5;
}

void effects_guiding_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[4] * signals[6] * (signals[0] + shape[0]);
}

void effects_motor_side_guiding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[4] * signals[6] * (signals[0] + shape[0]);
}

void effects_guiding_presliding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)])
{
    const double t1 = signals[1] * signals[7] / shape[1];
    const double t2 = sinew_one_exp(-sinew_abs(t1));
    const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[0]) * t2, -(1.0 - (1.0 + memory[0])
        * t2));
    columns[0] = signals[4] * (signals[0] + shape[0]) * t3;
    next[0] = t3;
}

void effects_guide_drag(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[6] * (signals[0] + shape[0]);
}

void effects_guide_drag_presliding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)])
{
    const double t1 = signals[1] * signals[7] / shape[1];
    const double t2 = sinew_one_exp(-sinew_abs(t1));
    const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[0]) * t2, -(1.0 - (1.0 + memory[0])
        * t2));
    columns[0] = (signals[0] + shape[0]) * t3;
    next[0] = t3;
}

void effects_force_sensor_scale(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[4];
}

void effects_force_sensor_offset(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    (void)signals;
    columns[0] = 1.0;
}

void effects_tendon_radius(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)])
{
    columns[0] = signals[4];
}

void effects_routing_offset(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(2)])
{
    const struct sinew_sines sines1 = sinew_one_sincos(signals[0]);
    const double s2 = sines1.s[0];
    const double c3 = sines1.c[0];
    columns[0] = signals[4] * s2;
    columns[1] = signals[4] * c3;
}

void effects_presliding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)])
{
    const double t1 = signals[1] * signals[7] / shape[0];
    const double t2 = sinew_one_exp(-sinew_abs(t1));
    const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[0]) * t2, -(1.0 - (1.0 + memory[0])
        * t2));
    columns[0] = t3;
    next[0] = t3;
}

void effects_soft_reversal(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)])
{
    const double t1 = sinew_one_tanh(signals[1] / shape[0]) - sinew_choose(signals[1], 1.0, -1.0);
    columns[0] = t1;
}

void effects_late_reversal(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)])
{
    const double t1 = signals[1] * signals[7] / shape[0];
    const double t2 = sinew_one_exp(-sinew_abs(t1));
    const double t3 = sinew_choose(t1, 1.0 - (1.0 - memory[0]) * t2, -(1.0 - (1.0 + memory[0])
        * t2));
    const double t4 = (sinew_choose(signals[1], 1.0, -1.0) - t3) * sinew_max(signals[6],
        -signals[6]);
    columns[0] = -t4;
    next[0] = t3;
}
