// SPDX-License-Identifier: GPL-3.0-or-later
// A position from a logged velocity.
#pragma once

#include <cmath>
#include <limits>

namespace sinew {

/// Follows one velocity row by row, by trapezoids; the position begins at 0.
class RunningIntegral {
 public:
  /// Times in s, rates in the channel's SI unit per second. NaN where either is none: the next row
  /// goes on from the last one that was a number. A time that does not grow adds nothing.
  double push(double time, double rate) {
    if (!std::isfinite(time) || !std::isfinite(rate))
      return std::numeric_limits<double>::quiet_NaN();
    if (started_ && time > time_) sum_ += 0.5 * (rate + rate_) * (time - time_);
    started_ = true;
    time_ = time;
    rate_ = rate;
    return sum_;
  }

 private:
  bool started_ = false;
  double time_ = 0.0, rate_ = 0.0, sum_ = 0.0;
};

}  // namespace sinew
