// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/identified_mechanism.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <stdexcept>

#include "symbolic/files/description_error.h"
#include "symbolic/model/pseudo_inertia.h"

namespace sinew {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

double entry_sum(const IdentifiedEffect& entry, const std::string& name) {
  double sum = 0.0;
  for (const IdentifiedValue& v : entry.coefficients) sum += v.name == name ? v.value : 0.0;
  return sum;
}

Vector3d first_moments_of(const IdentifiedEffect& entry) {
  return {entry_sum(entry, "first_moment_x"), entry_sum(entry, "first_moment_y"),
          entry_sum(entry, "first_moment_z")};
}

bool has_moments(const IdentifiedEffect& entry) {
  return std::any_of(entry.coefficients.begin(), entry.coefficients.end(),
                     [](const IdentifiedValue& v) { return v.name.rfind("moment_", 0) == 0; });
}

/// gravity_change_x, _y or _z; those that are not given do not change.
Vector3d changed_axis(const std::string& coefficient) {
  const char* names[] = {"gravity_change_x", "gravity_change_y", "gravity_change_z"};
  for (int k = 0; k < 3; ++k)
    if (coefficient == names[k]) return Vector3d::Unit(k);
  throw std::invalid_argument("identified.toml: gravity has no coefficient '" + coefficient + "'");
}

[[noreturn]] void refuse(const IdentifiedEffect& entry, const std::string& wrong,
                         const std::string& expected) {
  const std::string where =
      entry.where.line > 0 ? to_text(entry.where) : std::string("identified.toml");
  throw DescriptionError({fmt::format("{}: {}; {}", where, wrong, expected)});
}

/// A link of another mass and centre that keeps its shape: its inertia about its centre goes with
/// its mass.
Matrix4d keeping_shape(const IdentifiedEffect& entry, const Body& body) {
  Body changed = body;
  const Matrix4d before = body_pseudo_inertia(body);
  changed.mass += entry_sum(entry, "mass");
  if (!(changed.mass > 0.0) || !(body.mass > 0.0)) return pseudo_inertia_of(entry);
  changed.centre_of_mass =
      (body.mass * body.centre_of_mass + first_moments_of(entry)) / changed.mass;
  changed.inertia *= changed.mass / body.mass;
  return body_pseudo_inertia(changed) - before;
}

Matrix4d change_of(const IdentifiedEffect& entry, const Body& body) {
  return entry.effect == "payload" || has_moments(entry) ? pseudo_inertia_of(entry)
                                                         : keeping_shape(entry, body);
}

/// A sensor that reads `zero_offset` too much: the joint's zero is where it reads that. Throws
/// where another joint moves with its coordinate.
void move_zero(const IdentifiedEffect& entry, Mechanism& mechanism) {
  const auto joint = std::find_if(mechanism.joints.begin(), mechanism.joints.end(),
                                  [&](const Joint& j) { return j.name == entry.place; });
  if (joint == mechanism.joints.end())
    refuse(entry, fmt::format("there is no joint '{}'", entry.place),
           "expected a joint of the model");
  const auto couples = [&](const auto& c) {
    return c.dependent == entry.place || c.independent == entry.place;
  };
  if (std::any_of(mechanism.couplings.begin(), mechanism.couplings.end(), couples) ||
      std::any_of(mechanism.four_bars.begin(), mechanism.four_bars.end(), couples))
    refuse(entry, fmt::format("joint '{}' is coupled with another one", entry.place),
           "expected the zero offset of a joint that moves alone");
  const double back = -entry_sum(entry, "zero_offset");
  Transform& origin = joint->origin;
  if (joint->type == JointType::prismatic)
    origin.translation += origin.rotation * (back * joint->axis);
  else
    origin.rotation = origin.rotation * Eigen::AngleAxisd(back, joint->axis).toRotationMatrix();
}

/// What the entries change of one body.
struct BodyChange {
  Matrix4d J = Matrix4d::Zero();
  const IdentifiedEffect* last = nullptr;
};

void change_body(const BodyChange& change, Body& body) {
  const Matrix4d J = body_pseudo_inertia(body) + change.J;
  if (!(J(3, 3) > 0.0))
    refuse(*change.last,
           fmt::format("what was learnt leaves link '{}' without mass: {:.4g} kg of {:.4g} kg",
                       body.name, J(3, 3), body.mass),
           "expected a change that leaves some");
  // A described inertia may be given as it was identified elsewhere, and be none that a body has;
  // what is a body itself makes it no worse.
  if (!is_physical(J) && !is_physical(change.J))
    refuse(*change.last,
           fmt::format("no body has the mass properties that link '{}' would have: its "
                       "pseudo-inertia is not positive definite",
                       body.name),
           "expected moments of inertia that belong to some distribution of the mass");
  set_pseudo_inertia(J, body);
}

}  // namespace

bool changes_link(const IdentifiedEffect& entry) {
  return entry.effect == "payload" || entry.effect == "inertial_parameters";
}

bool changes_mechanism(const IdentifiedEffect& entry) {
  return changes_link(entry) || entry.effect == "gravity" || entry.effect == "sensor_offset";
}

Identified mechanism_changes(const Identified& before, const Identified& after) {
  Identified changes;
  for (const IdentifiedEffect& entry : after.effects)
    if (changes_mechanism(entry)) changes.effects.push_back(entry);
  for (const IdentifiedEffect& entry : before.effects) {
    if (!changes_mechanism(entry)) continue;
    IdentifiedEffect undone = entry;
    for (IdentifiedValue& value : undone.coefficients) value.value = -value.value;
    changes.effects.push_back(std::move(undone));
  }
  return changes;
}

Matrix4d pseudo_inertia_of(const IdentifiedEffect& entry) {
  const double mass = entry_sum(entry, "mass");
  const Vector3d first = first_moments_of(entry);
  if (!has_moments(entry) && mass != 0.0) return point_pseudo_inertia(mass, first);
  Matrix3d moments;
  moments << entry_sum(entry, "moment_xx"), entry_sum(entry, "moment_xy"),
      entry_sum(entry, "moment_xz"), entry_sum(entry, "moment_xy"), entry_sum(entry, "moment_yy"),
      entry_sum(entry, "moment_yz"), entry_sum(entry, "moment_xz"), entry_sum(entry, "moment_yz"),
      entry_sum(entry, "moment_zz");
  return pseudo_inertia_about_origin(mass, first, moments);
}

Mechanism with_identified(Mechanism mechanism, const Identified& identified) {
  std::map<std::size_t, BodyChange> changes;
  for (const IdentifiedEffect& entry : identified.effects) {
    if (entry.effect == "gravity")
      for (const IdentifiedValue& change : entry.coefficients)
        mechanism.gravity += change.value * changed_axis(change.name);
    if (entry.effect == "sensor_offset") move_zero(entry, mechanism);
    if (!changes_link(entry)) continue;
    const auto body = std::find_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                   [&](const Body& b) { return "link " + b.name == entry.place; });
    if (body == mechanism.bodies.end())
      refuse(entry, fmt::format("there is no {}", entry.place), "expected a link of the model");
    BodyChange& change = changes[static_cast<std::size_t>(body - mechanism.bodies.begin())];
    change.J += change_of(entry, *body);
    change.last = &entry;
  }
  for (const auto& [body, change] : changes) change_body(change, mechanism.bodies[body]);
  return mechanism;
}

}  // namespace sinew
