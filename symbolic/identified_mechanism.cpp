// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/identified_mechanism.h"

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
  const auto value = [&](const char* name) { return entry.coefficient(name); };
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
    throw std::invalid_argument("identified.toml: the payload leaves link '" + body.name +
                                "' without mass");
  body.centre_of_mass = first / body.mass;
  body.inertia = moments - parallel_axis(body.mass, body.centre_of_mass);
}

}  // namespace

bool changes_mechanism(const IdentifiedEffect& entry) {
  return entry.effect == "payload" || entry.effect == "gravity";
}

Mechanism with_identified(Mechanism mechanism, const Identified& identified) {
  for (const IdentifiedEffect& entry : identified.effects) {
    if (entry.effect == "gravity")
      mechanism.gravity += Eigen::Vector3d(entry.coefficient("gravity_change_x"),
                                           entry.coefficient("gravity_change_y"),
                                           entry.coefficient("gravity_change_z"));
    if (entry.effect != "payload") continue;
    const auto body = std::find_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                   [&](const Body& b) { return "link " + b.name == entry.place; });
    if (body == mechanism.bodies.end())
      throw std::invalid_argument("identified.toml: there is no " + entry.place);
    add_payload(entry, *body);
  }
  return mechanism;
}

}  // namespace sinew
