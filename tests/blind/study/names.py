# SPDX-License-Identifier: GPL-3.0-or-later
"""What a findings.json calls a cause, and what the trials call it. A name that is not here is no cause of
the trials and counts as wrong wherever it is told."""
import re

CAUSES = {
    "Coulomb friction level": "coulomb_level",
    "viscous friction level": "viscous_level",
    "viscous asymmetry": "viscous_asymmetry",
    "Coulomb friction asymmetry": "coulomb_asymmetry",
    "Stribeck friction": "stribeck",
    "friction concave in speed": "concave_friction",
    "load-dependent friction": "load_friction",
    "slow drift of friction": "friction_drift",
    "friction that varies with position": "position_friction",
    "gear elasticity": "gear_elasticity",
    "backlash": "backlash",
    "spring towards a position": "spring",
    "position-dependent cable torque": "cable_torque",
    "inertia": "inertia",
    "offset": "offset",
    "torque constant": "torque_constant",
    "delay": "delay",
    "pulley radius": "pulley_radius",
    "payload": "payload",
    "inertial parameters": "inertial_parameters",
    "gravity left out": "gravity",
    "direction of gravity": "gravity",
    "low-pass of the position sensor": "sensor_low_pass",
    "scale of the position sensor": "sensor_scale",
    "zero offset of the position sensor": "sensor_offset",
    "quantisation of the position sensor": "sensor_quantisation",
    "hysteresis of the position sensor": "sensor_hysteresis",
    "guiding friction": "guiding_friction",
    "scale of the force sensor": "force_sensor_scale",
    "offset of the force sensor": "force_sensor_offset",
    "radius of one tendon's pulley": "tendon_radius",
    "routing offset": "routing_offset",
    "ratio of coupled joints": "coupling_ratio",
    "unlogged force": "unlogged_force",
    "low-pass of the lever sensor": "sensor_low_pass",
    "hysteresis of the lever sensor": "sensor_hysteresis",
    "low-pass of the angle sensor": "sensor_low_pass",
    "hysteresis of the angle sensor": "sensor_hysteresis",
    "spring constant": "spring_constant",
    "preload offset": "preload_offset",
    "lever hysteresis": "lever_hysteresis",
    "tendon in series": "series_tendon",
    "slack": "slack",
    "scale of the lever sensor": "lever_scale",
    "offset of the lever sensor": "lever_offset",
    "quantisation of the lever sensor": "sensor_quantisation",
    "guiding friction (capstan law)": "guiding_friction",
    "guiding friction (fitted law)": "guiding_friction",
    "coupling left uncompensated": "wrist_coupling",
    "zero offset": "wrist_zero",
    "contact-point shift": "contact_shift",
    "scale of the angle sensor": "sensor_scale",
    "quantisation of the angle sensor": "sensor_quantisation",
}
RIPPLE = re.compile(r"ripple (once|(\d+) times) per (motor|output) turn")
LOAD_RIPPLE = re.compile(r"ripple proportional to load, (once|(\d+) times) per (motor|output) turn")


def key(name, place):
    """(cause, order, place) of a member of a set. At a wrist one motor's pulley is one tendon's radius."""
    found = RIPPLE.fullmatch(name)
    if found:
        side = "input_ripple" if found[3] == "motor" else "output_ripple"
        return side, int(found[2] or 1), place
    found = LOAD_RIPPLE.fullmatch(name)
    if found:
        return "load_ripple", int(found[2] or 1), place
    cause = CAUSES.get(name, "unknown: " + name)
    if cause == "pulley_radius" and place.startswith("motor "):
        cause = "tendon_radius"
    return cause, 0, place


# What is wrong with a link goes by one name, and so does gravity: a model that has none lacks it.
HIDDEN = {"link_mass": "inertial_parameters", "link_centre": "inertial_parameters",
          "link_products": "inertial_parameters", "gravity_left_out": "gravity"}


def hidden_key(hidden):
    return HIDDEN.get(hidden["cause"], hidden["cause"]), hidden.get("order", 0), hidden["place"]
