// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/dequantise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Changes between samples that stand alone: the reading is held before and after but for a little
/// noise. A smooth motion changes as much from one sample to the next.
std::vector<Index> lone_changes(const VectorXd& signal) {
  std::vector<Index> changes;
  for (Index k = 2; k + 1 < signal.size(); ++k) {
    const double here = std::abs(signal(k) - signal(k - 1));
    const double beside =
        std::max(std::abs(signal(k - 1) - signal(k - 2)), std::abs(signal(k + 1) - signal(k)));
    if (here > 6.0 * beside) changes.push_back(k);
  }
  return changes;
}

}  // namespace

double held_step(const VectorXd& signal) {
  const std::vector<Index> changes = lone_changes(signal);
  if (changes.size() < 10) return 0.0;
  std::vector<double> sizes;
  double lone = 0.0, all = 0.0;
  for (Index k = 1; k < signal.size(); ++k) all += std::abs(signal(k) - signal(k - 1));
  for (const Index k : changes) {
    sizes.push_back(std::abs(signal(k) - signal(k - 1)));
    lone += sizes.back();
  }
  if (lone < 0.5 * all) return 0.0;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2),
                   sizes.end());
  return sizes[sizes.size() / 2];
}

double sensor_step(const VectorXd& reading) {
  constexpr double kNear = 0.1, kNearlyAll = 0.9;  // a fifth of all changes is near by chance
  constexpr std::size_t kFewest = 40;
  std::vector<double> changes;
  for (Index k = 1; k < reading.size(); ++k)
    if (reading(k) != reading(k - 1)) changes.push_back(std::abs(reading(k) - reading(k - 1)));
  if (changes.size() < kFewest) return 0.0;
  const auto small = changes.begin() + kFewest / 4;
  std::nth_element(changes.begin(), small, changes.end());
  double step = *small;
  // From single steps to many at once, as the step becomes known well enough to count them.
  for (const double most : {1.0, 4.0, 16.0, 64.0}) {
    double way = 0.0, steps = 0.0;
    for (const double change : changes) {
      const double count = std::round(change / step);
      if (count < 1.0 || count > most) continue;
      way += change;
      steps += count;
    }
    if (steps > 0.0) step = way / steps;
  }
  const auto fits = std::count_if(changes.begin(), changes.end(), [&](double change) {
    return std::abs(change - step * std::round(change / step)) < kNear * step;
  });
  return static_cast<double>(fits) > kNearlyAll * static_cast<double>(changes.size()) ? step : 0.0;
}

VectorXd dequantised(const VectorXd& signal) {
  VectorXd out = signal;
  double last_at = -1.0, last = 0.0;
  for (const Index k : lone_changes(signal)) {
    const double at = static_cast<double>(k) - 0.5, middle = 0.5 * (signal(k) + signal(k - 1));
    if (last_at >= 0.0)
      for (auto i = static_cast<Index>(last_at + 0.5); i < k; ++i)
        out(i) = last + (middle - last) * (static_cast<double>(i) - last_at) / (at - last_at);
    last_at = at;
    last = middle;
  }
  return out;
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
  return side;
}

}  // namespace sinew::diagnosis
