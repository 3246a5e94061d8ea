// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/emitted/compiled_model.h"
#include "simulation/bodies/joints.h"
#include "simulation/scenario/signal.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// Turns commanded palm angles into the bar angles of the wrist, with the emitted C.
class WristDrive {
 public:
  WristDrive(const WristParameters& parameters, const std::filesystem::path& runtime);

  /// `flexion`, `abduction`: of the palm [rad, rad/s, rad/s²]. Throws std::domain_error where the
  /// wrist cannot point there.
  WristMotion at(const Sample& flexion, const Sample& abduction) const;
  /// Motor angles that hold the fingers still and their rates, one a tendon [rad, rad/s].
  void feedforward(const WristMotion& wrist, double* delta, double* rate) const;

 private:
  using BarAngles = void(int, const double*, const double*, double*, double*, int*);

  CompiledModel model_;
  BarAngles* bar_angles_;
  const sinew_function* feedforward_;
  const sinew_function* feedforward_rate_;
};

/// The wrist's motion under commands, looked up again and again. Where they are smooth the emitted
/// inverse is called at knots a millisecond apart only; polynomials of fifth degree through angles,
/// rates and accelerations lie between them (nearer than 1e-15 rad for motions of a few hertz).
class WristTrack {
 public:
  /// Signals may be null: not commanded.
  WristMotion at(const WristDrive& drive, const Signal* flexion, const Signal* abduction,
                 double time);

 private:
  struct Knot {
    long index = -1;
    WristMotion motion;
  };
  const WristMotion& knot(const WristDrive& drive, const Signal* flexion, const Signal* abduction,
                          long index);

  Knot knots_[2];  ///< even and odd
};

}  // namespace sinew
