// SPDX-License-Identifier: GPL-3.0-or-later
// What drives take beside the bodies that they move: friction, armature and every effect that logs
// taught, by the effort function that `sinew generate` emits.
#pragma once

#include <vector>

#include "simulation/emitted/driven_effort.h"

namespace sinew {

/// Coordinates in motion and what acts on them: those of the joints, then the motors' that the
/// drives include. SI units.
struct DrivenInstant {
  double time = 0.0, step = 0.0;  ///< s
  Eigen::VectorXd q, qd;
  Eigen::VectorXd effort;   ///< that acts on each coordinate
  Eigen::VectorXd load;     ///< external, against it
  Eigen::VectorXd tension;  ///< N, of each tendon as it is measured
};

/// Bodies whose motion the effort function leaves out: M (qdd - free).
struct OtherBodies {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix mass;
  Eigen::VectorXd free;  ///< accelerations without any effort
};

/// Derivatives of the effort that a motion takes.
struct DrivenSlopes {
  OtherBodies::Matrix by_position, by_velocity, by_acceleration;
};

/// A tendon's force and what its sensor makes of it: true = read (1 + excess) + offset.
struct ForceSensor {
  double offset = 0.0;  ///< N
  double excess = 0.0;
  double reading(double force) const { return (force - offset) / (1.0 + excess); }
  double force(double reading) const { return reading * (1.0 + excess) + offset; }
};

/// What a drive's effort stands for.
struct DriveSide {
  /// The effort includes the bodies of the joints; else the plant moves them.
  bool bodies = true;
  /// Efforts and tensions are those that force sensors read; else they are true.
  bool as_read = false;
};

class Drives {
 public:
  /// A delay is the plant's to make, and no part of the effort here; a force sensor's errors are
  /// where efforts are as read. Throws as DrivenEffort does.
  Drives(const DrivenModel& model, const Identified& identified, DriveSide side,
         const std::filesystem::path& runtime);
  /// `compiled`: with the effort of all entries, which is taken where it is the same.
  Drives(const DrivenModel& model, const Identified& identified, DriveSide side,
         const std::filesystem::path& runtime, std::shared_ptr<const CompiledModel> compiled);

  int coordinates() const { return effort_.joints(); }
  /// Of these, the first that are joints.
  int joints() const { return joints_; }
  int tendons() const { return static_cast<int>(sensors_.size()); }
  bool with_bodies() const { return side_.bodies; }
  /// Its motion is one of steps: effects act through the instants before, or efforts are delayed.
  bool needs_steps() const;
  /// The effort of a coordinate acts that much later than it is logged [s].
  const std::vector<double>& delays() const { return delays_; }
  const std::vector<ForceSensor>& force_sensors() const { return sensors_; }

  /// Accelerations under the efforts, by Newton's method from `guess`, where they are written.
  /// `others`: where the effort does not include the bodies; its coordinates beyond the drives'
  /// have none.
  void accelerations(const DrivenInstant& now, const OtherBodies* others,
                     Eigen::VectorXd& guess) const;
  /// Of the drives' own effort, by differences.
  DrivenSlopes slopes(const DrivenInstant& now, const Eigen::VectorXd& acceleration) const;
  /// The instant becomes the past of the effects.
  void remember(const DrivenInstant& now, const Eigen::VectorXd& acceleration);
  void forget() { effort_.forget(); }
  const EffortPast& past() const { return effort_.past(); }
  void set_past(const EffortPast& past) { effort_.set_past(past); }

 private:
  void set(const DrivenInstant& now) const;
  Eigen::VectorXd missing(const DrivenInstant& now, const OtherBodies* others,
                          const Eigen::VectorXd& acceleration) const;
  OtherBodies::Matrix inertia(const DrivenInstant& now, const Eigen::VectorXd& acceleration) const;

  DriveSide side_;
  int joints_ = 0;
  std::vector<double> delays_;
  std::vector<ForceSensor> sensors_;
  Eigen::VectorXd gain_;  ///< 1 + gain_change: what an effort is worth
  mutable DrivenEffort effort_;
};

}  // namespace sinew
