// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs that elementary functions are tested with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace sinew {

// A fixed sequence of uniform numbers, the same on every machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : state_(seed) {}
  double operator()(double low, double high) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return low + (high - low) * (static_cast<double>(state_ >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

// Numbers within +-limit: random ones, neighbours of every multiple of pi/4 (where quadrants change
// and results vanish), tiny ones of every magnitude, and the ends.
template <class Real>
std::vector<Real> angles_within(Real limit, int random_count) {
  std::vector<Real> result{0, limit, -limit};
  Uniform uniform(0x9e3779b97f4a7c15U);
  for (int i = 0; i < random_count; ++i) {
    result.push_back(static_cast<Real>(uniform(-1, 1) * static_cast<double>(limit)));
    result.push_back(static_cast<Real>(uniform(-4, 4)));
  }
  const double eighth = std::numbers::pi / 4;
  const auto steps =
      static_cast<std::int64_t>(std::min(static_cast<double>(limit) / eighth, 0x1p62));
  const std::int64_t stride = steps / 3000 + 1;
  for (std::int64_t k = -steps; k <= steps; k += stride) {
    Real x = static_cast<Real>(static_cast<double>(k) * eighth);
    for (int i = 0; i < 3; ++i) x = std::nextafter(x, -std::numeric_limits<Real>::infinity());
    for (int i = 0; i < 7; ++i, x = std::nextafter(x, std::numeric_limits<Real>::infinity()))
      if (std::fabs(x) <= limit) result.push_back(x);
  }
  for (Real x = 1; x > 0; x /= 2) {
    result.push_back(x);
    result.push_back(-x * Real(1.25));
  }
  return result;
}

}  // namespace sinew
