// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/drive_stretch.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr double block_time = 0.02;       // s, over which a velocity is taken
constexpr double velocity_spread = 0.1;   // of the velocity, within a plateau
constexpr double settling = 0.2;          // s at most, left out at a plateau's beginning
constexpr double velocity_noise = 0.005;  // rad/s, of a velocity taken from the angle

/// Samples each way that a velocity is taken over: as few as keep its noise small, because friction
/// is steep where the drive turns round and a mean over the turn is no friction.
long reach_of(const Channel& theta, const Eigen::ArrayXd& signal, double period, double smoothing) {
  const double noise = std::max(white_noise_rms(signal), theta.quantum / std::sqrt(12.0));
  const double wanted = noise * std::sqrt(2.0) / (2.0 * period * velocity_noise);
  return std::clamp(static_cast<long>(std::ceil(std::min(wanted, 1e6))), 1L,
                    std::max(1L, std::lround(smoothing / period / 2)));
}

Eigen::ArrayXd slope_of(const Eigen::ArrayXd& signal, double period, long half) {
  const long n = signal.size();
  Eigen::ArrayXd rate = Eigen::ArrayXd::Zero(n);
  for (long i = 0; i < n; ++i) {
    const long before = std::max(0L, i - half), after = std::min(n - 1, i + half);
    if (after > before)
      rate(i) = (signal(after) - signal(before)) / (static_cast<double>(after - before) * period);
  }
  return rate;
}

/// Least-squares slope of each block.
std::vector<double> block_velocities(const DriveStretch& stretch, long block) {
  std::vector<double> velocities;
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(block, -0.5, 0.5) *
                           (static_cast<double>(block - 1) * stretch.period);
  const double spread = (t * t).sum();
  for (long at = 0; at + block <= stretch.theta.size(); at += block)
    velocities.push_back((stretch.theta.segment(at, block) * t).sum() / spread);
  return velocities;
}

}  // namespace

std::vector<DriveStretch> drive_stretches(const Log& log, double smoothing) {
  std::vector<DriveStretch> all;
  const int theta = log.channel("theta"), omega = log.channel("omega"),
            torque = log.channel("tau_m"), load = log.channel("load");
  for (const Segment& segment : log.segments) {
    DriveStretch stretch;
    stretch.period = log.period;
    stretch.theta = segment.samples.col(theta);
    stretch.torque = segment.samples.col(torque);
    if (load >= 0) stretch.torque -= segment.samples.col(load);
    stretch.omega = omega >= 0 ? Eigen::ArrayXd(segment.samples.col(omega))
                               : slope_of(stretch.theta, log.period,
                                          reach_of(log.channels[static_cast<std::size_t>(theta)],
                                                   stretch.theta, log.period, smoothing));
    all.push_back(std::move(stretch));
  }
  return all;
}

std::vector<Plateau> plateaus(const std::vector<DriveStretch>& stretches, double least) {
  std::vector<Plateau> found;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const double period = stretches[s].period;
    const long block = std::max(5L, std::lround(block_time / period));
    const std::vector<double> v = block_velocities(stretches[s], block);
    for (std::size_t begin = 0; begin < v.size();) {
      std::size_t end = begin + 1;
      double sum = v[begin];
      const auto fits = [&](double next) {
        const double mean = sum / static_cast<double>(end - begin);
        return std::abs(next - mean) <= velocity_spread * std::abs(mean);
      };
      for (; end < v.size() && fits(v[end]); ++end) sum += v[end];
      const double time = static_cast<double>((static_cast<long>(end - begin)) * block) * period;
      const long skip = std::lround(std::min(settling, 0.3 * time) / period);
      const long first = static_cast<long>(begin) * block + skip,
                 last = static_cast<long>(end) * block - block;
      if (static_cast<double>(last - first) * period >= least) {
        const double turned = stretches[s].theta(last - 1) - stretches[s].theta(first);
        found.push_back(
            {s, first, last, turned / (static_cast<double>(last - 1 - first) * period)});
      }
      begin = end;
    }
  }
  return found;
}

}  // namespace sinew
