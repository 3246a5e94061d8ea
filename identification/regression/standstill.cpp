// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/standstill.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStill = 5e-4;      // of the largest speed
constexpr double kUnderWay = 1e-2;   // of the largest speed
constexpr double kShortest = 0.04;   // s; a reversal is over sooner
constexpr double kLongestWay = 0.1;  // s; after that slow motion is motion
constexpr double kSmoothing = 1.2;  // periods of the smoother's cutoff that it reaches to each side
constexpr double kReversal = 0.36;  // periods that one of 60 Hz spreads a reversal over
constexpr double kFlank = 0.02;     // s
constexpr double kMost = 0.7;       // of a log: reversals beyond it stay

/// From the end of rest to where the joint is under way: in samples, forwards or backwards.
Index way_out(const VectorXd& speed, Index at, Index direction, Index longest, double fast) {
  Index way = 0;
  while (way < longest && at + direction * way >= 0 && at + direction * way < speed.size() &&
         speed(at + direction * way) < fast)
    ++way;
  return way;
}

/// Periods of the cutoff within which a reversal is smeared by more than noise: more where samples
/// are sparse, since all that is compared lies below a lower cutoff, where friction's turn is
/// large.
double periods_of_reversal(double cutoff) {
  return std::min(kSmoothing, kReversal * std::sqrt(60.0 / std::min(cutoff, 60.0)));
}

/// Samples within a smoother's reach of a reversal: where friction turns, and with it the motion,
/// a log shows their sum over that time and not their course.
Flags reversing(const VectorXd& velocity, double step, double cutoff) {
  const auto reach = static_cast<Index>(std::ceil(periods_of_reversal(cutoff) / (cutoff * step)));
  const VectorXd speed = velocity.cwiseAbs();
  const double fast = kUnderWay * speed.maxCoeff();
  const auto longest = static_cast<Index>(kLongestWay / step);
  Flags near = Flags::Constant(velocity.size(), false);
  for (Index k = 1; k < velocity.size(); ++k) {
    if ((velocity(k) > 0.0) == (velocity(k - 1) > 0.0)) continue;
    const Index from = std::max<Index>(0, k - reach - way_out(speed, k - 1, -1, longest, fast));
    const Index to = std::min(speed.size(), k + reach + way_out(speed, k, 1, longest, fast));
    near.segment(from, to - from) = true;
  }
  return near;
}

/// Samples of rest, each stretch of them with the way into and out of it.
Flags resting(const VectorXd& velocity, double step, double cutoff, double still) {
  const VectorXd speed = velocity.cwiseAbs();
  const double fastest = speed.maxCoeff();
  const double slow = std::max(kStill * fastest, still);
  const auto shortest = static_cast<Index>(std::ceil(kShortest / step));
  const auto longest = static_cast<Index>(kLongestWay / step);
  const auto smoothing = static_cast<Index>(std::ceil(kSmoothing / (cutoff * step)));
  Flags rest = Flags::Constant(speed.size(), false);
  for (Index k = 0; k < speed.size();) {
    Index end = k;
    while (end < speed.size() && speed(end) <= slow) ++end;
    if (end - k >= shortest) {
      const double fast = std::max(kUnderWay * fastest, still);
      const Index before = smoothing + way_out(speed, k, -1, longest, fast);
      const Index after = smoothing + way_out(speed, end - 1, 1, longest, fast);
      const Index from = std::max<Index>(0, k - before);
      rest.segment(from, std::min(speed.size(), end + after) - from) = true;
    }
    k = end + 1;
  }
  return rest;
}

std::vector<Standstill> stretches(const Flags& flags, const VectorXd& time) {
  std::vector<Standstill> found;
  for (Index k = 0; k < flags.size(); ++k) {
    if (!flags(k)) continue;
    if (k == 0 || !flags(k - 1)) found.push_back({time(k), time(k)});
    found.back().to = time(k);
  }
  return found;
}

}  // namespace

Stillness find_stillness(const std::vector<VectorXd>& velocities, double step, double cutoff,
                         double still) {
  Stillness found{Flags::Constant(velocities.front().size(), false),
                  reversing(velocities.front(), step, cutoff)};
  for (const VectorXd& velocity : velocities)
    found.rests = found.rests || resting(velocity, step, cutoff, still);
  return found;
}

std::vector<Standstill> find_standstills(const std::vector<Stillness>& parts,
                                         const VectorXd& time) {
  Flags still = Flags::Constant(time.size(), false);
  for (const Stillness& part : parts) still = still || part.rests;
  for (const Stillness& part : parts) {
    const Flags with = still || part.reversals;
    if (static_cast<double>(with.count()) <= kMost * static_cast<double>(with.size())) still = with;
  }
  return stretches(still, time);
}

VectorXd motion_window(const std::vector<Standstill>& stretches, const VectorXd& time) {
  VectorXd window = VectorXd::Ones(time.size());
  for (Index k = 0; k < time.size(); ++k)
    for (const Standstill& rest : stretches) {
      const double away = std::max(rest.from - time(k), time(k) - rest.to) / kFlank;
      if (away >= 1.0) continue;
      window(k) *= away <= 0.0 ? 0.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * away);
    }
  return window;
}

}  // namespace sinew::diagnosis
