// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/sensor_steps.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Mean of cos(2 pi x / step) over distances x from a lattice: 1 on it, exp(-2 pi^2 s^2 / step^2)
/// with noise of rms s, 0 where there is none.
constexpr double kOnLattice = 0.5;
constexpr double kFewest = 40.0;  // readings or changes that tell of a lattice

/// Steps, the largest first and to a few per cent, that the changes within `lag` samples may be
/// multiples of: maxima of their mean cosine. A motion's own changes have a smooth distribution,
/// whose transform dies away.
std::vector<double> steps_of_changes(const VectorXd& reading, Index lag) {
  constexpr std::size_t kBins = 1 << 16;  // of the changes; a step has eight of them at least
  constexpr std::size_t kFewSteps = 10;   // of less in the largest change the motion's own show
  constexpr std::size_t kMost = 8;        // the others are fractions of these
  const Index n = reading.size() - lag;
  const VectorXd change = (reading.tail(n) - reading.head(n)).cwiseAbs();
  const double largest = change.maxCoeff();
  if (!(largest > 0.0)) return {};
  std::vector<double> share(2 * kBins, 0.0);
  for (const double x : change)
    share[std::min(kBins - 1,
                   static_cast<std::size_t>(x / largest * static_cast<double>(kBins)))] +=
        1.0 / static_cast<double>(n);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, share);
  const auto mean_cosine = [&](std::size_t i) {
    // Of the middles of the bins.
    const double half = std::numbers::pi * static_cast<double>(i) / (2.0 * kBins);
    return spectrum[i].real() * std::cos(half) + spectrum[i].imag() * std::sin(half);
  };
  std::vector<double> steps;
  double lowest = 1.0;
  for (std::size_t i = 2 * kFewSteps; i < kBins / 4 && steps.size() < kMost; ++i) {
    const double here = mean_cosine(i);
    lowest = std::min(lowest, here);
    // Changes of none lift all alike. Both ends of a change have the noise.
    if (here - lowest < kOnLattice * kOnLattice) continue;
    if (here >= mean_cosine(i - 1) && here > mean_cosine(i + 1))
      steps.push_back(2.0 * largest / static_cast<double>(i));
  }
  return steps;
}

/// Line through the counts and the values that are at most `most` steps away from the slowest.
struct Lattice {
  double step, offset;
  double counted = 0.0;  ///< values
  double on = 0.0;       ///< mean cosine of their distances
};

Lattice fitted(const VectorXd& way, double step, double most) {
  const double turn = 2.0 * std::numbers::pi / step;
  // The first value, too, lies off the lattice by its own noise and rounding.
  std::complex<double> phase;
  for (const double x : way)
    if (std::abs(x) <= most * step) phase += std::polar(1.0, turn * x);
  const double first = std::arg(phase) / turn;
  double counts = 0.0, squares = 0.0, ways = 0.0, products = 0.0;
  Lattice lattice{step, first};
  for (const double x : way) {
    if (std::abs(x) > most * step) continue;
    const double count = std::round((x - first) / step);
    lattice.counted += 1.0;
    counts += count;
    squares += count * count;
    ways += x;
    products += count * x;
  }
  const double spread = lattice.counted * squares - counts * counts;
  if (spread > 0.0) lattice.step = (lattice.counted * products - counts * ways) / spread;
  lattice.offset = (ways - lattice.step * counts) / lattice.counted;
  for (const double x : way)
    if (std::abs(x) <= most * step)
      lattice.on +=
          std::cos(2.0 * std::numbers::pi * (x - lattice.offset) / lattice.step) / lattice.counted;
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

/// The lattice on which the values lie, its step near `step`. It becomes known well enough to count
/// ever more of it from where the reading is slow.
SensorSteps lattice_near(const VectorXd& values, double step) {
  const double origin = values(slowest(values));
  const VectorXd way = values.array() - origin;
  const double furthest = way.cwiseAbs().maxCoeff();
  SensorSteps found;
  for (double most = 4.0;; most *= 4.0) {
    const Lattice lattice = fitted(way, step, most);
    if (lattice.counted >= kFewest) {
      if (!(lattice.step > 0.0) || lattice.on < kOnLattice) return {};
      step = lattice.step;
      const double on = std::min(lattice.on, 1.0);
      found = {step, origin + lattice.offset,
               step / (2.0 * std::numbers::pi) * std::sqrt(-2.0 * std::log(on))};
    }
    if (most * step > furthest) return found;
  }
}

/// A motion at constant speeds has equal changes one after the other without any steps of a sensor.
bool shows_steps(const VectorXd& reading, const SensorSteps& steps) {
  constexpr double kMostlyEqual = 0.9;
  const VectorXd count = ((reading.array() - steps.offset) / steps.step).round();
  double changes = 0.0, equal = 0.0;
  for (Index k = 1; k + 1 < count.size(); ++k) {
    const double here = count(k) - count(k - 1);
    if (here == 0.0) continue;
    changes += 1.0;
    equal += count(k + 1) - count(k) == here ? 1.0 : 0.0;
  }
  return changes >= kFewest && equal < kMostlyEqual * changes;
}

}  // namespace

SensorSteps sensor_steps(const VectorXd& reading) {
  SensorSteps coarsest;
  for (const Index lag : {1, 16, 256, 4096}) {
    if (2 * lag > reading.size()) break;
    for (const double step : steps_of_changes(reading, lag)) {
      const SensorSteps steps = lattice_near(reading, step);
      if (steps.step > coarsest.step && shows_steps(reading, steps)) coarsest = steps;
    }
  }
  return coarsest;
}

}  // namespace sinew::diagnosis
