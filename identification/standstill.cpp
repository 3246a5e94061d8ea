// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/standstill.h"

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
constexpr double kSmoothing = 0.02;  // s that filters reach to each side
constexpr double kFlank = 0.02;      // s
constexpr double kMost = 0.7;        // of a log

/// From the end of rest to where the joint is under way: in samples, forwards or backwards.
Index way_out(const VectorXd& speed, Index at, Index direction, Index longest, double fast) {
  Index way = 0;
  while (way < longest && at + direction * way >= 0 && at + direction * way < speed.size() &&
         speed(at + direction * way) < fast)
    ++way;
  return way;
}

/// Samples of rest, each stretch of them with the way into and out of it.
Eigen::ArrayX<bool> resting(const VectorXd& velocity, double step) {
  const VectorXd speed = velocity.cwiseAbs();
  const double fastest = speed.maxCoeff();
  const auto shortest = static_cast<Index>(std::ceil(kShortest / step));
  const auto longest = static_cast<Index>(kLongestWay / step);
  const auto smoothing = static_cast<Index>(std::ceil(kSmoothing / step));
  Eigen::ArrayX<bool> rest = Eigen::ArrayX<bool>::Constant(speed.size(), false);
  for (Index k = 0; k < speed.size();) {
    Index end = k;
    while (end < speed.size() && speed(end) < kStill * fastest) ++end;
    if (end - k >= shortest) {
      const double fast = kUnderWay * fastest;
      const Index before = smoothing + way_out(speed, k, -1, longest, fast);
      const Index after = smoothing + way_out(speed, end - 1, 1, longest, fast);
      const Index from = std::max<Index>(0, k - before);
      rest.segment(from, std::min(speed.size(), end + after) - from) = true;
    }
    k = end + 1;
  }
  return rest;
}

}  // namespace

std::vector<Standstill> find_standstills(const VectorXd& time,
                                         const std::vector<VectorXd>& velocities) {
  Eigen::ArrayX<bool> rest = Eigen::ArrayX<bool>::Constant(time.size(), false);
  if (time.size() < 2) return {};
  const double step = (time(time.size() - 1) - time(0)) / static_cast<double>(time.size() - 1);
  for (const VectorXd& velocity : velocities) rest = rest || resting(velocity, step);
  if (static_cast<double>(rest.count()) > kMost * static_cast<double>(rest.size())) return {};
  std::vector<Standstill> found;
  for (Index k = 0; k < rest.size(); ++k) {
    if (!rest(k)) continue;
    if (k == 0 || !rest(k - 1)) found.push_back({time(k), time(k)});
    found.back().to = time(k);
  }
  return found;
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
