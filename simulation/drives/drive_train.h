// SPDX-License-Identifier: GPL-3.0-or-later
// Motors, levers, tendons and guides of a simulation: one emitted model each, called for all motors
// or tendons at once. Arrays have one number a motor or tendon, SI units.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "simulation/emitted/compiled_model.h"
#include "simulation/scenario/scenario.h"
#include "simulation/drives/stored_energy.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// What the motors do at a state; one number a motor, derivatives with the feedforward's own.
struct MotorStates {
  Eigen::VectorXd torque;        ///< applied at the output shaft [N·m]
  Eigen::VectorXd acceleration;  ///< rad/s²
  Eigen::VectorXd by_angle,
      by_speed;  ///< derivatives of the acceleration [1/s², 1/s]
  double power = 0.0, friction_power = 0.0,
         ripple_power = 0.0;           ///< W, of all motors
  Eigen::VectorXd arguments, results;  ///< of the emitted loop
};

/// Without the losses that the scenario leaves out.
MotorParameters with_losses(MotorParameters parameters, const Scenario& scenario);

/// The motor's emitted C; friction and ripple as the scenario wants them.
class MotorModel {
 public:
  MotorModel(MotorParameters parameters, const Scenario& scenario,
             const std::filesystem::path& runtime);

  double radius() const { return parameters_.pulley_radius; }
  double inertia() const { return inertia_; }
  /// Output speed below which friction holds the motor [rad/s]; 0 without friction.
  double sticking_speed() const;
  /// `compensated`: the feedforward against friction and ripple comes on top of `torque`. `load`
  /// acts against all motors [N·m].
  void at(int count, const double* theta, const double* omega, const double* torque,
          const double* force, double load, bool compensated, MotorStates& states) const;

 private:
  using Motion = void(int, const double*, const double*, const double*, const double*,
                      const double*, double*, double*, double*, double*);

  MotorParameters parameters_;
  CompiledModel plain_, compensated_;
  double inertia_;
  Motion* plain_motion_;
  Motion* compensated_motion_;
};

/// Tendons with their levers.
struct TendonStates {
  Eigen::VectorXd force;         ///< N
  Eigen::VectorXd stiffness;     ///< N/m
  Eigen::VectorXd lever_angle;   ///< rad, as far as the emitted search has come
  Eigen::VectorXd residual;      ///< m, of the elongation that the search has not taken up
  Eigen::VectorXd start, found;  ///< arguments and results of the emitted loop
};

/// Levers and tendons in series.
class TendonModel {
 public:
  TendonModel(const TendonWithLever& parameters, const std::filesystem::path& runtime);

  double free_angle() const { return parameters_.lever.free_angle; }
  const LeverParameters& lever() const { return parameters_.lever; }
  /// `guess`: lever angles from which the emitted searches start. What a search leaves over goes
  /// into the force by the stiffness there, which is worth one more step of Newton's.
  void at(int count, const double* elongation, const double* guess, TendonStates& states) const;
  /// Force of one tendon after a long search [N].
  double force_at(double elongation) const;
  /// Energy in all levers and tendons [J]; beyond the lever's travel the force stays what it is at
  /// its end.
  double energy(const Eigen::VectorXd& elongation, const TendonStates& states) const;
  /// Elongation [m] at a force. Throws std::invalid_argument beyond the lever's travel.
  double elongation_at(double force) const;
  /// End of the lever's travel [m].
  double longest() const { return longest_; }

 private:
  using Search = void(int, const double*, const double*, double*, double*);

  TendonWithLever parameters_;
  TendonEnergy energy_;
  CompiledModel model_;
  Search* search_;
  double longest_ = 0.0;
  mutable std::vector<double> angle_, force_;  ///< for one call after the other
};

/// Friction between a tendon's two ends.
class GuidingModel {
 public:
  GuidingModel(GuidingLaw law, const GuidingParameters& parameters,
               const std::filesystem::path& runtime);

  /// Tension on the finger's side [N] for `tension` on the motor's; `velocity` towards the motor
  /// [m/s]. Never negative.
  void transmitted(int count, const double* tension, const double* bending, const double* velocity,
                   double* out) const;
  double reversal_velocity() const { return reversal_velocity_; }

 private:
  using Capstan = void(int, const double*, const double*, const double*, double*);
  using Fitted = void(int, const double*, const double*, double*);

  GuidingLaw law_;
  CompiledModel model_;
  double reversal_velocity_;
  Capstan* capstan_ = nullptr;
  Fitted* fitted_ = nullptr;
};

}  // namespace sinew
