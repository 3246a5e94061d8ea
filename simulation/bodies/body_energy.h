// SPDX-License-Identifier: GPL-3.0-or-later
// Energy of jointed bodies from geometry alone, for the audit: nothing of it goes into the
// equations of motion, so that a mistake there cannot hide.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/bodies/sines.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// A mechanism's base in a frame at rest, and how it moves.
struct MovingFrame {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, of the origin, base frame
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< rad/s, base frame
};

class BodyEnergy {
 public:
  explicit BodyEnergy(const Mechanism& mechanism);

  /// Kinetic energy and -sum of m g·c [J]. `positions` and `rates` of the moving joints, dependent
  /// ones included; `gravity` in the frame at rest [m/s²].
  double at(const double* positions, const double* rates, const MovingFrame& base,
            const Eigen::Vector3d& gravity) const;

 private:
  /// A joint and its body in axes of which z is the joint's.
  struct Link {
    int parent = -1;
    JointType type = JointType::fixed;
    Eigen::Matrix3d rotation;  ///< before the motion, to the parent's axes
    Eigen::Vector3d origin, centre;
    Eigen::Matrix3d inertia;
    double mass = 0.0;
  };
  std::vector<Link> links_;
  std::size_t moving_ = 0;                   ///< joints
  mutable std::vector<MovingFrame> frames_;  ///< for one call after the other
  mutable Sines sines_;
};

}  // namespace sinew
