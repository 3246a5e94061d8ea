// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/identified_mechanism.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

namespace sinew {
namespace {

/// Moments about the origin for a centre of mass at c: the parallel-axis term.
Eigen::Matrix3d parallel_axis(double mass, const Eigen::Vector3d& c) {
  return mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
}

void add_payload(const IdentifiedEffect& entry, Body& body) {
  // A point's moments of inertia may be left away.
  const auto value = [&](const std::string& name) {
    double sum = 0.0;
    for (const IdentifiedValue& v : entry.coefficients) sum += v.name == name ? v.value : 0.0;
    return sum;
  };
  const Eigen::Vector3d first =
      body.mass * body.centre_of_mass +
      Eigen::Vector3d(value("first_moment_x"), value("first_moment_y"), value("first_moment_z"));
  Eigen::Matrix3d moments;
  moments << value("moment_xx"), value("moment_xy"), value("moment_xz"), value("moment_xy"),
      value("moment_yy"), value("moment_yz"), value("moment_xz"), value("moment_yz"),
      value("moment_zz");
  moments += body.inertia + parallel_axis(body.mass, body.centre_of_mass);
  body.mass += value("mass");
  if (!(body.mass > 0.0))
    throw std::invalid_argument("identified.toml: what was learnt leaves link '" + body.name +
                                "' without mass");
  body.centre_of_mass = first / body.mass;
  body.inertia = moments - parallel_axis(body.mass, body.centre_of_mass);
}

/// gravity_change_x, _y or _z; those that are not given do not change.
Eigen::Vector3d changed_axis(const std::string& coefficient) {
  const char* names[] = {"gravity_change_x", "gravity_change_y", "gravity_change_z"};
  for (int k = 0; k < 3; ++k)
    if (coefficient == names[k]) return Eigen::Vector3d::Unit(k);
  throw std::invalid_argument("identified.toml: gravity has no coefficient '" + coefficient + "'");
}

bool changes_link(const IdentifiedEffect& entry) {
  return entry.effect == "payload" || entry.effect == "inertial_parameters";
}

}  // namespace

bool changes_mechanism(const IdentifiedEffect& entry) {
  return changes_link(entry) || entry.effect == "gravity";
}

Mechanism with_identified(Mechanism mechanism, const Identified& identified) {
  for (const IdentifiedEffect& entry : identified.effects) {
    if (entry.effect == "gravity")
      for (const IdentifiedValue& change : entry.coefficients)
        mechanism.gravity += change.value * changed_axis(change.name);
    if (!changes_link(entry)) continue;
    const auto body = std::find_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                   [&](const Body& b) { return "link " + b.name == entry.place; });
    if (body == mechanism.bodies.end())
      throw std::invalid_argument("identified.toml: there is no " + entry.place);
    add_payload(entry, *body);
  }
  return mechanism;
}

}  // namespace sinew
