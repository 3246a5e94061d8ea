// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of a tree of joints, in any number type. Shares nothing with symbolic/ but the plain data.
#pragma once

#include <vector>

#include "symbolic/model/mechanism.h"
#include "tests/reference/scalar.h"

namespace sinew::reference {

/// x_parent = rotation * x_child + translation [m].
template <class Scalar>
struct Pose {
  Matrix3<Scalar> rotation = Matrix3<Scalar>::Identity();
  Vector3<Scalar> translation = Vector3<Scalar>::Zero();

  Vector3<Scalar> operator*(const Vector3<Scalar>& point) const {
    return rotation * point + translation;
  }
  Pose operator*(const Pose& child) const {
    return {rotation * child.rotation, rotation * child.translation + translation};
  }
};

/// The nearest rotation to a matrix that is one up to the rounding of its entries.
///
/// A rotation written in doubles is orthogonal to 2^-53 only, and cos(90 deg) arrives as 6e-17;
/// what is meant is the rotation next to it, so that is what the reference uses.
template <class Scalar>
Matrix3<Scalar> exact_rotation(const Eigen::Matrix3d& rounded);

/// One joint with its numbers in Scalar; see sinew::Joint.
template <class Scalar>
struct ChainJoint {
  JointType type;
  int parent;      ///< body index, -1 the base
  int coordinate;  ///< index into q, -1 where fixed
  Pose<Scalar> origin;
  Vector3<Scalar> axis;
};

template <class Scalar>
class Chain {
 public:
  /// Throws std::invalid_argument where joints and bodies do not match or a parent comes later.
  explicit Chain(const Mechanism& mechanism);

  int coordinates() const { return coordinates_; }
  const std::vector<ChainJoint<Scalar>>& joints() const { return joints_; }

  /// Pose of every body in its parent's frame; q: coordinates() values [rad or m].
  std::vector<Pose<Scalar>> relative_poses(const VectorX<Scalar>& q) const;
  /// Pose of every body in the base frame.
  std::vector<Pose<Scalar>> base_poses(const VectorX<Scalar>& q) const;

  /// 3 x n derivative of a point fixed to `body` (-1: the base), point given in the base frame.
  MatrixX<Scalar> point_jacobian(const std::vector<Pose<Scalar>>& base_poses, int body,
                                 const Vector3<Scalar>& point) const;
  /// 3 x n map from joint velocities to the body's angular velocity, base frame.
  MatrixX<Scalar> angular_jacobian(const std::vector<Pose<Scalar>>& base_poses, int body) const;
  /// n matrices' worth of d(point_jacobian)/dq_k: entry k is the 3 x n derivative by q_k.
  std::vector<MatrixX<Scalar>> point_hessian(const std::vector<Pose<Scalar>>& base_poses, int body,
                                             const Vector3<Scalar>& point) const;

 private:
  /// Indices of the moving joints from `body` to the base.
  std::vector<int> moving_ancestors(int body) const;

  std::vector<ChainJoint<Scalar>> joints_;
  int coordinates_ = 0;
};

}  // namespace sinew::reference
