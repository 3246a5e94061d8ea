// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "simulation/drives/drive_train.h"
#include "simulation/bodies/joints.h"
#include "simulation/scenario/signal.h"
#include "simulation/drives/wrist_drive.h"

namespace sinew {

struct PlantParts;

/// Motor angles by which the tendons carry the bodies in one posture: their weight, and what a
/// moving palm takes. Over the pretension come the smallest forces that solve -P^T f = tau (5.8);
/// tau, P and the springs are those of the emitted C. Knots lie a millisecond apart, polynomials of
/// third degree between them.
class WeightFeedforward {
 public:
  /// `posture` n [rad], `pretension` of every tendon [N].
  WeightFeedforward(const PlantParts& parts, const Eigen::VectorXd& posture, double pretension);

  /// Adds angles and their rates at a time, one a tendon [rad, rad/s]. `parts` as constructed with;
  /// commands of the wrist may be null. Throws std::domain_error naming the tendon that would go
  /// slack or beyond its lever's travel.
  void add(const PlantParts& parts, const Signal* flexion, const Signal* abduction, double time,
           Eigen::VectorXd& angle, Eigen::VectorXd& rate);

 private:
  struct Knot {
    long index = -1;
    Eigen::VectorXd angle;
  };
  Eigen::VectorXd angle_at(const PlantParts& parts, const WristMotion& wrist, double time);
  /// Brings the elongations to those at forces, by Newton's method from the last ones.
  void follow(const TendonModel& tendon, const Eigen::VectorXd& force, double time);

  Eigen::VectorXd posture_, pretension_torque_;
  Eigen::MatrixXd force_by_torque_;  ///< tendons x joints [N a N·m]
  double pretension_, first_elongation_;
  Eigen::VectorXd elongation_, guess_;
  TendonStates states_;
  WristTrack track_;
  Knot knots_[8];
};

}  // namespace sinew
