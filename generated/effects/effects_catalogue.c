/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model effects behind one calling convention.
 *
 * Made by: sinew generate models/effects
 * Model:   sha256 69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f
 * Do not edit: change the model and generate again.
 */
#include "effects_catalogue.h"

#include "effects.h"

static void call_inertia(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_inertia(x + 0, y + 0);
}
static const double inertia_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0, 1e-04,
    -50.0, 0.001, -10000.0};
static const double inertia_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01, 50.0,
    10.0, 10000.0};
static const sinew_argument inertia_inputs[] = {
    {"signals", "SI", 11, 1, inertia_signals_low, inertia_signals_high},
};
static const sinew_argument inertia_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_viscous_level(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_viscous_level(x + 0, y + 0);
}
static const double viscous_level_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double viscous_level_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const sinew_argument viscous_level_inputs[] = {
    {"signals", "SI", 11, 1, viscous_level_signals_low, viscous_level_signals_high},
};
static const sinew_argument viscous_level_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_coulomb_level(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_coulomb_level(x + 0, y + 0);
}
static const double coulomb_level_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double coulomb_level_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const sinew_argument coulomb_level_inputs[] = {
    {"signals", "SI", 11, 1, coulomb_level_signals_low, coulomb_level_signals_high},
};
static const sinew_argument coulomb_level_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_offset(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_offset(x + 0, y + 0);
}
static const double offset_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0, 1e-04,
    -50.0, 0.001, -10000.0};
static const double offset_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01, 50.0,
    10.0, 10000.0};
static const sinew_argument offset_inputs[] = {
    {"signals", "SI", 11, 1, offset_signals_low, offset_signals_high},
};
static const sinew_argument offset_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_viscous_asymmetry(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_viscous_asymmetry(x + 0, y + 0);
}
static const double viscous_asymmetry_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double viscous_asymmetry_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument viscous_asymmetry_inputs[] = {
    {"signals", "SI", 11, 1, viscous_asymmetry_signals_low, viscous_asymmetry_signals_high},
};
static const sinew_argument viscous_asymmetry_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_coulomb_asymmetry(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_coulomb_asymmetry(x + 0, y + 0);
}
static const double coulomb_asymmetry_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double coulomb_asymmetry_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument coulomb_asymmetry_inputs[] = {
    {"signals", "SI", 11, 1, coulomb_asymmetry_signals_low, coulomb_asymmetry_signals_high},
};
static const sinew_argument coulomb_asymmetry_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_stribeck(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_stribeck(x + 0, x + 11, y + 0);
}
static const double stribeck_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0, 1e-04,
    -50.0, 0.001, -10000.0};
