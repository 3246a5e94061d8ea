// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random numbers that are the same with every standard library (std's distributions are
// not).
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>

namespace sinew::reference {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// Uniform in 0..count-1.
  int index(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  Eigen::Vector3d vector(double size) {
    const double x = uniform(-size, size);
    const double y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }
  Eigen::Vector3d direction() {
    while (true) {
      const Eigen::Vector3d candidate = vector(1.0);
      if (candidate.norm() > 0.1 && candidate.norm() <= 1.0) return candidate.normalized();
    }
  }
  Eigen::Matrix3d rotation() {
    const Eigen::Vector3d axis = direction();
    return Eigen::AngleAxisd(uniform(-3.1, 3.1), axis).toRotationMatrix();
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace sinew::reference
