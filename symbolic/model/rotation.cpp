// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/rotation.h"

#include <Eigen/LU>
#include <cmath>
#include <cstdlib>

namespace sinew {

namespace {

double snapped_entry(double entry) {
  const double whole = std::round(entry);
  return std::abs(entry - whole) <= 1e-12 ? whole + 0.0 : entry;  // + 0.0: no negative zero
}

/// The double `steps` places away.
double moved(double value, int steps) {
  const double towards = steps < 0 ? -HUGE_VAL : HUGE_VAL;
  for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, towards);
  return value;
}

Eigen::Vector3d nearest_rpy(const Eigen::Matrix3d& rotation) {
  using Extended = long double;
  const Eigen::Matrix<Extended, 3, 3> r = rotation.cast<Extended>();
  Eigen::Matrix<Extended, 3, 1> rpy(0, std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0))), 0);
  if (std::abs(rotation(2, 0)) < 1.0) {
    rpy[0] = std::atan2(r(2, 1), r(2, 2));
    rpy[2] = std::atan2(r(1, 0), r(0, 0));
  } else {
    rpy[2] = std::atan2(-r(0, 1), r(1, 1));
  }
  return rpy.cast<double>().unaryExpr([](double angle) { return angle + 0.0; });
}

}  // namespace

Eigen::Matrix3d snapped(const Eigen::Matrix3d& rotation) {
  return rotation.unaryExpr(&snapped_entry);
}

Eigen::Vector3d unit_axis(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d scaled = axis / axis.cwiseAbs().maxCoeff();  // no overflow, no underflow
  return (scaled / scaled.norm()).unaryExpr(&snapped_entry);
}

Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy) {
  using Extended = long double;
  const Eigen::Matrix<Extended, 3, 1> angle = rpy.cast<Extended>();
  const Extended cr = std::cos(angle[0]), sr = std::sin(angle[0]);
  const Extended cp = std::cos(angle[1]), sp = std::sin(angle[1]);
  const Extended cy = std::cos(angle[2]), sy = std::sin(angle[2]);
  Eigen::Matrix<Extended, 3, 3> r;
  r << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return snapped(r.cast<double>());
}

std::optional<Eigen::Vector3d> exact_rpy(const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d start = nearest_rpy(rotation);
  // The matrix is rounded, so angles computed from it may miss those it was made of by a few ulps.
  static constexpr int order[] = {0, 1, -1, 2, -2};
  for (const int roll : order)
    for (const int pitch : order)
      for (const int yaw : order) {
        const Eigen::Vector3d rpy(moved(start[0], roll), moved(start[1], pitch),
                                  moved(start[2], yaw));
        if (rotation_from_rpy(rpy) == rotation) return rpy;
      }
  return std::nullopt;
}

bool is_rotation(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) return false;
  const Eigen::Matrix3d excess = matrix.transpose() * matrix - Eigen::Matrix3d::Identity();
  return excess.cwiseAbs().maxCoeff() <= 1e-9 && matrix.determinant() > 0.0;
}

}  // namespace sinew
