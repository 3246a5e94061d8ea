// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/bodies/body_energy.h"

#include <Eigen/Geometry>

namespace sinew {

using Eigen::Matrix3d;
using Eigen::Vector3d;

BodyEnergy::BodyEnergy(const Mechanism& mechanism) : frames_(mechanism.bodies.size()) {
  std::vector<Matrix3d> own;  // from a joint's axes with z along it to the mechanism's
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const Body& body = mechanism.bodies[i];
    own.push_back(
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), joint.axis).toRotationMatrix());
    const Matrix3d before =
        joint.parent < 0 ? Matrix3d::Identity() : own[static_cast<std::size_t>(joint.parent)];
    Link link;
    link.parent = joint.parent;
    link.type = joint.type;
    link.rotation = before.transpose() * joint.origin.rotation * own.back();
    link.origin = before.transpose() * joint.origin.translation;
    link.centre = own.back().transpose() * body.centre_of_mass;
    link.inertia = own.back().transpose() * body.inertia * own.back();
    link.mass = body.mass;
    if (link.type != JointType::fixed) ++moving_;
    links_.push_back(link);
  }
}

double BodyEnergy::at(const double* positions, const double* rates, const MovingFrame& base,
                      const Vector3d& gravity) const {
  double energy = 0.0;
  sines_.of(positions, moving_);
  std::size_t joint = 0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const MovingFrame& carrier =
        link.parent < 0 ? base : frames_[static_cast<std::size_t>(link.parent)];
    MovingFrame& own = frames_[i];
    own.rotation.noalias() = carrier.rotation * link.rotation;
    own.origin = carrier.origin + carrier.rotation * link.origin;
    own.spin.noalias() = link.rotation.transpose() * carrier.spin;
    own.velocity.noalias() =
        link.rotation.transpose() * (carrier.velocity + carrier.spin.cross(link.origin));
    if (link.type == JointType::revolute) {
      const double c = sines_.cosine(joint), s = sines_.sine(joint);
      const auto turned = [&](Vector3d& v) {
        const double x = v(0);
        v(0) = c * x + s * v(1);
        v(1) = c * v(1) - s * x;
      };
      const Vector3d x = own.rotation.col(0);
      own.rotation.col(0) = c * x + s * own.rotation.col(1);
      own.rotation.col(1) = c * own.rotation.col(1) - s * x;
      turned(own.spin);
      turned(own.velocity);
      own.spin(2) += rates[joint++];
    } else if (link.type == JointType::prismatic) {
      const Vector3d slide(0.0, 0.0, positions[joint]);
      own.origin += own.rotation * slide;
      own.velocity += own.spin.cross(slide);
      own.velocity(2) += rates[joint++];
    }
    const Vector3d velocity = own.velocity + own.spin.cross(link.centre);
    energy += 0.5 * (link.mass * velocity.squaredNorm() + own.spin.dot(link.inertia * own.spin)) -
              link.mass * gravity.dot(own.origin + own.rotation * link.centre);
  }
  return energy;
}

}  // namespace sinew
