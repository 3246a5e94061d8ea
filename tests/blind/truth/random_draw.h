// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine: what a seed draws must not depend on a
// library.
#pragma once

#include <cmath>
#include <cstdint>

namespace sinew::truth {

/// splitmix64.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x2545f4914f6cdd1du) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31u);
  }
  double unit() { return static_cast<double>(bits() >> 11u) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  double log_uniform(double low, double high) {
    return low * std::exp(unit() * std::log(high / low));
  }
  double sign() { return unit() < 0.5 ? -1.0 : 1.0; }
  bool chance(double probability) { return unit() < probability; }
  /// 0 .. count - 1
  int below(int count) { return static_cast<int>(unit() * count); }
  double normal() {
    if (spare_) {
      spare_ = false;
      return kept_;
    }
    double u = 0.0, v = 0.0, s = 0.0;
    do {
      u = uniform(-1.0, 1.0);
      v = uniform(-1.0, 1.0);
      s = u * u + v * v;
    } while (s >= 1.0 || s == 0.0);
    const double scale = std::sqrt(-2.0 * std::log(s) / s);
    kept_ = v * scale;
    spare_ = true;
    return u * scale;
  }
  /// A stream of its own: draws from it leave this one as it is.
  Draw fork() { return Draw(bits()); }

 private:
  std::uint64_t state_;
  double kept_ = 0.0;
  bool spare_ = false;
};

}  // namespace sinew::truth
