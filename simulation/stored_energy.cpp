// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/stored_energy.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sinew {
namespace {

Eigen::Vector2d direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

double spring_length(const LeverParameters& p, double lever_angle) {
  const Eigen::Vector2d point = p.pivot + p.spring_arm * direction(lever_angle + p.spring_angle);
  return (point - p.anchor).norm();
}

Transform moved(const Joint& joint, double position) {
  Transform motion;
  if (joint.type == JointType::revolute)
    motion.rotation = Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
  else
    motion.translation = position * joint.axis;
  return {joint.origin.rotation * motion.rotation,
          joint.origin.translation + joint.origin.rotation * motion.translation};
}

}  // namespace

double gravity_potential(const Mechanism& mechanism, const double* q,
                         const Eigen::Vector3d& gravity) {
  std::vector<Transform> pose(mechanism.bodies.size());
  double energy = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const Transform step = joint.type == JointType::fixed ? joint.origin : moved(joint, q[next++]);
    const Transform parent =
        joint.parent < 0 ? Transform{} : pose[static_cast<std::size_t>(joint.parent)];
    pose[i] = {parent.rotation * step.rotation,
               parent.translation + parent.rotation * step.translation};
    const Body& body = mechanism.bodies[i];
    energy -= body.mass * gravity.dot(pose[i].translation + pose[i].rotation * body.centre_of_mass);
  }
  return energy;
}

TendonEnergy::TendonEnergy(const TendonWithLever& parameters)
    : lever_(parameters.lever),
      free_length_(spring_length(lever_, lever_.free_angle)),
      softness_(parameters.tendon.free_length / parameters.tendon.axial_stiffness) {}

double TendonEnergy::at(double lever_angle, double force) const {
  const double stretch = spring_length(lever_, lever_angle) - free_length_;
  return 0.5 * lever_.spring_stiffness * stretch * stretch + 0.5 * softness_ * force * force;
}

}  // namespace sinew
