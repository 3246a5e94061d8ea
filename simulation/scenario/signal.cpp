// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/scenario/signal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew {
namespace {

using std::numbers::pi;

Sample sample_of(const Wave& wave, double time) {
  if (time < wave.from || time >= wave.to) return {};
  const double since = time - wave.from;
  switch (wave.shape) {
    case WaveShape::constant:
      return {wave.value, 0.0, 0.0};
    case WaveShape::ramp:
      return {wave.value + wave.rate * since, wave.rate, 0.0};
    case WaveShape::sine: {
      const double omega = 2.0 * pi * wave.frequency, angle = omega * since + wave.phase;
      const double swing = wave.amplitude * std::sin(angle);
      return {wave.value + swing, wave.amplitude * omega * std::cos(angle), -omega * omega * swing};
    }
  }
  return {};
}

Sample sample_of(const SampledSignal& samples, double time) {
  if (time <= samples.time.front()) return {samples.value.front(), 0.0, 0.0};
  if (time >= samples.time.back()) return {samples.value.back(), 0.0, 0.0};
  const auto next = std::upper_bound(samples.time.begin(), samples.time.end(), time);
  const auto i = static_cast<std::size_t>(next - samples.time.begin());
  const double slope =
      (samples.value[i] - samples.value[i - 1]) / (samples.time[i] - samples.time[i - 1]);
  return {samples.value[i - 1] + slope * (time - samples.time[i - 1]), slope, 0.0};
}

}  // namespace

Sample Signal::at(double time) const {
  Sample sum;
  const auto take = [&](const Sample& sample) {
    sum.value += sample.value;
    sum.rate += sample.rate;
    sum.acceleration += sample.acceleration;
  };
  for (const Wave& wave : waves_) take(sample_of(wave, time));
  for (const SampledSignal& samples : sampled_) take(sample_of(samples, time));
  return sum;
}

void Signal::append_jumps(std::vector<double>& times) const {
  for (const Wave& wave : waves_) {
    times.push_back(wave.from);
    times.push_back(wave.to);
  }
  for (const SampledSignal& samples : sampled_)
    times.insert(times.end(), samples.time.begin(), samples.time.end());
}

}  // namespace sinew
