/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Regressors of the effects that a diagnosis looks for
 *
 * Made by: sinew generate models/effects
 * Model:   sha256 69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_EFFECTS_H
#define SINEW_EFFECTS_H

/* SI units; matrices row-major. Results are finite for every finite input. */

#ifndef SINEW_AT_LEAST
#ifdef __cplusplus
#define SINEW_AT_LEAST(n) n
#else
#define SINEW_AT_LEAST(n) static n
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Terms of the effect 'inertia', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] inertia_change
 * 0 multiplications, 0 additions. */
void effects_inertia(const double signals[SINEW_AT_LEAST(11)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'viscous friction level', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] viscous_change
 * 0 multiplications, 0 additions. */
void effects_viscous_level(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'Coulomb friction level', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] level_change
 * 0 multiplications, 0 additions. */
void effects_coulomb_level(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'offset', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] offset
 * 0 multiplications, 0 additions. */
void effects_offset(const double signals[SINEW_AT_LEAST(11)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'viscous asymmetry', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] difference
 * 0 multiplications, 0 additions, 1 other functions. */
void effects_viscous_asymmetry(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'Coulomb friction asymmetry', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] difference
 * 0 multiplications, 0 additions, 1 other functions. */
void effects_coulomb_asymmetry(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'Stribeck friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] stribeck_velocity, turning_share; made for 0.01..0.3, 0.05..1
 *   out columns       1 [SI] extra_at_rest
 * 4 multiplications, 2 additions, 2 divisions, 3 other functions. */
void effects_stribeck(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'friction concave in speed', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] bend, sharpness; made for 0.03..1, 1..4
 *   out columns       1 [SI] plateau
 * 4 multiplications, 1 additions, 2 divisions, 6 other functions. */
void effects_concave_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'friction concave in speed', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         3 [SI] top_speed, power, turning_share; made for 1..1, 0.2..0.8, 0.05..1
 *   out columns       1 [SI] at_top_speed
 * 3 multiplications, 2 additions, 2 divisions, 6 other functions. */
void effects_concave_power(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(3)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'friction quadratic in speed', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] coefficient
 * 1 multiplications, 0 additions, 1 other functions. */
void effects_quadratic_friction(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'load-dependent friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] turning_share; made for 0.05..1
 *   out columns       1 [SI] share
 * 2 multiplications, 2 additions, 1 divisions, 3 other functions. */
void effects_load_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'slow drift of friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] time_constant, turning_share; made for 0.05..2, 0.05..1
 *   out columns       1 [SI] change
 * 2 multiplications, 3 additions, 2 divisions, 3 other functions. */
void effects_friction_drift(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'friction that varies with position', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] turning_share; made for 0.05..1
 *   out columns       1 [SI] slope
 * 2 multiplications, 2 additions, 1 divisions, 2 other functions. */
void effects_position_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'ripple', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] wavenumber; made for 1..1000
 *   out columns       2 [SI] sine, cosine
 * 1 multiplications, 0 additions, 1 sincos. */
void effects_ripple(const double signals[SINEW_AT_LEAST(11)], const double shape[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(2)]);

/* Terms of the effect 'ripple proportional to load', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] wavenumber; made for 1..1000
 *   out columns       2 [SI] sine, cosine
 * 3 multiplications, 0 additions, 1 sincos. */
void effects_load_ripple(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(2)]);

/* Terms of the effect 'gear elasticity', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] compliance_term
 * 0 multiplications, 0 additions. */
void effects_gear_elasticity(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'gear elasticity', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] natural_frequency, damping_ratio; made for 10..400, 0.01..0.4
 *   in  memory        3 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] inertia_behind_spring
 *   out next          3 [1] states for the next sample
 * 24 multiplications, 12 additions, 1 divisions. */
void effects_gear_resonance(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)]);

/* Terms of the effect 'spring towards a position', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] stiffness
 * 0 multiplications, 0 additions. */
void effects_torsion_spring(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'drift of the offset', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] rate
 * 0 multiplications, 0 additions. */
void effects_offset_drift(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'position-dependent cable torque', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] middle, half_range; made for 0.1..1
 *   out columns       8 [SI] degree_0, degree_1, degree_2, degree_3, degree_4, degree_5, degree_6,
 *     degree_7
 * 6 multiplications, 16 additions, 1 divisions, 2 other functions. */
void effects_cable_torque(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(8)]);

/* Terms of the effect 'position-dependent cable torque', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] middle, half_range; made for 0.1..1
 *   out columns       4 [SI] degree_0, degree_1, degree_2, degree_3
 * 2 multiplications, 5 additions, 1 divisions, 2 other functions. */
void effects_cable_torque_cubic(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], double columns[SINEW_AT_LEAST(4)]);

/* Terms of the effect 'backlash', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] gap, restitution; made for 0.0001..0.03, 0.1..0.9
 *   in  memory        3 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] inertia_behind_gap
 *   out next          3 [1] states for the next sample
 * 4 multiplications, 6 additions, 2 divisions, 4 other functions. */