static const double stribeck_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double stribeck_shape_low[] = {0.01, 0.05};
static const double stribeck_shape_high[] = {0.3, 1.0};
static const sinew_argument stribeck_inputs[] = {
    {"signals", "SI", 11, 1, stribeck_signals_low, stribeck_signals_high},
    {"shape", "SI", 2, 1, stribeck_shape_low, stribeck_shape_high},
};
static const sinew_argument stribeck_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_concave_friction(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_concave_friction(x + 0, x + 11, y + 0);
}
static const double concave_friction_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double concave_friction_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double concave_friction_shape_low[] = {0.03, 1.0};
static const double concave_friction_shape_high[] = {1.0, 4.0};
static const sinew_argument concave_friction_inputs[] = {
    {"signals", "SI", 11, 1, concave_friction_signals_low, concave_friction_signals_high},
    {"shape", "SI", 2, 1, concave_friction_shape_low, concave_friction_shape_high},
};
static const sinew_argument concave_friction_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_concave_power(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_concave_power(x + 0, x + 11, y + 0);
}
static const double concave_power_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double concave_power_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double concave_power_shape_low[] = {1.0, 0.2, 0.05};
static const double concave_power_shape_high[] = {1.0, 0.8, 1.0};
static const sinew_argument concave_power_inputs[] = {
    {"signals", "SI", 11, 1, concave_power_signals_low, concave_power_signals_high},
    {"shape", "SI", 3, 1, concave_power_shape_low, concave_power_shape_high},
};
static const sinew_argument concave_power_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_quadratic_friction(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_quadratic_friction(x + 0, y + 0);
}
static const double quadratic_friction_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double quadratic_friction_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument quadratic_friction_inputs[] = {
    {"signals", "SI", 11, 1, quadratic_friction_signals_low, quadratic_friction_signals_high},
};
static const sinew_argument quadratic_friction_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_load_friction(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_load_friction(x + 0, x + 11, y + 0);
}
static const double load_friction_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double load_friction_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double load_friction_shape_low[] = {0.05};
static const double load_friction_shape_high[] = {1.0};
static const sinew_argument load_friction_inputs[] = {
    {"signals", "SI", 11, 1, load_friction_signals_low, load_friction_signals_high},
    {"shape", "SI", 1, 1, load_friction_shape_low, load_friction_shape_high},
};
static const sinew_argument load_friction_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_friction_drift(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_friction_drift(x + 0, x + 11, y + 0);
}
static const double friction_drift_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double friction_drift_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double friction_drift_shape_low[] = {0.05, 0.05};
static const double friction_drift_shape_high[] = {2.0, 1.0};
static const sinew_argument friction_drift_inputs[] = {
    {"signals", "SI", 11, 1, friction_drift_signals_low, friction_drift_signals_high},
    {"shape", "SI", 2, 1, friction_drift_shape_low, friction_drift_shape_high},
};
static const sinew_argument friction_drift_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_position_friction(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_position_friction(x + 0, x + 11, y + 0);
}
static const double position_friction_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double position_friction_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double position_friction_shape_low[] = {0.05};
static const double position_friction_shape_high[] = {1.0};
static const sinew_argument position_friction_inputs[] = {
    {"signals", "SI", 11, 1, position_friction_signals_low, position_friction_signals_high},
    {"shape", "SI", 1, 1, position_friction_shape_low, position_friction_shape_high},
};
static const sinew_argument position_friction_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_ripple(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_ripple(x + 0, x + 11, y + 0);
}
static const double ripple_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0, 1e-04,
    -50.0, 0.001, -10000.0};
static const double ripple_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01, 50.0,
    10.0, 10000.0};
static const double ripple_shape_low[] = {1.0};
static const double ripple_shape_high[] = {1000.0};
static const sinew_argument ripple_inputs[] = {
    {"signals", "SI", 11, 1, ripple_signals_low, ripple_signals_high},
    {"shape", "SI", 1, 1, ripple_shape_low, ripple_shape_high},
};
static const sinew_argument ripple_outputs[] = {
    {"columns", "SI", 2, 1, 0, 0},
};

static void call_load_ripple(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_load_ripple(x + 0, x + 11, y + 0);
}
static const double load_ripple_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double load_ripple_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double load_ripple_shape_low[] = {1.0};
static const double load_ripple_shape_high[] = {1000.0};
static const sinew_argument load_ripple_inputs[] = {
    {"signals", "SI", 11, 1, load_ripple_signals_low, load_ripple_signals_high},
    {"shape", "SI", 1, 1, load_ripple_shape_low, load_ripple_shape_high},
};
static const sinew_argument load_ripple_outputs[] = {
    {"columns", "SI", 2, 1, 0, 0},
};

static void call_gear_elasticity(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_gear_elasticity(x + 0, y + 0);
}
static const double gear_elasticity_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double gear_elasticity_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument gear_elasticity_inputs[] = {
    {"signals", "SI", 11, 1, gear_elasticity_signals_low, gear_elasticity_signals_high},
};
static const sinew_argument gear_elasticity_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_gear_resonance(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_gear_resonance(x + 0, x + 11, x + 13, y + 0, y + 1);
}
static const double gear_resonance_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double gear_resonance_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double gear_resonance_shape_low[] = {10.0, 0.01};
static const double gear_resonance_shape_high[] = {400.0, 0.4};
static const double gear_resonance_memory_low[] = {-1.0, -1.0, -1.0};
static const double gear_resonance_memory_high[] = {1.0, 1.0, 1.0};
static const sinew_argument gear_resonance_inputs[] = {
    {"signals", "SI", 11, 1, gear_resonance_signals_low, gear_resonance_signals_high},
    {"shape", "SI", 2, 1, gear_resonance_shape_low, gear_resonance_shape_high},
    {"memory", "1", 3, 1, gear_resonance_memory_low, gear_resonance_memory_high},
};
static const sinew_argument gear_resonance_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 3, 1, 0, 0},
};

