// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/expected_bodies.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// What a body has of a parameter [kg, kg m, kg m^2] for a kilogram about `radius` from the origin.
double per_mass(std::size_t parameter, double radius) {
  if (parameter == 0) return 1.0;
  return parameter < kMassAndFirstMoments ? radius : radius * radius;
}

}  // namespace

void expect(double mass, double radius, std::vector<LinearParameter>& parameters) {
  for (std::size_t k = 0; k < parameters.size(); ++k)
    parameters[k].spread = mass * per_mass(k, radius);
}

void expect_about(double radius, std::vector<LinearParameter>& parameters) {
  for (std::size_t k = 1; k < parameters.size(); ++k)
    parameters[k].times_first = per_mass(k, radius);
}

double radius_of(const Body& body) {
  return std::sqrt(body.centre_of_mass.squaredNorm() + 0.5 * body.inertia.trace() / body.mass);
}

MatrixXd moments_as_drawn(const Body& link) {
  using Eigen::Matrix3d;
  const Vector3d& c = link.centre_of_mass;
  MatrixXd moments(6, kMassAndFirstMoments);
  const auto set = [&](Index column, const Matrix3d& I) {
    moments.col(column) << I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2);
  };
  const Matrix3d about_origin = c.squaredNorm() * Matrix3d::Identity() - c * c.transpose();
  set(0, link.inertia / link.mass - about_origin);
  for (Index k = 0; k < 3; ++k) {
    const Vector3d e = Vector3d::Unit(k);
    set(1 + k, 2.0 * c(k) * Matrix3d::Identity() - e * c.transpose() - c * e.transpose());
  }
  return moments;
}

std::vector<MovingBody> moving_bodies(const Mechanism& mechanism) {
  std::vector<bool> moves, leaf(mechanism.bodies.size(), true);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const bool with_parent = joint.parent >= 0 && moves[static_cast<std::size_t>(joint.parent)];
    moves.push_back(joint.type != JointType::fixed || with_parent);
    if (joint.parent >= 0) leaf[static_cast<std::size_t>(joint.parent)] = false;
  }
  std::vector<MovingBody> list;
  for (std::size_t i = 0; i < leaf.size(); ++i)
    if (moves[i]) list.push_back({i, leaf[i]});
  return list;
}

double moving_mass(const Mechanism& mechanism) {
  double mass = 0.0;
  for (const MovingBody& m : moving_bodies(mechanism)) mass += mechanism.bodies[m.body].mass;
  return mass;
}

double reach_of(const Mechanism& mechanism) {
  double reach = 0.0, centre = 0.0;
  for (const Joint& joint : mechanism.joints) reach += joint.origin.translation.norm();
  for (const Body& body : mechanism.bodies) centre = std::max(centre, body.centre_of_mass.norm());
  return 2.0 * (reach + centre);
}

}  // namespace sinew::diagnosis
