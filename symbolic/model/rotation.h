// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations of a description: from roll, pitch and yaw, cleaned of rounding, and checked.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace sinew {

/// R = Rz(yaw) Ry(pitch) Rx(roll), angles in rad (the URDF convention). Entries within 1e-12 of 0
/// and ±1 become exactly that, so that quarter turns give permutation matrices. Computed in
/// extended precision, so that the rounded result does not depend on the machine's libm.
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

/// Entries within 1e-12 of 0, 1 and -1 set to exactly that.
Eigen::Matrix3d snapped(const Eigen::Matrix3d& rotation);

/// The direction of a vector other than zero; entries within 1e-12 of 0 and ±1 become exactly that.
Eigen::Vector3d unit_axis(const Eigen::Vector3d& axis);

/// Roll, pitch and yaw that rotation_from_rpy turns into exactly this matrix, if found.
std::optional<Eigen::Vector3d> exact_rpy(const Eigen::Matrix3d& rotation);

/// Orthonormal with determinant +1, within 1e-9 in each entry of R^T R.
bool is_rotation(const Eigen::Matrix3d& matrix);

}  // namespace sinew