static void call_torsion_spring(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_torsion_spring(x + 0, y + 0);
}
static const double torsion_spring_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double torsion_spring_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument torsion_spring_inputs[] = {
    {"signals", "SI", 11, 1, torsion_spring_signals_low, torsion_spring_signals_high},
};
static const sinew_argument torsion_spring_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_offset_drift(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_offset_drift(x + 0, y + 0);
}
static const double offset_drift_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double offset_drift_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const sinew_argument offset_drift_inputs[] = {
    {"signals", "SI", 11, 1, offset_drift_signals_low, offset_drift_signals_high},
};
static const sinew_argument offset_drift_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_cable_torque(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_cable_torque(x + 0, x + 11, y + 0);
}
static const double cable_torque_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double cable_torque_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double cable_torque_shape_low[] = {0.1, 0.1};
static const double cable_torque_shape_high[] = {1.0, 1.0};
static const sinew_argument cable_torque_inputs[] = {
    {"signals", "SI", 11, 1, cable_torque_signals_low, cable_torque_signals_high},
    {"shape", "SI", 2, 1, cable_torque_shape_low, cable_torque_shape_high},
};
static const sinew_argument cable_torque_outputs[] = {
    {"columns", "SI", 8, 1, 0, 0},
};

static void call_cable_torque_cubic(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_cable_torque_cubic(x + 0, x + 11, y + 0);
}
static const double cable_torque_cubic_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double cable_torque_cubic_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double cable_torque_cubic_shape_low[] = {0.1, 0.1};
static const double cable_torque_cubic_shape_high[] = {1.0, 1.0};
static const sinew_argument cable_torque_cubic_inputs[] = {
    {"signals", "SI", 11, 1, cable_torque_cubic_signals_low, cable_torque_cubic_signals_high},
    {"shape", "SI", 2, 1, cable_torque_cubic_shape_low, cable_torque_cubic_shape_high},
};
static const sinew_argument cable_torque_cubic_outputs[] = {
    {"columns", "SI", 4, 1, 0, 0},
};

static void call_inertial_backlash(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_inertial_backlash(x + 0, x + 11, x + 13, y + 0, y + 1);
}
static const double inertial_backlash_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double inertial_backlash_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double inertial_backlash_shape_low[] = {1e-04, 0.1};
static const double inertial_backlash_shape_high[] = {0.03, 0.9};
static const double inertial_backlash_memory_low[] = {-1.0, -1.0, -1.0};
static const double inertial_backlash_memory_high[] = {1.0, 1.0, 1.0};
static const sinew_argument inertial_backlash_inputs[] = {
    {"signals", "SI", 11, 1, inertial_backlash_signals_low, inertial_backlash_signals_high},
    {"shape", "SI", 2, 1, inertial_backlash_shape_low, inertial_backlash_shape_high},
    {"memory", "1", 3, 1, inertial_backlash_memory_low, inertial_backlash_memory_high},
};
static const sinew_argument inertial_backlash_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 3, 1, 0, 0},
};

static void call_loaded_backlash(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_loaded_backlash(x + 0, x + 11, x + 14, y + 0, y + 1);
}
static const double loaded_backlash_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double loaded_backlash_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double loaded_backlash_shape_low[] = {1e-04, 1.1, 0.1};
static const double loaded_backlash_shape_high[] = {0.03, 5.0, 0.9};
static const double loaded_backlash_memory_low[] = {-1.0, -1.0, -1.0};
static const double loaded_backlash_memory_high[] = {1.0, 1.0, 1.0};
static const sinew_argument loaded_backlash_inputs[] = {
    {"signals", "SI", 11, 1, loaded_backlash_signals_low, loaded_backlash_signals_high},
    {"shape", "SI", 3, 1, loaded_backlash_shape_low, loaded_backlash_shape_high},
    {"memory", "1", 3, 1, loaded_backlash_memory_low, loaded_backlash_memory_high},
};
static const sinew_argument loaded_backlash_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 3, 1, 0, 0},
};

