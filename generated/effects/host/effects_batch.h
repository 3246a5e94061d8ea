/* SPDX-License-Identifier: BSD-2-Clause
 *
 * For a host with vector instructions: the functions of the model effects over many states; element
 *     k of state i is at [k * count + i].
 *
 * Made by: sinew generate models/effects
 * Model:   sha256 69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_effects_BATCH_H
#define SINEW_effects_BATCH_H

#ifndef SINEW_RESTRICT
#ifdef __cplusplus
#define SINEW_RESTRICT
#else
#define SINEW_RESTRICT restrict
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

void effects_inertia_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_viscous_level_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_coulomb_level_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_offset_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_viscous_asymmetry_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_coulomb_asymmetry_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_stribeck_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_concave_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_concave_power_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_quadratic_friction_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_load_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_friction_drift_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_position_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_ripple_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_load_ripple_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_gear_elasticity_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_gear_resonance_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_torsion_spring_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_offset_drift_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_cable_torque_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_cable_torque_cubic_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_inertial_backlash_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_loaded_backlash_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_link_elasticity_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_link_resonance_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_link_backlash_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_guiding_friction_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_motor_side_guiding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_guiding_presliding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_guide_drag_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_guide_drag_presliding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_force_sensor_scale_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_force_sensor_offset_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_tendon_radius_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_routing_offset_batch(int count, const double *SINEW_RESTRICT signals,
    double *SINEW_RESTRICT columns);
void effects_presliding_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);
void effects_soft_reversal_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, double *SINEW_RESTRICT columns);
void effects_late_reversal_batch(int count, const double *SINEW_RESTRICT signals,
    const double *SINEW_RESTRICT shape, const double *SINEW_RESTRICT memory,
    double *SINEW_RESTRICT columns, double *SINEW_RESTRICT next);

#ifdef __cplusplus
}
#endif
#endif
