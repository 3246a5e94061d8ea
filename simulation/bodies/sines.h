// SPDX-License-Identifier: GPL-3.0-or-later
// Sines and cosines of many angles by the runtime, four at once.
#pragma once

#include <sinew_math.h>

#include <algorithm>
#include <vector>

namespace sinew {

/// To be used again and again: its arrays are kept.
class Sines {
 public:
  /// Of `count` angles [rad], |angle| < 800.
  void of(const double* angle, std::size_t count) {
    const std::size_t whole = (count + 3) / 4 * 4;
    angle_.resize(whole);
    sine_.resize(whole);
    cosine_.resize(whole);
    std::copy(angle, angle + count, angle_.data());
    std::fill(angle_.begin() + static_cast<std::ptrdiff_t>(count), angle_.end(), 0.0);
    for (std::size_t i = 0; i < whole; i += 4)
      sinew_sincos4(angle_.data() + i, sine_.data() + i, cosine_.data() + i);
  }
  double sine(std::size_t i) const { return sine_[i]; }
  double cosine(std::size_t i) const { return cosine_[i]; }

 private:
  std::vector<double> angle_, sine_, cosine_;
};

}  // namespace sinew