static void call_link_elasticity(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_link_elasticity(x + 0, y + 0);
}
static const double link_elasticity_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double link_elasticity_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument link_elasticity_inputs[] = {
    {"signals", "SI", 11, 1, link_elasticity_signals_low, link_elasticity_signals_high},
};
static const sinew_argument link_elasticity_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_link_resonance(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_link_resonance(x + 0, x + 11, x + 13, y + 0, y + 1);
}
static const double link_resonance_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double link_resonance_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double link_resonance_shape_low[] = {10.0, 0.01};
static const double link_resonance_shape_high[] = {400.0, 0.4};
static const double link_resonance_memory_low[] = {-1.0, -1.0, -1.0, -1.0};
static const double link_resonance_memory_high[] = {1.0, 1.0, 1.0, 1.0};
static const sinew_argument link_resonance_inputs[] = {
    {"signals", "SI", 11, 1, link_resonance_signals_low, link_resonance_signals_high},
    {"shape", "SI", 2, 1, link_resonance_shape_low, link_resonance_shape_high},
    {"memory", "1", 4, 1, link_resonance_memory_low, link_resonance_memory_high},
};
static const sinew_argument link_resonance_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 4, 1, 0, 0},
};

static void call_link_backlash(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_link_backlash(x + 0, x + 11, x + 13, y + 0, y + 1);
}
static const double link_backlash_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double link_backlash_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double link_backlash_shape_low[] = {1e-04, 0.1};
static const double link_backlash_shape_high[] = {0.03, 0.9};
static const double link_backlash_memory_low[] = {-1.0, -1.0, -1.0};
static const double link_backlash_memory_high[] = {1.0, 1.0, 1.0};
static const sinew_argument link_backlash_inputs[] = {
    {"signals", "SI", 11, 1, link_backlash_signals_low, link_backlash_signals_high},
    {"shape", "SI", 2, 1, link_backlash_shape_low, link_backlash_shape_high},
    {"memory", "1", 3, 1, link_backlash_memory_low, link_backlash_memory_high},
};
static const sinew_argument link_backlash_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 3, 1, 0, 0},
};

static void call_guiding_friction(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_guiding_friction(x + 0, x + 11, y + 0);
}
static const double guiding_friction_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double guiding_friction_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double guiding_friction_shape_low[] = {0.003};
static const double guiding_friction_shape_high[] = {30.0};
static const sinew_argument guiding_friction_inputs[] = {
    {"signals", "SI", 11, 1, guiding_friction_signals_low, guiding_friction_signals_high},
    {"shape", "SI", 1, 1, guiding_friction_shape_low, guiding_friction_shape_high},
};
static const sinew_argument guiding_friction_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_motor_side_guiding(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_motor_side_guiding(x + 0, x + 11, y + 0);
}
static const double motor_side_guiding_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double motor_side_guiding_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double motor_side_guiding_shape_low[] = {0.003};
static const double motor_side_guiding_shape_high[] = {30.0};
static const sinew_argument motor_side_guiding_inputs[] = {
    {"signals", "SI", 11, 1, motor_side_guiding_signals_low, motor_side_guiding_signals_high},
    {"shape", "SI", 1, 1, motor_side_guiding_shape_low, motor_side_guiding_shape_high},
};
static const sinew_argument motor_side_guiding_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_guiding_presliding(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_guiding_presliding(x + 0, x + 11, x + 13, y + 0, y + 1);
}
static const double guiding_presliding_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double guiding_presliding_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const double guiding_presliding_shape_low[] = {0.003, 3e-06};
static const double guiding_presliding_shape_high[] = {30.0, 0.001};
static const double guiding_presliding_memory_low[] = {-1.0};
static const double guiding_presliding_memory_high[] = {1.0};
static const sinew_argument guiding_presliding_inputs[] = {
    {"signals", "SI", 11, 1, guiding_presliding_signals_low, guiding_presliding_signals_high},
    {"shape", "SI", 2, 1, guiding_presliding_shape_low, guiding_presliding_shape_high},
    {"memory", "1", 1, 1, guiding_presliding_memory_low, guiding_presliding_memory_high},
};
static const sinew_argument guiding_presliding_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 1, 1, 0, 0},
};

