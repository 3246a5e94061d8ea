// SPDX-License-Identifier: GPL-3.0-or-later
// Motors, levers, tendons and guides of a simulation, one emitted model each.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "simulation/compiled_model.h"
#include "simulation/scenario.h"
#include "symbolic/part.h"

namespace sinew {

/// The motor's emitted C; friction and ripple as the scenario wants them.
class MotorModel {
 public:
  MotorModel(MotorParameters parameters, const Scenario& scenario,
             const std::filesystem::path& runtime);

  double radius() const { return parameters_.pulley_radius; }
  double inertia() const { return inertia_; }
  /// Output speed below which friction holds the motor [rad/s]; 0 without friction.
  double sticking_speed() const;
  double acceleration(double theta, double omega, double torque, double force) const;
  /// Motor, friction, ripple, tendon, kinetic [W].
  void powers(double theta, double omega, double torque, double force, double* power) const;
  /// Feedforward against friction and ripple [N·m].
  double compensation(double theta, double omega) const;

 private:
  MotorParameters parameters_;
  CompiledModel model_;
  double inertia_;
  const sinew_function* acceleration_;
  const sinew_function* powers_;
  const sinew_function* compensation_;
};

/// Force, stiffness and lever angle of a tendon.
struct TendonState {
  double force = 0.0;        ///< N
  double stiffness = 0.0;    ///< N/m
  double lever_angle = 0.0;  ///< rad
  double residual = 0.0;     ///< m, of the emitted Newton search
};

/// Levers and tendons in series.
class TendonModel {
 public:
  TendonModel(const TendonWithLever& parameters, const std::filesystem::path& runtime);

  double free_angle() const { return parameters_.lever.free_angle; }
  /// `guess`: lever angle from which the emitted search starts.
  TendonState at(double elongation, double guess) const;
  /// Energy in lever and tendon [J]; beyond the lever's travel the force stays what it is at its
  /// end.
  double energy(double elongation, const TendonState& state) const;
  /// Elongation [m] at a force. Throws std::invalid_argument beyond the lever's travel.
  double elongation_at(double force) const;
  /// End of the lever's travel [m].
  double longest() const { return longest_; }

 private:
  TendonWithLever parameters_;
  CompiledModel model_;
  const sinew_function* force_;
  double longest_ = 0.0;
};

/// Friction between a tendon's two ends.
class GuidingModel {
 public:
  GuidingModel(GuidingLaw law, const GuidingParameters& parameters,
               const std::filesystem::path& runtime);

  /// Tension on the finger's side [N] for `tension` on the motor's; `velocity` towards the motor
  /// [m/s]. Never negative.
  double transmitted(double tension, double bending, double velocity) const;
  double reversal_velocity() const { return reversal_velocity_; }

 private:
  GuidingLaw law_;
  CompiledModel model_;
  double reversal_velocity_;
  const sinew_function* function_;
};

}  // namespace sinew
