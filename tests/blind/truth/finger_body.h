// SPDX-License-Identifier: GPL-3.0-or-later
// Four links in a chain: motion and forces of rigid bodies by hand, with the masses of a finger.
#pragma once

#include <Eigen/Dense>
#include <array>

namespace sinew::truth {

using Vector4 = Eigen::Matrix<double, 4, 1>;
using Matrix4 = Eigen::Matrix<double, 4, 4>;

/// Finger in its base frame, z up. Angles: abduction, then three flexions.
struct FingerBody {
  std::array<double, 4> mass{0.002, 0.009, 0.006, 0.003};
  std::array<double, 4> length{0.006, 0.04038, 0.0298, 0.0201};
  double width = 0.012;
  double gravity = 9.81;  ///< 0: none
  double payload = 0.0;   ///< kg, a point at the tip

  /// Joint torques for a motion.
  Vector4 torque(const Vector4& q, const Vector4& qd, const Vector4& qdd) const;
  Matrix4 mass_matrix(const Vector4& q) const;
};

}  // namespace sinew::truth