static void call_guide_drag(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_guide_drag(x + 0, x + 11, y + 0);
}
static const double guide_drag_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double guide_drag_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double guide_drag_shape_low[] = {0.003};
static const double guide_drag_shape_high[] = {30.0};
static const sinew_argument guide_drag_inputs[] = {
    {"signals", "SI", 11, 1, guide_drag_signals_low, guide_drag_signals_high},
    {"shape", "SI", 1, 1, guide_drag_shape_low, guide_drag_shape_high},
};
static const sinew_argument guide_drag_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_guide_drag_presliding(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_guide_drag_presliding(x + 0, x + 11, x + 13, y + 0, y + 1);
}
static const double guide_drag_presliding_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double guide_drag_presliding_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0,
    1.0, 0.01, 50.0, 10.0, 10000.0};
static const double guide_drag_presliding_shape_low[] = {0.003, 3e-06};
static const double guide_drag_presliding_shape_high[] = {30.0, 0.001};
static const double guide_drag_presliding_memory_low[] = {-1.0};
static const double guide_drag_presliding_memory_high[] = {1.0};
static const sinew_argument guide_drag_presliding_inputs[] = {
    {"signals", "SI", 11, 1, guide_drag_presliding_signals_low, guide_drag_presliding_signals_high},
    {"shape", "SI", 2, 1, guide_drag_presliding_shape_low, guide_drag_presliding_shape_high},
    {"memory", "1", 1, 1, guide_drag_presliding_memory_low, guide_drag_presliding_memory_high},
};
static const sinew_argument guide_drag_presliding_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 1, 1, 0, 0},
};

static void call_force_sensor_scale(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_force_sensor_scale(x + 0, y + 0);
}
static const double force_sensor_scale_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double force_sensor_scale_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument force_sensor_scale_inputs[] = {
    {"signals", "SI", 11, 1, force_sensor_scale_signals_low, force_sensor_scale_signals_high},
};
static const sinew_argument force_sensor_scale_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_force_sensor_offset(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_force_sensor_offset(x + 0, y + 0);
}
static const double force_sensor_offset_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0,
    -1.0, 1e-04, -50.0, 0.001, -10000.0};
static const double force_sensor_offset_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument force_sensor_offset_inputs[] = {
    {"signals", "SI", 11, 1, force_sensor_offset_signals_low, force_sensor_offset_signals_high},
};
static const sinew_argument force_sensor_offset_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_tendon_radius(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_tendon_radius(x + 0, y + 0);
}
static const double tendon_radius_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double tendon_radius_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const sinew_argument tendon_radius_inputs[] = {
    {"signals", "SI", 11, 1, tendon_radius_signals_low, tendon_radius_signals_high},
};
static const sinew_argument tendon_radius_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_routing_offset(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_routing_offset(x + 0, y + 0);
}
static const double routing_offset_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double routing_offset_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0,
    0.01, 50.0, 10.0, 10000.0};
static const sinew_argument routing_offset_inputs[] = {
    {"signals", "SI", 11, 1, routing_offset_signals_low, routing_offset_signals_high},
};
static const sinew_argument routing_offset_outputs[] = {
    {"columns", "SI", 2, 1, 0, 0},
};

