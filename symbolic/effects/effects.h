// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue of effects: one file each, one line here.
#pragma once

#include "symbolic/effects/effect.h"

namespace sinew {

Effect inertia();
Effect viscous_level();
Effect coulomb_level();
Effect offset();
Effect viscous_asymmetry();
Effect coulomb_asymmetry();
Effect stribeck();
Effect concave_friction();
Effect concave_power();
Effect quadratic_friction();
Effect load_friction();
Effect friction_drift();
Effect position_friction();
Effect ripple();
Effect load_ripple();
Effect gear_elasticity();
Effect gear_resonance();
Effect torsion_spring();
Effect offset_drift();
Effect cable_torque();
Effect cable_torque_cubic();
Effect inertial_backlash();
Effect loaded_backlash();
// In the gear of a joint that carries links:
Effect link_elasticity();
Effect link_resonance();
Effect link_backlash();
// At a tendon:
Effect guiding_friction();
Effect motor_side_guiding();
Effect guiding_presliding();
Effect guide_drag();
Effect guide_drag_presliding();
Effect force_sensor_scale();
Effect force_sensor_offset();
Effect tendon_radius();
Effect routing_offset();
// How the model's own friction turns:
Effect presliding();
Effect soft_reversal();
Effect late_reversal();

/// All effects, in a fixed order.
const std::vector<Effect>& effects();

/// The effect of that identifier. Throws std::invalid_argument naming those there are.
const Effect& find_effect(const std::string& id);

}  // namespace sinew
