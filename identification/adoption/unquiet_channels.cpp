// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/unquiet_channels.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kTimesNoise = 3.0;
constexpr double kBursts = 6.0;     // fourth moment over the squared second; of a normal one 3
constexpr double kMaterial = 0.01;  // of the channel's rms

struct Left {
  double count = 0.0, squares = 0.0, fourths = 0.0, measured = 0.0, noise = 0.0;
};

void add(const MeasuredChannel& m, const Recording& log, Left& left) {
  const VectorXd& target = log.target[static_cast<std::size_t>(m.channel)];
  // White noise has its energy evenly up to half the sampling rate.
  const double share = std::min(1.0, log.step / m.step);
  const double noise = white_noise_rms(target.array());
  for (Index k = 0; k < m.measured.size(); ++k) {
    if (m.counts.size() > 0 && m.counts(k) == 0.0) continue;
    const double error = m.measured(k) - m.after(k);
    left.count += 1.0;
    left.squares += error * error;
    left.fourths += error * error * error * error;
    left.measured += m.measured(k) * m.measured(k);
    left.noise += noise * noise * share;
  }
}

}  // namespace

std::vector<UnquietChannel> unquiet_channels(const Problem& problem,
                                             const std::vector<MeasuredChannel>& measured) {
  std::vector<UnquietChannel> list;
  for (int c = 0; c < problem.channels; ++c) {
    Left left;
    for (const MeasuredChannel& m : measured) {
      if (m.channel != c) continue;
      const auto index = static_cast<std::size_t>(m.recording), first = problem.training.size();
      add(m, index < first ? problem.training[index] : problem.holdout[index - first], left);
    }
    const double times = std::sqrt(left.squares / std::max(left.noise, 1e-300));
    const bool bursts = left.fourths * left.count > kBursts * left.squares * left.squares;
    const bool material = left.squares > kMaterial * kMaterial * left.measured;
    if (times > kTimesNoise && bursts && material) list.push_back({c, times});
  }
  return list;
}

}  // namespace sinew::diagnosis