static void call_presliding(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_presliding(x + 0, x + 11, x + 12, y + 0, y + 1);
}
static const double presliding_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double presliding_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double presliding_shape_low[] = {1e-08};
static const double presliding_shape_high[] = {0.01};
static const double presliding_memory_low[] = {-1.0};
static const double presliding_memory_high[] = {1.0};
static const sinew_argument presliding_inputs[] = {
    {"signals", "SI", 11, 1, presliding_signals_low, presliding_signals_high},
    {"shape", "SI", 1, 1, presliding_shape_low, presliding_shape_high},
    {"memory", "1", 1, 1, presliding_memory_low, presliding_memory_high},
};
static const sinew_argument presliding_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 1, 1, 0, 0},
};

static void call_soft_reversal(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_soft_reversal(x + 0, x + 11, y + 0);
}
static const double soft_reversal_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double soft_reversal_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double soft_reversal_shape_low[] = {3e-04};
static const double soft_reversal_shape_high[] = {0.02};
static const sinew_argument soft_reversal_inputs[] = {
    {"signals", "SI", 11, 1, soft_reversal_signals_low, soft_reversal_signals_high},
    {"shape", "SI", 1, 1, soft_reversal_shape_low, soft_reversal_shape_high},
};
static const sinew_argument soft_reversal_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
};

static void call_late_reversal(const void *in, void *out)
{
    const double *x = (const double *)in;
    double *y = (double *)out;
    effects_late_reversal(x + 0, x + 11, x + 12, y + 0, y + 1);
}
static const double late_reversal_signals_low[] = {-3.0, -5.0, -50.0, -10000.0, -10.0, 0.0, -1.0,
    1e-04, -50.0, 0.001, -10000.0};
static const double late_reversal_signals_high[] = {3.0, 5.0, 50.0, 10000.0, 10.0, 100.0, 1.0, 0.01,
    50.0, 10.0, 10000.0};
static const double late_reversal_shape_low[] = {1e-07};
static const double late_reversal_shape_high[] = {0.003};
static const double late_reversal_memory_low[] = {-1.0};
static const double late_reversal_memory_high[] = {1.0};
static const sinew_argument late_reversal_inputs[] = {
    {"signals", "SI", 11, 1, late_reversal_signals_low, late_reversal_signals_high},
    {"shape", "SI", 1, 1, late_reversal_shape_low, late_reversal_shape_high},
    {"memory", "1", 1, 1, late_reversal_memory_low, late_reversal_memory_high},
};
static const sinew_argument late_reversal_outputs[] = {
    {"columns", "SI", 1, 1, 0, 0},
    {"next", "1", 1, 1, 0, 0},
};

