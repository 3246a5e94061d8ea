// SPDX-License-Identifier: GPL-3.0-or-later
// States to test at: random ones, corners of the range, close to multiples of pi/2, zero.
#pragma once

#include <cstdint>
#include <vector>

#include "symbolic/model/mechanism.h"

namespace sinew::reference {

/// A range for each number.
struct Box {
  std::vector<double> low, high;
};

/// `count` points of the box, the same for the same seed: the first is zero (or the nearest to it),
/// then of each ten one is a corner and two have about half their entries next to a multiple of
/// pi/2 (at distances from nothing over one unit in the last place to 1e-3).
std::vector<std::vector<double>> sample_box(const Box& box, int count, std::uint64_t seed);

/// Ranges of q, of qd and of qdd: coordinates' limits, max_velocity and max_acceleration.
Box position_box(const Mechanism& mechanism);
Box velocity_box(const Mechanism& mechanism);
Box acceleration_box(const Mechanism& mechanism);

}  // namespace sinew::reference
