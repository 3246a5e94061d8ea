// SPDX-License-Identifier: GPL-3.0-or-later
// A position sensor with play: its reading stands still until the motion has crossed the play, and
// then stays half of it behind.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "symbolic/extension/identified.h"

namespace sinew {

class LooseSensor {
 public:
  /// As loose as `hidden` says of the sensor at `place`; tight where it says nothing.
  LooseSensor(const std::vector<IdentifiedEffect>& hidden, const std::string& place) {
    for (const IdentifiedEffect& effect : hidden)
      if (effect.effect == "sensor_hysteresis" && effect.place == place)
        half_ = effect.coefficients.front().value;
  }

  struct Reading {
    double value, side;  ///< the motion is at value + half of the play * side
  };
  Reading of(double motion, double speed) {
    if (half_ <= 0.0) return {motion, std::copysign(1.0, speed)};
    if (!started_) held_ = motion - std::copysign(half_, speed);
    started_ = true;
    held_ = std::clamp(held_, motion - half_, motion + half_);
    return {held_, (motion - held_) / half_};
  }

 private:
  double half_ = 0.0, held_ = 0.0;
  bool started_ = false;
};

}  // namespace sinew