static const sinew_function functions[] = {
    {"effects_inertia", 1, 1, 11, 1, inertia_inputs, inertia_outputs, call_inertia},
    {"effects_viscous_level", 1, 1, 11, 1, viscous_level_inputs, viscous_level_outputs,
        call_viscous_level},
    {"effects_coulomb_level", 1, 1, 11, 1, coulomb_level_inputs, coulomb_level_outputs,
        call_coulomb_level},
    {"effects_offset", 1, 1, 11, 1, offset_inputs, offset_outputs, call_offset},
    {"effects_viscous_asymmetry", 1, 1, 11, 1, viscous_asymmetry_inputs, viscous_asymmetry_outputs,
        call_viscous_asymmetry},
    {"effects_coulomb_asymmetry", 1, 1, 11, 1, coulomb_asymmetry_inputs, coulomb_asymmetry_outputs,
        call_coulomb_asymmetry},
    {"effects_stribeck", 2, 1, 13, 1, stribeck_inputs, stribeck_outputs, call_stribeck},
    {"effects_concave_friction", 2, 1, 13, 1, concave_friction_inputs, concave_friction_outputs,
        call_concave_friction},
    {"effects_concave_power", 2, 1, 14, 1, concave_power_inputs, concave_power_outputs,
        call_concave_power},
    {"effects_quadratic_friction", 1, 1, 11, 1, quadratic_friction_inputs,
        quadratic_friction_outputs, call_quadratic_friction},
    {"effects_load_friction", 2, 1, 12, 1, load_friction_inputs, load_friction_outputs,
        call_load_friction},
    {"effects_friction_drift", 2, 1, 13, 1, friction_drift_inputs, friction_drift_outputs,
        call_friction_drift},
    {"effects_position_friction", 2, 1, 12, 1, position_friction_inputs, position_friction_outputs,
        call_position_friction},
    {"effects_ripple", 2, 1, 12, 2, ripple_inputs, ripple_outputs, call_ripple},
    {"effects_load_ripple", 2, 1, 12, 2, load_ripple_inputs, load_ripple_outputs, call_load_ripple},
    {"effects_gear_elasticity", 1, 1, 11, 1, gear_elasticity_inputs, gear_elasticity_outputs,
        call_gear_elasticity},
    {"effects_gear_resonance", 3, 2, 16, 4, gear_resonance_inputs, gear_resonance_outputs,
        call_gear_resonance},
    {"effects_torsion_spring", 1, 1, 11, 1, torsion_spring_inputs, torsion_spring_outputs,
        call_torsion_spring},
    {"effects_offset_drift", 1, 1, 11, 1, offset_drift_inputs, offset_drift_outputs,
        call_offset_drift},
    {"effects_cable_torque", 2, 1, 13, 8, cable_torque_inputs, cable_torque_outputs,
        call_cable_torque},
    {"effects_cable_torque_cubic", 2, 1, 13, 4, cable_torque_cubic_inputs,
        cable_torque_cubic_outputs, call_cable_torque_cubic},
    {"effects_inertial_backlash", 3, 2, 16, 4, inertial_backlash_inputs, inertial_backlash_outputs,
        call_inertial_backlash},
    {"effects_loaded_backlash", 3, 2, 17, 4, loaded_backlash_inputs, loaded_backlash_outputs,
        call_loaded_backlash},
    {"effects_link_elasticity", 1, 1, 11, 1, link_elasticity_inputs, link_elasticity_outputs,
        call_link_elasticity},
    {"effects_link_resonance", 3, 2, 17, 5, link_resonance_inputs, link_resonance_outputs,
        call_link_resonance},
    {"effects_link_backlash", 3, 2, 16, 4, link_backlash_inputs, link_backlash_outputs,
        call_link_backlash},
    {"effects_guiding_friction", 2, 1, 12, 1, guiding_friction_inputs, guiding_friction_outputs,
        call_guiding_friction},
    {"effects_motor_side_guiding", 2, 1, 12, 1, motor_side_guiding_inputs,
        motor_side_guiding_outputs, call_motor_side_guiding},
    {"effects_guiding_presliding", 3, 2, 14, 2, guiding_presliding_inputs,
        guiding_presliding_outputs, call_guiding_presliding},
    {"effects_guide_drag", 2, 1, 12, 1, guide_drag_inputs, guide_drag_outputs, call_guide_drag},
    {"effects_guide_drag_presliding", 3, 2, 14, 2, guide_drag_presliding_inputs,
        guide_drag_presliding_outputs, call_guide_drag_presliding},
    {"effects_force_sensor_scale", 1, 1, 11, 1, force_sensor_scale_inputs,
        force_sensor_scale_outputs, call_force_sensor_scale},
    {"effects_force_sensor_offset", 1, 1, 11, 1, force_sensor_offset_inputs,
        force_sensor_offset_outputs, call_force_sensor_offset},
    {"effects_tendon_radius", 1, 1, 11, 1, tendon_radius_inputs, tendon_radius_outputs,
        call_tendon_radius},
    {"effects_routing_offset", 1, 1, 11, 2, routing_offset_inputs, routing_offset_outputs,
        call_routing_offset},
    {"effects_presliding", 3, 2, 13, 2, presliding_inputs, presliding_outputs, call_presliding},
    {"effects_soft_reversal", 2, 1, 12, 1, soft_reversal_inputs, soft_reversal_outputs,
        call_soft_reversal},
    {"effects_late_reversal", 3, 2, 13, 2, late_reversal_inputs, late_reversal_outputs,
        call_late_reversal},
};

const sinew_catalogue effects_catalogue = {"effects",
    "69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f", 8, 38, functions};
