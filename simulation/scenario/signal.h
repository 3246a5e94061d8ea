// SPDX-License-Identifier: GPL-3.0-or-later
// What a scenario commands over time: shapes that add up, and sampled values.
#pragma once

#include <string>
#include <vector>

namespace sinew {

/// Value of a signal and its derivatives by time.
struct Sample {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

enum class WaveShape { constant, ramp, sine };

/// One shape, 0 outside [from, to): constant: `value`; ramp: value + rate * (t - from); sine:
/// value + amplitude * sin(2 pi frequency (t - from) + phase). SI units.
struct Wave {
  WaveShape shape = WaveShape::constant;
  double value = 0.0;
  double rate = 0.0;  ///< per second
  double amplitude = 0.0;
  double frequency = 0.0;  ///< Hz
  double phase = 0.0;      ///< rad
  double from = 0.0;       ///< s
  double to = 1e300;       ///< s
};

/// Values at times, in between by straight lines, held before the first and after the last.
struct SampledSignal {
  std::vector<double> time;  ///< s, rising
  std::vector<double> value;
};

/// A channel's command: the sum of its waves and samples.
class Signal {
 public:
  void add(const Wave& wave) {
    waves_.push_back(wave);
    smooth_ = smooth_ && wave.shape != WaveShape::ramp && wave.from <= 0.0 && wave.to >= Wave{}.to;
  }
  void add(const SampledSignal& samples) { sampled_.push_back(samples); }
  bool empty() const { return waves_.empty() && sampled_.empty(); }

  Sample at(double time) const;
  /// Without jumps of any derivative, at any time.
  bool smooth() const { return smooth_ && sampled_.empty(); }
  /// Times at which the value or its slope jumps, where an integrator has to stop.
  void append_jumps(std::vector<double>& times) const;

 private:
  std::vector<Wave> waves_;
  std::vector<SampledSignal> sampled_;
  bool smooth_ = true;
};

}  // namespace sinew
