// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/limits.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sinew::trials {

const std::vector<Limit>& limits() {
  static const std::vector<Limit> table = {
      {"coulomb_level", -0.8, 4.0, "friction", "run in, or run dry: a fifth to five times"},
      {"viscous_level", -0.8, 9.0, "damping", "grease between 60 and -10 degrees C: tenfold"},
      {"viscous_asymmetry", -0.9, 0.9, "damping", "neither direction may drive"},
      {"coulomb_asymmetry", -0.9, 0.9, "friction", "neither direction may drive"},
      {"stribeck", 0.0, 2.0, "friction", "dry gears break away at up to three times"},
      {"concave_friction", 0.0, 3.0, "friction", "mixed lubrication over the range of speeds"},
      {"load_friction", 0.0, 0.6, "1", "an efficiency of 40 % is a bad worm gear"},
      {"friction_drift", -0.75, 2.0, "friction", "cold start at 0, steady at 70 degrees C"},
      {"position_friction", -0.9, 0.9, "friction", "nowhere below nothing"},
      {"input_ripple", 0.0, 1.0, "effort", "cogging as large as the work"},
      {"output_ripple", 0.0, 1.0, "effort", "an output bearing that binds once a turn"},
      {"load_ripple", 0.0, 0.5, "1", "a gear's transmission swings by half"},
      {"inertia", -0.6, 6.0, "inertia", "a rotor left out; a tool that is not in the model"},
      {"torque_constant", -0.45, 0.75, "1",
       "magnets at 150 degrees C; peak for rms, delta for star"},
      {"offset", -1.0, 1.0, "effort", "beyond it the amplifier is at its limit"},
      {"gear_elasticity", 0.0, 1.0, "softest gear", "below 4 Hz it is a rubber band"},
      {"backlash", 0.0, 0.02, "range", "a worn gear: a degree or two"},
      {"delay", 0.0, 0.02, "s", "ten periods of a slow bus; no loop holds with more"},
      {"spring", 0.0, 2.0, "effort over range", "stronger, and it is the load"},
      {"cable_torque", -1.0, 1.0, "effort", "a cable package as strong as the work"},
      {"sensor_scale", -0.3, 0.3, "1", "a wrong count of lines shows as 2, not as 1.3"},
      {"sensor_offset", -0.35, 0.35, "rad or range", "a homing mark is off by 20 degrees at most"},
      {"sensor_low_pass", 0.0, 0.03, "s", "a filter of 5 Hz is seen by the eye"},
      {"sensor_quantisation", 0.0, 0.01, "range", "seven bits over the range"},
      {"sensor_hysteresis", 0.0, 0.03, "range", "a loose coupling of the encoder"},
      {"payload", 0.0, 3.0, "mass of the last link", "a tool and what it holds"},
      {"link_mass", -0.6, 1.5, "mass of the link", "CAD without screws and cables, or twice"},
      {"link_centre", 0.0, 0.5, "centre's distance", "a motor on one side of the link, not drawn"},
      {"link_products", 0.0, 0.79, "rad", "principal axes turned by 45 degrees"},
      {"gravity", 0.0, 3.14, "rad", "mounted the other way up"},
      {"gravity_left_out", 0.0, 9.81, "m/s^2",
       "the earth's; less where springs or the mounting take up the rest"},
      {"coupling_ratio", -0.35, 0.35, "1", "the next size of pulley"},
      {"pulley_radius", -0.35, 0.35, "1", "the next size of pulley"},
      {"tendon_radius", -0.35, 0.35, "1", "one tendon on the next size of pulley"},
      {"routing_offset", -1.0, 1.0, "radius", "a guide off by the radius of its pulley"},
      {"guiding_friction", 0.0, 0.45, "1", "dry steel on aluminium, by radian"},
      {"force_sensor_scale", -0.3, 0.3, "1", "beyond it a gain switch is wrong"},
      {"force_sensor_offset", -0.5, 0.5, "tension", "half of the pretension"},
      {"spring_constant", -0.5, 1.0, "1", "another spring of the same series"},
      {"preload_offset", 0.0, 3.0, "mm", "the thread of the adjuster"},
      {"lever_hysteresis", 0.0, 0.4, "force", "a rubber damper"},
      {"series_tendon", 0.0, 1.0e-4, "m/N", "a metre of aramid cord"},
      {"slack", 0.0, 4.0, "mm", "a knot that has set"},
      {"lever_scale", -0.3, 0.3, "1", "another magnet"},
      {"lever_offset", -0.1, 0.1, "counts", "a tenth of the travel"},
      {"wrist_coupling", 0.0, 1.0, "1", "all of the coupling"},
      {"wrist_zero", -0.35, 0.35, "rad", "a palm set by the eye is within 20 degrees"},
      {"contact_shift", 0.0, 6.0, "mm", "the guide's own radius"},
      {"unlogged_force", 0.0, 2.0, "effort", "a knock is soon stronger than the work"},
      // Outside: as strong as what they disturb.
      {"speed_memory", 0.0, 2.0, "friction", "grease that was thrown off comes back slowly"},
      {"latch", 0.0, 1.0, "effort", "a detent with half of the work's torque each way"},
      {"other_stage", 0.0, 1.0, "effort", "an eccentric wheel of another stage"},
      {"supply_sag", 0.0, 0.6, "1", "a battery at its end gives 40 % at full load"},
      {"tight_under_load", 0.0, 0.6, "1", "a bent shaft binds by its load"},
      {"filling", -0.8, 4.0, "inertia", "a vessel is filled, or emptied"},
      {"handling", -0.8, 4.0, "inertia", "something is taken up and put down again"},
      {"grease", 0.0, 5.0, "viscous friction", "stiff grease in the cold, until it has moved"},
      {"debris", 0.0, 2.0, "friction", "a chip between two teeth"},
      {"foldback", 0.0, 0.6, "1", "an amplifier protects itself with 40 % of its current"},
      {"contact", 0.0, 20.0, "effort over range", "a soft bumper that is not always there"},
      {"coarse_command", 0.0, 0.5, "effort", "six bits of a converter"},
      {"saturation", 0.0, 0.98, "1", "the amplifier's knee at the peak effort"},
      {"heat", 0.0, 0.5, "1", "half of the torque is lost at the limit of the winding"},
      {"outer_force", 0.0, 1.0, "effort", "somebody leans on it"},
      {"loose_motor", 0.0, 1.5, "rad", "a grub screw on a flat of its shaft"},
  };
  return table;
}

const Limit& limit_of(const std::string& cause) {
  for (const Limit& limit : limits())
    if (cause == limit.cause) return limit;
  throw std::out_of_range("the table of physical limits has no '" + cause + "'");
}

std::string limits_text() {
  std::string text = "| cause | from | to | times | because |\n| --- | --- | --- | --- | --- |\n";
  for (const Limit& l : limits())
    text += fmt::format("| `{}` | {:g} | {:g} | {} | {} |\n", l.cause, l.least, l.most, l.per,
                        l.reason);
  return text;
}

}  // namespace sinew::trials
