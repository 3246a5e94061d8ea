// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/model/same_mechanism.h"

namespace {

using namespace sinew;

bool same(const Transform& a, const Transform& b) {
  return a.rotation == b.rotation && a.translation == b.translation;
}

bool same(const Body& a, const Body& b) {
  return a.name == b.name && a.source_name == b.source_name && a.mass == b.mass &&
         a.centre_of_mass == b.centre_of_mass && a.inertia == b.inertia;
}

bool same(const Joint& a, const Joint& b) {
  return a.name == b.name && a.source_name == b.source_name && a.type == b.type &&
         a.parent == b.parent && same(a.origin, b.origin) && a.axis == b.axis && a.low == b.low &&
         a.high == b.high && a.max_velocity == b.max_velocity &&
         a.max_acceleration == b.max_acceleration && a.damping == b.damping &&
         a.friction == b.friction && a.friction_speed == b.friction_speed &&
         a.armature == b.armature && a.motor_turn == b.motor_turn &&
         a.motor_poles == b.motor_poles && a.motor_slots == b.motor_slots &&
         a.gear_teeth == b.gear_teeth;
}

bool same(const PulleyRouting& a, const PulleyRouting& b) {
  return a.joint == b.joint && a.radius == b.radius;
}

bool same(const StraightRouting& a, const StraightRouting& b) {
  return a.from_body == b.from_body && a.from == b.from && a.to_body == b.to_body && a.to == b.to;
}

bool same(const JointCoupling& a, const JointCoupling& b) {
  return a.dependent == b.dependent && a.independent == b.independent && a.ratio == b.ratio &&
         a.offset == b.offset;
}

bool same(const Frame& a, const Frame& b) {
  return a.name == b.name && a.body == b.body && same(a.pose, b.pose);
}

bool same(const Tendon& a, const Tendon& b);

template <typename Item>
bool all_same(const std::vector<Item>& a, const std::vector<Item>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(a[i], b[i])) return false;
  return true;
}

bool same(const Tendon& a, const Tendon& b) {
  return a.name == b.name && a.h0 == b.h0 && all_same(a.pulleys, b.pulleys) &&
         all_same(a.straights, b.straights);
}

}  // namespace

std::string first_difference(const Mechanism& a, const Mechanism& b) {
  if (a.name != b.name || a.description != b.description) return "name or description";
  if (a.gravity != b.gravity) return "gravity";
  if (!all_same(a.bodies, b.bodies)) return "bodies";
  if (!all_same(a.joints, b.joints)) return "joints";
  if (!all_same(a.tendons, b.tendons)) return "tendons";
  if (!all_same(a.couplings, b.couplings)) return "couplings";
  if (!all_same(a.frames, b.frames)) return "frames";
  if (a.tendon_stiffness_low != b.tendon_stiffness_low ||
      a.tendon_stiffness_high != b.tendon_stiffness_high ||
      a.tendon_force_high != b.tendon_force_high)
    return "tendon defaults";
  for (const auto& [path, from] : a.provenance)
    if (!b.provenance.contains(path) || b.provenance.at(path) != from)
      return "provenance of " + path;
  return a.provenance.size() == b.provenance.size() ? "" : "number of provenances";
}
