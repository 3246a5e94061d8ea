// SPDX-License-Identifier: GPL-3.0-or-later
// Reference motions and measurement noise of the truth simulators.
#pragma once

#include <vector>

#include "tests/blind/truth/random_draw.h"

namespace sinew::truth {

/// Position, velocity and acceleration of a reference.
struct Reference {
  double position = 0.0, velocity = 0.0, acceleration = 0.0;
};

enum class Course {
  mixed,      ///< strokes with trapezoidal speed and a few sines on top
  sines,      ///< sum of sines
  strokes,    ///< strokes with trapezoidal speed
  one_speed,  ///< to and fro at one speed, quick turns
  one_way,    ///< always forward, speed changing
  one_sine,   ///< one frequency
};

/// A motion drawn once, evaluated anywhere. Amplitude in rad or m, speeds below `top_speed`.
class Motion {
 public:
  Motion(Course course, double amplitude, double top_speed, double seconds, Draw draw);
  /// At step * 0, 1, ..., count - 1.
  std::vector<Reference> table(double step, size_t count);

 private:
  struct Sine {
    double amplitude, rate, phase;
  };
  struct Stroke {
    double start, from, distance, speed, ramp, length;
  };
  Reference strokes(double time);
  std::vector<Sine> sines_;
  std::vector<Stroke> strokes_;
  size_t current_ = 0;
  double drift_ = 0.0;
};

/// Coloured noise of rms 1: a white share, a slow share (first order) and a resonance.
class Noise {
 public:
  explicit Noise(Draw draw);
  double next();

 private:
  Draw draw_;
  double white_, slow_, ring_;
  double pole_, slow_gain_;
  double a1_, a2_, ring_gain_;
  double x_ = 0.0, y1_ = 0.0, y2_ = 0.0;
};

}  // namespace sinew::truth
