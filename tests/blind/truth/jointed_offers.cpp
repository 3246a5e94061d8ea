// SPDX-License-Identifier: GPL-3.0-or-later
// What may be hidden at an axis and in the bodies.
#include "tests/blind/truth/jointed.h"

#include <cmath>

namespace sinew::trials {
namespace {

/// The lowest order of a ripple of which motions show half a period; 0: none up to 6, or no turns.
int lowest_order(const AxisModel& m) {
  if (m.output_turn <= 0.0) return 0;
  const int order = static_cast<int>(std::ceil(0.25 * m.output_turn / m.range));
  return order <= 6 ? order : 0;
}

}  // namespace

void offer_axis(const Jointed& jointed, std::size_t axis, const std::string& place, bool drive,
                bool loaded, std::vector<Offer>& offers) {
  const AxisModel& m = jointed.axes[axis];
  const int at = static_cast<int>(axis);
  const auto offer = [&](const char* cause, double scale, const char* parameter = "",
                         unsigned fitted = fits_all, double factor = 1.0, int order = 0) {
    offers.push_back({cause, place, at, scale, false, fitted, parameter, factor, order});
  };
  const auto outside = [&](const char* cause, double scale) {
    offers.push_back({cause, place, at, scale, true, fits_all, "", 1.0, 0});
  };
  offer("coulomb_level", m.level, "level_change", fits_all & ~fits_coulomb);
  offer("viscous_level", m.viscous, "viscous_change", fits_all & ~fits_viscous);
  offer("viscous_asymmetry", m.viscous, "difference");
  offer("coulomb_asymmetry", m.level, "difference");
  offer("stribeck", m.level);
  offer("concave_friction", m.level);
  offer("friction_drift", m.level);
  if (loaded) offer("load_friction", 1.0, "share");
  if (loaded) outside("tight_under_load", 1.0);
  if (drive) {
    offer("inertia", m.inertia, "inertia_change", fits_all & ~fits_inertia);
    offer("offset", m.effort, "offset", fits_all & ~fits_offset);
    // Values of the model itself: only how friction turns is fitted beside them.
    offer("torque_constant", 1.0, "gain_change", fits_turning);
    offer("sensor_scale", 1.0, "scale_error", fits_turning);
    offer("delay", 1.0, "delay", fits_turning);
    for (const int order : {1, 24}) offer("input_ripple", m.effort, "", fits_all, 1.0, order);
    if (const int order = lowest_order(m); order > 0)
      offer("output_ripple", m.effort, "", fits_all, 1.0, order);
    if (loaded) offer("load_ripple", 1.0, "", fits_all, 1.0, 1);
    offer("gear_elasticity", 1.0);
    offer("backlash", 2.0 * m.range);
    offer("sensor_low_pass", 1.0, "time_constant", fits_turning);
    offer("sensor_quantisation", 2.0 * m.range);
    offer("sensor_hysteresis", 2.0 * m.range, "half_play", fits_all, 0.5);
    outside("other_stage", m.effort);
    outside("coarse_command", m.effort);
    outside("foldback", 1.0);
  }
  if (jointed.carries) {
    offer("spring", m.effort / m.range, "stiffness");
    offer("cable_torque", m.effort);
    offer("position_friction", m.level, "slope", fits_all, 1.0 / m.range);
  }
  offer("unlogged_force", m.effort);
  outside("speed_memory", m.level);
  outside("latch", m.effort);
  outside("handling", m.inertia);
  outside("grease", m.viscous);
  outside("debris", m.level);
}

void offer_links(const Jointed& jointed, bool products, std::vector<Offer>& offers) {
  const auto& links = jointed.chain.links;
  const auto last = static_cast<int>(links.size()) - 1;
  const auto offer = [&](const char* cause, int at, double scale, const char* parameter, int sign) {
    offers.push_back({cause, "link " + links[static_cast<std::size_t>(at)].name, at, scale, false,
                      fits_all, parameter, 1.0, 0, sign});
  };
  offer("payload", last, links.back().mass, "mass", 0);
  for (int i = 0; i <= last; ++i) {
    const Link& link = links[static_cast<std::size_t>(i)];
    // What the last link has more of than the model is a payload.
    offer("link_mass", i, link.mass, "mass", i == last ? -1 : 0);
    // Alone, a link's products of inertia act on nothing, and its centre is its weight's.
    if (links.size() == 1) continue;
    if (link.com.norm() > 0.0) offer("link_centre", i, link.com.norm(), "", 0);
    if (products) offer("link_products", i, 1.0, "", 0);
  }
}

void offer_gravity(const Jointed& jointed, std::vector<Offer>& offers) {
  const char* cause = jointed.chain.gravity.isZero() ? "gravity_left_out" : "gravity";
  offers.push_back({cause, "base", 0, 1.0, false, fits_all, "", 1.0, 0});
}

}  // namespace sinew::trials
