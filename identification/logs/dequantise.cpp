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

/// A reading as multiples of its sensor's step, and the samples at which they change.
struct Counted {
  VectorXd held;  ///< in the reading's unit
  std::vector<Index> changes;
};

Counted counted(const VectorXd& reading, const SensorSteps& steps) {
  const VectorXd count = ((reading.array() - steps.offset) / steps.step).round();
  Counted result{steps.offset + steps.step * count.array(), {}};
  for (Index k = 1; k < count.size(); ++k)
    if (count(k) != count(k - 1)) result.changes.push_back(k);
  return result;
}

/// Straight lines between the instants of the changes, where the next one goes on in the same
/// direction before the motion can have rested: `longest` samples. Else the middle of its step.
VectorXd between_changes(const Counted& reading, double longest) {
  const auto& [held, changes] = reading;
  VectorXd position = held;
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

/// Usual number of samples from one change to the next.
double usual_hold(const std::vector<Index>& changes) {
  std::vector<Index> held;
  for (std::size_t c = 1; c < changes.size(); ++c) held.push_back(changes[c] - changes[c - 1]);
  if (held.empty()) return 0.0;
  const auto usual = held.begin() + static_cast<std::ptrdiff_t>(held.size() / 2);
  std::nth_element(held.begin(), usual, held.end());
  return static_cast<double>(*usual);
}

}  // namespace

VectorXd consistent_motion(const VectorXd& reading, const SensorSteps& steps, double step,
                           double cutoff) {
  constexpr double kRest = 4.0;  // times the usual time between changes
  constexpr int kRounds = 20;    // ten times as many leave no less of the steps' error
  const double resolved = 0.5 / (cutoff * step);
  const double room = 0.5 * steps.step + 3.0 * steps.scatter;
  const Counted counts = counted(reading, steps);
  VectorXd position =
      between_changes(counts, kRest * std::max(resolved, usual_hold(counts.changes)));
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
