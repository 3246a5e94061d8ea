// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/dequantise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "identification/logs/filter.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Straight lines between the instants at which a count changes, where it changes on in the same
/// direction before the motion can have rested: `longest` samples. Else the middle of its step.
VectorXd between_changes(const VectorXd& reading, const SensorSteps& steps, double longest) {
  VectorXd count(reading.size());
  std::vector<Index> changes;
  for (Index k = 0; k < reading.size(); ++k) {
    count(k) = std::round((reading(k) - steps.offset) / steps.step);
    if (k > 0 && count(k) != count(k - 1)) changes.push_back(k);
  }
  VectorXd position = steps.offset + steps.step * count.array();
  const VectorXd held = position;
  for (std::size_t c = 1; c < changes.size(); ++c) {
    const Index from = changes[c - 1], to = changes[c];
    const double before = held(from) - held(from - 1), after = held(to) - held(to - 1);
    const auto samples = static_cast<double>(to - from);
    if (before * after < 0.0 || samples > longest) continue;
    const double first = held(from) - 0.5 * before, last = held(to) - 0.5 * after;
    for (Index k = from; k < to; ++k)
      position(k) = first + (last - first) * (static_cast<double>(k - from) + 0.5) / samples;
  }
  return position;
}

/// Usual number of samples from one change of the count to the next.
double usual_hold(const VectorXd& reading, const SensorSteps& steps) {
  std::vector<Index> held;
  Index last = -1;
  for (Index k = 1; k < reading.size(); ++k) {
    if (std::round((reading(k) - steps.offset) / steps.step) ==
        std::round((reading(k - 1) - steps.offset) / steps.step))
      continue;
    if (last >= 0) held.push_back(k - last);
    last = k;
  }
  if (held.empty()) return 0.0;
  const auto usual = held.begin() + static_cast<std::ptrdiff_t>(held.size() / 2);
  std::nth_element(held.begin(), usual, held.end());
  return static_cast<double>(*usual);
}

}  // namespace

VectorXd consistent_motion(const VectorXd& reading, const SensorSteps& steps, double step,
                           double cutoff) {
  constexpr double kRest = 4.0;  // times the usual time between changes
  constexpr int kRounds = 20;
  const double resolved = 0.5 / (cutoff * step);
  const double room = 0.5 * steps.step + 3.0 * steps.scatter;
  VectorXd position =
      between_changes(reading, steps, kRest * std::max(resolved, usual_hold(reading, steps)));
  for (int round = 0; round < kRounds; ++round) {
    position = position.cwiseMax((reading.array() - room).matrix())
                   .cwiseMin((reading.array() + room).matrix());
    position = differentiate(position, step, cutoff).q;
  }
  return position;
}

VectorXd side_of_play(const VectorXd& reading, const VectorXd& velocity, double quantum,
                      double still) {
  const auto stands = [&](Index k) {
    if (k + 1 >= reading.size()) return false;
    return quantum > 0.0 ? std::abs(reading(k + 1) - reading(k)) < 0.5 * quantum
                         : std::abs(velocity(k)) <= still;
  };
  VectorXd side(reading.size());
  double last = 0.0;
  Index from = 0;
  for (Index k = 0; k < reading.size(); ++k) {
    if (stands(k)) continue;
    const Index next = std::min(k + 1, reading.size() - 1);
    const double change = quantum > 0.0 ? reading(next) - reading(k) : velocity(k);
    const double now = change == 0.0 ? last : change > 0.0 ? 1.0 : -1.0;
    if (last == 0.0) last = now;
    const auto way = static_cast<double>(k - from + 1);
    // The true motion starts from rest where the reading stops: the way grows with the square.
    for (Index i = from; i <= k; ++i) {
      const double part = static_cast<double>(i - from + 1) / way;
      side(i) = last + (now - last) * part * part;
    }
    last = now;
    from = k + 1;
  }
  if (quantum <= 0.0) return side;
  // A change lies between two samples.
  VectorXd centred = side;
  centred.tail(side.size() - 1) = 0.5 * (side.tail(side.size() - 1) + side.head(side.size() - 1));
  return centred;
}

}  // namespace sinew::diagnosis