void effects_inertial_backlash(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)]);

/* Terms of the effect 'backlash', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         3 [SI] gap, mobility, restitution; made for 0.0001..0.03, 1.1..5, 0.1..0.9
 *   in  memory        3 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] inertia_behind_gap
 *   out next          3 [1] states for the next sample
 * 6 multiplications, 7 additions, 2 divisions, 5 other functions. */
void effects_loaded_backlash(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(3)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)]);

/* Terms of the effect 'gear elasticity', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] compliance_term
 * 1 multiplications, 0 additions. */
void effects_link_elasticity(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'gear elasticity', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] natural_frequency, damping_ratio; made for 10..400, 0.01..0.4
 *   in  memory        4 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] share_behind_spring
 *   out next          4 [1] states for the next sample
 * 31 multiplications, 16 additions, 2 divisions. */
void effects_link_resonance(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(4)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(4)]);

/* Terms of the effect 'backlash', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] gap, restitution; made for 0.0001..0.03, 0.1..0.9
 *   in  memory        3 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] share_behind_gap
 *   out next          3 [1] states for the next sample
 * 6 multiplications, 7 additions, 2 divisions, 5 other functions. */
void effects_link_backlash(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(3)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(3)]);

/* Terms of the effect 'guiding friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] bending_elsewhere; made for 0.003..30
 *   out columns       1 [SI] friction_coefficient
 * 2 multiplications, 1 additions. */
void effects_guiding_friction(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'guiding friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] bending_elsewhere; made for 0.003..30
 *   out columns       1 [SI] friction_coefficient
 * 2 multiplications, 1 additions. */
void effects_motor_side_guiding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'guiding friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] bending_elsewhere, presliding_length; made for 0.003..30, 3e-06..0.001
 *   in  memory        1 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] friction_coefficient
 *   out next          1 [1] states for the next sample
 * 5 multiplications, 5 additions, 1 divisions, 3 other functions. */
void effects_guiding_presliding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'guiding friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] bending_elsewhere; made for 0.003..30
 *   out columns       1 [SI] friction_force
 * 1 multiplications, 1 additions. */
void effects_guide_drag(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'guiding friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         2 [SI] bending_elsewhere, presliding_length; made for 0.003..30, 3e-06..0.001
 *   in  memory        1 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] friction_force
 *   out next          1 [1] states for the next sample
 * 4 multiplications, 5 additions, 1 divisions, 3 other functions. */
void effects_guide_drag_presliding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(2)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'scale of the force sensor', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] force_excess
 * 0 multiplications, 0 additions. */
void effects_force_sensor_scale(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'offset of the force sensor', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] force_offset
 * 0 multiplications, 0 additions. */
void effects_force_sensor_offset(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'radius of one tendon's pulley', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       1 [SI] radius_change
 * 0 multiplications, 0 additions. */
void effects_tendon_radius(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'routing offset', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   out columns       2 [SI] offset_across, offset_along
 * 2 multiplications, 0 additions, 1 sincos. */
void effects_routing_offset(const double signals[SINEW_AT_LEAST(11)],
    double columns[SINEW_AT_LEAST(2)]);

/* Terms of the effect 'presliding of friction', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] presliding_length; made for 1e-08..0.01
 *   in  memory        1 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] level
 *   out next          1 [1] states for the next sample
 * 3 multiplications, 4 additions, 1 divisions, 3 other functions. */
void effects_presliding(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'softness of friction at reversals', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] turning_speed; made for 0.0003..0.02
 *   out columns       1 [SI] softness
 * 0 multiplications, 1 additions, 1 divisions, 2 other functions. */
void effects_soft_reversal(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], double columns[SINEW_AT_LEAST(1)]);

/* Terms of the effect 'bristles of friction at reversals', to be multiplied by its coefficients.
 *   in  signals      11 [SI] position, velocity, acceleration, its second derivative, load, time,
 *     direction, step, parting, carried inertia, carried jounce; made for -3..3, -5..5, -50..50,
 *     -1e+04..1e+04, -10..10, 0..100, -1..1, 0.0001..0.01, ...
 *   in  shape         1 [SI] bristle_length; made for 1e-07..0.003
 *   in  memory        1 [1] before this sample; 0 before the first; made for -1..1
 *   out columns       1 [SI] level
 *   out next          1 [1] states for the next sample
 * 4 multiplications, 5 additions, 1 divisions, 5 other functions. */
void effects_late_reversal(const double signals[SINEW_AT_LEAST(11)],
    const double shape[SINEW_AT_LEAST(1)], const double memory[SINEW_AT_LEAST(1)],
    double columns[SINEW_AT_LEAST(1)], double next[SINEW_AT_LEAST(1)]);

#ifdef __cplusplus
}
#endif
#endif
