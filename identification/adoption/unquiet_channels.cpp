// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/unquiet_channels.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "identification/logs/log.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kTimesNoise = 3.0;
constexpr double kBursts = 6.0;     // fourth moment over the squared second; of a normal one 3
constexpr double kMaterial = 0.01;  // of the channel's rms

/// What is left over near the end of a smoothed motion may be the motion's own error.
bool motion_ends_in_band(const Design& design, const Segment& s) {
  const std::vector<double>& ends = design.recording(s.recording).band_hz;
  return !ends.empty() && ends[static_cast<std::size_t>(s.channel)] <= s.filter.band_hz;
}

/// 1 where what is left over is neither friction that holds nor what the filter makes of it: within
/// its length of a standstill there may be bursts in any log.
VectorXd away_from_standstill(const Design& design, std::size_t segment) {
  const Segment& s = design.segments()[segment];
  const VectorXd& window = design.window(static_cast<int>(segment));
  const Index reach = (s.filter.half_width + s.filter.factor - 1) / s.filter.factor;
  VectorXd away = VectorXd::Ones(s.samples);
  for (Index k = 0; k < s.samples; ++k) {
    if (window(k) == 1.0) continue;
    const Index from = std::max<Index>(0, k - reach), to = std::min(s.samples, k + reach + 1);
    away.segment(from, to - from).setZero();
  }
  return away;
}

struct Left {
  double count = 0.0, squares = 0.0, fourths = 0.0, measured = 0.0, noise = 0.0;
};

void add(const Design& design, std::size_t segment, const VectorXd& target,
         const VectorXd& residual, Left& left) {
  const Segment& s = design.segments()[segment];
  const Recording& log = design.problem().training[static_cast<std::size_t>(s.recording)];
  // White noise has its energy evenly up to half the sampling rate.
  const double share = std::min(1.0, log.step * s.rate_hz);
  const double noise = white_noise_rms(log.target[static_cast<std::size_t>(s.channel)].array());
  const VectorXd counts = away_from_standstill(design, segment);
  for (Index k = 0; k < s.samples; ++k) {
    if (counts(k) == 0.0) continue;
    const double square = residual(k) * residual(k);
    left.count += 1.0;
    left.squares += square;
    left.fourths += square * square;
    left.measured += target(k) * target(k);
    left.noise += noise * noise * share;
  }
}

}  // namespace

std::vector<UnquietChannel> unquiet_channels(const Design& design, const Selection& selection) {
  const Model& model = selection.model;
  if (model.target.empty()) return {};  // the search came to no end
  const VectorXd coefficients = solve(stack(model, selection.noise.weights)).coefficients;
  std::vector<const BandColumns*> columns;
  for (const Term& term : model.terms) columns.push_back(&term.columns.get());
  std::map<int, Left> channels;
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    if (s.holdout || motion_ends_in_band(design, s)) continue;
    const VectorXd& target = model.target[i];
    const VectorXd rest = target - predict(columns, coefficients, i);
    add(design, i, from_band(target, s.samples), from_band(rest, s.samples), channels[s.channel]);
  }
  std::vector<UnquietChannel> list;
  for (const auto& [channel, left] : channels) {
    const double times = std::sqrt(left.squares / std::max(left.noise, 1e-300));
    const bool bursts = left.fourths * left.count > kBursts * left.squares * left.squares;
    const bool material = left.squares > kMaterial * kMaterial * left.measured;
    if (times > kTimesNoise && bursts && material) list.push_back({channel, times});
  }
  return list;
}

}  // namespace sinew::diagnosis
