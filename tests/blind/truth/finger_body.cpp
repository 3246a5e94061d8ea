// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/finger_body.h"

#include <cmath>

namespace sinew::truth {
namespace {

using Eigen::Vector3d;

// Everything in the base frame: slower than link frames, and hard to get wrong.
struct Link {
  Eigen::Matrix3d axes;  // x along the bone, z the joint's axis
  Vector3d joint, centre, tip;
};

std::array<Link, 4> place(const FingerBody& f, const Vector4& q) {
  std::array<Link, 4> links;
  const double c0 = std::cos(q(0)), s0 = std::sin(q(0));
  const Vector3d ahead(c0, s0, 0.0), side(-s0, c0, 0.0), up(0.0, 0.0, 1.0);
  links[0].axes << ahead, side, up;
  links[0].joint.setZero();
  links[0].centre = 0.5 * f.length[0] * ahead;
  links[0].tip = f.length[0] * ahead;
  // The flexions turn in the plane of `ahead` and `up`, about -side.
  double angle = 0.0;
  Vector3d at = links[0].tip;
  constexpr std::array<double, 4> tip_drop = {0.0, 0.0, -0.005, -0.0007};
  for (size_t i = 1; i < 4; ++i) {
    angle += q(static_cast<long>(i));
    const Vector3d along = std::cos(angle) * ahead + std::sin(angle) * up;
    const Vector3d across = -std::sin(angle) * ahead + std::cos(angle) * up;
    links[i].axes << along, across, -side;
    // The drop is along the joint's axis, sideways to the plane of flexion.
    const Vector3d whole = f.length[i] * along - tip_drop[i] * side;
    links[i].joint = at;
    links[i].centre = at + 0.5 * whole;
    links[i].tip = at = at + whole;
  }
  return links;
}

Eigen::Matrix3d inertia(const FingerBody& f, size_t i, const Eigen::Matrix3d& axes) {
  const double m = f.mass[i], l = f.length[i], w = f.width;
  const double along = m * w * w / 8.0, across = m * (l * l / 12.0 + w * w / 16.0);
  return axes * Vector3d(along, across, across).asDiagonal() * axes.transpose();
}

}  // namespace

Vector4 FingerBody::torque(const Vector4& q, const Vector4& qd, const Vector4& qdd) const {
  const std::array<Link, 4> links = place(*this, q);
  Vector3d spin = Vector3d::Zero(), spin_rate = Vector3d::Zero();
  Vector3d joint_acceleration(0.0, 0.0, gravity);
  std::array<Vector3d, 4> force, moment;  // about each link's own joint
  for (size_t i = 0; i < 4; ++i) {
    const auto j = static_cast<long>(i);
    const Vector3d axis = links[i].axes.col(2);
    spin_rate += axis * qdd(j) + spin.cross(axis) * qd(j);
    spin += axis * qd(j);
    const auto acceleration_at = [&](const Vector3d& point) -> Vector3d {
      const Vector3d arm = point - links[i].joint;
      return joint_acceleration + spin_rate.cross(arm) + spin.cross(spin.cross(arm));
    };
    const Eigen::Matrix3d I = inertia(*this, i, links[i].axes);
    force[i] = mass[i] * acceleration_at(links[i].centre);
    moment[i] =
        I * spin_rate + spin.cross(I * spin) + (links[i].centre - links[i].joint).cross(force[i]);
    if (i == 3 && payload > 0.0) {
      const Vector3d extra = payload * acceleration_at(links[i].tip);
      force[i] += extra;
      moment[i] += (links[i].tip - links[i].joint).cross(extra);
    }
    joint_acceleration = acceleration_at(links[i].tip);
  }
  Vector4 result;
  Vector3d sum_force = Vector3d::Zero(), sum_moment = Vector3d::Zero();
  for (size_t i = 4; i-- > 0;) {
    if (i < 3) sum_moment += (links[i + 1].joint - links[i].joint).cross(sum_force);
    sum_force += force[i];
    sum_moment += moment[i];
    result(static_cast<long>(i)) = links[i].axes.col(2).dot(sum_moment);
  }
  return result;
}

Matrix4 FingerBody::mass_matrix(const Vector4& q) const {
  const std::array<Link, 4> links = place(*this, q);
  Matrix4 M = Matrix4::Zero();
  const auto add = [&](size_t last, const Vector3d& point, double m, const Eigen::Matrix3d* I) {
    Eigen::Matrix<double, 3, 4> J = Eigen::Matrix<double, 3, 4>::Zero(), W = J;
    for (size_t i = 0; i <= last; ++i) {
      J.col(static_cast<long>(i)) = links[i].axes.col(2).cross(point - links[i].joint);
      W.col(static_cast<long>(i)) = links[i].axes.col(2);
    }
    M += m * J.transpose() * J;
    if (I != nullptr) M += W.transpose() * *I * W;
  };
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::Matrix3d I = inertia(*this, i, links[i].axes);
    add(i, links[i].centre, mass[i], &I);
  }
  if (payload > 0.0) add(3, links[3].tip, payload, nullptr);
  return M;
}

}  // namespace sinew::truth
