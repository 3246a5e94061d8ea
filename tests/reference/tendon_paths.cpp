// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/tendon_paths.h"

#include <Eigen/Cholesky>
#include <stdexcept>

#include "tests/reference/written_number.h"

namespace sinew::reference {
namespace {

int body_named(const Mechanism& mechanism, const std::string& name) {
  if (name == "base") return -1;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
    if (mechanism.bodies[i].name == name) return static_cast<int>(i);
  throw std::invalid_argument("tendon: no body named " + name);
}

std::size_t joint_named(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].name == name && mechanism.joints[i].type != JointType::fixed) return i;
  throw std::invalid_argument("tendon: no moving joint named " + name);
}

}  // namespace

template <class Scalar>
TendonPaths<Scalar>::TendonPaths(const Mechanism& mechanism) : chain_(mechanism) {
  for (const sinew::Tendon& given : mechanism.tendons) {
    Tendon tendon{written_number<Scalar>(given.h0), Vector::Zero(chain_.coordinates()), {}};
    for (const PulleyRouting& pulley : given.pulleys)
      tendon.radii[chain_.joints()[joint_named(mechanism, pulley.joint)].coordinate] +=
          written_number<Scalar>(pulley.radius);
    for (const StraightRouting& straight : given.straights)
      tendon.straights.push_back(
          {body_named(mechanism, straight.from_body), body_named(mechanism, straight.to_body),
           written_vector<Scalar>(straight.from), written_vector<Scalar>(straight.to)});
    tendons_.push_back(tendon);
  }
}

template <class Scalar>
Vector3<Scalar> TendonPaths<Scalar>::place(const std::vector<Pose<Scalar>>& poses, int body,
                                           const Vector3<Scalar>& point) const {
  return body < 0 ? point : poses[static_cast<std::size_t>(body)] * point;
}

template <class Scalar>
auto TendonPaths<Scalar>::stretch(const std::vector<Pose<Scalar>>& poses,
                                  const Straight& straight) const -> Stretch {
  const Vector3<Scalar> from = place(poses, straight.from_body, straight.from);
  const Vector3<Scalar> to = place(poses, straight.to_body, straight.to);
  return {to - from, chain_.point_jacobian(poses, straight.to_body, to) -
                         chain_.point_jacobian(poses, straight.from_body, from)};
}

template <class Scalar>
auto TendonPaths<Scalar>::lengths(const Vector& q) const -> Vector {
  const auto poses = chain_.base_poses(q);
  Vector lengths(size());
  for (int i = 0; i < size(); ++i) {
    const Tendon& tendon = tendons_[static_cast<std::size_t>(i)];
    lengths[i] = tendon.h0 + tendon.radii.dot(q);
    for (const Straight& straight : tendon.straights)
      lengths[i] += stretch(poses, straight).span.norm();
  }
  return lengths;
}

template <class Scalar>
auto TendonPaths<Scalar>::coupling_matrix(const Vector& q) const -> Matrix {
  const auto poses = chain_.base_poses(q);
  Matrix coupling(size(), chain_.coordinates());
  for (int i = 0; i < size(); ++i) {
    const Tendon& tendon = tendons_[static_cast<std::size_t>(i)];
    coupling.row(i) = tendon.radii.transpose();
    for (const Straight& straight : tendon.straights) {
      const Stretch now = stretch(poses, straight);
      coupling.row(i) += now.span.transpose() * now.jacobian / now.span.norm();
    }
  }
  return coupling;
}

/// d2|s| = (J^T J - (u^T J)^T (u^T J)) / |s| + u . d2s with u = s/|s|, J = ds/dq.
template <class Scalar>
auto TendonPaths<Scalar>::length_hessian(const Vector& q, int tendon) const -> Matrix {
  const auto poses = chain_.base_poses(q);
  const int n = chain_.coordinates();
  Matrix hessian = Matrix::Zero(n, n);
  for (const Straight& straight : tendons_[static_cast<std::size_t>(tendon)].straights) {
    const Stretch now = stretch(poses, straight);
    const Scalar length = now.span.norm();
    const Vector3<Scalar> direction = now.span / length;
    const Vector along = now.jacobian.transpose() * direction;
    hessian += (now.jacobian.transpose() * now.jacobian - along * along.transpose()) / length;
    const auto to =
        chain_.point_hessian(poses, straight.to_body, place(poses, straight.to_body, straight.to));
    const auto from = chain_.point_hessian(poses, straight.from_body,
                                           place(poses, straight.from_body, straight.from));
    for (int k = 0; k < n; ++k) {
      const auto index = static_cast<std::size_t>(k);
      hessian.row(k) += direction.transpose() * Matrix(to[index] - from[index]);
    }
  }
  return hessian;
}

template <class Scalar>
auto TendonPaths<Scalar>::joint_torque(const Vector& q, const Vector& f) const -> Vector {
  return -(coupling_matrix(q).transpose() * f);
}

template <class Scalar>
auto TendonPaths<Scalar>::joint_stiffness(const Vector& q, const Vector& f, const Vector& kt) const
    -> Matrix {
  const Matrix coupling = coupling_matrix(q);
  Matrix stiffness = coupling.transpose() * kt.asDiagonal() * coupling;
  for (int i = 0; i < size(); ++i) stiffness += f[i] * length_hessian(q, i);
  return stiffness;
}

template <class Scalar>
auto TendonPaths<Scalar>::link_position(const Vector& h) const -> Vector {
  const Vector zero = Vector::Zero(chain_.coordinates());
  const Matrix coupling = coupling_matrix(zero);
  const Matrix normal = coupling.transpose() * coupling;
  return normal.ldlt().solve(Vector(coupling.transpose() * (h - lengths(zero))));
}

template class TendonPaths<double>;
template class TendonPaths<long double>;
template class TendonPaths<Real50>;

}  // namespace sinew::reference
