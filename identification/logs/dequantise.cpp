// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/dequantise.h"

#include <algorithm>
#include <cmath>
#include <map>
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

/// Line through the counts and the values that are at most `most` steps away from the first.
struct Lattice {
  double step, offset;
  double counted = 0.0;  ///< values
  double near = 0.0;     ///< of them: to a tenth of a step
  double squares = 0.0;  ///< of the distances of those, in steps
};

Lattice fitted(const VectorXd& way, double step, double most) {
  constexpr double kNear = 0.1;  // by chance a fifth is as near
  double counts = 0.0, squares = 0.0, ways = 0.0, products = 0.0;
  Lattice lattice{step, 0.0};
  for (const double x : way) {
    const double count = std::round(x / step);
    if (std::abs(count) > most) continue;
    lattice.counted += 1.0;
    counts += count;
    squares += count * count;
    ways += x;
    products += count * x;
  }
  const double spread = lattice.counted * squares - counts * counts;
  if (spread > 0.0) lattice.step = (lattice.counted * products - counts * ways) / spread;
  // The first value, too, lies off the lattice by its own rounding.
  lattice.offset = (ways - lattice.step * counts) / lattice.counted;
  for (const double x : way) {
    if (std::abs(std::round(x / step)) > most) continue;
    const double off = (x - lattice.offset) / lattice.step;
    const double distance = off - std::round(off);
    if (std::abs(distance) >= kNear) continue;
    lattice.near += 1.0;
    lattice.squares += distance * distance;
  }
  return lattice;
}

/// Where the reading moves least over some samples: there its neighbours are few steps away.
Index slowest(const VectorXd& reading) {
  constexpr Index kStretch = 40;
  if (reading.size() <= kStretch) return 0;
  Index at = 0;
  (reading.tail(reading.size() - kStretch) - reading.head(reading.size() - kStretch))
      .cwiseAbs()
      .minCoeff(&at);
  return at;
}

/// The lattice on which nearly all values lie, its step near `step`. It becomes known well enough
/// to count ever more of it from where the reading is slow.
SensorSteps lattice_near(const VectorXd& values, double step) {
  constexpr double kNearlyAll = 0.9, kFew = 40.0;
  const VectorXd way = values.array() - values(slowest(values));
  const double furthest = way.cwiseAbs().maxCoeff();
  SensorSteps found;
  for (double most = 4.0;; most *= 4.0) {
    const Lattice lattice = fitted(way, step, most);
    if (lattice.counted >= kFew) {
      if (!(lattice.step > 0.0) || lattice.near < kNearlyAll * lattice.counted) return {};
      step = lattice.step;
      found = {step, step * std::sqrt(lattice.squares / lattice.near)};
    }
    if (most * step > furthest) return found;
  }
}

/// A motion at one constant speed has equal changes without any steps of a sensor.
bool changes_vary(const std::vector<double>& changes, double step) {
  constexpr double kUsual = 0.9;
  std::map<double, int> of_count;
  for (const double change : changes) ++of_count[std::round(change / step)];
  const auto usual = std::max_element(of_count.begin(), of_count.end(),
                                      [](auto& a, auto& b) { return a.second < b.second; });
  return static_cast<double>(usual->second) < kUsual * static_cast<double>(changes.size());
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

SensorSteps sensor_steps(const VectorXd& reading) {
  constexpr Index kFewest = 40;
  std::vector<double> changes;
  std::size_t lone = 0;  // the reading is held before and after
  for (Index k = 1; k < reading.size(); ++k) {
    if (reading(k) == reading(k - 1)) continue;
    changes.push_back(std::abs(reading(k) - reading(k - 1)));
    const bool held_before = k > 1 && reading(k - 1) == reading(k - 2);
    lone += held_before && k + 1 < reading.size() && reading(k + 1) == reading(k) ? 1U : 0U;
  }
  if (static_cast<Index>(changes.size()) < kFewest) return {};
  const auto small = changes.begin() + kFewest / 4;
  std::nth_element(changes.begin(), small, changes.end());
  // One step each, rounded again this way or that.
  double single = 0.0, count = 0.0;
  for (const double change : changes) {
    if (std::abs(change - *small) > 0.4 * *small) continue;
    single += change;
    count += 1.0;
  }
  const SensorSteps steps = lattice_near(reading, single / count);
  const bool by_steps = 2 * lone > changes.size() || changes_vary(changes, steps.step);
  return steps.step > 0.0 && by_steps ? steps : SensorSteps();
}

VectorXd dequantised(const VectorXd& signal) {
  constexpr Index kRest = 4;  // times the usual time between changes
  const std::vector<Index> changes = lone_changes(signal);
  std::vector<Index> held;
  for (std::size_t i = 1; i < changes.size(); ++i) held.push_back(changes[i] - changes[i - 1]);
  if (held.empty()) return signal;
  const auto usual = held.begin() + static_cast<std::ptrdiff_t>(held.size() / 2);
  std::nth_element(held.begin(), usual, held.end());
  VectorXd out = signal;
  const auto middle = [&](Index k) { return 0.5 * (signal(k) + signal(k - 1)); };
  for (std::size_t c = 1; c < changes.size(); ++c) {
    const Index from = changes[c - 1], to = changes[c];
    if (to - from > kRest * *usual) continue;
    for (Index i = from; i < to; ++i)
      out(i) = middle(from) + (middle(to) - middle(from)) * (static_cast<double>(i - from) + 0.5) /
                                  static_cast<double>(to - from);
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
  if (quantum <= 0.0) return side;
  // A change lies between two samples.
  VectorXd centred = side;
  centred.tail(side.size() - 1) = 0.5 * (side.tail(side.size() - 1) + side.head(side.size() - 1));
  return centred;
}

}  // namespace sinew::diagnosis
