// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/chain.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "tests/reference/written_number.h"

namespace sinew::reference {
namespace {

template <class Scalar>
Matrix3<Scalar> rotation_about(const Vector3<Scalar>& axis, const Scalar& angle) {
  using std::cos;
  using std::sin;
  const Scalar s = sin(angle);
  const Scalar c = cos(angle);
  Matrix3<Scalar> cross;
  cross << Scalar(0), -axis.z(), axis.y(), axis.z(), Scalar(0), -axis.x(), -axis.y(), axis.x(),
      Scalar(0);
  return Matrix3<Scalar>::Identity() * c + cross * s + axis * axis.transpose() * (Scalar(1) - c);
}

/// Entries within a few roundings of 0 or +-1 are those numbers.
double snapped(double entry) {
  constexpr double tolerance = 1e-15;
  const double whole = std::round(entry);
  return std::abs(entry - whole) < tolerance ? whole : entry;
}

}  // namespace

template <class Scalar>
Matrix3<Scalar> exact_rotation(const Eigen::Matrix3d& rounded) {
  const Eigen::Matrix3d start = rounded.unaryExpr([](double entry) { return snapped(entry); });
  if (!((start * start.transpose()).isIdentity(1e-9)) || start.determinant() < 0)
    throw std::invalid_argument("not a rotation matrix");
  Matrix3<Scalar> rotation = start.cast<Scalar>();
  // Newton's iteration for the polar factor, R <- R (3 - R^T R) / 2, squares the error each time.
  for (int step = 0; step < 4; ++step)
    rotation =
        (rotation * (Matrix3<Scalar>::Identity() * Scalar(3) - rotation.transpose() * rotation) /
         Scalar(2))
            .eval();
  return rotation;
}

template <class Scalar>
Chain<Scalar>::Chain(const Mechanism& mechanism) {
  if (mechanism.bodies.size() != mechanism.joints.size())
    throw std::invalid_argument("a mechanism has one joint for each body");
  for (const Joint& joint : mechanism.joints) {
    if (joint.parent < -1 || joint.parent >= static_cast<int>(joints_.size()))
      throw std::invalid_argument(joint.name + ": a joint's parent comes before it");
    const Vector3<Scalar> axis = joint.axis.cast<Scalar>();
    joints_.push_back({joint.type,
                       joint.parent,
                       joint.type == JointType::fixed ? -1 : coordinates_++,
                       {exact_rotation<Scalar>(joint.origin.rotation),
                        written_vector<Scalar>(joint.origin.translation)},
                       Vector3<Scalar>(axis / axis.norm())});
  }
}

template <class Scalar>
std::vector<Pose<Scalar>> Chain<Scalar>::relative_poses(const VectorX<Scalar>& q) const {
  std::vector<Pose<Scalar>> poses;
  for (const ChainJoint<Scalar>& joint : joints_) {
    Pose<Scalar> motion;
    if (joint.type == JointType::revolute)
      motion.rotation = rotation_about(joint.axis, q[joint.coordinate]);
    if (joint.type == JointType::prismatic) motion.translation = joint.axis * q[joint.coordinate];
    poses.push_back(joint.origin * motion);
  }
  return poses;
}

template <class Scalar>
std::vector<Pose<Scalar>> Chain<Scalar>::base_poses(const VectorX<Scalar>& q) const {
  std::vector<Pose<Scalar>> poses = relative_poses(q);
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (joints_[i].parent >= 0)
      poses[i] = poses[static_cast<std::size_t>(joints_[i].parent)] * poses[i];
  return poses;
}

template <class Scalar>
std::vector<int> Chain<Scalar>::moving_ancestors(int body) const {
  std::vector<int> found;
  for (int i = body; i >= 0; i = joints_[static_cast<std::size_t>(i)].parent)
    if (joints_[static_cast<std::size_t>(i)].coordinate >= 0) found.push_back(i);
  return found;
}

template <class Scalar>
MatrixX<Scalar> Chain<Scalar>::point_jacobian(const std::vector<Pose<Scalar>>& base_poses, int body,
                                              const Vector3<Scalar>& point) const {
  MatrixX<Scalar> jacobian = MatrixX<Scalar>::Zero(3, coordinates_);
  for (int i : moving_ancestors(body)) {
    const auto& joint = joints_[static_cast<std::size_t>(i)];
    const auto& pose = base_poses[static_cast<std::size_t>(i)];
    const Vector3<Scalar> axis = pose.rotation * joint.axis;
    const Vector3<Scalar> arm = point - pose.translation;
    jacobian.col(joint.coordinate) =
        joint.type == JointType::revolute ? Vector3<Scalar>(axis.cross(arm)) : axis;
  }
  return jacobian;
}

template <class Scalar>
MatrixX<Scalar> Chain<Scalar>::angular_jacobian(const std::vector<Pose<Scalar>>& base_poses,
                                                int body) const {
  MatrixX<Scalar> jacobian = MatrixX<Scalar>::Zero(3, coordinates_);
  for (int i : moving_ancestors(body)) {
    const auto& joint = joints_[static_cast<std::size_t>(i)];
    if (joint.type == JointType::revolute)
      jacobian.col(joint.coordinate) =
          base_poses[static_cast<std::size_t>(i)].rotation * joint.axis;
  }
  return jacobian;
}

template <class Scalar>
std::vector<MatrixX<Scalar>> Chain<Scalar>::point_hessian(
    const std::vector<Pose<Scalar>>& base_poses, int body, const Vector3<Scalar>& point) const {
  std::vector<MatrixX<Scalar>> hessian(static_cast<std::size_t>(coordinates_),
                                       MatrixX<Scalar>::Zero(3, coordinates_));
  const MatrixX<Scalar> jacobian = point_jacobian(base_poses, body, point);
  const std::vector<int> chain = moving_ancestors(body);
  for (std::size_t outer = 0; outer < chain.size(); ++outer) {
    // The joint nearer the base turns what the farther one does; sliding changes nothing.
    const auto& near = joints_[static_cast<std::size_t>(chain[outer])];
    if (near.type != JointType::revolute) continue;
    const Vector3<Scalar> axis =
        base_poses[static_cast<std::size_t>(chain[outer])].rotation * near.axis;
    for (std::size_t inner = 0; inner <= outer; ++inner) {
      const int far = joints_[static_cast<std::size_t>(chain[inner])].coordinate;
      const Vector3<Scalar> column = jacobian.col(far);
      const Vector3<Scalar> turned = axis.cross(column);
      hessian[static_cast<std::size_t>(near.coordinate)].col(far) = turned;
      hessian[static_cast<std::size_t>(far)].col(near.coordinate) = turned;
    }
  }
  return hessian;
}

template Matrix3<double> exact_rotation(const Eigen::Matrix3d&);
template Matrix3<long double> exact_rotation(const Eigen::Matrix3d&);
template Matrix3<Real50> exact_rotation(const Eigen::Matrix3d&);
template class Chain<double>;
template class Chain<long double>;
template class Chain<Real50>;

}  // namespace sinew::reference
