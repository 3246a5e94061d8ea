// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/pseudo_inertia.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace sinew {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double rounding_of_pseudo_inertia = 1e-10;

}  // namespace

Matrix4d pseudo_inertia_about_origin(double mass, const Vector3d& first_moments, const Matrix3d& moments) {
  Matrix4d J;
  J.topLeftCorner<3, 3>() = 0.5 * moments.trace() * Matrix3d::Identity() - moments;
  J.topRightCorner<3, 1>() = first_moments;
  J.bottomLeftCorner<1, 3>() = first_moments.transpose();
  J(3, 3) = mass;
  return J;
}

Matrix4d body_pseudo_inertia(const Body& body) {
  const Vector3d& c = body.centre_of_mass;
  Matrix4d J = pseudo_inertia_about_origin(body.mass, body.mass * c, body.inertia);
  J.topLeftCorner<3, 3>() += body.mass * c * c.transpose();
  return J;
}

Matrix3d moments_of(const Matrix4d& J) {
  const Matrix3d S = J.topLeftCorner<3, 3>();
  return S.trace() * Matrix3d::Identity() - S;
}

Matrix4d point_pseudo_inertia(double mass, const Vector3d& first_moments) {
  Matrix4d J = pseudo_inertia_about_origin(mass, first_moments, Matrix3d::Zero());
  J.topLeftCorner<3, 3>() = first_moments * first_moments.transpose() / mass;
  return J;
}

void set_pseudo_inertia(const Matrix4d& J, Body& body) {
  body.mass = J(3, 3);
  const Vector3d c = J.topRightCorner<3, 1>() / body.mass;
  body.centre_of_mass = c;
  const Matrix3d S = J.topLeftCorner<3, 3>() - body.mass * c * c.transpose();
  const Matrix3d inertia = S.trace() * Matrix3d::Identity() - S;
  body.inertia = 0.5 * (inertia + inertia.transpose());
}

bool is_physical(const Matrix4d& J) {
  if (!J.allFinite()) return false;
  Eigen::Vector4d scale = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i) {
    if (J(i, i) < 0.0) return false;
    if (J(i, i) > 0.0)
      scale(i) = 1.0 / std::sqrt(J(i, i));
    else if (J.row(i).cwiseAbs().maxCoeff() > 0.0)
      return false;  // what has no size in a direction has no product with another one
  }
  const Matrix4d unit = scale.asDiagonal() * J * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix4d> solver(unit, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(0) >= -rounding_of_pseudo_inertia;
}

}  // namespace sinew
