// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/stored_energy.h"

#include <Eigen/Core>
#include <cmath>

namespace sinew {
TendonEnergy::TendonEnergy(const TendonWithLever& parameters)
    : stiffness_(parameters.lever.spring_stiffness),
      softness_(parameters.tendon.free_length / parameters.tendon.axial_stiffness) {
  const LeverParameters& lever = parameters.lever;
  const Eigen::Vector2d across = lever.pivot - lever.anchor;
  squares_ = across.squaredNorm() + lever.spring_arm * lever.spring_arm;
  swing_ = 2.0 * across.norm() * lever.spring_arm;
  angle_ = lever.spring_angle - std::atan2(across.y(), across.x());
  free_length_ = spring_length(lever.free_angle);
}

double TendonEnergy::spring_length(double lever_angle) const {
  return std::sqrt(squares_ + swing_ * std::cos(lever_angle + angle_));
}

double TendonEnergy::at(double lever_angle, double force) const {
  const double stretch = spring_length(lever_angle) - free_length_;
  return 0.5 * stiffness_ * stretch * stretch + 0.5 * softness_ * force * force;
}

}  // namespace sinew
