// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drives/stored_energy.h"

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
  free_length_ = spring_length(std::cos(lever.free_angle + angle_));
}

/// `cosine` of the lever's corner.
double TendonEnergy::spring_length(double cosine) const {
  return std::sqrt(squares_ + swing_ * cosine);
}

double TendonEnergy::at(std::size_t count, const double* lever_angle, const double* force) const {
  corner_.resize(count);
  for (std::size_t i = 0; i < count; ++i) corner_[i] = lever_angle[i] + angle_;
  sines_.of(corner_.data(), count);
  double energy = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double stretch = spring_length(sines_.cosine(i)) - free_length_;
    energy += 0.5 * stiffness_ * stretch * stretch + 0.5 * softness_ * force[i] * force[i];
  }
  return energy;
}

}  // namespace sinew
