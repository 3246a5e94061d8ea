// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/reference/random_numbers.h"

namespace sinew::reference {
namespace {

/// A multiple of pi/2 inside [low, high], missed by a random small distance; any value if none is.
double near_quarter_turn(RandomNumbers& random, double low, double high) {
  constexpr double quarter = std::numbers::pi / 2;
  const int first = static_cast<int>(std::ceil(low / quarter));
  const int last = static_cast<int>(std::floor(high / quarter));
  if (last < first) return random.uniform(low, high);
  const double turn = quarter * (first + random.index(last - first + 1));
  const int kind = random.index(4);
  double missed = turn;
  if (kind == 1) missed = std::nextafter(turn, random.chance(0.5) ? low : high);
  if (kind == 2) missed = turn + random.uniform(-1e-9, 1e-9);
  if (kind == 3) missed = turn + random.uniform(-1e-3, 1e-3);
  return std::clamp(missed, low, high);
}

Box symmetric_box(const Mechanism& mechanism, double Joint::*limit) {
  Box box;
  for (const Joint& joint : mechanism.joints) {
    if (joint.type == JointType::fixed) continue;
    box.low.push_back(-(joint.*limit));
    box.high.push_back(joint.*limit);
  }
  return box;
}

}  // namespace

std::vector<std::vector<double>> sample_box(const Box& box, int count, std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<std::vector<double>> points;
  for (int i = 0; i < count; ++i) {
    std::vector<double> point;
    for (std::size_t k = 0; k < box.low.size(); ++k) {
      const double low = box.low[k];
      const double high = box.high[k];
      double value = random.uniform(low, high);
      if (i == 0) value = std::clamp(0.0, low, high);
      if (i % 10 == 1) value = random.chance(0.5) ? low : high;
      if ((i % 10 == 2 || i % 10 == 3) && random.chance(0.5))
        value = near_quarter_turn(random, low, high);
      point.push_back(value);
    }
    points.push_back(point);
  }
  return points;
}

Box position_box(const Mechanism& mechanism) {
  Box box;
  for (const Joint& joint : mechanism.joints) {
    if (joint.type == JointType::fixed) continue;
    box.low.push_back(joint.low);
    box.high.push_back(joint.high);
  }
  return box;
}

Box velocity_box(const Mechanism& mechanism) {
  return symmetric_box(mechanism, &Joint::max_velocity);
}

Box acceleration_box(const Mechanism& mechanism) {
  return symmetric_box(mechanism, &Joint::max_acceleration);
}

}  // namespace sinew::reference
