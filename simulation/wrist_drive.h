// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/compiled_model.h"
#include "simulation/joints.h"
#include "simulation/signal.h"
#include "symbolic/wrist.h"

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
  using BarAngles = void(int, const double*, const double*, double*, double*, double*);

  CompiledModel model_;
  BarAngles* bar_angles_;
  const sinew_function* feedforward_;
  const sinew_function* feedforward_rate_;
};

}  // namespace sinew
