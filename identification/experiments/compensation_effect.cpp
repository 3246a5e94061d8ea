// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/compensation_effect.h"

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "identification/experiments/drive_stretch.h"

namespace sinew {
namespace {

using std::numbers::pi;
constexpr double same_speed = 0.1;
constexpr long least_turns = 3;

/// Sine and cosine at one turn of the motor, with a level and a slope along: one turn's worth, so
/// that the turns' scatter is the estimate's error whatever the noise's colour.
Eigen::Vector2d turn_of(const Eigen::ArrayXd& angle, const Eigen::ArrayXd& signal) {
  Eigen::MatrixXd columns(angle.size(), 4);
  columns.col(0) = angle.sin();
  columns.col(1) = angle.cos();
  columns.col(2).setOnes();
  columns.col(3) = angle - angle.mean();
  return columns.colPivHouseholderQr().solve(signal.matrix()).head<2>();
}

std::vector<Eigen::Vector2d> turns_of(const Eigen::ArrayXd& angle, const Eigen::ArrayXd& signal) {
  std::vector<Eigen::Vector2d> turns;
  const double way = angle(angle.size() - 1) > angle(0) ? 2.0 * pi : -2.0 * pi;
  long first = 0;
  for (long turn = 1; first < angle.size(); ++turn) {
    const double end = angle(0) + static_cast<double>(turn) * way;
    long last = first;
    while (last < angle.size() && (angle(last) - end) * way < 0.0) ++last;
    if (last == angle.size() || last - first < 8) break;
    turns.push_back(
        turn_of(angle.segment(first, last - first), signal.segment(first, last - first)));
    first = last;
  }
  return turns;
}

Estimate amplitude_of(const std::vector<Eigen::Vector2d>& turns) {
  const auto n = static_cast<double>(turns.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& turn : turns) mean += turn / n;
  const Eigen::Vector2d along = mean.norm() > 0.0 ? mean.normalized() : Eigen::Vector2d::UnitX();
  double squares = 0.0;
  for (const Eigen::Vector2d& turn : turns) squares += std::pow(along.dot(turn - mean), 2);
  return estimate(mean.norm(), std::sqrt(squares / (n - 1.0) / n),
                  static_cast<long>(turns.size()) - 1);
}

/// The channel over a stretch: logged, or the velocity that the angle has.
Eigen::ArrayXd signal_of(const Log& log, const Segment& segment, const DriveStretch& stretch,
                         const std::string& channel) {
  const int index = log.channel(channel);
  if (index >= 0) return segment.samples.col(index);
  return channel == "omega" ? stretch.omega : Eigen::ArrayXd();
}

std::vector<MotorOrderAmplitude> amplitudes_of(const Log& log, double gear_ratio,
                                               const std::string& channel) {
  std::vector<MotorOrderAmplitude> all;
  const std::vector<DriveStretch> stretches = drive_stretches(log, 4.0 * log.period);
  for (const Plateau& p : plateaus(stretches)) {
    const DriveStretch& s = stretches[p.stretch];
    const Eigen::ArrayXd signal = signal_of(log, log.segments[p.stretch], s, channel);
    if (signal.size() == 0) continue;
    const long count = p.last - p.first;
    const auto turns =
        turns_of(s.theta.segment(p.first, count) / gear_ratio, signal.segment(p.first, count));
    if (static_cast<long>(turns.size()) >= least_turns)
      all.push_back({log.file, p.velocity, static_cast<long>(turns.size()), amplitude_of(turns)});
  }
  return all;
}

MotorOrderReduction reduction_of(const MotorOrderAmplitude& after,
                                 const MotorOrderAmplitude& before) {
  const double share = after.amplitude.value / before.amplitude.value;
  const double error =
      std::hypot(after.amplitude.standard_error, share * before.amplitude.standard_error) /
      before.amplitude.value;
  return {after.log, after.speed,
          estimate(share, error, std::min(after.periods, before.periods) - 1)};
}

}  // namespace

MotorOrderEffect motor_order_effect(const std::vector<Log>& logs, double gear_ratio,
                                    const std::string& channel) {
  MotorOrderEffect effect;
  std::size_t of_first = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    for (const MotorOrderAmplitude& a : amplitudes_of(logs[i], gear_ratio, channel)) {
      effect.amplitudes.push_back(a);
      for (std::size_t k = 0; i > 0 && k < of_first; ++k) {
        const MotorOrderAmplitude& before = effect.amplitudes[k];
        if (std::abs(a.speed - before.speed) > same_speed * std::abs(before.speed) ||
            !(before.amplitude.value > 0.0))
          continue;
        effect.reductions.push_back(reduction_of(a, before));
        break;
      }
    }
    if (i == 0) of_first = effect.amplitudes.size();
  }
  return effect;
}

}  // namespace sinew
