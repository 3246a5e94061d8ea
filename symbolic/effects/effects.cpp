// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

#include <stdexcept>

namespace sinew {

const std::vector<Effect>& effects() {
  static const std::vector<Effect> all{
      inertia(),
      viscous_level(),
      coulomb_level(),
      offset(),
      viscous_asymmetry(),
      coulomb_asymmetry(),
      stribeck(),
      concave_friction(),
      concave_power(),
      quadratic_friction(),
      load_friction(),
      friction_drift(),
      position_friction(),
      ripple(),
      load_ripple(),
      gear_elasticity(),
      gear_resonance(),
      torsion_spring(),
      offset_drift(),
      cable_torque(),
      cable_torque_cubic(),
      inertial_backlash(),
      loaded_backlash(),
      link_elasticity(),
      link_resonance(),
      link_backlash(),
      guiding_friction(),
      motor_side_guiding(),
      guiding_presliding(),
      guide_drag(),
      guide_drag_presliding(),
      force_sensor_scale(),
      force_sensor_offset(),
      tendon_radius(),
      routing_offset(),
      presliding(),
      soft_reversal(),
      late_reversal(),
  };
  return all;
}

const Effect& find_effect(const std::string& id) {
  std::string known;
  for (const Effect& effect : effects()) {
    if (effect.id == id) return effect;
    known += (known.empty() ? "" : ", ") + effect.id;
  }
  throw std::invalid_argument("no effect is called '" + id + "'; expected one of " + known);
}

}  // namespace sinew
